#include "shared/gui/importing/line_list.h"

#include <QColor>
#include <QFont>
#include <algorithm>

#include "shared/gui/words/words.h"

namespace dobra::gui::importing {

QString kind_title(const ImportModel& model, const std::string& kind) {
  for (const auto& known : model.importing().kinds) {
    if (known.name == kind) return text(known.title.c_str());
  }
  return QString::fromStdString(kind);
}

LineList::LineList(ImportModel& model, QObject* parent) : QAbstractTableModel(parent), model_(model) {}

void LineList::show_file(std::size_t file) {
  beginResetModel();
  file_ = file;
  endResetModel();
}

void LineList::refresh() {
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, Columns - 1));
}

int LineList::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || model_.size() == 0 ? 0 : static_cast<int>(model_.choices(file_).size());
}

int LineList::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : Columns; }

QString LineList::words(std::size_t line, int column) const {
  const scenario::ImportLine& read = model_.look(file_).lines[line];
  switch (column) {
    case Name: {
      const QString name = read.name.empty() ? text("(no name)") : QString::fromStdString(read.name);
      return read.parts.size() == 1 ? name : text("%1 (%2 parts)").arg(name).arg(read.parts.size());
    }
    case Kind:
      return kind_title(model_, model_.choices(file_)[line].kind);
    case From:
      switch (model_.kind_from(file_, line)) {
        case KindFrom::File:
          return text("the file");
        case KindFrom::Name:
          return text("guess: its name");
        case KindFrom::Shape:
          return text("guess: its shape");
        case KindFrom::Rule:
          return text("pattern");
        case KindFrom::User:
          return text("chosen");
      }
      return {};
    default: {
      std::size_t points = 0;
      for (const geom::Polyline& part : read.parts) points += part.points.size();
      return QString::number(points);
    }
  }
}

QVariant LineList::data(const QModelIndex& index, int role) const {
  const auto line = static_cast<std::size_t>(index.row());
  const bool guessed =
      model_.kind_from(file_, line) == KindFrom::Name || model_.kind_from(file_, line) == KindFrom::Shape;
  const bool of_kind = index.column() == Kind || index.column() == From;
  if (role == Qt::DisplayRole || role == Qt::AccessibleTextRole) return words(line, index.column());
  if (role == Qt::CheckStateRole && index.column() == Name)
    return model_.choices(file_)[line].taken ? Qt::Checked : Qt::Unchecked;
  if (role == Qt::TextAlignmentRole && index.column() == Points) return {Qt::AlignRight | Qt::AlignVCenter};
  if (role == Qt::ToolTipRole) return words(line, index.column());
  if (role == Qt::FontRole && guessed && of_kind) {
    QFont font;
    font.setItalic(true);
    return font;
  }
  return {};
}

QVariant LineList::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole || orientation == Qt::Vertical) return {};
  switch (section) {
    case Name:
      return text("Line");
    case Kind:
      return text("Kind");
    case From:
      return text("Says who");
    default:
      return text("Points");
  }
}

Qt::ItemFlags LineList::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  if (index.column() == Name) flags |= Qt::ItemIsUserCheckable;
  return flags;
}

bool LineList::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || index.column() != Name) return false;
  model_.take_lines(file_, {static_cast<std::size_t>(index.row())}, value.toInt() == Qt::Checked);
  refresh();
  emit ticked();
  return true;
}

}  // namespace dobra::gui::importing
