#pragma once
// Somebody who knows nothing of the program: presses, drags, types, chooses and answers at random, by the events that a
// mouse and a keyboard send.

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <random>
#include <sstream>

#include "shared/gui/main_window.h"
#include "shared/gui/vtk_widget.h"

namespace dobra::test {

class Monkey {
 public:
  Monkey(gui::MainWindow& window, std::uint32_t seed) : window_(window), random_(seed) {
    // A question stops what asked it until it is answered, so that a clock answers.
    QObject::connect(&clock_, &QTimer::timeout, &clock_, [this] { answer(); });
    clock_.start(1);
  }

  /// One thing. What it was can be read in `last`.
  void act() {
    window_.activateWindow();
    const int what = below(100);
    if (what < 34)
      use_mouse();
    else if (what < 64)
      press_key(focus());
    else if (what < 76)
      trigger_action();
    else if (what < 90)
      click_widget();
    else if (what < 97)
      type_into_field();
    else
      resize();
    // A popup menu that stays open would take all that follows.
    if (QApplication::activePopupWidget() != nullptr) answer_popup(*QApplication::activePopupWidget());
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    if (!window_.isVisible()) window_.show();
  }

  /// The last twenty things, for a report of a failure.
  [[nodiscard]] std::string last() const {
    std::string all;
    for (const std::string& each : done_) all += each + "\n";
    return all;
  }
  [[nodiscard]] int below(int count) { return static_cast<int>(random_() % static_cast<std::uint32_t>(count)); }

 private:
  template <class... Parts>
  void note(const Parts&... parts) {
    std::ostringstream words;
    (words << ... << parts);
    done_.push_back(words.str());
    if (done_.size() > 20) done_.erase(done_.begin());
    if (qEnvironmentVariableIsSet("DOBRA_MONKEY_TALKS")) std::fprintf(stderr, "%s\n", done_.back().c_str());
  }
  QWidget* focus() {
    QWidget* focused = QApplication::focusWidget();
    return focused != nullptr ? focused : static_cast<QWidget*>(&window_.view());
  }
  Qt::KeyboardModifiers modifiers() {
    constexpr Qt::KeyboardModifier some[] = {Qt::NoModifier,    Qt::NoModifier,      Qt::NoModifier,
                                             Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier};
    return some[below(6)];
  }

  void use_mouse() {
    gui::VtkWidget& view = window_.view();
    const auto place = [&] { return QPointF(below(std::max(view.width(), 1)), below(std::max(view.height(), 1))); };
    const Qt::KeyboardModifiers held = modifiers();
    constexpr Qt::MouseButton buttons[] = {Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::MiddleButton,
                                           Qt::RightButton};
    const Qt::MouseButton button = buttons[below(5)];
    QPointF at = place();
    const int gesture = below(10);
    note("mouse ", gesture, " button ", static_cast<int>(button), " at ", at.x(), " ", at.y());
    if (gesture == 0) {
      QWheelEvent wheel(at, view.mapToGlobal(at), {}, {0, 120 * (below(9) - 4)}, Qt::NoButton, held, Qt::NoScrollPhase,
                        false);
      QCoreApplication::sendEvent(&view, &wheel);
      return;
    }
    if (gesture == 1) return QTest::mouseDClick(&view, button, held, at.toPoint());
    move(view, at, Qt::NoButton);
    QTest::mousePress(&view, button, held, at.toPoint());
    if (gesture > 4) {
      for (int i = below(4); i >= 0; --i) {
        at = below(2) == 0 ? at + QPointF(below(21) - 10, below(21) - 10) : place();
        move(view, at, button);
        if (below(3) == 0) QCoreApplication::processEvents();
        if (below(12) == 0) press_key(&view);  // amid the gesture
      }
    }
    QTest::mouseRelease(&view, button, held, at.toPoint());
  }
  static void move(gui::VtkWidget& view, QPointF at, Qt::MouseButton held) {
    QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, held, {});
    QCoreApplication::sendEvent(&view, &event);
  }

  void press_key(QWidget* where) {
    constexpr int keys[] = {
        Qt::Key_Return, Qt::Key_Return, Qt::Key_Escape, Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_Tab, Qt::Key_Space,
        Qt::Key_Left,   Qt::Key_Right,  Qt::Key_Up,     Qt::Key_Down,   Qt::Key_Home,      Qt::Key_End, Qt::Key_Plus,
        Qt::Key_Minus,  Qt::Key_Comma,  Qt::Key_Period, Qt::Key_At,     Qt::Key_Less,      Qt::Key_F2,  Qt::Key_F3,
        Qt::Key_F5,     Qt::Key_F7,     Qt::Key_F8,     Qt::Key_F9,     Qt::Key_F12,       Qt::Key_Menu};
    const int kind = below(10);
    Qt::KeyboardModifiers held = modifiers();
    int key = 0;
    if (kind < 4) {
      key = keys[below(static_cast<int>(std::size(keys)))];
    } else if (kind < 7) {
      key = Qt::Key_A + below(26);
    } else if (kind < 9) {
      key = Qt::Key_0 + below(10);
    } else {
      key = below(2) == 0 ? Qt::Key_Z : Qt::Key_Y;
      held = Qt::ControlModifier;
    }
    note("key ", key, " with ", static_cast<int>(held));
    QTest::keyClick(where, static_cast<Qt::Key>(key), held);
  }

