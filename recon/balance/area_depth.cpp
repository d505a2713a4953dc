#include "recon/balance/area_depth.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "recon/section/palette.h"

namespace recon::balance {

namespace {

BedBalance bed_of(const section::Horizon& horizon) {
  BedBalance bed;
  bed.horizon = horizon.id;
  bed.name = horizon.name;
  bed.piece_of = horizon.piece_of;
  const BedLength measured = bed_length(horizon.line);
  bed.length = measured.length;
  const geom::Point first = horizon.line.points.front();
  const geom::Point last = horizon.line.points.back();
  bed.width = measured.regional();
  bed.level = 0.5 * (first.y + last.y);
  geom::Polyline closed = horizon.line;
  closed.closed = true;
  bed.excess_area = -geom::signed_area(closed);  // left to right above the regional is clockwise
  bed.shortening = measured.shortening();
  if (bed.piece_of.empty() && bed.shortening > 1e-12 * bed.length) bed.depth = bed.excess_area / bed.shortening;
  return bed;
}

/// Whether the lesser part of two pieces' widths lies over the other piece by more than half.
bool over_each_other(const section::Horizon& a, const section::Horizon& b) {
  const geom::Box one = a.line.box();
  const geom::Box other = b.line.box();
  const double common = std::min(one.high.x, other.high.x) - std::max(one.low.x, other.low.x);
  return common > 0.5 * std::min(one.width(), other.width());
}

/// Ramsay's class of each layer between neighbours that is folded enough to have one.
std::vector<LayerClass> layer_classes(const section::Section& section) {
  const auto beds = whole_horizons(section);
  std::vector<LayerClass> layers;
  for (std::size_t i = 0; i + 1 < beds.size(); ++i) {
    for (const section::Horizon* upper : beds[i]) {
      for (const section::Horizon* lower : beds[i + 1]) {
        if (beds[i].size() + beds[i + 1].size() > 2 && !over_each_other(*upper, *lower)) continue;
        if (const auto fold = fold_class(upper->line, lower->line))
          layers.push_back({fmt::format("{} - {}", upper->name, lower->name), *fold});
      }
    }
  }
  return layers;
}

/// "+- 3 m", or nothing where no interval is known.
std::string error_text(const std::optional<double>& error) {
  return error ? fmt::format(" +- {:.3g}", *error) : std::string();
}

/// What is to be said of detachments that do not lie under what they have folded.
/// @param beds  that the fit is of.
std::vector<std::string> remarks_on_depth(double detachment, const std::vector<BedBalance>& beds) {
  const auto by_level = [](const BedBalance& a, const BedBalance& b) { return a.level < b.level; };
  const auto [lowest, highest] = std::minmax_element(beds.begin(), beds.end(), by_level);
  std::vector<std::string> remarks;
  if (detachment > lowest->level) {
    const bool over_all = detachment > highest->level;
    const BedBalance& bed = over_all ? *highest : *lowest;
    remarks.push_back(fmt::format(
        "the detachment at z = {:.6g} m comes out above {} '{}' (z = {:.6g} m), but a detachment lies under the beds "
        "that it folds; check where the beds end, since their regionals are the lines between their ends",
        detachment, over_all ? "every regional, the highest that of" : "the regional of", bed.name, bed.level));
  }
  std::vector<std::string> names;
  for (const BedBalance& bed : beds) {
    if (bed.depth && *bed.depth < 0.0) names.push_back('\'' + bed.name + '\'');
  }
  if (!names.empty())
    remarks.push_back(
        fmt::format("by itself {} gives a detachment above it: more area lies below its regional than above",
                    fmt::join(names, ", ")));
  return remarks;
}

/// The line through the whole horizons; those in pieces are left out, since what they lack would count.
std::optional<AreaDepthFit> fit_of(const std::vector<BedBalance>& whole, double confidence) {
  std::vector<double> levels;
  std::vector<double> areas;
  double size = 0.0;
  for (const BedBalance& bed : whole) {
    levels.push_back(bed.level);
    areas.push_back(bed.excess_area);
    size = std::max(size, bed.length);
  }
  return fit_area_depth(levels, areas, confidence, size);
}

std::string pieces_text(const std::vector<BedBalance>& beds) {
  std::vector<std::string> names;
  for (const BedBalance& bed : beds) {
    const std::string name = '\'' + bed.piece_of + '\'';
    if (!bed.piece_of.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  if (names.empty()) return {};
  return fmt::format(
      "area-depth-strain leaves out {}, in pieces: what lies between them is not known, and the line between the ends "
      "of a piece is no regional; join the pieces where they are one fold (join_gaps)",
      fmt::join(names, ", "));
}

std::string fit_text(const AreaDepthFit& fit, double confidence) {
  const std::string told = fit.r_squared ? fmt::format("{:.4g} % confidence, r2 = {:.4f}", confidence, *fit.r_squared)
                                         : std::string("two levels leave no freedom, so that no interval is known");
  const std::string detachment =
      fit.detachment
          ? fmt::format("detachment at z = {:.6g}{} m", *fit.detachment, error_text(fit.detachment_error))
          : std::string("the detachment is undetermined, since a displacement of 0 lies within the interval");
  return fmt::format("area-depth-strain: displacement {:.6g}{} m, {} ({})", fit.displacement,
                     error_text(fit.displacement_error), detachment, told);
}

/// Everything that hangs on the fit.
void tell_detachment(AreaDepth& result) {
  std::vector<BedBalance> whole = result.beds;
  std::erase_if(whole, [](const BedBalance& bed) { return !bed.piece_of.empty(); });
  if (std::string left_out = pieces_text(result.beds); !left_out.empty()) result.remarks.push_back(std::move(left_out));
  result.fit = fit_of(whole, result.params.confidence);
  if (!result.fit) {
    result.remarks.push_back(
        "no detachment can be told: that takes two whole horizons whose regionals are at different levels and whose "
        "excess areas differ by more than rounding");
    return;
  }
  result.remarks.push_back(fit_text(*result.fit, result.params.confidence));
  if (!result.fit->detachment) return;
  for (BedBalance& bed : result.beds) {
    const double moved = result.fit->displacement;
    if (bed.piece_of.empty()) bed.layer_strain = (bed.shortening - moved) / (bed.width + moved);
  }
  for (std::string& remark : remarks_on_depth(*result.fit->detachment, whole))
    result.remarks.push_back(std::move(remark));
}

}  // namespace

std::optional<AreaDepthFit> fit_area_depth(const std::vector<double>& levels, const std::vector<double>& areas,
                                           double confidence_percent, double size) {
  const auto count = static_cast<double>(levels.size());
  double mean_level = 0.0, mean_area = 0.0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    mean_level += levels[i] / count;
    mean_area += areas[i] / count;
  }
  double sxx = 0.0, sxy = 0.0, syy = 0.0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    sxx += (levels[i] - mean_level) * (levels[i] - mean_level);
    sxy += (levels[i] - mean_level) * (areas[i] - mean_area);
    syy += (areas[i] - mean_area) * (areas[i] - mean_area);
  }
  constexpr double figures = 1e-6;
  const double spread = std::sqrt(sxx);
  if (!(spread > figures * size) || std::abs(sxy) <= figures * size * size * std::sqrt(count) * spread)
    return std::nullopt;
  AreaDepthFit fit;
  fit.displacement = sxy / sxx;
  const double detachment = mean_level - mean_area / fit.displacement;
  if (levels.size() < 3) {
    fit.detachment = detachment;
    return fit;
  }
  const double rest = std::max(0.0, syy - sxy * sxy / sxx);
  fit.r_squared = 1.0 - rest / syy;
  const boost::math::students_t student(count - 2.0);
  const double t = boost::math::quantile(student, 0.5 + 0.005 * confidence_percent);
  const double deviation = std::sqrt(rest / (count - 2.0));
  const double to_mean = detachment - mean_level;
  fit.displacement_error = t * deviation / spread;
  if (std::abs(fit.displacement) <= *fit.displacement_error) return fit;
  fit.detachment = detachment;
  fit.detachment_error = t * deviation / std::abs(fit.displacement) * std::sqrt(1.0 / count + to_mean * to_mean / sxx);
  return fit;
}

base::Result<AreaDepth> area_depth(const section::Section& section, const BalanceParams& params) {
  if (section.horizons.empty()) {
    return base::Error{base::ErrorCode::BadSection, "the section has no horizon; add an [[input.horizon]]"};
  }
  AreaDepth result;
  result.params = params;
  for (const section::Horizon& horizon : section.horizons) result.beds.push_back(bed_of(horizon));
  result.layers = layer_classes(section);
  for (const LayerClass& layer : result.layers) {
    result.remarks.push_back(
        fmt::format("layer '{}' is folded like Ramsay's class {} (index {:.2f}, dips to {:.0f} deg)", layer.name,
                    class_name(layer.fold.value), layer.fold.index, layer.fold.dips.degrees()));
  }
  result.consistency = consistency_of(section.horizons);
  result.verdict = verdict_of(result.consistency, result.consistency.worst.percent, params.tolerance);
  result.remarks.push_back(fmt::format("{}: {}; the tolerance is {:.4g} %", verdict_words(result.verdict),
                                       consistency_text(result.consistency), params.tolerance));
  tell_detachment(result);
  return result;
}

}  // namespace recon::balance
