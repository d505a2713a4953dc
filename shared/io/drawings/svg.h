#pragma once
// The outlines of SVG pictures: path elements (M L H V C S Q T A Z, absolute and relative), and rect, circle, ellipse,
// line, polyline and polygon, with the transforms of their groups. Curves stay curves. SVG's y runs down: it is turned,
// so that the picture stands as it is seen; one unit is 1 m. What is not displayed (display: none, visibility: hidden,
// layers that are hidden so) is not there. Source: [svg11].

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point.h"

namespace dobra::io::drawings {

enum class SvgPieceKind { Line, Cubic, Arc };

struct SvgPiece {
  SvgPieceKind kind = SvgPieceKind::Line;
  geom::Point from;
  geom::Point to;
  std::array<geom::Point, 2> control{};  ///< Of a cubic Bezier curve; quadratic ones are raised to it.
  /// Of an arc: centre + cos(t) u + sin(t) v, t from `start` over `sweep` radians; u and v are conjugate half axes.
  geom::Point centre;
  geom::Vector u;
  geom::Vector v;
  double start = 0.0;
  double sweep = 0.0;
  bool goes_on = false;  ///< Of a cubic: one curve with the cubic before it.
};

/// A subpath: each piece starts where the one before ends.
struct SvgPath {
  std::string name;  ///< Its id, with " (2)" and so on for further subpaths; "path N" without one.
  std::vector<SvgPiece> pieces;
  bool closed = false;  ///< By Z, or because it ends where it starts.
  base::Place place;    ///< Of the element.
};

struct SvgFile {
  std::vector<SvgPath> paths;        ///< At least one, each with pieces; in the order of the file.
  std::vector<std::string> remarks;  ///< What was left out: definitions, texts, pictures, what is not displayed.
};

/// @error FileNotFound, NotAFile, CannotRead, EmptyFile; BadFormat with line and column: markup that does not close,
///        path data or a transform that is wrong, no outline at all; NotFinite.  @cost linear
base::Result<SvgFile> read_svg(const std::string& path);
base::Result<SvgFile> parse_svg(std::string_view text, const std::string& file);

}  // namespace dobra::io::drawings
