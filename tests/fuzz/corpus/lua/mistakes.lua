local g = require "gnomon"
g.moon {} g.sun "x"
return g.scene { 5, { a = 1 }, g.sun { on = 1, [2.5] = 0/0, name = "a/b" }, g.rule { light = "no" }, g.scene {} }
