#pragma once
// The parameters of the steps that make parts by a few numbers, or of a file; what those of all parts have in common.

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

}  // namespace quebra::solids
