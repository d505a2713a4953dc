#pragma once
// From curves to a domain: ends that meet are joined, curves become loops, loops get their depth, and what is wrong is
// named.

#include <optional>
#include <set>

#include "quebra/core/model.h"
#include "shared/base/result.h"
#include "shared/geom/polyline.h"
#include "shared/geom/spatial_index.h"

namespace quebra::core {

/// A name for the part of the material that a point lies in.
struct RegionName {
  std::string name;  ///< Parts of one name are one region.
  dobra::geom::Point at;
};

/// A polygon of the user's file: the material inside it takes its name.
struct Area {
  std::string name;                ///< Of the region; empty: none.
  std::vector<std::string> rings;  ///< Names of the curves of its contour and its holes.
  std::vector<dobra::geom::Polyline>
      outline;  ///< The same as they were read: inside is what an odd number of them holds.
};

/// Loops of these curves inside others are holes only where a point says so (.poly); else they divide material from
/// material.
struct HolePoints {
  std::set<std::string> curves;  ///< By name.
  std::vector<dobra::geom::Point> at;
  dobra::base::Place place;  ///< The file.
};

/// What a domain is made of.
struct Sketch {
  std::vector<Curve> curves;
  std::vector<dobra::base::Place> places;  ///< One a curve: where it stands in the user's file.
  std::vector<RegionName> regions;
  std::vector<NamedPoint> points;
  std::vector<std::string> remarks;
  /// Curves, by name, whose file tells no roles: they are found once ends are joined.
  std::set<std::string> without_role = {};
  std::optional<HolePoints> hole_points = std::nullopt;
  /// Lines, by name, that two areas share (areas.h): between two holes they divide nothing.
  std::set<std::string> interfaces = {};
  std::vector<Area> areas = {};  ///< A region named by `regions` keeps that name.
};

/// What repair.h mends.
struct RepairOptions {
  static constexpr double gap_fraction = 1e-3;
  static constexpr double greatest_gap_fraction = 0.1;
  double same_point = 1e-7;  ///< Points nearer than this fraction of the drawing's diagonal are one.
  /// Ends nearer than this that meet nothing are joined, m; otherwise gap_fraction of the diagonal.
  std::optional<double> gap = std::nullopt;
  double spike = 0.01;  ///< Corners sharper than this are spikes, degrees.
};

struct DomainOptions {
  double join_tolerance = 1e-7;  ///< Ends nearer than this fraction of the domain's diagonal are one point.
  /// The sketch went through repair: messages do not offer it again.
  std::optional<RepairOptions> repaired = std::nullopt;
};

/// Cracks and internal lines may cross, branch and end on other curves: every meeting becomes a junction.
/// @error BadDomain (a loop that is not closed, a branch), SelfIntersection with the names of both curves and the
///        point, OutsideDomain for a hole that is in no loop, and for an internal line, crack, point or region outside.
dobra::base::Result<Domain> make_domain(Sketch sketch, const DomainOptions& options = {});

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

}  // namespace quebra::core
