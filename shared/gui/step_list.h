#pragma once
// The parts of a document, one a line: the input, then the steps, each with its state; buttons to add, remove and move.

#include <QWidget>

#include "shared/scenario/program.h"

class QAction;
class QListWidget;
class QMenu;
class QToolButton;

namespace dobra::gui {

enum class PartState { Pending, Running, Done, Failed };

class StepList : public QWidget {
  Q_OBJECT

 public:
  explicit StepList(const scenario::Program& program, QWidget* parent = nullptr);

  /// What the buttons do. @pre all outlive the list
  void use(QMenu& add, QAction& remove, QAction& up, QAction& down);
  /// @param states  one for each part: the input and each step.
  void show_document(const scenario::Document& document, const std::vector<PartState>& states);
  /// 0 the input, k step k.
  [[nodiscard]] std::size_t selected() const;
  void select(std::size_t part);
  /// As the list calls it: "2  Offset grid · beds".
  [[nodiscard]] QString title(std::size_t part) const;
  [[nodiscard]] PartState state(std::size_t part) const { return states_.at(part); }

 signals:
  void selected_changed(std::size_t part);
  /// A new step of the operation behind the selected part.
  void add_asked(const std::string& operation);
  void remove_asked(std::size_t step);
  /// Exchange `step` and `step` + 1; the selection follows `selected`.
  void exchange_asked(std::size_t step, std::size_t selected);

 private:
  const scenario::Program& program_;
  QListWidget* list_;
  QToolButton* add_;
  QToolButton* remove_;
  QToolButton* up_;
  QToolButton* down_;
  std::vector<PartState> states_;
};

}  // namespace dobra::gui
