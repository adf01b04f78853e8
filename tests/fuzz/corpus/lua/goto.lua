local t <const> = 5 ::top:: local function f(...) local a, b = ... if a then return f(b) end end f(1, nil, 2)
do local _ENV = { x = 1 } x = x // 1 | 2 ~ 3 << 4 end goto top --[==[ long ]==] -- comment
