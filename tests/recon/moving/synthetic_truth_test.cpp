// Sections that a forward model of this file deforms, by closed forms or by small steps of the velocity field, and that
// are restored with slip solved from their cutoffs alone. Where none is cut on both walls, the slip is known here and
// found from the shapes of the beds in tests/recon/inversion/blind_truth_test.cpp.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "recon/moving/move_section.h"

namespace recon::moving {
namespace {

using Points = std::vector<geom::Point>;
using PointMap = std::function<geom::Point(geom::Point)>;

constexpr double to_radians = std::numbers::pi / 180.0;

/// Where a map changes its formula: a x + b z = c.
struct BreakLine {
  double a = 0.0, b = 0.0, c = 0.0;
  [[nodiscard]] double off(geom::Point p) const { return a * p.x + b * p.y - c; }
};
BreakLine line_through(geom::Point p, geom::Vector along) { return {along.y, -along.x, along.y * p.x - along.x * p.y}; }

/// A fault as heights over x, its ends going on straight; the hanging wall lies above.
struct FaultCourse {
  Points points;  ///< Ascending in x.
  [[nodiscard]] double height(double x) const {
    std::size_t i = 0;
    while (i + 2 < points.size() && x > points[i + 1].x) ++i;
    const geom::Point p = points[i];
    const geom::Point q = points[i + 1];
    return p.y + (q.y - p.y) * (x - p.x) / (q.x - p.x);
  }
  [[nodiscard]] double arc(double x) const {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double low = i == 0 ? -1e9 : points[i].x;
      const double high = i + 2 == points.size() ? 1e9 : points[i + 1].x;
      const double slope = (points[i + 1].y - points[i].y) / (points[i + 1].x - points[i].x);
      sum += std::clamp(x, low, high) * std::hypot(1.0, slope) - (i == 0 ? 0.0 : low * std::hypot(1.0, slope));
    }
    return sum;
  }
};

/// One slip of the forward model: what lies above the fault goes by a map.
struct ForwardSlip {
  FaultCourse fault;
  PointMap map;
  std::vector<BreakLine> breaks;
};

struct NamedLine {
  std::string name, whole;
  Points points;
};

/// Beds, faults and one polygon, deformed by one slip after the other.
struct Body {
  std::vector<NamedLine> beds, faults;
  Points unit;  ///< Closed.

  void slip(const ForwardSlip& by) {
    cut(beds, by);
    cut(faults, by);
    for (geom::Point& p : unit = with_breaks(unit, by, true)) {
      if (above(p, by)) p = by.map(p);
    }
  }

 private:
  static bool above(geom::Point p, const ForwardSlip& by) { return p.y > by.fault.height(p.x); }

  static void add_zeros(geom::Point p, geom::Point q, const std::function<double(geom::Point)>& off,
                        std::vector<double>& parts) {
    const double a = off(p);
    const double b = off(q);
    if (a * b < 0.0) parts.push_back(a / (a - b));
  }

  /// Further vertices where the map changes its formula and where the fault runs.
  static Points with_breaks(const Points& line, const ForwardSlip& by, bool closed) {
    Points refined;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
      const geom::Point p = line[i];
      const geom::Point q = line[(i + 1) % line.size()];
      std::vector<double> parts{0.0};
      for (const BreakLine& one : by.breaks)
        add_zeros(
            p, q, [&](geom::Point r) { return one.off(r); }, parts);
      for (const geom::Point bend : by.fault.points)
        add_zeros(
            p, q, [&](geom::Point r) { return r.x - bend.x; }, parts);
      std::sort(parts.begin(), parts.end());
      const std::vector<double> straight = parts;
      for (std::size_t k = 0; k < straight.size(); ++k) {
        const double from = straight[k];
        const double to = k + 1 < straight.size() ? straight[k + 1] : 1.0;
        const geom::Point u = geom::interpolate(p, q, from);
        const geom::Point v = geom::interpolate(p, q, to);
        std::vector<double> met;
        add_zeros(
            u, v, [&](geom::Point r) { return r.y - by.fault.height(r.x); }, met);
        if (!met.empty()) parts.push_back(from + met.front() * (to - from));
      }
      std::sort(parts.begin(), parts.end());
      for (const double part : parts) refined.push_back(geom::interpolate(p, q, part));
    }
    if (!closed) refined.push_back(line.back());
    return refined;
  }

