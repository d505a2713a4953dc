#pragma once
// Sizes that the user wants everywhere: a formula of x and y, or a background mesh (the sizes of its elements, or a
// field at its points); of both the least.

#include <memory>
#include <string>

#include "quebra/domain/domain.h"
#include "shared/mesh/sizing/size_field.h"
#include "shared/scenario/program.h"

namespace quebra::meshing {

bool is_size(double value);
/// BadValue, of a value that is no size. @param whose  "size_formula"
dobra::base::Error no_size(const std::string& whose, double value, const dobra::base::Place& place);

class SizeSource {
 public:
  /// No wish anywhere.
  SizeSource() = default;
  /// Reads and checks; empty texts are no wish. Of a background mesh points up to one element outside take the nearest
  /// size, others none.
  /// @error BadValue: a formula that cannot be read, a size that is not greater than 0 on the boundary or in the file,
  ///        with its place; a field that the file has not, naming those it has; those of io::formats::read_mesh.
  static dobra::base::Result<SizeSource> make(const domain::Domain& domain, const std::string& formula,
                                              const std::string& background, const std::string& field,
                                              const dobra::scenario::Context& context);

  [[nodiscard]] bool empty() const { return wishes_ == nullptr; }
  /// For SizeFieldOptions; empty if this is. Refers to what this holds together with it.
  [[nodiscard]] dobra::mesh::sizing::SizeFunction function() const;
  /// @error BadValue with the place where a size inside the domain was not greater than 0, of all asked so far.
  [[nodiscard]] dobra::base::Result<void> check() const;

 private:
  struct Wishes;
  std::shared_ptr<Wishes> wishes_;
};

}  // namespace quebra::meshing
