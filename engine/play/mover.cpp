#include "engine/play/mover.hpp"

#include "engine/play/plan_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace play {

namespace {

constexpr double kGravity = 9.81;      // m/s2
constexpr double kLongestStride = 0.1; // m between two looks at the ground
constexpr double kSkin = 1e-4;         // m that a body keeps from what it touches
constexpr double kEyeRate = 10.0;      // 1/s at which the eye follows the feet

/// What stops a disc on its way.
struct Contact {
    double free = std::numeric_limits<double>::infinity(); ///< way until it touches
    glm::dvec2 normal = {};                                ///< from the obstacle to the disc
};

class Mover {
public:
    Mover(const Obstacles& obstacles, const Body& body, const Stance& stance)
        : obstacles_(obstacles),
          body_(body),
          stance_(stance) {}

    Stance move(const glm::dvec2& velocity, double seconds) {
        const double way = glm::length(velocity) * seconds;
        const int strides = std::max(1, static_cast<int>(std::ceil(way / kLongestStride)));
        for (int i = 0; i < strides; ++i)
            stride(velocity * (seconds / strides), seconds / strides);
        return stance_;
    }

private:
    void stride(const glm::dvec2& way, double seconds) {
        const Stance before = stance_;
        slide(way);
        if (!settle(seconds)) {
            stance_ = before; // no headroom there
            settle(seconds);
        }
        stance_.eye_lag *= std::exp(-kEyeRate * seconds);
        if (stance_.grounded) stance_.eye_lag -= stance_.feet.y - before.feet.y;
        stance_.eye_lag = std::clamp(stance_.eye_lag, -body_.step, body_.step);
    }

    [[nodiscard]] glm::dvec2 axis() const { return {stance_.feet.x, stance_.feet.z}; }

    /// The plan of all that lies between two heights and within `reach` of the axis.
    void gather(double low, double high, double reach) {
        shapes_.clear();
        const glm::dvec3 side(reach, 0.0, reach);
        const glm::dvec3 foot(stance_.feet.x, 0.0, stance_.feet.z);
        const engine::WorldAabb box = {
            foot - side + glm::dvec3(0.0, low, 0.0), foot + side + glm::dvec3(0.0, high, 0.0)};
        obstacles_.each_near(box, [&](const Triangle& triangle) {
            if (const auto shape = slice(triangle, low, high)) shapes_.push_back(*shape);
        });
    }

    /// How far the disc at `at` surely goes along `direction` (unit): a convex shape lies behind
    /// the line through its nearest point.
    [[nodiscard]] Contact first_contact(const glm::dvec2& at, const glm::dvec2& direction) const {
        Contact first;
        for (const PlanShape& shape : shapes_) {
            const glm::dvec2 away = at - shape.nearest(at);
            const double distance = glm::length(away);
            const glm::dvec2 normal = distance > 0.0 ? away / distance : -direction;
            const double approach = -glm::dot(direction, normal);
            if (approach <= 1e-9) continue;
            const double free = std::max(distance - body_.radius - kSkin, 0.0) / approach;
            if (free < first.free) first = {free, normal};
        }
        return first;
    }

    /// Moves by `way` until something stops it, by conservative advancement.
    /// @return what is left of the way, and the normal of what stopped it
    std::pair<double, glm::dvec2> advance(const glm::dvec2& direction, double way) {
        constexpr int kMaxAdvances = 24;
        glm::dvec2 at = axis();
        Contact contact;
        for (int i = 0; i < kMaxAdvances && way > 0.0; ++i) {
            contact = first_contact(at, direction);
            const double advance = std::min(contact.free, way);
            at += advance * direction;
            way -= advance;
            if (advance < 1e-6) break;
        }
        stance_.feet.x = at.x;
        stance_.feet.z = at.y;
        return {way, contact.normal};
    }

    /// Moves by `way`, along whatever is met; stops between two that leave no way out.
    void slide(glm::dvec2 way) {
        constexpr int kMaxContacts = 4;
        const double reach = glm::length(way) + body_.radius + 2.0 * kSkin;
        gather(stance_.feet.y + body_.step, stance_.feet.y + body_.height, reach);
        std::vector<glm::dvec2> normals;
        for (int i = 0; i < kMaxContacts; ++i) {
            const double length = glm::length(way);
            if (length < 1e-9) return;
            const auto [left, normal] = advance(way / length, length);
            if (left <= 0.0) return;
            normals.push_back(normal);
            way *= left / length;
            way -= glm::dot(way, normal) * normal;
            for (const glm::dvec2& other : normals)
                if (glm::dot(way, other) < -1e-9 * glm::length(way)) return;
        }
    }

    /// The highest ground under the axis that is no higher than a step.
    [[nodiscard]] std::optional<double> ground() const {
        const glm::dvec2 at = axis();
        const double highest = stance_.feet.y + body_.step;
        const engine::WorldAabb column = {
            {at.x, -std::numeric_limits<double>::max(), at.y}, {at.x, highest, at.y}};
        std::optional<double> best;
        obstacles_.each_near(column, [&](const Triangle& triangle) {
            const auto height = height_at(triangle, at);
            if (height && *height <= highest && (!best || *height > *best)) best = height;
        });
        return best;
    }

    /// Whether nothing between two heights is in the disc.
    bool is_free(double low, double high) {
        if (low >= high) return true;
        gather(low, high, body_.radius);
        return std::none_of(shapes_.begin(), shapes_.end(), [&](const PlanShape& shape) {
            return glm::length(axis() - shape.nearest(axis())) < body_.radius;
        });
    }

    /// The lowest height between `low` and the feet to which the cylinder can sink.
    double sunk(double low) {
        const double top = stance_.feet.y + body_.step;
        if (is_free(low + body_.step, top)) return low;
        double high = stance_.feet.y;
        while (high - low > kSkin) {
            const double middle = 0.5 * (low + high);
            (is_free(middle + body_.step, top) ? high : low) = middle;
        }
        return high;
    }

    /// Puts the feet on the ground, or lets them fall. @return false: there is no headroom
    bool settle(double seconds) {
        const std::optional<double> floor = ground();
        const double feet = stance_.feet.y;
        if (floor && *floor >= feet) {
            const bool free = is_free(feet + body_.height, *floor + body_.height);
            stance_.feet.y = free ? *floor : feet;
            land();
            return free;
        }
        const double speed = stance_.grounded ? 0.0 : stance_.fall_speed + kGravity * seconds;
        const double fall = stance_.grounded ? body_.step : speed * seconds;
        const double wanted = feet - fall;
        const double lowest = floor ? std::max(*floor, wanted) : wanted;
        const bool steps_down = stance_.grounded && (!floor || *floor < wanted);
        if (steps_down) { // over an edge: falls from here on
            stance_.grounded = false;
            return true;
        }
        stance_.feet.y = sunk(lowest);
        const bool stands = stance_.feet.y > wanted || stance_.grounded;
        if (stands) {
            land();
        } else {
            stance_.fall_speed = speed;
        }
        return true;
    }

    void land() {
        stance_.fall_speed = 0.0;
        stance_.grounded = true;
    }

    const Obstacles& obstacles_;
    const Body& body_;
    Stance stance_;
    std::vector<PlanShape> shapes_;
};

} // namespace

Stance moved(
    const Obstacles& obstacles,
    const Body& body,
    const Stance& stance,
    const glm::dvec2& velocity,
    double seconds) {
    return Mover(obstacles, body, stance).move(velocity, seconds);
}

} // namespace play
