#include "quebra/core/operations.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "quebra/analysis/adaptivity.h"
#include "quebra/analysis/analysis.h"
#include "quebra/analysis/fracture.h"
#include "quebra/core/drawing.h"
#include "quebra/core/importing.h"
#include "quebra/core/input.h"
#include "quebra/core/layers.h"
#include "quebra/core/result_picture.h"
#include "quebra/core/solid_operations.h"
#include "quebra/core/surface_layers.h"
#include "quebra/meshing/constraint.h"
#include "quebra/meshing/half_crack.h"
#include "quebra/meshing/meshing.h"
#include "quebra/meshing/zone.h"
#include "quebra/surfaces/mesh_step.h"
#include "quebra/surfaces/shell.h"
#include "shared/operations/offset_step.h"

namespace quebra::core {
namespace {

using namespace dobra;

base::Result<scenario::State> input(const scenario::Table& table, const scenario::Context& context,
                                    const base::Progress&) {
  DOBRA_TRY(model::Model model, read_input(scenario::from_table<InputParams>(table), table, context));
  return scenario::make_state(std::move(model));
}

/// The curves or surfaces alone: whatever is wrong with them, they can be looked at.
void draw_input(const scenario::Table& table, const scenario::Context& context, dobra::scene::Picture& picture) {
  const auto params = scenario::from_table<InputParams>(table);
  if (const auto surfaces = drawn_surfaces(params, table, context)) return draw_surfaces(*surfaces, picture);
  const auto drawn = read_drawing(params, table, context);
  if (!drawn || drawn->curves.empty()) return;
  dobra::scene::Panel panel;
  panel.key = "domain";
  for (const sketch::Curve& curve : drawn->curves) {
    panel.layers.push_back({"curve." + curve.name,
                            curve.name,
                            {.line = ink, .line_width = 1.2},
                            dobra::scene::Lines{{trace(curve).line}, {}}});
  }
  picture.panels.push_back(std::move(panel));
}

void draw_input_in_space(const scenario::Table& table, const scenario::Context& context,
                         dobra::scene::space::SpacePicture& picture) {
  const auto drawn = drawn_surfaces(scenario::from_table<InputParams>(table), table, context);
  if (drawn) draw_surfaces_in_space(*drawn, picture);
}

/// The lines of supports and loads, for what only shows on a mesh: a formula that has no value somewhere.
/// And in other units than SI it says what a thickness is that was left out.
scenario::State with_lines(const scenario::State& state, const scenario::Table& table,
                           const scenario::UnitSystem& units) {
  model::Model model = scenario::model_of<model::Model>(state);
  analysis::ProblemParams problem = *model.problem;
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
    if (std::any_of(rows.begin(), rows.end(),
                    [](const scenario::Table& row) { return row.find("thickness") == nullptr; }))
      model.remarks.push_back("a material has no `thickness`: it is 1 m");
  }
  model.problem = std::make_shared<const analysis::ProblemParams>(std::move(problem));
  return scenario::make_state(std::move(model));
}

/// set_problem, whose errors get the line of the table that they are about.
scenario::Operation problem_operation() {
  auto operation = scenario::make_operation<model::Model, analysis::ProblemParams>(
      "problem", "Materials, supports, loads", "The elastic problem, by the names of regions, curves and points.",
      analysis::set_problem);
  operation.run = [run = operation.run](const scenario::State& state, const scenario::Table& table,
                                        const scenario::Context& context,
                                        const base::Progress& progress) -> base::Result<scenario::State> {
    auto result = run(state, table, context, progress);
    if (result) return with_lines(*result, table, context.units);
    const auto fault = analysis::fault_of(scenario::model_of<model::Model>(state).domain,
                                          scenario::from_table<analysis::ProblemParams>(table));
    const scenario::Value* rows = fault ? table.find(fault->key) : nullptr;
    if (rows == nullptr) return result;
    return base::located(result.error(), std::get<std::vector<scenario::Table>>(*rows)[fault->row].own_place);
  };
  return operation;
}

void add_once(const std::string& name, std::vector<std::string>& names) {
  if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

/// "curve": curves and cracks; "place": what a support or a load may stand on; "region"; "point".
std::vector<std::string> names_in(const domain::Domain& domain, const std::string& what) {
  std::vector<std::string> names;
  for (const sketch::Curve& curve : domain.curves) {
    const bool crack = curve.role == sketch::Role::Crack;
    if (what == "curve" || (what == "place" && !crack)) add_once(curve.name, names);
    for (const char* const side : {"_left", "_right", "_start", "_end"}) {
      if (what == "place" && crack) add_once(curve.name + side, names);
    }
  }
  for (const sketch::NamedPoint& point : domain.points) {
    if (what == "point" || what == "place") add_once(point.name, names);
  }
  for (const auto& [tag, name] : domain.region_names) {
    if (what == "region") add_once(name, names);
  }
  return names;
}

/// A crack stands for the lip or the end that is nearest, where a place is meant.
std::string name_at(const domain::Domain& domain, const std::string& what,
                    const std::optional<dobra::scene::Pick>& line, geom::Point at) {
  if (what == "point" || what == "place") {
    const double reach = 0.01 * domain.box().diagonal();
    const sketch::NamedPoint* nearest = nullptr;
    for (const sketch::NamedPoint& point : domain.points) {
      const double distance = geom::distance(point.at, at);
      if (!point.name.empty() && distance <= reach && (!nearest || distance < geom::distance(nearest->at, at)))
        nearest = &point;
    }
    if (nearest != nullptr) return nearest->name;
  }
  const bool drawn = line && (line->layer == "boundary" || line->layer == "internal" || line->layer == "cracks");
  if (!drawn || line->id >= domain.curves.size() || (what != "curve" && what != "place")) return {};
  const sketch::Curve& curve = domain.curves[line->id];
  if (what == "curve" || curve.role != sketch::Role::Crack) return curve.name;
  const geom::Polyline trace = sketch::trace(curve).line;
  std::size_t segment = 0;
  for (std::size_t i = 1; i < trace.segment_count(); ++i) {
    if (geom::distance(trace.segment(i), at) < geom::distance(trace.segment(segment), at)) segment = i;
  }
  const geom::Segment side = trace.segment(segment);
  return curve.name + (cross(side.vector(), at - side.from) >= 0.0 ? "_left" : "_right");
}

bool mesher_at_work(const scenario::State& state) { return scenario::model_of<model::Model>(state).work != nullptr; }

/// Of the domain, or of the surfaces.
base::Result<model::Model> mesh_model(const model::Model& model, const meshing::MeshParams& params,
                                      const scenario::Context& context, const base::Progress& progress) {
  if (model.surfaces) return surfaces::add_surface_mesh(model, params, context, progress);
  return meshing::add_mesh(model, params, context, progress);
}

// What a model tells: of its domain, or of its surfaces.
void quantities(const model::Model& model, std::vector<scenario::Quantity>& all) {
  if (only_solids(model)) return;
  model.surfaces ? add_surface_quantities(model, all) : add_quantities(model, all);
}
void finding_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  if (only_solids(model)) return;
  model.surfaces ? add_surface_finding_tables(model, tables) : add_finding_tables(model, tables);
}
void mesh_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  model.surfaces ? add_surface_mesh_tables(model, tables) : add_mesh_tables(model, tables);
}
void mesh_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  model->surfaces ? add_surface_mesh_outputs(model, outputs) : add_mesh_outputs(model, outputs);
}
void draw_model(const model::Model& model, dobra::scene::Picture& picture) {
  if (only_solids(model)) return;
  model.surfaces ? draw_surfaces(model, picture) : draw(model, picture);
}

