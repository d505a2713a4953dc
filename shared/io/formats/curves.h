#pragma once
// The curves of a file in any of the formats that hold curves: one entry for commands that take "a file of lines".

#include <optional>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/polyline.h"
#include "shared/io/formats/line_files.h"

namespace dobra::io::formats {

struct NamedCurve {
  /// As in the file; a further part of the same feature has " (2)" and so on added; "curve N" (N = its 1-based number
  /// in `Curves::curves`) where the file gives no name. Names may repeat if the file repeats them.
  std::string name;
  /// Open in the order of the file; contours of polygons anticlockwise, their holes clockwise.
  geom::Polyline line = {};
  /// The number of the polygon that it is the contour or a hole of, from 0 on in the file, and the name of its feature.
  std::optional<std::size_t> polygon = std::nullopt;
  std::string feature = {};
};

struct Curves {
  std::vector<NamedCurve> curves;                         ///< At least one, in file order.
  std::vector<std::string> remarks;                       ///< What was changed or left out on reading, one line each.
  const Format* format = nullptr;                         ///< That it was read in.
  double unit = 1.0;                                      ///< As it was taken, m.
  lines::YDirection y_direction = lines::YDirection::Up;  ///< As it was taken.
};

/// Reads whatever read_any_lines (line_files.h) reads, by the ending of the name: x and y as they stand, without units
/// or heights. Points that belong to no line are left out with a remark.
/// @error UnknownFormat naming what is read; BadFormat if there is no line and no polygon; those of the readers.
base::Result<Curves> read_curves(const std::string& path);
/// The same in metres, x right and y up, by what the options and the file say. @error Unclear for what neither says.
base::Result<Curves> read_curves(const std::string& path, const LineOptions& options);

}  // namespace dobra::io::formats
