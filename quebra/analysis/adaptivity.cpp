#include "quebra/analysis/adaptivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "shared/base/kept_line.h"
#include "shared/fem/error/new_sizes.h"
#include "shared/fem/sparse_solver.h"

namespace quebra::analysis {
namespace {

namespace fem = dobra::fem;
namespace mesh = dobra::mesh;
using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Result;
using dobra::geom::Vector;

/// A cycle that lowers the error by less has stalled.
constexpr double least_gain = 0.02;
/// The estimate was never less than this part of the true error on the specimens measured
/// (docs/algorithms/estimate.md): a few hundred unknowns, or more.
double least_effectivity(double percent) { return percent > 2.0 ? 0.8 : 0.85; }
/// At clamped corners the estimate of a first mesh was seen down to 0.44 of the true error; further meshes tell.
constexpr double least_unconfirmed = 0.4;
/// On further meshes it was seen down to this.
constexpr double least_at_clamps = 0.58;
/// Where such an estimate would do, the next mesh is this much finer, so that its energy tells.
constexpr double finer_to_confirm = 0.6;
/// A mesh with so many times the unknowns says something of the one before.
constexpr double tells_of_before = 1.2;

/// The sizes aim this much lower than what counts as reached: what the mesher makes of them comes out a little above.
constexpr double aim = 0.95;
/// The same round a peak, where a few elements decide.
constexpr double aim_at_peaks = 0.7;
/// A peak that was asked to meet the target and did not is aimed at lower by this, so often before it counts as
/// stalled.
constexpr double lower_aim = 0.7;
constexpr int most_misses = 3;
/// A peak within this many times the target is asked to meet it in the next cycle.
constexpr double in_reach = 4.0;
/// What a cycle aims at, of the error that it has, if the target is farther: what an estimate says of meshes far finer
/// is no ground to make them, and where the stress is infinite no mesh follows at once.
constexpr double gain = 0.25;

/// Of the memory allowed, that a mesh is planned for; the memory of a factorisation as a power of its unknowns.
constexpr double planned_memory = 0.8;
constexpr double memory_power = 1.1;
/// A mesh with less than this many times the unknowns is not worth a cycle.
constexpr double least_growth = 1.2;

/// A peak whose error falls more slowly than this power of the size is no peak but a place of infinite stress.
constexpr double least_rate = 0.5;

/// Size of the elements at a loaded point, of the radius of its neighbourhood.
constexpr double elements_across = 0.5;

dobra::geom::Point centre_of(const mesh::ElementMesh& own, std::size_t element) {
  const auto corners = own.nodes_of(mesh::ElementId(element)).first(mesh::corner_count(own.types[element]));
  Vector sum;
  for (const mesh::NodeId node : corners) sum = sum + (own.point(node) - dobra::geom::Point{});
  return dobra::geom::Point{} + sum / static_cast<double>(corners.size());
}

double left_out_of(const Analysis& analysis) {
  double most = 0.0;
  for (const CaseFields& fields : analysis.fields) most = std::max(most, fields.estimate.left_out);
  return most;
}

/// The length of the elements at a tip.
double tip_size(const mesh::ElementMesh& own, mesh::NodeId tip) {
  double size = 0.0;
  for (std::size_t e = 0; e < own.element_count(); ++e) {
    const auto corners = own.nodes_of(mesh::ElementId(e)).first(mesh::corner_count(own.types[e]));
    if (std::find(corners.begin(), corners.end(), tip) == corners.end()) continue;
    for (const mesh::NodeId node : corners) size = std::max(size, distance(own.point(node), own.point(tip)));
  }
  return size;
}

/// A peak of a cycle, to see in the next whether its error falls.
struct PeakSeen {
  std::size_t load_case = 0;
  dobra::geom::Point at;
  double size = 0.0;
  double eta = 0.0;
  std::optional<double> eta_before = {};  ///< In the cycle before, if it was there.
};

/// The peaks that the loop minds, over the cycles.
class Peaks {
 public:
  /// Looks at the peaks of an analysis: those above the target whose error did not fall are left out from now on, with
  /// a remark.
  void see(const Analysis& analysis, const AdaptParams& params, std::vector<std::string>& remarks) {
    if (params.peaks == MindPeaks::No) return;
    const mesh::ElementMesh& own = analysis.meshed->mesh;
    std::vector<PeakSeen> now;
    const bool asked = worst_ && 100.0 * worst_->eta < in_reach * params.target;
    worst_.reset();
    for (std::size_t c = 0; c < analysis.fields.size(); ++c) {
      for (const fem::error::HotSpot& spot : analysis.fields[c].peaks) {
        PeakSeen peak{c, own.point(spot.node), tip_size(own, spot.node), spot.eta};
        if (ignored(peak.at)) continue;
        const auto before = std::find_if(seen_.begin(), seen_.end(), [&](const PeakSeen& old) {
          return old.load_case == c && distance(old.at, peak.at) < 0.5 * old.size;
        });
        if (100.0 * peak.eta > params.target && before != seen_.end() && peak.size < 0.7 * before->size &&
            peak.eta > before->eta * std::pow(peak.size / before->size, least_rate)) {
          remarks.push_back(
              fmt::format("the stress at ({:.6g}, {:.6g}) does not settle as the elements get smaller: it is infinite "
                          "there, and is not minded",
                          peak.at.x, peak.at.y));
          ignored_.push_back(*before);
          continue;
        }
        if (before != seen_.end()) peak.eta_before = before->eta;
        if (!worst_ || peak.eta > worst_->eta) worst_ = peak;
        now.push_back(peak);
      }
    }
    seen_ = std::move(now);
    if (asked && worst_ && 100.0 * worst_->eta > params.target) ++misses_;
  }
  /// What the next mesh aims at round a peak, of the target.
  [[nodiscard]] double aim() const { return aim_at_peaks * std::pow(lower_aim, misses_); }
  [[nodiscard]] bool tried_enough() const { return misses_ >= most_misses; }
  [[nodiscard]] bool ignored(dobra::geom::Point at) const {
    return std::any_of(ignored_.begin(), ignored_.end(),
                       [&](const PeakSeen& old) { return distance(old.at, at) < old.size; });
  }
  [[nodiscard]] const std::optional<PeakSeen>& worst() const { return worst_; }

