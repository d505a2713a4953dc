#include "quebra/core/validation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "quebra/core/operations.h"
#include "shared/base/text.h"
#include "shared/scenario/runner.h"

namespace quebra::core {
namespace {

using namespace dobra;

constexpr double pi = std::numbers::pi;

std::string scenario_of(const std::string& input, const std::string& state, const std::string& problem,
                        const std::string& steps) {
  return "dobra = 1\nprogram = \"quebra\"\n[input]\n" + input + "[[step]]\noperation = \"problem\"\nstate = \"" +
         state + "\"\n" + problem + steps;
}

std::string point(const char* name, double x, double y) {
  return fmt::format("[[input.point]]\nname = \"{}\"\npoint = [{}, {}]\n", name, x, y);
}
std::string line(const char* name, const char* points) {
  return fmt::format("[[input.curve]]\nname = \"{}\"\npoints = {}\n", name, points);
}
std::string material(double young, double poisson) {
  return fmt::format("[[step.material]]\nyoung = {}\npoisson = {}\n", young, poisson);
}
std::string support(const char* where, const char* what) {
  return fmt::format("[[step.support]]\nwhere = \"{}\"\n{}\n", where, what);
}
std::string load(const char* where, const char* what) {
  return fmt::format("[[step.load]]\nwhere = \"{}\"\n{}\n", where, what);
}

std::string adapt(double target) {
  return fmt::format("[[step]]\noperation = \"adapt\"\ntarget = {}\nmax_cycles = 20\n", target);
}
std::string crack_steps(double size, const std::string& rosette = "") {
  return fmt::format(
      "[[step]]\noperation = \"mesh\"\nsize = {}\norder = \"2\"\nrosettes = \"yes\"\n{}[[step]]\noperation = "
      "\"analyse\"\n[[step]]\noperation = \"crack\"\n",
      size, rosette);
}
std::string probe(const char* label, double x, double y) {
  return fmt::format("[[step]]\noperation = \"probe\"\nlabel = \"{}\"\nat = [{}, {}]\n", label, x, y);
}

const std::string held = support("anchor", "x = 0.0\ny = 0.0") + support("guide", "x = 0.0");
const std::string pulled = load("top", "y = 1.0") + load("bottom", "y = -1.0");
const std::string fine_mesh = "mesh 4 times as fine, 48 sectors, half the tip radius";

/// The tolerances of the three methods, with the default rosette.
constexpr double integral_tolerance = 1e-3;
constexpr double closure_tolerance = 2e-3;
constexpr double correlation_tolerance = 1e-2;

/// One K of one tip by the three methods, against a reference exact to 0.1 %.
struct Factor {
  std::string section, name;
  std::string scenario;
  std::string mode;  ///< "K_I" or "K_II"
  double unit = 1.0;
  double reference = 0.0;
  std::string source;
};
/// @param coarse  why the reference is exact to 0.15 % only; empty if it is not.
void add_by_three_methods(std::vector<ValidationCase>& cases, const Factor& f, const std::string& coarse = "") {
  const auto add = [&](const char* method, const char* prefix, double tolerance) {
    cases.push_back({f.section, fmt::format("{}, {} by {}", f.name, f.mode, method), f.scenario,
                     "tip.load.crack_end." + std::string(prefix) + f.mode, f.unit, f.reference,
                     tolerance + (coarse.empty() ? 0.0 : 1e-3), f.source, coarse});
  };
  add("interaction integral", "", integral_tolerance);
  add("crack closure", "closure.", closure_tolerance);
  add("displacement correlation", "correlation.", correlation_tolerance);
}

constexpr double kirsch_energy = 0.00844491271144;  // plane stress

/// Elements, and the mesh step that makes them.
struct Element {
  const char* name;
  const char* mesh;
  double order;
};
constexpr std::array<Element, 4> elements{{{"T3", "order = \"1\"\n", 1.0},
                                           {"T6", "order = \"2\"\n", 2.0},
                                           {"Q4 (few T3 between)", "order = \"1\"\nquads = \"yes\"\n", 1.0},
                                           {"Q8 (few T6 between)", "order = \"2\"\nquads = \"yes\"\n", 2.0}}};

/// Linear displacements on the rim of a square and of a hole in it: inside they are linear too, and the stress is the
/// same all over. Quarter-point elements: a crack along a pull, which it does not feel.
void add_patch_tests(std::vector<ValidationCase>& cases) {
  constexpr double tolerance = 1e-12;
  constexpr double xx = 1.0, yy = 0.3, xy = 0.7, poisson = 0.25, bulk = 1.0 / (1.0 - poisson * poisson);
  constexpr std::array stress{bulk * (xx + poisson * yy), bulk * (yy + poisson * xx), 0.5 * xy / (1.0 + poisson)};
  const double von_mises =
      std::sqrt(stress[0] * stress[0] + stress[1] * stress[1] - stress[0] * stress[1] + 3.0 * stress[2] * stress[2]);
  const std::string square =
      "[[input.curve]]\nname = \"rim\"\nkind = \"polygon\"\npoints = [[-1, -1], [1, -1], [1, 1], [-1, 1]]\n";
  const std::string held_linear = "x_formula = \"x + 0.5 * y\"\ny_formula = \"0.2 * x + 0.3 * y\"";
  const auto add = [&](const std::string& name, const std::string& text, const std::array<double, 3>& s, double mises,
                       double u_x) {
    const auto row = [&](const char* what, const char* quantity, double reference) {
      cases.push_back({"patch test", fmt::format("Patch of {}, {}", name, what), text, quantity, 1.0, reference,
                       tolerance, "closed form"});
    };
    row("u_x at (0.7, 0.2)", "probe.inside.load.u_x", u_x);
    row("s_xx at (0.7, 0.2)", "probe.inside.load.s_xx", s[0]);
    row("greatest von Mises stress", "case.load.max_von_mises", mises);
    row("greatest principal stress", "case.load.max_principal",
        0.5 * (s[0] + s[1]) + std::hypot(0.5 * (s[0] - s[1]), s[2]));
  };
  const std::string inside = probe("inside", 0.7, 0.2);
  for (const Element& element : elements) {
    const std::string mesh =
        fmt::format("[[step]]\noperation = \"mesh\"\nsize = 0.3\n{}[[step]]\noperation = \"analyse\"\n", element.mesh);
    add(element.name,
        scenario_of(
            square + "[[input.curve]]\nname = \"hole\"\nkind = \"circle\"\ncentre = [-0.2, 0.1]\nradius = 0.4\n",
            "stress",
            material(1.0, poisson) + support("rim", held_linear.c_str()) + support("hole", held_linear.c_str()),
            mesh + inside),
        stress, von_mises, 0.7 + 0.5 * 0.2);
  }
  const std::string cracked = line("bottom", "[[-1, -1], [1, -1]]") + line("right", "[[1, -1], [1, 1]]") +
                              line("top", "[[1, 1], [-1, 1]]") + line("left", "[[-1, 1], [-1, -1]]") +
                              "[[input.crack]]\nname = \"crack\"\npoints = [[-0.4, 0.0], [0.4, 0.0]]\n" +
                              point("origin", -1, -1);
  add("quarter-point T6",
      scenario_of(
          cracked, "stress",
          material(1.0, poisson) + support("left", "x = 0.0") + support("origin", "y = 0.0") + load("right", "x = 1.0"),
          "[[step]]\noperation = \"mesh\"\nsize = 0.3\norder = \"2\"\nrosettes = \"yes\"\ntip_radius = "
          "0.05\n[[step]]\noperation = \"analyse\"\n" +
              inside),
      {1.0, 0.0, 0.0}, 1.0, 1.7);
}

void add_kirsch(std::vector<ValidationCase>& cases) {
  const std::string input = "specimen = \"quarter_plate\"\nwidth = 4.0\nradius = 1.0\n";
  const std::string problem = material(1000.0, 0.3) + support("bottom", "normal = 0.0") +
                              support("left", "normal = 0.0") + load("right", "kind = \"kirsch\"\nvalue = 1.0") +
                              load("top", "kind = \"kirsch\"\nvalue = 1.0");
  const std::string source = "Kirsch, closed form by quadrature";
  const std::string energy = fmt::format("exact_energy = [{}]\n", kirsch_energy);
  const auto even = [&](double size, const std::string& rules) {
    return scenario_of(input, "stress", problem,
                       fmt::format("[[step]]\noperation = \"mesh\"\nsize = {}\n{}[[step]]\noperation = \"analyse\"\n{}",
                                   size, rules, energy));
  };
  for (const Element& element : elements) {
    const double order = element.order;
    cases.push_back({"rates", fmt::format("Plate with a hole, even meshes of {}, rate of the error in h", element.name),
                     even(0.05, element.mesh), "case.load.true_error", 1.0, order, 0.1,
                     "theory: the order of the elements",
                     "unstructured meshes, of h = 0.1 and 0.05, which are not alike", even(0.1, element.mesh)});
  }
  for (const char* const order : {"1", "2"}) {
    for (const double target : {5.0, 1.0}) {
      cases.push_back(
          {"effectivity", fmt::format("Plate with a hole, T{} adapted to {} %", order[0] == '1' ? 3 : 6, target),
           scenario_of(input, "stress", problem, adapt(target) + fmt::format("order = \"{}\"\n", order) + energy),
           "case.load.effectivity", 1.0, 1.0, 0.1, source, "an estimate: 0.9 to 1.1 is asked for"});
    }
  }
  const std::string strain = scenario_of(input, "strain", problem, adapt(0.05));
  const std::string stress =
      scenario_of(input, "stress", problem, adapt(0.05) + probe("side", 1, 0) + probe("crown", 0, 1));
  cases.push_back({"3.1", "Plate with a hole, plane strain, energy", strain, "case.load.energy", 1.0, 0.00769365372642,
                   1e-6, source});
  cases.push_back(
      {"3.1", "Plate with a hole, plane stress, energy", stress, "case.load.energy", 1.0, kirsch_energy, 1e-6, source});
  cases.push_back(
      {"3.1", "Plate with a hole, greatest stress", stress, "case.load.max_principal", 1.0, 3.0, 3e-3, source});
  cases.push_back(
      {"3.1", "Plate with a hole, s_xx at (0, 1)", stress, "probe.crown.load.s_xx", 1.0, 3.0, 3e-3, source});
  cases.push_back(
      {"3.1", "Plate with a hole, s_yy at (1, 0)", stress, "probe.side.load.s_yy", 1.0, -1.0, 3e-3, source});
}

/// Stress at a point: the hole holds little of the energy, so the error asked for is small.
void add_holes(std::vector<ValidationCase>& cases) {
  struct Row {
    double d, gross, net, howland;  // howland 0: not tabled
  };
  constexpr std::array<Row, 6> table{{{0.05, 3.008, 2.858, 0},
                                      {0.1, 3.035, 2.732, 3.03},
                                      {0.2, 3.152, 2.521, 3.14},
                                      {0.4, 3.746, 2.248, 3.74},
                                      {0.5, 4.346, 2.173, 4.32},
                                      {0.7, 6.983, 2.095, 0}}};
  for (const auto& [d, gross, net, howland] : table) {
    const std::string text =
        scenario_of(fmt::format("specimen = \"quarter_plate\"\nwidth = 4.0\nheight = 1.0\nradius = {}\n", d), "stress",
                    material(1.0, 0.3) + support("bottom", "normal = 0.0") + support("left", "normal = 0.0") +
                        load("right", "x = 1.0"),
                    adapt(0.1));
    const std::string name = fmt::format("Finite plate with a hole, d/W = {}", d);
    const double roark = 3.0 - 3.13 * d + 3.66 * d * d - 1.53 * d * d * d;
    const double heywood = 2.0 + (1.0 - d) * (1.0 - d) * (1.0 - d);
    cases.push_back(
        {"3.2", name + ", gross Kt", text, "case.load.max_principal", 1.0, gross, 1e-2, "list of references 3.2"});
    cases.push_back(
        {"3.2", name + ", net Kt", text, "case.load.max_principal", 1.0 - d, net, 1e-2, "list of references 3.2"});
    if (howland > 0.0)
      cases.push_back(
          {"3.2", name + ", gross Kt, Howland", text, "case.load.max_principal", 1.0, howland, 1e-2, "Howland 1930"});
    cases.push_back(
        {"3.2", name + ", net Kt, Roark", text, "case.load.max_principal", 1.0 - d, roark, 1e-2, "Roark, table 17.1"});
    cases.push_back(
        {"3.2", name + ", net Kt, Heywood", text, "case.load.max_principal", 1.0 - d, heywood, d < 0.3 ? 1e-2 : 4e-2,
         "Heywood",
         d < 0.3 ? "" : "a rule of thumb: Roark's formula and the table above are 0.9 to 3.4 % higher here"});
  }
}

void add_corners(std::vector<ValidationCase>& cases) {
  const std::string l = line("face_1", "[[0, 0], [1, 0]]") +
                        line("loaded", "[[1, 0], [1, 1], [-1, 1], [-1, -1], [0, -1]]") +
                        line("face_2", "[[0, -1], [0, 0]]") + point("origin", 0, 0) + point("far", 0, 1);
  const auto opened = [&](const std::string& steps) {
    return scenario_of(l, "strain",
                       material(1.0, 0.3) + support("origin", "x = 0.0\ny = 0.0") + support("far", "x = 0.0") +
                           load("loaded", "kind = \"l_shape\""),
                       steps);
  };
  const std::string source = "Szabo and Babuska 1991";
  cases.push_back(
      {"3.3", "L-shape, opening mode, energy", opened(adapt(0.1)), "case.load.energy", 1.0, 4.15454423, 5e-6, source});
  for (const char* const order : {"1", "2"}) {
    for (const double target : {5.0, 1.0}) {
      cases.push_back(
          {"effectivity", fmt::format("L-shape, opening mode, T{} adapted to {} %", order[0] == '1' ? 3 : 6, target),
           opened(adapt(target) + fmt::format("order = \"{}\"\nexact_energy = [4.15454423]\n", order)),
           "case.load.effectivity", 1.0, 0.95, 0.15 / 0.95, source, "an estimate: 0.8 to 1.1 is asked for"});
    }
  }
  cases.push_back(
      {"3.3", "L-shape, clamped, sheared, energy",
       scenario_of("specimen = \"l_shape\"\n", "stress",
                   material(1e5, 0.3) + support("bottom", "x = 0.0\ny = 0.0") + load("right", "y = 10.0"), adapt(0.2)),
       "case.load.energy", 1.0, 60.619, 1e-5, "list of references 3.3 (60.619 +- 0.0005)"});
  const std::string cook =
      scenario_of("specimen = \"cook\"\n", "stress",
                  material(1.0, 1.0 / 3.0) + support("left", "x = 0.0\ny = 0.0") + load("right", "y = 0.0625"),
                  adapt(0.2) + probe("below", 24, 22) + probe("above", 24, 52));
  cases.push_back({"3.4", "Cook's membrane, displacement", cook, "case.load.point.middle_right.u_y", 1.0, 23.967, 5e-5,
                   "list of references 3.4"});
  cases.push_back(
      {"3.4", "Cook's membrane, energy", cook, "case.load.energy", 1.0, 12.021, 1e-4, "list of references 3.4"});
  const std::string digits = "the reference has three digits";
  cases.push_back({"3.4", "Cook's membrane, greatest principal stress at (24, 22)", cook, "probe.below.load.s_1", 1.0,
                   0.237, 2.5e-3, "list of references 3.4", digits});
  cases.push_back({"3.4", "Cook's membrane, least principal stress at (24, 52)", cook, "probe.above.load.s_2", 1.0,
                   -0.203, 3e-3, "list of references 3.4", digits + ", cut off: adapted to 0.05 % it is -0.2035"});
}

std::string edge_crack(double a, const std::string& rosette = "") {
  const std::string input =
      fmt::format("specimen = \"single_edge_notch\"\nwidth = 1.0\nheight = 3.0\ncrack_length = {}\n", a) +
      point("anchor", 1, 0) + point("guide", 1, -1.5);
  return scenario_of(input, "stress", material(1.0, 0.3) + held + pulled, crack_steps(0.08, rosette));
}

void add_straight_cracks(std::vector<ValidationCase>& cases) {
  constexpr std::array<std::array<double, 2>, 6> edge{
      {{0.1, 1.189}, {0.2, 1.367}, {0.3, 1.659}, {0.4, 2.110}, {0.5, 2.824}, {0.6, 4.030}}};
  for (const auto& [a, f] : edge) {
    const std::string name = fmt::format("Edge crack, a/W = {}", a);
    const double unit = 1.0 / std::sqrt(pi * a);
    add_by_three_methods(cases, {"3.5", name, edge_crack(a), "K_I", unit, f, "list of references 3.5"});
    const double p = 0.5 * pi * a;
    const double tada =
        std::sqrt(std::tan(p) / p) * (0.752 + 2.02 * a + 0.37 * std::pow(1 - std::sin(p), 3)) / std::cos(p);
    cases.push_back(
        {"3.5", name + ", K_I, handbook", edge_crack(a), "tip.load.crack_end.K_I", unit, tada, a < 0.15 ? 6e-3 : 5e-3,
         "Tada, Paris, Irwin",
         a < 0.15 ? "the formula is said to be within 0.5 %; here it is 0.56 % above the reference of the list" : ""});
    const double polynomial = 1.122 - 0.231 * a + 10.55 * a * a - 21.71 * a * a * a + 30.382 * a * a * a * a;
    cases.push_back({"3.5", name + ", K_I, polynomial", edge_crack(a), "tip.load.crack_end.K_I", unit, polynomial, 5e-3,
                     "Gross and Brown, in Tada, Paris, Irwin"});
  }
  for (int i = 1; i <= 7; ++i) {
    const double a = 0.1 * i;
    const std::string input =
        fmt::format("specimen = \"centre_crack\"\nwidth = 2.0\nheight = 6.0\ncrack_length = {}\n", a) +
        point("anchor", 1, 0) + point("guide", 1, -3);
    add_by_three_methods(cases, {"3.6", fmt::format("Centre crack, a/W = {:.1f}", a),
                                 scenario_of(input, "stress", material(1.0, 0.3) + held + pulled, crack_steps(0.1)),
                                 "K_I", 1.0 / std::sqrt(pi * a),
                                 (1 - 0.025 * a * a + 0.06 * std::pow(a, 4)) * std::sqrt(1 / std::cos(0.5 * pi * a)),
                                 "Tada, Paris, Irwin (0.1 %)"});
  }
}

void add_compact_tension(std::vector<ValidationCase>& cases) {
  struct Row {
    double a, standard, fine;
  };
  constexpr std::array<Row, 7> table{{{0.3, 5.621, 5.62008},
                                      {0.4, 7.279, 7.26253},
                                      {0.45, 8.340, 8.31038},
                                      {0.5, 9.659, 9.62121},
                                      {0.55, 11.364, 11.3267},
                                      {0.6, 13.654, 13.6278},
                                      {0.7, 21.55, 21.5629}}};
  for (const auto& [a, standard, fine] : table) {
    const std::string pins = fmt::format("specimen = \"compact_tension\"\nwidth = 1.0\ncrack_length = {}\n", a) +
                             point("anchor", 1, 0) + point("guide", 1, 0.6);
    const std::string text = scenario_of(pins, "strain",
                                         material(1.0, 0.3) + held + load("load_upper", "kind = \"force\"\ny = 1.0") +
                                             load("load_lower", "kind = \"force\"\ny = -1.0"),
                                         crack_steps(0.08));
    const std::string name = fmt::format("Compact tension, a/W = {}", a);
    add_by_three_methods(cases, {"3.7 compact tension", name, text, "K_I", 1.0, fine, fine_mesh});
    cases.push_back({"3.7 compact tension", name + ", K_I, standard", text, "tip.load.crack_end.K_I", 1.0, standard,
                     5e-3, "ASTM E399 (0.5 %)"});
  }
}

void add_beams(std::vector<ValidationCase>& cases) {
  struct Row {
    double a, standard, fine;
  };
  constexpr std::array<Row, 7> table{{{0.3, 1.521, 6.05548},
                                      {0.4, 1.982, 7.88447},
                                      {0.45, 2.285, 9.0834},
                                      {0.5, 2.663, 10.5745},
                                      {0.55, 3.142, 12.4806},
                                      {0.6, 3.772, 14.994},
                                      {0.7, 5.850, 23.3667}}};
  for (const auto& [a, standard, fine] : table) {
    const std::string text =
        scenario_of(fmt::format("specimen = \"three_point_bend\"\nheight = 1.0\ncrack_length = {}\n", a), "strain",
                    material(1.0, 0.3) + support("support_left", "y = 0.0") + support("support_right", "y = 0.0") +
                        support("load", "x = 0.0") + load("load", "kind = \"force\"\ny = -1.0"),
                    crack_steps(0.08));
    const std::string name = fmt::format("Beam in three-point bending, a/W = {}", a);
    add_by_three_methods(cases, {"3.7 beam", name, text, "K_I", 1.0, fine, fine_mesh});
    if (a <= 0.6) {
      const double f = 1.090 - 1.735 * a + 8.20 * a * a - 14.18 * a * a * a + 14.57 * a * a * a * a;
      cases.push_back({"3.7 beam", name + ", K_I, handbook", text, "tip.load.crack_end.K_I",
                       1.0 / (6.0 * std::sqrt(pi * a)), f, a == 0.55 ? 6e-3 : 5e-3,
                       "Tada, Paris, Irwin, after Brown and Srawley 1966 (0.2 %)",
                       a == 0.55 ? "0.504 %: the formula is there farthest above the fine mesh" : ""});
    }
    // Points of support and load, span 4 W. What the beam is longer than its span does not matter (4.02 to 8 W: 0.003
    // %).
    const bool high = a > 0.3 && a < 0.7;
    cases.push_back({"3.7 beam", name + ", K_I, standard", text, "tip.load.crack_end.K_I", 0.25, standard,
                     high ? 8e-3 : 5e-3, "ASTM E399 (0.5 %)",
                     high ? "the fit is 0.3 to 0.45 % above the handbook's and up to 0.73 % above the fine mesh, whose "
                            "K is also that of dU/da; the length of the beam beyond its supports does not matter"
                          : ""});
  }
}

void add_inclined_cracks(std::vector<ValidationCase>& cases) {
  constexpr std::array<std::array<double, 2>, 5> kinks{
      {{15, -26.74}, {30, -43.22}, {45, -53.13}, {60, -60.00}, {75, -65.51}}};
  const auto plate = [](double width, double angle) {
    return scenario_of(
        fmt::format("specimen = \"centre_crack\"\nwidth = {0}\ncrack_length = 1.0\nangle = {1}\n", width, angle) +
            point("anchor", 0.5 * width, -0.5 * width) + point("guide", 0.5 * width, 0.5 * width),
        "stress", material(1.0, 0.3) + held + pulled, crack_steps(0.05 * width));
  };
  for (const auto& [degrees, kink] : kinks) {
    const double b = degrees * pi / 180.0;
    const std::string text = plate(100.0, degrees);
    const std::string name = fmt::format("Inclined centre crack, {} degrees", degrees);
    const std::string source = "closed form of the infinite plate";
    add_by_three_methods(cases, {"3.8 a", name, text, "K_I", 1.0 / std::sqrt(pi), std::cos(b) * std::cos(b), source});
    add_by_three_methods(cases, {"3.8 a", name, text, "K_II", 1.0 / std::sqrt(pi), std::sin(b) * std::cos(b), source});
    cases.push_back({"3.8 a", name + ", kink", text, "tip.load.crack_end.kink.sigma_theta", 1.0, kink, 2e-3,
                     "Erdogan and Sih 1963"});
  }
  const std::string square = plate(20.0, 45.0);
  add_by_three_methods(cases, {"3.8 a", "Inclined centre crack, a/W = 0.1, 45 degrees", square, "K_I",
                               1.0 / std::sqrt(pi), 0.5062, "list of references 3.8 a"});
  add_by_three_methods(cases, {"3.8 a", "Inclined centre crack, a/W = 0.1, 45 degrees", square, "K_II",
                               1.0 / std::sqrt(pi), 0.5046, "list of references 3.8 a"});
}

void add_mixed_modes(std::vector<ValidationCase>& cases) {
  const std::string sheared = scenario_of(
      line("bottom", "[[0, 0], [7, 0]]") + line("right", "[[7, 0], [7, 16]]") + line("top", "[[7, 16], [0, 16]]") +
          line("left", "[[0, 16], [0, 0]]") + "[[input.crack]]\nname = \"crack\"\npoints = [[0, 8], [3.5, 8]]\n",
      "strain", material(3e7, 0.25) + support("bottom", "x = 0.0\ny = 0.0") + load("top", "x = 1.0"), crack_steps(0.5));
  add_by_three_methods(cases,
                       {"3.8 b", "Edge crack under shear", sheared, "K_I", 1.0, 34.01, "list of references 3.8 b"});
  add_by_three_methods(cases,
                       {"3.8 b", "Edge crack under shear", sheared, "K_II", 1.0, 4.536, "list of references 3.8 b"});
  cases.push_back({"3.8 b", "Edge crack under shear, K_I, published", sheared, "tip.load.crack_end.K_I", 1.0, 34.0,
                   1.5e-3, "Moes, Dolbow, Belytschko 1999", "three digits"});
  cases.push_back({"3.8 b", "Edge crack under shear, K_II, published", sheared, "tip.load.crack_end.K_II", 1.0, 4.55,
                   5e-3, "Moes, Dolbow, Belytschko 1999", "three digits; the list of references has 4.536"});
  constexpr std::array<std::array<double, 3>, 2> edge{{{0.2, 0.6247, 0.3205}, {0.4, 1.162, 0.5627}}};
  for (const auto& [a, one, two] : edge) {
    const double c = a * std::sqrt(0.5);
    const std::string text =
        scenario_of(line("bottom", "[[0, 0], [1, 0]]") + line("right", "[[1, 0], [1, 2]]") +
                        line("top", "[[1, 2], [0, 2]]") + line("left", "[[0, 2], [0, 0]]") +
                        fmt::format("[[input.crack]]\nname = \"crack\"\npoints = [[0, 1], [{}, {}]]\n", c, 1.0 + c) +
                        point("anchor", 1, 0) + point("guide", 1, 2),
                    "stress", material(1.0, 0.3) + held + pulled, crack_steps(0.08));
    const std::string name = fmt::format("Inclined edge crack, a = {}", a);
    add_by_three_methods(cases, {"3.8 c", name, text, "K_I", 1.0, one, "list of references 3.8 c"});
    add_by_three_methods(cases, {"3.8 c", name, text, "K_II", 1.0, two, "list of references 3.8 c"});
  }
}

void add_pmma_beams(std::vector<ValidationCase>& cases) {
  struct Row {
    const char* name;
    double a, b, one, two, kink;
  };
  constexpr std::array<Row, 2> table{{{"I", 5.0, 1.5, 0.5013, 0.0774, -16.8}, {"II", 6.0, 1.0, 0.3368, 0.0381, -12.6}}};
  for (const Row& row : table) {
    const std::string text =
        scenario_of(fmt::format("specimen = \"pmma_beam\"\nposition = {}\ncrack_length = {}\n", row.a, row.b), "strain",
                    material(1.0, 0.3) + support("support_left", "x = 0.0\ny = 0.0") +
                        support("support_right", "y = 0.0") + load("load", "kind = \"force\"\ny = -1.0"),
                    crack_steps(0.5));
    const std::string name = fmt::format("Beam with holes, specimen {}", row.name);
    add_by_three_methods(cases, {"3.9", name, text, "K_I", 1.0, row.one, "list of references 3.9"});
    add_by_three_methods(cases, {"3.9", name, text, "K_II", 1.0, row.two, "list of references 3.9"},
                         "the reference has three digits");
    cases.push_back({"3.9", name + ", first kink", text, "tip.load.crack_end.kink.sigma_theta", 1.0, row.kink, 4e-3,
                     "list of references 3.9", "three digits"});
  }
}

/// Sectors and length of the tip's elements: what each method makes of a coarse rosette.
void add_rosettes(std::vector<ValidationCase>& cases) {
  struct Row {
    int sectors;
    double h, correlation, closure, integral;
  };
  constexpr std::array<Row, 6> table{{{6, 0.1, 2.657, 2.807, 2.820},
                                      {8, 0.1, 2.734, 2.815, 2.822},
                                      {12, 0.1, 2.769, 2.821, 2.823},
                                      {16, 0.1, 2.778, 2.822, 2.824},
                                      {8, 0.025, 2.762, 2.816, 2.824},
                                      {16, 0.025, 2.807, 2.823, 2.824}}};
  for (const Row& row : table) {
    const std::string text = edge_crack(0.5, fmt::format("sectors = {}\ntip_radius = {}\n", row.sectors, 0.5 * row.h));
    const auto add = [&](const char* method, const char* prefix, double reference, double tolerance) {
      cases.push_back({"section 7",
                       fmt::format("Edge crack, a/W = 0.5, {} sectors, h/a = {}, {}", row.sectors, row.h, method), text,
                       fmt::format("tip.load.crack_end.{}K_I", prefix), 1.0 / std::sqrt(0.5 * pi), reference, tolerance,
                       "list of references, section 7",
                       "coarse on purpose; our three rings have so many sectors, the mesh of the reference one ring"});
    };
    const bool fine = row.sectors >= 12;
    add("interaction integral", "", row.integral, fine ? integral_tolerance : 5e-3);
    add("crack closure", "closure.", row.closure, fine ? closure_tolerance : 5e-3);
    add("displacement correlation", "correlation.", row.correlation, fine ? correlation_tolerance : 2e-2);
  }
}

/// A square whose rim bears the tractions of a given K_I and K_II: K, and the three criteria.
void add_kinks(std::vector<ValidationCase>& cases) {
  struct Row {
    double one, two, sigma, s, g;
  };
  constexpr std::array<Row, 6> table{{{1, 0.05, 5.70, 5.68, 6.30},
                                      {1, 0.1, 11.20, 11.07, 12.32},
                                      {1, 0.25, 25.33, 24.17, 27.50},
                                      {1, 0.5, 40.21, 37.63, 43.37},
                                      {1, 1, 53.13, 51.90, 57.35},
                                      {0, 1, 70.53, 82.34, 75.0}}};
  for (const Row& row : table) {
    const auto field = [&](const char* component, const std::string& one, const std::string& two) {
      std::string text =
          fmt::format("({} * ({}) + {} * ({})) / sqrt(2 * pi * hypot(x, y))", row.one, one, row.two, two);
      for (const auto& [from, to] : {std::pair{"S3", "sin(1.5 * atan2(y, x))"},
                                     {"C3", "cos(1.5 * atan2(y, x))"},
                                     {"S1", "sin(0.5 * atan2(y, x))"},
                                     {"C1", "cos(0.5 * atan2(y, x))"}}) {
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at))
          text.replace(at, 2, to);
      }
      return fmt::format("stress_{} = \"{}\"\n", component, text);
    };
    const std::string tractions = "kind = \"stress\"\n" + field("xx", "C1 * (1 - S1 * S3)", "0 - S1 * (2 + C1 * C3)") +
                                  field("yy", "C1 * (1 + S1 * S3)", "S1 * C1 * C3") +
                                  field("xy", "S1 * C1 * C3", "C1 * (1 - S1 * S3)");
    const std::string text = scenario_of(
        "[[input.curve]]\nname = \"rim\"\nkind = \"polygon\"\npoints = [[-1, -1], [1, -1], [1, 1], [-1, "
        "1]]\n[[input.crack]]\nname = \"crack\"\npoints = [[-1, 0], [0, 0]]\n" +
            point("anchor", 1, -1) + point("guide", 1, 1),
        "strain", material(1.0, 0.3) + held + load("rim", tractions.c_str()), crack_steps(0.1));
    const std::string name = fmt::format("Given K_I = {}, K_II = {}", row.one, row.two);
    if (row.one > 0.0) add_by_three_methods(cases, {"section 8", name, text, "K_I", 1.0, row.one, "the load"});
    add_by_three_methods(cases, {"section 8", name, text, "K_II", 1.0, row.two, "the load"});
    const auto kink = [&](const char* criterion, const char* quantity, double angle, double tolerance,
                          const char* note) {
      cases.push_back({"section 8", name + ", kink by " + criterion, text,
                       std::string("tip.load.crack_end.kink.") + quantity, 1.0, -angle, tolerance,
                       "list of references, section 8", note});
    };
    kink("greatest hoop stress", "sigma_theta", row.sigma, 2e-3, "");
    kink("least energy density", "s_theta", row.s, 2e-3, "");
    const char* const digits = row.one == 0.0  ? "the reference has two digits"
                               : row.two < 0.1 ? "the formula's maximum is at 6.285"
                                               : "";
    kink("greatest energy release", "g_theta", row.g, row.one == 0.0 ? 5e-3 : row.two < 0.1 ? 3e-3 : 2e-3, digits);
  }
}

