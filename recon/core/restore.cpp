#include "recon/core/restore.h"

#include <fmt/format.h>

#include "shared/base/parallel.h"

namespace recon::core {

namespace {

std::string at_text(geom::Point p) { return fmt::format("({:.6g}, {:.6g})", p.x, p.y); }

void remark_on(const std::string& name, const MappedLine& mapped, std::vector<std::string>& remarks) {
  if (!mapped.tears.empty()) {
    double torn = 0.0;
    const Tear* widest = &mapped.tears.front();
    for (const Tear& tear : mapped.tears) {
      torn += tear.gap;
      if (tear.gap > widest->gap) widest = &tear;
    }
    remarks.push_back(
        fmt::format("horizon '{}' crosses the medial axis of the top at {} places, where the grid is not "
                    "single-valued: its restored line jumps there by "
                    "{:.4g} m in all, most at {} by {:.4g} m",
                    name, mapped.tears.size(), torn, at_text(widest->place), widest->gap));
  }
  if (mapped.beyond_ends > 0) {
    remarks.push_back(
        fmt::format("horizon '{}': {} points lie beyond the ends of the top; there the grid was continued straight",
                    name, mapped.beyond_ends));
  }
  if (mapped.without_column > 0) {
    remarks.push_back(
        fmt::format("horizon '{}': {} points lie in no column of the grid and went with the nearest segment of the top",
                    name, mapped.without_column));
  }
  if (mapped.not_reversible > 0) {
    remarks.push_back(fmt::format(
        "horizon '{}': {} restored points belong to another column of the target grid: restoring back would not "
        "bring them home",
        name, mapped.not_reversible));
  }
}

}  // namespace

base::Result<Restoration> restore(const Section& section, const ColumnMap& map, const RestoreParams& params,
                                  const base::Progress& progress) {
  DOBRA_TRY_VOID(progress.check());
  Restoration restoration;
  restoration.tolerance_percent = params.tolerance;
  restoration.lines = base::parallel_map<MappedLine>(section.horizons.size(), [&](std::size_t i) {
    return progress.cancelled() ? MappedLine{} : map.map(section.horizons[i].line);
  });
  DOBRA_TRY_VOID(progress.check());
  restoration.section = section;
  for (std::size_t i = 0; i < section.horizons.size(); ++i) {
    const Horizon& horizon = section.horizons[i];
    restoration.section.horizons[i].line = restoration.lines[i].after;
    restoration.lengths.push_back(line_length(horizon, restoration.lines[i]));
    remark_on(horizon.name, restoration.lines[i], restoration.remarks);
  }
  restoration.balance = judge_balance(restoration.lengths, params.tolerance);
  restoration.remarks.push_back(
      "constant thickness keeps the length of the top and the depth of every point; area and the length of deeper beds "
      "change");
  restoration.remarks.push_back(
      fmt::format("{}: the greatest change of a bed's length is {:.4g} % (horizon '{}'), the tolerance {:.4g} %",
                  restoration.balance.balanced ? "balanced" : "not balanced",
                  restoration.balance.greatest_change_percent, restoration.balance.worst, params.tolerance));
  progress.report(1.0, "restored");
  return restoration;
}

}  // namespace recon::core
