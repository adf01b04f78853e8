// gnomon: one command line for everything. Unknown words are refused with the nearest known one.

#include "engine/core/text.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "tools/gnomon/commands.hpp"

namespace {

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

std::string nearest(std::string_view word, const std::vector<std::string>& names) {
    const std::vector<std::string_view> views(names.begin(), names.end());
    return engine::did_you_mean(word, views);
}

/// The first word that is no option of the command it is given to, as a sentence; empty when all
/// are known.
std::string unknown_word(const CLI::App& app, const std::vector<std::string>& words) {
    if (words.empty()) return {};
    std::vector<std::string> commands;
    const CLI::App* command = nullptr;
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
        commands.push_back(sub->get_name());
        if (sub->get_name() == words.front()) command = sub;
    }
    if (command == nullptr)
        return words.front().starts_with("-")
                   ? std::string()
                   : fmt::format(
                       "unknown command '{}'{}", words.front(), nearest(words.front(), commands));
    const auto names = option_names(*command);
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string name = words[i].substr(0, words[i].find('='));
        if (!name.starts_with("--") || name == "--") continue;
        if (command->get_option_no_throw(name) == nullptr)
            return fmt::format(
                "unknown option '{}' of gnomon {}{}",
                name,
                command->get_name(),
                nearest(name, names));
    }
    return {};
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Gnomon: shadows as right as the scene needs and no dearer"};
    app.name("gnomon");
    app.require_subcommand(1);
    const std::vector<gnomon::Run> runs = {
        gnomon::add_render(app),
        gnomon::add_measure(app),
        gnomon::add_chart(app),
        gnomon::add_check(app),
        gnomon::add_explain(app),
        gnomon::add_play(app)};
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (const std::string problem = unknown_word(app, words); !problem.empty()) {
        fmt::print(stderr, "gnomon: {}\n", problem);
        return gnomon::kWrongUsage;
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? gnomon::kFine : gnomon::kWrongUsage;
    }
    const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
    for (std::size_t i = 0; i < commands.size(); ++i)
        if (commands[i]->parsed()) return runs[i]();
    return gnomon::kWrongUsage;
}
