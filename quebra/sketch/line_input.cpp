#include "quebra/sketch/line_input.h"

#include "quebra/sketch/roles_by_name.h"

namespace quebra::sketch {

dobra::base::Result<SketchOptions> sketch_options(const LineInput& input) {
  SketchOptions options;
  options.open_lines = input.closed;
  DOBRA_TRY(options.lines, dobra::scenario::lines::line_options(input));
  for (const Role role : {Role::Boundary, Role::Hole, Role::Internal, Role::Crack})
    options.lines.text.kinds.push_back(role_name(role));
  options.chosen = input != LineInput{};
  return options;
}

}  // namespace quebra::sketch
