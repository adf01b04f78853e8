-- What a light with a size asks: penumbrae that begin at nothing where things touch the floor and widen with height.

local g = require "gnomon"

return g.scene {
  g.lamp { name = "globe", position = { 1.4, 4, 1.4 }, intensity = 6000, radius = 0.25, range = 20 },
  g.camera { name = "main", position = { 0, 3.2, 5.6 }, look_at = { -0.3, 0.2, 0 } },
  g.model { name = "floor", shape = "plane", size = { 16, 16 }, casts = false },
  g.model { name = "block", shape = "box", position = { -1.5, 0.7, 0 }, size = { 0.9, 1.4, 0.9 }, receives = false },
  g.model { name = "ball", shape = "sphere", position = { 0.9, 1.2, 0.2 }, size = { 0.9, 0.9, 0.9 }, receives = false },
  g.model { name = "post", shape = "box", position = { -0.1, 0.8, 1.4 }, size = { 0.14, 1.6, 0.14 }, receives = false },
}
