#pragma once
// The parameters of the steps that make parts of parts.

#include <optional>
#include <string>
#include <vector>

#include "quebra/solids/part_params.h"

namespace quebra::solids {

/// A base of what is made of other parts.
struct OfParts : NamedPart {
  std::vector<std::string> of;
  template <class P, class D>
  static void describe_of(D& d) {
    describe_part<P>(d);
    d.field("of", static_cast<std::vector<std::string> P::*>(&OfParts::of),
            {.title = "Of",
             .help = "Names of parts that steps before have made; a part may be used more than once.",
             .names = "part",
             .presence = dobra::scenario::Presence::Required});
  }
};

struct UniteParams : OfParts {
  template <class D>
  static void describe(D& d) {
    describe_of<UniteParams>(d);
  }
};
struct IntersectParams : OfParts {
  template <class D>
  static void describe(D& d) {
    describe_of<IntersectParams>(d);
  }
};
struct SubtractParams : OfParts {
  template <class D>
  static void describe(D& d) {
    describe_of<SubtractParams>(d);
  }
};
struct GroupParams : OfParts {
  template <class D>
  static void describe(D& d) {
    describe_of<GroupParams>(d);
  }
};

struct PlaceParams : OfParts {
  std::optional<dobra::geom::Point3> scale, turn_axis;
  dobra::geom::Point3 about{}, by{};
  double turn = 0.0;
  std::vector<double> matrix;
  template <class D>
  static void describe(D& d) {
    describe_of<PlaceParams>(d);
    d.field("scale", &PlaceParams::scale,
            {.title = "Scale (x, y, z)", .help = "Factors about the point `about`, first; negative ones mirror."});
    d.field("turn", &PlaceParams::turn,
            {.title = "Turn", .help = "In degrees, anticlockwise about an axis through the point `about`, second."});
    d.field("turn_axis", &PlaceParams::turn_axis, {.title = "Axis of the turn", .help = "z where left out."});
    d.field("about", &PlaceParams::about,
            {.title = "About (x, y, z)", .help = "What stays in its place while scaled and turned.", .unit = "m"});
    d.field("by", &PlaceParams::by, {.title = "By (x, y, z)", .help = "How far it is moved, last.", .unit = "m"});
    d.field(
        "matrix", &PlaceParams::matrix,
        {.title = "Matrix", .help = "In place of all that: 16 numbers row by row, applied to columns (x, y, z, 1)."});
  }
};

struct RoundParams : OfParts {
  double radius = 1.0;
  int segments = 8;
  template <class D>
  static void describe(D& d) {
    describe_of<RoundParams>(d);
    d.field("radius", &RoundParams::radius, {.title = "Radius", .help = "Of all edges.", .unit = "m", .above = 0});
    d.field("segments", &RoundParams::segments,
            {.title = "Segments",
             .help = "Planes by which one face turns into its neighbour; 2 makes chamfers.",
             .at_least = 2,
             .at_most = 64});
  }
};

}  // namespace quebra::solids
