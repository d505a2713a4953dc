#pragma once
// The colours of the programs, one table for widgets and canvas, on light and on dark. Words keep a contrast of 4.5 and
// more to what is behind them; a test goes through the table.

#include <QPalette>

#include "shared/scene/ground.h"

namespace dobra::gui::theme {

enum class Theme { System, Light, Dark };
enum class Canvas { Paper, Dark };
enum class CanvasChoice { AsTheme, Paper, Dark };

/// Of all widgets. System: those that Qt has found on the desktop, with quiet words that can be read.
/// @pre a QApplication exists.
void apply(Theme theme);

/// The palette of a theme. System: that of the desktop. @pre a QApplication exists.
QPalette palette_of(Theme theme);

inline bool is_dark(const QPalette& palette) { return palette.color(QPalette::Base).lightness() < 128; }

/// What a choice comes to beside widgets of a palette.
inline Canvas canvas_of(CanvasChoice choice, const QPalette& palette) {
  if (choice == CanvasChoice::AsTheme) return is_dark(palette) ? Canvas::Dark : Canvas::Paper;
  return choice == CanvasChoice::Dark ? Canvas::Dark : Canvas::Paper;
}

/// Words on the background of a form.
inline QColor wrong_text(const QPalette& palette) {
  return is_dark(palette) ? QColor(0xff, 0xa3, 0x9c) : QColor(0xb7, 0x1c, 0x1c);
}

/// What is met, and what is to be known.
inline QColor right_text(const QPalette& palette) {
  return is_dark(palette) ? QColor(0x81, 0xd4, 0x86) : QColor(0x1b, 0x6b, 0x20);
}
inline QColor remark_text(const QPalette& palette) {
  return is_dark(palette) ? QColor(0x7c, 0xc0, 0xff) : QColor(0x12, 0x5c, 0x8e);
}

/// The background of an editor; its text stays that of the palette.
inline QColor wrong_base(const QPalette& palette) {
  return is_dark(palette) ? QColor(0x5c, 0x1f, 0x1b) : QColor(0xff, 0xd9, 0xd4);
}

/// The palette with words that stand back (defaults, explanations) no fainter than they may be.
QPalette with_quiet_words(QPalette palette);

/// Of a bar that says what went wrong.
struct ErrorColors {
  QColor back, border, words, button, button_border;
};
ErrorColors error_colors(const QPalette& palette);
/// For the widget called error_bar.
QString error_bar_style(const QPalette& palette);

/// What is drawn on the canvas by the window itself, over the picture; the picture's own colours follow `ground`.
struct CanvasColors {
  scene::Ground ground;
  QColor quiet;         ///< Hints on an empty sheet.
  QColor words;         ///< On `behind_words`.
  QColor behind_words;  ///< Not quite opaque.
  QColor drawn;         ///< What a tool draws.
  QColor chosen;
  QColor snapped;
  QColor handle;  ///< Inside of handles that are not chosen.
};
const CanvasColors& canvas_colors(Canvas canvas);

}  // namespace dobra::gui::theme
