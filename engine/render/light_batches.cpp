#include "engine/render/light_batches.hpp"

#include <render/shared/lights.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace render {

namespace {

constexpr int kTileSize = 64;

bool overlap(const gpu::Rect& a, const gpu::Rect& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height
           && b.y < a.y + a.height;
}

/// The first layer on which nothing overlaps `area`, if there is one left.
std::optional<int> free_layer(const LightBatch& batch, const gpu::Rect& area) {
    for (int layer = 0; layer < MAX_MASK_LAYERS; ++layer) {
        const bool taken =
            std::any_of(batch.lights.begin(), batch.lights.end(), [&](const BatchLight& other) {
                return other.layer == layer && overlap(other.area, area);
            });
        if (!taken) return layer;
    }
    return std::nullopt;
}

/// False when the batch has no room for the light.
bool add_light(LightBatch& batch, std::uint32_t light, const gpu::Rect& area, bool masked) {
    if (batch.lights.size() == MAX_BATCH_LIGHTS) return false;
    const auto layer = masked ? free_layer(batch, area) : std::nullopt;
    if (masked && !layer) return false;
    batch.lights.push_back({light, area, layer});
    if (layer) batch.layer_count = std::max(batch.layer_count, *layer + 1);
    return true;
}

std::uint32_t lights_at(const LightBatch& batch, const gpu::Rect& tile) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < batch.lights.size(); ++i)
        if (overlap(batch.lights[i].area, tile)) bits |= 1U << i;
    return bits;
}

} // namespace

gpu::Rect screen_rect(const scene::CameraView& camera, const scene::PlacedLight& light) {
    const gpu::Rect whole{0, 0, camera.width, camera.height};
    if (light.light.kind == scene::LightKind::directional || !std::isfinite(light.light.range))
        return whole;
    const double range = static_cast<double>(light.light.range);
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high(-low);
    bool any_behind = false;
    bool all_behind = true;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(
            (corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
        const glm::dvec3 at = camera.project(light.position + side * range);
        const bool behind = at.z < static_cast<double>(camera.near);
        any_behind = any_behind || behind;
        all_behind = all_behind && behind;
        low = glm::min(low, glm::dvec2(at));
        high = glm::max(high, glm::dvec2(at));
    }
    if (all_behind) return {};
    if (any_behind) return whole;
    const int left =
        static_cast<int>(std::clamp(std::floor(low.x), 0.0, static_cast<double>(camera.width)));
    const int right =
        static_cast<int>(std::clamp(std::ceil(high.x), 0.0, static_cast<double>(camera.width)));
    const int top =
        static_cast<int>(std::clamp(std::floor(low.y), 0.0, static_cast<double>(camera.height)));
    const int bottom =
        static_cast<int>(std::clamp(std::ceil(high.y), 0.0, static_cast<double>(camera.height)));
    return {left, camera.height - bottom, right - left, bottom - top};
}

std::vector<LightBatch> batch_lights(
    std::span<const scene::PlacedLight> lights,
    std::span<const gpu::Rect> areas,
    const std::vector<bool>& masked) {
    std::vector<LightBatch> batches(1);
    for (std::uint32_t light = 0; light < areas.size(); ++light) {
        if (areas[light].empty()) continue;
        if (add_light(batches.back(), light, areas[light], masked[light])) continue;
        batches.emplace_back();
        add_light(batches.back(), light, areas[light], masked[light]);
    }
    for (LightBatch& batch : batches)
        std::stable_partition(
            batch.lights.begin(), batch.lights.end(), [&](const BatchLight& entry) {
                return lights[entry.light].light.kind == scene::LightKind::directional;
            });
    return batches;
}

std::vector<LightTile> light_tiles(const LightBatch& batch, int width, int height) {
    std::vector<LightTile> tiles;
    std::size_t row_below = 0; // first tile of the row below, while it can still grow upward
    for (int y = 0; y < height; y += kTileSize) {
        const int top = std::min(y + kTileSize, height);
        std::vector<LightTile> row;
        for (int x = 0; x < width; x += kTileSize) {
            const int right = std::min(x + kTileSize, width);
            const std::uint32_t bits = lights_at(batch, {x, y, right - x, top - y});
            if (!row.empty() && row.back().bits == bits)
                row.back().rectangle.z = static_cast<unsigned>(right);
            else
                row.push_back({glm::uvec4(x, y, right, top), bits});
        }
        const bool same = tiles.size() - row_below == row.size()
                          && std::equal(
                              row.begin(),
                              row.end(),
                              tiles.begin() + static_cast<std::ptrdiff_t>(row_below),
                              [](const LightTile& a, const LightTile& b) {
                                  return a.bits == b.bits && a.rectangle.x == b.rectangle.x
                                         && a.rectangle.z == b.rectangle.z;
                              });
        if (same && !tiles.empty()) {
            for (std::size_t i = row_below; i < tiles.size(); ++i)
                tiles[i].rectangle.w = static_cast<unsigned>(top);
        } else {
            row_below = tiles.size();
            tiles.insert(tiles.end(), row.begin(), row.end());
        }
    }
    return tiles;
}

} // namespace render
