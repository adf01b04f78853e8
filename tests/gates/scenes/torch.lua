-- What a cone of light asks: a floor at a slant to it, a curved caster, a thin one, and one that walks.

local g = require "gnomon"

return g.scene {
  g.spot {
    name = "torch", position = { -2.4, 3.2, 2.2 }, target = { 0.4, 0, -0.4 }, intensity = 20000, range = 14,
    inner_angle = 30, outer_angle = 42,
  },
  g.camera { name = "main", position = { 1.2, 2.8, 4.6 }, look_at = { 0.2, 0.3, -0.4 } },
  g.model { name = "floor", shape = "plane", size = { 16, 16 } },
  g.model { name = "ring", shape = "torus", position = { 0.9, 0.6, -1.2 }, size = { 1.2, 0.3, 1.2 }, rotation = { 60, 0, 20 } },
  g.model { name = "block", shape = "box", position = { -0.6, 0.5, -0.8 }, size = { 0.8, 1, 0.8 } },
  g.model { name = "pole", shape = "box", position = { 0.3, 0.8, 0.5 }, size = { 0.08, 1.6, 0.08 } },
  g.path { name = "way", points = { { -0.6, 0.35, 1.2 }, { 1.8, 0.35, 0.4 } }, closed = false },
  g.model { name = "walker", shape = "box", size = { 0.35, 0.7, 0.35 }, path = "way", path_speed = 1.4, path_start = 0.2 },
}
