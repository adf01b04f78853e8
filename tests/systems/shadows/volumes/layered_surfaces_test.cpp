#include "engine/scene/primitives.hpp"
#include "systems/shadows/volumes/layered_surfaces.hpp"
#include "tests/support/worlds.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace shadows {
namespace {

scene::Mesh stack_of_slabs(int count) {
    const scene::Mesh slab = scene::make_box({2.0F, 0.005F, 2.0F});
    scene::Mesh stack = slab;
    for (int i = 1; i < count; ++i)
        test_support::add_part(stack, slab, {0.0F, 0.01F * static_cast<float>(i), 0.0F});
    stack.submeshes.clear();
    scene::finish_mesh(stack);
    return stack;
}

std::uint32_t triangles_of(const std::vector<LayeredSurface>& pieces) {
    return std::accumulate(
        pieces.begin(), pieces.end(), 0U, [](std::uint32_t sum, const LayeredSurface& piece) {
            return sum + piece.surface.triangle_count();
        });
}

TEST(LayeredSurfaces, ASurfaceWithFewLayersIsOnePiece) {
    EXPECT_EQ(make_layered_surfaces(scene::make_torus(1.0F, 0.3F)).size(), 1U);
}

TEST(LayeredSurfaces, NoPieceHasMoreLayersThanAStencilCounts) {
    const auto pieces = make_layered_surfaces(stack_of_slabs(256));

    EXPECT_GT(pieces.size(), 1U);
    for (const LayeredSurface& piece : pieces)
        EXPECT_LE(piece.layers, kMostLayers);
    EXPECT_EQ(triangles_of(pieces), 256U * 12U);
}

TEST(LayeredSurfaces, ClosedPartsStayWhole) {
    for (const LayeredSurface& piece : make_layered_surfaces(stack_of_slabs(256)))
        EXPECT_FALSE(piece.open);
}

TEST(LayeredSurfaces, OnePartWithTooManyLayersIsTornAndStillBlocksTriangleByTriangle) {
    // A ribbon folded to and fro.
    scene::Mesh ribbon;
    for (int i = 0; i <= 400; ++i) {
        const auto height = static_cast<float>(i) * 0.01F;
        const float x = i % 2 == 0 ? -1.0F : 1.0F;
        ribbon.positions.push_back({x, height, -1.0F});
        ribbon.positions.push_back({x, height, 1.0F});
    }
    for (std::uint32_t i = 0; i < 400; ++i)
        for (const std::uint32_t k : {0U, 1U, 2U, 2U, 1U, 3U})
            ribbon.indices.push_back(2 * i + k);
    ribbon.normals.assign(ribbon.positions.size(), {0.0F, 1.0F, 0.0F});
    scene::finish_mesh(ribbon);

    const auto pieces = make_layered_surfaces(ribbon);

    EXPECT_GT(pieces.size(), 1U);
    for (const LayeredSurface& piece : pieces) {
        EXPECT_LE(piece.layers, kMostLayers);
        EXPECT_TRUE(piece.open);
    }
    EXPECT_EQ(triangles_of(pieces), 800U);
}

TEST(LayeredSurfaces, AMeshWithoutTrianglesHasNone) {
    EXPECT_TRUE(make_layered_surfaces(scene::Mesh()).empty());
}

} // namespace
} // namespace shadows
