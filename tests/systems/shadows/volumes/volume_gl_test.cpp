// What stencil volumes promise on the device: both ways to count agree, and a lit cap lies exactly
// where the G-buffer has the surface.

#include "engine/core/random.hpp"
#include "tests/support/worlds.hpp"
#include "tests/systems/shadows/volumes/random_places.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

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

TEST_F(VolumesDrawn, AreCountedAlikeFromAnEyeInTheirMidst) {
    engine::Random random(29);
    std::size_t cheaper = 0;
    for (int i = 0; i < 24; ++i) {
        SCOPED_TRACE(i);
        const scene::PlacedLight light =
            i % 2 == 0 ? test_support::sun_light()
                       : test_support::lamp_light("lamp", {1.0, 5.0, 2.0}, 100.0F, 1000.0F);
        make_level(light, i % 3 == 0 ? torn_ring() : scene::make_torus(1.0F, 0.35F));
        // Below the ring, the cube or the ball, where the light would go on.
        const glm::dvec3 caster = std::array<glm::dvec3, 3>{
            {{0.9, 1.5, 0.0}, {2.0, 0.9, 1.0}, {-2.0, 1.0, 1.0}}}[static_cast<std::size_t>(i) % 3];
        const glm::dvec3 away =
            i % 2 == 0 ? glm::dvec3(light.direction) : glm::normalize(caster - light.position);
        const glm::dvec3 eye = caster + away * 0.9 + unit_vector(random) * 0.15;
        const scene::CameraView camera =
            camera_looking(eye, eye + glm::normalize(unit_vector(random) + away), kSize, kSize);

        const engine::Image started = mask(camera, {});
        const std::uint64_t triangles = studio->renderer().frame().counters().triangles;
        const engine::Image behind = mask(camera, Remedies().without(Remedy::volume_start_count));

        EXPECT_EQ(started.bytes, behind.bytes);
        cheaper += triangles < studio->renderer().frame().counters().triangles ? 1 : 0;
    }
    EXPECT_GT(cheaper, 8U);
}

/// What a proxy does to the shadow on the floor.
struct ProxyDrawn : VolumesDrawn {
    struct Error {
        double predicted_px = 0.0; ///< of edge displacement
        double measured_px = 0.0;  ///< pixels that differ from the caster's own shadow, per edge
    };

    /// A smooth ring over a floor, and the volume's own error left out.
    Error of_level(int proxy, const scene::CameraView& camera) {
        level.shadows.scene.proxy = 0;
        const engine::Image own = mask(camera, {});
        const std::vector<std::uint32_t> ids = studio->receiver_ids();
        const auto [floor, own_px] = floor_plan();
        level.shadows.scene.proxy = proxy;
        const engine::Image simple = mask(camera, {});
        const double differing =
            count(ids, floor, [&](std::size_t i) { return own.bytes[i] != simple.bytes[i]; });
        const double cracks = count(
                                  ids,
                                  floor,
                                  [&](std::size_t i) {
                                      return i + 1 < ids.size() && ids[i + 1] == floor
                                             && own.bytes[i] != own.bytes[i + 1];
                                  })
                              + count(ids, floor, [&](std::size_t i) {
                                    return i + kSize < ids.size() && ids[i + kSize] == floor
                                           && own.bytes[i] != own.bytes[i + kSize];
                                });
        // Crofton: edges of a grid are longer than the curve that they follow.
        const double edge_px = cracks * std::numbers::pi / 4.0;
        return {floor_plan().second - own_px, differing / edge_px};
    }

    template <class Wanted>
    static double count(const std::vector<std::uint32_t>& ids, std::uint32_t floor, Wanted wanted) {
        double sum = 0.0;
        for (std::size_t i = 0; i < ids.size(); ++i)
            sum += ids[i] == floor && wanted(i) ? 1.0 : 0.0;
        return sum;
    }

    /// The floor's id and its predicted error.
    std::pair<std::uint32_t, double> floor_plan() {
        for (const Plan& plan : studio->shadows().plan().plans)
            if (studio->shadows().scene().receiver(plan.receiver).name.starts_with("floor"))
                return {plan.receiver, plan.entries.at(0).predicted.error_px};
        ADD_FAILURE() << "the floor has no plan";
        return {0, 0.0};
    }
};

TEST_F(ProxyDrawn, ItsErrorIsAtMostAsPredictedAndNotFarLess) {
    const std::vector<scene::PlacedLight> lights = {
        test_support::sun_light(),
        test_support::lamp_light("lamp", {1.0, 5.0, 2.0}, 100.0F, 1000.0F)};
    for (const scene::PlacedLight& light : lights) {
        test_support::WorldBuilder builder = test_support::floor_of(20.0F);
        scene::Mesh ring = scene::make_torus(1.0F, 0.35F, 96, 40);
        ring.proxies = scene::make_proxies(ring);
        const int levels = static_cast<int>(ring.proxies.size());
        ASSERT_GE(levels, 2);
        builder.add("ring", std::move(ring), at({0.0, 1.5, 0.0}));
        builder.add_light(light);
        level.world = std::move(builder.world);
        level.shadows.scene.technique = "volume";
        scene::update(level.world, 0.0F);
        for (int proxy = 1; proxy <= levels; ++proxy) {
            const Error error =
                of_level(proxy, camera_looking({0.0, 4.0, 5.0}, {0.0, 0.0, 0.0}, kSize, kSize));
            SCOPED_TRACE(fmt::format(
                "{}, proxy {}: {:.3f} px predicted, {:.3f} measured",
                light.name,
                proxy,
                error.predicted_px,
                error.measured_px));

            EXPECT_GT(error.measured_px, 0.0);
            EXPECT_LE(error.measured_px, error.predicted_px);
            EXPECT_LE(error.predicted_px, 12.0 * error.measured_px);
        }
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
