#include "quebra/repair/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <set>

#include "quebra/domain/roles.h"
#include "quebra/repair/crossings.h"
#include "quebra/repair/stray_lines.h"
#include "quebra/sketch/areas.h"
#include "quebra/sketch/ends.h"
#include "quebra/sketch/snap.h"

// 1 points of each curve. 2 spikes; polygons that share sides are parted, what nearly touches is made to. 3 curves
// drawn twice. 4 gaps; then roles, where the file tells none, crossings (crossings.h), and what lies outside
// (stray_lines.h).

namespace quebra::repair {
namespace {

using dobra::base::Result;
using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Vector;

class Repairer {
 public:
  Repairer(sketch::Sketch sketch, const sketch::RepairOptions& options)
      : repaired_{std::move(sketch), {}}, options_(options) {
    Box box;
    for (const sketch::Curve& curve : curves()) box.add(trace(curve).line.box());
    size_ = curves().empty() ? 0.0 : box.diagonal();
  }

  Result<Repaired> run() {
    const double greatest = sketch::RepairOptions::greatest_gap_fraction * size_;
    if (options_.gap.value_or(0.0) > greatest) {
      return dobra::base::Error{dobra::base::ErrorCode::BadValue,
                                fmt::format("`gap` is {:.6g} m, and at most {:.6g} m, 1/10 of the drawing's diagonal, "
                                            "is closed; close wider gaps by hand",
                                            *options_.gap, greatest)};
    }
    for (std::size_t i = 0; i < curves().size();) {
      const bool stays = clean(i);
      if (stays) {
        ++i;
      } else {
        drop(i);
      }
    }
    part_shared_sides(repaired_.sketch, options_.same_point * size_);
    merge_near();
    drop_doubles();
    close_gaps();
    if (!any_loop_closes(repaired_.sketch)) {
      DOBRA_TRY_VOID(cut_at_crossings(repaired_.sketch, options_.same_point * size_));
    }
    const std::set<std::string> without_role = repaired_.sketch.without_role;
    domain::find_roles(repaired_.sketch, domain::DomainOptions{}.join_tolerance * size_);
    DOBRA_TRY(std::vector<sketch::Finding> crossings,
              rebuild_crossings(repaired_.sketch, without_role, options_.same_point * size_));
    DOBRA_TRY(std::vector<sketch::Finding> outside,
              drop_outside(repaired_.sketch, without_role, {.repaired = options_}));
    for (auto* const more : {&crossings, &outside}) {
      repaired_.findings.insert(repaired_.findings.end(), std::make_move_iterator(more->begin()),
                                std::make_move_iterator(more->end()));
    }
    return std::move(repaired_);
  }

 private:
  std::vector<sketch::Curve>& curves() { return repaired_.sketch.curves; }
  Polyline* line(std::size_t i) { return std::get_if<Polyline>(&curves()[i].shape); }
  void found(sketch::Wrong wrong, Point at, std::string curve, std::string mend) {
    repaired_.findings.push_back({wrong, at, std::move(curve), std::move(mend)});
  }
  void drop(std::size_t i) {
    curves().erase(curves().begin() + static_cast<std::ptrdiff_t>(i));
    auto& places = repaired_.sketch.places;
    if (i < places.size()) places.erase(places.begin() + static_cast<std::ptrdiff_t>(i));
  }

  // --- 1, 2 ---------------------------------------------------------------------------------------------------------
  /// False if nothing is left of the curve.
  bool clean(std::size_t i) {
    Polyline* const own = line(i);
    if (own == nullptr) return true;
    const std::string name = curves()[i].name;
    const double least = options_.same_point * size_;
    std::vector<Point> kept;
    for (const Point p : own->points) {
      if (kept.empty() || distance(kept.back(), p) > least) {
        kept.push_back(p);
      } else {
        found(kept.back() == p ? sketch::Wrong::RepeatedPoint : sketch::Wrong::NearlyRepeatedPoint, p, name,
              "one of the two points is left out");
      }
    }
    while (own->closed && kept.size() > 1 && distance(kept.front(), kept.back()) <= least) {
      found(kept.front() == kept.back() ? sketch::Wrong::RepeatedPoint : sketch::Wrong::NearlyRepeatedPoint,
            kept.back(), name, "one of the two points is left out");
      kept.pop_back();
    }
    remove_spikes(kept, own->closed, name);
    own->points = std::move(kept);
    if (own->points.size() >= (own->closed ? 3U : 2U) && !(own->closed && thin(own->points, least))) return true;
    found(sketch::Wrong::NoExtent, own->points.empty() ? Point{} : own->points.front(), name, "the curve is left out");
    return false;
  }

  /// Whether all points lie within `width` of the line from the first to the one farthest from it.
  static bool thin(const std::vector<Point>& points, double width) {
    const Point first = points.front();
    const Point far = *std::max_element(points.begin(), points.end(),
                                        [&](Point a, Point b) { return distance(first, a) < distance(first, b); });
    return std::all_of(points.begin(), points.end(), [&](Point p) {
      return distance(dobra::geom::Segment{first, far}, p) <= width;
    });
  }

