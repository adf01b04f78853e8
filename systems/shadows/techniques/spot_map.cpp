// The shadow map of a spot light. Right for anything inside the cone; texels grow with the distance
// from the light and with the tangent of the cone's angle.

#include "systems/shadows/techniques/local_map_job.hpp"

#include <fmt/format.h>

#include <cmath>

namespace shadows {

namespace {

class SpotMap final : public ShadowTechnique {
public:
    [[nodiscard]] const TechniqueTraits& traits() const override {
        static constexpr TechniqueTraits kTraits{"spot_map", "the shadow map of a spot light"};
        return kTraits;
    }

    [[nodiscard]] engine::Result<Prediction>
    predict(const PairView& pair, const CasterGroup& casters) const override {
        const scene::Light& light = pair.light.light;
        if (light.kind != scene::LightKind::spot) return engine::Error{"it serves spot lights"};
        const auto angle = static_cast<double>(light.outer_angle);
        if (angle > kWidestSpot)
            return engine::Error{fmt::format(
                "the cone opens {:.0f} degrees to each side, more than {:.0f}",
                glm::degrees(angle),
                glm::degrees(kWidestSpot))};
        return predict_map(pair, casters, pyramid_texel_of_one(pair, std::tan(angle)), 1);
    }

    [[nodiscard]] std::unique_ptr<ShadowJob> start() const override {
        return std::make_unique<LocalMapJob>(LocalMapJob::Kind::spot, "spot_map");
    }
};

} // namespace

std::unique_ptr<ShadowTechnique> make_spot_map() {
    return std::make_unique<SpotMap>();
}

} // namespace shadows
