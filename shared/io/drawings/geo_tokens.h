#pragma once
// The words, numbers, texts and signs of a .geo file, each with its place.

#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"

namespace dobra::io::drawings {

struct GeoToken {
  enum class Kind { Word, Number, Text, Sign, End };
  Kind kind = Kind::End;
  std::string text;  ///< A word, a sign, or what stands between quotes.
  double value = 0.0;
  std::size_t line = 1;
  std::size_t column = 1;
};

/// Ends with a token of kind End. Comments are left out.
/// @error BadFormat: a text or comment without end, a number that is none, a character that no statement has.
base::Result<std::vector<GeoToken>> geo_tokens(std::string_view text, const std::string& file);

}  // namespace dobra::io::drawings