  static void cut(std::vector<NamedLine>& lines, const ForwardSlip& by) {
    std::vector<NamedLine> pieces;
    for (const NamedLine& line : lines) {
      const Points refined = with_breaks(line.points, by, false);
      Points piece;
      const auto put = [&](bool moves) {
        if (piece.size() < 2) return;
        if (moves) std::transform(piece.begin(), piece.end(), piece.begin(), by.map);
        pieces.push_back({"", line.whole, piece});
      };
      bool moving = false;
      for (std::size_t i = 0; i + 1 < refined.size(); ++i) {
        const bool moves = above(geom::midpoint(refined[i], refined[i + 1]), by);
        if (piece.empty() || moves != moving) {
          put(moving);
          piece = {refined[i]};
          moving = moves;
        }
        piece.push_back(refined[i + 1]);
      }
      put(moving);
    }
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const NamedLine& a, const NamedLine& b) { return a.whole < b.whole; });
    for (std::size_t i = 0, number = 0; i < pieces.size(); ++i) {
      number = i > 0 && pieces[i - 1].whole == pieces[i].whole ? number + 1 : 1;
      pieces[i].name = pieces[i].whole + " (" + std::to_string(number) + ")";
    }
    lines = std::move(pieces);
  }
};

section::Section section_of(const Body& body, const std::vector<std::pair<std::string, Points>>& faults) {
  section::Section section;
  for (const NamedLine& bed : body.beds)
    section.horizons.push_back(
        {section::HorizonId(section.horizons.size()), bed.name, {bed.points, false}, {}, bed.whole});
  const auto add = [&](const std::string& name, const std::string& whole, const Points& points, int order) {
    section.lines.push_back(
        {section::LineId(section.lines.size()), section::LineKind::Fault, name, {points, false}, {}});
    section.lines.back().piece_of = whole;
    section.lines.back().order = order;
  };
  int order = 1;
  for (const auto& [name, points] : faults) add(name, {}, points, order++);
  for (const NamedLine& piece : body.faults) add(piece.name, piece.whole, piece.points, order);
  section.units.push_back({section::UnitId(0), "Q", {body.unit, true}, {}});
  return section;
}

Body flat_beds(double left, double right, const std::vector<double>& heights, Points unit) {
  Body body;
  for (const double z : heights) {
    const std::string name = "z" + std::to_string(static_cast<int>(z));
    body.beds.push_back({name, name, {{left, z}, {right, z}}});
  }
  body.unit = std::move(unit);
  return body;
}

