#pragma once
// One line over the view: the lines of a file have become the document's own, and where they are to be saved. It never
// blocks.

#include <QFrame>
#include <string>
#include <vector>

#include "shared/scenario/document.h"

class QLabel;
class QPushButton;

namespace dobra::gui::importing {

class TakenInBar : public QFrame {
  Q_OBJECT

 public:
  explicit TakenInBar(QWidget* parent = nullptr);

  /// @param files  whose lines `document` holds now.
  void say(const std::vector<std::string>& files, const scenario::Document& document);
  /// What is said now; empty if nothing is.
  [[nodiscard]] QString message() const;

 signals:
  /// The lines are to be saved in a file beside the document.
  void beside_asked();
  void undo_asked();

 private:
  QLabel* words_;
  QPushButton* beside_;
};

}  // namespace dobra::gui::importing
