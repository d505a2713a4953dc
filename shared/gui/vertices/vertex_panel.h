#pragma once
// The list of vertices: of the lines that are selected on the canvas, or of one that is chosen here. What is typed,
// inserted, deleted and pasted goes out as changes of lines, each one step of undo. Page: docs/user/canvas.md.

#include <QWidget>

#include "shared/canvas/tool.h"
#include "shared/gui/vertices/vertex_model.h"

class QComboBox;
class QLabel;
class QTableView;
class QToolButton;

namespace dobra::gui::vertices {

class VertexPanel : public QWidget {
  Q_OBJECT

 public:
  explicit VertexPanel(QWidget* parent = nullptr);

  /// The lines that can be chosen, and the vertices of those that are selected. What this panel is told while it is not
  /// seen it reads when it is.
  /// @pre `work` outlives the panel
  void show(const canvas::Workspace& work, const QString& unit, const QString& height);

  [[nodiscard]] VertexModel& model() { return model_; }
  [[nodiscard]] QTableView& table() { return *table_; }

 signals:
  void edited(const dobra::canvas::Edited& edited);
  /// Lines and vertices chosen here.
  void selected(const dobra::canvas::Selection& selection);
  void told(const QString& message);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void fill();
  void fill_lines();
  void show_lines();
  void show_rows();
  void tell_selection();
  void choose_line(int index);
  void move(int row, geom::Point to);
  void insert();
  void remove();
  void copy();
  void paste();
  [[nodiscard]] std::vector<int> chosen_rows() const;
  /// The line of the row that has the cursor, if it can be edited; else says why it cannot.
  [[nodiscard]] const TableLine* line_in_hand(VertexRow& where);
  void change(const scene::Pick& pick, geom::Polyline line, const QString& what);
  [[nodiscard]] QToolButton* button(const QString& words, const char* name, const QKeySequence& keys);

  const canvas::Workspace* work_ = nullptr;
  VertexModel model_;
  QComboBox* lines_;
  QLabel* reason_;  ///< Why nothing can be changed here.
  QTableView* table_;
  std::vector<QToolButton*> editing_;
  std::vector<scene::Pick> picks_;  ///< Of the entries of `lines_`, but the first.
  std::optional<scene::Pick> own_;  ///< Chosen here, and not on the canvas: a line that cannot be edited.
  bool stale_ = false;
  bool filling_ = false;
};

}  // namespace dobra::gui::vertices