Points box(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

ForwardSlip shift(FaultCourse fault, geom::Vector by) {
  return {std::move(fault), [by](geom::Point p) { return p + by; }, {}};
}

/// q' = q + h cos a, w' = w + W(q') - W(q) across and along the direction of shear, `angle` from the vertical.
ForwardSlip inclined(const FaultCourse& fault, double angle, double h) {
  const double c = std::cos(angle * to_radians);
  const double s = std::sin(angle * to_radians);
  FaultCourse turned;
  ForwardSlip slip{fault, {}, {}};
  for (const geom::Point p : fault.points) {
    turned.points.push_back({p.x * c - p.y * s, p.x * s + p.y * c});
    slip.breaks.push_back({c, -s, turned.points.back().x});
    slip.breaks.push_back({c, -s, turned.points.back().x - h * c});
  }
  slip.map = [turned, c, s, h](geom::Point p) {
    const double q = p.x * c - p.y * s;
    const double q2 = q + h * c;
    const double w2 = p.x * s + p.y * c + turned.height(q2) - turned.height(q);
    return geom::Point{q2 * c + w2 * s, -q2 * s + w2 * c};
  };
  return slip;
}

/// Straight motion in domains that are parted by lines through the bends along v_i - v_(i+1); towards +x.
ForwardSlip domains(const FaultCourse& fault, const std::vector<double>& speeds, double slip) {
  std::vector<geom::Vector> v;
  for (std::size_t i = 0; i + 1 < fault.points.size(); ++i)
    v.push_back(speeds[i] * geom::normalised(fault.points[i + 1] - fault.points[i]));
  std::vector<BreakLine> walls;
  ForwardSlip made{fault, {}, {}};
  for (std::size_t i = 0; i + 1 < v.size(); ++i) {
    const geom::Point bend = fault.points[i + 1];
    geom::Vector rise = v[i] - v[i + 1];
    if (rise.y < 0.0) rise = -rise;
    walls.push_back(line_through(bend, rise));  // > 0 to the right, as rise.y > 0
    made.breaks.push_back(walls.back());
    made.breaks.push_back(line_through(bend - slip * v[i], rise));
  }
  made.map = [walls, v, slip](geom::Point p) {
    double left = slip;
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (i < walls.size() && walls[i].off(p) >= 0.0) continue;
      const double speed = i < walls.size() ? walls[i].a * v[i].x + walls[i].b * v[i].y : 0.0;
      const double until = i < walls.size() ? -walls[i].off(p) / speed : left;
      const double time = std::min(left, until);
      p = p + time * v[i];
      left -= time;
      if (left <= 0.0) break;
    }
    return p;
  };
  return made;
}

struct TruthStep {
  MoveParams params;
  double slip = 0.0;
};

MoveParams step_on(const char* fault, MoveMethod method, std::vector<std::string> close) {
  MoveParams params;
  params.fault = fault;
  params.method = method;
  params.close = std::move(close);
  return params;
}

/// Restores, and compares with the beds and the polygon before the forward model.
void expect_restored(section::Section section, const Body& before, const std::vector<TruthStep>& steps) {
  for (const TruthStep& step : steps) {
    const auto moved = move_block(section, step.params, {});
    ASSERT_TRUE(moved) << to_string(moved.error());
    EXPECT_NEAR(moved->motion.slip, step.slip, 1e-6) << step.params.fault;
    EXPECT_NEAR(moved->opened.gap, 0.0, 1e-3);
    section = moved->section;
  }
  for (const NamedLine& bed : before.beds) {
    const double width = bed.points.back().x - bed.points.front().x;
    double length = 0.0;
    for (const section::Horizon& piece : section.horizons) {
      if (whole_name(piece) != bed.whole) continue;
      length += geom::length(piece.line);
      for (const geom::Point p : piece.line.points)
        ASSERT_NEAR(p.y, bed.points.front().y, 1e-6 * width) << piece.name << " at " << p.x;
    }
    EXPECT_NEAR(length, width, 1e-9 * width) << bed.whole;
  }
  double area = 0.0;
  for (const section::Unit& unit : section.units) area += geom::signed_area(unit.contour);
  const double true_area = geom::signed_area(geom::Polyline{before.unit, true});
  EXPECT_NEAR(area, true_area, 1e-9 * true_area);
}

double slip_between(const FaultCourse& fault, double x_footwall, double x_hanging) {
  return std::abs(fault.arc(x_hanging) - fault.arc(x_footwall));
}

double x_of_cut(const FaultCourse& fault, double z) {
  double low = -1e5, high = 1e5;  // a fault that falls or rises all along
  const double sign = fault.height(high) > fault.height(low) ? 1.0 : -1.0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (sign * (fault.height(middle) - z) < 0.0 ? low : high) = middle;
  }
  return low;
}

FaultCourse listric_course() {
  FaultCourse fault;
  for (int i = 0; i <= 24; ++i)
    fault.points.push_back({-200.0 + 200.0 * i, -1200.0 * (1.0 - std::exp((200.0 - 200.0 * i) / 900.0)) + 100.0});
  return fault;
}

