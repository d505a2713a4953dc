// Sections whose faults cut no horizon on both walls, deformed by small steps of the raw field of trishear: the slip is
// found from the shapes of the beds, and the section is taken back with what was found.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recon/inversion/trishear_fit.h"
#include "recon/moving/move_section.h"
#include "tests/recon/inversion/folded_beds.h"

namespace recon::inversion {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Even trishear in front of a tip; the hanging wall lies to the left of the direction of the ramp.
struct Truth {
  geom::Point tip;  ///< Before the slip.
  double ramp, propagation, apical, slip;
  [[nodiscard]] geom::Vector along() const { return {std::cos(ramp * degree), std::sin(ramp * degree)}; }
  [[nodiscard]] geom::Point tip_after() const { return tip + propagation * std::abs(slip) * along(); }
};

/// Where classical Runge-Kutta steps of the raw field take a point, in the frame of the tip.
geom::Point stepped(const Truth& truth, geom::Point p) {
  const double m = std::tan(0.5 * truth.apical * degree);
  const double sense = truth.slip < 0.0 ? -1.0 : 1.0;
  const auto rate = [&](geom::Vector at) -> geom::Vector {
    const geom::Vector tip{-truth.propagation, 0.0};
    if (at.x <= 0.0 || std::abs(at.y) >= m * at.x) return at.y > 0.0 ? tip + geom::Vector{sense, 0.0} : tip;
    const double e = at.y / (m * at.x);
    return tip + sense * geom::Vector{0.5 * (e + 1.0), 0.25 * m * (e * e - 1.0)};
  };
  const geom::Vector along = truth.along();
  const geom::Vector out = geom::left_of(along);
  geom::Vector at{geom::dot(p - truth.tip, along), geom::dot(p - truth.tip, out)};
  constexpr int steps = 3000;
  const double h = std::abs(truth.slip) / steps;
  for (int i = 0; i < steps; ++i) {
    const geom::Vector a = rate(at);
    const geom::Vector b = rate(at + 0.5 * h * a);
    const geom::Vector c = rate(at + 0.5 * h * b);
    const geom::Vector d = rate(at + h * c);
    at = at + (h / 6.0) * (a + 2.0 * b + 2.0 * c + d);
  }
  return truth.tip_after() + at.x * along + at.y * out;
}

constexpr double width = 5000.0;  ///< Of the beds.

section::Section deformed(const Truth& truth, const std::vector<double>& heights) {
  section::Section section;
  for (const double z : heights) {
    std::vector<geom::Point> points;
    for (int i = 0; i <= 40; ++i) points.push_back(stepped(truth, {-2000.0 + width * i / 40.0, z}));
    test::add_horizon("z" + std::to_string(static_cast<int>(z)), std::move(points), section);
  }
  section.border = geom::Polyline{{{-3500, -1500}, {4500, -1500}, {4500, 2500}, {-3500, 2500}}, true};
  return section;
}

/// From the lower border, or from its side where it is level, to the tip.
void draw_fault(geom::Point tip, double ramp, section::Section& section) {
  const geom::Vector along{std::cos(ramp * degree), std::sin(ramp * degree)};
  const double length = std::abs(along.y) < 0.1 ? (tip.x + 3500.0) / along.x : (tip.y + 1500.0) / along.y;
  section::SectionLine fault;
  fault.id = section::LineId(0);
  fault.kind = section::LineKind::Fault;
  fault.name = "F";
  fault.line.points = {tip - length * along, tip};
  section.lines = {fault};
}

/// Takes the section back with what was found.
void expect_flat_again(section::Section section, const Fit& fit, const std::vector<double>& heights) {
  const double ramp = test::estimate(fit, "ramp").best;
  if (section.lines.empty())
    draw_fault({test::estimate(fit, "tip_x").best, test::estimate(fit, "tip_z").best}, ramp, section);
  moving::MoveParams params;
  params.fault = "F";
  params.method = moving::MoveMethod::Trishear;
  params.slip = -test::estimate(fit, "slip").best;
  params.apical = base::Angle::from_degrees(test::estimate(fit, "apical").best);
  params.propagation = test::estimate(fit, "propagation").best;
  if (ramp == 0.0) params.towards = moving::Towards::PlusX;
  const auto moved = moving::move_block(section, params, {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    // The points that the forward model made: between them the bed was no chord.
    const std::vector<geom::Point>& bed = section.horizons[i].line.points;
    for (const geom::Point p : bed)
      ASSERT_NEAR(moved->forward(p).y, heights[i], 1e-6 * width) << heights[i] << " at " << p.x;
    EXPECT_NEAR(moved->forward(bed.front()).x, -2000.0, 1e-4 * std::abs(*params.slip));
    EXPECT_NEAR(moved->forward(bed.back()).x, 3000.0, 1e-4 * std::abs(*params.slip));
  }
}

void expect_slip(const Fit& fit, double slip) {
  EXPECT_NEAR(test::estimate(fit, "slip").best, slip, 1e-4 * std::abs(slip));
}

Fit blind_fit_of(const section::Section& section, const InvertParams& params) {
  auto found = invert(section, params, {});
  EXPECT_TRUE(found) << to_string(found.error());
  return found ? std::move(found->fit) : Fit{};
}

TEST(BlindTruth, TrishearOfWhichNothingIsKnown) {
  const std::vector<double> heights{450, 800};
  const Truth truth{{300, 150}, 30, 1.5, 60, 150};
  const section::Section section = deformed(truth, heights);
  InvertParams params;
  params.ramp = {5, 85};
  params.generations = 40;
  const Fit fit = blind_fit_of(section, params);
  expect_slip(fit, truth.slip);
  expect_flat_again(section, fit, heights);
}

TEST(BlindTruth, TipInsideOfAFaultThatIsDrawn) {
  const std::vector<double> heights{450, 800};
  // Thrusts, and a normal fault whose tip goes up as well.
  for (const Truth& truth :
       {Truth{{300, 150}, 30, 1.5, 60, 150}, Truth{{100, 0}, 25, 0.8, 80, 260}, Truth{{0, 100}, 60, 1.8, 50, -180}}) {
    SCOPED_TRACE(truth.slip);
    section::Section section = deformed(truth, heights);
    draw_fault(truth.tip_after(), truth.ramp, section);
    InvertParams params;
    params.fault = "F";
    params.slip = {-600, 600};
    params.generations = 40;
    const Fit fit = blind_fit_of(section, params);
    expect_slip(fit, truth.slip);
    expect_flat_again(section, fit, heights);
  }
}

TEST(BlindTruth, DetachmentOfUnknownDepthAndSlip) {
  const std::vector<double> heights{400, 700, 1000};
  const Truth truth{{-400, 100}, 0, 1.2, 70, 240};
  const section::Section section = deformed(truth, heights);
  InvertParams params;
  params.ramp = {0};
  params.tip_x = {-1000, 500};
  params.generations = 40;
  const Fit fit = blind_fit_of(section, params);
  expect_slip(fit, truth.slip);
  EXPECT_NEAR(test::estimate(fit, "tip_z").best, truth.tip.y, 1e-4 * truth.slip);
  expect_flat_again(section, fit, heights);
}

}  // namespace
}  // namespace recon::inversion
