// No shadow at all: the right choice when its absence is under the budget anyway, because it would
// be too small on screen. Its error is the whole shadow.

#include "systems/shadows/error_model.hpp"
#include "systems/shadows/shadow_technique.hpp"

namespace shadows {

namespace {

class None final : public ShadowTechnique {
public:
    [[nodiscard]] const TechniqueTraits& traits() const override {
        static constexpr TechniqueTraits kTraits{
            "none", "no shadow, when its error is under the budget anyway"};
        return kTraits;
    }

    [[nodiscard]] engine::Result<Prediction>
    predict(const PairView& pair, const CasterGroup& casters) const override {
        const ShadowFootprint shadow = shadow_footprint(pair, casters);
        Prediction prediction;
        prediction.error_area_px = shadow.area_px;
        prediction.error_px = shadow.length_px > 0.0 ? shadow.area_px / shadow.length_px : 0.0;
        return prediction;
    }

    [[nodiscard]] std::unique_ptr<ShadowJob> start() const override { return nullptr; }
};

} // namespace

std::unique_ptr<ShadowTechnique> make_none() {
    return std::make_unique<None>();
}

} // namespace shadows
