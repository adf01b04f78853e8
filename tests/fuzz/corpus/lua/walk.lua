local g = require "gnomon"
local function on_update(dt)
  local world = g.world
  local sun, cart = world:find("sun"), world:find("cart")
  sun.direction = { math.sin(world.time), -1, sun.direction[3] + dt }
  sun.illuminance, sun.on = sun.illuminance * 2, not sun.on
  cart.path_speed = -cart.path_speed
  world:find("eye").rotation = { 0, 90 * dt, 0 }
end
return g.scene { preset = "low", on_update = on_update, shadow = { filter = "bilinear", cascades = 2 },
  g.sun { name = "sun", shadow = { technique = "cascaded_map", map_size = 256 } },
  g.spot { name = "torch", shadow = { technique = "spot_map" } }, g.lamp { name = "lamp", shadow = { never = "cube_map" } },
  g.path { name = "round", points = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 0, 3 } }, closed = false },
  g.model { name = "cart", shape = "cylinder", path = "round", path_speed = 2, path_start = 0.5 },
  g.player { position = { 0, 0, 4 }, heading = 90, speed = 2, path = "round" },
  g.camera { name = "eye" } }
