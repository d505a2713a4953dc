#include "recon/kinematics/amount.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/kinematics/refuse.h"
#include "recon/maps/columns.h"

namespace recon::kinematics {

namespace {

double along_measure(geom::Vector v, Measure measure) { return measure == Measure::Heave ? v.x : v.y; }

base::Error never_so_far(Amount amount, geom::Point at, const char* why) {
  const char* word = amount.as == Measure::Heave ? "heave" : "throw";
  return refused(fmt::format("no point along the fault has a {} of {} m: {}; give slip, or a smaller {}", word,
                             amount.value, why, word),
                 at);
}

}  // namespace

base::Result<double> arc_after(const FaultPath& path, double arc, Amount amount) {
  if (amount.as == Measure::Slip || amount.value == 0.0) return arc + amount.value;
  const std::vector<double> arcs = geom::arc_lengths(path.line);
  const bool up = amount.value > 0.0;
  const std::size_t last = path.line.segment_count() - 1;
  std::size_t i = 0;
  while (i < last && (up ? arcs[i + 1] <= arc : arcs[i + 1] < arc)) ++i;
  double left = std::abs(amount.value);
  double sense = 0.0;
  geom::Point at = geom::point_at(path.line, arcs, arc);
  for (;;) {
    const geom::Vector unit = geom::normalised(path.line.segment(i).vector());
    const double rate = (up ? 1.0 : -1.0) * along_measure(unit, amount.as);
    if (sense * rate < 0.0) return never_so_far(amount, at, "it turns back here");
    if (rate != 0.0) sense = rate > 0.0 ? 1.0 : -1.0;
    const bool ends = up ? i == last : i == 0;
    const double room = up ? arcs[i + 1] - arc : arc - arcs[i];
    const double needed = rate == 0.0 ? maps::infinity : left / std::abs(rate);
    if (needed <= room || (ends && rate != 0.0)) return up ? arc + needed : arc - needed;
    if (ends) return never_so_far(amount, at, amount.as == Measure::Heave ? "it goes on upright" : "it goes on level");
    left -= std::max(room, 0.0) * std::abs(rate);
    arc = up ? arcs[i + 1] : arcs[i];
    at = path.line.points[up ? i + 1 : i];
    i = up ? i + 1 : i - 1;
  }
}

}  // namespace recon::kinematics
