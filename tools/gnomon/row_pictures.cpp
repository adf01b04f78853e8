#include "tools/gnomon/row_pictures.hpp"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

#include "tools/gnomon/text_files.hpp"

namespace gnomon {

namespace {

std::uint8_t byte_of(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

engine::Image mask_image(const measure::Mask& mask) {
    engine::Image image(mask.width, mask.height, 1);
    std::transform(mask.visibility.begin(), mask.visibility.end(), image.bytes.begin(), byte_of);
    return image;
}

} // namespace

std::string picture_stem(const measure::Row& row) {
    std::string stem = fmt::format(
        "{}_{}_{}", file_word(row.scene), file_word(row.light), file_word(row.technique));
    if (row.protocol != measure::kStill) stem += "_" + file_word(row.protocol);
    return stem;
}

engine::Image error_image(const measure::Comparison& comparison) {
    engine::Image image(comparison.measured.width, comparison.measured.height, 3);
    const std::vector<std::uint8_t> far = measure::far_errors(comparison);
    for (std::size_t pixel = 0; pixel < comparison.kind.size(); ++pixel) {
        const float measured = comparison.measured.visibility[pixel];
        const float truth = comparison.truth.visibility[pixel];
        glm::vec3 color = glm::vec3(0.25F + 0.5F * truth) * glm::vec3(0.85F, 1.0F, 0.85F);
        const float error = std::abs(measured - truth);
        const glm::vec3 wrong =
            measured < truth ? glm::vec3(1.0F, 0.1F, 0.1F) : glm::vec3(0.1F, 0.2F, 1.0F);
        color = glm::mix(color, wrong, error);
        if (far[pixel] != 0)
            color = measured < truth ? glm::vec3(1.0F, 0.9F, 0.0F) : glm::vec3(0.0F, 1.0F, 1.0F);
        if (comparison.kind[pixel] != measure::PixelKind::valid) color = glm::vec3(0.35F);
        for (int channel = 0; channel < 3; ++channel)
            image.bytes[3 * pixel + static_cast<std::size_t>(channel)] = byte_of(color[channel]);
    }
    return image;
}

engine::Result<void> write_row_pictures(
    const std::filesystem::path& folder,
    const measure::Row& row,
    const measure::Comparison& comparison,
    const engine::Image& color) {
    if (folder.empty()) return {};
    const std::string stem = (folder / picture_stem(row)).string();
    if (auto written = engine::write_png(stem + "_error.png", error_image(comparison)); !written)
        return written;
    if (auto written = engine::write_png(stem + "_mask.png", mask_image(comparison.measured));
        !written)
        return written;
    return engine::write_png(stem + "_color.png", color);
}

} // namespace gnomon
