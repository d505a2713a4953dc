#include "shared/solid/check/settle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <unordered_map>

#include "shared/base/check.h"
#include "shared/solid/warp.h"

namespace dobra::solid::check {
namespace {

using geom::Point3;

/// A triangle of the rounded boundary, and how far it is from that boundary as it was before, at most.
struct Piece {
  std::array<std::uint32_t, 3> corners;
  std::uint32_t name;
  double off = 0.0;
};

/// Makes one what is nearly one. Triangles stay closed, as sums of oriented edges, whatever is done.
class Tidier {
 public:
  Tidier(const ToMesh& faces, double tolerance) : points_(faces.mesh.points), tolerance_(tolerance) {
    pieces_.reserve(faces.mesh.faces.size());
    for (std::uint32_t f = 0; f < faces.mesh.faces.size(); ++f) {
      const auto& face = faces.mesh.faces[f];
      DOBRA_CHECK(face.size() == 3);
      pieces_.push_back({{face[0], face[1], face[2]}, f});
    }
  }

  void run() {
    merge_points();
    swap_edges();
  }

  /// Replaces the faces; points that none of them has go.
  void put_into(ToMesh& faces) const {
    ToMesh out;
    std::vector<std::uint32_t> numbers(points_.size(), none);
    for (const Piece& piece : pieces_) {
      if (gone(piece)) continue;
      std::vector<std::uint32_t>& face = out.mesh.faces.emplace_back();
      for (const std::uint32_t corner : piece.corners) {
        if (numbers[corner] == none) {
          numbers[corner] = static_cast<std::uint32_t>(out.mesh.points.size());
          out.mesh.points.push_back(points_[corner]);
        }
        face.push_back(numbers[corner]);
      }
      out.names.push_back(faces.names[piece.name]);
    }
    faces = std::move(out);
  }

  [[nodiscard]] double displacement() const { return displacement_; }
  [[nodiscard]] std::size_t merged() const { return merged_; }
  [[nodiscard]] Point3 at() const { return at_; }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& cell) const {
      std::uint64_t hash = 0;
      for (const std::int64_t part : cell)
        hash = (hash ^ static_cast<std::uint64_t>(part) ^ (hash >> 29U)) * 0x9e3779b97f4a7c15U;
      return hash ^ (hash >> 32U);
    }
  };

  static bool gone(const Piece& piece) {
    const auto& [a, b, c] = piece.corners;
    return a == b || b == c || c == a;
  }

  void note(double off, Point3 at) {
    if (off <= displacement_) return;
    displacement_ = off;
    at_ = at;
  }

  /// Points within the tolerance of one that was kept before become that one.
  void merge_points() {
    std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> kept;
    std::vector<std::uint32_t> one(points_.size());
    for (std::uint32_t p = 0; p < points_.size(); ++p) {
      one[p] = near_one(kept, p);
      if (one[p] != p) {
        ++merged_;
        note(distance(points_[p], points_[one[p]]), points_[p]);
      }
    }
    for (Piece& piece : pieces_) {
      for (std::uint32_t& corner : piece.corners) {
        piece.off = std::max(piece.off, distance(points_[corner], points_[one[corner]]));
        corner = one[corner];
      }
    }
  }

  std::uint32_t near_one(std::unordered_map<Cell, std::vector<std::uint32_t>, Hash>& kept, std::uint32_t p) const {
    const Point3 at = points_[p];
    const auto step = [&](double x) { return static_cast<std::int64_t>(std::floor(x / tolerance_)); };
    const Cell own{step(at.x), step(at.y), step(at.z)};
    for (std::int64_t i = own[0] - 1; i <= own[0] + 1; ++i) {
      for (std::int64_t j = own[1] - 1; j <= own[1] + 1; ++j) {
        for (std::int64_t k = own[2] - 1; k <= own[2] + 1; ++k) {
          const auto found = kept.find({i, j, k});
          if (found == kept.end()) continue;
          for (const std::uint32_t q : found->second) {
            if (distance(points_[q], at) <= tolerance_) return q;
          }
        }
      }
    }
    kept[own].push_back(p);
    return p;
  }

  // ---- a triangle that is nearly its longest side: its third corner is put into that side -------------------------

  static std::uint64_t key(std::uint32_t a, std::uint32_t b) { return (std::uint64_t{a} << 32U) | b; }

  void enter(std::uint32_t t) {
    for (std::size_t i = 0; i < 3; ++i)
      of_edge_[key(pieces_[t].corners[i], pieces_[t].corners[(i + 1) % 3])].push_back(t);
  }
  void leave(std::uint32_t t) {
    for (std::size_t i = 0; i < 3; ++i)
      std::erase(of_edge_[key(pieces_[t].corners[i], pieces_[t].corners[(i + 1) % 3])], t);
  }

  void swap_edges() {
    std::deque<std::uint32_t> open;
    for (std::uint32_t t = 0; t < pieces_.size(); ++t) {
      if (gone(pieces_[t])) continue;
      enter(t);
      open.push_back(t);
    }
    std::size_t left = 8 * open.size();  // so that it ends where triangles are swapped to and fro
    while (!open.empty() && left-- > 0) {
      const std::uint32_t t = open.front();
      open.pop_front();
      if (gone(pieces_[t])) continue;
      const auto longest = longest_side(pieces_[t]);
      const auto& corners = pieces_[t].corners;
      const std::uint32_t a = corners[longest];
      const std::uint32_t b = corners[(longest + 1) % 3];
      const std::uint32_t apex = corners[(longest + 2) % 3];
      const geom::Vector3 side = points_[b] - points_[a];
      const double height = length(cross(side, points_[apex] - points_[a])) / length(side);
      if (height > tolerance_) continue;
      const auto beyond = of_edge_.find(key(b, a));
      if (beyond == of_edge_.end() || beyond->second.empty()) continue;
      swap(t, beyond->second.back(), {a, b, apex}, height, open);
    }
  }

