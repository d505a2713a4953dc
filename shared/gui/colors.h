#pragma once
// Colours of what is wrong, on light and on dark palettes: text on them keeps a contrast of 4.5 and more.

#include <QPalette>

namespace dobra::gui {

inline bool is_dark(const QPalette& palette) { return palette.color(QPalette::Base).lightness() < 128; }

/// Words on the background of a form.
inline QColor wrong_text(const QPalette& palette) {
  return is_dark(palette) ? QColor(0xff, 0xa3, 0x9c) : QColor(0xb7, 0x1c, 0x1c);
}

/// The background of an editor; its text stays that of the palette.
inline QColor wrong_base(const QPalette& palette) {
  return is_dark(palette) ? QColor(0x5c, 0x1f, 0x1b) : QColor(0xff, 0xd9, 0xd4);
}

}  // namespace dobra::gui
