#include "quebra/analysis/problem.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "quebra/domain/junctions.h"
#include "quebra/domain/selection.h"
#include "shared/base/formula.h"
#include "shared/base/text.h"
#include "shared/fem/assemble.h"
#include "shared/fem/error/exact_fields.h"

// 1. Rows of the scenario become functions and values (support_of, load_of ...), which also judge them.
// 2. fault_of runs that on the domain, for its names; problem_of on a mesh.

namespace quebra::analysis {
namespace {

namespace fem = dobra::fem;
namespace mesh = dobra::mesh;
using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Formula;
using dobra::base::Place;
using dobra::base::Result;
using dobra::geom::Point;
using dobra::geom::Vector;

Error bad(std::string message) { return {ErrorCode::BadValue, std::move(message)}; }

/// A vector at a place of a curve with its outward normal (0, 0 inside the material).
using PlaceFunction = std::function<Vector(Point, Vector)>;

/// A number or a formula; what is empty is the number.
Result<std::function<double(Point, Vector)>> number_or(double number, const std::string& text) {
  using Function = std::function<double(Point, Vector)>;
  if (text.empty()) return Function([number](Point, Vector) { return number; });
  static const std::vector<std::string> names{"x", "y", "nx", "ny"};
  DOBRA_TRY(const Formula formula, Formula::make(text, names));
  return Function([formula](Point p, Vector n) { return formula.at(std::array{p.x, p.y, n.x, n.y}); });
}

bool has_formula(const LoadParams& load) {
  return !load.x_formula.empty() || !load.y_formula.empty() || !load.value_formula.empty();
}

Result<void> check_linear(const LoadParams& load) {
  if (load.from.has_value() != load.to.has_value()) return bad("a linear load needs both `from` and `to`");
  if (!load.from) {
    if (load.x_to != 0.0 || load.y_to != 0.0 || load.value_to != 0.0)
      return bad("x_to, y_to and value_to belong to a linear load: give `from` and `to`");
    return {};
  }
  if (*load.from == *load.to) return bad("`from` and `to` of a linear load are the same point");
  if (has_formula(load)) return bad("a load is linear (`from`, `to`) or a formula, not both");
  return {};
}

/// What is given but would not count.
Result<void> check_keys(const LoadParams& load) {
  const auto refuse = [](bool given, const char* message) -> Result<void> {
    return given ? Result<void>(bad(message)) : Result<void>{};
  };
  const auto both = [](double number, const std::string& formula) { return number != 0.0 && !formula.empty(); };
  DOBRA_TRY_VOID(
      refuse(both(load.x, load.x_formula) || both(load.y, load.y_formula) || both(load.value, load.value_formula),
             "a load is a number or a formula, not both: leave x, y or value out where x_formula, y_formula or "
             "value_formula stands"));
  const bool vector = load.x != 0.0 || load.y != 0.0, value = load.value != 0.0;
  switch (load.kind) {
    case LoadKind::Traction:
    case LoadKind::Body:
      DOBRA_TRY_VOID(refuse(load.value_to != 0.0, "`value_to` is of a pressure; give x_to and y_to here"));
      break;
    case LoadKind::Pressure:
      DOBRA_TRY_VOID(refuse(load.x_to != 0.0 || load.y_to != 0.0,
                            "a pressure has no direction: give `value_to`, not x_to and y_to"));
      break;
    case LoadKind::Force:
      DOBRA_TRY_VOID(refuse(value, "`value` is of a pressure; give x and y here"));
      break;
    case LoadKind::Stress:
      DOBRA_TRY_VOID(refuse(vector || value,
                            "a load of kind = \"stress\" is given by stress_xx, stress_yy and stress_xy alone: leave "
                            "x, y and value out"));
      break;
    case LoadKind::Kirsch:
      DOBRA_TRY_VOID(refuse(vector, "a load of kind = \"kirsch\" is given by `value` and `radius`: leave x and y out"));
      break;
    case LoadKind::Corner:
      DOBRA_TRY_VOID(refuse(vector || value,
                            "a load of kind = \"l_shape\" is given by `bisector` alone: leave x, y and value out"));
      break;
  }
  DOBRA_TRY_VOID(
      refuse(load.kind != LoadKind::Kirsch && load.radius != LoadParams{}.radius, "`radius` is of kind = \"kirsch\""));
  return refuse(load.kind != LoadKind::Corner && load.bisector.radians() != LoadParams{}.bisector.radians(),
                "`bisector` is of kind = \"l_shape\"");
}

/// x, y of a traction or body force: constant, linear or by formulas.
Result<PlaceFunction> vector_of(const LoadParams& load) {
  if (!load.value_formula.empty() || load.value != 0.0) return bad("`value` is of a pressure; give x and y here");
  if (load.from) {
    const auto linear = fem::linear(*load.from, {load.x, load.y}, *load.to, {load.x_to, load.y_to});
    return PlaceFunction(linear);
  }
  DOBRA_TRY(const auto x, number_or(load.x, load.x_formula));
  DOBRA_TRY(const auto y, number_or(load.y, load.y_formula));
  return PlaceFunction([x, y](Point p, Vector n) { return Vector{x(p, n), y(p, n)}; });
}

Result<fem::Traction> pressure_of(const LoadParams& load) {
  if (load.x != 0.0 || load.y != 0.0 || !load.x_formula.empty() || !load.y_formula.empty())
    return bad("a pressure has no direction: give `value`, not x and y");
  if (load.from) {
    const auto linear = fem::linear(*load.from, {load.value, 0.0}, *load.to, {load.value_to, 0.0});
    return fem::Traction([linear](Point p, Vector n) { return -linear(p, n).x * n; });
  }
  DOBRA_TRY(const auto value, number_or(load.value, load.value_formula));
  return fem::Traction([value](Point p, Vector n) { return -value(p, n) * n; });
}

Result<fem::Traction> stress_of(const LoadParams& load) {
  DOBRA_TRY(const auto xx, number_or(0.0, load.stress_xx));
  DOBRA_TRY(const auto yy, number_or(0.0, load.stress_yy));
  DOBRA_TRY(const auto xy, number_or(0.0, load.stress_xy));
  return fem::traction_of([xx, yy, xy](Point p) { return fem::Voigt{xx(p, {}), yy(p, {}), xy(p, {})}; });
}

/// What a load is, for a case of a problem: along curves, at points, or in the material.
struct Load {
  fem::Traction traction = {};
  std::optional<Vector> force = std::nullopt;
  std::function<Vector(Point)> body = {};
};

Result<Load> load_of(const LoadParams& load) {
  DOBRA_TRY_VOID(check_linear(load));
  DOBRA_TRY_VOID(check_keys(load));
  const bool stress = !load.stress_xx.empty() || !load.stress_yy.empty() || !load.stress_xy.empty();
  if (stress != (load.kind == LoadKind::Stress))
    return bad(stress ? "stress_xx, stress_yy and stress_xy are of kind = \"stress\""
                      : "a load of kind = \"stress\" needs stress_xx, stress_yy or stress_xy");
  const bool plain = load.kind == LoadKind::Force || load.kind == LoadKind::Stress || load.kind == LoadKind::Kirsch ||
                     load.kind == LoadKind::Corner;
  if (plain && (load.from || has_formula(load)))
    return bad("only tractions, pressures and body forces are linear or have formulas");
  Load result;
  switch (load.kind) {
    case LoadKind::Traction: {
      DOBRA_TRY(result.traction, vector_of(load));
      break;
    }
    case LoadKind::Pressure: {
      DOBRA_TRY(result.traction, pressure_of(load));
      break;
    }
    case LoadKind::Stress: {
      DOBRA_TRY(result.traction, stress_of(load));
      break;
    }
    case LoadKind::Force:
      result.force = Vector{load.x, load.y};
      break;
    case LoadKind::Body: {
      DOBRA_TRY(const PlaceFunction vector, vector_of(load));
      result.body = [vector](Point p) { return vector(p, {}); };
      break;
    }
    case LoadKind::Kirsch:
      result.traction =
          fem::traction_of([load](Point p) { return fem::error::kirsch_stress(p, load.radius, load.value); });
      break;
    case LoadKind::Corner:
      result.traction = fem::traction_of([load](Point p) { return fem::error::l_corner_stress(p, load.bisector); });
      break;
  }
  return result;
}

Result<fem::Support> support_of(const SupportParams& params) {
  fem::Support support{params.where, params.x, params.y, params.normal};
  const bool formula = !params.x_formula.empty() || !params.y_formula.empty();
  if (!formula) {
    if (!params.x && !params.y && !params.normal) return bad("the support holds nothing; give x, y or normal");
    return support;
  }
  if ((params.x && !params.x_formula.empty()) || (params.y && !params.y_formula.empty()))
    return bad("a displacement is a number or a formula, not both");
  if (params.normal) return bad("a support with a formula prescribes both displacements: leave `normal` out");
  if ((!params.x && params.x_formula.empty()) || (!params.y && params.y_formula.empty()))
    return bad("a support with a formula prescribes both: give x or x_formula, and y or y_formula");
  DOBRA_TRY(const auto x, number_or(params.x.value_or(0.0), params.x_formula));
  DOBRA_TRY(const auto y, number_or(params.y.value_or(0.0), params.y_formula));
  support.x = support.y = std::nullopt;
  support.field = [x, y](Point p) { return Vector{x(p, {}), y(p, {})}; };
  return support;
}

Result<void> check_tie(const TieParams& tie) {
  if (tie.where.empty() == tie.points.empty()) return bad("a tie needs `where`, a curve, or `points`");
  if (!tie.where.empty()) {
    if (tie.value != 0.0 || !tie.axes.empty() || !tie.coefficients.empty())
      return bad("axes, coefficients and value are of a tie between `points`");
    return {};
  }
  if (tie.axes.size() != tie.points.size() || tie.coefficients.size() != tie.points.size())
    return bad(fmt::format("{} points need as many axes and coefficients; there are {} and {}", tie.points.size(),
                           tie.axes.size(), tie.coefficients.size()));
  for (std::size_t i = 0; i < tie.axes.size(); ++i) {
    if (tie.axes[i] != "x" && tie.axes[i] != "y")
      return bad(fmt::format("'{}' is no axis; write \"x\" or \"y\"", tie.axes[i]));
    if (tie.coefficients[i] == 0.0) return bad("a coefficient of 0 says nothing; leave its point out");
  }
  return {};
}

/// The names that a mesh of the domain will have.
struct Names {
  const domain::Domain& domain;
  std::vector<std::string> curves;  ///< Boundary curves, groups of them, lips.
  std::vector<std::string> points;  ///< Named points and tips, and the lips' own nodes of points on cracks.
  std::vector<std::string> regions;
  std::map<std::string, std::vector<std::string>> parted = {};  ///< Points on cracks, with those of their lips.
};

Names names_of(const domain::Domain& domain) {
  Names names{domain, {}, {}, {}};
  for (const sketch::Curve& curve : domain.curves) {
    names.curves.insert(names.curves.end(), curve.groups.begin(), curve.groups.end());
    if (curve.role != sketch::Role::Crack) {
      names.curves.push_back(curve.name);
      continue;
    }
    for (const char* const lip : {"_left", "_right"}) names.curves.push_back(curve.name + lip);
    for (const char* const tip : {"_start", "_end"}) names.points.push_back(curve.name + tip);
  }
  for (const sketch::NamedPoint& point : domain.points) {
    if (point.name.empty()) continue;
    names.points.push_back(point.name);
    const auto cracks = cracks_through(domain, point.at);
    for (const std::size_t crack : cracks) {
      for (const char* const lip : {"_left", "_right"})
        names.parted[point.name].push_back(point.name + (cracks.size() > 1 ? "_" + domain.curves[crack].name : "") +
                                           lip);
    }
  }
  for (const auto& [name, lips] : names.parted) names.points.insert(names.points.end(), lips.begin(), lips.end());
  for (const auto& [tag, name] : domain.region_names) names.regions.push_back(name);
  return names;
}

Result<void> known(const std::string& name, const char* what, const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) != names.end()) return {};
  return bad(name.empty() ? fmt::format("`where` is missing: the name of a {}", what)
                          : fmt::format("there is no {} '{}'{}", what, name, domain::what_there_is(name, names)));
}

