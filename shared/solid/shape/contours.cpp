#include "shared/solid/shape/contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "shared/geom/intersect.h"
#include "shared/geom/predicates.h"

namespace dobra::solid::shape {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;

namespace {

base::Place in_plane(Point p) { return {.x = p.x, .y = p.y}; }

/// Of a contour, the side that leaves corner i.
struct ContourSide {
  geom::Segment line;
  std::size_t contour = 0, i = 0;
};

void add_contour(const geom::Polyline& line, std::size_t contour, std::vector<ContourSide>& sides) {
  const std::size_t n = line.points.size();
  for (std::size_t i = 0; i < n; ++i) sides.push_back({{line.points[i], line.points[(i + 1) % n]}, contour, i});
}

/// Calls of(first, second, intersection) for sides that meet, the first before the second in the order given, until it
/// is true.
template <class Of>
void for_meetings(const std::vector<ContourSide>& sides, Of&& of) {
  const auto low = [&](std::size_t s) { return std::min(sides[s].line.from.x, sides[s].line.to.x); };
  const auto high = [&](std::size_t s) { return std::max(sides[s].line.from.x, sides[s].line.to.x); };
  std::vector<std::size_t> order(sides.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t s, std::size_t t) { return std::pair(low(s), s) < std::pair(low(t), t); });
  std::vector<std::size_t> open;
  for (const std::size_t s : order) {
    std::erase_if(open, [&](std::size_t t) { return high(t) < low(s); });
    for (const std::size_t t : open) {
      const ContourSide& first = sides[std::min(s, t)];
      const ContourSide& second = sides[std::max(s, t)];
      const geom::Intersection met = geom::intersect(first.line, second.line);
      if (met.kind != geom::IntersectionKind::None) of(first, second, met);
    }
    open.push_back(s);
  }
}

/// Sides of a contour with n corners meet where they must not.
bool must_not_meet(const ContourSide& first, const ContourSide& second, const geom::Intersection& met, std::size_t n,
                   Touching touching) {
  if (met.kind == geom::IntersectionKind::Overlap) return true;
  const bool neighbours = first.i + 1 == second.i || (first.i == 0 && second.i + 1 == n);
  return !neighbours && (touching == Touching::No || met.start.proper());
}

/// The first two sides that meet where they must not.
std::optional<Error> crossing_of(const geom::Polyline& line, const char* what, Touching touching) {
  std::vector<ContourSide> sides;
  add_contour(line, 0, sides);
  std::optional<std::array<std::size_t, 2>> least;
  Point at;
  for_meetings(sides, [&](const ContourSide& first, const ContourSide& second, const geom::Intersection& met) {
    const std::array pair{first.i, second.i};
    if (!must_not_meet(first, second, met, sides.size(), touching) || (least && *least < pair)) return;
    least = pair;
    at = met.start.point;
  });
  if (!least) return std::nullopt;
  return Error{
      ErrorCode::SelfIntersection,
      fmt::format("the {} crosses or touches itself: its sides {} and {} meet", what, (*least)[0] + 1, (*least)[1] + 1),
      in_plane(at)};
}

bool surrounds(const geom::Polyline& line, Point p) {
  bool inside = false;
  const std::size_t n = line.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = line.points[i];
    const Point b = line.points[(i + 1) % n];
    if ((a.y > p.y) != (b.y > p.y) && (geom::orient2d(a, b, p) == geom::Sign::Positive) == (b.y > p.y))
      inside = !inside;
  }
  return inside;
}

/// A corner of the hole that is none of the other contour.
std::optional<Point> own_corner(const geom::Polyline& hole, const geom::Polyline& other) {
  for (const Point p : hole.points) {
    if (std::find(other.points.begin(), other.points.end(), p) == other.points.end()) return p;
  }
  return std::nullopt;
}

