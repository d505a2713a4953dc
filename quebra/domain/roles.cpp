#include "quebra/domain/roles.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "quebra/sketch/ends.h"
#include "shared/topo/insert.h"

namespace quebra::domain {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Side;
using dobra::topo::Subdivision;

std::array<Point, 2> ends_of(const sketch::Curve& curve) { return {point(curve, 0.0), point(curve, length(curve))}; }

void close_what_returns(std::vector<sketch::Curve>& curves) {
  for (sketch::Curve& curve : curves) {
    auto* const line = std::get_if<Polyline>(&curve.shape);
    if (line == nullptr || line->closed || line->points.size() < 4 || line->points.front() != line->points.back())
      continue;
    line->points.pop_back();
    line->closed = true;
  }
}

/// The open curves that bound or may bound the domain, by their ends.
class Ends {
 public:
  Ends(std::vector<sketch::Curve>& curves, const std::set<std::string>& without_role)
      : curves_(curves), without_role_(without_role) {
    for (std::size_t i = 0; i < curves.size(); ++i) {
      if (!bounds(curves[i]) || closed(curves[i])) continue;
      for (const Point end : ends_of(curves[i])) at_[end].push_back(i);
    }
  }

  /// Chains with a free end do not bound the domain.
  void drop_loose() {
    std::vector<std::size_t> loose;
    for (const auto& [end, meeting] : at_) {
      if (meeting.size() == 1) loose.push_back(meeting.front());
    }
    while (!loose.empty()) {
      const std::size_t i = loose.back();
      loose.pop_back();
      if (curves_[i].role != sketch::Role::Boundary || !may_change(i)) continue;
      curves_[i].role = sketch::Role::Internal;
      for (const Point end : ends_of(curves_[i])) {
        auto& meeting = at_[end];
        meeting.erase(std::find(meeting.begin(), meeting.end(), i));
        if (meeting.size() == 1) loose.push_back(meeting.front());
      }
    }
  }

  /// Where three or more still meet, what borders on the outside bounds the domain and the rest divides it.
  void drop_inner() {
    std::set<std::size_t> branched;
    for (const auto& [end, meeting] : at_) {
      if (meeting.size() > 2) branched.insert(meeting.begin(), meeting.end());
    }
    if (branched.empty()) return;
    std::vector<std::size_t> bounding;
    std::vector<Polyline> lines;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      if (!bounds(curves_[i])) continue;
      bounding.push_back(i);
      lines.push_back(trace(curves_[i]).line);
    }
    Subdivision subdivision;
    const auto paths = insert(subdivision, lines);
    if (!paths) return;  // what is wrong with a line is told when the domain is made
    for (std::size_t k = 0; k < bounding.size(); ++k) {
      const std::size_t i = bounding[k];
      if (closed(curves_[i]) || !may_change(i) || (*paths)[k].empty()) continue;
      const auto h = (*paths)[k].front();
      const auto left = subdivision.face(h);
      const auto right = subdivision.face(Subdivision::twin(h));
      const bool rim = left == Subdivision::unbounded() || right == Subdivision::unbounded();
      const bool chain_of_loop = !branched.contains(i) && left != right;
      if (!rim && !chain_of_loop) curves_[i].role = sketch::Role::Internal;
    }
  }

 private:
  [[nodiscard]] bool may_change(std::size_t i) const { return without_role_.contains(curves_[i].name); }

  std::vector<sketch::Curve>& curves_;
  const std::set<std::string>& without_role_;
  std::map<Point, std::vector<std::size_t>> at_;
};

/// Number of the innermost loop of those; nothing if there are none.
std::optional<std::size_t> innermost(const Domain& domain, const std::vector<std::size_t>& loops) {
  std::optional<std::size_t> found;
  for (const std::size_t i : loops) {
    if (!found || domain.loops[*found].depth <= domain.loops[i].depth) found = i;
  }
  return found;
}

}  // namespace

void find_roles(sketch::Sketch& sketch, double tolerance) {
  join_ends(sketch.curves, tolerance);
  close_what_returns(sketch.curves);
  if (sketch.without_role.empty()) return;
  Ends ends(sketch.curves, sketch.without_role);
  ends.drop_loose();
  ends.drop_inner();
  sketch.without_role.clear();
}

Result<void> apply_hole_points(Domain& domain, const Inside& inside, const sketch::HolePoints& holes) {
  const auto own = [&](const Domain::Loop& loop) {
    return std::all_of(loop.sides.begin(), loop.sides.end(),
                       [&](const auto& side) { return holes.curves.contains(domain.curves[side.curve].name); });
  };
  std::vector<bool> is_void(domain.loops.size(), false);
  for (std::size_t i = 0; i < domain.loops.size(); ++i)
    is_void[i] = !own(domain.loops[i]) && domain.loops[i].depth % 2 == 1;
  for (const Point hole : holes.at) {
    const auto loop = innermost(domain, inside.loops_around(hole));
    if (!loop) {
      Place at = holes.place;
      at.x = hole.x;
      at.y = hole.y;
      return Error{ErrorCode::OutsideDomain, "a hole point lies outside every loop; move it inside or remove it", at};
    }
    is_void[*loop] = true;
  }
  for (std::size_t i = 0; i < domain.loops.size(); ++i) {
    auto around = inside.loops_around(inside.contours()[i].points.front());
    std::erase_if(around, [&](std::size_t j) { return domain.loops[j].depth >= domain.loops[i].depth; });
    const auto surrounding = innermost(domain, around);
    const bool surrounded_by_void = !surrounding || is_void[*surrounding];
    if (surrounded_by_void != is_void[i] || !own(domain.loops[i])) continue;
    for (const auto& side : domain.loops[i].sides) domain.curves[side.curve].role = sketch::Role::Internal;
  }
  return {};
}

}  // namespace quebra::domain
