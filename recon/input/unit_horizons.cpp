#include "recon/input/unit_horizons.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "recon/input/unit_gaps.h"
#include "recon/input/unit_owners.h"
#include "recon/section/section_faces.h"
#include "shared/geom/place.h"
#include "shared/geom/simplify.h"

namespace recon::input {

using topo::EdgeId;
using topo::HalfEdgeId;
using topo::Structure;
using topo::Subdivision;

namespace {

/// What an edge is for the unit on its right.
enum class Role { None, Top, Turns };  ///< Turns: it goes round the end of the unit within the one beyond.

/// A half-edge on the way round a unit, which lies on its right.
struct Step {
  HalfEdgeId h;
  std::size_t beyond = UnitOwners::nobody;
  bool barrier = false;
  double length = 0.0;
  double right = 0.0;   ///< How far it goes in x ...
  double across = 0.0;  ///< ... and the sum of that without signs.
  Role role = Role::None;
};

struct Loop {
  std::size_t unit = 0;
  std::vector<Step> steps;
};

struct Run {
  std::size_t first = 0;
  std::size_t last = 0;  ///< One behind.
};

struct MadeLine {
  std::string name;
  geom::Polyline line;
};

/// Stretches of steps that are alike, once the loop is turned so that it begins with one.
template <class Alike>
std::vector<Run> runs_of(std::vector<Step>& steps, const Alike& alike) {
  for (std::size_t i = 1; i < steps.size(); ++i) {
    if (alike(steps.front(), steps.back()) && !alike(steps[i - 1], steps[i]))
      std::rotate(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(i), steps.end());
  }
  std::vector<Run> runs;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (i == 0 || !alike(steps[i - 1], steps[i])) runs.push_back({i, i});
    runs.back().last = i + 1;
  }
  return runs;
}

double sum_over(const std::vector<Step>& steps, Run run, double Step::*what) {
  double sum = 0.0;
  for (std::size_t i = run.first; i < run.last; ++i) sum += steps[i].*what;
  return sum;
}

/// A way that goes less than this part of its length in x has no upper side as a whole.
constexpr double least_slant = 0.1;

class Maker {
 public:
  Maker(const UnitOwners& owners, section::Section& section) : owners_(owners), section_(section) {}

