#pragma once

#include <QString>

#include "shared/base/text.h"

namespace dobra::gui::importing {

/// The translation of an English source text.
inline QString text(const char* source) { return QString::fromStdString(base::translated(source)); }

}  // namespace dobra::gui::importing
