#pragma once
// What a scenario says of a file of lines, and whether lines that do not close are outlines.

#include "quebra/sketch/sketch_file.h"
#include "shared/scenario/lines/line_reading.h"

namespace quebra::sketch {

/// A base of InputParams.
struct LineInput : dobra::scenario::lines::LineReading {
  OpenLines closed = OpenLines::AsDrawn;

  template <class P, class D>
  static void describe_in(D& d) {
    d.choice("closed", static_cast<OpenLines P::*>(&LineInput::closed), {"no", "yes"},
             {.title = "Closed",
              .help = "yes: every line of the file is an outline, whose last point need not repeat the first.",
              .when = "file is set"});
    LineReading::describe_in<P>(d, "file is set");
  }
  bool operator==(const LineInput&) const = default;
};

/// @error BadValue naming the key.
dobra::base::Result<SketchOptions> sketch_options(const LineInput& input);

}  // namespace quebra::sketch
