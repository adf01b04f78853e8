// Six shadow maps round a point light, or round a spot too wide for one. Each face sees a few
// texels past its edges, so that filters meet no seam.

#include "systems/shadows/techniques/local_map_job.hpp"

namespace shadows {

namespace {

class CubeMap final : public ShadowTechnique {
public:
    [[nodiscard]] const TechniqueTraits& traits() const override {
        static constexpr TechniqueTraits kTraits{
            "cube_map", "six shadow maps round a point light or a wide spot"};
        return kTraits;
    }

    [[nodiscard]] engine::Result<Prediction>
    predict(const PairView& pair, const CasterGroup& casters) const override {
        if (pair.light.light.kind == scene::LightKind::directional)
            return engine::Error{"it serves point and spot lights"};
        return predict_map(pair, casters, pyramid_texel_of_one(pair, 1.0), 6);
    }

    [[nodiscard]] std::unique_ptr<ShadowJob> start() const override {
        return std::make_unique<LocalMapJob>(LocalMapJob::Kind::cube, "cube_map");
    }
};

} // namespace

std::unique_ptr<ShadowTechnique> make_cube_map() {
    return std::make_unique<CubeMap>();
}

} // namespace shadows
