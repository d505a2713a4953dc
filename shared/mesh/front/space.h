#pragma once
// The space in which a mesher measures. Every node has a place in a chart, where orientation is decided exactly and
// where the kernel keeps it, and a place in space, where lengths, angles and circles are judged. In the plane the two
// are the same; on a surface they are not (shared/surf/mesh/chart_space.h). The front, the filling of gaps, the placing
// of points and the smoothing are templates on it. This page is what such a space has.
// Page: docs/algorithms/advancing_front.md.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "shared/geom/segment.h"
#include "shared/mesh/front/fill_engine.h"

namespace dobra::mesh::front {

/// How a step of length 1 in space looks in the chart, in a leaf of the tree of sizes.
struct LeafScale {
  double mean = 1.0;                    ///< Its length there, the mean over all directions.
  double reach_u = 1.0, reach_v = 1.0;  ///< Most that it goes along u and v.
};

/// The plane: the chart is the space.
class Plane {
 public:
  using Kernel = delaunay::DelaunayKernel;
  using Vertex = Kernel::Vertex;
  using Point = geom::Point;    ///< In space.
  using Vector = geom::Vector;  ///< In space; has dot, + and -.
  struct Frame {};              ///< How the tangent plane lies at a node.

  /// Where a node may come to be.
  struct Place {
    Point at;
    [[nodiscard]] geom::Point chart() const { return at; }
  };

  /// Whether the chart is not the space: then new places must be settled, and the orientation of triangles be asked.
  static constexpr bool curved = false;

  Plane() = default;
  explicit Plane(Kernel& kernel) : kernel_(&kernel) {}

  [[nodiscard]] Point at(Vertex v) const { return kernel_->point(v); }
  [[nodiscard]] Place place(Vertex v) const { return {at(v)}; }
  [[nodiscard]] Frame frame(Vertex /*v*/) const { return {}; }
  [[nodiscard]] Frame frame(Vertex /*a*/, Vertex /*b*/) const { return {}; }  ///< To the left of the side from a to b.
  [[nodiscard]] Frame frame(Vertex /*a*/, Vertex /*b*/, Vertex /*c*/) const { return {}; }

  /// Of two vectors in the tangent plane: positive when the second is anticlockwise of the first.
  static double cross(Frame /*frame*/, Vector a, Vector b) { return geom::cross(a, b); }
  static Vector left_of(Frame /*frame*/, Vector a) { return geom::left_of(a); }
  /// From the corner of a triangle with the sides u and w to the centre of its circle. @param twice  cross(u, w)
  static Vector to_centre(Frame /*frame*/, Vector u, Vector w, double uu, double ww, double twice) {
    return {(w.y * uu - u.y * ww) / (2.0 * twice), (u.x * ww - w.x * uu) / (2.0 * twice)};
  }

  /// At the fraction t of the side from a to b.
  [[nodiscard]] Place between(Vertex a, Vertex b, double t) const { return {geom::interpolate(at(a), at(b), t)}; }
  /// The middle of the side from a to b, moved by a vector of its tangent plane.
  [[nodiscard]] Place beside(Vertex a, Vertex b, Vector by) const { return {geom::midpoint(at(a), at(b)) + by}; }
  /// A place of the plane of a triangle.
  [[nodiscard]] Place in_plane(Vertex a, Vertex /*b*/, Vertex /*c*/, Vector from_a) const { return {at(a) + from_a}; }
  /// Moved by a vector of its tangent plane.
  [[nodiscard]] static Place moved(const Place& from, Vector by) { return {from.at + by}; }
  /// Puts a place beside a side where it belongs: at the same distance from the middle of the side, over it.
  /// @return whether there is such a place.
  bool settle(Vertex /*a*/, Vertex /*b*/, double /*height*/, Place& /*place*/) const { return true; }
  /// Puts a place on the surface that has only one in the chart. @return whether there is one.
  bool ground(Place& /*place*/) const { return true; }
  /// Whether three places turn left in the chart, where that does not follow from their angles.
  static bool turns_left(geom::Point /*a*/, geom::Point /*b*/, geom::Point /*c*/) { return true; }

  /// A node at the place; for a node that the kernel makes itself (`insert`), `announce` it first.
  Vertex add(const Place& place) { return kernel_->add_vertex(place.at); }
  void announce(const Place& /*place*/) {}
  /// The nodes from number `count` on are no more.
  void forget(std::size_t /*count*/) {}
  void move(Vertex v, const Place& place) { kernel_->move(v, place.at); }

  static LeafScale scale(sizing::QuadCellId /*leaf*/) { return {}; }
  /// Whether a node that is near a place in space is so on the surface too.
  static bool same_sheet(const Place& /*place*/, Vertex /*v*/, double /*distance*/) { return true; }

  /// From a side to a place, m.
  static double to_side(Point from, Point to, Point p) { return geom::distance(geom::Segment{from, to}, p); }
  /// Triangles of the square of the tree of sizes.
  static double estimated_triangles(const sizing::SizeField& field) { return field.estimated_triangles(); }
  std::size_t make_room(const sizing::SizeField& field, const FrontalOptions& options) {
    return front::make_room(*kernel_, field, options);
  }

  /// The same space for the nodes of another kernel, which are nodes of this one. @param node  one a vertex of it.
  [[nodiscard]] Plane part(Kernel& kernel, std::span<const Vertex> /*node*/) const { return Plane(kernel); }
  /// Takes over a node from a part. @return its number here
  Vertex take(const Plane& part, Vertex v) { return kernel_->add_vertex(part.at(v)); }

 private:
  Kernel* kernel_ = nullptr;
};

}  // namespace dobra::mesh::front
