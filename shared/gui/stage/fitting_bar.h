#pragma once
// A bar of buttons with words, or with icons alone where the words have no room; the words are then their tool tips.

#include <QToolBar>

namespace dobra::gui::stage {

class FittingBar : public QToolBar {
  Q_OBJECT

 public:
  FittingBar(const QString& title, QWidget* parent);

 protected:
  bool event(QEvent* event) override;

 private:
  void choose_style();
  /// Of all buttons with their words, pixels.
  [[nodiscard]] int width_of_words() const;
};

}  // namespace dobra::gui::stage