scenario::Operation mesh_operation() {
  auto operation = scenario::make_operation<model::Model, meshing::MeshParams>(
      "mesh", "Mesh", "Divides borders and fills the domain with triangles, or each surface: sizes first, then shapes.",
      mesh_model, {.tables = mesh_tables, .outputs = mesh_outputs});
  operation.run = [run = operation.run](const scenario::State& state, const scenario::Table& table,
                                        const scenario::Context& context,
                                        const base::Progress& progress) -> base::Result<scenario::State> {
    if (!scenario::model_of<model::Model>(state).surfaces || table.find("growth") != nullptr)
      return run(state, table, context, progress);
    scenario::Table own = table;
    own.set("growth", surf::mesh::SizeOptions{}.growth);
    return run(state, own, context, progress);
  };
  operation.stop_after = "stop_after";
  operation.at_work = mesher_at_work;
  return operation;
}

/// Nothing but another mesh may follow a mesh that is not done.
scenario::Operation after_a_whole_mesh(scenario::Operation operation) {
  operation.run = [run = operation.run](const scenario::State& state, const scenario::Table& table,
                                        const scenario::Context& context,
                                        const base::Progress& progress) -> base::Result<scenario::State> {
    if (mesher_at_work(state)) {
      return base::Error{base::ErrorCode::CannotMesh,
                         "the mesh before this step was stopped before it was done: set its stop_after to 0"};
    }
    return run(state, table, context, progress);
  };
  return operation;
}

