#include "engine/script/scene_reader.hpp"

#include "engine/core/text.hpp"
#include "engine/script/part_readers.hpp"
#include "engine/script/table_reader.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>

namespace script {

namespace {

/// What a name of the level stands for.
struct NameOwner {
    std::string kind; ///< "light", "model", "camera"
    engine::SourcePlace place;
};

class SceneReader {
public:
    SceneReader(
        const std::vector<Constructed>& constructed,
        const engine::Schema& schema,
        const std::string& file,
        Report& report)
        : constructed_(constructed),
          schema_(schema),
          report_(report) {
        scene_.file = file;
    }

    scene::SceneDescription read(const Value& root) {
        if (root.type != Value::Type::table || word_of(*root.table) != "scene") {
            report_.error(
                {fmt::format(
                     "the level returns {}, expected: return g.scene {{ ... }}", described(root)),
                 {scene_.file, 0}});
            return std::move(scene_);
        }
        const Subject subject = subject_of(*root.table);
        read_fields(*root.table, subject);
        for (const Value& child : root.table->list)
            read_child(child, subject);
        name_the_nameless();
        check_rules();
        check_paths();
        warn_of_forgotten_parts();
        return std::move(scene_);
    }

private:
    [[nodiscard]] std::string word_of(const Table& table) const {
        return table.constructor < 0
                   ? ""
                   : constructed_[static_cast<std::size_t>(table.constructor)].word;
    }

    Subject subject_of(const Table& table) {
        used_.insert(table.constructor);
        const Constructed& call = constructed_[static_cast<std::size_t>(table.constructor)];
        return {call.word, call.word, call.place, {}};
    }

    [[nodiscard]] std::string described(const Value& value) const {
        if (value.type != Value::Type::table || value.table->constructor < 0)
            return value.description();
        return fmt::format("a {}", word_of(*value.table));
    }

    void read_fields(const Table& table, const Subject& subject) {
        TableReader reader(table, schema_, "scene", report_, subject);
        scene_.shadow = read_shadow(reader);
        TableReader budget = reader.table("budget");
        if (const auto error_px = budget.optional_number("error_px")) {
            if (scene_.shadow.error_px)
                budget.complain("error_px", "is said in shadow too, expected one of them");
            scene_.shadow.error_px = static_cast<float>(*error_px);
        }
        if (const auto shadow_ms = budget.optional_number("shadow_ms"))
            scene_.shadow_ms = static_cast<float>(*shadow_ms);
        budget.finish();
        // filled_by_preset() has added what the preset says, and LevelScript keeps the function.
        static_cast<void>(reader.text("preset"));
        static_cast<void>(reader.callback("on_update"));
        scene_.ambient = glm::vec3(reader.vector("ambient"));
        if (const auto exposure = reader.optional_number("exposure"))
            scene_.exposure = static_cast<float>(*exposure);
        reader.finish();
    }

    void read_child(const Value& child, const Subject& scene) {
        const bool is_table = child.type == Value::Type::table;
        if (is_table && child.table->constructor >= 0) {
            read_part(*child.table);
        } else if (is_table && child.table->fields.empty() && child.table->strays.empty()) {
            for (const Value& grandchild : child.table->list)
                read_child(grandchild, scene);
        } else {
            const std::string what =
                is_table ? "a plain table with a field '" + first_key(*child.table) + "'"
                         : child.description();
            report_.error(
                scene,
                "",
                fmt::format(
                    "holds {}, expected g.sun, g.spot, g.lamp, g.model, g.camera, g.path, "
                    "g.player or g.rule",
                    what));
        }
    }

    static std::string first_key(const Table& table) {
        return table.fields.empty() ? table.strays.front() : table.fields.front().first;
    }

    void read_part(const Table& table) {
        const std::string word = word_of(table);
        const Subject subject = subject_of(table);
        if (word.empty()) return; // reported by the vocabulary
        if (word == "scene") {
            report_.error(subject, "", "stands inside another scene; a level is one scene");
            return;
        }
        TableReader reader(table, schema_, word, report_, subject);
        if (word == "sun") add(scene_.lights, read_sun(reader), "light", reader.subject());
        if (word == "spot") add(scene_.lights, read_spot(reader), "light", reader.subject());
        if (word == "lamp") add(scene_.lights, read_lamp(reader), "light", reader.subject());
        if (word == "model") add(scene_.models, read_model(reader), "model", reader.subject());
        if (word == "camera") add(scene_.cameras, read_camera(reader), "camera", reader.subject());
        if (word == "path") add(scene_.paths, read_path(reader), "path", reader.subject());
        if (word == "player") add_player(read_player(reader), reader.subject());
        if (word == "model") model_subjects_.push_back(reader.subject());
        if (word == "rule") {
            scene_.rules.push_back(read_rule(reader));
            rule_subjects_.push_back(reader.subject());
        }
    }

