#include "shared/gui/step_list.h"

#include <QAction>
#include <QHBoxLayout>
#include <QListWidget>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "shared/gui/text.h"
#include "shared/gui/theme/icons.h"

namespace dobra::gui {

namespace {

theme::Symbol symbol_of(PartState state) {
  switch (state) {
    case PartState::Pending:
      return theme::Symbol::Pending;
    case PartState::Running:
      return theme::Symbol::Running;
    case PartState::Done:
      return theme::Symbol::Done;
    case PartState::Failed:
      return theme::Symbol::Failed;
  }
  return theme::Symbol::Pending;
}

QString words_of(PartState state) {
  switch (state) {
    case PartState::Pending:
      return text("not run");
    case PartState::Running:
      return text("running");
    case PartState::Done:
      return text("done");
    case PartState::Failed:
      return text("failed");
  }
  return {};
}

QToolButton* button(theme::Symbol symbol, const QString& tip, const char* name, QWidget* parent) {
  auto* made = new QToolButton(parent);
  made->setIcon(theme::icon(symbol));
  made->setToolTip(tip);
  made->setAccessibleName(tip);
  made->setAutoRaise(true);
  made->setObjectName(name);
  return made;
}

}  // namespace

StepList::StepList(const scenario::Program& program, QWidget* parent)
    : QWidget(parent),
      program_(program),
      list_(new QListWidget(this)),
      add_(button(theme::Symbol::Add, text("Add a step behind the selected one"), "button.add", this)),
      remove_(button(theme::Symbol::Remove, text("Remove the step"), "button.remove", this)),
      up_(button(theme::Symbol::Up, text("Move the step up"), "button.up", this)),
      down_(button(theme::Symbol::Down, text("Move the step down"), "button.down", this)) {
  list_->setAccessibleName(text("Steps"));
  setFocusProxy(list_);

  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(2);
  for (QToolButton* each : {add_, remove_, up_, down_}) buttons->addWidget(each);
  buttons->addStretch(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(list_, 1);
  column->addLayout(buttons);

  connect(list_, &QListWidget::currentRowChanged, this, [this] { emit selected_changed(selected()); });
}

void StepList::use(QMenu& add, QAction& remove, QAction& up, QAction& down) {
  add_->setMenu(&add);
  add_->setPopupMode(QToolButton::InstantPopup);
  add_->setEnabled(!program_.operations.empty());
  remove_->setDefaultAction(&remove);
  up_->setDefaultAction(&up);
  down_->setDefaultAction(&down);
}

void StepList::show_document(const scenario::Document& document, const std::vector<PartState>& states) {
  const std::size_t before = selected();
  states_ = states;
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (std::size_t part = 0; part <= document.steps.size(); ++part) {
      QString title = text("Input");
      if (part > 0) {
        const scenario::Step& step = document.steps[part - 1];
        const scenario::Operation* operation = program_.find_operation(step.operation);
        title = QString::number(part) + "  " + text((operation != nullptr ? operation->title : step.operation).c_str());
        if (!step.name.empty()) title += QString::fromUtf8(" · ") + QString::fromStdString(step.name);
      }
      auto* item = new QListWidgetItem(theme::icon(symbol_of(states.at(part))), title, list_);
      item->setToolTip(words_of(states.at(part)));
    }
    list_->setCurrentRow(static_cast<int>(std::min(before, document.steps.size())));
  }
  if (selected() != before) emit selected_changed(selected());
}

std::size_t StepList::selected() const { return static_cast<std::size_t>(std::max(0, list_->currentRow())); }

void StepList::select(std::size_t part) { list_->setCurrentRow(static_cast<int>(part)); }

QString StepList::title(std::size_t part) const {
  const QListWidgetItem* item = list_->item(static_cast<int>(part));
  return item == nullptr ? QString() : item->text();
}

}  // namespace dobra::gui
