#pragma once
// What became of every bed and unit, between any two states of the chain. Page: docs/user/restore.md

#include <QWidget>

#include "recon/model/chain.h"
#include "shared/gui/window_part.h"

class QComboBox;
class QLabel;
class QTreeWidget;

namespace recon::gui {

/// Lengths of beds and areas of units before and after, those beyond the tolerance marked, with the verdict. The row of
/// a bed selects its lines on the canvas, and the other way round; Enter looks at them.
class BalancePanel : public QWidget {
 public:
  BalancePanel(const dobra::gui::Desk& desk, QWidget* parent);

 protected:
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// Fills the rows once they can be seen.
  void show_outcome();
  void fill();
  void show_states(std::size_t count);
  void show_rows();
  void fit_names();
  enum class Row { Bed, Unit };
  void add_rows(const std::vector<model::Compared>& rows, Row kind, double tolerance);
  /// The lines of the current row's bed.
  void select_lines();
  /// The row of what is selected on the canvas.
  void follow_selection();

  dobra::gui::Desk desk_;
  QComboBox* states_ = nullptr;
  QLabel* verdict_ = nullptr;
  QTreeWidget* rows_ = nullptr;
  bool following_ = false;
  bool stale_ = true;
};

}  // namespace recon::gui
