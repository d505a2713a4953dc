#include "recon/inversion/trishear_fit.h"

#include <cmath>
#include <numbers>

#include "recon/faults/fault.h"
#include "recon/inversion/limits.h"
#include "recon/kinematics/trishear.h"

namespace recon::inversion {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

geom::Vector ramp_direction(double ramp) { return {std::cos(ramp * degree), std::sin(ramp * degree)}; }

geom::Box box_of_beds(const std::vector<BedShape>& beds) {
  geom::Box box;
  for (const BedShape& bed : beds) {
    for (const geom::Point p : bed.points) box.add(p);
  }
  return box;
}

/// The tip of a fault and the direction that it ends in.
struct DrawnRamp {
  geom::Point tip;
  double ramp;  ///< Degrees.
};

base::Result<DrawnRamp> drawn_ramp(const section::Section& section, const std::string& name,
                                   std::vector<std::string>& remarks) {
  DOBRA_TRY(const std::vector<faults::Fault> all, faults::faults_of(section, {}));
  DOBRA_TRY(const faults::Fault* fault, faults::find_fault(all, name));
  const kinematics::TrishearTip tip = trishear_tip(fault->path);
  if (auto remark = faults::remark_on_taken_tip(*fault, tip.at)) remarks.push_back(*std::move(remark));
  return DrawnRamp{tip.at, std::atan2(tip.direction.y, tip.direction.x) / degree};
}

}  // namespace

Model trishear_model(double size) {
  return [size](std::span<const double> v, Precision precision) -> std::optional<Restore> {
    const geom::Vector along = ramp_direction(v[Ramp]);
    const geom::Point tip = geom::Point{v[TipX], v[TipZ]} - v[Propagation] * std::abs(v[Slip]) * along;
    const kinematics::Side above = along.x >= 0.0 ? kinematics::Side::Left : kinematics::Side::Right;
    // A tip that goes down takes the hanging wall along the other way.
    const double slip = along.y >= 0.0 ? v[Slip] : -v[Slip];
    const kinematics::TrishearTolerances tolerances{size, precision == Precision::Full ? 1e-10 : 1e-6, 0};
    const auto map = kinematics::TrishearMap::make(
        tip, along, above, slip, {base::Angle::from_degrees(v[Apical]), v[Propagation], v[Concentration]}, tolerances);
    if (!map) return std::nullopt;
    return [back = map->swapped()](geom::Point p) { return back(p); };
  };
}

base::Result<std::vector<std::vector<Unknown>>> trishear_unknowns(const section::Section& section,
                                                                  const std::vector<BedShape>& beds,
                                                                  const InvertParams& params,
                                                                  std::vector<std::string>& remarks) {
  const geom::Box box = box_of_beds(beds);
  std::vector<double> x{box.low.x - 0.25 * box.width(), box.high.x + 0.25 * box.width()};
  std::vector<double> z{box.low.y - std::max(box.height(), 0.25 * box.width()), box.high.y};
  std::vector<std::vector<double>> ramps{{5.0, 85.0}, {95.0, 175.0}};
  if (!params.fault.empty()) {
    DOBRA_TRY(const DrawnRamp drawn, drawn_ramp(section, params.fault, remarks));
    x = {drawn.tip.x};
    z = {drawn.tip.y};
    ramps = {{drawn.ramp}};
  }
  if (!params.ramp.empty()) ramps = {params.ramp};
  std::vector<std::vector<Unknown>> lists;
  for (const std::vector<double>& ramp : ramps) {
    std::vector<Unknown> list(trishear_values);
    DOBRA_TRY(list[TipX], unknown_of("tip_x", "m", params.tip_x, x));
    DOBRA_TRY(list[TipZ], unknown_of("tip_z", "m", params.tip_z, z));
    DOBRA_TRY(list[Ramp], unknown_of("ramp", "deg", ramp, {}));
    DOBRA_TRY(list[Propagation], unknown_of("propagation", "", params.propagation, {0.0, 5.0}));
    DOBRA_TRY(list[Apical], unknown_of("apical", "deg", params.apical, {5.0, 150.0}));
    DOBRA_TRY(list[Slip], unknown_of("slip", "m", params.slip, {0.0, box.width()}));
    DOBRA_TRY(list[Concentration], unknown_of("concentration", "", params.concentration, {1.0}));
    lists.push_back(std::move(list));
  }
  return lists;
}

geom::Polyline ramp_line(std::span<const double> values, double length) {
  const geom::Point tip{values[TipX], values[TipZ]};
  return {{tip - length * ramp_direction(values[Ramp]), tip}, false};
}

std::vector<geom::Polyline> triangle_sides(std::span<const double> values, double length) {
  const geom::Point tip{values[TipX], values[TipZ]};
  std::vector<geom::Polyline> sides;
  for (const double half : {0.5 * values[Apical], -0.5 * values[Apical]})
    sides.push_back({{tip, tip + length * ramp_direction(values[Ramp] + half)}, false});
  return sides;
}

}  // namespace recon::inversion
