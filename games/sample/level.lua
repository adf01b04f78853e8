-- A walled court at noon, built of shapes alone: a slab, four walls with a gate, two rows of columns under a roof,
-- stairs to a terrace, a fountain, and a dark chamber with a lamp. North is -z; one unit is a metre.

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

-- The fountain: a rim, its water, a stem and a sphere that is the hero of the court's shadows.
local fountain = {
  g.model { name = "fountain_rim", shape = "torus", position = { 1, 0.3, 1 }, size = { 4, 0.6, 4 }, color = stone },
  g.model {
    name = "fountain_water", shape = "cylinder", position = { 1, 0.2, 1 }, size = { 3.2, 0.3, 3.2 }, color = water,
  },
  g.model {
    name = "fountain_stem", shape = "cylinder", position = { 1, 0.9, 1 }, size = { 0.35, 1.4, 0.35 }, color = bronze,
  },
  g.model {
    name = "fountain_sphere", shape = "sphere", position = { 1, 2, 1 }, size = { 1, 1, 1 }, color = bronze, hero = true,
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
  box("crate_large", { -5.5, 0.6, 6.5 }, { 1.2, 1.2, 1.2 }, brick),
  g.model {
    name = "crate_small", shape = "box", position = { -5.4, 1.5, 6.4 }, rotation = { 0, 30, 0 },
    size = { 0.6, 0.6, 0.6 }, color = brick,
  },
  g.model { name = "jar_body", shape = "sphere", position = { -3.6, 0.5, 7 }, size = { 0.8, 1, 0.8 }, color = bronze },
  g.model {
    name = "jar_neck", shape = "cylinder", position = { -3.6, 1.05, 7 }, size = { 0.4, 0.3, 0.4 }, color = bronze,
  },
  g.model {
    name = "cypress_trunk", shape = "cylinder", position = { 5, 0.5, -2 }, size = { 0.25, 1, 0.25 }, color = bronze,
  },
  g.model {
    name = "cypress_crown", shape = "cone", position = { 5, 3, -2 }, size = { 1.4, 4, 1.4 }, color = g.srgb("#3f6b3a"),
  },
}

return g.scene {
  budget = { error_px = 1.0, shadow_ms = 12 },
  ambient = { 0.16, 0.18, 0.22 },

  -- High and a little from the south-west, so that every wall has a lit and a dark side.
  g.sun { name = "sun", direction = { 0.45, -1, -0.35 }, illuminance = 80000, color = g.srgb("#fff4e0") },
  g.spot {
    name = "lantern_gate", position = { 0, 3.1, 8.7 }, target = { 0, 0, 6 }, intensity = 60000, range = 9,
    inner_angle = 25, outer_angle = 42, radius = 0.05, color = g.srgb("#ffd9a0"),
  },
  g.spot {
    name = "lantern_arcade", position = { -11.6, 3.1, 0 }, target = { -9.8, 0, 0 }, intensity = 50000, range = 8,
    inner_angle = 20, outer_angle = 50, radius = 0.05, color = g.srgb("#ffd9a0"),
  },
  g.lamp {
    name = "lamp_chamber", position = { 9.6, 2.4, 6.8 }, intensity = 20000, range = 7, radius = 0.04,
    color = g.srgb("#ffb870"),
  },

  g.camera { name = "court", position = { -6.5, 4.6, 8.4 }, look_at = { 1.5, 0.8, -1 }, fov = 62 },
  g.camera { name = "arcade", position = { -10.6, 1.7, 7.6 }, look_at = { -8.6, 1.4, -4 }, fov = 65 },

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

  -- The lamp lights only its chamber, whose shadows are seen from near: ask for more there.
  g.rule { light = "lamp_chamber", error_px = 0.5 },
  -- Beyond 60 m nobody tells a soft edge from a hard one.
  g.rule { distance = 60, error_px = 3 },
}