 private:
  std::vector<PeakSeen> seen_;
  std::vector<PeakSeen> ignored_;
  std::optional<PeakSeen> worst_;
  int misses_ = 0;
};

bool has_clamped_corner(const Analysis& analysis) {
  return std::any_of(analysis.singular.begin(), analysis.singular.end(), [](const fem::error::SingularVertex& vertex) {
    return vertex.first == fem::error::CornerFace::Clamped || vertex.last == fem::error::CornerFace::Clamped;
  });
}

/// The true error of an analysis, 0..1, as one on a finer mesh tells it: their energies differ by (e^2 - e_finer^2)
/// / 2. The greatest of the cases; nothing where the mesh is not finer or a case has surroundings left out.
std::optional<double> error_told_by(const Analysis& coarse, const Analysis& fine) {
  const auto unknowns = [](const Analysis& of) { return static_cast<double>(of.solution.statistics.unknowns); };
  if (unknowns(fine) < tells_of_before * unknowns(coarse) || left_out_of(coarse) > 0.0 || left_out_of(fine) > 0.0)
    return std::nullopt;
  double greatest = 0.0;
  for (std::size_t c = 0; c < fine.solution.cases.size(); ++c) {
    const double norm = 2.0 * fine.solution.cases[c].energy;
    const double eta = fine.fields[c].estimate.eta;
    const double rest = norm * eta * eta / std::max(1e-300, 1.0 - eta * eta);
    const double gained = 2.0 * std::abs(fine.solution.cases[c].energy - coarse.solution.cases[c].energy);
    if (norm > 0.0) greatest = std::max(greatest, std::sqrt((gained + rest) / (norm + rest)));
  }
  return greatest;
}

/// How far a cycle got.
struct Reached {
  double whole = 0.0;            ///< Fractions.
  std::optional<PeakSeen> peak;  ///< That of the greatest error.
  double left_out = 0.0;         ///< Of the energy, at loaded points.
  bool tried_enough = false;     ///< Lower aims did not help the peak.
  double effectivity = 1.0;      ///< The least that the estimate is to be trusted with, of the true error.
  bool told = false;             ///< By the energies of this mesh and the one before.
  /// Even if the estimate is as low as it may be.
  [[nodiscard]] bool met(double percent) const {
    return 100.0 * std::max(whole / effectivity, peak ? peak->eta : 0.0) <= percent;
  }
  /// It would be met if the estimate were as good as it is away from clamped corners.
  [[nodiscard]] bool to_confirm(double percent) const {
    Reached trusted = *this;
    trusted.effectivity = least_effectivity(percent);
    return !met(percent) && trusted.met(percent);
  }
  /// Of what is not met nothing got better, nothing came up, and both are judged over the same domain.
  [[nodiscard]] bool stalls(const Reached& before, double percent) const {
    constexpr double same = 0.05;
    if (std::abs(left_out - before.left_out) > same) return false;
    const auto gains = [&](double now, std::optional<double> then, double enough) {
      return 100.0 * now > enough && (!then || now <= (1.0 - least_gain) * *then);
    };
    // An estimate that was too low is no measure of what was gained.
    const double then = before.whole * least_effectivity(percent) / before.effectivity;
    return !gains(whole, std::max(before.whole, then), effectivity * percent) &&
           !(peak && 100.0 * peak->eta > percent && (!tried_enough || gains(peak->eta, peak->eta_before, percent)));
  }
  [[nodiscard]] std::string text() const {
    const std::string error = fmt::format("the error is {:.3g} % (up to {:.3g} %, for the estimate may be low)",
                                          100.0 * whole, 100.0 * whole / effectivity);
    return peak ? error + fmt::format(", {:.3g} % round the peak of stress at ({:.6g}, {:.6g})", 100.0 * peak->eta,
                                      peak->at.x, peak->at.y)
                : error;
  }
};

/// Sizes of the elements round the peaks, not above those of `least`: those of a peak that is met too, or the next mesh
/// would lose it again.
void add_peaks(const Analysis& analysis, const Peaks& peaks, double target, const fem::error::NewSizeOptions& options,
               std::vector<double>& least) {
  const mesh::ElementMesh& own = analysis.meshed->mesh;
  std::map<mesh::NodeId, double> etas;
  for (const CaseFields& fields : analysis.fields) {
    for (const fem::error::HotSpot& spot : fields.peaks) {
      if (!peaks.ignored(own.point(spot.node))) etas[spot.node] = std::max(etas[spot.node], spot.eta);
    }
  }
  if (etas.empty()) return;
  for (std::size_t e = 0; e < own.element_count(); ++e) {
    for (const mesh::NodeId node : own.nodes_of(mesh::ElementId(e))) {
      const auto found = etas.find(node);
      if (found == etas.end()) continue;
      const double order = mesh::is_quadratic(own.types[e]) ? 2.0 : 1.0;
      const double factor = std::clamp(std::pow(peaks.aim() * target / found->second, 1.0 / order),
                                       options.least_factor, options.most_factor);
      least[e] = std::min(least[e], std::max(options.min_size, factor * fem::error::element_size(own, e)));
    }
  }
}

/// Elements in a neighbourhood that is left out have no error to go by: they stay as they are, and become small enough
/// to tell the neighbourhood from the rest.
void add_loaded_points(const Analysis& analysis, double min_size, std::vector<double>& least,
                       std::vector<mesh::delaunay::SizeRequest>& sizes) {
  const mesh::ElementMesh& own = analysis.meshed->mesh;
  for (const CaseFields& fields : analysis.fields) {
    for (const LoadedPoint& point : fields.loaded) {
      sizes.push_back({point.at, std::max(min_size, elements_across * point.radius)});
      for (std::size_t e = 0; e < own.element_count(); ++e) {
        if (distance(centre_of(own, e), point.at) < point.radius)
          least[e] = std::min(least[e], fem::error::element_size(own, e));
      }
    }
  }
}

/// The error that the next mesh is to have, 0..1: the last one's, or on the way there in even steps of about `gain`.
double aimed_at(const Analysis& analysis, const AdaptParams& params, double effectivity) {
  const double goal = aim * effectivity * params.target / 100.0;
  if (analysis.eta <= goal) return goal;
  constexpr double slack = 0.1;  // a little farther is no step more
  const double steps = std::max(1.0, std::ceil(std::log(goal / analysis.eta) / std::log(gain) - slack));
  return analysis.eta * std::pow(goal / analysis.eta, 1.0 / steps);
}

/// The size with 12 bits: the last digits of an estimate depend on the processor by the kernels of the solver, the mesh
/// does not.
double without_noise(double size) {
  constexpr double steps = 4096.0;
  int exponent = 0;
  const double part = std::frexp(size, &exponent);
  return std::ldexp(std::round(part * steps) / steps, exponent);
}

/// Of the next mesh.
struct Wanted {
  meshing::MeshWishes mesh = {};
  double more = 1.0;  ///< As many elements as this one has, times this.
};

/// @param before  how far the analysis got: where it is to be confirmed, the next mesh is finer everywhere.
Result<Wanted> wishes_of(const Analysis& analysis, const AdaptParams& params, const Peaks& peaks, double first_size,
                         const Reached& before) {
  const mesh::ElementMesh& own = analysis.meshed->mesh;
  const bool rosettes = params.rosettes == meshing::UseRosettes::Yes;
  fem::error::NewSizeOptions options{
      .target = aimed_at(analysis, params, before.told ? before.effectivity : least_effectivity(params.target)),
      .rule = params.rule == RuleOfSizes::Optimal ? fem::error::SizeRule::Optimal : fem::error::SizeRule::EqualError,
      .min_size = params.min_size,
      .max_size = std::max(first_size, params.min_size),
      .singular_rings = rosettes ? fem::fracture::RosetteOptions{}.rings : 1};
  Wanted wanted{.more = 0.0};
  meshing::MeshWishes& wishes = wanted.mesh;
  std::vector<double> least(own.element_count(), options.max_size);
  for (const CaseFields& fields : analysis.fields) {
    DOBRA_TRY(const auto sizes, fem::error::new_sizes(own, fields.estimate, analysis.singular, options));
    for (std::size_t e = 0; e < sizes.size(); ++e) least[e] = std::min(least[e], sizes[e]);
  }
  if (params.peaks == MindPeaks::Yes) add_peaks(analysis, peaks, params.target / 100.0, options, least);
  if (analysis.point_forces == PointForces::LeaveOut) add_loaded_points(analysis, params.min_size, least, wishes.sizes);
  const bool confirm = before.to_confirm(params.target);
  for (std::size_t e = 0; confirm && e < own.element_count(); ++e)
    least[e] = std::min(least[e], std::max(params.min_size, finer_to_confirm * fem::error::element_size(own, e)));
  for (double& size : least) size = std::max(params.min_size, without_noise(size));
  for (std::size_t e = 0; e < own.element_count(); ++e) {
    const double finer =
        std::min(fem::error::element_size(own, e) / least[e], 1.0 / options.least_factor);  // graded beyond that
    wanted.more += finer * finer / static_cast<double>(own.element_count());
  }
  // The elements round a singular vertex ask there, and all for the least of their sizes: the field is alike all round.
  std::map<mesh::NodeId, double> at_vertices;
  for (const fem::error::SingularVertex& vertex : analysis.singular) at_vertices[vertex.node] = options.max_size;
  for (std::size_t e = 0; e < own.element_count(); ++e) {
    const auto corners = own.nodes_of(mesh::ElementId(e)).first(mesh::corner_count(own.types[e]));
    const auto touched =
        std::find_if(corners.begin(), corners.end(), [&](mesh::NodeId node) { return at_vertices.contains(node); });
    if (touched != corners.end()) {
      double& size = at_vertices.at(*touched);
      size = std::min(size, least[e]);
      continue;
    }
    wishes.sizes.push_back({centre_of(own, e), least[e]});
  }
  for (const auto& [node, size] : at_vertices) wishes.sizes.push_back({own.point(node), size});
  if (!rosettes) return wanted;
  // A rosette shrinks as a whole, by what the elements at its tip are asked to; it never grows.
  for (const mesh::CrackTip& tip : own.tips) {
    double now = 0.0;
    for (std::size_t e = 0; e < own.element_count(); ++e) {
      const auto corners = own.nodes_of(mesh::ElementId(e)).first(mesh::corner_count(own.types[e]));
      if (std::find(corners.begin(), corners.end(), tip.node) != corners.end())
        now = std::max(now, fem::error::element_size(own, e));
    }
    wishes.tips.push_back(
        {own.point(tip.node), tip_size(own, tip.node) * std::min(1.0, at_vertices.at(tip.node) / now)});
  }
  return wanted;
}

/// The loop: what it has so far, and what it goes by.
class Loop {
 public:
  Loop(const model::Model& model, const AdaptParams& params, const meshing::SizeSource& source)
      : params_(params), source_(source), result_(model) {
    // The greatest that a cycle may ask for. A formula or a background mesh alone says what is wanted at first.
    size_ = params.size > 0.0 ? params.size : model.domain.box().diagonal() / (source.empty() ? 8.0 : 1.0);
    static_cast<meshing::MeshRules&>(meshing_) = params;
    meshing_.size = source.empty() ? size_ : params.size;
    short_before_ = params.from == StartFrom::First && model.short_of_target;
    result_.short_of_target = false;
  }

