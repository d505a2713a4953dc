#include "shared/surf/param/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "shared/base/disjoint_sets.h"
#include "shared/geom/predicates.h"
#include "shared/mesh/face_turns.h"
#include "shared/mesh/quality.h"

namespace dobra::surf::param {

using base::Error;
using base::ErrorCode;
using geom::Point3;
using Triangle = std::array<std::uint32_t, 3>;

namespace {

Error refused(std::string message, Point3 at) {
  return {ErrorCode::BadMesh, std::move(message), base::Place{.x = at.x, .y = at.y, .z = at.z}};
}

/// Half-edges sorted by their ends, without direction.
struct Sides {
  std::vector<HalfEdge> order;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;  ///< One a half-edge, the lower number first.
};

Sides sides_of(const std::vector<Triangle>& triangles, std::size_t points) {
  Sides sides;
  sides.ends.resize(3 * triangles.size());
  std::vector<std::uint32_t> first(points + 1, 0);
  for (HalfEdge h = 0; h < sides.ends.size(); ++h) {
    const std::uint32_t a = triangles[h / 3][h % 3], b = triangles[h / 3][(h + 1) % 3];
    sides.ends[h] = std::minmax(a, b);
    ++first[sides.ends[h].first + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> at = first;
  sides.order.resize(sides.ends.size());
  for (HalfEdge h = 0; h < sides.ends.size(); ++h) sides.order[at[sides.ends[h].first]++] = h;
  for (std::size_t v = 0; v < points; ++v) {
    std::sort(sides.order.begin() + first[v], sides.order.begin() + first[v + 1], [&](HalfEdge a, HalfEdge b) {
      return std::pair(sides.ends[a].second, a) < std::pair(sides.ends[b].second, b);
    });
  }
  return sides;
}

/// Twins whatever their direction. @error CannotMesh: a side of three triangles
base::Result<std::vector<HalfEdge>> pair_up(const std::vector<Point3>& points, const std::vector<Triangle>& triangles) {
  const Sides sides = sides_of(triangles, points.size());
  std::vector<HalfEdge> twins(sides.ends.size(), no_half_edge);
  for (std::size_t i = 0; i < sides.order.size();) {
    std::size_t j = i;
    while (j < sides.order.size() && sides.ends[sides.order[j]] == sides.ends[sides.order[i]]) ++j;
    if (j - i > 2) {
      const auto [a, b] = sides.ends[sides.order[i]];
      return refused(fmt::format("the mesh is not manifold: {} triangles share the side between points {} and {}; "
                                 "leave parts of it out",
                                 j - i, a, b),
                     geom::midpoint(points[a], points[b]));
    }
    if (j - i == 2) {
      twins[sides.order[i]] = sides.order[i + 1];
      twins[sides.order[i + 1]] = sides.order[i];
    }
    i = j;
  }
  return twins;
}

/// Corners at one place are one point. @return the number of each point among those kept
std::size_t merge_points(std::vector<Point3>& points, std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) { return std::array{points[i].x, points[i].y, points[i].z}; };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  std::vector<std::uint32_t> same(points.size());
  std::size_t merged = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && key(order[i]) == key(order[i - 1]);
    same[order[i]] = again ? same[order[i - 1]] : order[i];
    merged += again ? 1 : 0;
  }
  for (Triangle& t : triangles) {
    for (std::uint32_t& corner : t) corner = same[corner];
  }
  return merged;
}

/// Triangles of fewer than three points, and those that have the points of one before.
std::size_t drop_repeated(std::vector<Triangle>& triangles) {
  const std::size_t before = triangles.size();
  std::erase_if(triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  std::vector<std::pair<Triangle, std::uint32_t>> sorted(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    sorted[t] = {triangles[t], t};
    std::sort(sorted[t].first.begin(), sorted[t].first.end());
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> again(triangles.size(), false);
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first == sorted[i - 1].first) again[sorted[i].second] = true;
  }
  std::size_t at = 0;
  std::erase_if(triangles, [&](const Triangle&) { return again[at++]; });
  return before - triangles.size();
}

std::size_t drop_unused(std::vector<Point3>& points, std::vector<Triangle>& triangles) {
  std::vector<std::uint32_t> number(points.size(), no_half_edge);
  for (const Triangle& t : triangles) {
    for (const std::uint32_t corner : t) number[corner] = 0;
  }
  std::vector<Point3> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (number[i] == no_half_edge) continue;
    number[i] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(points[i]);
  }
  for (Triangle& t : triangles) {
    for (std::uint32_t& corner : t) corner = number[corner];
  }
  const std::size_t dropped = points.size() - kept.size();
  points = std::move(kept);
  return dropped;
}

/// Turns the few triangles the way of the many. @error CannotMesh: not one piece, or with one side only
base::Result<std::size_t> turn_alike(const std::vector<Point3>& points, std::vector<Triangle>& triangles) {
  DOBRA_TRY(const std::vector<HalfEdge> twins, pair_up(points, triangles));
  enum : std::int8_t { Unknown, Keep, Turn };
  std::vector<std::int8_t> state(triangles.size(), Unknown);
  std::vector<std::uint32_t> queue{0};
  state[0] = Keep;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (HalfEdge h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h) {
      if (twins[h] == no_half_edge) continue;
      const HalfEdge other = twins[h];
      const bool agree = triangles[h / 3][h % 3] != triangles[other / 3][other % 3];
      const std::int8_t wanted = agree ? state[h / 3] : state[h / 3] == Keep ? std::int8_t{Turn} : std::int8_t{Keep};
      if (state[other / 3] == Unknown) {
        state[other / 3] = wanted;
        queue.push_back(other / 3);
      } else if (state[other / 3] != wanted) {
        return refused(
            "the mesh has one side only, like a Moebius strip: no turn of its triangles makes neighbours "
            "agree; cut it first",
            geom::midpoint(points[triangles[h / 3][h % 3]], points[triangles[h / 3][(h + 1) % 3]]));
      }
    }
  }
  if (queue.size() < triangles.size()) {
    const bool first = 2 * queue.size() < triangles.size();
    const auto stray = first ? state.begin() : std::find(state.begin(), state.end(), std::int8_t{Unknown});
    return refused(fmt::format("the mesh has several pieces: one has {} of {} triangles; give each its own file",
                               queue.size(), triangles.size()),
                   points[triangles[static_cast<std::size_t>(stray - state.begin())][0]]);
  }
  std::array<dobra::mesh::TurnedAlike, 2> alike{dobra::mesh::TurnedAlike(points[triangles[0][0]]),
                                                dobra::mesh::TurnedAlike(points[triangles[0][0]])};
  for (std::size_t t = 0; t < triangles.size(); ++t) alike[state[t] == Keep ? 0 : 1].add(points, triangles[t]);
  const bool closed = std::find(twins.begin(), twins.end(), no_half_edge) == twins.end();
  const std::int8_t wrong = alike[0].stays_before(alike[1], closed) ? Turn : Keep;
  std::size_t turned = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (state[t] != wrong) continue;
    std::swap(triangles[t][1], triangles[t][2]);
    ++turned;
  }
  return turned;
}

