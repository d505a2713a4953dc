#include "recon/faults/fault.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "recon/faults/outline.h"
#include "recon/section/crossings.h"
#include "shared/base/text.h"
#include "shared/geom/intersect.h"
#include "shared/geom/place.h"

namespace recon::faults {

namespace {

using kinematics::Side;

base::Error refusal(const Fault& fault, geom::Point at, std::string message) {
  return {base::ErrorCode::BadSection, std::move(message), geom::place_at(at, fmt::format("fault '{}'", fault.name))};
}

/// Two lines end to end, if ends of them are within the tolerance.
std::optional<geom::Polyline> joined(geom::Polyline a, geom::Polyline b, double tolerance) {
  const auto gap = [](const geom::Polyline& p, const geom::Polyline& q) {
    return geom::distance(p.points.back(), q.points.front());
  };
  double least = tolerance;
  std::optional<geom::Polyline> best;
  for (const bool turn_a : {false, true}) {
    for (const bool turn_b : {false, true}) {
      geom::Polyline first = turn_a ? geom::reversed(a) : a;
      const geom::Polyline second = turn_b ? geom::reversed(b) : b;
      if (gap(first, second) > least) continue;
      least = gap(first, second);
      first.points.insert(first.points.end(), second.points.begin(), second.points.end());
      best = geom::without_repeated_points(std::move(first));
    }
  }
  return best;
}

struct Drawn {
  std::vector<const section::SectionLine*> pieces;
  geom::Polyline line;
};

/// The pieces of one fault, those that meet joined.
std::vector<Drawn> joined_pieces(const std::vector<const section::SectionLine*>& pieces, double tolerance) {
  std::vector<Drawn> drawn;
  for (const auto* piece : pieces) drawn.push_back({{piece}, piece->line});
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    for (std::size_t j = i + 1; j < drawn.size();) {
      auto line = joined(drawn[i].line, drawn[j].line, tolerance);
      if (!line) {
        ++j;
        continue;
      }
      drawn[i].line = std::move(*line);
      drawn[i].pieces.insert(drawn[i].pieces.end(), drawn[j].pieces.begin(), drawn[j].pieces.end());
      drawn.erase(drawn.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;
    }
  }
  return drawn;
}

/// The line from its lower end to its higher one, from -x to +x where they are equally high.
kinematics::FaultPath path_of(geom::Polyline line) {
  kinematics::FaultPath path{std::move(line)};
  const geom::Vector chord = path.line.points.back() - path.line.points.front();
  path.level = std::abs(chord.y) <= 1e-9 * geom::length(chord);
  if (path.level ? chord.x < 0.0 : chord.y < 0.0) path.line = geom::reversed(std::move(path.line));
  return path;
}

Side opposite(Side side) { return side == Side::Left ? Side::Right : Side::Left; }

/// Sets the side of the hanging wall. @pre the path is the own line.
base::Result<void> find_hanging_wall(section::HangingWall said, Fault& fault) {
  const geom::Point low = fault.path.line.points.front();
  const geom::Point high = fault.path.line.points.back();
  const geom::Vector chord = high - low;
  const bool upright = std::abs(chord.x) <= 1e-9 * geom::length(chord);
  const Side above = chord.x > 0.0 ? Side::Left : Side::Right;
  using Wall = section::HangingWall;
  if (said == Wall::Left || said == Wall::Right) {
    if (fault.path.level) {
      return refusal(fault, low,
                     fmt::format("its ends are equally high, so that no wall lies to its {}; say hanging_wall = "
                                 "\"above\" or \"below\"",
                                 section::hanging_wall_name(said)));
    }
    fault.path.hanging = said == Wall::Left ? Side::Left : Side::Right;
    return {};
  }
  if (upright && said != Wall::Auto) {
    return refusal(fault, low,
                   fmt::format("it stands upright, so that no wall lies {} it; say hanging_wall = \"left\" or "
                               "\"right\"",
                               section::hanging_wall_name(said)));
  }
  fault.path.hanging = said == Wall::Below ? opposite(above) : above;
  if (upright) {
    fault.undecided = refusal(fault, geom::midpoint(low, high),
                              "the fault stands upright, so that neither wall lies above the other; say hanging_wall = "
                              "\"left\" or \"right\" in its [[input.fault]]");
  }
  return {};
}

/// What has two sides does not cross itself.
base::Result<void> check_simple(const Fault& fault) {
  const std::vector<section::SelfCrossing> crossings = section::self_crossings(fault.path.line);
  if (crossings.empty()) return {};
  return refusal(
      fault, crossings.front().place,
      fmt::format("the fault crosses itself or runs back on itself (places: {}), so that it has no two walls; "
                  "take the loop out of the line, or give its parts two names if they are two faults",
                  crossings.size()));
}

base::Result<std::vector<Fault>> drawn_faults(const section::Section& section, double tolerance) {
  std::vector<std::pair<std::string, std::vector<const section::SectionLine*>>> wholes;
  for (const section::SectionLine& line : section.lines) {
    if (line.kind != section::LineKind::Fault) continue;
    const std::string& name = whole_name(line);
    auto found = std::find_if(wholes.begin(), wholes.end(), [&](const auto& whole) { return whole.first == name; });
    if (found == wholes.end()) found = wholes.insert(found, {name, {}});
    found->second.push_back(&line);
  }
  std::vector<Fault> faults;
  for (const auto& [whole, pieces] : wholes) {
    std::vector<Drawn> drawn = joined_pieces(pieces, tolerance);
    for (Drawn& one : drawn) {
      Fault fault;
      fault.whole = whole;
      fault.name = drawn.size() == 1 ? whole : one.pieces.front()->name;
      fault.order = one.pieces.front()->order;
      fault.path = path_of(std::move(one.line));
      fault.own_to = geom::length(fault.path.line);
      for (const auto* piece : one.pieces) fault.pieces.push_back(piece->id);
      DOBRA_TRY_VOID(check_simple(fault));
      DOBRA_TRY_VOID(find_hanging_wall(one.pieces.front()->hanging_wall, fault));
      faults.push_back(std::move(fault));
    }
  }
  const auto age = [](const Fault& f) { return f.order > 0 ? f.order : std::numeric_limits<int>::max(); };
  std::stable_sort(faults.begin(), faults.end(), [&](const Fault& a, const Fault& b) { return age(a) < age(b); });
  return faults;
}

bool in_rock(const std::vector<geom::Polyline>& outline, geom::Point p, double deeper) {
  bool inside = false;
  for (const geom::Polyline& ring : outline) {
    if (geom::distance(ring, p) <= deeper) return false;
    if (geom::locate(ring, p) == geom::Side::Inside) inside = !inside;
  }
  return inside;
}

/// Finds what each end is, before any path goes on along another one.
class Ends {
 public:
  Ends(const section::Section& section, const std::vector<Fault>& faults, const std::vector<geom::Polyline>& outline,
       double tolerance)
      : section_(section), faults_(faults), outline_(outline), tolerance_(tolerance) {}

