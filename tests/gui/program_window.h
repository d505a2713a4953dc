#pragma once
// A program's window among copies of the examples, with what a person does to it.

#include <gtest/gtest.h>

#include <QApplication>
#include <QDockWidget>
#include <QSettings>
#include <QTest>
#include <QTreeWidget>
#include <fstream>

#include "shared/gui/canvas.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/main_window.h"
#include "shared/gui/parameter_form.h"
#include "shared/gui/vtk_widget.h"
#include "tests/gui/examples_folder.h"

namespace dobra::test {

class ProgramWindow {
 public:
  /// @param document  "recon/fold.toml"
  explicit ProgramWindow(std::string document) : document_(std::move(document)) {
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    for (const char* name : {"recon", "quebra"})
      QSettings(QSettings::IniFormat, QSettings::UserScope, "Dobra", name).clear();
    window_ = std::make_unique<gui::MainWindow>(program_of(document_), part_of(document_));
    window_->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window_.get(), 20000));
  }
  ~ProgramWindow() { window_->session().cancel(); }
  gui::MainWindow* operator->() { return window_.get(); }
  gui::MainWindow& operator*() { return *window_; }

  void open() { open(examples_.file(document_)); }
  void open(const std::filesystem::path& file) {
    ASSERT_TRUE(window_->open(file).ok());
    come_to_rest();
  }
  /// Beside the examples.
  std::filesystem::path write(const std::string& name, const std::string& text) {
    const std::filesystem::path file = examples_.file(document_).parent_path() / name;
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }
  void come_to_rest() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !window_->session().busy(); }, 120000));
    QCoreApplication::processEvents();
  }
  [[nodiscard]] const scenario::Document& document() { return window_->session().document(); }
  std::string text() { return scenario::document_text(document()); }

  void focus() {
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get(), 5000));
    window_->view().setFocus();
    QCoreApplication::processEvents();
  }
  QWidget* focused() { return QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : window_.get(); }
  void press(Qt::Key key, Qt::KeyboardModifiers held = {}) { QTest::keyClick(focused(), key, held); }
  void write_keys(const char* typed) {
    for (const char c : std::string(typed)) QTest::keyClick(focused(), c);
  }
  std::size_t panel(const std::string& key) {
    const auto& panels = window_->session().outcome()->picture->panels;
    const auto found = std::find_if(panels.begin(), panels.end(), [&](const auto& each) { return each.key == key; });
    EXPECT_NE(found, panels.end()) << key;
    return static_cast<std::size_t>(found - panels.begin());
  }
  QPointF pixel(std::size_t panel, geom::Point at) { return window_->view().pixel_of(panel, at); }
  void move(QPointF at, Qt::MouseButton held = Qt::NoButton) {
    QMouseEvent event(QEvent::MouseMove, at, window_->view().mapToGlobal(at), Qt::NoButton, held, {});
    QCoreApplication::sendEvent(&window_->view(), &event);
  }
  void hold(QPointF at, Qt::KeyboardModifiers keys = {}) {
    move(at);
    QTest::mousePress(&window_->view(), Qt::LeftButton, keys, at.toPoint());
  }
  void let_go(QPointF at, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseRelease(&window_->view(), Qt::LeftButton, keys, at.toPoint());
  }
  void click(QPointF at, Qt::KeyboardModifiers keys = {}) {
    hold(at, keys);
    let_go(at, keys);
  }
  /// The tree of a panel, in front of its neighbours.
  QTreeWidget* rows(const char* dock) {
    auto* panel = window_->findChild<QDockWidget*>(QString("dock.") + dock);
    if (panel == nullptr) return nullptr;
    panel->show();
    panel->raise();
    QCoreApplication::processEvents();
    return panel->findChild<QTreeWidget*>();
  }
  void click_row(QTreeWidget& tree, QTreeWidgetItem& row) {
    tree.scrollToItem(&row);
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, tree.visualItemRect(&row).center());
    QCoreApplication::processEvents();
  }

 private:
  ExamplesFolder examples_;
  std::string document_;
  std::unique_ptr<gui::MainWindow> window_;
};

}  // namespace dobra::test
