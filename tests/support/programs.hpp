// Programs run by tests as people run them, and folders for what they leave.

#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace test_support {

/// A box on a floor under a sun and a lamp.
inline constexpr const char* kTwoLights = R"(
local g = require "gnomon"
return g.scene {
  g.sun { name = "sun", direction = { 0.5, -1, -0.4 } },
  g.lamp { name = "lamp", position = { 1.5, 2, 0 }, intensity = 30, range = 8 },
  g.model { name = "floor", shape = "box", size = { 20, 0.2, 20 }, position = { 0, -0.1, 0 } },
  g.model { name = "box", shape = "box", size = { 1, 1, 1 }, position = { 0, 0.5, 0 } },
  g.camera { name = "front", position = { 0, 3, 6 }, look_at = { 0, 0, 0 } },
}
)";

/// How a program ended.
struct Outcome {
    int code = -1;    ///< its exit code; -1: it was killed
    std::string text; ///< of both standard output and error
};

/// @param command for the shell
inline Outcome run(const std::string& command) {
    Outcome outcome;
    std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return outcome;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        outcome.text.append(buffer.data(), count);
    const int status = pclose(pipe);
    if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
    return outcome;
}

/// A test with an empty folder of its own, which goes when it ends.
class TestWithFolder : public testing::Test {
protected:
    TestWithFolder() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path()
                  / fmt::format("gnomon_{}_{}_{}", test->test_suite_name(), test->name(), getpid());
        std::filesystem::create_directories(folder_);
    }
    ~TestWithFolder() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    [[nodiscard]] std::string path(const std::string& name) const {
        return (folder_ / name).string();
    }

    std::filesystem::path folder_;
};

} // namespace test_support
