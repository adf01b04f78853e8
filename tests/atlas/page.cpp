// The page of the atlas: curves as SVG, masks as PNG in data addresses, nothing fetched.

#include "tests/atlas/page_frame.hpp"
#include "tests/atlas/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tools/page/html.hpp"
#include "tools/page/picture.hpp"

namespace atlas {

namespace {

using page::escaped;

std::string picture(const engine::Image& image, const std::string& caption) {
    if (image.bytes.empty()) return {};
    return fmt::format(
        "<figure><img alt=\"{0}\" src=\"{1}\">"
        "<figcaption>{0}</figcaption></figure>\n",
        escaped(caption),
        page::png_url(image));
}

/// Where values lie in a chart of 330 x 170.
class Axes {
public:
    Axes(const Outcome& one, const Curve& curve)
        : from_(one.steps.front()),
          span_(one.steps.back() - one.steps.front()),
          top_(std::max({largest(curve.off), largest(curve.on), 1.25 * curve.at_most, 1e-6})) {}

    [[nodiscard]] double x(double step) const { return 44.0 + 276.0 * (step - from_) / span_; }
    [[nodiscard]] double y(double value) const { return 140.0 - 124.0 * value / top_; }
    [[nodiscard]] double top() const { return top_; }

private:
    double from_;
    double span_;
    double top_;
};

std::string line_of(
    const Outcome& one,
    const std::vector<double>& values,
    const Axes& axes,
    const std::string& kind) {
    std::string points;
    std::string dots;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double x = axes.x(one.steps[i]);
        const double y = axes.y(values[i]);
        points += fmt::format("{:.1f},{:.1f} ", x, y);
        dots += fmt::format(
            "<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\"><title>{} at {:.4g}: "
            "{:.5g}</title></circle>",
            kind,
            x,
            y,
            kind,
            one.steps[i],
            values[i]);
    }
    return fmt::format("<polyline class=\"{}\" points=\"{}\"/>{}\n", kind, points, dots);
}

std::string axis_label(double value) {
    return value >= 100.0 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

std::string chart(const Outcome& one, const Curve& curve) {
    const Axes axes(one, curve);
    const double worst = axes.x(one.steps[one.worst]);
    std::string svg = fmt::format(
        "<figure><svg viewBox=\"0 0 330 170\" role=\"img\"><rect class=\"frame\" x=\"44\" y=\"16\" "
        "width=\"276\" height=\"124\"/>"
        "<text x=\"40\" y=\"22\" text-anchor=\"end\">{}</text>"
        "<text x=\"40\" y=\"142\" text-anchor=\"end\">0</text>"
        "<text x=\"44\" y=\"155\">{:.4g}</text>"
        "<text x=\"320\" y=\"155\" text-anchor=\"end\">{:.4g}</text>"
        "<line class=\"worst\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"16\" y2=\"140\"/>\n",
        axis_label(axes.top()),
        one.steps.front(),
        one.steps.back(),
        worst,
        worst);
    svg += fmt::format(
        "<line class=\"gate\" x1=\"44\" x2=\"320\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/>\n",
        axes.y(curve.at_most));
    svg += line_of(one, curve.off, axes, "off");
    svg += line_of(one, curve.on, axes, "on");
    return svg
           + fmt::format(
               "</svg><figcaption>{}, at most {:g}</figcaption></figure>\n",
               escaped(curve.figure),
               curve.at_most);
}

std::string verdict_of(const Outcome& one) {
    return fmt::format(
        "<span class=\"{}\">{}</span>", one.good() ? "good" : "bad", escaped(one.verdict()));
}

std::string table_row(const Outcome& one) {
    const Curve& curve = one.telling();
    return fmt::format(
        "<tr data-case=\"{0} {2}\"><td><a href=\"#{0}\">{0}</a></td><td>{1}</td><td><code>{2}"
        "</code></td><td>{3}</td><td class=\"number\">{4}</td><td class=\"number\">{5:.4g}</td>"
        "<td>{6}</td></tr>\n",
        escaped(one.id),
        escaped(one.sentence),
        one.remedy.empty() ? "-" : one.remedy,
        escaped(fmt::format("{} <= {:g}", curve.figure, curve.at_most)),
        curve.off.empty() ? "-" : fmt::format("{:.4g}", largest(curve.off)),
        largest(curve.on),
        verdict_of(one));
}

std::string section(const Outcome& one) {
    std::string html = fmt::format(
        "<section id=\"{0}\" data-case=\"{0} {1}\"><h2>{0}: {2}</h2><p>{3} {4}</p>"
        "<div class=\"row\">\n",
        escaped(one.id),
        one.remedy.empty() ? "-" : one.remedy,
        escaped(one.sentence),
        one.remedy.empty() ? std::string("no switch;")
                           : fmt::format("remedy <code>{}</code>;", one.remedy),
        verdict_of(one));
    html += picture(one.without, "without the remedy");
    html += picture(one.with, one.remedy.empty() ? "mask" : "with it");
    html += picture(one.truth, "truth");
    html += "</div><div class=\"row\">\n";
    for (const Curve& curve : one.curves)
        html += chart(one, curve);
    return html + "</div></section>\n";
}

std::string refusals(const Findings& found) {
    std::string html =
        "<h2>Refused</h2><p>Asked for what they cannot do, these say so instead of drawing it."
        "</p><table><tr><th>case</th><th>what would go wrong</th><th>technique</th>"
        "<th>what it says</th></tr>\n";
    for (const Refusal& one : found.refusals)
        html += fmt::format(
            "<tr data-case=\"{0} {2}\"><td>{0}</td><td>{1}</td><td><code>{2}</code></td>"
            "<td>{3}</td></tr>\n",
            escaped(one.id),
            escaped(one.sentence),
            escaped(one.technique),
            escaped(one.reason));
    html += "</table>\n<h2>Cannot occur</h2><table><tr><th>case</th><th>what goes wrong elsewhere"
            "</th><th>why not here</th></tr>\n";
    for (const Impossible& one : found.impossible)
        html += fmt::format(
            "<tr data-case=\"{0} -\"><td>{0}</td><td>{1}</td><td>{2}</td></tr>\n",
            escaped(one.id),
            escaped(one.sentence),
            escaped(one.why));
    return html + "</table>\n";
}

} // namespace

std::string html_page(const Findings& found) {
    std::string html(kPageTop);
    html += kFilterBox;
    html += "<table><tr><th>case</th><th>without the remedy</th><th>remedy</th><th>gate</th>"
            "<th class=\"number\">worst off</th><th class=\"number\">worst on</th><th>verdict</th>"
            "</tr>\n";
    for (const Outcome& one : found.outcomes)
        html += table_row(one);
    html += "</table>\n";
    html += refusals(found);
    for (const Outcome& one : found.outcomes)
        html += section(one);
    return page::html_page("The atlas of failures", kPageStyle, html);
}

} // namespace atlas
