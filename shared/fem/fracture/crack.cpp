#include "shared/fem/fracture/crack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "shared/fem/assemble.h"
#include "shared/fem/error/exact_fields.h"

namespace dobra::fem::fracture {
namespace {

using base::Error;
using base::ErrorCode;
using geom::Point;
using geom::Vector;
using mesh::ElementMesh;
using std::numbers::pi;

/// How far a lip may stray from a straight line, and a quarter point from its place, as a fraction of the length.
constexpr double straightness = 1e-6;
/// Lips overlap, and K_I closes, by more than this fraction of the rest: less is noise of the mesh.
constexpr double noise = 1e-3;

double distance_to(Point p, Point a, Point b) {
  const double t = std::clamp(dot(p - a, b - a) / length_squared(b - a), 0.0, 1.0);
  return distance(p, a + t * (b - a));
}

bool is_quarter(const ElementMesh& mesh, mesh::ElementSide side, mesh::NodeId tip) {
  const auto [from, to, middle] = side_nodes(mesh, side);
  if (!middle.valid()) return false;
  const Point at = mesh.point(tip);
  const Point far = mesh.point(from == tip ? to : from);
  return distance(mesh.point(middle), geom::interpolate(at, far, 0.25)) < straightness * distance(at, far);
}

/// Regions may differ in name only.
bool same_material(const ElementMesh& mesh, const Materials& materials, std::size_t a, std::size_t b) {
  return mesh.regions[a] == mesh.regions[b] || materials.at(mesh.regions[a]) == materials.at(mesh.regions[b]);
}

/// What lies round the tips: boundary sides and interfaces of materials.
struct Surroundings {
  std::vector<mesh::ElementSide> boundary;
  std::vector<mesh::ElementSide> interfaces;
};

Surroundings surroundings_of(const ElementMesh& mesh, const Materials& materials) {
  Surroundings result;
  const auto neighbours = neighbours_of(mesh);
  std::size_t at = 0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (std::uint32_t i = 0; i < mesh::corner_count(mesh.types[e]); ++i, ++at) {
      const mesh::ElementSide side{mesh::ElementId(e), i};
      if (!neighbours[at].element.valid()) {
        result.boundary.push_back(side);
      } else if (!same_material(mesh, materials, neighbours[at].element.index(), e)) {
        result.interfaces.push_back(side);
      }
    }
  }
  return result;
}

double room_of(const ElementMesh& mesh, const TipFrame& frame, const Surroundings& around) {
  double room = std::numeric_limits<double>::infinity();
  const auto limit = [&](const mesh::ElementSide& side) {
    const auto nodes = side_nodes(mesh, side);
    room = std::min(room, distance_to(frame.at, mesh.point(nodes[0]), mesh.point(nodes[1])));
  };
  const auto on_crack = [&](mesh::NodeId node) {
    const Vector v = frame.local(mesh.point(node) - frame.at);
    return (v.x <= 0.0 || frame.lips != Lips::Both) && std::abs(v.y) <= straightness * (std::abs(v.x) + frame.length);
  };
  for (const auto& side : around.boundary) {
    const auto nodes = side_nodes(mesh, side);
    if (!on_crack(nodes[0]) || !on_crack(nodes[1])) limit(side);
  }
  for (const auto& side : around.interfaces) limit(side);
  for (const mesh::CrackTip& other : mesh.tips) {
    if (other.node != frame.tip.node) room = std::min(room, distance(frame.at, mesh.point(other.node)));
  }
  return room;
}

base::Result<TipFrame> frame_of(const ElementMesh& mesh, const Materials& materials, const mesh::CrackTip& tip,
                                const Surroundings& around) {
  TipFrame frame{.tip = tip, .at = mesh.point(tip.node)};
  for (const auto& side : around.boundary) {
    const auto nodes = side_nodes(mesh, side);
    if (nodes[1] == tip.node) frame.left = side;
    if (nodes[0] == tip.node) frame.right = side;
  }
  if (!frame.left.element.valid() || !frame.right.element.valid())
    return bad_tip(frame, "no lips end here; a tip must lie inside the material, and the crack have double nodes");
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.nodes_of(mesh::ElementId(e));
    if (std::find(nodes.begin(), nodes.end(), tip.node) == nodes.end()) continue;
    if (!same_material(mesh, materials, e, frame.left.element.index()))
      return bad_tip(frame, "two materials meet at the tip; the intensity factors of an interface are not known here");
  }
  Point left = mesh.point(side_nodes(mesh, frame.left)[0]);
  Point right = mesh.point(side_nodes(mesh, frame.right)[1]);
  const bool left_ahead = dot(left - frame.at, tip.direction) > 0.0;
  const bool right_ahead = dot(right - frame.at, tip.direction) > 0.0;
  if (left_ahead != right_ahead) {  // one lip, and the line of symmetry ahead
    frame.lips = right_ahead ? Lips::OnlyLeft : Lips::OnlyRight;
    if (left_ahead) {
      std::swap(frame.left, frame.right);
      std::swap(left, right);
    }
    right = frame.at - (right - frame.at);
  }
  frame.length = distance(left, frame.at);
  frame.tip.direction = normalised((frame.at - left) + (frame.at - right));
  for (const Point p : {left, right}) {
    if (std::abs(frame.local(p - frame.at).y) > straightness * frame.length)
      return bad_tip(frame, frame.lips == Lips::Both ? "the lips do not end in one straight line"
                                                     : "the line of symmetry does not go straight on ahead of the lip");
  }
  frame.material = materials.at(mesh.regions[frame.left.element.index()]);
  frame.quarter = is_quarter(mesh, frame.left, tip.node) && is_quarter(mesh, frame.right, tip.node);
  frame.room = room_of(mesh, frame, around);
  return frame;
}

