#include "shared/solid/section.h"

#include <algorithm>
#include <bit>
#include <map>
#include <tuple>
#include <unordered_map>

#include "shared/base/parallel.h"
#include "shared/solid/contacts.h"
#include "shared/solid/plane_crossing.h"
#include "shared/topo/adjacency.h"
#include "shared/topo/insert.h"

namespace dobra::solid {
namespace {

using base::Error;
using base::ErrorCode;
using geom::Point3;
using geom::Sign;
using geom::Vector3;

Plane as_plane(const CutPlane& cut) { return {{Point3{cut.a, cut.b, cut.c}, {}, {}}, cut.d}; }

/// Whether a facet's border runs along the axis where the facet is the border of an area on its left, seen from above.
bool runs_forwards(const Space& space, PlaneId cut, PlaneId facet, int axis) {
  const auto i = static_cast<std::size_t>(axis);
  const Vector3 m = space.rough_normal(cut);
  const Vector3 n = space.rough_normal(facet);
  const Vector3 line = cross(m, n);
  const std::array<double, 3> rough{line.x, line.y, line.z};
  if (std::abs(rough[i]) > 1e-3 * length(m) * length(n)) return rough[i] > 0.0;
  return cross(space.normal(cut), space.normal(facet))[i].sign() == Sign::Positive;
}

/// Reads how often each solid surrounds every face of a subdivision off the paths of its lines.
class Areas {
 public:
  Areas(topo::Subdivision& plane, std::size_t solids) : plane_(plane), solids_(solids) {}

  void pass(topo::HalfEdgeId h, std::uint32_t solid) {
    const topo::EdgeId e = topo::Subdivision::edge(h);
    if (last_of_.size() <= e.index()) last_of_.resize(e.index() + 1, none);
    steps_.push_back({solid, topo::Subdivision::half_edge(e) == h ? 1 : -1, last_of_[e.index()]});
    last_of_[e.index()] = static_cast<std::uint32_t>(steps_.size() - 1);
  }

  /// Sets SectionArea, and takes out the edges that have the same on both sides.
  void finish() {
    spread();
    find_overlaps();
    std::vector<topo::EdgeId> idle;
    for (const topo::EdgeId e : plane_.edges()) {
      const topo::HalfEdgeId h = topo::Subdivision::half_edge(e);
      if (area_of(plane_.face(h)) == area_of(plane_.face(topo::Subdivision::twin(h)))) idle.push_back(e);
    }
    for (const topo::FaceId f : plane_.faces()) {
      if (const std::uint32_t solid = area_of(f); solid != none) plane_.attribute(f) = SectionArea{solid};
    }
    for (const topo::EdgeId e : idle) DOBRA_CHECK(topo::remove(plane_, e).ok());
  }

  [[nodiscard]] std::vector<SectionOverlap> overlaps() const {
    std::vector<SectionOverlap> all;
    for (const auto& [pair, overlap] : overlaps_) all.push_back(overlap);
    return all;
  }

 private:
  void find_overlaps() {
    geom::Box box;
    for (const topo::VertexId v : plane_.vertices()) box.add(plane_.point(v));
    const double least = 1e-12 * box.diagonal() * box.diagonal();
    for (const topo::FaceId f : plane_.faces()) {
      const auto& numbers = numbers_[f.index()];
      const auto covers = [&](std::uint32_t s) { return numbers[s] > 0; };
      const std::uint32_t first = area_of(f);
      if (first == none) continue;
      for (std::uint32_t second = first + 1; second < solids_; ++second) {
        if (!covers(second)) continue;
        const double area = topo::area(plane_, f);
        if (!(area > least)) continue;
        const geom::Point at = plane_.point(plane_.origin(plane_.half_edges(plane_.loops(f).front()).front()));
        SectionOverlap& told =
            overlaps_.try_emplace({first, second}, SectionOverlap{first, second, 0.0, at}).first->second;
        told.area += area;
      }
    }
  }

  struct Step {
    std::uint32_t solid;
    int left;              // to the left of half_edge(e) it is surrounded so often more
    std::uint32_t before;  // another step of the edge, or none
  };