/// A curve or a lip by its name, or sides by a condition.
Result<void> known_sides(const std::string& where, const Names& names) {
  if (!domain::is_condition(where) || std::find(names.curves.begin(), names.curves.end(), where) != names.curves.end())
    return known(where, "curve or lip", names.curves);
  DOBRA_TRY(const domain::Selection selection, select(names.domain, where));
  if (!selection.parts.empty()) return {};
  return bad(fmt::format("the condition '{}' holds for corners only, and a whole side is wanted; the boundary has {}",
                         where, listed(names.domain)));
}

/// The same, or a point, or corners by a condition.
Result<void> known_place(const std::string& where, const Names& names) {
  std::vector<std::string> all = names.curves;
  all.insert(all.end(), names.points.begin(), names.points.end());
  if (!domain::is_condition(where) || std::find(all.begin(), all.end(), where) != all.end())
    return known(where, "curve, lip or point", all);
  const auto selection = select(names.domain, where);
  return selection ? Result<void>{} : Result<void>(selection.error());
}

Result<void> check_row(const MaterialParams& material, const Names& names, Plane state) {
  if (!material.region.empty()) DOBRA_TRY_VOID(known(material.region, "region", names.regions));
  return fem::check({material.young, material.poisson, material.thickness,
                     state == Plane::Stress ? fem::PlaneState::Stress : fem::PlaneState::Strain},
                    "the material");
}

