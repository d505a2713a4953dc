#pragma once
// The path data of SVG: the attribute `d`, without any transform. Used by svg.h.

#include <string>
#include <string_view>
#include <vector>

#include "shared/io/drawings/svg.h"

namespace dobra::io::drawings {

/// What an attribute of numbers and commands is read with: blanks and commas between numbers, numbers that follow each
/// other without either, flags of one character.
class SvgScanner {
 public:
  explicit SvgScanner(std::string_view text) : text_(text) {}
  /// Passes over blanks; true at the end.
  bool at_end();
  [[nodiscard]] bool at_number();
  /// The character here, taken.  @pre not at_end
  char take() { return text_[at_++]; }
  /// Takes `c` if it stands here, blanks before it aside.
  bool take(char c);
  /// @error BadFormat or NotFinite, without a place.
  base::Result<double> number();
  base::Result<double> flag();
  [[nodiscard]] std::size_t position() const { return at_; }
  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

 private:
  void skip_comma();

  std::string_view text_;
  std::size_t at_ = 0;
};

/// Subpaths with at least one piece, in SVG's own axes, without names and places.
/// @error BadFormat or NotFinite saying what is wrong, without a place.
base::Result<std::vector<SvgPath>> svg_subpaths(std::string_view data);

}  // namespace dobra::io::drawings
