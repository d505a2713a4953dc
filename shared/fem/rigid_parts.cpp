#include "shared/fem/rigid_parts.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "shared/base/disjoint_sets.h"

namespace dobra::fem {
namespace {

using geom::Point;
using geom::Vector;
using mesh::ElementMesh;

/// Of the unit motions, scaled by the size of the mesh: below it a motion is not hindered.
constexpr double free_motion = 1e-9;

/// The parts, and to which of them each node belongs (corners that touch belong to several).
struct Parts {
  std::vector<std::size_t> of_element;
  std::vector<std::size_t> elements;  ///< How many each part has.
  std::vector<std::size_t> first_element;
  std::vector<std::vector<std::size_t>> of_node;
};

Parts parts_of(const ElementMesh& mesh) {
  const auto neighbours = neighbours_of(mesh);
  base::DisjointSets groups(mesh.element_count());
  std::size_t side = 0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (std::size_t i = 0; i < mesh::corner_count(mesh.types[e]); ++i, ++side) {
      if (neighbours[side].element.valid()) groups.join(e, neighbours[side].element.index());
    }
  }
  Parts parts;
  parts.of_element.resize(mesh.element_count());
  parts.of_node.resize(mesh.points.size());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::size_t root = groups.root(e);
    if (root == e) {
      parts.of_element[e] = parts.elements.size();
      parts.elements.push_back(0);
      parts.first_element.push_back(e);
    }
    const std::size_t part = parts.of_element[e] = parts.of_element[root];
    ++parts.elements[part];
    for (const mesh::NodeId node : mesh.nodes_of(mesh::ElementId(e))) {
      auto& known = parts.of_node[node.index()];
      if (std::find(known.begin(), known.end(), part) == known.end()) known.push_back(part);
    }
  }
  return parts;
}

/// One equation on the motions (x, y, turn) of parts.
using MotionRow = std::map<std::size_t, std::array<double, 3>>;

class Motions {
 public:
  Motions(const ElementMesh& mesh, const Parts& parts) : mesh_(mesh), parts_(parts), groups_(parts.elements.size()) {
    const geom::Box box = geom::box_of(mesh.points);
    centre_ = box.centre();
    radius_ = 0.5 * box.diagonal();
  }

  /// The displacement of `node` as part of `part`: sum of `coefficients` . u.
  void add_to(MotionRow& row, std::size_t part, std::size_t node, Vector coefficients) const {
    const Vector arm = (mesh_.points[node] - centre_) / radius_;
    auto& r = row[part];
    r[0] += coefficients.x;
    r[1] += coefficients.y;
    r[2] += cross(arm, coefficients);
  }
  void add_row(const MotionRow& row) {
    for (const auto& [part, values] : row) groups_.join(row.begin()->first, part);
    rows_.push_back(row);
  }

  base::Result<void> judge();

 private:
  [[nodiscard]] std::string describe(const Eigen::MatrixXd& free, std::size_t column) const;
  base::Result<void> judge_group(const std::vector<std::size_t>& members, const std::vector<const MotionRow*>& rows);

  const ElementMesh& mesh_;
  const Parts& parts_;
  base::DisjointSets groups_;
  std::vector<MotionRow> rows_;
  Point centre_;
  double radius_ = 1.0;
};

/// "x", "y" or "along (0.6, 0.8)".
std::string direction_text(double x, double y) {
  if (std::abs(y) < 1e-6 * std::abs(x)) return "along x";
  if (std::abs(x) < 1e-6 * std::abs(y)) return "along y";
  return fmt::format("along ({:.4g}, {:.4g})", x, y);
}

/// The motions of one part in words, from the columns of the free space.
std::string Motions::describe(const Eigen::MatrixXd& free, std::size_t column) const {
  const auto row = static_cast<Eigen::Index>(3 * column);
  Eigen::MatrixXd own = free.middleRows(row, 3);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> rank(own);
  const auto dimension = (own.norm() > 1e-6) ? Eigen::Index(std::max<Eigen::Index>(rank.rank(), 1)) : Eigen::Index(0);
  if (dimension >= 3) return "it can move along x, along y and turn";
  // A basis of the motions of this part: first a translation, if one is among them.
  const Eigen::MatrixXd basis = rank.householderQ() * Eigen::MatrixXd::Identity(3, dimension);
  std::vector<std::string> words;
  const Eigen::RowVectorXd turns = basis.row(2);
  if (dimension == 2) {
    const Eigen::Vector3d slide = basis.col(0) * turns(1) - basis.col(1) * turns(0);
    words.push_back(slide.norm() > 1e-6 ? "move " + direction_text(slide(0), slide(1)) + " and turn"
                                        : "move along x and along y");
  } else if (std::abs(turns(0)) < 1e-6) {
    words.push_back("move " + direction_text(basis(0, 0), basis(1, 0)));
  } else {
    const Vector shift{basis(0, 0), basis(1, 0)};
    Point pivot = centre_ + (radius_ / turns(0)) * Vector{-shift.y, shift.x};
    for (double* value : {&pivot.x, &pivot.y}) *value = std::abs(*value) < free_motion * radius_ ? 0.0 : *value;
    words.push_back(fmt::format("turn about ({:.6g}, {:.6g})", pivot.x, pivot.y));
  }
  return "it can " + words.front();
}

