-- What planes must leave out: a caster above the lamp, one that reaches through its height, and one under the floor.
-- None but the block on the floor throws a shadow there that anyone sees whole.

local g = require "gnomon"

return g.scene {
  g.lamp { name = "lamp", position = { 0.2, 2.2, 0.3 }, intensity = 3000, range = 20 },
  g.camera { name = "main", position = { 0, 3.4, 6 }, look_at = { 0, 0, 0 } },
  g.model { name = "floor", shape = "plane", size = { 16, 16 }, casts = false },
  g.model { name = "block", shape = "box", position = { -1.4, 0.4, 0.6 }, size = { 0.6, 0.8, 0.6 }, receives = false },
  g.model { name = "above", shape = "box", position = { 0.6, 3.6, -0.4 }, size = { 0.8, 0.5, 0.8 }, receives = false },
  g.model { name = "below", shape = "box", position = { 1.6, -0.8, 0.8 }, size = { 0.8, 0.6, 0.8 }, receives = false },
  g.path { name = "way", points = { { -0.4, 0.4, 1.8 }, { 1.6, 0.4, 1.8 } }, closed = false },
  g.model {
    name = "walker", shape = "box", size = { 0.4, 0.8, 0.4 }, path = "way", path_speed = 1.4, path_start = 0.2,
    receives = false,
  },
}
