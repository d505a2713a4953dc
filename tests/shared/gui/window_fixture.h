#pragma once
// A window of the small program, with what a person does to it.

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>
#include <QWheelEvent>

#include "shared/gui/layer_tree.h"
#include "shared/gui/main_window.h"
#include "shared/gui/mending/error_bar.h"
#include "shared/gui/parameter_form.h"
#include "shared/gui/vtk_widget.h"
#include "tests/shared/gui/fake_program.h"

namespace dobra::test {

class WindowFixture : public testing::Test {
 protected:
  WindowFixture() {
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window, 10000));
  }
  void open_waves(const std::string& text = waves_text()) {
    ASSERT_TRUE(window.open(folder.write("waves.toml", text)).ok());
    settle();
  }
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.session().busy(); }, 30000));
    QCoreApplication::processEvents();
  }
  base::Result<void> type(const std::string& key, const char* typed) { return window.form().form()->type(key, typed); }
  std::string text() { return scenario::document_text(window.session().document()); }
  QPointF middle_of(std::size_t panel) { return window.view().pixel_of(panel, window.view().view(panel).centre); }

  void drag(Qt::MouseButton button, QPointF from, QPointF to) {
    QTest::mousePress(&window.view(), button, {}, from.toPoint());
    for (const double t : {0.5, 1.0}) {
      const QPointF at = from + t * (to - from);
      QMouseEvent move(QEvent::MouseMove, at, window.view().mapToGlobal(at), Qt::NoButton, button, {});
      QCoreApplication::sendEvent(&window.view(), &move);
    }
    QTest::mouseRelease(&window.view(), button, {}, to.toPoint());
  }
  void turn_wheel(QPointF at, int notches) {
    QWheelEvent wheel(at, window.view().mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, {}, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(&window.view(), &wheel);
  }

  /// The editor that a person would click to change `key`, its form scrolled to it.
  QWidget* editor(const char* key) {
    auto* found = window.form().findChild<QWidget*>(QString("editor.") + key);
    return found != nullptr && found->focusProxy() != nullptr ? found->focusProxy() : found;
  }
  /// A click with the mouse, which takes the focus there.
  void click(QWidget* widget) {
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 5000));
    QTest::mouseClick(widget, Qt::LeftButton);
    QCoreApplication::processEvents();
    const bool takes_focus = (widget->focusPolicy() & Qt::ClickFocus) != 0;
    ASSERT_TRUE(QTest::qWaitFor([&] { return widget->hasFocus() || !takes_focus; }, 5000));
  }
  /// Keys go where the focus is, or to the window.
  QWidget* focus() { return QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : &window; }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(focus(), key, modifiers); }
  /// Replaces all text of the focused editor, key by key.
  void write(const char* key, const char* typed) {
    QCoreApplication::processEvents();  // a form that is to come is there
    click(editor(key));
    press(Qt::Key_A, Qt::ControlModifier);
    for (const char c : std::string(typed)) {
      if (c == '\n')
        press(Qt::Key_Return);
      else
        QTest::keyClick(focus(), c);
    }
  }

  TemporaryFolder folder;
  const scenario::Program program = fake_program();
  gui::MainWindow window{program};
};

}  // namespace dobra::test
