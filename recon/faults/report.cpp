#include "recon/faults/report.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/geom/intersect.h"
#include "shared/geom/place.h"

namespace recon::faults {

namespace {

/// Steps and reversals with their places, ends that stand off what they end on.
void add_remarks(const Fault& fault, const std::vector<ProfilePoint>& profile, double tolerance,
                 std::vector<std::string>& remarks) {
  for (std::size_t i = 1; i < profile.size(); ++i) {
    if (profile[i].mark == ProfileMark::None) continue;
    remarks.push_back(
        fmt::format("fault '{}': {} of the separation between horizons '{}' ({:.4g} m) and '{}' ({:.4g} "
                    "m), {:.4g} to {:.4g} m from its higher end",
                    fault.name, name_of(profile[i].mark), profile[i - 1].horizon, profile[i - 1].separation,
                    profile[i].horizon, profile[i].separation, profile[i - 1].distance, profile[i].distance));
  }
  for (const FaultEnd& end : {fault.lower, fault.upper}) {
    if (end.on.empty() || end.gap <= 1e-6 * tolerance) continue;
    remarks.push_back(fmt::format("fault '{}' ends {:.4g} m off fault '{}' at {} and is taken to end on it", fault.name,
                                  end.gap, end.on, end.at));
  }
  if (fault.name != fault.whole) {
    remarks.push_back(
        fmt::format("'{}' does not meet the other pieces of fault '{}' and stands by itself", fault.name, fault.whole));
  }
}

/// Where two lines cross, farther from their ends than the tolerance.
std::optional<geom::Point> crossing_of(const geom::Polyline& a, const geom::Polyline& b, double tolerance) {
  if (!a.box().overlaps(b.box())) return std::nullopt;
  for (std::size_t i = 0; i < a.segment_count(); ++i) {
    for (std::size_t k = 0; k < b.segment_count(); ++k) {
      const geom::Intersection met = geom::intersect(a.segment(i), b.segment(k));
      if (met.kind == geom::IntersectionKind::None) continue;
      const geom::Point at = met.start.point;
      const auto inner = [&](const geom::Polyline& line) {
        return std::min(geom::distance(line.points.front(), at), geom::distance(line.points.back(), at)) > tolerance;
      };
      if (inner(a) && inner(b)) return at;
    }
  }
  return std::nullopt;
}

/// Of two faults that cross one is younger and offsets the other, unless its slip there is nothing.
void remark_on_crossings(const std::vector<Fault>& faults, double tolerance, std::vector<std::string>& remarks) {
  for (std::size_t i = 0; i < faults.size(); ++i) {
    for (std::size_t k = i + 1; k < faults.size(); ++k) {
      const Fault& a = faults[i];
      const Fault& b = faults[k];
      if (a.order > 0 && b.order > 0 && a.order != b.order) continue;
      const auto at = crossing_of(own_line(a), own_line(b), tolerance);
      if (!at) continue;
      remarks.push_back(
          fmt::format("faults '{}' and '{}' cross at {} and neither offsets the other, so that nothing "
                      "says which is younger: give both an order, of which 1 is the youngest, or part the older one "
                      "there",
                      a.name, b.name, *at));
    }
  }
}

/// Faults side by side, of which the tolerance may give the end of a bed to the wrong one.
void remark_on_neighbours(const std::vector<Fault>& faults, double tolerance, std::vector<std::string>& remarks) {
  for (const Fault& a : faults) {
    const geom::Polyline line = own_line(a);
    const std::vector<double> arcs = geom::arc_lengths(line);
    for (const Fault& b : faults) {
      if (b.whole >= a.whole) continue;  // a pair once
      double apart = 0.0;
      for (const double fraction : {0.25, 0.5, 0.75})
        apart = std::max(apart, geom::distance(own_line(b), geom::point_at(line, arcs, fraction * arcs.back())));
      if (apart > 2.0 * tolerance) continue;
      remarks.push_back(fmt::format(
          "faults '{}' and '{}' run {:.4g} m apart or less, and ends within {:.4g} m of a fault are taken to "
          "it: beds, or the fault, may go to the wrong one; give a smaller tolerance (--tolerance)",
          b.name, a.name, apart, tolerance));
    }
  }
}

}  // namespace

base::Result<FaultReport> report_faults(const section::Section& section, const FaultsParams& params) {
  const FaultOptions options{params.tolerance.value_or(0.0)};
  FaultReport report;
  report.tolerance = tolerance_of(section, options);
  DOBRA_TRY(report.faults, faults_of(section, options));
  if (report.faults.empty()) {
    return base::Error{base::ErrorCode::BadSection,
                       "the section has no fault; add an [[input.fault]], or give lines of a file the kind fault "
                       "(--kind 'F*=fault')",
                       base::Place{.item = "faults"}};
  }
  report.cutoffs = cutoffs_of(section, report.faults, options);
  for (std::size_t i = 0; i < report.faults.size(); ++i) {
    const std::vector<std::string>& told = report.cutoffs[i].remarks;
    report.remarks.insert(report.remarks.end(), told.begin(), told.end());
    report.profiles.push_back(profile_of(report.cutoffs[i]));
    add_remarks(report.faults[i], report.profiles[i], report.tolerance, report.remarks);
    if (report.cutoffs[i].pairs.empty() && !report.faults[i].undecided)
      report.remarks.push_back(
          fmt::format("fault '{}' has no cutoffs: no horizon crosses it or ends within {:.4g} m of it",
                      report.faults[i].name, report.tolerance));
  }
  remark_on_crossings(report.faults, report.tolerance, report.remarks);
  remark_on_neighbours(report.faults, report.tolerance, report.remarks);
  DOBRA_TRY(const Blocks blocks, Blocks::make(section, report.faults, options));
  report.blocks = blocks.all();
  for (const Fault& fault : report.faults) {
    const auto wall = blocks.hanging_wall(fault);
    if (!wall && !fault.undecided && !report.blocks.empty()) report.remarks.push_back(to_string(wall.error()));
  }
  if (!report.blocks.empty()) {
    for (std::string& remark : blocks.remarks_on_beds(section)) report.remarks.push_back(std::move(remark));
  } else {
    report.remarks.push_back(
        "there are no blocks, since the horizons and their ends at the faults enclose no area; give a border "
        "([[input.border]]), or a larger tolerance");
  }
  return report;
}

}  // namespace recon::faults