/// Half the triangle's longest side, as its number, and whether the height on it is as good as nothing.
struct Flatness {
  HalfEdge longest = 0;
  bool flat = false;
};
Flatness flatness(const std::vector<Point3>& points, const Triangle& t, double flat) {
  Flatness found;
  double most = -1.0;
  for (HalfEdge k = 0; k < 3; ++k) {
    const double side = geom::distance(points[t[k]], points[t[(k + 1) % 3]]);
    if (side > most) most = side, found.longest = k;
  }
  const double twice = geom::length(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
  found.flat = !(twice > flat * most * most);
  return found;
}

/// Of a polygon seen along the axis nearest to its normal, anticlockwise.
std::vector<geom::Point> seen_along_normal(const std::vector<Point3>& points, const std::vector<std::uint32_t>& face) {
  std::vector<Point3> corners;
  for (const std::uint32_t corner : face) corners.push_back(points[corner]);
  const Point3 n = dobra::mesh::newell_area(corners);
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  std::vector<geom::Point> flat;
  for (const Point3 p : corners) {
    geom::Point q{p.x, p.y};
    bool over = n.z < 0.0;
    if (x >= y && x >= z)
      q = {p.y, p.z}, over = n.x < 0.0;
    else if (y >= z)
      q = {p.z, p.x}, over = n.y < 0.0;
    flat.push_back(over ? geom::Point{q.y, q.x} : q);
  }
  return flat;
}

/// Each corner turns to the left: every diagonal is inside.
bool turns_one_way(const std::vector<Point3>& points, const std::vector<std::uint32_t>& face) {
  const std::vector<geom::Point> at = seen_along_normal(points, face);
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (geom::orient2d(at[i], at[(i + 1) % at.size()], at[(i + 2) % at.size()]) != geom::Sign::Positive) return false;
  }
  return true;
}

