#include "quebra/core/adaptivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "shared/fem/new_sizes.h"

namespace quebra::core {
namespace {

namespace fem = dobra::fem;
namespace mesh = dobra::mesh;
using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Result;
using dobra::geom::Vector;

/// A cycle that lowers the error by less has stalled.
constexpr double least_gain = 0.02;
/// The sizes aim this much lower than the error asked for: what the mesher makes of them comes out a little above.
constexpr double aim = 0.95;
/// The same round a peak, where a few elements decide.
constexpr double aim_at_peaks = 0.7;

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
  /// Looks at the peaks of an analysis: those above the target whose error did not fall are left out from now on, with a remark.
  void see(const Analysis& analysis, const AdaptParams& params, std::vector<std::string>& remarks) {
    if (params.peaks == MindPeaks::No) return;
    const mesh::ElementMesh& own = analysis.meshed->mesh;
    std::vector<PeakSeen> now;
    worst_.reset();
    for (std::size_t c = 0; c < analysis.fields.size(); ++c) {
      for (const fem::HotSpot& spot : analysis.fields[c].peaks) {
        PeakSeen peak{c, own.point(spot.node), tip_size(own, spot.node), spot.eta};
        if (ignored(peak.at)) continue;
        const auto before = std::find_if(seen_.begin(), seen_.end(), [&](const PeakSeen& old) {
          return old.load_case == c && distance(old.at, peak.at) < 0.5 * old.size;
        });
        if (100.0 * peak.eta > params.target && before != seen_.end() && peak.size < 0.7 * before->size && peak.eta > before->eta * std::pow(peak.size / before->size, least_rate)) {
          remarks.push_back(fmt::format("the stress at ({:.6g}, {:.6g}) does not settle as the elements get smaller: it is infinite there, and is not minded", peak.at.x, peak.at.y));
          ignored_.push_back(*before);
          continue;
        }
        if (before != seen_.end()) peak.eta_before = before->eta;
        if (!worst_ || peak.eta > worst_->eta) worst_ = peak;
        now.push_back(peak);
      }
    }
    seen_ = std::move(now);
  }
  [[nodiscard]] bool ignored(dobra::geom::Point at) const {
    return std::any_of(ignored_.begin(), ignored_.end(), [&](const PeakSeen& old) { return distance(old.at, at) < old.size; });
  }
  [[nodiscard]] const std::optional<PeakSeen>& worst() const { return worst_; }