Result<void> check_row(const SupportParams& support, const Names& names) {
  DOBRA_TRY_VOID(support_of(support));
  return support.normal ? known_sides(support.where, names) : known_place(support.where, names);
}

Result<void> check_row(const SpringParams& spring, const Names& names) {
  return spring.kind == fem::SpringKind::Foundation ? known_sides(spring.where, names)
                                                    : known_place(spring.where, names);
}

Result<void> check_row(const TieParams& tie, const Names& names) {
  DOBRA_TRY_VOID(check_tie(tie));
  for (const std::string& point : tie.points) {
    DOBRA_TRY_VOID(known(point, "point", names.points));
    if (const auto parted = names.parted.find(point); parted != names.parted.end())
      return bad(fmt::format("point '{}' lies on a crack and moves with each lip by itself; tie one of '{}'", point,
                             fmt::join(parted->second, "', '")));
  }
  return tie.where.empty() ? Result<void>{} : known_sides(tie.where, names);
}

Result<void> check_row(const LoadParams& load, const Names& names) {
  DOBRA_TRY_VOID(load_of(load));
  if (load.kind == LoadKind::Force) return known_place(load.where, names);
  if (load.kind == LoadKind::Body)
    return load.where.empty() ? Result<void>{} : known(load.where, "region", names.regions);
  return known_sides(load.where, names);
}

