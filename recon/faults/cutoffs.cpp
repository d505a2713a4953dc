#include "recon/faults/cutoffs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "recon/faults/pairing.h"
#include "shared/base/parallel.h"
#include "shared/geom/intersect.h"
#include "shared/geom/place.h"

namespace recon::faults {

namespace {

using kinematics::Wall;
using section::LineEnd;

std::string text_at(geom::Point p) { return fmt::format("{}", p); }

/// A piece of a horizon with vertices where it meets a fault.
struct Vertex {
  geom::Point at;
  double along = 0.0;        ///< The piece, m.
  std::optional<Wall> wall;  ///< Nothing on the fault.
};

/// A stretch of the piece on the fault, by its vertices; a single one where it crosses.
struct Meeting {
  std::size_t first = 0, last = 0;
  std::optional<Wall> before, behind;
};

/// One fault against all horizons.
class Cutter {
 public:
  Cutter(const section::Section& section, const std::vector<Fault>& faults, std::size_t fault, double tolerance)
      : section_(section), faults_(faults), fault_(faults[fault]), own_(own_line(fault_)), tolerance_(tolerance) {
    for (const section::Horizon& horizon : section.horizons) box_.add(horizon.line.box());
    rounding_ = 1e-9 * box_of(section).diagonal();
    told_ = 1e-6 * box_of(section).diagonal();
    made_.fault = fault_.name;
  }

  FaultCutoffs run() {
    if (fault_.undecided) {
      made_.remarks.push_back(fmt::format("fault '{}': {}", fault_.name, fault_.undecided->message));
      return std::move(made_);
    }
    for (const section::Horizon& horizon : section_.horizons) cut(horizon);
    ExpectedSeparation expected;
    for (auto& [name, walls] : found_) {
      sort(walls);
      expected.learn_from(walls);
    }
    for (const auto& [name, walls] : found_) pair(name, walls, expected);
    std::stable_sort(made_.pairs.begin(), made_.pairs.end(),
                     [](const CutoffPair& a, const CutoffPair& b) { return a.distance < b.distance; });
    find_sense();
    return std::move(made_);
  }

 private:
  WallCutoffs& walls_of(const section::Horizon& horizon) {
    const std::string& name = whole_name(horizon);
    const auto at = std::find_if(found_.begin(), found_.end(), [&](const auto& f) { return f.first == name; });
    return at != found_.end() ? at->second : found_.emplace_back(name, WallCutoffs()).second;
  }

  void add(const section::Horizon& horizon, Wall wall, geom::Point at, LineEnd end, double extended, bool passes) {
    WallCutoffs& walls = walls_of(horizon);
    const double arc = kinematics::nearest(fault_.path, at).arc;
    (wall == Wall::Hanging ? walls.hanging : walls.foot).push_back({horizon.id, end, at, arc, extended, passes});
    if (std::abs(extended) <= told_) return;
    made_.remarks.push_back(fmt::format("horizon '{}' is {} by {:.4g} m to fault '{}' at {}", horizon.name,
                                        extended > 0.0 ? "extended" : "trimmed", std::abs(extended), fault_.name,
                                        text_at(at)));
  }

  void cut(const section::Horizon& horizon) {
    if (!horizon.line.box().overlaps(own_.box().grown(10.0 * tolerance_))) return;
    const std::vector<Vertex> line = refined(horizon.line);
    const std::vector<Meeting> meetings = meetings_of(line);
    const double length = line.back().along;
    std::optional<Meeting> at_first, at_last;  // what is to be trimmed behind: the innermost of each end
    const double from_first = overshoot_of(line.front());
    const double from_last = overshoot_of(line.back());
    for (const Meeting& m : meetings) {
      if (line[m.last].along <= from_first) at_first = m;
      if (length - line[m.first].along <= from_last && !at_last && !(at_first && at_first->first == m.first))
        at_last = m;
    }
    for (const Meeting& m : meetings) {
      const bool trims = line[m.last].along <= from_first || length - line[m.first].along <= from_last;
      if (!trims) cross(horizon, line, m);
    }
    // Of a piece that is hardly longer than the tolerance only the nearer end is the fault's.
    const bool stub = length <= 2.0 * tolerance_;
    const bool first_is_nearer = geom::distance(own_, line.front().at) <= geom::distance(own_, line.back().at);
    if (!stub || first_is_nearer) end(horizon, line, at_first, LineEnd::First, !meetings.empty());
    if (!stub || !first_is_nearer) end(horizon, line, at_last, LineEnd::Last, !meetings.empty());
  }