  std::vector<MadeLine> run() {
    find_loops();
    for (Loop& loop : loops_) find_barriers(loop);
    for (Loop& loop : loops_) note_barriers(loop);
    for (Loop& loop : loops_) set_roles(loop);
    for (Loop& loop : loops_) fill_short_breaks(loop);
    for (Loop& loop : loops_) make_lines(loop);
    if (short_ > 0) {
      remarks_.push_back(fmt::format("edges between units that are no longer than {:.4g} m become no horizon: {}",
                                     owners_.tolerance(), short_));
    }
    if (stubs_ > 0) {
      remarks_.push_back(
          fmt::format("ends of edges between units turn off ({}) by no more than {:.4g} m, where polygons do not end "
                      "together, and are cut, the first at {}",
                      stubs_, owners_.tolerance(), first_stub_));
    }
    return std::move(made_);
  }
  [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  [[nodiscard]] const Subdivision& sub() const { return owners_.arrangement().subdivision(); }
  [[nodiscard]] std::size_t left_of(HalfEdgeId h) const { return owners_.unit(sub().face(h)); }
  [[nodiscard]] std::size_t right_of(HalfEdgeId h) const { return left_of(Structure::twin(h)); }

  /// The next half-edge round the unit on the right, without leaving it where parts of it meet in a point.
  [[nodiscard]] HalfEdgeId next(HalfEdgeId h) const {
    const std::size_t unit = right_of(h);
    HalfEdgeId e = sub().turned(Structure::twin(h));
    while (left_of(e) == unit) e = sub().turned(e);
    return e;
  }

  void find_loops() {
    std::set<HalfEdgeId> seen;
    for (const EdgeId e : sub().edges()) {
      for (const HalfEdgeId start : {Structure::half_edge(e), Structure::twin(Structure::half_edge(e))}) {
        const std::size_t unit = right_of(start);
        if (unit == UnitOwners::nobody || unit == left_of(start) || seen.contains(start)) continue;
        Loop loop{unit, {}};
        for (HalfEdgeId h = start; seen.insert(h).second; h = next(h)) loop.steps.push_back(step_of(h));
        loops_.push_back(std::move(loop));
      }
    }
  }

  [[nodiscard]] Step step_of(HalfEdgeId h) const {
    Step step{.h = h, .beyond = left_of(h)};
    const std::vector<geom::Point> points = owners_.course(h);
    for (std::size_t i = 1; i < points.size(); ++i) {
      step.length += geom::distance(points[i - 1], points[i]);
      step.across += std::abs(points[i].x - points[i - 1].x);
    }
    step.right = points.back().x - points.front().x;
    return step;
  }

  /// Edges on a fault, and stretches that run beside one. What only comes near it at an end is none.
  void find_barriers(Loop& loop) {
    std::set<HalfEdgeId> near;
    for (const Step& step : loop.steps) {
      const EdgeId edge = Structure::edge(step.h);
      if (owners_.on_barrier(edge)) barriers_.insert(edge);
      if (owners_.on_barrier(edge) || owners_.near_barrier(edge)) near.insert(step.h);
    }
    const auto alike = [&](const Step& a, const Step& b) { return near.contains(a.h) == near.contains(b.h); };
    for (const Run run : runs_of(loop.steps, alike)) {
      if (!near.contains(loop.steps[run.first].h)) continue;
      if (sum_over(loop.steps, run, &Step::length) <= 3.0 * owners_.tolerance()) continue;
      for (std::size_t i = run.first; i < run.last; ++i) barriers_.insert(Structure::edge(loop.steps[i].h));
    }
  }

  void note_barriers(Loop& loop) {
    for (Step& step : loop.steps) {
      step.barrier = barriers_.contains(Structure::edge(step.h));
      if (step.barrier || step.beyond == UnitOwners::nobody) continue;
      Slant& slant = slants_[{loop.unit, step.beyond}];
      slant.right += step.right;
      slant.across += step.across;
    }
  }

  void set_roles(Loop& loop) {
    const auto alike = [](const Step& a, const Step& b) { return a.beyond == b.beyond && a.barrier == b.barrier; };
    for (const Run run : runs_of(loop.steps, alike)) {
      const Step& step = loop.steps[run.first];
      if (step.beyond == UnitOwners::nobody || step.barrier) continue;
      const Role role = role_of(loop, run);
      for (std::size_t i = run.first; i < run.last; ++i) loop.steps[i].role = role;
    }
  }

  /// Over all that two units have in common the one is above the other, or over this stretch, or it turns, or it has no
  /// upper side.
  [[nodiscard]] Role role_of(const Loop& loop, Run run) {
    const Slant all = slants_.at({loop.unit, loop.steps[run.first].beyond});
    if (std::abs(all.right) >= least_slant * all.across && all.across > 0.0)
      return all.right > 0.0 ? Role::Top : Role::None;
    const double right = sum_over(loop.steps, run, &Step::right);
    const double across = sum_over(loop.steps, run, &Step::across);
    if (std::abs(right) >= least_slant * across && across > 0.0) return right > 0.0 ? Role::Top : Role::None;
    const std::vector<geom::Point> points = points_of(loop, run);
    double reach = 0.0;
    for (const geom::Point p : points) reach = std::max(reach, std::abs(p.x - points.front().x));
    if (geom::distance(points.front(), points.back()) <= 2.0 * reach)
      return geom::signed_area({points, true}) < 0.0 ? Role::Turns : Role::None;
    tell_upright(loop.unit, loop.steps[run.first].beyond, points.front());
    return Role::None;
  }

  void tell_upright(std::size_t unit, std::size_t beyond, geom::Point place) {
    if (unit > beyond) return;  // told from the other side
    remarks_.push_back(
        fmt::format("the edge between '{}' and '{}' at {} stands upright: it is the top of neither, and no horizon",
                    owners_.names()[unit], owners_.names()[beyond], place));
  }

  /// A bit of another edge between two tops, no longer than what is untidy.
  void fill_short_breaks(Loop& loop) const {
    const auto alike = [](const Step& a, const Step& b) { return a.role == b.role; };
    const std::vector<Run> runs = runs_of(loop.steps, alike);
    for (std::size_t i = 0; runs.size() > 2 && i < runs.size(); ++i) {
      const Step& before = loop.steps[runs[(i + runs.size() - 1) % runs.size()].first];
      const Step& behind = loop.steps[runs[(i + 1) % runs.size()].first];
      if (loop.steps[runs[i].first].role != Role::None || before.role != Role::Top || behind.role != Role::Top)
        continue;
      if (sum_over(loop.steps, runs[i], &Step::length) > owners_.tolerance()) continue;
      const auto from = loop.steps.begin() + static_cast<std::ptrdiff_t>(runs[i].first);
      const auto to = loop.steps.begin() + static_cast<std::ptrdiff_t>(runs[i].last);
      if (std::any_of(from, to, [](const Step& s) { return s.barrier || s.beyond == UnitOwners::nobody; })) continue;
      std::for_each(from, to, [](Step& s) { s.role = Role::Top; });
    }
  }

  [[nodiscard]] std::vector<geom::Point> points_of(const Loop& loop, Run run) const {
    std::vector<geom::Point> points;
    for (std::size_t i = run.first; i < run.last; ++i) owners_.arrangement().append(loop.steps[i].h, points);
    points.push_back(sub().point(sub().target(loop.steps[run.last - 1].h)));
    return points;
  }

  void make_lines(Loop& loop) {
    const auto alike = [](const Step& a, const Step& b) {
      return a.role == b.role && (a.role != Role::Turns || a.beyond == b.beyond);
    };
    const std::size_t count = loop.steps.size();
    for (const Run run : runs_of(loop.steps, alike)) {
      const Role role = loop.steps[run.first].role;
      if (role == Role::None) continue;
      if (sum_over(loop.steps, run, &Step::length) <= owners_.tolerance()) {
        ++short_;
        continue;
      }
      std::vector<geom::Point> points = points_of(loop, run);
      if (role == Role::Top && run.last - run.first < count) cut_stubs(points);
      if (run.last - run.first < count) {
        if (loop.steps[(run.first + count - 1) % count].barrier) reach_barrier(points, points.begin());
        if (loop.steps[run.last % count].barrier) reach_barrier(points, points.end());
      }
      if (role == Role::Turns) {
        split_at_turns(loop.unit, loop.steps[run.first].beyond, std::move(points));
      } else {
        add_simple(loop.unit, std::move(points));
      }
    }
  }

  /// Where an edge ends beside a gap or an overlap it may turn off along the end of that.
  void cut_stubs(std::vector<geom::Point>& points) {
    for (int end = 0; end < 2; ++end) {
      if (const std::size_t stub = stub_of(points); stub > 0) {
        if (stubs_++ == 0) first_stub_ = points.front();
        points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(stub));
      }
      std::reverse(points.begin(), points.end());
    }
  }

