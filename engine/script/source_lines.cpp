#include "engine/script/source_lines.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

namespace script {

namespace {

struct Token {
    std::string_view text; ///< of a string: what stands between its quotes
    int line = 0;
    bool quoted = false;

    [[nodiscard]] bool is(char symbol) const {
        return !quoted && text.size() == 1 && text[0] == symbol;
    }
};

bool is_word(char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}

/// Splits Lua text into words, strings and single symbols; comments fall away.
class Lexer {
public:
    explicit Lexer(std::string_view text) : text_(text) {}

    std::vector<Token> tokens() {
        while (at_ < text_.size())
            step();
        return std::move(tokens_);
    }

private:
    void step() {
        const char letter = text_[at_];
        if (std::isspace(static_cast<unsigned char>(letter)) != 0) {
            advance_to(at_ + 1);
        } else if (text_.substr(at_, 2) == "--") {
            at_ += 2;
            if (!skip_long_bracket()) advance_to(text_.find('\n', at_));
        } else if (letter == '"' || letter == '\'') {
            read_string(letter);
        } else if (letter == '[' && skip_long_bracket()) {
            // a long string: no field is called so
        } else if (is_word(letter)) {
            const std::size_t start = at_;
            while (at_ < text_.size() && is_word(text_[at_]))
                ++at_;
            tokens_.push_back({text_.substr(start, at_ - start), line_});
        } else {
            tokens_.push_back({text_.substr(at_++, 1), line_});
        }
    }

    void read_string(char quote) {
        const int line = line_;
        const std::size_t start = at_ + 1;
        std::size_t end = start;
        while (end < text_.size() && text_[end] != quote && text_[end] != '\n')
            end += text_[end] == '\\' ? 2 : 1;
        end = std::min(end, text_.size());
        tokens_.push_back({text_.substr(start, end - start), line, true});
        advance_to(end + 1);
    }

    /// Stands at [[ or [=[ and moves behind its end; else stays and says no.
    bool skip_long_bracket() {
        if (at_ >= text_.size() || text_[at_] != '[') return false;
        const std::size_t second = text_.find_first_not_of('=', at_ + 1);
        if (second == std::string_view::npos || text_[second] != '[') return false;
        const std::string closing = "]" + std::string(second - at_ - 1, '=') + "]";
        const std::size_t end = text_.find(closing, second);
        advance_to(end == std::string_view::npos ? end : end + closing.size());
        return true;
    }

    void advance_to(std::size_t end) {
        end = std::min(end, text_.size());
        line_ += static_cast<int>(std::count(
            text_.begin() + static_cast<long>(std::min(at_, end)),
            text_.begin() + static_cast<long>(end),
            '\n'));
        at_ = end;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    std::vector<Token> tokens_;
};

struct Found {
    std::size_t depth = 0; ///< parts of the path that were found
    int line = 0;
};

/// Looks for path[depth...] in the table whose { is tokens[open].
Found find_in_table(
    const std::vector<Token>& tokens,
    std::size_t open,
    const std::vector<std::string>& path,
    Found found) {
    int nesting = 0;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        if (token.is('{') || token.is('(')) ++nesting;
        if (token.is('}') || token.is(')')) --nesting;
        if (nesting == 0) return found;
        if (nesting != 1 || token.text != path[found.depth]) continue;
        const std::size_t equals = i + (token.quoted ? 2 : 1); // name =, or ["name"] =
        const bool is_key =
            equals + 1 < tokens.size() && tokens[equals].is('=') && !tokens[equals + 1].is('=');
        if (!is_key || (token.quoted && !tokens[i - 1].is('['))) continue;
        found = {found.depth + 1, token.line};
        if (found.depth == path.size() || !tokens[equals + 1].is('{')) return found;
        return find_in_table(tokens, equals + 1, path, found);
    }
    return found;
}

} // namespace

int field_line(
    std::string_view text, int line, std::string_view word, const std::vector<std::string>& path) {
    if (path.empty()) return line;
    const std::vector<Token> tokens = Lexer(text).tokens();
    Found best{0, line};
    for (std::size_t i = 0; i + 1 < tokens.size() && tokens[i].line <= line; ++i) {
        if (tokens[i].line != line || tokens[i].quoted || tokens[i].text != word) continue;
        std::size_t open = i + 1;
        if (tokens[open].is('(')) ++open;
        if (open >= tokens.size() || !tokens[open].is('{')) continue;
        const Found found = find_in_table(tokens, open, path, {0, line});
        if (found.depth > best.depth) best = found;
    }
    return best.line;
}

} // namespace script
