// One drawing, back to front: gutters and grid, floors, fronts, curves, points, names, legend.

#include "tools/chart/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "tools/chart/labels.hpp"
#include "tools/chart/log_axis.hpp"
#include "tools/chart/pareto.hpp"
#include "tools/page/html.hpp"

namespace chart {

namespace {

constexpr double kLeft = 78.0;
constexpr double kRight = 880.0;
constexpr double kTop = 44.0;
constexpr double kBottom = 560.0;
constexpr double kGutterX = 64.0;
constexpr double kGutterY = 34.0;
constexpr double kLeastMs = 0.1; ///< less is what two timings of the same frame differ by

/// A point that has a place.
struct Mark {
    const Point* point = nullptr;
    std::size_t index = 0; ///< in Chart::all()
    bool is_peer = false;
    Place value;
    Place px;
};

class Drawing {
public:
    Drawing(const Chart& chart, const Series& series, Across across, Up up)
        : chart_(chart),
          series_(series),
          across_(across),
          up_(up),
          marks_(marks()),
          x_(values(&Place::x, {}), kLeft, kRight, kGutterX),
          y_(values(&Place::y, floors(chart, up)), kBottom, kTop, kGutterY) {
        for (Mark& mark : marks_)
            mark.px = {x_.place(mark.value.x), y_.place(mark.value.y)};
    }

    std::string svg() {
        frame();
        floor_lines();
        front(false);
        front(true);
        families();
        auto_curve();
        points();
        names();
        legend();
        return fmt::format(
            "<svg class=\"chart\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" "
            "role=\"group\" aria-label=\"{}: {} against {}\">\n{}</svg>\n",
            kChartWidth,
            kChartHeight,
            page::escaped(chart_.title()),
            page::escaped(title_of(up_)),
            page::escaped(title_of(across_)),
            out_);
    }

private:
    [[nodiscard]] std::vector<Mark> marks() const {
        std::vector<Mark> marks;
        const std::vector<const Point*> all = chart_.all();
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool is_peer = i >= chart_.points.size();
            // Other engines predict nothing: they keep the time that they took.
            const auto x = value(*all[i], is_peer ? Across::measured : across_);
            const auto y = value(*all[i], up_);
            if (x && y) marks.push_back({all[i], i, is_peer, {*x < kLeastMs ? 0.0 : *x, *y}, {}});
        }
        return marks;
    }
    [[nodiscard]] std::vector<double>
    values(double Place::*member, const std::vector<Floor>& lines) const {
        std::vector<double> values;
        for (const Mark& mark : marks_)
            values.push_back(mark.value.*member);
        for (const Floor& line : lines)
            values.push_back(line.value);
        return values;
    }
    /// By rising x.
    [[nodiscard]] std::vector<const Mark*> front_marks(bool of_peers) const {
        const std::vector<bool> on = on_front(chart_, across_, up_);
        std::vector<const Mark*> front;
        for (const Mark& mark : marks_)
            if (mark.is_peer == of_peers && on[mark.index]) front.push_back(&mark);
        std::stable_sort(front.begin(), front.end(), [](const Mark* a, const Mark* b) {
            return a->px.x != b->px.x ? a->px.x < b->px.x : a->px.y < b->px.y;
        });
        return front;
    }

    [[nodiscard]] Place floor_name(const Floor& floor) const {
        return {kLeft + kGutterX + 6.0, y_.place(floor.value) - 4.0};
    }

    template <class... T>
    void add(fmt::format_string<T...> format, T&&... values) {
        out_ += fmt::format(format, std::forward<T>(values)...);
    }
    void line(double x1, double y1, double x2, double y2, std::string_view css) {
        add("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n",
            css,
            x1,
            y1,
            x2,
            y2);
    }
    void text(
        double x, double y, std::string_view anchor, std::string_view css, std::string_view words) {
        add("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n",
            css,
            x,
            y,
            anchor,
            page::escaped(words));
    }
    void polyline(const std::vector<Place>& places, const std::string& attributes) {
        if (places.size() < 2) return;
        std::string points;
        for (const Place& place : places)
            points += fmt::format("{:.1f},{:.1f} ", place.x, place.y);
        points.pop_back();
        add("<polyline {} points=\"{}\"/>\n", attributes, points);
    }

