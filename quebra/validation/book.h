#pragma once
// The validation book: a folder of scenarios (resources/validation) whose expectations are values of the literature and
// of closed forms. Pages: docs/user/analysis.md, docs/algorithms/fem.md and crack.md.

#include <filesystem>
#include <string>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/scenario/document.h"

namespace quebra::validation {

/// The scenarios of a folder, by the names of their files.
/// @error FileNotFound: none; those of read_document; MissingKey for an expectation without `name` or `value`.
dobra::base::Result<std::vector<dobra::scenario::Document>> read_book(const std::filesystem::path& folder);

/// An expectation, and what came out.
struct Row {
  dobra::scenario::Expect expect;
  double value = 0.0;
  double error = 0.0;  ///< Relative to the expected value; a value of the other sign is wrong by 200 %.
  bool met = false;
};

/// Runs the scenarios and judges all their expectations.
/// @error that of the scenario which fails, with its file; UnknownQuantity; CannotSolve for a value that is no number.
dobra::base::Result<std::vector<Row>> validate(const std::vector<dobra::scenario::Document>& book,
                                               const dobra::base::Progress& progress);

/// As tables: CSV, JSON, and a page.
std::string csv(const std::vector<Row>& rows);
std::string json(const std::vector<Row>& rows);
std::string html(const std::vector<Row>& rows);

}  // namespace quebra::validation
