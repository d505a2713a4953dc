#pragma once
// The vertical exaggeration of the view, to choose or to type.

#include <QComboBox>
#include <array>
#include <optional>

namespace dobra::gui::view {

inline constexpr std::array usual_exaggerations{1.0, 2.0, 5.0, 10.0};

/// "VE 1×", "VE 5×" or what is typed.
class ExaggerationBox : public QComboBox {
  Q_OBJECT

 public:
  explicit ExaggerationBox(QWidget* parent);
  /// @param drawn  what the picture has, where that is not told by `exaggeration`.
  void show_value(const std::optional<double>& exaggeration, double drawn);

 signals:
  void chosen(const std::optional<double>& exaggeration);
  void refused(const QString& why);

 protected:
  void focusOutEvent(QFocusEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void take(const QString& typed);
  QString shown_;
};

}  // namespace dobra::gui::view
