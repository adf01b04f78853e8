#include "tools/truth/truth_files.hpp"

#include "engine/core/image.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <fstream>

namespace truth {
namespace {

constexpr std::uint8_t kSure = 255;
constexpr std::uint8_t kUndecided = 64;

engine::Image valid_picture(const TruthImage& truth) {
    engine::Image picture(truth.image.width, truth.image.height, 1);
    for (std::size_t i = 0; i < picture.pixel_count(); ++i)
        if (truth.image.entity[i] != ecs::kNoEntity.value)
            picture.bytes[i] = truth.undecided[i] != 0 ? kUndecided : kSure;
    return picture;
}

nlohmann::ordered_json summary(const std::string& name, const TruthImage& truth) {
    const Shares parts = shares(truth);
    return {
        {"light", name},
        {"size", {truth.image.width, truth.image.height}},
        {"shares",
         {{"surface", parts.surface},
          {"shadow", parts.shadow},
          {"facing_away", parts.facing_away},
          {"undecided", parts.undecided},
          {"undecided_inside", parts.undecided_inside}}}};
}

} // namespace

engine::Image mask_picture(const TruthImage& truth) {
    engine::Image picture(truth.image.width, truth.image.height, 1);
    for (std::size_t i = 0; i < picture.pixel_count(); ++i)
        picture.bytes[i] =
            static_cast<std::uint8_t>(std::lround(255.0F * truth.image.visibility[i]));
    return picture;
}

engine::Result<void>
write_truth(const std::filesystem::path& folder, const std::string& name, const TruthImage& truth) {
    const std::string base = (folder / ("truth_" + name)).string();
    if (auto written = engine::write_png(base + ".png", mask_picture(truth)); !written)
        return written;
    if (auto written = engine::write_png(base + "_valid.png", valid_picture(truth)); !written)
        return written;
    std::ofstream file(base + ".json");
    file << summary(name, truth).dump(2) << '\n';
    file.close();
    if (!file) return engine::Error{"cannot write '" + base + ".json'"};
    return {};
}

} // namespace truth
