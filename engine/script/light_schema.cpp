// The kinds of the scene schema that shine.

#include "engine/script/schema_parts.hpp"

namespace script {

using engine::Field;
using engine::FieldType;
using engine::Kind;

namespace {

Field on_field() {
    return {
        .name = "on",
        .type = FieldType::boolean,
        .text = "False keeps the light in the level but dark.",
        .fallback = true};
}

Field light_color_field() {
    return {
        .name = "color",
        .type = FieldType::color,
        .text = "Linear red, green, blue that multiply the strength; all 0 is dark, over 1 is a "
                "stronger light.",
        .fallback = Numbers{1.0, 1.0, 1.0},
        .range = {.min = 0.0, .max = 100.0}};
}

Field light_shadow_field() {
    return {
        .name = "shadow",
        .type = FieldType::table,
        .text = "What is asked of this light's shadows.",
        .kind = "light_shadow"};
}

/// What spots and lamps share.
std::vector<Field> local_light_fields(double intensity) {
    return {
        name_field("light"),
        position_field({0.0, 2.0, 0.0}),
        {.name = "intensity",
         .type = FieldType::number,
         .text = "Strength in its brightest direction; a candle is 1, a household bulb about 100, "
                 "a stage light 100000.",
         .fallback = intensity,
         .unit = "cd",
         .range = {.min = 0.0, .max = 1e8}},
        light_color_field(),
        {.name = "range",
         .type = FieldType::number,
         .text = "Where the light ends. Too short cuts it off visibly; without it the light "
                 "reaches everything, and "
                 "so do its costs.",
         .unit = "m",
         .range = {.min = 0.0, .max = 1e6, .min_open = true}},
        {.name = "radius",
         .type = FieldType::number,
         .text = "Radius of the shining sphere: 0 gives hard shadows, large values soft ones that "
                 "cost samples.",
         .fallback = 0.0,
         .unit = "m",
         .range = {.min = 0.0, .max = 100.0}},
        on_field(),
        light_shadow_field()};
}

} // namespace

Kind sun_kind() {
    return {
        .name = "sun",
        .text = "A directional light: so far away that its rays are parallel.",
        .fields =
            {name_field("light"),
             {.name = "direction",
              .type = FieldType::vector,
              .text = "The way the light travels; any length but 0.",
              .fallback = Numbers{-0.4, -1.0, -0.3},
              .range = kWorld},
             {.name = "illuminance",
              .type = FieldType::number,
              .text = "Strength on a surface that faces it; noon is 100000, an overcast day 10000, "
                      "the moon 0.2.",
              .fallback = 60000.0,
              .unit = "lux",
              .range = {.min = 0.0, .max = 1e6}},
             light_color_field(),
             {.name = "angular_size",
              .type = FieldType::number,
              .text = "Full angle under which the light is seen: 0 gives hard shadows, 0.53 is the "
                      "sun, large values "
                      "are a bright patch of sky whose shadows cost samples.",
              .fallback = 0.53,
              .unit = "deg",
              .range = {.min = 0.0, .max = 90.0}},
             on_field(),
             light_shadow_field()},
        .constructed = true,
        .example = R"(g.sun { name = "sun", direction = {-0.4, -1, -0.3}, illuminance = 60000 })"};
}

Kind spot_kind() {
    return {
        .name = "spot",
        .text = "A light that shines into a cone.",
        .fields = joined(
            local_light_fields(1000.0),
            {{.name = "direction",
              .type = FieldType::vector,
              .text = "The way the axis of the light points; any length but 0. Or say target.",
              .fallback = Numbers{0.0, -1.0, 0.0},
              .range = kWorld},
             {.name = "target",
              .type = FieldType::vector,
              .text = "A point on the axis, instead of direction.",
              .unit = "m",
              .range = kWorld},
             {.name = "outer_angle",
              .type = FieldType::number,
              .text = "Half-angle from the axis at which the light ends. Near 0 nothing is lit; "
                      "near 90 maps get "
                      "coarse, and a lamp is the better light.",
              .fallback = 45.0,
              .unit = "deg",
              .range = {.min = 0.0, .max = 90.0, .min_open = true, .max_open = true}},
             {.name = "inner_angle",
              .type = FieldType::number,
              .text = "Half-angle from the axis at which the fall-off begins; less than "
                      "outer_angle. Equal angles "
                      "would cut the light off like a knife.",
              .fallback = 0.0,
              .unit = "deg",
              .range = {.min = 0.0, .max = 90.0, .max_open = true}}}),
        .constructed = true,
        .example =
            R"(g.spot { name = "torch", position = {2, 3, 1}, target = {0, 0, 0}, range = 12, outer_angle = 40 })"};
}

Kind lamp_kind() {
    return {
        .name = "lamp",
        .text = "A point light: it shines in all directions.",
        .fields = local_light_fields(100.0),
        .constructed = true,
        .example =
            R"(g.lamp { name = "lantern", position = {0, 2.5, 0}, intensity = 200, range = 10 })"};
}

} // namespace script
