#pragma once
// The parameters of the step that cuts parts to a plane domain.

#include <string>
#include <vector>

#include "shared/scenario/field.h"

namespace quebra::solids {

struct CutCrackParams {
  std::string name;
  std::vector<dobra::geom::Point> points;
  double tip_size = 0.0;
  template <class D>
  static void describe(D& d) {
    d.field("name", &CutCrackParams::name,
            {.title = "Name",
             .help = "The lips are the sets NAME_left and NAME_right, the tips NAME_start and NAME_end.",
             .presence = dobra::scenario::Presence::Required});
    d.field("points", &CutCrackParams::points,
            {.title = "Points",
             .help = "In the plane of the section, from start to end; an end on the boundary opens there.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
    d.field("tip_size", &CutCrackParams::tip_size,
            {.title = "Size at the ends",
             .help = "Length of the element sides at both ends, from which they grow; 0: none of their own.",
             .unit = "m",
             .at_least = 0});
  }
};

struct CutParams {
  std::vector<std::string> of;
  std::vector<double> plane;
  std::vector<CutCrackParams> cracks;
  template <class D>
  static void describe(D& d) {
    d.field("of", &CutParams::of,
            {.title = "Of", .help = "Names of parts; the last part where left out.", .names = "part"});
    d.field(
        "plane", &CutParams::plane,
        {.title = "Plane",
         .help = "a, b, c, d of the plane a x + b y + c z + d = 0; the section is seen from where that is positive.",
         .presence = dobra::scenario::Presence::Required});
    d.tables("crack", &CutParams::cracks, {.title = "Cracks", .help = "Drawn in the section."});
  }
};

}  // namespace quebra::solids
