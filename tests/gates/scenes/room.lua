-- What a lamp asks: receivers on every side of it, casters near it and far, and one that walks.

local g = require "gnomon"

return g.scene {
  g.lamp { name = "lamp", position = { 0.3, 2.3, 0.2 }, intensity = 3000, range = 14 },
  g.camera { name = "main", position = { 0, 1.9, 4.2 }, look_at = { 0, 0.8, 0 } },
  g.model { name = "floor", shape = "plane", size = { 10, 10 } },
  g.model { name = "back", shape = "box", position = { 0, 1.5, -3.1 }, size = { 7, 3, 0.2 } },
  g.model { name = "left", shape = "box", position = { -3.1, 1.5, 0.6 }, size = { 0.2, 3, 7 } },
  g.model { name = "table", shape = "box", position = { -1.1, 0.75, 0 }, size = { 1.2, 0.1, 0.8 } },
  g.model { name = "ball", shape = "sphere", position = { 1.3, 0.8, -0.8 }, size = { 0.9, 0.9, 0.9 } },
  g.model { name = "rail", shape = "box", position = { 0.4, 1.4, -1.6 }, size = { 1.8, 0.08, 0.08 } },
  g.path { name = "way", points = { { -1.6, 0.4, 1.4 }, { 1.8, 0.4, 1.4 } }, closed = false },
  g.model { name = "walker", shape = "box", size = { 0.4, 0.8, 0.4 }, path = "way", path_speed = 1.4, path_start = 0.2 },
}