 private:
  std::vector<PeakSeen> seen_;
  std::vector<PeakSeen> ignored_;
  std::optional<PeakSeen> worst_;
};

/// How far a cycle got.
struct Reached {
  double whole = 0.0;             ///< Fractions.
  std::optional<PeakSeen> peak;   ///< That of the greatest error.
  double left_out = 0.0;          ///< Of the energy, at loaded points.
  [[nodiscard]] bool met(double percent) const { return 100.0 * std::max(whole, peak ? peak->eta : 0.0) <= percent; }
  /// Of what is not met nothing got better, nothing came up, and both are judged over the same domain.
  [[nodiscard]] bool stalls(const Reached& before, double percent) const {
    constexpr double same = 0.05;
    if (std::abs(left_out - before.left_out) > same) return false;
    const auto gains = [&](double now, std::optional<double> then) { return 100.0 * now > percent && (!then || now <= (1.0 - least_gain) * *then); };
    return !gains(whole, before.whole) && !(peak && gains(peak->eta, peak->eta_before));
  }
  [[nodiscard]] std::string text() const {
    const std::string error = fmt::format("the error is {:.3g} %", 100.0 * whole);
    return peak ? error + fmt::format(", {:.3g} % round the peak of stress at ({:.6g}, {:.6g})", 100.0 * peak->eta, peak->at.x, peak->at.y) : error;
  }
};

/// Sizes of the elements round the peaks, not above those of `least`: those of a peak that is met too, or the next mesh would
/// lose it again.
void add_peaks(const Analysis& analysis, const Peaks& peaks, double target, const fem::NewSizeOptions& options, std::vector<double>& least) {
  const mesh::ElementMesh& own = analysis.meshed->mesh;
  std::map<mesh::NodeId, double> etas;
  for (const CaseFields& fields : analysis.fields) {
    for (const fem::HotSpot& spot : fields.peaks) {
      if (!peaks.ignored(own.point(spot.node))) etas[spot.node] = std::max(etas[spot.node], spot.eta);
    }
  }
  if (etas.empty()) return;
  for (std::size_t e = 0; e < own.element_count(); ++e) {
    for (const mesh::NodeId node : own.nodes_of(mesh::ElementId(e))) {
      const auto found = etas.find(node);
      if (found == etas.end()) continue;
      const double order = mesh::is_quadratic(own.types[e]) ? 2.0 : 1.0;
      const double factor = std::clamp(std::pow(aim_at_peaks * target / found->second, 1.0 / order), options.least_factor, options.most_factor);
      least[e] = std::min(least[e], std::max(options.min_size, factor * fem::element_size(own, e)));
    }
  }
}

/// Elements in a neighbourhood that is left out have no error to go by: they stay as they are, and become small enough to
/// tell the neighbourhood from the rest.
void add_loaded_points(const Analysis& analysis, double min_size, std::vector<double>& least, std::vector<mesh::SizeRequest>& sizes) {
  const mesh::ElementMesh& own = analysis.meshed->mesh;
  for (const CaseFields& fields : analysis.fields) {
    for (const LoadedPoint& point : fields.loaded) {
      sizes.push_back({point.at, std::max(min_size, elements_across * point.radius)});
      for (std::size_t e = 0; e < own.element_count(); ++e) {
        if (distance(centre_of(own, e), point.at) < point.radius) least[e] = std::min(least[e], fem::element_size(own, e));
      }
    }
  }
}

Result<MeshWishes> wishes_of(const Analysis& analysis, const AdaptParams& params, const Peaks& peaks, double first_size) {
  const mesh::ElementMesh& own = analysis.meshed->mesh;
  const bool rosettes = params.rosettes == UseRosettes::Yes;
  fem::NewSizeOptions options{.target = aim * params.target / 100.0,
                              .rule = params.rule == RuleOfSizes::Optimal ? fem::SizeRule::Optimal : fem::SizeRule::EqualError,
                              .min_size = params.min_size,
                              .max_size = std::max(first_size, params.min_size),
                              .singular_rings = rosettes ? fem::RosetteOptions{}.rings : 1};
  MeshWishes wishes;
  std::vector<double> least(own.element_count(), options.max_size);
  for (const CaseFields& fields : analysis.fields) {
    DOBRA_TRY(const auto sizes, fem::new_sizes(own, fields.estimate, analysis.singular, options));
    for (std::size_t e = 0; e < sizes.size(); ++e) least[e] = std::min(least[e], sizes[e]);
  }
  if (params.peaks == MindPeaks::Yes) add_peaks(analysis, peaks, params.target / 100.0, options, least);
  if (analysis.point_forces == PointForces::LeaveOut) add_loaded_points(analysis, params.min_size, least, wishes.sizes);
  // The elements round a singular vertex ask there, and all for the least of their sizes: the field is alike all round.
  std::map<mesh::NodeId, double> at_vertices;
  for (const fem::SingularVertex& vertex : analysis.singular) at_vertices[vertex.node] = options.max_size;
  for (std::size_t e = 0; e < own.element_count(); ++e) {
    const auto corners = own.nodes_of(mesh::ElementId(e)).first(mesh::corner_count(own.types[e]));
    const auto touched = std::find_if(corners.begin(), corners.end(), [&](mesh::NodeId node) { return at_vertices.contains(node); });
    if (touched != corners.end()) {
      double& size = at_vertices.at(*touched);
      size = std::min(size, least[e]);
      continue;
    }
    wishes.sizes.push_back({centre_of(own, e), least[e]});
  }
  for (const auto& [node, size] : at_vertices) wishes.sizes.push_back({own.point(node), size});
  if (!rosettes) return wishes;
  // A rosette shrinks as a whole, by what the elements at its tip are asked to; it never grows.
  for (const mesh::CrackTip& tip : own.tips) {
    double now = 0.0;
    for (std::size_t e = 0; e < own.element_count(); ++e) {
      const auto corners = own.nodes_of(mesh::ElementId(e)).first(mesh::corner_count(own.types[e]));
      if (std::find(corners.begin(), corners.end(), tip.node) != corners.end()) now = std::max(now, fem::element_size(own, e));
    }
    wishes.tips.push_back({own.point(tip.node), tip_size(own, tip.node) * std::min(1.0, at_vertices.at(tip.node) / now)});
  }
  return wishes;
}

}  // namespace

