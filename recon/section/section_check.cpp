#include "recon/section/section_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/section/section_faces.h"
#include "shared/geom/place.h"

namespace recon::section {

base::Result<void> refuse_crossings(const Section& section, const SectionFaces& faces) {
  std::vector<const HorizonMeeting*> crossings;
  for (const HorizonMeeting& pair : faces.meetings) {
    if (pair.meeting.crossings > 0) crossings.push_back(&pair);
  }
  if (crossings.empty()) return {};
  const auto name_of = [&](HorizonId id) { return find_horizon(section, id)->name; };
  const LineMeeting& meeting = crossings.front()->meeting;
  const Horizon& first = *find_horizon(section, crossings.front()->first);
  base::Place place = place_at(meeting.place, fmt::format("horizon '{}'", first.name));
  place.file = first.source.file;
  std::string more;
  constexpr std::size_t most = 10;
  for (std::size_t i = 1; i < std::min(crossings.size(), most); ++i) {
    const geom::Point at = crossings[i]->meeting.place;
    more += fmt::format("{} '{}' crosses '{}' at {}", i == 1 ? "; so do others:" : ",", name_of(crossings[i]->first),
                        name_of(crossings[i]->second), at);
  }
  if (crossings.size() > most) more += fmt::format(", and more pairs: {}", crossings.size() - most);
  return base::Error{
      base::ErrorCode::BadSection,
      fmt::format("the line crosses horizon '{}' at {}{}; correct them, or set crossings = \"allow\" (--crossings "
                  "allow) to go on as they are",
                  name_of(crossings.front()->second),
                  meeting.crossings == 1 ? "one place" : fmt::format("{} places", meeting.crossings), more),
      place};
}

base::Result<void> refuse_lines_outside(const Section& section) {
  geom::Box box;
  for (const Horizon& horizon : section.horizons) box.add(horizon.line.box());
  for (const SectionLine& line : section.lines) {
    if (line.kind != LineKind::Pin && line.kind != LineKind::Loose) continue;
    if (box.overlaps(line.line.box())) continue;
    base::Place place =
        place_at(line.line.points.front(), fmt::format("{} line '{}'", kind_name(line.kind), line.name));
    place.file = line.source.file;
    return base::Error{
        base::ErrorCode::BadSection,
        fmt::format("it lies outside the section, whose horizons reach from x = {:.6g} to {:.6g} and from "
                    "z = {:.6g} to {:.6g}; move it",
                    box.low.x, box.high.x, box.low.y, box.high.y),
        place};
  }
  return {};
}

base::Result<void> check_section(Section& section, Crossings crossings) {
  if (!section.faces) {
    DOBRA_TRY(SectionFaces faces, faces_of(section));
    section.faces = std::make_shared<const SectionFaces>(std::move(faces));
  }
  if (crossings == Crossings::Refuse) DOBRA_TRY_VOID(refuse_crossings(section, *section.faces));
  return refuse_lines_outside(section);
}

}  // namespace recon::section