std::optional<Error> missing_material(const domain::Domain& domain, const ProblemParams& params) {
  for (const domain::Face& face : domain.faces) {
    const auto named = domain.region_names.find(face.region);
    const bool has = std::any_of(params.materials.begin(), params.materials.end(), [&](const MaterialParams& own) {
      return own.region.empty() || (named != domain.region_names.end() && own.region == named->second);
    });
    if (has) continue;
    const std::string name = named != domain.region_names.end() ? fmt::format("region '{}'", named->second)
                                                                : std::string("the region without a name");
    return Error{ErrorCode::BadValue, name + " has no material; give it one, or one without `region` for all",
                 Place{.item = "material", .x = face.inside.x, .y = face.inside.y}};
  }
  return std::nullopt;
}

Result<std::int32_t> region_of(const mesh::ElementMesh& mesh, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& [tag, own] : mesh.region_names) {
    if (own == name) return tag;
    names.push_back(own);
  }
  return bad(fmt::format("there is no region '{}'{}", name, domain::what_there_is(name, names)));
}

std::optional<ProblemFault> material_twice(const std::vector<MaterialParams>& materials) {
  for (std::size_t i = 0; i < materials.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (materials[k].region != materials[i].region) continue;
      const std::string region = materials[i].region.empty() ? std::string("every region without a material of its own")
                                                             : fmt::format("region '{}'", materials[i].region);
      return ProblemFault{
          "material", i,
          bad(fmt::format("{} has a material already, number {} of the step; leave one out", region, k + 1))};
    }
  }
  return std::nullopt;
}

/// Names of the cases that loads name.
std::vector<std::string> loaded_cases(const ProblemParams& params) {
  std::vector<std::string> names;
  for (const LoadParams& row : params.loads) {
    if (std::find(names.begin(), names.end(), row.load_case) == names.end()) names.push_back(row.load_case);
  }
  return names;
}

