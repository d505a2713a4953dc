#include "recon/faults/displacement.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace recon::faults {

namespace {

/// Of the distances along a fault: separations that are no greater are none.
constexpr double rounding = 1e-5;

/// Jumps are steps that are more than three times the median one and 2 % of the greatest separation. Of two jumps a
/// step is one that is more than three times the other, a metre along the fault, and 10 % of the greatest.
void mark_steps(double greatest, std::vector<ProfilePoint>& points) {
  std::vector<double> jumps;
  for (std::size_t i = 1; i < points.size(); ++i)
    jumps.push_back(std::abs(points[i].separation - points[i - 1].separation));
  if (jumps.size() < 2) return;
  const auto mark = [&](const std::vector<double>& sizes, double usual, double least) {
    for (std::size_t i = 0; i < jumps.size(); ++i) {
      if (sizes[i] > 3.0 * usual && jumps[i] > least * greatest) points[i + 1].mark = ProfileMark::Step;
    }
  };
  if (jumps.size() == 2) {
    std::vector<double> rates = jumps;
    for (std::size_t i = 0; i < 2; ++i)
      rates[i] /= std::max(points[i + 1].distance - points[i].distance, rounding * points.back().distance);
    mark(rates, std::min(rates[0], rates[1]), 0.1);
    return;
  }
  std::vector<double> sorted = jumps;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  mark(jumps, sorted[sorted.size() / 2], 0.02);
}

/// A profile rises to one greatest value and falls from there; changes below 2 % of it are the digitiser's.
void mark_reversals(double greatest, std::vector<ProfilePoint>& points) {
  const double noise = 0.02 * greatest;
  const auto top = std::max_element(points.begin(), points.end(), [](const ProfilePoint& a, const ProfilePoint& b) {
    return std::abs(a.separation) < std::abs(b.separation);
  });
  const auto peak = static_cast<std::size_t>(top - points.begin());
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double before = points[i - 1].separation;
    const double here = points[i].separation;
    const double rise = std::abs(here) - std::abs(before);
    const bool wrong_way = i <= peak ? rise < -noise : rise > noise;
    const bool changes_sign = before * here < 0.0 && std::min(std::abs(before), std::abs(here)) > noise;
    if (wrong_way || changes_sign) points[i].mark = ProfileMark::Reversal;
  }
}

}  // namespace

const char* name_of(ProfileMark mark) {
  constexpr std::array<const char*, 3> names{"", "step", "reversal"};
  return names[static_cast<std::size_t>(mark)];
}

std::vector<ProfilePoint> profile_of(const FaultCutoffs& cutoffs) {
  std::vector<ProfilePoint> points;
  double greatest = 0.0;
  for (const CutoffPair& pair : cutoffs.pairs) {
    if (!pair.separation) continue;
    points.push_back({pair.horizon, pair.distance, *pair.separation});
    greatest = std::max(greatest, std::abs(*pair.separation));
  }
  const double length = points.empty() ? 0.0 : points.back().distance;
  if (points.size() < 2 || greatest <= rounding * length) return points;
  mark_steps(greatest, points);
  mark_reversals(greatest, points);
  return points;
}

}  // namespace recon::faults
