#include "shared/gui/vertices/vertex_panel.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <map>
#include <utility>

#include "shared/canvas/line_edit.h"
#include "shared/gui/vertices/rows.h"
#include "shared/gui/words/words.h"

namespace dobra::gui::vertices {

namespace {

constexpr std::size_t most_in_list = 2000;      ///< Lines that the list names; more are chosen on the canvas.
constexpr std::size_t most_chosen_rows = 5000;  ///< Vertices of the canvas that are marked in the table.

QString text_of(const std::string& source) { return QString::fromStdString(source); }

geom::Polyline with_points(const geom::Polyline& line, std::vector<geom::Point> points) {
  return {std::move(points), line.closed};
}

}  // namespace

VertexPanel::VertexPanel(QWidget* parent)
    : QWidget(parent),
      model_(this),
      lines_(new QComboBox(this)),
      reason_(new QLabel(this)),
      table_(new QTableView(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->setSpacing(4);
  lines_->setAccessibleName(text("Line"));
  lines_->setObjectName("vertices.line");
  lines_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  lines_->setMinimumContentsLength(8);
  reason_->setWordWrap(true);
  reason_->setObjectName("vertices.reason");
  reason_->hide();
  table_->setModel(&model_);
  table_->setObjectName("vertices.table");
  table_->setAccessibleName(text("Vertices"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().lineSpacing() + 6);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->horizontalHeader()->setHighlightSections(false);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(2);
  const auto add = [&](const QString& words, const char* name, const QKeySequence& keys, auto slot) {
    QToolButton* made = button(words, name, keys);
    connect(made, &QToolButton::clicked, this, slot);
    buttons->addWidget(made);
    return made;
  };
  editing_ = {add(text("Insert"), "insert", QKeySequence(Qt::Key_Insert), &VertexPanel::insert),
              add(text("Delete"), "delete", QKeySequence(Qt::Key_Delete), &VertexPanel::remove),
              add(text("Paste"), "paste", QKeySequence::Paste, &VertexPanel::paste)};
  add(text("Copy"), "copy", QKeySequence::Copy, &VertexPanel::copy);
  buttons->addStretch(1);
  column->addWidget(lines_);
  column->addWidget(reason_);
  column->addWidget(table_, 1);
  column->addLayout(buttons);
  connect(lines_, &QComboBox::activated, this, &VertexPanel::choose_line);
  connect(&model_, &VertexModel::move_asked, this, &VertexPanel::move);
  connect(&model_, &VertexModel::refused, this, &VertexPanel::told);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &VertexPanel::tell_selection);
}

QToolButton* VertexPanel::button(const QString& words, const char* name, const QKeySequence& keys) {
  auto* made = new QToolButton(this);
  made->setText(words);
  made->setObjectName(QString("vertices.") + name);
  made->setToolTip(QString("%1 (%2)").arg(words, keys.toString(QKeySequence::NativeText)));
  made->setAccessibleName(text("Vertices") + ": " + words);
  made->setFocusPolicy(Qt::StrongFocus);
  auto* action = new QAction(table_);
  action->setShortcut(keys);
  action->setShortcutContext(Qt::WidgetShortcut);  // in the table; an open cell keeps its own keys
  connect(action, &QAction::triggered, made, &QToolButton::click);
  table_->addAction(action);
  return made;
}

void VertexPanel::show(const canvas::Workspace& work, const QString& unit, const QString& height) {
  work_ = &work;
  model_.set_axes(unit, height);
  stale_ = true;
  if (isVisible()) fill();
}

void VertexPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_) fill();
}

void VertexPanel::fill() {
  stale_ = false;
  if (work_ == nullptr) return;
  filling_ = true;
  if (!work_->selection.empty()) own_.reset();
  fill_lines();
  show_lines();
  show_rows();
  filling_ = false;
}

