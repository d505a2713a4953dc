#include "shared/fem/error/singular_field.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "shared/base/parallel.h"

// Notation: t the angle from `out`, l the exponent, F(t) = A cos(l+1)t + B sin(l+1)t + C cos(l-1)t + D sin(l-1)t.
//   s_tt = l (l + 1) F r^(l-1),  s_rt = -l F' r^(l-1),  s_rr = (F'' + (l + 1) F) r^(l-1),
//   2 mu u_r = r^l (-(l + 1)(A cos(l+1)t + B sin(l+1)t) + (kappa - l)(C cos(l-1)t + D sin(l-1)t)),
//   2 mu u_t = r^l ( (l + 1)(A sin(l+1)t - B cos(l+1)t) + (kappa + l)(C sin(l-1)t - D cos(l-1)t)).

namespace dobra::fem::error {
namespace {

using geom::Point;
using geom::Vector;
using mesh::ElementMesh;
using std::numbers::pi;

/// A row of the conditions on (A, B, C, D) is zero to this, of the largest.
constexpr double same_condition = 1e-6;
/// A zone is believed if its modes leave less than this of what a plane alone leaves of the samples.
constexpr double explained = 0.75;
/// As in recover.cpp.
constexpr double zone_weight_floor = 0.2;
/// Samples of a fit to its unknowns.
constexpr Eigen::Index samples_per_unknown = 2;

struct Rows {
  Eigen::RowVector4d value, slope, radial, across;  ///< F, F', u_r, u_t
};

Rows rows_at(double t, double l, double kappa) {
  const double cp = std::cos((l + 1) * t), sp = std::sin((l + 1) * t), cm = std::cos((l - 1) * t),
               sm = std::sin((l - 1) * t);
  Rows rows;
  rows.value << cp, sp, cm, sm;
  rows.slope << -(l + 1) * sp, (l + 1) * cp, -(l - 1) * sm, (l - 1) * cm;
  rows.radial << -(l + 1) * cp, -(l + 1) * sp, (kappa - l) * cm, (kappa - l) * sm;
  rows.across << (l + 1) * sp, -(l + 1) * cp, (kappa + l) * sm, -(kappa + l) * cm;
  return rows;
}

/// Elements by their distance from a node in rings: first those that touch it.
std::vector<std::vector<std::uint32_t>> rings_round(const ElementMesh& mesh,
                                                    const std::vector<std::vector<std::uint32_t>>& stars,
                                                    mesh::NodeId centre, int count) {
  std::vector<std::vector<std::uint32_t>> rings;
  std::set<std::uint32_t> known;
  std::set<std::size_t> nodes{centre.index()};
  for (int ring = 0; ring < count; ++ring) {
    std::set<std::uint32_t> next;
    for (const std::size_t n : nodes) {
      for (const std::uint32_t e : stars[n]) {
        if (known.insert(e).second) next.insert(e);
      }
    }
    for (const std::uint32_t e : next) {
      for (const mesh::NodeId n : mesh.nodes_of(mesh::ElementId(e))) nodes.insert(n.index());
    }
    rings.emplace_back(next.begin(), next.end());
  }
  return rings;
}

}  // namespace

std::vector<CornerField> corner_modes(const SingularVertex& vertex, const Material& material) {
  if (vertex.exponent == 1.0) return {CornerField{1.0}};
  const double kappa = kolosov(material);
  Eigen::Matrix4d conditions;
  const auto hold = [&](Eigen::Index row, CornerFace face, double t) {
    const Rows rows = rows_at(t, vertex.exponent, kappa);
    conditions.row(row) = face == CornerFace::Free ? rows.value : face == CornerFace::Roller ? rows.slope : rows.radial;
    conditions.row(row + 1) = face == CornerFace::Free ? rows.slope : rows.across;
  };
  hold(0, vertex.first, 0.0);
  hold(2, vertex.last, vertex.interior.radians());
  const Eigen::JacobiSVD<Eigen::Matrix4d> svd(conditions, Eigen::ComputeFullV);
  std::vector<CornerField> modes;
  for (Eigen::Index i = 0; i < 4; ++i) {
    if (svd.singularValues()(i) > same_condition * svd.singularValues()(0)) continue;
    const Eigen::Vector4d mode = svd.matrixV().col(i);
    modes.push_back({mode(0), mode(1), mode(2), mode(3)});
  }
  return modes;
}

Voigt corner_stress(const SingularVertex& vertex, const CornerField& mode, Vector from_vertex) {
  const double l = vertex.exponent;
  const Vector& out = vertex.out;
  double t = std::atan2(cross(out, from_vertex), dot(out, from_vertex));
  if (t < 0.5 * (vertex.interior.radians() - 2.0 * pi)) t += 2.0 * pi;
  const Vector r = normalised(from_vertex);
  // Of the polynomials r^2 (1, cos 2t, sin 2t) at exponent 1 a plane has account; r^2 t is the one that is none.
  if (l == 1.0)
    return {2.0 * t * mode[0] + 2.0 * r.x * r.y * mode[0], 2.0 * t * mode[0] - 2.0 * r.x * r.y * mode[0],
            -(r.x * r.x - r.y * r.y) * mode[0]};
  const double cp = std::cos((l + 1) * t), sp = std::sin((l + 1) * t), cm = std::cos((l - 1) * t),
               sm = std::sin((l - 1) * t);
  const auto& [a, b, c, d] = mode;
  const double f = a * cp + b * sp + c * cm + d * sm;
  const double slope = (l + 1) * (b * cp - a * sp) + (l - 1) * (d * cm - c * sm);
  const double second = -(l + 1) * (l + 1) * (a * cp + b * sp) - (l - 1) * (l - 1) * (c * cm + d * sm);
  const double power = std::pow(length(from_vertex), l - 1);
  const double rr = power * (second + (l + 1) * f), tt = power * l * (l + 1) * f, rt = -power * l * slope;
  return {r.x * r.x * rr + r.y * r.y * tt - 2 * r.x * r.y * rt, r.y * r.y * rr + r.x * r.x * tt + 2 * r.x * r.y * rt,
          r.x * r.y * (rr - tt) + (r.x * r.x - r.y * r.y) * rt};
}

namespace {

std::array<double, 6> monomials(Vector p) { return {1.0, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y}; }

}  // namespace

Voigt SingularZone::stress(Point p) const {
  Voigt sum{};
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const Voigt one = corner_stress(vertex, modes[m], p - at);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += amplitudes[m] * one[k];
  }
  const Vector local = (p - at) / scale;
  const auto terms = monomials(local);
  for (std::size_t i = 0; i < polynomial.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += terms[i] * polynomial[i][k];
  }
  return sum;
}

