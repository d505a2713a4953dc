#include "shared/solid/line_along_x.h"

#include <algorithm>

namespace dobra::solid {

using geom::Sign;

void add_step(Windings& windings, std::uint32_t operand, int step) {
  const auto at = std::lower_bound(windings.begin(), windings.end(), operand,
                                   [](const auto& entry, std::uint32_t o) { return entry.first < o; });
  if (at == windings.end() || at->first != operand) {
    windings.insert(at, {operand, step});
  } else if ((at->second += step) == 0) {
    windings.erase(at);
  }
}

LineAlongX::LineAlongX(const Soup& soup, const Homogeneous& from) : soup_(soup), from_(from) {
  for (std::size_t i = 0; i < 3; ++i) {
    near_[i] = rounded_quotient(from_.place[i], from_.weight);
    slack_[i] = std::abs(near_[i]) * 0x1p-52;
  }
}

Windings LineAlongX::windings(const std::vector<BoxTree>& trees) const {
  Windings result;
  const auto wanted = [&](const Box3& box) {
    return near_[0] - slack_[0] <= box.high[0] && near_[1] + slack_[1] >= box.low[1] &&
           near_[1] - slack_[1] <= box.high[1] && near_[2] + slack_[2] >= box.low[2] &&
           near_[2] - slack_[2] <= box.high[2];
  };
  for (const BoxTree& tree : trees) {
    tree.select(wanted, [&](std::uint32_t f) {
      const int step = crossing(soup_.facets[f]);
      if (step != 0) add_step(result, soup_.facets[f].operand, step);
    });
  }
  return result;
}

bool LineAlongX::starts_on_facet(const std::vector<BoxTree>& trees) const {
  bool found = false;
  const auto wanted = [&](const Box3& box) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (near_[i] + slack_[i] < box.low[i] || near_[i] - slack_[i] > box.high[i]) return false;
    }
    return !found;
  };
  for (const BoxTree& tree : trees) {
    tree.select(wanted, [&](std::uint32_t f) { found = found || holds(soup_.facets[f]); });
  }
  return found;
}

/// 1 where the line leaves the facet's operand, -1 where it enters it, 0 if it does not meet the facet.
int LineAlongX::crossing(const Facet& facet) const {
  const Sign slope = soup_.space.normal_sign(facet.plane, 0);
  if (slope == Sign::Zero) return 0;
  bool inside = false;
  soup_.visit_edges(facet, [&](std::uint32_t i, std::uint32_t j) {
    if (passes_right_of(soup_.corners[i], soup_.corners[j])) inside = !inside;
  });
  if (!inside) return 0;
  // Whether the point comes before the facet along x.
  Sign where = side(facet);
  for (const int axis : {1, 2, 0}) {
    if (where == Sign::Zero) where = soup_.space.normal_sign(facet.plane, axis);
  }
  if (where == slope) return 0;
  return slope == Sign::Positive ? 1 : -1;
}

Sign LineAlongX::side(const Facet& facet) const {
  const Homogeneous& c = soup_.space.coefficients(facet.plane);
  return (dot(c.place, from_.place) + c.weight * from_.weight).sign();
}

bool LineAlongX::holds(const Facet& facet) const {
  if (side(facet) != Sign::Zero) return false;
  const Projection onto = soup_.space.projection(facet.plane);
  bool inside = false;
  bool on_border = false;
  soup_.visit_edges(facet, [&](std::uint32_t i, std::uint32_t j) {
    PointId a = soup_.corners[i];
    PointId b = soup_.corners[j];
    Sign at_a = compare(onto.v, a);
    Sign at_b = compare(onto.v, b);
    const Sign turned = turn(onto.u, onto.v, a, b);
    if (turned == Sign::Zero && at_a * at_b != Sign::Positive &&
        compare(onto.u, a) * compare(onto.u, b) != Sign::Positive) {
      on_border = true;
    }
    const bool above_a = at_a == Sign::Positive;
    const bool above_b = at_b == Sign::Positive;
    if (above_a != above_b && (turned == Sign::Positive) == above_b) inside = !inside;
  });
  return on_border || inside;
}

/// Of the point p's coordinate against the start's.
Sign LineAlongX::compare(int axis, PointId p) const {
  const auto i = static_cast<std::size_t>(axis);
  const double value = soup_.space.coordinate(p, axis);
  const double slack = slack_[i] + std::abs(value) * 0x1p-52;
  if (std::abs(value - near_[i]) > slack) return geom::sign_of(value - near_[i]);
  const Homogeneous at = soup_.space.place(p);
  return (at.place[i] * from_.weight - from_.place[i] * at.weight).sign();
}

/// Positive if the start is to the left of p-q in the plane of both axes.
Sign LineAlongX::turn(int u, int v, PointId p, PointId q) const {
  const auto i = static_cast<std::size_t>(u);
  const auto j = static_cast<std::size_t>(v);
  const Homogeneous a = soup_.space.place(p);
  const Homogeneous b = soup_.space.place(q);
  const Homogeneous& m = from_;
  return (a.place[i] * (b.place[j] * m.weight - m.place[j] * b.weight) -
          a.place[j] * (b.place[i] * m.weight - m.place[i] * b.weight) +
          a.weight * (b.place[i] * m.place[j] - m.place[i] * b.place[j]))
      .sign();
}

/// In the plane of y and z: whether the edge crosses the line from the start along y.
bool LineAlongX::passes_right_of(PointId a, PointId b) const {
  const bool above_a = compare(2, a) == Sign::Positive;
  const bool above_b = compare(2, b) == Sign::Positive;
  if (above_a == above_b) return false;
  const PointId low = above_a ? b : a;
  const PointId high = above_a ? a : b;
  // Where both ends are on one side there is no doubt.
  const Sign low_y = compare(1, low);
  const Sign high_y = compare(1, high);
  if (low_y == high_y && low_y != Sign::Zero) return low_y == Sign::Positive;
  // Left of the edge upwards is the side of lesser y; from the edge itself the line starts a little to the right.
  return turn(1, 2, low, high) == Sign::Positive;
}

}  // namespace dobra::solid
