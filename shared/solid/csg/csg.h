#pragma once
// A solid as a tree: shapes placed by matrices, united, intersected and subtracted. A subtree may stand in many places.
// Matrices are carried down to the shapes, so that every operation stays exact; each shape in each of its places is
// rounded once. What has been evaluated is remembered by what it is made of. Page: docs/algorithms/csg.md. Source:
// [requicha1980representations].

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "shared/base/progress.h"
#include "shared/solid/boolean.h"
#include "shared/solid/placement.h"
#include "shared/solid/shape/profile.h"

namespace dobra::solid::csg {

class Node;
/// Immutable; shared where a sub-result is used more than once.
using Tree = std::shared_ptr<const Node>;

/// @param text  says all that the solid depends on; shapes of one text are the same.
Tree leaf(std::string text, shape::Shape made);
/// What a function makes of a solid where it stands, before matrices above it.
/// @param text  says all that the function does; functions of one text are the same.
Tree derived(std::string text, Tree operand, std::function<base::Result<Solid>(const Solid&)> make);
/// @pre check_matrix() passed
Tree placed(Tree tree, const Matrix& matrix);
/// @pre operands are not empty; the first one is what a difference takes from
Tree combined(Operation operation, std::vector<Tree> operands);

struct Evaluated {
  Solid solid;
  std::size_t rounded = 0;  ///< Points of shapes that matrices moved to places which had to be rounded.
  /// What operations that left nothing, or whose operands do not overlap, had in common, in the order of evaluation.
  std::vector<std::pair<Operation, Contact>> contacts;
  std::vector<OppositeFaces> opposite;  ///< What the shape leaves out, where it was placed; of a leaf alone.
  std::optional<WarpedFaces> warped;    ///< What of it is not plane, where it was placed; of a leaf alone.
};

/// Remembers results; thread-safe.
class Evaluator {
 public:
  /// @param most_faces  of all results that are remembered together; those unused for longest go first.
  explicit Evaluator(std::size_t most_faces = 2'000'000) : most_faces_(most_faces) {}

  /// @error those of from_loops() and place(); Cancelled.
  /// @cost  that of combine() for each operation that is new
  base::Result<Evaluated> evaluate(const Tree& tree, const base::Progress& progress = {});
  /// Shapes and operations that the last call had to compute.
  [[nodiscard]] std::size_t computed() const { return computed_; }

 private:
  struct Known {
    Evaluated result;
    std::uint64_t last_used = 0;
  };
  using Seen = std::map<std::pair<const Node*, Matrix>, std::uint64_t>;

  std::uint64_t number_of(const Node& node, const Matrix& matrix, Seen& seen);
  base::Result<Evaluated> result_of(const Node& node, const Matrix& matrix, Seen& seen, const base::Progress& progress);
  base::Result<Evaluated> compute(const Node& node, const Matrix& matrix, Seen& seen, const base::Progress& progress);
  void forget();

  std::mutex mutex_;
  std::map<std::string, std::uint64_t> numbers_;
  std::map<std::uint64_t, Known> known_;
  std::uint64_t calls_ = 0;
  std::size_t computed_ = 0;
  std::size_t most_faces_;
};

}  // namespace dobra::solid::csg
