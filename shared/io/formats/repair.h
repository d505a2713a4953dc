#pragma once
// Repairs of digitised line-work: points out of order, points twice, gaps, horizons that end short of a fault, slivers
// of polygons. Each is asked for by name, and each tells what it did, where, and how far anything moved.
// Page: docs/algorithms/repair.md. Source: [figueiredo1994] (order by the minimum spanning tree).

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "shared/io/lines/feature.h"

namespace dobra::io::formats {

enum class PointOrder { AsGiven, AlongTheCurve };

/// An end of a part of a feature. Of the feature all but its parts may be read.
struct PartEnd {
  const lines::Feature& feature;
  const geom::Polyline& part;
  bool last = false;  ///< Else its first point.
};

/// All lengths in metres; what is not set is not done. Done in this order.
struct RepairOptions {
  PointOrder order = PointOrder::AsGiven;           ///< Lines and points features that are one curve each.
  std::optional<double> duplicates = std::nullopt;  ///< Points nearer than this to the one before are dropped.
  std::optional<double> gaps = std::nullopt;        ///< Ends of lines of one name and kind nearer than this are joined.
  /// Asked before two ends are joined, nearest ones first; without it all may be.
  std::function<bool(const PartEnd&, const PartEnd&)> may_join = {};
  std::optional<double> snap = std::nullopt;  ///< Ends of lines nearer than this to a fault are moved onto it.
  /// Of which lines the ends are moved onto which; without it those of all but faults onto faults.
  std::function<bool(const lines::Feature& line, const lines::Feature& onto)> may_snap = {};
  /// Of several lines near an end the one that its line crosses first before it; else the nearest one.
  bool first_crossing = false;
  double on_line = 0.0;  ///< What is no farther than this from such a line lies on it, and stays as it is.
  /// Vertices of polygons nearer than this to a line or to an earlier polygon are moved onto it, and both get the
  /// vertex.
  std::optional<double> edges = std::nullopt;
  std::optional<double> slivers = std::nullopt;  ///< Polygons, and spikes of polygons, thinner than this are removed.
};

struct Repair {
  std::string what;    ///< "order", "duplicates", "gap", "snap", "edge", "sliver" or "spike".
  std::string item;    ///< "horizon 'top'".
  std::string text;    ///< What was done, with numbers.
  geom::Point at;      ///< Where.
  double moved = 0.0;  ///< The farthest that a point moved or that was bridged, m.
};

/// Repairs features in section coordinates (without heights), in place.
/// Faults are the lines of kind "fault"; a line of kind "unit" that ends within `gaps` of its beginning becomes a
/// polygon.
/// @error InvalidOption: a tolerance that is not a positive number; BadFormat with the feature and the place: points
///        that do not lie along one curve. @cost O(n log n) in the number of points; points that stand off the curve
///        take O(n) each.
base::Result<std::vector<Repair>> repair(std::vector<lines::Feature>& features, const RepairOptions& options);

/// "gap: horizon 'top': ..., at (x, z), moved d m": one line.
std::string to_string(const Repair& repair);

}  // namespace dobra::io::formats
