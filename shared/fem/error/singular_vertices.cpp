#include "shared/fem/error/singular_vertices.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "shared/fem/constraints.h"
#include "shared/fem/error/exact_fields.h"

namespace dobra::fem::error {
namespace {

using geom::Vector;
using mesh::ElementMesh;
using std::numbers::pi;

/// Interior angles above this are corners where the stresses are infinite, and not a curve followed by sides.
constexpr double least_corner = 210.0 * pi / 180.0;
/// An exponent nearer to 1 than this makes no difference to the sizes.
constexpr double hardly_singular = 0.95;
/// Free corners below this are corners and not a curve followed by sides.
constexpr double most_pointed = 150.0 * pi / 180.0;
/// The lips of a tip may be open by this much, radians.
constexpr double closed_tip = 0.1;
/// Sine of the angle between directions that count as the same.
constexpr double same_direction = 1e-6;

using Face = CornerFace;

/// The directions along which supports hold a node: none, one, or two (any).
using Holds = std::map<std::size_t, std::vector<Vector>>;

Holds holds_of(const ElementMesh& mesh, const Problem& problem) {
  Holds holds;
  for (const DofConstraint& constraint : constraints_of(mesh, problem)) {
    const std::size_t node = constraint.terms.front().first / 2;
    Vector direction;
    bool own = true;
    for (const auto& [dof, coefficient] : constraint.terms) {
      own = own && dof / 2 == node;
      (dof % 2 == 0 ? direction.x : direction.y) += coefficient;
    }
    if (!own || length(direction) == 0.0) continue;
    direction = normalised(direction);
    auto& known = holds[node];
    if (std::none_of(known.begin(), known.end(),
                     [&](Vector v) { return std::abs(cross(v, direction)) < same_direction; }))
      known.push_back(direction);
  }
  return holds;
}

/// How a side is held: all its nodes are, or it is free. A support at one point holds no side.
Face face_of(const Holds& holds, std::span<const mesh::NodeId> nodes, Vector along) {
  Face face = Face::Clamped;
  for (const mesh::NodeId node : nodes) {
    if (!node.valid()) continue;
    const auto held = holds.find(node.index());
    if (held == holds.end()) return Face::Free;
    if (held->second.size() > 1) continue;
    // Held along one direction only: across the face that is a roller; along it nothing of the kind.
    if (std::abs(dot(held->second.front(), along)) > same_direction * length(along)) return Face::Free;
    face = Face::Roller;
  }
  return face;
}

}  // namespace

double clamped_corner_exponent(base::Angle interior, const Material& material) {
  const double w = interior.radians();
  const double kappa = kolosov(material);
  const double sine = std::sin(w);
  const auto f = [&](double l) {
    const double s = std::sin(l * w);
    return 4.0 * kappa * s * s - (kappa + 1.0) * (kappa + 1.0) + 4.0 * l * l * sine * sine;
  };
  // f(0) < 0, and it rises up to the first root.
  constexpr int steps = 1000;
  for (int i = 1; i <= steps; ++i) {
    if (f(static_cast<double>(i) / steps) < 0.0) continue;
    double low = static_cast<double>(i - 1) / steps;
    double high = static_cast<double>(i) / steps;
    while (high - low > 1e-15) {
      const double middle = 0.5 * (low + high);
      if (middle == low || middle == high) break;
      (f(middle) < 0.0 ? low : high) = middle;
    }
    return high;
  }
  return 1.0;
}

namespace {

/// A node of the boundary with its two sides.
struct Corner {
  Vector in;
  Vector out;
  Face face_in = Face::Free;
  Face face_out = Face::Free;
  const Material* material = nullptr;
};

std::map<mesh::NodeId, Corner> corners_of(const ElementMesh& mesh, const Problem& problem) {
  const Holds holds = holds_of(mesh, problem);
  std::map<mesh::NodeId, Corner> corners;
  for (const mesh::ElementSide side : boundary_sides(mesh)) {
    const auto nodes = side_nodes(mesh, side);
    const auto [from, to, middle] = nodes;
    const auto towards = [&, mid = middle](mesh::NodeId a, mesh::NodeId b) {
      // The tangent at a of the parabola a, middle, b; of a straight side, or one with a quarter point at a, the chord.
      const Vector chord = mesh.point(b) - mesh.point(a);
      if (!mid.valid()) return chord;
      const Vector tangent = 4.0 * (mesh.point(mid) - mesh.point(a)) - chord;
      return length(tangent) > closed_tip * length(chord) ? tangent : chord;
    };
    Corner& first = corners[from];
    first.out = towards(from, to);
    first.face_out = face_of(holds, nodes, first.out);
    first.material = &problem.materials.at(mesh.regions[side.element.index()]);
    Corner& last = corners[to];
    last.in = towards(to, from);
    last.face_in = face_of(holds, nodes, last.in);
  }
  return corners;
}

/// From `out` anticlockwise to `in`, radians: the material lies on the left of the boundary. The lips of a tip leave a
/// whole turn.
double interior_of(const Corner& corner, bool tip) {
  const double angle = std::atan2(cross(corner.out, corner.in), dot(corner.out, corner.in));
  return angle <= (tip ? closed_tip : 0.0) ? angle + 2.0 * pi : angle;
}

SingularVertex vertex_of(mesh::NodeId node, const Corner& corner, double exponent, double angle) {
  return {node, exponent, normalised(corner.out), base::Angle::from_radians(angle), corner.face_out, corner.face_in};
}

}  // namespace

std::vector<SingularVertex> singular_vertices(const ElementMesh& mesh, const Problem& problem) {
  std::vector<SingularVertex> singular;
  std::set<mesh::NodeId> tips;
  for (const mesh::CrackTip& tip : mesh.tips) tips.insert(tip.node);
  for (const auto& [node, corner] : corners_of(mesh, problem)) {
    if (corner.material == nullptr) continue;
    const bool tip = tips.contains(node);
    const double angle = interior_of(corner, tip);
    double exponent = tip ? 0.5 : 1.0;
    const auto [weak, strong] = std::minmax(corner.face_in, corner.face_out);
    if (tip) {
      // 0.5, whatever the lips carry
    } else if (weak == Face::Free && strong == Face::Clamped) {
      exponent = clamped_corner_exponent(base::Angle::from_radians(angle), *corner.material);
    } else if (weak == Face::Free && strong == Face::Roller) {
      if (2.0 * angle > least_corner)
        exponent = corner_exponent(base::Angle::from_radians(std::min(2.0 * angle, 2.0 * pi)));
    } else if (angle > least_corner) {
      exponent = corner_exponent(base::Angle::from_radians(angle));
    }
    if (exponent < hardly_singular) singular.push_back(vertex_of(node, corner, exponent, angle));
  }
  return singular;
}

std::vector<SingularVertex> free_corners(const ElementMesh& mesh, const Problem& problem) {
  std::vector<SingularVertex> found;
  std::set<mesh::NodeId> tips;
  for (const mesh::CrackTip& tip : mesh.tips) tips.insert(tip.node);
  for (const auto& [node, corner] : corners_of(mesh, problem)) {
    if (tips.contains(node) || corner.material == nullptr || corner.face_in != Face::Free ||
        corner.face_out != Face::Free)
      continue;
    const double angle = interior_of(corner, false);
    if (angle < most_pointed) found.push_back(vertex_of(node, corner, 1.0, angle));
  }
  return found;
}

}  // namespace dobra::fem::error
