#include "tools/chart/pareto.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace chart {

std::vector<std::size_t> pareto_front(std::span<const Place> places) {
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return places[a].x != places[b].x ? places[a].x < places[b].x : places[a].y < places[b].y;
    });
    std::vector<std::size_t> front;
    double lowest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        const bool equal = !front.empty() && places[i].x == places[front.back()].x
                           && places[i].y == places[front.back()].y;
        if (!(places[i].y < lowest) && !equal) continue;
        lowest = places[i].y;
        front.push_back(i);
    }
    return front;
}

std::vector<bool> on_front(const Chart& chart, Across across, Up up) {
    const std::vector<const Point*> all = chart.all();
    std::vector<bool> front(all.size(), false);
    for (const bool of_peers : {false, true}) {
        std::vector<Place> places;
        std::vector<std::size_t> index;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto x = value(*all[i], of_peers ? Across::measured : across);
            const auto y = value(*all[i], up);
            if ((i >= chart.points.size()) != of_peers || !x || !y || all[i]->is_truth) continue;
            places.push_back({std::max(*x, 0.0), *y});
            index.push_back(i);
        }
        for (const std::size_t i : pareto_front(places))
            front[index[i]] = true;
    }
    return front;
}

} // namespace chart
