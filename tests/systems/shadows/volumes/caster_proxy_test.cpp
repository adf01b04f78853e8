#include "systems/shadows/volumes/caster_proxy.hpp"
#include "systems/shadows/volumes/volume_prediction.hpp"
#include "tests/systems/shadows/scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace shadows {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A box over a floor; the box has proxies that are off by 1 mm, 1 cm and 10 cm.
struct CasterProxy : testing::Test {
    ShadowScene scene = box_over_floor();
    scene::ShadowWish wish;
    double budget_px = 1.0;

    CasterProxy() {
        CasterView& box = scene.casters[0];
        box.closed = true;
        box.triangles = 64000;
        box.proxies = {{{16000, 0.001}, {4000, 0.01}, {1000, 0.1}}};
    }

    ReceiverView& floor() { return scene.receivers[0]; }
    CasterView& box() { return scene.casters[0]; }

    [[nodiscard]] Prediction predict() const {
        const auto groups = group_casters(scene, scene.lights[0]);
        const auto predicted = predict_volume(
            {scene, scene.lights[0], scene.receivers[0], wish, budget_px}, groups.front());
        return predicted ? *predicted : Prediction();
    }
};

TEST_F(CasterProxy, NeverServesTheMeshThatItWasMadeFrom) {
    floor().entity = box().id;

    EXPECT_FALSE(proxy_may_serve(box(), 1, floor()));
}

TEST_F(CasterProxy, ServesAPlaneThatTheCasterStandsOn) {
    box().bounds.min.y = 0.0;
    box().bounds_mesh.min.y = 0.0F;
    box().world_from_mesh = glm::dmat4(1.0);
    floor().flat = true;
    floor().normal = {0.0, 1.0, 0.0};
    floor().offset = 0.0;
    floor().residual = 0.0;

    EXPECT_TRUE(proxy_may_serve(box(), 3, floor()));
}

TEST_F(CasterProxy, DoesNotServeAPlaneThatTheCasterStandsIn) {
    box().bounds.min.y = -0.2;
    box().bounds_mesh.min.y = -0.2F;
    box().world_from_mesh = glm::dmat4(1.0);

    EXPECT_FALSE(proxy_may_serve(box(), 1, floor()));
}

TEST_F(CasterProxy, ServesACurvedReceiverThatKeepsAwayFartherThanItsDeviation) {
    floor().flat = false;
    floor().bounds.max.y = 0.0;
    box().bounds.min.y = 0.05;

    EXPECT_TRUE(proxy_may_serve(box(), 2, floor()));
    EXPECT_FALSE(proxy_may_serve(box(), 3, floor()));
}

TEST_F(CasterProxy, IsTheCoarsestWithinTheBudget) {
    EXPECT_THAT(predict().proxy_levels, ElementsAre(1));
    budget_px = 1000.0;
    EXPECT_THAT(predict().proxy_levels, ElementsAre(3));
    budget_px = 0.05;
    EXPECT_THAT(predict().proxy_levels, IsEmpty());
}

TEST_F(CasterProxy, CostsLessAndErrsMore) {
    const double least = predict().error_px;
    const double cheaper = predict().cost.vertices;
    budget_px = 0.05;

    EXPECT_LT(predict().error_px, least);
    EXPECT_GT(predict().cost.vertices, 2.0 * cheaper);
}

TEST_F(CasterProxy, IsTheOneThatIsAskedForWhateverItsError) {
    wish.proxy = 2;
    EXPECT_THAT(predict().proxy_levels, ElementsAre(2));
    EXPECT_GT(predict().error_px, budget_px);
    wish.proxy = 0;
    EXPECT_THAT(predict().proxy_levels, IsEmpty());
    EXPECT_THAT(predict().note, IsEmpty());
}

TEST_F(CasterProxy, SaysWhyItIsNotTheOneThatIsAskedFor) {
    wish.proxy = 1;
    EXPECT_THAT(predict().note, HasSubstr("to its proxy 1"));
    box().proxies = {};
    EXPECT_THAT(predict().note, HasSubstr("only heroes"));
    box().deforms = true;
    EXPECT_THAT(predict().note, HasSubstr("in a pose"));
    box().deforms = false;
    box().closed = false;
    EXPECT_THAT(predict().note, HasSubstr("not closed"));
}

TEST_F(CasterProxy, IsOffByMoreWhereALampMagnifiesIt) {
    wish.proxy = 1;
    const double under_sun = predict().error_px;
    LightView& light = scene.lights[0];
    light.light.kind = scene::LightKind::point;
    light.light.range = 1000.0F;
    light.position = box().bounds.centre() + glm::dvec3(0.0, 2.0, 0.0);

    EXPECT_GT(predict().error_px, 1.2 * under_sun);
}

} // namespace
} // namespace shadows
