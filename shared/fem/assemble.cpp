#include "shared/fem/assemble.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/base/parallel.h"
#include "shared/fem/mixed.h"

namespace dobra::fem {
namespace {

using geom::Vector;
using mesh::ElementMesh;
using Block = std::array<double, 4>;

constexpr std::size_t grain = 256;

constexpr std::size_t block_count(std::size_t nodes) { return nodes * (nodes + 1) / 2; }
/// Position of block (a, b), a <= b, among those of an element of n nodes.
constexpr std::size_t block_index(std::size_t a, std::size_t b, std::size_t n) { return a * n - a * (a + 1) / 2 + b; }

/// The elements round each node, ascending.
struct Stars {
  std::vector<std::size_t> first;
  std::vector<std::uint32_t> elements;
};

Stars stars_of(const ElementMesh& mesh) {
  Stars stars;
  stars.first.assign(mesh.points.size() + 1, 0);
  for (const mesh::NodeId node : mesh.nodes) ++stars.first[node.index() + 1];
  for (std::size_t i = 0; i < mesh.points.size(); ++i) stars.first[i + 1] += stars.first[i];
  stars.elements.resize(mesh.nodes.size());
  std::vector<std::size_t> next(stars.first.begin(), stars.first.end() - 1);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const mesh::NodeId node : mesh.nodes_of(mesh::ElementId(e)))
      stars.elements[next[node.index()]++] = static_cast<std::uint32_t>(e);
  }
  return stars;
}

/// Nodes that share an element with `node`, from itself on.
void gather_row(const ElementMesh& mesh, const Stars& stars, std::size_t node, std::vector<std::uint32_t>& row) {
  row.clear();
  for (std::size_t k = stars.first[node]; k < stars.first[node + 1]; ++k) {
    for (const mesh::NodeId other : mesh.nodes_of(mesh::ElementId(stars.elements[k]))) {
      if (other.index() >= node) row.push_back(static_cast<std::uint32_t>(other.index()));
    }
  }
  if (row.empty()) row.push_back(static_cast<std::uint32_t>(node));  // a node of no element keeps its diagonal
  std::sort(row.begin(), row.end());
  row.erase(std::unique(row.begin(), row.end()), row.end());
}

BlockMatrix structure_of(const ElementMesh& mesh, const Stars& stars) {
  BlockMatrix matrix;
  const std::size_t n = mesh.points.size();
  const std::size_t chunks = (n + grain - 1) / grain;
  auto rows = base::parallel_map<std::vector<std::uint32_t>>(chunks, [&](std::size_t chunk) {
    std::vector<std::uint32_t> all, row;
    for (std::size_t node = chunk * grain; node < std::min(n, (chunk + 1) * grain); ++node) {
      gather_row(mesh, stars, node, row);
      all.push_back(static_cast<std::uint32_t>(row.size()));
      all.insert(all.end(), row.begin(), row.end());
    }
    return all;
  });
  matrix.first.reserve(n + 1);
  matrix.first.push_back(0);
  for (auto& all : rows) {
    for (std::size_t k = 0; k < all.size(); k += all[k] + 1) {
      matrix.first.push_back(matrix.first.back() + all[k]);
      matrix.columns.insert(matrix.columns.end(), all.begin() + static_cast<std::ptrdiff_t>(k + 1),
                            all.begin() + static_cast<std::ptrdiff_t>(k + 1 + all[k]));
    }
    all = {};
  }
  matrix.blocks.assign(matrix.columns.size(), Block{});
  return matrix;
}

Block& block_at(BlockMatrix& matrix, std::size_t row, std::size_t column) {
  const auto begin = matrix.columns.begin() + static_cast<std::ptrdiff_t>(matrix.first[row]);
  const auto end = matrix.columns.begin() + static_cast<std::ptrdiff_t>(matrix.first[row + 1]);
  return matrix.blocks[static_cast<std::size_t>(std::lower_bound(begin, end, column) - matrix.columns.begin())];
}

