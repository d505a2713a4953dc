#include "shared/solid/shape/loft.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

#include "shared/solid/shape/bands.h"
#include "shared/solid/shape/contours.h"
#include "shared/solid/shape/section_map.h"

namespace dobra::solid::shape {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Point3;
using geom::Vector3;

/// Half the integral of a x db, where chains are walked together from 0 to 1: round a contour the area that lies
/// between its two copies, as a vector. It is that of the contour where they are equal, and what is turned by an angle
/// has the cosine of it.
Vector3 mixed_area(const std::vector<Point3>& points, const Chain& a, const Chain& b) {
  const auto on = [&](const Chain& chain, std::size_t i, double s) {
    const Point3 from = points[chain.points[i]];
    const double part = (s - chain.at[i]) / (chain.at[i + 1] - chain.at[i]);
    return from + part * (points[chain.points[i + 1]] - from);
  };
  const Point3 a_origin = points[a.points[0]];
  Vector3 sum{};
  double s = a.at[0];
  for (std::size_t i = 0, j = 0; i + 1 < a.points.size() && j + 1 < b.points.size();) {
    const double next = std::min(a.at[i + 1], b.at[j + 1]);
    if (next > s) sum = sum + cross(on(a, i, 0.5 * (s + next)) - a_origin, on(b, j, next) - on(b, j, s));
    s = next;
    if (a.at[i + 1] <= s) ++i;
    if (b.at[j + 1] <= s) ++j;
  }
  return 0.5 * (sum + cross(a_origin - points[0], points[b.points.back()] - points[b.points.front()]));
}

/// The fractions of a line's length; of an island the last is its first point once more.
std::vector<double> fractions(const geom::Polyline& line) {
  std::vector<double> at = geom::arc_lengths(line);
  const double whole = at.back();
  for (double& s : at) s /= whole;
  at.back() = 1.0;
  return at;
}

/// The points of a line and of the places between its vertices; an island comes back to its first point.
std::vector<Point> with_breaks(const geom::Polyline& line, const std::vector<double>& at,
                               const std::vector<double>& breaks) {
  std::vector<Point> points;
  std::size_t i = 0;
  for (const double s : breaks) {
    while (i + 1 < at.size() && at[i + 1] <= s) ++i;
    const Point from = line.points[i % line.points.size()];
    points.push_back(at[i] == s ? from
                                : geom::interpolate(from, line.points[(i + 1) % line.points.size()],
                                                    (s - at[i]) / (at[i + 1] - at[i])));
  }
  return points;
}

/// The island begins at the corner that stands nearest to the first corner of the other, centre on centre.
geom::Polyline turned_towards(const geom::Polyline& other, geom::Polyline island) {
  const auto centre = [](const geom::Polyline& line) {
    Point sum{0, 0};
    for (const Point p : line.points) sum = {sum.x + p.x, sum.y + p.y};
    const auto n = static_cast<double>(line.points.size());
    return Point{sum.x / n, sum.y / n};
  };
  const Point here = centre(other);
  const Point there = centre(island);
  const auto off = [&](Point p) {
    return std::hypot(p.x - there.x - other.points[0].x + here.x, p.y - there.y - other.points[0].y + here.y);
  };
  const auto first =
      std::min_element(island.points.begin(), island.points.end(), [&](Point p, Point q) { return off(p) < off(q); });
  std::rotate(island.points.begin(), first, island.points.end());
  return island;
}

Vector3 normal_of(const SectionFrame& frame) { return cross(frame.along, frame.up); }

/// Whether the next section lies on the side from which the first is looked at; none where they cross.
Result<bool> ahead(const LoftSection& here, const LoftSection& there, std::size_t number) {
  const Vector3 n = normal_of(here.frame);
  if (!(dot(n, normal_of(there.frame)) > 0.0)) {
    return Error{ErrorCode::InvalidOption,
                 fmt::format("section {} is looked at from the other side than section {}, or square to it: turn it "
                             "round",
                             number + 1, number),
                 base::Place{.x = there.frame.origin.x, .y = there.frame.origin.y, .z = there.frame.origin.z}};
  }
  std::optional<bool> side;
  const auto look = [&](const LoftSection& from, const LoftSection& at, bool back) -> Result<void> {
    for (const LoftLine& line : at.lines) {
      for (const Point p : line.line.points) {
        const double off = dot(at.frame.in_space(p) - from.frame.origin, normal_of(from.frame));
        const bool up = (off > 0.0) != back;
        if (off != 0.0 && (!side || *side == up)) {
          side = up;
          continue;
        }
        const std::size_t which = back ? number - 1 : number;
        return section_error(which, at.frame, p,
                             fmt::format("it crosses or touches section {} here: sections that are joined stand apart",
                                         (back ? number : number - 1) + 1));
      }
    }
    return {};
  };
  DOBRA_TRY_VOID(look(here, there, false));
  DOBRA_TRY_VOID(look(there, here, true));
  return side.value_or(true);
}

class SectionsLofter {
 public:
  SectionsLofter(std::span<const LoftSection> sections, const LoftOptions& options)
      : sections_(sections), options_(options) {}

