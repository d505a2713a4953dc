#include "shared/cli/staging.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

#include "shared/base/text.h"
#include "shared/io/file.h"

namespace dobra::cli {
namespace {

namespace fs = std::filesystem;

/// Makes `folder` and its missing parents, telling which were made.
base::Result<std::vector<fs::path>> make_folders(const fs::path& folder) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  for (fs::path path = fs::absolute(folder, ignored).lexically_normal();
       !fs::exists(path, ignored) && path.has_relative_path(); path = path.parent_path()) {
    if (path.has_filename()) missing.push_back(path);
  }
  std::reverse(missing.begin(), missing.end());
  std::vector<fs::path> made;
  for (const fs::path& path : missing) {
    if (::mkdir(path.c_str(), 0777) != 0 && errno != EEXIST) {
      const int failed = errno;
      for (auto back = made.rbegin(); back != made.rend(); ++back) ::rmdir(back->c_str());
      return io::cannot_write(folder, failed);
    }
    made.push_back(path);
  }
  return made;
}

/// How a staged file gets to its place.
enum class Way { Rename, WriteThrough };

base::Result<Way> way_to(const fs::path& place) {
  struct stat status {};
  if (::lstat(place.c_str(), &status) != 0) return Way::Rename;
  if (S_ISDIR(status.st_mode)) return io::cannot_write(place, EISDIR);
  if (!S_ISREG(status.st_mode)) return Way::WriteThrough;
  // A rename would replace a file that its owner protected against writing.
  if (::access(place.c_str(), W_OK) != 0) return io::cannot_write(place, errno);
  return Way::Rename;
}

constexpr std::string_view prefix = ".staging-";

/// The folder, locked by this process; below 0 if another one has the lock, or there are no locks here.
int lock(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0 || ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

/// Removes what runs left whose process is gone. The lock is asked too: a process on another machine, or in another
/// container, has a number that means nothing here.
void sweep(const fs::path& target) {
  std::error_code ignored;
  std::vector<fs::path> stale;
  for (fs::directory_iterator entry(target, ignored), end; !ignored && entry != end; entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(prefix)) continue;
    const std::string number = name.substr(prefix.size(), name.find('-', prefix.size()) - prefix.size());
    const auto process = base::parse_number(number);
    if (!process || !(*process >= 1.0) || *process > 1e9) continue;
    if (::kill(static_cast<pid_t>(*process), 0) == 0 || errno != ESRCH) continue;
    stale.push_back(entry->path());
  }
  for (const fs::path& folder : stale) {
    const int own = lock(folder);
    if (own < 0) continue;
    fs::remove_all(folder, ignored);
    ::close(own);
  }
}

}  // namespace

base::Result<void> check_writable(const fs::path& file) {
  DOBRA_TRY(const Way way, way_to(file));
  if (way == Way::Rename) {
    DOBRA_TRY_VOID(Staging::open(file.parent_path(), TargetFolder::MustExist));
  } else if (::access(file.c_str(), W_OK) != 0) {
    return io::cannot_write(file, errno);
  }
  return {};
}

base::Result<Staging> Staging::open(const fs::path& target, TargetFolder mode) {
  static std::atomic<unsigned> count{0};
  Staging staging;
  staging.target_ = target.empty() ? fs::path(".") : target;
  struct stat status {};
  const bool exists = ::stat(staging.target_.c_str(), &status) == 0;
  if (exists && !S_ISDIR(status.st_mode)) return io::cannot_write(staging.target_, ENOTDIR);
  if (!exists && mode == TargetFolder::MustExist) return io::cannot_write(staging.target_, errno);
  if (!exists) {
    DOBRA_TRY(staging.created_, make_folders(staging.target_));
  }
  sweep(staging.target_);
  const fs::path folder = staging.target_ / fmt::format("{}{}-{}", prefix, ::getpid(), count++);
  if (::mkdir(folder.c_str(), 0777) != 0) return io::cannot_write(staging.target_, errno);
  staging.folder_ = folder;
  staging.lock_ = lock(folder);
  return staging;
}

Staging::Staging(Staging&& other) noexcept
    : target_(std::move(other.target_)),
      folder_(std::move(other.folder_)),
      lock_(std::exchange(other.lock_, -1)),
      created_(std::move(other.created_)) {
  other.folder_.clear();
  other.created_.clear();
}

Staging::~Staging() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
  if (lock_ >= 0) ::close(lock_);
  // Folders that hold something, as after commit(), stay.
  for (auto path = created_.rbegin(); path != created_.rend(); ++path) ::rmdir(path->c_str());
}

base::Error Staging::for_user(base::Error error) const {
  const std::string inside = folder_.string() + '/';
  const auto replace = [&](std::string& text) {
    for (std::size_t at = text.find(inside); at != std::string::npos; at = text.find(inside)) {
      text.replace(at, inside.size(), (target_ / "").string());
    }
  };
  replace(error.message);
  if (error.place) replace(error.place->file);
  return error;
}

base::Result<std::vector<std::string>> Staging::commit() {
  std::vector<std::string> names;
  std::error_code failed;
  for (fs::directory_iterator entry(folder_, failed), end; !failed && entry != end; entry.increment(failed)) {
    names.push_back(entry->path().filename().string());
  }
  if (failed) return io::cannot_write(target_, failed.value());
  std::sort(names.begin(), names.end());
  std::vector<std::string> to_rename;
  std::vector<std::string> to_write;
  for (const std::string& name : names) {
    DOBRA_TRY(const Way way, way_to(target_ / name));
    (way == Way::Rename ? to_rename : to_write).push_back(name);
  }
  for (const std::string& name : to_write) {
    DOBRA_TRY(const std::string bytes, io::read_bytes(folder_ / name));
    DOBRA_TRY_VOID(io::write_file(target_ / name, bytes));
  }
  for (const std::string& name : to_rename) {
    if (::rename((folder_ / name).c_str(), (target_ / name).c_str()) != 0)
      return io::cannot_write(target_ / name, errno);
  }
  created_.clear();
  return names;
}

base::Result<void> write_whole(const Session& session, const fs::path& out,
                               const std::function<base::Result<void>(const fs::path&)>& write) {
  DOBRA_TRY(Staging staging, Staging::open(out.parent_path(), TargetFolder::MustExist));
  if (const auto written = write(staging.path(out.filename().string())); !written)
    return staging.for_user(written.error());
  DOBRA_TRY_VOID(session.check());
  DOBRA_TRY_VOID(staging.commit());
  return {};
}

}  // namespace dobra::cli
