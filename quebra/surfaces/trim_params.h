#pragma once
// [[input.trim]], [[input.part]] and [[input.surface_point]]: lines in the chart of a surface, the parts that are
// meant, and points. Charts are written in degrees and lengths, as the ranges of their surface.

#include <optional>
#include <string>
#include <vector>

#include "quebra/surfaces/surface_params.h"

namespace quebra::surfaces {

enum class TrimKind { Line, Polygon, Circle, Ellipse, Arc, Spline, Bezier, Surface, Plane };
enum class TrimRole { Hole, Outline, Cut, Internal, Interface, Crack };
/// It has an inside.
inline bool is_loop(TrimRole role) { return role == TrimRole::Hole || role == TrimRole::Outline; }

struct TrimParams {
  std::string name, surface;
  TrimKind kind = TrimKind::Line;
  TrimRole role = TrimRole::Hole;
  std::vector<dobra::geom::Point> points;
  std::optional<dobra::geom::Point> centre;
  std::optional<double> radius;
  std::vector<double> radii;
  dobra::base::Angle rotation = dobra::base::Angle::from_degrees(0.0);
  std::string tool;
  std::optional<dobra::geom::Point3> at, normal;
  double tip_size = 0.0;
  std::vector<double> bands;
  double rosette = 0.0;
  int sectors = 8;

  template <class D>
  static void describe(D& d) {
    d.field("name", &TrimParams::name,
            {.title = "Name",
             .help = "Of the set of its sides; a crack NAME has the lips NAME_left and NAME_right and the ends "
                     "NAME_start and NAME_end.",
             .presence = dobra::scenario::Presence::Required});
    d.field("surface", &TrimParams::surface,
            {.title = "Surface", .help = "On which it lies; may be left out where one is meshed.", .names = "surface"});
    d.choice("kind", &TrimParams::kind,
             {"line", "polygon", "circle", "ellipse", "arc", "spline", "bezier", "surface", "plane"},
             {.title = "Kind",
              .help = "In the chart: line (a chain), polygon, circle, ellipse, arc (three points), spline, bezier (one "
                      "of any degree). In space: where another surface or a plane cuts it."});
    d.choice("role", &TrimParams::role, {"hole", "outline", "cut", "internal", "interface", "crack"},
             {.title = "Role",
              .help = "hole: what lies inside is taken away; outline: what lies outside; cut: divides, and parts say "
                      "what stays; internal: sides of the mesh lie along it; interface: between two regions; crack: "
                      "the mesh is opened along it."});
    d.field("points", &TrimParams::points,
            {.title = "Points (u, v)",
             .help = "Of the chart. An arc has three: first, one on the way, last.",
             .when = "kind in line, polygon, arc, spline, bezier"});
    d.field("centre", &TrimParams::centre,
            {.title = "Centre (u, v)", .help = "Of the chart.", .when = "kind in circle, ellipse"});
    d.field("radius", &TrimParams::radius,
            {.title = "Radius", .help = "In the numbers of the chart.", .above = 0, .when = "kind = circle"});
    d.field("radii", &TrimParams::radii,
            {.title = "Half axes", .help = "Two, in the numbers of the chart.", .above = 0, .when = "kind = ellipse"});
    d.field("rotation", &TrimParams::rotation,
            {.title = "Rotation", .help = "Of the first half axis from u.", .unit = "deg", .when = "kind = ellipse"});
    d.field("tool", &TrimParams::tool,
            {.title = "Cut by", .help = "Name of the other surface.", .names = "surface", .when = "kind = surface"});
    d.field("at", &TrimParams::at, {.title = "Point of the plane (x, y, z)", .unit = "m", .when = "kind = plane"});
    d.field("normal", &TrimParams::normal, {.title = "Normal of the plane", .when = "kind = plane"});
    d.field("tip_size", &TrimParams::tip_size,
            {.title = "Size at the ends",
             .help = "Length of the element sides at both ends of a crack; 0: none of their own.",
             .unit = "m",
             .at_least = 0,
             .when = "role = crack"});
    d.field("bands", &TrimParams::bands,
            {.title = "Distances of bands",
             .help = "Of lines round a crack, along which the mesh has sides: lengths in space from the crack.",
             .unit = "m",
             .above = 0,
             .when = "role = crack"});
    d.field("rosette", &TrimParams::rosette,
            {.title = "Radius of rosettes",
             .help = "Of a ring of triangles round each end of a crack inside, a length in space; the size of elements "
                     "there unless another is given; 0: no ring.",
             .unit = "m",
             .at_least = 0,
             .when = "role = crack"});
    d.field("sectors", &TrimParams::sectors,
            {.title = "Sectors", .help = "Of a rosette.", .at_least = 5, .at_most = 60, .when = "role = crack"});
  }
};

enum class PartFate { Keep, Drop };

/// A part of a surface, by a place in it.
struct PartParams {
  std::string surface, name;
  PartFate fate = PartFate::Keep;
  std::optional<dobra::geom::Point> at;
  std::optional<dobra::geom::Point3> place;

  template <class D>
  static void describe(D& d) {
    d.field("surface", &PartParams::surface,
            {.title = "Surface", .help = "May be left out where one is meshed.", .names = "surface"});
    d.choice("fate", &PartParams::fate, {"keep", "drop"},
             {.title = "It", .help = "keep: once a part of a surface is kept, those that are not named are dropped."});
    d.field("at", &PartParams::at, {.title = "Place (u, v)", .help = "Anywhere in the part, in the chart; or:"});
    d.field(
        "place", &PartParams::place,
        {.title = "Place (x, y, z)", .help = "Anywhere in the part, in space; the nearest point counts.", .unit = "m"});
    d.field("name", &PartParams::name, {.title = "Region", .help = "Name of its elements' region."});
  }
};

struct SurfacePointParams {
  std::string name, surface;
  std::optional<dobra::geom::Point> at;
  std::optional<dobra::geom::Point3> place;
  double size = 0.0;

  template <class D>
  static void describe(D& d) {
    d.field(
        "name", &SurfacePointParams::name,
        {.title = "Name", .help = "Of the set that holds its node.", .presence = dobra::scenario::Presence::Required});
    d.field("surface", &SurfacePointParams::surface,
            {.title = "Surface", .help = "May be left out where one is meshed.", .names = "surface"});
    d.field("at", &SurfacePointParams::at, {.title = "Place (u, v)", .help = "In the chart; or:"});
    d.field("place", &SurfacePointParams::place,
            {.title = "Place (x, y, z)", .help = "In space; the nearest point of the surface counts.", .unit = "m"});
    d.field("size", &SurfacePointParams::size,
            {.title = "Size", .help = "Of the elements there; 0: no wish.", .unit = "m", .at_least = 0});
  }
};

/// The curve of a trim that is drawn in the chart, its written numbers times the scales; z = 0. Circles and ellipses
/// run anticlockwise there.
/// @error BadValue: what its kind needs is missing, in the words of the keys; those of the makers of surf::Curve.
dobra::base::Result<dobra::surf::Curve> make_trim_curve(const TrimParams& params, ChartUnits units);
/// Whether the curve ends where it begins.
bool is_closed(const TrimParams& params);

}  // namespace quebra::surfaces
