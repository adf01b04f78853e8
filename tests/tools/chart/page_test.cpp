// The page of charts, as text; chart_browser_test opens it.

#include "tests/tools/chart/points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using testing::HasSubstr;
using testing::Not;

/// The text of the element that holds the page's data.
nlohmann::json data_of(const std::string& page) {
    const std::string start = "id=\"data\">";
    const std::size_t from = page.find(start) + start.size();
    return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

TEST(ChartPage, NeedsNothingFromElsewhere) {
    std::string page = chart::chart_page(chart_test::findings());
    const std::string name_of_svg = "http://www.w3.org/2000/svg"; // a name, which nobody fetches
    for (std::size_t at = page.find(name_of_svg); at != std::string::npos;
         at = page.find(name_of_svg))
        page.erase(at, name_of_svg.size());

    EXPECT_THAT(page, Not(HasSubstr("http")));
    EXPECT_THAT(page, Not(HasSubstr("<link")));
    EXPECT_THAT(page, Not(HasSubstr("src=\"")));
    EXPECT_THAT(page, Not(HasSubstr("url(")));
}

TEST(ChartPage, HoldsEveryPointWithItsPictures) {
    const auto data = data_of(chart::chart_page(chart_test::findings()));

    ASSERT_EQ(data.size(), 1U);
    const auto& points = data[0]["points"];
    ASSERT_EQ(points.size(), 9U);
    EXPECT_EQ(points[2]["name"], "map@1024");
    EXPECT_THAT(
        points[2]["pictures"]["mask"].get<std::string>(),
        testing::StartsWith("data:image/png;base64,"));
    EXPECT_NE(points[2]["pictures"]["mask"], points[2]["pictures"]["error"]);
    EXPECT_EQ(points[2]["facts"][0], nlohmann::json({"shadows add, ms", "8"}));
    EXPECT_EQ(points[8]["name"], "ogre pcf 1024");
}

TEST(ChartPage, LetsNoTextEndItsData) {
    const std::string page = chart::chart_page(chart_test::findings());
    const auto data = data_of(page);

    EXPECT_EQ(
        data[0]["points"][0]["facts"].back(), nlohmann::json({"map", "</script>&\"quoted\""}));
    EXPECT_THAT(page, HasSubstr("64x48, &lt;/script&gt; is only text"));
}

TEST(ChartPage, OffersOnlyTheAxesThatAreKnown) {
    chart::Findings findings = chart_test::findings();
    EXPECT_THAT(chart::chart_page(findings), HasSubstr("value=\"measured\" checked"));

    for (chart::Point& point : findings.charts[0].points)
        point.measured_ms.reset();
    const std::string page = chart::chart_page(findings);

    EXPECT_THAT(page, Not(HasSubstr("value=\"measured\"")));
    EXPECT_THAT(page, HasSubstr("value=\"predicted\" checked"));
}

TEST(ChartPage, BeginsWithWhatItsLightsAreJudgedBy) {
    chart::Findings findings = chart_test::findings();
    EXPECT_THAT(chart::chart_page(findings), HasSubstr("value=\"wrong_percent\" checked"));

    findings.charts[0].soft = true;

    EXPECT_THAT(chart::chart_page(findings), HasSubstr("value=\"eps_px\" checked"));
}

TEST(ChartPage, SaysWhatHasNoPointAndWhy) {
    EXPECT_THAT(
        chart::chart_page(chart_test::findings()),
        HasSubstr("<code>planar</code></td><td>no receiver is &lt;flat&gt;</td>"));
}

} // namespace
