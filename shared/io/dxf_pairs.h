#pragma once
// The text form of DXF: pairs of a group code and a value, each on a line of its own. For the readers of chords (gis)
// and of true curves (drawings).

#include <set>
#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/io/scan.h"

namespace dobra::io {

/// The pairs of a drawing, one after another. The text must outlive it.
class DxfPairs {
 public:
  DxfPairs(std::string_view text, std::string file) : lines_(text), file_(std::move(file)) {}

  int code = 0;
  std::string_view value;  ///< Without blanks round it.

  /// Moves on. @error BadFormat: no group code, or the text ends where a pair should stand.
  base::Result<void> next();
  [[nodiscard]] bool is(int wanted_code, std::string_view wanted) const {
    return code == wanted_code && value == wanted;
  }
  /// At the value of the current pair.
  [[nodiscard]] base::Error error(std::string message, base::ErrorCode error_code = base::ErrorCode::BadFormat) const;

 private:
  [[nodiscard]] base::Error cut_short() const;

  Lines lines_;
  std::string file_;
};

/// The layers that are off (a negative colour) or frozen, as the table of layers says.
std::set<std::string> hidden_dxf_layers(std::string_view text);

}  // namespace dobra::io