  /// Takes up the last cycle of the model. @return whether it has met the target.
  Result<bool> resume() {
    if (result_.analyses.empty() || result_.analyses.back()->cycle == 0)
      return Error{ErrorCode::BadValue,
                   "there is no cycle to go on from: put a step 'adapt' before, or begin with the first"};
    const auto& analyses = result_.analyses;
    // What the cycles before saw; they have told it.
    std::size_t i = analyses.size() - 1;
    while (i > 0 && analyses[i]->cycle > 1 && analyses[i - 1]->cycle == analyses[i]->cycle - 1) --i;
    std::vector<std::string> told;
    for (; i < analyses.size(); ++i) peaks_.see(*analyses[i], params_, told);
    std::erase(result_.remarks, result_.why_short);
    result_.why_short.clear();
    before_ = reached();
    if (before_.met(params_.target)) return true;
    done_ = analyses.back()->cycle;
    for (const std::string& told_before : remarks_on(*analyses.back())) std::erase(result_.remarks, told_before);
    return false;
  }

  Result<model::Model> run(const dobra::base::Progress& progress) {
    if (params_.from == StartFrom::Last) {
      DOBRA_TRY(const bool met, resume());
      if (met) return std::move(result_);
    }
    for (int own = 1;; ++own) {
      if (done_ > 0) {
        DOBRA_TRY(const std::string why, plan());
        if (!why.empty()) return finish(why);
      }
      const auto part = progress.part((own - 1.0) / params_.max_cycles, static_cast<double>(own) / params_.max_cycles);
      if (const auto cycled = cycle(part); !cycled) {
        if (own == 1) return cycled.error();
        return finish(
            fmt::format("cycle {} could not be finished: {}; {} after {} cycles, above the {:.3g} % asked for",
                        done_ + 1, cycled.error().message, before_.text(), done_, params_.target));
      }
      const Reached now = reached();
      if (now.met(params_.target)) return finish("");
      if (done_ > 1 && now.stalls(before_, params_.target))
        return finish(fmt::format("{} and stalls above the {:.3g} % asked for{}", now.text(), params_.target,
                                  params_.min_size > 0.0 ? "; allow smaller elements" : ""));
      if (own == params_.max_cycles)
        return finish(fmt::format("after {} cycles {}, above the {:.3g} % asked for; allow more", own, now.text(),
                                  params_.target));
      before_ = now;
    }
  }

