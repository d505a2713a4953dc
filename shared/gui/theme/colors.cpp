#include "shared/gui/theme/colors.h"

#include <QApplication>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>

#include "shared/gui/theme/icons.h"

namespace dobra::gui::theme {

namespace {

/// What the desktop gave before any theme was applied.
struct Desktop {
  QPalette palette;
  QString style;
};
const Desktop& desktop() {
  static const Desktop found{QApplication::palette(), QApplication::style()->objectName()};
  return found;
}

struct Row {
  QPalette::ColorRole role;
  QRgb light;
  QRgb dark;
};
constexpr Row table[] = {{QPalette::Window, 0xfff0f0f0, 0xff2b2e31},
                         {QPalette::WindowText, 0xff1a1a1a, 0xffe8eaec},
                         {QPalette::Base, 0xffffffff, 0xff1f2123},
                         {QPalette::AlternateBase, 0xfff5f6f7, 0xff26292c},
                         {QPalette::Text, 0xff1a1a1a, 0xffe8eaec},
                         {QPalette::PlaceholderText, 0xff5a5a5a, 0xffb4b9be},
                         {QPalette::Button, 0xffeaeaea, 0xff363a3e},
                         {QPalette::ButtonText, 0xff1a1a1a, 0xffe8eaec},
                         {QPalette::BrightText, 0xff000000, 0xffffffff},
                         {QPalette::Highlight, 0xff2a6fb5, 0xff2f6db0},
                         {QPalette::HighlightedText, 0xffffffff, 0xffffffff},
                         {QPalette::Link, 0xff125c8e, 0xff7cc0ff},
                         {QPalette::LinkVisited, 0xff6a3d8f, 0xffc9a7ee},
                         {QPalette::ToolTipBase, 0xffffffe6, 0xff3a3e42},
                         {QPalette::ToolTipText, 0xff1a1a1a, 0xffe8eaec},
                         {QPalette::Light, 0xffffffff, 0xff4a4f54},
                         {QPalette::Midlight, 0xfff7f7f7, 0xff40444a},
                         {QPalette::Mid, 0xffb8b8b8, 0xff24272a},
                         {QPalette::Dark, 0xff9f9f9f, 0xff1a1c1e},
                         {QPalette::Shadow, 0xff6b6b6b, 0xff0d0e0f}};
constexpr Row disabled_words = {QPalette::NoRole, 0xff636363, 0xffa3a8ad};

QPalette made(bool dark) {
  QPalette palette;
  for (const Row& row : table) {
    for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled})
      palette.setColor(group, row.role, QColor::fromRgb(dark ? row.dark : row.light));
  }
  const QColor faint = QColor::fromRgb(dark ? disabled_words.dark : disabled_words.light);
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::PlaceholderText})
    palette.setColor(QPalette::Disabled, role, faint);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, palette.color(QPalette::Active, QPalette::Button));
  palette.setColor(QPalette::Disabled, QPalette::HighlightedText, faint);
  return palette;
}

/// More of a bar than there is room for.
void draw_more(QPainter& painter) {
  for (const double x : {4.0, 12.0}) painter.drawPolyline(QPolygonF({{x, 5.0}, {x + 7.0, 12.0}, {x, 19.0}}));
}

void draw_more_below(QPainter& painter) {
  for (const double y : {4.0, 12.0}) painter.drawPolyline(QPolygonF({{5.0, y}, {12.0, y + 7.0}, {19.0, y}}));
}

/// Fusion, whose boxes to tick and arrows of bars are as dark as what is round them on dark palettes.
class Style : public QProxyStyle {
 public:
  Style() : QProxyStyle("fusion") {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck) return;
    if (!is_dark(option->palette)) return;
    painter->save();
    painter->setPen(option->palette.color(QPalette::PlaceholderText));
    painter->setBrush(Qt::NoBrush);
    painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
    painter->restore();
  }

  QIcon standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override {
    if (which == SP_ToolBarHorizontalExtensionButton) return icon(draw_more);
    if (which == SP_ToolBarVerticalExtensionButton) return icon(draw_more_below);
    return QProxyStyle::standardIcon(which, option, widget);
  }
};

}  // namespace

QPalette with_quiet_words(QPalette palette) {
  const QColor quiet = is_dark(palette) ? QColor(0xb4, 0xb9, 0xbe) : QColor(0x5a, 0x5a, 0x5a);
  for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive})
    palette.setColor(group, QPalette::PlaceholderText, quiet);
  return palette;
}

QPalette palette_of(Theme theme) {
  if (theme == Theme::System) return with_quiet_words(desktop().palette);
  return made(theme == Theme::Dark);
}

void apply(Theme theme) {
  // Styles of desktops draw with colours of their own; ours draws with those of the palette.
  const QString name = desktop().style;
  const bool of_desktop = theme == Theme::System && name.compare("fusion", Qt::CaseInsensitive) != 0 &&
                          QStyleFactory::keys().contains(name, Qt::CaseInsensitive);
  const bool was_ours = dynamic_cast<Style*>(QApplication::style()) != nullptr;
  if (of_desktop && was_ours) QApplication::setStyle(name);
  if (!of_desktop && !was_ours) QApplication::setStyle(new Style);
  QApplication::setPalette(palette_of(theme));
}

ErrorColors error_colors(const QPalette& palette) {
  if (is_dark(palette))
    return {QColor(0x4a, 0x1d, 0x1a), QColor(0x8c, 0x3b, 0x35), QColor(0xff, 0xd7, 0xd2), QColor(0x66, 0x2a, 0x25),
            QColor(0xa8, 0x5a, 0x53)};
  return {QColor(0xfd, 0xec, 0xea), QColor(0xe0, 0xa0, 0x9a), QColor(0x5f, 0x14, 0x11), QColor(0xf8, 0xd3, 0xce),
          QColor(0xc9, 0x8a, 0x84)};
}

QString error_bar_style(const QPalette& palette) {
  const ErrorColors c = error_colors(palette);
  return QString(
             "#error_bar { background: %1; border: 1px solid %2; }"
             "#error_bar QLabel { color: %3; }"
             "#error_bar QToolButton { color: %3; background: %4; border: 1px solid %5; padding: 2px 8px; }")
      .arg(c.back.name(), c.border.name(), c.words.name(), c.button.name(), c.button_border.name());
}

const CanvasColors& canvas_colors(Canvas canvas) {
  static const CanvasColors paper{{},
                                  QColor(0x66, 0x66, 0x66),
                                  QColor(0x20, 0x20, 0x20),
                                  QColor(0xff, 0xff, 0xff, 0xe1),
                                  QColor(0x0b, 0x57, 0xd0),
                                  QColor(0xd9, 0x5f, 0x02),
                                  QColor(0xb0, 0x00, 0x6d),
                                  QColor(0xff, 0xff, 0xff)};
  static const CanvasColors dark{{{0x1e, 0x21, 0x24}},           QColor(0xa8, 0xad, 0xb3), QColor(0xf0, 0xf0, 0xf0),
                                 QColor(0x1e, 0x21, 0x24, 0xe1), QColor(0x6a, 0xb0, 0xff), QColor(0xff, 0x9d, 0x4d),
                                 QColor(0xff, 0x6f, 0xc8),       QColor(0x1e, 0x21, 0x24)};
  return canvas == Canvas::Dark ? dark : paper;
}

}  // namespace dobra::gui::theme
