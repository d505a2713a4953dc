#pragma once
// Where what a picture shows is made while the window goes on: one thread, in the order in which it was asked for.

#include <QObject>
#include <QTimer>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace dobra::gui::frames {

class Bench : public QObject {
  Q_OBJECT

 public:
  /// What is called on the thread of the bench; what it returns is called on that of the window. Both are destroyed
  /// there.
  using Work = std::function<std::function<void()>()>;

  explicit Bench(QObject* parent = nullptr);
  /// Waits for the work in hand.
  ~Bench() override;

  void post(Work work);
  /// Forgets all work and what was made, the work in hand excepted, of which nothing is heard any more.
  void clear();
  [[nodiscard]] bool is_idle() const;

 signals:
  /// Some of what was asked for is shown.
  void arrived();

 private:
  struct Piece {
    Work work;
    std::function<void()> show = nullptr;
    std::uint64_t age = 0;  ///< How often the bench was cleared before.
  };
  [[nodiscard]] bool all_is_made() const;
  void run();
  void deliver();

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Piece> waiting_;
  std::vector<Piece> made_;
  bool in_hand_ = false;
  bool ends_ = false;
  std::uint64_t age_ = 0;
  bool announced_ = false;
  QTimer pause_;  ///< Between two deliveries, each of which is a frame.
  std::thread thread_;
};

}  // namespace dobra::gui::frames