/// Openings (y) and slidings (x) between the lips in the frame of the tip; none in the middle of sides of first order.
struct Openings {
  Vector corner;
  Vector middle;
};

Openings openings_of(const ElementMesh& mesh, const TipFrame& frame, std::span<const Vector> u) {
  const auto left = side_nodes(mesh, frame.left);
  const auto right = side_nodes(mesh, frame.right);
  if (frame.lips != Lips::Both) {
    const auto opening = [&](mesh::NodeId node) {
      if (!node.valid()) return Vector{};
      return Vector{0.0, 2.0 * frame.local(u[node.index()] - u[frame.tip.node.index()]).y};
    };
    return {opening(left[0] == frame.tip.node ? left[1] : left[0]), opening(left[2])};
  }
  const Vector corner = frame.local(u[left[0].index()] - u[right[1].index()]);
  if (!left[2].valid()) return {corner, {}};
  return {corner, frame.local(u[left[2].index()] - u[right[2].index()])};
}

/// The side that runs straight ahead from the tip, of the element on its left, or of the only one.
std::optional<mesh::ElementSide> side_ahead(const ElementMesh& mesh, const TipFrame& frame) {
  if (frame.lips != Lips::Both) return frame.right;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (std::uint32_t i = 0; i < mesh::corner_count(mesh.types[e]); ++i) {
      const mesh::ElementSide side{mesh::ElementId(e), i};
      const auto nodes = side_nodes(mesh, side);
      if (nodes[0] != frame.tip.node) continue;
      const Vector v = frame.local(mesh.point(nodes[1]) - frame.at);
      if (v.x > 0.0 && std::abs(v.y) < straightness * v.x) return side;
    }
  }
  return std::nullopt;
}

/// What the elements on the left of the crack's line bear at their nodes less the loads on their sides, N, one a node.
std::vector<Vector> forces_from_left(const ElementMesh& mesh, const Problem& problem, const LoadCase& load,
                                     const TipFrame& frame, std::span<const Vector> u) {
  std::vector<Vector> forces(mesh.points.size());
  std::vector<bool> chosen(mesh.element_count(), false);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const ElementGeometry element = geometry_of(mesh, e);
    const auto own = std::span(element.nodes).first(element.count);
    const bool at_tip = std::find(own.begin(), own.end(), frame.tip.node.index()) != own.end();
    Vector middle;
    for (std::size_t i = 0; i < mesh::corner_count(element.type); ++i)
      middle = middle + frame.local(element.coordinates[i] - frame.at);
    if (!at_tip || middle.y < 0.0) continue;
    chosen[e] = true;
    std::array<std::array<double, 4>, 36> blocks;
    element_stiffness(element, problem.materials.at(mesh.regions[e]),
                      std::span(blocks).first(element.count * (element.count + 1) / 2));
    std::size_t k = 0;
    for (std::size_t a = 0; a < element.count; ++a) {
      for (std::size_t b = a; b < element.count; ++b, ++k) {
        const auto& [xx, xy, yx, yy] = blocks[k];
        const Vector ua = u[own[a]];
        const Vector ub = u[own[b]];
        forces[own[a]] = forces[own[a]] + Vector{xx * ub.x + xy * ub.y, yx * ub.x + yy * ub.y};
        if (a != b) forces[own[b]] = forces[own[b]] + Vector{xx * ua.x + yx * ua.y, xy * ua.x + yy * ua.y};
      }
    }
  }
  std::vector<Vector> applied(mesh.points.size());
  for (const SideLoad& side_load : load.sides) {
    auto sides = find_sides(mesh, side_load.where).value();
    std::erase_if(sides, [&](const mesh::ElementSide& side) { return !chosen[side.element.index()]; });
    add_side_load(mesh, problem.materials, sides, side_load.traction, applied);
  }
  for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = forces[i] - applied[i];
  return forces;
}

