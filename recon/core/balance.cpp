#include "recon/core/balance.h"

#include <algorithm>
#include <cmath>

namespace recon::core {

namespace {

double width(const geom::Polyline& line) { return std::abs(line.points.back().x - line.points.front().x); }

double percent(double part, double whole) { return whole == 0.0 ? 0.0 : 100.0 * part / whole; }

}  // namespace

LineLength line_length(const Horizon& horizon, const MappedLine& mapped) {
  LineLength row;
  row.horizon = horizon.id;
  row.name = horizon.name;
  row.length_before = geom::length(horizon.line);
  row.length_after = geom::length(mapped.after);
  row.change_percent = percent(row.length_after - row.length_before, row.length_before);
  row.width_before = width(horizon.line);
  row.width_after = width(mapped.after);
  row.shortening = row.width_after - row.width_before;
  row.shortening_percent = percent(row.shortening, row.width_after);
  for (const Tear& tear : mapped.tears) row.torn += tear.gap;

  row.depth_min = row.depth_max = mapped.names.front().depth;
  double weighted = 0.0;
  double weight = 0.0;
  for (std::size_t i = 0; i < mapped.names.size(); ++i) {
    const double depth = mapped.names[i].depth;
    row.depth_min = std::min(row.depth_min, depth);
    row.depth_max = std::max(row.depth_max, depth);
    if (i == 0) continue;
    const double piece = std::sqrt(geom::length_squared(mapped.before.points[i] - mapped.before.points[i - 1]));
    weighted += piece * 0.5 * (mapped.names[i - 1].depth + depth);
    weight += piece;
  }
  row.depth_mean = weight > 0.0 ? weighted / weight : row.depth_min;
  return row;
}

double inconsistency_percent(const std::vector<LineLength>& lengths) {
  if (lengths.empty()) return 0.0;
  const auto less = [](const LineLength& a, const LineLength& b) { return a.shortening < b.shortening; };
  const auto [least, greatest] = std::minmax_element(lengths.begin(), lengths.end(), less);
  double longest = 0.0;
  for (const LineLength& row : lengths) longest = std::max(longest, row.length_after);
  return percent(greatest->shortening - least->shortening, longest);
}

}  // namespace recon::core
