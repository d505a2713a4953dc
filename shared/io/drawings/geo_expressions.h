#pragma once
// The expressions of a .geo file: what stands behind '=' and between brackets. Used by geo.cpp, whose statements build
// on it.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "shared/io/drawings/geo.h"
#include "shared/io/drawings/geo_tokens.h"

namespace dobra::io::drawings {

/// Tokens and where the reading is; variables, lists, and what was read so far, of which new tags are asked.
/// Precedence, by recursive descent: ?: || && == < + * unary ^.
class GeoExpressions {
 protected:
  template <class T>
  using Result = base::Result<T>;
  using Error = base::Error;
  using Kind = GeoToken::Kind;
  using List = std::vector<double>;

  static constexpr std::size_t deepest = 200;  ///< Nesting of expressions and of loops.

  GeoExpressions(std::vector<GeoToken> tokens, std::string file) : tokens_(std::move(tokens)), file_(std::move(file)) {}

  [[nodiscard]] const GeoToken& token(std::size_t ahead = 0) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
  }
  [[nodiscard]] bool is(std::string_view text, std::size_t ahead = 0) const {
    return (token(ahead).kind == Kind::Word || token(ahead).kind == Kind::Sign) && token(ahead).text == text;
  }
  bool take(std::string_view text) {
    if (!is(text)) return false;
    ++at_;
    return true;
  }
  [[nodiscard]] base::Place place(const GeoToken& token) const;
  [[nodiscard]] Error error_at(const GeoToken& token, std::string message) const;
  [[nodiscard]] Error error(std::string message) const { return error_at(token(), std::move(message)); }
  [[nodiscard]] std::string found() const;
  Result<void> expect(std::string_view text);
  Result<double> expression();
  Result<double> conditional();
  Result<double> binary(int level);
  Result<double> unary();
  Result<double> signed_power();
  Result<double> primary();
  Result<double> named();
  [[nodiscard]] std::string unknown(const char* what, const std::string& name) const;
  template <class T>
  static double next_tag(const std::map<std::int64_t, T>& items) {
    return items.empty() ? 1.0 : static_cast<double>(items.rbegin()->first) + 1.0;
  }
  /// "{a, b:c, list[]}" or a single value.
  Result<List> list();
  /// Work of `count` steps; an error once a file asks for more than any geometry needs.
  Result<void> spend(double count);
  Result<void> list_item(List& values);
  Result<std::int64_t> tag_of(double value) const;
  Result<std::vector<std::int64_t>> tags();
  /// "(expression)"
  Result<std::int64_t> own_tag();

  std::vector<GeoToken> tokens_;
  std::string file_;
  std::size_t at_ = 0;
  double steps_ = 0.0;
  std::size_t depth_ = 0;
  GeoFile geo_;
  std::map<std::int64_t, std::vector<std::int64_t>> loop_curves_;
  std::map<std::string, double> variables_;
  std::map<std::string, List> lists_;
  std::int64_t last_group_ = 0;
};

}  // namespace dobra::io::drawings
