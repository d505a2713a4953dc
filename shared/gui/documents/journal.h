#pragma once
// What is not saved yet, beside the document: "fold.toml.unsaved". It is there as long as the window holds changes, and
// so after a crash, for the next window to offer. Written on a thread of its own, the latest document of each file.

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <thread>

#include "shared/gui/documents/history.h"

namespace dobra::gui::documents {

class Journal {
 public:
  using Failed = std::function<void(const base::Error&)>;

  /// @param failed  called on the journal's thread when it cannot be written.
  explicit Journal(Failed failed);
  /// Comes back when all is written.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Where the journal of a document is; one without a file has its journal among the user's data.
  static std::filesystem::path file_of(const scenario::Document& document);

  /// The journal is to hold the document, or is to go if `document` is null. Returns at once.
  void keep(const std::filesystem::path& file, DocumentPtr document);
  /// Waits until all that was asked for is on the disk.
  void wait();

 private:
  void work();

  Failed failed_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::filesystem::path, DocumentPtr> waiting_;
  bool writing_ = false;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace dobra::gui::documents
