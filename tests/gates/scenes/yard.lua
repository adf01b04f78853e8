-- What any receiver asks of a sun: curved ones, casters on casters, a wall, a thin pole whose shadow climbs things, and
-- one that walks.

local g = require "gnomon"

return g.scene {
  g.sun { name = "sun", direction = { -0.6, -1, -0.45 }, angular_size = 0 },
  g.camera { name = "main", position = { 0.4, 2.6, 6 }, look_at = { 0, 0.5, 0 } },
  g.model { name = "floor", shape = "plane", size = { 24, 24 } },
  g.model { name = "wall", shape = "box", position = { 0, 1, -2.6 }, size = { 8, 2, 0.4 } },
  g.model { name = "dome", shape = "sphere", position = { -1.3, 0, 0.2 }, size = { 2.4, 2.4, 2.4 } },
  g.model { name = "ring", shape = "torus", position = { 1.7, 0.3, 0.9 }, size = { 1.8, 0.5, 1.8 } },
  g.model { name = "block", shape = "box", position = { 1.4, 0.7, -1 }, size = { 0.9, 1.4, 0.9 }, rotation = { 0, 25, 0 } },
  g.model { name = "pole", shape = "box", position = { -0.1, 1.2, 1.1 }, size = { 0.1, 2.4, 0.1 } },
  g.path { name = "way", points = { { -2.4, 0.4, 2.4 }, { 1.6, 0.4, 2.4 } }, closed = false },
  g.model { name = "walker", shape = "box", size = { 0.4, 0.8, 0.4 }, path = "way", path_speed = 1.4, path_start = 0.3 },
}
