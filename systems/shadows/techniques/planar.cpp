// Casters projected on flat receivers: the right choice for floors and walls, where its edges are
// exact for hard lights at any size on screen and any distance from the light. It costs the
// casters' triangles once per receiver, and once more for every point of a light whose penumbra
// is wide enough to be seen. Its artefacts: few points make bands of a penumbra, and a receiver
// that is not quite flat shows the shadow where its plane would.
//
// The stencil holds the pixels of one receiver at a time, so that nothing can hang in the air,
// fight with the receiver's depth or paint over what lies on it; each pixel is darkened once, and
// loses its mark by it.

#include "systems/shadows/planar_prediction.hpp"
#include "systems/shadows/techniques/planar_job.hpp"

namespace shadows {

namespace {

class Planar final : public ShadowTechnique {
public:
    [[nodiscard]] const TechniqueTraits& traits() const override {
        static constexpr TechniqueTraits kTraits{
            "planar", "casters projected on flat receivers, held to them by the stencil"};
        return kTraits;
    }

    [[nodiscard]] engine::Result<Prediction>
    predict(const PairView& pair, const CasterGroup& casters) const override {
        return predict_planar(pair, casters);
    }

    [[nodiscard]] std::unique_ptr<ShadowJob> start() const override { return make_planar_job(); }
};

} // namespace

std::unique_ptr<ShadowTechnique> make_planar() {
    return std::make_unique<Planar>();
}

} // namespace shadows