  Result<std::vector<LoftPart>> run() {
    if (sections_.size() < 2) return Error{ErrorCode::InvalidOption, "a loft needs two sections or more"};
    for (std::size_t k = 0; k < sections_.size(); ++k) {
      DOBRA_TRY(auto map, section_map(sections_[k], k));
      maps_.push_back(std::move(map));
    }
    std::vector<Dart> identity(maps_[0].next.size());
    for (Dart d = 0; d < identity.size(); ++d) identity[d] = d;
    darts_.push_back(std::move(identity));
    for (std::size_t k = 1; k < sections_.size(); ++k) {
      DOBRA_TRY(const bool up, ahead(sections_[k - 1], sections_[k], k));
      if (k > 1 && up != up_) {
        return section_error(k, sections_[k].frame, maps_[k].origin(0),
                             fmt::format("it lies on the side of section {} on which section {} lies: give sections in "
                                         "the order in which they stand",
                                         k, k - 1));
      }
      up_ = up;
      DOBRA_TRY(const auto onto, laid_onto(maps_[k - 1], maps_[k], k));
      std::vector<Dart> darts;
      for (const Dart d : darts_.back()) darts.push_back(onto[d]);
      darts_.push_back(std::move(darts));
    }
    place_lines();
    DOBRA_TRY_VOID(check_turns());
    std::vector<LoftPart> parts;
    for (std::uint32_t r = 0; r < maps_[0].regions.size(); ++r) parts.push_back(part(r));
    return parts;
  }

 private:
  struct PointOrder {
    bool operator()(Point a, Point b) const { return a.x != b.x ? a.x < b.x : a.y < b.y; }
  };

  /// The chains of all lines in all sections, and the bands between them.
  void place_lines() {
    chains_.assign(maps_.size(), std::vector<Chain>(maps_[0].lines.size()));
    std::vector<std::map<Point, std::uint32_t, PointOrder>> numbers(maps_.size());
    std::vector<RuledLines> rulings;
    for (std::size_t i = 0; i < maps_[0].lines.size(); ++i) {
      const std::vector<geom::Polyline> lines = copies_of(i);
      std::vector<std::vector<double>> at;
      std::vector<std::vector<Joint>> joints;
      for (const geom::Polyline& line : lines) at.push_back(fractions(line));
      for (std::size_t k = 1; k < lines.size(); ++k) joints.push_back(joints_of(lines[k - 1], lines[k]));
      const RuledLines& made = rulings.emplace_back(ruled(at, joints));
      for (std::size_t k = 0; k < lines.size(); ++k) {
        Chain& chain = chains_[k][i];
        chain.at = made.breaks[k];
        for (const Point p : with_breaks(lines[k], at[k], chain.at)) {
          const auto [known, fresh] = numbers[k].try_emplace(p, static_cast<std::uint32_t>(points_.size()));
          if (fresh) points_.push_back(maps_[k].frame.in_space(p));
          chain.points.push_back(known->second);
        }
      }
    }
    for (std::size_t i = 0; i < rulings.size(); ++i) {
      auto& triangles = bands_.emplace_back();
      for (std::size_t k = 1; k < chains_.size(); ++k) {
        const auto next = band(points_, chains_[k - 1][i], chains_[k][i], rulings[i].rulings[k - 1]);
        triangles.insert(triangles.end(), next.begin(), next.end());
      }
    }
  }

