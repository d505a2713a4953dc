#pragma once
// Words of the window. All of them live in one translation context, "dobra", shared with base::translated, so that one
// file resources/translations/dobra_LANGUAGE.ts holds everything a user reads.

#include <QCoreApplication>
#include <QString>

namespace dobra::gui::words {

/// The translation of an English source text; the text itself if there is none.
inline QString text(const char* source) { return QCoreApplication::translate("dobra", source); }

}  // namespace dobra::gui::words

namespace dobra::gui {
using words::text;  // in every room of the window
}
