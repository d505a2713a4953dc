#pragma once
// The [input] of a scenario from a file that a user names: a scenario, whose input is taken, or a file of lines.

#include <string>

#include "shared/cli/session.h"
#include "shared/scenario/document.h"

namespace recon::cli {

/// A file that holds the section, and how its lines are to be read.
struct SectionFile {
  std::string file;
  dobra::scenario::Table lines;  ///< What the user gave, see shared/cli/line_options.h.
};

/// A document of RECON with an input and without steps; what was changed on reading becomes notes of the session.
/// @param section a scenario (.toml), or lines in any format of read_any_lines, whose kinds say what each
///                one is (core::import_lines).
/// @error those of the readers and of import_lines; BadUsage for options of lines beside a scenario, which has its own.
dobra::base::Result<dobra::scenario::Document> section_document(dobra::cli::Session& session,
                                                                const SectionFile& section);

/// The only line of a file, read with the options of the section's file. @error those of the reader; BadFormat.
dobra::base::Result<std::vector<dobra::geom::Point>> only_line(const std::string& file,
                                                               const dobra::scenario::Table& lines);

}  // namespace recon::cli
