#include "shared/solid/mesh_solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

#include "shared/base/check.h"
#include "shared/base/disjoint_sets.h"
#include "shared/mesh/polygon_lists.h"
#include "shared/solid/assemble.h"
#include "shared/solid/triangulate.h"
#include "shared/solid/warp.h"

namespace dobra::solid {
namespace {

using base::Error;
using base::ErrorCode;
using geom::Point3;
using geom::Sign;

base::Place place_at(Point3 p) {
  base::Place place;
  place.x = p.x;
  place.y = p.y;
  place.z = p.z;
  return place;
}

/// Three corners that are not in a line: two far apart, and the one farthest from their line.
std::optional<std::array<PointId, 3>> spread(const Space& space, const std::vector<PointId>& loop) {
  const Point3 origin = space.rounded(loop[0]);
  const auto farthest = [&](auto&& size) {
    return *std::max_element(loop.begin(), loop.end(), [&](PointId p, PointId q) { return size(p) < size(q); });
  };
  const PointId second = farthest([&](PointId p) { return distance(space.rounded(p), origin); });
  const geom::Vector3 along = space.rounded(second) - origin;
  const PointId third = farthest([&](PointId p) { return length(cross(along, space.rounded(p) - origin)); });
  if (!space.collinear(loop[0], second, third)) return std::array{loop[0], second, third};
  for (const PointId p : loop) {
    if (!space.collinear(loop[0], second, p)) return std::array{loop[0], second, p};
  }
  return std::nullopt;
}

/// What is said of faces that bound no volume.
enum class Nothing { Empty, Refused };

class Reader {
 public:
  Reader(const FaceLoops& mesh, const FromMeshOptions& options, Nothing nothing)
      : mesh_(mesh), options_(options), nothing_(nothing) {}

  base::Result<Taken> run() {
    DOBRA_TRY_VOID(check_corners());
    flat_ = 1e-9 * diagonal_of(mesh_.points);
    for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) DOBRA_TRY_VOID(add_face(f));
    soup_.inner = {Inner::Searched};
    const std::vector<BoxTree> trees{BoxTree(soup_, 0, static_cast<std::uint32_t>(soup_.facets.size()))};
    const Contacts found = contacts(soup_, trees);
    const Cells cells = arrange(soup_, found);
    const Fans round = fans(soup_, cells);
    if (const auto half = open_half(soup_, cells, round)) return open_error(cells, round, *half);
    const Sides windings = sides(soup_, cells, round, trees);
    const auto checked = check_windings(found, cells, windings);
    if (!checked && options_.crossings == Crossings::Refused) return checked.error();
    std::vector<char> inside;
    for (const Windings& kind : windings.kinds) inside.push_back(!kind.empty() && kind[0].second > 0 ? 1 : 0);
    if (nothing_ == Nothing::Refused && std::count(inside.begin(), inside.end(), 1) == 0) {
      for (const Cell& cell : cells.cells) {
        if (const auto covers = cells.covers_of(cell); covers.size() > 1) return nothing_error(cells, cell, covers);
      }
    }
    std::vector<OppositeFaces> opposite;
    if (checked) opposite = opposite_faces(cells, windings, inside);
    return Taken{Solid(assemble(soup_, found, cells, round, windings, inside, std::move(names_))), std::move(opposite),
                 warped_, !checked};
  }

