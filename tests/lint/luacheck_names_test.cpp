// luacheck must know exactly the names that the sandbox gives to scripts.

#include "engine/script/sandbox.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

namespace {

std::string sandbox_of_luacheckrc() {
    std::ifstream file(PROJECT_SOURCE_DIR "/.luacheckrc");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::size_t start = text.find("stds.sandbox = {");
    return text.substr(start, text.find("\n}", start) - start);
}

/// "assert", "math.abs" ... as the file lists them.
std::set<std::string> names_for_luacheck() {
    const std::string text = sandbox_of_luacheckrc();
    const std::regex word(R"re((\w+) = \{ fields|"(\w+)"|(\} \}))re");
    std::set<std::string> names;
    std::string library;
    for (std::sregex_iterator match(text.begin(), text.end(), word), end; match != end; ++match) {
        if ((*match)[1].matched) library = (*match)[1].str() + ".";
        if ((*match)[2].matched) names.insert(library + (*match)[2].str());
        if ((*match)[3].matched) library.clear();
    }
    return names;
}

std::set<std::string> names_of_the_sandbox() {
    std::set<std::string> names = {"require"};
    for (const script::SandboxName& global : script::sandbox_names()) {
        if (global.members.empty()) names.emplace(global.name);
        for (const std::string_view member : global.members)
            names.insert(std::string(global.name) + "." + std::string(member));
    }
    return names;
}

TEST(LuacheckNames, AreThoseOfTheSandbox) {
    EXPECT_EQ(names_for_luacheck(), names_of_the_sandbox());
}

} // namespace
