local g = require "gnomon"
return g.scene { budget = { error_px = 1, shadow_ms = 8 }, ambient = {0.2, 0.2, 0.2}, exposure = 1,
  g.sun { name = "sun", direction = {-0.4, -1, -0.3}, illuminance = 60000, angular_size = 0.53, shadow = { never = {"blob"} } },
  g.spot { name = "torch", position = {2, 3, 1}, target = {0, 0, 0}, range = 12, outer_angle = 40, inner_angle = 9 },
  g.lamp { position = {1, 2, 3}, radius = 0.1, color = g.srgb("#ff8800") },
  g.model { name = "floor", shape = "plane", size = {40, 40}, scale = 2, casts = false },
  g.model { file = "hero.glb", hero = true, animation = "Run", rotation = {0, 90, 0} },
  g.camera { position = {0, 2, 8}, look_at = {0, 1, 0}, fov = 60 },
  g.rule { light = "torch", receiver = "floor", technique = "planar", distance = 60 } }
