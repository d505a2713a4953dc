#pragma once
// Labels that show as much of their words as there is room for, and the whole under the pointer.

#include <QLabel>

namespace dobra::gui::labels {

/// One line, which takes what room there is; an ellipsis stands for what is cut off.
class Line : public QLabel {
 public:
  using QLabel::QLabel;
  [[nodiscard]] QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }
  /// The tool tip is the whole text.
  void say(const QString& words);
  [[nodiscard]] bool is_cut() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// A paragraph; whole words fall away at its end.
class Paragraph : public QLabel {
 public:
  explicit Paragraph(QWidget* parent = nullptr);
  void say(const QString& words);
  [[nodiscard]] const QString& words() const { return words_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();

  QString words_;
};

}  // namespace dobra::gui::labels
