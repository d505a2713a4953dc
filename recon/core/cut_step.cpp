#include "recon/core/cut_step.h"

#include <fmt/format.h>

#include "recon/core/report.h"
#include "recon/core/surface_step.h"

namespace recon::core {

namespace scenario = dobra::scenario;

namespace {

void add_cut_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  const auto* cut = model.findings.get<space::CutSection>();
  if (cut == nullptr) return;
  quantities.push_back({"cut.length", cut->trace.length(), "m"});
  quantities.push_back({"cut.horizons", count_of(cut->section.horizons.size()), ""});
}

void add_cut_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  if (const auto* cut = model.findings.get<space::CutSection>()) append(surface_remarks(cut->findings), remarks);
}

void add_cut_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  if (model->findings.get<space::CutSection>() == nullptr) return;
  outputs.push_back({"section.toml", [model](const std::filesystem::path& path) {
                       const auto* cut = model->findings.get<space::CutSection>();
                       return scenario::write_document(document_of(*cut, "Section cut from surfaces"), path);
                     }});
}

}  // namespace

scenario::Document document_of(const space::CutSection& cut, const std::string& title) {
  scenario::Document document;
  document.program = "recon";
  document.title = title;
  document.input = cut.input;
  return document;
}

base::Result<model::Model> run_cut(const model::Model& model, const space::CutParams& params, const scenario::Context&,
                                   const base::Progress&) {
  const auto* surfaces = model.findings.get<space::MadeSurfaces>();
  if (surfaces == nullptr)
    return base::Error{base::ErrorCode::CannotRestore, "there are no surfaces yet; put a step 'surface' before it"};
  DOBRA_TRY(space::CutSection cut, cut_section(*surfaces, params));
  model::Model next;
  next.findings = model.findings;
  next.remarks = model.remarks;
  append(cut.remarks, next.remarks);
  next.section = cut.section;
  next.findings.set(std::move(cut), {});
  return next;
}

scenario::Operation cut_step() {
  return scenario::make_operation<model::Model, space::CutParams>(
      "cut", "Cut a section", "A new section where a trace crosses the surfaces; the steps behind work on it.", run_cut,
      {.quantities = add_cut_quantities, .remarks = add_cut_remarks, .outputs = add_cut_outputs});
}

}  // namespace recon::core
