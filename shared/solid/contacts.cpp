#include "shared/solid/contacts.h"

#include "shared/solid/triangulate.h"

namespace dobra::solid {
namespace {

using geom::Sign;

/// One corner of a loop against the other plane, with how the loop passes the line as seen from just below and above.
struct Event {
  PointId point;
  bool below, above;
};

bool strictly_one_side(const std::vector<Sign>& signs) {
  for (const Sign sign : signs) {
    if (sign == Sign::Zero || sign != signs.front()) return false;
  }
  return true;
}

class Finder {
 public:
  Finder(Soup& soup, Contacts& found) : soup_(soup), found_(found) {}

  void pair(std::uint32_t f, std::uint32_t g) {
    const Facet& own = soup_.facets[f];
    const Facet& other = soup_.facets[g];
    read_signs(own.plane, other, signs_g_);
    if (strictly_one_side(signs_g_)) return;
    const std::size_t zeros = static_cast<std::size_t>(std::count(signs_g_.begin(), signs_g_.end(), Sign::Zero));
    if (zeros == signs_g_.size()) {
      if (!apart(own, other) && !apart(other, own)) found_.coplanar.emplace_back(f, g);
      return;
    }
    if (zeros > 0 && zeros <= 2 && only_common(own, other)) return;
    read_signs(other.plane, own, signs_f_);
    if (strictly_one_side(signs_f_)) return;
    const int axis = axis_of_line(soup_.space, own.plane, other.plane);
    stops_along(soup_, f, other.plane, signs_f_, axis, stops_f_);
    stops_along(soup_, g, own.plane, signs_g_, axis, stops_g_);
    merge(f, g, axis);
  }

 private:
  void read_signs(PlaneId plane, const Facet& facet, std::vector<Sign>& signs) const {
    signs.clear();
    for (const PointId p : soup_.corners_of(facet)) signs.push_back(soup_.space.side(plane, p));
  }

  /// The other facet stays on one side of this one and touches its plane in an edge or a corner of both alone.
  [[nodiscard]] bool only_common(const Facet& own, const Facet& other) const {
    Sign side = Sign::Zero;
    std::vector<PointId> touching;
    for (std::uint32_t i = 0; i < signs_g_.size(); ++i) {
      if (signs_g_[i] == Sign::Zero) {
        touching.push_back(soup_.corners[other.first_corner + i]);
      } else if (side == Sign::Zero) {
        side = signs_g_[i];
      } else if (side != signs_g_[i]) {
        return false;
      }
    }
    if (touching.size() == 1) return soup_.has_corner(own, touching[0]);
    return soup_.has_edge(own, touching[0], touching[1]) && soup_.has_edge(other, touching[0], touching[1]);
  }

  /// A line through an edge of `f`, a triangle, has all of `g` of the same plane beyond it, except common corners.
  [[nodiscard]] bool apart(const Facet& f, const Facet& g) const {
    if (f.corner_end - f.first_corner != 3) return false;
    const Projection onto = soup_.space.projection(f.plane);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const PointId a = soup_.corners[f.first_corner + i];
      const PointId b = soup_.corners[f.first_corner + (i + 1) % 3];
      bool beyond = true;
      for (const PointId c : soup_.corners_of(g)) {
        const Sign side = soup_.space.orient(onto, a, b, c);
        if (side == Sign::Positive || (side == Sign::Zero && c != a && c != b)) {
          beyond = false;
          break;
        }
      }
      if (beyond) return true;
    }
    return false;
  }

  void merge(std::uint32_t f, std::uint32_t g, int axis) {
    const Space& space = soup_.space;
    std::size_t i = 0;
    std::size_t j = 0;
    bool in_f = false;  // what lies between the last stop and the next
    bool in_g = false;
    bool joined = false;  // the last stop ended or began a common segment
    PointId last;
    while (i < stops_f_.size() || j < stops_g_.size()) {
      bool take_f = i < stops_f_.size();
      bool take_g = j < stops_g_.size();
      if (take_f && take_g && stops_f_[i].point != stops_g_[j].point) {
        const bool first = space.compare(axis, stops_f_[i].point, stops_g_[j].point) == std::strong_ordering::less;
        (first ? take_g : take_f) = false;
      }
      const PointId at = take_f ? stops_f_[i].point : stops_g_[j].point;
      const bool before = in_f && in_g;
      if (before) {
        cut(f, g, last, at);
        cut(g, f, last, at);
        const bool common = soup_.has_edge(soup_.facets[f], last, at) && soup_.has_edge(soup_.facets[g], last, at);
        if (!common) note(f, g, last);
      }
      const bool held_f = take_f || in_f;
      const bool held_g = take_g || in_g;
      if (take_f) in_f = stops_f_[i++].holds;
      if (take_g) in_g = stops_g_[j++].holds;
      joined = before || (in_f && in_g);
      if (held_f && held_g && !joined) {
        cut(f, g, at, at);
        cut(g, f, at, at);
        if (!soup_.has_corner(soup_.facets[f], at) || !soup_.has_corner(soup_.facets[g], at)) note(f, g, at);
      }
      last = at;
    }
  }