base::Result<void> Motions::judge_group(const std::vector<std::size_t>& members,
                                        const std::vector<const MotionRow*>& rows) {
  const auto size = static_cast<Eigen::Index>(3 * members.size());
  std::map<std::size_t, Eigen::Index> column;
  for (const std::size_t part : members) column.emplace(part, 3 * static_cast<Eigen::Index>(column.size()));
  // The triangular factor of the rows so far, with room for as many more: rank without squaring the numbers.
  Eigen::MatrixXd stack = Eigen::MatrixXd::Zero(2 * size + 64, size);
  Eigen::Index used = size;
  const auto compress = [&] {
    const Eigen::MatrixXd r =
        Eigen::HouseholderQR<Eigen::MatrixXd>(stack).matrixQR().topRows(size).triangularView<Eigen::Upper>();
    stack.setZero();
    stack.topRows(size) = r;
    used = size;
  };
  for (const MotionRow* row : rows) {
    if (used == stack.rows()) compress();
    double norm = 0.0;
    for (const auto& [part, values] : *row)
      norm = std::max({norm, std::abs(values[0]), std::abs(values[1]), std::abs(values[2])});
    if (norm == 0.0) continue;  // between two nodes at one place: rigid motions do not feel it
    for (const auto& [part, values] : *row) {
      for (Eigen::Index i = 0; i < 3; ++i)
        stack(used, column.at(part) + i) = values[static_cast<std::size_t>(i)] / norm;
    }
    ++used;
  }
  compress();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(stack.topRows(size), Eigen::ComputeFullV);
  const Eigen::VectorXd& values = svd.singularValues();
  Eigen::Index rank = 0;
  while (rank < size && values(rank) > free_motion) ++rank;
  if (rank == size) return {};
  const Eigen::MatrixXd free = svd.matrixV().rightCols(size - rank);
  std::size_t worst = 0;
  for (std::size_t k = 1; k < members.size(); ++k) {
    if (free.middleRows(static_cast<Eigen::Index>(3 * k), 3).norm() >
        1.01 * free.middleRows(static_cast<Eigen::Index>(3 * worst), 3).norm())
      worst = k;
  }
  const std::size_t part = members[worst];
  const std::size_t element = parts_.first_element[part];
  const std::int32_t region = mesh_.regions[element];
  const auto named = mesh_.region_names.find(region);
  const Point at = mesh_.points[mesh_.nodes[mesh_.first[element]].index()];
  return base::Error{
      base::ErrorCode::NotSupported,
      fmt::format("the part of {} elements in region {} is not held: {}; support it", parts_.elements[part],
                  named != mesh_.region_names.end() ? "'" + named->second + "'" : std::to_string(region),
                  describe(free, worst)),
      base::Place{.item = "supports", .x = at.x, .y = at.y}};
}

base::Result<void> Motions::judge() {
  std::map<std::size_t, std::pair<std::vector<std::size_t>, std::vector<const MotionRow*>>> groups;
  for (std::size_t part = 0; part < parts_.elements.size(); ++part) groups[groups_.root(part)].first.push_back(part);
  for (const MotionRow& row : rows_) groups[groups_.root(row.begin()->first)].second.push_back(&row);
  for (const auto& [root, group] : groups) DOBRA_TRY_VOID(judge_group(group.first, group.second));
  return {};
}

Vector unit(std::uint32_t dof) { return dof % 2 == 0 ? Vector{1.0, 0.0} : Vector{0.0, 1.0}; }

}  // namespace

base::Result<void> check_supported(const ElementMesh& mesh, const Problem& problem,
                                   const std::vector<DofConstraint>& constraints) {
  const Parts parts = parts_of(mesh);
  Motions motions(mesh, parts);
  for (const DofConstraint& constraint : constraints) {
    MotionRow row;
    for (const auto& [dof, coefficient] : constraint.terms)
      motions.add_to(row, parts.of_node[dof / 2].front(), dof / 2, coefficient * unit(dof));
    motions.add_row(row);
  }
  for (const Spring& spring : problem.springs) {
    const auto nodes = find_nodes(mesh, spring.where).value();
    for (const mesh::NodeId node : nodes) {
      for (const std::uint32_t axis : {0U, 1U}) {
        if ((axis == 0 ? spring.x : spring.y) == 0.0) continue;
        MotionRow row;
        motions.add_to(row, parts.of_node[node.index()].front(), node.index(), unit(axis));
        motions.add_row(row);
      }
    }
  }
  for (std::size_t node = 0; node < mesh.points.size(); ++node) {
    for (std::size_t k = 1; k < parts.of_node[node].size(); ++k) {
      for (const std::uint32_t axis : {0U, 1U}) {
        MotionRow row;
        motions.add_to(row, parts.of_node[node][0], node, unit(axis));
        motions.add_to(row, parts.of_node[node][k], node, -unit(axis));
        motions.add_row(row);
      }
    }
  }
  return motions.judge();
}

}  // namespace dobra::fem
