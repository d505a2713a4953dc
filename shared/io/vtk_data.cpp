// An array is a head and its data. The head is the number of bytes; of compressed arrays the number of blocks, the
// bytes of a whole block, those of the last one (0: a whole one), and what each takes compressed. In base64 a
// compressed array has its head encoded apart from its data, another has both in one.
#include "shared/io/vtk_data.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "shared/base/text.h"
#include "shared/io/base64.h"
#include "shared/io/scan.h"

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

class ArrayBytes {
 public:
  ArrayBytes(std::string_view data, const VtkEncoding& encoding) : data_(data), encoding_(encoding) {}

  Result<std::string> plain() {
    DOBRA_TRY(const std::size_t size, length(0));
    DOBRA_TRY(const std::string bytes, take(encoding_.header_size, size));
    if (encoding_.alone && written(encoding_.header_size + size) != data_.size())
      return Error{ErrorCode::BadFormat, fmt::format("the array says {} bytes and holds more", size), {}};
    return bytes.substr(encoding_.header_size);
  }

  Result<std::string> compressed() {
    DOBRA_TRY(const std::size_t count, length(0));
    if (count == 0) return std::string();
    DOBRA_TRY(const std::size_t whole, length(1));
    DOBRA_TRY(const std::size_t last, length(2));
    if (count > data_.size()) return wrong();
    std::vector<std::size_t> sizes;
    std::size_t all = 0;
    for (std::size_t k = 0; k < count; ++k) {
      DOBRA_TRY(sizes.emplace_back(), length(3 + k));
      if (sizes.back() > data_.size() - all) return wrong();
      all += sizes.back();
    }
    const std::size_t head = (3 + count) * encoding_.header_size;
    data_.remove_prefix(written(head));
    DOBRA_TRY(const std::string packed, take(0, all));
    std::string bytes;
    std::size_t at = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t size = k + 1 == count && last != 0 ? last : whole;
      DOBRA_TRY_VOID(unpack(std::string_view(packed).substr(at, sizes[k]), size, bytes));
      at += sizes[k];
    }
    return bytes;
  }

 private:
  /// What so many bytes take in the file.
  [[nodiscard]] std::size_t written(std::size_t bytes) const { return encoding_.base64 ? (bytes + 2) / 3 * 4 : bytes; }

  Error wrong() const { return Error{ErrorCode::BadFormat, "the array is longer than what is left of the file", {}}; }

  /// `head` and `size` bytes from here on.
  Result<std::string> take(std::size_t head, std::size_t size) const {
    if (size > data_.size() || written(head + size) > data_.size()) return wrong();
    const std::string_view text = data_.substr(0, written(head + size));
    if (!encoding_.base64) return std::string(text);
    std::optional<std::string> bytes = from_base64(text);
    if (!bytes || bytes->size() < head + size) return Error{ErrorCode::BadFormat, "this array is not valid base64", {}};
    bytes->resize(head + size);
    return *std::move(bytes);
  }

  /// The k-th number of the head. The text of base64 is decoded from the group of three bytes in which it begins.
  Result<std::size_t> length(std::size_t k) const {
    const std::size_t begin = k * encoding_.header_size;
    const std::size_t skipped = encoding_.base64 ? begin / 3 * 4 : begin;
    if (skipped > data_.size()) return wrong();
    const std::size_t lead = encoding_.base64 ? begin % 3 : 0;
    DOBRA_TRY(const std::string bytes, ArrayBytes(data_.substr(skipped), encoding_).take(lead, encoding_.header_size));
    std::uint64_t value = 0;
    std::memcpy(&value, bytes.data() + lead, encoding_.header_size);
    return static_cast<std::size_t>(value);
  }

  static Result<void> unpack(std::string_view packed, std::size_t size, std::string& bytes) {
    constexpr std::size_t most = 1032;  // zlib shrinks nothing further
    const auto refuse = [] {
      return Error{ErrorCode::BadFormat, "zlib cannot unpack this array; the file may be damaged", {}};
    };
    if (size / most > packed.size()) return refuse();
    const std::size_t before = bytes.size();
    bytes.resize(before + size);
    uLongf length = size;
    const int state = uncompress(reinterpret_cast<Bytef*>(bytes.data() + before), &length,
                                 reinterpret_cast<const Bytef*>(packed.data()), packed.size());
    if (state != Z_OK || length != size) return refuse();
    return {};
  }

  std::string_view data_;
  const VtkEncoding encoding_;
};

}  // namespace

Result<VtkParts> vtk_parts(std::string_view text, const std::string& file) {
  const std::size_t tag = text.find("<AppendedData");
  const std::size_t tag_end = text.find('>', tag);
  if (tag == std::string_view::npos || text.substr(tag, tag_end - tag).find("\"raw\"") == std::string_view::npos)
    return VtkParts{std::string(text), {}};
  const std::size_t begin = text.find('_', tag_end);
  constexpr std::string_view end_tag = "</AppendedData>";
  const std::size_t end = text.rfind(end_tag);
  // The bytes may hold what looks like the tag: the true one stands before the end of the file.
  if (begin == std::string_view::npos || end == std::string_view::npos || end <= begin ||
      !base::trimmed(text.substr(end + end_tag.size())).starts_with("</VTKFile>")) {
    return Error{ErrorCode::BadFormat, "the appended data do not end; the file may have been cut short",
                 place_of_byte(text, tag, file)};
  }
  return VtkParts{std::string(text.substr(0, begin + 1)).append(text.substr(end)),
                  text.substr(begin + 1, end - begin - 1)};
}

Result<std::string> vtk_bytes(std::string_view data, const VtkEncoding& encoding) {
  ArrayBytes array(data, encoding);
  return encoding.zlib ? array.compressed() : array.plain();
}

}  // namespace dobra::io
