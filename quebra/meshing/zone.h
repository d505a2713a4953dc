#pragma once
// "Elements of size h within w of here": a plastic zone, as sizes asked of the mesher; no edge of
// the mesh follows the zone's border. Source: [carvalho2005offset], QUEBRA 2D.

#include <string>
#include <vector>

#include "quebra/model/model.h"
#include "shared/base/progress.h"
#include "shared/scenario/program.h"

namespace quebra::meshing {

struct ZoneParams {
  std::vector<std::string> curves;
  std::vector<dobra::geom::Point> points;
  double size = 0.0;
  double width = 0.0;

  template <class D>
  static void describe(D& d) {
    d.field("curves", &ZoneParams::curves,
            {.title = "Curves",
             .help = "Names of curves and cracks round which the elements are to be small.",
             .names = "curve"});
    d.field("points", &ZoneParams::points,
            {.title = "Points", .help = "A line of one's own, or a single point.", .unit = "m"});
    d.field("size", &ZoneParams::size,
            {.title = "Size",
             .help = "Of the element sides in the zone.",
             .unit = "m",
             .above = 0,
             .presence = dobra::scenario::Presence::Required});
    d.field("width", &ZoneParams::width,
            {.title = "Width",
             .help = "How far the zone reaches to either side.",
             .unit = "m",
             .above = 0,
             .presence = dobra::scenario::Presence::Required});
  }
};

/// @error BadValue for an unknown curve, for neither curves nor points, and for a zone of more than ten million
/// elements.
dobra::base::Result<model::Model> add_zone(const model::Model& model, const ZoneParams& params,
                                           const dobra::scenario::Context& context,
                                           const dobra::base::Progress& progress);

/// Points inside the domain's box, less than a size apart, that cover the zone.
std::vector<dobra::geom::Point> points_of(const model::Zone& zone, const domain::Domain& domain);

}  // namespace quebra::meshing