void VertexPanel::fill_lines() {
  lines_->clear();
  picks_.clear();
  if (work_->empty()) return;
  const auto all = work_->lines();
  std::map<std::string, std::size_t> lines_of_layer;
  for (const auto& [pick, line] : all) ++lines_of_layer[pick.layer];
  QStringList titles;
  for (const auto& [pick, line] : all) {
    if (picks_.size() == most_in_list) break;
    picks_.push_back(pick);
    const QString name = text_of(work_->name(pick));
    const bool own = lines_of_layer[pick.layer] == 1 || name != text_of(work_->title(pick));
    titles << (own ? name : QString("%1, %2").arg(name).arg(pick.id + 1));
  }
  const std::size_t chosen = own_ ? 1 : work_->selection.size();
  lines_->addItem(chosen > 1 ? text("%1 lines").arg(chosen) : text("No line is selected"));
  lines_->addItems(titles);
  if (chosen != 1) return;
  const scene::Pick pick = own_ ? *own_ : work_->selection.begin()->first;
  const auto at = std::find(picks_.begin(), picks_.end(), pick);
  if (at != picks_.end()) lines_->setCurrentIndex(static_cast<int>(at - picks_.begin()) + 1);
}

void VertexPanel::show_lines() {
  std::vector<TableLine> shown;
  const auto add = [&](const scene::Pick& pick) {
    const geom::Polyline* line = work_->empty() ? nullptr : work_->line(pick);
    if (line != nullptr) shown.push_back({pick, text_of(work_->name(pick)), *line, work_->is_editable(pick)});
  };
  if (own_) add(*own_);
  if (own_ && shown.empty()) own_.reset();
  for (const auto& [pick, vertices] : work_->selection) {
    if (!own_) add(pick);
  }
  const bool fixed =
      !shown.empty() && std::none_of(shown.begin(), shown.end(), [](const auto& l) { return l.editable; });
  reason_->setText(fixed ? text_of(canvas::made_by_a_step()) : QString());
  reason_->setVisible(fixed);
  for (QToolButton* each : editing_) each->setEnabled(!shown.empty() && !fixed);
  model_.show(std::move(shown));
}

void VertexPanel::show_rows() {
  QItemSelection rows;
  std::size_t count = 0;
  int first = -1;
  for (std::size_t l = 0; l < model_.lines().size(); ++l) {
    const auto found = work_->selection.find(model_.lines()[l].pick);
    if (found == work_->selection.end()) continue;
    for (const std::size_t vertex : found->second) {
      if (vertex >= model_.lines()[l].line.points.size() || ++count > most_chosen_rows) break;
      const int row = model_.row_of({l, vertex});
      if (first < 0) first = row;
      // Neighbours are one range: a thousand rows are not a thousand ranges.
      if (!rows.isEmpty() && rows.back().bottom() == row - 1)
        rows.back() =
            QItemSelectionRange(model_.index(rows.back().top(), 0), model_.index(row, model_.columnCount() - 1));
      else
        rows.append(QItemSelectionRange(model_.index(row, 0), model_.index(row, model_.columnCount() - 1)));
    }
  }
  table_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
  if (first >= 0 && !table_->hasFocus()) table_->scrollTo(model_.index(first, 0));
}

void VertexPanel::tell_selection() {
  if (filling_ || work_ == nullptr || own_) return;
  canvas::Selection selection;
  for (const TableLine& line : model_.lines()) selection[line.pick];
  for (const QItemSelectionRange& range : table_->selectionModel()->selection()) {
    for (int row = range.top(); row <= range.bottom(); ++row) {
      const VertexRow where = model_.at(row);
      selection[model_.lines()[where.line].pick].insert(where.vertex);
    }
  }
  emit selected(selection);
}

void VertexPanel::choose_line(int index) {
  if (work_ == nullptr || index < 1 || static_cast<std::size_t>(index) > picks_.size()) return;
  const scene::Pick pick = picks_[static_cast<std::size_t>(index) - 1];
  own_.reset();
  if (!work_->is_editable(pick)) {
    own_ = pick;
    emit selected({});
  } else {
    emit selected({{pick, {}}});
  }
  fill();
}

