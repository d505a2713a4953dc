#include "shared/io/dxf_pairs.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "shared/base/text.h"

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {}  // namespace

Error DxfPairs::error(std::string message, ErrorCode error_code) const {
  return {error_code, std::move(message), Place{.file = file_, .line = lines_.number()}};
}

Error DxfPairs::cut_short() const {
  return error("the drawing ends without '0 EOF'; the file may have been cut short");
}

Result<void> DxfPairs::next() {
  if (!lines_.next()) return cut_short();
  const std::string_view word = base::trimmed(lines_.line());
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), code);
  if (problem != std::errc{} || end != word.data() + word.size()) {
    return error(
        fmt::format("{} is not a group code; a DXF file is pairs of lines, a whole number and its value", shown(word)));
  }
  if (!lines_.next()) return cut_short();
  value = base::trimmed(lines_.line());
  return {};
}

std::set<std::string> hidden_dxf_layers(std::string_view text) {
  std::set<std::string> hidden;
  DxfPairs pairs(text, {});
  bool in_layer = false;
  std::string name;
  while (pairs.next() && !pairs.is(2, "ENTITIES")) {
    if (pairs.code == 0) in_layer = pairs.value == "LAYER";
    if (!in_layer) continue;
    if (pairs.code == 2) name = pairs.value;
    if (pairs.code != 62 && pairs.code != 70) continue;
    const double number = base::parse_number(pairs.value).value_or(0.0);
    const bool off = pairs.code == 62 && number < 0.0;
    const bool frozen = pairs.code == 70 && std::fmod(number, 2.0) == 1.0;
    if (off || frozen) hidden.insert(name);
  }
  return hidden;
}

}  // namespace dobra::io
