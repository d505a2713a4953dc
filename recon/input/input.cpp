#include "recon/input/input.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "recon/input/colors.h"
#include "recon/input/import.h"
#include "recon/input/items.h"
#include "recon/input/join.h"
#include "recon/input/line_file.h"
#include "recon/input/mend.h"
#include "recon/input/topography.h"
#include "recon/input/unit_horizons.h"
#include "recon/section/crossings.h"
#include "recon/section/file_rounding.h"
#include "recon/section/rejoin.h"
#include "recon/section/section_faces.h"
#include "shared/geom/place.h"
#include "shared/io/lines/section_ends.h"
#include "shared/scenario/color_table.h"

namespace recon::input {

namespace {

base::Error bad(base::ErrorCode code, std::string message, std::string item) {
  base::Place place;
  place.item = std::move(item);
  return {code, std::move(message), place};
}

base::Result<ReadPieces> read_any(const HorizonInput& input, const ReadSettings& settings,
                                  const dobra::scenario::Context& context) {
  if (input.placed) return ReadPieces{{input.placed->line}, {}, input.placed->trace};
  if (input.file.empty() == input.points.empty()) {
    return base::Error{base::ErrorCode::MissingKey, input.file.empty()
                                                        ? "a line needs file = \"...\" or points = [...]"
                                                        : "a line has both file and points; keep one of them"};
  }
  if (input.file.empty()) {
    ReadPieces read{{geom::Polyline{}}, {}};
    for (const geom::Point p : input.points) read.pieces[0].points.push_back(to_section(p, settings.convention));
    return read;
  }
  const std::string path = (context.folder / input.file).string();
  base::Place place;
  place.file = path;
  auto read = lines_of_file(input, path, settings);
  if (!read) return base::located(read.error(), place);
  return read;
}

/// The chords of the curve that was drawn by the points.
base::Result<void> draw(const HorizonInput& input, const ReadSettings& settings, geom::Polyline& line) {
  geom::DrawnCurve curve{line.points, {}, input.weights};
  const geom::Point origin = to_section({}, settings.convention);
  for (const geom::Point t : input.tangents) curve.tangents.push_back(to_section(t, settings.convention) - origin);
  DOBRA_TRY(geom::Polyline drawn, geom::drawn(curve, input.curve, settings.curves));
  if (drawn.closed) drawn.points.push_back(drawn.points.front());
  line.points = std::move(drawn.points);
  return {};
}

}  // namespace

base::Result<ReadSettings> read_settings(const SectionInput& input) {
  ReadSettings settings;
  settings.convention = {input.y_axis, input.reference, input.unit, input.exaggeration};
  settings.curves.max_angle = input.curve_angle;
  if (input.curve_length) settings.curves.max_length = *input.curve_length;
  settings.plane_tolerance = input.plane_tolerance;
  const auto refuse = [](const std::string& key, const std::string& what) {
    return bad(base::ErrorCode::BadValue, fmt::format("{}: {}", key, what), "input");
  };
  DOBRA_TRY(settings.trace, dobra::scenario::lines::trace_of(input.trace, refuse));
  DOBRA_TRY(settings.fold_axis, dobra::scenario::lines::fold_axis_of(input.fold_axis, refuse));
  return settings;
}

base::Result<ReadPieces> read_pieces(const HorizonInput& input, const ReadSettings& settings,
                                     const dobra::scenario::Context& context) {
  base::Place item;
  item.item = fmt::format("horizon '{}'", input.name);
  auto read = read_any(input, settings, context);
  if (!read) return base::located(read.error(), item);
  for (geom::Polyline& line : read->pieces) {
    if (auto made = draw(input, settings, line); !made) return base::located(made.error(), item);
    const std::size_t before = line.points.size();
    line.closed = false;
    line = geom::without_repeated_points(std::move(line));
    if (line.points.size() < before)
      read->remarks.push_back(fmt::format("{} repeated points dropped", before - line.points.size()));
    if (auto valid = geom::validate(line); !valid) return base::located(valid.error(), item);
  }
  return read;
}

base::Result<ReadLine> read_line(const HorizonInput& input, const ReadSettings& settings,
                                 const dobra::scenario::Context& context) {
  DOBRA_TRY(ReadPieces read, read_pieces(input, settings, context));
  if (read.pieces.size() == 1) return ReadLine{std::move(read.pieces.front()), std::move(read.remarks), read.trace};
  base::Place place;
  place.file = input.file;
  place.item = fmt::format("horizon '{}'", input.name);
  return base::Error{base::ErrorCode::BadSection,
                     fmt::format("the line is in {} pieces; join them into one (join_gaps = ...), or keep one of them",
                                 read.pieces.size()),
                     place};
}

namespace {

base::Result<void> check_names(const SectionInput& input) {
  if (input.horizons.empty() && input.units.empty()) {
    return bad(base::ErrorCode::BadSection, "the section has no horizon; add an [[input.horizon]]", "input");
  }
  for (std::size_t i = 0; i < input.horizons.size(); ++i) {
    const std::string& name = input.horizons[i].name;
    const auto same = [&](const HorizonInput& other) { return other.name == name; };
    if (name.empty())
      return bad(base::ErrorCode::BadSection, "a horizon needs a name", fmt::format("horizon {}", i + 1));
    if (std::any_of(input.horizons.begin(), input.horizons.begin() + static_cast<std::ptrdiff_t>(i), same)) {
      return bad(base::ErrorCode::BadSection, "two horizons have this name; change one of them",
                 fmt::format("horizon '{}'", name));
    }
    const std::string& whole = input.horizons[i].piece_of;
    const auto is_whole = [&](const HorizonInput& other) { return other.name == whole; };
    if (!whole.empty() && std::any_of(input.horizons.begin(), input.horizons.end(), is_whole)) {
      return bad(base::ErrorCode::BadSection,
                 fmt::format("piece_of names '{0}', which is a horizon itself; give that one another name and "
                             "piece_of = \"{0}\" too",
                             whole),
                 fmt::format("horizon '{}'", name));
    }
  }
  return {};
}

/// Takes out the loops of a line, or refuses them.
base::Result<void> treat_self_crossings(section::Horizon& horizon, SelfCrossings wish,
                                        std::vector<std::string>& remarks) {
  const std::string item = fmt::format("horizon '{}'", horizon.name);
  base::Place source = horizon.source;
  source.item = item;
  if (wish == SelfCrossings::Refuse) {
    const std::vector<section::SelfCrossing> crossings = section::self_crossings(horizon.line);
    if (crossings.empty()) return {};
    const base::Error error{
        base::ErrorCode::BadSection,
        fmt::format("the line crosses itself (places: {}); correct it, or cut small loops out: self_crossings = "
                    "\"cut_loops\" (--self-crossings cut_loops)",
                    crossings.size()),
        place_at(crossings.front().place, item)};
    return base::located(error, source);
  }
  auto cut = section::without_loops(horizon.line);
  if (!cut) return base::located(cut.error(), source);
  if (!cut->places.empty()) {
    remarks.push_back(
        fmt::format("{}: small loops cut out: {}, the first at {}", item, cut->places.size(), cut->places.front()));
  }
  horizon.line = std::move(cut->line);
  return {};
}

}  // namespace

namespace {

/// Lines in space of several files lie in one plane only if they are told which.
base::Result<void> check_planes(const HorizonInput& input, const ReadPieces& read, const ReadSettings& settings,
                                std::optional<dobra::io::lines::Trace>& plane) {
  if (!read.trace || settings.trace) return {};
  const bool same = !plane || (plane->x == read.trace->x && plane->y == read.trace->y &&
                               plane->east == read.trace->east && plane->north == read.trace->north);
  if (!plane) plane = read.trace;
  if (same) return {};
  base::Place place;
  place.file = input.file;
  place.item = fmt::format("horizon '{}'", input.name);
  return base::Error{base::ErrorCode::Unclear,
                     "its lines in space lie in another plane, or begin elsewhere, than those of the files before; say "
                     "where the section runs with trace = [x0, y0, x1, y1] in [input]",
                     place};
}

/// The horizons that one input gives: pieces are numbered from the left.
std::vector<section::Horizon> horizons_of(const HorizonInput& wanted, std::vector<geom::Polyline> pieces,
                                          std::vector<std::string>& remarks) {
  for (geom::Polyline& line : pieces) {
    if (line.points.front().x > line.points.back().x) line = geom::reversed(std::move(line));
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const geom::Polyline& a, const geom::Polyline& b) {
    return a.box().centre().x < b.box().centre().x;
  });
  std::vector<section::Horizon> horizons;
  std::vector<std::string> told;
  for (geom::Polyline& line : pieces) {
    section::Horizon horizon{section::HorizonId(), wanted.name, std::move(line), {}, wanted.piece_of, wanted.role};
    horizon.source.file = wanted.file;
    if (pieces.size() > 1) {
      horizon.piece_of = whole_name(horizon);
      horizon.name = fmt::format("{} ({})", wanted.name, horizons.size() + 1);
      const geom::Point from = horizon.line.points.front();
      const geom::Point to = horizon.line.points.back();
      told.push_back(fmt::format("'{}' from {} to {}", horizon.name, from, to));
    }
    horizons.push_back(std::move(horizon));
  }
  if (pieces.size() > 1) {
    remarks.push_back(
        fmt::format("horizon '{}' is in {} pieces, numbered from the left: {}; join_gaps joins those "
                    "whose ends are near",
                    wanted.name, pieces.size(), fmt::join(told, ", ")));
  }
  return horizons;
}

/// Ends between pieces that lie on no fault and no other horizon: the units above and below run together there, unless
/// they are beyond a fault.
void tell_open_ends(ReadSection& read) {
  const section::Section& section = read.section;
  const double near = rounding_of_files(section);
  constexpr double beside = 0.01;  // of the section: what goes on farther was drawn so
  const double far = beside * box_of(section).diagonal();
  for (const section::Horizon& horizon : section.horizons) {
    for (const section::LineEnd end : {section::LineEnd::First, section::LineEnd::Last}) {
      if (is_outermost(section, horizon, end)) continue;
      const geom::Point p = end == section::LineEnd::First ? horizon.line.points.front() : horizon.line.points.back();
      double nearest = std::numeric_limits<double>::infinity();
      for (const section::SectionLine& line : section.lines) {
        if (line.kind == section::LineKind::Fault || line.kind == section::LineKind::Topography)
          nearest = std::min(nearest, geom::distance(line.line, p));
      }
      const auto is_truncated_by = [&](const section::Horizon& other) {
        return whole_name(other) != whole_name(horizon) && geom::distance(other.line, p) <= near;
      };
      if (nearest <= near || std::any_of(section.horizons.begin(), section.horizons.end(), is_truncated_by)) continue;
      const auto tell = [&](const std::string& text) {
        read.remarks.push_back(text);
        read.places[text] = geom::place_at(p, fmt::format("horizon '{}'", horizon.name));
      };
      if (const auto overshoot = overshoot_of(section, horizon, end, far)) {
        tell(words_of(*overshoot));
        continue;
      }
      const std::string gap =
          std::isfinite(nearest) ? fmt::format("{:.4g} m from the nearest fault", nearest) : std::string("on no fault");
      tell(
          fmt::format("horizon '{}' ends at {}, {}, so that the units above and below it run together there; "
                      "snap_to_faults moves ends that are near onto the fault",
                      horizon.name, p, gap));
    }
  }
}

/// The compass points over the ends: as the scenario says, or as the plane of the lines in space runs.
base::Result<void> set_ends(const SectionInput& input, const ReadSettings& settings,
                            const std::optional<dobra::io::lines::Trace>& plane, section::Section& section) {
  if (!input.orientation.empty()) {
    const auto ends = dobra::io::lines::ends_of_text(input.orientation);
    if (!ends) return bad(ends.error().code, "orientation = " + ends.error().message, "input");
    std::tie(section.left_end, section.right_end) = *ends;
    return {};
  }
  std::pair<std::string, std::string> ends;
  if (settings.fold_axis)
    ends = dobra::io::lines::ends_of(dobra::io::lines::azimuth_of(*settings.fold_axis));
  else if (settings.trace)
    ends = dobra::io::lines::ends_of(dobra::io::lines::azimuth_of(*settings.trace));
  else if (plane)
    ends = dobra::io::lines::ends_of(dobra::io::lines::azimuth_of(*plane));
  std::tie(section.left_end, section.right_end) = ends;
  return {};
}

/// The table of colours, with remarks on names that only one of the two has.
base::Result<void> read_colors(const std::string& path, ReadSection& read) {
  DOBRA_TRY(dobra::scene::ColorTable table, dobra::scenario::read_color_table(path));
  std::vector<std::string> names;
  for (const section::Horizon& horizon : read.section.horizons) names.push_back(whole_name(horizon));
  for (const section::Unit& unit : read.section.units) {
    const bool by_itself = unit.piece_of.empty() || dobra::scene::entry_for(table, unit.name, unit.name) != nullptr;
    names.push_back(by_itself ? unit.name : unit.piece_of);
  }
  if (read.section.units.empty()) {
    for (const section::RockUnit& unit : read.section.faces->units) names.push_back(unit.name);
  }
  // Faults and the like may be in the table, but need not be.
  for (const section::SectionLine& line : read.section.lines) {
    if (dobra::scene::entry_for(table, line.name, line.name) != nullptr) names.push_back(line.name);
  }
  for (std::string& remark : dobra::scene::remarks_on(table, names)) read.remarks.push_back(std::move(remark));
  read.section.colors = std::make_shared<const dobra::scene::ColorTable>(std::move(table));
  return {};
}

/// Joins what the inputs of horizons ask for. @pre nothing refers to ids of horizons yet.
base::Result<void> join_gaps(const std::vector<HorizonInput>& horizons, ReadSection& read) {
  std::vector<JoinWish> wishes;
  for (const HorizonInput& horizon : horizons) {
    if (horizon.join_gaps > 0.0)
      wishes.push_back({horizon.piece_of.empty() ? horizon.name : horizon.piece_of, horizon.join_gaps});
  }
  if (wishes.empty()) return {};
  DOBRA_TRY(JoinedPieces joined, join_horizons(std::move(read.section), wishes));
  read.section = std::move(joined.section);
  for (std::size_t i = 0; i < read.section.horizons.size(); ++i) read.section.horizons[i].id = section::HorizonId(i);
  for (std::string& remark : joined.remarks) read.remarks.push_back(std::move(remark));
  return {};
}

}  // namespace

