#include "recon/section/file_rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace recon::section {
namespace {

/// The lines that bound units and blocks.
std::vector<const geom::Polyline*> lines_of(const Section& section) {
  std::vector<const geom::Polyline*> lines;
  for (const Horizon& horizon : section.horizons) lines.push_back(&horizon.line);
  for (const SectionLine& line : section.lines) {
    if (line.kind == LineKind::Fault || line.kind == LineKind::Topography) lines.push_back(&line.line);
  }
  if (section.border) lines.push_back(&*section.border);
  return lines;
}

}  // namespace

std::optional<double> last_decimal(const Section& section) {
  constexpr int most = 9;
  const std::vector<const geom::Polyline*> lines = lines_of(section);
  // Heights that grew downwards are differences from the reference.
  double greatest = std::abs(section.convention.reference) * metres_per_unit(section.convention.unit);
  for (const geom::Polyline* const line : lines) {
    for (const geom::Point p : line->points) greatest = std::max({greatest, std::abs(p.x), std::abs(p.y)});
  }
  const double rounding = 16.0 * std::numeric_limits<double>::epsilon() * greatest;
  int decimals = 0;
  double scale = 1.0;
  for (const geom::Polyline* const line : lines) {
    for (const geom::Point p : line->points) {
      for (const double value : {p.x, p.y}) {
        while (std::abs(value - std::round(value * scale) / scale) > rounding) {
          if (++decimals > most) return std::nullopt;
          scale *= 10.0;
        }
      }
    }
  }
  constexpr double enough = 100.0;  // times the rounding of doubles, which would make anything a multiple
  if (lines.empty() || 1.0 / scale < enough * rounding) return std::nullopt;
  return 1.0 / scale;
}

double rounding_of_coordinates(const Section& section) {
  constexpr double widest = 1e-4;      // of the diagonal
  constexpr double of_doubles = 1e-9;  // of the bound itself, which is included
  const std::optional<double> decimal = last_decimal(section);
  if (!decimal) return 0.0;
  return std::min((1.0 + of_doubles) * std::sqrt(2.0) * *decimal, widest * box_of(section).diagonal());
}

}  // namespace recon::section
