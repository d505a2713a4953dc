#include "quebra/core/deck.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "shared/fem/constraints.h"
#include "shared/io/inp.h"

namespace quebra::core {
namespace {

namespace fem = dobra::fem;
using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::io::twenty_columns;

std::string material_text(std::int32_t region, const fem::Material& material) {
  return fmt::format("*MATERIAL, NAME=MATERIAL_{0}\n*ELASTIC\n{1}, {2}\n*SOLID SECTION, ELSET=REGION_{0}, MATERIAL=MATERIAL_{0}\n{3}\n", region,
                     twenty_columns(material.young), twenty_columns(material.poisson), twenty_columns(material.thickness));
}

/// Supports of one displacement by node and axis; further ones of the same displacement say the same (the solver checks).
using Held = std::map<std::uint32_t, double>;

Result<std::string> equations_text(const std::vector<fem::DofConstraint>& constraints, const Held& held) {
  std::string text;
  std::set<std::uint32_t> dependent;
  for (const fem::DofConstraint& constraint : constraints) {
    if (constraint.terms.size() < 2) continue;
    if (constraint.value != 0.0)
      return Error{ErrorCode::InvalidOption, "a deck has no words for a tie or inclined support with a value other than zero", Place{.item = constraint.name}};
    auto terms = constraint.terms;
    std::erase_if(terms, [](const auto& term) { return term.second == 0.0; });
    // The first term is eliminated: it must be free and not eliminated before.
    const auto first = std::find_if(terms.begin(), terms.end(), [&](const auto& term) { return !held.contains(term.first) && !dependent.contains(term.first); });
    if (first == terms.end()) continue;
    dependent.insert(first->first);
    std::iter_swap(terms.begin(), first);
    text += fmt::format("*EQUATION\n{}\n", terms.size());
    for (const auto& [dof, coefficient] : terms) text += fmt::format("{}, {}, {}\n", dof / 2 + 1, dof % 2 + 1, twenty_columns(coefficient));
  }
  return text;
}

}  // namespace

Result<std::string> deck_text(const dobra::mesh::ElementMesh& mesh, const fem::Problem& problem) {
  if (!problem.springs.empty()) return Error{ErrorCode::InvalidOption, "springs are not written to decks", Place{.item = problem.springs.front().where}};
  const bool strain = problem.materials.begin()->second.state == fem::PlaneState::Strain;
  DOBRA_TRY(std::string text, dobra::io::inp_text(mesh, {.element = strain ? dobra::io::InpElement::PlaneStrain : dobra::io::InpElement::PlaneStress}));
  const std::set<std::int32_t> regions(mesh.regions.begin(), mesh.regions.end());
  for (const std::int32_t region : regions) text += material_text(region, problem.materials.at(region));
  const std::vector<fem::DofConstraint> constraints = fem::constraints_of(mesh, problem);
  Held held;
  for (const fem::DofConstraint& constraint : constraints) {
    const auto only = std::find_if(constraint.terms.begin(), constraint.terms.end(), [](const auto& term) { return std::abs(term.second) > 1e-12; });
    const auto real = std::count_if(constraint.terms.begin(), constraint.terms.end(), [](const auto& term) { return std::abs(term.second) > 1e-12; });
    if (real == 1) held.try_emplace(only->first, constraint.value / only->second);
  }
  DOBRA_TRY(const std::string equations, equations_text(constraints, held));
  text += equations;
  for (const fem::LoadCase& load : problem.cases) {
    text += fmt::format("*STEP\n*STATIC\n** {}\n*BOUNDARY, OP=NEW\n", load.name);
    for (const auto& [dof, value] : held) text += fmt::format("{0}, {1}, {1}, {2}\n", dof / 2 + 1, dof % 2 + 1, twenty_columns(load.settlement * value));
    text += "*CLOAD, OP=NEW\n";
    const auto forces = fem::load_vector(mesh, problem, load);
    for (std::size_t n = 0; n < forces.size(); ++n) {
      if (forces[n].x != 0.0) text += fmt::format("{}, 1, {}\n", n + 1, twenty_columns(forces[n].x));
      if (forces[n].y != 0.0) text += fmt::format("{}, 2, {}\n", n + 1, twenty_columns(forces[n].y));
    }
    text += "*NODE PRINT, NSET=NALL\nU\n*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n";
  }
  return text;
}

}  // namespace quebra::core