  void spread() {
    std::size_t count = 0;
    for (const topo::FaceId f : plane_.faces()) count = std::max(count, f.index() + 1);
    numbers_.resize(count);
    std::vector<char> known(count, 0);
    std::vector<topo::FaceId> queue{topo::Subdivision::unbounded()};
    numbers_[queue[0].index()].assign(solids_, 0);
    known[queue[0].index()] = 1;
    while (!queue.empty()) {
      const topo::FaceId face = queue.back();
      queue.pop_back();
      for (const topo::LoopId loop : plane_.loops(face)) {
        for (const topo::HalfEdgeId h : plane_.half_edges(loop)) {
          const topo::FaceId beyond = plane_.face(topo::Subdivision::twin(h));
          if (known[beyond.index()] != 0) continue;
          known[beyond.index()] = 1;
          auto& numbers = numbers_[beyond.index()] = numbers_[face.index()];
          const bool forwards = topo::Subdivision::half_edge(topo::Subdivision::edge(h)) == h;
          const std::size_t e = topo::Subdivision::edge(h).index();
          for (std::uint32_t i = e < last_of_.size() ? last_of_[e] : none; i != none; i = steps_[i].before)
            numbers[steps_[i].solid] -= forwards ? steps_[i].left : -steps_[i].left;
          queue.push_back(beyond);
        }
      }
    }
    for (const auto& numbers : numbers_) {
      const auto at = std::find_if(numbers.begin(), numbers.end(), [](int n) { return n > 0; });
      areas_.push_back(at == numbers.end() ? none : static_cast<std::uint32_t>(at - numbers.begin()));
    }
  }

  /// The first solid that surrounds the face.
  [[nodiscard]] std::uint32_t area_of(topo::FaceId f) const { return areas_[f.index()]; }

  topo::Subdivision& plane_;
  std::size_t solids_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> last_of_;     // of each edge, the last of its steps
  std::vector<std::vector<int>> numbers_;  // of each face, how often each solid surrounds it
  std::map<std::pair<std::uint32_t, std::uint32_t>, SectionOverlap> overlaps_;
  std::vector<std::uint32_t> areas_;
};

bool crosses(const Box3& box, const CutPlane& plane) {
  double low = plane.d;
  double high = plane.d;
  double size = std::abs(plane.d);
  const std::array<double, 3> n{plane.a, plane.b, plane.c};
  for (std::size_t i = 0; i < 3; ++i) {
    const double p = n[i] * box.low[i];
    const double q = n[i] * box.high[i];
    low += std::min(p, q);
    high += std::max(p, q);
    size += std::max(std::abs(p), std::abs(q));
  }
  const double slack = 0x1p-48 * size;
  return low <= slack && high >= -slack;
}

/// The part of a box below a plane, as a soup of its faces.
class HalfBox {
 public:
  HalfBox(const Box3& box, const CutPlane& cut, const std::string& name) {
    names_ = {"", name};
    cut_ = soup_.space.add(as_plane(cut));
    for (std::size_t i = 0; i < 8; ++i) {
      corners_[i] =
          soup_.space.add(Point3{(i & 1U) != 0 ? box.high[0] : box.low[0], (i & 2U) != 0 ? box.high[1] : box.low[1],
                                 (i & 4U) != 0 ? box.high[2] : box.low[2]});
    }
  }

  Solid solid() {
    constexpr std::array<std::array<std::size_t, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    bool any_above = false;
    for (const PointId p : corners_) any_above = any_above || soup_.space.side(cut_, p) == Sign::Positive;
    for (const auto& face : faces) clip(face);
    if (any_above && !soup_.facets.empty()) close();
    return link();
  }

 private:
  void clip(const std::array<std::size_t, 4>& face) {
    std::vector<PointId> loop;
    bool any_below = false;
    for (std::size_t i = 0; i < 4; ++i) {
      const PointId p = corners_[face[i]];
      const PointId q = corners_[face[(i + 1) % 4]];
      const Sign at_p = soup_.space.side(cut_, p);
      const Sign at_q = soup_.space.side(cut_, q);
      any_below = any_below || at_p == Sign::Negative;
      if (at_p != Sign::Positive) loop.push_back(p);
      if (at_p == Sign::Zero) rim_.push_back(p);
      if (at_p * at_q == Sign::Negative) {
        loop.push_back(soup_.space.meet(p, q, cut_));
        rim_.push_back(loop.back());
      }
    }
    if (!any_below) return;
    const auto place = [&](std::size_t i) { return soup_.space.rounded(corners_[face[i]]); };
    add(soup_.space.add(Plane{{place(0), place(1), place(2)}, {}}), loop, 0);
  }