TEST(SyntheticTruth, PlanarNormalFault) {
  const FaultCourse fault{{{-300, 300}, {1500, -1500}}};
  const Body before = flat_beds(-2000, 3000, {-100, -500, -900}, box(1200, -800, 2500, -600));
  Body body = before;
  body.slip(shift(fault, {90, -90}));
  for (const MoveMethod method :
       {MoveMethod::Rigid, MoveMethod::Shear, MoveMethod::FaultParallelFlow, MoveMethod::FlexuralSlip})
    expect_restored(section_of(body, {{"F", fault.points}}), before,
                    {{step_on("F", method, {"z-500"}), 90.0 * std::numbers::sqrt2}});
}

TEST(SyntheticTruth, ListricAndRampFlatFaultsUnderInclinedShear) {
  const FaultCourse ramp_flat{{{-200, 200}, {600, -600}, {1600, -700}, {2400, -1300}, {5000, -1350}}};
  for (const FaultCourse& fault : {listric_course(), ramp_flat}) {
    for (const double angle : {0.0, 20.0, -20.0}) {
      SCOPED_TRACE(angle);
      const Body before = flat_beds(-1500, 4500, {-50, -250, -500}, box(1500, -400, 3200, -300));
      Body body = before;
      const ForwardSlip slip = inclined(fault, angle, 260.0);
      body.slip(slip);
      MoveParams params = step_on("F", MoveMethod::Shear, {"z-250"});
      params.angle = base::Angle::from_degrees(angle);
      const double x = x_of_cut(fault, -50.0);
      const double true_slip = slip_between(fault, x, slip.map({x, -50.0}).x);
      expect_restored(section_of(body, {{"F", fault.points}}), before, {{params, true_slip}});
      params.close = {"z-50", "z-250", "z-500"};
      expect_restored(section_of(body, {{"F", fault.points}}), before, {{params, true_slip}});
    }
  }
}

TEST(SyntheticTruth, TwoSyntheticFaultsAndAnAntitheticPair) {
  const Body before = flat_beds(-2000, 5000, {-100, -400}, box(900, -350, 1400, -150));
  const FaultCourse west{{{-200, 200}, {500, -1200}}};
  const FaultCourse east{{{1900, 200}, {2600, -1200}}};
  Body body = before;
  body.slip(shift(west, {50, -100}));
  body.slip(shift(east, {30, -60}));
  expect_restored(section_of(body, {{"E", east.points}, {"W", west.points}}), before,
                  {{step_on("E", MoveMethod::Rigid, {"z-100"}), std::hypot(30, 60)},
                   {step_on("W", MoveMethod::Rigid, {"z-100", "z-400"}), std::hypot(50, 100)}});
  // The younger one dips the other way; it takes along all west of it, the older fault too.
  const FaultCourse antithetic{{{1800, -900}, {2350, 200}}};
  body = before;
  body.faults = {{"W", "W", west.points}};
  body.slip(shift(west, {50, -100}));
  body.slip(shift(antithetic, {-40, -80}));
  expect_restored(section_of(body, {{"E", antithetic.points}}), before,
                  {{step_on("E", MoveMethod::FaultParallelFlow, {"z-400"}), std::hypot(40, 80)},
                   {step_on("W", MoveMethod::Shear, {"z-100"}), std::hypot(50, 100)}});
}

TEST(SyntheticTruth, ThrustWithAFaultBendFold) {
  const double theta = 20.0 * to_radians;
  const double gamma = std::atan((1.0 + std::sqrt(1.0 - 3.0 * std::pow(std::tan(theta), 2))) / std::tan(theta));
  const double ratio = std::sin(gamma - theta) / std::sin(gamma);
  const FaultCourse fault{
      {{-5000, 0}, {0, 0}, {1400 * std::cos(theta), 1400 * std::sin(theta)}, {9000, 1400 * std::sin(theta)}}};
  for (const double slip : {350.0, 800.0}) {
    const Body before = flat_beds(-5000, 8000, {250, 400, 900}, box(-900, 600, 2400, 800));
    Body body = before;
    body.slip(domains(fault, {1.0, 1.0, ratio}, slip));
    expect_restored(section_of(body, {{"F", fault.points}}), before,
                    {{step_on("F", MoveMethod::FaultBendFold, {"z250"}), -slip}});
    expect_restored(section_of(body, {{"F", fault.points}}), before,
                    {{step_on("F", MoveMethod::FaultBendFold, {"z250", "z400"}), -slip}});
  }
}

