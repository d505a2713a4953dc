#pragma once
// Boundary models in OCCT's text format (.brep), versions 1 to 3, as the file has them: geometry in tables, shapes that
// use shapes. What is of no use to a mesher (polygons, triangulations, regularities) is read over and counted.
// Source: [opencascade2021].

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point.h"
#include "shared/io/brep/placement.h"

namespace dobra::io::brep {

struct Curve;
struct Surface;
using CurvePtr = std::shared_ptr<const Curve>;
using SurfacePtr = std::shared_ptr<const Surface>;

struct Line {
  geom::Point3 at;
  geom::Vector3 along;
};
/// at + f(t) x + g(t) y with (f, g) = (a cos t, b sin t) for a circle and an ellipse, (a cosh t, b sinh t) for a
/// hyperbola, (t^2 / (4 a), t) for a parabola.
struct Conic {
  enum class Kind { Circle, Ellipse, Parabola, Hyperbola } kind = Kind::Circle;
  geom::Point3 at;
  geom::Vector3 x, y;
  double a = 0.0;  ///< Radius, greater half axis, or focal length.
  double b = 0.0;  ///< Smaller half axis; of a circle as a.
};
/// Knots as often as they stand; Bezier's curves have them too. What is periodic is written out, its first control
/// points again at the end.
struct Spline {
  std::size_t degree = 0;
  std::vector<double> knots;
  std::vector<geom::Point3> points;
  std::vector<double> weights;  ///< Empty: all 1.
};
struct TrimmedCurve {
  double from = 0.0, to = 0.0;
  CurvePtr of;
};
/// Moved by `distance` along tangent x direction; in the plane to the right of the tangent.
struct OffsetCurve {
  double distance = 0.0;
  geom::Vector3 direction{0.0, 0.0, 1.0};
  CurvePtr of;
};
/// In space, or in a chart with z = 0.
struct Curve {
  std::variant<Line, Conic, Spline, TrimmedCurve, OffsetCurve> is;
};

/// In the parameters that the format gives them, lengths in the unit of the file, angles in radians.
struct Elementary {
  enum class Kind { Plane, Cylinder, Cone, Sphere, Torus } kind = Kind::Plane;
  geom::Point3 at;
  geom::Vector3 z, x, y;  ///< The axis first.
  double radius = 0.0;
  double other = 0.0;  ///< A torus's smaller radius, a cone's half angle.
};
struct Extrusion {
  geom::Vector3 along;
  CurvePtr of;
};
struct Revolution {
  geom::Point3 at;
  geom::Vector3 axis;
  CurvePtr of;
};
/// As Spline; v runs fastest.
struct SplinePatch {
  std::size_t degree_u = 0, degree_v = 0;
  std::vector<double> knots_u, knots_v;
  std::vector<geom::Point3> points;
  std::vector<double> weights;
};
struct TrimmedPatch {
  geom::Point low, high;
  SurfacePtr of;
};
struct OffsetPatch {
  double distance = 0.0;
  SurfacePtr of;
};
struct Surface {
  std::variant<Elementary, Extrusion, Revolution, SplinePatch, TrimmedPatch, OffsetPatch> is;
};

enum class Orientation : std::uint8_t { Forward, Reversed, Internal, External };
/// Of a part in what is oriented so itself.
Orientation operator*(Orientation whole, Orientation part);

/// Number of a table of Model, from 0.
using Index = std::size_t;

/// A shape as another one uses it.
struct Use {
  Orientation orientation = Orientation::Forward;
  Index shape = 0;
  Placement placement;
};
struct Vertex {
  geom::Point3 at;
};
/// A curve in the chart of a surface.
struct ChartCurve {
  Index curve = 0;                ///< Of Model::chart_curves.
  std::optional<Index> reversed;  ///< The one of the reversed edge, where the surface closes on itself there.
  Index surface = 0;
  Placement placement;
  double from = 0.0, to = 0.0;
};
struct SpaceCurve {
  Index curve = 0;  ///< Of Model::curves.
  Placement placement;
  double from = 0.0, to = 0.0;
};
struct Edge {
  bool degenerated = false;  ///< One point in space.
  std::optional<SpaceCurve> curve;
  std::vector<ChartCurve> chart_curves;
};
struct Face {
  std::optional<Index> surface;  ///< None: triangles alone.
  Placement placement;
  bool natural = false;  ///< Bounded by the sides of the surface's own chart.
};
enum class ShapeKind : std::uint8_t { Vertex, Edge, Wire, Face, Shell, Solid, CompSolid, Compound };
struct Shape {
  ShapeKind kind = ShapeKind::Compound;
  double tolerance = 0.0;                               ///< Of a vertex, an edge or a face, in the unit of the file.
  std::variant<std::monostate, Vertex, Edge, Face> is;  ///< By the kind.
  std::vector<Use> parts;                               ///< Shapes of lower numbers.
  std::size_t line = 0;                                 ///< Where it begins in the file.
};

/// A whole file.
struct Model {
  std::string file;
  int version = 1;
  std::vector<CurvePtr> chart_curves, curves;
  std::vector<SurfacePtr> surfaces;
  std::vector<Shape> shapes;
  Use root;
  std::size_t triangulations = 0;  ///< Passed over.
};

/// @error BadFormat, NotFinite with line and column: another format (a binary or an XML one is named), a version that
///        is not known, a table that ends before its count, a number of a table that is not there, knots and counts
///        that do not fit, shapes of the wrong kind.
base::Result<Model> parse_brep(std::string_view text, const std::string& file);
/// @error those of io::read_text and parse_brep
base::Result<Model> read_brep(const std::string& path);

}  // namespace dobra::io::brep
