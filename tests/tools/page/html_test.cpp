// Text and files inside a page.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "tools/page/html.hpp"

namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::vector<std::uint8_t> bytes_of(std::string_view text) {
    return {text.begin(), text.end()};
}

TEST(PageText, OfAnyKindIsShownAsItIs) {
    EXPECT_EQ(page::escaped("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
}

// The vectors of RFC 4648, section 10.
TEST(PageBase64, FollowsItsStandard) {
    EXPECT_EQ(page::base64(bytes_of("")), "");
    EXPECT_EQ(page::base64(bytes_of("f")), "Zg==");
    EXPECT_EQ(page::base64(bytes_of("fo")), "Zm8=");
    EXPECT_EQ(page::base64(bytes_of("foo")), "Zm9v");
    EXPECT_EQ(page::base64(bytes_of("foobar")), "Zm9vYmFy");
    EXPECT_EQ(page::base64(std::vector<std::uint8_t>{0xFB, 0xFF, 0xBF}), "+/+/");
}

TEST(PageDataUrl, SaysWhatItHolds) {
    EXPECT_EQ(page::data_url("text/plain", bytes_of("foo")), "data:text/plain;base64,Zm9v");
}

TEST(Page, KnowsDarkAndLightAndAsksNobody) {
    const std::string html = page::html_page("a < b", "i { x: y }", "<p>body</p>");

    EXPECT_THAT(html, StartsWith("<!DOCTYPE html>"));
    EXPECT_THAT(html, HasSubstr("<title>a &lt; b</title>"));
    EXPECT_THAT(html, HasSubstr("@media (prefers-color-scheme: dark)"));
    EXPECT_THAT(html, HasSubstr("i { x: y }"));
    EXPECT_THAT(html, HasSubstr("<body>\n<p>body</p>"));
    EXPECT_THAT(html, Not(HasSubstr("http")));
    EXPECT_THAT(html, Not(HasSubstr("<link")));
}

} // namespace
