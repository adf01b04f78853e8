local s = ("abc"):rep(9, ","):gsub("(%w+),", "%1"):format(1, "x", {})
print(s:find("a*b-c?", 1), s:match("^(.-)%s*$"), table.concat({1, 2}, s), string.pack("<i4z", 7, s), utf8.char(955))
for w in s:gmatch("%a+") do print(w:upper(), #w) end
table.sort({3, 1, 2}, function(a, b) return a < b end) table.move({1, 2}, 1, 2, 3) error(setmetatable({}, {__tostring = print}))
