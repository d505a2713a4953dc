#include "shared/solid/measure.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "shared/solid/line_along_x.h"

namespace dobra::solid {
namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<256, boost::multiprecision::digit_base_2>,
                                  boost::multiprecision::et_off>;
using Real3 = std::array<Real, 3>;

Real real(const Dyadic& value) { return ldexp(Real(value.whole()), value.exponent()); }

Real3 real(const Space& space, PointId p) {
  if (space.is_exact(p)) {
    const geom::Point3 at = space.rounded(p);
    return {Real(at.x), Real(at.y), Real(at.z)};
  }
  const Homogeneous at = space.place(p);
  const Real weight = real(at.weight);
  return {real(at.place[0]) / weight, real(at.place[1]) / weight, real(at.place[2]) / weight};
}

Real3 minus(const Real3& a, const Real3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Real3 turned(const Real3& a, const Real3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real product(const Real3& a, const Real3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Visits, for every facet and every edge that does not touch its first corner, the triangle of both, from the first
/// corner of all.
template <class Begin, class Visit>
void visit_triangles(const Soup& soup, Begin&& begin, Visit&& visit) {
  if (soup.facets.empty()) return;
  const Real3 origin = real(soup.space, soup.corners[0]);
  for (std::uint32_t f = 0; f < soup.facets.size(); ++f) {
    const Facet& facet = soup.facets[f];
    const PointId apex = soup.corners[facet.first_corner];
    const Real3 o = minus(real(soup.space, apex), origin);
    begin(f);
    soup.visit_edges(facet, [&](std::uint32_t i, std::uint32_t j) {
      if (soup.corners[i] == apex || soup.corners[j] == apex) return;
      visit(o, minus(real(soup.space, soup.corners[i]), origin), minus(real(soup.space, soup.corners[j]), origin));
    });
  }
}

}  // namespace

std::vector<double> shell_volumes(const Solid& solid) {
  std::vector<Real> six(solid.shell_count());
  std::size_t shell = 0;
  visit_triangles(
      solid.boundary().soup, [&](std::uint32_t f) { shell = solid.shell(FaceId(f)).index(); },
      [&](const Real3& o, const Real3& a, const Real3& b) { six[shell] += product(o, turned(a, b)); });
  std::vector<double> volumes;
  for (const Real& value : six) volumes.push_back(static_cast<double>(Real(value / 6)));
  return volumes;
}

double volume(const Solid& solid) {
  Real six = 0;
  visit_triangles(
      solid.boundary().soup, [](std::uint32_t) {},
      [&](const Real3& o, const Real3& a, const Real3& b) { six += product(o, turned(a, b)); });
  return static_cast<double>(Real(six / 6));
}

Measures measure(const Solid& solid) {
  Measures out;
  const Soup& soup = solid.boundary().soup;
  Real six = 0;
  Real area = 0;
  Real3 facet_area{};
  Real3 first{};                 // 24 times the integrals of x, y, z
  std::array<Real, 6> second{};  // 120 times those of xx, yy, zz, xy, yz, zx
  constexpr std::array<std::pair<std::size_t, std::size_t>, 6> pairs{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
  const auto end_facet = [&] {
    area += sqrt(product(facet_area, facet_area));
    facet_area = {};
  };
  visit_triangles(
      soup, [&](std::uint32_t) { end_facet(); },
      [&](const Real3& o, const Real3& a, const Real3& b) {
        const Real3 face = turned(minus(a, o), minus(b, o));
        for (std::size_t i = 0; i < 3; ++i) facet_area[i] += face[i];
        const Real part = product(o, turned(a, b));
        six += part;
        const Real3 sum{o[0] + a[0] + b[0], o[1] + a[1] + b[1], o[2] + a[2] + b[2]};
        for (std::size_t i = 0; i < 3; ++i) first[i] += part * sum[i];
        for (std::size_t k = 0; k < 6; ++k) {
          const auto [i, j] = pairs[k];
          second[k] += part * (o[i] * o[j] + a[i] * a[j] + b[i] * b[j] + sum[i] * sum[j]);
        }
      });
  end_facet();
  out.volume = static_cast<double>(Real(six / 6));
  out.area = static_cast<double>(Real(area / 2));
  if (six == 0) return out;
  const Real3 origin = real(soup.space, soup.corners[0]);
  Real3 centre{};
  for (std::size_t i = 0; i < 3; ++i) centre[i] = first[i] / (4 * six);
  // Adding nought makes -0 a 0.
  const auto rounded = [](const Real& value) { return static_cast<double>(value) + 0.0; };
  out.centre = {rounded(Real(centre[0] + origin[0])), rounded(Real(centre[1] + origin[1])),
                rounded(Real(centre[2] + origin[2]))};
  std::array<Real, 6> about{};
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = pairs[k];
    about[k] = second[k] / 120 - six / 6 * centre[i] * centre[j];
  }
  out.inertia = {rounded(Real(about[1] + about[2])), rounded(Real(about[2] + about[0])),
                 rounded(Real(about[0] + about[1])), rounded(Real(-about[3])),
                 rounded(Real(-about[4])),           rounded(Real(-about[5]))};
  return out;
}

PointLocator::PointLocator(const Solid& solid) : solid_(solid) {
  trees_.emplace_back(solid_.boundary().soup, 0, static_cast<std::uint32_t>(solid_.face_count()));
}

Location PointLocator::locate(geom::Point3 p) const {
  const LineAlongX line(solid_.boundary().soup, {{Dyadic(p.x), Dyadic(p.y), Dyadic(p.z)}, Dyadic(1.0)});
  if (line.starts_on_facet(trees_)) return Location::Boundary;
  return line.windings(trees_).empty() ? Location::Outside : Location::Inside;
}

}  // namespace dobra::solid
