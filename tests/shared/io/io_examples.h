#pragma once
// What several tests of io need: a folder of their own, a mesh with everything in it, and checks of errors.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "shared/base/error.h"
#include "shared/mesh/lips.h"
#include "shared/mesh/order2.h"
#include "shared/mesh/recombine.h"

namespace dobra::test {

/// A fresh folder that goes away with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "dobra_io_XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// A plate of n x n cells with a square hole in the middle, bent so that no coordinate is a short decimal: two regions
/// (0 and 7) on either side of a constraint, a second constraint inside region 7, boundary sets, two node sets.
inline mesh::TriangleMesh example_triangles(std::size_t n = 12) {
  mesh::TriangleMesh mesh;
  const auto node = [&](std::size_t i, std::size_t j) { return mesh::NodeId(j * (n + 1) + i); };
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / static_cast<double>(n);
      const double y = static_cast<double>(j) / static_cast<double>(n);
      mesh.points.push_back({x + 0.03 * std::sin(7.0 * y), y - 0.0123 * std::cos(5.0 * x) * 1e-3});
    }
  }
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      if (i == n / 3 && j == n / 2) continue;  // The hole, left of the constraint.
      mesh.triangles.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1)});
      mesh.triangles.push_back({node(i, j), node(i + 1, j + 1), node(i, j + 1)});
      const std::int32_t region = i < 2 * n / 3 ? 0 : 7;
      mesh.regions.insert(mesh.regions.end(), {region, region});
    }
  }
  const auto on = [&](mesh::NodeId k, std::size_t column, std::size_t row) {
    return k.index() % (n + 1) == column || k.index() / (n + 1) == row;
  };
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  for (const mesh::Edge& edge : mesh::boundary_edges(mesh)) {
    const auto both = [&](std::size_t column, std::size_t row) {
      return on(edge[0], column, row) && on(edge[1], column, row);
    };
    const char* const name = both(none, 0)   ? "bottom"
                             : both(n, none) ? "right"
                             : both(none, n) ? "top"
                             : both(0, none) ? "left"
                                             : "hole";
    mesh.boundary_sets[name].push_back(edge);
  }
  for (std::size_t j = 0; j < n; ++j)
    mesh.constraint_sets["interface"].push_back({node(2 * n / 3, j), node(2 * n / 3, j + 1)});
  for (std::size_t i = 2 * n / 3 + 1; i + 1 < n; ++i)
    mesh.constraint_sets["inner"].push_back({node(i, 2), node(i + 1, 2)});
  mesh.node_sets["pin"] = {node(0, 0)};
  mesh.node_sets["gauges"] = {node(1, 1), node(2, 1), node(n, n)};
  return mesh;
}

/// The same as a mesh of elements, the constraint in region 7 opened as a crack; region 7 has a name.
inline mesh::ElementMesh example_mesh(std::size_t n = 12) {
  mesh::ElementMesh mesh = mesh::element_mesh_of(example_triangles(n));
  mesh.region_names[7] = "granite";
  const std::vector<std::string> cracks{"inner"};
  return n < 12 ? mesh : mesh::open_lips(std::move(mesh), cracks).value();
}

/// The same with quadrilaterals where they fit, and elements of second order.
inline mesh::ElementMesh quadratic_example() {
  return mesh::to_second_order(mesh::recombine(example_mesh(), {0.9})).mesh;
}

/// "file:line:column" of an error.
inline std::string place_text(const base::Error& error) {
  if (!error.place) return "nowhere";
  return error.place->file + ':' + std::to_string(error.place->line) + ':' + std::to_string(error.place->column);
}

}  // namespace dobra::test
