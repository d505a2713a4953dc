#include "shared/gui/script.h"

#include <fmt/format.h>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <utility>

#include "shared/base/text.h"
#include "shared/gui/documents/edit.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/main_window.h"
#include "shared/gui/mending/error_bar.h"
#include "shared/gui/parameter_form.h"
#include "shared/gui/text.h"
#include "shared/gui/vtk_widget.h"
#include "shared/io/file.h"

namespace dobra::gui {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

constexpr int beat_milliseconds = 5;
constexpr int between_commands = 30;  ///< Milliseconds: the window paints what the last command changed.

/// Words that a command needs at least, its own name included.
const std::map<std::string, std::size_t>& commands() {
  static const std::map<std::string, std::size_t> all{
      {"wait", 1},  {"select", 2},      {"set", 2},        {"undo", 1},         {"redo", 1},        {"save", 1},
      {"fit", 1},   {"hide", 2},        {"show", 2},       {"save-picture", 2}, {"screenshot", 2},  {"zoom", 4},
      {"add", 2},   {"remove", 1},      {"quit", 1},       {"report", 2},       {"go-to-error", 1}, {"expect-error", 2},
      {"watch", 2}, {"longest-gap", 2}, {"full-frame", 2}, {"recover", 1},      {"tool", 2},        {"point", 3},
      {"click", 3}, {"drag", 5},        {"keys", 2},       {"look", 2},         {"frames", 2},      {"states", 6},
      {"action", 2}};
  return all;
}

Error failure(const QString& message) { return {ErrorCode::BadUsage, message.toStdString()}; }

/// All behind the first `count` words.
std::string behind(const std::string& line, std::size_t count) {
  std::string rest(base::trimmed(line));
  for (; count > 0; --count) {
    const std::size_t end = rest.find_first_of(" \t");
    if (end == std::string::npos) return {};
    rest = base::trimmed(rest.substr(end));
  }
  return rest;
}

}  // namespace

