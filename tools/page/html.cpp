#include "tools/page/html.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace page {

const std::string_view kPageStyle =
    R"css(:root { color-scheme: light dark; --ink: #222; --paper: #fff; --faint: #6b6b6b; --line: #d8d8d8;
  --good: #15803d; --bad: #b91c1c; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e6e6; --paper: #16181c; --faint: #a3a3a3; --line: #3a3d44;
  --good: #4ade80; --bad: #f87171; } }
body { font: 15px/1.45 system-ui, sans-serif; color: var(--ink); background: var(--paper);
  max-width: 1120px; margin: 2rem auto; padding: 0 1rem; }
h1 { margin-bottom: 0; } h2 { font-size: 1.1rem; margin: 0; }
p { margin: .3rem 0; } code { font-size: .92em; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; margin: 1rem 0; }
th, td { text-align: left; padding: .2rem .6rem .2rem 0; border-bottom: 1px solid var(--line); vertical-align: top; }
td.number, th.number { text-align: right; white-space: nowrap; }
a { color: inherit; }
section { border-top: 1px solid var(--line); padding: 1rem 0; }
figure { margin: 0; } figcaption { font-size: .8rem; color: var(--faint); }
.bad { color: var(--bad); font-weight: 600; } .faint { color: var(--faint); }
)css";

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char letter : text) {
        if (letter == '<')
            safe += "&lt;";
        else if (letter == '>')
            safe += "&gt;";
        else if (letter == '&')
            safe += "&amp;";
        else if (letter == '"')
            safe += "&quot;";
        else
            safe += letter;
    }
    return safe;
}

std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view kLetters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = (group << 8U) | (k < count ? bytes[i + k] : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= count ? kLetters[(group >> (18U - 6U * k)) & 63U] : '=';
    }
    return text;
}

std::string data_url(std::string_view media_type, std::span<const std::uint8_t> bytes) {
    return fmt::format("data:{};base64,{}", media_type, base64(bytes));
}

std::string html_page(std::string_view title, std::string_view style, std::string_view body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{}</title>\n<style>\n{}{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
        escaped(title),
        kPageStyle,
        style,
        body);
}

} // namespace page
