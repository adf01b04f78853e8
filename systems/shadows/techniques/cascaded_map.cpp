// Shadow maps of a directional light in cascades: right for anything, at the price of drawing every
// caster again. Their edges are as coarse as a texel on screen; casters thinner than a texel are
// missed now and then.

#include "systems/shadows/maps/cascade_fit.hpp"
#include "systems/shadows/maps/map_error.hpp"
#include "systems/shadows/maps/map_resolution.hpp"
#include "systems/shadows/screen_bounds.hpp"
#include "systems/shadows/techniques/map_job.hpp"
#include "systems/shadows/techniques/map_uniforms.hpp"

#include <fmt/format.h>
#include <glm/gtx/component_wise.hpp>

#include <algorithm>
#include <cmath>

namespace shadows {

namespace {

/// What of a frame decides where cascades lie, besides their size.
struct Layout {
    DepthRange range;
    int count = 1;
};

Layout layout_of(const DepthRange& range, const scene::ShadowWish& wish) {
    Layout layout;
    layout.range = range;
    layout.count = std::clamp(wish.cascades.value_or(cascade_count(layout.range)), 1, kMaxCascades);
    return layout;
}

/// That of a first frame.
Layout first_layout(const ShadowScene& scene, const scene::ShadowWish& wish) {
    return layout_of(steady_range(wanted_range(scene), std::nullopt), wish);
}

/// Texel of a single-texel map at the pair's receiver, metres across the light: that of the cascade
/// in which most of the receiver lies.
double texel_of_one(const PairView& pair, const Layout& layout) {
    const scene::CameraView& camera = pair.scene.camera;
    const double distance = typical_distance(camera, pair.receiver.bounds);
    // The sphere round a slice is about as wide as its far end.
    const double far = slice_end(layout.range, layout.count, distance);
    const double half_width = std::tan(static_cast<double>(camera.fov_y) * 0.5) * far;
    return 2.0 * half_width * std::hypot(1.0, camera.aspect());
}

/// From a point to the nearest side of a layer, texels; negative outside.
double texels_inside(const ParallelView& view, const glm::dvec3& point) {
    const glm::dvec2 texel = (glm::dvec2(view.light_from(point)) - view.min) / view.texel;
    const glm::dvec2 inside = glm::min(texel, static_cast<double>(view.size) - texel);
    return std::min(inside.x, inside.y);
}

class CascadedJob final : public MapJob {
public:
    CascadedJob() : MapJob("cascaded_map") {}

    [[nodiscard]] bool still_serves(const ShadowRequest& request) const override {
        const DepthRange last = held_->range;
        held_ = held_range(wanted_range(request.scene), held_, remedies());
        const auto views = fit_cascades(requested(request), remedies());
        if (!(held_->range == last) || views.size() != views_.size()) return false;
        for (std::size_t i = 0; i < views.size(); ++i)
            if (views[i].min != views_[i].min || views[i].texel != views_[i].texel) return false;
        return true;
    }

    [[nodiscard]] Resolution
    resolution(const scene::CameraView& camera, const SurfacePoint& point) const override {
        // As light_at of map_mask.frag: the finest cascade that holds the point, and its last tenth
        // fades into the next.
        const auto inside = [&](const ParallelView& view) {
            const double border = filter_border(filter()) + soft_reach() / glm::compMin(view.texel);
            return texels_inside(view, point.position) - border;
        };
        const std::size_t last = views_.size() - 1;
        std::size_t layer = 0;
        while (layer < last && inside(views_[layer]) < 0.0)
            ++layer;
        const ParallelView& view = views_[layer];
        const double reach = filter_reach(filter());
        const Resolution finest = on_screen(camera, point, texel_at(view, point, reach));
        const bool fades = inside(view) < 0.1 * static_cast<double>(view.size);
        if (layer == last || !fades) return finest;
        return coarser(finest, on_screen(camera, point, texel_at(views_[layer + 1], point, reach)));
    }

protected:
    void fit(const ShadowRequest& request, int size) override {
        size_ = size;
        held_ = held_range(wanted_range(request.scene), held_, remedies());
        axes_ = light_axes(glm::dvec3(light().direction), axes_, remedies());
        views_ = fit_cascades(requested(request), remedies());
    }
    [[nodiscard]] int layers() const override { return static_cast<int>(views_.size()); }
    [[nodiscard]] glm::dmat4 map_from_world(int layer) const override {
        return views_[static_cast<std::size_t>(layer)].map_from_world();
    }
    [[nodiscard]] bool reaches(int layer, const engine::WorldAabb& caster) const override {
        return shadows::reaches(views_[static_cast<std::size_t>(layer)], caster);
    }
    [[nodiscard]] double texel_m_of_one(const PairView& pair) const override {
        return texel_of_one(pair, first_layout(pair.scene, pair.wish));
    }
    [[nodiscard]] gpu::Defines mask_defines() const override {
        gpu::Defines defines = {"PARALLEL", fmt::format("MAP_LAYERS={}", layers())};
        if (!remedies().on(Remedy::map_blended_seams)) defines.emplace_back("SUDDEN_SEAMS");
        return defines;
    }

    void place(const gpu::Program& mask, const scene::CameraView& camera) const override {
        set_view(mask, views_.front(), camera, filter_border(filter()));
        for (std::size_t i = 1; i < views_.size(); ++i)
            mask.set(fmt::format("placement[{}]", i), placement_of(views_[i], camera));
        mask.set("light_source", glm::vec2(static_cast<float>(soft_reach()), 1.0F));
    }

private:
    /// How far a penumbra may reach across the light, metres: from the nearest end of the map to
    /// the farthest.
    [[nodiscard]] double soft_reach() const {
        return soft_tangent() * (views_.front().farthest - views_.front().nearest);
    }
    [[nodiscard]] double soft_tangent() const {
        if (filter() != MapFilter::pcss) return 0.0;
        return std::tan(static_cast<double>(light().light.angular_radius));
    }
    [[nodiscard]] CascadeRequest requested(const ShadowRequest& request) const {
        const Layout layout = layout_of(held_->range, request.wish);
        return {
            request.scene.camera,
            *axes_,
            request.scene.receiver_bounds,
            caster_bounds(),
            layout.range,
            remedies().on(Remedy::map_cascades) ? layout.count : 1,
            size_,
            soft_tangent()};
    }

    int size_ = 0;
    mutable std::optional<HeldRange> held_; ///< counts frames, those that draw nothing included
    std::optional<glm::dmat3> axes_;
    std::vector<ParallelView> views_;
};

class CascadedMap final : public ShadowTechnique {
public:
    [[nodiscard]] const TechniqueTraits& traits() const override {
        static constexpr TechniqueTraits kTraits{
            "cascaded_map", "one to four stable shadow maps of a directional light"};
        return kTraits;
    }

    [[nodiscard]] engine::Result<Prediction>
    predict(const PairView& pair, const CasterGroup& casters) const override {
        if (pair.light.light.kind != scene::LightKind::directional)
            return engine::Error{"it serves directional lights"};
        const Layout layout = first_layout(pair.scene, pair.wish);
        return predict_map(pair, casters, texel_of_one(pair, layout), layout.count);
    }

    [[nodiscard]] std::unique_ptr<ShadowJob> start() const override {
        return std::make_unique<CascadedJob>();
    }
};

} // namespace

std::unique_ptr<ShadowTechnique> make_cascaded_map() {
    return std::make_unique<CascadedMap>();
}

} // namespace shadows
