#include "shared/fem/constraints.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "shared/base/angle.h"

namespace dobra::fem {
namespace {

using geom::Vector;
using mesh::ElementMesh;

constexpr double negligible = 1e-12;  ///< Of the greatest coefficient of a constraint.
/// Sides that turn by more than 30 degrees at a node hold it along both normals; less is a curve, held along the mean.
const double same_normal = std::cos(base::Angle::from_degrees(30.0).radians());

std::uint32_t dof(mesh::NodeId node, Axis axis) {
  return static_cast<std::uint32_t>(2 * node.index() + static_cast<std::size_t>(axis));
}

/// The directions along which the sides of a set hold each of their nodes.
std::map<mesh::NodeId, std::vector<Vector>> normals_of(const ElementMesh& mesh,
                                                       const std::vector<mesh::ElementSide>& sides) {
  std::map<mesh::NodeId, std::vector<Vector>> normals;
  for (const mesh::ElementSide side : sides) {
    const ElementType type = mesh.types[side.element.index()];
    const auto nodes = side_nodes(mesh, side);
    const std::size_t count = mesh::is_quadratic(type) ? 3 : 2;
    for (std::size_t i = 0; i < count; ++i) {
      const Shape shape = side_shape(type, i == 0 ? -1.0 : (i == 1 ? 1.0 : 0.0));
      Vector tangent;
      for (std::size_t k = 0; k < count; ++k) {
        const geom::Point p = mesh.point(nodes[k]);
        tangent = tangent + shape.d_xi[k] * Vector{p.x, p.y};
      }
      // At a crack tip with quarter points the parabola stands still; its side is straight.
      const Vector chord = mesh.point(nodes[1]) - mesh.point(nodes[0]);
      if (length(tangent) < negligible * length(chord)) tangent = chord;
      const Vector normal = normalised(right_of(tangent));
      auto& known = normals[nodes[i]];
      const auto alike =
          std::find_if(known.begin(), known.end(), [&](Vector other) { return dot(normal, other) > same_normal; });
      if (alike == known.end()) {
        known.push_back(normal);
      } else if (dot(normal, *alike) < 1.0 - negligible) {
        *alike = normalised(normal + *alike);
      }
    }
  }
  return normals;
}

void add_support(const ElementMesh& mesh, const Support& support, std::vector<DofConstraint>& constraints) {
  const std::string name = "support of '" + support.where + "'";
  const auto nodes = find_nodes(mesh, support.where).value();
  for (const mesh::NodeId node : nodes) {
    if (support.x) constraints.push_back({{{dof(node, Axis::X), 1.0}}, *support.x, name});
    if (support.y) constraints.push_back({{{dof(node, Axis::Y), 1.0}}, *support.y, name});
    if (support.field) {
      const Vector u = support.field(mesh.point(node));
      constraints.push_back({{{dof(node, Axis::X), 1.0}}, u.x, name});
      constraints.push_back({{{dof(node, Axis::Y), 1.0}}, u.y, name});
    }
  }
  if (!support.normal) return;
  const auto sides = find_sides(mesh, support.where).value();
  for (const auto& [node, normals] : normals_of(mesh, sides)) {
    for (const Vector n : normals)
      constraints.push_back({{{dof(node, Axis::X), n.x}, {dof(node, Axis::Y), n.y}}, *support.normal, name});
  }
}

using Row = std::map<std::uint32_t, double>;

}  // namespace

std::vector<DofConstraint> constraints_of(const ElementMesh& mesh, const Problem& problem) {
  std::vector<DofConstraint> constraints;
  for (const Support& support : problem.supports) add_support(mesh, support, constraints);
  for (const Tie& tie : problem.ties) {
    DofConstraint constraint{{}, tie.value, tie.name};
    for (const TieTerm& term : tie.terms) constraint.terms.push_back({dof(term.node, term.axis), term.coefficient});
    constraints.push_back(std::move(constraint));
  }
  return constraints;
}

base::Result<EquationMap> EquationMap::make(const ElementMesh& mesh, const std::vector<DofConstraint>& constraints) {
  EquationMap map;
  map.index_.assign(2 * mesh.points.size(), 0);
  std::unordered_map<std::uint32_t, std::size_t> slave_of;
  std::vector<std::uint32_t> pivots;
  double largest_value = 0.0;
  for (const DofConstraint& constraint : constraints)
    largest_value = std::max(largest_value, std::abs(constraint.value));

  for (const DofConstraint& constraint : constraints) {
    Row row;
    double value = constraint.value;
    double scale = 0.0;
    // What earlier constraints eliminated is replaced; their own right sides may hold later slaves, so until none is
    // left.
    std::vector<DofTerm> pending(constraint.terms);
    for (const auto& [d, c] : pending) scale = std::max(scale, std::abs(c));
    while (!pending.empty()) {
      const auto [d, c] = pending.back();
      pending.pop_back();
      const auto slave = slave_of.find(d);
      if (slave == slave_of.end()) {
        row[d] += c;
        continue;
      }
      value -= c * map.slaves_[slave->second].value;
      for (const auto& [other, factor] : map.slaves_[slave->second].terms) pending.push_back({other, c * factor});
    }
    std::erase_if(row, [&](const auto& term) { return std::abs(term.second) <= negligible * scale; });
    if (row.empty()) {
      // Said before. Said otherwise before: a contradiction.
      if (std::abs(value) <= 1e-9 * scale * largest_value) continue;
      const geom::Point at = mesh.points[constraint.terms.front().first / 2];
      return base::Error{base::ErrorCode::InvalidOption,
                         "prescribes a displacement that another support or tie prescribes otherwise",
                         base::Place{.item = constraint.name, .x = at.x, .y = at.y}};
    }
    const auto pivot = std::max_element(
        row.begin(), row.end(), [](const auto& a, const auto& b) { return std::abs(a.second) < std::abs(b.second); });
    Slave slave{{}, value / pivot->second};
    for (const auto& [d, c] : row) {
      if (d != pivot->first) slave.terms.push_back({d, -c / pivot->second});
    }
    slave_of[pivot->first] = map.slaves_.size();
    pivots.push_back(pivot->first);
    map.slaves_.push_back(std::move(slave));
  }

  for (std::size_t s = 0; s < pivots.size(); ++s) map.index_[pivots[s]] = -1 - static_cast<std::int32_t>(s);
  map.unit_.resize(map.index_.size());
  for (std::size_t d = 0; d < map.index_.size(); ++d) {
    if (map.index_[d] < 0) continue;
    map.unit_[d] = {static_cast<std::uint32_t>(map.equations_), 1.0};
    map.index_[d] = static_cast<std::int32_t>(map.equations_++);
  }
  // From the last, whose terms are all free, to the first.
  for (std::size_t s = map.slaves_.size(); s-- > 0;) {
    Row row;
    double value = map.slaves_[s].value;
    for (const auto& [d, c] : map.slaves_[s].terms) {
      const View part = map.view(d);
      value += c * part.value;
      for (const auto& [equation, factor] : part.terms) row[equation] += c * factor;
    }
    map.slaves_[s] = {{row.begin(), row.end()}, value};
  }
  return map;
}

EquationMap::View EquationMap::view(std::size_t dof) const {
  const std::int32_t index = index_[dof];
  if (index >= 0) return {std::span(unit_).subspan(dof, 1), 0.0};
  const Slave& slave = slaves_[static_cast<std::size_t>(-1 - index)];
  return {slave.terms, slave.value};
}

SymmetricMatrix EquationMap::reduce(const BlockMatrix& matrix) const {
  SymmetricMatrix reduced;
  reduced.size = equations_;
  const std::size_t entries = 4 * matrix.blocks.size();
  reduced.rows.reserve(entries);
  reduced.columns.reserve(entries);
  reduced.values.reserve(entries);
  const auto add = [&](std::uint32_t row, std::uint32_t column, double value) {
    reduced.rows.push_back(static_cast<std::int32_t>(std::max(row, column)) + 1);
    reduced.columns.push_back(static_cast<std::int32_t>(std::min(row, column)) + 1);
    reduced.values.push_back(value);
  };
  // One entry of the upper triangle of K, standing for itself and for its mirror image.
  const auto add_entry = [&](std::size_t i, std::size_t j, double value) {
    const View a = view(i);
    const View b = view(j);
    for (const auto& [row, left] : a.terms) {
      for (const auto& [column, right] : b.terms) {
        const double part = left * right * value;
        if (i == j) {
          if (row >= column) add(row, column, part);
        } else {
          add(row, column, row == column ? 2.0 * part : part);
        }
      }
    }
  };
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t k = matrix.first[i]; k < matrix.first[i + 1]; ++k) {
      const std::size_t j = matrix.columns[k];
      const auto& [xx, xy, yx, yy] = matrix.blocks[k];
      add_entry(2 * i, 2 * j, xx);
      add_entry(2 * i, 2 * j + 1, xy);
      if (i != j) add_entry(2 * i + 1, 2 * j, yx);
      add_entry(2 * i + 1, 2 * j + 1, yy);
    }
  }
  return reduced;
}

