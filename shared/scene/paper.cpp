#include "shared/scene/paper.h"

#include <fmt/format.h>

#include <cmath>

#include "shared/scene/layout.h"

namespace dobra::scene {

double paper_height(double width) { return width / a4_landscape.width * a4_landscape.height; }

std::string ratio_text(double scale) {
  const double n = points_per_metre / scale;
  if (n < 0.999) return fmt::format("{:.4g}:1", 1.0 / n);
  std::string digits = fmt::format("{:.10g}", n);
  if (digits.find_first_of(".e") == std::string::npos) {
    for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, "\u202f");
  }
  return "1:" + digits;
}

double usual_width(const Picture& picture) { return picture.paper == Paper::A4Landscape ? a4_landscape.width : 720.0; }

double round_ratio(double points_per_metre_of_world) {
  const double least = points_per_metre / points_per_metre_of_world * (1.0 - 1e-9);
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5}) {
    if (factor * decade >= least) return factor * decade;
  }
  return 10.0 * decade;
}

}  // namespace dobra::scene
