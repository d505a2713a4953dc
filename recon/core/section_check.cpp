#include "recon/core/section_check.h"

#include <fmt/format.h>

#include "recon/core/section_faces.h"

namespace recon::core {

base::Result<void> refuse_crossings(const Section& section, const SectionFaces& faces) {
  for (const HorizonMeeting& pair : faces.meetings) {
    if (pair.meeting.crossings == 0) continue;
    const Horizon& first = *find_horizon(section, pair.first);
    const Horizon& second = *find_horizon(section, pair.second);
    base::Place place = place_at(pair.meeting.place, fmt::format("horizon '{}'", first.name));
    place.file = first.source.file;
    const std::size_t count = pair.meeting.crossings;
    return base::Error{
        base::ErrorCode::BadSection,
        fmt::format("the line crosses horizon '{}' at {}; correct one of them, or set crossings = \"allow\" "
                    "(--crossings allow) to go on as they are",
                    second.name, count == 1 ? "one place" : fmt::format("{} places", count)),
        place};
  }
  return {};
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

}  // namespace recon::core