/// The ear of greatest alpha first: a corner whose triangle turns left and has no other corner in it. Where there is
/// none, as in polygons that cross themselves, the rest is a fan.
void cut_by_ears(const std::vector<Point3>& points, std::vector<std::uint32_t> face, std::vector<Triangle>& triangles) {
  std::vector<geom::Point> at = seen_along_normal(points, face);
  const auto is_ear = [&](std::size_t i, std::size_t before, std::size_t after) {
    const geom::Point a = at[before], b = at[i], c = at[after];
    if (geom::orient2d(a, b, c) != geom::Sign::Positive) return false;
    for (std::size_t k = 0; k < at.size(); ++k) {
      if (k == before || k == i || k == after) continue;
      if (geom::orient2d(a, b, at[k]) != geom::Sign::Negative && geom::orient2d(b, c, at[k]) != geom::Sign::Negative &&
          geom::orient2d(c, a, at[k]) != geom::Sign::Negative)
        return false;
    }
    return true;
  };
  while (face.size() > 3) {
    const std::size_t n = face.size();
    std::size_t best = n;
    double most = -1.0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
      if (!is_ear(i, before, after)) continue;
      const double alpha = dobra::mesh::alpha_in_space(points[face[before]], points[face[i]], points[face[after]]);
      if (alpha > most) most = alpha, best = i;
    }
    if (best == n) break;
    triangles.push_back({face[(best + n - 1) % n], face[best], face[(best + 1) % n]});
    face.erase(face.begin() + static_cast<std::ptrdiff_t>(best));
    at.erase(at.begin() + static_cast<std::ptrdiff_t>(best));
  }
  for (std::size_t i = 1; i + 1 < face.size(); ++i) triangles.push_back({face[0], face[i], face[i + 1]});
}

/// Seen along the axis nearest to the normal of the greatest triangle at its first corner: unlike the mean normal, that
/// of a bow-tie is not nought.
std::vector<geom::Point> seen_along_greatest(const std::vector<Point3>& points,
                                             const std::vector<std::uint32_t>& face) {
  geom::Vector3 n{};
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    const geom::Vector3 here = cross(points[face[i]] - points[face[0]], points[face[i + 1]] - points[face[0]]);
    if (geom::length(here) > geom::length(n)) n = here;
  }
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  std::vector<geom::Point> flat;
  for (const std::uint32_t corner : face) {
    const Point3 p = points[corner];
    flat.push_back(x >= y && x >= z ? geom::Point{p.y, p.z} : y >= z ? geom::Point{p.z, p.x} : geom::Point{p.x, p.y});
  }
  return flat;
}