 private:
  base::Result<void> check_corners() const {
    if (!options_.face_names.empty() && options_.face_names.size() != mesh_.faces.size()) {
      return Error{ErrorCode::InvalidOption, fmt::format("there are {} names for {} faces: give one for each face",
                                                         options_.face_names.size(), mesh_.faces.size())};
    }
    for (std::size_t p = 0; p < mesh_.points.size(); ++p) {
      const Point3 at = mesh_.points[p];
      if (!is_finite(at)) {
        return Error{ErrorCode::NotFinite, fmt::format("point {} has a coordinate that is not a number", p)};
      }
      constexpr double largest = 1e75;  // products of four coordinates are finite numbers
      if (std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}) > largest) {
        return Error{ErrorCode::NotFinite,
                     fmt::format("point {} has a coordinate beyond 1e75: solids are computed with smaller ones", p),
                     place_at(at)};
      }
    }
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      for (const auto& loop : mesh_.faces[f]) {
        for (const std::uint32_t corner : loop) {
          if (corner >= mesh_.points.size()) {
            return Error{ErrorCode::BadFormat, fmt::format("face {} names point {}, which does not exist", f, corner)};
          }
        }
      }
    }
    return {};
  }

  using Loops = std::vector<std::vector<PointId>>;

  base::Result<void> add_face(std::uint32_t f) {
    Loops loops;
    for (const auto& corners : mesh_.faces[f]) {
      std::vector<PointId> loop;
      for (const std::uint32_t corner : corners) {
        const PointId p = soup_.space.add(mesh_.points[corner]);
        if (loop.empty() || loop.back() != p) loop.push_back(p);
      }
      while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
      if (loop.size() >= 3) loops.push_back(std::move(loop));
    }
    if (loops.empty()) return {};
    const std::vector<PointId>& outer = loops[0];
    if (loops.size() == 1 && outer.size() == 3) {
      if (!soup_.space.collinear(outer[0], outer[1], outer[2])) add_facet(f, loops, {outer[0], outer[1], outer[2]});
      return {};
    }
    const auto corners = spread(soup_.space, outer);
    if (!corners) return {};
    const PlaneId plane = add_plane(*corners);
    const bool flat = std::all_of(loops.begin(), loops.end(), [&](const std::vector<PointId>& loop) {
      return std::all_of(loop.begin(), loop.end(), [&](PointId p) { return soup_.space.side(plane, p) == Sign::Zero; });
    });
    return flat ? add_flat(f, loops, *corners, plane) : add_warped(f, loops);
  }

  PlaneId add_plane(const std::array<PointId, 3>& corners) {
    return soup_.space.add(
        Plane{{soup_.space.rounded(corners[0]), soup_.space.rounded(corners[1]), soup_.space.rounded(corners[2])}, {}});
  }

  void add_facet(std::uint32_t f, const Loops& loops, const std::array<PointId, 3>& corners) {
    soup_.begin(add_plane(corners), 0,
                name_number(options_.face_names.empty() ? options_.name : options_.face_names[f]));
    face_.push_back(f);
    for (const auto& loop : loops) {
      soup_.begin_loop();
      for (const PointId p : loop) soup_.add_corner(p, PlaneId());
    }
  }

  base::Result<void> add_flat(std::uint32_t f, Loops& loops, std::array<PointId, 3> corners, PlaneId plane) {
    const Projection onto = soup_.space.projection(plane);
    if (!bound_a_face(soup_.space, onto, loops)) return crossing_error(f, loops, onto);
    const bool left = runs_left(soup_.space, onto, loops[0]);
    if (!left) std::swap(corners[1], corners[2]);
    for (std::size_t l = 1; l < loops.size(); ++l) {
      if (runs_left(soup_.space, onto, loops[l]) == left) std::reverse(loops[l].begin(), loops[l].end());
    }
    add_facet(f, loops, corners);
    return {};
  }

  base::Result<void> add_warped(std::uint32_t f, Loops& loops) {
    note_warped(f, loops[0]);
    const bool turned = begin_alike(soup_.space, loops);
    std::vector<Point3> points;
    for (const PointId p : loops[0]) points.push_back(soup_.space.rounded(p));
    const Point3 n = mesh::newell_area(points);
    const std::array<double, 3> size{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
    const auto axis = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
    const double along = axis == 0 ? n.x : axis == 1 ? n.y : n.z;
    Projection onto{(axis + 1) % 3, (axis + 2) % 3};
    if (along < 0.0) std::swap(onto.u, onto.v);
    if (!bound_a_face(soup_.space, onto, loops) || !runs_left(soup_.space, onto, loops[0])) {
      return crossing_error(f, loops, onto);
    }
    for (std::size_t l = 1; l < loops.size(); ++l) {
      if (runs_left(soup_.space, onto, loops[l])) std::reverse(loops[l].begin(), loops[l].end());
    }
    auto triangles = triangulate(soup_.space, onto, loops);
    if (!triangles) return crossing_error(f, loops, onto);
    for (auto& t : *triangles) {
      if (turned) std::swap(t[1], t[2]);
      if (!soup_.space.collinear(t[0], t[1], t[2])) add_facet(f, {{t[0], t[1], t[2]}}, t);
    }
    return {};
  }

  void note_warped(std::uint32_t f, const std::vector<PointId>& loop) {
    std::vector<Point3> points;
    for (const PointId p : loop) points.push_back(soup_.space.rounded(p));
    if (const auto own = warp_of(points, flat_)) add_warp(warped_, f, *own);
  }

  [[nodiscard]] Error crossing_error(std::uint32_t f, const Loops& loops, Projection onto) const {
    const auto met = where_edges_meet(soup_.space, onto, loops);
    return {ErrorCode::SelfIntersection,
            fmt::format("face {} crosses or touches itself: cut it into simple polygons", f),
            place_at(met ? *met : soup_.space.rounded(loops.back()[0]))};
  }

  [[nodiscard]] std::uint32_t face_of(const Cells& cells, CellId cell) const {
    return face_[cells.cells[cell.index()].facet];
  }

  [[nodiscard]] Error cover_error(std::span<const Cover> covers, Point3 at) const {
    return {ErrorCode::SelfIntersection,
            fmt::format("faces {} and {} cover each other: take one of them out", face_[covers[0].facet],
                        face_[covers[1].facet]),
            place_at(at)};
  }

  [[nodiscard]] Error nothing_error(const Cells& cells, const Cell& cell, std::span<const Cover> covers) const {
    return {ErrorCode::NotClosed,
            fmt::format("the faces bound nothing: faces {} and {} cover each other, one turned against the other; give "
                        "faces that surround a volume",
                        face_[covers[0].facet], face_[covers[1].facet]),
            place_at(soup_.space.rounded(cells.halves[cell.first_half].origin))};
  }

  [[nodiscard]] Error open_error(const Cells& cells, const Fans& round, std::uint32_t half) const {
    std::uint32_t around = half;
    do {
      const Cell& cell = cells.cells[cells.halves[around].cell.index()];
      if (const auto covers = cells.covers_of(cell); covers.size() > 1)
        return cover_error(covers, soup_.space.rounded(cells.halves[around].origin));
      around = round.turned[around];
    } while (around != half);
    const Point3 a = soup_.space.rounded(cells.halves[half].origin);
    const Point3 b = soup_.space.rounded(cells.target(half));
    const CellId cell = cells.halves[half].cell;
    return {ErrorCode::NotClosed,
            fmt::format("the surface is not closed at an edge of face {}: a face is missing there, or one of its "
                        "faces is turned over",
                        face_[cells.covers_of(cells.cells[cell.index()])[0].facet]),
            place_at(a + 0.5 * (b - a))};
  }

  /// Inside is what is surrounded once.
  base::Result<void> check_windings(const Contacts& found, const Cells& cells, const Sides& windings) const {
    const auto number = [&](std::uint32_t kind) {
      return windings.kinds[kind].empty() ? 0 : windings.kinds[kind][0].second;
    };
    for (std::uint32_t c = 0; c < cells.cells.size(); ++c) {
      const int above = number(windings.above[c]);
      const int below = number(windings.below[c]);
      if (std::min(above, below) >= 0 && std::max(above, below) <= 1) continue;
      return winding_error(found, cells, c, std::min(above, below) < 0);
    }
    return {};
  }

  [[nodiscard]] Error winding_error(const Contacts& found, const Cells& cells, std::uint32_t c, bool inverted) const {
    if (!found.inside.empty()) {
      const auto& first = *std::min_element(found.inside.begin(), found.inside.end(), [](const auto& s, const auto& t) {
        return std::pair(s.f, s.g) < std::pair(t.f, t.g);
      });
      return {ErrorCode::SelfIntersection,
              fmt::format("faces {} and {} cross: a solid's faces meet in edges and corners alone", face_[first.f],
                          face_[first.g]),
              place_at(soup_.space.rounded(first.at))};
    }
    const auto covers = cells.covers_of(cells.cells[c]);
    const Point3 at = soup_.space.rounded(cells.halves[cells.cells[c].first_half].origin);
    if (covers.size() > 1) return cover_error(covers, at);
    const char* what = inverted ? "face {} is turned inside out, and so is the part that it bounds: turn its faces over"
                                : "face {} bounds a part that lies within another part: unite them, or turn it over";
    return {inverted ? ErrorCode::InsideOut : ErrorCode::SelfIntersection,
            fmt::format(fmt::runtime(what), face_[covers[0].facet]), place_at(at)};
  }

  /// Where every region is surrounded once or not at all, a cell with two covers has one turned against another.
  [[nodiscard]] std::vector<OppositeFaces> opposite_faces(const Cells& cells, const Sides& windings,
                                                          const std::vector<char>& inside) const {
    std::vector<std::uint32_t> doubled;
    for (std::uint32_t c = 0; c < cells.cells.size(); ++c) {
      if (cells.covers_of(cells.cells[c]).size() > 1) doubled.push_back(c);
    }
    const auto within = [&](std::uint32_t c) {
      return inside[windings.above[c]] != 0 && inside[windings.below[c]] != 0;
    };
    // Those of one kind with a common corner hang together.
    base::DisjointSets groups(doubled.size());
    std::map<std::pair<PointId, bool>, std::size_t> first_at;
    for (std::size_t i = 0; i < doubled.size(); ++i) {
      const Cell& cell = cells.cells[doubled[i]];
      for (std::uint32_t h = cell.first_half; h < cell.half_end; ++h)
        groups.join(i, first_at.try_emplace({cells.halves[h].origin, within(doubled[i])}, i).first->second);
    }
    std::map<std::size_t, OppositeFaces> found;
    std::set<std::array<std::uint32_t, 2>> known;
    for (std::size_t i = 0; i < doubled.size(); ++i) {
      const Cell& cell = cells.cells[doubled[i]];
      const std::array<std::uint32_t, 2> pair = opposite_pair(cells.covers_of(cell));
      const bool fresh = known.insert(pair).second;
      const OppositeFaces told{pair[0], pair[1], 1, within(doubled[i]),
                               soup_.space.rounded(cells.halves[cell.first_half].origin)};
      const auto [at, begun] = found.try_emplace(groups.root(i), told);
      if (begun || !fresh) continue;
      const std::size_t pairs = at->second.pairs + 1;
      if (pair < std::array{at->second.face, at->second.against}) at->second = told;
      at->second.pairs = pairs;
    }
    std::vector<OppositeFaces> all;
    for (const auto& [root, faces] : found) all.push_back(faces);
    std::sort(all.begin(), all.end(), [](const OppositeFaces& a, const OppositeFaces& b) {
      return std::pair(a.face, a.against) < std::pair(b.face, b.against);
    });
    return all;
  }

  [[nodiscard]] std::array<std::uint32_t, 2> opposite_pair(std::span<const Cover> covers) const {
    const auto other = std::find_if(covers.begin(), covers.end(),
                                    [&](const Cover& cover) { return cover.turned != covers[0].turned; });
    DOBRA_CHECK(other != covers.end());
    const auto [low, high] = std::minmax(face_[covers[0].facet], face_[other->facet]);
    return {low, high};
  }

  std::uint32_t name_number(const std::string& name) {
    const auto [at, fresh] = numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
    if (fresh) names_.push_back(name);
    return at->second;
  }

  const FaceLoops& mesh_;
  const FromMeshOptions& options_;
  Nothing nothing_;
  Soup soup_;
  std::vector<std::uint32_t> face_;  // of each facet, the face of the mesh
  double flat_ = 0.0;                // a face is plane where no corner is farther off
  std::optional<WarpedFaces> warped_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
};

