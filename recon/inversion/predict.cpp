#include "recon/inversion/predict.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "recon/balance/area_depth.h"
#include "recon/faults/cutoffs.h"
#include "recon/inversion/fold_angles.h"
#include "recon/inversion/rollover.h"
#include "recon/kinematics/block_map.h"
#include "recon/kinematics/shear.h"
#include "shared/geom/arc_length.h"
#include "shared/geom/intersect.h"
#include "shared/geom/place.h"

namespace recon::inversion {

namespace {

constexpr double flat_to = 2.0;  ///< Degrees from the regional.

using Figures = std::vector<std::pair<std::string, double>>;

base::Error bad_value(std::string message) { return {base::ErrorCode::BadValue, std::move(message)}; }

/// Nothing is given that the prediction has no use for.
base::Result<void> check_predict(const PredictParams& params) {
  using enum Prediction;
  const Prediction what = *params.what;
  const bool fold = what == FaultBendFold || what == FaultPropagationFold;
  const auto useless = [&](bool given, const char* key, bool of_use) -> base::Result<void> {
    if (!given || of_use) return {};
    return bad_value(fmt::format("'{}' is of no use to the prediction of a {}, so leave it out", key, name_of(what)));
  };
  DOBRA_TRY_VOID(useless(!params.fault.empty(), "fault", !fold));
  DOBRA_TRY_VOID(useless(!params.horizon.empty(), "horizon", !fold));
  DOBRA_TRY_VOID(useless(params.elevation.has_value(), "elevation", what == Rollover));
  DOBRA_TRY_VOID(useless(params.slip.has_value(), "slip", what == Rollover));
  DOBRA_TRY_VOID(useless(params.heave.has_value(), "heave", what == Rollover));
  DOBRA_TRY_VOID(useless(params.angle.radians() != 0.0, "angle", !fold));
  DOBRA_TRY_VOID(useless(params.bedding.radians() != 0.0, "bedding", !fold));
  DOBRA_TRY_VOID(useless(params.backlimb.has_value(), "backlimb", fold));
  DOBRA_TRY_VOID(useless(params.forelimb.has_value(), "forelimb", fold));
  if (fold) return {};
  if (params.fault.empty()) return bad_value(fmt::format("name the 'fault' of the {}", name_of(what)));
  if (what == Fault && params.horizon.empty()) return bad_value("name the 'horizon' whose rollover tells the fault");
  if (what == Rollover && params.horizon.empty() == !params.elevation)
    return bad_value(
        "a rollover takes either the 'horizon' whose footwall cutoff its regional goes through, or the "
        "'elevation' of that");
  if (what == Rollover && params.slip.has_value() == params.heave.has_value())
    return bad_value(fmt::format("give one of slip and heave, not {}", params.slip ? "both" : "none"));
  return {};
}

/// The fault of the prediction and the cutoffs of its horizon.
struct FaultAndCutoffs {
  faults::Fault fault;
  std::optional<faults::Cutoff> hanging, foot;
  std::vector<faults::CutoffPair> pairs;  ///< Of all horizons.
};

base::Result<FaultAndCutoffs> fault_of(const section::Section& section, const PredictParams& params) {
  DOBRA_TRY(const std::vector<faults::Fault> all, faults::faults_of(section, {}));
  DOBRA_TRY(const faults::Fault* fault, faults::find_fault(all, params.fault));
  if (fault->undecided) return *fault->undecided;
  FaultAndCutoffs found{*fault, {}, {}, {}};
  if (params.horizon.empty()) return found;
  for (const faults::FaultCutoffs& cutoffs : faults::cutoffs_of(section, all, {})) {
    if (cutoffs.fault != fault->name) continue;
    found.pairs = cutoffs.pairs;
    for (const faults::CutoffPair& pair : cutoffs.pairs) {
      if (pair.horizon != params.horizon) continue;
      if (!found.hanging) found.hanging = pair.hanging_wall;
      if (!found.foot) found.foot = pair.footwall;
    }
  }
  if (found.foot && (found.hanging || *params.what == Prediction::Rollover)) return found;
  return base::Error{base::ErrorCode::BadSection,
                     fmt::format("horizon '{}' has no cutoff on the {} of fault '{}'; extend it to the fault",
                                 params.horizon, found.foot ? "hanging wall" : "footwall", params.fault),
                     place_at(fault->path.line.points.back(), "fault")};
}

/// The path from a higher place on it down to a lower one.
geom::Polyline down_between(const kinematics::FaultPath& path, const faults::Cutoff& high, const faults::Cutoff& low) {
  const std::vector<double> arcs = geom::arc_lengths(path.line);
  const double near = 1e-9 * arcs.back();
  geom::Polyline part;
  part.points.push_back(high.at);
  for (std::size_t i = arcs.size(); i-- > 0;) {
    if (arcs[i] < high.arc - near && arcs[i] > low.arc + near) part.points.push_back(path.line.points[i]);
  }
  part.points.push_back(low.at);
  return part;
}

/// The bed from its cutoff away from the fault.
geom::Polyline bed_from(const section::Section& section, const faults::Cutoff& cutoff) {
  geom::Polyline bed = find_horizon(section, cutoff.piece)->line;
  if (cutoff.end == section::LineEnd::Last) std::reverse(bed.points.begin(), bed.points.end());
  bed.points.front() = cutoff.at;
  return bed;
}

/// How far the fault as drawn lies from the one predicted, along the direction of shear: at its corners below the known
/// part; root of the mean square, m.
std::optional<double> misfit_of_drawn(const kinematics::FaultPath& path, double below, const geom::Polyline& predicted,
                                      base::Angle shear) {
  const geom::Vector along{std::sin(shear.radians()), std::cos(shear.radians())};
  const double reach = predicted.box().diagonal() + path.line.box().diagonal();
  const std::vector<double> arcs = geom::arc_lengths(path.line);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (arcs[i] >= below) continue;
    const geom::Point p = path.line.points[i];
    const geom::Segment line{p - reach * along, p + reach * along};
    for (std::size_t k = 0; k < predicted.segment_count(); ++k) {
      const auto hit = geom::intersect(line, predicted.segment(k));
      if (hit.kind == geom::IntersectionKind::None) continue;
      const double off = geom::dot(hit.start.point - p, along);
      sum += off * off;
      ++count;
      break;
    }
  }
  if (count == 0) return std::nullopt;
  return std::sqrt(sum / static_cast<double>(count));
}

/// Where all beds with rollovers over the fault place its detachment by the ledger's area-depth line: the area that
/// each has lost grows with its height over the detachment. Independent of the chain of one bed.
void add_depth_of_beds(const section::Section& section, const FaultAndCutoffs& from, const PredictParams& params,
                       Figures& figures, std::vector<std::string>& remarks) {
  std::vector<double> levels, areas;
  for (const faults::CutoffPair& pair : from.pairs) {
    if (!pair.hanging_wall || !pair.footwall || pair.hanging_wall->arc >= pair.footwall->arc) continue;
    const auto found = fault_under({down_between(from.fault.path, *pair.footwall, *pair.hanging_wall),
                                    bed_from(section, *pair.hanging_wall), params.bedding, params.angle});
    if (!found || found->end_dip.degrees() > flat_to) continue;
    levels.push_back(pair.footwall->at.y);
    areas.push_back(found->lost_area);
  }
  const auto fit =
      levels.size() < 2 ? std::nullopt : balance::fit_area_depth(levels, areas, 95.0, box_of(section).diagonal());
  if (fit && fit->detachment) {
    figures.emplace_back("detachment_by_area_depth", *fit->detachment);
    figures.emplace_back("displacement_by_area_depth", fit->displacement);
    if (fit->detachment_error) figures.emplace_back("detachment_by_area_depth_error", *fit->detachment_error);
  } else {
    remarks.push_back(
        fmt::format("area-depth tells no detachment: it takes two beds at different levels whose rollovers "
                    "reach over the flat, and here are {}",
                    levels.size()));
  }
}

/// The detachment where the predicted fault is flat, and what makes it doubtful.
void add_flat(const PredictedFault& found, Figures& figures, std::vector<std::string>& remarks) {
  if (found.end_dip.degrees() <= flat_to) {
    figures.emplace_back("detachment_by_fault", found.end.y);
  } else {
    remarks.push_back(fmt::format(
        "the fault still dips {:.3g} degrees to the regional where the rollover ends, at {}: it flattens below that, "
        "and the detachment lies deeper than z = {:.6g} m; follow the bed farther from the fault",
        found.end_dip.degrees(), found.end, found.end.y));
  }
  if (found.steps > 20) {
    remarks.push_back(
        fmt::format("the shift goes {} times into the rollover: errors of the bed add up {} "
                    "times at its end",
                    found.steps, found.steps));
  }
}

base::Result<Predicted> predict_fault(const section::Section& section, const PredictParams& params) {
  DOBRA_TRY(const FaultAndCutoffs from, fault_of(section, params));
  const faults::Cutoff& hanging = *from.hanging;
  const faults::Cutoff& foot = *from.foot;
  if (hanging.arc >= foot.arc) {
    return base::Error{base::ErrorCode::BadSection,
                       fmt::format("horizon '{}' is not down in the hanging wall of fault '{}', so that it has no "
                                   "rollover",
                                   params.horizon, params.fault),
                       place_at(hanging.at, "fault")};
  }
  DOBRA_TRY(const PredictedFault found, fault_under({down_between(from.fault.path, foot, hanging),
                                                     bed_from(section, hanging), params.bedding, params.angle}));
  Predicted predicted;
  predicted.params = params;
  predicted.lines = {{"fault", found.line}, {"regional", found.regional}};
  Figures figures{{"shift", found.shift},
                  {"steps", static_cast<double>(found.steps)},
                  {"end_dip", found.end_dip.degrees()},
                  {"end_x", found.end.x},
                  {"end_z", found.end.y},
                  {"lost_area", found.lost_area},
                  {"detachment_by_area", found.area_place.y},
                  {"depth_by_area", found.area_depth}};
  add_flat(found, figures, predicted.remarks);
  if (const auto misfit = misfit_of_drawn(from.fault.path, hanging.arc, found.line, params.angle))
    figures.emplace_back("drawn_fault_misfit", *misfit);
  add_depth_of_beds(section, from, params, figures, predicted.remarks);
  predicted.solutions.push_back(std::move(figures));
  return predicted;
}

/// Where the regional of a rollover meets the fault: at a cutoff, or at an elevation.
base::Result<double> regional_arc(const FaultAndCutoffs& from, const PredictParams& params) {
  if (from.foot) return from.foot->arc;
  const geom::Polyline& line = from.fault.path.line;
  const std::vector<double> arcs = geom::arc_lengths(line);
  const double z = *params.elevation;
  for (std::size_t i = line.segment_count(); i-- > 0;) {
    const geom::Segment s = line.segment(i);
    if ((s.from.y - z) * (s.to.y - z) > 0.0 || s.from.y == s.to.y) continue;
    return arcs[i] + (z - s.from.y) / (s.to.y - s.from.y) * s.length();
  }
  return base::Error{
      base::ErrorCode::BadValue,
      fmt::format("fault '{}' lies between z = {:.6g} and {:.6g} m, so that no regional at {:.6g} m meets it",
                  params.fault, line.box().low.y, line.box().high.y, z)};
}

base::Result<Predicted> predict_rollover(const section::Section& section, const PredictParams& params) {
  DOBRA_TRY(const FaultAndCutoffs from, fault_of(section, params));
  const kinematics::FaultPath& path = from.fault.path;
  DOBRA_TRY(const double arc, regional_arc(from, params));
  const kinematics::Amount amount{params.slip ? kinematics::Measure::Slip : kinematics::Measure::Heave,
                                  params.slip ? *params.slip : *params.heave};
  const bool to_plus = path.line.points.back().x > path.line.points.front().x;
  DOBRA_TRY(const double h, kinematics::shear_heave(path, params.angle, arc, amount));
  DOBRA_TRY(const maps::SectionMap map, kinematics::shear_over(path, params.angle, h));
  const geom::Point start = kinematics::point_at(path, arc);
  geom::Box box = box_of(section);
  const double reach = box.diagonal() + geom::length(path.line);
  const geom::Vector bedding{std::cos(params.bedding.radians()), std::sin(params.bedding.radians())};
  const geom::Vector away = to_plus ? -bedding : bedding;  // of a fault that rises to +x the hanging wall lies to -x
  geom::Polyline regional{{start, start + reach * away}, false};
  // As far as the fault is known.
  const double end = to_plus ? path.line.box().low.x : path.line.box().high.x;
  if (std::abs(away.x) > 0.0) regional.points[1] = start + std::abs((end - start.x) / away.x) * away;
  Predicted predicted;
  predicted.params = params;
  const geom::Polyline bed = kinematics::BlockMap(map).forward(regional).after;
  predicted.lines = {{"bed", bed}, {"regional", regional}};
  const auto lowest =
      std::min_element(bed.points.begin(), bed.points.end(), [](geom::Point a, geom::Point b) { return a.y < b.y; });
  predicted.solutions.push_back({{"shear_heave", h},
                                 {"regional_x", start.x},
                                 {"regional_z", start.y},
                                 {"cutoff_x", bed.points.front().x},
                                 {"cutoff_z", bed.points.front().y},
                                 {"lowest_x", lowest->x},
                                 {"lowest_z", lowest->y}});
  return predicted;
}

base::Result<Predicted> predict_bend_fold(const PredictParams& params) {
  DOBRA_TRY(const auto folds, bend_folds_of({params.backlimb, params.forelimb}));
  Predicted predicted;
  predicted.params = params;
  for (const kinematics::BendFold& fold : folds) {
    const double gamma = fold.gamma.degrees();
    predicted.solutions.push_back({{"ramp", fold.theta.degrees()},
                                   {"phi", fold.phi.degrees()},
                                   {"gamma", gamma},
                                   {"beta", fold.beta.degrees()},
                                   {"forelimb", 180.0 - 2.0 * gamma},
                                   {"slip_ratio", fold.slip_ratio}});
  }
  if (folds.size() == 2) {
    predicted.remarks.push_back(
        fmt::format("two folds have this backlimb: an open one with a forelimb of {:.4g} degrees, "
                    "and a tight one of {:.4g}; the dip of the forelimb tells which",
                    180.0 - 2.0 * folds[0].gamma.degrees(), 180.0 - 2.0 * folds[1].gamma.degrees()));
  }
  return predicted;
}

base::Result<Predicted> predict_propagation_fold(const PredictParams& params) {
  DOBRA_TRY(const PropagationFold fold, propagation_fold_of({params.backlimb, params.forelimb}));
  Predicted predicted;
  predicted.params = params;
  const kinematics::PropagationAngles& a = fold.angles;
  predicted.solutions.push_back({{"ramp", a.theta.degrees()},
                                 {"gamma_star", a.gamma_star.degrees()},
                                 {"gamma_1", a.gamma_1.degrees()},
                                 {"gamma", a.gamma.degrees()},
                                 {"forelimb", a.beta_2.degrees()},
                                 {"propagation", a.propagation}});
  if (fold.misfit) {
    predicted.solutions.back().emplace_back("forelimb_misfit", fold.misfit->degrees());
    if (std::abs(fold.misfit->degrees()) > 1.0) {
      predicted.remarks.push_back(fmt::format(
          "a parallel fault-propagation fold with this backlimb has a forelimb of "
          "{:.4g} degrees, {:.3g} {} than the one given",
          a.beta_2.degrees(), std::abs(fold.misfit->degrees()), fold.misfit->degrees() > 0.0 ? "more" : "less"));
    }
  }
  return predicted;
}

}  // namespace

const char* name_of(Prediction what) {
  constexpr std::array<const char*, 4> names{"fault", "rollover", "fault_bend_fold", "fault_propagation_fold"};
  return names[static_cast<std::size_t>(what)];
}

base::Result<Predicted> predict(const section::Section& section, const PredictParams& params) {
  DOBRA_TRY_VOID(check_predict(params));
  switch (*params.what) {
    case Prediction::Fault:
      return predict_fault(section, params);
    case Prediction::Rollover:
      return predict_rollover(section, params);
    case Prediction::FaultBendFold:
      return predict_bend_fold(params);
    case Prediction::FaultPropagationFold:
      break;
  }
  return predict_propagation_fold(params);
}

}  // namespace recon::inversion