/// Where two sides of a face pass through each other; sides of warped faces that pass far from each other do not.
std::optional<Point3> crossing_of(const std::vector<Point3>& points, const std::vector<std::uint32_t>& face) {
  constexpr double near = 0.1;  // of the shorter side
  const std::vector<geom::Point> at = seen_along_greatest(points, face);
  const std::size_t n = face.size();
  const auto sign = [](geom::Point a, geom::Point b, geom::Point c) {
    return static_cast<int>(geom::orient2d(a, b, c));
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i + 2; k < n; ++k) {
      const std::size_t j = (i + 1) % n, l = (k + 1) % n;
      if (l == i || sign(at[i], at[j], at[k]) * sign(at[i], at[j], at[l]) >= 0 ||
          sign(at[k], at[l], at[i]) * sign(at[k], at[l], at[j]) >= 0)
        continue;
      const geom::Vector along = at[j] - at[i], other = at[l] - at[k];
      const double turn = cross(along, other);
      const double s = cross(at[k] - at[i], other) / turn, t = cross(at[k] - at[i], along) / turn;
      const geom::Vector3 one = points[face[j]] - points[face[i]], two = points[face[l]] - points[face[k]];
      const Point3 here = points[face[i]] + s * one, there = points[face[k]] + t * two;
      if (geom::distance(here, there) <= near * std::min(geom::length(one), geom::length(two))) return here;
    }
  }
  return std::nullopt;
}

bool has(const Triangle& t, std::uint32_t v) { return v == t[0] || v == t[1] || v == t[2]; }

/// Removes the area-less triangle t: its longest side is flipped, on the border the triangle is left out.
/// @error BadMesh
base::Result<void> mend_one(const std::vector<Point3>& points, std::vector<Triangle>& triangles, std::size_t t,
                            HalfEdge longest, double flat) {
  const std::uint32_t a = triangles[t][longest], b = triangles[t][(longest + 1) % 3],
                      c = triangles[t][(longest + 2) % 3];
  std::optional<std::size_t> other;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    if (k != t && has(triangles[k], a) && has(triangles[k], b)) other = k;
  }
  if (!other) {
    triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(t));
    return {};
  }
  std::uint32_t d = a;
  for (const std::uint32_t v : triangles[*other]) d = v != a && v != b ? v : d;
  const bool taken = std::any_of(triangles.begin(), triangles.end(),
                                 [&](const Triangle& each) { return has(each, c) && has(each, d); });
  const Triangle one{a, d, c}, two{d, b, c};
  if (taken || flatness(points, one, flat).flat || flatness(points, two, flat).flat) {
    return refused(
        fmt::format("a triangle of points {}, {} and {} has no area, and no flip of a side mends it", a, b, c),
        points[c]);
  }
  triangles[t] = one;
  triangles[*other] = two;
  return {};
}

/// @return how many triangles without area were there  @cost O(n) for each of them
base::Result<std::size_t> mend_flat(const std::vector<Point3>& points, std::vector<Triangle>& triangles, double flat) {
  std::size_t mended = 0;
  for (std::size_t t = 0; t < triangles.size();) {
    const Flatness here = flatness(points, triangles[t], flat);
    if (here.flat) {
      DOBRA_TRY_VOID(mend_one(points, triangles, t, here.longest, flat));
      ++mended;
    } else {
      ++t;
    }
  }
  return mended;
}

}  // namespace

std::vector<HalfEdge> Sheet::first_half_edges() const {
  std::vector<HalfEdge> first(points.size(), no_half_edge);
  for (HalfEdge h = 0; h < twins.size(); ++h) {
    if (first[start(h)] == no_half_edge || twins[h] == no_half_edge) first[start(h)] = h;
  }
  return first;
}

base::Result<Sheet> connect(std::vector<Point3> points, std::vector<Triangle> triangles) {
  DOBRA_TRY(std::vector<HalfEdge> twins, pair_up(points, triangles));
  return connect(std::move(points), std::move(triangles), std::move(twins));
}

