#include "recon/unfold/stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "recon/unfold/full_bed.h"
#include "shared/base/parallel.h"
#include "shared/base/text.h"
#include "shared/geom/contour.h"
#include "shared/geom/place.h"

namespace recon::unfold {

namespace {

/// A horizon in its bed: its vertices, and those of them that were given.
struct LinePart {
  section::HorizonId id;
  std::size_t first = 0;
  std::size_t last = 0;
  std::vector<std::size_t> given;  ///< Along travel.
};

/// One bed of a stack from end to end, travelling like the base, with a vertex at the pin.
struct StackLine {
  section::HorizonId id;
  geom::Polyline line;
  std::vector<double> arc;  ///< Where the bed jumps it grows by next to nothing.
  std::vector<LinePart> parts;
  std::size_t pin_before = 0;  ///< Vertices at the pin: one, or two where the bed jumps there.
  std::size_t pin_behind = 0;
  double depth_before = 0.0;  ///< Of these below the base, m.
  double depth_behind = 0.0;
  std::vector<maps::ColumnPoint> names;  ///< Flexural: of every vertex.

  [[nodiscard]] double pin() const { return arc[pin_before]; }
  /// Distance from the pin along the bed, m: negative before it.
  [[nodiscard]] double from_pin(double at) const { return at > pin() ? at - arc[pin_behind] : at - pin(); }
  [[nodiscard]] double depth(double at) const { return at > pin() ? depth_behind : depth_before; }
};

/// How much the arc length grows over a jump, relative to the length of the bed: places must grow.
constexpr double jump = 1e-11;

/// The pin as a vertex of a part; one nearer than the tolerance is taken.
struct PinVertex {
  std::size_t vertex = 0;
  bool is_new = false;
};
PinVertex insert_pin(BedPart& part, double pin, double tolerance) {
  const auto after = std::lower_bound(part.arc.begin(), part.arc.end(), pin - tolerance);
  const auto i = std::min(after, part.arc.end() - 1) - part.arc.begin();
  if (after == part.arc.end() || *after <= pin + tolerance) return {static_cast<std::size_t>(i), false};
  part.line.points.insert(part.line.points.begin() + i, geom::point_at(part.line, part.arc, pin));
  part.arc.insert(part.arc.begin() + i, pin);
  return {static_cast<std::size_t>(i), true};
}

struct MeasuredPart {
  std::vector<geom::Point> points;
  std::vector<maps::ColumnPoint> names;  ///< None, or of every vertex.
  std::vector<std::size_t> given;        ///< Where the vertices of the part stand.
};

MeasuredPart as_it_is(const BedPart& part) {
  MeasuredPart made{part.line.points, {}, std::vector<std::size_t>(part.line.points.size())};
  std::iota(made.given.begin(), made.given.end(), std::size_t{0});
  return made;
}

/// A part with a vertex wherever it crosses a rung of the top, and the name of every vertex.
MeasuredPart measured(const BedPart& part, const maps::ColumnMap& grid) {
  const maps::MappedLine traced = measure_along(grid.source(), grid.tolerances(), part.line);
  MeasuredPart made;
  std::vector<std::size_t> place(traced.before.points.size());  // of traced vertices, once repeated ones are left out
  for (std::size_t i = 0; i < place.size(); ++i) {
    const geom::Point p = traced.before.points[i];
    if (made.points.empty() || made.points.back() != p) {
      made.points.push_back(p);
      made.names.push_back(traced.names[i]);
    }
    place[i] = made.points.size() - 1;
  }
  for (const std::size_t i : traced.given) made.given.push_back(place[i]);
  return made;
}

/// Puts a part behind what the line has. @return where its first vertex stands: where a horizon and a missing part
/// touch they share one, that of the horizon.
std::size_t append(MeasuredPart made, bool is_horizon, double touching, double jump_length, StackLine& line) {
  std::vector<geom::Point>& points = line.line.points;
  const bool touches = !points.empty() && geom::distance(points.back(), made.points.front()) <= touching;
  if (touches && is_horizon) {
    points.back() = made.points.front();
    if (!made.names.empty()) line.names.back() = made.names.front();
  }
  const double start = line.arc.empty() ? 0.0 : line.arc.back() + (touches ? 0.0 : jump_length);
  const std::vector<double> arc = geom::arc_lengths({made.points, false});
  const std::ptrdiff_t skip = touches ? 1 : 0;
  const std::size_t first = points.size() - (touches ? 1 : 0);
  points.insert(points.end(), made.points.begin() + skip, made.points.end());
  for (std::size_t i = touches ? 1 : 0; i < arc.size(); ++i) line.arc.push_back(start + arc[i]);
  if (!made.names.empty()) line.names.insert(line.names.end(), made.names.begin() + skip, made.names.end());
  return first;
}

StackLine stack_line(FullBed bed, const Target& target, const PinLine& pin, bool with_depths) {
  StackLine line;
  line.id = bed.id;
  const PinVertex pinned = insert_pin(bed.parts[bed.pin_part], bed.pin_arc, pin.tolerance());
  double length = 0.0;
  for (const BedPart& part : bed.parts) length += part.arc.back();
  for (std::size_t i = 0; i < bed.parts.size(); ++i) {
    const BedPart& part = bed.parts[i];
    const bool is_horizon = part.horizon.valid();
    // Two horizons do not share a vertex, so that each keeps its own.
    const bool shares = i > 0 && !(is_horizon && bed.parts[i - 1].horizon.valid());
    MeasuredPart made = with_depths ? measured(part, target.map) : as_it_is(part);
    std::vector<std::size_t> given = made.given;
    const std::size_t before = line.line.points.size();
    const std::size_t first =
        append(std::move(made), is_horizon, shares ? 1e4 * pin.tolerance() : -1.0, jump * length, line);
    for (std::size_t& k : given) k += first;
    if (i == bed.pin_part) {
      line.pin_before = line.pin_behind = given[pinned.vertex];
      if (pinned.is_new) given.erase(given.begin() + static_cast<std::ptrdiff_t>(pinned.vertex));
    }
    // In a gap that holds the pin the bed may jump there.
    const bool jumps = first == before && line.pin_before + 1 == before;
    if (i == bed.pin_part + 1 && jumps && !bed.parts[bed.pin_part].horizon.valid()) line.pin_behind = first;
    if (is_horizon) line.parts.push_back({part.horizon, first, line.line.points.size() - 1, std::move(given)});
  }
  line.depth_before = pin.depth(line.line.points[line.pin_before]);
  line.depth_behind = pin.depth(line.line.points[line.pin_behind]);
  return line;
}

/// Arc length to the common place u: -1 .. 0 before the pin, 0 .. 1 after it (one of the two where the pin is at an
/// end).
double place_of(const StackLine& line, double arc) {
  const double pin = line.pin();
  if (arc == pin) return 0.0;
  return arc < pin ? (arc - pin) / pin : (arc - pin) / (line.arc.back() - pin);
}

/// A line of the stack with its image, and what becomes of the vertices of the horizon.
class RuledBuilder {
 public:
  explicit RuledBuilder(const StackLine& line) : line_(line), place_(line.arc.size(), 0) {
    const std::size_t count = line.arc.size() + line.arc.size() / 8;
    ruled_.u.reserve(count);
    ruled_.from.reserve(count);
    ruled_.to.reserve(count);
    names_.reserve(line.names.empty() ? 0 : count);
  }

