#pragma once
// Commands executed in the real window, one a line, so that what a user does can be replayed and tested:
// - wait: until no run is under way
// - select STEP: number, name, or 0 / input; set KEY VALUE: types into the selected form
// - add OPERATION: behind the selected part; remove: the selected step
// - undo, redo, fit; zoom FACTOR X Y: X, Y in 0..1 of the view from its top left
// - tool NAME: of the canvas (select, line, trim ...); point X Z, click X Z, drag X Z X Z: the mouse, at places of the
//   first panel; keys TEXT: letters, one after the other, to where the focus is then, or Enter, Escape, Delete,
//   Backspace
// - action ID: as its menu does (file.save, draw.line, step.add.OPERATION ...; the list is the palette's)
// - look input|result|both: which states are shown
// - hide LAYER, show LAYER: key, or panel/key
// - save [PATH], save-picture PATH, screenshot PATH; report PATH: report.json of the last run
// - expect-error WORDS: the error bar says WORDS; go-to-error: presses Show in it
// - watch play|pause|stop: the operation at work; watch step COUNT: so many steps more
// - longest-gap PATH: milliseconds that the window was deaf for at most since the last of these, or the beginning
// - full-frame PATH: milliseconds that the longest frame in full detail took since the last of these, from its
// beginning
//   to its end, and those for which it let nothing else be heard: the longest of its parts, where it is drawn in parts
// - frames PATH: pans there and back, and writes how many pictures a second are drawn meanwhile
// - recover: takes up the changes that a window lost
// - quit: without asking, and without keeping what is not saved
// "#" begins a comment. At the end without quit the window stays open. PATH is relative to the current folder.

#include <QElapsedTimer>
#include <QEvent>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "shared/base/result.h"

namespace dobra::gui {

class MainWindow;

class Script : public QObject {
  Q_OBJECT

 public:
  struct Line {
    std::size_t number = 0;  ///< 1-based.
    std::vector<std::string> words;
    std::string rest;   ///< All behind the first word.
    std::string rest2;  ///< All behind the second word.
  };

  /// @error FileNotFound; BadSyntax for an unknown command or missing words, with the line.
  static base::Result<std::vector<Line>> read(const std::filesystem::path& file);

  /// Starts as soon as the event loop runs.
  Script(std::vector<Line> lines, std::filesystem::path file, MainWindow& window);
  ~Script() override;

 signals:
  /// After quit. A command that failed has written one line to standard error; `exit_code` is then 1.
  void ended(int exit_code);

 private:
  void step();
  base::Result<void> execute(const Line& line);
  base::Result<void> select(const std::string& part);
  base::Result<void> trigger(const std::string& id);
  base::Result<void> zoom(const Line& line);
  base::Result<void> mouse(const Line& line);
  void press_keys(const QString& typed);
  void press_next_key();
  base::Result<void> watch(const Line& line);
  struct Gesture;
  void begin(std::unique_ptr<Gesture> gesture);
  void move_on();
  /// How many frames a second are shown while the picture is panned.
  base::Result<void> count_frames(const std::filesystem::path& file);
  /// How many states of the document a second are shown while a point is dragged.
  base::Result<void> count_states(const Line& line);
  void post_mouse(QEvent::Type type, QPointF pixel, Qt::MouseButton button, Qt::MouseButtons held);
  base::Result<void> write_report(const std::filesystem::path& file);

  std::vector<Line> lines_;
  std::filesystem::path file_;
  MainWindow& window_;
  std::size_t next_ = 0;
  std::vector<std::pair<int, QString>> keys_;  ///< Still to be pressed.
  QTimer beat_;                                ///< Tells how long nothing else could be heard.
  QElapsedTimer since_beat_;
  qint64 longest_gap_ = 0;
  std::unique_ptr<Gesture> gesture_;  ///< Until it has ended.
};

}  // namespace dobra::gui
