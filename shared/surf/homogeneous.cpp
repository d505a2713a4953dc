#include "shared/surf/homogeneous.h"

#include <algorithm>

namespace dobra::surf {

using geom::Vector3;

std::vector<Homogeneous> bezier_net(const SplineBasis& basis, const std::vector<Homogeneous>& points, double from,
                                    double to) {
  const SplineBasis::ToBezier by = basis.bezier(from, to);
  std::vector<Homogeneous> net(basis.degree() + 1);
  for (std::size_t i = 0; i < net.size(); ++i) {
    for (std::size_t j = 0; j < net.size(); ++j) net[i] += by.of[i][j] * points[by.first + j];
  }
  return net;
}

NetBounds::NetBounds(const std::vector<Homogeneous>& net, std::size_t count_u, std::size_t count_v) {
  // About a point among them, so that what is far from the origin keeps its digits: A = sum of w (P - c), S - c = A /
  // w.
  const geom::Point3 c = net[net.size() / 2].point();
  std::vector<Vector3> a;
  std::vector<double> w;
  double radius = 0.0, least = net.front().w;
  for (const Homogeneous& each : net) {
    a.push_back(each.vector() - each.w * from_origin(c));
    w.push_back(each.w);
    radius = std::max(radius, geom::length(a.back()) / each.w);
    least = std::min(least, each.w);
  }
  const double p = static_cast<double>(count_u - 1), q = static_cast<double>(count_v - 1);
  const auto at = [&](const auto& list, std::size_t i, std::size_t j) { return list[i * count_v + j]; };
  struct Most {
    double vector = 0.0, weight = 0.0;
    void take(double f, Vector3 v, double weight_of) {
      vector = std::max(vector, f * geom::length(v));
      weight = std::max(weight, f * std::abs(weight_of));
    }
  } u, v, d_uu, d_uv, d_vv;
  for (std::size_t i = 0; i < count_u; ++i) {
    for (std::size_t j = 0; j < count_v; ++j) {
      const bool in_u = i + 1 < count_u, in_v = j + 1 < count_v;
      if (in_u) u.take(p, at(a, i + 1, j) - at(a, i, j), at(w, i + 1, j) - at(w, i, j));
      if (in_v) v.take(q, at(a, i, j + 1) - at(a, i, j), at(w, i, j + 1) - at(w, i, j));
      if (i + 2 < count_u)
        d_uu.take(p * (p - 1.0), at(a, i + 2, j) - 2.0 * at(a, i + 1, j) + at(a, i, j),
                  at(w, i + 2, j) - 2.0 * at(w, i + 1, j) + at(w, i, j));
      if (j + 2 < count_v)
        d_vv.take(q * (q - 1.0), at(a, i, j + 2) - 2.0 * at(a, i, j + 1) + at(a, i, j),
                  at(w, i, j + 2) - 2.0 * at(w, i, j + 1) + at(w, i, j));
      if (in_u && in_v)
        d_uv.take(p * q, at(a, i + 1, j + 1) - at(a, i + 1, j) - at(a, i, j + 1) + at(a, i, j),
                  at(w, i + 1, j + 1) - at(w, i + 1, j) - at(w, i, j + 1) + at(w, i, j));
    }
  }
  const double by_u = (u.vector + u.weight * radius) / least, by_v = (v.vector + v.weight * radius) / least;
  uu = (d_uu.vector + 2.0 * u.weight * by_u + d_uu.weight * radius) / least;
  uv = (d_uv.vector + u.weight * by_v + v.weight * by_u + d_uv.weight * radius) / least;
  vv = (d_vv.vector + 2.0 * v.weight * by_v + d_vv.weight * radius) / least;
}

}  // namespace dobra::surf