    void add_player(const scene::PlayerDescription& player, const Subject& subject) {
        if (scene_.player)
            report_.error(subject, "", "is the second one; a level has one player at most");
        scene_.player = player;
        player_subject_ = subject;
    }

    template <class Description>
    void
    add(std::vector<Description>& list,
        Description&& description,
        const char* kind,
        const Subject& subject) {
        if (!description.name.empty()) {
            const auto [owner, is_new] =
                names_.try_emplace(description.name, NameOwner{kind, subject.place});
            if (!is_new) {
                report_.error(
                    subject,
                    "name",
                    fmt::format(
                        "is taken by the {} at {}:{}",
                        owner->second.kind,
                        owner->second.place.file,
                        owner->second.place.line));
            }
        }
        list.push_back(std::move(description));
    }

    /// "box", "box_2", "box_3": the first that is free.
    std::string
    free_name(const std::string& base, const char* kind, const engine::SourcePlace& place) {
        std::size_t& number = numbers_[base];
        std::string name;
        do {
            ++number;
            name = number == 1 ? base : fmt::format("{}_{}", base, number);
        } while (!names_.try_emplace(name, NameOwner{kind, place}).second);
        return name;
    }

    void name_the_nameless() {
        for (scene::LightDescription& light : scene_.lights) {
            const char* word = light.light.kind == scene::LightKind::directional ? "sun"
                               : light.light.kind == scene::LightKind::spot      ? "spot"
                                                                                 : "lamp";
            if (light.name.empty()) light.name = free_name(word, "light", light.place);
        }
        for (scene::PathDescription& path : scene_.paths)
            if (path.name.empty()) path.name = free_name("path", "path", path.place);
        for (scene::CameraDescription& camera : scene_.cameras)
            if (camera.name.empty()) camera.name = free_name("camera", "camera", camera.place);
        for (scene::ModelDescription& model : scene_.models) {
            if (!model.name.empty()) continue;
            const std::string stem = std::filesystem::path(model.file).stem().string();
            std::string base = model.shape.empty() ? stem : model.shape;
            if (!engine::is_name(base)) base = "model";
            model.name = free_name(base, "model", model.place);
        }
    }

    void check_rules() {
        for (std::size_t i = 0; i < scene_.rules.size(); ++i) {
            check_name(rule_subjects_[i], "light", scene_.rules[i].light, "light");
            check_name(rule_subjects_[i], "receiver", scene_.rules[i].receiver, "model");
            check_name(rule_subjects_[i], "caster", scene_.rules[i].caster, "model");
        }
    }

    void check_paths() {
        for (std::size_t i = 0; i < scene_.models.size(); ++i)
            check_name(model_subjects_[i], "path", scene_.models[i].path, "path");
        if (scene_.player) check_name(player_subject_, "path", scene_.player->path, "path");
    }

    /// Models may be followed by the path of a node, which only the model's file knows.
    void check_name(
        const Subject& subject,
        const std::string& field,
        const std::optional<std::string>& name,
        const std::string& kind) {
        if (!name) return;
        const std::string owner =
            kind == "model" ? name->substr(0, name->find_first_of("/#")) : *name;
        const auto found = names_.find(owner);
        if (found != names_.end() && found->second.kind == kind) return;
        std::vector<std::string_view> candidates;
        for (const auto& [candidate, its_owner] : names_)
            if (its_owner.kind == kind) candidates.push_back(candidate);
        const std::string what = found == names_.end()
                                     ? "which is no " + kind + " of this level"
                                     : "which is a " + found->second.kind + ", expected a " + kind;
        report_.error(
            subject,
            field,
            fmt::format("is \"{}\", {}{}", *name, what, engine::did_you_mean(owner, candidates)));
    }

    void warn_of_forgotten_parts() {
        for (std::size_t i = 0; i < constructed_.size(); ++i) {
            const Constructed& call = constructed_[i];
            if (!used_.contains(static_cast<int>(i)) && !call.word.empty())
                report_.warn(
                    {call.word, call.word, call.place, {}},
                    "",
                    "is made, but it is not in the scene");
        }
    }

    const std::vector<Constructed>& constructed_;
    const engine::Schema& schema_;
    Report& report_;
    scene::SceneDescription scene_;
    std::vector<Subject> rule_subjects_;  ///< of scene_.rules
    std::vector<Subject> model_subjects_; ///< of scene_.models
    Subject player_subject_;
    std::map<std::string, NameOwner, std::less<>> names_;
    std::map<std::string, std::size_t> numbers_; ///< the last number used for a made-up name
    std::set<int> used_;                         ///< constructors that are part of the scene
};

} // namespace

scene::SceneDescription read_scene(
    const Value& root,
    const std::vector<Constructed>& constructed,
    const engine::Schema& schema,
    const std::string& file,
    Report& report) {
    return SceneReader(constructed, schema, file, report).read(root);
}

} // namespace script