  void add(PlaneId plane, const std::vector<PointId>& loop, std::uint32_t name) {
    soup_.begin(plane, 0, name);
    soup_.begin_loop();
    for (const PointId p : loop) soup_.add_corner(p, PlaneId());
  }

  /// The cap: the hull of the points on the plane, all of which are its corners, anticlockwise seen from above.
  void close() {
    const Projection onto = soup_.space.projection(cut_);
    std::sort(rim_.begin(), rim_.end(), [&](PointId p, PointId q) {
      return p != q && soup_.space.compare(onto, p, q) == std::strong_ordering::less;
    });
    rim_.erase(std::unique(rim_.begin(), rim_.end()), rim_.end());
    std::vector<PointId> hull;
    for (int pass = 0; pass < 2; ++pass) {
      const std::size_t first = hull.size();
      for (const PointId p : rim_) {
        while (hull.size() >= first + 2 &&
               soup_.space.orient(onto, hull[hull.size() - 2], hull.back(), p) == Sign::Negative) {
          hull.pop_back();
        }
        hull.push_back(p);
      }
      hull.pop_back();
      std::reverse(rim_.begin(), rim_.end());
    }
    add(cut_, hull, 1);
  }

  Solid link() {
    Boundary out;
    out.names = names_;
    out.shell_count = soup_.facets.empty() ? 0 : 1;
    out.shells.assign(soup_.facets.size(), 0);
    std::vector<std::uint32_t> facet(soup_.corners.size());
    std::vector<std::pair<PointId, PointId>> ends(soup_.corners.size());
    std::vector<std::uint32_t> numbers(soup_.space.point_count(), none);
    for (std::uint32_t f = 0; f < soup_.facets.size(); ++f) {
      soup_.visit_edges(soup_.facets[f], [&](std::uint32_t i, std::uint32_t j) {
        facet[i] = f;
        ends[i] = {soup_.corners[i], soup_.corners[j]};
      });
    }
    for (std::uint32_t i = 0; i < ends.size(); ++i) {
      std::uint32_t& number = numbers[ends[i].first.index()];
      if (number == none) number = out.vertex_count++;
      out.vertices.push_back(number);
      const auto mate = std::find(ends.begin(), ends.end(), std::pair(ends[i].second, ends[i].first));
      DOBRA_CHECK(mate != ends.end());
      out.mates.push_back(static_cast<std::uint32_t>(mate - ends.begin()));
      soup_.across[i] = soup_.facets[facet[out.mates[i]]].plane;
    }
    soup_.inner = {Inner::Trusted};
    out.soup = std::move(soup_);
    return Solid(std::move(out));
  }

  Soup soup_;
  PlaneId cut_;
  std::array<PointId, 8> corners_;
  std::vector<PointId> rim_;
  std::vector<std::string> names_;
};

}  // namespace

base::Result<SectionFrame> frame_of(const CutPlane& plane) {
  const Vector3 normal{plane.a, plane.b, plane.c};
  const double size = length(normal);
  if (!std::isfinite(size) || !std::isfinite(plane.d) || size == 0.0) {
    return Error{ErrorCode::InvalidOption, "a plane a, b, c, d needs finite numbers, and a, b and c not all zero"};
  }
  const Vector3 n = normal / size;
  const Vector3 level = cross({0.0, 0.0, 1.0}, n);
  SectionFrame frame;
  frame.origin = Point3{} + (-plane.d / size) * n;
  frame.along = length(level) == 0.0 ? Vector3{1.0, 0.0, 0.0} : normalised(level);
  frame.up = cross(n, frame.along);
  return frame;
}

struct Sections::Line {
  geom::Point from, to;
  std::uint32_t solid;
  const std::string* name;
};

namespace {

/// Where edges of one solid meet a plane, for a facet and its neighbours that come soon after.
class EdgeCrossings {
 public:
  EdgeCrossings(const Space& points, const Plane& plane) : points_(points), plane_(plane), kept_(128) {}

  /// None where only exact numbers can tell.  @pre the ends are on different sides, and doubles
  std::optional<Point3> at(PointId a, PointId b) {
    if (b < a) std::swap(a, b);
    Kept& kept = kept_[(a.index() * 0x9e3779b9U ^ b.index() * 0x85ebca6bU) % kept_.size()];
    if (kept.a != a || kept.b != b) {
      const auto found = crossing_in_doubles(plane_, points_.rounded(a), points_.rounded(b));
      kept = {a, b, found ? std::optional(found->at) : std::nullopt};
    }
    return kept.at;
  }

