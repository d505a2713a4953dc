#include "shared/cli/offset_families.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/base/text.h"
#include "shared/io/formats/line_files.h"

namespace dobra::cli {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Polyline;
using offset::Area;

namespace {

bool untreated(const OffsetPlan& plan) { return plan.curves.treatment == offset::Treatment::Untreated; }

/// Whether open lines get an area on both sides.
bool both_sides(const OffsetPlan& plan) {
  return plan.side == OffsetSide::Both || (!plan.side && plan.dissolve == Dissolve::Yes);
}

// --- bases

/// A line that ends where it begins is a contour.
bool is_closed(const Polyline& line) {
  return line.closed || (line.points.size() > 3 && line.points.front() == line.points.back());
}

Polyline as_contour(Polyline line) {
  line.closed = true;
  line = geom::without_repeated_points(std::move(line));
  return geom::signed_area(line) < 0.0 ? geom::reversed(std::move(line)) : line;
}

/// The parts of a feature as lines and polygons.
OffsetBase base_of(io::lines::Feature feature, Closing closing) {
  OffsetBase made;
  if (feature.type == io::lines::FeatureType::Polygons) {
    for (const auto& [first, last] : io::lines::polygons_of(feature)) {
      const auto begin = feature.parts.begin();
      made.polygons.emplace_back(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last));
    }
  }
  for (Polyline& part : feature.parts) {
    if (feature.type == io::lines::FeatureType::Polygons) break;
    if (closing == Closing::Closed || is_closed(part)) {
      made.polygons.push_back({as_contour(std::move(part))});
    } else {
      made.lines.push_back(std::move(part));
    }
  }
  feature.parts.clear();
  made.source = std::move(feature);
  return made;
}

/// What the plan takes together: all of it, or, where curves run on one side or are untreated, each curve by itself.
std::vector<OffsetBase> taken_apart(OffsetBase base, const OffsetPlan& plan) {
  std::vector<OffsetBase> all;
  const auto add = [&](std::vector<Polyline> lines, std::vector<std::vector<Polyline>> polygons) {
    all.push_back({{}, base.source, std::move(lines), std::move(polygons)});
  };
  if (untreated(plan)) {
    for (const auto& polygon : base.polygons) {
      for (const Polyline& ring : polygon) add({}, {{ring}});
    }
  } else if (!base.polygons.empty()) {
    add({}, std::move(base.polygons));
  }
  if (both_sides(plan) && !untreated(plan) && !base.lines.empty()) {
    if (all.empty()) add({}, {});
    all.back().lines = std::move(base.lines);
  } else {
    for (Polyline& line : base.lines) add({std::move(line)}, {});
  }
  return all;
}

Result<std::vector<OffsetBase>> chosen(std::vector<OffsetBase> all, const std::optional<std::string>& wanted) {
  if (!wanted) return all;
  std::vector<OffsetBase> named;
  std::vector<std::string> names;
  for (const OffsetBase& base : all) {
    names.push_back(base.name);
    if (base.name == *wanted) named.push_back(base);
  }
  if (!named.empty()) return named;
  const std::optional<double> number = base::parse_number(*wanted);
  if (number && *number >= 1.0 && *number <= static_cast<double>(all.size()) && *number == std::floor(*number)) {
    return std::vector<OffsetBase>{all[static_cast<std::size_t>(*number) - 1]};
  }
  return Error{ErrorCode::BadUsage, fmt::format("--curve: there is no curve '{}' among the {} of the file{}", *wanted,
                                                all.size(), base::did_you_mean(*wanted, names))};
}

/// @return how many polygons were taken as others.
Result<std::size_t> mend(Session& session, std::vector<OffsetBase>& bases) {
  std::size_t count = 0;
  for (OffsetBase& base : bases) {
    std::vector<std::vector<Polyline>> sound;
    for (const auto& polygon : base.polygons) {
      auto mended = offset::mended(polygon, session.progress());
      if (!mended) return base::located(mended.error(), {.item = base.name});
      std::vector<std::vector<Polyline>>& parts = *mended;
      if (parts.size() != 1 || parts.front() != polygon) {
        ++count;
        const geom::Point at = polygon[0].points[0];
        session.note(fmt::format(
            "{}: the polygon at ({:.10g}, {:.10g}) crosses or touches itself; taken as {} not", base.name, at.x, at.y,
            parts.size() == 1 ? "one polygon that does" : fmt::format("{} polygons that do", parts.size())));
      }
      std::move(parts.begin(), parts.end(), std::back_inserter(sound));
    }
    base.polygons = std::move(sound);
  }
  return count;
}

// --- notes

std::size_t sharp_turns(const Polyline& line, offset::Side side, geom::Point& first) {
  const std::size_t n = line.points.size();
  std::size_t count = 0;
  for (std::size_t i = line.closed ? 0 : 1; i < n - (line.closed ? 0 : 1); ++i) {
    const geom::Vector u = line.points[i] - line.points[(i + n - 1) % n];
    const geom::Vector v = line.points[(i + 1) % n] - line.points[i];
    const double turn = geom::cross(u, v);
    if ((turn > 0.0) != (side == offset::Side::RightOfTravel)) continue;
    const double left = std::atan2(std::abs(turn), -geom::dot(u, v));  // to a full U-turn
    if (std::sin(0.5 * left) * offset::bisector_limit >= 1.0) continue;
    if (count++ == 0) first = line.points[i];
  }
  return count;
}

/// Of the corners of one base.
struct CutTips {
  std::size_t count = 0;
  geom::Point first = {};

