// Figures of move.md, fault_flow.md, fault_bend_fold.md, propagation_fold.md and trishear.md: level beds, and what a
// move makes of them.
#include <fmt/format.h>

#include <cmath>

#include "recon/kinematics/flow_domains.h"
#include "recon/moving/move_section.h"
#include "recon/section/palette.h"
#include "tests/figures/figures.h"

namespace dobra::figures {
namespace {

using geom::Point;
using recon::moving::MoveMethod;
using recon::moving::MoveParams;

const scene::Axes move_axes{"x [m]", "z [m]"};

/// Level beds every 200 m up from `low`, and one fault.
recon::section::Section level_beds(double left, double right, double low, int count, std::vector<Point> fault) {
  recon::section::Section section;
  for (int i = 0; i < count; ++i) {
    const double z = low + 200.0 * i;
    section.horizons.push_back({recon::section::HorizonId(section.horizons.size()),
                                fmt::format("bed {}", count - i),
                                chain({{left, z}, {right, z}}),
                                {}});
  }
  section.lines.push_back(
      {recon::section::LineId(0), recon::section::LineKind::Fault, "F", chain(std::move(fault)), {}});
  return section;
}

scene::Panel move_panel(const std::string& title, const recon::section::Section& section,
                        std::vector<geom::Polyline> walls) {
  std::vector<scene::Layer> layers;
  const recon::section::Palette palette(section);
  for (const recon::section::Horizon& horizon : section.horizons)
    layers.push_back(lines({}, stroke(palette.of(whole_name(horizon)).line, 1.6), {horizon.line}));
  if (!walls.empty()) layers.push_back(lines("walls", stroke(grey, 0.8, scene::Dash::Dashed), std::move(walls)));
  layers.push_back(lines("fault", stroke(red, 2.2), {section.lines[0].line}));
  return panel(title, std::move(layers), 60.0, move_axes);
}

MoveParams forward_by(MoveMethod method, double slip) {
  MoveParams params;
  params.fault = "F";
  params.method = method;
  params.direction = recon::moving::Direction::Forward;
  params.slip = slip;
  return params;
}

base::Result<scene::Picture> before_and_after(const recon::section::Section& section, const MoveParams& params,
                                              const char* after, std::vector<geom::Polyline> walls = {}) {
  DOBRA_TRY(const recon::moving::Moved moved, recon::moving::move_block(section, params, {}));
  scene::Picture picture{{}, {}, scene::Arrangement::Column};
  picture.panels = {move_panel("Before", section, {}), move_panel(after, moved.section, std::move(walls))};
  picture.panels[0].extent->add(*picture.panels[1].extent);
  picture.panels[1].extent = picture.panels[0].extent;
  return picture;
}

std::vector<Point> listric_fault() {
  std::vector<Point> points;
  for (int i = 0; i <= 12; ++i) points.push_back({-400.0 + 350.0 * i, 400.0 - 1500.0 * (1.0 - std::exp(-0.45 * i))});
  return points;
}

base::Result<scene::Picture> move() {
  MoveParams params = forward_by(MoveMethod::Shear, -500.0);
  params.angle = base::Angle::from_degrees(20.0);
  return before_and_after(level_beds(-1000, 4200, -800, 5, listric_fault()), params,
                          "500 m down the fault, sheared antithetically at 20 degrees");
}

base::Result<scene::Picture> fault_flow() {
  std::vector<Point> fault{{-2500, 0}, {-900, 0}, {-300, 110}, {200, 360}, {700, 780}, {1100, 1300}};
  DOBRA_TRY(const auto domains,
            recon::kinematics::FlowDomains::make({chain(fault)}, std::vector<double>(fault.size() - 1, 1.0)));
  std::vector<geom::Polyline> walls;
  constexpr double highest = 1250.0;
  for (const recon::kinematics::FlowWall& wall : domains.walls()) {
    if (wall.from < highest) walls.push_back(chain({wall.at, wall.point(std::min(wall.to, highest))}));
  }
  return before_and_after(level_beds(-2400, 1400, 200, 5, fault), forward_by(MoveMethod::FaultParallelFlow, 400.0),
                          "400 m up the fault, with the walls of the flow", std::move(walls));
}

base::Result<scene::Picture> fault_bend_fold() {
  return before_and_after(level_beds(-2500, 3200, 100, 5, {{-2500, 0}, {0, 0}, {1099, 400}, {3200, 400}}),
                          forward_by(MoveMethod::FaultBendFold, 600.0), "600 m along the lower flat");
}

base::Result<scene::Picture> propagation_fold() {
  MoveParams params = forward_by(MoveMethod::FaultPropagationFold, 400.0);
  params.ramp = base::Angle::from_degrees(25.0);
  params.towards = recon::moving::Towards::PlusX;
  return before_and_after(level_beds(-1800, 1800, 150, 5, {{-1800, 0}, {0, 0}}), params,
                          "400 m along the flat; the tip has climbed 738 m");
}

base::Result<scene::Picture> trishear() {
  MoveParams params = forward_by(MoveMethod::Trishear, 350.0);
  params.apical = base::Angle::from_degrees(60.0);
  params.propagation = 1.5;
  const double rise = std::tan(base::Angle::from_degrees(30.0).radians());
  return before_and_after(level_beds(-1500, 2300, -300, 7, {{-1000, -1000 * rise}, {100, 100 * rise}}), params,
                          "350 m up the ramp, P/S 1.5, apical angle 60 degrees");
}

}  // namespace

std::vector<Figure> fault_figures() {
  return {{"move", move},
          {"fault_flow", fault_flow},
          {"fault_bend_fold", fault_bend_fold},
          {"propagation_fold", propagation_fold},
          {"trishear", trishear}};
}

}  // namespace dobra::figures