Result<void> check_case(const ProblemParams& params, std::size_t row) {
  const CaseParams& own = params.cases[row];
  for (std::size_t k = 0; k < row; ++k) {
    if (params.cases[k].name == own.name)
      return bad(fmt::format("load case '{}' has its settings already, in number {} of the step; leave one out",
                             own.name, k + 1));
  }
  const auto names = loaded_cases(params);
  if (std::find(names.begin(), names.end(), own.name) != names.end() || (moves(params) && own.settlement != 0.0))
    return {};
  return bad(fmt::format("nothing acts in load case '{}': no load is of it{}", own.name,
                         dobra::base::did_you_mean(own.name, names)));
}

Result<fem::Materials> materials_of(const mesh::ElementMesh& mesh, const ProblemParams& params) {
  fem::Materials materials;
  const auto state = params.state == Plane::Stress ? fem::PlaneState::Stress : fem::PlaneState::Strain;
  for (const MaterialParams& own : params.materials) {
    const fem::Material material{own.young, own.poisson, own.thickness, state};
    if (own.region.empty()) {
      for (const std::int32_t region : mesh.regions) materials.try_emplace(region, material);
      continue;
    }
    DOBRA_TRY(const std::int32_t region, region_of(mesh, own.region));
    materials[region] = material;
  }
  return materials;
}

Result<std::vector<fem::Tie>> ties_of(const mesh::ElementMesh& mesh, const TieParams& params) {
  if (!params.where.empty())
    return fem::equal_displacement(mesh, params.where, params.axis == TieAxis::X ? fem::Axis::X : fem::Axis::Y);
  fem::Tie tie{"tie of '" + params.points.front() + "'", {}, params.value};
  for (std::size_t i = 0; i < params.points.size(); ++i) {
    DOBRA_TRY(const auto nodes, fem::find_nodes(mesh, params.points[i]));
    tie.terms.push_back({nodes.front(), params.axes[i] == "x" ? fem::Axis::X : fem::Axis::Y, params.coefficients[i]});
  }
  return std::vector{tie};
}

fem::LoadCase& case_of(fem::Problem& problem, const std::string& name) {
  for (fem::LoadCase& own : problem.cases) {
    if (own.name == name) return own;
  }
  return problem.cases.emplace_back(fem::LoadCase{.name = name});
}

Result<void> add_load(const mesh::ElementMesh& mesh, const LoadParams& row, fem::LoadCase& own) {
  DOBRA_TRY(const Load load, load_of(row));
  if (load.traction) own.sides.push_back({row.where, load.traction});
  if (load.force) own.points.push_back({row.where, *load.force});
  if (!load.body) return {};
  fem::BodyForce body{.force = load.body};
  if (!row.where.empty()) {
    DOBRA_TRY(body.region, region_of(mesh, row.where));
  }
  own.bodies.push_back(std::move(body));
  return {};
}

}  // namespace

std::vector<std::string> places_of(const ProblemParams& params) {
  std::vector<std::string> places;
  const auto add = [&](const auto& rows) {
    for (const auto& row : rows) places.push_back(row.where);
  };
  add(params.supports);
  add(params.springs);
  add(params.ties);
  for (const LoadParams& row : params.loads) {
    if (row.kind != LoadKind::Body) places.push_back(row.where);
  }
  return places;
}

bool moves(const ProblemParams& params) {
  const auto moved = [](const std::optional<double>& value) { return value.value_or(0.0) != 0.0; };
  return std::any_of(params.supports.begin(), params.supports.end(),
                     [&](const SupportParams& row) {
                       return moved(row.x) || moved(row.y) || moved(row.normal) || !row.x_formula.empty() ||
                              !row.y_formula.empty();
                     }) ||
         std::any_of(params.ties.begin(), params.ties.end(), [](const TieParams& row) { return row.value != 0.0; });
}

std::optional<ProblemFault> fault_of(const domain::Domain& domain, const ProblemParams& params) {
  const Names names = names_of(domain);
  std::optional<ProblemFault> fault;
  const auto judge = [&](const char* key, const auto& rows, const auto& check) {
    for (std::size_t i = 0; i < rows.size() && !fault; ++i) {
      if (const Result<void> result = check(rows[i]); !result) fault = ProblemFault{key, i, result.error()};
    }
  };
  const auto by_name = [&](const auto& row) { return check_row(row, names); };
  judge("material", params.materials, [&](const auto& row) { return check_row(row, names, params.state); });
  judge("support", params.supports, by_name);
  judge("spring", params.springs, by_name);
  judge("tie", params.ties, by_name);
  judge("load", params.loads, by_name);
  if (!fault) fault = material_twice(params.materials);
  for (std::size_t i = 0; i < params.cases.size() && !fault; ++i) {
    if (const auto result = check_case(params, i); !result) fault = ProblemFault{"case", i, result.error()};
  }
  if (!fault) {
    if (auto error = missing_material(domain, params)) fault = ProblemFault{"", 0, *std::move(error)};
  }
  return fault;
}