  [[nodiscard]] FaultEnd of(const Fault& fault, geom::Point end) const {
    const bool rock = in_rock(outline_, end, tolerance_) ? !at_section_end(fault, end) : leads_into_rock(fault, end);
    FaultEnd found{rock ? EndKind::Tip : EndKind::Border, end, {}, 0.0};
    double least = tolerance_;
    for (const Fault& other : faults_) {
      if (&other == &fault) continue;
      const auto on = kinematics::nearest(other.path, end);
      const geom::Point at = kinematics::point_at(other.path, std::clamp(on.arc, 0.0, other.own_to));
      // Two ends side by side at the border are no junction.
      const bool inner = on.arc > 0.0 && on.arc < other.own_to;
      const double gap = geom::distance(at, end);
      if (gap > least || (!rock && !inner)) continue;
      least = gap;
      found = {is_cut_by(fault, other) ? EndKind::Cut : EndKind::Branch, at, other.name, gap};
    }
    return found;
  }

 private:
  /// Whether another piece of it goes on behind the other one, or the ages say that the other is younger.
  [[nodiscard]] bool is_cut_by(const Fault& fault, const Fault& other) const {
    if (fault.order > 0 && other.order > 0 && fault.order > other.order) return true;
    return std::any_of(faults_.begin(), faults_.end(), [&](const Fault& piece) {
      if (&piece == &fault || piece.whole != fault.whole || other.whole == fault.whole) return false;
      const auto wall = kinematics::wall_of(
          other.path, geom::midpoint(piece.path.line.points.front(), piece.path.line.points.back()));
      const auto own = kinematics::wall_of(
          other.path, geom::midpoint(fault.path.line.points.front(), fault.path.line.points.back()));
      return wall && own && *wall != *own;
    });
  }