 private:
  /// How far the last cycle got.
  [[nodiscard]] Reached reached() const {
    const Analysis& last = *result_.analyses.back();
    const double usual = least_effectivity(params_.target);
    Reached now{last.eta, peaks_.worst(), left_out_of(last), peaks_.tried_enough(), usual};
    if (!has_clamped_corner(last)) return now;
    const std::size_t count = result_.analyses.size();
    const Analysis* before = count > 1 ? result_.analyses[count - 2].get() : nullptr;
    std::optional<double> told;
    if (before != nullptr && before->cycle > 0 && before->cycle == last.cycle - 1) told = error_told_by(*before, last);
    now.told = told.has_value();
    now.effectivity =
        told && *told > 0.0 ? std::clamp(before->eta / *told, least_unconfirmed, usual) : least_unconfirmed;
    return now;
  }

  /// The sizes of the next mesh, as small as memory allows. @return why there is none; empty: there is one
  Result<std::string> plan() {
    const Analysis& last = *result_.analyses.back();
    DOBRA_TRY(wanted_, wishes_of(last, params_, peaks_, size_, before_));
    const double allowed = params_.memory > 0.0 ? params_.memory : fem::machine_memory();
    const double now = last.solution.statistics.memory_estimate;
    if (!(allowed > 0.0) || now * std::pow(wanted_.more, memory_power) <= allowed) return std::string();
    const double fits = std::pow(planned_memory * allowed / now, 1.0 / memory_power);
    if (fits < least_growth) {
      return fmt::format(
          "{} after {} cycles, above the {:.3g} % asked for: the next mesh, of about {:.2g} unknowns, needs about "
          "{:.2g} GB, and {:.2g} GB are allowed",
          before_.text(), done_, params_.target, wanted_.more * static_cast<double>(last.solution.statistics.unknowns),
          now * std::pow(wanted_.more, memory_power) / 1e9, allowed / 1e9);
    }
    for (auto& request : wanted_.mesh.sizes) request.size *= std::sqrt(wanted_.more / fits);
    return std::string();
  }

