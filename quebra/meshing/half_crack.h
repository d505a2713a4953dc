#pragma once
// Symmetric halves of cracked models: a curve of the boundary is one lip of a crack on a line of symmetry, and the line
// goes straight on as another curve ahead of the tip. Page: docs/algorithms/crack.md.

#include <string>
#include <vector>

#include "quebra/model/model.h"
#include "shared/base/progress.h"
#include "shared/scenario/program.h"

namespace quebra::meshing {

struct HalfCrackParams {
  std::string lip;

  template <class D>
  static void describe(D& d) {
    d.field("lip", &HalfCrackParams::lip,
            {.title = "Lip",
             .help = "Curve of the boundary; its tips are NAME_start and NAME_end where the boundary goes straight on. "
                     "Give what lies ahead a support with normal = 0.",
             .names = "curve",
             .presence = dobra::scenario::Presence::Required});
  }
};

/// Adds the tips of one lip to the model, for the meshes made afterwards.
/// @error BadValue: no such curve, not on the boundary, or nowhere does the boundary go straight on.
dobra::base::Result<model::Model> add_half_crack(const model::Model& model, const HalfCrackParams& params,
                                                 const dobra::scenario::Context& context,
                                                 const dobra::base::Progress& progress);

/// Makes tips of the mesh of them, with a node set each. @error BadCrack with the place: no node there.
dobra::base::Result<void> name_half_tips(dobra::mesh::ElementMesh& mesh, const std::vector<model::HalfTip>& tips);

}  // namespace quebra::meshing
