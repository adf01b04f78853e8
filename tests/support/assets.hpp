// Real models as they come, where a folder of them is at hand: GNOMON_ASSETS, or shared/assets
// beside the project.

#pragma once

#include <cstdlib>
#include <filesystem>

namespace test_support {

/// Empty when there is none.
inline std::filesystem::path assets_folder() {
    const char* chosen = std::getenv("GNOMON_ASSETS");
    const std::filesystem::path folder =
        chosen != nullptr ? chosen : PROJECT_SOURCE_DIR "/../shared/assets";
    return std::filesystem::is_directory(folder) ? folder : std::filesystem::path();
}

} // namespace test_support
