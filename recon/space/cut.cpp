#include "recon/space/cut.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "shared/geom/simplify.h"
#include "shared/io/lines/section_plane.h"

namespace recon::space {

namespace loft = dobra::surf::loft;
namespace scenario = dobra::scenario;
using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

constexpr double greatest_gap = 0.05;  // of the size: what is beyond is no end at a fault any more
constexpr double no_gap = 1e-9;

/// How far the ends of horizons that belong to faults are from their lines here.
double gap_at_faults(const loft::SectionCut& cut, double size, std::vector<loft::Finding>& findings) {
  double most = 0.0;
  for (const loft::CutLine& line : cut.lines) {
    if (line.kind != loft::LineKind::Horizon) continue;
    const auto measure = [&](const std::string& fault, geom::Point end) {
      if (fault.empty()) return;
      double gap = INFINITY;
      for (const loft::CutLine& other : cut.lines) {
        if (other.kind == loft::LineKind::Fault && other.name == fault)
          gap = std::min(gap, geom::distance(other.line, end));
      }
      if (gap <= greatest_gap * size) {
        most = std::max(most, gap);
      } else {
        findings.push_back(
            {"off_fault",
             fmt::format("horizon '{}' ends at fault '{}', which is not near there in this section", line.name, fault),
             {.item = line.name, .x = end.x, .y = end.y}});
      }
    };
    measure(line.first_fault, line.line.points.front());
    measure(line.last_fault, line.line.points.back());
  }
  return most > no_gap * size ? most : 0.0;
}

/// The lines as tables, called "A", or "A (1)", "A (2)", ... where there are several of A.
std::vector<scenario::Table> tables_of(const loft::SectionCut& cut, loft::LineKind kind) {
  std::map<std::string, std::size_t> count, number;
  for (const loft::CutLine& line : cut.lines) {
    if (line.kind == kind) ++count[line.name];
  }
  std::vector<scenario::Table> rows;
  for (const loft::CutLine& line : cut.lines) {
    if (line.kind != kind) continue;
    scenario::Table row;
    const bool whole = count[line.name] == 1;
    row.set("name", whole ? line.name : fmt::format("{} ({})", line.name, ++number[line.name]));
    row.set("points", scenario::Points(line.line.points));
    if (!whole) row.set("piece_of", line.name);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string ends_of(const loft::PlanTrace& trace) {
  const geom::Vector way = trace.corners().back() - trace.corners().front();
  const auto azimuth = base::Angle::from_radians(std::atan2(way.x, way.y));
  const auto [left, right] = dobra::io::lines::ends_of(azimuth);
  return fmt::format("{} - {}", left, right);
}

}  // namespace

Result<CutSection> cut_section(const MadeSurfaces& surfaces, const CutParams& params) {
  DOBRA_TRY(loft::PlanTrace trace, plan_trace(params.trace, "trace"));
  loft::SectionCut cut = loft::cut_along(surfaces.made.surfaces, trace, surfaces.made.size);
  for (loft::CutLine& line : cut.lines) {
    if (params.simplify == 0.0) break;
    DOBRA_TRY(line.line, geom::simplify(line.line, {params.simplify}));
  }
  CutSection made{{}, {}, std::move(trace), std::move(cut.findings), {}};
  std::vector<scenario::Table> horizons = tables_of(cut, loft::LineKind::Horizon);
  std::vector<scenario::Table> faults = tables_of(cut, loft::LineKind::Fault);
  if (horizons.empty()) {
    const geom::Point from = made.trace.corners().front();
    return Error{ErrorCode::BadSection,
                 "no horizon lies under the trace; lay it over the surfaces, which reach from the first section to the "
                 "last",
                 base::Place{.item = "trace", .x = from.x, .y = from.y}};
  }
  made.input.set("orientation", ends_of(made.trace));
  if (made.trace.corners().size() == 2) {
    const geom::Point a = made.trace.corners().front(), b = made.trace.corners().back();
    made.input.set("trace", std::vector<double>{a.x, a.y, b.x, b.y});
  }
  if (const double gap = gap_at_faults(cut, surfaces.made.size, made.findings); gap > 0.0) {
    // A little more than the widest, rounded up, so that the number is short in the file.
    const double step = std::pow(10.0, std::floor(std::log10(gap)) - 1.0);
    const double snap = std::ceil(1.01 * gap / step) * step;
    made.input.set("snap_to_faults", snap);
    made.findings.push_back({"gap_at_fault",
                             fmt::format("between the sections horizons leave up to {:.6g} m to their faults; their "
                                         "ends are moved there (snap_to_faults)",
                                         gap),
                             {}});
  }
  made.input.set("horizon", std::move(horizons));
  if (!faults.empty()) made.input.set("fault", std::move(faults));
  DOBRA_TRY(input::ReadSection read,
            read_section(scenario::from_table<input::SectionInput>(made.input), scenario::Context{}, base::Progress{}));
  made.section = std::move(read.section);
  made.remarks = std::move(read.remarks);
  return made;
}

}  // namespace recon::space
