#pragma once
// The space of a mesher that works in the chart of a surface (mesh/front/space.h says what a space is): orientation is
// decided exactly in the scaled chart, everything that is measured is measured in space. A vector of the tangent plane
// goes to the chart by the first fundamental form, from a place that is known: nothing is ever searched for over the
// whole surface. Page: docs/algorithms/surface_front.md.

#include <array>
#include <span>
#include <vector>

#include "shared/mesh/delaunay/filtered_predicates.h"
#include "shared/mesh/front/space.h"
#include "shared/surf/mesh/chart_sizes.h"
#include "shared/surf/mesh/scaled_chart.h"

namespace dobra::surf::mesh {

class ChartSpace final : public dobra::mesh::delaunay::DelaunayKernel::FlipRule {
 public:
  using Kernel = dobra::mesh::delaunay::DelaunayKernel;
  using Vertex = Kernel::Vertex;
  using Point = geom::Point3;
  using Vector = geom::Vector3;
  using Frame = geom::Vector3;  ///< The unit normal.
  using SizeField = dobra::mesh::sizing::SizeField;

  struct Place {
    Point at;
    geom::Point in_chart;
    Vector u, v;            ///< Derivatives there, or near it.
    bool grounded = false;  ///< `at`, u and v are of the surface at this place of the chart.
    [[nodiscard]] geom::Point chart() const { return in_chart; }
  };

  static constexpr bool curved = true;

  ChartSpace() = default;
  /// @pre all outlive the space.
  ChartSpace(const ScaledChart& chart, const ChartSizes& sizes, Kernel& kernel)
      : chart_(&chart), sizes_(&sizes), kernel_(&kernel) {}

  [[nodiscard]] Point at(Vertex v) const { return nodes_[v].at; }
  [[nodiscard]] Place place(Vertex v) const {
    return {nodes_[v].at, kernel_->point(v), nodes_[v].u(), nodes_[v].v(), true};
  }
  [[nodiscard]] Frame frame(Vertex v) const { return unit(cross(nodes_[v].u(), nodes_[v].v())); }
  [[nodiscard]] Frame frame(Vertex a, Vertex b) const {
    if (on_kink(a) || on_kink(b)) return normal(left_of_middle(a, b));
    return unit(geom::cross(nodes_[a].u() + nodes_[b].u(), nodes_[a].v() + nodes_[b].v()));
  }
  [[nodiscard]] Frame frame(Vertex a, Vertex b, Vertex c) const {
    return on_kink(a) ? normal(centroid(a, b, c)) : frame(a);
  }
  /// Of the surface in the middle of a triangle of the chart.
  [[nodiscard]] Frame frame_in_middle(Vertex a, Vertex b, Vertex c) const { return normal(centroid(a, b, c)); }

  static Vector cross(Vector a, Vector b) { return geom::cross(a, b); }
  static double cross(Frame normal, Vector a, Vector b) { return dot(normal, geom::cross(a, b)); }
  static Vector left_of(Frame normal, Vector a) { return geom::cross(normal, a); }
  static Vector to_centre(Frame /*normal*/, Vector u, Vector w, double uu, double ww, double /*twice*/) {
    const Vector area = geom::cross(u, w);
    return (ww * geom::cross(area, u) - uu * geom::cross(area, w)) / (2.0 * dot(area, area));
  }

  [[nodiscard]] Place between(Vertex a, Vertex b, double t) const;
  [[nodiscard]] Place beside(Vertex a, Vertex b, Vector by) const;
  [[nodiscard]] Place in_plane(Vertex a, Vertex b, Vertex c, Vector from_a) const;
  [[nodiscard]] static Place moved(const Place& from, Vector by) {
    const geom::Vector step = in_chart(from.u, from.v, by);
    return {from.at + step.x * from.u + step.y * from.v, from.in_chart + step, from.u, from.v};
  }
  /// @return false where the surface has no place or no normal, or the height is missed by more than a tenth.
  bool settle(Vertex a, Vertex b, double height, Place& place) const;
  bool ground(Place& place) const;
  static bool turns_left(geom::Point a, geom::Point b, geom::Point c) {
    return dobra::mesh::delaunay::filtered_orientation(a, b, c) == geom::Sign::Positive;
  }

