#include "shared/io/gis/gdal.h"

#include <cpl_vsi.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>

namespace dobra::io::gis {

namespace {

constexpr std::string_view memory_folder = "/vsimem/";

}  // namespace

void CPL_STDCALL GdalMessages::collect(CPLErr severity, CPLErrorNum, const char* message) {
  auto* self = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
  std::string line = message;
  std::replace(line.begin(), line.end(), '\n', ' ');
  // The name of a text in memory, in quotes, says nothing to the user; the place of the error names the file.
  for (std::size_t at = line.find(memory_folder); at != std::string::npos; at = line.find(memory_folder)) {
    std::size_t end = std::min(line.find_first_of("'\"`:, )", at), line.size());
    const bool quoted = at > 0 && std::string_view("'\"`").find(line[at - 1]) != std::string_view::npos;
    if (quoted && end < line.size()) --at, ++end;
    line.replace(at, end - at, "the file");
  }
  if (severity >= CE_Failure && !self->failure) self->failure = line;
  if (severity == CE_Warning) self->warnings.push_back(line);
}

GdalMemoryFile::GdalMemoryFile(std::string_view text, std::string_view ending) {
  static std::atomic<unsigned> count{0};
  name_ = fmt::format("{}dobra_text_{}{}", memory_folder, count++, ending);
  // GDAL only reads it: data sets are opened read-only and the buffer is not owned.
  auto* data = reinterpret_cast<GByte*>(const_cast<char*>(text.data()));
  if (VSILFILE* file = VSIFileFromMemBuffer(name_.c_str(), data, text.size(), FALSE)) VSIFCloseL(file);
}

GdalMemoryFile::~GdalMemoryFile() { VSIUnlink(name_.c_str()); }

}  // namespace dobra::io::gis
