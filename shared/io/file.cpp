#include "shared/io/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <system_error>

namespace dobra::io {
namespace {

using base::Error;
using base::ErrorCode;

std::string reason(int error_number) { return std::generic_category().message(error_number); }

base::Place at(const std::filesystem::path& file, std::size_t line = 0) {
  base::Place place;
  place.file = file.string();
  place.line = line;
  return place;
}

/// A file descriptor that is closed on every way out.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int number() const { return number_; }
  /// 0 or errno: some file systems tell only here that the disk is full.
  int close() {
    const int status = ::close(number_);
    number_ = -1;
    return status == 0 ? 0 : errno;
  }

 private:
  int number_;
};

/// 0 or errno.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      return errno;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

base::Result<void> write_directly(const std::filesystem::path& file, std::string_view bytes) {
  Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (out.number() < 0) return cannot_write(file, errno);
  if (const int status = write_all(out.number(), bytes); status != 0) return cannot_write(file, status);
  if (const int status = out.close(); status != 0) return cannot_write(file, status);
  return {};
}

std::filesystem::path aside_of(const std::filesystem::path& file) {
  static std::atomic<unsigned> count{0};
  return file.parent_path() / fmt::format(".{}.{}-{}.part", file.filename().string(), ::getpid(), count++);
}

/// Writes, flushes and closes a new file. 0 or errno.
int write_new(const std::filesystem::path& file, std::string_view bytes, const struct stat* like) {
  Descriptor out(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (out.number() < 0) return errno;
  if (like != nullptr && ::fchmod(out.number(), like->st_mode & 07777) != 0) return errno;
  if (const int status = write_all(out.number(), bytes); status != 0) return status;
  if (::fsync(out.number()) != 0 && errno != EINVAL && errno != ENOSYS) return errno;
  return out.close();
}

std::size_t line_of(std::string_view text, std::size_t position) {
  return 1 +
         static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
}

}  // namespace

Error cannot_write(const std::filesystem::path& file, int error_number) {
  return Error{ErrorCode::CannotWrite, fmt::format("cannot be written: {}", reason(error_number)), at(file)};
}

std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return ending;
}

base::Result<void> check_readable(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) return Error{ErrorCode::FileNotFound, "there is no such file", at(file)};
    return Error{ErrorCode::CannotRead, fmt::format("cannot be read: {}", reason(errno)), at(file)};
  }
  if (S_ISDIR(status.st_mode)) return Error{ErrorCode::NotAFile, "is a folder; give a file", at(file)};
  return {};
}

base::Result<std::string> read_bytes(const std::filesystem::path& file) {
  DOBRA_TRY_VOID(check_readable(file));
  Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (in.number() < 0) return Error{ErrorCode::CannotRead, fmt::format("cannot be read: {}", reason(errno)), at(file)};
  struct stat status {};
  std::string bytes;
  if (::fstat(in.number(), &status) == 0 && S_ISREG(status.st_mode))
    bytes.reserve(static_cast<std::size_t>(status.st_size));
  std::string buffer(std::size_t{1} << 16, '\0');
  for (;;) {
    const ssize_t got = ::read(in.number(), buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return Error{ErrorCode::CannotRead, fmt::format("cannot be read: {}", reason(errno)), at(file)};
    if (got == 0) return bytes;
    bytes.append(buffer, 0, static_cast<std::size_t>(got));
  }
}

base::Result<std::string> read_text(const std::filesystem::path& file) {
  DOBRA_TRY(std::string text, read_bytes(file));
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    return Error{ErrorCode::EmptyFile, "is empty", at(file)};
  }
  if (const std::size_t nul = text.find('\0'); nul != std::string::npos) {
    return Error{ErrorCode::BadFormat, "is not a text file (it holds NUL bytes); give a text file in UTF-8",
                 at(file, line_of(text, nul))};
  }
  if (const auto bad = first_byte_outside_utf8(text)) {
    return Error{ErrorCode::BadFormat,
                 fmt::format("byte 0x{:02X} is not UTF-8: a binary file, or text in another encoding; save it as UTF-8",
                             static_cast<unsigned char>(text[*bad])),
                 at(file, line_of(text, *bad))};
  }
  return text;
}

std::optional<std::size_t> first_byte_outside_utf8(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  std::size_t i = 0;
  while (i < text.size()) {
    const unsigned lead = byte(i);
    const unsigned next = byte(i + 1);
    std::size_t length = 0;
    if (lead < 0x80U)
      length = 1;
    else if (lead >= 0xC2U && lead <= 0xDFU)
      length = 2;
    else if (lead >= 0xE0U && lead <= 0xEFU)
      length = 3;
    else if (lead >= 0xF0U && lead <= 0xF4U)
      length = 4;
    if (length == 0) return i;
    for (std::size_t k = 1; k < length; ++k) {
      if (!continues(i + k)) return i;
    }
    // Overlong forms, surrogates and code points beyond U+10FFFF show in the second byte.
    const bool bad_second = (lead == 0xE0U && next < 0xA0U) || (lead == 0xEDU && next > 0x9FU) ||
                            (lead == 0xF0U && next < 0x90U) || (lead == 0xF4U && next > 0x8FU);
    if (bad_second) return i;
    i += length;
  }
  return std::nullopt;
}

base::Result<void> write_file(const std::filesystem::path& file, std::string_view bytes) {
  struct stat status {};
  const bool exists = ::stat(file.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) return cannot_write(file, EISDIR);
  if (exists && !S_ISREG(status.st_mode)) return write_directly(file, bytes);
  // A rename would replace a file that its owner protected against writing.
  if (exists && ::access(file.c_str(), W_OK) != 0) return cannot_write(file, errno);

  std::error_code resolved;
  std::filesystem::path target = std::filesystem::weakly_canonical(file, resolved);
  if (resolved) target = file;
  const std::filesystem::path aside = aside_of(target);
  if (const int failed = write_new(aside, bytes, exists ? &status : nullptr); failed != 0) {
    if (failed != EEXIST) ::unlink(aside.c_str());
    return cannot_write(file, failed);
  }
  if (::rename(aside.c_str(), target.c_str()) != 0) {
    const int failed = errno;
    ::unlink(aside.c_str());
    return cannot_write(file, failed);
  }
  return {};
}

base::Result<void> write_text(const std::filesystem::path& file, const base::Result<std::string>& text) {
  if (!text) return text.error();
  return write_file(file, *text);
}

}  // namespace dobra::io
