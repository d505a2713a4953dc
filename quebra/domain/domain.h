#pragma once
// From curves to a domain: ends that meet are joined, curves become loops, loops get their depth, and what is wrong is
// named.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "quebra/sketch/finding.h"
#include "quebra/sketch/sketch.h"
#include "shared/base/result.h"
#include "shared/geom/polyline.h"
#include "shared/geom/spatial_index.h"

namespace quebra::domain {

/// A point where a curve meets another one away from its ends, or where a point of the domain lies on it: a node of
/// both.
struct Junction {
  std::size_t curve = 0;
  double s = 0.0;
  dobra::geom::Point at;
};

/// A part of the material, bounded by loops and internal lines.
struct Face {
  std::int32_t region = 0;  ///< Tag: 1, 2, ... first the named regions in their order.
  dobra::geom::Point inside;
  double area = 0.0;  ///< m2, arcs followed by trace_turn.
};

/// Curves joined into loops. Ends that meet are the same point, bit for bit.
struct Domain {
  std::vector<sketch::Curve> curves;
  /// One loop: indices of curves in order round it, and whether each is travelled backwards.
  struct Side {
    std::size_t curve = 0;
    bool backwards = false;
  };
  struct Loop {
    std::vector<Side> sides;
    int depth = 0;  ///< 0: outer boundary, 1: hole in it, 2: island in the hole ...
  };
  std::vector<Loop> loops;
  std::vector<Junction> junctions;  ///< By curve, then by distance.
  std::vector<sketch::NamedPoint> points;
  std::vector<sketch::RegionName> regions;  ///< As they were named; those of areas are not among them.
  std::vector<Face> faces;
  std::map<std::int32_t, std::string> region_names;
  double unit = 1.0;  ///< Of the coordinates in conditions on places (selection.h), m.

  [[nodiscard]] dobra::geom::Box box() const;
  /// As of lone_circles, of these curves and points.
  [[nodiscard]] std::vector<std::uint8_t> lone_circles(double margin) const;
};

struct DomainOptions {
  double join_tolerance = 1e-7;  ///< Ends nearer than this fraction of the domain's diagonal are one point.
  /// The sketch went through repair: messages do not offer it again.
  std::optional<sketch::RepairOptions> repaired = std::nullopt;
};

/// Cracks and internal lines may cross, branch and end on other curves: every meeting becomes a junction.
/// @error BadDomain (a loop that is not closed, a branch), SelfIntersection with the names of both curves and the
///        point, OutsideDomain for a hole that is in no loop, and for an internal line, crack, point or region outside.
dobra::base::Result<Domain> make_domain(sketch::Sketch sketch, const DomainOptions& options = {});

/// The contour of a loop, in order, arcs followed by trace_turn.
dobra::geom::Polyline contour(const Domain& domain, const Domain::Loop& loop);

/// All contours of a domain, made once for many questions.
class Inside {
 public:
  explicit Inside(const Domain& domain);
  /// True if p is strictly inside: in an odd number of loops and on none.
  /// @cost O(log loops) and the sides of the contours whose boxes hold p.
  [[nodiscard]] bool operator()(dobra::geom::Point p) const;
  /// Numbers of the loops that p lies strictly inside, ascending; the same cost.
  [[nodiscard]] std::vector<std::size_t> loops_around(dobra::geom::Point p) const;
  /// One a loop, in their order.
  [[nodiscard]] const std::vector<dobra::geom::Polyline>& contours() const { return contours_; }

 private:
  std::vector<dobra::geom::Polyline> contours_;
  dobra::geom::SpatialIndex boxes_;
};

}  // namespace quebra::domain