namespace {

/// Where stresses are compared: the samples of an element, and its stress there.
struct ZoneSamples {
  std::vector<Point> points;
  std::vector<Voigt> stresses;
  std::vector<Voigt> recovered;
};

void add_samples(ZoneSamples& samples, const ElementMesh& mesh, const Material& material, std::size_t e,
                 std::span<const Vector> u, const RecoveredStress& recovered) {
  const ElementGeometry element = geometry_of(mesh, e);
  const ElementSolution solution(element, material, u);
  for (const Shape& shape : shapes_at(element.type, Rule::Sample)) {
    const Mapped m = map(element.points(), shape);
    samples.points.push_back(m.at);
    samples.stresses.push_back(solution.stress(m));
    Voigt smooth{};
    for (std::size_t a = 0; a < element.count; ++a) {
      for (std::size_t k = 0; k < 3; ++k) smooth[k] += m.n[a] * recovered.at_element_nodes[mesh.first[e] + a][k];
    }
    samples.recovered.push_back(smooth);
  }
}

/// Amplitudes and polynomial of a zone; false if the samples do not determine them, or do not show the modes.
bool fit(SingularZone& zone, const ZoneSamples& samples, Eigen::Index terms) {
  zone.scale = 0.0;
  for (const Point p : samples.points) zone.scale = std::max(zone.scale, distance(p, zone.at));
  const auto modes = static_cast<Eigen::Index>(zone.modes.size());
  const Eigen::Index columns = modes + 3 * terms;
  const auto rows = static_cast<Eigen::Index>(3 * samples.points.size());
  if (rows < samples_per_unknown * columns) return false;
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows, columns);
  Eigen::VectorXd b(rows);
  const double power = std::pow(zone.scale, zone.vertex.exponent - 1.0);
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const Vector from = samples.points[i] - zone.at;
    // As exact, in proportion, near the vertex as far from it; but what is near counts for more, as in patches of
    // nodes.
    const double r = length(from) / zone.scale;
    const double weight = std::pow(r, 1.0 - zone.vertex.exponent) * std::pow(zone_weight_floor + r, -1.5);
    const Vector local = from / zone.scale;
    const auto plane = monomials(local);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto row = static_cast<Eigen::Index>(3 * i + k);
      for (Eigen::Index m = 0; m < modes; ++m)
        a(row, m) = weight * corner_stress(zone.vertex, zone.modes[static_cast<std::size_t>(m)], from)[k] / power;
      for (Eigen::Index t = 0; t < terms; ++t)
        a(row, modes + terms * static_cast<Eigen::Index>(k) + t) = weight * plane[static_cast<std::size_t>(t)];
      b(row) = weight * samples.stresses[i][k];
    }
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
  if (qr.rank() < columns) return false;
  const Eigen::VectorXd x = qr.solve(b);
  const Eigen::MatrixXd plane_only = a.rightCols(3 * terms);
  const Eigen::VectorXd without = plane_only.colPivHouseholderQr().solve(b);
  if ((a * x - b).norm() > explained * (plane_only * without - b).norm()) return false;
  for (Eigen::Index m = 0; m < modes; ++m) zone.amplitudes.push_back(x(m) / power);
  for (Eigen::Index t = 0; t < terms; ++t)
    zone.polynomial.push_back({x(modes + t), x(modes + terms + t), x(modes + 2 * terms + t)});
  return true;
}

