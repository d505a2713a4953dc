#include "quebra/core/operations.h"

#include <algorithm>

#include "quebra/core/adaptivity.h"
#include "quebra/core/analysis.h"
#include "quebra/core/constraint.h"
#include "quebra/core/fracture.h"
#include "quebra/core/half_crack.h"
#include "quebra/core/input.h"
#include "quebra/core/layers.h"
#include "quebra/core/meshing.h"
#include "quebra/core/result_picture.h"
#include "quebra/core/zone.h"

namespace quebra::core {
namespace {

using namespace dobra;

base::Result<scenario::State> input(const scenario::Table& table, const scenario::Context& context, const base::Progress&) {
  DOBRA_TRY(Model model, read_input(scenario::from_table<InputParams>(table), table, context));
  return scenario::make_state(std::move(model));
}

/// The lines of supports and loads, for what only shows on a mesh: a formula that has no value somewhere.
/// And in other units than SI it says what a thickness is that was left out.
scenario::State with_lines(const scenario::State& state, const scenario::Table& table, const scenario::UnitSystem& units) {
  Model model = scenario::model_of<Model>(state);
  ProblemParams problem = *model.problem;
  const auto give_lines = [&](const char* key, auto& own) {
    const scenario::Value* rows = table.find(key);
    if (rows == nullptr) return;
    const auto& tables = std::get<std::vector<scenario::Table>>(*rows);
    for (std::size_t i = 0; i < tables.size(); ++i) own[i].place = tables[i].own_place;
  };
  give_lines("support", problem.supports);
  give_lines("load", problem.loads);
  const scenario::Value* const materials = table.find("material");
  if (!units.si() && materials != nullptr) {
    const auto& rows = std::get<std::vector<scenario::Table>>(*materials);
    if (std::any_of(rows.begin(), rows.end(), [](const scenario::Table& row) { return row.find("thickness") == nullptr; }))
      model.remarks.push_back("a material has no `thickness`: it is 1 m");
  }
  model.problem = std::make_shared<const ProblemParams>(std::move(problem));
  return scenario::make_state(std::move(model));
}

/// set_problem, whose errors get the line of the table that they are about.
scenario::Operation problem_operation() {
  auto operation = scenario::make_operation<Model, ProblemParams>(
      "problem", "Materials, supports, loads", "The elastic problem, by the names of regions, curves and points.", set_problem);
  operation.run = [run = operation.run](const scenario::State& state, const scenario::Table& table, const scenario::Context& context,
                                        const base::Progress& progress) -> base::Result<scenario::State> {
    auto result = run(state, table, context, progress);
    if (result) return with_lines(*result, table, context.units);
    const auto fault = fault_of(scenario::model_of<Model>(state).domain, scenario::from_table<ProblemParams>(table));
    const scenario::Value* rows = fault ? table.find(fault->key) : nullptr;
    if (rows == nullptr) return result;
    return base::located(result.error(), std::get<std::vector<scenario::Table>>(*rows)[fault->row].own_place);
  };
  return operation;
}

bool mesher_at_work(const scenario::State& state) { return scenario::model_of<Model>(state).work != nullptr; }

scenario::Operation mesh_operation() {
  auto operation = scenario::make_operation<Model, MeshParams>(
      "mesh", "Mesh", "Divides the boundary and fills the domain with triangles: quadtree for the sizes, Delaunay for the shapes.", add_mesh);
  operation.stop_after = "stop_after";
  operation.at_work = mesher_at_work;
  return operation;
}

/// Nothing but another mesh may follow a mesh that is not done.
scenario::Operation after_a_whole_mesh(scenario::Operation operation) {
  operation.run = [run = operation.run](const scenario::State& state, const scenario::Table& table, const scenario::Context& context,
                                        const base::Progress& progress) -> base::Result<scenario::State> {
    if (mesher_at_work(state)) {
      return base::Error{base::ErrorCode::CannotMesh, "the mesh before this step was stopped before it was done: set its stop_after to 0"};
    }
    return run(state, table, context, progress);
  };
  return operation;
}

/// Columns of words that tell lengths and places.
void turn_messages(std::vector<scenario::DataTable>& tables, const scenario::UnitSystem& units) {
  for (scenario::DataTable& table : tables) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      if (table.columns[i] != "mend" && table.columns[i] != "reason") continue;
      for (auto& row : table.rows) row[i] = scenario::message_in_units(std::get<std::string>(row[i]), units);
    }
  }
}