std::vector<int> VertexPanel::chosen_rows() const {
  std::vector<int> rows;
  for (const QItemSelectionRange& range : table_->selectionModel()->selection()) {
    for (int row = range.top(); row <= range.bottom(); ++row) rows.push_back(row);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

void VertexPanel::move(int row, geom::Point to) {
  const VertexRow where = model_.at(row);
  const geom::Point from = model_.point(row);
  canvas::Edited edited{{}, text("Move vertex").toStdString(), canvas::Stage::Done};
  // As when it is dragged: vertices of other lines at the same place go along.
  for (const auto& [pick, vertex] : work_->vertices_at(from)) {
    const bool own = pick == model_.lines()[where.line].pick;
    if (own && vertex != where.vertex) continue;
    if (edited.lines.empty() || edited.lines.back().pick != pick) edited.lines.push_back({pick, {*work_->line(pick)}});
    edited.lines.back().becomes.front().points[vertex] = to;
  }
  emit this->edited(edited);
}

const TableLine* VertexPanel::line_in_hand(VertexRow& where) {
  if (model_.rowCount() == 0) return nullptr;
  const QModelIndex current = table_->currentIndex();
  where = model_.at(current.isValid() ? current.row() : model_.rowCount() - 1);
  const TableLine& line = model_.lines()[where.line];
  if (line.editable) return &line;
  emit told(text_of(canvas::made_by_a_step()));
  return nullptr;
}

void VertexPanel::change(const scene::Pick& pick, geom::Polyline line, const QString& what) {
  emit edited({{{pick, {std::move(line)}}}, what.toStdString(), canvas::Stage::Done});
}

void VertexPanel::insert() {
  VertexRow where;
  const TableLine* line = line_in_hand(where);
  if (line == nullptr) return;
  std::vector<geom::Point> points = line->line.points;
  const std::size_t n = points.size();
  const std::size_t i = where.vertex;
  // Halfway to the next one; behind the last as far again as from the one before.
  geom::Point at = points[i] + geom::Vector{1.0, 0.0};
  if (i + 1 < n || line->line.closed)
    at = geom::interpolate(points[i], points[(i + 1) % n], 0.5);
  else if (n > 1)
    at = points[i] + (points[i] - points[i - 1]);
  points.insert(points.begin() + static_cast<std::ptrdiff_t>(i) + 1, at);
  const scene::Pick pick = line->pick;
  change(pick, with_points(line->line, std::move(points)), text("Insert vertex"));
}

void VertexPanel::remove() {
  std::map<std::size_t, std::set<std::size_t>> gone;
  for (const int row : chosen_rows()) {
    const VertexRow where = model_.at(row);
    gone[where.line].insert(where.vertex);
  }
  if (gone.empty()) return emit told(text("Select the rows that are to go."));
  canvas::Edited edited{{}, text("Delete vertices").toStdString(), canvas::Stage::Done};
  for (const auto& [l, vertices] : gone) {
    const TableLine& line = model_.lines()[l];
    if (!line.editable) return emit told(text_of(canvas::made_by_a_step()));
    const base::Result<geom::Polyline> left = canvas::without_vertices(line.line, vertices);
    if (!left) return emit told(text_of(left.error().message));
    edited.lines.push_back({line.pick, {*left}});
  }
  emit this->edited(edited);
}

void VertexPanel::copy() {
  std::vector<int> rows = chosen_rows();
  std::vector<geom::Point> points;
  for (const int row : rows) points.push_back(model_.point(row));
  for (int row = 0; rows.empty() && row < model_.rowCount(); ++row) points.push_back(model_.point(row));
  if (!points.empty()) QApplication::clipboard()->setText(rows_of_points(points));
}

void VertexPanel::paste() {
  VertexRow where;
  const TableLine* line = line_in_hand(where);
  if (line == nullptr) return;
  const base::Result<std::vector<geom::Point>> pasted = points_of_rows(QApplication::clipboard()->text());
  if (!pasted) return emit told(text_of(pasted.error().message));
  std::vector<geom::Point> points = line->line.points;
  // As in a spreadsheet: over the rows from here on, and on behind the last.
  for (std::size_t i = 0; i < pasted->size(); ++i) {
    if (where.vertex + i < points.size())
      points[where.vertex + i] = (*pasted)[i];
    else
      points.push_back((*pasted)[i]);
  }
  const scene::Pick pick = line->pick;
  change(pick, with_points(line->line, std::move(points)), text("Paste vertices"));
}

}  // namespace dobra::gui::vertices
