#pragma once
// Lines as columns of numbers: "x y", CSV, TSV and the like, one point a line. Digitised sections come this way.
// Comment lines start with '#'; LF, CRLF and CR line ends and a byte order mark are read. The decimal sign is '.', or
// ',' where all numbers of the file read so; marks of thousands are left out where they can be nothing else.

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/polyline.h"

namespace dobra::io::lines {

/// Detect takes the separator under which most of the first thousand lines give two numbers.
enum class Separator { Detect, Blank, Tab, Comma, Semicolon };
/// Detect takes the first line as a header when neither of its two fields is a number.
enum class Header { Detect, None, Present };
enum class BlankLines { Ignore, SplitLines };
/// Whether rows of one name that stand apart in the file are several lines or one.
enum class Rows { Consecutive, Gathered };
/// Whether a last point equal to the first closes the line (the repeated point is then dropped).
enum class Closing { KeepOpen, WhenFirstPointRepeats };

/// How a header calls the columns of names and of kinds, capitals or not.
inline constexpr std::array<std::string_view, 2> text_name_words{"name", "nome"};
inline constexpr std::array<std::string_view, 2> text_kind_words{"kind", "tipo"};
/// Capitals do not count.
bool is_word(std::string_view text, std::span<const std::string_view> words);

struct TextPointsOptions {
  Separator separator = Separator::Detect;  ///< Blank: any run of spaces and tabs.
  Header header = Header::Detect;
  /// The columns of x and y, or of x, y and a height: numbers from 1, or names that stand in the header.
  std::vector<std::string> columns = {"1", "2"};
  /// Columns, as above, whose texts together name a line: it ends where they change. A header's "name" and "kind"
  /// (capitals or not) are name and kind of themselves where this is empty.
  std::vector<std::string> name_columns = {};
  /// Further columns of numbers, as above, such as errors; a row that is too short has 0 there.
  std::vector<std::string> extra_columns = {};
  Rows rows = Rows::Consecutive;
  BlankLines blank_lines = BlankLines::Ignore;  ///< SplitLines: a blank line ends a line of points.
  Closing closing = Closing::KeepOpen;
  std::vector<std::string> kinds = {};  ///< The words that a column of kinds may hold; empty: those of sections.
};

struct TextPoints {
  std::vector<geom::Polyline> lines;         ///< Each has at least two distinct points, none repeated in a row.
  std::vector<std::vector<double>> heights;  ///< One a point, or empty without a third column.
  std::vector<std::vector<double>> extras;   ///< Of every point one number an extra column, or empty without them.
  std::vector<std::string> names;            ///< One a line; empty texts without name columns.
  std::vector<std::string> kinds;            ///< One a line; empty texts without a column "kind".
  std::vector<std::size_t> begins;           ///< For each line, the number of its first line in the file.
  std::vector<std::string> remarks;          ///< What was changed on the way, one line each, with line numbers.
  Separator separator = Separator::Blank;    ///< As used.
  std::size_t column_count = 0;              ///< Of the first row.
  std::vector<std::string> header;           ///< As it stands; empty without one.
  std::size_t header_line = 0;               ///< Its number in the file; 0 without one.
  std::vector<std::string> units;            ///< Of a row of units below the header; empty without one.
  std::vector<std::size_t> columns;          ///< Those of x and y, or of x, y and a height, from 1.
  bool third_is_number = false;              ///< Whether the third column of the first row of numbers is one.
};

/// The lines of a file of points.
/// @error FileNotFound, NotAFile, CannotRead; EmptyFile; BadFormat and NotFinite with line and column (binary file,
///        non-numeric text, NaN, too few columns, header only, -999.25 and the like far from all other values);
///        Unclear: numbers that mean two things, with line and column; DegenerateCurve with the line: fewer than two
///        distinct points; InvalidOption. @cost O(file size).
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

}  // namespace dobra::io::lines
