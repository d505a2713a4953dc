#pragma once
// What a window without a document shows: a new one, files, those of before, and the examples. All of it are buttons,
// in the order of the Tab key.

#include <QScrollArea>
#include <vector>

#include "shared/gui/welcome/examples.h"

class QBoxLayout;
class QVBoxLayout;

namespace dobra::gui::welcome {

class Page : public QScrollArea {
  Q_OBJECT

 public:
  /// @param title, about  of the program, as a user reads them.
  /// @param imports  whether files of other programs can be brought in.
  Page(const QString& title, const QString& about, const std::vector<Example>& examples, bool imports, QWidget* parent);

  /// The latest first; those that are not there any more are said to be missing.
  void show_recent(const QStringList& files);
  /// The keyboard begins at the first button.
  void take_focus();

 signals:
  void new_asked();
  void open_asked();
  void import_asked();
  void example_asked(const std::string& file);
  void recent_asked(const QString& file);
  /// The Escape key.
  void left();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* first_ = nullptr;
  QBoxLayout* columns_ = nullptr;
  QVBoxLayout* recent_ = nullptr;
};

}  // namespace dobra::gui::welcome
