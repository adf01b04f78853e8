#include "tools/chart/chart_page.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "tools/chart/drawing.hpp"
#include "tools/chart/page_script.hpp"
#include "tools/page/html.hpp"

namespace chart {

namespace {

using page::escaped;

template <class Axis>
bool is_known(const std::vector<Chart>& charts, Axis axis) {
    return std::any_of(charts.begin(), charts.end(), [&](const Chart& chart) {
        return std::any_of(chart.points.begin(), chart.points.end(), [&](const Point& point) {
            return value(point, axis).has_value();
        });
    });
}

/// Buttons for the axes on which some point has a value.
template <class Axis, std::size_t n>
std::string choice(
    const std::vector<Chart>& charts,
    const std::array<Axis, n>& axes,
    Axis chosen,
    std::string_view name,
    std::string_view heading) {
    std::string html = fmt::format("<fieldset><b>{}</b>\n", heading);
    for (const Axis axis : axes) {
        if (!is_known(charts, axis)) continue;
        html += fmt::format(
            "<label title=\"{4}\"><input type=\"radio\" name=\"{0}\" value=\"{1}\"{2}> "
            "{3}</label>\n",
            name,
            word_of(axis),
            axis == chosen ? " checked" : "",
            escaped(short_title_of(axis)),
            escaped(title_of(axis)));
    }
    return html + "</fieldset>\n";
}

std::string views(const Findings& findings, const Chart& chart) {
    std::string html;
    for (const Across across : kAcross)
        for (const Up up : kUp)
            if (is_known(findings.charts, across) && is_known(findings.charts, up))
                html += fmt::format(
                    "<div class=\"view\" data-across=\"{}\" data-up=\"{}\">{}</div>\n",
                    word_of(across),
                    word_of(up),
                    drawing(chart, findings.series, across, up));
    return html;
}

std::string refusals(const Chart& chart) {
    if (chart.refusals.empty()) return {};
    std::string html = "<details open><summary>Without a point</summary><table>\n";
    for (const Refusal& refusal : chart.refusals)
        html += fmt::format(
            "<tr><td><code>{}</code></td><td>{}</td></tr>\n",
            escaped(refusal.name),
            escaped(refusal.reason));
    return html + "</table></details>\n";
}

/// What the script has to know of every point.
std::string data(const Findings& findings) {
    nlohmann::ordered_json charts = nlohmann::ordered_json::array();
    for (const Chart& chart : findings.charts) {
        nlohmann::ordered_json points = nlohmann::ordered_json::array();
        for (const Point* point : chart.all()) {
            nlohmann::ordered_json facts = nlohmann::ordered_json::array();
            const auto add = [&](std::string_view name, const std::optional<double>& number) {
                if (number) facts.push_back({std::string(name), fmt::format("{:.4g}", *number)});
            };
            add("shadows add, ms", value(*point, Across::measured));
            add("predicted, ms", value(*point, Across::predicted));
            for (const Up up : kUp)
                add(title_of(up), value(*point, up));
            for (const auto& [name, text] : point->facts)
                facts.push_back({name, text});
            points.push_back(
                {{"name", point->name},
                 {"facts", std::move(facts)},
                 {"pictures",
                  {{"picture", point->pictures.color},
                   {"mask", point->pictures.mask},
                   {"error", point->pictures.error}}}});
        }
        charts.push_back({{"truth", chart.truth_mask}, {"points", std::move(points)}});
    }
    std::string text = charts.dump();
    // Nothing in it may end the element that holds it.
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
        text.replace(at, 1, "\\u003c");
    return text;
}

} // namespace

std::string chart_page(const Findings& findings) {
    std::string body = fmt::format(
        "<h1>{}</h1>\n<p class=\"faint\">{}</p>\n",
        escaped(findings.title),
        escaped(findings.about));
    body += kHowToRead;
    body += "<form class=\"axes\">\n";
    body += choice(findings.charts, kUp, usual_up(findings.charts), "up", "Up");
    body += choice(
        findings.charts,
        kAcross,
        is_known(findings.charts, Across::measured) ? Across::measured : Across::predicted,
        "across",
        "Across");
    body += "</form>\n";
    for (std::size_t i = 0; i < findings.charts.size(); ++i) {
        const Chart& chart = findings.charts[i];
        body += fmt::format(
            "<section data-chart=\"{}\">\n{}{}</section>\n",
            i,
            views(findings, chart),
            refusals(chart));
    }
    body += kPanel;
    body +=
        fmt::format("<script type=\"application/json\" id=\"data\">{}</script>\n", data(findings));
    body += kScript;
    return page::html_page(
        findings.title, std::string(kChartStyle) + std::string(kChartPageStyle), body);
}

} // namespace chart