  /// How far from its end a line may meet the fault and still end there. An end that is as near to the fault as the
  /// tolerance may have run past it by more, at a low angle.
  [[nodiscard]] double overshoot_of(const Vertex& end) const {
    return geom::distance(own_, end.at) <= tolerance_ ? 5.0 * tolerance_ : tolerance_;
  }

  /// The line itself, with vertices where it meets the fault and in the middle between two of these.
  [[nodiscard]] std::vector<Vertex> refined(const geom::Polyline& line) const {
    std::vector<geom::Point> points;
    std::vector<bool> far;  // so that nobody asks for its wall
    const geom::Box reach = own_.box().grown(rounding_);
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
      const geom::Segment segment = line.segment(i);
      const bool meets = segment.box().overlaps(reach);
      std::vector<geom::Point> hits{segment.from, segment.to};
      for (std::size_t k = 0; k < own_.segment_count() && meets; ++k) {
        const geom::Intersection hit = geom::intersect(segment, own_.segment(k));
        if (hit.kind != geom::IntersectionKind::None) hits.push_back(hit.start.point);
        if (hit.kind == geom::IntersectionKind::Overlap) hits.push_back(hit.end.point);
      }
      geom::sort_along(segment, hits);
      for (std::size_t k = 0; k + 1 < hits.size(); ++k) {
        points.push_back(hits[k]);
        far.push_back(!meets && i > 0 && !line.segment(i - 1).box().overlaps(reach));
        if (hits.size() == 2) continue;
        points.push_back(geom::midpoint(hits[k], hits[k + 1]));
        far.push_back(false);
      }
    }
    points.push_back(line.points.back());
    far.push_back(false);
    std::vector<Vertex> vertices;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const geom::Point p = points[i];
      const double step = vertices.empty() ? 0.0 : geom::distance(vertices.back().at, p);
      const double before = vertices.empty() ? 0.0 : vertices.back().along;
      const double off = far[i] ? rounding_ : kinematics::nearest(fault_.path, p).distance;
      const bool on = !far[i] && std::abs(off) <= rounding_;
      vertices.push_back({p, before + step, on ? std::nullopt : std::optional(off > 0.0 ? Wall::Hanging : Wall::Foot)});
    }
    return vertices;
  }