  void remove_spikes(std::vector<Point>& points, bool closed, const std::string& name) {
    const double flat = std::cos(options_.spike * std::numbers::pi / 180.0);
    for (std::size_t i = 0; points.size() > 2 && i < points.size();) {
      const std::size_t n = points.size();
      const bool end = !closed && (i == 0 || i + 1 == n);
      const Vector back = points[(i + n - 1) % n] - points[i];
      const Vector ahead = points[(i + 1) % n] - points[i];
      const double lengths = length(back) * length(ahead);
      if (end || (lengths > 0.0 && dot(back, ahead) < flat * lengths)) {
        ++i;
        continue;
      }
      found(lengths > 0.0 ? sketch::Wrong::Spike : sketch::Wrong::RepeatedPoint, points[i], name,
            "its point is left out");
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
      i = i > 0 ? i - 1 : 0;
    }
  }

  /// Boundaries that run so close to each other that nothing fits between become one line there.
  void merge_near() {
    std::vector<Polyline*> lines;
    std::vector<std::size_t> owner;
    for (std::size_t i = 0; i < curves().size(); ++i) {
      if (!bounds(curves()[i]) || line(i) == nullptr || !line(i)->closed) continue;
      lines.push_back(line(i));
      owner.push_back(i);
    }
    for (const sketch::Snap& snap : sketch::snap_together(lines, options_.same_point * size_)) {
      if (snap.gap == 0.0) continue;
      found(sketch::Wrong::Sliver, snap.at, curves()[owner[snap.line]].name + ", " + curves()[owner[snap.other]].name,
            fmt::format("the two curves, {:.3g} m apart there, pass one point", snap.gap));
    }
  }

  // --- 3 ------------------------------------------------------------------------------------------------------------
  void drop_doubles() {
    std::map<sketch::ShapeKey, std::string> known;
    for (std::size_t i = 0; i < curves().size();) {
      const Point start = point(curves()[i], 0.0);
      const auto [first, is_new] = known.try_emplace(shape_key(curves()[i]), curves()[i].name);
      if (is_new) {
        ++i;
        continue;
      }
      found(sketch::Wrong::CurveTwice, start, first->second + ", " + curves()[i].name, "the second is left out");
      drop(i);
    }
  }

  // --- 4 ------------------------------------------------------------------------------------------------------------
  void close_gaps() {
    std::vector<sketch::End> ends = open_ends(curves());
    std::erase_if(ends, [&](const sketch::End& end) { return !bounds(curves()[end.curve]); });
    std::map<Point, int> meeting;
    for (const sketch::End& end : ends) ++meeting[end.at];
    std::erase_if(ends, [&](const sketch::End& end) { return meeting[end.at] > 1; });
    std::vector<std::uint8_t> used(ends.size(), 0);
    for (const auto& [gap, a, b] : near_ends(ends, gap_limit(options_, size_))) {
      if (used[a] != 0 || used[b] != 0) continue;
      used[a] = used[b] = 1;
      // What make_domain joins anyway is no gap.
      if (gap > domain::DomainOptions{}.join_tolerance * size_) join(ends[a], ends[b]);
    }
  }

  void join(const sketch::End& a, const sketch::End& b) {
    const std::string names = curves()[a.curve].name + ", " + curves()[b.curve].name;
    const std::string what = gap_text(curves(), a, b);
    const std::string limit = fmt::format("up to {:.3g} m are closed", gap_limit(options_, size_));
    Polyline* const own = line(b.curve);
    if (a.curve == b.curve && own != nullptr && own->points.size() > 3) {
      own->points.pop_back();
      own->closed = true;
      found(sketch::Wrong::Gap, a.at, names, fmt::format("{}: the ends are joined; gaps {}", what, limit));
      return;
    }
    // A straight curve is moved rather than one that bends.
    const bool b_first = own != nullptr || line(a.curve) == nullptr;
    const sketch::End& first = b_first ? b : a;
    const sketch::End& second = b_first ? a : b;
    const bool moved = move_end(curves()[first.curve], first.last, second.at) ||
                       move_end(curves()[second.curve], second.last, first.at);
    found(sketch::Wrong::Gap, second.at, names,
          moved ? fmt::format("{}: the ends are joined; gaps {}", what, limit)
                : fmt::format("left as it is: {}; gaps {}, but arcs cannot be moved so far: close it by hand", what,
                              limit));
  }

  Repaired repaired_;
  sketch::RepairOptions options_;
  double size_ = 0.0;
};

}  // namespace

Result<Repaired> repair(sketch::Sketch sketch, const sketch::RepairOptions& options) {
  return Repairer(std::move(sketch), options).run();
}

}  // namespace quebra::repair