/// Sums row `node` over its elements, in ascending order.
void fill_row(const ElementMesh& mesh, const Stars& stars, std::span<const std::size_t> first_block,
              std::span<const Block> blocks, std::size_t node, BlockMatrix& matrix) {
  for (std::size_t k = stars.first[node]; k < stars.first[node + 1]; ++k) {
    const std::size_t element = stars.elements[k];
    const auto nodes = mesh.nodes_of(mesh::ElementId(element));
    std::size_t a = 0;
    while (nodes[a].index() != node) ++a;
    for (std::size_t b = 0; b < nodes.size(); ++b) {
      if (nodes[b].index() < node) continue;
      const Block& k_ab = blocks[first_block[element] + block_index(std::min(a, b), std::max(a, b), nodes.size())];
      Block& sum = block_at(matrix, node, nodes[b].index());
      sum[0] += k_ab[0];
      sum[1] += a <= b ? k_ab[1] : k_ab[2];
      sum[2] += a <= b ? k_ab[2] : k_ab[1];
      sum[3] += k_ab[3];
    }
  }
}

void add_foundation(const ElementMesh& mesh, const Problem& problem, const Spring& spring, BlockMatrix& matrix) {
  const auto sides = find_sides(mesh, spring.where).value();
  for (const mesh::ElementSide side : sides) {
    const double thickness = problem.materials.at(mesh.regions[side.element.index()]).thickness;
    integrate_side(mesh, side, [&](auto nodes, const Shape& shape, geom::Point, Vector, double length) {
      for (std::size_t a = 0; a < nodes.size(); ++a) {
        for (std::size_t b = 0; b < nodes.size(); ++b) {
          if (nodes[b] < nodes[a]) continue;
          Block& block = block_at(matrix, nodes[a].index(), nodes[b].index());
          const double factor = shape.n[a] * shape.n[b] * length * thickness;
          block[0] += factor * spring.x;
          block[3] += factor * spring.y;
        }
      }
    });
  }
}

void add_springs(const ElementMesh& mesh, const Problem& problem, BlockMatrix& matrix) {
  for (const Spring& spring : problem.springs) {
    if (spring.kind == SpringKind::Foundation) {
      add_foundation(mesh, problem, spring, matrix);
      continue;
    }
    const Shares shares = find_shares(mesh, spring.where).value();
    for (const mesh::NodeId node : shares.nodes) {
      Block& block = block_at(matrix, node.index(), node.index());
      block[0] += shares.each * spring.x;
      block[3] += shares.each * spring.y;
    }
  }
}

void add_body_force(const ElementMesh& mesh, const Materials& materials, const BodyForce& body,
                    std::span<Vector> forces) {
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (body.region && *body.region != mesh.regions[e]) continue;
    const ElementGeometry element = geometry_of(mesh, e);
    const double thickness = materials.at(mesh.regions[e]).thickness;
    const auto points = integration_points(element.type, Rule::Curved);
    const auto shapes = shapes_at(element.type, Rule::Curved);
    for (std::size_t g = 0; g < points.size(); ++g) {
      const Mapped m = map(element.points(), shapes[g]);
      const Vector force = m.determinant * points[g].weight * thickness * body.force(m.at);
      for (std::size_t a = 0; a < element.count; ++a)
        forces[element.nodes[a]] = forces[element.nodes[a]] + m.n[a] * force;
    }
  }
}

bool mixed_stiffness(const ElementGeometry& element, const Material& material, std::span<Block> blocks) {
  for (const Shape& shape : shapes_at(element.type, Rule::Curved)) {
    if (!(map(element.points(), shape).determinant > 0.0)) return false;
  }
  const MixedElement mixed(element, material);
  std::size_t k = 0;
  for (std::size_t a = 0; a < element.count; ++a) {
    for (std::size_t b = a; b < element.count; ++b, ++k)
      blocks[k] = {mixed.stiffness(2 * a, 2 * b), mixed.stiffness(2 * a, 2 * b + 1), mixed.stiffness(2 * a + 1, 2 * b),
                   mixed.stiffness(2 * a + 1, 2 * b + 1)};
  }
  return true;
}

}  // namespace

