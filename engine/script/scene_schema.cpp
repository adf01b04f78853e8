#include "engine/script/scene_schema.hpp"

#include "engine/script/live_fields.hpp"
#include "engine/script/schema_parts.hpp"

#include <algorithm>

namespace script {

namespace {

using engine::Field;
using engine::FieldType;
using engine::Kind;

Field error_field() {
    return {
        .name = "error_px",
        .type = FieldType::number,
        .text = "Accepted displacement of shadow edges. Small values ask for dear techniques; over "
                "about 4 edges are "
                "seen to be wrong.",
        .unit = "px",
        .range = {.min = 0.0, .max = 1000.0}};
}

std::vector<Field> wish_fields(const SceneVocabulary& vocabulary) {
    std::vector<std::string> techniques = vocabulary.techniques;
    if (std::find(techniques.begin(), techniques.end(), "auto") == techniques.end())
        techniques.insert(techniques.begin(), "auto");
    std::vector<std::string> real = techniques;
    real.erase(std::find(real.begin(), real.end(), "auto"));
    return {
        {.name = "technique",
         .type = FieldType::choice,
         .text =
             "The technique to use whatever it costs; \"auto\" leaves the choice to the picker.",
         .words = techniques},
        {.name = "never",
         .type = FieldType::words,
         .text =
             "Techniques that must not be picked; with too many of them nothing fits the budget.",
         .words = real},
        error_field(),
        {.name = "map_size",
         .type = FieldType::integer,
         .text = "Texels per side of shadow maps. Too few give blocky edges, too many cost memory "
                 "and time.",
         .unit = "texels",
         .range = {.min = 16.0, .max = 16384.0}},
        {.name = "filter",
         .type = FieldType::choice,
         .text = "How shadow maps are looked up: hard and cheap first, soft and dear last.",
         .words = vocabulary.filters},
        {.name = "samples",
         .type = FieldType::integer,
         .text = "Points on the light that soft techniques try. Few show as bands, many cost time.",
         .range = {.min = 1.0, .max = 1024.0}},
        {.name = "cascades",
         .type = FieldType::integer,
         .text = "Maps that share the view of a sun. One is coarse near the camera, four cost four "
                 "passes.",
         .range = {.min = 1.0, .max = 4.0}},
        {.name = "proxy",
         .type = FieldType::integer,
         .text = "How far volumes simplify heroes for what is not near them. 0 keeps every edge, 3 "
                 "is cheapest and coarsest.",
         .range = {.min = 0.0, .max = 3.0}},
        {.name = "way",
         .type = FieldType::choice,
         .text = "How planar shadows are made: from the casters themselves, from boxes in their "
                 "place, with a soft skirt, or kept in a texture. Without it the cheapest that is "
                 "right enough.",
         .words = vocabulary.ways},
        {.name = "refresh",
         .type = FieldType::integer,
         .text = "Frames that a shadow map or texture serves before it is drawn anew. 1 follows "
                 "every motion; with more, shadows lag behind what moves.",
         .unit = "frames",
         .range = {.min = 1.0, .max = 1000.0}}};
}

Kind scene_kind() {
    return {
        .name = "scene",
        .text = "The level: its fields, and everything in it as a list. Lists inside the list are "
                "unfolded.",
        .fields =
            {{.name = "preset",
              .type = FieldType::choice,
              .text = "Fills in whatever budget and shadow do not say, from "
                      "scripts/gnomon/presets.lua.",
              .words = {"low", "medium", "high", "ultra"}},
             {.name = "budget",
              .type = FieldType::table,
              .text = "What shadows may cost.",
              .kind = "budget"},
             {.name = "shadow",
              .type = FieldType::table,
              .text = "Wishes for all shadows of the level.",
              .kind = "shadow"},
             {.name = "ambient",
              .type = FieldType::color,
              .text = "Light from everywhere, linear, relative to the exposure. At 0 shadows are "
                      "black, over 1 they "
                      "wash out.",
              .fallback = Numbers{0.2, 0.2, 0.2},
              .range = {.min = 0.0, .max = 100.0}},
             {.name = "exposure",
              .type = FieldType::number,
              .text = "Multiplies light before tone mapping: too little is night, too much is "
                      "white. Without it a "
                      "value is found from the lights.",
              .range = {.min = 0.0, .max = 1e6, .min_open = true}},
             {.name = "on_update",
              .type = FieldType::callback,
              .text =
                  "Called before each frame with the seconds since the last one; see \"While a "
                  "level runs\". When it fails it is not called again, and the level goes on."}},
        .constructed = true,
        .example = R"(g.scene { ambient = {0.3, 0.3, 0.35}, g.sun { name = "sun" } })"};
}

std::vector<Field> model_shape_fields() {
    return {
        name_field("model"),
        {.name = "file",
         .type = FieldType::text,
         .text = "A .glb or .gltf file, relative to the level's folder. Either this or shape."},
        {.name = "shape",
         .type = FieldType::choice,
         .text = "One of the built-in bodies, centred on its position. A plane is open and flat: "
                 "it casts a shadow "
                 "like paper.",
         .words = {"box", "plane", "sphere", "cylinder", "cone", "torus"}},
        {.name = "size",
         .type = FieldType::vector,
         .text = "Full extents of a shape: x, y, z, or x, z for a plane. The y of a torus is the "
                 "thickness of its ring.",
         .fallback = Numbers{1.0, 1.0, 1.0},
         .unit = "m",
         .range = {.min = 0.0, .max = 1e5, .min_open = true},
         .min_count = 2},
        {.name = "color",
         .type = FieldType::color,
         .text = "Linear red, green, blue of a shape; 1 is whiter than paper (0.8), and 0 hides "
                 "all shadows.",
         .fallback = Numbers{0.8, 0.8, 0.8},
         .range = {.min = 0.0, .max = 1.0}}};
}

Kind model_kind() {
    const auto role = [](std::string name, std::string text, bool fallback) {
        return Field{
            .name = std::move(name),
            .type = FieldType::boolean,
            .text = std::move(text),
            .fallback = fallback};
    };
    return {
        .name = "model",
        .text = "A thing to see: a model file or a built-in shape.",
        .fields = joined(
            joined(model_shape_fields(), follower_fields()),
            {position_field({0.0, 0.0, 0.0}),
             {.name = "rotation",
              .type = FieldType::vector,
              .text = "Turns about x, y and z, applied in the order z, x, y (roll, pitch, yaw).",
              .fallback = Numbers{0.0, 0.0, 0.0},
              .unit = "deg",
              .range = {.min = -3600.0, .max = 3600.0}},
             {.name = "scale",
              .type = FieldType::scale,
              .text = "One factor or three, none 0; a negative one mirrors. Files in centimetres "
                      "want 0.01.",
              .fallback = Numbers{1.0, 1.0, 1.0},
              .range = {.min = -1e4, .max = 1e4}},
             role("casts", "Whether it throws shadows; big flat ground need not.", true),
             role("receives", "Whether shadows are seen on it.", true),
             role(
                 "hero",
                 "Whether its shadow is held to a quarter of a pixel; a level with many heroes is "
                 "dear.",
                 false),
             {.name = "animation",
              .type = FieldType::text,
              .text = "Clip of the file to play; the first one without it."},
             {.name = "animation_speed",
              .type = FieldType::number,
              .text = "1 is as authored, 0 stands still, negative runs backwards.",
              .fallback = 1.0,
              .range = {.min = -100.0, .max = 100.0}},
             {.name = "animation_start",
              .type = FieldType::number,
              .text = "Where in the clip it begins, so that many of one file do not march in step.",
              .fallback = 0.0,
              .unit = "s",
              .range = {.min = 0.0, .max = 1e4}},
             {.name = "shadow",
              .type = FieldType::table,
              .text = "What is asked of shadows on this model.",
              .kind = "shadow"}}),
        .constructed = true,
        .example =
            R"(g.model { name = "floor", shape = "plane", size = {40, 40}, casts = false })"};
}

Kind camera_kind() {
    return {
        .name = "camera",
        .text = "A place to look from. The first one is used when none is asked for.",
        .fields =
            {name_field("camera"),
             position_field({0.0, 1.7, 5.0}),
             {.name = "look_at",
              .type = FieldType::vector,
              .text = "A point in the middle of the picture; it must not be the position. Or say "
                      "rotation.",
              .fallback = Numbers{0.0, 0.0, 0.0},
              .unit = "m",
              .range = kWorld},
             {.name = "rotation",
              .type = FieldType::vector,
              .text = "Instead of look_at: turns about x, y and z, applied in the order z, x, y; "
                      "all 0 looks along -z.",
              .unit = "deg",
              .range = {.min = -3600.0, .max = 3600.0}},
             {.name = "fov",
              .type = FieldType::number,
              .text = "Full vertical angle of view: small is a telescope, over 120 stretches the "
                      "corners.",
              .fallback = 60.0,
              .unit = "deg",
              .range = {.min = 1.0, .max = 170.0}},
             {.name = "near",
              .type = FieldType::number,
              .text = "What is nearer is not seen; too small wastes depth precision far away.",
              .fallback = 0.1,
              .unit = "m",
              .range = {.min = 1e-4, .max = 1000.0}}},
        .constructed = true,
        .example =
            R"(g.camera { name = "main", position = {0, 2, 8}, look_at = {0, 1, 0}, fov = 60 })"};
}

Kind rule_kind(const SceneVocabulary& vocabulary) {
    const auto names = [](std::string name, std::string text) {
        return Field{.name = std::move(name), .type = FieldType::text, .text = std::move(text)};
    };
    return {
        .name = "rule",
        .text =
            "A wish for some shadows only. What is left out matches everything; later rules win.",
        .fields = joined(
            {names("light", "Name of a light."),
             names(
                 "receiver",
                 "Name of a model that shadows fall on, or \"model/node\" inside of it."),
             names(
                 "caster", "Name of a model that throws shadows, or \"model/node\" inside of it."),
             {.name = "distance",
              .type = FieldType::number,
              .text = "The rule holds from this distance to the camera on.",
              .unit = "m",
              .range = {.min = 0.0, .max = 1e7}}},
            wish_fields(vocabulary)),
        .constructed = true,
        .example = R"(g.rule { light = "torch", receiver = "floor", error_px = 0.5 })"};
}

} // namespace

engine::Schema scene_schema(const SceneVocabulary& vocabulary) {
    Field scene_error = error_field();
    scene_error.text += " Where nobody says, the picker takes 1, and 0.25 for heroes.";
    const Kind budget = {
        .name = "budget",
        .text = "What the designer accepts for the whole level.",
        .fields = {
            scene_error,
            {.name = "shadow_ms",
             .type = FieldType::number,
             .text = "Predicted time of all shadow work in a frame. Tight budgets give up accuracy "
                     "where it buys most "
                     "time; without it accuracy alone decides.",
             .unit = "ms",
             .range = {.min = 0.0, .max = 1000.0, .min_open = true}}}};
    const Kind shadow = {
        .name = "shadow",
        .text = "What a designer asks of shadows.",
        .fields = wish_fields(vocabulary)};
    const Kind light_shadow = {
        .name = "light_shadow",
        .text = "What a designer asks of the shadows of one light.",
        .fields = joined(
            {{.name = "casts",
              .type = FieldType::boolean,
              .text = "False lets the light through everything; it costs nothing then.",
              .fallback = true}},
            wish_fields(vocabulary))};
    engine::Schema schema = {
        {scene_kind(),
         sun_kind(),
         spot_kind(),
         lamp_kind(),
         model_kind(),
         camera_kind(),
         rule_kind(vocabulary),
         path_kind(),
         player_kind(),
         budget,
         shadow,
         light_shadow}};
    for (const LiveField& live : live_fields())
        for (engine::Kind& kind : schema.kinds)
            for (Field& field : kind.fields)
                field.live = field.live || (kind.name == live.kind && field.name == live.field);
    return schema;
}

} // namespace script
