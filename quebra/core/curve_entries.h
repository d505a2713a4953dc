#pragma once
// Curves, points and regions as the tables of a document that make them again.

#include "quebra/model/model.h"
#include "quebra/sketch/curve.h"
#include "shared/scenario/document.h"

namespace quebra::core {

/// "crack" or "curve": the tables that hold it.
const char* table_of(const sketch::Curve& curve);
/// The [[input.curve]] or [[input.crack]], in the units of the document. Arcs and splines stay what they are.
dobra::scenario::Table curve_entry(const sketch::Curve& curve, const dobra::scenario::UnitSystem& units);

/// The document with all that its file gives as tables of its own, and without the file. Curves are those of the
/// domain: named, cut and mended as reading has done it.
dobra::scenario::Document with_file_taken_in(dobra::scenario::Document document, const model::Model& model);

}  // namespace quebra::core
