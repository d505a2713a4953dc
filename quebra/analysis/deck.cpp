#include "quebra/analysis/deck.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "quebra/model/mesh_files.h"
#include "shared/fem/constraints.h"
#include "shared/fem/mixed.h"
#include "shared/io/meshes/inp.h"

namespace quebra::analysis {
namespace {

namespace fem = dobra::fem;
using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::io::meshes::twenty_columns;

/// The material of plane strain whose stresses and strains in the plane are those of `material`.
fem::Material in_plane_strain(fem::Material material) {
  if (material.state == fem::PlaneState::Strain) return material;
  const double nu = material.poisson;
  material.young *= (1.0 + 2.0 * nu) / ((1.0 + nu) * (1.0 + nu));
  material.poisson = nu / (1.0 + nu);
  material.state = fem::PlaneState::Strain;
  return material;
}

std::string material_text(std::int32_t region, const fem::Material& material) {
  const fem::Material own = in_plane_strain(material);
  std::string text;
  if (material.state == fem::PlaneState::Stress) {
    text = fmt::format(
        "** Plane stress, E = {}, nu = {}. CalculiX has no such elements (its CPS are a layer of solids, sheared where "
        "its thickness varies):\n"
        "** in plane strain E (1 + 2 nu) / (1 + nu)^2 and nu / (1 + nu) give the same displacements, strains and "
        "stresses in the plane, exactly.\n"
        "** Only the stress across, S33, is not that of the sheet: there it is 0. For Abaqus, CPS elements with the "
        "first pair are the same.\n",
        twenty_columns(material.young), twenty_columns(material.poisson));
  }
  return text + fmt::format(
                    "*MATERIAL, NAME=MATERIAL_{0}\n*ELASTIC\n{1}, {2}\n*SOLID SECTION, ELSET=REGION_{0}, "
                    "MATERIAL=MATERIAL_{0}\n{3}\n",
                    region, twenty_columns(own.young), twenty_columns(own.poisson), twenty_columns(own.thickness));
}

/// Plane stress with nu <= -0.5 has no equal in plane strain.
std::optional<Error> without_equal(const fem::Problem& problem) {
  for (const auto& [region, material] : problem.materials) {
    if (material.state == fem::PlaneState::Stress && material.poisson <= -0.5)
      return Error{ErrorCode::InvalidOption,
                   "a deck holds plane stress as plane strain, which cannot be done for nu <= -0.5",
                   Place{.item = fmt::format("material of region {}", region)}};
    if (fem::nearly_incompressible(material))
      return Error{ErrorCode::InvalidOption,
                   "CalculiX has no mixed elements, and its own lock at this Poisson's ratio in plane strain",
                   Place{.item = fmt::format("material of region {}", region)}};
  }
  return std::nullopt;
}

/// Supports of one displacement by node and axis; further ones of the same displacement say the same (the solver
/// checks).
using Held = std::map<std::uint32_t, double>;

/// Ties and inclined supports; one with a value other than zero ends in a node of its own, after those of the mesh,
/// that is prescribed along x.
struct Equations {
  std::string text;
  std::vector<double> values;  ///< Of those nodes.
};

/// @param sprung  displacements with springs: CalculiX loses a spring at one that an equation eliminates.
Result<Equations> equations_of(const std::vector<fem::DofConstraint>& constraints, const Held& held,
                               const std::set<std::uint32_t>& sprung, std::size_t nodes) {
  Equations equations;
  std::set<std::uint32_t> dependent;
  for (const fem::DofConstraint& constraint : constraints) {
    if (constraint.terms.size() < 2) continue;
    auto terms = constraint.terms;
    std::erase_if(terms, [](const auto& term) { return term.second == 0.0; });
    // The first term is eliminated: it must be free and not eliminated before.
    const auto first = std::find_if(terms.begin(), terms.end(), [&](const auto& term) {
      return !held.contains(term.first) && !dependent.contains(term.first);
    });
    if (first == terms.end()) continue;
    const auto plain = std::find_if(first, terms.end(), [&](const auto& term) {
      return !held.contains(term.first) && !dependent.contains(term.first) && !sprung.contains(term.first);
    });
    if (plain == terms.end())
      return Error{ErrorCode::InvalidOption,
                   "a deck cannot have springs at every displacement of a tie; leave one of its nodes without",
                   Place{.item = constraint.name}};
    std::iter_swap(first, plain);
    dependent.insert(first->first);
    std::iter_swap(terms.begin(), first);
    if (constraint.value != 0.0) {
      terms.push_back({static_cast<std::uint32_t>(2 * (nodes + equations.values.size())), -1.0});
      equations.values.push_back(constraint.value);
    }
    equations.text += fmt::format("*EQUATION\n{}\n", terms.size());
    for (const auto& [dof, coefficient] : terms)
      equations.text += fmt::format("{}, {}, {}\n", dof / 2 + 1, dof % 2 + 1, twenty_columns(coefficient));
  }
  return equations;
}

std::string value_nodes_text(std::size_t nodes, std::size_t count) {
  if (count == 0) return {};
  std::string text = "*NODE, NSET=TIE_VALUES\n";
  for (std::size_t i = 0; i < count; ++i) text += fmt::format("{}, 0, 0\n", nodes + i + 1);
  return text;
}

/// The supports of single displacements.
Held held_by(const std::vector<fem::DofConstraint>& constraints) {
  Held held;
  for (const fem::DofConstraint& constraint : constraints) {
    const auto counts = [](const auto& term) { return std::abs(term.second) > 1e-12; };
    if (std::count_if(constraint.terms.begin(), constraint.terms.end(), counts) != 1) continue;
    const auto only = std::find_if(constraint.terms.begin(), constraint.terms.end(), counts);
    held.try_emplace(only->first, constraint.value / only->second);
  }
  return held;
}

Result<std::set<std::uint32_t>> sprung_by(const dobra::mesh::ElementMesh& mesh,
                                          const std::vector<fem::Spring>& springs) {
  std::set<std::uint32_t> sprung;
  for (const fem::Spring& spring : springs) {
    if (spring.kind == fem::SpringKind::Foundation)
      return Error{
          ErrorCode::InvalidOption,
          "a deck has no words for a bed of springs, which couples the nodes of a side; give springs at the nodes",
          Place{.item = "bed along '" + spring.where + "'"}};
    DOBRA_TRY(const auto nodes, fem::find_nodes(mesh, spring.where));
    for (const auto node : nodes) {
      if (spring.x != 0.0) sprung.insert(static_cast<std::uint32_t>(2 * node.index()));
      if (spring.y != 0.0) sprung.insert(static_cast<std::uint32_t>(2 * node.index() + 1));
    }
  }
  return sprung;
}

/// Springs from the nodes to the ground.
Result<std::string> springs_text(const dobra::mesh::ElementMesh& mesh, const std::vector<fem::Spring>& springs,
                                 const dobra::scenario::UnitSystem& units) {
  std::string text;
  std::size_t element = mesh.element_count();
  std::size_t number = 0;
  for (const fem::Spring& spring : springs) {
    DOBRA_TRY(const fem::Shares shares, fem::find_shares(mesh, spring.where));
    for (const int axis : {1, 2}) {
      const double stiffness = units.from_si(axis == 1 ? spring.x : spring.y, "N/m");
      if (stiffness == 0.0) continue;
      text += fmt::format("*ELEMENT, TYPE=SPRING1, ELSET=SPRING_{}\n", ++number);
      for (const auto node : shares.nodes) text += fmt::format("{}, {}\n", ++element, node.index() + 1);
      text += fmt::format("*SPRING, ELSET=SPRING_{}\n{}\n{}\n", number, axis, twenty_columns(shares.each * stiffness));
    }
  }
  return text;
}

}  // namespace

std::optional<Error> deck_gap(const dobra::mesh::ElementMesh& mesh, const fem::Problem& problem) {
  if (const auto gap = without_equal(problem)) return gap;
  const auto constraints = fem::constraints_of(mesh, problem);
  const auto sprung = sprung_by(mesh, problem.springs);
  if (!sprung) return sprung.error();
  const auto equations = equations_of(constraints, held_by(constraints), *sprung, mesh.points.size());
  return equations ? std::nullopt : std::optional(equations.error());
}

Result<std::string> deck_text(const dobra::mesh::ElementMesh& mesh, const fem::Problem& problem,
                              const dobra::scenario::UnitSystem& units) {
  if (auto gap = without_equal(problem)) return *std::move(gap);
  const std::vector<fem::DofConstraint> constraints = fem::constraints_of(mesh, problem);
  const Held held = held_by(constraints);
  DOBRA_TRY(const auto sprung, sprung_by(mesh, problem.springs));
  DOBRA_TRY(const Equations equations, equations_of(constraints, held, sprung, mesh.points.size()));
  DOBRA_TRY(std::string text, dobra::io::meshes::inp_text(model::in_units(mesh, units),
                                                          {.element = dobra::io::meshes::InpElement::PlaneStrain}));
  text = "** " + model::note_of(units) + '\n' + text;
  const auto in = [&units](double value, const char* si) { return twenty_columns(units.from_si(value, si)); };
  const std::set<std::int32_t> regions(mesh.regions.begin(), mesh.regions.end());
  for (const std::int32_t region : regions) {
    fem::Material material = problem.materials.at(region);
    material.young = units.from_si(material.young, "Pa");
    material.thickness = units.from_si(material.thickness, "m");
    text += material_text(region, material);
  }
  text += value_nodes_text(mesh.points.size(), equations.values.size()) + equations.text;
  DOBRA_TRY(const std::string springs, springs_text(mesh, problem.springs, units));
  text += springs;
  for (const fem::LoadCase& load : problem.cases) {
    text += fmt::format("*STEP\n*STATIC\n** {}\n*BOUNDARY, OP=NEW\n", load.name);
    for (const auto& [dof, value] : held)
      text += fmt::format("{0}, {1}, {1}, {2}\n", dof / 2 + 1, dof % 2 + 1, in(load.settlement * value, "m"));
    for (std::size_t i = 0; i < equations.values.size(); ++i)
      text +=
          fmt::format("{0}, 1, 1, {1}\n", mesh.points.size() + i + 1, in(load.settlement * equations.values[i], "m"));
    text += "*CLOAD, OP=NEW\n";
    const auto forces = fem::load_vector(mesh, problem, load);
    for (std::size_t n = 0; n < forces.size(); ++n) {
      if (forces[n].x != 0.0) text += fmt::format("{}, 1, {}\n", n + 1, in(forces[n].x, "N"));
      if (forces[n].y != 0.0) text += fmt::format("{}, 2, {}\n", n + 1, in(forces[n].y, "N"));
    }
    text += "*NODE PRINT, NSET=NALL\nU\n*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n";
  }
  return text;
}

}  // namespace quebra::analysis