  /// How many points at the start of a line lead, within the tolerance, to a place from where it goes on at more than
  /// 45 degrees to the way there.
  [[nodiscard]] std::size_t stub_of(const std::vector<geom::Point>& points) const {
    const double tolerance = owners_.tolerance();
    std::size_t stub = 0;
    double length = 0.0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      length += geom::distance(points[i - 1], points[i]);
      if (length > tolerance) break;
      std::size_t on = i + 1;
      while (on + 1 < points.size() && geom::distance(points[i], points[on]) < 3.0 * tolerance) ++on;
      const geom::Vector back = points[i] - points.front();
      const geom::Vector ahead = points[on] - points[i];
      if (std::abs(geom::cross(back, ahead)) > geom::dot(back, ahead)) stub = i;
    }
    return stub;
  }

  /// An end that an untidy edge along a fault leaves short of it goes on to the fault, which gets the vertex.
  void reach_barrier(std::vector<geom::Point>& points, std::vector<geom::Point>::iterator where) {
    const geom::Point end = where == points.begin() ? points.front() : points.back();
    double nearest = owners_.tolerance();
    section::SectionLine* barrier = nullptr;
    std::size_t segment = 0;
    for (section::SectionLine& line : section_.lines) {
      if (line.kind != section::LineKind::Fault && line.kind != section::LineKind::Topography) continue;
      for (std::size_t i = 0; i < line.line.segment_count(); ++i) {
        const double d = geom::distance(line.line.segment(i), end);
        if (d < nearest) nearest = d, barrier = &line, segment = i;
      }
    }
    if (barrier == nullptr || nearest == 0.0) return;
    const geom::Segment s = barrier->line.segment(segment);
    const geom::Point on = geom::interpolate(s.from, s.to, geom::nearest_fraction(s, end));
    std::vector<geom::Point>& course = barrier->line.points;
    if (on != s.from && on != s.to) course.insert(course.begin() + static_cast<std::ptrdiff_t>(segment) + 1, on);
    if (on != end) points.insert(where, on);
  }