bool element_stiffness(const ElementGeometry& element, const Material& material, std::span<Block> blocks) {
  if (mesh::is_quadratic(element.type) && nearly_incompressible(material))
    return mixed_stiffness(element, material, blocks);
  const Elasticity d = elasticity(material);
  const Rule rule = stiffness_rule(element);
  const auto points = integration_points(element.type, rule);
  const auto shapes = shapes_at(element.type, rule);
  std::fill(blocks.begin(), blocks.end(), Block{});
  for (std::size_t g = 0; g < points.size(); ++g) {
    const Mapped m = map(element.points(), shapes[g]);
    if (!(m.determinant > 0.0)) return false;
    const double volume = m.determinant * points[g].weight * material.thickness;
    std::size_t k = 0;
    for (std::size_t a = 0; a < element.count; ++a) {
      const double xx = volume * d.xx * m.d_x[a];
      const double xy = volume * d.xy * m.d_x[a];
      const double sx = volume * d.shear * m.d_x[a];
      const double yy = volume * d.xx * m.d_y[a];
      const double yx = volume * d.xy * m.d_y[a];
      const double sy = volume * d.shear * m.d_y[a];
      for (std::size_t b = a; b < element.count; ++b, ++k) {
        blocks[k][0] += xx * m.d_x[b] + sy * m.d_y[b];
        blocks[k][1] += xy * m.d_y[b] + sy * m.d_x[b];
        blocks[k][2] += yx * m.d_x[b] + sx * m.d_y[b];
        blocks[k][3] += yy * m.d_y[b] + sx * m.d_x[b];
      }
    }
  }
  return true;
}

base::Result<BlockMatrix> assemble(const ElementMesh& mesh, const Problem& problem) {
  const std::size_t elements = mesh.element_count();
  std::vector<std::size_t> first_block(elements + 1, 0);
  for (std::size_t e = 0; e < elements; ++e)
    first_block[e + 1] = first_block[e] + block_count(mesh::node_count(mesh.types[e]));
  std::vector<Block> blocks(first_block.back());
  std::vector<std::uint8_t> good(elements);
  base::parallel_for(
      elements,
      [&](std::size_t e) {
        const auto own = std::span(blocks).subspan(first_block[e], first_block[e + 1] - first_block[e]);
        good[e] = element_stiffness(geometry_of(mesh, e), problem.materials.at(mesh.regions[e]), own);
      },
      grain);
  if (const auto bad = std::find(good.begin(), good.end(), std::uint8_t{0}); bad != good.end()) {
    const auto e = static_cast<std::size_t>(bad - good.begin());
    const geom::Point at = mesh.points[mesh.nodes[mesh.first[e]].index()];
    return base::Error{base::ErrorCode::CannotMesh,
                       fmt::format("element {} is turned inside out; move its mid-side nodes or mesh again", e),
                       base::Place{.x = at.x, .y = at.y}};
  }
  const Stars stars = stars_of(mesh);
  BlockMatrix matrix = structure_of(mesh, stars);
  base::parallel_for(
      mesh.points.size(), [&](std::size_t node) { fill_row(mesh, stars, first_block, blocks, node, matrix); }, grain);
  add_springs(mesh, problem, matrix);
  return matrix;
}

std::vector<Vector> multiply(const BlockMatrix& matrix, std::span<const Vector> u) {
  std::vector<Vector> product(matrix.size());
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t k = matrix.first[i]; k < matrix.first[i + 1]; ++k) {
      const std::size_t j = matrix.columns[k];
      const auto& [xx, xy, yx, yy] = matrix.blocks[k];
      product[i] = product[i] + Vector{xx * u[j].x + xy * u[j].y, yx * u[j].x + yy * u[j].y};
      if (j != i) product[j] = product[j] + Vector{xx * u[i].x + yx * u[i].y, xy * u[i].x + yy * u[i].y};
    }
  }
  return product;
}

void add_side_load(const ElementMesh& mesh, const Materials& materials, std::span<const mesh::ElementSide> sides,
                   const Traction& traction, std::span<Vector> forces) {
  for (const mesh::ElementSide side : sides) {
    const double thickness = materials.at(mesh.regions[side.element.index()]).thickness;
    integrate_side(mesh, side, [&](auto nodes, const Shape& shape, geom::Point at, Vector normal, double length) {
      const Vector force = length * thickness * traction(at, normal);
      for (std::size_t a = 0; a < nodes.size(); ++a)
        forces[nodes[a].index()] = forces[nodes[a].index()] + shape.n[a] * force;
    });
  }
}

std::vector<Vector> load_vector(const ElementMesh& mesh, const Problem& problem, const LoadCase& load) {
  std::vector<Vector> forces(mesh.points.size());
  for (const SideLoad& side : load.sides)
    add_side_load(mesh, problem.materials, find_sides(mesh, side.where).value(), side.traction, forces);
  for (const BodyForce& body : load.bodies) add_body_force(mesh, problem.materials, body, forces);
  for (const PointLoad& point : load.points) {
    const Shares shares = find_shares(mesh, point.where).value();
    for (const mesh::NodeId node : shares.nodes)
      forces[node.index()] = forces[node.index()] + shares.each * point.force;
  }
  return forces;
}

}  // namespace dobra::fem