/// Whether the zone's stress comes nearer to the samples than the recovered one.
bool nearer(const SingularZone& zone, const Elasticity& d, const ZoneSamples& samples) {
  double own = 0.0, smooth = 0.0;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    Voigt from_zone = zone.stress(samples.points[i]);
    Voigt from_smooth = samples.recovered[i];
    for (std::size_t k = 0; k < 3; ++k) {
      from_zone[k] -= samples.stresses[i][k];
      from_smooth[k] -= samples.stresses[i][k];
    }
    own += energy_product(d, from_zone, from_zone);
    smooth += energy_product(d, from_smooth, from_smooth);
  }
  return own < smooth;
}

}  // namespace

std::vector<SingularZone> singular_zones(const ElementMesh& mesh, const Materials& materials,
                                         const std::vector<SingularVertex>& singular, std::span<const Vector> u,
                                         const RecoveredStress& recovered, const SingularZoneOptions& options) {
  if (singular.empty()) return {};
  std::vector<std::vector<std::uint32_t>> stars(mesh.points.size());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const mesh::NodeId n : mesh.nodes_of(mesh::ElementId(e)))
      stars[n.index()].push_back(static_cast<std::uint32_t>(e));
  }
  const auto zone_at = [&](const SingularVertex& vertex) -> std::optional<SingularZone> {
    if (length(vertex.out) == 0.0) return std::nullopt;
    const auto rings = rings_round(mesh, stars, vertex.node, options.fit_rings);
    const std::int32_t region = mesh.regions[rings[0].front()];
    if (std::any_of(rings[0].begin(), rings[0].end(), [&](auto e) { return mesh.regions[e] != region; }))
      return std::nullopt;
    const Material& material = materials.at(region);
    const Elasticity d = elasticity(material);
    SingularZone zone{.vertex = vertex, .at = mesh.point(vertex.node), .modes = corner_modes(vertex, material)};
    if (zone.modes.empty()) return std::nullopt;
    ZoneSamples all;
    for (std::size_t ring = 1; ring < rings.size(); ++ring) {
      for (const std::uint32_t e : rings[ring]) {
        if (mesh.regions[e] == region) add_samples(all, mesh, material, e, u, recovered);
      }
    }
    const bool quadratic = mesh::is_quadratic(mesh.types[rings[0].front()]);
    if (!fit(zone, all, quadratic ? 6 : 3)) return std::nullopt;
    zone.elements = rings[0];
    for (std::size_t ring = 1; ring < static_cast<std::size_t>(options.rings); ++ring) {
      ZoneSamples own;
      std::vector<std::uint32_t> elements;
      for (const std::uint32_t e : rings[ring]) {
        if (mesh.regions[e] != region) continue;
        elements.push_back(e);
        add_samples(own, mesh, material, e, u, recovered);
      }
      if (!nearer(zone, d, own)) break;
      zone.elements.insert(zone.elements.end(), elements.begin(), elements.end());
    }
    return zone;
  };
  const auto found = base::parallel_map<std::optional<SingularZone>>(
      singular.size(), [&](std::size_t i) { return zone_at(singular[i]); });
  std::vector<SingularZone> zones;
  for (const auto& zone : found) {
    if (zone) zones.push_back(*zone);
  }
  return zones;
}

}  // namespace dobra::fem::error
