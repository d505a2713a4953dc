#include "shared/solid/csg/csg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "shared/solid/check/settle.h"

namespace dobra::solid::csg {

using base::Result;

class Node {
 public:
  enum class Kind : std::uint8_t { Leaf, Derived, Placed, Combined };
  Kind kind = Kind::Leaf;
  std::string text;
  shape::Shape made;                                        // of a leaf
  std::function<base::Result<Solid>(const Solid&)> make{};  // of a derived one
  Matrix matrix = identity;                                 // of a placed one
  Operation operation = Operation::Union;
  std::vector<Tree> operands;
};

Tree leaf(std::string text, shape::Shape made) {
  Node node;
  node.text = std::move(text);
  node.made = std::move(made);
  return std::make_shared<const Node>(std::move(node));
}

Tree derived(std::string text, Tree operand, std::function<Result<Solid>(const Solid&)> make) {
  Node node;
  node.kind = Node::Kind::Derived;
  node.text = std::move(text);
  node.make = std::move(make);
  node.operands = {std::move(operand)};
  return std::make_shared<const Node>(std::move(node));
}

Tree placed(Tree tree, const Matrix& matrix) {
  Node node;
  node.kind = Node::Kind::Placed;
  node.matrix = matrix;
  node.operands = {std::move(tree)};
  return std::make_shared<const Node>(std::move(node));
}

Tree combined(Operation operation, std::vector<Tree> operands) {
  Node node;
  node.kind = Node::Kind::Combined;
  node.operation = operation;
  node.operands = std::move(operands);
  return std::make_shared<const Node>(std::move(node));
}

namespace {

Result<Evaluated> place_shape(shape::Shape made, const Matrix& matrix) {
  Evaluated out;
  DOBRA_TRY(out.rounded, place(made.mesh.points, matrix));
  if (mirrors(matrix)) {
    for (auto& face : made.mesh.faces) {
      for (auto& loop : face) std::reverse(loop.begin(), loop.end());
    }
  }
  FromMeshOptions options;
  options.face_names = std::move(made.names);
  DOBRA_TRY(Taken taken, take(made.mesh, options));
  out.solid = std::move(taken.solid);
  out.opposite = std::move(taken.opposite);
  out.warped = taken.warped;
  if (out.solid.empty() && out.rounded > 0) {
    return base::Error{base::ErrorCode::InvalidOption,
                       "nothing is left where it is placed, as coordinates are rounded there: place it nearer to the "
                       "origin, or make it larger"};
  }
  return out;
}

/// Corners that are no doubles are rounded first.
Result<Evaluated> place_solid(Solid solid, const Matrix& matrix) {
  Evaluated out;
  if (matrix == identity) {
    out.solid = std::move(solid);
    return out;
  }
  DOBRA_TRY(check::SettledMesh mesh, check::settle(solid));
  if (mesh.flaw) return *mesh.flaw;
  shape::Shape made{{std::move(mesh.mesh.points), {}}, std::move(mesh.names)};
  for (auto& face : mesh.mesh.faces) made.mesh.faces.push_back({std::move(face)});
  return place_shape(std::move(made), matrix);
}

}  // namespace

std::uint64_t Evaluator::number_of(const Node& node, const Matrix& matrix, Seen& seen) {
  if (node.kind == Node::Kind::Placed) return number_of(*node.operands[0], product(matrix, node.matrix), seen);
  if (const auto found = seen.find({&node, matrix}); found != seen.end()) return found->second;
  std::string text;
  if (node.kind != Node::Kind::Combined) {
    for (const double x : matrix) text += fmt::format("{} ", x);
    for (const Tree& operand : node.operands) text += fmt::format("{} ", number_of(*operand, identity, seen));
    text += node.text;
  } else {
    text = fmt::format("operation {}:", static_cast<int>(node.operation));
    for (const Tree& operand : node.operands) text += fmt::format(" {}", number_of(*operand, matrix, seen));
  }
  const std::uint64_t number = numbers_.try_emplace(std::move(text), numbers_.size()).first->second;
  seen[{&node, matrix}] = number;
  return number;
}

Result<Evaluated> Evaluator::compute(const Node& node, const Matrix& matrix, Seen& seen,
                                     const base::Progress& progress) {
  DOBRA_TRY_VOID(progress.check());
  ++computed_;
  if (node.kind == Node::Kind::Leaf) return place_shape(node.made, matrix);
  if (node.kind == Node::Kind::Derived) {
    DOBRA_TRY(Evaluated operand, result_of(*node.operands[0], identity, seen, progress));
    DOBRA_TRY(Solid made, node.make(operand.solid));
    DOBRA_TRY(Evaluated out, place_solid(std::move(made), matrix));
    out.rounded += operand.rounded;
    return out;
  }
  Evaluated out;
  std::vector<Solid> solids;
  for (const Tree& operand : node.operands) {
    DOBRA_TRY(Evaluated one, result_of(*operand, matrix, seen, progress));
    solids.push_back(std::move(one.solid));
    out.rounded += one.rounded;
    out.contacts.insert(out.contacts.end(), one.contacts.begin(), one.contacts.end());
  }
  DOBRA_TRY(Combined both, combine(solids, node.operation));
  out.solid = std::move(both.solid);
  if (solids.size() > 1 && (both.contact != Contact::Volume || out.solid.empty()))
    out.contacts.emplace_back(node.operation, both.contact);
  return out;
}

Result<Evaluated> Evaluator::result_of(const Node& node, const Matrix& matrix, Seen& seen,
                                       const base::Progress& progress) {
  if (node.kind == Node::Kind::Placed)
    return result_of(*node.operands[0], product(matrix, node.matrix), seen, progress);
  const std::uint64_t number = number_of(node, matrix, seen);
  if (const auto found = known_.find(number); found != known_.end()) {
    found->second.last_used = calls_;
    return found->second.result;
  }
  DOBRA_TRY(Evaluated result, compute(node, matrix, seen, progress));
  known_[number] = {result, calls_};
  return result;
}

void Evaluator::forget() {
  std::vector<std::array<std::uint64_t, 2>> by_age;
  std::size_t faces = 0;
  for (const auto& [number, known] : known_) {
    by_age.push_back({known.last_used, number});
    faces += known.result.solid.face_count();
  }
  std::sort(by_age.begin(), by_age.end());
  for (const auto& [used, number] : by_age) {
    if (faces <= most_faces_ || used == calls_) return;
    faces -= known_[number].result.solid.face_count();
    known_.erase(number);
  }
}

Result<Evaluated> Evaluator::evaluate(const Tree& tree, const base::Progress& progress) {
  const std::lock_guard lock(mutex_);
  ++calls_;
  computed_ = 0;
  Seen seen;
  auto result = result_of(*tree, identity, seen, progress);
  forget();
  return result;
}

}  // namespace dobra::solid::csg