  void add(const Polyline& line, const offset::OffsetOptions& options) {
    geom::Point at;
    if (options.join != offset::Join::Bisector) return;
    const std::size_t more = sharp_turns(line, options.side, at);
    if (count == 0) first = at;
    count += more;
  }
  void note(Session& session, const std::string& name) const {
    if (count == 0) return;
    session.note(fmt::format(
        "{}: {} {} so sharply that the bisector point is more than {} D away, the first at ({:.10g}, {:.10g}); "
        "cut across at distance D",
        name, count, count == 1 ? "corner turns back" : "corners turn back", offset::bisector_limit, first.x, first.y));
  }
};

void note_curve(Session& session, const OffsetFamily& family, const DrawnOffset& curve) {
  const bool left_out = family.content == OffsetContent::Lines && curve.distance < 0.0;  // told already
  if (curve.lines.empty() && !left_out) {
    session.note(fmt::format("{}: nothing remains at distance {}", family.name, base::number_text(curve.distance)));
  }
  if (curve.dropped == 0) return;
  session.note(
      fmt::format("{}: at distance {} the curve is in {} pieces; the longest is kept, {} of {:.6g} m {} left out "
                  "(--pieces all keeps them)",
                  family.name, base::number_text(curve.distance), curve.dropped + 1, curve.dropped,
                  curve.dropped_length, curve.dropped == 1 ? "is" : "are"));
}

// --- curves

class Maker {
 public:
  Maker(Session& session, const OffsetPlan& plan, OffsetVerdict& verdict)
      : session_(session), plan_(plan), verdict_(verdict) {}

  Result<OffsetFamily> run(const OffsetBase& base, const base::Progress& progress) {
    cut_ = {};
    DOBRA_TRY(OffsetFamily family, made(base, progress));
    cut_.note(session_, base.name);
    verdict_.cut_tips += cut_.count;
    return family;
  }

 private:
  Result<OffsetFamily> made(const OffsetBase& base, const base::Progress& progress) {
    OffsetFamily family{.name = base.name, .source = base.source, .bases = base.lines};
    for (const auto& polygon : base.polygons) family.bases.insert(family.bases.end(), polygon.begin(), polygon.end());
    const bool one_sided = !base.lines.empty() && !both_sides(plan_);
    if (one_sided || untreated(plan_)) {
      DOBRA_TRY(family.curves, curves(base.name, family.bases.front(), progress));
      return family;
    }
    DOBRA_TRY(const std::vector<Area> made, areas(base, progress));
    for (std::size_t k = 0; k < made.size(); ++k) family.curves.push_back(drawn(made[k], plan_.distances[k]));
    family.content = OffsetContent::Polygons;
    verdict_.joined = verdict_.joined || family.bases.size() > 1 || !base.lines.empty();
    return family;
  }

  Result<std::vector<DrawnOffset>> curves(const std::string& name, const Polyline& line,
                                          const base::Progress& progress) {
    DOBRA_TRY(const std::vector<double> distances, usable(name, line));
    offset::OffsetOptions settings = plan_.curves;
    settings.side = plan_.side == OffsetSide::Left ? offset::Side::LeftOfTravel : offset::Side::RightOfTravel;
    cut_.add(line, settings);
    DOBRA_TRY(const auto made, offset::offset(line, distances, settings, progress));
    if (plan_.verify) DOBRA_TRY_VOID(verify_offset(name, line, settings, made, verdict_, session_.progress()));
    std::vector<DrawnOffset> all;
    auto next = made.begin();
    for (const double distance : plan_.distances) {
      all.push_back(distance > 0.0 ? drawn(*next++, line, plan_.arc_tolerance) : DrawnOffset{.distance = distance});
    }
    return all;
  }

