#include "shared/mesh/polygon_mesh.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "shared/mesh/face_turns.h"

namespace dobra::mesh {
namespace {

using Index = std::uint32_t;
using Ends = std::pair<Index, Index>;

/// One passage of a face along an edge.
struct Passage {
  Ends ends;  ///< The smaller first.
  Index face;
  bool forwards;  ///< From the smaller to the greater.
  friend auto operator<=>(const Passage&, const Passage&) = default;
};

std::vector<Passage> passages_of(const PolygonMesh& mesh, const std::vector<bool>& usable) {
  std::vector<Passage> all;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (!usable.empty() && !usable[f]) continue;
    const auto& face = mesh.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index from = face[i], to = face[(i + 1) % face.size()];
      all.push_back({std::minmax(from, to), f, from < to});
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Calls `visit` with the passages along each edge.
template <class Visit>
void each_edge(std::span<const Passage> passages, Visit visit) {
  for (std::size_t begin = 0; begin < passages.size();) {
    std::size_t end = begin;
    while (end < passages.size() && passages[end].ends == passages[begin].ends) ++end;
    visit(passages.subspan(begin, end - begin));
    begin = end;
  }
}

class Check {
 public:
  Check(const PolygonMesh& mesh, Closedness closedness) : mesh_(mesh), closedness_(closedness) {}

  std::vector<PolygonFinding> run(const std::span<const PolygonEdge>* edges) {
    corners();
    passages_ = passages_of(mesh_, usable_);
    lengths_and_repeats();
    boundaries();
    turns();
    unused();
    if (edges != nullptr) reciprocity(*edges);
    std::stable_sort(findings_.begin(), findings_.end(),
                     [](const auto& a, const auto& b) { return a.fault < b.fault; });
    return std::move(findings_);
  }

 private:
  void add(PolygonFault fault, std::vector<Index> faces, std::vector<Index> points, std::string message) {
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    findings_.push_back({fault, std::move(faces), std::move(points), std::move(message)});
  }

  void corners() {
    usable_.assign(mesh_.faces.size(), true);
    for (Index f = 0; f < mesh_.faces.size(); ++f) {
      const auto& face = mesh_.faces[f];
      const auto refuse = [&](PolygonFault fault, std::vector<Index> points, std::string message) {
        usable_[f] = false;
        add(fault, {f}, std::move(points), std::move(message));
      };
      for (const Index corner : face) {
        if (corner >= mesh_.points.size()) {
          refuse(PolygonFault::BadCorner, {corner},
                 fmt::format("face {}: corner {} does not exist ({} points)", f, corner, mesh_.points.size()));
        } else if (const geom::Point3& p = mesh_.points[corner];
                   !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
          refuse(PolygonFault::BadCorner, {corner}, fmt::format("face {}: point {} is not finite", f, corner));
        }
      }
      if (face.size() < 3) {
        refuse(PolygonFault::TooFewCorners, face,
               fmt::format("face {} has {} corners; a polygon has three or more", f, face.size()));
      }
    }
  }

  void lengths_and_repeats() {
    each_edge(passages_, [&](std::span<const Passage> edge) {
      const auto [a, b] = edge.front().ends;
      if (mesh_.points[a] == mesh_.points[b]) {
        std::vector<Index> faces;
        for (const Passage& passage : edge) faces.push_back(passage.face);
        add(PolygonFault::ZeroLengthEdge, std::move(faces), {a, b},
            fmt::format("edge {}-{} of face {} has no length", a, b, edge.front().face));
      }
      for (std::size_t i = 1; i < edge.size(); ++i) {
        if (edge[i].face != edge[i - 1].face) continue;
        add(PolygonFault::RepeatedEdge, {edge[i].face}, {a, b},
            fmt::format("face {} passes the edge {}-{} twice", edge[i].face, a, b));
      }
    });
  }

  /// Edges of one face, joined to loops; edges of more than two.
  void boundaries() {
    std::map<Index, std::vector<Index>> next;  // Against the face's turn: the way round of the face that is missing.
    each_edge(passages_, [&](std::span<const Passage> edge) {
      const auto [a, b] = edge.front().ends;
      if (edge.size() == 1) {
        const auto [from, to] = edge.front().forwards ? std::pair(b, a) : std::pair(a, b);
        next[from].push_back(to);
      } else if (edge.size() > 2) {
        std::vector<Index> faces;
        for (const Passage& passage : edge) faces.push_back(passage.face);
        std::string text =
            fmt::format("edge {}-{} is shared by {} faces: {}", a, b, edge.size(), fmt::join(faces, ", "));
        add(PolygonFault::TooManyFaces, std::move(faces), {a, b}, std::move(text));
      }
    });
    if (closedness_ == Closedness::Sheet) return;
    while (!next.empty()) {
      std::vector<Index> loop{next.begin()->first};
      for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
        loop.push_back(at->second.back());
        at->second.pop_back();
        if (at->second.empty()) next.erase(at);
        if (loop.back() == loop.front()) break;
      }
      if (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();
      std::string text = fmt::format("a face is missing: the mesh is open along the points {}", fmt::join(loop, "-"));
      add(PolygonFault::OpenBoundary, {}, std::move(loop), std::move(text));
    }
  }

  /// Spreads one turn over the faces joined by edges of two; those that need the other one are reversed.
  void turns() {
    std::vector<std::vector<std::pair<Index, bool>>> neighbours(mesh_.faces.size());  // And whether the turns agree.
    std::vector<bool> bordered(mesh_.faces.size(), false);
    each_edge(passages_, [&](std::span<const Passage> edge) {
      if (edge.size() != 2)
        for (const Passage& passage : edge) bordered[passage.face] = true;
      if (edge.size() != 2 || edge[0].face == edge[1].face) return;
      const bool agree = edge[0].forwards != edge[1].forwards;
      neighbours[edge[0].face].push_back({edge[1].face, agree});
      neighbours[edge[1].face].push_back({edge[0].face, agree});
    });
    std::vector<signed char> turn(mesh_.faces.size(), -1);
    for (Index seed = 0; seed < mesh_.faces.size(); ++seed) {
      if (turn[seed] >= 0 || !usable_[seed]) continue;
      std::array<std::vector<Index>, 2> of_turn;
      std::vector<Index> stack{seed};
      turn[seed] = 0;
      bool orientable = true, closed = true;
      while (!stack.empty()) {
        const Index face = stack.back();
        stack.pop_back();
        of_turn[static_cast<std::size_t>(turn[face])].push_back(face);
        closed = closed && !bordered[face];
        for (const auto& [other, agree] : neighbours[face]) {
          const auto wanted = static_cast<signed char>(agree ? turn[face] : 1 - turn[face]);
          if (turn[other] < 0) {
            turn[other] = wanted;
            stack.push_back(other);
          } else if (turn[other] != wanted) {
            orientable = false;
          }
        }
      }
      name_reversed(of_turn, orientable, closed);
    }
  }

  void name_reversed(std::array<std::vector<Index>, 2>& of_turn, bool orientable, bool closed) {
    if (!orientable) {
      std::vector<Index> all = of_turn[0];
      all.insert(all.end(), of_turn[1].begin(), of_turn[1].end());
      const Index lowest = *std::min_element(all.begin(), all.end());
      std::string text = fmt::format("the {} faces joined to face {} cannot be turned alike", all.size(), lowest);
      add(PolygonFault::NotOrientable, std::move(all), {}, std::move(text));
      return;
    }
    // The seed is the lowest face and has turn 0.
    std::array<TurnedAlike, 2> alike{TurnedAlike(mesh_.points[mesh_.faces[of_turn[0][0]][0]]),
                                     TurnedAlike(mesh_.points[mesh_.faces[of_turn[0][0]][0]])};
    for (const std::size_t i : {0U, 1U}) {
      for (const Index face : of_turn[i]) alike[i].add(mesh_.points, mesh_.faces[face]);
    }
    for (const Index face : of_turn[alike[0].stays_before(alike[1], closed) ? 1 : 0]) {
      add(PolygonFault::ReversedFace, {face}, {}, fmt::format("face {} is turned against its neighbours", face));
    }
  }

  void unused() {
    std::vector<bool> used(mesh_.points.size(), false);
    for (const auto& face : mesh_.faces) {
      for (const Index corner : face) {
        if (corner < used.size()) used[corner] = true;
      }
    }
    for (Index p = 0; p < used.size(); ++p) {
      if (!used[p]) add(PolygonFault::UnusedPoint, {}, {p}, fmt::format("point {} belongs to no face", p));
    }
  }

  void reciprocity(std::span<const PolygonEdge> edges) {
    std::map<Ends, std::vector<Index>> passed;
    each_edge(passages_, [&](std::span<const Passage> edge) {
      for (const Passage& passage : edge) passed[edge.front().ends].push_back(passage.face);
    });
    std::map<Ends, std::size_t> listed;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const Ends ends = std::minmax(edges[e].a, edges[e].b);
      const auto fault = [&](Index face, const char* text) {
        add(PolygonFault::EdgeNotReciprocal, {face}, {ends.first, ends.second},
            fmt::format(fmt::runtime(text), fmt::arg("e", e), fmt::arg("a", ends.first), fmt::arg("b", ends.second),
                        fmt::arg("f", face)));
      };
      const auto [entry, fresh] = listed.emplace(ends, e);
      if (!fresh) {
        add(PolygonFault::EdgeNotReciprocal, {}, {ends.first, ends.second},
            fmt::format("edge {} repeats edge {} ({}-{})", e, entry->second, ends.first, ends.second));
        continue;
      }
      const auto found = passed.find(ends);
      const std::vector<Index> none;
      const std::vector<Index>& of_faces = found == passed.end() ? none : found->second;
      for (const Index face : edges[e].faces) {
        if (std::find(of_faces.begin(), of_faces.end(), face) == of_faces.end())
          fault(face, "edge {e} ({a}-{b}) names face {f}, which does not pass it");
      }
      for (const Index face : of_faces) {
        if (std::find(edges[e].faces.begin(), edges[e].faces.end(), face) == edges[e].faces.end())
          fault(face, "face {f} passes edge {e} ({a}-{b}), which does not name it");
      }
    }
    for (const auto& [ends, faces] : passed) {
      if (listed.contains(ends)) continue;
      add(PolygonFault::EdgeNotReciprocal, faces, {ends.first, ends.second},
          fmt::format("face {} passes {}-{}, which is not in the list of edges", faces.front(), ends.first,
                      ends.second));
    }
  }

  const PolygonMesh& mesh_;
  Closedness closedness_;
  std::vector<bool> usable_;
  std::vector<Passage> passages_;
  std::vector<PolygonFinding> findings_;
};

}  // namespace

std::vector<PolygonEdge> edges_of(const PolygonMesh& mesh) {
  std::vector<PolygonEdge> edges;
  each_edge(passages_of(mesh, {}), [&](std::span<const Passage> edge) {
    PolygonEdge& last = edges.emplace_back(PolygonEdge{edge.front().ends.first, edge.front().ends.second, {}});
    for (const Passage& passage : edge) {
      if (last.faces.empty() || last.faces.back() != passage.face) last.faces.push_back(passage.face);
    }
  });
  return edges;
}

std::vector<PolygonFinding> check(const PolygonMesh& mesh, Closedness closedness) {
  return Check(mesh, closedness).run(nullptr);
}

std::vector<PolygonFinding> check(const PolygonMesh& mesh, std::span<const PolygonEdge> edges, Closedness closedness) {
  return Check(mesh, closedness).run(&edges);
}

geom::Point3 newell_area(std::span<const geom::Point3> points) {
  geom::Point3 sum;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const geom::Point3 &p = points[i], &q = points[(i + 1) % points.size()];
    sum.x += (p.y - q.y) * (p.z + q.z);
    sum.y += (p.z - q.z) * (p.x + q.x);
    sum.z += (p.x - q.x) * (p.y + q.y);
  }
  return {0.5 * sum.x, 0.5 * sum.y, 0.5 * sum.z};
}

std::vector<double> distances_from_mean_plane(std::span<const geom::Point3> points) {
  const geom::Point3 area = newell_area(points);
  const double size = std::hypot(area.x, area.y, area.z);
  if (size == 0.0) return {};
  geom::Point3 mean;
  for (const geom::Point3& p : points) mean = {mean.x + p.x, mean.y + p.y, mean.z + p.z};
  const double count = static_cast<double>(points.size());
  std::vector<double> distances;
  for (const geom::Point3& p : points) {
    distances.push_back(
        (area.x * (p.x - mean.x / count) + area.y * (p.y - mean.y / count) + area.z * (p.z - mean.z / count)) / size);
  }
  return distances;
}

}  // namespace dobra::mesh
