-- Noon Court: a walled court on a summer morning. A gate in the south, an arcade along the west wall, stairs to a
-- terrace in the north-east, a dark chamber with a lamp in the south-east, a fountain and a statue between them, and
-- passers-by. The sun moves. North is -z; one unit is a metre.

local g = require "gnomon"
local crowd = require "crowd"

local stone = g.srgb("#c9bda4")
local sand = g.srgb("#d8c9a3")
local brick = g.srgb("#a0644a")
local bronze = g.srgb("#8a6a3c")
local candlelight = g.srgb("#ffd9a0")

local function box(name, center, size, color)
  return g.model { name = name, shape = "box", position = center, size = size, color = color or stone }
end

local function model(name, file, position, heading)
  return g.model {
    name = name, file = "models/" .. file .. ".glb", position = position, rotation = { 0, heading or 0, 0 },
  }
end

-- Walls half a metre thick round a court of 24 by 18 m; the west wall carries the arcade's roof, the south wall has a
-- gate with steps down to the plain.
local walls = {
  box("wall_north", { 0, 2, -9.25 }, { 25, 4, 0.5 }, brick),
  box("wall_east", { 12.25, 2, 0 }, { 0.5, 4, 18 }, brick),
  box("wall_west", { -12.25, 2.4, 0 }, { 0.5, 4.8, 18 }, brick),
  box("wall_south_left", { -7.25, 2, 9.25 }, { 10.5, 4, 0.5 }, brick),
  box("wall_south_right", { 7.25, 2, 9.25 }, { 10.5, 4, 0.5 }, brick),
  box("gate_post_left", { -2.2, 2.15, 9.25 }, { 0.7, 4.3, 0.8 }),
  box("gate_post_right", { 2.2, 2.15, 9.25 }, { 0.7, 4.3, 0.8 }),
  box("gate_lintel", { 0, 3.75, 9.25 }, { 3.7, 0.8, 0.6 }),
  box("gate_step", { 0, -0.375, 9.85 }, { 5, 0.25, 0.7 }),
  model("lantern_of_gate", "lantern", { 0, 3.35, 8.9 }),
}

