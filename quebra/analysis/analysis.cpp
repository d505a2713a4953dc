#include "quebra/analysis/analysis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>

#include "quebra/analysis/deck.h"
#include "quebra/analysis/results.h"
#include "quebra/domain/selection.h"
#include "quebra/model/mesh_files.h"
#include "shared/base/text.h"
#include "shared/fem/assemble.h"
#include "shared/fem/error/new_sizes.h"
#include "shared/fem/error/singular_vertices.h"
#include "shared/fem/mixed.h"
#include "shared/io/file.h"
#include "shared/mesh/element_quality.h"

namespace quebra::analysis {
namespace {

namespace fem = dobra::fem;
namespace mesh = dobra::mesh;
using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Result;
using dobra::geom::Vector;

/// Triangles below have an angle of less than 10 degrees or so.
constexpr double poor_shape = 0.3;
/// Of the energy, that is worth a figure.
constexpr double least_told = 1e-3;

/// The largest element with a node at a place, which has one.
std::size_t element_at(const mesh::ElementMesh& m, dobra::geom::Point at) {
  std::size_t largest = m.element_count();
  for (std::size_t e = 0; e < m.element_count(); ++e) {
    const auto nodes = m.nodes_of(mesh::ElementId(e));
    if (std::none_of(nodes.begin(), nodes.end(), [&](mesh::NodeId node) { return m.point(node) == at; })) continue;
    if (largest == m.element_count() || fem::error::element_size(m, e) > fem::error::element_size(m, largest))
      largest = e;
  }
  return largest;
}

/// Greatest von Mises and principal stress at the nodes, those round points with a force included.
struct Extremes {
  double von_mises = 0.0;
  double principal = 0.0;
  dobra::geom::Point at;   ///< Of the von Mises stress.
  double elsewhere = 0.0;  ///< The greatest von Mises stress that is not round a point with a force.
};

Extremes extremes_of(const Analysis& analysis, std::size_t c) {
  Extremes greatest;
  const mesh::ElementMesh& m = analysis.meshed->mesh;
  const auto& stresses = analysis.fields[c].recovered.at_element_nodes;
  const auto& loaded = analysis.fields[c].loaded;
  for (std::size_t e = 0; e < m.element_count(); ++e) {
    for (std::size_t k = m.first[e]; k < m.first[e + 1]; ++k) {
      const double mises = fem::von_mises(stresses[k], analysis.problem.materials.at(m.regions[e]));
      const dobra::geom::Point at = m.point(m.nodes[k]);
      if (mises > greatest.von_mises) {
        greatest.von_mises = mises;
        greatest.at = at;
      }
      const auto holds = [&](const LoadedPoint& point) { return distance(point.at, at) < point.radius; };
      if (mises > greatest.elsewhere && std::none_of(loaded.begin(), loaded.end(), holds)) greatest.elsewhere = mises;
      greatest.principal = std::max(greatest.principal, fem::principal(stresses[k]).greatest);
    }
  }
  return greatest;
}

/// The mean at each node of what the elements round it have there.
std::vector<double> mean_at_nodes(const mesh::ElementMesh& m, const std::vector<double>& at_element_nodes) {
  std::vector<double> sums(m.points.size());
  std::vector<double> counts(m.points.size());
  for (std::size_t k = 0; k < m.nodes.size(); ++k) {
    sums[m.nodes[k].index()] += at_element_nodes[k];
    counts[m.nodes[k].index()] += 1.0;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= std::max(counts[i], 1.0);
  return sums;
}

dobra::io::meshes::MeshFields fields_of(const Analysis& analysis, const dobra::scenario::UnitSystem& units) {
  dobra::io::meshes::MeshFields fields;
  for (std::size_t c = 0; c < analysis.solution.cases.size(); ++c) {
    const auto& result = analysis.solution.cases[c];
    dobra::io::meshes::MeshField u{result.name + " displacement", 2, {}};
    dobra::io::meshes::MeshField s{result.name + " stress", 3, {}};
    for (const Vector v : result.displacements) u.values.insert(u.values.end(), {v.x, v.y});
    for (const auto& v : fem::error::nodal_mean(analysis.meshed->mesh, analysis.fields[c].recovered.at_element_nodes))
      s.values.insert(s.values.end(), v.begin(), v.end());
    fields.at_points.push_back(std::move(u));
    fields.at_points.push_back(std::move(s));
    for (const FieldName name : {FieldName::VonMises, FieldName::Principal1, FieldName::Principal2})
      fields.at_points.push_back({result.name + ' ' + field_names()[static_cast<std::size_t>(name)], 1,
                                  mean_at_nodes(analysis.meshed->mesh, field_at_element_nodes(analysis, c, name))});
    fields.at_elements.push_back({result.name + " error", 1, analysis.fields[c].estimate.elements});
  }
  if (units.si()) return fields;
  for (auto* at : {&fields.at_points, &fields.at_elements}) {
    for (dobra::io::meshes::MeshField& field : *at) {
      const char* const si = field.name.ends_with(" displacement") ? "m"
                             : field.name.ends_with(" error")      ? "J^0.5"
                                                                   : "Pa";
      for (double& value : field.values) value = units.from_si(value, si);
    }
  }
  return fields;
}

/// What the forces that act at each node of a curve come to, and the load that is spread over it.
std::vector<std::string> forces_on_curves(const Analysis& analysis, std::size_t c) {
  const mesh::ElementMesh& m = analysis.meshed->mesh;
  std::vector<std::string> remarks;
  for (const fem::PointLoad& load : analysis.problem.cases[c].points) {
    if (!m.side_sets.contains(load.where)) continue;
    const double count = static_cast<double>(fem::find_nodes(m, load.where).value().size());
    double area = 0.0;  // that a traction acts on
    for (const Vector force :
         fem::load_vector(m, analysis.problem, {.sides = {{load.where, fem::uniform({1.0, 0.0})}}}))
      area += force.x;
    const auto [x, y] = load.force;
    remarks.push_back(fmt::format(
        "the force on '{}' acts at each of its {:.0f} nodes: ({:.6g}, {:.6g}) N in all, more on a finer mesh; for "
        "({:.6g}, {:.6g}) N spread over the curve give kind = \"traction\", x = {:.6g} Pa, y = {:.6g} Pa",
        load.where, count, count * x, count * y, x, y, x / area, y / area));
  }
  return remarks;
}

/// The nodes of a point that a crack parts, and the names of those on one lip; nothing of any other place.
std::optional<std::string> lips_of(const mesh::ElementMesh& m, const std::string& where) {
  const auto point = m.node_sets.find(where);
  if (point == m.node_sets.end() || point->second.size() < 2) return std::nullopt;
  std::vector<std::string> names;
  for (const auto& [name, nodes] : m.node_sets) {
    const bool lip = name.starts_with(where + "_") && (name.ends_with("_left") || name.ends_with("_right"));
    if (lip && std::all_of(nodes.begin(), nodes.end(),
                           [&](mesh::NodeId node) { return m.point(node) == m.point(point->second.front()); }))
      names.push_back(name);
  }
  return fmt::format("'{}' lies on a crack and has {} nodes ('{}')", where, point->second.size(),
                     fmt::join(names, "', '"));
}

/// Elements of first order in plane strain on the way to incompressibility.
std::optional<std::string> locking(const Analysis& analysis) {
  const mesh::ElementMesh& m = analysis.meshed->mesh;
  for (std::size_t e = 0; e < m.element_count(); ++e) {
    const fem::Material& material = analysis.problem.materials.at(m.regions[e]);
    if (material.state != fem::PlaneState::Strain || material.poisson <= fem::stiff_above ||
        mesh::is_quadratic(m.types[e]))
      continue;
    const auto name = m.region_names.find(m.regions[e]);
    return fmt::format(
        "elements of first order begin to lock in plane strain with Poisson's ratio {:.6g}{}: stresses oscillate and "
        "displacements come out small; mesh with order = \"2\"",
        material.poisson, name != m.region_names.end() ? " (region '" + name->second + "')" : std::string());
  }
  return std::nullopt;
}

/// What acts at points that a crack parts.
std::vector<std::string> parted_points(const Analysis& analysis, std::size_t c) {
  const mesh::ElementMesh& m = analysis.meshed->mesh;
  std::vector<std::string> remarks;
  for (const fem::PointLoad& load : analysis.problem.cases[c].points) {
    if (const auto lips = lips_of(m, load.where))
      remarks.push_back(
          fmt::format("{}: each takes an equal part of the force ({:.6g}, {:.6g}) N; name one to load that lip alone",
                      *lips, load.force.x, load.force.y));
  }
  if (c > 0) return remarks;
  for (const fem::Support& support : analysis.problem.supports) {
    if (const auto lips = lips_of(m, support.where))
      remarks.push_back(*lips + ": the support holds all of them; name one to hold that lip alone");
  }
  for (const fem::Spring& spring : analysis.problem.springs) {
    if (const auto lips = lips_of(m, spring.where))
      remarks.push_back(*lips + ": each has an equal part of the spring; name one to hold that lip alone");
  }
  return remarks;
}

/// Displacements under forces at points, which no mesh settles.
std::vector<std::string> loaded_displacements(const Analysis& analysis, std::size_t c) {
  const mesh::ElementMesh& m = analysis.meshed->mesh;
  std::vector<LoadedPoint> pushed;
  double growth = 0.0;  // of a straight edge, by Flamant
  for (const LoadedPoint& point : analysis.fields[c].loaded) {
    const auto& loads = analysis.problem.cases[c].points;
    const auto load =
        std::find_if(loads.begin(), loads.end(), [&](const fem::PointLoad& own) { return own.where == point.name; });
    if (load == loads.end() || length(load->force) == 0.0) continue;
    pushed.push_back(point);
    const std::size_t e = element_at(m, point.at);
    const fem::Material& material = analysis.problem.materials.at(m.regions[e]);
    growth = std::max(growth, 2.0 * length(point.force) * std::numbers::ln2 /
                                  (std::numbers::pi * fem::effective_modulus(material) * material.thickness));
  }
  if (pushed.empty()) return {};
  return {
      fmt::format("displacements at {}, and how far a crack opens there, are those under a force at a single point: "
                  "they grow without end, on a straight edge by up to {:.2g} m each time the elements there are "
                  "halved; read them away from it, or spread the force",
                  names_of(pushed), growth)};
}

/// Of the surroundings of points with a force: what they hold, elements too coarse for them, tips in them.
std::vector<std::string> left_out_of(const Analysis& analysis, std::size_t c) {
  const mesh::ElementMesh& m = analysis.meshed->mesh;
  const auto& loaded = analysis.fields[c].loaded;
  const auto [least, greatest] = std::minmax_element(
      loaded.begin(), loaded.end(), [](const LoadedPoint& a, const LoadedPoint& b) { return a.radius < b.radius; });
  const std::string radius = least->radius == greatest->radius
                                 ? fmt::format("{:.3g} m", least->radius)
                                 : fmt::format("{:.3g} m to {:.3g} m", least->radius, greatest->radius);
  const double held = analysis.fields[c].estimate.left_out;
  std::vector<std::string> remarks{
      fmt::format("forces at single points ({}) have an infinite energy: their surroundings of radius {}{} are left "
                  "out of the error",
                  names_of(loaded), radius,
                  held >= least_told ? fmt::format(" hold {:.2g} % of the energy and", 100.0 * held) : std::string())};
  for (std::size_t i = 0; i < loaded.size(); ++i) {
    const LoadedPoint& point = loaded[i];
    const auto same = [&](const LoadedPoint& other) { return other.at == point.at; };  // the other lip's
    if (std::any_of(loaded.begin(), loaded.begin() + static_cast<std::ptrdiff_t>(i), same)) continue;
    const double size = fem::error::element_size(m, element_at(m, point.at));
    if (size > point.radius) {
      remarks.push_back(fmt::format(
          "the elements at '{}' ({:.6g}, {:.6g}) are of {:.3g} m, larger than its surroundings of {:.3g} m that are "
          "left out: the error takes in a part of what is infinite; give the point a size of {:.2g} m",
          point.name, point.at.x, point.at.y, size, point.radius, 0.5 * point.radius));
    }
    for (const mesh::CrackTip& tip : m.tips) {
      const double gap = distance(m.point(tip.node), point.at);
      if (gap > 0.0 && gap < point.radius)
        remarks.push_back(
            fmt::format("the surroundings of '{}', of radius {:.3g} m, hold the crack tip '{}' at ({:.6g}, {:.6g}), "
                        "where the error is then not judged: give a point_radius below {:.3g} m",
                        point.name, point.radius, tip.name, m.point(tip.node).x, m.point(tip.node).y, gap));
    }
  }
  return remarks;
}

/// Elements whose shape spoils the stresses in them.
std::optional<std::string> flat_elements(const Analysis& analysis) {
  const mesh::ElementMesh& m = analysis.meshed->mesh;
  std::size_t count = 0, worst = 0;
  double least = poor_shape;
  for (std::size_t e = 0; e < m.element_count(); ++e) {
    const double shape = mesh::shape_of(m, mesh::ElementId(e));
    if (shape >= poor_shape) continue;
    ++count;
    if (shape >= least) continue;
    least = shape;
    worst = e;
  }
  if (count == 0) return std::nullopt;
  const auto corners = m.nodes_of(mesh::ElementId(worst)).first(mesh::corner_count(m.types[worst]));
  Vector sum;
  for (const mesh::NodeId node : corners) sum = sum + (m.point(node) - dobra::geom::Point{});
  const dobra::geom::Point at = dobra::geom::Point{} + sum / static_cast<double>(corners.size());
  return fmt::format(
      "nearly flat elements: {} of {}, the worst at ({:.6g}, {:.6g}) with shape {:.2g} (1 is best, below {} is "
      "poor): stresses there are not to be trusted; take a smaller size there, a greater `narrow`, or divide the "
      "curves more evenly (`segments`)",
      count, m.element_count(), at.x, at.y, least, poor_shape);
}

/// Greatest of the elements round a peak of stress of a case; 0: no peak.
double peak_eta_of(const CaseFields& fields) {
  double most = 0.0;
  for (const fem::error::HotSpot& spot : fields.peaks) most = std::max(most, spot.eta);
  return most;
}

/// Of the energy, round points with a force: an estimate of what is left would say nothing.
constexpr double most_left_out = 0.95;

/// The exact energy tells the error of loads that act on supports which stand still.
Result<void> check_exact(const fem::Problem& problem, const ProblemParams& params, const std::vector<double>& exact) {
  if (exact.empty()) return {};
  const auto bad = [](std::string message) { return Error{ErrorCode::BadValue, std::move(message)}; };
  if (exact.size() != problem.cases.size()) {
    std::string names;
    for (const auto& own : problem.cases) names += (names.empty() ? "" : ", ") + own.name;
    return bad(fmt::format(
        "exact_energy has {} values for {} load cases; give one a case, in the order {}; 0 where it is not known",
        exact.size(), problem.cases.size(), names));
  }
  for (std::size_t c = 0; c < exact.size(); ++c) {
    if (!(exact[c] >= 0.0))
      return bad(fmt::format("the exact_energy of load case '{}' is less than 0", problem.cases[c].name));
    if (exact[c] == 0.0) continue;  // not known
    if (problem.cases[c].settlement != 0.0 && moves(params))
      return bad(
          "exact_energy tells the error only where supports stand still; here a support or a tie prescribes a "
          "displacement, or a formula of one");
  }
  if (*std::max_element(exact.begin(), exact.end()) == 0.0)
    return bad("exact_energy is 0, not known, for every load case: leave it out");
  return {};
}

}  // namespace

Result<Analysis> analyse(const domain::Domain& domain, std::shared_ptr<const model::Meshed> meshed,
                         const ProblemParams& params, double memory, const EstimateParams& judged,
                         const dobra::base::Progress& progress) {
  const auto places = places_of(params);
  if (std::any_of(places.begin(), places.end(), domain::is_condition)) {
    auto own = std::make_shared<model::Meshed>(*meshed);
    DOBRA_TRY(own->mesh, with_sets(domain, meshed->mesh, places));
    meshed = std::move(own);
  }
  const mesh::ElementMesh& mesh = meshed->mesh;
  Analysis analysis{.meshed = meshed, .point_forces = judged.point_forces};
  DOBRA_TRY(analysis.problem, problem_of(mesh, params));
  DOBRA_TRY_VOID(check_exact(analysis.problem, params, judged.exact_energy));
  auto solved = fem::solve(mesh, analysis.problem, {.memory_limit = memory}, progress.part(0.0, 0.8));
  if (!solved) {
    if (solved.error().code == ErrorCode::InvalidOption) DOBRA_TRY_VOID(check_finite(mesh, params, analysis.problem));
    return solved.error();
  }
  analysis.solution = *std::move(solved);
  analysis.singular = fem::error::singular_vertices(mesh, analysis.problem);
  const auto corners = fem::error::free_corners(mesh, analysis.problem);
  for (const auto& result : analysis.solution.cases) {
    const auto& u = result.displacements;
    const auto& materials = analysis.problem.materials;
    CaseFields fields{fem::error::recover_stress(mesh, materials, u), {}};
    auto zones = fem::error::singular_zones(mesh, materials, analysis.singular, u, fields.recovered);
    // Of the free corners those whose stress shows it count as singular too.
    for (auto& zone : fem::error::singular_zones(mesh, materials, corners, u, fields.recovered)) {
      const bool known = std::any_of(analysis.singular.begin(), analysis.singular.end(),
                                     [&](const auto& vertex) { return vertex.node == zone.vertex.node; });
      if (!known) analysis.singular.push_back(zone.vertex);
      zones.push_back(std::move(zone));
    }
    fields.loaded = loaded_points(domain, mesh, params, analysis.problem, result, judged.point_radius);
    std::vector<fem::error::Disc> left_out;
    if (judged.point_forces == PointForces::LeaveOut) {
      for (const LoadedPoint& point : fields.loaded) left_out.push_back({point.at, point.radius});
    }
    fields.estimate = fem::error::estimate_error(mesh, materials, u, fields.recovered, zones, left_out);
    if (fields.estimate.left_out > most_left_out)
      return Error{ErrorCode::BadValue,
                   fmt::format("the surroundings of the points {} hold {:.3g} % of the energy, and nothing is left to "
                               "judge: give a smaller point_radius, or point_forces = \"count\"",
                               names_of(fields.loaded), 100.0 * fields.estimate.left_out)};
    if (!judged.exact_energy.empty() && judged.exact_energy[analysis.fields.size()] > 0.0)
      fields.exact_energy = judged.exact_energy[analysis.fields.size()];
    fields.peaks = fem::error::hot_spots(mesh, analysis.problem, u, fields.recovered, fields.estimate,
                                         analysis.singular, left_out);
    analysis.eta = std::max(analysis.eta, fields.estimate.eta);
    analysis.peak_eta = std::max(analysis.peak_eta, peak_eta_of(fields));
    analysis.fields.push_back(std::move(fields));
  }
  return analysis;
}

std::optional<Truth> truth_of(const Analysis& analysis, std::size_t load_case) {
  constexpr double digits = 1e-9;  // of the energy, that a solution has
  const CaseFields& fields = analysis.fields[load_case];
  if (!fields.exact_energy || !fields.loaded.empty()) return std::nullopt;
  const double exact = *fields.exact_energy, found = analysis.solution.cases[load_case].energy;
  if (found > (1.0 + digits) * exact) return std::nullopt;
  Truth truth{fem::error::true_error(exact, found)};
  if (exact - found > digits * exact) truth.effectivity = fields.estimate.error / truth.error;
  return truth;
}

std::vector<std::string> remarks_on(const Analysis& analysis) {
  std::vector<std::string> remarks;
  if (auto remark = locking(analysis)) remarks.push_back(*std::move(remark));
  if (auto remark = flat_elements(analysis)) remarks.push_back(*std::move(remark));
  const bool some_exact = std::any_of(analysis.fields.begin(), analysis.fields.end(),
                                      [](const CaseFields& fields) { return fields.exact_energy.has_value(); });
  for (std::size_t c = 0; c < analysis.fields.size(); ++c) {
    const CaseFields& fields = analysis.fields[c];
    const std::string of =
        analysis.fields.size() > 1 ? fmt::format("load case '{}': ", analysis.solution.cases[c].name) : std::string();
    const auto& loaded = fields.loaded;
    for (const std::string& remark : forces_on_curves(analysis, c)) remarks.push_back(of + remark);
    for (const std::string& remark : parted_points(analysis, c)) remarks.push_back(of + remark);
    if (analysis.solution.cases[c].energy == 0.0)
      remarks.push_back(of + "nothing acts: no load, and no support that moves, so all displacements are 0");
    if (some_exact && !fields.exact_energy)
      remarks.push_back(of + "its exact energy is not given, so its true error and the effectivity are not known");
    if (fields.exact_energy && !truth_of(analysis, c)) {
      remarks.push_back(loaded.empty()
                            ? fmt::format("{}the energy found, {:.9g} J, is above the exact one given, {:.9g} J, which "
                                          "cannot be that of this problem",
                                          of, analysis.solution.cases[c].energy, *fields.exact_energy)
                            : of + "the exact energy given is not compared: that of a force at a point is infinite");
    }
    if (loaded.empty()) continue;
    if (const Extremes extremes = extremes_of(analysis, c); extremes.von_mises > extremes.elsewhere) {
      remarks.push_back(
          fmt::format("{}max_von_mises, {:.4g} Pa at ({:.6g}, {:.6g}), is that of a force at a single point, which "
                      "grows without end as the elements get smaller; away from such points it is {:.4g} Pa",
                      of, extremes.von_mises, extremes.at.x, extremes.at.y, extremes.elsewhere));
    }
    for (const std::string& remark : loaded_displacements(analysis, c)) remarks.push_back(of + remark);
    if (analysis.point_forces == PointForces::LeaveOut) {
      for (const std::string& remark : left_out_of(analysis, c)) remarks.push_back(of + remark);
    } else {
      remarks.push_back(
          fmt::format("{}forces at single points ({}) have an infinite energy, which no mesh meets: spread them over a "
                      "curve, or leave their surroundings out of the error with point_forces = \"leave_out\"",
                      of, names_of(loaded)));
    }
  }
  return remarks;
}

Result<model::Model> add_analysis(const model::Model& model, const AnalyseParams& params,
                                  const dobra::scenario::Context&, const dobra::base::Progress& progress) {
  if (!model.problem)
    return Error{ErrorCode::BadValue,
                 "there is nothing to analyse: put a step 'problem' with materials, supports and loads before"};
  if (model.meshes.empty()) return Error{ErrorCode::BadValue, "there is no mesh to analyse: put a step 'mesh' before"};
  DOBRA_TRY(Analysis analysis,
            analyse(model.domain, model.meshes.back(), *model.problem, params.memory, params, progress));
  model::Model result = model;
  for (std::string& remark : remarks_on(analysis)) result.remarks.push_back(std::move(remark));
  result.analyses.push_back(std::make_shared<const Analysis>(std::move(analysis)));
  return result;
}

void add_analysis_quantities(const model::Model& model, std::vector<dobra::scenario::Quantity>& quantities) {
  if (model.analyses.empty()) return;
  const Analysis& analysis = *model.analyses.back();
  quantities.push_back({"unknowns", static_cast<double>(analysis.solution.statistics.unknowns), ""});
  quantities.push_back({"cycles", static_cast<double>(analysis.cycle), ""});
  quantities.push_back({"eta", 100.0 * analysis.eta, "%"});
  quantities.push_back({"peak_eta", 100.0 * analysis.peak_eta, "%"});
  for (std::size_t c = 0; c < analysis.solution.cases.size(); ++c) {
    const auto& result = analysis.solution.cases[c];
    const std::string prefix = "case." + result.name + ".";
    double moved = 0.0;
    for (const Vector u : result.displacements) moved = std::max(moved, length(u));
    quantities.push_back({prefix + "energy", result.energy, "J"});
    quantities.push_back({prefix + "eta", 100.0 * analysis.fields[c].estimate.eta, "%"});
    quantities.push_back({prefix + "error", analysis.fields[c].estimate.error, "J^0.5"});
    if (!analysis.fields[c].loaded.empty())
      quantities.push_back({prefix + "left_out", 100.0 * analysis.fields[c].estimate.left_out, "%"});
    if (const auto truth = truth_of(analysis, c)) {
      quantities.push_back({prefix + "true_error", truth->error, "J^0.5"});
      if (truth->effectivity) quantities.push_back({prefix + "effectivity", *truth->effectivity, ""});
    }
    quantities.push_back({prefix + "max_displacement", moved, "m"});
    const Extremes extremes = extremes_of(analysis, c);
    quantities.push_back({prefix + "max_von_mises", extremes.von_mises, "Pa"});
    quantities.push_back({prefix + "max_principal", extremes.principal, "Pa"});
    for (const auto& [name, nodes] : analysis.meshed->mesh.node_sets) {
      if (nodes.size() != 1) continue;
      const Vector u = result.displacements[nodes.front().index()];
      quantities.push_back({prefix + "point." + name + ".u_x", u.x, "m"});
      quantities.push_back({prefix + "point." + name + ".u_y", u.y, "m"});
    }
  }
}

void add_analysis_tables(const model::Model& model, std::vector<dobra::scenario::DataTable>& tables) {
  if (model.analyses.empty()) return;
  dobra::scenario::DataTable cycles{"analyses",
                                    {"mesh", "case", "cycle", "elements", "unknowns", "eta [%]", "peak eta [%]",
                                     "energy [J]", "true error [J^0.5]", "effectivity"},
                                    {}};
  for (const auto& analysis : model.analyses) {
    for (std::size_t c = 0; c < analysis->fields.size(); ++c) {
      const fem::CaseResult& solved = analysis->solution.cases[c];
      const CaseFields& fields = analysis->fields[c];
      auto& row = cycles.rows.emplace_back();
      row.reserve(cycles.columns.size());
      row.emplace_back(analysis->meshed->name);
      row.emplace_back(solved.name);
      for (const double value :
           {static_cast<double>(analysis->cycle), static_cast<double>(analysis->meshed->mesh.element_count()),
            static_cast<double>(analysis->solution.statistics.unknowns), 100.0 * fields.estimate.eta,
            100.0 * peak_eta_of(fields), solved.energy})
        row.emplace_back(value);
      const auto truth = truth_of(*analysis, c);
      for (const auto& known :
           {truth ? std::optional(truth->error) : std::nullopt, truth ? truth->effectivity : std::nullopt}) {
        if (known)
          row.emplace_back(*known);
        else
          row.emplace_back(std::string());
      }
    }
  }
  tables.push_back(std::move(cycles));
}

void add_analysis_outputs(const std::shared_ptr<const model::Model>& model,
                          std::vector<dobra::scenario::Output>& outputs) {
  if (model->analyses.empty()) return;
  const std::shared_ptr<const Analysis> analysis = model->analyses.back();
  const dobra::scenario::UnitSystem units = model->units;
  outputs.push_back({"results.vtu", [analysis, units](const auto& path) {
                       return model::write_vtu(path.string(), analysis->meshed->mesh, fields_of(*analysis, units),
                                               units);
                     }});
  if (const auto gap = deck_gap(analysis->meshed->mesh, analysis->problem)) {
    outputs.back().losses.push_back("analysis.inp is not written: " + to_string(*gap));
    return;
  }
  outputs.push_back({"analysis.inp", [analysis, units](const auto& path) -> Result<void> {
                       DOBRA_TRY(const std::string text, deck_text(analysis->meshed->mesh, analysis->problem, units));
                       return dobra::io::write_file(path, text);
                     }});
}

}  // namespace quebra::analysis