TEST(SyntheticTruth, ImbricateOfThreeThrustsOnOneDetachment) {
  const double rise = std::tan(25.0 * to_radians);
  const auto thrust = [&](double x) { return FaultCourse{{{-6000, 0}, {x, 0}, {x + 1500, 1500 * rise}}}; };
  const Body before = flat_beds(-5000, 9000, {150, 300, 450}, box(-900, 200, -300, 400));
  Body body = before;
  const auto ramp = [&](double x) { return Points{{x, 0}, {x + 1500, 1500 * rise}}; };
  body.slip(domains(thrust(0), {1, 1}, 250));
  body.faults = {{"F1", "F1", ramp(0)}};
  body.slip(domains(thrust(2500), {1, 1}, 330));
  body.faults.push_back({"F2", "F2", ramp(2500)});
  body.slip(domains(thrust(5000), {1, 1}, 280));
  body.faults.push_back({"F3", "F3", ramp(5000)});
  section::Section section = section_of(body, {{"D", {{-6000, 0}, {9000, 0}}}});
  for (section::SectionLine& line : section.lines) {
    const std::string& name = whole_name(line);
    line.order = name == "D" ? 0 : name == "F3" ? 1 : name == "F2" ? 2 : 3;
  }
  expect_restored(section, before,
                  {{step_on("F3", MoveMethod::FaultParallelFlow, {"z150"}), -280.0},
                   {step_on("F2", MoveMethod::FaultParallelFlow, {"z300"}), -330.0},
                   {step_on("F1", MoveMethod::FaultParallelFlow, {"z150", "z450"}), -250.0}});
}

TEST(SyntheticTruth, FaultThatAYoungerOneHasCut) {
  const FaultCourse older{{{-500, 400}, {1500, -1600}}};
  const FaultCourse younger{{{-700, -1500}, {1500, 400}}};
  const Body before = flat_beds(-2500, 3500, {-100, -700}, box(1700, -600, 2500, -300));
  Body body = before;
  body.faults = {{"O", "O", older.points}};
  body.slip(shift(older, {120, -120}));
  const geom::Vector along = geom::normalised(younger.points[0] - younger.points[1]);
  body.slip(shift(younger, 140.0 * along));
  expect_restored(section_of(body, {{"Y", younger.points}}), before,
                  {{step_on("Y", MoveMethod::Rigid, {"z-100"}), 140.0},
                   {step_on("O", MoveMethod::Rigid, {"z-700"}), 120.0 * std::numbers::sqrt2}});
}

/// The raw field of trishear with even shear, by classical Runge-Kutta steps. The tip is at the origin before.
geom::Point trisheared(geom::Point p, double half_angle, double ps, double slip, int steps) {
  const double m = std::tan(half_angle);
  const auto rate = [&](double x, double y) -> geom::Vector {
    if (x <= 0.0 || std::abs(y) >= m * x) return y > 0.0 ? geom::Vector{1.0 - ps, 0.0} : geom::Vector{-ps, 0.0};
    const double e = y / (m * x);
    return {0.5 * (e + 1.0) - ps, 0.25 * m * (e * e - 1.0)};
  };
  double x = p.x, y = p.y;
  const double h = slip / steps;
  for (int i = 0; i < steps; ++i) {
    const geom::Vector a = rate(x, y);
    const geom::Vector b = rate(x + 0.5 * h * a.x, y + 0.5 * h * a.y);
    const geom::Vector c = rate(x + 0.5 * h * b.x, y + 0.5 * h * b.y);
    const geom::Vector d = rate(x + h * c.x, y + h * c.y);
    x += h / 6.0 * (a.x + 2.0 * b.x + 2.0 * c.x + d.x);
    y += h / 6.0 * (a.y + 2.0 * b.y + 2.0 * c.y + d.y);
  }
  return {x + ps * slip, y};
}

