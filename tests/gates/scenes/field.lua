-- What a camera on the move asks of maps: far more ground than it sees, with posts all over, so that a map covers what
-- is in view and must follow.

local g = require "gnomon"

local posts = {}
for row = -5, 5 do
  for column = -5, 5 do
    posts[#posts + 1] = g.model {
      name = "post_" .. row .. "_" .. column, shape = "box", position = { 4 * column + 0.9 * row, 0.6, 4 * row },
      size = { 0.5, 1.2, 0.5 }, rotation = { 0, 31 * row + 17 * column, 0 },
    }
  end
end

return g.scene {
  g.sun { name = "sun", direction = { -0.6, -1, -0.35 }, angular_size = 0 },
  g.camera { name = "main", position = { 0.4, 2.6, 6 }, look_at = { 0, 0, 0.5 } },
  g.model { name = "floor", shape = "plane", size = { 120, 120 } },
  posts,
}