  Vertex add(const Place& place) {
    announce(place);
    return kernel_->add_vertex(place.in_chart);
  }
  void announce(const Place& place) { nodes_.push_back(Node::of(place)); }
  void forget(std::size_t count) { nodes_.resize(count); }
  void move(Vertex v, const Place& place) {
    kernel_->move(v, place.in_chart);
    nodes_[v] = Node::of(place);
  }
  /// A node of the kernel that has none here yet: those come in order. @param at  where it is, on the surface or near
  /// it
  /// @param on_kink  the normal jumps there: what is wanted of a side or triangle is looked up on it
  void enter(Vertex v, Point at, bool on_kink = false);

  [[nodiscard]] dobra::mesh::front::LeafScale scale(dobra::mesh::sizing::QuadCellId leaf) const {
    return sizes_->scale[leaf.index()];
  }
  [[nodiscard]] bool same_sheet(const Place& place, Vertex v, double distance) const;
  static double to_side(Point from, Point to, Point p);
  [[nodiscard]] double estimated_triangles(const SizeField& field) const;
  /// About how many triangles there will be, those of the domain only.
  [[nodiscard]] double expected_triangles() const;
  std::size_t make_room(const SizeField& field, const dobra::mesh::front::FrontalOptions& options);

  [[nodiscard]] ChartSpace part(Kernel& kernel, std::span<const Vertex> node) const;
  Vertex take(const ChartSpace& part, Vertex v) {
    nodes_.push_back(part.nodes_[v]);
    return kernel_->add_vertex(part.kernel_->point(v));
  }
  /// While cells are large beside the bends of the surface: the chart decides of those over which it turns.
  void coarse() { coarse_ = true; }
  /// Whether a side is flipped too where less of the area beside it looks against the surface afterwards, by a tenth
  /// at least.
  void favour_unfolded(bool yes) { unfolding_ = yes; }
  /// Makes the kernel flip sides by this space's rule.
  void rule() { kernel_->set_rule(this); }
  [[nodiscard]] bool flips(Vertex a, Vertex b, Vertex c, Vertex d) const override;
  /// Whether the normals at two of the corners differ by more than 60 degrees: chords are no measure of the surface
  /// then.
  [[nodiscard]] bool turns(Vertex a, Vertex b, Vertex c) const;
  /// The area of a triangle that looks against the normals at its corners, as these see it, m2; 0 of others, and on
  /// kinks, where there are none.
  [[nodiscard]] double folded_area(Vertex a, Vertex b, Vertex c) const;

 private:
  /// What is kept of a node: derivatives need not be exact, what must be so is decided in the chart.
  struct Node {
    Point at;
    std::array<float, 6> tangents{};
    static Node of(const Place& p) {
      const auto f = [](double x) { return static_cast<float>(x); };
      return {p.at, {f(p.u.x), f(p.u.y), f(p.u.z), f(p.v.x), f(p.v.y), f(p.v.z)}};
    }
    [[nodiscard]] Vector u() const { return {tangents[0], tangents[1], tangents[2]}; }
    [[nodiscard]] Vector v() const { return {tangents[3], tangents[4], tangents[5]}; }
  };

  /// Newton's steps from a place to the one at that distance from the middle of a side, over it.
  bool approach(Vertex a, Vertex b, double height, Place& place) const;
  [[nodiscard]] bool on_kink(Vertex v) const { return v < on_kink_.size() && on_kink_[v] != 0; }
  [[nodiscard]] geom::Point left_of_middle(Vertex a, Vertex b) const;
  [[nodiscard]] geom::Point centroid(Vertex a, Vertex b, Vertex c) const;
  [[nodiscard]] Frame normal(geom::Point in_chart) const;
  static Vector unit(Vector a) { return a / std::sqrt(dot(a, a)); }
  /// The step of the chart that a vector's part in the tangent plane is.
  static geom::Vector in_chart(Vector u, Vector v, Vector by) {
    const double e = dot(u, u), f = dot(u, v), g = dot(v, v);
    const double det = e * g - f * f;
    const double along_u = dot(by, u), along_v = dot(by, v);
    return {(g * along_u - f * along_v) / det, (e * along_v - f * along_u) / det};
  }

  const ScaledChart* chart_ = nullptr;
  const ChartSizes* sizes_ = nullptr;
  Kernel* kernel_ = nullptr;
  std::vector<Node> nodes_;
  std::vector<std::uint8_t> on_kink_;  ///< Up to the last of those; none where the surface has no kink.
  bool whole_ = true;                  ///< Not a part.
  bool coarse_ = false;
  bool unfolding_ = false;
  mutable std::size_t by_chart_ = 0;  ///< Flips that the chart decided.
};

}  // namespace dobra::surf::mesh
