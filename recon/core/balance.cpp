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
  row.piece_of = horizon.piece_of;
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

namespace {

void add_piece(const LineLength& piece, LineLength& whole) {
  const double length = whole.length_before + piece.length_before;
  whole.depth_mean = (whole.depth_mean * whole.length_before + piece.depth_mean * piece.length_before) / length;
  whole.depth_min = std::min(whole.depth_min, piece.depth_min);
  whole.depth_max = std::max(whole.depth_max, piece.depth_max);
  whole.length_before = length;
  whole.length_after += piece.length_after;
  whole.change_percent = percent(whole.length_after - whole.length_before, whole.length_before);
  whole.width_before += piece.width_before;
  whole.width_after += piece.width_after;
  whole.shortening = whole.width_after - whole.width_before;
  whole.shortening_percent = percent(whole.shortening, whole.width_after);
  whole.torn += piece.torn;
}

}  // namespace

std::vector<LineLength> whole_beds(const std::vector<LineLength>& rows) {
  std::vector<LineLength> beds;
  for (const LineLength& row : rows) {
    const auto same = [&](const LineLength& bed) { return !row.piece_of.empty() && bed.piece_of == row.piece_of; };
    const auto whole = std::find_if(beds.begin(), beds.end(), same);
    if (whole != beds.end()) {
      add_piece(row, *whole);
      continue;
    }
    beds.push_back(row);
    if (!row.piece_of.empty()) beds.back().name = row.piece_of;
  }
  return beds;
}

std::vector<LineLength> totals_of(const std::vector<LineLength>& rows) {
  std::vector<LineLength> totals = whole_beds(rows);
  std::erase_if(totals, [](const LineLength& bed) { return bed.piece_of.empty(); });
  return totals;
}

double inconsistency_percent(const std::vector<LineLength>& rows) {
  if (rows.empty()) return 0.0;
  const std::vector<LineLength> lengths = whole_beds(rows);
  const auto less = [](const LineLength& a, const LineLength& b) { return a.shortening < b.shortening; };
  const auto [least, greatest] = std::minmax_element(lengths.begin(), lengths.end(), less);
  double longest = 0.0;
  for (const LineLength& row : lengths) longest = std::max(longest, row.length_after);
  return percent(greatest->shortening - least->shortening, longest);
}

}  // namespace recon::core
