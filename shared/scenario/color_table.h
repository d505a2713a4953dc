#pragma once
// Tables of colours of rock units as files: CSV with a header, or TOML with [[unit]] tables. Columns, or keys: name,
// colour, pattern, age, lithology. Page: docs/user/restore.md.

#include <string>

#include "shared/base/result.h"
#include "shared/scene/unit_colors.h"

namespace dobra::scenario {

/// By the ending: .toml, else CSV (comma, semicolon or tab; quotes; other columns are left alone).
/// @error those of io::read_text; BadFormat with the line: no name, a name twice, a colour or pattern that is none, a
/// header without a column of names; those of read_rows and check (TOML).
base::Result<scene::ColorTable> read_color_table(const std::string& path);
base::Result<scene::ColorTable> parse_color_table(const std::string& text, const std::string& file);

}  // namespace dobra::scenario