/// What a scenario gives for a case.
struct Found {
  double value = 0.0;
  double unknowns = 0.0;
};
base::Result<Found> found_by(scenario::Runner& runner, const ValidationCase& one, const std::string& text) {
  const base::Place place{.file = one.name};
  DOBRA_TRY(const scenario::Document document, scenario::parse_document(text, one.name));
  DOBRA_TRY_VOID(scenario::check(document, program()));
  const scenario::Run run = runner.run(document);
  if (run.error) return base::located(*run.error, place);
  std::optional<double> value;
  Found found;
  for (const auto& quantity : program().quantities_of(run.states.back())) {
    if (quantity.name == one.quantity) value = quantity.value;
    if (quantity.name == "unknowns") found.unknowns = quantity.value;
  }
  if (!value)
    return base::Error{base::ErrorCode::UnknownQuantity, "the scenario has no quantity " + one.quantity, place};
  found.value = *value;
  return found;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

}  // namespace

std::vector<ValidationCase> validation_cases() {
  std::vector<ValidationCase> cases;
  add_patch_tests(cases);
  add_kirsch(cases);
  add_holes(cases);
  add_corners(cases);
  add_straight_cracks(cases);
  add_compact_tension(cases);
  add_beams(cases);
  add_inclined_cracks(cases);
  add_mixed_modes(cases);
  add_pmma_beams(cases);
  add_rosettes(cases);
  add_kinks(cases);
  return cases;
}

