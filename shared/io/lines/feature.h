#pragma once
// Line-work: named points, lines and polygons with their properties, as every exchange format carries them. All readers
// of lines return it, all writers take it (line_files.h chooses by the format).

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/polyline.h"

namespace dobra::io::lines {

enum class FeatureType { Points, Lines, Polygons };

using PropertyValue = std::variant<bool, std::int64_t, double, std::string>;

/// One feature: coordinates are those of the section or the domain (x right, y up), never longitude and latitude; or,
/// where there are heights, map coordinates x, y and the height (or depth) of each point.
struct Feature {
  FeatureType type = FeatureType::Lines;
  /// Points: one part that holds them all. Lines: open parts. Polygons: closed parts, each anticlockwise contour
  /// followed by its clockwise holes.
  std::vector<geom::Polyline> parts = {};
  std::string name = {};  ///< Property "name"; empty if there is none.
  std::string kind = {};  ///< Property "kind", such as "horizon" or "fault"; empty if there is none.
  std::vector<std::pair<std::string, PropertyValue>> properties = {};  ///< The others, in file order.
  std::vector<std::vector<double>> heights = {};  ///< Empty, or the third coordinate of every point of every part.
  /// Empty, or for every part the extra columns of a text, point after point; of lines as they were read, without
  /// repairs.
  std::vector<std::vector<double>> extras = {};
  /// Its number in the file, where that keeps one. Does not count in comparisons.
  std::optional<std::int64_t> id = {};
  base::Place source = {};  ///< File and line, or file and item. Where it came from does not count in comparisons.

  friend bool operator==(const Feature& a, const Feature& b) {
    return a.type == b.type && a.parts == b.parts && a.name == b.name && a.kind == b.kind &&
           a.properties == b.properties && a.heights == b.heights;
  }
};

enum class YDirection { Up, Down };

/// What a file leaves open and only the user can say; the text names the option that answers.
struct Question {
  enum class About { YDirection, Unit, Coordinates } about;
  std::string text;
};

/// A reference system, as files name it.
struct ReferenceSystem {
  std::string wkt;
  std::string name;
  std::string code;      ///< Such as "EPSG:31983"; empty if there is none.
  bool degrees = false;  ///< Coordinates are longitudes and latitudes.
  friend bool operator==(const ReferenceSystem&, const ReferenceSystem&) = default;
};

/// What a file says of its own coordinates; nothing where it does not say.
struct StatedConvention {
  std::optional<YDirection> y_direction = std::nullopt;  ///< Down: the last coordinate is a depth.
  std::optional<double> unit = std::nullopt;             ///< Metres in one unit of x and y.
  std::optional<double> height_unit = std::nullopt;      ///< The same of heights, where it differs.
  std::optional<ReferenceSystem> system = std::nullopt;  ///< Kept for writers that are given it; never applied.
  std::vector<Question> questions = {};
};

/// A vertical plane, by its trace on the map: the section's x runs from the origin along the direction.
struct Trace {
  double x = 0.0;  ///< Origin, m.
  double y = 0.0;
  double east = 1.0;  ///< Unit direction.
  double north = 0.0;
  double largest_misfit = 0.0;  ///< Distance of the points from the plane, m.
  double mean_misfit = 0.0;     ///< Root of the mean square, m.
};

struct Features {
  std::vector<Feature> features;
  std::vector<std::string> remarks;  ///< What was changed or left out on reading, one line each.
  StatedConvention stated = {};
};

/// What a reader does with third coordinates.
enum class Heights { Drop, Keep };

/// What a reader does with lines and rings that are none, and with geometries that it does not know.
enum class Faulty { Refuse, Skip };

/// Cleans what a file gave: drops repeated points, closes polygons without their repeated first point, turns contours
/// anticlockwise and holes (every ring of a polygon but its first) clockwise; polygons with heights are turned as they
/// are seen from the south (from the west if their plane runs from north to south, from above if it is level).
/// @param ring_of_polygon  for Polygons: for each part its number within its polygon (0 = outer contour).
/// @return                 number of repeated points dropped.
/// @error                  NotFinite, DegenerateCurve with the place.
base::Result<std::size_t> normalise(Feature& feature, const std::vector<std::size_t>& ring_of_polygon);

/// The same; parts that are no line or polygon are left out, a contour with its holes, with a remark each that begins
/// with `where`. No part may be left. @error NotFinite
base::Result<std::size_t> normalise_sound(Feature& feature, const std::vector<std::size_t>& ring_of_polygon,
                                          const std::string& where, std::vector<std::string>& remarks);

/// Before `normalise`: that rings of a polygon do not repeat their first point at the end, and where the first of them
/// is closed; empty where all do.
std::string open_rings(const Feature& feature);

/// Leaves x and y alone of a feature with heights, as normalise would have given it without them.
/// @error DegenerateCurve with the place.
base::Result<void> drop_heights(Feature& feature);

/// The same for all; with Faulty::Skip what is no polygon then is left out with a remark.
base::Result<void> drop_heights(Features& features, Faulty faulty);

/// For each part of a feature with heights, 0 where it is a contour and 1 where it is a hole, by its orientation.
std::vector<std::size_t> rings_of(const Feature& feature);

/// Parts of a Polygons feature grouped into polygons, each [first, last): an anticlockwise part starts a new one.
std::vector<std::pair<std::size_t, std::size_t>> polygons_of(const Feature& feature);

/// For formats without holes: every ring of a polygon a polygon of its own, turned as a contour; the others as they
/// are.
std::vector<Feature> rings_apart(std::span<const Feature> features);

/// "lines.csv:3" or "lines.shp: feature 3 'top'": how remarks name a place.
std::string where(const base::Place& place);

/// "feature 3 'top'": how messages name the feature of that number (from 1).
std::string item_of(std::size_t number, const Feature& feature);

}  // namespace dobra::io::lines
