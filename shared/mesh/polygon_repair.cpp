#include "shared/mesh/polygon_repair.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "shared/mesh/polygon_lists.h"

namespace dobra::mesh {
namespace {

using geom::Point3;
using geom::Vector3;
using Index = std::uint32_t;

Point3 middle(const std::vector<Point3>& points, const std::vector<Index>& of) {
  Vector3 sum{};
  std::size_t count = 0;
  for (const Index p : of) {
    if (p >= points.size() || !is_finite(points[p])) continue;
    sum = sum + (points[p] - Point3{});
    ++count;
  }
  return count == 0 ? Point3{} : Point3{} + sum / static_cast<double>(count);
}

/// Faces that hang together over edges.
std::vector<Index> parts_of(const PolygonMesh& mesh, std::size_t& count) {
  std::vector<Index> root(mesh.faces.size());
  std::iota(root.begin(), root.end(), 0U);
  const auto find = [&](Index i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const PolygonEdge& edge : edges_of(mesh)) {
    for (std::size_t i = 1; i < edge.faces.size(); ++i) root[find(edge.faces[i])] = find(edge.faces[0]);
  }
  std::map<Index, Index> numbers;
  std::vector<Index> part(root.size());
  for (Index f = 0; f < root.size(); ++f)
    part[f] = numbers.try_emplace(find(f), static_cast<Index>(numbers.size())).first->second;
  count = numbers.size();
  return part;
}

class Mender {
 public:
  Mender(const PolygonMesh& mesh, const PolygonRepairOptions& options) : given_(mesh), options_(options) {}

  RepairedPolygons run() {
    take_faces();
    drop_repeats();
    if (options_.turn) turn_like_neighbours();
    if (options_.fill) fill_holes();
    if (options_.turn) turn_parts_outwards();
    drop_points();
    return std::move(out_);
  }

 private:
  using Kind = PolygonRepair::Kind;

  void tell(Kind kind, std::vector<Index> items, Point3 place, std::string message) {
    out_.repairs.push_back({kind, std::move(items), place, std::move(message)});
  }
  [[nodiscard]] Point3 place_of(Index given_face) const { return middle(given_.points, given_.faces[given_face]); }

  /// Faces with the first of equal points, without repeated corners.
  void take_faces() {
    std::vector<Point3> finite = given_.points;
    for (Point3& p : finite) {
      if (!is_finite(p)) p = Point3{};
    }
    const std::vector<Index> first = merged_points(finite, options_.merge);
    std::vector<Index> merged;
    std::vector<Index> used(given_.points.size(), 0);
    for (Index f = 0; f < given_.faces.size(); ++f) {
      std::vector<Index> face;
      bool good = true;
      for (const Index corner : given_.faces[f]) {
        if (corner >= given_.points.size() || !is_finite(given_.points[corner])) {
          good = false;
          break;
        }
        if (std::exchange(used[corner], 1) == 0 && first[corner] != corner) merged.push_back(corner);
        if (face.empty() || face.back() != first[corner]) face.push_back(first[corner]);
      }
      while (face.size() > 1 && face.front() == face.back()) face.pop_back();
      if (good && face.size() >= 3) {
        out_.mesh.faces.push_back(std::move(face));
        out_.faces.push_back(f);
        continue;
      }
      tell(Kind::DroppedFaces, {f}, place_of(f),
           fmt::format("face {} is left out: {}", f,
                       good ? "it has less than three corners" : "one of its corners is no point"));
    }
    if (!merged.empty()) {
      std::sort(merged.begin(), merged.end());
      std::string text = fmt::format("{} points are one with others at the same place", merged.size());
      const Point3 at = given_.points[merged.front()];
      tell(Kind::MergedPoints, std::move(merged), at, std::move(text));
    }
    out_.mesh.points = given_.points;
  }

  void keep(const std::vector<char>& gone) {
    std::size_t to = 0;
    for (std::size_t f = 0; f < gone.size(); ++f) {
      if (gone[f] != 0) continue;
      if (to != f) out_.mesh.faces[to] = std::move(out_.mesh.faces[f]);
      out_.faces[to] = out_.faces[f];
      ++to;
    }
    out_.mesh.faces.resize(to);
    out_.faces.resize(to);
  }

