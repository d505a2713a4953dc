#include "quebra/core/validation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "quebra/core/operations.h"
#include "shared/base/text.h"
#include "shared/scenario/runner.h"

namespace quebra::core {
namespace {

using namespace dobra;

constexpr double pi = std::numbers::pi;

std::string scenario_of(const std::string& input, const std::string& state, const std::string& problem, const std::string& steps) {
  return "dobra = 1\nprogram = \"quebra\"\n[input]\n" + input + "[[step]]\noperation = \"problem\"\nstate = \"" + state + "\"\n" + problem + steps;
}

std::string point(const char* name, double x, double y) { return fmt::format("[[input.point]]\nname = \"{}\"\npoint = [{}, {}]\n", name, x, y); }
std::string line(const char* name, const char* points) { return fmt::format("[[input.curve]]\nname = \"{}\"\npoints = {}\n", name, points); }
std::string material(double young, double poisson) { return fmt::format("[[step.material]]\nyoung = {}\npoisson = {}\n", young, poisson); }
std::string support(const char* where, const char* what) { return fmt::format("[[step.support]]\nwhere = \"{}\"\n{}\n", where, what); }
std::string load(const char* where, const char* what) { return fmt::format("[[step.load]]\nwhere = \"{}\"\n{}\n", where, what); }

std::string adapt(double target) { return fmt::format("[[step]]\noperation = \"adapt\"\ntarget = {}\nmax_cycles = 20\n", target); }
std::string crack_steps(double size) {
  return fmt::format("[[step]]\noperation = \"mesh\"\nsize = {}\norder = \"2\"\nrosettes = \"yes\"\n[[step]]\noperation = \"analyse\"\n[[step]]\noperation = \"crack\"\n", size);
}

const std::string held = support("anchor", "x = 0.0\ny = 0.0") + support("guide", "x = 0.0");
const std::string pulled = load("top", "y = 1.0") + load("bottom", "y = -1.0");

void add_kirsch(std::vector<ValidationCase>& cases) {
  const std::string input = "specimen = \"quarter_plate\"\nwidth = 4.0\nradius = 1.0\n";
  const std::string problem = material(1000.0, 0.3) + support("bottom", "normal = 0.0") + support("left", "normal = 0.0") +
                              load("right", "kind = \"kirsch\"\nvalue = 1.0") + load("top", "kind = \"kirsch\"\nvalue = 1.0");
  const std::string source = "Kirsch, closed form by quadrature";
  cases.push_back({"Plate with a hole, plane strain, energy", scenario_of(input, "strain", problem, adapt(0.05)), "case.load.energy", 1.0, 0.00769365372642, 1e-6, source});
  cases.push_back({"Plate with a hole, plane stress, energy", scenario_of(input, "stress", problem, adapt(0.05)), "case.load.energy", 1.0, 0.00844491271144, 1e-6, source});
  cases.push_back({"Plate with a hole, greatest stress", scenario_of(input, "stress", problem, adapt(0.05)), "case.load.max_principal", 1.0, 3.0, 3e-3, source});
}

void add_corners(std::vector<ValidationCase>& cases) {
  const std::string l = line("face_1", "[[0, 0], [1, 0]]") + line("loaded", "[[1, 0], [1, 1], [-1, 1], [-1, -1], [0, -1]]") +
                        line("face_2", "[[0, -1], [0, 0]]") + point("origin", 0, 0) + point("far", 0, 1);
  cases.push_back({"L-shape, opening mode, energy",
                   scenario_of(l, "strain", material(1.0, 0.3) + support("origin", "x = 0.0\ny = 0.0") + support("far", "x = 0.0") + load("loaded", "kind = \"l_shape\""), adapt(0.1)),
                   "case.load.energy", 1.0, 4.15454423, 5e-6, "Szabo and Babuska 1991"});
  cases.push_back({"L-shape, clamped, sheared, energy",
                   scenario_of("specimen = \"l_shape\"\n", "stress", material(1e5, 0.3) + support("bottom", "x = 0.0\ny = 0.0") + load("right", "y = 10.0"), adapt(0.2)),
                   "case.load.energy", 1.0, 60.619, 2e-5, "an independent T6 code, list of references 3.3"});
  const std::string cook = scenario_of("specimen = \"cook\"\n", "stress", material(1.0, 1.0 / 3.0) + support("left", "x = 0.0\ny = 0.0") + load("right", "y = 0.0625"), adapt(0.2));
  cases.push_back({"Cook's membrane, displacement", cook, "case.load.point.middle_right.u_y", 1.0, 23.967, 5e-4, "an independent T6 code, list of references 3.4"});
  cases.push_back({"Cook's membrane, energy", cook, "case.load.energy", 1.0, 12.021, 2e-4, "an independent T6 code, list of references 3.4"});
}

/// Stress at a point: the hole holds little of the energy, so the error asked for is small.
void add_holes(std::vector<ValidationCase>& cases) {
  constexpr std::array<std::array<double, 2>, 6> table{{{0.05, 3.008}, {0.1, 3.035}, {0.2, 3.152}, {0.4, 3.746}, {0.5, 4.346}, {0.7, 6.983}}};
  for (const auto& [d, kt] : table) {
    const std::string input = fmt::format("specimen = \"quarter_plate\"\nwidth = 4.0\nheight = 1.0\nradius = {}\n", d);
    cases.push_back({fmt::format("Finite plate with a hole, d/W = {}, Kt", d),
                     scenario_of(input, "stress", material(1.0, 0.3) + support("bottom", "normal = 0.0") + support("left", "normal = 0.0") + load("right", "x = 1.0"), adapt(0.1)),
                     "case.load.max_principal", 1.0, kt, 1e-2, "Howland 1930; an independent T6 code, list of references 3.2"});
  }
}

void add_straight_cracks(std::vector<ValidationCase>& cases) {
  constexpr std::array<std::array<double, 2>, 6> edge{{{0.1, 1.189}, {0.2, 1.367}, {0.3, 1.659}, {0.4, 2.110}, {0.5, 2.824}, {0.6, 4.030}}};
  for (const auto& [a, f] : edge) {
    const std::string input = fmt::format("specimen = \"single_edge_notch\"\nwidth = 1.0\nheight = 3.0\ncrack_length = {}\n", a) + point("anchor", 1, 0) + point("guide", 1, -1.5);
    const std::string text = scenario_of(input, "stress", material(1.0, 0.3) + held + pulled, crack_steps(0.08));
    const double unit = 1.0 / std::sqrt(pi * a);
    cases.push_back({fmt::format("Edge crack, a/W = {}, interaction integral", a), text, "tip.load.crack_end.K_I", unit, f, 2e-3, "Tada; an independent T6 code, list of references 3.5"});
    cases.push_back({fmt::format("Edge crack, a/W = {}, crack closure", a), text, "tip.load.crack_end.closure.K_I", unit, f, 4e-3, "Tada; an independent T6 code, list of references 3.5"});
    cases.push_back({fmt::format("Edge crack, a/W = {}, displacement correlation", a), text, "tip.load.crack_end.correlation.K_I", unit, f, 1.2e-2, "Tada; an independent T6 code, list of references 3.5"});
  }
  for (int i = 1; i <= 7; ++i) {
    const double a = 0.1 * i;
    const std::string input = fmt::format("specimen = \"centre_crack\"\nwidth = 2.0\nheight = 6.0\ncrack_length = {}\n", a) + point("anchor", 1, 0) + point("guide", 1, -3);
    cases.push_back({fmt::format("Centre crack, a/W = {:.1f}", a), scenario_of(input, "stress", material(1.0, 0.3) + held + pulled, crack_steps(0.1)), "tip.load.crack_end.K_I",
                     1.0 / std::sqrt(pi * a), (1 - 0.025 * a * a + 0.06 * std::pow(a, 4)) * std::sqrt(1 / std::cos(0.5 * pi * a)), 1e-3, "Tada, Paris, Irwin"});
  }
}

std::string beam(double a) {
  const std::string input = fmt::format("specimen = \"three_point_bend\"\nheight = 1.0\ncrack_length = {}\n", a);
  return scenario_of(input, "strain",
                     material(1.0, 0.3) + support("support_left", "y = 0.0") + support("support_right", "y = 0.0") + support("load", "x = 0.0") + load("load", "kind = \"force\"\ny = -1.0"),
                     crack_steps(0.08));
}

void add_standard_specimens(std::vector<ValidationCase>& cases) {
  constexpr std::array<std::array<double, 2>, 6> table{{{0.3, 5.621}, {0.4, 7.279}, {0.45, 8.340}, {0.5, 9.659}, {0.6, 13.654}, {0.7, 21.55}}};
  for (const auto& [a, compact] : table) {
    const std::string pins = fmt::format("specimen = \"compact_tension\"\nwidth = 1.0\ncrack_length = {}\n", a) + point("anchor", 1, 0) + point("guide", 1, 0.6);
    cases.push_back({fmt::format("Compact tension, a/W = {}", a),
                     scenario_of(pins, "strain", material(1.0, 0.3) + held + load("load_upper", "kind = \"force\"\ny = 1.0") + load("load_lower", "kind = \"force\"\ny = -1.0"), crack_steps(0.08)),
                     "tip.load.crack_end.K_I", 1.0, compact, 1e-2, "ASTM E399"});
  }
  for (const double a : {0.3, 0.4, 0.5, 0.6}) {
    const double f = 1.090 - 1.735 * a + 8.20 * a * a - 14.18 * a * a * a + 14.57 * a * a * a * a;
    cases.push_back({fmt::format("Beam in three-point bending, a/W = {}", a), beam(a), "tip.load.crack_end.K_I", 1.0 / (6.0 * std::sqrt(pi * a)), f, 5e-3, "Tada, after Brown and Srawley 1966 (0.2 %)"});
  }
  // The polynomial of the standard lies up to 0.45 % above the handbook's between 0.4 and 0.6: it is met at the ends.
  constexpr std::array<std::array<double, 2>, 2> standard{{{0.3, 1.521}, {0.7, 5.850}}};
  for (const auto& [a, f] : standard)
    cases.push_back({fmt::format("Beam in three-point bending, a/W = {}, standard", a), beam(a), "tip.load.crack_end.K_I", 0.25, f, 5e-3, "ASTM E399"});
}

void add_mixed_modes(std::vector<ValidationCase>& cases) {
  const std::string inclined = scenario_of("specimen = \"centre_crack\"\nwidth = 20.0\ncrack_length = 1.0\nangle = 45.0\n" + point("anchor", 10, -10) + point("guide", 10, 10), "stress",
                                           material(1.0, 0.3) + held + pulled, crack_steps(1.0));
  cases.push_back({"Inclined centre crack, 45 degrees, K_I", inclined, "tip.load.crack_end.K_I", 1.0 / std::sqrt(pi), 0.5062, 2e-3, "an independent T6 code, list of references 3.8 a"});
  cases.push_back({"Inclined centre crack, 45 degrees, K_II", inclined, "tip.load.crack_end.K_II", 1.0 / std::sqrt(pi), 0.5046, 2e-3, "an independent T6 code, list of references 3.8 a"});
  cases.push_back({"Inclined centre crack, 45 degrees, kink", inclined, "tip.load.crack_end.kink.sigma_theta", 1.0, 53.13, 3e-3, "Erdogan, Sih 1963; an independent T6 code, list of references 3.8 a"});
  const std::string sheared = scenario_of(line("bottom", "[[0, 0], [7, 0]]") + line("right", "[[7, 0], [7, 16]]") + line("top", "[[7, 16], [0, 16]]") +
                                              line("left", "[[0, 16], [0, 0]]") + "[[input.crack]]\nname = \"crack\"\npoints = [[0, 8], [3.5, 8]]\n",
                                          "strain", material(3e7, 0.25) + support("bottom", "x = 0.0\ny = 0.0") + load("top", "x = 1.0"), crack_steps(0.5));
  cases.push_back({"Edge crack under shear, K_I", sheared, "tip.load.crack_end.K_I", 1.0, 34.01, 2e-3, "Moes, Dolbow, Belytschko 1999"});
  cases.push_back({"Edge crack under shear, K_II", sheared, "tip.load.crack_end.K_II", 1.0, 4.536, 3e-3, "Moes, Dolbow, Belytschko 1999"});
  constexpr std::array<std::array<double, 3>, 2> edge{{{0.2, 0.6247, 0.3205}, {0.4, 1.162, 0.5627}}};
  for (const auto& [a, one, two] : edge) {
    const double c = a * std::sqrt(0.5);
    const std::string text =
        scenario_of(line("bottom", "[[0, 0], [1, 0]]") + line("right", "[[1, 0], [1, 2]]") + line("top", "[[1, 2], [0, 2]]") + line("left", "[[0, 2], [0, 0]]") +
                        fmt::format("[[input.crack]]\nname = \"crack\"\npoints = [[0, 1], [{}, {}]]\n", c, 1.0 - c) + point("anchor", 1, 0) + point("guide", 1, 2),
                    "stress", material(1.0, 0.3) + held + pulled, crack_steps(0.08));
    cases.push_back({fmt::format("Inclined edge crack, a = {}, K_I", a), text, "tip.load.crack_end.K_I", 1.0, one, 2e-3, "an independent T6 code, list of references 3.8 c"});
    cases.push_back({fmt::format("Inclined edge crack, a = {}, K_II", a), text, "tip.load.crack_end.K_II", 1.0, two, 4e-3, "an independent T6 code, list of references 3.8 c"});
  }
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

}  // namespace

std::vector<ValidationCase> validation_cases() {
  std::vector<ValidationCase> cases;
  add_kirsch(cases);
  add_holes(cases);
  add_corners(cases);
  add_straight_cracks(cases);
  add_standard_specimens(cases);
  add_mixed_modes(cases);
  return cases;
}

base::Result<std::vector<ValidationResult>> validate(const std::vector<ValidationCase>& cases, const base::Progress& progress) {
  std::vector<ValidationResult> results;
  scenario::Runner runner(program());  // remembers the runs that cases share
  for (std::size_t i = 0; i < cases.size(); ++i) {
    DOBRA_TRY_VOID(progress.check());
    progress.report(static_cast<double>(i) / static_cast<double>(cases.size()), cases[i].name);
    DOBRA_TRY(const scenario::Document document, scenario::parse_document(cases[i].scenario, cases[i].name));
    DOBRA_TRY_VOID(scenario::check(document, program()));
    const scenario::Run run = runner.run(document);
    if (run.error) return base::located(*run.error, base::Place{.file = cases[i].name});
    ValidationResult result{cases[i]};
    bool found = false;
    for (const auto& quantity : program().quantities_of(run.states.back())) {
      if (quantity.name != cases[i].quantity) continue;
      found = true;
      result.value = quantity.value * cases[i].factor;
    }
    if (!found) return base::Error{base::ErrorCode::UnknownQuantity, "the scenario has no quantity " + cases[i].quantity, base::Place{.file = cases[i].name}};
    result.error = std::abs(std::abs(result.value) - cases[i].reference) / cases[i].reference;
    results.push_back(std::move(result));
  }
  return results;
}

std::string validation_csv(const std::vector<ValidationResult>& results) {
  std::string text = "case,value,reference,error,tolerance,met,source\n";
  for (const auto& r : results) {
    text += fmt::format("\"{}\",{},{},{:.3e},{},{},\"{}\"\n", r.what.name, base::number_text(r.value), base::number_text(r.what.reference), r.error,
                        base::number_text(r.what.tolerance), r.met() ? "yes" : "no", r.what.source);
  }
  return text;
}

std::string validation_json(const std::vector<ValidationResult>& results) {
  std::string text = "[";
  for (const auto& r : results) {
    text += fmt::format("{}\n  {{\"case\": \"{}\", \"value\": {}, \"reference\": {}, \"error\": {}, \"tolerance\": {}, \"met\": {}, \"source\": \"{}\"}}", text.size() > 1 ? "," : "",
                        r.what.name, base::number_text(r.value), base::number_text(r.what.reference), base::number_text(r.error), base::number_text(r.what.tolerance), r.met(),
                        r.what.source);
  }
  return text + "\n]\n";
}

std::string validation_html(const std::vector<ValidationResult>& results) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>QUEBRA: validation</title>\n<style>body{font-family:sans-serif;margin:2em}table{border-collapse:collapse}"
      "td,th{padding:.2em .8em;border-bottom:1px solid #ccc;text-align:left}.no{background:#fdd}</style>\n<h1>QUEBRA: validation</h1>\n" +
      fmt::format("<p>{} values, {} within the tolerance.</p>\n", results.size(), std::count_if(results.begin(), results.end(), [](const auto& r) { return r.met(); })) +
      "<table>\n"
      "<tr><th>Case</th><th>Value</th><th>Reference</th><th>Error</th><th>Tolerance</th><th>Source</th></tr>\n";
  for (const auto& r : results) {
    text += fmt::format("<tr{}><td>{}</td><td>{:.9g}</td><td>{:.9g}</td><td>{:.3g} %</td><td>{:.3g} %</td><td>{}</td></tr>\n", r.met() ? "" : " class=\"no\"", escaped(r.what.name),
                        r.value, r.what.reference, 100.0 * r.error, 100.0 * r.what.tolerance, escaped(r.what.source));
  }
  return text + "</table></html>\n";
}

}  // namespace quebra::core
