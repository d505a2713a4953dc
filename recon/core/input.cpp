#include "recon/core/input.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/core/crossings.h"
#include "recon/core/items.h"
#include "recon/core/line_file.h"
#include "recon/core/section_faces.h"

namespace recon::core {

namespace {

base::Error bad(base::ErrorCode code, std::string message, std::string item) {
  base::Place place;
  place.item = std::move(item);
  return {code, std::move(message), place};
}

base::Result<ReadLine> given_line(const HorizonInput& input, const Convention& convention) {
  ReadLine read;
  for (const geom::Point p : input.points) read.line.points.push_back(to_section(p, convention));
  const std::size_t before = read.line.points.size();
  read.line = geom::without_repeated_points(std::move(read.line));
  if (read.line.points.size() < before) {
    read.remarks.push_back(fmt::format("{} repeated points dropped", before - read.line.points.size()));
  }
  return read;
}

base::Result<ReadLine> read_any(const HorizonInput& input, const Convention& convention,
                                const dobra::scenario::Context& context) {
  if (input.file.empty() == input.points.empty()) {
    return base::Error{base::ErrorCode::MissingKey, input.file.empty()
                                                        ? "a line needs file = \"...\" or points = [...]"
                                                        : "a line has both file and points; keep one of them"};
  }
  if (input.file.empty()) return given_line(input, convention);
  const std::string path = (context.folder / input.file).string();
  base::Place place;
  place.file = path;
  auto read = line_of_file(input, path, convention);
  if (!read) return base::located(read.error(), place);
  return read;
}

}  // namespace

base::Result<ReadLine> read_line(const HorizonInput& input, const Convention& convention,
                                 const dobra::scenario::Context& context) {
  base::Place item;
  item.item = fmt::format("horizon '{}'", input.name);
  auto read = read_any(input, convention, context);
  if (!read) return base::located(read.error(), item);
  read->line.closed = false;
  if (auto valid = geom::validate(read->line); !valid) return base::located(valid.error(), item);
  return read;
}

namespace {

base::Result<void> check_names(const SectionInput& input) {
  if (input.horizons.empty()) {
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

base::Result<ReadSection> read_section(const SectionInput& input, const dobra::scenario::Context& context,
                                       const base::Progress& progress) {
  DOBRA_TRY_VOID(check_names(input));
  ReadSection result;
  result.section.convention = {input.y_axis, input.reference, input.unit, input.exaggeration};
  for (std::size_t i = 0; i < input.horizons.size(); ++i) {
    DOBRA_TRY_VOID(progress.check());
    const HorizonInput& wanted = input.horizons[i];
    DOBRA_TRY(ReadLine read, read_line(wanted, result.section.convention, context));
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
  DOBRA_TRY_VOID(read_items(input, context, result));
  DOBRA_TRY(SectionFaces faces, faces_of(result.section));
  for (std::string& remark : remarks_of(faces, result.section)) result.remarks.push_back(std::move(remark));
  result.section.faces = std::make_shared<const SectionFaces>(std::move(faces));
  return result;
}

}  // namespace recon::core