  /// Whether a fault that ends outside the rock would enter it if it went on, and has not been in it: one that ends
  /// below the lowest bed.
  [[nodiscard]] bool leads_into_rock(const Fault& fault, geom::Point end) const {
    const std::vector<geom::Point>& points = fault.path.line.points;
    const geom::Point inner = end == points.front() ? points[1] : points[points.size() - 2];
    const geom::Segment ahead{end, end + box_of(section_).diagonal() * geom::normalised(end - inner)};
    const auto outside = [&](const geom::Polyline& ring) { return geom::locate(ring, end) == geom::Side::Outside; };
    if (!std::all_of(outline_.begin(), outline_.end(), outside)) return false;
    const auto meets = [&](const geom::Segment& side) {
      for (const geom::Polyline& ring : outline_) {
        for (std::size_t i = 0; i < ring.segment_count(); ++i) {
          if (geom::intersect(side, ring.segment(i)).kind != geom::IntersectionKind::None) return true;
        }
      }
      return false;
    };
    for (std::size_t i = 0; i < fault.path.line.segment_count(); ++i) {
      if (meets(fault.path.line.segment(i))) return false;
    }
    return meets(ahead);
  }
  /// Whether the fault leaves through the section's end that its slip has moved on one wall: without a border the rock
  /// ends there with a straight side from one wall to the other, which leans over the fault's end.
  [[nodiscard]] bool at_section_end(const Fault& fault, geom::Point end) const {
    if (section_.border) return false;
    const std::vector<geom::Point>& points = fault.path.line.points;
    const geom::Point inner = end == points.front() ? points[1] : points[points.size() - 2];
    const geom::Vector way = geom::normalised(end - inner);
    const geom::Segment ahead{end, end + box_of(section_).diagonal() * way};
    std::optional<geom::Segment> side;
    double nearest = std::numeric_limits<double>::infinity();
    for (const geom::Polyline& ring : outline_) {
      for (std::size_t i = 0; i < ring.segment_count(); ++i) {
        const geom::Intersection hit = geom::intersect(ahead, ring.segment(i));
        if (hit.kind == geom::IntersectionKind::None || geom::distance(hit.start.point, end) >= nearest) continue;
        nearest = geom::distance(hit.start.point, end);
        side = ring.segment(i);
      }
    }
    if (!side || !joins_ends(*side)) return false;
    const auto wall = kinematics::wall_of(fault.path, side->from);
    const auto other = kinematics::wall_of(fault.path, side->to);
    const double least = std::min(geom::dot(side->from - end, way), geom::dot(side->to - end, way));
    return wall && other && *wall != *other && least <= tolerance_;
  }
  /// No part of a horizon, but from the end of one to that of another.
  [[nodiscard]] bool joins_ends(const geom::Segment& side) const {
    const auto ends_there = [&](geom::Point p) {
      return std::any_of(section_.horizons.begin(), section_.horizons.end(), [&](const section::Horizon& h) {
        return std::min(geom::distance(h.line.points.front(), p), geom::distance(h.line.points.back(), p)) <=
               tolerance_;
      });
    };
    const geom::Point middle = geom::midpoint(side.from, side.to);
    const double near = 1e-9 * box_of(section_).diagonal();
    return ends_there(side.from) && ends_there(side.to) &&
           std::none_of(section_.horizons.begin(), section_.horizons.end(),
                        [&](const section::Horizon& h) { return geom::distance(h.line, middle) <= near; });
  }

  const section::Section& section_;
  const std::vector<Fault>& faults_;
  const std::vector<geom::Polyline>& outline_;
  double tolerance_;
};

base::Result<void> check_ages(const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    for (const FaultEnd& end : {fault.lower, fault.upper}) {
      if (end.kind != EndKind::Cut) continue;
      const auto other = std::find_if(faults.begin(), faults.end(), [&](const Fault& f) { return f.name == end.on; });
      if (fault.order == 0 || other->order == 0 || other->order < fault.order) continue;
      return refusal(*other, end.at,
                     fmt::format("it cuts '{}' in two, but its order {} says that it is not younger than that ({}); "
                                 "correct order, of which 1 is the youngest",
                                 fault.whole, other->order, fault.order));
    }
  }
  return {};
}

/// What of another path lies beyond a point on it, in the direction of least turn; empty where it would turn back.
std::vector<geom::Point> beyond(const kinematics::FaultPath& other, geom::Point at, geom::Vector way) {
  const double arc = kinematics::nearest(other, at).arc;
  const std::vector<double> arcs = geom::arc_lengths(other.line);
  std::vector<geom::Point> up, down;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (arcs[i] > arc) up.push_back(other.line.points[i]);
    if (arcs[i] < arc) down.insert(down.begin(), other.line.points[i]);
  }
  const auto advance = [&](const std::vector<geom::Point>& points) {
    return points.empty() || points.front() == at ? 0.0 : geom::dot(geom::normalised(points.front() - at), way);
  };
  const std::vector<geom::Point>& taken = advance(up) >= advance(down) ? up : down;
  return advance(taken) > 0.0 ? taken : std::vector<geom::Point>();
}

/// Lets paths go on along what they join.
class Branches {
 public:
  explicit Branches(std::vector<Fault>& faults) : faults_(faults), whole_(faults.size()), state_(faults.size()) {}

  void go_on() {
    for (std::size_t i = 0; i < faults_.size(); ++i) visit(i);
    for (std::size_t i = 0; i < faults_.size(); ++i) faults_[i] = std::move(whole_[i]);
  }

 private:
  enum class State { New, Open, Done };