base::Result<ReadSection> read_section(const SectionInput& given, const dobra::scenario::Context& context,
                                       const base::Progress& progress) {
  DOBRA_TRY(const ReadSettings settings, read_settings(given));
  ReadSection result;
  DOBRA_TRY(const SectionInput input, with_lines_of_files(given, settings, context, result.remarks));
  DOBRA_TRY_VOID(check_names(input));
  result.section.convention = settings.convention;
  std::optional<dobra::io::lines::Trace> plane;
  for (std::size_t i = 0; i < input.horizons.size(); ++i) {
    DOBRA_TRY_VOID(progress.check());
    HorizonInput wanted = input.horizons[i];
    wanted.join_gaps = 0.0;  // its pieces are joined when the faults between them are known
    DOBRA_TRY(ReadPieces read, read_pieces(wanted, settings, context));
    DOBRA_TRY_VOID(check_planes(wanted, read, settings, plane));
    for (const std::string& remark : read.remarks) {
      result.remarks.push_back(fmt::format("horizon '{}': {}", wanted.name, remark));
    }
    for (section::Horizon& horizon : horizons_of(wanted, std::move(read.pieces), result.remarks)) {
      horizon.id = section::HorizonId(result.section.horizons.size());
      if (const section::Horizon* same = find_horizon(result.section, horizon.name))
        return bad(base::ErrorCode::BadSection, "a piece of another horizon has this name already; change one of them",
                   fmt::format("horizon '{}'", same->name));
      DOBRA_TRY_VOID(treat_self_crossings(horizon, input.self_crossings, result.remarks));
      result.section.horizons.push_back(std::move(horizon));
    }
    progress.report(static_cast<double>(i + 1) / static_cast<double>(input.horizons.size()), wanted.name);
  }
  result.trace = settings.trace ? settings.trace : plane;
  DOBRA_TRY_VOID(set_ends(input, settings, plane, result.section));
  DOBRA_TRY_VOID(read_items(input, settings, context, result));
  tell_numbered_names(input, result);
  DOBRA_TRY_VOID(read_backdrops(input, context, result.section));
  DOBRA_TRY_VOID(mend(input, result));
  constexpr double same_place = 1e-9;  // of the diagonal
  if (result.section.units.empty()) join_at_branches(result.section, same_place * box_of(result.section).diagonal());
  DOBRA_TRY_VOID(join_gaps(input.horizons, result));
  if (input.horizons_from_units) DOBRA_TRY_VOID(add_horizons_of_units(input.share_edges, result));
  if (input.above_topography == AboveTopography::Leave) DOBRA_TRY_VOID(cut_at_topography(result));
  tell_open_ends(result);
  DOBRA_TRY(section::SectionFaces faces, faces_of(result.section));
  for (std::string& remark : remarks_of(faces, result.section)) result.remarks.push_back(std::move(remark));
  for (const section::MisfitRemark& told : misfit_remarks(faces)) {
    result.places[told.text] = geom::place_at(told.place);
    result.remarks.push_back(told.text);
  }
  result.section.faces = std::make_shared<const section::SectionFaces>(std::move(faces));
  if (!input.colors.empty()) DOBRA_TRY_VOID(read_colors((context.folder / input.colors).string(), result));
  DOBRA_TRY_VOID(take_colors(input, result.section));
  return result;
}

}  // namespace recon::input
