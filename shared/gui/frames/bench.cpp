#include "shared/gui/frames/bench.h"

#include <utility>

namespace dobra::gui::frames {

namespace {
constexpr int between_deliveries = 60;  ///< Milliseconds.
}

Bench::Bench(QObject* parent) : QObject(parent) {
  pause_.setSingleShot(true);
  pause_.setInterval(between_deliveries);
  connect(&pause_, &QTimer::timeout, this, &Bench::deliver);
  thread_ = std::thread([this] { run(); });
}

Bench::~Bench() {
  clear();
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Bench::post(Work work) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back({std::move(work), nullptr, age_});
  }
  changed_.notify_all();
}

void Bench::clear() {
  std::deque<Piece> dropped;
  std::vector<Piece> unseen;
  const std::lock_guard lock(mutex_);
  ++age_;
  dropped.swap(waiting_);
  unseen.swap(made_);
}

bool Bench::is_idle() const {
  const std::lock_guard lock(mutex_);
  return waiting_.empty() && made_.empty() && !in_hand_;
}

bool Bench::all_is_made() const {
  const std::lock_guard lock(mutex_);
  return waiting_.empty() && !in_hand_;
}

void Bench::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
    if (ends_) return;
    Piece piece = std::move(waiting_.front());
    waiting_.pop_front();
    in_hand_ = true;
    lock.unlock();
    piece.show = piece.work();
    lock.lock();
    in_hand_ = false;
    made_.push_back(std::move(piece));
    if (std::exchange(announced_, true)) continue;
    QMetaObject::invokeMethod(
        this,
        [this] {
          if (all_is_made())
            deliver();
          else if (!pause_.isActive())
            pause_.start();
        },
        Qt::QueuedConnection);
  }
}

void Bench::deliver() {
  std::vector<Piece> made;
  {
    const std::lock_guard lock(mutex_);
    made.swap(made_);
    announced_ = false;
    std::erase_if(made, [this](const Piece& piece) { return piece.age != age_; });
  }
  if (made.empty()) return;
  for (const Piece& piece : made) piece.show();
  emit arrived();
}

}  // namespace dobra::gui::frames
