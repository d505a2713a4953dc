#include "recon/model/stage.h"

#include <fmt/format.h>

#include "recon/section/crossings.h"
#include "recon/section/section_faces.h"
#include "shared/geom/place.h"

namespace recon::model {

namespace {

/// A line of the next section: what no operation on a section can stand on is refused here.
base::Result<geom::Polyline> tidy(geom::Polyline line, const std::string& item, std::vector<std::string>& remarks) {
  const geom::Point start = line.points.front();
  line = geom::without_repeated_points(std::move(line));
  if (line.points.size() < (line.closed ? 3U : 2U)) {
    return base::Error{base::ErrorCode::BadSection, "nothing of it is left after the restoration; take it out before",
                       place_at(start, item)};
  }
  const auto crossings = section::self_crossings(line);
  if (crossings.empty()) return line;
  const geom::Point place = crossings.front().place;
  const base::Error crossed{base::ErrorCode::BadSection,
                            "it crosses itself after the restoration, so that no further step can stand on it; restore "
                            "with another pin or method or with a simpler top (simplify), or stand the grid on the "
                            "input: from = \"input\"",
                            place_at(place, item)};
  if (line.closed) return crossed;
  auto without = section::without_loops(std::move(line));
  if (!without) return crossed;
  remarks.push_back(fmt::format("{}: small loops of the restoration cut out: {}, the first at {}", item,
                                without->places.size(), place));
  return std::move(without->line);
}

}  // namespace

namespace {

/// What `of` says of what was done at a stage.
template <class Of>
decltype(auto) done_at(const Stage& stage, Of&& of) {
  if (stage.moved) return of(*stage.moved);
  if (stage.blockwise) return of(*stage.blockwise);
  return of(*stage.restoration);
}

}  // namespace

bool is_done(const Stage& stage) { return stage.restoration || stage.moved || stage.blockwise; }

const section::Section& section_made(const Stage& stage) {
  return done_at(stage, [](const auto& done) -> const section::Section& { return done.section; });
}

geom::Point forward(const Stage& stage, geom::Point p) {
  if (stage.restoration) return stage.restoration->map.forward(p).at;
  return stage.moved ? stage.moved->forward(p) : stage.blockwise->forward(p);
}

geom::Point inverse(const Stage& stage, geom::Point p) {
  if (stage.restoration) return stage.restoration->map.inverse(p);
  return stage.moved ? stage.moved->inverse(p) : stage.blockwise->inverse(p);
}

geom::Polyline forward(const Stage& stage, const geom::Polyline& line) {
  if (stage.restoration) return stage.restoration->map.forward(line).after;
  return stage.moved ? stage.moved->forward(line) : stage.blockwise->forward(line);
}

geom::Polyline inverse(const Stage& stage, const geom::Polyline& line) {
  if (stage.restoration) return stage.restoration->map.swapped().forward(line).after;
  return stage.moved ? stage.moved->inverse(line) : stage.blockwise->inverse(line);
}

const std::vector<balance::LineLength>& lengths_of(const Stage& stage) {
  return done_at(stage, [](const auto& done) -> const std::vector<balance::LineLength>& { return done.lengths; });
}

const std::vector<balance::UnitRow>& units_of(const Stage& stage) {
  if (stage.restoration) return stage.restoration->ledger.units;
  return stage.moved ? stage.moved->units : stage.blockwise->units;
}

const std::vector<std::string>& remarks_of(const Stage& stage) {
  return done_at(stage, [](const auto& done) -> const std::vector<std::string>& { return done.remarks; });
}

const char* what_was_done(const Stage& stage) {
  return stage.moved ? "move" : stage.blockwise ? "restoration of blocks" : "restoration";
}

base::Result<section::Section> section_after(const Stage& stage, std::vector<std::string>& remarks) {
  section::Section section = section_made(stage);
  for (section::Horizon& horizon : section.horizons) {
    DOBRA_TRY(horizon.line, tidy(std::move(horizon.line), fmt::format("horizon '{}'", horizon.name), remarks));
    if (horizon.line.points.front().x > horizon.line.points.back().x)
      horizon.line = geom::reversed(std::move(horizon.line));
  }
  for (section::SectionLine& line : section.lines) line.line = geom::without_repeated_points(std::move(line.line));
  for (section::Unit& unit : section.units) {
    DOBRA_TRY(unit.contour, tidy(std::move(unit.contour), fmt::format("unit '{}'", unit.name), remarks));
    if (geom::signed_area(unit.contour) < 0.0) unit.contour = geom::reversed(std::move(unit.contour));
  }
  DOBRA_TRY(section::SectionFaces faces, faces_of(section));
  section.faces = std::make_shared<const section::SectionFaces>(std::move(faces));
  return section;
}

}  // namespace recon::model
