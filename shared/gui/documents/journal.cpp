#include "shared/gui/documents/journal.h"

#include <QStandardPaths>

#include "shared/io/file.h"

namespace dobra::gui::documents {

Journal::Journal(Failed failed) : failed_(std::move(failed)), thread_([this] { work(); }) {}

Journal::~Journal() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::filesystem::path Journal::file_of(const scenario::Document& document) {
  std::filesystem::path file = document.file;
  if (file.empty()) {
    file = std::filesystem::path(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation).toStdString()) /
           (document.program + ".toml");
  }
  return file += ".unsaved";
}

void Journal::keep(const std::filesystem::path& file, DocumentPtr document) {
  {
    const std::lock_guard lock(mutex_);
    waiting_[file] = std::move(document);
  }
  changed_.notify_all();
}

void Journal::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return waiting_.empty() && !writing_; });
}

void Journal::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const auto [file, document] = *waiting_.begin();
    waiting_.erase(waiting_.begin());
    writing_ = true;
    lock.unlock();
    std::error_code ignored;  // a folder that cannot be made is told of by the writing
    if (document == nullptr) {
      std::filesystem::remove(file, ignored);
    } else {
      if (document->file.empty()) std::filesystem::create_directories(file.parent_path(), ignored);
      const base::Result<void> written = io::write_file(file, scenario::document_text(*document));
      if (!written) failed_(written.error());
    }
    lock.lock();
    writing_ = false;
    changed_.notify_all();
  }
}

}  // namespace dobra::gui::documents