  void trigger_action() {
    QList<QAction*> actions;
    for (QAction* each : window_.findChildren<QAction*>()) {
      if (each->isEnabled() && !each->isSeparator() && each->menu() == nullptr) actions.push_back(each);
    }
    if (actions.isEmpty()) return;
    QAction* chosen = actions[below(static_cast<int>(actions.size()))];
    note("action ", chosen->text().toStdString());
    chosen->trigger();
  }

  void click_widget() {
    QList<QWidget*> widgets;
    for (QWidget* each : window_.findChildren<QWidget*>()) {
      const bool of_use = qobject_cast<QAbstractButton*>(each) != nullptr ||
                          qobject_cast<QLineEdit*>(each) != nullptr || qobject_cast<QComboBox*>(each) != nullptr ||
                          qobject_cast<QAbstractItemView*>(each->parentWidget()) != nullptr;
      if (of_use && each->isVisible() && each->isEnabled()) widgets.push_back(each);
    }
    if (widgets.isEmpty()) return;
    QWidget* chosen = widgets[below(static_cast<int>(widgets.size()))];
    note("click on ", chosen->metaObject()->className(), " ", chosen->objectName().toStdString());
    if (auto* choices = qobject_cast<QComboBox*>(chosen)) {
      // Its list would be a window of its own.
      choices->setFocus();
      return QTest::keyClick(choices, below(2) == 0 ? Qt::Key_Down : Qt::Key_Up);
    }
    const QPoint at(below(std::max(chosen->width(), 1)), below(std::max(chosen->height(), 1)));
    QTest::mouseClick(chosen, below(8) == 0 ? Qt::RightButton : Qt::LeftButton, modifiers(), at);
  }

  void type_into_field() {
    QList<QLineEdit*> fields;
    for (QLineEdit* each : window_.findChildren<QLineEdit*>()) {
      if (each->isVisible() && each->isEnabled()) fields.push_back(each);
    }
    if (fields.isEmpty()) return;
    QLineEdit* chosen = fields[below(static_cast<int>(fields.size()))];
    constexpr const char* texts[] = {"1",  "0",         "-3.5", "1e300",  "nan",   "12,5",  "abc",
                                     "",   "Limestone", "a, b", "[]",     "[1,2]", "1e-30", "7 m",
                                     "\"", "\\",        "0 0",  "@10<45", "100",   "2"};
    const char* typed = texts[below(static_cast<int>(std::size(texts)))];
    note("type ", typed, " into ", chosen->objectName().toStdString());
    chosen->setFocus();
    chosen->selectAll();
    if (*typed == '\0')
      QTest::keyClick(chosen, Qt::Key_Delete);
    else
      QTest::keyClicks(chosen, typed);
    if (below(4) != 0) QTest::keyClick(chosen, below(2) == 0 ? Qt::Key_Return : Qt::Key_Tab);
  }

  void resize() {
    const QSize size(500 + below(800), 350 + below(450));
    note("resize to ", size.width(), " ", size.height());
    window_.resize(size);
  }

  void answer() {
    if (QWidget* popup = QApplication::activePopupWidget()) return answer_popup(*popup);
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    // Files elsewhere are none of its business.
    if (qobject_cast<QFileDialog*>(dialog) != nullptr) return dialog->reject();
    QList<QAbstractButton*> buttons;
    for (QAbstractButton* each : dialog->findChildren<QAbstractButton*>()) {
      if (each->isVisible() && each->isEnabled()) buttons.push_back(each);
    }
    const int how = below(8);
    note("answer ", how, " to ", dialog->metaObject()->className());
    if (how == 0 || buttons.isEmpty()) return dialog->reject();
    // To the dialog, as a window system does that lets nobody past it; it may not have the focus yet.
    if (how < 3) return press_key(dialog->focusWidget() != nullptr ? dialog->focusWidget() : dialog);
    QTest::mouseClick(buttons[below(static_cast<int>(buttons.size()))], Qt::LeftButton);
  }
  void answer_popup(QWidget& popup) {
    auto* menu = qobject_cast<QMenu*>(&popup);
    note("popup ", popup.metaObject()->className());
    if (menu == nullptr || menu->actions().isEmpty() || below(3) == 0) {
      popup.close();
      return;
    }
    QAction* chosen = menu->actions()[below(static_cast<int>(menu->actions().size()))];
    menu->close();
    if (chosen->isEnabled() && !chosen->isSeparator() && chosen->menu() == nullptr) chosen->trigger();
  }

  gui::MainWindow& window_;
  std::mt19937 random_;
  QTimer clock_;
  std::vector<std::string> done_;
};

}  // namespace dobra::test
