#include "shared/gui/vertices/vertex_model.h"

#include <algorithm>

#include "shared/gui/vertices/rows.h"
#include "shared/gui/words/words.h"

namespace dobra::gui::vertices {

namespace {

bool same_rows(const std::vector<TableLine>& a, const std::vector<TableLine>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const TableLine& one, const TableLine& other) {
    return one.pick == other.pick && one.editable == other.editable && one.title == other.title &&
           one.line.points.size() == other.line.points.size();
  });
}

}  // namespace

void VertexModel::show(std::vector<TableLine> lines) {
  if (same_rows(lines_, lines)) {
    lines_ = std::move(lines);
    if (rows_ > 0) emit dataChanged(index(0, 0), index(rows_ - 1, columnCount() - 1));
    return;
  }
  beginResetModel();
  lines_ = std::move(lines);
  first_.clear();
  rows_ = 0;
  for (const TableLine& line : lines_) {
    first_.push_back(rows_);
    rows_ += static_cast<int>(line.line.points.size());
  }
  endResetModel();
}

void VertexModel::set_axes(const QString& unit, const QString& height) {
  if (unit == unit_ && height == height_) return;
  unit_ = unit;
  height_ = height;
  emit headerDataChanged(Qt::Horizontal, X, Z);
}

VertexRow VertexModel::at(int row) const {
  const auto after = std::upper_bound(first_.begin(), first_.end(), row);
  const auto line = static_cast<std::size_t>(after - first_.begin() - 1);
  return {line, static_cast<std::size_t>(row - first_[line])};
}

int VertexModel::row_of(const VertexRow& vertex) const { return first_[vertex.line] + static_cast<int>(vertex.vertex); }

geom::Point VertexModel::point(int row) const {
  const VertexRow where = at(row);
  return lines_[where.line].line.points[where.vertex];
}

int VertexModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : rows_; }

int VertexModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : lines_.size() > 1 ? Line + 1 : Z + 1;
}

QVariant VertexModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rows_) return {};
  const VertexRow where = at(index.row());
  const TableLine& line = lines_[where.line];
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>(Qt::AlignVCenter | (index.column() == Line ? Qt::AlignLeft : Qt::AlignRight));
  if (role != Qt::DisplayRole && role != Qt::EditRole) return {};
  const geom::Point p = line.line.points[where.vertex];
  switch (index.column()) {
    case Number:
      return static_cast<qulonglong>(where.vertex + 1);
    case X:
      return cell_text(p.x);
    case Z:
      return cell_text(p.y);
    default:
      return line.title;
  }
}

QVariant VertexModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const QString unit = unit_.isEmpty() ? QString() : " [" + unit_ + "]";
  switch (section) {
    case Number:
      return text("No.");
    case X:
      return "x" + unit;
    case Z:
      return height_ + unit;
    default:
      return text("Line");
  }
}

Qt::ItemFlags VertexModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled | Qt::ItemNeverHasChildren;
  if (!index.isValid() || index.row() >= rows_) return flags;
  const bool coordinate = index.column() == X || index.column() == Z;
  if (coordinate && lines_[at(index.row()).line].editable) flags |= Qt::ItemIsEditable;
  return flags;
}

bool VertexModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable)) return false;
  const std::optional<double> number = cell_value(value.toString());
  if (!number) {
    emit refused(text("'%1' is not a number").arg(value.toString()));
    return false;
  }
  geom::Point to = point(index.row());
  (index.column() == X ? to.x : to.y) = *number;
  if (to != point(index.row())) emit move_asked(index.row(), to);
  return false;  // the document has not said so yet
}

}  // namespace dobra::gui::vertices