double intensity(double release, double opening, const Material& material) {
  return std::copysign(std::sqrt(std::abs(release) * effective_modulus(material)), opening);
}

/// The weight q at the nodes of an element: falls with the distance of the corners; linear along sides.
std::array<double, most_nodes> weights_of(const ElementGeometry& element, Point tip, const Contour& contour) {
  std::array<double, most_nodes> q{};
  const std::size_t corners = mesh::corner_count(element.type);
  for (std::size_t i = 0; i < corners; ++i)
    q[i] =
        std::clamp((contour.outer - distance(element.coordinates[i], tip)) / (contour.outer - contour.inner), 0.0, 1.0);
  for (std::size_t i = corners; i < element.count; ++i) q[i] = 0.5 * (q[i - corners] + q[(i - corners + 1) % corners]);
  return q;
}

/// In the frame of the tip.
Gradient turned(const Gradient& g, const TipFrame& frame) {
  const Vector e1 = frame.tip.direction;
  const Vector e2 = frame.up();
  const auto component = [&](Vector a, Vector b) {  // a . (grad u) b
    return a.x * (g[0] * b.x + g[1] * b.y) + a.y * (g[2] * b.x + g[3] * b.y);
  };
  return {component(e1, e1), component(e1, e2), component(e2, e1), component(e2, e2)};
}

Voigt turned(const Voigt& s, const TipFrame& frame) {
  const Gradient turned_stress = turned(Gradient{s[0], s[2], s[2], s[1]}, frame);
  return {turned_stress[0], turned_stress[3], turned_stress[1]};
}

/// (s_ij u_i,1 - w d_1j) q,j for stresses s and gradients g.
double flux(const Voigt& s, const Gradient& g, double w, Vector dq) {
  return (s[0] * g[0] + s[2] * g[2] - w) * dq.x + (s[2] * g[0] + s[1] * g[2]) * dq.y;
}

double product(const Voigt& stress, const Gradient& g) {
  return stress[0] * g[0] + stress[1] * g[3] + stress[2] * (g[1] + g[2]);
}

/// J and the three interaction integrals, not yet turned into intensities.
using Integrals = std::array<double, 4>;
constexpr std::array<error::TipLoad, 3> auxiliary{error::TipLoad::Opening, error::TipLoad::Sliding,
                                                  error::TipLoad::Force};

void add_element(const ElementGeometry& element, const TipFrame& frame, const LoadCase& load, std::int32_t region,
                 const std::array<double, most_nodes>& q, std::span<const Vector> u, Integrals& sum) {
  const ElementSolution solution(element, frame.material, u);
  const auto points = integration_points(element.type, Rule::Curved);
  const auto shapes = shapes_at(element.type, Rule::Curved);
  for (std::size_t g = 0; g < points.size(); ++g) {
    const Mapped m = map(element.points(), shapes[g]);
    const double area = m.determinant * points[g].weight;
    double value = 0.0;
    Vector slope;
    for (std::size_t a = 0; a < element.count; ++a) {
      value += m.n[a] * q[a];
      slope = slope + q[a] * Vector{m.d_x[a], m.d_y[a]};
    }
    const Vector dq = frame.local(slope);
    const Gradient own = turned(solution.gradient(m), frame);
    const Voigt stress = turned(solution.stress(m), frame);
    Vector force;
    for (const BodyForce& body : load.bodies) {
      if (!body.region || *body.region == region) force = force + frame.local(body.force(m.at));
    }
    sum[0] +=
        area * (flux(stress, own, 0.5 * product(stress, own), dq) - value * (force.x * own[0] + force.y * own[2]));
    const Vector place = frame.local(m.at - frame.at);
    for (std::size_t k = 0; k < auxiliary.size(); ++k) {
      const error::TipField field = tip_field({place.x, place.y}, auxiliary[k], frame.material);
      const double mixed = product(stress, field.gradient);
      sum[k + 1] += area * (flux(stress, field.gradient, mixed, dq) + flux(field.stress, own, 0.0, dq) -
                            value * (force.x * field.gradient[0] + force.y * field.gradient[2]));
    }
  }
}