  /// Where the line is on the own part of the fault.
  [[nodiscard]] std::vector<Meeting> meetings_of(const std::vector<Vertex>& line) const {
    std::vector<Meeting> meetings;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i].wall || geom::distance(own_, line[i].at) > rounding_) continue;
      Meeting m{i, i, {}, {}};
      while (m.last + 1 < line.size() && !line[m.last + 1].wall) ++m.last;
      if (m.first > 0) m.before = line[m.first - 1].wall;
      if (m.last + 1 < line.size()) m.behind = line[m.last + 1].wall;
      i = m.last;
      meetings.push_back(m);
    }
    return meetings;
  }

  /// The line passes the fault away from its ends: uncut, or drawn along it from one wall to the other.
  void cross(const section::Horizon& horizon, const std::vector<Vertex>& line, const Meeting& m) {
    if (!m.before || !m.behind || *m.before == *m.behind) return;
    const geom::Point from = line[m.first].at;
    const geom::Point to = line[m.last].at;
    const bool along = geom::distance(from, to) > rounding_;
    add(horizon, *m.before, from, LineEnd::Last, 0.0, !along);
    add(horizon, *m.behind, to, LineEnd::First, 0.0, !along);
    if (along) return;
    made_.remarks.push_back(fmt::format("horizon '{}' crosses fault '{}' at {} without being cut", horizon.name,
                                        fault_.name, text_at(from)));
  }

  /// An end of the line: at the fault, past it by no more than the tolerance, or short of it.
  /// @param crossed  whether the line crosses the fault farther from its end than that.
  void end(const section::Horizon& horizon, const std::vector<Vertex>& line, const std::optional<Meeting>& passed,
           LineEnd which, bool crossed) {
    const bool first = which == LineEnd::First;
    if (passed) {
      const std::size_t inner = first ? passed->last : passed->first;
      const auto wall = first ? passed->behind : passed->before;
      const double beyond = first ? line[inner].along : line.back().along - line[inner].along;
      if (wall) add(horizon, *wall, line[inner].at, which, beyond > 0.0 ? -beyond : 0.0, false);
      return;
    }
    const Vertex& tip = first ? line.front() : line.back();
    const double gap = geom::distance(own_, tip.at);
    if (!tip.wall || gap > 10.0 * tolerance_ || !is_nearest(tip.at, gap)) return;
    if (gap > tolerance_ && crossed) return;  // told where it crosses
    if (gap > tolerance_) {
      if (tip.at.x <= box_.low.x + tolerance_ || tip.at.x >= box_.high.x - tolerance_) return;  // the section's end
      if (goes_on(horizon, tip, gap)) return;
      const std::string advice =
          std::ceil(gap) < 0.5 * distance_to_other_beds(horizon, tip.at)
              ? fmt::format("tolerance = {:.4g} (--tolerance) takes it to the fault", std::ceil(gap))
              : "draw it to the fault; other beds lie too near for a tolerance that reaches so far";
      made_.remarks.push_back(fmt::format("horizon '{}' stops {:.4g} m short of fault '{}' at {}; {}", horizon.name,
                                          std::ceil(gap), fault_.name, text_at(tip.at), advice));
      return;
    }
    const geom::Point before = first ? line[1].at : line[line.size() - 2].at;
    const geom::Point at = reached(before, tip.at);
    add(horizon, *tip.wall, at, which, geom::distance(tip.at, at), false);
  }

  /// Whether another piece of the bed begins nearer than the fault is, on the same wall: a gap in the bed.
  [[nodiscard]] bool goes_on(const section::Horizon& horizon, const Vertex& tip, double gap) const {
    return std::any_of(section_.horizons.begin(), section_.horizons.end(), [&](const section::Horizon& other) {
      if (&other == &horizon || whole_name(other) != whole_name(horizon)) return false;
      const auto follows = [&](geom::Point p) {
        return geom::distance(p, tip.at) < gap && kinematics::wall_of(fault_.path, p) == tip.wall;
      };
      return follows(other.line.points.front()) || follows(other.line.points.back());
    });
  }

  [[nodiscard]] double distance_to_other_beds(const section::Horizon& horizon, geom::Point p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const section::Horizon& other : section_.horizons) {
      if (whole_name(other) != whole_name(horizon)) least = std::min(least, geom::distance(other.line, p));
    }
    return least;
  }

  /// Of several faults the nearest takes an end.
  [[nodiscard]] bool is_nearest(geom::Point p, double gap) const {
    return std::all_of(faults_.begin(), faults_.end(), [&](const Fault& other) {
      return &other == &fault_ || geom::distance(own_line(other), p) >= gap;
    });
  }

  /// Where a line that goes on straight meets the fault, or, if not nearby, the nearest point of that.
  [[nodiscard]] geom::Point reached(geom::Point before, geom::Point tip) const {
    const geom::Point far = tip + 3.0 * tolerance_ * geom::normalised(tip - before);
    std::optional<geom::Point> best;
    for (std::size_t k = 0; k < own_.segment_count(); ++k) {
      const geom::Intersection hit = geom::intersect({tip, far}, own_.segment(k));
      if (hit.kind == geom::IntersectionKind::None) continue;
      if (!best || geom::distance(tip, hit.start.point) < geom::distance(tip, *best)) best = hit.start.point;
    }
    if (best) return *best;
    const double arc = kinematics::nearest(fault_.path, tip).arc;
    return kinematics::point_at(fault_.path, std::clamp(arc, fault_.own_from, fault_.own_to));
  }

  /// From the higher end down.
  static void sort(WallCutoffs& walls) {
    for (std::vector<Cutoff>* cutoffs : {&walls.hanging, &walls.foot})
      std::stable_sort(cutoffs->begin(), cutoffs->end(),
                       [](const Cutoff& a, const Cutoff& b) { return a.arc > b.arc; });
  }

  void pair(const std::string& horizon, const WallCutoffs& walls, const ExpectedSeparation& expected) {
    for (const auto& [hanging, foot] : partners_of(walls, expected))
      made_.pairs.push_back(measured(horizon, hanging, foot));
    tell_several(horizon, walls);
  }

  void tell_several(const std::string& horizon, const WallCutoffs& walls) {
    for (const auto& [name, cutoffs] : {std::pair("hanging wall", &walls.hanging), {"footwall", &walls.foot}}) {
      if (cutoffs->size() < 2) continue;
      std::string places;
      for (const Cutoff& c : *cutoffs) places += (places.empty() ? "" : ", ") + text_at(c.at);
      made_.remarks.push_back(
          fmt::format("horizon '{}' has {} cutoffs on the {} of fault '{}', paired in order from "
                      "above: {}",
                      horizon, cutoffs->size(), name, fault_.name, places));
    }
  }

  CutoffPair measured(const std::string& horizon, const std::optional<Cutoff>& hw, const std::optional<Cutoff>& fw) {
    CutoffPair pair;
    pair.horizon = horizon;
    pair.hanging_wall = hw;
    pair.footwall = fw;
    if (!hw || !fw) {
      const Cutoff& only = hw ? *hw : *fw;
      pair.distance = fault_.own_to - only.arc;
      made_.remarks.push_back(partner_missing(pair, fault_.name));
      return pair;
    }
    pair.distance = fault_.own_to - 0.5 * (hw->arc + fw->arc);
    pair.separation = fw->arc - hw->arc;
    pair.throw_ = fw->at.y - hw->at.y;
    pair.heave = opening() * (hw->at.x - fw->at.x) + 0.0;  // no -0
    pair.gap = std::max(*pair.heave, 0.0);
    pair.overlap = std::max(-*pair.heave, 0.0);
    return pair;
  }

  /// The sign of the x towards which a hanging wall goes that comes down.
  [[nodiscard]] double opening() const {
    const double down = own_.points.front().x - own_.points.back().x;
    if (std::abs(down) > rounding_) return down > 0.0 ? 1.0 : -1.0;
    return fault_.path.hanging == kinematics::Side::Right ? 1.0 : -1.0;
  }

  void find_sense() {
    double sum = 0.0, greatest = 0.0;
    for (const CutoffPair& pair : made_.pairs) {
      if (!pair.separation) continue;
      sum += *pair.separation;
      greatest = std::max(greatest, std::abs(*pair.separation));
      made_.sense = Sense::None;
    }
    if (made_.sense == Sense::Unknown || greatest <= told_) return;
    made_.sense = sum > 0.0 ? Sense::Normal : Sense::Reverse;
  }

  const section::Section& section_;
  const std::vector<Fault>& faults_;
  const Fault& fault_;
  geom::Polyline own_;
  double tolerance_;
  geom::Box box_;          ///< Of all horizons.
  double rounding_ = 0.0;  ///< What is no farther off lies on the fault, m.
  double told_ = 0.0;      ///< Ends that are moved by less are the rounding of files, m.
  std::vector<std::pair<std::string, WallCutoffs>> found_;
  FaultCutoffs made_;
};

}  // namespace