  /// Meshes and analyses once more. An error leaves what the cycles before made.
  Result<void> cycle(const dobra::base::Progress& progress) {
    meshing_.label = fmt::format("Cycle {}", done_ + 1);
    std::vector<std::string> remarks;
    DOBRA_TRY(model::Meshed meshed,
              meshing::mesh_domain(result_, meshing_, wanted_.mesh, remarks, progress.part(0.0, 0.3), source_));
    const auto shared = std::make_shared<const model::Meshed>(std::move(meshed));
    DOBRA_TRY(Analysis analysis,
              analyse(result_.domain, shared, *result_.problem, params_.memory, params_, progress.part(0.3, 1.0)));
    analysis.cycle = ++done_;
    peaks_.see(analysis, params_, remarks);
    result_.meshes.push_back(shared);
    result_.remarks.insert(result_.remarks.end(), remarks.begin(), remarks.end());
    const std::string peak =
        analysis.peak_eta > 0.0 ? fmt::format(", {:.3g} % round peaks", 100.0 * analysis.peak_eta) : std::string();
    progress.report(
        1.0, dobra::base::kept_line(fmt::format("cycle {}: {} unknowns, error {:.3g} %{}", done_,
                                                analysis.solution.statistics.unknowns, 100.0 * analysis.eta, peak)));
    result_.analyses.push_back(std::make_shared<const Analysis>(std::move(analysis)));
    return {};
  }

