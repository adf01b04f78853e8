-- The passers-by of the court: where they go, and who goes there. All wear the same clothes: one mesh, posed for each.

local g = require "gnomon"

local kStride = 1.42 -- metres that the clip "walk" goes in its second

local ways = {
  g.path {
    name = "promenade",
    points = {
      { -1.9, 0, 3.6 }, { -6.4, 0, 4.3 }, { -6.9, 0, -1.5 }, { -6.4, 0, -4.9 }, { 1, 0, -5.4 }, { 4.2, 0, -3 },
      { 4.4, 0, 2.6 }, { 3, 0, 4.6 }, { 0.6, 0, 5 },
    },
  },
  g.path { name = "arcade_way", points = { { -10.9, 0.12, -7.6 }, { -10.9, 0.12, 7.6 } }, closed = false },
  g.path {
    name = "terrace_way",
    points = {
      { 6.4, 0, 0.4 }, { 8.5, 0, -0.6 }, { 8.6, 0, -1.85 }, { 8.6, 1.2, -3.95 }, { 8.2, 1.2, -7 }, { 11, 1.2, -7.4 },
    },
    closed = false,
  },
  g.path {
    name = "gate_way",
    points = {
      { -0.9, 0, 6.4 }, { -0.9, 0, 9.3 }, { -0.9, -0.5, 10.3 }, { -2.4, -0.5, 16 }, { 2.4, -0.5, 17 },
      { 0.9, -0.5, 10.3 }, { 0.9, 0, 9.3 }, { 0.9, 0, 6.4 },
    },
  },
}

-- Way, share of it at which each begins, metres a second; negative speeds go the other way round.
local people = {
  { "promenade", 0.02, 1.3 }, { "promenade", 0.17, 1.1 }, { "promenade", 0.2, 1.1 }, { "promenade", 0.36, -1.25 },
  { "promenade", 0.48, 1.4 }, { "promenade", 0.6, -1.15 }, { "promenade", 0.74, 1.2 }, { "promenade", 0.88, -1.35 },
  { "arcade_way", 0.1, 1.0 }, { "arcade_way", 0.35, 1.2 }, { "arcade_way", 0.8, 0.9 },
  { "terrace_way", 0.22, 1.0 }, { "terrace_way", 0.55, 1.1 },
  { "gate_way", 0.05, 1.2 }, { "gate_way", 0.3, 1.3 }, { "gate_way", 0.52, 1.1 }, { "gate_way", 0.8, 1.25 },
}

local walkers = {}
for i, person in ipairs(people) do
  local way, start, speed = table.unpack(person)
  walkers[i] = g.model {
    name = "walker_" .. i, file = "models/walker.glb", animation = "walk", animation_speed = math.abs(speed) / kStride,
    animation_start = (i * 0.37) % 1, path = way, path_start = start, path_speed = speed,
  }
end

return { ways, walkers }
