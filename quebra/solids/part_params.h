#pragma once
// The parameters of the steps that make parts: instances, sweeps, operations, places.

#include <optional>
#include <string>
#include <vector>

#include "shared/io/formats/boundary_file.h"
#include "shared/scenario/field.h"

namespace quebra::solids {

/// A base of all others.
struct NamedPart {
  std::string part;

  template <class P, class D>
  static void describe_part(D& d) {
    d.field("part", static_cast<std::string P::*>(&NamedPart::part),
            {.title = "Part",
             .help = "What the result is called; later steps name it in `of`, and its faces begin with it.",
             .presence = dobra::scenario::Presence::Required});
  }
};

/// A base of what is made from nothing.
struct PlacedPart : NamedPart {
  std::string material;
  dobra::geom::Point3 at{};
  std::optional<dobra::geom::Point3> axis;

  template <class P, class D>
  static void describe_placed(D& d) {
    describe_part<P>(d);
    d.field("material", static_cast<std::string P::*>(&PlacedPart::material),
            {.title = "Material", .help = "Region of the domains that are cut from it; empty: the name of the part."});
    d.field("at", static_cast<dobra::geom::Point3 P::*>(&PlacedPart::at),
            {.title = "At (x, y, z)", .help = "Where its origin is put.", .unit = "m"});
    d.field("axis", static_cast<std::optional<dobra::geom::Point3> P::*>(&PlacedPart::axis),
            {.title = "Axis", .help = "Direction in which its z axis is turned; z where left out."});
  }
};

struct BlockParams : PlacedPart {
  dobra::geom::Point3 size{1.0, 1.0, 1.0};
  template <class D>
  static void describe(D& d) {
    describe_placed<BlockParams>(d);
    d.field("size", &BlockParams::size,
            {.title = "Size (x, y, z)",
             .help = "From its origin, which is a corner; each above 0.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
  }
};

/// A base of what stands on a regular polygon.
struct OnPolygon : PlacedPart {
  int sides = 6;
  double radius = 1.0, height = 1.0;
  template <class P, class D>
  static void describe_polygon(D& d) {
    describe_placed<P>(d);
    d.field("sides", static_cast<int P::*>(&OnPolygon::sides),
            {.title = "Sides", .help = "Of its base.", .at_least = 3, .at_most = 10000});
    d.field("radius", static_cast<double P::*>(&OnPolygon::radius),
            {.title = "Radius", .help = "From the middle of its base to a corner.", .unit = "m", .above = 0});
    d.field("height", static_cast<double P::*>(&OnPolygon::height), {.title = "Height", .unit = "m", .above = 0});
  }
};

struct PrismParams : OnPolygon {
  template <class D>
  static void describe(D& d) {
    describe_polygon<PrismParams>(d);
  }
};
struct PyramidParams : OnPolygon {
  template <class D>
  static void describe(D& d) {
    describe_polygon<PyramidParams>(d);
  }
};

/// A base of what polygons stand for.
struct RoundPart : PlacedPart {
  double radius = 1.0;
  int segments = 64;
  template <class P, class D>
  static void describe_round(D& d) {
    describe_placed<P>(d);
    d.field("radius", static_cast<double P::*>(&RoundPart::radius), {.title = "Radius", .unit = "m", .above = 0});
    d.field("segments", static_cast<int P::*>(&RoundPart::segments),
            {.title = "Segments",
             .help = "Corners of the polygon that stands for a circle, all of them on it.",
             .at_least = 3,
             .at_most = 10000});
  }
};

struct CylinderParams : RoundPart {
  double height = 1.0;
  template <class D>
  static void describe(D& d) {
    describe_round<CylinderParams>(d);
    d.field("height", &CylinderParams::height, {.title = "Height", .unit = "m", .above = 0});
  }
};

struct ConeParams : RoundPart {
  double height = 1.0, top_radius = 0.0;
  template <class D>
  static void describe(D& d) {
    describe_round<ConeParams>(d);
    d.field("height", &ConeParams::height, {.title = "Height", .unit = "m", .above = 0});
    d.field("top_radius", &ConeParams::top_radius,
            {.title = "Radius at the top", .help = "0 makes a point.", .unit = "m", .at_least = 0});
  }
};

struct SphereParams : RoundPart {
  int rows = 32;
  template <class D>
  static void describe(D& d) {
    describe_round<SphereParams>(d);
    d.field("rows", &SphereParams::rows,
            {.title = "Rows", .help = "From pole to pole.", .at_least = 2, .at_most = 10000});
  }
};

struct TorusParams : RoundPart {
  double minor_radius = 0.25;
  int rows = 32;
  template <class D>
  static void describe(D& d) {
    describe_round<TorusParams>(d);
    d.field("minor_radius", &TorusParams::minor_radius,
            {.title = "Radius of the tube", .help = "Below the radius.", .unit = "m", .above = 0});
    d.field("rows", &TorusParams::rows,
            {.title = "Rows", .help = "Corners round the tube.", .at_least = 3, .at_most = 10000});
  }
};

struct HoleParams {
  std::vector<dobra::geom::Point> points;
  template <class D>
  static void describe(D& d) {
    d.field("points", &HoleParams::points,
            {.title = "Points",
             .help = "Corners of a closed contour.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
  }
};

/// A base of what moves a profile.
struct OfProfile : PlacedPart {
  std::vector<dobra::geom::Point> points;
  std::vector<HoleParams> holes;
  template <class P, class D>
  static void describe_profile(D& d) {
    describe_placed<P>(d);
    d.field("points", static_cast<std::vector<dobra::geom::Point> P::*>(&OfProfile::points),
            {.title = "Points",
             .help = "Corners of a closed contour.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
    d.tables("hole", static_cast<std::vector<HoleParams> P::*>(&OfProfile::holes),
             {.title = "Holes", .help = "Of the profile."});
  }
};

struct ExtrudeParams : OfProfile {
  dobra::geom::Point3 by{0.0, 0.0, 1.0};
  template <class D>
  static void describe(D& d) {
    describe_profile<ExtrudeParams>(d);
    d.field("by", &ExtrudeParams::by,
            {.title = "By (x, y, z)", .help = "How far the profile, which lies in z = 0, is moved.", .unit = "m"});
  }
};

struct SweepParams : OfProfile {
  std::vector<dobra::geom::Point3> path;
  template <class D>
  static void describe(D& d) {
    describe_profile<SweepParams>(d);
    d.field("path", &SweepParams::path,
            {.title = "Path",
             .help = "Points in space that the profile's origin moves along; corners are mitred.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
  }
};

struct RevolveParams : PlacedPart {
  std::vector<dobra::geom::Point> points;
  double angle = 360.0;
  int segments = 64;
  template <class D>
  static void describe(D& d) {
    describe_placed<RevolveParams>(d);
    d.field("points", &RevolveParams::points,
            {.title = "Points",
             .help = "Corners of a closed contour of (radius, z); sides on the axis make no faces.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
    d.field(
        "angle", &RevolveParams::angle,
        {.title = "Angle", .help = "In degrees about the z axis, anticlockwise from x.", .above = 0, .at_most = 360});
    d.field("segments", &RevolveParams::segments,
            {.title = "Segments", .help = "Over the whole angle.", .at_least = 1, .at_most = 10000});
  }
};

struct SolidFileParams : PlacedPart {
  std::string file;
  template <class D>
  static void describe(D& d) {
    describe_placed<SolidFileParams>(d);
    d.file("file", &SolidFileParams::file,
           {.title = "File",
            .help = "The boundary of a solid.",
            .files = {{"Boundaries of solids", dobra::io::formats::boundary_endings()}},
            .presence = dobra::scenario::Presence::Required});
  }
};

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
