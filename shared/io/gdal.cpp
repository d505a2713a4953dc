#include "shared/io/gdal.h"

#include <cpl_vsi.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>

namespace dobra::io {

void CPL_STDCALL GdalMessages::collect(CPLErr severity, CPLErrorNum, const char* message) {
  auto* self = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
  std::string line = message;
  std::replace(line.begin(), line.end(), '\n', ' ');
  if (severity >= CE_Failure && !self->failure) self->failure = line;
  if (severity == CE_Warning) self->warnings.push_back(line);
}

GdalMemoryFile::GdalMemoryFile(std::string_view text, std::string_view ending) {
  static std::atomic<unsigned> count{0};
  name_ = fmt::format("/vsimem/dobra_text_{}{}", count++, ending);
  // GDAL only reads it: data sets are opened read-only and the buffer is not owned.
  auto* data = reinterpret_cast<GByte*>(const_cast<char*>(text.data()));
  if (VSILFILE* file = VSIFileFromMemBuffer(name_.c_str(), data, text.size(), FALSE)) VSIFCloseL(file);
}

GdalMemoryFile::~GdalMemoryFile() { VSIUnlink(name_.c_str()); }

}  // namespace dobra::io
