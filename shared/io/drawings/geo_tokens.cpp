#include "shared/io/drawings/geo_tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "shared/io/scan.h"

namespace dobra::io::drawings {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

bool starts_word(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool goes_on(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; }

class Scanner {
 public:
  Scanner(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  Result<std::vector<GeoToken>> run() {
    std::vector<GeoToken> tokens;
    while (true) {
      DOBRA_TRY_VOID(skip_blanks());
      GeoToken token;
      token.line = line_;
      token.column = at_ - line_start_ + 1;
      if (at_ < text_.size()) DOBRA_TRY_VOID(scan(token));
      tokens.push_back(std::move(token));
      if (tokens.back().kind == GeoToken::Kind::End) return tokens;
    }
  }

 private:
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  [[nodiscard]] Error error(std::string message) const {
    base::Place place;
    place.file = file_;
    place.line = line_;
    place.column = at_ - line_start_ + 1;
    return {ErrorCode::BadFormat, std::move(message), place};
  }
  void step() {
    if (text_[at_] == '\n') {
      ++line_;
      line_start_ = at_ + 1;
    }
    ++at_;
  }

  Result<void> skip_blanks() {
    while (at_ < text_.size()) {
      if (std::isspace(static_cast<unsigned char>(peek())) != 0) {
        step();
      } else if (peek() == '/' && peek(1) == '/') {
        while (at_ < text_.size() && peek() != '\n') ++at_;
      } else if (peek() == '/' && peek(1) == '*') {
        const std::size_t end = text_.find("*/", at_ + 2);
        if (end == std::string_view::npos) return error("this comment has no end");
        while (at_ < end + 2) step();
      } else {
        return {};
      }
    }
    return {};
  }

  Result<void> scan(GeoToken& token) {
    const char c = peek();
    const std::size_t begin = at_;
    if (starts_word(c)) {
      while (goes_on(peek())) ++at_;
      token.kind = GeoToken::Kind::Word;
      token.text = std::string(text_.substr(begin, at_ - begin));
      return {};
    }
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 ||
        (c == '.' && std::isdigit(static_cast<unsigned char>(peek(1))) != 0)) {
      const auto [stop, status] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), token.value);
      if (status != std::errc{} || !std::isfinite(token.value)) return error("this number cannot be read");
      at_ = static_cast<std::size_t>(stop - text_.data());
      if (starts_word(peek())) return error("a number must not run into a word");
      token.kind = GeoToken::Kind::Number;
      token.text = std::string(text_.substr(begin, at_ - begin));
      return {};
    }
    if (c == '"') {
      const std::size_t end = text_.find_first_of("\"\n", at_ + 1);
      if (end == std::string_view::npos || text_[end] == '\n') return error("this text has no closing quote");
      token.kind = GeoToken::Kind::Text;
      token.text = std::string(text_.substr(at_ + 1, end - at_ - 1));
      at_ = end + 1;
      return {};
    }
    constexpr std::array<std::string_view, 12> doubles{"==", "!=", "<=", ">=", "&&", "||",
                                                       "+=", "-=", "*=", "/=", "++", "--"};
    token.kind = GeoToken::Kind::Sign;
    for (const std::string_view sign : doubles) {
      if (!text_.substr(at_).starts_with(sign)) continue;
      token.text = std::string(sign);
      at_ += 2;
      return {};
    }
    if (std::string_view("+-*/%^(){}[]=<>!,;:?#&~").find(c) == std::string_view::npos) {
      return error(fmt::format("the character {} has no meaning here", shown(text_.substr(at_, 1))));
    }
    token.text = std::string(1, c);
    ++at_;
    return {};
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t line_start_ = 0;
};

}  // namespace

Result<std::vector<GeoToken>> geo_tokens(std::string_view text, const std::string& file) {
  return Scanner(text, file).run();
}

}  // namespace dobra::io::drawings