scenario::Program make_program() {
  scenario::Program program;
  program.name = "quebra";
  program.title = "QUEBRA";
  program.takes_units = scenario::TakesUnits::Any;
  program.input_fields = scenario::fields_of<InputParams>();
  program.read_input = input;
  program.operations = {
      scenario::make_operation<Model, ConstraintParams>(
          "constraints", "Offset constraints", "Offset curves of a boundary, as internal constraints that grade the mesh.", add_constraints),
      scenario::make_operation<Model, ZoneParams>(
          "zone", "Zone of small elements", "Elements of a given size within a given distance of curves, cracks or points.", add_zone),
      scenario::make_operation<Model, HalfCrackParams>(
          "half_crack", "Half of a crack", "A curve of the boundary is one lip of a crack on a line of symmetry.", add_half_crack),
      mesh_operation(),
      problem_operation(),
      scenario::make_operation<Model, AnalyseParams>(
          "analyse", "Analyse", "Displacements, stresses and their error on the last mesh.", add_analysis),
      scenario::make_operation<Model, AdaptParams>(
          "adapt", "Adapt", "Meshes and analyses until the error asked for is met.", adapt),
      scenario::make_operation<Model, FractureParams>(
          "crack", "Stress intensity factors", "K_I and K_II by three methods, J, T and kink angles at every crack tip.", add_tips),
      scenario::make_operation<Model, LineParams>("line", "Results along a line", "Displacements and stresses along a line, as a table.", add_line),
      scenario::make_operation<Model, ProbeParams>("probe", "Results at a point", "Displacements and stresses at a point.", add_probe),
      scenario::make_operation<Model, ViewParams>("view", "Picture of a field", "A field on the deformed shape: colours, contours, mesh, extremes.", add_view),
  };
  for (scenario::Operation& operation : program.operations) {
    if (operation.name != "mesh") operation = after_a_whole_mesh(std::move(operation));
  }
  program.picture_of = [](const scenario::State& state) {
    const Model& model = scenario::model_of<Model>(state);
    scene::Picture picture = picture_of(model);
    add_views(model, picture);
    return in_units(std::move(picture), model.units);
  };
  program.quantities_of = [](const scenario::State& state) {
    const Model& model = scenario::model_of<Model>(state);
    auto quantities = quantities_of(model);
    add_analysis_quantities(model, quantities);
    add_tip_quantities(model, quantities);
    add_sample_quantities(model, quantities);
    return in_units(std::move(quantities), model.units);
  };
  program.reached_of = [](const scenario::State& state) -> std::optional<bool> {
    const Model& model = scenario::model_of<Model>(state);
    const bool adapted = std::any_of(model.analyses.begin(), model.analyses.end(), [](const auto& analysis) { return analysis->cycle > 0; });
    const auto tips = tips_reached(model);
    if (!adapted) return tips;
    return !model.short_of_target && tips.value_or(true);
  };
  program.remarks_of = [](const scenario::State& state) {
    const Model& model = scenario::model_of<Model>(state);
    std::vector<std::string> remarks = model.remarks;
    for (std::string& remark : remarks) remark = scenario::message_in_units(remark, model.units);
    return remarks;
  };
  program.tables_of = [](const scenario::State& state) {
    const Model& model = scenario::model_of<Model>(state);
    auto tables = tables_of(model);
    add_analysis_tables(model, tables);
    add_tip_tables(model, tables);
    add_sample_tables(model, tables);
    turn_messages(tables, model.units);
    return in_units(std::move(tables), model.units);
  };
  program.outputs_of = [](const scenario::State& state) {
    auto outputs = outputs_of(std::static_pointer_cast<const Model>(state));
    add_analysis_outputs(scenario::model_of<Model>(state), outputs);
    return outputs;
  };
  return program;
}

}  // namespace

const scenario::Program& program() {
  static const scenario::Program table = make_program();
  return table;
}

}  // namespace quebra::core
