#include "recon/core/operations.h"

#include "recon/core/input.h"
#include "recon/core/layers.h"
#include "recon/core/report.h"
#include "recon/core/section_check.h"
#include "recon/core/section_faces.h"
#include "recon/core/topography.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace scene = dobra::scene;

namespace {

/// What no method can take for granted of a section.
base::Result<void> check_section(Section& section, Crossings crossings) {
  if (!section.faces) {
    DOBRA_TRY(SectionFaces faces, faces_of(section));
    section.faces = std::make_shared<const SectionFaces>(std::move(faces));
  }
  if (crossings == Crossings::Refuse) DOBRA_TRY_VOID(refuse_crossings(section, *section.faces));
  return refuse_lines_outside(section);
}

/// A new stage in hand with nothing but its section. What a stage gave that was not restored is forgotten.
base::Result<Model> next_stage(const Model& model, GridFrom from) {
  Model next;
  next.remarks = model.remarks;
  next.area_depth = model.area_depth;
  next.area_balance = model.area_balance;
  if (from == GridFrom::Input) {
    next.section = input_section(model);
    return next;
  }
  next.earlier = model.earlier;
  if (!model.restoration) {
    next.section = model.section;
    return next;
  }
  DOBRA_TRY(next.section, section_after(model));
  next.earlier.push_back(std::make_shared<const Stage>(model));
  return next;
}

}  // namespace

base::Result<Model> run_grid(const Model& model, const GridParams& params, const scenario::Context&,
                             const base::Progress& progress) {
  DOBRA_TRY(Model next, next_stage(model, params.from));
  DOBRA_TRY(next.section, with_topography_as_horizon(std::move(next.section), params.top));
  DOBRA_TRY(next.source, make_source_grid(next.section, params, progress));
  return next;
}

base::Result<Model> run_target(const Model& model, const TargetParams& params, const scenario::Context& context,
                               const base::Progress& progress) {
  if (!model.source) {
    return base::Error{base::ErrorCode::CannotRestore,
                       "a target needs a source grid first; put a step 'grid' before it"};
  }
  Model next = model;
  next.restoration.reset();
  next.monte_carlo.reset();
  next.carried.reset();
  DOBRA_TRY(next.target, make_target(model.section, *model.source, params, context, progress));
  return next;
}

base::Result<Model> run_restore(const Model& model, const RestoreParams& params, const scenario::Context&,
                                const base::Progress& progress) {
  if (!model.source || !model.target) {
    const char* missing =
        model.source ? "restore needs a target first; put a step 'target' before it"
                     : "restore needs a source grid and a target first; put the steps 'grid' and 'target' before it";
    return base::Error{base::ErrorCode::CannotRestore, missing};
  }
  Model next = model;
  next.monte_carlo.reset();
  next.carried.reset();
  DOBRA_TRY_VOID(check_section(next.section, params.crossings));
  DOBRA_TRY(next.restoration, restore(next.section, *model.source, *model.target, params, progress));
  return next;
}

base::Result<Model> run_balance(const Model& model, const BalanceParams& params, const scenario::Context&,
                                const base::Progress&) {
  Section section = input_section(model);
  DOBRA_TRY_VOID(check_section(section, params.crossings));
  Model next = model;
  DOBRA_TRY(next.area_depth, area_depth(section, params));
  if (model.earlier.empty()) next.section = std::move(section);  // it may have got its faces
  return next;
}

base::Result<Model> run_area_balance(const Model& model, const AreaBalanceParams& params,
                                     const scenario::Context& context, const base::Progress&) {
  Model next = model;
  DOBRA_TRY(next.area_balance, balance_area(params, context));
  return next;
}

base::Result<Model> run_monte_carlo(const Model& model, const MonteCarloParams& params, const scenario::Context&,
                                    const base::Progress& progress) {
  if (!model.restoration) {
    return base::Error{base::ErrorCode::CannotRestore,
                       "error bars need a restoration first; put a step 'restore' before it"};
  }
  Model next = model;
  DOBRA_TRY(next.monte_carlo,
            monte_carlo(model.section, *model.source, *model.target, model.restoration->params, params, progress));
  return next;
}

base::Result<Model> run_carry(const Model& model, const CarryParams& params, const scenario::Context& context,
                              const base::Progress&) {
  const std::vector<const Stage*> chain = restored_stages(model);
  if (chain.empty()) {
    return base::Error{base::ErrorCode::CannotRestore,
                       "nothing is restored yet that could carry a line; put a step 'restore' before it"};
  }
  Model next = model;
  DOBRA_TRY(next.carried, carry_lines(chain, params, context));
  return next;
}

namespace {

base::Result<scenario::State> read_input(const scenario::Table& table, const scenario::Context& context,
                                         const base::Progress& progress) {
  DOBRA_TRY(ReadSection read, read_section(scenario::from_table<SectionInput>(table), context, progress));
  Model model;
  model.section = std::move(read.section);
  model.remarks = std::move(read.remarks);
  return scenario::make_state(std::move(model));
}

scenario::Program make_program() {
  scenario::Program recon;
  recon.name = "recon";
  recon.title = "RECON";
  recon.input_fields = scenario::fields_of<SectionInput>();
  recon.read_input = read_input;
  recon.results = scenario::make_results<Model>({
      .quantities = [](const Model& model, auto& list) { list = quantities_of(model); },
      .tables = [](const Model& model, auto& list) { list = tables_of(model); },
      .remarks = [](const Model& model, auto& list) { list = remarks_of(model); },
      .outputs = [](const std::shared_ptr<const Model>& model, auto& list) { list = outputs_of(model); },
      .draw = [](const Model& model, scene::Picture& picture) { picture = picture_of(model); },
  });
  recon.operations = {
      scenario::make_operation<Model, GridParams>(
          "grid", "Source grid", "Offset curves of the top of the section and the transversals between them.",
          run_grid),
      scenario::make_operation<Model, TargetParams>(
          "target", "Target", "The geometry to which the top is restored, a datum or a line, held at a pin.",
          run_target),
      scenario::make_operation<Model, RestoreParams>(
          "restore", "Restore", "Carries every point of the section from the source grid to the target grid.",
          run_restore),
      scenario::make_operation<Model, CarryParams>(
          "carry", "Carry", "Points, lines or polygons of one state of the section, carried to another, forward or back.",
          run_carry),
      scenario::make_operation<Model, MonteCarloParams>(
          "monte_carlo", "Error bars",
          "Restores the section again and again with picks, pin and angle drawn from their errors.", run_monte_carlo),
      scenario::make_operation<Model, BalanceParams>(
          "balance", "Balance", "Bed lengths, excess areas and the depth of the detachment of the section as it is.",
          run_balance),
      scenario::make_operation<Model, AreaBalanceParams>(
          "area_balance", "Area balance",
          "Shortening from the area of a section and the thickness that its layers had, with errors.",
          run_area_balance)};
  return recon;
}

}  // namespace

const scenario::Program& program() {
  static const scenario::Program recon = make_program();
  return recon;
}

}  // namespace recon::core
