// OpenMesh wants its readers and writers included before its meshes.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include "shared/io/meshes/stl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "shared/base/text.h"
#include "shared/io/meshes/mesh_plane.h"
#include "shared/io/scan.h"
#include "shared/mesh/openmesh.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;

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

}  // namespace dobra::io::meshes
