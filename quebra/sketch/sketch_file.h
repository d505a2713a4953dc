#pragma once
// Files that hold the geometry of a domain: drawings, lines in the exchange formats, and meshes whose boundary is
// meant.

#include <string>

#include "quebra/sketch/sketch.h"
#include "shared/base/result.h"
#include "shared/io/formats/line_files.h"

namespace quebra::sketch {

enum class OpenLines { AsDrawn, Close };

struct SketchOptions {
  /// Of files of lines: units, axes, columns; what neither they nor the file tell is asked.
  dobra::io::formats::LineOptions lines = {};
  OpenLines open_lines = OpenLines::AsDrawn;  ///< Close: every line is an outline whose last side is left out.
  double silent_unit = 1.0;                   ///< Metres in one unit of a file that does not say.
  bool chosen = false;                        ///< Whether the user chose any of these.
};

/// By the ending of the name, as the table of formats says: drawings, meshes, lines; a text may be a graph instead.
/// Curves without roles are left to
/// make_domain: closed ones and chains that close bound the domain, the others are internal lines.
/// @error FileNotFound, NotAFile; UnknownFormat naming what is read; BadValue for options that the format does not ask;
/// those of the readers.
dobra::base::Result<Sketch> read_sketch(const std::string& path, const SketchOptions& options = {});

}  // namespace quebra::sketch