  /// A line that comes back to a place of its own, where the unit is but a point wide, goes round what lies there.
  void add_simple(std::size_t unit, std::vector<geom::Point> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto again = std::find(points.begin() + static_cast<std::ptrdiff_t>(i) + 1, points.end(), points[i]);
      if (again == points.end()) continue;
      const auto from = points.begin() + static_cast<std::ptrdiff_t>(i);
      add_parts(unit, {from, again + 1});
      points.erase(from + 1, again + 1);
      --i;
    }
    add(owners_.names()[unit], points);
  }

  void split_at_turns(std::size_t unit, std::size_t beyond, std::vector<geom::Point> points) {
    const geom::Point place = add_parts(unit, std::move(points));
    remarks_.push_back(
        fmt::format("unit '{0}' ends within unit '{1}' at ({2:.6g}, {3:.6g}): its edge there is horizon "
                    "'{0}' above and 'base of {0}' below",
                    owners_.names()[unit], owners_.names()[beyond], place.x, place.y));
  }

  /// Parts between the ends of the line and where it reaches farthest: those that run to the right have the unit below.
  /// @return the place of the turn.
  geom::Point add_parts(std::size_t unit, std::vector<geom::Point> points) {
    const auto less = [](geom::Point a, geom::Point b) { return a.x < b.x; };
    if (points.front() == points.back()) {
      points.pop_back();
      std::rotate(points.begin(), std::min_element(points.begin(), points.end(), less), points.end());
      points.push_back(points.front());
    }
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    const double start = points.front().x;
    const auto turn = high->x - start >= start - low->x ? high : low;
    for (const std::vector<geom::Point>& part :
         {std::vector(points.begin(), turn + 1), std::vector(turn, points.end())}) {
      if (part.size() < 2) continue;
      const bool top = part.back().x > part.front().x;
      add((top ? "" : "base of ") + owners_.names()[unit], part);
    }
    return *turn;
  }

  void add(const std::string& name, const std::vector<geom::Point>& points) {
    // Where untidy edges meet, points come so near to each other that they tell no direction.
    geom::Polyline line = geom::without_near_points({points, false}, 1e-3 * owners_.tolerance());
    if (line.points.size() < 2) return;
    if (line.points.front().x > line.points.back().x) line = geom::reversed(std::move(line));
    made_.push_back({name, std::move(line)});
  }

  struct Slant {
    double right = 0.0;
    double across = 0.0;
  };
  const UnitOwners& owners_;
  section::Section& section_;
  std::vector<Loop> loops_;
  std::set<EdgeId> barriers_;
  std::map<std::pair<std::size_t, std::size_t>, Slant> slants_;  ///< Of a unit on the right, and the one beyond.
  std::vector<MadeLine> made_;
  std::vector<std::string> remarks_;
  std::size_t short_ = 0;
  std::size_t stubs_ = 0;  ///< That were cut.
  geom::Point first_stub_;
};

