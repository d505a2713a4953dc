#include "recon/core/stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "shared/base/parallel.h"
#include "shared/base/text.h"
#include "shared/geom/intersect.h"

namespace recon::core {

namespace {

/// Where along `line` the pin line (the normal of the top at the pin) meets it; of several places the nearest to the
/// pin.
std::optional<double> pin_on(const geom::Polyline& line, const std::vector<double>& arc, geom::Point pin,
                             geom::Vector normal, double reach) {
  const geom::Segment pin_line{pin + -reach * normal, pin + reach * normal};
  const double rounding = 1e-12 * reach * geom::length(normal);
  std::optional<double> best;
  double least = std::numeric_limits<double>::infinity();
  double before = geom::cross(line.points.front() - pin, normal);
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const double from = before;
    before = geom::cross(line.points[i + 1] - pin, normal);
    if (std::min(from, before) > rounding || std::max(from, before) < -rounding) continue;  // on one side of it
    const geom::Intersection meeting = geom::intersect(line.segment(i), pin_line);
    if (meeting.kind == geom::IntersectionKind::None) continue;
    const double distance = geom::distance(meeting.start.point, pin);
    if (distance >= least) continue;
    least = distance;
    best = arc[i] + geom::distance(line.points[i], meeting.start.point);
  }
  return best;
}

/// One line of a stack, travelling like the base, with a vertex at the pin.
struct StackLine {
  HorizonId id;
  geom::Polyline line;
  std::vector<double> arc;
  std::vector<std::size_t> given;  ///< Where the vertices of the horizon stand, along travel.
  std::size_t pin_vertex = 0;
  double pin = 0.0;                ///< Arc length, m.
  double depth = 0.0;              ///< Of its pin below that of the base, m.
  std::vector<ColumnPoint> names;  ///< Flexural: of every vertex.
};

void insert_pin(StackLine& line) {
  const auto after = std::lower_bound(line.arc.begin(), line.arc.end(), line.pin);
  line.pin_vertex = static_cast<std::size_t>(std::min(after, line.arc.end() - 1) - line.arc.begin());
  if (after == line.arc.end() || *after == line.pin) {
    line.pin = line.arc[line.pin_vertex];
    return;
  }
  const auto i = after - line.arc.begin();
  line.line.points.insert(line.line.points.begin() + i, geom::point_at(line.line, line.arc, line.pin));
  line.arc.insert(line.arc.begin() + i, line.pin);
  for (std::size_t k = line.pin_vertex; k < line.given.size(); ++k) ++line.given[k];
}

/// Gives the line a vertex wherever it crosses a rung of the top, and every vertex its name.
void measure_depths(StackLine& line, const ColumnMap& grid) {
  MappedLine traced = measure_along(grid.source(), grid.tolerances(), line.line);
  std::vector<std::size_t> place(traced.before.points.size());  // of traced vertices, once repeated ones are left out
  line.line.points.clear();
  for (std::size_t i = 0; i < place.size(); ++i) {
    const geom::Point p = traced.before.points[i];
    if (line.line.points.empty() || line.line.points.back() != p) {
      line.line.points.push_back(p);
      line.names.push_back(traced.names[i]);
    }
    place[i] = line.line.points.size() - 1;
  }
  line.arc = geom::arc_lengths(line.line);
  line.pin_vertex = place[traced.given[line.pin_vertex]];
  line.pin = line.arc[line.pin_vertex];
  for (std::size_t& i : line.given) i = place[traced.given[i]];
}

/// Of the vertices of the horizon.
double mean_depth(const StackLine& line) {
  double sum = 0.0;
  for (const std::size_t i : line.given) sum += line.names[i].depth;
  return sum / static_cast<double>(line.given.size());
}

/// The pin at an end of the base pins the ends of all lines; elsewhere the pin line must meet them.
enum class PinAt { Start, End, Inside };

PinAt pin_at(const SourceGrid& source, double arc) {
  const double length = geom::length(source.base);
  if (arc <= 1e-9 * length) return PinAt::Start;
  return arc >= (1.0 - 1e-9) * length ? PinAt::End : PinAt::Inside;
}

/// The normal of the top at the pin; at a corner its rung, as in ColumnMap::slip.
geom::Vector pin_normal(const Target& target) {
  const Columns& columns = target.map.source();
  const ColumnPoint at = target.map.locate(target.source_pin).at;
  const std::size_t column = std::clamp<std::size_t>(at.column.index(), 1, columns.inner_count());
  for (const std::size_t rung : {column, column - 1}) {
    if (geom::distance(columns.foot(rung), target.source_pin) <= target.map.tolerances().tear)
      return geom::normalised(columns.rung_vector(rung));
  }
  return geom::right_of(columns.frame(ColumnId(column)).tangent);
}

base::Result<StackLine> stack_line(const Horizon& horizon, const SourceGrid& source, const Target& target,
                                   geom::Vector normal, PinAt where) {
  StackLine line;
  line.id = horizon.id;
  line.line = horizon.id == source.top          ? source.base
              : source.side == LayerSide::Above ? geom::reversed(horizon.line)
                                                : horizon.line;
  line.arc = geom::arc_lengths(line.line);
  line.given.resize(line.arc.size());
  std::iota(line.given.begin(), line.given.end(), std::size_t{0});
  if (horizon.id == source.top) {
    line.pin = target.source_arc;
  } else if (where != PinAt::Inside) {
    line.pin = where == PinAt::Start ? 0.0 : line.arc.back();
  } else {
    const double reach = 4.0 * (source.base.box().diagonal() + line.line.box().diagonal());
    const std::optional<double> pin = pin_on(line.line, line.arc, target.source_pin, normal, reach);
    if (!pin || *pin <= 0.0 || *pin >= line.arc.back()) {
      return base::Error{base::ErrorCode::CannotRestore,
                         fmt::format("the pin line does not meet horizon '{}'; move the pin", horizon.name),
                         place_at(target.source_pin, "pin")};
    }
    line.pin = *pin;
  }
  line.depth = geom::dot(geom::point_at(line.line, line.arc, line.pin) - target.source_pin, normal);
  insert_pin(line);
  return line;
}

/// Arc length to the common place u: -1 .. 0 before the pin, 0 .. 1 after it (one of the two where the pin is at an
/// end).
double place_of(const StackLine& line, double arc) {
  if (arc == line.pin) return 0.0;
  return arc < line.pin ? (arc - line.pin) / line.pin : (arc - line.pin) / (line.arc.back() - line.pin);
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
  void add_between(std::size_t i, double part, geom::Point image, const Columns& columns) {
    const geom::Point p = geom::interpolate(line_.line.points[i - 1], line_.line.points[i], part);
    const double arc = (1.0 - part) * line_.arc[i - 1] + part * line_.arc[i];
    if (add(place_of(line_, arc), p, image) && !line_.names.empty())
      names_.push_back(columns.name_in(line_.names[i].column, p));
  }

  [[nodiscard]] std::size_t pin() const { return place_[line_.pin_vertex]; }
  RuledLine& ruled() { return ruled_; }

  /// As a trace would give it; from left to right whatever the side of the layers.
  [[nodiscard]] MappedLine mapped(LayerSide side) const {
    MappedLine mapped;
    mapped.before.points = ruled_.from;
    mapped.after.points = ruled_.to;
    mapped.names = names_;
    mapped.given.reserve(line_.given.size());
    for (const std::size_t i : line_.given) mapped.given.push_back(place_[i]);
    if (side == LayerSide::Above) {
      std::reverse(mapped.before.points.begin(), mapped.before.points.end());
      std::reverse(mapped.after.points.begin(), mapped.after.points.end());
      std::reverse(mapped.names.begin(), mapped.names.end());
      std::reverse(mapped.given.begin(), mapped.given.end());
      for (std::size_t& i : mapped.given) i = ruled_.u.size() - 1 - i;
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
  RuledLine ruled_;
  std::vector<ColumnPoint> names_;
  std::vector<std::size_t> place_;  ///< Of the vertices of the line.
};

class StackBuilder {
 public:
  StackBuilder(const SourceGrid& source, const Target& target, const MethodParams& params, ColumnMap goal)
      : source_(source),
        target_(target),
        params_(params),
        goal_(std::move(goal)),
        top_length_(geom::length(source.base)) {}

  base::Result<MethodMap> run(std::vector<StackLine> lines) {
    const bool proportional = params_.method == RestoreMethod::Proportional;
    if (proportional) thickness_ = params_.thickness.value_or(mean_thickness(lines));
    MethodMap made;
    std::vector<RuledLine> ruled(lines.size());
    std::vector<MappedLine> mapped(lines.size());
    base::parallel_for(lines.size(), [&](std::size_t i) {
      const StackLine& line = lines[i];
      RuledBuilder builder(line);
      if (params_.method == RestoreMethod::Flexural) {
        lay_out(line, builder);
      } else {
        put_at_depth(line, i == 0, builder);
      }
      // A simplified base is not the top itself, which then goes through the map.
      const bool is_horizon = line.id != source_.top || source_.params.simplify == 0.0;
      if (!proportional && is_horizon) mapped[i] = builder.mapped(source_.side);
      ruled[i] = std::move(builder.ruled());
    });
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!mapped[i].given.empty()) made.lines.emplace_back(lines[i].id, std::move(mapped[i]));
    }
    const RuledMap map(std::move(ruled));
    if (const auto folded = map.folded()) {
      const std::string message = "the rulings between the horizons cross here, so that the map is not single-valued";
      if (params_.doubt == Doubt::Refuse) {
        return base::Error{base::ErrorCode::CannotRestore, message + "; move the pin, or use another method",
                           place_at(*folded)};
      }
      made.remarks.push_back(fmt::format("{} ({:.6g}, {:.6g}); points there go with the first strip that holds them",
                                         message, folded->x, folded->y));
    }
    made.map = SectionMap(map);
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
    const Columns& columns = target_.map.source();
    const auto before = goal_.lay(line.arc, line.names, line.pin_vertex, -1.0);
    for (std::size_t i = before.size(); i-- > 1;) {
      const ColumnMap::LaidPoint& at = before[i];
      if (at.part == 0.0) {
        builder.add_vertex(at.vertex, at.point);
      } else {
        builder.add_between(at.vertex, 1.0 - at.part, at.point, columns);
      }
    }
    for (const ColumnMap::LaidPoint& at : goal_.lay(line.arc, line.names, line.pin_vertex, 1.0)) {
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
    const double depth = proportional ? (is_first ? 0.0 : thickness_) : line.depth;
    std::vector<double> corners = goal_.target_corners(stretched ? 0.0 : depth);
    std::sort(corners.begin(), corners.end());
    ColumnId hint;
    const auto image = [&](double arc) {
      return stretched ? below_top(place_of(line, arc), depth, hint) : goal_.target_point(arc - line.pin, depth, hint);
    };
    auto corner = corners.begin();
    for (std::size_t i = 0; i < line.arc.size(); ++i) {
      for (; corner != corners.end() && line.pin + *corner < line.arc[i]; ++corner) {
        const double arc = line.pin + *corner;
        if (i > 0 && arc > line.arc[i - 1])
          builder.add_between(i, (arc - line.arc[i - 1]) / (line.arc[i] - line.arc[i - 1]), image(arc), goal_.source());
      }
      builder.add_vertex(i, image(line.arc[i]));
    }
    if (params_.percent == 100.0) return;
    RuledLine& ruled = builder.ruled();
    ruled.to = bent_between(ruled.from, ruled.to, builder.pin(), params_.percent / 100.0);
  }

  /// At the same place as u on the top, at a depth along the normal of the target.
  [[nodiscard]] geom::Point below_top(double u, double depth, ColumnId& hint) const {
    const double pin = target_.source_arc;
    const geom::Point foot = goal_.target_point(u * (u < 0.0 ? pin : top_length_ - pin), 0.0, hint);
    ColumnPoint name = goal_.target().locate(foot, goal_.tolerances().side, hint).at;
    name.depth = depth;
    return goal_.target().point(name);
  }

  const SourceGrid& source_;
  const Target& target_;
  const MethodParams& params_;
  ColumnMap goal_;  ///< Slip: beds of the target by their distance from the pin.
  double top_length_ = 0.0;
  double thickness_ = 0.0;
};

/// Top and base of proportional thickness.
base::Result<std::vector<HorizonId>> top_and_base(const Section& section, const SourceGrid& source,
                                                  const MethodParams& params, HorizonId farthest) {
  const Horizon* base_horizon =
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

}  // namespace

base::Result<MethodMap> make_stack_map(const Section& section, const SourceGrid& source, const Target& target,
                                       const MethodParams& params, std::optional<Columns> on_the_way) {
  if (section.horizons.size() < 2) {
    return base::Error{base::ErrorCode::BadSection,
                       fmt::format("method \"{}\" needs two horizons", method_name(params.method))};
  }
  const bool flexural = params.method == RestoreMethod::Flexural;
  std::vector<HorizonId> order;
  if (flexural) {  // put in order when all are measured
    for (const Horizon& horizon : section.horizons) order.push_back(horizon.id);
  } else {
    order = horizons_in_order(section, source, target);
  }
  std::vector<HorizonId> taken = order;
  if (params.method == RestoreMethod::Proportional) {
    DOBRA_TRY(taken, top_and_base(section, source, params, order.back()));
  }
  const geom::Vector normal = pin_normal(target);
  const PinAt where = pin_at(source, target.source_arc);
  auto found = base::parallel_map<std::optional<base::Result<StackLine>>>(taken.size(), [&](std::size_t i) {
    auto line = stack_line(*find_horizon(section, taken[i]), source, target, normal, where);
    if (line && flexural) measure_depths(*line, target.map);
    return line;
  });
  std::vector<StackLine> lines;
  for (auto& line : found) {
    if (!*line) return line->error();
    lines.push_back(std::move(**line));
  }
  if (flexural) {
    std::vector<std::pair<double, HorizonId>> depths;
    for (const StackLine& line : lines) depths.emplace_back(line.id == source.top ? 0.0 : mean_depth(line), line.id);
    order = in_order(std::move(depths));
    const auto place = [&](const StackLine& line) { return std::find(order.begin(), order.end(), line.id); };
    std::sort(lines.begin(), lines.end(), [&](const StackLine& a, const StackLine& b) { return place(a) < place(b); });
  }
  ColumnMap goal;
  if (on_the_way) {
    // The matched columns cover the source from its first point, so the pin has the same arc length on both.
    goal = ColumnMap::slip(target.map.source(), target.source_arc, std::move(*on_the_way), target.source_arc);
  } else {
    DOBRA_TRY(goal,
              match_by_length(source.base, target.source_arc, target.line, target.target_arc, {}, ColumnLaw::Slip));
  }
  return StackBuilder(source, target, params, std::move(goal)).run(std::move(lines));
}

}  // namespace recon::core
