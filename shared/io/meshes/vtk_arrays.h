#pragma once
// The number arrays of VTK's XML files (.vtu, .vtp), one piece: ASCII, or binary in place or appended. Of use to their
// readers. Source: [vtkfileformats].

#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/meshes/vtu.h"
#include "shared/io/vtk_data.h"
#include "shared/io/xml.h"

namespace dobra::io::meshes {

struct VtkArray {
  MeshField field;
  pugi::xml_node node;
};

class VtkArrays {
 public:
  /// @param text      must outlive it
  /// @param ending    of such files, for messages
  /// @param type      of the VTKFile
  /// @param sections  of which the arrays are read; others are passed over
  /// @error BadFormat, NotFinite with line and column; UnknownFormat: another type or byte order, several pieces,
  ///        data compressed by another library than zlib
  static base::Result<VtkArrays> read(std::string_view text, const std::string& file, std::string_view ending,
                                      const std::string& type, std::initializer_list<const char*> sections);

  /// Those of a section that were not taken, in the order of the file.
  [[nodiscard]] std::vector<VtkArray>& of(const std::string& section) { return arrays_[section]; }
  /// The first of that name; of any, if it is empty. @error BadFormat: there is none
  base::Result<VtkArray> take(const std::string& section, std::string_view name);
  [[nodiscard]] const pugi::xml_node& piece() const { return piece_; }
  [[nodiscard]] const std::string& file() const { return xml_->file(); }
  [[nodiscard]] base::Error error(const pugi::xml_node& at, std::string message,
                                  base::ErrorCode code = base::ErrorCode::BadFormat) const;

 private:
  VtkArrays(std::unique_ptr<const VtkParts> parts, std::unique_ptr<const Xml> xml)
      : parts_(std::move(parts)), xml_(std::move(xml)) {}
  base::Result<void> check_header(const pugi::xml_node& file, const std::string& type);
  base::Result<void> find_appended(const pugi::xml_node& file);
  base::Result<void> read_array(const pugi::xml_node& node, const std::string& section);
  base::Result<void> read_binary(const pugi::xml_node& node, std::vector<double>& values) const;
  base::Result<void> read_ascii(std::string_view text, std::vector<double>& values) const;

  std::unique_ptr<const VtkParts> parts_;
  std::unique_ptr<const Xml> xml_;  // of their markup
  pugi::xml_node piece_;
  VtkEncoding encoding_;
  std::string_view appended_;  // from the '_' on
  bool appended_base64_ = false;
  std::map<std::string, std::vector<VtkArray>> arrays_;
};

}  // namespace dobra::io::meshes
