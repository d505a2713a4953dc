// OpenMesh wants its readers and writers included before its meshes.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include "shared/io/meshes/stl.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <sstream>
#include <unordered_map>

#include "shared/base/text.h"
#include "shared/io/meshes/mesh_plane.h"
#include "shared/io/scan.h"
#include "shared/mesh/openmesh.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point3;

namespace {

constexpr int all_digits = 17;
constexpr const char* as_text = ".stla";  // as OpenMesh calls it

/// Capitals do not count.
bool is_keyword(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// Every facet is followed by an endsolid; OpenMesh takes what it finds.
Result<void> check_end(std::string_view text, const std::string& file) {
  Records records(text, file, '\0');
  bool open = false;
  while (records.next()) {
    if (is_keyword(records.word(0), "facet")) open = true;
    if (is_keyword(records.word(0), "endsolid")) open = false;
  }
  if (!open) return {};
  return Error{ErrorCode::BadFormat, "the file ends without endsolid, as if it were cut short; write it again",
               base::Place{.file = file, .line = records.line_number()}};
}

/// Of a binary file, in bytes.
constexpr std::size_t head_size = 80;   // text before the count
constexpr std::size_t facet_size = 50;  // normal, three corners, two bytes more
constexpr std::size_t normal_size = 12;
constexpr std::size_t corner_size = 12;

std::uint32_t little_endian_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

float real_at(std::string_view bytes, std::size_t at) { return std::bit_cast<float>(little_endian_at(bytes, at)); }

/// Points by their coordinates.
class MergedPoints {
 public:
  explicit MergedPoints(mesh::PolygonMesh& mesh) : mesh_(mesh) {}
  std::uint32_t number(Point3 p) {
    // The two zeros are one number.
    const Key key{std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
                  std::bit_cast<std::uint64_t>(p.z + 0.0)};
    const auto [at, fresh] = numbers_.try_emplace(key, static_cast<std::uint32_t>(mesh_.points.size()));
    if (fresh) mesh_.points.push_back(p);
    return at->second;
  }

 private:
  using Key = std::array<std::uint64_t, 3>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t hash = 0;
      for (const std::uint64_t part : key) hash = (hash ^ part ^ (hash >> 29U)) * 0x9e3779b97f4a7c15U;
      return hash ^ (hash >> 32U);
    }
  };
  mesh::PolygonMesh& mesh_;
  std::unordered_map<Key, std::uint32_t, Hash> numbers_;
};

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= head_size + 4 &&
         bytes.size() == head_size + 4 + facet_size * std::size_t{little_endian_at(bytes, head_size)};
}

Result<mesh::PolygonMesh> parse_binary_stl(std::string_view bytes, const std::string& file) {
  mesh::PolygonMesh mesh;
  MergedPoints points(mesh);
  const std::uint32_t count = little_endian_at(bytes, head_size);
  mesh.faces.reserve(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    std::vector<std::uint32_t> face;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = head_size + 4 + facet_size * t + normal_size + corner_size * c;
      const Point3 p{real_at(bytes, at), real_at(bytes, at + 4), real_at(bytes, at + 8)};
      if (!is_finite(p)) {
        return Error{ErrorCode::NotFinite,
                     fmt::format("triangle {} of the file has a coordinate that is not a finite number", t),
                     base::Place{.file = file}};
      }
      face.push_back(points.number(p));
    }
    mesh.faces.push_back(std::move(face));
  }
  return mesh;
}

Result<mesh::PolygonMesh> parse_stl_text(std::string_view text, const std::string& file) {
  mesh::PolygonMesh mesh;
  MergedPoints points(mesh);
  Records records(text, file, '\0');
  std::vector<std::uint32_t> face;
  bool in_facet = false;
  bool in_solid = false;
  while (records.next()) {
    const std::string_view word = records.word(0);
    if (is_keyword(word, "vertex")) {
      Point3 p;
      DOBRA_TRY(p.x, records.number(1, "x"));
      DOBRA_TRY(p.y, records.number(2, "y"));
      DOBRA_TRY(p.z, records.number(3, "z"));
      if (!in_facet || face.size() == 3) return records.error(0, "a facet has three corners; this is one too many");
      face.push_back(points.number(p));
    } else if (is_keyword(word, "facet")) {
      if (in_facet) return records.error(0, "the facet before has no endfacet");
      in_facet = in_solid = true;
    } else if (is_keyword(word, "endfacet")) {
      if (face.size() != 3)
        return records.error(0, fmt::format("the facet has {} corners and must have 3", face.size()));
      mesh.faces.push_back(std::move(face));
      face.clear();
      in_facet = false;
    } else if (is_keyword(word, "solid")) {
      in_solid = true;
    } else if (is_keyword(word, "endsolid")) {
      in_solid = false;
    } else if (!is_keyword(word, "outer") && !is_keyword(word, "endloop")) {
      return records.error(0, fmt::format("{} is no word of an STL file", shown(word)));
    }
    if (is_keyword(word, "endsolid") && in_facet) return records.error(0, "the facet before has no endfacet");
  }
  if (!in_solid && !in_facet) return mesh;
  return Error{ErrorCode::BadFormat, "the file ends without endsolid, as if it were cut short; write it again",
               base::Place{.file = file, .line = records.line_number()}};
}

}  // namespace

