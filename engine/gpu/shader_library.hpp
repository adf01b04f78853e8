// All programs of a run: compiled on first use, one per set of files and defines, recompiled when
// their files change.

#pragma once

#include "engine/core/result.hpp"
#include "engine/gpu/program.hpp"
#include "engine/gpu/shader_source.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace gpu {

/// Variants of a program, beside its name: "FILTER=PCF_3X3", "LAYERS=4", "ALPHA_MASK".
using Defines = std::vector<std::string>;

class ShaderLibrary {
public:
    /// @param folders one per module, as the generated `embedded::<root>_shaders()` give them;
    /// "gpu" is added
    explicit ShaderLibrary(std::vector<ShaderFolder> folders);

    /// The pointer is never null and stays good for the library's life, through reloads.
    /// Errors: a missing file, or the compiler's message with its place. The failed program is
    /// remembered too, and compiled again only when one of its files changes.
    engine::Result<const Program*>
    graphics(const std::string& vertex, const std::string& fragment, const Defines& defines = {});
    engine::Result<const Program*> compute(const std::string& compute, const Defines& defines = {});

    /// Recompiles programs whose files on disk have changed. Looks at most twice a second; call
    /// each frame.
    /// @return what does not compile; those programs stay as they were
    std::vector<engine::Error> poll();

    /// The same, without waiting for the next half second.
    std::vector<engine::Error> poll_now();

    /// Of programs, compiled so far, reloads included.
    [[nodiscard]] int compile_count() const { return compile_count_; }

private:
    struct Key {
        std::vector<std::string> files; ///< vertex and fragment, or compute alone
        Defines defines;
        auto operator<=>(const Key&) const = default;
    };
    struct WatchedFile {
        std::filesystem::path path;
        std::filesystem::file_time_type time; ///< min() when the file was not there
    };
    struct Entry {
        std::unique_ptr<Program> program; ///< null when it never compiled
        engine::Error error;              ///< why
        std::vector<WatchedFile> watched;
    };

    engine::Result<const Program*> get(Key key);
    engine::Result<Program> compile(const Key& key, std::vector<WatchedFile>& watched);
    void watch(const std::string& name, std::vector<WatchedFile>& watched) const;

    std::vector<ShaderFolder> folders_;
    std::map<Key, Entry> entries_;
    std::chrono::steady_clock::time_point next_poll_;
    int compile_count_ = 0;
};

} // namespace gpu
