#include "quebra/repair/stray_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "quebra/domain/open_outline.h"
#include "quebra/sketch/snap.h"
#include "shared/geom/intersect.h"
#include "shared/topo/insert.h"

namespace quebra::repair {
namespace {

using dobra::base::Result;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Segment;
using dobra::topo::HalfEdgeId;
using dobra::topo::Subdivision;

const Polyline* open_line(const sketch::Curve& curve) {
  const auto* line = std::get_if<Polyline>(&curve.shape);
  return line != nullptr && !line->closed ? line : nullptr;
}

/// Puts pieces in the place of curve i: the first keeps its name. @return how many there are.
std::size_t replace(sketch::Sketch& sketch, std::size_t i, std::vector<Polyline> pieces) {
  const sketch::Curve whole = sketch.curves[i];
  const auto at = static_cast<std::ptrdiff_t>(i);
  const dobra::base::Place place = sketch.places.empty() ? dobra::base::Place{} : sketch.places[i];
  sketch.curves.erase(sketch.curves.begin() + at);
  sketch.places.erase(sketch.places.begin() + (sketch.places.empty() ? 0 : at));
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    sketch::Curve piece = whole;
    if (k > 0) piece.name += fmt::format("_{}", k + 1);
    piece.shape = std::move(pieces[k]);
    if (sketch.without_role.contains(whole.name)) sketch.without_role.insert(piece.name);
    sketch.curves.insert(sketch.curves.begin() + at + static_cast<std::ptrdiff_t>(k), std::move(piece));
    sketch.places.insert(sketch.places.begin() + at + static_cast<std::ptrdiff_t>(k), place);
  }
  return pieces.size();
}

/// The sides of the contours of a domain.
class Rim {
 public:
  explicit Rim(const domain::Domain& domain) : inside_(domain) {
    std::vector<dobra::geom::Box> boxes;
    for (const Polyline& contour : inside_.contours()) {
      for (std::size_t i = 0; i < contour.segment_count(); ++i) {
        sides_.push_back(contour.segment(i));
        boxes.push_back(sides_.back().box());
      }
    }
    index_ = dobra::geom::SpatialIndex(boxes);
  }

  [[nodiscard]] bool holds(Point p) const { return inside_(p); }
  [[nodiscard]] const domain::Inside& inside() const { return inside_; }

  /// The line with a vertex wherever it meets a side.
  [[nodiscard]] Polyline cut(const Polyline& line) const {
    Polyline result{{line.points.front()}, false};
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
      const Segment segment = line.segment(i);
      std::map<double, Point> at;
      index_.for_each_overlapping(segment.box(), [&](std::size_t k) {
        const auto met = intersect(segment, sides_[k]);
        if (met.kind == dobra::geom::IntersectionKind::None) return;
        at.emplace(nearest_fraction(segment, met.start.point), met.start.point);
        if (met.kind == dobra::geom::IntersectionKind::Overlap)
          at.emplace(nearest_fraction(segment, met.end.point), met.end.point);
      });
      for (const auto& [fraction, p] : at) {
        if (fraction > 0.0 && fraction < 1.0 && p != result.points.back()) result.points.push_back(p);
      }
      result.points.push_back(segment.to);
    }
    return result;
  }

 private:
  domain::Inside inside_;
  std::vector<Segment> sides_;
  dobra::geom::SpatialIndex index_;
};

/// The parts of a line that lie inside, and how long the others are.
struct Trimmed {
  std::vector<Polyline> inside;
  double length_outside = 0.0;
  Point outside;  ///< On the longest part outside.
};

Trimmed trim(const Polyline& line, const Rim& rim) {
  Trimmed result;
  double longest = -1.0;
  bool inside = false;
  const Polyline cut = rim.cut(line);
  for (std::size_t i = 0; i < cut.segment_count(); ++i) {
    const auto [from, to] = cut.segment(i);
    const bool in = rim.holds(midpoint(from, to));
    if (in && !inside) result.inside.push_back({{from}, false});
    if (in) result.inside.back().points.push_back(to);
    inside = in;
    if (in) continue;
    result.length_outside += distance(from, to);
    if (distance(from, to) <= longest) continue;
    longest = distance(from, to);
    result.outside = midpoint(from, to);
  }
  return result;
}

}  // namespace

