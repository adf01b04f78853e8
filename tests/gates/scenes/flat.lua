-- What flat receivers ask: convex casters that stand on a floor and over it, a thin one among them, and one that walks.
-- They receive no shadows, so that a technique for planes alone can serve everything here.

local g = require "gnomon"

return g.scene {
  g.sun { name = "sun", direction = { -0.5, -1, -0.35 }, angular_size = 0 },
  g.camera { name = "main", position = { 0, 3.4, 6.5 }, look_at = { 0, 0.2, 0 } },
  g.model { name = "floor", shape = "plane", size = { 24, 24 }, casts = false },
  g.model { name = "block", shape = "box", position = { -1.8, 0.6, 0 }, size = { 1, 1.2, 1 }, receives = false },
  g.model { name = "ball", shape = "sphere", position = { 1.4, 1.3, -0.4 }, size = { 1.2, 1.2, 1.2 }, receives = false },
  g.model { name = "post", shape = "box", position = { 3, 0.9, 1.2 }, size = { 0.12, 1.8, 0.12 }, receives = false },
  g.path { name = "way", points = { { -1.5, 0.5, 2 }, { 1.5, 0.5, 2 } }, closed = false },
  g.model {
    name = "walker", shape = "box", size = { 0.5, 1, 0.5 }, path = "way", path_speed = 1.4, path_start = 0.1,
    receives = false,
  },
}
