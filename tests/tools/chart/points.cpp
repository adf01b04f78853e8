#include "tests/tools/chart/points.hpp"

#include "tools/measure/floors.hpp"
#include "tools/page/picture.hpp"

namespace chart_test {

namespace {

std::string grey_picture(std::uint8_t level) {
    engine::Image image(4, 3, 1);
    image.bytes.assign(12, level);
    return page::png_url(image);
}

} // namespace

chart::Point point(const std::string& name, double ms, double wrong_px) {
    chart::Point point;
    point.name = name;
    point.series = name.substr(0, name.find('@'));
    point.family = point.series;
    point.measured_ms = ms;
    point.predicted_ms = ms / 2.0;
    point.errors = chart::Errors{
        10000.0,
        wrong_px,
        wrong_px,
        500.0,
        500.0 * measure::kPrecisionFloor,
        500.0 * measure::kHalfPixelFloor};
    point.facts = {{"map", "</script>&\"quoted\""}};
    point.pictures = {grey_picture(40), grey_picture(80), grey_picture(120)};
    return point;
}

chart::Findings findings() {
    chart::Findings findings;
    findings.title = "Charts of made_up";
    findings.about = "64x48, </script> is only text";
    findings.series.own = {"none", "map", "volume", "traced", "auto"};
    findings.series.peers = {"ogre"};
    chart::Chart& one = findings.charts.emplace_back();
    one.scene = "made_up";
    one.light = "sun <1>";
    one.truth_mask = grey_picture(200);
    one.points = {
        point("none", 0.0, 4000.0),
        point("map@256", 4.0, 400.0),
        point("map@1024", 8.0, 100.0),
        point("map@4096", 30.0, 25.0),
        point("volume", 20.0, 0.0),
        point("traced", 900.0, 0.0),
        point("auto@0.1", 21.0, 2.0),
        point("auto@8", 3.0, 900.0)};
    one.points[5].is_truth = true;
    one.points[6].budget_px = 0.1;
    one.points[7].budget_px = 8.0;
    chart::Point& peer = one.peers.emplace_back();
    peer.name = "ogre pcf 1024";
    peer.series = "ogre";
    peer.measured_ms = 50.0;
    peer.wrong_percent = 3.0;
    one.refusals = {{"planar", "no receiver is <flat>"}};
    return findings;
}

} // namespace chart_test
