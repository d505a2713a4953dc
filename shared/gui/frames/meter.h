#pragma once
// How long it takes from an input to the frame that shows it, part by part, and how many frames are shown. It can be
// seen over the picture: key F12, or DOBRA_METER=1.

#include <QLabel>
#include <QObject>
#include <array>
#include <chrono>
#include <deque>
#include <utility>

namespace dobra::gui::frames {

/// The way of an edit: the document that it makes, the run, the layers of its picture (both in the worker), the actors
/// of what has changed, the frame.
enum class Part { Edit, Run, Layers, Actors, Draw };
inline constexpr int part_count = 5;

class Meter : public QObject {
  Q_OBJECT

 public:
  using Clock = std::chrono::steady_clock;

  static double milliseconds_since(Clock::time_point begin);

  void add(Part part, double milliseconds);
  /// A frame has reached the screen.
  void count_frame();
  /// The next frame shows another state of the document.
  void expect_state();

  /// A frame in full detail: what it took from its beginning to its end, and the longest time that nothing else was
  /// heard meanwhile. One that is drawn in parts begins before; until it ends, the next that begins takes its place.
  void begin_full_frame() { ++begun_; }
  void add_full_frame(double milliseconds, double deaf);
  /// Frames in parts that were begun.
  [[nodiscard]] std::size_t begun() const { return begun_; }
  /// The longest since this was asked last.
  struct FullFrame {
    double milliseconds = 0.0;
    double deaf = 0.0;
  };
  FullFrame take_longest_frame() { return std::exchange(longest_, {}); }
  /// Those that came to their end, in one or in parts.
  [[nodiscard]] std::size_t full_frames() const { return full_frames_; }

  /// The last of each part, milliseconds.
  [[nodiscard]] double last(Part part) const { return last_[static_cast<std::size_t>(part)]; }
  /// Frames that were shown since the meter was made, and those of them that showed another state.
  [[nodiscard]] std::size_t frames() const { return frames_; }
  [[nodiscard]] std::size_t states() const { return states_; }
  /// Of the last second.
  [[nodiscard]] std::size_t frames_a_second() const { return recent_.size(); }
  /// "edit 1.2  run 14.0  layers 3.1  actors 2.0  draw 8.4 ms  40 frames/s".
  [[nodiscard]] QString words() const;

 signals:
  void changed();

 private:
  std::array<double, part_count> last_{};
  std::size_t frames_ = 0;
  std::size_t states_ = 0;
  std::size_t begun_ = 0;
  std::size_t full_frames_ = 0;
  FullFrame longest_;
  bool new_state_ = false;
  std::deque<Clock::time_point> recent_;
};

/// What a meter says, in a corner of its parent; F12 shows and hides it.
class MeterLabel : public QLabel {
  Q_OBJECT

 public:
  MeterLabel(Meter& meter, QWidget* parent);
};

}  // namespace dobra::gui::frames
