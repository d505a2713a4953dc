#include "shared/gui/tables_editor.h"

#include <QApplication>
#include <QFrame>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "shared/base/check.h"
#include "shared/gui/parameter_form.h"
#include "shared/gui/text.h"

namespace dobra::gui {

using scenario::Table;

namespace {

constexpr std::size_t opened_at_first = 1;  ///< With more tables than this, each starts closed.

/// The first text in a table: what a reader would call it.
QString name_of(const Table& table) {
  const scenario::Value* name = table.find("name");
  if (name == nullptr && !table.empty()) name = &table.entries().front().value;
  const auto* words = name != nullptr ? std::get_if<std::string>(name) : nullptr;
  return words != nullptr ? QString::fromStdString(*words) : QString();
}

}  // namespace

TablesEditor::TablesEditor(scenario::Field field, std::filesystem::path folder, QWidget* parent)
    : QWidget(parent), field_(std::move(field)), folder_(std::move(folder)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  list_ = new QVBoxLayout;
  list_->setSpacing(4);
  column->addLayout(list_);
  auto* add = new QToolButton(this);
  add->setText(text("Add"));
  add->setAccessibleName(text(field_.options.title) + ": " + text("Add"));
  add->setObjectName("add." + QString::fromStdString(field_.key));
  column->addWidget(add, 0, Qt::AlignLeft);
  connect(add, &QToolButton::clicked, this, [this] {
    add_item();
    retitle(items_.size() - 1);
    items_.back().header->setChecked(true);
    emit entered(tables(), {});
  });
}

void TablesEditor::show_tables(const std::vector<Table>& tables) {
  const bool first_time = items_.empty();
  while (items_.size() > tables.size()) {
    items_.back().frame->deleteLater();
    items_.pop_back();
  }
  const std::size_t before = items_.size();
  while (items_.size() < tables.size()) add_item();
  for (std::size_t i = 0; i < tables.size(); ++i) {
    items_[i].table = tables[i];
    if (items_[i].form != nullptr) items_[i].form->set_table(tables[i]);
    retitle(i);
  }
  if (items_.size() == before) return;
  if (!first_time)
    open_by_itself(items_.size() - 1);
  else if (tables.size() <= opened_at_first)
    items_.back().header->setChecked(true);
}

/// Only the newest is open by itself: a form costs a hundred widgets, and hundreds of lines can be drawn.
void TablesEditor::open_by_itself(std::size_t index) {
  for (Item& item : items_) {
    const bool in_use = item.form != nullptr && item.form->isAncestorOf(QApplication::focusWidget());
    if (in_use) item.by_itself = false;
    if (!std::exchange(item.by_itself, false)) continue;
    item.header->setChecked(false);
    item.form->deleteLater();
    item.form = nullptr;
  }
  items_[index].header->setChecked(true);
  items_[index].by_itself = true;
}

void TablesEditor::canvas_answers() {
  canvas_answers_ = true;
  for (TableForm* form : made_forms()) form->canvas_answers();
}

std::vector<TableForm*> TablesEditor::made_forms() const {
  std::vector<TableForm*> forms;
  for (const Item& item : items_) {
    if (item.form != nullptr) forms.push_back(item.form);
  }
  return forms;
}

TableForm& TablesEditor::open(std::size_t index) {
  DOBRA_CHECK(index < items_.size());
  items_[index].header->setChecked(true);
  return form(index);
}

TableForm& TablesEditor::form(std::size_t index) {
  DOBRA_CHECK(index < items_.size());
  Item& item = items_[index];
  if (item.form != nullptr) return *item.form;
  auto* form = new TableForm(field_.fields, folder_, item.frame);
  item.form = form;
  form->set_table(item.table);
  form->setVisible(item.header->isChecked());
  if (canvas_answers_) form->canvas_answers();
  item.frame->layout()->addWidget(form);
  connect(form, &TableForm::wants_to_be_seen, this, &TablesEditor::wants_to_be_seen);
  connect(form, &TableForm::pointing_asked, this, &TablesEditor::pointing_asked);
  connect(form, &TableForm::edited, this, [this, frame = item.frame](const Table& table, const QString& key) {
    const std::size_t i = position_of(frame);
    items_[i].by_itself = false;
    items_[i].table = table;
    retitle(i);
    emit entered(tables(), QString::number(i + 1) + "." + key);
  });
  emit form_made(form);
  return *form;
}

std::size_t TablesEditor::position_of(const QWidget* frame) const {
  const auto found = std::find_if(items_.begin(), items_.end(), [&](const Item& item) { return item.frame == frame; });
  DOBRA_CHECK(found != items_.end());
  return static_cast<std::size_t>(found - items_.begin());
}

void TablesEditor::add_item() {
  auto* frame = new QFrame(this);
  frame->setFrameShape(QFrame::StyledPanel);
  auto* column = new QVBoxLayout(frame);
  column->setContentsMargins(4, 2, 4, 4);
  column->setSpacing(2);
  auto* header = new QToolButton(frame);
  header->setCheckable(true);
  header->setAutoRaise(true);
  header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  header->setArrowType(Qt::RightArrow);
  header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* remove = new QToolButton(frame);
  remove->setText(QString::fromUtf8("✕"));
  remove->setAutoRaise(true);
  remove->setToolTip(text("Remove"));
  auto* top = new QHBoxLayout;
  top->addWidget(header, 1);
  top->addWidget(remove);
  column->addLayout(top);
  list_->addWidget(frame);
  items_.push_back({frame, header, remove, {}, nullptr});
  connect(header, &QToolButton::toggled, this, [this, header, frame](bool open) {
    header->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    const std::size_t i = position_of(frame);
    if (open || items_[i].form != nullptr) form(i).setVisible(open);
  });
  connect(header, &QToolButton::clicked, this, [this, frame] { items_[position_of(frame)].by_itself = false; });
  connect(remove, &QToolButton::clicked, this, [this, frame] { remove_item(position_of(frame)); });
}

void TablesEditor::remove_item(std::size_t index) {
  items_[index].frame->deleteLater();
  items_.erase(items_.begin() + static_cast<std::ptrdiff_t>(index));
  for (std::size_t i = 0; i < items_.size(); ++i) retitle(i);
  emit entered(tables(), {});
}

void TablesEditor::retitle(std::size_t index) {
  const QString name = name_of(items_[index].table);
  const QString number = QString::number(index + 1);
  const QString title = name.isEmpty() ? number : number + QString::fromUtf8(" · ") + name;
  if (items_[index].header->text() == title) return;
  items_[index].header->setText(title);
  const QString heard = text(field_.options.title) + " " + title;
  items_[index].header->setAccessibleName(heard);
  items_[index].remove->setAccessibleName(heard + ": " + text("Remove"));
}

std::vector<Table> TablesEditor::tables() const {
  std::vector<Table> all;
  for (const Item& item : items_) all.push_back(item.table);
  return all;
}

}  // namespace dobra::gui
