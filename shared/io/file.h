#pragma once
// Whole files in and out: text that is really text, and writes that leave either the old file or the new one.
// Every reader and writer goes through here, so that bad files get the same messages.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "shared/base/result.h"

namespace dobra::io {

/// The ending of a file's name with its dot, in small letters: ".csv"; empty if there is none.
std::string ending_of(const std::filesystem::path& file);

/// Whether there is something to read: what is said of a name before its ending is judged.
/// @error FileNotFound, NotAFile (a directory).
base::Result<void> check_readable(const std::filesystem::path& file);

/// The bytes of a regular file (or of a pipe).
/// @error FileNotFound, NotAFile (a directory), CannotRead with the system's reason.
base::Result<std::string> read_bytes(const std::filesystem::path& file);

/// The text of a file in UTF-8, without a byte order mark; line ends stay as they are.
/// @error those of read_bytes; EmptyFile (nothing but blanks); BadFormat with the line for binary content (NUL bytes)
///        and for text in another encoding.
base::Result<std::string> read_text(const std::filesystem::path& file);

/// Position of the first byte that does not belong to valid UTF-8; nothing if all do.
std::optional<std::size_t> first_byte_outside_utf8(std::string_view text);

/// Replaces `file` by `bytes`: written aside in the same folder, flushed to the disk, renamed over the old one. After
/// an error the old file is as it was and nothing is left beside it. A symbolic link stays a link; the file it points
/// to is replaced. What is not a regular file (a device, a pipe) is written directly. The folder must exist.
/// @error CannotWrite, naming the file and the system's reason.
base::Result<void> write_file(const std::filesystem::path& file, std::string_view bytes);

/// The same for a text that may have failed: its error, and the file is left alone.
base::Result<void> write_text(const std::filesystem::path& file, const base::Result<std::string>& text);

/// The error to return when a write failed: CannotWrite with the reason that `error_number` (errno) stands for.
base::Error cannot_write(const std::filesystem::path& file, int error_number);

}  // namespace dobra::io