/// Of a mesh that is not closed, the face that is turned over, if one alone is wrong.
std::optional<Error> turn_error(const mesh::PolygonMesh& mesh) {
  mesh::PolygonMesh merged = mesh;
  const auto first = mesh::merged_points(mesh.points, 0.0);
  for (auto& face : merged.faces) {
    for (std::uint32_t& corner : face) corner = first[corner];
  }
  std::optional<Error> found;
  for (const mesh::PolygonFinding& finding : mesh::check(merged, mesh::Closedness::Solid)) {
    if (finding.fault == mesh::PolygonFault::UnusedPoint) continue;
    if (found || finding.fault != mesh::PolygonFault::ReversedFace) return std::nullopt;
    const auto& face = merged.faces[finding.faces[0]];
    geom::Vector3 sum{};
    for (const std::uint32_t corner : face) sum = sum + (merged.points[corner] - Point3{});
    found = Error{ErrorCode::NotClosed,
                  fmt::format("face {} is turned against its neighbours: turn it over", finding.faces[0]),
                  place_at(Point3{} + sum / static_cast<double>(face.size()))};
  }
  return found;
}

}  // namespace

std::string message(const WarpedFaces& faces) {
  return fmt::format(
      "faces that are not plane and were cut into triangles: {}; face {} has the corner that is farthest "
      "off, {:.3g} m; cut otherwise, the volume would differ by {:.3g} m3 at most",
      faces.count, faces.face, faces.distance, faces.volume);
}

