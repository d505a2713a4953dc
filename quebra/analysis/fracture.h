#pragma once
// Stress intensity factors of the last analysis, at every crack tip and for every load case.
// Page: docs/algorithms/crack.md.

#include <string>
#include <vector>

#include "quebra/analysis/analysis.h"
#include "shared/scenario/document.h"

namespace quebra::analysis {

struct FractureParams {
  std::optional<double> contour;

  template <class D>
  static void describe(D& d) {
    d.field("contour", &FractureParams::contour,
            {.title = "Contour",
             .help = "Outer radius of the ring of the integrals; by default the largest that fits.",
             .unit = "m",
             .above = 0});
  }
};

/// A tip that cannot be analysed is listed with the reason, and a remark says it.
/// @error BadValue: no analysis, or no tip in its mesh; no tip that can be analysed: the reason of the first.
dobra::base::Result<model::Model> add_tips(const model::Model& model, const FractureParams& params,
                                           const dobra::scenario::Context& context,
                                           const dobra::base::Progress& progress);

/// Who asks for K wants rosettes: the last `mesh` or `adapt` step before the last `crack` step gets them, and second
/// order, unless it says otherwise itself by `rosettes`, order = "1" or quads = "yes"; a document without either gets a
/// mesh step.
/// @return what was done, for the user; empty if nothing.
std::string ask_for_rosettes(dobra::scenario::Document& document);

/// What the crack steps of a model add to its quantities and tables.
void add_tip_quantities(const model::Model& model, std::vector<dobra::scenario::Quantity>& quantities);
void add_tip_tables(const model::Model& model, std::vector<dobra::scenario::DataTable>& tables);
/// Whether the crack steps gave every tip its K; nothing if there was none.
std::optional<bool> tips_reached(const model::Model& model);

}  // namespace quebra::analysis
