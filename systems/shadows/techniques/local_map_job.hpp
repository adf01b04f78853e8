// Shadow maps that see from a point: one pyramid for a spot, six for a point light.

#pragma once

#include "systems/shadows/maps/local_fit.hpp"
#include "systems/shadows/techniques/map_job.hpp"

namespace shadows {

/// Texel of a pyramid with a single texel at the pair's receiver, metres across the light.
double pyramid_texel_of_one(const PairView& pair, double tan_half);

class LocalMapJob final : public MapJob {
public:
    enum class Kind : std::uint8_t { spot, cube };

    LocalMapJob(Kind kind, std::string_view technique) : MapJob(technique), kind_(kind) {}

    [[nodiscard]] Resolution
    resolution(const scene::CameraView& camera, const SurfacePoint& point) const override;

protected:
    void fit(const ShadowRequest& request, int size) override;
    [[nodiscard]] int layers() const override { return kind_ == Kind::spot ? 1 : 6; }
    [[nodiscard]] glm::dmat4 map_from_world(int layer) const override {
        return views_[static_cast<std::size_t>(layer)].map_from_world();
    }
    [[nodiscard]] bool reaches(int layer, const engine::WorldAabb& caster) const override {
        return sees(views_[static_cast<std::size_t>(layer)], caster);
    }
    [[nodiscard]] double texel_m_of_one(const PairView& pair) const override;
    [[nodiscard]] gpu::Defines mask_defines() const override {
        return {kind_ == Kind::spot ? "SPOT" : "CUBE", "MAP_LAYERS=1"};
    }
    void place(const gpu::Program& mask, const scene::CameraView& camera) const override;

private:
    /// From the light to the nearest blocker that penumbrae know of, metres.
    [[nodiscard]] double nearest_blocker() const;

    Kind kind_;
    std::vector<PyramidView> views_;
};

} // namespace shadows