  /// What stands for a line of the first section, in each section, in its direction.
  [[nodiscard]] std::vector<geom::Polyline> copies_of(std::size_t i) const {
    std::vector<geom::Polyline> lines;
    for (std::size_t k = 0; k < maps_.size(); ++k) {
      const Dart here = darts_[k][2 * i];
      geom::Polyline line = maps_[k].lines[here / 2].line;
      if ((here & 1U) != 0) line = geom::reversed(std::move(line));
      if (line.closed && k > 0) line = turned_towards(lines.back(), std::move(line));
      lines.push_back(std::move(line));
    }
    return lines;
  }

  /// Whatever hangs together is turned by less than a right angle from each section to the next.
  [[nodiscard]] Result<void> check_turns() const {
    for (std::size_t k = 1; k < chains_.size(); ++k) {
      const Vector3 n = normal_of(maps_[k - 1].frame);
      std::vector<double> area(maps_[0].component_count, 0.0);
      for (const auto& region : maps_[0].regions) {
        for (const Dart d : maps_[0].loop(region.loops[0])) {
          const double half = dot(n, mixed_area(points_, chains_[k - 1][d / 2], chains_[k][d / 2]));
          area[maps_[0].component[d / 2]] += (d & 1U) == 0 ? half : -half;
        }
      }
      for (const auto& region : maps_[0].regions) {
        const Dart d = region.loops[0];
        if (area[maps_[0].component[d / 2]] > 0.0) continue;
        return section_error(k, maps_[k].frame, maps_[k].origin(darts_[k][d]),
                             fmt::format("its lines are turned against those of section {}, as if its trace were drawn "
                                         "from the other end: turn it round",
                                         k));
      }
    }
    return {};
  }

  /// The loops of the region in a section, seen from where it is looked at.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> end_of(std::uint32_t region, std::size_t k) const {
    std::vector<std::vector<std::uint32_t>> loops;
    for (const Dart first : maps_[0].regions[region].loops) {
      auto& loop = loops.emplace_back();
      for (const Dart d : maps_[0].loop(first)) {
        std::vector<std::uint32_t> points = chains_[k][d / 2].points;
        if ((d & 1U) != 0) std::reverse(points.begin(), points.end());
        loop.insert(loop.end(), points.begin(), points.end() - 1);
      }
    }
    return loops;
  }

  [[nodiscard]] LoftPart part(std::uint32_t region) const {
    LoftPart part{maps_[0].regions[region].name, {}};
    std::unordered_map<std::uint32_t, std::uint32_t> numbers;
    const auto add = [&](std::vector<std::vector<std::uint32_t>> loops, bool turned, const std::string& name) {
      for (auto& loop : loops) {
        if (turned) std::reverse(loop.begin(), loop.end());
        for (std::uint32_t& p : loop) {
          const auto [at, fresh] = numbers.try_emplace(p, static_cast<std::uint32_t>(part.shape.mesh.points.size()));
          if (fresh) part.shape.mesh.points.push_back(points_[p]);
          p = at->second;
        }
      }
      part.shape.mesh.faces.push_back(std::move(loops));
      part.shape.names.push_back(name);
    };
    add(end_of(region, 0), up_, options_.start);
    add(end_of(region, chains_.size() - 1), !up_, options_.end);
    for (const Dart first : maps_[0].regions[region].loops) {
      for (const Dart d : maps_[0].loop(first)) {
        if (maps_[0].region_of[twin(d)] == region) continue;  // the region goes on beyond it
        for (const auto& [t, segment] : bands_[d / 2])
          add({{t[0], t[1], t[2]}}, ((d & 1U) != 0) == up_, maps_[0].lines[d / 2].name);
      }
    }
    return part;
  }