  void add_vertex(std::size_t i, geom::Point image) {
    if (add(place_of(line_, line_.arc[i]), line_.line.points[i], image) && !line_.names.empty())
      names_.push_back(line_.names[i]);
    place_[i] = ruled_.u.size() - 1;
  }

  /// A place between vertex i - 1 and vertex i.
  void add_between(std::size_t i, double part, geom::Point image, const maps::Columns& columns) {
    const geom::Point p = geom::interpolate(line_.line.points[i - 1], line_.line.points[i], part);
    const double arc = (1.0 - part) * line_.arc[i - 1] + part * line_.arc[i];
    if (add(place_of(line_, arc), p, image) && !line_.names.empty())
      names_.push_back(columns.name_in(line_.names[i].column, p));
  }

  [[nodiscard]] std::size_t pin() const { return place_[line_.pin_before]; }
  maps::RuledLine& ruled() { return ruled_; }

  /// A horizon, as a trace would give it; from left to right whatever the side of the layers.
  /// @param number  of the line in the stack.
  [[nodiscard]] maps::MappedLine mapped(const LinePart& part, section::LayerSide side, std::size_t number) const {
    const auto first = static_cast<std::ptrdiff_t>(place_[part.first]);
    const auto end = static_cast<std::ptrdiff_t>(place_[part.last]) + 1;
    maps::MappedLine mapped;
    mapped.before.points.assign(ruled_.from.begin() + first, ruled_.from.begin() + end);
    mapped.after.points.assign(ruled_.to.begin() + first, ruled_.to.begin() + end);
    if (!names_.empty()) mapped.names.assign(names_.begin() + first, names_.begin() + end);
    mapped.given.reserve(part.given.size());
    for (const std::size_t i : part.given) mapped.given.push_back(place_[i] - place_[part.first]);
    mapped.on_stack = maps::OnStack{number, place_[part.first], place_[part.last]};
    if (side == section::LayerSide::Above) {
      std::swap(mapped.on_stack->first, mapped.on_stack->last);
      std::reverse(mapped.before.points.begin(), mapped.before.points.end());
      std::reverse(mapped.after.points.begin(), mapped.after.points.end());
      std::reverse(mapped.names.begin(), mapped.names.end());
      std::reverse(mapped.given.begin(), mapped.given.end());
      for (std::size_t& i : mapped.given) i = mapped.before.points.size() - 1 - i;
    }
    return mapped;
  }

