local f = coroutine.wrap(function(a) local x <close> = setmetatable({}, {__close = print}) while true do coroutine.yield(a) end end)
print(f(1), pcall(f), xpcall(error, tostring, {}), select("#", f()))
while true do pcall(function() while true do end end) end
