-- The vocabulary of levels: local g = require "gnomon".
--
-- The engine hands in its constructors, one for each kind of the scene schema; each takes a table and
-- remembers where it was written. docs/reference.md lists their fields.

local native = ...

local words = {}
for word, constructor in pairs(native.constructors) do
  words[word] = constructor
end

-- The world of a running level: see on_update.
words.world = native.world

-- The exact sRGB decoding of one channel, 0..255. Source: IEC 61966-2-1.
local function linear(channel)
  local c = channel / 255
  if c <= 0.04045 then
    return c / 12.92
  end
  return ((c + 0.055) / 1.055) ^ 2.4
end

-- A linear colour from the way pictures and web pages write it: srgb("#ff8800") or srgb(255, 136, 0).
function words.srgb(red, green, blue)
  if type(red) == "string" then
    local r, g, b = red:match("^#(%x%x)(%x%x)(%x%x)$")
    if not r then
      error("srgb wants \"#rrggbb\" or three numbers from 0 to 255, found \"" .. red .. "\"", 2)
    end
    red, green, blue = tonumber(r, 16), tonumber(g, 16), tonumber(b, 16)
  end
  for _, channel in ipairs({ red, green or false, blue or false }) do
    if type(channel) ~= "number" or channel < 0 or channel > 255 then
      error("srgb wants \"#rrggbb\" or three numbers from 0 to 255", 2)
    end
  end
  return { linear(red), linear(green), linear(blue) }
end

return setmetatable({}, {
  __index = function(_, word)
    return words[word] or native.unknown(word)
  end,
  __newindex = function(_, word)
    error("the vocabulary has no place for '" .. tostring(word) .. "'; write: local name = ...", 2)
  end,
  __metatable = false,
})