  std::span<const LoftSection> sections_;
  LoftOptions options_;
  std::vector<SectionMap> maps_;
  std::vector<std::vector<Dart>> darts_;  // of each section, what stands for the first one's
  bool up_ = true;                        // the sections follow each other towards who looks at them
  std::vector<Point3> points_;
  std::vector<std::vector<Chain>> chains_;  // of each section, each line of the first
  std::vector<std::vector<BandTriangle>> bands_;
};

/// The contour with its first corner there, also where it had to be turned round.
void begin_at(Contour& contour, Point first) {
  const auto by = std::find(contour.points.begin(), contour.points.end(), first) - contour.points.begin();
  std::rotate(contour.points.begin(), contour.points.begin() + by, contour.points.end());
  std::rotate(contour.names.begin(), contour.names.begin() + by, contour.names.end());
}

/// Every profile has its neighbours on one side each: the one before it behind, the one after it in front.
Result<void> check_order(std::span<const PlacedProfile> profiles, const std::vector<Rings>& rings, const Maker& maker) {
  for (std::size_t k = 0; k < profiles.size(); ++k) {
    const Matrix& m = profiles[k].place;
    const Point3 origin{m[3], m[7], m[11]};
    const Vector3 up = cross(Vector3{m[0], m[4], m[8]}, Vector3{m[1], m[5], m[9]});
    const auto check = [&](std::size_t l, double way) -> Result<void> {
      for (const Ring& ring : rings[l]) {
        for (const std::uint32_t p : ring) {
          if (way * dot(maker.points()[p] - origin, up) > 0.0) continue;
          constexpr const char* in_front =
              "profile {} has a corner that is not in front of profile {}: profiles stand one in front of the other";
          constexpr const char* behind =
              "profile {} has a corner that is not behind profile {}: profiles stand one in front of the other";
          return Error{ErrorCode::InvalidOption, fmt::format(fmt::runtime(way > 0.0 ? in_front : behind), l + 1, k + 1),
                       at_point(maker.points()[p])};
        }
      }
      return {};
    };
    if (k > 0) DOBRA_TRY_VOID(check(k - 1, -1.0));
    if (k + 1 < profiles.size()) DOBRA_TRY_VOID(check(k + 1, 1.0));
  }
  return {};
}

/// From one contour to the next the area goes as (1 - t)^2 A + 2 t (1 - t) M + t^2 B, which comes to 0 where the mixed
/// area M is minus the mean of A and B.
bool shrinks_to_a_point(const std::vector<Point3>& points, const Chain& a, const Chain& b) {
  constexpr double tolerance = 1e-9;  // of the area: what is turned by half a turn is rounded
  const Vector3 own = mixed_area(points, a, a);
  const double first = dot(own, own);
  const double last = dot(own, mixed_area(points, b, b));
  return dot(own, mixed_area(points, a, b)) <= -(1.0 - tolerance) * std::sqrt(first * std::max(last, 0.0));
}