/// Solids have no plane domain until they are cut.
scenario::Operation after_a_cut(scenario::Operation operation) {
  operation.run = [run = operation.run, name = operation.name](
                      const scenario::State& state, const scenario::Table& table, const scenario::Context& context,
                      const base::Progress& progress) -> base::Result<scenario::State> {
    if (only_solids(scenario::model_of<model::Model>(state))) {
      return base::Error{
          base::ErrorCode::BadDomain,
          fmt::format("`{}` needs a plane domain, and there are solids alone: put a step `cut` before it", name)};
    }
    return run(state, table, context, progress);
  };
  return operation;
}

/// What works on a plane domain has nothing to do with surfaces.
scenario::Operation of_plane_domains(scenario::Operation operation) {
  operation.run = [run = operation.run, name = operation.name](
                      const scenario::State& state, const scenario::Table& table, const scenario::Context& context,
                      const base::Progress& progress) -> base::Result<scenario::State> {
    if (scenario::model_of<model::Model>(state).surfaces) {
      return base::Error{base::ErrorCode::NotSupported,
                         fmt::format("`{}` is of plane domains; a mesh of surfaces goes on to the step `shell`, which "
                                     "writes it for other programs",
                                     name)};
    }
    return run(state, table, context, progress);
  };
  return operation;
}

scenario::UnitSystem units_of(const scenario::State& state) { return scenario::model_of<model::Model>(state).units; }

std::optional<bool> adapted_enough(const model::Model& model) {
  const bool adapted = std::any_of(model.analyses.begin(), model.analyses.end(),
                                   [](const auto& analysis) { return analysis->cycle > 0; });
  return adapted ? std::optional(!model.short_of_target) : std::nullopt;
}

struct OffsetKeeper {
  /// The curves of the domain by their names; arcs and splines as chords.
  static std::vector<io::lines::Feature> lines_of(const model::Model& model) {
    std::vector<io::lines::Feature> features;
    for (const sketch::Curve& curve : model.domain.curves)
      features.push_back({.type = io::lines::FeatureType::Lines, .parts = {trace(curve).line}, .name = curve.name});
    return features;
  }
  static std::size_t state_of(const model::Model&) { return 0; }
  static operations::AllOffsets all(const model::Model& model) {
    operations::AllOffsets all;
    for (const auto& one : model.offsets) all.push_back(one.get());
    return all;
  }
  static void add(model::Model& model, operations::Offsets made) {
    model.offsets.push_back(std::make_shared<const operations::Offsets>(std::move(made)));
  }
};