/// The work of a load on a lip as the crack grows; the side runs along x in the frame.
void add_lip(const ElementMesh& mesh, mesh::ElementSide side, const Traction& traction, const TipFrame& frame,
             const Contour& contour, std::span<const Vector> u, Integrals& sum) {
  const ElementGeometry element = geometry_of(mesh, side.element.index());
  const auto q = weights_of(element, frame.at, contour);
  const std::size_t corners = mesh::corner_count(element.type);
  const std::array<double, 3> own_q{q[side.side], q[(side.side + 1) % corners],
                                    mesh::is_quadratic(element.type) ? q[corners + side.side] : 0.0};
  integrate_side(mesh, side, [&](auto nodes, const Shape& shape, Point at, Vector normal, double length) {
    Vector slope;  // du/ds over the derivative of the place, both along the side
    Vector tangent;
    double value = 0.0;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const Point p = mesh.point(nodes[a]);
      slope = slope + shape.d_xi[a] * frame.local(u[nodes[a].index()]);
      tangent = tangent + shape.d_xi[a] * frame.local(p - frame.at);
      value += shape.n[a] * own_q[a];
    }
    const Vector along = slope / tangent.x;
    const Vector t = frame.local(traction(at, normal));
    sum[0] -= length * value * dot(t, along);
    // The left lip runs towards the tip, the right one away from it.
    const bool upper = tangent.x > 0.0 || frame.lips != Lips::Both;
    const Point place{frame.local(at - frame.at).x, upper ? 0.0 : -0.0};
    for (std::size_t k = 0; k < auxiliary.size(); ++k) {
      const Gradient g = tip_field(place, auxiliary[k], frame.material).gradient;
      sum[k + 1] -= length * value * (t.x * g[0] + t.y * g[2]);
    }
  });
}

/// The traction on a lip at the tip, in its frame, Pa.
Vector lip_traction(const ElementMesh& mesh, const LoadCase& load, const TipFrame& frame, mesh::ElementSide lip) {
  Vector sum;
  const Vector outward = (lip == frame.left ? -1.0 : 1.0) * frame.up();
  for (const SideLoad& side_load : load.sides) {
    const auto sides = find_sides(mesh, side_load.where).value();
    if (std::find(sides.begin(), sides.end(), lip) != sides.end())
      sum = sum + frame.local(side_load.traction(frame.at, outward));
  }
  return sum;
}

/// What closes a crack, as a traction on the left of its line: of loads on both lips the mean, for the stress ahead
/// jumps by no load of one lip alone.
Vector closing_traction(const ElementMesh& mesh, const LoadCase& load, const TipFrame& frame) {
  const Vector left = lip_traction(mesh, load, frame, frame.left);
  if (frame.lips != Lips::Both) return left;
  return 0.5 * (left - lip_traction(mesh, load, frame, frame.right));
}

/// Where the lips of a crack pass through each other deepest, if they do.
struct Overlap {
  double depth = 0.0;  ///< m
  Point at;
};