  model::Model finish(const std::string& why) {
    for (std::string& remark : remarks_on(*result_.analyses.back())) result_.remarks.push_back(std::move(remark));
    result_.short_of_target = short_before_ || !why.empty();
    result_.why_short = why;
    if (!why.empty()) result_.remarks.push_back(why);
    const Analysis& last = *result_.analyses.back();
    if (why.empty() && has_clamped_corner(last) && 100.0 * last.eta / least_at_clamps > params_.target)
      result_.remarks.push_back(
          fmt::format("the sides that are held end in corners of infinite stress, where the estimate was seen down to "
                      "{} of the true error: that may be up to {:.3g} %, above the {:.3g} % asked for; ask for less to "
                      "be sure",
                      least_at_clamps, 100.0 * last.eta / least_at_clamps, params_.target));
    return std::move(result_);
  }

  const AdaptParams& params_;
  const meshing::SizeSource& source_;
  model::Model result_;
  double size_ = 0.0;
  meshing::MeshParams meshing_;
  bool short_before_ = false;
  Wanted wanted_;
  Peaks peaks_;
  Reached before_{1.0, {}, 0.0};
  int done_ = 0;  ///< Cycles, those that it goes on from included.
};

}  // namespace

Result<model::Model> adapt(const model::Model& model, const AdaptParams& params,
                           const dobra::scenario::Context& context, const dobra::base::Progress& progress) {
  if (!model.problem)
    return Error{ErrorCode::BadValue,
                 "there is nothing to analyse: put a step 'problem' with materials, supports and loads before"};
  DOBRA_TRY(const meshing::SizeSource source,
            meshing::SizeSource::make(model.domain, params.size_formula, params.background, params.background_field,
                                      context));
  return Loop(model, params, source).run(progress);
}

}  // namespace quebra::analysis