TEST(SyntheticTruth, TrishearInFrontOfATipInsideRestoresWithTheSlipThatMadeIt) {
  const double ps = 1.5, slip = 150.0, length = 900.0;
  section::Section section;
  std::vector<double> heights{450.0, 800.0};
  const double dip = 30.0 * to_radians;
  const geom::Vector along{std::cos(dip), std::sin(dip)};
  const geom::Vector out{-along.y, along.x};
  const geom::Point tip = geom::Point{-500, -300} + length * along;
  for (const double z : heights) {
    geom::Polyline bed;
    for (int i = 0; i <= 5000; ++i) {
      const geom::Vector from = geom::Point{-2000.0 + 1.0 * i, z} - tip;
      const geom::Point q =
          trisheared({geom::dot(from, along), geom::dot(from, out)}, 30.0 * to_radians, ps, slip, 200);
      bed.points.push_back(tip + q.x * along + q.y * out);
    }
    section.horizons.push_back(
        {section::HorizonId(section.horizons.size()), "z" + std::to_string(static_cast<int>(z)), bed, {}});
  }
  section.lines.push_back(
      {section::LineId(0), section::LineKind::Fault, "F", {{{-500, -300}, tip + ps * slip * along}, false}, {}});
  section.border = geom::Polyline{box(-2500, -300, 3500, 1500), true};
  MoveParams params = step_on("F", MoveMethod::Trishear, {});
  params.slip = -slip;
  params.apical = base::Angle::from_degrees(60.0);
  params.propagation = ps;
  const auto moved = move_block(section, params, {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    for (const geom::Point p : moved->section.horizons[i].line.points) ASSERT_NEAR(p.y, heights[i], 5e-3);
    EXPECT_NEAR(geom::length(moved->section.horizons[i].line), 5000.0, 5e-4);  // chords of 1 m over the zone's sides
  }
  EXPECT_LT(geom::distance(moved->section.lines[0].line.points.back(), tip), 1e-9);
}

/// Parallel fault-propagation folds built of dip domains, of beds that were level at a height h above the flat. Its bed
/// is level, turns up by theta at the axial plane of the bend, comes down by beta in front, and is level again from the
/// axial plane of the tip on, or ends on the fault. Angles by the equation of [suppe1990].
class DipDomains {
 public:
  DipDomains(double theta, double slip) : theta_(theta * to_radians), slip_(slip) {
    const auto off = [&](double g) {
      return (1.0 + 2.0 * std::cos(g) * std::cos(g)) / std::sin(2.0 * g) + (std::cos(theta_) - 2.0) / std::sin(theta_);
    };
    double low = 1e-3;  // of gamma*
    double high = low;
    while (off(high) > 0.0) high += 1e-3;  // the lesser root; the other one is trivial
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (off(middle) > 0.0 ? low : high) = middle;
    }
    gamma_ = low + 0.5 * theta_;
    beta_ = std::numbers::pi - 2.0 * gamma_;
    // Limbs as long as takes up the slip: a (1 - cos theta) + f (1 - cos beta) = slip, a sin theta = f sin beta.
    limb_ = slip / (std::sin(theta_) * (std::tan(0.5 * theta_) + std::tan(0.5 * beta_)));
    front_ = limb_ * std::sin(theta_) / std::sin(beta_);
    // The bed that the tip has just reached has no crest.
    tip_ = (limb_ * std::cos(theta_) + front_ * std::cos(beta_)) * up();
  }
  [[nodiscard]] geom::Point tip() const { return {tip_.x, tip_.y}; }

  /// From x = left + slip to right; two pieces where the tip has cut the bed.
  [[nodiscard]] std::vector<Points> bed(double left, double right, double h) const {
    const geom::Point bend{-h * std::tan(0.5 * theta_), h};
    const geom::Point start{left + slip_, h};
    if (h > tip_.y) {
      const geom::Point front =
          tip() + ((h - tip_.y) / std::sin(gamma_)) * geom::Vector{std::cos(gamma_), std::sin(gamma_)};
      return {{start, bend, bend + limb_ * up(), front - front_ * down(), front, {right, h}}};
    }
    // The limbs meet on the plane that bisects them, which goes down from the bed of the tip.
    const geom::Point branch = geom::Point{-tip_.y * std::tan(0.5 * theta_), tip_.y} + limb_ * up();
    const geom::Vector plane = up() - down();
    const double back = geom::cross(branch - bend, plane) / geom::cross(up(), plane);
    const geom::Point top = bend + back * up();
    const double fore = geom::cross(geom::Point{} - top, up()) / geom::cross(down(), up());
    return {{start, bend, top, top + fore * down()}, {{h / std::tan(theta_), h}, {right, h}}};
  }

 private:
  [[nodiscard]] geom::Vector up() const { return {std::cos(theta_), std::sin(theta_)}; }
  [[nodiscard]] geom::Vector down() const { return {std::cos(beta_), -std::sin(beta_)}; }
  double theta_, slip_, gamma_ = 0.0, beta_ = 0.0, limb_ = 0.0, front_ = 0.0;
  geom::Vector tip_;
};

