#include "quebra/surfaces/finding_text.h"

#include <fmt/format.h>

namespace quebra::surfaces {

std::string line_of(const dobra::surf::mesh::Finding& finding, bool in_chart) {
  const dobra::base::Place& place = finding.place;
  std::string line = place.item.empty() ? finding.message : fmt::format("{}: {}", place.item, finding.message);
  if (in_chart && place.u && place.v) {
    line += fmt::format("; at (u {:.6g}, v {:.6g})", *place.u, *place.v);
  } else if (place.x && place.y && place.z) {
    line += fmt::format("; at ({:.6g}, {:.6g}, {:.6g})", *place.x, *place.y, *place.z);
  }
  return line;
}

}  // namespace quebra::surfaces
