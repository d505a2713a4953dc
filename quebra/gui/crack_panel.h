#pragma once
// The cracks of the domain, and what the analysis found at their tips. Page: docs/user/analysis.md

#include <QWidget>

#include "shared/gui/window_part.h"

class QComboBox;
class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace quebra::gui {

/// One row a crack with its length and direction, under it its tips with K_I and K_II of a load case. The row of a
/// crack selects it on the canvas, and the other way round; Enter looks at it.
class CrackPanel : public QWidget {
 public:
  CrackPanel(const dobra::gui::Desk& desk, QWidget* parent);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  /// Fills the rows once they can be seen.
  void show_outcome();
  void fill();
  void show_rows();
  void select_crack();
  /// The row of what is selected on the canvas.
  void follow_selection();

  dobra::gui::Desk desk_;
  QComboBox* cases_ = nullptr;
  QLabel* none_ = nullptr;
  QTreeWidget* rows_ = nullptr;
  bool following_ = false;
  bool stale_ = true;
};

}  // namespace quebra::gui
