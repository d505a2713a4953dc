#include "recon/core/input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/core/crossings.h"
#include "recon/core/items.h"
#include "recon/core/line_file.h"
#include "recon/core/mend.h"
#include "recon/core/section_faces.h"
#include "recon/core/topography.h"

namespace recon::core {

namespace {

base::Error bad(base::ErrorCode code, std::string message, std::string item) {
  base::Place place;
  place.item = std::move(item);
  return {code, std::move(message), place};
}

base::Result<ReadLine> read_any(const HorizonInput& input, const ReadSettings& settings,
                                const dobra::scenario::Context& context) {
  if (input.file.empty() == input.points.empty()) {
    return base::Error{base::ErrorCode::MissingKey, input.file.empty()
                                                        ? "a line needs file = \"...\" or points = [...]"
                                                        : "a line has both file and points; keep one of them"};
  }
  if (input.file.empty()) {
    ReadLine read;
    for (const geom::Point p : input.points) read.line.points.push_back(to_section(p, settings.convention));
    return read;
  }
  const std::string path = (context.folder / input.file).string();
  base::Place place;
  place.file = path;
  auto read = line_of_file(input, path, settings);
  if (!read) return base::located(read.error(), place);
  return read;
}

/// The chords of the curve that was drawn by the points.
base::Result<void> draw(const HorizonInput& input, const ReadSettings& settings, ReadLine& read) {
  geom::DrawnCurve curve{read.line.points, {}, input.weights};
  const geom::Point origin = to_section({}, settings.convention);
  for (const geom::Point t : input.tangents) curve.tangents.push_back(to_section(t, settings.convention) - origin);
  DOBRA_TRY(geom::Polyline drawn, geom::drawn(curve, input.curve, settings.curves));
  if (drawn.closed) drawn.points.push_back(drawn.points.front());
  read.line.points = std::move(drawn.points);
  return {};
}

}  // namespace

base::Result<ReadSettings> read_settings(const SectionInput& input) {
  ReadSettings settings;
  settings.convention = {input.y_axis, input.reference, input.unit, input.exaggeration};
  settings.curves.max_angle = input.curve_angle;
  if (input.curve_length) settings.curves.max_length = *input.curve_length;
  settings.plane_tolerance = input.plane_tolerance;
  if (!input.trace.empty()) {
    if (input.trace.size() != 4)
      return bad(base::ErrorCode::BadValue, "trace needs four numbers: x0, y0, x1, y1 on the map", "input");
    auto trace = dobra::io::trace_between({input.trace[0], input.trace[1]}, {input.trace[2], input.trace[3]});
    if (!trace) return bad(base::ErrorCode::BadValue, trace.error().message, "input");
    settings.trace = *trace;
  }
  if (!input.fold_axis.empty()) {
    if (input.fold_axis.size() != 2 || std::abs(input.fold_axis[1]) >= 90.0)
      return bad(base::ErrorCode::BadValue, "fold_axis needs trend and plunge in degrees, such as [261, 10]", "input");
    settings.fold_axis = {base::Angle::from_degrees(input.fold_axis[0]), base::Angle::from_degrees(input.fold_axis[1])};
  }
  return settings;
}

base::Result<ReadLine> read_line(const HorizonInput& input, const ReadSettings& settings,
                                 const dobra::scenario::Context& context) {
  base::Place item;
  item.item = fmt::format("horizon '{}'", input.name);
  auto read = read_any(input, settings, context);
  if (!read) return base::located(read.error(), item);
  if (auto made = draw(input, settings, *read); !made) return base::located(made.error(), item);
  const std::size_t before = read->line.points.size();
  read->line.closed = false;
  read->line = geom::without_repeated_points(std::move(read->line));
  if (read->line.points.size() < before)
    read->remarks.push_back(fmt::format("{} repeated points dropped", before - read->line.points.size()));
  if (auto valid = geom::validate(read->line); !valid) return base::located(valid.error(), item);
  return read;
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
  }
  return {};
}

/// Takes out the loops of a line, or refuses them.
base::Result<void> treat_self_crossings(Horizon& horizon, SelfCrossings wish, std::vector<std::string>& remarks) {
  const std::string item = fmt::format("horizon '{}'", horizon.name);
  base::Place source = horizon.source;
  source.item = item;
  if (wish == SelfCrossings::Refuse) {
    const std::vector<SelfCrossing> crossings = self_crossings(horizon.line);
    if (crossings.empty()) return {};
    const base::Error error{
        base::ErrorCode::BadSection,
        fmt::format("the line crosses itself ({} places); correct it, or set self_crossings = \"cut_loops\"",
                    crossings.size()),
        place_at(crossings.front().place, item)};
    return base::located(error, source);
  }
  auto cut = without_loops(horizon.line);
  if (!cut) return base::located(cut.error(), source);
  if (!cut->places.empty()) {
    remarks.push_back(fmt::format("{}: {} small loops cut out, the first at ({:.6g}, {:.6g})", item, cut->places.size(),
                                  cut->places.front().x, cut->places.front().y));
  }
  horizon.line = std::move(cut->line);
  return {};
}

}  // namespace

namespace {

/// Lines in space of several files lie in one plane only if they are told which.
base::Result<void> check_planes(const HorizonInput& input, const ReadLine& read, const ReadSettings& settings,
                                std::optional<dobra::io::Trace>& plane) {
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

}  // namespace

base::Result<ReadSection> read_section(const SectionInput& input, const dobra::scenario::Context& context,
                                       const base::Progress& progress) {
  DOBRA_TRY_VOID(check_names(input));
  DOBRA_TRY(const ReadSettings settings, read_settings(input));
  ReadSection result;
  result.section.convention = settings.convention;
  std::optional<dobra::io::Trace> plane;
  for (std::size_t i = 0; i < input.horizons.size(); ++i) {
    DOBRA_TRY_VOID(progress.check());
    const HorizonInput& wanted = input.horizons[i];
    DOBRA_TRY(ReadLine read, read_line(wanted, settings, context));
    DOBRA_TRY_VOID(check_planes(wanted, read, settings, plane));
    for (const std::string& remark : read.remarks) {
      result.remarks.push_back(fmt::format("horizon '{}': {}", wanted.name, remark));
    }
    Horizon horizon{HorizonId(i), wanted.name, std::move(read.line), {}};
    horizon.source.file = wanted.file;
    if (horizon.line.points.front().x > horizon.line.points.back().x)
      horizon.line = geom::reversed(std::move(horizon.line));
    DOBRA_TRY_VOID(treat_self_crossings(horizon, input.self_crossings, result.remarks));
    result.section.horizons.push_back(std::move(horizon));
    progress.report(static_cast<double>(i + 1) / static_cast<double>(input.horizons.size()), wanted.name);
  }
  DOBRA_TRY_VOID(read_items(input, settings, context, result));
  DOBRA_TRY_VOID(read_backdrops(input, context, result.section));
  DOBRA_TRY_VOID(mend(input, result));
  if (input.above_topography == AboveTopography::Leave) DOBRA_TRY_VOID(cut_at_topography(result));
  DOBRA_TRY(SectionFaces faces, faces_of(result.section));
  for (std::string& remark : remarks_of(faces, result.section)) result.remarks.push_back(std::move(remark));
  result.section.faces = std::make_shared<const SectionFaces>(std::move(faces));
  return result;
}

}  // namespace recon::core
