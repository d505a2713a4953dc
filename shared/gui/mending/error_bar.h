#pragma once
// One line over the view that says what went wrong, until it is right or closed. It never blocks.

#include <QFrame>
#include <optional>

#include "shared/base/error.h"

class QLabel;
class QToolButton;

namespace dobra::gui::mending {

class ErrorBar : public QFrame {
  Q_OBJECT

 public:
  explicit ErrorBar(QWidget* parent = nullptr);

  enum class CanShow { Yes, No };
  /// @param can_show  whether there is a place, step or field to go to.
  void say(const QString& message, CanShow can_show);
  void clear() { hide(); }
  /// Those of the palette of the application, once that is another: a style sheet does not follow it.
  void take_colors();
  /// What is said now; empty if nothing is.
  [[nodiscard]] QString message() const;

 signals:
  void show_asked();

 private:
  QLabel* words_;
  QToolButton* show_;
};

}  // namespace dobra::gui::mending
