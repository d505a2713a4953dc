#pragma once
// Words of the window in the language of its user, and names of files.

#include <QString>
#include <filesystem>
#include <string>

#include "shared/gui/words/words.h"

namespace dobra::gui {

inline QString from_path(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }
inline std::filesystem::path to_path(const QString& path) { return {path.toStdString()}; }

/// Loads the translation of the user's language (that of the locale, or of `language` such as "pt_BR") into the
/// application, and hooks base::translated to it. English where there is no translation. Decimals stand behind the mark
/// of that language.
/// @pre a QCoreApplication exists.
void install_translation(const QString& language = {});

}  // namespace dobra::gui