Result<Model> adapt(const Model& model, const AdaptParams& params, const dobra::scenario::Context& context, const dobra::base::Progress& progress) {
  if (!model.problem) return Error{ErrorCode::BadValue, "there is nothing to analyse: put a step 'problem' with materials, supports and loads before"};
  Model result = model;
  result.short_of_target = false;
  DOBRA_TRY(const SizeSource source, SizeSource::make(model.domain, params.size_formula, params.background, params.background_field, context));
  // The greatest that a cycle may ask for. A formula or a background mesh alone says what is wanted at first.
  const double size = params.size > 0.0 ? params.size : model.domain.box().diagonal() / (source.empty() ? 8.0 : 1.0);
  MeshParams meshing;
  static_cast<MeshRules&>(meshing) = params;
  meshing.size = source.empty() ? size : params.size;
  MeshWishes wishes;
  Peaks peaks;
  Reached before{1.0, {}, 0.0};
  const bool short_before = params.from == StartFrom::First && model.short_of_target;
  int done = 0;
  if (params.from == StartFrom::Last) {
    if (model.analyses.empty() || model.analyses.back()->cycle == 0) return Error{ErrorCode::BadValue, "there is no cycle to go on from: put a step 'adapt' before, or begin with the first"};
    const Analysis& last = *model.analyses.back();
    // What the cycles before saw; they have told it.
    std::size_t i = model.analyses.size() - 1;
    while (i > 0 && model.analyses[i]->cycle > 1 && model.analyses[i - 1]->cycle == model.analyses[i]->cycle - 1) --i;
    std::vector<std::string> told;
    for (; i < model.analyses.size(); ++i) peaks.see(*model.analyses[i], params, told);
    std::erase(result.remarks, model.why_short);
    result.why_short.clear();
    before = {last.eta, peaks.worst(), left_out_of(last)};
    if (before.met(params.target)) return result;
    done = last.cycle;
    DOBRA_TRY(wishes, wishes_of(last, params, peaks, size));
    for (const std::string& told_before : remarks_on(last)) std::erase(result.remarks, told_before);
  }
  const auto finish = [&](const std::string& why) {
    for (std::string& remark : remarks_on(*result.analyses.back())) result.remarks.push_back(std::move(remark));
    result.short_of_target = short_before || !why.empty();
    result.why_short = why;
    if (!why.empty()) result.remarks.push_back(why);
    return result;
  };
  for (int cycle = 1;; ++cycle) {
    const auto part = progress.part((cycle - 1.0) / params.max_cycles, static_cast<double>(cycle) / params.max_cycles);
    meshing.label = fmt::format("Cycle {}", done + cycle);
    DOBRA_TRY(Meshed meshed, mesh_domain(result, meshing, wishes, result.remarks, part.part(0.0, 0.3), source));
    result.meshes.push_back(std::make_shared<const Meshed>(std::move(meshed)));
    DOBRA_TRY(Analysis analysis, analyse(model.domain, result.meshes.back(), *model.problem, 0.0, params, part.part(0.3, 1.0)));
    analysis.cycle = done + cycle;
    peaks.see(analysis, params, result.remarks);
    const Reached now{analysis.eta, peaks.worst(), left_out_of(analysis)};
    result.analyses.push_back(std::make_shared<const Analysis>(std::move(analysis)));
    if (now.met(params.target)) return finish("");
    if (done + cycle > 1 && now.stalls(before, params.target))
      return finish(fmt::format("{} and stalls above the {:.3g} % asked for{}", now.text(), params.target, params.min_size > 0.0 ? "; allow smaller elements" : ""));
    if (cycle == params.max_cycles) return finish(fmt::format("after {} cycles {}, above the {:.3g} % asked for; allow more", cycle, now.text(), params.target));
    before = now;
    DOBRA_TRY(wishes, wishes_of(*result.analyses.back(), params, peaks, size));
  }
}

}  // namespace quebra::core