  const Fault& visit(std::size_t i) {
    if (state_[i] != State::New) return state_[i] == State::Done ? whole_[i] : faults_[i];
    state_[i] = State::Open;
    Fault made = faults_[i];
    std::vector<geom::Point>& points = made.path.line.points;
    if (made.upper.kind == EndKind::Branch) {
      const auto more = path_beyond(made.upper, points[points.size() - 2], points.back());
      points.insert(points.end(), more.begin(), more.end());
    }
    if (made.lower.kind == EndKind::Branch) {
      auto more = path_beyond(made.lower, points[1], points.front());
      std::reverse(more.begin(), more.end());
      points.insert(points.begin(), more.begin(), more.end());
      for (std::size_t k = 0; k < more.size(); ++k) made.own_from += geom::distance(points[k], points[k + 1]);
      made.own_to += made.own_from;
    }
    whole_[i] = std::move(made);
    state_[i] = State::Done;
    return whole_[i];
  }

  std::vector<geom::Point> path_beyond(const FaultEnd& end, geom::Point inner, geom::Point last) {
    const auto parent = std::find_if(faults_.begin(), faults_.end(), [&](const Fault& f) { return f.name == end.on; });
    const Fault& other = visit(static_cast<std::size_t>(parent - faults_.begin()));
    std::vector<geom::Point> more = beyond(other.path, end.at, geom::normalised(last - inner));
    if (end.at != last && !more.empty() && end.at != more.front()) more.insert(more.begin(), end.at);
    return more;
  }

  std::vector<Fault>& faults_;
  std::vector<Fault> whole_;
  std::vector<State> state_;
};

}  // namespace

const char* name_of(Sense sense) {
  constexpr std::array<const char*, 4> names{"unknown", "none", "normal", "reverse"};
  return names[static_cast<std::size_t>(sense)];
}

const char* name_of(EndKind kind) {
  constexpr std::array<const char*, 4> names{"border", "tip", "branch", "cut"};
  return names[static_cast<std::size_t>(kind)];
}

double tolerance_of(const section::Section& section, const FaultOptions& options) {
  return options.tolerance > 0.0 ? options.tolerance : 0.005 * box_of(section).diagonal();
}

std::optional<std::string> remark_on_taken_tip(const Fault& fault, geom::Point end) {
  if (fault.path.tip_at_begin || fault.path.tip_at_end) return std::nullopt;
  return fmt::format("fault '{}' leaves the section at {}; that end is taken for its tip", fault.name, end);
}

geom::Polyline own_line(const Fault& fault) {
  const std::vector<double> arcs = geom::arc_lengths(fault.path.line);
  const double rounding = 1e-12 * arcs.back();
  geom::Polyline own;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (arcs[i] >= fault.own_from - rounding && arcs[i] <= fault.own_to + rounding)
      own.points.push_back(fault.path.line.points[i]);
  }
  return own;
}

base::Result<std::vector<Fault>> faults_of(const section::Section& section, const FaultOptions& options) {
  const double tolerance = tolerance_of(section, options);
  DOBRA_TRY(std::vector<Fault> faults, drawn_faults(section, tolerance));
  DOBRA_TRY(const Outline outline, outline_of(section, faults, options));
  const Ends ends(section, faults, outline.rings, tolerance);
  std::vector<std::pair<FaultEnd, FaultEnd>> found;
  for (const Fault& fault : faults)
    found.emplace_back(ends.of(fault, fault.path.line.points.front()), ends.of(fault, fault.path.line.points.back()));
  for (std::size_t i = 0; i < faults.size(); ++i) {
    std::tie(faults[i].lower, faults[i].upper) = std::move(found[i]);
    faults[i].path.tip_at_begin = faults[i].lower.kind == EndKind::Tip;
    faults[i].path.tip_at_end = faults[i].upper.kind == EndKind::Tip;
  }
  DOBRA_TRY_VOID(check_ages(faults));
  Branches(faults).go_on();
  return faults;
}

base::Result<const Fault*> find_fault(const std::vector<Fault>& faults, const std::string& name) {
  std::vector<std::string> names;
  const Fault* piece = nullptr;
  for (const Fault& fault : faults) {
    if (fault.name == name) return &fault;
    if (fault.whole == name) piece = &fault;
    names.push_back(fault.name);
  }
  if (piece != nullptr) {
    return refusal(*piece, piece->path.line.points.front(),
                   fmt::format("the pieces of '{}' do not meet; move on the younger fault between them first", name));
  }
  const std::string known = names.empty() ? "" : fmt::format("; its faults are '{}'", fmt::join(names, "', '"));
  return base::Error{base::ErrorCode::BadSection,
                     fmt::format("the section has no fault '{}'{}{}", name, known, base::did_you_mean(name, names)),
                     base::Place{.item = "faults"}};
}

}  // namespace recon::faults