FaultCutoffs cutoffs_at(const section::Section& section, const std::vector<Fault>& faults, std::size_t which,
                        const FaultOptions& options) {
  return Cutter(section, faults, which, tolerance_of(section, options)).run();
}

std::vector<FaultCutoffs> cutoffs_of(const section::Section& section, const std::vector<Fault>& faults,
                                     const FaultOptions& options) {
  return base::parallel_map<FaultCutoffs>(faults.size(),
                                          [&](std::size_t i) { return cutoffs_at(section, faults, i, options); });
}

std::string partner_missing(const CutoffPair& pair, const std::string& fault) {
  const Cutoff& only = pair.hanging_wall ? *pair.hanging_wall : *pair.footwall;
  return fmt::format("horizon '{}' has no cutoff on the {} of fault '{}' for the one at {}", pair.horizon,
                     pair.hanging_wall ? "footwall" : "hanging wall", fault, text_at(only.at));
}

namespace {

/// Lengthens or trims a line to a cutoff, and a little past the fault, whose course is rounded.
void reach(const Cutoff& cutoff, double past, geom::Polyline& line) {
  const bool first = cutoff.end == LineEnd::First;
  if (first) line = geom::reversed(std::move(line));
  std::vector<geom::Point>& points = line.points;
  double over = -cutoff.extended;
  while (over > 0.0 && points.size() > 2 && geom::distance(points[points.size() - 2], points.back()) <= over) {
    over -= geom::distance(points[points.size() - 2], points.back());
    points.pop_back();
  }
  const geom::Point before = points[points.size() - 2];
  const double end = geom::distance(points.back(), cutoff.at);  // of rounding, it gives no direction
  const bool replaced = cutoff.extended < 0.0 || end <= 1e-6 * geom::distance(before, points.back());
  const geom::Point inner = replaced ? before : points.back();
  const geom::Vector way = cutoff.at - inner;
  if (replaced) points.pop_back();
  points.push_back(geom::length(way) > 0.0 ? cutoff.at + past * geom::normalised(way) : cutoff.at);
  if (first) line = geom::reversed(std::move(line));
}

}  // namespace

void reach_faults(const std::vector<FaultCutoffs>& cutoffs, double past, section::Horizon& horizon) {
  for (const FaultCutoffs& of_fault : cutoffs) {
    for (const CutoffPair& pair : of_fault.pairs) {
      for (const std::optional<Cutoff>& cutoff : {pair.hanging_wall, pair.footwall}) {
        if (cutoff && !cutoff->passes && cutoff->extended != 0.0 && cutoff->piece == horizon.id)
          reach(*cutoff, past, horizon.line);
      }
    }
  }
}

}  // namespace recon::faults
