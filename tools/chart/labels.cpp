#include "tools/chart/labels.hpp"

#include <algorithm>
#include <array>

namespace chart {

namespace {

// Of 10.5 px type.
constexpr double kLetterPx = 5.9;
constexpr double kAscentPx = 8.5;
constexpr double kDescentPx = 2.5;
constexpr double kMarkPx = 5.0;
constexpr double kGapPx = 7.0;

bool overlap(const Box& a, const Box& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

bool inside(const Box& a, const Box& room) {
    return a.left >= room.left && a.right <= room.right && a.top >= room.top
           && a.bottom <= room.bottom;
}

} // namespace

Box mark_box(const Place& point) {
    return {point.x - kMarkPx, point.y - kMarkPx, point.x + kMarkPx, point.y + kMarkPx};
}

Box text_box(const Place& start, std::string_view text) {
    const double width = kLetterPx * static_cast<double>(text.size());
    return {start.x, start.y - kAscentPx, start.x + width, start.y + kDescentPx};
}

std::vector<std::optional<Place>>
place_labels(std::span<const Wanted> wanted, std::vector<Box> taken, const Box& room) {
    std::vector<std::optional<Place>> places;
    for (const Wanted& one : wanted) {
        const double width = kLetterPx * static_cast<double>(one.text.size());
        const double x = one.point.x;
        const double y = one.point.y;
        const std::array<Place, 6> tries = {{
            {x + kGapPx, y - kGapPx + 2.0},
            {x + kGapPx, y + kGapPx + kAscentPx - 4.0},
            {x - kGapPx - width, y - kGapPx + 2.0},
            {x - kGapPx - width, y + kGapPx + kAscentPx - 4.0},
            {x - width / 2.0, y - kGapPx - 1.0},
            {x - width / 2.0, y + kGapPx + kAscentPx},
        }};
        const auto free = std::find_if(tries.begin(), tries.end(), [&](const Place& place) {
            const Box box = text_box(place, one.text);
            return inside(box, room) && std::none_of(taken.begin(), taken.end(), [&](const Box& b) {
                       return overlap(box, b);
                   });
        });
        if (free == tries.end()) {
            places.emplace_back(std::nullopt);
            continue;
        }
        taken.push_back(text_box(*free, one.text));
        places.emplace_back(*free);
    }
    return places;
}

} // namespace chart