/// Why holes do not lie within the outline, each beside the others. They may touch in corners.
Result<void> check_holes(const Profile& profile) {
  std::vector<ContourSide> sides;
  add_contour(profile.outline, 0, sides);
  for (std::size_t h = 0; h < profile.holes.size(); ++h) add_contour(profile.holes[h], h + 1, sides);
  std::optional<std::array<std::size_t, 4>> least;
  Point at;
  for_meetings(sides, [&](const ContourSide& first, const ContourSide& second, const geom::Intersection& met) {
    const bool corners = met.kind == geom::IntersectionKind::Point && met.start.on_first != geom::At::Interior &&
                         met.start.on_second != geom::At::Interior;
    const std::array pair{first.contour, second.contour, first.i, second.i};
    if (first.contour == second.contour || corners || (least && *least < pair)) return;
    least = pair;
    at = met.start.point;
  });
  const auto refuse = [](const std::string& what, Point where) {
    return Error{ErrorCode::SelfIntersection, what, in_plane(where)};
  };
  if (least && (*least)[0] == 0)
    return refuse(fmt::format("hole {} of the profile meets the outline: holes lie within it", (*least)[1]), at);
  if (least) {
    return refuse(
        fmt::format("holes {} and {} of the profile meet: holes lie beside each other", (*least)[0], (*least)[1]), at);
  }
  for (std::size_t h = 0; h < profile.holes.size(); ++h) {
    const geom::Polyline& hole = profile.holes[h];
    if (const auto p = own_corner(hole, profile.outline); p && !surrounds(profile.outline, *p))
      return refuse(fmt::format("hole {} of the profile lies outside the outline", h + 1), *p);
    for (std::size_t other = 0; other < profile.holes.size(); ++other) {
      const auto p = other == h ? std::nullopt : own_corner(hole, profile.holes[other]);
      if (!p || !surrounds(profile.holes[other], *p)) continue;
      return refuse(
          fmt::format("hole {} of the profile lies within hole {}: holes lie beside each other", h + 1, other + 1), *p);
    }
  }
  return {};
}

}  // namespace

Result<void> check_contour(const geom::Polyline& line, const char* what, Touching touching) {
  const std::size_t n = line.points.size();
  const auto refuse = [&](ErrorCode code, const std::string& why, std::optional<base::Place> place = std::nullopt) {
    return Error{code, fmt::format("the {} {}", what, why), std::move(place)};
  };
  if (n < 3) return refuse(ErrorCode::DegenerateCurve, fmt::format("has {} points and needs three or more", n));
  for (std::size_t i = 0; i < n; ++i) {
    const Point p = line.points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y))
      return refuse(ErrorCode::NotFinite, fmt::format("has no finite number at point {}", i + 1));
    if (p == line.points[(i + 1) % n]) {
      return refuse(ErrorCode::DegenerateCurve,
                    fmt::format("has point {} at the place of the one before it; leave it out (the last point of a "
                                "contour is joined to its first by itself)",
                                (i + 1) % n + 1),
                    in_plane(p));
    }
  }
  const bool straight = std::all_of(line.points.begin(), line.points.end(), [&](Point p) {
    return geom::orient2d(line.points[0], line.points[1], p) == geom::Sign::Zero;
  });
  if (straight) return refuse(ErrorCode::DegenerateCurve, "has no area: give corners that surround one");
  if (auto crossing = crossing_of(line, what, touching)) return *std::move(crossing);
  if (geom::signed_area({line.points, true}) == 0.0)
    return refuse(ErrorCode::DegenerateCurve, "has no area: give corners that surround one");
  return {};
}

Result<void> check_apart(const Maker& maker, const Rings& rings) {
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t j = (i + 1) % ring.size();
      if (maker.points()[ring[i]] != maker.points()[ring[j]]) continue;
      return Error{ErrorCode::InvalidOption,
                   fmt::format("points {} and {} of a contour fall together where it is moved to, as coordinates are "
                               "rounded there: move it less far, or draw it larger",
                               std::min(i, j) + 1, std::max(i, j) + 1),
                   at_point(maker.points()[ring[i]])};
    }
  }
  return {};
}

/// Anticlockwise, or clockwise for a hole.
Contour turned_contour(const geom::Polyline& line, bool hole, SideNames names, const std::string& stem) {
  Contour contour{line.points, {}};
  const std::size_t n = contour.points.size();
  for (std::size_t i = 0; i < n; ++i)
    contour.names.push_back(names == SideNames::Each && !hole ? fmt::format("{}_{}", stem, i + 1) : stem);
  if ((geom::signed_area({line.points, true}) > 0.0) == hole) {
    std::reverse(contour.points.begin(), contour.points.end());
    // The side that leaves a corner is now the one that came to it.
    std::reverse(contour.names.begin(), contour.names.end());
    std::rotate(contour.names.begin(), contour.names.begin() + 1, contour.names.end());
  }
  return contour;
}

Result<std::vector<Contour>> contours_of(const Profile& profile, SideNames names) {
  DOBRA_TRY_VOID(check_contour(profile.outline, "outline of the profile"));
  std::vector<Contour> contours{turned_contour(profile.outline, false, names, "side")};
  for (std::size_t i = 0; i < profile.holes.size(); ++i) {
    DOBRA_TRY_VOID(check_contour(profile.holes[i], "hole of the profile"));
    contours.push_back(turned_contour(profile.holes[i], true, names,
                                      names == SideNames::Each ? fmt::format("hole_{}", i + 1) : "hole"));
  }
  if (!profile.holes.empty()) DOBRA_TRY_VOID(check_holes(profile));
  return contours;
}

}  // namespace dobra::solid::shape
