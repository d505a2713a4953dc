#pragma once
// What a dialog that asks for a file offers.

#include <QString>
#include <vector>

#include "shared/scenario/field.h"

namespace dobra::gui::importing {

/// "Scenarios (*.toml)" in the user's language.
QString filter_of(const scenario::FileKind& kind);

/// All kinds at once first, where they are several; then each; then all files. Of no kind: empty, which is all files.
QString file_filter(const std::vector<scenario::FileKind>& kinds);

}  // namespace dobra::gui::importing
