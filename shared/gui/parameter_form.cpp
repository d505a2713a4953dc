#include "shared/gui/parameter_form.h"

#include <QApplication>
#include <QLabel>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

#include "shared/gui/labels/labels.h"
#include "shared/gui/text.h"

namespace dobra::gui {

using scenario::Field;
using scenario::Table;

namespace {

constexpr int hint_lines = 4;

}  // namespace

ParameterForm::ParameterForm(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), help_(new QLabel(this)), scroll_(new QScrollArea(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 6, 0, 0);
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  title_->setWordWrap(true);
  help_->setWordWrap(true);
  help_->setForegroundRole(QPalette::PlaceholderText);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setWidgetResizable(true);
  scroll_->setAccessibleName(text("Parameters"));
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(title_);
  column->addWidget(help_);
  column->addWidget(scroll_, 1);
  hint_ = new labels::Paragraph(this);
  hint_->setObjectName("form.hint");
  hint_->setForegroundRole(QPalette::PlaceholderText);
  hint_->setContentsMargins(0, 2, 8, 2);
  // Room that is always there: a form that moved with the focus would slip from under the mouse.
  hint_->setFixedHeight(hint_lines * hint_->fontMetrics().lineSpacing() + 4);
  column->addWidget(hint_);
  help_->hide();
  hint_->hide();
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { show_hint(now); });
}

void ParameterForm::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  show_words();
}

void ParameterForm::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  show_words();
}

void ParameterForm::show_words() {
  // Well above what the form needs with them, so that a small window can become smaller still.
  const int lines = isVisible() ? height() / hint_->fontMetrics().lineSpacing() : 0;
  help_->setVisible(lines > 15 && !help_->text().isEmpty());
  hint_->setVisible(lines > 18);
}

void ParameterForm::show_part(const QString& identity, const QString& title, const QString& help,
                              const std::vector<Field>& fields, const Table& table,
                              const std::filesystem::path& folder) {
  title_->setText(title);
  help_->setText(help);
  title_->setToolTip(help);
  show_words();
  if (form_ == nullptr || identity != identity_) {
    identity_ = identity;
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 4, 8, 8);
    form_ = new TableForm(fields, folder, page);
    column->addWidget(form_);
    column->addStretch(1);
    if (canvas_answers_) form_->canvas_answers();
    connect(form_, &TableForm::edited, this, &ParameterForm::edited);
    connect(form_, &TableForm::pointing_asked, this, &ParameterForm::pointing_asked);
    // Once the layout has settled: a message that has just appeared has no place before.
    connect(form_, &TableForm::wants_to_be_seen, this, [this](QWidget* widget) {
      QTimer::singleShot(0, widget, [this, widget] { scroll_->ensureWidgetVisible(widget, 0, 24); });
    });
    scroll_->setWidget(page);  // Deletes the page before.
  }
  form_->set_table(table);
}

void ParameterForm::show_hint(QWidget* focused) {
  QString hint;
  for (QWidget* widget = focused; widget != nullptr && widget != this; widget = widget->parentWidget()) {
    if (isAncestorOf(widget) && widget->property(hint_property).isValid())
      hint = widget->property(hint_property).toString();
  }
  // What is looked at while a list is open or a button is pressed stays explained.
  if (focused == nullptr || (!isAncestorOf(focused) && !hint.isEmpty())) return;
  hint_->say(hint);
}

}  // namespace dobra::gui
