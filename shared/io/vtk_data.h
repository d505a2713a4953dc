#pragma once
// The binary data of VTK's XML files: in place or appended behind the markup, as base64 or raw, as they are or
// compressed by zlib. Of use to VtkArrays. Source: [vtkfileformats].

#include <cstddef>
#include <string>
#include <string_view>

#include "shared/base/result.h"

namespace dobra::io {

/// A file parted into its markup, which is XML, and the raw bytes appended in it, which are not.
struct VtkParts {
  std::string markup;         ///< Of the same lines up to those bytes.
  std::string_view appended;  ///< Behind the '_'; empty where no raw bytes are appended.
};

/// @error BadFormat: the appended bytes have no beginning or no end.  @cost linear
base::Result<VtkParts> vtk_parts(std::string_view text, const std::string& file);

/// How the bytes of an array are written.
struct VtkEncoding {
  std::size_t header_size = 4;  ///< bytes of a length
  bool zlib = false;
  bool base64 = true;
  bool alone = false;  ///< nothing may follow the array
};

/// The bytes of the array that begins where `data` does; what follows it is passed over.
/// @error BadFormat without a place: no base64, lengths that do not fit, bytes that zlib refuses.  @cost linear
base::Result<std::string> vtk_bytes(std::string_view data, const VtkEncoding& encoding);

}  // namespace dobra::io
