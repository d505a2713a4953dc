#pragma once
// Lines as columns of text: x and height, with names and kinds. Page: docs/user/import.md.

#include <span>
#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/io/formats/line_files.h"

namespace dobra::io::formats {

/// @error those of lines::parse_text_points and of normalise, with file and line.
base::Result<lines::Features> features_of_text(std::string_view text, const std::string& file,
                                               const LineOptions& options);

/// "x,z,name,kind" or "x,y,z,name,kind", names and kinds where a feature has one; a blank line between lines.
/// @error NotFinite, naming the feature.
base::Result<std::string> text_of(std::span<const lines::Feature> features);

}  // namespace dobra::io::formats
