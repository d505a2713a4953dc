#pragma once
// A list of all that can be done, filtered as one types, over the upper part of a window. Enter does what is marked,
// Escape and a click elsewhere close it, and the focus goes back to where it was.

#include <QFrame>
#include <QPointer>

#include "shared/gui/actions/find.h"

class QLabel;
class QLineEdit;
class QTreeWidget;

namespace dobra::gui::actions {

class Palette : public QFrame {
  Q_OBJECT

 public:
  /// Hidden until `open`.
  explicit Palette(QWidget& window);

  void open(std::vector<Choice> choices);
  /// The titles that are listed now, in order.
  [[nodiscard]] QStringList listed() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void filter(const QString& typed);
  void move_by(int rows);
  void choose();
  void close_list();
  void place();

  QWidget& window_;
  QLineEdit* typed_;
  QTreeWidget* list_;
  std::vector<Choice> choices_;
  QLabel* nothing_;                 ///< Said where nothing is found.
  std::vector<std::size_t> shown_;  ///< Of the choices, row by row.
  QPointer<QWidget> focus_before_;
};

}  // namespace dobra::gui::actions
