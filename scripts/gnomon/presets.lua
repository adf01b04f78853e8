-- What shadows may cost and how they are made, in four sizes: g.scene { preset = "high", ... }.
-- Whatever a level says itself wins. Times are those of a software rasteriser; a graphics card needs a fraction.

return {
  low = {
    budget = { error_px = 4, shadow_ms = 6 },
    shadow = { map_size = 512, filter = "bilinear", samples = 4, cascades = 2 },
  },
  medium = {
    budget = { error_px = 2, shadow_ms = 12 },
    shadow = { map_size = 1024, filter = "pcf", samples = 8, cascades = 3 },
  },
  high = {
    budget = { error_px = 1, shadow_ms = 25 },
    shadow = { map_size = 2048, filter = "pcf", samples = 16, cascades = 4 },
  },
  -- No cap on time: accuracy alone decides.
  ultra = {
    budget = { error_px = 0.5 },
    shadow = { map_size = 4096, filter = "pcss", samples = 64, cascades = 4 },
  },
}