scenario::Program make_program() {
  scenario::Program program;
  program.name = "quebra";
  program.title = "QUEBRA";
  program.takes_units = scenario::TakesUnits::Any;
  program.input_fields = scenario::fields_of<InputParams>();
  program.read_input = input;
  program.draw_input = draw_input;
  program.draw_input_in_space = draw_input_in_space;
  program.nothing_yet = [](const scenario::Table& input) {
    constexpr std::array keys{"specimen", "file", "curve", "crack", "surface", "solids"};
    return std::none_of(keys.begin(), keys.end(), [&](const char* key) { return input.find(key) != nullptr; });
  };
  program.drawing = drawing();
  program.importing = importing();
  program.units_of = units_of;
  program.names_of = [](const scenario::State& state, const std::string& what) {
    const auto& model = scenario::model_of<model::Model>(state);
    std::vector<std::string> names;
    if (what == "part" && model.solids) {
      for (const auto& part : model.solids->parts) names.push_back(part.name);
      return names;
    }
    if (!model.surfaces) return names_in(model.domain, what);
    for (const auto& face : model.surfaces->faces) {
      if (what == "surface" || what == "region") add_once(face.name, names);
    }
    return names;
  };
  program.name_at = [](const scenario::State& state, const std::string& what,
                       const std::optional<dobra::scene::Pick>& line, geom::Point at) {
    return name_at(scenario::model_of<model::Model>(state).domain, what, line, at);
  };
  program.results = scenario::make_results<model::Model>({
      .quantities = quantities,
      .tables = finding_tables,
      .remarks = [](const model::Model& model, auto& remarks) { remarks = model.remarks; },
      .draw = draw_model,
      .draw_space =
          [](const model::Model& model, auto& picture) {
            if (!model.solids) draw_surfaces_in_space(model, picture);
          },
  });
  program.operations = {
      scenario::make_operation<model::Model, meshing::ConstraintParams>(
          "constraints", "Offset constraints",
          "Offset curves of a boundary, as internal constraints that grade the mesh.", meshing::add_constraints),
      scenario::make_operation<model::Model, meshing::ZoneParams>(
          "zone", "Zone of small elements",
          "Elements of a given size within a given distance of curves, cracks or points.", meshing::add_zone),
      scenario::make_operation<model::Model, meshing::HalfCrackParams>(
          "half_crack", "Half of a crack", "A curve of the boundary is one lip of a crack on a line of symmetry.",
          meshing::add_half_crack),
      mesh_operation(),
      scenario::make_operation<model::Model, surfaces::ShellParams>(
          "shell", "Shell", "Thickness, materials, supports and loads of a mesh of surfaces: decks for other programs.",
          surfaces::add_shell, {.quantities = surfaces::add_shell_quantities, .outputs = surfaces::add_shell_outputs}),
      problem_operation(),
      scenario::make_operation<model::Model, analysis::AnalyseParams>(
          "analyse", "Analyse", "Displacements, stresses and their error on the last mesh.", analysis::add_analysis,
          {.quantities = analysis::add_analysis_quantities,
           .tables = analysis::add_analysis_tables,
           .outputs = analysis::add_analysis_outputs}),
      scenario::make_operation<model::Model, analysis::AdaptParams>(
          "adapt", "Adapt", "Meshes and analyses until the error asked for is met.", analysis::adapt,
          {.reached = adapted_enough}),
      scenario::make_operation<model::Model, analysis::FractureParams>(
          "crack", "Stress intensity factors",
          "K_I and K_II by three methods, J, T and kink angles at every crack tip.", analysis::add_tips,
          {.quantities = analysis::add_tip_quantities,
           .tables = analysis::add_tip_tables,
           .reached = analysis::tips_reached}),
      scenario::make_operation<model::Model, analysis::LineParams>(
          "line", "Results along a line", "Displacements and stresses along a line, as a table.", analysis::add_line,
          {.tables = analysis::add_sample_tables}),
      scenario::make_operation<model::Model, analysis::ProbeParams>(
          "probe", "Results at a point", "Displacements and stresses at a point.", analysis::add_probe,
          {.quantities = analysis::add_sample_quantities}),
      scenario::make_operation<model::Model, ViewParams>(
          "view", "Picture of a field", "A field on the deformed shape: colours, contours, mesh, extremes.", add_view,
          {.draw = add_views}),
      operations::offset_operation<model::Model, OffsetKeeper>(),
  };
  for (scenario::Operation& operation : program.operations) {
    operation = after_a_cut(std::move(operation));
    if (operation.name == "mesh") continue;
    operation = after_a_whole_mesh(std::move(operation));
    if (operation.name != "shell") operation = of_plane_domains(std::move(operation));
  }
  for (scenario::Operation& operation : solid_operations()) program.operations.push_back(std::move(operation));
  return program;
}

}  // namespace

const scenario::Program& program() {
  static const scenario::Program table = make_program();
  return table;
}

}  // namespace quebra::core
