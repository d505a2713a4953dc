#pragma once
// From curves to a domain: ends that meet are joined, curves become loops, loops get their depth, and what is wrong is named.

#include "quebra/core/model.h"
#include "shared/base/result.h"

namespace quebra::core {

struct DomainOptions {
  double join_tolerance = 1e-9;  ///< Ends nearer than this fraction of the domain's diagonal are one point.
};

/// @param places  one a curve: where it stands in the user's file.
/// @error BadDomain (a loop that is not closed, a branch), SelfIntersection with the names of both curves and the point,
///        OutsideDomain for a hole that is in no loop.
dobra::base::Result<Domain> make_domain(std::vector<Curve> curves, const std::vector<dobra::base::Place>& places,
                                        const DomainOptions& options = {});

/// How finely arcs are followed where a domain is cut with lines (not how they are meshed).
inline constexpr dobra::base::Angle trace_turn = dobra::base::Angle::from_degrees(2.0);

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