 private:
  bool add(double u, geom::Point from, geom::Point to) {
    if (!ruled_.u.empty() && u <= ruled_.u.back()) return false;
    ruled_.u.push_back(u);
    ruled_.from.push_back(from);
    ruled_.to.push_back(to);
    return true;
  }

  const StackLine& line_;
  maps::RuledLine ruled_;
  std::vector<maps::ColumnPoint> names_;
  std::vector<std::size_t> place_;  ///< Of the vertices of the line.
};

class StackBuilder {
 public:
  StackBuilder(const SourceGrid& source, const Target& target, const MethodParams& params, maps::ColumnMap goal)
      : source_(source), target_(target), params_(params), goal_(std::move(goal)) {}

  base::Result<MethodMap> run(const std::vector<StackLine>& lines) {
    const bool proportional = params_.method == RestoreMethod::Proportional;
    if (proportional) thickness_ = params_.thickness.value_or(mean_thickness(lines));
    MethodMap made;
    std::vector<maps::RuledLine> ruled(lines.size());
    std::vector<std::vector<std::pair<section::HorizonId, maps::MappedLine>>> mapped(lines.size());
    top_before_ = lines[top_line(lines)].pin();
    top_behind_ = lines[top_line(lines)].arc.back() - top_before_;
    base::parallel_for(lines.size(), [&](std::size_t i) {
      const StackLine& line = lines[i];
      RuledBuilder builder(line);
      if (params_.method == RestoreMethod::Flexural) {
        lay_out(line, builder);
      } else {
        put_at_depth(line, i == 0, builder);
      }
      for (const LinePart& part : line.parts) {
        // A simplified base is not the top itself, which then goes through the map.
        const bool is_horizon = part.id != source_.top || source_.params.simplify == 0.0;
        if (!proportional && is_horizon) mapped[i].emplace_back(part.id, builder.mapped(part, source_.side, i));
      }
      ruled[i] = std::move(builder.ruled());
    });
    for (auto& of_line : mapped) std::move(of_line.begin(), of_line.end(), std::back_inserter(made.lines));
    const maps::RuledMap map(std::move(ruled));
    if (const auto folded = map.folded()) {
      const std::string message = "the rulings between the horizons cross here, so that the map is not single-valued";
      if (params_.doubt == Doubt::Refuse) {
        return base::Error{base::ErrorCode::CannotRestore, message + "; move the pin, or use another method",
                           place_at(*folded)};
      }
      made.remarks.push_back(
          fmt::format("{} {}; points there go with the first strip that holds them", message, *folded));
    }
    made.map = maps::SectionMap(map);
    return made;
  }