base::Result<std::vector<ValidationResult>> validate(const std::vector<ValidationCase>& cases,
                                                     const base::Progress& progress) {
  std::vector<ValidationResult> results;
  scenario::Runner runner(program());  // remembers the runs that cases share
  for (std::size_t i = 0; i < cases.size(); ++i) {
    DOBRA_TRY_VOID(progress.check());
    progress.report(static_cast<double>(i) / static_cast<double>(cases.size()), cases[i].name);
    ValidationResult result{cases[i]};
    DOBRA_TRY(const Found fine, found_by(runner, cases[i], cases[i].scenario));
    result.value = fine.value * cases[i].factor;
    if (!cases[i].coarse.empty()) {
      DOBRA_TRY(const Found coarse, found_by(runner, cases[i], cases[i].coarse));
      result.value = 2.0 * std::log(coarse.value / fine.value) / std::log(fine.unknowns / coarse.unknowns);
    }
    result.error = std::abs(result.value / cases[i].reference - 1.0);
    if (!std::isfinite(result.error))
      return base::Error{
          base::ErrorCode::CannotSolve,
          fmt::format("'{}' came out as {} against {}, which is no finite number to judge; no result is written",
                      cases[i].name, result.value, cases[i].reference)};
    results.push_back(std::move(result));
  }
  return results;
}

