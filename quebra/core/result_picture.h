#pragma once
// A field of an analysis as a picture: colours and contours on the deformed shape, the mesh, the shape before, and
// where the field is greatest and least.

#include <optional>

#include "quebra/analysis/results.h"
#include "shared/scene/layer.h"

namespace quebra::core {

enum class Shown { Yes, No };
enum class ColorRange { Field, Full };

struct ViewParams {
  analysis::FieldName field = analysis::FieldName::VonMises;
  std::string load_case;
  int cycle = 0;
  std::optional<double> deformation;
  int contours = 9;
  ColorRange range = ColorRange::Field;
  Shown mesh = Shown::Yes;
  Shown extremes = Shown::Yes;

  template <class D>
  static void describe(D& d) {
    d.choice("field", &ViewParams::field, analysis::field_names(),
             {.title = "Field",
              .help = "von Mises, stresses, principal stresses, displacements, or the error of each element."});
    d.field("case", &ViewParams::load_case, {.title = "Load case", .help = "The first by default."});
    d.field("cycle", &ViewParams::cycle,
            {.title = "Cycle", .help = "Of the adaptive loop; 0: the last analysis.", .at_least = 0});
    d.field(
        "deformation", &ViewParams::deformation,
        {.title = "Deformation",
         .help = "Times the displacements that are drawn: 1 true, 0 none; by default they are a twentieth of the size.",
         .at_least = 0});
    d.field("contours", &ViewParams::contours,
            {.title = "Contours", .help = "Number of lines.", .at_least = 0, .at_most = 100, .when = "field != error"});
    d.choice("range", &ViewParams::range, {"field", "full"},
             {.title = "Range of colours",
              .help = "field: what 99.5 % of the area has, if a peak (a crack tip) stands out of it; full: from the "
                      "least to the greatest value."});
    d.choice("mesh", &ViewParams::mesh, {"yes", "no"}, {.title = "Mesh"});
    d.choice("extremes", &ViewParams::extremes, {"yes", "no"},
             {.title = "Extremes", .help = "Marks the greatest and the least value.", .when = "field != error"});
  }
};

/// Adds a picture of the last analysis, or of a cycle. @error BadValue: no analysis, no such case or cycle.
dobra::base::Result<model::Model> add_view(const model::Model& model, const ViewParams& params,
                                           const dobra::scenario::Context& context,
                                           const dobra::base::Progress& progress);

/// @pre load_case < analysis.fields.size()
dobra::scene::Panel view_panel(const analysis::Analysis& analysis, std::size_t load_case, const ViewParams& params);

/// The views of a model in place of its meshes; without views that of the default beside them.
void add_views(const model::Model& model, dobra::scene::Picture& picture);

}  // namespace quebra::core
