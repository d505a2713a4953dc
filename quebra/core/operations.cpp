#include "quebra/core/operations.h"

#include "quebra/core/constraint.h"
#include "quebra/core/input.h"
#include "quebra/core/layers.h"
#include "quebra/core/meshing.h"
#include "quebra/core/zone.h"

namespace quebra::core {
namespace {

using namespace dobra;

base::Result<scenario::State> input(const scenario::Table& table, const scenario::Context& context, const base::Progress&) {
  DOBRA_TRY(Model model, read_input(scenario::from_table<InputParams>(table), table, context));
  return scenario::make_state(std::move(model));
}

scenario::Program make_program() {
  scenario::Program program;
  program.name = "quebra";
  program.title = "QUEBRA";
  program.input_fields = scenario::fields_of<InputParams>();
  program.read_input = input;
  program.operations = {
      scenario::make_operation<Model, ConstraintParams>(
          "constraints", "Offset constraints", "Offset curves of a boundary, as internal constraints that grade the mesh.", add_constraints),
      scenario::make_operation<Model, ZoneParams>(
          "zone", "Zone of small elements", "Elements of a given size within a given distance of curves, cracks or points.", add_zone),
      scenario::make_operation<Model, MeshParams>(
          "mesh", "Mesh", "Divides the boundary and fills the domain with triangles: quadtree for the sizes, Delaunay for the shapes.", add_mesh),
  };
  program.picture_of = [](const scenario::State& state) { return picture_of(scenario::model_of<Model>(state)); };
  program.quantities_of = [](const scenario::State& state) { return quantities_of(scenario::model_of<Model>(state)); };
  program.remarks_of = [](const scenario::State& state) { return scenario::model_of<Model>(state).remarks; };
  program.tables_of = [](const scenario::State& state) { return tables_of(scenario::model_of<Model>(state)); };
  program.outputs_of = [](const scenario::State& state) { return outputs_of(std::static_pointer_cast<const Model>(state)); };
  return program;
}

}  // namespace

const scenario::Program& program() {
  static const scenario::Program table = make_program();
  return table;
}

}  // namespace quebra::core
