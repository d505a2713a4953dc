#include "shared/base/finding_text.h"

namespace dobra::base {

std::string line_of(const Finding& finding) {
  const Place& place = finding.place;
  return to_string({ErrorCode::BadSection, finding.message, Place{.x = place.x, .y = place.y, .z = place.z}});
}

}  // namespace dobra::base
