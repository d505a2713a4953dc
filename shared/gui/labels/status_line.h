#pragma once
// The line at the bottom of the window, a place for each: what the tool waits for; what the last run, or the last
// command, has come to; the run under way; where the cursor is.

#include <QStatusBar>
#include <QTimer>

class QLabel;
class QProgressBar;
class QToolButton;

namespace dobra::gui::labels {

class Line;

class StatusLine : public QStatusBar {
  Q_OBJECT

 public:
  explicit StatusLine(QWidget* parent = nullptr);

  /// Texts that are longer than their places end in "..."; a tool tip has them whole.
  void show_hint(const QString& hint);
  void show_state(const QString& state);
  void show_place(const QString& place);
  /// Of the line under the cursor.
  void show_dip(const QString& dip);

  /// The progress of a run is seen from its third tenth of a second on.
  void begin_run();
  void show_progress(double fraction, const QString& what);
  void end_run();

 signals:
  void cancel_asked();

 private:
  Line* hint_;
  Line* state_;
  QLabel* place_;
  Line* dip_;
  QProgressBar* progress_;
  QToolButton* cancel_;
  QTimer patience_;
};

}  // namespace dobra::gui::labels