 private:
  /// Of the layers if their area stays and the top keeps its length.
  static double mean_thickness(const std::vector<StackLine>& lines) {
    const geom::Polyline contour = contour_between(lines.front().line, lines.back().line);
    return std::abs(geom::signed_area(contour)) / lines.front().arc.back();
  }

  /// From the pin to both sides, every piece as long as it is and at its depth.
  void lay_out(const StackLine& line, RuledBuilder& builder) const {
    const maps::Columns& columns = target_.map.source();
    const auto before = goal_.lay(line.arc, line.names, line.pin_before, -1.0);
    for (std::size_t i = before.size(); i-- > 1;) {
      const maps::ColumnMap::LaidPoint& at = before[i];
      if (at.part == 0.0) {
        builder.add_vertex(at.vertex, at.point);
      } else {
        builder.add_between(at.vertex, 1.0 - at.part, at.point, columns);
      }
    }
    for (const maps::ColumnMap::LaidPoint& at : goal_.lay(line.arc, line.names, line.pin_behind, 1.0)) {
      if (at.part == 0.0) {
        builder.add_vertex(at.vertex, at.point);
      } else {
        builder.add_between(at.vertex + 1, at.part, at.point, columns);
      }
    }
  }

  /// On the parallel of the target at one depth, with vertices where that has its corners.
  void put_at_depth(const StackLine& line, bool is_first, RuledBuilder& builder) const {
    const bool proportional = params_.method == RestoreMethod::Proportional;
    const bool stretched = proportional && !is_first;
    const auto depth_at = [&](double arc) { return proportional ? (is_first ? 0.0 : thickness_) : line.depth(arc); };
    // Where the bed jumps at the pin its two sides lie at two depths.
    std::vector<double> corners;
    for (const bool behind : {false, true}) {
      const double pin = line.arc[behind ? line.pin_behind : line.pin_before];
      const double depth = stretched ? 0.0 : depth_at(behind ? line.arc.back() : line.arc.front());
      for (const double corner : goal_.target_corners(depth))
        if (behind ? corner > 0.0 : corner <= 0.0) corners.push_back(pin + corner);
    }
    std::sort(corners.begin(), corners.end());
    maps::ColumnId hint;
    const auto image = [&](double arc) {
      return stretched ? below_top(place_of(line, arc), depth_at(arc), hint)
                       : goal_.target_point(line.from_pin(arc), depth_at(arc), hint);
    };
    auto corner = corners.begin();
    for (std::size_t i = 0; i < line.arc.size(); ++i) {
      for (; corner != corners.end() && *corner < line.arc[i]; ++corner) {
        if (i > 0 && *corner > line.arc[i - 1])
          builder.add_between(i, (*corner - line.arc[i - 1]) / (line.arc[i] - line.arc[i - 1]), image(*corner),
                              goal_.source());
      }
      builder.add_vertex(i, image(line.arc[i]));
    }
    if (params_.percent == 100.0) return;
    maps::RuledLine& ruled = builder.ruled();
    ruled.to = bent_between(ruled.from, ruled.to, builder.pin(), params_.percent / 100.0);
  }

  /// At the same place as u on the top, at a depth along the normal of the target.
  [[nodiscard]] geom::Point below_top(double u, double depth, maps::ColumnId& hint) const {
    const geom::Point foot = goal_.target_point(u * (u < 0.0 ? top_before_ : top_behind_), 0.0, hint);
    maps::ColumnPoint name = goal_.target().locate(foot, goal_.tolerances().side, hint).at;
    name.depth = depth;
    return goal_.target().point(name);
  }

  [[nodiscard]] std::size_t top_line(const std::vector<StackLine>& lines) const {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const LinePart& part : lines[i].parts)
        if (part.id == source_.top) return i;
    }
    return 0;
  }

