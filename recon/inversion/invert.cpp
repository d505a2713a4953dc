#include "recon/inversion/invert.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "recon/faults/cutoffs.h"
#include "recon/inversion/limits.h"
#include "recon/inversion/shear_fit.h"
#include "recon/inversion/trishear_fit.h"
#include "shared/base/text.h"

namespace recon::inversion {

namespace {

/// The two values of the map among those that are sought.
base::Result<std::array<std::size_t, 2>> axes_of(const std::vector<Unknown>& unknowns,
                                                 const std::vector<std::string>& names) {
  std::vector<std::string> free;
  for (const Unknown& unknown : unknowns) {
    if (!unknown.fixed()) free.push_back(unknown.key);
  }
  std::array<std::size_t, 2> axes{};
  for (std::size_t i = 0; i < 2; ++i) {
    const bool known = names.size() == 2 && std::find(free.begin(), free.end(), names[i]) != free.end();
    if (!known || names[0] == names[1]) {
      return base::Error{base::ErrorCode::BadValue,
                         fmt::format("'map' takes two different values of those that are sought ({}), not [{}]",
                                     fmt::join(free, ", "), fmt::join(names, ", "))};
    }
    axes[i] = static_cast<std::size_t>(
        std::find_if(unknowns.begin(), unknowns.end(), [&](const Unknown& u) { return u.key == names[i]; }) -
        unknowns.begin());
  }
  return axes;
}

/// The model and the values of a method, and what it draws.
struct Task {
  Model model;
  std::vector<std::vector<Unknown>> unknowns;  ///< Alternatives.
  std::vector<std::string> remarks;
};

base::Result<Task> task_of(const section::Section& section, const std::vector<BedShape>& beds,
                           const InvertParams& params, double size) {
  Task task;
  if (params.method == InvertMethod::Trishear) {
    task.model = trishear_model(size);
    DOBRA_TRY(task.unknowns, trishear_unknowns(section, beds, params, task.remarks));
  } else {
    DOBRA_TRY(ShearTask shear, shear_task(section, beds, params));
    task.model = std::move(shear.model);
    task.unknowns = {std::move(shear.unknowns)};
  }
  return task;
}

void draw_best(const section::Section& section, const Model& model, double size, Inversion& inversion) {
  const std::vector<double> values = inversion.fit.values();
  const std::optional<Restore> restore = model(values, Precision::Full);
  for (const section::Horizon& horizon : section.horizons) {
    const auto& beds = inversion.fit.beds;
    if (!restore ||
        std::none_of(beds.begin(), beds.end(), [&](const BedMisfit& bed) { return bed.name == whole_name(horizon); }))
      continue;
    geom::Polyline line;
    for (const geom::Point p : horizon.line.points) line.points.push_back((*restore)(p));
    inversion.restored.push_back(std::move(line));
    inversion.restored_names.push_back(horizon.name);
  }
  if (inversion.params.method != InvertMethod::Trishear) return;
  inversion.fault = ramp_line(values, 0.4 * size);
  inversion.triangle = triangle_sides(values, 0.3 * size);
}

/// The section with beds that end where the faults cut them off: what reaches past a fault is of no block.
section::Section ended_on_faults(section::Section section) {
  const faults::FaultOptions options;
  const auto all = faults::faults_of(section, options);
  if (!all) return section;
  const std::vector<faults::FaultCutoffs> cutoffs = faults::cutoffs_of(section, *all, options);
  for (section::Horizon& horizon : section.horizons) faults::reach_faults(cutoffs, 0.0, horizon);
  return section;
}

}  // namespace

base::Result<Inversion> invert(const section::Section& section, const InvertParams& params,
                               const base::Progress& progress) {
  DOBRA_TRY_VOID(check_keys(params));
  DOBRA_TRY(const std::vector<BedShape> beds, bed_shapes(ended_on_faults(section), params.horizon));
  const double size = box_of(section).diagonal();
  DOBRA_TRY(const Task task, task_of(section, beds, params, size));
  std::array<std::size_t, 2> axes{};
  if (!params.map.empty()) {
    DOBRA_TRY(axes, axes_of(task.unknowns.front(), params.map));
  }
  const FitOptions options{static_cast<std::uint64_t>(params.seed), params.generations, params.confidence,
                           params.bedding, size};
  Inversion inversion;
  inversion.params = params;
  const double until = params.map.empty() ? 1.0 : 0.6;
  DOBRA_TRY(inversion.fit, fit_beds(beds, task.unknowns, task.model, options, progress.part(0.0, until)));
  if (!params.map.empty()) {
    std::vector<Unknown> unknowns;
    for (const Estimate& estimate : inversion.fit.estimates) unknowns.push_back(estimate.unknown);
    DOBRA_TRY(inversion.map,
              map_misfit(beds, unknowns, task.model, inversion.fit, axes, static_cast<std::size_t>(params.map_points),
                         options, progress.part(until, 1.0)));
  }
  draw_best(section, task.model, size, inversion);
  inversion.remarks = task.remarks;
  inversion.remarks.insert(inversion.remarks.end(), inversion.fit.remarks.begin(), inversion.fit.remarks.end());
  return inversion;
}

}  // namespace recon::inversion
