#include "recon/section/file_rounding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace recon::section {
namespace {

struct NamedLine {
  const geom::Polyline* line;
  std::string name;
};

/// The lines that bound units and blocks.
std::vector<NamedLine> lines_of(const Section& section) {
  std::vector<NamedLine> lines;
  for (const Horizon& horizon : section.horizons)
    lines.push_back({&horizon.line, fmt::format("horizon '{}'", horizon.name)});
  for (const SectionLine& line : section.lines) {
    if (line.kind == LineKind::Fault || line.kind == LineKind::Topography)
      lines.push_back({&line.line, fmt::format("{} '{}'", kind_name(line.kind), line.name)});
  }
  if (section.border) lines.push_back({&*section.border, "border"});
  return lines;
}

/// The lines as a file of that convention has them.
class InFile {
 public:
  InFile(const std::vector<NamedLine>& lines, const Convention& convention) : lines_(lines), convention_(convention) {
    // Heights that grew downwards are differences from the reference.
    double greatest = std::abs(convention.reference);
    for (const NamedLine& line : lines) {
      for (const geom::Point p : line.line->points) {
        const geom::Point in_file = from_section(p, convention);
        greatest = std::max({greatest, std::abs(in_file.x), std::abs(in_file.y)});
        ++points_;
      }
    }
    rounding_ = 16.0 * std::numeric_limits<double>::epsilon() * greatest;
  }

  /// The coarsest that they lie on.
  [[nodiscard]] std::optional<FileGrid> grid() const {
    constexpr int most = 9;
    constexpr double enough = 100.0;  // times the rounding of doubles, which would make anything a multiple
    double scale = 1.0;
    for (int decimals = 0; decimals <= most && 1.0 / scale >= enough * rounding_; ++decimals, scale *= 10.0) {
      if (const auto found = with(scale)) return found;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] bool lies_on(geom::Point p, double scale) const {
    const geom::Point in_file = from_section(p, convention_);
    const auto is_multiple = [&](double value) {
      return std::abs(value - std::round(value * scale) / scale) <= rounding_;
    };
    return is_multiple(in_file.x) && is_multiple(in_file.y);
  }

  [[nodiscard]] std::optional<FileGrid> with(double scale) const {
    constexpr std::size_t one_in = 50;
    const double step = metres_per_unit(convention_.unit) / scale;
    FileGrid grid{step, std::hypot(step, step / convention_.exaggeration), points_, 0, {}, {}};
    for (const NamedLine& line : lines_) {
      const std::size_t before = grid.odd;
      for (const geom::Point p : line.line->points) {
        if (lies_on(p, scale)) continue;
        if (grid.odd++ == 0) grid.odd_line = line.name, grid.odd_place = p;
      }
      if (grid.odd * one_in > points_ || 2 * (grid.odd - before) > line.line->points.size()) return std::nullopt;
    }
    return grid;
  }

  const std::vector<NamedLine>& lines_;
  Convention convention_;
  std::size_t points_ = 0;
  double rounding_ = 0.0;
};

}  // namespace

std::optional<FileGrid> grid_of_files(const Section& section) {
  const std::vector<NamedLine> lines = lines_of(section);
  if (lines.empty()) return std::nullopt;
  std::optional<FileGrid> coarsest;
  // Files of lines may have units of their own.
  for (const Convention& convention :
       {section.convention, Convention{}, Convention{VerticalAxis::Up, 0.0, LengthUnit::Foot, 1.0}}) {
    std::optional<FileGrid> grid = InFile(lines, convention).grid();
    if (grid && (!coarsest || grid->step > coarsest->step)) coarsest = std::move(grid);
  }
  return coarsest;
}

std::optional<double> last_decimal(const Section& section) {
  const std::optional<FileGrid> grid = grid_of_files(section);
  return grid ? std::optional(grid->step) : std::nullopt;
}

double rounding_of_coordinates(const Section& section) {
  constexpr double widest = 1e-4;      // of the diagonal
  constexpr double of_doubles = 1e-9;  // of the bound itself, which is included
  const std::optional<FileGrid> grid = grid_of_files(section);
  return grid ? std::min((1.0 + of_doubles) * grid->cell, widest * box_of(section).diagonal()) : 0.0;
}

}  // namespace recon::section
