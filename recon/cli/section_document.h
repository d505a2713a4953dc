#pragma once
// The [input] of a scenario from a file that a user names: a scenario, whose input is taken, or a file of lines.

#include <string>

#include "shared/base/result.h"
#include "shared/scenario/document.h"

namespace recon::cli {

/// How coordinates of a file of lines are to be read; empty where the user has not said.
struct FileConvention {
  std::string unit;    ///< "m", "km", "ft"
  std::string y_axis;  ///< "up", "down"
  double reference = 0.0;
};

/// A document of RECON with an input and without steps.
/// @param file a scenario (.toml); GeoJSON, whose property kind (horizon, fault, pin, loose, unit, marker) says what
/// each
///             feature is; or any other file of curves, all of them horizons.
/// @error those of the readers; BadUsage for a convention beside a scenario, which has its own.
dobra::base::Result<dobra::scenario::Document> section_document(const std::string& file,
                                                                const FileConvention& convention);

}  // namespace recon::cli