 private:
  struct Kept {
    PointId a, b;
    std::optional<Point3> at;
  };
  const Space& points_;
  const Plane& plane_;
  std::vector<Kept> kept_;
};

/// What most facets are: their corners are doubles, none of them in the plane, and their border crosses it twice.
enum class Simple : std::uint8_t { Missed, Cut, Unclear };

/// The line runs from where the border goes down through the plane to where it comes up.
Simple cut_simply(const Soup& all, const Facet& facet, const Space& space, PlaneId cut, EdgeCrossings& crossings,
                  std::array<Point3, 2>& ends) {
  struct Corner {
    PointId point;
    Sign side;
  };
  const auto corner = [&](std::uint32_t i) {
    const PointId p = all.corners[i];
    return Corner{p, all.space.is_exact(p) ? space.side(cut, all.space.rounded(p)) : Sign::Zero};
  };
  std::array<Corner, 4> crossed{};
  std::size_t count = 0;
  for (std::uint32_t l = facet.first_loop; l < facet.loop_end; ++l) {
    const std::uint32_t end = all.loop_end(facet, l);
    Corner last = corner(end - 1);
    for (std::uint32_t i = all.loop_starts[l]; i < end; ++i) {
      const Corner next = corner(i);
      if (next.side == Sign::Zero) return Simple::Unclear;
      if (next.side != last.side) {
        if (count == crossed.size()) return Simple::Unclear;
        crossed[count++] = last;
        crossed[count++] = next;
      }
      last = next;
    }
  }
  if (count == 0) return Simple::Missed;
  for (std::size_t i = 0; i < count; i += 2) {
    const auto at = crossings.at(crossed[i].point, crossed[i + 1].point);
    if (!at) return Simple::Unclear;
    ends[crossed[i].side == Sign::Positive ? 0 : 1] = *at;
  }
  return Simple::Cut;
}

/// Segments, each once whatever way it runs.
class OnceOnly {
 public:
  explicit OnceOnly(std::size_t most) {
    numbers_.reserve(most);
    curves_.reserve(most);
  }
  /// Its index in all().
  std::size_t add(geom::Point from, geom::Point to) {
    Key key{from.x, from.y, to.x, to.y};
    if (std::tie(to.x, to.y) < std::tie(from.x, from.y)) key = {to.x, to.y, from.x, from.y};
    const auto [at, fresh] = numbers_.try_emplace(key, curves_.size());
    if (fresh) curves_.push_back({{from, to}, false});
    return at->second;
  }
  [[nodiscard]] const std::vector<geom::Polyline>& all() const { return curves_; }

 private:
  using Key = std::array<double, 4>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t hash = 0;
      for (const double value : key) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value + 0.0)) * 0x9e3779b97f4a7c15U;  // one zero
        hash ^= hash >> 32U;
      }
      return hash;
    }
  };
  std::unordered_map<Key, std::size_t, Hash> numbers_;
  std::vector<geom::Polyline> curves_;
};

}  // namespace

Sections::Sections(std::span<const Solid> solids) : solids_(solids.begin(), solids.end()) {
  for (const Solid& s : solids_) {
    trees_.emplace_back(s.boundary().soup, 0, static_cast<std::uint32_t>(s.face_count()));
  }
}

