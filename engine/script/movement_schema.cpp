// The kinds of the scene schema that are about going somewhere.

#include "engine/script/schema_parts.hpp"

namespace script {

using engine::Field;
using engine::FieldType;
using engine::Kind;

engine::Kind path_kind() {
    return {
        .name = "path",
        .text = "A way through the level, straight from point to point.",
        .fields =
            {name_field("path"),
             {.name = "points",
              .type = FieldType::points,
              .text = "The places that it leads through, in their order.",
              .unit = "m",
              .range = kWorld,
              .min_count = 2},
             {.name = "closed",
              .type = FieldType::boolean,
              .text = "True leads from the last point to the first; false turns back there.",
              .fallback = true}},
        .constructed = true,
        .example = R"(g.path { name = "round", points = {{0, 0, 0}, {4, 0, 0}, {4, 0, 3}} })"};
}

engine::Kind player_kind() {
    return {
        .name = "player",
        .text = "Whom the person at the keys is; at most one. Without it the camera flies.",
        .fields =
            {position_field({0.0, 0.0, 0.0}),
             {.name = "heading",
              .type = FieldType::number,
              .text = "Turn about y with which the player begins; 0 looks along -z, 90 along -x.",
              .fallback = 0.0,
              .unit = "deg",
              .range = {.min = -3600.0, .max = 3600.0}},
             {.name = "speed",
              .type = FieldType::number,
              .text = "How fast the player walks; 1.4 is a stroll, over 4 is running.",
              .fallback = 1.6,
              .unit = "m/s",
              .range = {.min = 0.0, .max = 100.0, .min_open = true}},
             {.name = "path",
              .type = FieldType::text,
              .text = "Name of the path that the player follows where nobody is at the keys."}},
        .constructed = true,
        .example = R"(g.player { position = {0, 0, 4}, heading = 0 })"};
}

std::vector<Field> follower_fields() {
    return {
        {.name = "path",
         .type = FieldType::text,
         .text = "Name of a path to go along, looking (with the side towards z) the way it leads. "
                 "It decides position and rotation."},
        {.name = "path_speed",
         .type = FieldType::number,
         .text = "How fast it goes along its path; 0 stands still, negative walks the other way.",
         .fallback = 1.2,
         .unit = "m/s",
         .range = {.min = -100.0, .max = 100.0}},
        {.name = "path_start",
         .type = FieldType::number,
         .text = "Share of the path at which it begins.",
         .fallback = 0.0,
         .range = {.min = 0.0, .max = 1.0}}};
}

} // namespace script