    void frame();
    void floor_lines();
    void front(bool of_peers);
    void families();
    void auto_curve();
    void points();
    void names();
    void legend();

    const Chart& chart_;
    const Series& series_;
    Across across_;
    Up up_;
    std::vector<Mark> marks_;
    LogAxis x_;
    LogAxis y_;
    std::string out_;
};

void Drawing::frame() {
    if (x_.knows_zero()) {
        add("<rect class=\"gutter\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
            kLeft,
            kTop,
            x_.start() - kLeft,
            kBottom - kTop);
        text(x_.place(0.0), kBottom + 18.0, "middle", "", fmt::format("< {:g}", kLeastMs));
        line(x_.start(), kTop, x_.start(), kBottom, "grid whole");
    }
    if (y_.knows_zero()) {
        add("<rect class=\"gutter\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
            kLeft,
            y_.start(),
            kRight - kLeft,
            kBottom - y_.start());
        text(kLeft - 8.0, y_.place(0.0) + 4.0, "end", "", "0");
        line(kLeft, y_.start(), kRight, y_.start(), "grid whole");
    }
    for (const Tick& tick : x_.ticks()) {
        line(tick.at, kTop, tick.at, kBottom, tick.whole ? "grid whole" : "grid");
        text(tick.at, kBottom + 18.0, "middle", "", tick.label);
    }
    for (const Tick& tick : y_.ticks()) {
        line(kLeft, tick.at, kRight, tick.at, tick.whole ? "grid whole" : "grid");
        text(kLeft - 8.0, tick.at + 4.0, "end", "", tick.label);
    }
    add("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
        kLeft,
        kTop,
        kRight - kLeft,
        kBottom - kTop);
    text(kLeft, 24.0, "start", "title", chart_.title());
    text((kLeft + kRight) / 2.0, kBottom + 44.0, "middle", "", title_of(across_));
    add("<text transform=\"translate(20,{:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
        (kTop + kBottom) / 2.0,
        page::escaped(title_of(up_)));
}

void Drawing::floor_lines() {
    for (const Floor& floor : floors(chart_, up_)) {
        const double y = y_.place(floor.value);
        line(kLeft, y, kRight, y, "floor");
        const Place start = floor_name(floor);
        text(start.x, start.y, "start", "floor-name", floor.name);
    }
}

/// Steps, since nothing cheaper than a point of the front is as good as it.
void Drawing::front(bool of_peers) {
    std::vector<Place> steps;
    for (const Mark* mark : front_marks(of_peers)) {
        if (!steps.empty()) steps.push_back({mark->px.x, steps.back().y});
        steps.push_back(mark->px);
    }
    polyline(steps, of_peers ? "class=\"peer-front\"" : "class=\"front\"");
}

void Drawing::families() {
    std::map<std::string, std::vector<const Mark*>> families;
    for (const Mark& mark : marks_)
        if (!mark.point->family.empty()) families[mark.point->family].push_back(&mark);
    for (const auto& [name, members] : families) {
        std::vector<Place> places;
        for (const Mark* mark : members)
            places.push_back(mark->px);
        const std::string& series = members.front()->point->series;
        polyline(
            places,
            fmt::format(
                "class=\"family {}\" style=\"fill:none\" data-series=\"{}\"",
                series_.css_class(series),
                page::escaped(series)));
    }
}

void Drawing::auto_curve() {
    std::map<double, const Mark*> by_budget;
    for (const Mark& mark : marks_)
        if (mark.point->budget_px) by_budget[*mark.point->budget_px] = &mark;
    std::vector<Place> places;
    for (const auto& [budget, mark] : by_budget)
        places.push_back(mark->px);
    if (!by_budget.empty())
        polyline(
            places,
            fmt::format(
                "class=\"auto-curve\" data-series=\"{}\"",
                page::escaped(by_budget.begin()->second->point->series)));
}

void Drawing::points() {
    for (const Mark& mark : marks_)
        add("<g class=\"p {0}\" data-point=\"{1}\" data-series=\"{2}\" tabindex=\"0\" "
            "role=\"button\" aria-label=\"{3}: {4:.4g} ms, {5} {6:.4g}\" "
            "transform=\"translate({7:.1f},{8:.1f})\"><path d=\"{9}\"/></g>\n",
            series_.css_class(mark.point->series),
            mark.index,
            page::escaped(mark.point->series),
            page::escaped(mark.point->name),
            mark.value.x,
            page::escaped(title_of(up_)),
            mark.value.y,
            mark.px.x,
            mark.px.y,
            series_.shape(mark.point->series));
}

/// Budgets on the curve of what was picked first, then the front's own names.
void Drawing::names() {
    std::vector<Wanted> wanted;
    std::vector<std::string> series;
    const auto want = [&](const Mark& mark, std::string name) {
        wanted.push_back({mark.px, std::move(name)});
        series.push_back(mark.point->series);
    };
    for (const Mark& mark : marks_)
        if (mark.point->budget_px) want(mark, fmt::format("{:g} px", *mark.point->budget_px));
    for (const bool of_peers : {false, true})
        for (const Mark* mark : front_marks(of_peers))
            if (!mark->point->budget_px) want(*mark, mark->point->name);
    std::vector<Box> taken;
    for (const Mark& mark : marks_)
        taken.push_back(mark_box(mark.px));
    for (const Floor& floor : floors(chart_, up_))
        taken.push_back(text_box(floor_name(floor), floor.name));
    const auto found = place_labels(wanted, std::move(taken), {kLeft, kTop, kRight, kBottom});
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (found[i])
            add("<text class=\"label\" data-series=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
                page::escaped(series[i]),
                found[i]->x,
                found[i]->y,
                page::escaped(wanted[i].text));
}

void Drawing::legend() {
    std::set<std::string> shown;
    for (const Mark& mark : marks_)
        shown.insert(mark.point->series);
    double y = kTop + 8.0;
    for (const auto& names : {series_.own, series_.peers})
        for (const std::string& name : names) {
            if (!shown.contains(name)) continue;
            add("<g class=\"key\" data-series=\"{0}\" tabindex=\"0\" role=\"switch\" "
                "aria-checked=\"true\" aria-label=\"{0}\" transform=\"translate({1},{2})\">"
                "<rect x=\"-10\" y=\"-10\" width=\"180\" height=\"20\" fill=\"transparent\"/>"
                "<g class=\"{3}\"><path class=\"key-mark {3}\" d=\"{4}\"/></g>"
                "<text x=\"14\" y=\"4\">{0}</text></g>\n",
                page::escaped(name),
                kRight + 24.0,
                y,
                series_.css_class(name),
                series_.shape(name));
            y += 21.0;
        }
    struct Line {
        std::string_view css;
        std::string_view text;
        bool is_drawn;
    };
    for (const Line& one :
         {Line{"front", "nothing beats these", front_marks(false).size() > 1},
          Line{"peer-front", "the same, of others", front_marks(true).size() > 1},
          Line{"floor", "what sampling allows", !floors(chart_, up_).empty()}}) {
        if (!one.is_drawn) continue;
        y += 8.0;
        line(kRight + 14.0, y, kRight + 36.0, y, one.css);
        text(kRight + 44.0, y + 4.0, "start", "", one.text);
        y += 13.0;
    }
}

} // namespace

std::string drawing(const Chart& chart, const Series& series, Across across, Up up) {
    return Drawing(chart, series, across, up).svg();
}

std::string svg_file(const std::string& drawing) {
    const std::size_t inside = drawing.find('>') + 1;
    return fmt::format(
        "{}\n<style>\n{}{}svg {{ background: var(--paper); }}\n</style>\n{}",
        drawing.substr(0, inside),
        page::kPageStyle.substr(0, page::kPageStyle.find("body {")),
        kChartStyle,
        drawing.substr(inside));
}

} // namespace chart
