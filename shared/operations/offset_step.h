#pragma once
// `offset` as an operation of either program: a step of scenarios, with layers, numbers, a table, remarks and a file of
// its own, whose construction can be watched. The command `offset` of both programs computes by offset_curves() too.
// Page: docs/user/offset_command.md

#include <memory>

#include "shared/operations/offset_families.h"
#include "shared/operations/offset_stages.h"
#include "shared/scenario/program.h"

namespace dobra::operations {

/// What one step (or the command) has made.
struct Offsets {
  std::vector<OffsetFamily> families = {};
  OffsetOrigin origin = {};
  OffsetVerdict verdict = {};
  bool verified = false;
  bool of_file = false;                             ///< The bases are of a file, not of the model.
  std::optional<OffsetStage> stage = std::nullopt;  ///< The construction was stopped before it was done.
  std::vector<std::string> remarks = {};            ///< In order.
  scenario::UnitSystem units = {};                  ///< Of its file.
  std::size_t state = 0;                            ///< Of the model, where that has several: of which the bases are.
};
/// Of all steps, in their order; the model holds them.
using AllOffsets = std::vector<const Offsets*>;

/// Curves or areas of lines, or the first steps of their construction.
/// @param file  where the lines are from; empty: the model.
/// @error those of offset_input, offset_families and check_numbers.
base::Result<Offsets> offset_curves(const OffsetCaller& caller, const OffsetPlan& plan, io::formats::LineWork lines,
                                    const std::string& file);

/// "verified 12 edges ...", and what was not judged, if anything: a line each.
std::vector<std::string> verdict_text(const Offsets& offsets, const OffsetPlan& plan);

/// The step: the lines of its file, in metres, else those of the model.
/// @error those of offset_plan, io::formats::read_any_lines and offset_curves.
base::Result<Offsets> offset_step(const OffsetParams& params, const std::vector<io::lines::Feature>& of_model,
                                  const scenario::Context& context, const base::Progress& progress);

// What steps tell, each of its own: "offset.2.length", layers "offset_2_1" of the first panel, offset_2.geojson.
void add_offset_quantities(const AllOffsets& all, std::vector<scenario::Quantity>& quantities);
void add_offset_tables(const AllOffsets& all, std::vector<scenario::DataTable>& tables);
void add_offset_remarks(const AllOffsets& all, std::vector<std::string>& remarks);
/// @param model  who holds them.
void add_offset_outputs(const AllOffsets& all, const scenario::State& model, std::vector<scenario::Output>& outputs);
/// Those of one state of the model.
void draw_offsets(const AllOffsets& all, std::size_t state, scene::Picture& picture);
/// Whether the verifier found nothing, where it was asked.
std::optional<bool> offsets_verified(const AllOffsets& all);

/// The operation of a program.
/// @tparam Keeper  how its model keeps them, in static functions: `lines_of(model)`, its lines and polygons by their
/// names; `state_of(model)`, which of its states the first panel of its picture shows; `all(model)`; `add(model,
/// offsets)`.
template <class Model, class Keeper>
scenario::Operation offset_operation() {
  scenario::Operation operation = scenario::make_operation<Model, OffsetParams>(
      "offset", "Offset curves", "Curves parallel to lines of the model or of a file, or areas about them.",
      [](const Model& model, const OffsetParams& params, const scenario::Context& context,
         const base::Progress& progress) -> base::Result<Model> {
        DOBRA_TRY(Offsets made, offset_step(params, Keeper::lines_of(model), context, progress));
        made.state = Keeper::state_of(model);
        Model next = model;
        Keeper::add(next, std::move(made));
        return next;
      },
      {.quantities = [](const Model& model, auto& list) { add_offset_quantities(Keeper::all(model), list); },
       .tables = [](const Model& model, auto& list) { add_offset_tables(Keeper::all(model), list); },
       .remarks = [](const Model& model, auto& list) { add_offset_remarks(Keeper::all(model), list); },
       .outputs = [](const std::shared_ptr<const Model>& model,
                     auto& list) { add_offset_outputs(Keeper::all(*model), model, list); },
       .draw = [](const Model& model,
                  auto& picture) { draw_offsets(Keeper::all(model), Keeper::state_of(model), picture); },
       .reached = [](const Model& model) { return offsets_verified(Keeper::all(model)); }});
  operation.stop_after = "stop_after";
  operation.at_work = [](const scenario::State& state) {
    const AllOffsets all = Keeper::all(scenario::model_of<Model>(state));
    return !all.empty() && all.back()->stage.has_value();
  };
  return operation;
}

}  // namespace dobra::operations
