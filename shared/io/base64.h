#pragma once
// Base64 of RFC 4648, for the binary arrays of .vtu files.

#include <optional>
#include <string>
#include <string_view>

namespace dobra::io {

std::string base64(std::string_view bytes);

/// The bytes of a base64 text (blanks between its characters are skipped); nothing if it is not valid.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace dobra::io