std::string message(const OppositeFaces& faces) {
  const char* what = faces.inside
                         ? "faces {} and {} cover each other, one turned against the other: the wall between them lies "
                           "within the solid and is left out (pairs of faces in it: {})"
                         : "faces {} and {} cover each other, one turned against the other: the sheet between them has "
                           "no thickness and is left out (pairs of faces in it: {})";
  return fmt::format(fmt::runtime(what), faces.face, faces.against, faces.pairs);
}

base::Result<Taken> take(const FaceLoops& mesh, const FromMeshOptions& options) {
  return Reader(mesh, options, Nothing::Empty).run();
}

base::Result<Taken> take(const mesh::PolygonMesh& mesh, const FromMeshOptions& options) {
  FaceLoops loops{mesh.points, {}};
  loops.faces.reserve(mesh.faces.size());
  for (const auto& face : mesh.faces) loops.faces.push_back({face});
  auto taken = Reader(loops, options, Nothing::Refused).run();
  if (taken || taken.error().code != ErrorCode::NotClosed) return taken;
  if (auto better = turn_error(mesh)) return *std::move(better);
  return taken;
}

base::Result<Solid> from_loops(const FaceLoops& mesh, const FromMeshOptions& options) {
  DOBRA_TRY(Taken taken, take(mesh, options));
  return std::move(taken.solid);
}