  /// The distances above 0. Below it an open line has no inside that could shrink: told.
  Result<std::vector<double>> usable(const std::string& name, const Polyline& line) {
    std::vector<double> distances;
    for (const double distance : plan_.distances) {
      if (distance > 0.0) {
        distances.push_back(distance);
        continue;
      }
      if (line.closed) {
        return Error{
            ErrorCode::BadUsage,
            fmt::format("--distance, --distances: {} must be above 0 for {}, which is untreated; choose --side left",
                        base::number_text(distance), name)};
      }
      session_.note(
          fmt::format("{}: an open line has nothing inside that could shrink: left out at distance {}; the other side "
                      "is --side left",
                      name, base::number_text(distance)));
      ++verdict_.skipped;
    }
    return distances;
  }

  /// Of all lines and polygons of a base together, one a distance.
  Result<std::vector<Area>> areas(const OffsetBase& base, const base::Progress& progress) {
    offset::AreaOptions options{.join = plan_.curves.join,
                                .mitre_limit = plan_.curves.mitre_limit,
                                .cap = plan_.cap,
                                .arc_tolerance = plan_.arc_tolerance};
    options.judge = [&](const Polyline& ring, const offset::OffsetOptions& settings,
                        const auto& curves) -> Result<void> {
      cut_.add(ring, settings);
      return plan_.verify ? verify_offset(base.name, ring, settings, curves, verdict_, session_.progress())
                          : Result<void>();
    };
    std::vector<std::vector<Area>> parts;
    const double total = static_cast<double>(base.polygons.size() + base.lines.size());
    const auto part_of_work = [&] {
      const double done = static_cast<double>(parts.size());
      return progress.part(done / total, (done + 1.0) / total);
    };
    for (const auto& polygon : base.polygons) {
      DOBRA_TRY(auto made, plan_.side == OffsetSide::Both
                               ? offset::around_polygon(polygon, plan_.distances, options, part_of_work())
                               : offset::grown(polygon, signed_distances(), options, part_of_work()));
      parts.push_back(std::move(made));
    }
    for (const Polyline& line : base.lines) {
      DOBRA_TRY(const std::vector<double> distances, usable(base.name, line));
      std::vector<Area> made;
      if (!distances.empty()) {
        DOBRA_TRY(made, offset::around_line(line, distances, options, part_of_work()));
      }
      for (std::size_t k = 0; k < plan_.distances.size(); ++k) {
        if (plan_.distances[k] < 0.0) made.insert(made.begin() + static_cast<std::ptrdiff_t>(k), Area{});
      }
      parts.push_back(std::move(made));
    }
    std::vector<Area> all;
    for (std::size_t k = 0; k < plan_.distances.size(); ++k) {
      std::vector<Area> at_one;
      for (auto& part : parts) at_one.push_back(std::move(part[k]));
      DOBRA_TRY(Area made, at_one.size() == 1 ? Result<Area>(std::move(at_one[0])) : offset::joined(at_one, progress));
      all.push_back(std::move(made));
    }
    return all;
  }

  [[nodiscard]] std::vector<double> signed_distances() const {
    std::vector<double> all = plan_.distances;
    if (plan_.side == OffsetSide::Left) std::transform(all.begin(), all.end(), all.begin(), std::negate<>());
    return all;
  }

  Session& session_;
  const OffsetPlan& plan_;
  OffsetVerdict& verdict_;
  CutTips cut_;
};

/// A distance below 0 is for polygons: there must be one.
Result<void> check_signs(const std::vector<OffsetBase>& bases, const OffsetPlan& plan) {
  const auto negative = std::find_if(plan.distances.begin(), plan.distances.end(), [](double d) { return d < 0.0; });
  if (negative == plan.distances.end()) return {};
  for (const OffsetBase& base : bases) {
    if (!base.polygons.empty()) return {};
  }
  return Error{
      ErrorCode::BadUsage,
      fmt::format("--distance, --distances: {} must be above 0 for {}, an open line; choose the other side with --side "
                  "left or right",
                  base::number_text(*negative), bases.front().name)};
}

Result<OffsetFamily> dissolved(const std::vector<OffsetFamily>& families, const OffsetPlan& plan,
                               const base::Progress& progress) {
  OffsetFamily all{.name = "dissolved", .content = OffsetContent::Polygons};
  for (const OffsetFamily& family : families)
    all.bases.insert(all.bases.end(), family.bases.begin(), family.bases.end());
  for (std::size_t k = 0; k < plan.distances.size(); ++k) {
    std::vector<Area> parts;
    for (const OffsetFamily& family : families) {
      if (family.content == OffsetContent::Lines) {
        return Error{ErrorCode::BadUsage,
                     fmt::format("--dissolve joins areas, and {} is a curve on one side of a line; give --side both",
                                 family.name)};
      }
      const DrawnOffset& curve = family.curves[k];
      parts.push_back({curve.lines, curve.area.value_or(0.0), curve.length});
    }
    DOBRA_TRY(const Area made, offset::joined(parts, progress));
    all.curves.push_back(drawn(made, plan.distances[k]));
  }
  return all;
}

}  // namespace

