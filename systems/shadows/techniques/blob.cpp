// A soft ellipse under each caster: the right choice for what is small on screen, where nobody can
// tell a shadow's outline from its caster's ellipsoid. It costs one rectangle per caster and no
// geometry. Its artefacts: every outline is an ellipse, holes are closed, and a caster never
// darkens itself.
//
// The ellipse is evaluated where each pixel's surface truly is, so it climbs steps, bends round
// edges and falls into pits by itself; it stops at nothing, because what lies in the shadow of the
// first receiver is dark anyway. Masks take the minimum, so a blob that lies in a shadow is never
// darker than it.

#include "engine/gpu/pass.hpp"
#include "engine/render/light_visibility.hpp"
#include "systems/shadows/blob_fit.hpp"
#include "systems/shadows/blob_prediction.hpp"
#include "systems/shadows/screen_bounds.hpp"
#include "systems/shadows/shadow_technique.hpp"
#include "systems/shadows/techniques/receiver_bits.hpp"

#include <fmt/format.h>
#include <render/shared/bindings.h>
#include <shadows/shared/blobs.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace shadows {

namespace {

/// Receiver ids of one entity: from, up to but not.
struct IdRange {
    std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t end = 0;
};

struct PlacedBlob {
    Blob blob;
    IdRange own;
    engine::WorldAabb bounds;                ///< of what it can darken
    double softness = 0.0;                   ///< the light's size over the blob's
    glm::dvec4 plane = {0.0, 1.0, 0.0, 0.0}; ///< of the first receiver behind it; for tests alone
};

/// The light's size as a tangent (sun) or in metres (lamp), over the blob's radius.
double softness_of(const LightView& light, const Blob& blob) {
    const double size = light.light.kind == scene::LightKind::directional
                            ? std::tan(static_cast<double>(light.light.angular_radius))
                            : static_cast<double>(light.light.radius);
    return size / disc_radius(blob, light);
}

/// A sun straight above, for tests.
LightView without_direction(LightView light) {
    light.light.kind = scene::LightKind::directional;
    light.direction = {0.0F, -1.0F, 0.0F};
    return light;
}

/// The plane of the first flat receiver that the light meets behind the blob's centre; the last
/// resort is the level of the centre.
glm::dvec4 first_plane(const ShadowScene& scene, const LightView& light, const glm::dvec3& centre) {
    const glm::dvec3 direction = light_direction(light, centre);
    glm::dvec4 plane(0.0, 1.0, 0.0, -centre.y);
    double nearest = std::numeric_limits<double>::infinity();
    for (const ReceiverView& receiver : scene.receivers) {
        if (!receiver.flat) continue;
        const double distance = (receiver.offset - glm::dot(receiver.normal, centre))
                                / glm::dot(receiver.normal, direction);
        const glm::dvec3 hit = centre + direction * distance;
        const double margin = 1e-6 * (1.0 + glm::length(hit));
        const engine::WorldAabb bounds{receiver.bounds.min - margin, receiver.bounds.max + margin};
        if (!(distance > 0.0) || distance >= nearest || !bounds.contains(hit)) continue;
        nearest = distance;
        plane = glm::dvec4(receiver.normal, -receiver.offset);
    }
    return plane;
}

class BlobJob final : public ShadowJob {
public:
    engine::Result<void> update(const ShadowRequest& request) override {
        remedies_ = request.remedies;
        light_ = request.scene.lights[request.light];
        if (!remedies_.on(Remedy::blob_along_light)) light_ = without_direction(light_);
        receivers_.assign(request.plans, request.receiver_end);
        place_blobs(request);
        return {};
    }

    engine::Result<void> render(
        gpu::Frame& /*frame*/,
        gpu::ShaderLibrary& shaders,
        const render::Geometry& /*geometry*/) override {
        gpu::Defines defines = {fmt::format("BLOB_EDGE={}", kBlobEdge)};
        if (!remedies_.on(Remedy::blob_on_surface)) defines.emplace_back("ON_PLANE");
        const auto program = shaders.graphics("shadows/blob.vert", "shadows/blob.frag", defines);
        if (!program) return program.error();
        program_ = *program;
        return {};
    }

    void apply(
        gpu::Frame& frame,
        const scene::CameraView& camera,
        const render::VisibilityTarget& target) override {
        std::vector<BlobData> seen;
        double pixels = 0.0;
        for (const PlacedBlob& blob : blobs_) {
            const PixelBox box = screen_bounds(camera, blob.bounds);
            if (box.empty()) continue;
            seen.push_back(data_of(blob, camera.position, box));
            pixels += box.area();
        }
        if (seen.empty()) return;
        buffer_.assign(gpu::bytes_of(seen));
        const gpu::ScopedPass pass(frame, fmt::format("blob/{}", light_.name), target.mask);
        gpu::RenderState state = gpu::kScreenState;
        state.blend = gpu::Blend::min;
        state.scissor = target.area;
        frame.state(state);
        receivers_.bind();
        buffer_.bind_storage(BLOBS_BINDING);
        target.gbuffer.bind(UNIT_GBUFFER);
        target.depth.bind(UNIT_DEPTH);
        frame.draw(
            *program_,
            no_vertices_,
            {.count = 4,
             .instances = static_cast<std::uint32_t>(seen.size()),
             .primitive = gpu::Primitive::triangle_strip});
        frame.counters().mask_fragments += static_cast<std::uint64_t>(pixels);
        frame.counters().taps += 2 * static_cast<std::uint64_t>(pixels);
    }