/// Walks along both lips from the tip as far as they face each other; of a single lip as far as it is straight.
std::optional<Overlap> overlap_of(const ElementMesh& mesh, const TipFrame& frame,
                                  const std::vector<mesh::ElementSide>& boundary, std::span<const Vector> u) {
  std::map<mesh::NodeId, mesh::ElementSide> ending, starting;
  for (const auto& side : boundary) {
    const auto nodes = side_nodes(mesh, side);
    starting.try_emplace(nodes[0], side);
    ending.try_emplace(nodes[1], side);
  }
  const bool whole = frame.lips == Lips::Both;
  const bool backwards = frame.lips == Lips::OnlyRight;  // the only lip begins in the tip
  Overlap deepest;
  double greatest = 0.0;
  // Whether the two still face each other.
  const auto look = [&](mesh::NodeId left, mesh::NodeId right, Vector into_left) {
    if (!left.valid()) return true;
    const Point at = mesh.point(left);
    if (whole ? mesh.point(right) != at : std::abs(frame.local(at - frame.at).y) > straightness * frame.length)
      return false;
    const Vector apart = whole ? u[left.index()] - u[right.index()]
                               : 2.0 * dot(u[left.index()] - u[frame.tip.node.index()], into_left) * into_left;
    greatest = std::max(greatest, length(apart));
    if (-dot(apart, into_left) > deepest.depth) deepest = {-dot(apart, into_left), at};
    return true;
  };
  mesh::ElementSide left = frame.left;
  mesh::ElementSide right = frame.right;
  for (std::size_t step = 0; step < boundary.size(); ++step) {
    const auto on_left = side_nodes(mesh, left);
    const auto on_right = side_nodes(mesh, right);
    const mesh::NodeId far = on_left[backwards ? 1 : 0];
    const Vector into_left = whole ? left_of(normalised(mesh.point(on_left[1]) - mesh.point(on_left[0]))) : frame.up();
    if (!look(far, on_right[1], into_left) || !look(on_left[2], on_right[2], into_left)) break;
    const auto next = (backwards ? starting : ending).find(far);
    const auto next_right = starting.find(on_right[1]);
    if (far == on_right[1] || next == (backwards ? starting : ending).end() || next_right == starting.end()) break;
    left = next->second;
    if (whole) right = next_right->second;
  }
  return deepest.depth > noise * greatest ? std::optional(deepest) : std::nullopt;
}

double relative_distance(const Intensity& a, const Intensity& b) {
  return std::hypot(a.one - b.one, a.two - b.two) / std::hypot(b.one, b.two);
}

/// A single lip is half a crack only if the line ahead of it stays where it is across.
base::Result<void> check_symmetry(const ElementMesh& mesh, const TipFrame& frame, std::span<const Vector> u) {
  if (frame.lips == Lips::Both) return {};
  const auto across = [&](mesh::ElementSide side) {
    double most = 0.0;
    for (const mesh::NodeId node : side_nodes(mesh, side)) {
      if (node.valid()) most = std::max(most, std::abs(frame.local(u[node.index()] - u[frame.tip.node.index()]).y));
    }
    return most;
  };
  if (across(frame.right) <= straightness * across(frame.left)) return {};
  return bad_tip(frame, "the line of symmetry ahead of the lip is not held across; give it a support with normal = 0");
}

}  // namespace

Error bad_tip(const TipFrame& frame, std::string message) {
  return {ErrorCode::BadCrack, std::move(message),
          base::Place{.item = "crack tip '" + frame.tip.name + "'", .x = frame.at.x, .y = frame.at.y}};
}

std::vector<base::Result<TipFrame>> tip_frames(const ElementMesh& mesh, const Materials& materials) {
  const Surroundings around = surroundings_of(mesh, materials);
  std::vector<base::Result<TipFrame>> frames;
  for (const mesh::CrackTip& tip : mesh.tips) frames.push_back(frame_of(mesh, materials, tip, around));
  return frames;
}

base::Result<Intensity> displacement_correlation(const ElementMesh& mesh, const TipFrame& frame,
                                                 std::span<const Vector> u) {
  if (!frame.quarter)
    return bad_tip(
        frame, "displacement correlation needs quarter-point elements at the tip; without them it is wrong by 60 %");
  const Openings d = openings_of(mesh, frame, u);
  const double factor =
      shear_modulus(frame.material) / (kolosov(frame.material) + 1.0) * std::sqrt(2.0 * pi / frame.length);
  return Intensity{factor * (4.0 * d.middle.y - d.corner.y), factor * (4.0 * d.middle.x - d.corner.x)};
}