Result<OffsetInput> offset_input(Session& session, const std::string& file, const OffsetPlan& plan) {
  // Curves are taken as they stand: a plane, whatever it is, and whatever its unit is.
  io::formats::LineOptions options;
  options.coordinates = io::formats::Coordinates::Section;
  options.y_direction = io::lines::YDirection::Up;
  options.unit_wanted = io::formats::UnitWanted::OfTheFile;
  options.faulty = io::lines::Faulty::Skip;
  DOBRA_TRY(io::formats::LineWork read, io::formats::read_any_lines(file, options));
  for (const std::string& remark : read.remarks) session.note(remark);
  if (read.system && read.system->degrees) {
    session.note(
        fmt::format("{}: its coordinates are in degrees ({}), and so are the distances", file, read.system->name));
  }
  if (read.stated_unit && *read.stated_unit != 1.0) {
    session.note(fmt::format("{}: its unit is {} m, and so is that of the distances", file, *read.stated_unit));
  }
  OffsetInput input{{}, {std::move(read.system), read.stated_unit}};
  std::size_t points = 0;
  for (io::lines::Feature& feature : read.features) {
    if (feature.type == io::lines::FeatureType::Points) {
      ++points;
      continue;
    }
    std::vector<OffsetBase> bases = taken_apart(base_of(std::move(feature), plan.closing), plan);
    for (std::size_t i = 0; i < bases.size(); ++i) {
      const std::string& name = bases[i].source.name;
      bases[i].name = name.empty() ? fmt::format("curve {}", input.bases.size() + 1)
                      : i > 0      ? fmt::format("{} ({})", name, i + 1)
                                   : name;
      input.bases.push_back(std::move(bases[i]));
    }
  }
  if (points > 0) {
    session.note(fmt::format("{}: {} {} of points left out: only lines and polygons are used", file, points,
                             points == 1 ? "feature" : "features"));
  }
  if (input.bases.empty()) {
    return Error{ErrorCode::BadFormat, "there is no line and no polygon in the file", base::Place{.file = file}};
  }
  DOBRA_TRY(input.bases, chosen(std::move(input.bases), plan.curve));
  if (!untreated(plan)) {
    auto mended = mend(session, input.bases);
    if (!mended) return base::located(mended.error(), {.file = file});
    input.mended = *mended;
  }
  return input;
}

Result<std::vector<OffsetFamily>> offset_families(Session& session, const std::string& file, const OffsetInput& input,
                                                  const OffsetPlan& plan, OffsetVerdict& verdict) {
  const base::Progress progress = session.progress();
  DOBRA_TRY_VOID(check_signs(input.bases, plan));
  verdict.mended = input.mended;
  Maker maker(session, plan, verdict);
  std::vector<OffsetFamily> families;
  const double total = static_cast<double>(input.bases.size());
  for (const OffsetBase& base : input.bases) {
    DOBRA_TRY_VOID(session.check());
    const double done = static_cast<double>(families.size());
    auto family = maker.run(base, progress.part(done / total, (done + 1.0) / total));
    if (!family && family.error().code == ErrorCode::BadUsage) return family.error();
    if (!family) return base::located(family.error(), base::Place{.file = file, .item = base.name});
    families.push_back(*std::move(family));
  }
  if (plan.dissolve == Dissolve::Yes) {
    DOBRA_TRY(OffsetFamily all, dissolved(families, plan, progress));
    verdict.joined = verdict.joined || families.size() > 1;
    families.clear();
    families.push_back(std::move(all));
  }
  for (const OffsetFamily& family : families) {
    for (const DrawnOffset& curve : family.curves) note_curve(session, family, curve);
  }
  return families;
}

}  // namespace dobra::cli
