#pragma once
// What a run found: a tree of quantities ("horizon.top" over "length_before"), the verdicts on the document's
// expectations, and remarks to the user.

#include <QWidget>

#include "shared/gui/documents/worker.h"

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace dobra::gui {

class Results : public QWidget {
  Q_OBJECT

 public:
  explicit Results(QWidget* parent = nullptr);

  /// Remarks call these fields by their titles.
  void name_by(std::vector<scenario::Field> fields) { fields_ = std::move(fields); }
  void show_outcome(const documents::Outcome& outcome);
  void clear();

 private:
  void show_quantities(const std::vector<scenario::Quantity>& quantities);
  void list_names(const std::vector<scenario::Quantity>& quantities);
  void show_remarks(const documents::Outcome& outcome);

  QTreeWidget* quantities_;
  QLabel* remarks_;
  std::vector<scenario::Field> fields_;
  std::vector<std::string> names_;       ///< Of the quantities that are listed, and
  std::vector<QTreeWidgetItem*> lines_;  ///< their lines.
};

}  // namespace dobra::gui