base::Result<Solid> from_mesh(const mesh::PolygonMesh& mesh, const FromMeshOptions& options) {
  DOBRA_TRY(Taken taken, take(mesh, options));
  return std::move(taken.solid);
}

base::Result<ToMesh> to_mesh(const Solid& solid, FacesAs as) {
  ToMesh out;
  const Soup& soup = solid.boundary().soup;
  const Space& space = soup.space;
  std::vector<std::uint32_t> numbers(space.point_count(), none);
  const auto number = [&](PointId p) {
    std::uint32_t& n = numbers[p.index()];
    if (n != none) return n;
    n = static_cast<std::uint32_t>(out.mesh.points.size());
    const Point3 at = space.rounded(p);
    out.mesh.points.push_back(at);
    if (!space.is_exact(p)) {
      // Each coordinate was rounded by half a unit in its last place at most.
      const auto half = [](double value) {
        return 0.5 * (std::nextafter(std::abs(value), INFINITY) - std::abs(value));
      };
      out.displacement = std::max(out.displacement, std::hypot(half(at.x), half(at.y), half(at.z)));
    }
    return n;
  };
  for (std::uint32_t f = 0; f < soup.facets.size(); ++f) {
    const Facet& facet = soup.facets[f];
    const auto corners = soup.corners_of(facet);
    const Projection onto = space.projection(facet.plane);
    const bool whole = facet.loop_end - facet.first_loop == 1 && (as == FacesAs::Polygons || corners.size() == 3) &&
                       std::all_of(corners.begin(), corners.end(), [&](PointId p) { return space.is_exact(p); }) &&
                       is_simple(space, onto, corners);
    const std::string& name = solid.name(FaceId(f));
    const auto add = [&](std::span<const PointId> loop) {
      std::vector<std::uint32_t> face;
      for (const PointId p : loop) face.push_back(number(p));
      out.mesh.faces.push_back(std::move(face));
      out.names.push_back(name);
    };
    if (whole) {
      add(corners);
      continue;
    }
    const auto loops = sorted_loops(soup, facet, onto);
    const auto triangles = triangulate(space, onto, loops);
    if (!triangles) {
      return Error{ErrorCode::CannotMesh, fmt::format("face {} of the solid cannot be cut into triangles", f),
                   place_at(space.rounded(corners[0]))};
    }
    for (const auto& t : *triangles) add(t);
  }
  return out;
}

}  // namespace dobra::solid