  void cut(std::uint32_t f, std::uint32_t g, PointId a, PointId b) {
    const Facet& own = soup_.facets[f];
    if (a == b ? soup_.has_corner(own, a) : soup_.has_edge(own, a, b)) return;
    found_.cuts.push_back({f, a, b, soup_.facets[g].plane});
  }

  void note(std::uint32_t f, std::uint32_t g, PointId at) {
    if (soup_.facets[f].operand == soup_.facets[g].operand) found_.inside.push_back({f, g, at});
  }

  Soup& soup_;
  Contacts& found_;
  std::vector<Sign> signs_f_, signs_g_;
  std::vector<Stop> stops_f_, stops_g_;
};

PointId crossing(Soup& soup, const Facet& facet, std::uint32_t i, std::uint32_t j, PlaneId other) {
  const PointId a = soup.corners[i];
  const PointId b = soup.corners[j];
  // Through planes the numbers do not grow from one operation to the next.
  const bool plain = soup.space.is_exact(a) && soup.space.is_exact(b);
  if (!plain && soup.across[i].valid()) return soup.space.meet(facet.plane, soup.across[i], other);
  return soup.space.meet(a, b, other);
}

}  // namespace

int axis_of_line(const Space& space, PlaneId a, PlaneId b) {
  const geom::Vector3 m = space.rough_normal(a);
  const geom::Vector3 n = space.rough_normal(b);
  const geom::Vector3 line = cross(m, n);
  const std::array<double, 3> size{std::abs(line.x), std::abs(line.y), std::abs(line.z)};
  const auto greatest = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  if (size[static_cast<std::size_t>(greatest)] > 1e-3 * length(m) * length(n)) return greatest;
  const Dyadic3 exact = cross(space.normal(a), space.normal(b));
  for (int axis = 0; axis < 3; ++axis) {
    if (!exact[static_cast<std::size_t>(axis)].zero()) return axis;
  }
  return -1;
}

void stops_along(Soup& soup, std::uint32_t facet, PlaneId other, const std::vector<Sign>& signs, int axis,
                 std::vector<Stop>& stops) {
  const Facet& own = soup.facets[facet];
  std::vector<Event> events;
  soup.visit_edges(own, [&](std::uint32_t i, std::uint32_t j) {
    const Sign a = signs[i - own.first_corner];
    const Sign b = signs[j - own.first_corner];
    const bool below = (a == Sign::Negative) != (b == Sign::Negative);
    const bool above = (a == Sign::Positive) != (b == Sign::Positive);
    if (a == Sign::Zero) {
      events.push_back({soup.corners[i], below, above});
    } else if (b == Sign::Zero) {
      events.push_back({soup.corners[j], below, above});
    } else if (a != b) {
      events.push_back({crossing(soup, own, i, j, other), true, true});
    }
  });
  std::sort(events.begin(), events.end(), [&](const Event& a, const Event& b) {
    return soup.space.compare(axis, a.point, b.point) == std::strong_ordering::less;
  });
  stops.clear();
  bool below = false;
  bool above = false;
  for (std::size_t i = 0; i < events.size(); ++i) {
    below = below != events[i].below;
    above = above != events[i].above;
    if (i + 1 < events.size() && events[i + 1].point == events[i].point) continue;
    stops.push_back({events[i].point, below || above, below});
  }
}

Contacts contacts(Soup& soup, const std::vector<BoxTree>& trees) {
  Contacts found;
  Finder finder(soup, found);
  const auto visit = [&](std::uint32_t f, std::uint32_t g) { finder.pair(f, g); };
  // A facet whose own corner lies within its own edge is cut there, as its neighbours are.
  for (std::uint32_t f = 0; f < soup.facets.size(); ++f) {
    const Facet& facet = soup.facets[f];
    if (soup.inner[facet.operand] != Inner::Searched || !meets_itself(soup, facet)) continue;
    const PointId corner = soup.corners[facet.first_corner];
    found.cuts.push_back({f, corner, corner, facet.plane});
  }
  for (std::size_t i = 0; i < trees.size(); ++i) {
    if (soup.inner[i] == Inner::Searched) trees[i].inner_pairs(visit);
    for (std::size_t j = i + 1; j < trees.size(); ++j) trees[i].pairs(trees[j], visit);
  }
  return found;
}

}  // namespace dobra::solid