-- Seven columns, six arches between them, two solid ends, and a roof. Arches begin on the capitals, at 3.4 m.
local bay = 7 / 3
local arcade = {
  box("arcade_roof", { -10.45, 4.8, 0 }, { 3.1, 0.2, 18 }),
  box("arcade_end_north", { -9.2, 2.35, -8.15 }, { 0.5, 4.7, 1.7 }),
  box("arcade_end_south", { -9.2, 2.35, 8.15 }, { 0.5, 4.7, 1.7 }),
  box("arcade_kerb", { -10.55, 0.06, 0 }, { 2.9, 0.12, 18 }),
}
for i = 1, 7 do
  local z = -7 + (i - 1) * bay
  arcade[#arcade + 1] = model("column_" .. i, "column", { -9.2, 0, z })
  if i < 7 then
    arcade[#arcade + 1] = model("arch_" .. i, "arch", { -9.2, 3.4, z + bay / 2 }, 90)
  end
end
for i, z in ipairs { -3.5, 3.5 } do
  arcade[#arcade + 1] = box("chain_" .. i, { -10.6, 4.2, z }, { 0.02, 1, 0.02 }, bronze)
  arcade[#arcade + 1] = model("lantern_of_arcade_" .. i, "lantern", { -10.6, 3.7, z })
end

-- Five steps of 0.2 m, and the terrace is the sixth. A low wall keeps people on it.
local stairs = {
  box("terrace", { 9, 0.6, -6.375 }, { 6, 1.2, 5.25 }),
  box("parapet_west", { 6.15, 1.6, -6.375 }, { 0.3, 0.8, 5.25 }),
  box("parapet_south", { 6.9, 1.6, -3.9 }, { 1.2, 0.8, 0.3 }),
  box("parapet_south_east", { 11.25, 1.6, -3.9 }, { 1.5, 0.8, 0.3 }),
  model("bench_terrace", "bench", { 10.2, 1.2, -8.5 }),
  model("jar_terrace_left", "jar", { 6.7, 1.2, -8.4 }, 40),
  model("jar_terrace_right", "jar", { 11.5, 1.2, -4.6 }, 110),
}
for i = 1, 5 do
  local height = i * 0.2
  stairs[#stairs + 1] = box("step_" .. i, { 9, height / 2, -1.825 - i * 0.35 }, { 3, height, 0.35 }, sand)
end

-- The chamber: two walls of its own, a door in the western one, and a roof. What stands in it throws long shadows.
local chamber = {
  box("chamber_north", { 9.5, 1.5, 4.6 }, { 5, 3, 0.3 }),
  box("chamber_west", { 7.15, 1.5, 7.6 }, { 0.3, 3, 2.8 }),
  box("chamber_lintel", { 7.15, 2.6, 5.475 }, { 0.3, 0.8, 1.45 }),
  box("chamber_roof", { 9.5, 3.1, 6.725 }, { 5, 0.2, 4.55 }),
  model("lantern_of_chamber", "lantern", { 9.6, 3, 6.8 }),
  box("chest", { 10.9, 0.35, 8.3 }, { 1, 0.7, 0.6 }, bronze),
  model("jar_chamber", "jar", { 11.2, 0, 5.6 }, 70),
  box("stool", { 8.1, 0.25, 8.2 }, { 0.45, 0.5, 0.45 }, bronze),
}

local things = {
  model("fountain", "fountain", { 1, 0, 1 }),
  model("sundial", "sundial", { -5, 0, 2.6 }),
  box("crate_large", { -6.2, 0.6, 7.6 }, { 1.2, 1.2, 1.2 }, brick),
  g.model {
    name = "crate_small", shape = "box", position = { -6.1, 1.5, 7.5 }, rotation = { 0, 30, 0 },
    size = { 0.6, 0.6, 0.6 }, color = brick,
  },
  model("jar_crates", "jar", { -4.6, 0, 8.2 }, 25),
  model("jar_gate", "jar", { 3.4, 0, 8.3 }, 80),
  model("bench_west", "bench", { -4.4, 0, -8.5 }),
  model("bench_east", "bench", { 1.6, 0, -8.5 }),
  model("cypress_court", "cypress", { -7.1, 0, -8 }),
  model("cypress_north_1", "cypress", { -1.4, 0, -7.7 }, 70),
  model("cypress_north_2", "cypress", { 4.4, 0, -7.7 }, 200),
}

-- Beyond the walls: cypresses along the way to the gate, and hills.
local plain = {
  -- The ground takes no part in casting: nothing lies below it.
  g.model {
    name = "ground", shape = "plane", position = { 0, -0.5, 0 }, size = { 800, 800 }, color = g.srgb("#b3a878"),
    casts = false,
  },
  g.model { name = "hills", file = "models/hills.glb", casts = false },
}
for i, at in ipairs { { -4.5, 13 }, { 4.5, 13 }, { -4.5, 19 }, { 4.5, 19 }, { -17, -4 }, { -15, 8 }, { 16, -12 },
  { 18, 2 }, { -8, -15 }, { 7, -17 } } do
  plain[#plain + 1] = model("cypress_plain_" .. i, "cypress", { at[1], -0.5, at[2] }, 47 * i)
end

-- The statue is the hero of the court's shadows. It stands on two steps, a centimetre deep in the upper one.
local statue = {
  box("statue_step_low", { -3, 0.1, 0 }, { 1.8, 0.2, 1.8 }),
  box("statue_step_high", { -3, 0.3, 0 }, { 1.2, 0.2, 1.2 }),
  g.model {
    name = "statue", file = "models/statue.glb", position = { -3, 0.39, 0 }, rotation = { 0, 65, 0 }, hero = true,
  },
}

local function lantern(name, position)
  return g.spot {
    name = name, position = position, intensity = 50000, range = 9, inner_angle = 25, outer_angle = 48, radius = 0.05,
    color = candlelight,
  }
end

-- The sun goes to and fro between morning and afternoon in a quarter of an hour, so that noon comes and night does
-- not; the flame in the chamber flickers.
local function on_update()
  local time = g.world.time
  local share = 0.5 - 0.5 * math.cos(2 * math.pi * time / 900)
  local azimuth = math.rad(60.6 - 110 * share)
  local height = math.rad(37.3 + 25 * math.sin(math.pi * share))
  g.world:find("sun").direction = {
    -math.cos(height) * math.sin(azimuth), -math.sin(height), -math.cos(height) * math.cos(azimuth),
  }
  g.world:find("lamp_chamber").intensity = 140000 * (1 + 0.08 * math.sin(11 * time) * math.sin(7.3 * time))
end

return g.scene {
  preset = "medium",
  budget = { error_px = 1 },
  ambient = { 0.18, 0.17, 0.17 },
  on_update = on_update,

  -- Low in the south-east: shadows are longer than what throws them, and those of the columns lie in the arcade.
  g.sun { name = "sun", direction = { -0.8, -0.7, -0.45 }, illuminance = 70000, color = g.srgb("#ffe8c4") },
  lantern("lantern_gate", { 0, 2.83, 8.9 }),
  lantern("lantern_arcade_north", { -10.6, 3.18, -3.5 }),
  lantern("lantern_arcade_south", { -10.6, 3.18, 3.5 }),
  g.lamp {
    name = "lamp_chamber", position = { 9.6, 2.75, 6.8 }, intensity = 140000, range = 7, radius = 0.03,
    color = g.srgb("#ffb870"),
  },

  -- A visitor's way round: past the sundial, through the arcade, up the stairs, into the chamber.
  g.path {
    name = "round",
    points = {
      { -1.2, 0, 4.9 }, { -3.6, 0, 3.7 }, { -6.9, 0, 4.9 }, { -8, 0, 5.83 }, { -10.3, 0, 5.83 }, { -10.5, 0, 0 },
      { -10.3, 0, -3.5 }, { -7.4, 0, -3.5 }, { -4, 0, -2.6 }, { 0, 0, -3.6 }, { 6, 0, -3 }, { 8.4, 0, -1 },
      { 9, 0.6, -2.9 }, { 9, 1.2, -5 }, { 10.6, 1.2, -6.6 }, { 7.6, 1.2, -7.4 }, { 7.8, 1.2, -5.4 }, { 8.9, 1.2, -4.2 },
      { 9, 0, -1 }, { 6.4, 0, 2.6 }, { 5.6, 0, 5.2 }, { 7.2, 0, 5.45 }, { 8.6, 0, 5.9 }, { 8.5, 0, 7.2 },
      { 8.4, 0, 5.7 }, { 7, 0, 5.45 }, { 5, 0, 5.8 }, { 2.4, 0, 6.8 }, { 0.4, 0, 6.6 },
    },
  },
  g.player { position = { 0.6, 0, 7.2 }, heading = 35, speed = 2, path = "round" },

  g.camera { name = "court", position = { 3.4, 2.3, 8 }, look_at = { -2, 0.9, -0.5 }, fov = 58 },
  g.camera { name = "by_sundial", position = { -3.4, 1.75, 5 }, look_at = { -5, 0.95, 2.6 }, fov = 50 },
  g.camera { name = "arcade", position = { -10.5, 1.8, 7.6 }, look_at = { -9.9, 1.6, -4 }, fov = 62 },
  g.camera { name = "between_columns", position = { -10.1, 1.7, -5.6 }, look_at = { -3.5, 1.2, -3.9 }, fov = 50 },
  g.camera { name = "by_statue", position = { -5.3, 1.5, -3.9 }, look_at = { -2.6, 1.35, 0.4 }, fov = 50 },
  g.camera { name = "by_stairs", position = { 5.3, 1.8, 0.8 }, look_at = { 8.9, 0.9, -4.4 }, fov = 55 },
  g.camera { name = "by_chamber", position = { 4.6, 1.7, 4.4 }, look_at = { 9.4, 1.1, 6.4 }, fov = 58 },
  g.camera { name = "in_chamber", position = { 7.6, 1.7, 4.95 }, look_at = { 10.4, 0.9, 8 }, fov = 68 },
  g.camera { name = "on_terrace", position = { 6.9, 2.9, -5.6 }, look_at = { -2.5, 0.6, 1 }, fov = 60 },
  g.camera { name = "above", position = { 17, 13, 19 }, look_at = { -1, 0, -0.5 }, fov = 52 },

  plain,
  box("floor", { 0, -0.25, 0 }, { 25, 0.5, 19 }, sand),
  walls,
  arcade,
  stairs,
  chamber,
  things,
  statue,
  crowd,

  -- The lamp lights only its chamber, whose shadows are seen from near: ask for more there.
  g.rule { light = "lamp_chamber", error_px = 0.5 },
  -- Beyond 60 m nobody tells a soft edge from a hard one.
  g.rule { distance = 60, error_px = 3 },
}
