#include "shared/gui/stage/fitting_bar.h"

#include <QAction>
#include <QEvent>
#include <QStyle>
#include <QStyleOptionToolButton>

namespace dobra::gui::stage {

FittingBar::FittingBar(const QString& title, QWidget* parent) : QToolBar(title, parent) {
  setToolButtonStyle(Qt::ToolButtonTextOnly);
}

bool FittingBar::event(QEvent* event) {
  const bool done = QToolBar::event(event);
  switch (event->type()) {
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::ActionAdded:
    case QEvent::ActionChanged:
    case QEvent::ActionRemoved:
    case QEvent::FontChange:
      choose_style();
      break;
    default:
      break;
  }
  return done;
}

void FittingBar::choose_style() {
  const auto wanted = width_of_words() <= contentsRect().width() ? Qt::ToolButtonTextOnly : Qt::ToolButtonIconOnly;
  if (toolButtonStyle() != wanted) setToolButtonStyle(wanted);
}

int FittingBar::width_of_words() const {
  const int spacing = style()->pixelMetric(QStyle::PM_ToolBarItemSpacing, nullptr, this);
  const int margin = style()->pixelMetric(QStyle::PM_ToolBarItemMargin, nullptr, this);
  int width = 2 * (margin + style()->pixelMetric(QStyle::PM_ToolBarFrameWidth, nullptr, this));
  for (const QAction* action : actions()) {
    const QWidget* button = widgetForAction(const_cast<QAction*>(action));
    if (!action->isVisible() || button == nullptr) continue;
    QStyleOptionToolButton option;
    option.initFrom(button);
    option.text = action->iconText();
    option.toolButtonStyle = Qt::ToolButtonTextOnly;
    // As QToolButton measures its words.
    const QSize words = button->fontMetrics().size(Qt::TextShowMnemonic, option.text) +
                        QSize(2 * button->fontMetrics().horizontalAdvance(QLatin1Char(' ')), 0);
    width += style()->sizeFromContents(QStyle::CT_ToolButton, &option, words, button).width() + spacing;
  }
  return width;
}

}  // namespace dobra::gui::stage