std::string validation_csv(const std::vector<ValidationResult>& results) {
  std::string text = "section,case,value,reference,error,tolerance,met,source,note\n";
  for (const auto& r : results) {
    text += fmt::format("{},\"{}\",{},{},{:.3e},{},{},\"{}\",\"{}\"\n", r.what.section, r.what.name,
                        base::number_text(r.value), base::number_text(r.what.reference), r.error,
                        base::number_text(r.what.tolerance), r.met() ? "yes" : "no", r.what.source, r.what.note);
  }
  return text;
}

std::string validation_json(const std::vector<ValidationResult>& results) {
  std::string text = "[";
  for (const auto& r : results) {
    text += fmt::format(
        "{}\n  {{\"section\": \"{}\", \"case\": \"{}\", \"value\": {}, \"reference\": {}, \"error\": {}, "
        "\"tolerance\": {}, \"met\": {}, \"source\": \"{}\", \"note\": \"{}\"}}",
        text.size() > 1 ? "," : "", r.what.section, r.what.name, base::number_text(r.value),
        base::number_text(r.what.reference), base::number_text(r.error), base::number_text(r.what.tolerance), r.met(),
        r.what.source, r.what.note);
  }
  return text + "\n]\n";
}

std::string validation_html(const std::vector<ValidationResult>& results) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>QUEBRA: "
      "validation</title>\n<style>body{font-family:sans-serif;margin:2em}table{border-collapse:collapse}"
      "td,th{padding:.2em .8em;border-bottom:1px solid #ccc;text-align:left}.no{background:#fdd}</style>\n<h1>QUEBRA: "
      "validation</h1>\n" +
      fmt::format("<p>{} values, {} within the tolerance.</p>\n", results.size(),
                  std::count_if(results.begin(), results.end(), [](const auto& r) { return r.met(); })) +
      "<table>\n"
      "<tr><th>Section</th><th>Case</th><th>Value</th><th>Reference</th><th>Error</th><th>Tolerance</th><th>Source</"
      "th><th>Note</th></tr>\n";
  for (const auto& r : results) {
    text += fmt::format(
        "<tr{}><td>{}</td><td>{}</td><td>{:.9g}</td><td>{:.9g}</td><td>{:.3g} %</td><td>{:.3g} "
        "%</td><td>{}</td><td>{}</td></tr>\n",
        r.met() ? "" : " class=\"no\"", r.what.section, escaped(r.what.name), r.value, r.what.reference,
        100.0 * r.error, 100.0 * r.what.tolerance, escaped(r.what.source), escaped(r.what.note));
  }
  return text + "</table></html>\n";
}

}  // namespace quebra::core
