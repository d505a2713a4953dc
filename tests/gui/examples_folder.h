#pragma once
// A copy of the examples in a folder of its own, left and removed at the end.

#include <cstdlib>
#include <filesystem>
#include <string>

#include "quebra/core/operations.h"
#include "quebra/gui/window.h"
#include "recon/core/operations.h"
#include "recon/gui/window.h"
#include "shared/gui/window_part.h"

namespace dobra::test {

class ExamplesFolder {
 public:
  ExamplesFolder() : before_(std::filesystem::current_path()) {
    std::string name = (std::filesystem::temp_directory_path() / "dobra_examples_XXXXXX").string();
    folder_ = mkdtemp(name.data());
    std::filesystem::copy(std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/examples", folder_ / "examples",
                          std::filesystem::copy_options::recursive);
    std::filesystem::current_path(folder_);
  }
  ExamplesFolder(const ExamplesFolder&) = delete;
  ExamplesFolder& operator=(const ExamplesFolder&) = delete;
  ~ExamplesFolder() {
    std::filesystem::current_path(before_);
    std::filesystem::remove_all(folder_);
  }

  /// @param document  "recon/fold.toml"
  [[nodiscard]] std::filesystem::path file(const std::string& document) const {
    return folder_ / "examples" / document;
  }

 private:
  std::filesystem::path before_;
  std::filesystem::path folder_;
};

/// That of an example.
inline const scenario::Program& program_of(const std::string& document) {
  static const scenario::Program recon = recon::core::program();
  static const scenario::Program quebra = quebra::core::program();
  return document.starts_with("recon/") ? recon : quebra;
}
/// What that program adds to its window.
inline gui::WindowPart part_of(const std::string& document) {
  return document.starts_with("recon/") ? recon::gui::window_part() : quebra::gui::window_part();
}

}  // namespace dobra::test
