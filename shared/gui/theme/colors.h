#pragma once
// The colours that the window gives by itself, on light and on dark palettes and on the paper of the canvas. Words keep
// a contrast of 4.5 and more to what is behind them.

#include <QPalette>

namespace dobra::gui::theme {

inline bool is_dark(const QPalette& palette) { return palette.color(QPalette::Base).lightness() < 128; }

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
inline QPalette with_quiet_words(QPalette palette) {
  const QColor quiet = is_dark(palette) ? QColor(0xb4, 0xb9, 0xbe) : QColor(0x5a, 0x5a, 0x5a);
  for (const QPalette::ColorGroup group : {QPalette::Active, QPalette::Inactive})
    palette.setColor(group, QPalette::PlaceholderText, quiet);
  return palette;
}

/// Of a bar that says what went wrong, on any palette.
inline constexpr const char* error_bar =
    "#error_bar { background: #fdecea; border: 1px solid #e0a09a; }"
    "#error_bar QLabel { color: #5f1411; }"
    "#error_bar QToolButton { color: #5f1411; background: #f8d3ce; border: 1px solid #c98a84; padding: 2px 8px; }";

/// On the canvas, which is white paper.
inline constexpr QRgb paper_quiet = 0xff666666;
inline constexpr QRgb paper_words = 0xff202020;
inline constexpr QRgb paper_behind_words = 0xe1ffffff;
inline constexpr QRgb drawn = 0xff0b57d0;
inline constexpr QRgb chosen = 0xffd95f02;
inline constexpr QRgb snapped = 0xffb0006d;

}  // namespace dobra::gui::theme