std::vector<double> EquationMap::reduce(const BlockMatrix& matrix, std::span<const Vector> forces,
                                        double settlement) const {
  std::vector<Vector> right(forces.begin(), forces.end());
  const bool moved = std::any_of(slaves_.begin(), slaves_.end(), [](const Slave& s) { return s.value != 0.0; });
  if (moved && settlement != 0.0) {
    const std::vector<Vector> prescribed = expand(std::vector<double>(equations_, 0.0), settlement);
    const std::vector<Vector> reaction = multiply(matrix, prescribed);
    for (std::size_t i = 0; i < right.size(); ++i) right[i] = right[i] - reaction[i];
  }
  std::vector<double> reduced(equations_, 0.0);
  for (std::size_t d = 0; d < index_.size(); ++d) {
    const double force = d % 2 == 0 ? right[d / 2].x : right[d / 2].y;
    for (const auto& [equation, factor] : view(d).terms) reduced[equation] += factor * force;
  }
  return reduced;
}

std::vector<Vector> EquationMap::expand(std::span<const double> solution, double settlement) const {
  std::vector<Vector> u(index_.size() / 2);
  for (std::size_t d = 0; d < index_.size(); ++d) {
    const View part = view(d);
    double value = settlement * part.value;
    for (const auto& [equation, factor] : part.terms) value += factor * solution[equation];
    (d % 2 == 0 ? u[d / 2].x : u[d / 2].y) = value;
  }
  return u;
}

std::size_t EquationMap::node_of_equation(std::size_t equation) const {
  const auto found = std::find(index_.begin(), index_.end(), static_cast<std::int32_t>(equation));
  return static_cast<std::size_t>(found - index_.begin()) / 2;
}

}  // namespace dobra::fem
