// Failures of stencil shadow volumes that come from the caster: open, branching, badly wound, torn
// and mirrored meshes, and lamps in the plane of a side or amid it all.
//
// Source: B. Kim, K. Kim and G. Turk, "A Shadow Volume Algorithm for Opaque and Transparent
// Non-Manifold Casters", jgt 13(3), 2008.

#include "tests/atlas/volume_stage.hpp"
#include "tests/support/worlds.hpp"

#include <cmath>

namespace atlas {

namespace {

using shadows::Remedy;
using test_support::at;
using test_support::floor_of;
using test_support::sun_along;
using test_support::WorldBuilder;

/// A sheet, seen and lit from both sides in turn.
Stage tilted_sheet(double degrees) {
    WorldBuilder builder = floor_of(20.0F);
    builder.world.assets.materials.emplace_back().double_sided = true;
    scene::Mesh sheet = scene::make_plane({2.0F, 2.0F});
    sheet.submeshes[0].material = 1;
    scene::Transform place = at({0.0, 2.0, 0.0});
    place.rotation =
        glm::angleAxis(static_cast<float>(glm::radians(degrees)), glm::vec3(1.0F, 0.0F, 0.0F));
    builder.add("sheet", std::move(sheet), place);
    builder.add_light(lamp_at({0.0, 5.0, 0.0}));
    return served(builder, "lamp", "sheet");
}

/// Three sheets that share one upright edge.
Stage turnstile(double yaw_degrees) {
    WorldBuilder builder = floor_of(20.0F);
    builder.world.assets.materials.emplace_back().double_sided = true;
    scene::Mesh mesh;
    mesh.positions = {{0.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
    for (int i = 0; i < 3; ++i) {
        const auto angle = static_cast<float>(glm::radians(yaw_degrees + 120.0 * i));
        const glm::vec3 out(2.0F * std::cos(angle), 0.0F, 2.0F * std::sin(angle));
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(out);
        mesh.positions.push_back(out + glm::vec3(0.0F, 1.0F, 0.0F));
        for (const std::uint32_t index : {0U, first, first + 1, 0U, first + 1, 1U})
            mesh.indices.push_back(index);
    }
    mesh.normals.assign(mesh.positions.size(), {0.0F, 1.0F, 0.0F});
    scene::finish_mesh(mesh);
    mesh.submeshes[0].material = 1;
    builder.add("turnstile", std::move(mesh), at({0.0, 0.3, 0.0}));
    builder.add_light(sun_along({1.0, -1.0, 0.3}));
    return served(builder, "sun");
}

/// A ball whose every n-th triangle is wound the wrong way round.
Stage badly_wound_ball(double every) {
    WorldBuilder builder = floor_of(20.0F);
    scene::Mesh ball = scene::make_sphere(0.8F, 16);
    for (std::size_t t = 0; 3 * t < ball.indices.size(); t += static_cast<std::size_t>(every))
        std::swap(ball.indices[3 * t], ball.indices[3 * t + 1]);
    scene::finish_mesh(ball);
    builder.add("ball", std::move(ball), at({0.0, 1.2, 0.0}));
    builder.add_light(sun_along({1.0, -1.2, 0.3}));
    return served(builder, "sun");
}

/// A wall split by a vertex on the middle of an edge that its neighbour does not have, no two
/// triangles with a vertex in common.
Stage torn_wall(double yaw_degrees) {
    WorldBuilder builder = floor_of(20.0F);
    const scene::Mesh box = scene::make_box({2.0F, 2.0F, 0.4F});
    scene::Mesh soup;
    const auto add = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        for (const glm::vec3& p : {a, b, c}) {
            soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
            soup.positions.push_back(p);
        }
    };
    for (std::size_t t = 0; t < box.indices.size(); t += 3) {
        const glm::vec3 a = box.positions[box.indices[t]];
        const glm::vec3 b = box.positions[box.indices[t + 1]];
        const glm::vec3 c = box.positions[box.indices[t + 2]];
        if (t % 12 == 0) {
            add(a, (a + b) * 0.5F, c);
            add((a + b) * 0.5F, b, c);
        } else {
            add(a, b, c);
        }
    }
    soup.normals.assign(soup.positions.size(), {0.0F, 1.0F, 0.0F});
    scene::finish_mesh(soup);
    scene::Transform place = at({0.0, 1.3, 0.0});
    place.rotation =
        glm::angleAxis(static_cast<float>(glm::radians(yaw_degrees)), glm::vec3(0.0F, 1.0F, 0.0F));
    builder.add("wall", std::move(soup), place);
    builder.add_light(lamp_at({1.0, 5.0, 3.0}));
    return served(builder, "lamp");
}

/// A ball with triangles that have no area: twin corners, and corners on one line.
Stage degenerate_ball(double every) {
    WorldBuilder builder = floor_of(20.0F);
    scene::Mesh ball = scene::make_sphere(0.8F, 24);
    const std::size_t count = ball.indices.size() / 3;
    for (std::size_t t = 0; t < count; t += static_cast<std::size_t>(every)) {
        const std::uint32_t a = ball.indices[3 * t];
        const std::uint32_t b = ball.indices[3 * t + 1];
        for (const std::uint32_t index : {a, a, b, a, b, a})
            ball.indices.push_back(index);
    }
    ball.submeshes.clear();
    scene::finish_mesh(ball);
    builder.add("ball", std::move(ball), at({0.0, 1.2, 0.0}));
    builder.add_light(sun_along({1.0, -1.2, 0.3}));
    return served(builder, "sun");
}

/// A lamp that passes through the plane of a cube's side.
Stage lamp_in_plane(double offset) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("cube", scene::make_box(glm::vec3(1.0F)), at({0.0, 1.5, 0.0}));
    builder.add_light(lamp_at({0.5 + offset, 4.0, 0.5}));
    return served(builder, "lamp");
}

/// A lamp inside a lattice of bars.
Stage lantern(double height) {
    WorldBuilder builder = floor_of(20.0F);
    scene::Mesh bars = scene::make_box({0.1F, 1.0F, 0.1F});
    const scene::Mesh bar = bars;
    for (const glm::vec3& offset :
         {glm::vec3(0.5F, 0.0F, 0.0F), glm::vec3(0.5F, 0.0F, 0.5F), glm::vec3(0.0F, 0.0F, 0.5F)})
        test_support::append(bars, bar, offset);
    test_support::append(bars, scene::make_box({0.7F, 0.05F, 0.7F}), {0.25F, 0.55F, 0.25F});
    builder.add("lantern", std::move(bars), at({0.0, 1.5, 0.0}));
    builder.add_light(lamp_at({0.25, height, 0.25}));
    return served(builder, "lamp");
}

/// The lamp is inside of what it lights the outside of.
Stage lamp_in_box(double height) {
    WorldBuilder builder = floor_of(20.0F);
    builder.add("box", scene::make_box(glm::vec3(1.0F)), at({0.0, 1.5, 0.0}));
    builder.add_light(lamp_at({0.2, height, 0.1}));
    return served(builder, "lamp");
}

/// What is mirrored is wound the other way round on screen.
Stage mirrored_ring(double turn) {
    WorldBuilder builder = floor_of(20.0F);
    scene::Transform place = at({0.0, 1.5, 0.0}, {-1.0F, 1.3F, 0.8F});
    place.rotation = glm::angleAxis(static_cast<float>(turn), glm::vec3(1.0F, 0.0F, 0.0F));
    builder.add("ring", scene::make_torus(1.0F, 0.35F), place);
    builder.add_light(lamp_at({1.5, 5.0, 2.0}));
    return served(builder, "lamp", "ring");
}

} // namespace

std::vector<Case> volume_mesh_cases() {
    const std::vector<Gate> exact = exact_shape();
    return {
        {.id = "V6",
         .sentence = "a sheet throws no shadow when its back is lit",
         .build = tilted_sheet,
         .sweep = {3.0, 183.0, 160.0},
         .remedy = Remedy::volume_signed_edges,
         .gates = exact},
        {.id = "V7",
         .sentence = "three sheets at one edge throw streaks",
         .build = turnstile,
         .sweep = {0.0, 120.0, 40.0},
         .remedy = Remedy::volume_signed_edges,
         .gates = exact},
        {.id = "V8",
         .sentence = "triangles wound the wrong way round throw shadows of their own",
         .build = badly_wound_ball,
         .sweep = {2.0, 17.0, 10.0},
         .remedy = Remedy::volume_signed_edges,
         .gates = exact},
        {.id = "V9",
         .sentence = "a soup of triangles with a vertex amid an edge throws cracks",
         .build = torn_wall,
         .sweep = {0.0, 90.0, 30.0},
         .remedy = std::nullopt,
         .gates = exact},
        {.id = "V10",
         .sentence = "triangles without an area tear the outline",
         .build = degenerate_ball,
         .sweep = {1.0, 21.0, 20.0},
         .remedy = std::nullopt,
         .gates = exact},
        {.id = "V11",
         .sentence = "sides and caps disagree where the lamp is in a side's plane",
         .build = lamp_in_plane,
         .sweep = {-1e-2, 1e-2, 0.0},
         .remedy = std::nullopt,
         .gates = exact},
        {.id = "Lantern",
         .sentence = "a lamp among bars is lost in their box",
         .build = lantern,
         .sweep = {1.2, 1.9, 1.5},
         .remedy = std::nullopt,
         .gates = exact},
        {.id = "LampInBox",
         .sentence = "a closed box lets the lamp inside it out",
         .build = lamp_in_box,
         .sweep = {1.1, 1.9, 1.5},
         .remedy = std::nullopt,
         .gates = {no_light_leak_inside(), no_false_shadow_inside()}},
        {.id = "Mirrored",
         .sentence = "a mirrored mesh is counted inside out",
         .build = mirrored_ring,
         .sweep = {0.0, 1.5, 0.6},
         .remedy = std::nullopt,
         .gates = exact},
    };
}

} // namespace atlas
