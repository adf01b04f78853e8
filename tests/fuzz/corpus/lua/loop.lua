local g = require "gnomon"
local t = {}
for i = 1, 9 do t[i] = g.model { shape = "box", position = {i, math.random(), 0} } end
for k, v in pairs({ a = 1, [2] = 3 }) do print(k, v) end
return g.scene { t }