Result<std::vector<Script::Line>> Script::read(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) {
    return Error{ErrorCode::FileNotFound, "cannot read the script; give --script a text file",
                 base::Place{file.string(), 0, 0, {}, {}, {}}};
  }
  std::vector<Line> lines;
  std::string written;
  for (std::size_t number = 1; std::getline(in, written); ++number) {
    written = base::trimmed(written);
    if (written.empty() || written.front() == '#') continue;
    Line line{number, {}, behind(written, 1), behind(written, 2)};
    std::istringstream words(written);
    for (std::string word; words >> word;) line.words.push_back(word);
    const base::Place place{file.string(), number, 0, {}, {}, {}};
    const auto command = commands().find(line.words[0]);
    if (command == commands().end()) {
      std::vector<std::string> names;
      for (const auto& [name, count] : commands()) names.push_back(name);
      return Error{ErrorCode::BadSyntax,
                   "unknown command '" + line.words[0] + "'" + base::did_you_mean(line.words[0], names), place};
    }
    if (line.words.size() < command->second) {
      return Error{ErrorCode::BadSyntax, "'" + line.words[0] + "' needs more words", place};
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

Script::Script(std::vector<Line> lines, std::filesystem::path file, MainWindow& window)
    : QObject(&window), lines_(std::move(lines)), file_(std::move(file)), window_(window) {
  QTimer::singleShot(0, this, &Script::step);
  connect(&beat_, &QTimer::timeout, this, [this] { longest_gap_ = std::max(longest_gap_, since_beat_.restart()); });
  since_beat_.start();
  beat_.start(beat_milliseconds);
}

Script::~Script() = default;

void Script::step() {
  if (next_ == lines_.size()) return;
  const Line& line = lines_[next_];
  const bool shown = !window_.session().busy() && window_.view().is_settled();
  if (!keys_.empty() || gesture_ || (line.words[0] == "wait" && !shown)) {
    QTimer::singleShot(between_commands, this, &Script::step);
    return;
  }
  ++next_;
  if (line.words[0] == "quit") {
    window_.session().forget_unsaved();
    emit ended(0);
    return;
  }
  const Result<void> done = execute(line);
  if (!done) {
    std::fprintf(stderr, "%s:%zu: %s\n", file_.string().c_str(), line.number, base::to_string(done.error()).c_str());
    emit ended(1);
    return;
  }
  QTimer::singleShot(between_commands, this, &Script::step);
}

Result<void> Script::execute(const Line& line) {
  const std::string& command = line.words[0];
  Session& session = window_.session();
  if (command == "select") return select(line.words[1]);
  if (command == "set") {
    // At its default already, or the same value again, is not an error: the form then has nothing to do.
    return window_.form().form()->type(line.words[1], QString::fromStdString(line.rest2));
  }
  if (command == "undo") {
    if (!window_.undo()) return failure(text("there is nothing to undo"));
  } else if (command == "redo") {
    if (!session.history().can_redo()) return failure(text("there is nothing to do again"));
    session.redo();
  } else if (command == "save") {
    const std::filesystem::path file = line.rest.empty() ? session.document().file : std::filesystem::path(line.rest);
    if (file.empty()) return failure(text("the document has no file yet; write save PATH"));
    return window_.save(file);
  } else if (command == "save-picture") {
    return window_.save_picture(line.rest);
  } else if (command == "screenshot") {
    return window_.save_screenshot(line.rest);
  } else if (command == "report") {
    return write_report(line.rest);
  } else if (command == "recover") {
    if (!session.unsaved()) return failure(text("there is nothing to recover"));
    session.recover();
  } else if (command == "longest-gap") {
    return io::write_file(line.rest, std::to_string(std::exchange(longest_gap_, 0)) + "\n");
  } else if (command == "full-frame") {
    const frames::Meter::FullFrame frame = window_.view().meter().take_longest_frame();
    return io::write_file(line.rest, fmt::format("{:.0f} {:.0f}\n", frame.milliseconds, frame.deaf));
  } else if (command == "frames") {
    return count_frames(line.rest);
  } else if (command == "states") {
    return count_states(line);
  } else if (command == "hide" || command == "show") {
    if (!window_.layers().set_layer_visible(line.rest, command == "show")) {
      return failure(text("no layer '%1'").arg(QString::fromStdString(line.rest)));
    }
  } else if (command == "fit") {
    window_.view().fit();
  } else if (command == "zoom") {
    return zoom(line);
  } else if (command == "tool") {
    if (!window_.actions().trigger("draw." + line.rest))
      return failure(text("no tool '%1'").arg(QString::fromStdString(line.rest)));
  } else if (command == "point" || command == "click" || command == "drag") {
    return mouse(line);
  } else if (command == "keys") {
    press_keys(QString::fromStdString(line.rest));
  } else if (command == "action") {
    return trigger(line.words[1]);
  } else if (command == "look") {
    if (!window_.look_at(QString::fromStdString(line.rest))) return failure(text("write look input, result or both"));
  } else if (command == "add") {
    if (session.program().find_operation(line.words[1]) == nullptr) {
      return failure(text("no operation '%1'").arg(QString::fromStdString(line.words[1])));
    }
    emit window_.steps().add_asked(line.words[1]);
  } else if (command == "remove") {
    if (window_.steps().selected() == 0) return failure(text("the input cannot be removed; select a step"));
    emit window_.steps().remove_asked(window_.steps().selected());
  } else if (command == "go-to-error") {
    if (window_.error_bar().message().isEmpty()) return failure(text("there is no error to go to"));
    emit window_.error_bar().show_asked();
  } else if (command == "watch") {
    return watch(line);
  } else if (command == "expect-error") {
    const QString said = window_.error_bar().message();
    if (!said.contains(QString::fromStdString(line.rest))) {
      return failure(text("the error bar says '%1'").arg(said));
    }
  }
  return {};
}

Result<void> Script::trigger(const std::string& id) {
  actions::Registry& actions = window_.actions();
  if (actions.find(id) == nullptr) {
    std::vector<std::string> ids;
    for (const actions::Registry::Entry& entry : actions.all()) ids.push_back(entry.action.id);
    return failure(text("no action '%1'").arg(QString::fromStdString(id)) +
                   QString::fromStdString(base::did_you_mean(id, ids)));
  }
  actions.refresh();
  if (!actions.find(id)->isEnabled()) return failure(text("'%1' cannot be done now").arg(QString::fromStdString(id)));
  // Behind this command: a question that it opens does not keep the script waiting.
  QTimer::singleShot(0, &window_, [&actions, id] { actions.trigger(id); });
  return {};
}

Result<void> Script::select(const std::string& part) {
  const std::vector<scenario::Step>& steps = window_.session().document().steps;
  if (part == "input" || part == "0") {
    window_.select(0);
    return {};
  }
  for (std::size_t step = 1; step <= steps.size(); ++step) {
    if (steps[step - 1].name != part && std::to_string(step) != part) continue;
    window_.select(step);
    return {};
  }
  return failure(text("no step '%1'; there are %2").arg(QString::fromStdString(part)).arg(steps.size()));
}

Result<void> Script::watch(const Line& line) {
  Player& player = window_.player();
  const std::size_t part = window_.watched_part();
  if (part == 0) return failure(text("no step of this document can be watched"));
  const std::string& what = line.words[1];
  const std::optional<double> count = line.words.size() > 2 ? base::parse_number(line.words[2]) : 1.0;
  if (what == "play")
    player.play(part);
  else if (what == "pause")
    player.pause();
  else if (what == "stop")
    player.stop();
  else if (what == "step" && count && *count >= 1.0)
    player.step(part, static_cast<std::size_t>(*count));
  else
    return failure(text("write watch play, pause, stop or step COUNT"));
  return {};
}

Result<void> Script::zoom(const Line& line) {
  const std::optional<double> factor = base::parse_number(line.words[1]);
  const std::optional<double> x = base::parse_number(line.words[2]);
  const std::optional<double> y = base::parse_number(line.words[3]);
  if (!factor || !x || !y || !(*factor > 0))
    return failure(text("write zoom FACTOR X Y with a factor above 0 and X, Y in 0..1"));
  window_.view().zoom(*factor, {*x * window_.view().width(), *y * window_.view().height()});
  return {};
}

/// A mouse that moves to and fro for two seconds, button held, 120 times a second. As a window system does, it sends
/// the latest place only, once the one before has been answered.
struct Script::Gesture {
  QPointF from;
  QPointF to;
  Qt::MouseButton button = Qt::NoButton;
  std::filesystem::path file;                    ///< Where the answer goes: how many a second.
  std::function<std::size_t()> count = nullptr;  ///< Of what.
  std::size_t before = 0;
  QElapsedTimer clock;
  QTimer beat;
  bool answered = true;
};

void Script::begin(std::unique_ptr<Gesture> gesture) {
  gesture_ = std::move(gesture);
  post_mouse(QEvent::MouseMove, gesture_->from, Qt::NoButton, Qt::NoButton);
  post_mouse(QEvent::MouseButtonPress, gesture_->from, gesture_->button, gesture_->button);
  gesture_->before = gesture_->count();
  gesture_->clock.start();
  gesture_->beat.setTimerType(Qt::PreciseTimer);
  connect(&gesture_->beat, &QTimer::timeout, this, &Script::move_on);
  gesture_->beat.start(8);
}

void Script::move_on() {
  constexpr qint64 duration = 2000;  // milliseconds
  Gesture& gesture = *gesture_;
  const double turns = static_cast<double>(gesture.clock.elapsed()) / 1000.0;
  const double part = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * turns);
  const QPointF at = gesture.from + part * (gesture.to - gesture.from);
  if (gesture.clock.elapsed() < duration) {
    if (!std::exchange(gesture.answered, false)) return;
    post_mouse(QEvent::MouseMove, at, Qt::NoButton, gesture.button);
    QMetaObject::invokeMethod(
        this,
        [this] {
          if (gesture_) gesture_->answered = true;
        },
        Qt::QueuedConnection);
    return;
  }
  gesture.beat.stop();
  const double seconds = static_cast<double>(gesture.clock.elapsed()) / 1000.0;
  const double rate = static_cast<double>(gesture.count() - gesture.before) / seconds;
  post_mouse(QEvent::MouseButtonRelease, at, gesture.button, Qt::NoButton);
  const Result<void> written = io::write_file(gesture.file, QString::number(rate, 'f', 1).toStdString() + "\n");
  if (!written) std::fprintf(stderr, "%s\n", base::to_string(written.error()).c_str());
  QMetaObject::invokeMethod(
      this, [this] { gesture_.reset(); }, Qt::QueuedConnection);
}

Result<void> Script::count_frames(const std::filesystem::path& file) {
  VtkWidget& view = window_.view();
  if (!view.is_ready() || view.panel_count() == 0) return failure(text("there is no picture to point at"));
  auto gesture = std::make_unique<Gesture>();
  gesture->from = view.plot(0).center();
  gesture->to = gesture->from + QPointF(120.0, 20.0);
  gesture->button = Qt::MiddleButton;
  gesture->file = file;
  gesture->count = [&view] { return view.meter().frames(); };
  begin(std::move(gesture));
  return {};
}

Result<void> Script::count_states(const Line& line) {
  std::vector<double> at;
  for (std::size_t i = 1; i < 5; ++i) {
    const std::optional<double> number = base::parse_number(line.words[i]);
    if (!number) return failure(text("'%1' is not a number").arg(QString::fromStdString(line.words[i])));
    at.push_back(*number);
  }
  VtkWidget& view = window_.view();
  if (!view.is_ready() || view.panel_count() == 0) return failure(text("there is no picture to point at"));
  auto gesture = std::make_unique<Gesture>();
  gesture->from = view.pixel_of(0, {at[0], at[1]});
  gesture->to = view.pixel_of(0, {at[2], at[3]});
  gesture->button = Qt::LeftButton;
  gesture->file = line.words[5];
  gesture->count = [&view] { return view.meter().states(); };
  begin(std::move(gesture));
  return {};
}

void Script::post_mouse(QEvent::Type type, QPointF pixel, Qt::MouseButton button, Qt::MouseButtons held) {
  // Posted, as those of a person are: a question that one of them opens does not keep the script waiting.
  VtkWidget& view = window_.view();
  QCoreApplication::postEvent(&view, new QMouseEvent(type, pixel, view.mapToGlobal(pixel), button, held, {}));
}

Result<void> Script::mouse(const Line& line) {
  std::vector<double> at;
  for (std::size_t i = 1; i < line.words.size(); ++i) {
    const std::optional<double> number = base::parse_number(line.words[i]);
    if (!number) return failure(text("'%1' is not a number").arg(QString::fromStdString(line.words[i])));
    at.push_back(*number);
  }
  VtkWidget& view = window_.view();
  if (!view.is_ready() || view.panel_count() == 0) return failure(text("there is no picture to point at"));
  const QPointF from = view.pixel_of(0, {at[0], at[1]});
  post_mouse(QEvent::MouseMove, from, Qt::NoButton, Qt::NoButton);
  if (line.words[0] == "point") return {};
  post_mouse(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
  QPointF to = from;
  if (at.size() > 3) {
    to = view.pixel_of(0, {at[2], at[3]});
    for (const double part : {0.25, 0.5, 0.75, 1.0})
      post_mouse(QEvent::MouseMove, from + part * (to - from), Qt::NoButton, Qt::LeftButton);
  }
  post_mouse(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
  return {};
}

void Script::press_keys(const QString& typed) {
  const std::map<QString, int> names{{"Enter", Qt::Key_Return},
                                     {"Escape", Qt::Key_Escape},
                                     {"Delete", Qt::Key_Delete},
                                     {"Backspace", Qt::Key_Backspace}};
  if (const auto named = names.find(typed); named != names.end()) {
    keys_.emplace_back(named->second, QString());
  } else {
    for (const QChar letter : typed) keys_.emplace_back(Qt::Key_unknown, letter);
  }
  press_next_key();
}

/// To where the focus is, or to the picture. A key may move the focus, so that the next one waits for what it does.
void Script::press_next_key() {
  if (keys_.empty()) return;
  const auto [key, letters] = keys_.front();
  keys_.erase(keys_.begin());
  const QWidget* top = QApplication::activeModalWidget() != nullptr ? QApplication::activeModalWidget() : &window_;
  QWidget* focus = top->focusWidget() != nullptr ? top->focusWidget() : &window_.view();
  // Posted: a question that the key opens does not keep the script waiting.
  QCoreApplication::postEvent(focus, new QKeyEvent(QEvent::KeyPress, key, {}, letters));
  QCoreApplication::postEvent(focus, new QKeyEvent(QEvent::KeyRelease, key, {}, letters));
  QTimer::singleShot(0, this, &Script::press_next_key);
}

Result<void> Script::write_report(const std::filesystem::path& file) {
  const Session& session = window_.session();
  if (session.busy() || !session.outcome()) return failure(text("no run has ended yet; write wait before"));
  const documents::Outcome& outcome = *session.outcome();
  return io::write_file(file, scenario::report_json(*outcome.document, session.program(), outcome.run));
}

}  // namespace dobra::gui