std::vector<Sections::Line> Sections::collect(std::uint32_t solid, const CutPlane& plane,
                                              const SectionFrame& frame) const {
  std::vector<Line> lines;
  const Soup& all = solids_[solid].boundary().soup;
  Soup soup;  // of one facet at a time, in a space that the cut's points do not outlive
  const Plane given = as_plane(plane);
  const PlaneId cut = soup.space.add(given);
  std::vector<std::uint32_t> found;
  trees_[solid].select([&](const Box3& box) { return crosses(box, plane); },
                       [&](std::uint32_t f) { found.push_back(f); });
  if (found.empty()) return lines;
  std::sort(found.begin(), found.end());
  EdgeCrossings crossings(all.space, given);
  lines.reserve(found.size());
  std::vector<Sign> signs;
  std::vector<Stop> stops;
  for (const std::uint32_t f : found) {
    const Facet& facet = all.facets[f];
    const auto add = [&](Point3 first, Point3 last) {
      const geom::Point from = frame.in_plane(first);
      const geom::Point to = frame.in_plane(last);
      if (from != to) lines.push_back({from, to, solid, &solids_[solid].name(FaceId(f))});
    };
    std::array<Point3, 2> ends;
    const Simple simple = cut_simply(all, facet, soup.space, cut, crossings, ends);
    if (simple == Simple::Cut) add(ends[0], ends[1]);
    if (simple != Simple::Unclear) continue;
    signs.clear();
    soup.begin(soup.space.add(all.space.plane(facet.plane)), 0, 0);
    for (std::uint32_t l = facet.first_loop; l < facet.loop_end; ++l) {
      soup.begin_loop();
      for (std::uint32_t i = all.loop_starts[l]; i < all.loop_end(facet, l); ++i) {
        soup.add_corner(soup.space.add(all.space, all.corners[i]), PlaneId());
        signs.push_back(soup.space.side(cut, soup.corners.back()));
      }
    }
    if (std::find(signs.begin(), signs.end(), Sign::Negative) == signs.end()) continue;
    if (std::all_of(signs.begin(), signs.end(), [](Sign s) { return s == Sign::Negative; })) continue;
    const PlaneId own = soup.facets.back().plane;
    const int axis = axis_of_line(soup.space, cut, own);
    const bool forwards = runs_forwards(soup.space, cut, own, axis);
    stops_along(soup, static_cast<std::uint32_t>(soup.facets.size() - 1), cut, signs, axis, stops);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      if (!stops[i].below) continue;
      const Point3 first = soup.space.rounded(stops[i].point);
      const Point3 last = soup.space.rounded(stops[i + 1].point);
      forwards ? add(first, last) : add(last, first);
    }
  }
  return lines;
}

base::Result<Section> Sections::cut(const CutPlane& plane) const {
  Section out;
  DOBRA_TRY(out.frame, frame_of(plane));
  const auto of_solid = base::parallel_map<std::vector<Line>>(
      solids_.size(), [&](std::size_t s) { return collect(static_cast<std::uint32_t>(s), plane, out.frame); });
  // Where two solids meet, each line is there twice.
  std::size_t count = 0;
  for (const auto& lines : of_solid) count += lines.size();
  OnceOnly curves(count);
  std::vector<std::size_t> curve_of;
  for (const auto& lines : of_solid) {
    for (const Line& line : lines) curve_of.push_back(curves.add(line.from, line.to));
  }
  DOBRA_TRY(const auto paths, topo::insert(out.plane, curves.all()));
  Areas areas(out.plane, solids_.size());
  auto curve = curve_of.begin();
  for (const auto& lines : of_solid) {
    for (const Line& line : lines) {
      const std::size_t c = *curve++;
      const bool along = curves.all()[c].points[0] == line.from;
      for (const topo::HalfEdgeId h : paths[c]) {
        areas.pass(along ? h : topo::Subdivision::twin(h), line.solid);
        std::any& attribute = out.plane.attribute(topo::Subdivision::edge(h));
        if (!attribute.has_value()) attribute = SectionLine{};
        auto& names = std::any_cast<SectionLine&>(attribute).names;
        const auto at = std::lower_bound(names.begin(), names.end(), *line.name);
        if (at == names.end() || *at != *line.name) names.insert(at, *line.name);
      }
    }
  }
  areas.finish();
  out.overlaps = areas.overlaps();
  return out;
}

base::Result<Halves> halve(const Solid& solid, const CutPlane& plane, const std::string& cap) {
  DOBRA_TRY_VOID(frame_of(plane));
  if (solid.empty()) return Halves{};
  const BoxTree tree(solid.boundary().soup, 0, static_cast<std::uint32_t>(solid.face_count()));
  // A box with room on all sides, so that no face of it meets the solid.
  Box3 box = tree.box();
  double size = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    size = std::max({size, box.high[i] - box.low[i], std::abs(box.low[i]), std::abs(box.high[i])});
  const double room = std::exp2(std::ceil(std::log2(size)));
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = -2.0 * room;
    box.high[i] = 2.0 * room;
  }
  const std::array operands{solid, HalfBox(box, plane, cap).solid()};
  DOBRA_TRY(Combined below, combine(operands, Operation::Intersection));
  DOBRA_TRY(Combined above, combine(operands, Operation::Difference));
  return Halves{std::move(below.solid), std::move(above.solid), below.contact};
}

}  // namespace dobra::solid
