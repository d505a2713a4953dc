#pragma once
// Names and places that are pointed at on the canvas instead of typed into a form.

#include <QString>

#include "shared/canvas/tool.h"
#include "shared/gui/documents/shown.h"

namespace dobra::gui::vertices {

/// A field whose value is to come from the canvas.
struct Pointing {
  scenario::Field field;
  std::size_t part = 0;  ///< Of the document: names are those of the model before it.
  documents::Shown shown = documents::Shown::Result;
  [[nodiscard]] bool of_name() const {
    return field.kind == scenario::Kind::Text || field.kind == scenario::Kind::Texts;
  }
};

/// What is to be clicked.
QString hint_of(const Pointing& wish);

/// What goes into the field: the name of the line or block, the point, or its coordinate, in the document's units.
/// @param outcome  of the last run; may be null.
/// @error BadValue: nothing of that kind is there; in words for the user.
base::Result<QString> pointed_text(const Pointing& wish, const canvas::Pointed& pointed,
                                   const scenario::Document& document, const scenario::Program& program,
                                   const documents::Outcome* outcome);

}  // namespace dobra::gui::vertices
