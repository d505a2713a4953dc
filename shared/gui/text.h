#pragma once
// Words of the window. All of them live in one translation context, "dobra", shared with base::translated, so that one
// file resources/translations/dobra_LANGUAGE.ts holds everything a user reads.

#include <QCoreApplication>
#include <QString>
#include <filesystem>
#include <string>

namespace dobra::gui {

/// The translation of an English source text; the text itself if there is none.
inline QString text(const char* source) { return QCoreApplication::translate("dobra", source); }

inline QString from_path(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }
inline std::filesystem::path to_path(const QString& path) { return {path.toStdString()}; }

/// Loads the translation of the user's language (that of the locale, or of `language` such as "pt_BR") into the
/// application, and hooks base::translated to it. English where there is no translation. Decimals stand behind the mark
/// of that language.
/// @pre a QCoreApplication exists.
void install_translation(const QString& language = {});

}  // namespace dobra::gui
