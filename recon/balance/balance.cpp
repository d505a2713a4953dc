#include "recon/balance/balance.h"

#include <algorithm>
#include <cmath>

#include "recon/balance/percent.h"

namespace recon::balance {

namespace {

void set_lengths(LineLength& row) {
  row.length_before = row.before.length;
  row.length_after = row.after.length;
  row.change_percent = percent(row.length_after - row.length_before, row.length_before);
  row.width_before = row.before.regional();
  row.width_after = row.after.regional();
  row.shortening = row.before.shortening();
  row.shortening_percent = percent(row.shortening, row.length_before);
}

}  // namespace

LineLength line_length(const section::Horizon& horizon, const maps::MappedLine& mapped) {
  LineLength row;
  row.horizon = horizon.id;
  row.name = horizon.name;
  row.piece_of = horizon.piece_of;
  row.role = horizon.role;
  row.before = bed_length(horizon.line);
  row.after = bed_length(mapped.after);
  set_lengths(row);
  for (const maps::Tear& tear : mapped.tears) row.torn += tear.gap;

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
  whole.before += piece.before;
  whole.after += piece.after;
  set_lengths(whole);
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

}  // namespace recon::balance
