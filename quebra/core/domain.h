#pragma once
// From curves to a domain: ends that meet are joined, curves become loops, loops get their depth, and what is wrong is named.

#include "quebra/core/model.h"
#include "shared/base/result.h"

namespace quebra::core {

/// A name for the part of the material that a point lies in.
struct RegionName {
  std::string name;  ///< Parts of one name are one region.
  dobra::geom::Point at;
};

/// What a domain is made of.
struct Sketch {
  std::vector<Curve> curves;
  std::vector<dobra::base::Place> places;  ///< One a curve: where it stands in the user's file.
  std::vector<RegionName> regions;
  std::vector<NamedPoint> points;
  std::vector<std::string> remarks;
};

struct DomainOptions {
  double join_tolerance = 1e-9;  ///< Ends nearer than this fraction of the domain's diagonal are one point.
};

/// Cracks and internal lines may cross, branch and end on other curves: every meeting becomes a junction.
/// @error BadDomain (a loop that is not closed, a branch), SelfIntersection with the names of both curves and the point,
///        OutsideDomain for a hole that is in no loop, and for an internal line, crack, point or region outside.
dobra::base::Result<Domain> make_domain(Sketch sketch, const DomainOptions& options = {});

/// The contour of a loop, in order, arcs followed by trace_turn.
dobra::geom::Polyline contour(const Domain& domain, const Domain::Loop& loop);

/// All contours of a domain, made once for many questions.
class Inside {
 public:
  explicit Inside(const Domain& domain);
  /// True if p is strictly inside: in an odd number of loops and on none.
  [[nodiscard]] bool operator()(dobra::geom::Point p) const;

 private:
  std::vector<dobra::geom::Polyline> contours_;
};

}  // namespace quebra::core