TEST(SyntheticTruth, FaultPropagationFoldBuiltOfDipDomains) {
  const double left = -3000.0, right = 4000.0;
  for (const auto& [theta, slip] : {std::pair{15.0, 500.0}, {25.0, 400.0}, {35.0, 300.0}}) {
    SCOPED_TRACE(theta);
    const DipDomains fold(theta, slip);
    const Body before = flat_beds(left, right, {100, 600, 1000}, box(left, 600, right, 1000));
    Body body = before;
    body.beds.clear();
    for (const NamedLine& bed : before.beds) {
      const std::vector<Points> pieces = fold.bed(left, right, bed.points.front().y);
      double length = 0.0;
      for (const Points& piece : pieces) {
        length += geom::length(geom::Polyline{piece, false});
        body.beds.push_back({bed.whole + " (" + std::to_string(body.beds.size() + 1) + ")", bed.whole, piece});
      }
      ASSERT_NEAR(length, right - left, 1e-9 * (right - left)) << bed.whole;  // of the construction itself
    }
    ASSERT_EQ(body.beds.size(), 4U);  // the tip has cut the lowest one
    body.unit = fold.bed(left, right, 600).front();
    const Points roof = fold.bed(left, right, 1000).front();
    body.unit.insert(body.unit.end(), roof.rbegin(), roof.rend());
    const section::Section section = section_of(body, {{"F", {{left, 0}, {0, 0}, fold.tip()}}});
    expect_restored(section, before, {{step_on("F", MoveMethod::FaultPropagationFold, {"z100"}), -slip}});
    MoveParams known = step_on("F", MoveMethod::FaultPropagationFold, {});
    known.slip = -slip;
    expect_restored(section, before, {{known, -slip}});
  }
}

TEST(SyntheticTruth, DetachmentGivesBackTheSlipThatItHas) {
  const Body before = flat_beds(-2000, 2000, {200, 500}, box(-500, 250, 500, 450));
  const FaultCourse fault{{{-4000, 0}, {4000, 0}}};
  Body body = before;
  body.slip(shift(fault, {-320, 0}));
  section::Section section = section_of(body, {{"D", fault.points}});
  section.border = geom::Polyline{box(-4000, -500, 4000, 900), true};
  for (const Towards towards : {Towards::PlusX, Towards::MinusX}) {
    MoveParams params = step_on("D", MoveMethod::FaultParallelFlow, {});
    params.towards = towards;
    params.slip = towards == Towards::PlusX ? 320.0 : -320.0;
    expect_restored(section, before, {{params, *params.slip}});
  }
}

}  // namespace
}  // namespace recon::moving