  const SourceGrid& source_;
  const Target& target_;
  const MethodParams& params_;
  maps::ColumnMap goal_;     ///< Slip: beds of the target by their distance from the pin.
  double top_before_ = 0.0;  ///< Of the top from end to end: how far it reaches before and behind the pin, m.
  double top_behind_ = 0.0;
  double thickness_ = 0.0;
};

/// Top and base of proportional thickness.
base::Result<std::vector<section::HorizonId>> top_and_base(const section::Section& section, const SourceGrid& source,
                                                           const MethodParams& params, section::HorizonId farthest) {
  const section::Horizon* base_horizon =
      params.base.empty() ? find_horizon(section, farthest) : find_horizon(section, params.base);
  if (base_horizon == nullptr) {
    return base::Error{base::ErrorCode::BadSection,
                       fmt::format("there is no horizon '{}' to be the base{}", params.base,
                                   base::did_you_mean(params.base, horizon_names(section)))};
  }
  if (base_horizon->id == source.top)
    return base::Error{base::ErrorCode::BadSection, "the base must be another horizon than the top"};
  return std::vector{source.top, base_horizon->id};
}

/// All beds reach to the same sides of the pin, unless a parallel has closed on the way to the end.
base::Result<void> refuse_closed_ends(const section::Section& section, const std::vector<StackLine>& lines) {
  const auto before = [](const StackLine& line) { return line.pin_before > 0; };
  const auto behind = [](const StackLine& line) { return line.pin_behind + 1 < line.arc.size(); };
  const bool some_before = std::any_of(lines.begin(), lines.end(), before);
  const bool some_behind = std::any_of(lines.begin(), lines.end(), behind);
  for (const StackLine& line : lines) {
    if (before(line) == some_before && behind(line) == some_behind) continue;
    const section::Horizon& horizon = *find_horizon(section, line.id);
    return base::Error{base::ErrorCode::CannotRestore,
                       "other horizons go on beyond the pin line where it ends; move the pin",
                       place_at(line.line.points[line.pin_before], fmt::format("horizon '{}'", horizon.name))};
  }
  return {};
}

}  // namespace

base::Result<MethodMap> make_stack_map(const section::Section& section, const SourceGrid& source, const Target& target,
                                       const MethodParams& params, std::optional<maps::Columns> on_the_way) {
  if (section.horizons.size() < 2) {
    return base::Error{base::ErrorCode::BadSection,
                       fmt::format("method \"{}\" needs two horizons", method_name(params.method))};
  }
  std::vector<section::HorizonId> taken = horizons_in_order(section, source, target);
  if (params.method == RestoreMethod::Proportional) {
    DOBRA_TRY(taken, top_and_base(section, source, params, taken.back()));
  }
  std::vector<std::string> remarks;
  DOBRA_TRY(
      std::vector<FullBed> beds,
      full_beds(section, source, target.map.source(), target.source_arc, taken,
                params.method == RestoreMethod::Proportional ? BedEnds::OfTheSection : BedEnds::AsTheyAre, remarks));
  const PinLine pin(target.map.source(), target.source_arc);
  const bool flexural = params.method == RestoreMethod::Flexural;
  const std::vector<StackLine> lines = base::parallel_map<StackLine>(
      beds.size(), [&](std::size_t i) { return stack_line(std::move(beds[i]), target, pin, flexural); });
  DOBRA_TRY_VOID(refuse_closed_ends(section, lines));
  maps::ColumnMap goal;
  if (on_the_way) {
    // The matched columns cover the source from its first point, so the pin has the same arc length on both.
    goal = maps::ColumnMap::slip(target.map.source(), target.source_arc, std::move(*on_the_way), target.source_arc);
  } else {
    DOBRA_TRY(goal, match_by_length(source.base, target.source_arc, target.line, target.target_arc, {},
                                    maps::ColumnLaw::Slip));
  }
  DOBRA_TRY(MethodMap made, StackBuilder(source, target, params, std::move(goal)).run(lines));
  made.remarks.insert(made.remarks.begin(), remarks.begin(), remarks.end());
  return made;
}

}  // namespace recon::unfold
