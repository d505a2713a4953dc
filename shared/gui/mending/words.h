#pragma once
// The words of this room, out of the one translation context of the window (shared/gui/text.h).

#include <QCoreApplication>
#include <QString>

namespace dobra::gui::mending {

inline QString text(const char* source) { return QCoreApplication::translate("dobra", source); }

}  // namespace dobra::gui::mending
