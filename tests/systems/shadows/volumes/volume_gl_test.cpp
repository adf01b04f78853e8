// What stencil volumes promise on the device: both ways to count agree, and a lit cap lies exactly
// where the G-buffer has the surface.

#include "engine/core/random.hpp"
#include "tests/support/worlds.hpp"
#include "tests/systems/shadows/volumes/random_places.hpp"

#include <gtest/gtest.h>

#include "tools/gnomon/studio.hpp"

namespace shadows {
namespace {

using test_support::at;
using test_support::camera_looking;

constexpr int kSize = 192;

/// An open ring: what is seen through its hole needs its caps.
scene::Mesh torn_ring() {
    scene::Mesh ring = scene::make_torus(1.0F, 0.35F);
    ring.indices.resize(ring.indices.size() - 3);
    ring.submeshes.clear();
    scene::finish_mesh(ring);
    return ring;
}

struct VolumesDrawn : testing::Test {
    std::unique_ptr<gnomon::Studio> studio;
    gnomon::Level level;

    void SetUp() override {
        auto opened = gnomon::Studio::open(kSize, kSize);
        if (!opened) GTEST_SKIP() << "no OpenGL here";
        studio = *std::move(opened);
    }

    /// A floor and casters over it, lit by a lamp or a sun, all by volumes.
    void make_level(const scene::PlacedLight& light, scene::Mesh ring) {
        test_support::WorldBuilder builder;
        builder.add("floor", scene::make_plane(glm::vec2(20.0F)));
        scene::Transform tilted = at({0.0, 1.5, 0.0});
        tilted.rotation = glm::angleAxis(0.6F, glm::normalize(glm::vec3(1.0F, 0.3F, 0.2F)));
        builder.add("ring", std::move(ring), tilted);
        builder.add("cube", scene::make_box(glm::vec3(1.0F)), at({2.0, 0.5, 1.0}));
        builder.add("ball", scene::make_sphere(0.7F), at({-2.0, 1.0, 1.0}, {1.0F, 1.4F, -0.8F}));
        builder.add_light(light);
        level.world = std::move(builder.world);
        level.shadows.scene.technique = "volume";
        scene::update(level.world, 0.0F);
    }

    engine::Image mask(const scene::CameraView& camera, const Remedies& remedies) {
        studio->shadows().remedies = remedies;
        studio->shadows().always_refresh = true;
        EXPECT_TRUE(studio->draw(level, camera));
        auto drawn = studio->mask(0);
        EXPECT_TRUE(drawn);
        return drawn ? *std::move(drawn) : engine::Image();
    }

    std::size_t z_fail_differs(const scene::CameraView& camera) {
        const engine::Image mixed = mask(camera, {});
        const engine::Image all_z_fail = mask(camera, Remedies().without(Remedy::volume_z_pass));
        std::size_t count = 0;
        for (std::size_t i = 0; i < mixed.bytes.size(); ++i)
            count += mixed.bytes[i] != all_z_fail.bytes[i] ? 1 : 0;
        return count;
    }
};

TEST_F(VolumesDrawn, AreCountedAlikeFromBeforeAndFromBehind) {
    engine::Random random(23);
    for (int i = 0; i < 24; ++i) {
        SCOPED_TRACE(i);
        make_level(
            i % 2 == 0 ? test_support::sun_light()
                       : test_support::lamp_light("lamp", {1.0, 5.0, 2.0}, 100.0F, 1000.0F),
            i % 3 == 0 ? torn_ring() : scene::make_torus(1.0F, 0.35F));
        glm::dvec3 eye = unit_vector(random) * random.uniform(2.0, 9.0);
        eye.y = std::abs(eye.y) + 0.3;

        EXPECT_EQ(z_fail_differs(camera_looking(eye, {0.0, 1.0, 0.0}, kSize, kSize)), 0U);
    }
}

TEST_F(VolumesDrawn, LitCapsLieWhereTheGBufferHasTheSurfaceBitForBit) {
    make_level(test_support::sun_light(), torn_ring());
    const scene::CameraView camera = camera_looking({1.0, 5.0, 4.0}, {0.0, 1.0, 0.0}, kSize, kSize);
    const Remedies z_fail = Remedies().without(Remedy::volume_z_pass);

    const engine::Image strict = mask(camera, z_fail);
    const engine::Image lenient = mask(camera, z_fail.without(Remedy::volume_equal_depth));

    // A lit pixel stays lit when its own cap counts as behind it, and is dark when it does not:
    // both only when the depths are equal.
    const auto ids = studio->receiver_ids();
    std::size_t lit = 0;
    std::size_t equal = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const ReceiverView* seen = nullptr;
        for (const ReceiverView& receiver : studio->shadows().scene().receivers)
            if (receiver.id == ids[i]) seen = &receiver;
        if (seen == nullptr || seen->name != "ring" || strict.bytes[i] != 255) continue;
        ++lit;
        equal += lenient.bytes[i] == 0 ? 1 : 0;
    }
    EXPECT_GT(lit, 1000U);
    EXPECT_EQ(equal, lit);
}

} // namespace
} // namespace shadows
