#pragma once
// The rows of a text of points, and their fields. Internal to io: text_points and text_columns use it.

#include <string>
#include <string_view>
#include <vector>

#include "shared/io/lines/text_points.h"
#include "shared/io/scan.h"

namespace dobra::io::lines {

/// A line that begins with '#'.
bool is_comment(std::string_view line);
bool is_empty(std::string_view line);
/// The character; of Blank and Detect ' '.
char sign_of(Separator separator);
/// Fields of a line; a field in double quotes may hold the separator.
void split_fields(std::string_view line, Separator separator, std::vector<Word>& fields);
/// The same of a header: a unit in brackets between blanks belongs to the word before it.
void split_header(std::string_view line, Separator separator, std::vector<Word>& fields);
/// The one under which a header has most fields.
Separator separator_of_header(std::string_view header);
/// The first line that is neither empty nor a comment.
std::string_view first_row(std::string_view text);

/// Small letters, without the accents of Portuguese, blanks for '_' and '-', none at the ends.
std::string plain(std::string_view word);

}  // namespace dobra::io::lines