base::Result<Intensity> crack_closure(const ElementMesh& mesh, const Problem& problem, const LoadCase& load,
                                      const TipFrame& frame, std::span<const Vector> u) {
  if (!mesh::is_quadratic(mesh.types[frame.left.element.index()]))
    return bad_tip(frame, "crack closure needs quadratic elements at the tip");
  const auto ahead = side_ahead(mesh, frame);
  if (!ahead) return bad_tip(frame, "crack closure needs an element side straight ahead of the tip");
  const auto nodes = side_nodes(mesh, *ahead);
  const std::size_t own = nodes[0] == frame.tip.node ? 0 : 1;  // of the side: the tip
  if (std::abs(distance(mesh.point(nodes[1 - own]), frame.at) - frame.length) > 0.01 * frame.length)
    return bad_tip(frame, "crack closure needs elements of the same length ahead of the tip and behind it");
  const std::vector<Vector> forces = forces_from_left(mesh, problem, load, frame, u);
  const double thickness = frame.material.thickness;
  Vector at_tip = -1.0 / thickness * frame.local(forces[frame.tip.node.index()]);
  Vector at_middle = -1.0 / thickness * frame.local(forces[nodes[2].index()]);
  // The load of the lips would follow the crack: what closes it is the stress ahead less that on the lips.
  const Vector lip = closing_traction(mesh, load, frame);
  integrate_side(mesh, *ahead, [&](auto, const Shape& shape, Point, Vector, double length) {
    at_tip = at_tip + (shape.n[own] * length) * lip;
    at_middle = at_middle + (shape.n[2] * length) * lip;
  });
  const Openings d = openings_of(mesh, frame, u);
  const auto release = [&](double tip_force, double middle_force, double corner, double middle) {
    const double work = frame.quarter ? tip_force * ((6.0 - 1.5 * pi) * corner + (6.0 * pi - 20.0) * middle) +
                                            middle_force * (0.5 * corner + middle)
                                      : tip_force * corner + middle_force * middle;
    return work / (2.0 * frame.length);
  };
  const double one = intensity(release(at_tip.y, at_middle.y, d.corner.y, d.middle.y), d.corner.y, frame.material);
  if (frame.lips != Lips::Both) return Intensity{one, 0.0};
  return Intensity{one, intensity(release(at_tip.x, at_middle.x, d.corner.x, d.middle.x), d.corner.x, frame.material)};
}

DomainIntegrals domain_integrals(const ElementMesh& mesh, const LoadCase& load, const TipFrame& frame,
                                 const Contour& contour, std::span<const Vector> u) {
  Integrals sum{};
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const ElementGeometry element = geometry_of(mesh, e);
    const auto q = weights_of(element, frame.at, contour);
    const auto own = std::span(q).first(element.count);
    const bool outside = std::all_of(own.begin(), own.end(), [](double w) { return w == 0.0; });
    const bool flat = std::all_of(own.begin(), own.end(), [](double w) { return w == 1.0; });
    if (outside || (flat && load.bodies.empty())) continue;
    add_element(element, frame, load, mesh.regions[e], q, u, sum);
  }
  for (const SideLoad& side_load : load.sides) {
    const auto sides = find_sides(mesh, side_load.where).value();
    for (const mesh::ElementSide side : sides) {
      const auto nodes = side_nodes(mesh, side);
      // Inside the contour there is no boundary but the lips, and a line of symmetry, whose supports take its loads.
      const double ahead = frame.local(midpoint(mesh.point(nodes[0]), mesh.point(nodes[1])) - frame.at).x;
      if (ahead < 0.0 &&
          std::min(distance(mesh.point(nodes[0]), frame.at), distance(mesh.point(nodes[1]), frame.at)) < contour.outer)
        add_lip(mesh, side, side_load.traction, frame, contour, u, sum);
    }
  }
  const double modulus = effective_modulus(frame.material);
  if (frame.lips != Lips::Both) {  // the other half is the mirror image
    const double across = -lip_traction(mesh, load, frame, frame.left).y;
    return {2.0 * sum[0], {modulus * sum[1], 0.0}, 2.0 * modulus * sum[3] + across};
  }
  // The force at the tip feels the stress across the crack that loaded lips carry, as if it were along it.
  const double across =
      0.5 * (lip_traction(mesh, load, frame, frame.right).y - lip_traction(mesh, load, frame, frame.left).y);
  return {sum[0], {0.5 * modulus * sum[1], 0.5 * modulus * sum[2]}, modulus * sum[3] + across};
}