Result<void> cut_at_crossings(sketch::Sketch& sketch, double same_point) {
  const auto takes_part = [&](const sketch::Curve& curve) {
    return curve.role == sketch::Role::Boundary && sketch.without_role.contains(curve.name) &&
           open_line(curve) != nullptr;
  };
  std::vector<Polyline> lines;
  for (const sketch::Curve& curve : sketch.curves) {
    if (takes_part(curve)) lines.push_back(*open_line(curve));
  }
  std::vector<Polyline*> together;
  for (Polyline& line : lines) together.push_back(&line);
  sketch::snap_together(together, same_point);
  Subdivision subdivision;
  DOBRA_TRY(const auto paths, insert(subdivision, lines));
  const auto ends_of = [&](HalfEdgeId h) {
    return std::pair{subdivision.point(subdivision.origin(h)),
                     subdivision.point(subdivision.origin(Subdivision::twin(h)))};
  };
  std::map<Point, int> meeting;
  for (const auto edge : subdivision.edges()) {
    const auto [from, to] = ends_of(Subdivision::half_edge(edge));
    ++meeting[from];
    ++meeting[to];
  }
  std::set<std::size_t> taken;  // of lines that run along each other the first has the edge
  auto path = paths.begin();
  for (std::size_t i = 0; i < sketch.curves.size();) {
    if (!takes_part(sketch.curves[i])) {
      ++i;
      continue;
    }
    std::vector<Polyline> pieces;
    bool goes_on = false;
    for (const HalfEdgeId h : *path++) {
      const auto [from, to] = ends_of(h);
      const bool own = taken.insert(Subdivision::edge(h).index()).second;
      if (own && !goes_on) pieces.push_back({{from}, false});
      if (own) pieces.back().points.push_back(to);
      goes_on = own && meeting[to] == 2;
    }
    i += replace(sketch, i, std::move(pieces));
  }
  return {};
}

Result<std::vector<sketch::Finding>> drop_outside(sketch::Sketch& sketch, const std::set<std::string>& lines,
                                                  const domain::DomainOptions& options) {
  const auto asked = [&](const sketch::Curve& curve) {
    return curve.role == sketch::Role::Internal && !closed(curve) && lines.contains(curve.name);
  };
  if (std::none_of(sketch.curves.begin(), sketch.curves.end(), asked)) return std::vector<sketch::Finding>{};
  sketch::Sketch rim_only;
  rim_only.hole_points = sketch.hole_points;
  for (const sketch::Curve& curve : sketch.curves) {
    if (curve.role == sketch::Role::Boundary || curve.role == sketch::Role::Hole) rim_only.curves.push_back(curve);
  }
  rim_only.places.resize(rim_only.curves.size());
  const auto domain = domain::make_domain(std::move(rim_only), options);
  if (!domain) return std::vector<sketch::Finding>{};  // said when all of it is put together
  const Rim rim(*domain);
  if (auto open = domain::open_outline(sketch.curves, sketch.places, rim.inside(), options.repaired))
    return *std::move(open);
  std::vector<sketch::Finding> findings;
  for (std::size_t i = 0; i < sketch.curves.size();) {
    const sketch::Curve& curve = sketch.curves[i];
    if (!asked(curve)) {
      ++i;
      continue;
    }
    const Polyline* line = open_line(curve);
    Trimmed parts = trim(line != nullptr ? *line : trace(curve).line, rim);
    const bool bent_in_part = line == nullptr && !parts.inside.empty();
    if (!(parts.length_outside > options.join_tolerance * domain->box().diagonal()) || bent_in_part) {
      ++i;
      continue;
    }
    findings.push_back({sketch::Wrong::Outside, parts.outside, curve.name,
                        parts.inside.empty() ? std::string("the line is left out")
                                             : fmt::format("{:.3g} m of its {:.3g} m are left out",
                                                           parts.length_outside, length(curve))});
    i += replace(sketch, i, std::move(parts.inside));
  }
  return findings;
}

}  // namespace quebra::repair