base::Result<Sheet> connect(std::vector<Point3> points, std::vector<Triangle> triangles, std::vector<HalfEdge> twins) {
  Sheet sheet{std::move(points), std::move(triangles), std::move(twins), {}};
  // Each vertex has one fan: as many half-edges start there as are met by turning round it from the first.
  std::vector<std::uint32_t> degree(sheet.points.size(), 0), out(sheet.points.size(), no_half_edge);
  for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
    ++degree[sheet.start(h)];
    if (sheet.twins[h] != no_half_edge) continue;
    if (out[sheet.start(h)] != no_half_edge) {
      return refused(fmt::format("parts of the mesh meet in point {} alone; part them there", sheet.start(h)),
                     sheet.points[sheet.start(h)]);
    }
    out[sheet.start(h)] = h;
  }
  const std::vector<HalfEdge> first = sheet.first_half_edges();
  for (std::uint32_t v = 0; v < sheet.points.size(); ++v) {
    std::uint32_t met = 0;
    HalfEdge h = first[v];
    do {
      ++met;
      h = sheet.twins[previous(h)];
    } while (h != no_half_edge && h != first[v] && met <= degree[v]);
    if (met != degree[v])
      return refused(fmt::format("parts of the mesh meet in point {} alone; part them there", v), sheet.points[v]);
  }
  std::vector<bool> seen(sheet.points.size(), false);
  for (std::uint32_t v = 0; v < sheet.points.size(); ++v) {
    if (out[v] == no_half_edge || seen[v]) continue;
    std::vector<std::uint32_t> loop;
    for (std::uint32_t w = v; !seen[w]; w = sheet.end(out[w])) {
      seen[w] = true;
      loop.push_back(w);
    }
    sheet.loops.push_back(std::move(loop));
  }
  return sheet;
}

namespace {

/// Triangles of the polygons of a file, each point at its place once, none doubled. @error NotFinite, BadMesh
struct Soup {
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
  Mended mended;
};
base::Result<Soup> soup_of(const dobra::mesh::PolygonMesh& mesh) {
  Soup soup;
  soup.points = mesh.points;
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    if (!geom::is_finite(soup.points[i]))
      return Error{ErrorCode::NotFinite, fmt::format("point {} of the mesh is not finite", i)};
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    for (const std::uint32_t corner : face) {
      if (corner >= soup.points.size())
        return Error{ErrorCode::BadMesh, fmt::format("a face names point {} of {}", corner, soup.points.size())};
    }
    if (face.size() > 3) {
      if (const auto crossing = crossing_of(soup.points, face)) {
        return refused(fmt::format("two sides of face {} cross, as in a bow-tie: give its corners in their order "
                                   "round it, or make two faces of it",
                                   f),
                       *crossing);
      }
    }
    soup.mended.cut += face.size() > 3 ? 1 : 0;
    if (face.size() > 4 || (face.size() == 4 && !turns_one_way(soup.points, face))) {
      cut_by_ears(soup.points, face, soup.triangles);
      continue;
    }
    const bool other = face.size() == 4 && geom::distance(soup.points[face[1]], soup.points[face[3]]) <
                                               geom::distance(soup.points[face[0]], soup.points[face[2]]);
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      if (other)
        soup.triangles.push_back({face[1], face[i == 1 ? 2 : 3], face[i == 1 ? 3 : 0]});
      else
        soup.triangles.push_back({face[0], face[i], face[i + 1]});
    }
  }
  soup.mended.merged = merge_points(soup.points, soup.triangles);
  soup.mended.dropped = drop_repeated(soup.triangles);
  if (soup.triangles.empty()) return Error{ErrorCode::BadMesh, "the mesh has no triangle"};
  return soup;
}

/// @pre one piece at most that sides join
base::Result<SheetMade> sheet_of_soup(Soup soup, const SheetOptions& options) {
  SheetMade made{{}, soup.mended};
  DOBRA_TRY(made.mended.turned, turn_alike(soup.points, soup.triangles));
  DOBRA_TRY(made.mended.flipped, mend_flat(soup.points, soup.triangles, options.flat));
  if (soup.triangles.empty()) return Error{ErrorCode::BadMesh, "no triangle of the mesh has an area"};
  // Merged points are among those without a triangle.
  made.mended.unused = drop_unused(soup.points, soup.triangles) - made.mended.merged;
  DOBRA_TRY(made.sheet, connect(std::move(soup.points), std::move(soup.triangles)));
  return made;
}