Result<model::Model> set_problem(const model::Model& model, const ProblemParams& params,
                                 const dobra::scenario::Context&, const dobra::base::Progress&) {
  if (auto fault = fault_of(model.domain, params)) {
    if (fault->key.empty()) return fault->error;
    Error error = fault->error;
    error.place = Place{.item = fmt::format("{} {}", fault->key, fault->row + 1)};
    return error;
  }
  model::Model result = model;
  const auto names = loaded_cases(params);
  for (const CaseParams& own : params.cases) {
    const std::string meant = std::find(names.begin(), names.end(), own.name) != names.end()
                                  ? std::string()
                                  : dobra::base::did_you_mean(own.name, names);
    if (!meant.empty())
      result.remarks.push_back(
          fmt::format("no load is of load case '{}', only prescribed displacements act in it{}", own.name, meant));
  }
  result.problem = std::make_shared<const ProblemParams>(params);
  return result;
}

Result<fem::Problem> problem_of(const mesh::ElementMesh& mesh, const ProblemParams& params) {
  fem::Problem problem;
  problem.cases.clear();
  DOBRA_TRY(problem.materials, materials_of(mesh, params));
  for (const SupportParams& row : params.supports) {
    DOBRA_TRY(fem::Support support, support_of(row));
    problem.supports.push_back(std::move(support));
  }
  for (const SpringParams& row : params.springs) problem.springs.push_back({row.where, row.x, row.y, row.kind});
  for (const TieParams& row : params.ties) {
    DOBRA_TRY(const auto ties, ties_of(mesh, row));
    problem.ties.insert(problem.ties.end(), ties.begin(), ties.end());
  }
  for (const CaseParams& row : params.cases) case_of(problem, row.name).settlement = row.settlement;
  for (const LoadParams& row : params.loads) DOBRA_TRY_VOID(add_load(mesh, row, case_of(problem, row.load_case)));
  if (problem.cases.empty()) problem.cases.emplace_back();  // prescribed displacements alone
  return problem;
}

Result<void> check_finite(const mesh::ElementMesh& mesh, const ProblemParams& params, const fem::Problem& problem) {
  const auto trouble = [&](Place place, std::string item, Point at, std::string message) {
    place.item = std::move(item);
    place.x = at.x;
    place.y = at.y;
    return Error{ErrorCode::BadValue, std::move(message), std::move(place)};
  };
  for (std::size_t i = 0; i < params.supports.size(); ++i) {
    const fem::Support& support = problem.supports[i];
    if (!support.field) continue;
    DOBRA_TRY(const auto nodes, fem::find_nodes(mesh, support.where));
    for (const mesh::NodeId node : nodes) {
      const Point at = mesh.point(node);
      const Vector u = support.field(at);
      if (!std::isfinite(u.x) || !std::isfinite(u.y))
        return trouble(
            params.supports[i].place, fmt::format("support {}", i + 1), at,
            fmt::format("the support on '{}' prescribes a displacement that has no finite value here", support.where));
    }
  }
  for (std::size_t i = 0; i < params.loads.size(); ++i) {
    const LoadParams& row = params.loads[i];
    fem::LoadCase alone;
    DOBRA_TRY_VOID(add_load(mesh, row, alone));
    const auto forces = fem::load_vector(mesh, problem, alone);
    for (std::size_t n = 0; n < forces.size(); ++n) {
      if (std::isfinite(forces[n].x) && std::isfinite(forces[n].y)) continue;
      return trouble(row.place, fmt::format("load {}", i + 1), mesh.points[n],
                     fmt::format("the load{} of case '{}' has no finite value here",
                                 row.where.empty() ? "" : " on '" + row.where + "'", row.load_case));
    }
  }
  return {};
}

}  // namespace quebra::analysis
