-- A walled court on a summer morning: a slab, four walls with a gate, an arcade, stairs to a terrace, a fountain and a
-- dark chamber with a lamp, all of shapes; a statue, a sundial and passers-by from models/. North is -z; one unit is a
-- metre.

local g = require "gnomon"

local stone = g.srgb("#c9bda4")
local sand = g.srgb("#d8c9a3")
local brick = g.srgb("#a0644a")
local bronze = g.srgb("#8a6a3c")
local water = g.srgb("#6fa3b0")

local function box(name, center, size, color)
  return g.model { name = name, shape = "box", position = center, size = size, color = color or stone }
end

-- Walls, 4 m high and half a metre thick, round a court of 24 by 18 m; the south wall has a gate.
local walls = {
  box("wall_north", { 0, 2, -9.25 }, { 25, 4, 0.5 }, brick),
  box("wall_east", { 12.25, 2, 0 }, { 0.5, 4, 18 }, brick),
  box("wall_west", { -12.25, 2, 0 }, { 0.5, 4, 18 }, brick),
  box("wall_south_left", { -7.25, 2, 9.25 }, { 10.5, 4, 0.5 }, brick),
  box("wall_south_right", { 7.25, 2, 9.25 }, { 10.5, 4, 0.5 }, brick),
  box("gate_lintel", { 0, 3.6, 9.25 }, { 4, 0.8, 0.5 }, stone),
}

-- An arcade along the west wall: a base, a shaft and a capital for each of seven columns, and a roof on top.
local arcade = { box("arcade_roof", { -10.4, 3.5, 0 }, { 3.2, 0.3, 16 }) }
for i = 1, 7 do
  local z = -7 + (i - 1) * 7 / 3
  arcade[#arcade + 1] = {
    box("column_base_" .. i, { -9.2, 0.15, z }, { 0.8, 0.3, 0.8 }),
    g.model {
      name = "column_" .. i, shape = "cylinder", position = { -9.2, 1.75, z }, size = { 0.5, 2.9, 0.5 },
      color = stone,
    },
    box("column_capital_" .. i, { -9.2, 3.25, z }, { 0.7, 0.2, 0.7 }),
  }
end