  /// Of faces with the same corners in the same cyclic order, either way round, the first stays.
  void drop_repeats() {
    std::set<std::vector<Index>> seen;
    std::vector<char> gone(out_.mesh.faces.size(), 0);
    for (std::size_t f = 0; f < gone.size(); ++f) {
      std::vector<Index> face = out_.mesh.faces[f];
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      if (face.back() < face[1]) std::reverse(face.begin() + 1, face.end());
      if (seen.insert(std::move(face)).second) continue;
      gone[f] = 1;
      const Index given = out_.faces[f];
      tell(Kind::DroppedRepeats, {given}, place_of(given),
           fmt::format("face {} is left out: it is there twice", given));
    }
    keep(gone);
  }

  void turn(std::size_t face) { std::reverse(out_.mesh.faces[face].begin(), out_.mesh.faces[face].end()); }

  void turn_like_neighbours() {
    for (const PolygonFinding& finding : check(out_.mesh, Closedness::Sheet)) {
      if (finding.fault != PolygonFault::ReversedFace) continue;
      turn(finding.faces[0]);
      const Index given = out_.faces[finding.faces[0]];
      tell(Kind::TurnedFaces, {given}, place_of(given), fmt::format("face {} is turned like its neighbours", given));
    }
  }

  void fill_holes() {
    for (const PolygonFinding& finding : check(out_.mesh, Closedness::Solid)) {
      if (finding.fault != PolygonFault::OpenBoundary) continue;
      const std::vector<Index>& loop = finding.points;
      const std::set<Index> corners(loop.begin(), loop.end());
      if (loop.size() < 3 || loop.size() > options_.longest || corners.size() != loop.size()) continue;
      out_.mesh.faces.push_back(loop);
      out_.faces.push_back(RepairedPolygons::none);
      tell(Kind::FilledHole, loop, middle(given_.points, loop),
           fmt::format("a missing face is put in over the points {}", fmt::join(loop, "-")));
    }
  }

  /// Six times the volume that the faces of a part bound, seen from a point of theirs.
  [[nodiscard]] double bounded(const std::vector<Index>& faces) const {
    const Point3 origin = out_.mesh.points[out_.mesh.faces[faces[0]][0]];
    double sum = 0.0;
    for (const Index f : faces) {
      const auto& face = out_.mesh.faces[f];
      const Vector3 a = out_.mesh.points[face[0]] - origin;
      for (std::size_t i = 1; i + 1 < face.size(); ++i)
        sum += dot(a, cross(out_.mesh.points[face[i]] - origin, out_.mesh.points[face[i + 1]] - origin));
    }
    return sum;
  }

  /// How often the faces surround a point, by solid angles.
  [[nodiscard]] double turns_round(const std::vector<Index>& faces, Point3 p) const {
    double sum = 0.0;
    for (const Index f : faces) {
      const auto& face = out_.mesh.faces[f];
      for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        const Vector3 a = out_.mesh.points[face[0]] - p;
        const Vector3 b = out_.mesh.points[face[i]] - p;
        const Vector3 c = out_.mesh.points[face[i + 1]] - p;
        const double la = length(a);
        const double lb = length(b);
        const double lc = length(c);
        sum += std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
      }
    }
    return sum / (2.0 * std::numbers::pi);
  }

