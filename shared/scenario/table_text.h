#pragma once
// A table of results as CSV text (RFC 4180): comma, decimal point, quotes where needed, one header line.

#include <string>

#include "shared/scenario/program.h"

namespace dobra::scenario {

/// Numbers read back to the same bits. Lines end with a single newline.
std::string csv_text(const DataTable& table);

}  // namespace dobra::scenario
