#include "quebra/sketch/line_input.h"

namespace quebra::sketch {

dobra::base::Result<SketchOptions> sketch_options(const LineInput& input) {
  SketchOptions options;
  options.open_lines = input.closed;
  DOBRA_TRY(options.lines, dobra::scenario::lines::line_options(input));
  options.chosen = input != LineInput{};
  return options;
}

}  // namespace quebra::sketch
