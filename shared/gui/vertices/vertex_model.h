#pragma once
// The vertices of lines as a table: nothing is kept a row, so that a line of 200 000 vertices opens at once. A cell
// that is typed into tells what is wanted; the table shows it when the document has it.

#include <QAbstractTableModel>
#include <span>
#include <vector>

#include "shared/canvas/workspace.h"

namespace dobra::gui::vertices {

/// A line of the picture, in its coordinates.
struct TableLine {
  scene::Pick pick;
  QString title;
  geom::Polyline line;
  bool editable = true;
};

/// A vertex of one of the lines.
struct VertexRow {
  std::size_t line = 0;
  std::size_t vertex = 0;
  bool operator==(const VertexRow&) const = default;
};

class VertexModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Number, X, Z, Line };

  using QAbstractTableModel::QAbstractTableModel;

  /// The rows of these lines, one line after the other. Views keep their place where the lines are those of before and
  /// as long. @cost O(lines)
  void show(std::vector<TableLine> lines);
  /// "m": of both columns.
  void set_axes(const QString& unit, const QString& height);

  [[nodiscard]] const std::vector<TableLine>& lines() const { return lines_; }
  /// @pre row < rowCount(). @cost O(log lines)
  [[nodiscard]] VertexRow at(int row) const;
  [[nodiscard]] int row_of(const VertexRow& vertex) const;
  [[nodiscard]] geom::Point point(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Emits what was asked for; changes nothing.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 signals:
  void move_asked(int row, dobra::geom::Point to);
  /// What was typed is no coordinate.
  void refused(const QString& why);

 private:
  std::vector<TableLine> lines_;
  std::vector<int> first_;  ///< Row of the first vertex of each line.
  int rows_ = 0;
  QString unit_;
  QString height_ = "z";  ///< What the second coordinate is called.
};

}  // namespace dobra::gui::vertices
