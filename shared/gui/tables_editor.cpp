#include "shared/gui/tables_editor.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

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
  while (items_.size() < tables.size()) {
    add_item();
    items_.back().header->setChecked(!first_time || tables.size() <= opened_at_first);
  }
  for (std::size_t i = 0; i < tables.size(); ++i) {
    items_[i].form->set_table(tables[i]);
    retitle(i);
  }
}

void TablesEditor::canvas_answers() {
  canvas_answers_ = true;
  for (const Item& item : items_) item.form->canvas_answers();
}

TableForm& TablesEditor::open(std::size_t index) {
  DOBRA_CHECK(index < items_.size());
  items_[index].header->setChecked(true);
  return *items_[index].form;
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
  remove->setAccessibleName(text("Remove"));
  auto* top = new QHBoxLayout;
  top->addWidget(header, 1);
  top->addWidget(remove);
  auto* form = new TableForm(field_.fields, folder_, frame);
  form->set_table({});
  form->hide();
  if (canvas_answers_) form->canvas_answers();
  column->addLayout(top);
  column->addWidget(form);
  list_->addWidget(frame);
  items_.push_back({frame, header, form});

  const auto position = [this, form] {
    std::size_t i = 0;
    while (i < items_.size() && items_[i].form != form) ++i;
    return i;
  };
  connect(header, &QToolButton::toggled, this, [header, form](bool open) {
    header->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    form->setVisible(open);
  });
  connect(remove, &QToolButton::clicked, this, [this, position] { remove_item(position()); });
  connect(form, &TableForm::wants_to_be_seen, this, &TablesEditor::wants_to_be_seen);
  connect(form, &TableForm::pointing_asked, this, &TablesEditor::pointing_asked);
  connect(form, &TableForm::edited, this, [this, position](const Table&, const QString& key) {
    const std::size_t i = position();
    retitle(i);
    emit entered(tables(), QString::number(i + 1) + "." + key);
  });
}

void TablesEditor::remove_item(std::size_t index) {
  items_[index].frame->deleteLater();
  items_.erase(items_.begin() + static_cast<std::ptrdiff_t>(index));
  for (std::size_t i = 0; i < items_.size(); ++i) retitle(i);
  emit entered(tables(), {});
}

void TablesEditor::retitle(std::size_t index) {
  const QString name = name_of(items_[index].form->table());
  const QString number = QString::number(index + 1);
  const QString title = name.isEmpty() ? number : number + QString::fromUtf8(" · ") + name;
  items_[index].header->setText(title);
  items_[index].header->setAccessibleName(text(field_.options.title) + " " + title);
}

std::vector<Table> TablesEditor::tables() const {
  std::vector<Table> all;
  for (const Item& item : items_) all.push_back(item.form->table());
  return all;
}

}  // namespace dobra::gui
