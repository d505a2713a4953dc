#pragma once
// A mesh of surfaces as shells for CalculiX (.inp) and Nastran (.bdf): sections with thickness, supports as single
// constraints, loads as nodal forces that the shape functions of the elements make of them. Page:
// docs/user/surfaces.md. Source: [calculix-ccx], [nastran-qrg].

#include <map>

#include "quebra/model/model.h"
#include "quebra/surfaces/shell_params.h"
#include "shared/base/progress.h"
#include "shared/scenario/program.h"

namespace quebra::surfaces {

/// What a deck says beside the mesh, in SI.
struct Shell {
  struct Section {
    double young = 0.0, poisson = 0.3, thickness = 0.0;
  };
  std::map<std::int32_t, Section> sections;                          ///< Of every region of the mesh.
  std::map<std::size_t, std::array<std::optional<double>, 6>> held;  ///< A node: displacements, m, rotations, rad.
  std::map<std::size_t, dobra::geom::Vector3> forces;                ///< A node: N.
};

/// @error BadValue: a name that is no region or set, a region without material, no support, loads that have no effect.
/// @cost O(n log n)
dobra::base::Result<Shell> make_shell(const dobra::surf::mesh::SurfaceElements& elements, const ShellParams& params);

/// The decks, in `units`.
dobra::base::Result<std::string> shell_inp(const dobra::surf::mesh::SurfaceElements& elements, const Shell& shell,
                                           const dobra::scenario::UnitSystem& units);
dobra::base::Result<std::string> shell_bdf(const dobra::surf::mesh::SurfaceElements& elements, const Shell& shell,
                                           const dobra::scenario::UnitSystem& units);

/// The step. @error those of make_shell; BadValue: there is no mesh of surfaces before it.
dobra::base::Result<model::Model> add_shell(const model::Model& model, const ShellParams& params,
                                            const dobra::scenario::Context& context,
                                            const dobra::base::Progress& progress);
/// "shell.inp" and "shell.bdf", of a model that has a shell.
void add_shell_outputs(const std::shared_ptr<const model::Model>& model, std::vector<dobra::scenario::Output>& outputs);
/// Total force, N, and nodes held.
void add_shell_quantities(const model::Model& model, std::vector<dobra::scenario::Quantity>& quantities);

}  // namespace quebra::surfaces