/// The sides over contour c of all profiles.
Result<void> add_bands(Maker& maker, const std::vector<std::vector<Contour>>& contours, const std::vector<Rings>& rings,
                       std::size_t c, SideNames names) {
  const std::size_t n = contours[0][c].points.size();
  const bool equal =
      std::all_of(contours.begin(), contours.end(), [&](const auto& own) { return own[c].points.size() == n; });
  const auto chain_of = [&](std::size_t k) {
    Chain chain{rings[k][c], {}};
    chain.points.push_back(chain.points.front());
    if (!equal) chain.at = fractions({contours[k][c].points, true});
    for (std::size_t i = 0; equal && i <= n; ++i) chain.at.push_back(static_cast<double>(i));
    return chain;
  };
  for (std::size_t k = 1; k < contours.size(); ++k) {
    const Chain below = chain_of(k - 1);
    const Chain above = chain_of(k);
    if (shrinks_to_a_point(maker.points(), below, above)) {
      return Error{ErrorCode::InvalidOption,
                   fmt::format("profile {} is turned by half a turn against profile {}, so that the solid would shrink "
                               "to a point between them: begin it at the corner that stands over the other's first",
                               k + 1, k),
                   at_point(maker.points()[above.points[0]])};
    }
    std::vector<Point3> points = maker.points();
    const std::size_t known = points.size();
    const auto triangles = equal
                               ? band(points, below, above, ruled({below.at, above.at}, {{{0, 0}, {n, n}}}).rulings[0])
                               : band(points, below, above);
    std::for_each(points.begin() + static_cast<std::ptrdiff_t>(known), points.end(), [&](Point3 p) { maker.point(p); });
    for (const auto& [t, segment] : triangles) {
      const bool own = equal || names == SideNames::One || c > 0;
      maker.face({{t[0], t[1], t[2]}}, own ? contours[0][c].names[equal ? segment : 0] : "side");
    }
  }
  return {};
}

}  // namespace

LoftSection loft_section(const Cap& cap, std::span<const std::string> names) {
  LoftSection section{cap.frame, {}};
  const auto name = [&](std::uint32_t solid) { return solid == outside ? std::string() : names[solid]; };
  for (const CapLine& line : cap.lines)
    section.lines.push_back(
        {line.line, fmt::format("{}", fmt::join(line.names, "+")), name(line.left), name(line.right)});
  return section;
}

Result<std::vector<LoftPart>> loft_sections(std::span<const LoftSection> sections, const LoftOptions& options) {
  return SectionsLofter(sections, options).run();
}

Result<Shape> loft(std::span<const PlacedProfile> profiles, SideNames names) {
  if (profiles.size() < 2) return Error{ErrorCode::InvalidOption, "a loft needs two profiles or more"};
  std::vector<std::vector<Contour>> contours;
  for (std::size_t k = 0; k < profiles.size(); ++k) {
    DOBRA_TRY_VOID(check_matrix(profiles[k].place));
    auto given = contours_of(profiles[k].profile, names);
    if (!given) {
      Error error = put_in_space(given.error(), flat);
      DOBRA_TRY_VOID(put_error(error, profiles[k].place));
      error.message = fmt::format("profile {}: {}", k + 1, error.message);
      return error;
    }
    std::vector<Contour>& own = *given;
    if (k > 0 && own.size() != contours[0].size()) {
      return Error{ErrorCode::InvalidOption,
                   fmt::format("profiles that are joined have as many holes; number {} has {}, and number 1 has {}",
                               k + 1, own.size() - 1, contours[0].size() - 1)};
    }
    for (std::size_t c = 0; c < own.size(); ++c) {
      const geom::Polyline& drawn = c == 0 ? profiles[k].profile.outline : profiles[k].profile.holes[c - 1];
      begin_at(own[c], drawn.points[0]);
    }
    contours.push_back(std::move(own));
  }
  Maker maker;
  std::vector<Rings> rings;
  for (std::size_t k = 0; k < profiles.size(); ++k) {
    Rings& own = rings.emplace_back();
    for (const Contour& contour : contours[k]) {
      std::vector<Point3> points;
      for (const Point p : contour.points) points.push_back(flat(p));
      DOBRA_TRY_VOID(place(points, profiles[k].place));
      Ring& ring = own.emplace_back();
      for (const Point3 p : points) ring.push_back(maker.point(p));
    }
  }
  DOBRA_TRY_VOID(check_order(profiles, rings, maker));
  maker.face(reversed(rings.front()), "start");
  maker.face(rings.back(), "end");
  for (std::size_t c = 0; c < contours[0].size(); ++c) DOBRA_TRY_VOID(add_bands(maker, contours, rings, c, names));
  return maker.take();
}

}  // namespace dobra::solid::shape