  [[nodiscard]] std::pair<Point3, Point3> box_of(const std::vector<Index>& faces) const {
    Point3 low = out_.mesh.points[out_.mesh.faces[faces[0]][0]];
    Point3 high = low;
    for (const Index f : faces) {
      for (const Index corner : out_.mesh.faces[f]) {
        const Point3 p = out_.mesh.points[corner];
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    }
    return {low, high};
  }

  void turn_parts_outwards() {
    std::size_t count = 0;
    const std::vector<Index> part = parts_of(out_.mesh, count);
    std::vector<std::vector<Index>> faces(count);
    for (Index f = 0; f < part.size(); ++f) faces[part[f]].push_back(f);
    std::set<Index> open;
    for (const PolygonEdge& edge : edges_of(out_.mesh)) {
      if (edge.faces.size() != 2) open.insert(part[edge.faces[0]]);
    }
    for (const PolygonFinding& finding : check(out_.mesh, Closedness::Sheet)) {
      if (finding.fault == PolygonFault::NotOrientable) open.insert(part[finding.faces[0]]);
    }
    std::vector<std::pair<Point3, Point3>> boxes;
    for (const auto& own : faces) boxes.push_back(box_of(own));
    std::vector<char> wrong(count, 0);
    for (Index i = 0; i < count; ++i) {
      if (open.contains(i)) continue;
      const Point3 at = out_.mesh.points[out_.mesh.faces[faces[i][0]][0]];
      std::size_t round = 0;
      for (Index j = 0; j < count; ++j) {
        const auto& [low, high] = boxes[j];
        const bool may = low.x <= at.x && at.x <= high.x && low.y <= at.y && at.y <= high.y && low.z <= at.z &&
                         at.z <= high.z && j != i && !open.contains(j);
        if (may && std::abs(turns_round(faces[j], at)) > 0.5) ++round;
      }
      wrong[i] = (bounded(faces[i]) < 0.0) != (round % 2 == 1) ? 1 : 0;
    }
    for (Index i = 0; i < count; ++i) {
      if (wrong[i] == 0) continue;
      std::vector<Index> items;
      for (const Index f : faces[i]) {
        turn(f);
        if (out_.faces[f] != RepairedPolygons::none) items.push_back(out_.faces[f]);
      }
      std::string text = fmt::format("the part of {} faces with face {} is turned over: it was inside out",
                                     faces[i].size(), items.empty() ? faces[i][0] : items.front());
      const Point3 at = items.empty() ? Point3{} : place_of(items.front());
      tell(Kind::TurnedFaces, std::move(items), at, std::move(text));
    }
  }

  void drop_points() {
    std::vector<Index> number(given_.points.size(), RepairedPolygons::none);
    std::vector<char> named(given_.points.size(), 0);
    for (const auto& face : given_.faces) {
      for (const Index corner : face) {
        if (corner < named.size()) named[corner] = 1;
      }
    }
    for (const auto& face : out_.mesh.faces) {
      for (const Index corner : face) number[corner] = 0;
    }
    std::vector<Index> unused;
    std::vector<Point3> kept;
    for (Index p = 0; p < number.size(); ++p) {
      if (named[p] == 0) unused.push_back(p);
      if (number[p] == RepairedPolygons::none) continue;
      number[p] = static_cast<Index>(kept.size());
      kept.push_back(out_.mesh.points[p]);
    }
    for (auto& face : out_.mesh.faces) {
      for (Index& corner : face) corner = number[corner];
    }
    out_.mesh.points = std::move(kept);
    if (unused.empty()) return;
    std::string text = fmt::format("{} points belong to no face and are left out", unused.size());
    const Point3 at = given_.points[unused.front()];
    tell(Kind::DroppedPoints, std::move(unused), at, std::move(text));
  }

  const PolygonMesh& given_;
  PolygonRepairOptions options_;
  RepairedPolygons out_;
};

}  // namespace

PolygonReport report(const PolygonMesh& mesh, Closedness closedness, double flat) {
  PolygonReport told;
  Point3 low{INFINITY, INFINITY, INFINITY};
  Point3 high{-INFINITY, -INFINITY, -INFINITY};
  for (const Point3 p : mesh.points) {
    if (!is_finite(p)) continue;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double off = mesh.points.empty() ? 0.0 : flat * distance(low, high);
  told.findings = check(mesh, closedness);
  std::vector<char> bad(mesh.faces.size(), 0);
  for (const PolygonFinding& finding : told.findings) {
    std::vector<Index> points = finding.points;
    if (points.empty() && !finding.faces.empty()) points = mesh.faces[finding.faces[0]];
    told.places.push_back(middle(mesh.points, points));
    if (finding.fault == PolygonFault::BadCorner) bad[finding.faces[0]] = 1;
  }
  PolygonMesh usable{mesh.points, {}};
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (bad[f] != 0) continue;
    usable.faces.push_back(mesh.faces[f]);
    if (mesh.faces[f].size() < 4) continue;
    std::vector<Point3> corners;
    for (const Index corner : mesh.faces[f]) corners.push_back(mesh.points[corner]);
    double most = 0.0;
    for (const double d : distances_from_mean_plane(corners)) most = std::max(most, std::abs(d));
    if (most > off) told.warped.push_back({f, most});
  }
  parts_of(usable, told.parts);
  return told;
}

RepairedPolygons repaired(const PolygonMesh& mesh, const PolygonRepairOptions& options) {
  return Mender(mesh, options).run();
}

}  // namespace dobra::mesh
