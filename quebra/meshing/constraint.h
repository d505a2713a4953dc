#pragma once
// Offset curves of a boundary as internal constraints: the mesh gets edges along them, and so refines gently towards
// it. Source: [carvalho2005offset], QUEBRA 2D.

#include <string>
#include <vector>

#include "quebra/meshing/band.h"
#include "shared/base/progress.h"
#include "shared/scenario/program.h"

namespace quebra::meshing {

enum class BandSide { Inside, Left, Right };

struct ConstraintParams {
  std::vector<std::string> curves;
  int count = 4;
  double distance = 0.1;
  double factor = 1.0;
  BandSide side = BandSide::Inside;
  Spacing spacing = Spacing::Ring;
  double spacing_factor = 1.0;

  template <class D>
  static void describe(D& d) {
    d.field("curves", &ConstraintParams::curves,
            {.title = "Base curves",
             .help = "Names of one curve, or of curves that follow each other.",
             .names = "curve",
             .presence = dobra::scenario::Presence::Required});
    d.field("count", &ConstraintParams::count, {.title = "Number of curves", .at_least = 1, .at_most = 1000});
    d.field("distance", &ConstraintParams::distance,
            {.title = "First distance", .help = "From the base to the first curve.", .unit = "m", .above = 0});
    d.field(
        "factor", &ConstraintParams::factor,
        {.title = "Factor", .help = "D_k = factor D_(k-1) + first distance; 1 spaces the curves equally.", .above = 0});
    d.choice("side", &ConstraintParams::side, {"inside", "left", "right"},
             {.title = "Side",
              .help = "inside: where the domain is, and all round a crack; left or right of the base's direction."});
    d.choice("spacing", &ConstraintParams::spacing, {"ring", "base"},
             {.title = "Nodes",
              .help = "ring: as far apart as the curve is from its neighbours; base: as the divided base has them."});
    d.field("spacing_factor", &ConstraintParams::spacing_factor,
            {.title = "Node spacing",
             .help = "Multiplies the distance of the nodes (ring).",
             .above = 0,
             .when = "spacing = ring"});
  }
};

/// Adds the constraints; pieces outside the domain are cut away, bands give way to each other (band.h), and a curve of
/// which nothing is left gets a remark.
/// @error BadValue for an unknown curve, or curves that do not follow each other.
dobra::base::Result<model::Model> add_constraints(const model::Model& model, const ConstraintParams& params,
                                                  const dobra::scenario::Context& context,
                                                  const dobra::base::Progress& progress);

}  // namespace quebra::meshing