/// A piece for itself; a point has one copy for each fan of its triangles.
/// @param fans  one a point: how many so far
Soup piece_of(const Soup& soup, const std::vector<std::uint32_t>& triangles, const std::vector<HalfEdge>& twins,
              std::vector<std::uint32_t>& number, std::vector<std::uint32_t>& fans) {
  Soup piece;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) number[triangles[i]] = i;
  base::DisjointSets same(3 * triangles.size());
  for (HalfEdge h = 0; h < same.size(); ++h) {
    const Triangle& here = soup.triangles[triangles[h / 3]];
    const HalfEdge twin = twins[3 * triangles[h / 3] + h % 3];
    if (twin == no_half_edge) continue;
    const Triangle& there = soup.triangles[twin / 3];
    for (const HalfEdge corner : {h, next(h)}) {
      for (const HalfEdge other : {twin, next(twin)}) {
        if (here[corner % 3] == there[other % 3]) same.join(corner, 3 * number[twin / 3] + other % 3);
      }
    }
  }
  std::vector<std::uint32_t> point(same.size(), no_half_edge);
  piece.triangles.resize(triangles.size());
  for (HalfEdge h = 0; h < same.size(); ++h) {
    const std::uint32_t v = soup.triangles[triangles[h / 3]][h % 3];
    std::uint32_t& mine = point[same.root(h)];
    if (mine == no_half_edge) {
      mine = static_cast<std::uint32_t>(piece.points.size());
      piece.points.push_back(soup.points[v]);
      ++fans[v];
    }
    piece.triangles[h / 3][h % 3] = mine;
  }
  return piece;
}

}  // namespace

base::Result<SheetMade> sheet_of(const dobra::mesh::PolygonMesh& mesh, const SheetOptions& options) {
  DOBRA_TRY(Soup soup, soup_of(mesh));
  return sheet_of_soup(std::move(soup), options);
}

base::Result<std::vector<SheetMade>> sheets_of(const dobra::mesh::PolygonMesh& mesh, const SheetOptions& options) {
  DOBRA_TRY(Soup soup, soup_of(mesh));
  DOBRA_TRY(const std::vector<HalfEdge> twins, pair_up(soup.points, soup.triangles));
  base::DisjointSets joined(soup.triangles.size());
  for (HalfEdge h = 0; h < twins.size(); ++h) {
    if (twins[h] != no_half_edge) joined.join(h / 3, twins[h] / 3);
  }
  std::vector<std::vector<std::uint32_t>> pieces;
  std::vector<std::size_t> piece(soup.triangles.size());
  for (std::uint32_t t = 0; t < piece.size(); ++t) {
    const std::size_t root = joined.root(t);
    if (root == t) piece[t] = pieces.size(), pieces.emplace_back();
    pieces[piece[root]].push_back(t);
  }
  std::vector<SheetMade> sheets;
  std::vector<std::uint32_t> number(piece.size(), no_half_edge), fans(soup.points.size(), 0);
  for (const auto& triangles : pieces) {
    DOBRA_TRY(SheetMade made, sheet_of_soup(piece_of(soup, triangles, twins, number, fans), options));
    sheets.push_back(std::move(made));
  }
  // Of the whole, told with the first piece.
  Mended& first = sheets.front().mended;
  first.merged += soup.mended.merged, first.dropped += soup.mended.dropped, first.cut += soup.mended.cut;
  for (std::size_t v = 0; v < fans.size(); ++v) {
    if (fans[v] < 2) continue;
    first.parted += fans[v] - 1;
    first.parted_at.push_back(soup.points[v]);
  }
  first.unused += drop_unused(soup.points, soup.triangles) - soup.mended.merged;
  return sheets;
}

}  // namespace dobra::surf::param
