#pragma once
// A document is a scenario: an input and an ordered list of steps. Saving one writes the file that the command line
// runs.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/scenario/units.h"
#include "shared/scenario/value.h"

namespace dobra::scenario {

struct Step {
  std::string operation;
  std::string name;     ///< Free, may be empty; --set and expectations may use it in place of the step's number.
  Table params;         ///< Without `operation` and `name`.
  std::string comment;  ///< Comment lines above the table, without "# ", joined by newlines.
  base::Place place;
};

/// A claim about a quantity of the state after the last step (or after `step`).
struct Expect {
  std::string quantity;
  std::optional<std::string> step;  ///< Name or 1-based number of the step; the last if absent.
  std::optional<double> value;      ///< With a tolerance ...
  double tolerance = 0.0;           ///< absolute,
  double relative_tolerance = 0.0;  ///< or relative to `value`; the larger of the two counts.
  std::optional<double> at_least;   ///< ... or bounds.
  std::optional<double> at_most;
  double factor = 1.0;  ///< Multiplies the quantity before it is compared: 1 / (sigma sqrt(pi a)) of a K.
  /// Compared is then the order at which the quantity falls from this step to `step` with the size of the elements,
  /// sizes as 1 / sqrt(unknowns).
  std::optional<std::string> rate_from;
  std::string name;     ///< What the claim is called, of which section, who says so, and what is to be known of it:
  std::string section;  ///< texts for tables; all may be empty.
  std::string source;
  std::string note;
  std::string comment;
  base::Place place;
};

struct Document {
  static constexpr std::int64_t current_version = 1;

  std::string program;  ///< "recon" or "quebra".
  std::string title;
  UnitSystem units;                        ///< Of every number of the document.
  std::optional<UnitSystem> result_units;  ///< Of the results, where they are to differ.
  Table input;                             ///< Nested tables ([[input.horizon]]) are values of kind Tables.
  std::vector<Step> steps;
  std::vector<Expect> expects;
  std::string comment;  ///< Comment lines at the top of the file.
  std::string input_comment;
  std::string end_comment;                    ///< Comment lines after everything else.
  std::filesystem::path file;                 ///< Where it was read from or saved to; empty if neither.
  std::shared_ptr<const std::string> source;  ///< The text that it was read from; saving keeps what of it still holds.
  /// The file beside that the tables of the input ([[input.horizon]] and so on) are saved in, from the document's
  /// folder; empty: they stand in the document itself. In memory they are always in `input`.
  std::string lines_file;
  std::shared_ptr<const std::string> lines_source;  ///< As `source`, of that file.

  [[nodiscard]] const UnitSystem& shown_units() const { return result_units ? *result_units : units; }
  /// Relative paths in the document start here.
  [[nodiscard]] std::filesystem::path folder() const { return file.parent_path(); }
};

/// Reads TOML:  dobra = 1, program = "recon", title = "..."; [input]; [[step]] operation = "..."; [[expect]].
/// Only the form is judged here (top-level keys, types that no parameter can have); the program judges the parameters.
/// Comments are kept: lines above a key or table stay there, a comment behind a value moves above it, those inside
/// lists are dropped.
/// @error BadSyntax, UnknownKey, MissingKey, BadValue with file:line:column.
base::Result<Document> parse_document(const std::string& text, const std::filesystem::path& file);

/// With the tables of its file of lines, where it names one.
/// @error FileNotFound, NotAFile, CannotRead, EmptyFile, BadFormat (a binary file), those of parse_document, and those
/// of with_lines_read.
base::Result<Document> read_document(const std::filesystem::path& file);

/// Canonical text, whatever the source: parse_document(document_text(d)) gives d, and its text again is the same bytes.
std::string document_text(const Document& document);

/// The text that the document was read from, with what has changed since in its place. The layout,
/// comments, and numbers of the rest stay to the byte. Canonical where there is no such text.
std::string saved_text(const Document& document);

/// Writes the text aside, then renames; its file of lines alike, before it.
/// @error CannotWrite
base::Result<void> write_document(const Document& document, const std::filesystem::path& file);

/// Sets unit_system or result_units, whichever `key` is. @error that of UnitSystem::make, naming the key.
base::Result<void> set_units(Document& document, const std::string& key, const std::string& text);

/// "step 2 (grid)", as steps are called in messages. @param number 1-based.
std::string step_label(const Document& document, std::size_t number);

/// The 1-based number of the step that a name or a number in digits means; nothing if there is none.
std::optional<std::size_t> find_step(const Document& document, const std::string& name_or_number);

}  // namespace dobra::scenario
