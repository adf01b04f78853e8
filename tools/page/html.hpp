// What every page that a tool leaves behind is made of: one HTML file that needs no other, readable
// in a dark browser as in a light one.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace page {

/// Text as HTML shows it, in an element or in a quoted attribute.
std::string escaped(std::string_view text);

/// Source: RFC 4648, section 4.
std::string base64(std::span<const std::uint8_t> bytes);

/// A file as an address that a page can carry: "data:image/png;base64,...".
/// Source: RFC 2397.
std::string data_url(std::string_view media_type, std::span<const std::uint8_t> bytes);

/// CSS: colours by name (--ink, --paper, --faint, --line, --good, --bad) that follow the browser's
/// scheme, type, and tables.
extern const std::string_view kPageStyle;

/// A whole page.
/// @param style CSS besides kPageStyle
/// @param body HTML, taken as it is
std::string html_page(std::string_view title, std::string_view style, std::string_view body);

} // namespace page
