#pragma once
// The examples that come with a program: compiled in, with the files that they name.

#include <filesystem>
#include <string>

#include "shared/base/result.h"

namespace dobra::gui::welcome {

struct Example {
  std::string file;   ///< "fold.toml", in resources/examples/PROGRAM, or with its folder: "surfaces/6.toml".
  std::string title;  ///< English source.
  std::string line;   ///< What it shows, one sentence, English source.
};

/// Writes all examples of the folder that `file` is in, and the files that they name, to `folder`, over what is there;
/// those of another folder than the program's own to a folder of its name in it.
/// @return where the example is now.
/// @error FileNotFound: the program has no such example; CannotWrite.
base::Result<std::filesystem::path> write_example(const std::string& program, const std::string& file,
                                                  const std::filesystem::path& folder);

/// A folder of the user's own, the same at every start, where the files of examples stay.
std::filesystem::path examples_folder(const std::string& program);

}  // namespace dobra::gui::welcome
