// What a running level may read and change, field by field. The scene schema says what each field
// holds; here stands where it lives in the world.

#pragma once

#include "engine/scene/world.hpp"

#include <glm/glm.hpp>

#include <span>
#include <string_view>
#include <variant>

namespace script {

using LiveValue = std::variant<bool, double, glm::dvec3>;

struct LiveField {
    std::string_view kind;  ///< of the schema
    std::string_view field; ///< of that kind
    LiveValue (*read)(const scene::World& world, ecs::Entity entity);
    /// @pre `value` is what the schema asks for
    void (*write)(scene::World& world, ecs::Entity entity, const LiveValue& value);
};

std::span<const LiveField> live_fields();

/// The kind of the schema that an entity is of: a light, a camera or a model.
std::string_view live_kind(const scene::World& world, ecs::Entity entity);

} // namespace script
