#pragma once
// Level beds folded by a known trishear, and sections made of lines.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "recon/inversion/invert.h"
#include "recon/kinematics/trishear.h"
#include "shared/base/counter_random.h"

namespace recon::test {

struct KnownTrishear {
  geom::Point tip{1000, 300};  ///< As it is, after the slip.
  double ramp = 30, propagation = 2, apical = 50, slip = 250;
};

inline kinematics::TrishearMap map_of(const KnownTrishear& known) {
  const double angle = known.ramp * std::numbers::pi / 180.0;
  const geom::Vector along{std::cos(angle), std::sin(angle)};
  return kinematics::TrishearMap::make(known.tip - known.propagation * std::abs(known.slip) * along, along,
                                       along.x >= 0 ? kinematics::Side::Left : kinematics::Side::Right, known.slip,
                                       {base::Angle::from_degrees(known.apical), known.propagation, 1.0})
      .value();
}

inline void add_horizon(const std::string& name, std::vector<geom::Point> points, section::Section& section) {
  section::Horizon horizon;
  horizon.id = section::HorizonId(static_cast<std::uint32_t>(section.horizons.size()));
  horizon.name = name;
  horizon.line.points = std::move(points);
  section.horizons.push_back(std::move(horizon));
}

/// Beds that were level at the given heights, of `count` points from x = 0 to 2000 each, with errors of `noise` metres.
inline section::Section folded_beds(const KnownTrishear& known, const std::vector<double>& heights, int count,
                                    double noise = 0.0) {
  const kinematics::TrishearMap map = map_of(known);
  section::Section section;
  for (std::size_t bed = 0; bed < heights.size(); ++bed) {
    std::vector<geom::Point> points;
    for (int i = 0; i < count; ++i) {
      const auto error = base::normal_pair({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(bed), 7, 0}, 11);
      points.push_back(map(geom::Point{2000.0 * i / (count - 1), heights[bed]}) +
                       geom::Vector{noise * error[0], noise * error[1]});
    }
    add_horizon("bed " + std::to_string(bed + 1), std::move(points), section);
  }
  return section;
}

/// Limits about the known values, which do not lie in their middle.
inline inversion::InvertParams limits_about(const KnownTrishear& known) {
  inversion::InvertParams params;
  params.tip_x = {known.tip.x - 150, known.tip.x + 250};
  params.tip_z = {known.tip.y - 150, known.tip.y + 100};
  params.ramp = {known.ramp - 10, known.ramp + 15};
  params.propagation = {0.5 * known.propagation, 2.0 * known.propagation};
  params.apical = {0.6 * known.apical, 1.5 * known.apical};
  params.slip = {0.5 * known.slip, 1.6 * known.slip};
  params.generations = 50;
  return params;
}

inline const inversion::Estimate& estimate(const inversion::Fit& fit, const std::string& key) {
  for (const inversion::Estimate& one : fit.estimates) {
    if (one.unknown.key == key) return one;
  }
  throw std::out_of_range(key);
}

inline bool tells(const std::vector<std::string>& remarks, const std::string& text) {
  for (const std::string& remark : remarks) {
    if (remark.find(text) != std::string::npos) return true;
  }
  return false;
}

}  // namespace recon::test
