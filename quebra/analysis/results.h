#pragma once
// Results of an analysis by name: fields at the nodes, along lines and at points. Page: docs/algorithms/fem.md.

#include <string>
#include <vector>

#include "quebra/analysis/analysis.h"

namespace quebra::analysis {

enum class FieldName {
  VonMises,
  StressX,
  StressY,
  StressXY,
  Principal1,
  Principal2,
  DisplacementX,
  DisplacementY,
  Displacement,
  Error
};

/// As in scenario files, in that order: "von_mises", "s_xx", ...
const std::vector<std::string>& field_names();
/// "Pa", "m", "J^0.5"
std::string unit_of(FieldName field);
/// The field of a case at the nodes of every element, in the order of mesh.nodes; stresses are the recovered ones.
std::vector<double> field_at_element_nodes(const Analysis& analysis, std::size_t load_case, FieldName field);

struct LineParams {
  std::string label = "line";
  dobra::geom::Point from, to;
  int count = 101;

  template <class D>
  static void describe(D& d) {
    d.field("label", &LineParams::label, {.title = "Label", .help = "Names the table: line_LABEL.csv."});
    d.field("from", &LineParams::from, {.title = "From", .unit = "m", .presence = dobra::scenario::Presence::Required});
    d.field("to", &LineParams::to, {.title = "To", .unit = "m", .presence = dobra::scenario::Presence::Required});
    d.field("count", &LineParams::count,
            {.title = "Points",
             .help = "Both ends included; those outside the material are left out.",
             .at_least = 2,
             .at_most = 1000000});
  }
};

struct ProbeParams {
  std::string label = "probe";
  dobra::geom::Point at;

  template <class D>
  static void describe(D& d) {
    d.field("label", &ProbeParams::label,
            {.title = "Label", .help = "Names the quantities: probe.LABEL.CASE.von_mises."});
    d.field("at", &ProbeParams::at, {.title = "Point", .unit = "m", .presence = dobra::scenario::Presence::Required});
  }
};

/// Reads all fields of the last analysis along a line, or at a point.
/// @error BadValue: no analysis, the label is taken, or nothing of it lies in the material (with the place).
dobra::base::Result<model::Model> add_line(const model::Model& model, const LineParams& params,
                                           const dobra::scenario::Context& context,
                                           const dobra::base::Progress& progress);
dobra::base::Result<model::Model> add_probe(const model::Model& model, const ProbeParams& params,
                                            const dobra::scenario::Context& context,
                                            const dobra::base::Progress& progress);

void add_sample_tables(const model::Model& model, std::vector<dobra::scenario::DataTable>& tables);
void add_sample_quantities(const model::Model& model, std::vector<dobra::scenario::Quantity>& quantities);

}  // namespace quebra::analysis
