#pragma once
// What a run found: a tree of quantities ("horizon.top" over "length_before"), the verdicts on the document's
// expectations, and remarks to the user.

#include <QWidget>

#include "shared/gui/documents/worker.h"

class QLabel;
class QTreeWidget;

namespace dobra::gui {

class Results : public QWidget {
  Q_OBJECT

 public:
  explicit Results(QWidget* parent = nullptr);

  void show_outcome(const documents::Outcome& outcome);
  void clear();

 private:
  QTreeWidget* quantities_;
  QLabel* remarks_;
};

/// A number as a reader wants it: six significant digits.
QString readable(double value);

}  // namespace dobra::gui
