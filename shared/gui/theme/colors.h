#pragma once
// Colours of what is wrong, on light and on dark palettes: text on them keeps a contrast of 4.5 and more.

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

}  // namespace dobra::gui::theme
