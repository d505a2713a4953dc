#include "shared/gui/mending/error_bar.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "shared/gui/theme/colors.h"
#include "shared/gui/theme/icons.h"
#include "shared/gui/words/words.h"

namespace dobra::gui::mending {

ErrorBar::ErrorBar(QWidget* parent) : QFrame(parent), words_(new QLabel(this)), show_(new QToolButton(this)) {
  setObjectName("error_bar");
  setStyleSheet(theme::error_bar_style(QApplication::palette()));
  auto* sign = new QLabel(this);
  sign->setPixmap(theme::icon(theme::Symbol::Warning).pixmap(20, 20));
  words_->setWordWrap(true);
  words_->setTextFormat(Qt::PlainText);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  show_->setText(text("Show"));
  show_->setToolTip(text("Go to the step and the place"));
  auto* close = new QToolButton(this);
  close->setText(QString::fromUtf8("✕"));
  close->setAutoRaise(true);
  close->setToolTip(text("Close this message"));
  close->setAccessibleName(close->toolTip());
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 4, 4);
  row->addWidget(sign);
  row->addWidget(words_, 1);
  row->addWidget(show_);
  row->addWidget(close);
  connect(show_, &QToolButton::clicked, this, &ErrorBar::show_asked);
  connect(close, &QToolButton::clicked, this, &ErrorBar::clear);
  hide();
}

void ErrorBar::say(const QString& message, CanShow can_show) {
  take_colors();
  words_->setText(message);
  show_->setVisible(can_show == CanShow::Yes);
  show();
}

QString ErrorBar::message() const { return isHidden() ? QString() : words_->text(); }

void ErrorBar::take_colors() {
  const QString style = theme::error_bar_style(QApplication::palette());
  if (style != styleSheet()) setStyleSheet(style);
}

}  // namespace dobra::gui::mending
