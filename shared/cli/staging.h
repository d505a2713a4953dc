#pragma once
// Results are first written into a hidden folder inside their target folder and moved in when all of them are there, so
// that a run that fails, is interrupted or fills the disk leaves the target as it was. Hidden folders that killed runs
// left are removed by the next one.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/cli/session.h"

namespace dobra::cli {

enum class TargetFolder { Create, MustExist };

/// Whether a file can be written there, to be asked before long work: its folder is there and can be written, and so
/// can what stands in its place.
/// @error CannotWrite naming the file or the folder.
base::Result<void> check_writable(const std::filesystem::path& file);

class Staging {
 public:
  /// @error CannotWrite naming the folder that cannot be made or written.
  static base::Result<Staging> open(const std::filesystem::path& target, TargetFolder mode);

  Staging(Staging&& other) noexcept;
  Staging& operator=(Staging&&) = delete;
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  /// Removes what was not moved in, and the target folder if it was made for nothing.
  ~Staging();

  /// Where to write the file that will be `name` in the target folder.
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  /// The error of a failed write, naming the file where the user expects it.
  [[nodiscard]] base::Error for_user(base::Error error) const;
  /// Moves everything in, and returns the names in order. What stands in a target's place and is no regular file (a
  /// device, a symbolic link) is written through, before anything is moved.
  /// @error CannotWrite naming the file; nothing was moved then.
  base::Result<std::vector<std::string>> commit();

 private:
  Staging() = default;
  std::filesystem::path target_;
  std::filesystem::path folder_;
  int lock_ = -1;  ///< Of the folder, as long as this process lives.
  std::vector<std::filesystem::path>
      created_;  ///< Target and its parents, as far as they were made here; the deepest last.
};

/// One file, whole or not at all.
/// @param write  to the path that it is given.
/// @error that of `write`, naming `out`; CannotWrite; Cancelled if the user stopped the work meanwhile.
base::Result<void> write_whole(const Session& session, const std::filesystem::path& out,
                               const std::function<base::Result<void>(const std::filesystem::path&)>& write);

}  // namespace dobra::cli