-- Six steps of 0.2 m up to a terrace in the north-east corner.
local stairs = { box("terrace", { 9, 0.6, -6.5 }, { 6, 1.2, 5 }) }
for i = 1, 6 do
  local height = i * 0.2
  stairs[#stairs + 1] = box("step_" .. i, { 9, height / 2, -1.9 - i * 0.35 }, { 3, height, 0.35 }, sand)
end

-- The fountain: a rim, its water, a stem and a sphere.
local fountain = {
  g.model { name = "fountain_rim", shape = "torus", position = { 1, 0.3, 1 }, size = { 4, 0.6, 4 }, color = stone },
  g.model {
    name = "fountain_water", shape = "cylinder", position = { 1, 0.2, 1 }, size = { 3.2, 0.3, 3.2 }, color = water,
  },
  g.model {
    name = "fountain_stem", shape = "cylinder", position = { 1, 0.9, 1 }, size = { 0.35, 1.4, 0.35 }, color = bronze,
  },
  g.model {
    name = "fountain_sphere", shape = "sphere", position = { 1, 2, 1 }, size = { 1, 1, 1 }, color = bronze,
  },
}

-- The chamber in the south-east corner: two walls of its own and a roof, lit by a lamp.
local chamber = {
  box("chamber_north", { 9.5, 1.5, 4.6 }, { 5, 3, 0.3 }),
  box("chamber_west", { 7.15, 1.5, 7.6 }, { 0.3, 3, 2.8 }),
  box("chamber_roof", { 9.5, 3.1, 6.8 }, { 5, 0.2, 4.6 }),
  box("chest", { 10.8, 0.35, 7.9 }, { 1, 0.7, 0.6 }, bronze),
}

-- What stands about: jars, crates, a cypress.
local things = {
  box("crate_large", { -6.2, 0.6, 7.6 }, { 1.2, 1.2, 1.2 }, brick),
  g.model {
    name = "crate_small", shape = "box", position = { -6.1, 1.5, 7.5 }, rotation = { 0, 30, 0 },
    size = { 0.6, 0.6, 0.6 }, color = brick,
  },
  g.model { name = "jar_body", shape = "sphere", position = { -4.2, 0.5, 8 }, size = { 0.8, 1, 0.8 }, color = bronze },
  g.model {
    name = "jar_neck", shape = "cylinder", position = { -4.2, 1.05, 8 }, size = { 0.4, 0.3, 0.4 }, color = bronze,
  },
  g.model {
    name = "cypress_trunk", shape = "cylinder", position = { 6, 0.5, -1 }, size = { 0.25, 1, 0.25 }, color = bronze,
  },
  g.model {
    name = "cypress_crown", shape = "cone", position = { 6, 3, -1 }, size = { 1.4, 4, 1.4 }, color = g.srgb("#3f6b3a"),
  },
}

-- The statue is the hero of the court's shadows. It stands on two steps, a centimetre deep in the upper one.
local statue = {
  box("statue_step_low", { -3, 0.1, 0 }, { 1.8, 0.2, 1.8 }),
  box("statue_step_high", { -3, 0.3, 0 }, { 1.2, 0.2, 1.2 }),
  g.model {
    name = "statue", file = "models/statue.glb", position = { -3, 0.39, 0 }, rotation = { 0, 65, 0 }, hero = true,
  },
}

local function walker(name, position, heading, speed)
  return g.model {
    name = name, file = "models/walker.glb", position = position, rotation = { 0, heading, 0 }, animation = "walk",
    animation_speed = speed,
  }
end

-- Headings in degrees: 0 is south, 90 is east.
local people = {
  walker("walker_gate", { -1.9, 0, 3.2 }, 205, 1),
  walker("walker_arcade", { -7.4, 0, 0.9 }, 15, 0.9),
  walker("walker_stairs", { 6.2, 0, -3.4 }, 70, 1.1),
}

return g.scene {
  budget = { error_px = 1.0, shadow_ms = 12 },
  ambient = { 0.18, 0.17, 0.17 },

  -- Low in the south-east: shadows are longer than what throws them, and those of the columns lie in the arcade.
  g.sun { name = "sun", direction = { -0.8, -0.7, -0.45 }, illuminance = 70000, color = g.srgb("#ffe8c4") },
  g.spot {
    name = "lantern_gate", position = { 0, 3.1, 8.7 }, target = { 0, 0, 6 }, intensity = 60000, range = 9,
    inner_angle = 25, outer_angle = 42, radius = 0.05, color = g.srgb("#ffd9a0"),
  },
  g.spot {
    name = "lantern_arcade", position = { -11.6, 3.1, 0 }, target = { -9.8, 0, 0 }, intensity = 50000, range = 8,
    inner_angle = 20, outer_angle = 50, radius = 0.05, color = g.srgb("#ffd9a0"),
  },
  g.lamp {
    name = "lamp_chamber", position = { 9.6, 2.4, 6.8 }, intensity = 90000, range = 7, radius = 0.04,
    color = g.srgb("#ffb870"),
  },

  -- A walk goes through the cameras in this order, on a curve that keeps clear of walls and columns.
  g.camera { name = "court", position = { 2.6, 2.1, 8 }, look_at = { -2, 0.9, -0.5 }, fov = 58 },
  g.camera { name = "by_sundial", position = { -3.4, 1.75, 5 }, look_at = { -5, 0.95, 2.6 }, fov = 50 },
  g.camera { name = "arcade", position = { -10.5, 1.7, 5 }, look_at = { -9.7, 1.4, -4 }, fov = 62 },
  g.camera { name = "between_columns", position = { -10.1, 1.7, -5.6 }, look_at = { -3.5, 1.2, -3.9 }, fov = 50 },
  g.camera { name = "by_statue", position = { -5.6, 1.5, -4.2 }, look_at = { -2.6, 1.35, 0.4 }, fov = 50 },
  g.camera { name = "by_stairs", position = { 2.6, 1.9, -2 }, look_at = { 8.6, 0.8, -3 }, fov = 55 },
  g.camera { name = "by_chamber", position = { 4.4, 1.7, 4.3 }, look_at = { 9.4, 1.1, 6.6 }, fov = 58 },

  -- The ground takes no part in casting: nothing lies below it.
  g.model {
    name = "ground", shape = "plane", position = { 0, -0.5, 0 }, size = { 120, 120 }, color = sand, casts = false,
  },
  box("floor", { 0, -0.25, 0 }, { 25, 0.5, 19 }, sand),
  walls,
  arcade,
  stairs,
  fountain,
  chamber,
  things,
  statue,
  g.model { name = "sundial", file = "models/sundial.glb", position = { -5, 0, 2.6 } },
  people,

  -- The lamp lights only its chamber, whose shadows are seen from near: ask for more there.
  g.rule { light = "lamp_chamber", error_px = 0.5 },
  -- Beyond 60 m nobody tells a soft edge from a hard one.
  g.rule { distance = 60, error_px = 3 },
}
