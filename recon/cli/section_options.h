#pragma once
// What the sub-commands that work on a section have in common: the file and how it is read, the document that their
// steps are added to, and --out.

#include <filesystem>
#include <string>
#include <vector>

#include "recon/section/section.h"
#include "shared/cli/line_options.h"
#include "shared/cli/parameter_options.h"
#include "shared/cli/session.h"
#include "shared/scenario/document.h"
#include "shared/scenario/program.h"

namespace recon::cli {

/// The file, how its lines are read, and what else [input] says of the section.
struct SectionOptions {
  explicit SectionOptions(dobra::cli::OutOfRange out_of_range = dobra::cli::OutOfRange::BadValue)
      : lines(out_of_range), input(out_of_range) {}

  std::string file;
  dobra::cli::LineOptions lines;
  dobra::cli::ParameterOptions input;

  void add(CLI::App& app, const std::vector<dobra::cli::OptionOf>& input_keys);
};

/// What commands that draw the section offer of [input].
std::vector<dobra::cli::OptionOf> section_keys();

/// A file name as the scenario will look for it, whose names start from the folder of the section's file.
std::string as_seen_from(const dobra::scenario::Document& document, const std::string& file);

/// A step of the operation with what the options say.
base::Result<dobra::scenario::Step> step_of(const dobra::cli::Session& session, const char* operation,
                                            const dobra::cli::ParameterOptions& options);

/// @param lines  as the options of the section say.
base::Result<dobra::scenario::Document> document_of(dobra::cli::Session& session, const SectionOptions& options,
                                                    const dobra::scenario::Table& lines);

/// Adds FILE, which must be given.
void add_file(CLI::App& app, std::string& file, const std::string& help);
/// Adds --out. @param what  it writes.
void add_out_file(CLI::App& app, std::optional<std::filesystem::path>& out, const std::string& what);
/// Adds --out. @param what  the lines that it writes, such as "restored lines".
void add_out(CLI::App& app, std::optional<std::filesystem::path>& out, const char* what);

/// That --out can be written. @error BadUsage: an ending that says nothing; those of check_writable.
base::Result<void> check_out(const std::optional<std::filesystem::path>& out);

/// A picture, the scenario itself to go on with, or the lines of a section; nothing without --out.
base::Result<void> write_out(dobra::cli::Session& session, const std::optional<std::filesystem::path>& out,
                             const dobra::scenario::Document& document, const dobra::scenario::State& state,
                             const section::Section& section);

}  // namespace recon::cli