Result<std::string> stl_text(const mesh::TriangleMesh& mesh) {
  DOBRA_TRY(const mesh::OpenMeshTriangles triangles, to_openmesh(mesh));
  omlog().disable();  // It says on standard error which writer it takes.
  std::ostringstream out;
  if (!OpenMesh::IO::write_mesh(triangles, out, as_text, OpenMesh::IO::Options::Default, all_digits)) {
    return Error{ErrorCode::CannotMesh, "OpenMesh could not write the mesh"};
  }
  return out.str();
}

std::string stl_text(const mesh::PolygonMesh& mesh) {
  std::string text = "solid\n";
  const auto facet = [&](geom::Point3 a, geom::Point3 b, geom::Point3 c) {
    const geom::Vector3 area = cross(b - a, c - a);
    const geom::Vector3 normal = length(area) > 0.0 ? normalised(area) : area;
    const auto triple = [](double x, double y, double z) {
      return fmt::format("{} {} {}\n", base::number_text(x), base::number_text(y), base::number_text(z));
    };
    text += "facet normal " + triple(normal.x, normal.y, normal.z) + "outer loop\n";
    for (const geom::Point3 p : {a, b, c}) text += "vertex " + triple(p.x, p.y, p.z);
    text += "endloop\nendfacet\n";
  };
  for (const auto& face : mesh.faces) {
    const auto at = [&](std::size_t i) { return mesh.points[face[i]]; };
    if (face.size() == 3) {
      facet(at(0), at(1), at(2));
    } else if (distance(at(0), at(2)) <= distance(at(1), at(3))) {
      facet(at(0), at(1), at(2)), facet(at(0), at(2), at(3));
    } else {
      facet(at(0), at(1), at(3)), facet(at(1), at(2), at(3));
    }
  }
  return text + "endsolid\n";
}

Result<mesh::TriangleMesh> parse_stl(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_end(text, file));
  std::istringstream in{std::string(text)};
  mesh::OpenMeshTriangles triangles;
  OpenMesh::IO::Options options;
  if (!OpenMesh::IO::read_mesh(triangles, in, as_text, options)) {
    return Error{ErrorCode::CannotMesh, "OpenMesh could not read the mesh", base::Place{.file = file}};
  }
  std::vector<geom::Point> points;
  std::vector<double> heights;
  for (const auto vertex : triangles.all_vertices()) {
    points.push_back({triangles.point(vertex)[0], triangles.point(vertex)[1]});
    heights.push_back(triangles.point(vertex)[2]);
  }
  DOBRA_TRY_VOID(check_plane(points, heights, file));
  auto mesh = mesh::from_openmesh(triangles);
  if (!mesh) return base::located(mesh.error(), {.file = file});
  return mesh;
}

Result<mesh::PolygonMesh> parse_stl_facets(std::string_view bytes, const std::string& file) {
  if (is_binary_stl(bytes)) return parse_binary_stl(bytes, file);
  if (bytes.find('\0') == std::string_view::npos) {
    DOBRA_TRY_VOID(check_text(bytes, file));
    return parse_stl_text(bytes, file);
  }
  if (bytes.size() < head_size + 4) {
    return Error{ErrorCode::BadFormat, "is no STL: neither text nor as long as the head of a binary file",
                 base::Place{.file = file}};
  }
  const std::uint32_t count = little_endian_at(bytes, head_size);
  return Error{ErrorCode::BadFormat,
               fmt::format("is a binary STL of {} triangles, which takes {} bytes, but has {}: it was cut short or "
                           "changed; write it again",
                           count, head_size + 4 + facet_size * std::size_t{count}, bytes.size()),
               base::Place{.file = file}};
}

}  // namespace dobra::io::meshes