/// Numbered from the left where a name has several lines; from the top of the section down.
std::vector<section::Horizon> horizons_of(std::vector<MadeLine> lines) {
  std::stable_sort(lines.begin(), lines.end(), [](const MadeLine& a, const MadeLine& b) {
    return a.line.box().centre().x < b.line.box().centre().x;
  });
  std::map<std::string, std::size_t> count;
  for (const MadeLine& line : lines) ++count[line.name];
  std::map<std::string, std::size_t> number;
  section::Section alone;
  for (MadeLine& line : lines) {
    section::Horizon horizon{section::HorizonId(), line.name, std::move(line.line), {}, {}};
    if (count[line.name] > 1) {
      horizon.piece_of = line.name;
      horizon.name = fmt::format("{} ({})", line.name, ++number[line.name]);
    }
    alone.horizons.push_back(std::move(horizon));
  }
  std::map<std::string, std::size_t> rank;  // pieces of one stand together
  std::vector<std::pair<std::size_t, section::Horizon>> ranked;
  for (const std::size_t i : stack_order(alone)) {
    const std::size_t own = rank.try_emplace(whole_name(alone.horizons[i]), rank.size()).first->second;
    ranked.emplace_back(own, alone.horizons[i]);
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first, a.second.line.box().centre().x) < std::pair(b.first, b.second.line.box().centre().x);
  });
  std::vector<section::Horizon> horizons;
  for (auto& [order, horizon] : ranked) horizons.push_back(std::move(horizon));
  return horizons;
}

base::Error bad(std::string message, std::string item = "input") {
  return {base::ErrorCode::BadSection, std::move(message), base::Place{.item = std::move(item)}};
}

}  // namespace

base::Result<void> add_horizons_of_units(double tolerance, ReadSection& read) {
  section::Section& section = read.section;
  if (section.units.empty()) return bad("horizons_from_units: the section has no polygon; give some, or leave it out");
  geom::Box box;
  for (const section::Unit& unit : section.units) box.add(unit.contour.box());
  const double bridged = tolerance > 0.0 ? tolerance : 1e-3 * box.diagonal();
  DOBRA_TRY(const UnitOwners owners, UnitOwners::make(section, bridged));
  Maker maker(owners, section);
  std::vector<section::Horizon> horizons = horizons_of(maker.run());
  if (horizons.empty()) {
    return bad(
        fmt::format("horizons_from_units: no two units lie on each other along an edge that is no fault; where "
                    "gaps are wider than {:.4g} m, give share_edges (--edges M){}{}",
                    bridged, owners.remarks().empty() ? "" : "; ", fmt::join(owners.remarks(), "; ")));
  }
  std::vector<std::string> told;
  const std::size_t given = section.horizons.size();
  for (section::Horizon& horizon : horizons) {
    if (const section::Horizon* same = first_piece(section, whole_name(horizon));
        same != nullptr && same->id.index() < given)
      return bad("the top of a unit is a horizon of the same name; change one of them", "horizon '" + same->name + "'");
    told.push_back('\'' + horizon.name + '\'');
    horizon.id = section::HorizonId(section.horizons.size());
    section.horizons.push_back(std::move(horizon));
  }
  const auto add = [&](const std::vector<std::string>& more) {
    read.remarks.insert(read.remarks.end(), more.begin(), more.end());
  };
  add(owners.remarks());
  add(maker.remarks());
  add(wide_gaps(section, bridged));
  read.remarks.push_back(
      fmt::format("horizons made of the edges of units: {}, {}", told.size(), fmt::join(told, ", ")));
  return {};
}

}  // namespace recon::input