namespace {

/// The methods beside the interaction integral, and what keeps one from taking part.
void compare_methods(const ElementMesh& mesh, const Problem& problem, const LoadCase& load, const TipFrame& frame,
                     std::span<const Vector> u, TipResult& result) {
  const Intensity k = result.domain.k;
  std::string missing;
  const auto take = [&](const base::Result<Intensity>& other, std::optional<Intensity>& own) {
    if (!other) {
      missing += (missing.empty() ? "" : "; ") + other.error().message;
      return;
    }
    own = *other;
    if (k.one != 0.0 || k.two != 0.0)
      result.spread = std::max(result.spread.value_or(0.0), relative_distance(*other, k));
  };
  take(displacement_correlation(mesh, frame, u), result.correlation);
  take(crack_closure(mesh, problem, load, frame, u), result.closure);
  if (missing.empty()) return;
  const bool alone = !result.correlation && !result.closure;
  result.remarks.push_back(fmt::format(
      "crack tip '{}': {} ({}){}; mesh with rosettes = \"yes\" and order = \"2\"", frame.tip.name,
      alone ? "K by one method only, which nothing confirms" : "K by two methods only", missing,
      frame.quarter ? "" : "; these elements do not hold the singularity, so K may be off by several percent"));
}

/// Kink angles, or why there are none.
void look_for_contact(const ElementMesh& mesh, const TipFrame& frame, const std::vector<mesh::ElementSide>& boundary,
                      std::span<const Vector> u, TipResult& result) {
  const Intensity k = result.domain.k;
  const double size = std::hypot(k.one, k.two);
  const auto overlap = overlap_of(mesh, frame, boundary, u);
  const auto rounded = [&](double x) { return std::abs(x) < 1e-9 * frame.length ? 0.0 : x; };
  const Openings openings = openings_of(mesh, frame, u);
  const bool closed = k.one < -noise * size || openings.corner.y < -noise * length(openings.corner) ||
                      openings.middle.y < -noise * length(openings.middle);
  if (overlap || closed) {
    result.remarks.push_back(
        fmt::format("crack tip '{}': closed: {}; contact is not modelled, so K and J are not those of lips that press "
                    "on each other{}",
                    frame.tip.name,
                    overlap ? fmt::format("the lips overlap by up to {:.3g} m at ({:.6g}, {:.6g})", overlap->depth,
                                          rounded(overlap->at.x), rounded(overlap->at.y))
                    : k.one < 0.0 ? fmt::format("K_I is {:.4g} Pa sqrt(m)", k.one)
                                  : "the lips meet at the tip",
                    closed ? ", and no kink angle is given" : ""));
  }
  if (closed || size == 0.0) return;
  result.kinks = {kink_of(KinkCriterion::SigmaTheta, k, frame.material),
                  kink_of(KinkCriterion::STheta, k, frame.material), kink_of(KinkCriterion::GTheta, k, frame.material)};
}

base::Result<TipResult> tip_result(const ElementMesh& mesh, const Problem& problem, const LoadCase& load,
                                   const TipFrame& frame, const std::vector<mesh::ElementSide>& boundary,
                                   std::span<const Vector> u, std::optional<double> outer) {
  DOBRA_TRY_VOID(check_symmetry(mesh, frame, u));
  DOBRA_TRY(const Contour contour, contour_of(frame, outer));
  TipResult result{.name = frame.tip.name, .at = frame.at, .ahead = frame.tip.direction, .contour = contour};
  result.domain = domain_integrals(mesh, load, frame, contour, u);
  const Contour half{0.5 * contour.inner, 0.5 * contour.outer};
  result.inner_j = domain_integrals(mesh, load, frame, half, u).j;
  const Intensity k = result.domain.k;
  compare_methods(mesh, problem, load, frame, u, result);
  result.release = (k.one * k.one + k.two * k.two) / effective_modulus(frame.material);
  compare_figures(frame, result);
  look_for_contact(mesh, frame, boundary, u, result);
  return result;
}

}  // namespace

std::vector<TipResult> crack_tips(const ElementMesh& mesh, const Problem& problem, const LoadCase& load,
                                  std::span<const Vector> u, std::optional<double> outer) {
  auto frames = tip_frames(mesh, problem.materials);
  const std::vector<mesh::ElementSide> boundary = surroundings_of(mesh, problem.materials).boundary;
  std::vector<TipResult> results;
  for (std::size_t t = 0; t < frames.size(); ++t) {
    const mesh::CrackTip& tip = mesh.tips[t];
    if (frames[t]) frames[t]->acted = nearest_acted_on(mesh, problem, load, *frames[t]);
    auto own = frames[t] ? tip_result(mesh, problem, load, *frames[t], boundary, u, outer) : frames[t].error();
    if (own) {
      results.push_back(*std::move(own));
      continue;
    }
    results.push_back({.name = tip.name, .at = mesh.point(tip.node), .ahead = tip.direction, .refused = own.error()});
  }
  return results;
}

}  // namespace dobra::fem::fracture