  [[nodiscard]] std::size_t longest_side(const Piece& piece) const {
    std::size_t longest = 0;
    double most = -1.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double size = distance(points_[piece.corners[i]], points_[piece.corners[(i + 1) % 3]]);
      if (size <= most) continue;
      most = size;
      longest = i;
    }
    return longest;
  }

  /// Of a-b-apex and b-a-c on the other side, apex-a-c and b-apex-c are made.
  void swap(std::uint32_t t, std::uint32_t other, const std::array<std::uint32_t, 3>& own, double height,
            std::deque<std::uint32_t>& open) {
    const auto& [a, b, apex] = own;
    std::uint32_t c = none;
    for (const std::uint32_t corner : pieces_[other].corners) {
      if (corner != a && corner != b) c = corner;
    }
    leave(t);
    leave(other);
    ++merged_;
    const double off = std::max(pieces_[t].off, pieces_[other].off) + height;
    note(off, points_[apex]);
    if (c == apex) {  // the two lie on each other and bound nothing
      pieces_[t].corners = pieces_[other].corners = {a, a, a};
      return;
    }
    const std::uint32_t name = pieces_[other].name;
    pieces_[t] = {{apex, a, c}, name, off};
    pieces_[other] = {{b, apex, c}, name, off};
    for (const std::uint32_t made : {t, other}) {
      enter(made);
      open.push_back(made);
    }
  }

  std::vector<Point3> points_;
  std::vector<Piece> pieces_;
  double tolerance_;
  double displacement_ = 0.0;
  std::size_t merged_ = 0;
  Point3 at_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> of_edge_;
};

double largest_coordinate(const std::vector<Point3>& points) {
  double largest = 0.0;
  for (const Point3& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest;
}

/// As the file has it: in its unit.
base::Result<ToMesh> in_unit(const Solid& solid, FacesAs as, double unit) {
  DOBRA_TRY(ToMesh faces, to_mesh(solid, as));
  if (unit == 1.0) return faces;
  for (Point3& p : faces.mesh.points) p = {p.x / unit, p.y / unit, p.z / unit};
  // Each coordinate is rounded once more, by half a unit in its last place.
  faces.displacement = faces.displacement / unit + 0x1p-52 * largest_coordinate(faces.mesh.points);
  return faces;
}

base::Result<Taken> taken(const ToMesh& faces, Crossings crossings) {
  FromMeshOptions options;
  options.face_names = faces.names;
  options.crossings = crossings;
  return take(faces.mesh, options);
}

void put(ToMesh& faces, const Solid& bounded, double displacement, SettledMesh& out) {
  out.mesh = std::move(faces.mesh);
  out.names = std::move(faces.names);
  out.counts = bounded.counts();
  out.displacement = displacement;
}

/// Whether it came to a mesh that bounds a solid.
base::Result<bool> mend(ToMesh faces, const SettleOptions& options, SettledMesh& out) {
  const double last_place = 0x1p-52 * largest_coordinate(faces.mesh.points);
  const double most = std::max(options.most * diagonal_of(faces.mesh.points), options.least_places * last_place);
  double displacement = faces.displacement;
  double farthest = 0.0;
  // Sheets that lie on each other cross all over; what is cut there must not grow without end.
  const std::size_t most_faces = 1000 + 3 * faces.mesh.faces.size();
  for (double tolerance = 2.0 * last_place; displacement + tolerance <= most && faces.mesh.faces.size() <= most_faces;
       tolerance *= 4.0) {
    Tidier tidier(faces, tolerance);
    tidier.run();
    tidier.put_into(faces);
    displacement += tidier.displacement();
    out.merged += tidier.merged();
    if (tidier.displacement() > farthest) {
      farthest = tidier.displacement();
      out.at = tidier.at();
    }
    const auto read = taken(faces, Crossings::Resolved);
    if (!read || read->solid.empty()) return false;
    if (!read->resolved) {
      put(faces, read->solid, displacement, out);
      return true;
    }
    DOBRA_TRY(faces, to_mesh(read->solid, FacesAs::Triangles));
    displacement += faces.displacement;
  }
  return false;
}

}  // namespace

base::Result<SettledMesh> settle(const Solid& solid, const SettleOptions& options) {
  SettledMesh out;
  DOBRA_TRY(ToMesh faces, in_unit(solid, options.as, options.unit));
  const auto read = taken(faces, Crossings::Refused);
  if (read) {
    put(faces, read->solid, faces.displacement, out);
    return out;
  }
  DOBRA_TRY(ToMesh triangles, in_unit(solid, FacesAs::Triangles, options.unit));
  DOBRA_TRY(const bool mended, mend(std::move(triangles), options, out));
  if (mended) return out;
  out = {};
  out.flaw = read.error();
  put(faces, solid, faces.displacement, out);
  return out;
}

}  // namespace dobra::solid::check
