#pragma once
// GDAL/OGR kept on a leash: its messages collected instead of printed, text given to it from memory.
// Internal to io: the readers that go through OGR use it. Source: [gdal].

#include <cpl_error.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dobra::io::gis {

/// What GDAL says in this thread while the object lives comes here instead of to standard error.
class GdalMessages {
 public:
  GdalMessages() { CPLPushErrorHandlerEx(&GdalMessages::collect, this); }
  ~GdalMessages() { CPLPopErrorHandler(); }
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  std::optional<std::string> failure;  ///< The first one, on one line.
  std::vector<std::string> warnings;   ///< One line each.

 private:
  static void CPL_STDCALL collect(CPLErr severity, CPLErrorNum number, const char* message);
};

/// A text as a file of GDAL's memory file system, for reading. The text must outlive the object.
class GdalMemoryFile {
 public:
  /// @param ending  of the name, such as ".dxf": some drivers look at it.
  GdalMemoryFile(std::string_view text, std::string_view ending);
  ~GdalMemoryFile();
  GdalMemoryFile(const GdalMemoryFile&) = delete;
  GdalMemoryFile& operator=(const GdalMemoryFile&) = delete;
  [[nodiscard]] const char* name() const { return name_.c_str(); }

 private:
  std::string name_;
};

}  // namespace dobra::io::gis
