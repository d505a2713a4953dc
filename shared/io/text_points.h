#pragma once
// Lines as columns of numbers: "x y", CSV, TSV and the like, one point a line. Digitised sections come this way.
// Comment lines start with '#'; LF, CRLF and CR line ends and a byte order mark are read; the decimal sign is '.'.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/polyline.h"

namespace dobra::io {

/// Detect takes the separator under which most of the first thousand lines give two numbers.
enum class Separator { Detect, Blank, Tab, Comma, Semicolon };
/// Detect takes the first line as a header when neither of its two fields is a number.
enum class Header { Detect, None, Present };
enum class YDirection { Up, Down };
enum class BlankLines { Ignore, SplitLines };
/// Whether a last point equal to the first closes the line (the repeated point is then dropped).
enum class Closing { KeepOpen, WhenFirstPointRepeats };

struct TextPointsOptions {
  Separator separator = Separator::Detect;  ///< Blank: any run of spaces and tabs.
  Header header = Header::Detect;
  std::size_t x_column = 1;                     ///< 1-based.
  std::size_t y_column = 2;                     ///< 1-based.
  YDirection y_direction = YDirection::Up;      ///< Down: y = (y_reference - value) * unit_factor.
  double y_reference = 0.0;                     ///< In file units; read only when y_direction is Down.
  double unit_factor = 1.0;                     ///< Metres in one file unit, > 0.
  BlankLines blank_lines = BlankLines::Ignore;  ///< SplitLines: a blank line ends a line of points.
  Closing closing = Closing::KeepOpen;
};

struct TextPoints {
  std::vector<geom::Polyline> lines;  ///< Metres, y up; each has at least two distinct points, none repeated in a row.
  std::vector<std::string> remarks;   ///< What was changed on the way, one line each, with line numbers.
  Separator separator = Separator::Blank;  ///< As used.
};

/// The lines of a file of points.
/// @error FileNotFound, NotAFile, CannotRead; EmptyFile; BadFormat and NotFinite with line and column (binary file,
///        non-numeric text, NaN, too few columns, header only); DegenerateCurve with the line: fewer than two distinct
///        points; InvalidOption. @cost O(file size).
base::Result<TextPoints> read_text_points(const std::string& path, const TextPointsOptions& options = {});

/// The same from text in memory; `file` is the name that errors show.
base::Result<TextPoints> parse_text_points(std::string_view text, const std::string& file,
                                           const TextPointsOptions& options = {});

/// "x_name,y_name", then one point a line with every digit; a blank line between lines, and a closed line repeats its
/// first point: parse_text_points with SplitLines and WhenFirstPointRepeats gives the same lines back.
/// @error NotFinite
base::Result<std::string> points_csv(std::span<const geom::Polyline> lines, std::string_view x_name = "x",
                                     std::string_view y_name = "y");
/// @error NotFinite, CannotWrite
base::Result<void> write_points_csv(const std::string& path, std::span<const geom::Polyline> lines,
                                    std::string_view x_name = "x", std::string_view y_name = "y");

}  // namespace dobra::io
