#include "shared/gui/labels/labels.h"

#include <QPainter>

namespace dobra::gui::labels {

namespace {

constexpr QChar ellipsis(0x2026);

}  // namespace

void Line::say(const QString& words) {
  setText(words);
  setToolTip(words);
}

bool Line::is_cut() const { return fontMetrics().horizontalAdvance(text()) > contentsRect().width(); }

void Line::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.drawText(contentsRect(), Qt::AlignVCenter | Qt::AlignLeft,
                   fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width()));
}

Paragraph::Paragraph(QWidget* parent) : QLabel(parent) {
  setWordWrap(true);
  setTextFormat(Qt::PlainText);
  setAlignment(Qt::AlignTop | Qt::AlignLeft);
}

void Paragraph::say(const QString& words) {
  words_ = words;
  setToolTip(words);
  fit();
}

void Paragraph::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  fit();
}

void Paragraph::fit() {
  const QRect room = contentsRect();
  const auto fits = [&](const QString& text) {
    const QRect wide(0, 0, room.width(), 100000);
    return fontMetrics().boundingRect(wide, Qt::TextWordWrap, text).height() <= room.height();
  };
  QString shown = words_;
  while (isVisible() && !fits(shown) && shown.contains(' '))
    shown = shown.left(shown.lastIndexOf(' ')).remove(ellipsis) + ellipsis;
  if (shown != text()) setText(shown);
}

}  // namespace dobra::gui::labels