    [[nodiscard]] std::size_t gpu_bytes() const override { return buffer_.capacity_bytes(); }

private:
    /// One blob per caster of the plans, with bounds that cover every receiver it is drawn for.
    void place_blobs(const ShadowRequest& request) {
        const ShadowScene& scene = request.scene;
        std::unordered_map<std::uint32_t, IdRange> ids_of;
        for (const ReceiverView& receiver : scene.receivers) {
            IdRange& ids = ids_of[receiver.entity];
            ids = {std::min(ids.first, receiver.id), std::max(ids.end, receiver.id + 1)};
        }
        std::map<std::uint32_t, engine::WorldAabb> bounds_of; // by the caster's index
        for (const Plan* plan : request.plans)
            for (const PlanEntry& entry : plan->entries)
                if (entry.technique == "blob")
                    grow_bounds(request, scene.receiver(plan->receiver), entry, bounds_of);
        blobs_.clear();
        for (const auto& [index, bounds] : bounds_of) {
            const CasterView& caster = scene.casters[index];
            PlacedBlob placed{fit_blob(caster), ids_of[caster.id], bounds};
            if (!remedies_.on(Remedy::blob_aspect)) placed.blob = round_blob(placed.blob, light_);
            if (!remedies_.on(Remedy::blob_on_surface))
                placed.plane = first_plane(scene, light_, placed.blob.centre);
            placed.softness = softness_of(light_, placed.blob);
            blobs_.push_back(placed);
        }
    }

    void grow_bounds(
        const ShadowRequest& request,
        const ReceiverView& receiver,
        const PlanEntry& entry,
        std::map<std::uint32_t, engine::WorldAabb>& bounds_of) const {
        // A round blob may leave its caster's box, and a misplaced one the box's shadow.
        const bool anywhere =
            !remedies_.on(Remedy::blob_aspect) || !remedies_.on(Remedy::blob_on_surface);
        for (const std::uint32_t group : entry.caster_groups)
            for (const std::uint32_t index : request.groups[group].casters) {
                const CasterView& caster = request.scene.casters[index];
                if (caster.id == receiver.entity) continue;
                const engine::WorldAabb swept =
                    anywhere ? receiver.bounds
                             : swept_bounds(light_, caster.bounds, receiver.bounds);
                if (!swept.empty()) bounds_of[index].grow(swept);
            }
    }

    [[nodiscard]] BlobData
    data_of(const PlacedBlob& placed, const glm::dvec3& camera, const PixelBox& box) const {
        const glm::dmat3& unit_from_world = placed.blob.unit_from_world;
        const glm::dvec3 shift = unit_from_world * (camera - placed.blob.centre);
        const glm::dmat3 rows = glm::transpose(unit_from_world);
        const bool sun = light_.light.kind == scene::LightKind::directional;
        const glm::dvec3 light =
            sun ? glm::dvec3(light_.direction) : placed.blob.centre - light_.position;
        BlobData data;
        data.row_0 = glm::vec4(glm::dvec4(rows[0], shift.x));
        data.row_1 = glm::vec4(glm::dvec4(rows[1], shift.y));
        data.row_2 = glm::vec4(glm::dvec4(rows[2], shift.z));
        data.light = glm::vec4(glm::dvec4(unit_from_world * light, sun ? 0.0 : 1.0));
        data.rectangle = glm::vec4(glm::ivec4(box.left, box.bottom, box.right, box.top));
        data.plane = glm::vec4(glm::dvec4(
            glm::dvec3(placed.plane), placed.plane.w + glm::dot(glm::dvec3(placed.plane), camera)));
        data.own = {
            placed.own.first,
            placed.own.end,
            std::bit_cast<std::uint32_t>(static_cast<float>(placed.softness)),
            0};
        return data;
    }

    LightView light_;
    Remedies remedies_;
    ReceiverBits receivers_;
    std::vector<PlacedBlob> blobs_;
    gpu::Buffer buffer_ = gpu::Buffer::dynamic("blobs");
    gpu::VertexArray no_vertices_ = gpu::VertexArray::none();
    const gpu::Program* program_ = nullptr;
};

class BlobTechnique final : public ShadowTechnique {
public:
    [[nodiscard]] const TechniqueTraits& traits() const override {
        static constexpr TechniqueTraits kTraits{
            "blob", "a soft ellipse behind each caster, for what is small on screen"};
        return kTraits;
    }

    [[nodiscard]] engine::Result<Prediction>
    predict(const PairView& pair, const CasterGroup& casters) const override {
        return predict_blob(pair, casters);
    }

    [[nodiscard]] std::unique_ptr<ShadowJob> start() const override {
        return std::make_unique<BlobJob>();
    }
};

} // namespace

std::unique_ptr<ShadowTechnique> make_blob() {
    return std::make_unique<BlobTechnique>();
}

} // namespace shadows
