// figures FOLDER [svg|png [BEGINNING]]: writes every figure of docs/algorithms, and the pictures of bundled
// examples that pages show; or those whose names begin so. To be run in the top folder of the sources, where
// resources/examples are.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "quebra/core/operations.h"
#include "recon/core/operations.h"
#include "shared/base/check.h"
#include "shared/cli/pictures.h"
#include "shared/render/cairo.h"
#include "shared/scenario/runner.h"
#include "tests/figures/figures.h"

namespace dobra::figures {
namespace {

using Folder = std::filesystem::path;

base::Result<void> write_figure(const Figure& figure, const Folder& folder, const std::string& ending) {
  DOBRA_TRY(const scene::Picture picture, figure.make());
  const scene::PageSize page = scene::suggested_page(picture, figure.width, render::cairo_text_measure());
  if (figure.pixels) return render::write_png(picture, folder / (figure.name + ".png"), page, 1.5);
  return render::write_picture(picture, folder / (figure.name + "." + ending), page);
}

/// What a program draws after the last step of a scenario.
base::Result<void> write_example(const scenario::Program& program, const Folder& scenario, const Folder& file) {
  DOBRA_TRY(const scenario::Document document, scenario::read_document(scenario));
  const scenario::Run run = scenario::Runner(program).run(document);
  if (!run.complete()) return *run.error;
  return render::write_png(cli::picture_of(program, document, run.states.back()), file, std::nullopt, 2.0);
}

/// What it draws in space.
base::Result<void> write_space(const scenario::Program& program, const scenario::Document& document,
                               const Folder& file) {
  const scenario::Run run = scenario::Runner(program).run(document);
  if (!run.complete()) return *run.error;
  const auto picture = program.space_of(run.states.back());
  DOBRA_CHECK(picture.has_value());
  return cli::draw(*picture, file, cli::Drawer::Cairo);
}

base::Result<void> write_space_example(const scenario::Program& program, const Folder& scenario, const Folder& file) {
  DOBRA_TRY(const scenario::Document document, scenario::read_document(scenario));
  return write_space(program, document, file);
}

/// A crack on a cylinder, with bands and rosettes.
base::Result<void> write_bands_on_surface(const Folder& file) {
  DOBRA_TRY(const scenario::Document document,
            scenario::parse_document("dobra = 1\nprogram = \"quebra\"\n"
                                     "[[input.surface]]\nname = \"panel\"\nkind = \"cylinder\"\nradius = 10\n"
                                     "u = [72, 108]\nv = [0, 8]\n"
                                     "[[input.trim]]\nname = \"crack\"\nrole = \"crack\"\n"
                                     "points = [[82, 4], [98, 4]]\nbands = [0.6, 1.2]\nrosette = 0.3\n"
                                     "[[step]]\noperation = \"mesh\"\nsize = 0.7\n",
                                     "bands"));
  return write_space(quebra::core::program(), document, file);
}

/// Says what went wrong, if anything; how many times something did.
int failures(const std::string& name, const base::Result<void>& written) {
  if (written) return 0;
  fmt::print(stderr, "figures: {}: {}\n", name, base::to_string(written.error()));
  return 1;
}

int write_all(const Folder& folder, const std::string& ending, const std::string& beginning) {
  int failed = 0;
  const auto asked = [&](const std::string& name) { return name.starts_with(beginning); };
  for (const auto& family : {geom_figures(), topo_figures(), offset_figures(), recon_figures(), fault_figures(),
                             mesh_figures(), quality_figures(), surf_figures(), trim_figures(), paper_figures(),
                             import_figures(), free_border_figures(), param_figures(), loft_figures()}) {
    for (const Figure& figure : family) {
      if (asked(figure.name)) failed += failures(figure.name, write_figure(figure, folder, ending));
    }
  }
  for (const std::string name : {"boolean", "sweeps", "section_loft", "csg", "cap", "section_block"}) {
    if (asked(name)) failed += failures(name, write_solids(name, folder / (name + "." + ending)));
  }
  if (asked("projection")) failed += failures("projection", write_projection(folder / ("projection." + ending)));
  const Folder examples = "resources/examples";
  if (asked("fold")) {
    failed +=
        failures("fold", write_example(recon::core::program(), examples / "recon/fold.toml", folder / "fold.png"));
  }
  if (asked("plate_with_hole")) {
    failed +=
        failures("plate_with_hole", write_example(quebra::core::program(), examples / "quebra/plate_with_hole.toml",
                                                  folder / "plate_with_hole.png"));
  }
  if (asked("cracked_shell")) {
    failed +=
        failures("cracked_shell", write_space_example(quebra::core::program(), examples / "surfaces/cracked_shell.toml",
                                                      folder / "cracked_shell.png"));
  }
  if (asked("sections_in_space")) {
    failed += failures("sections_in_space", write_space_example(recon::core::program(), examples / "recon/space.toml",
                                                                folder / "sections_in_space.png"));
  }
  if (asked("bands_on_surface"))
    failed += failures("bands_on_surface", write_bands_on_surface(folder / "bands_on_surface.png"));
  return failed;
}

}  // namespace
}  // namespace dobra::figures

int main(int argc, char** argv) {
  const std::string ending = argc >= 3 ? argv[2] : "svg";
  if (argc < 2 || argc > 4 || (ending != "svg" && ending != "png")) {
    fmt::print(stderr, "usage: figures FOLDER [svg|png [BEGINNING]]\n");
    return 2;
  }
  std::error_code error;
  std::filesystem::create_directories(argv[1], error);
  if (error) {
    fmt::print(stderr, "figures: cannot make the folder {}: {}\n", argv[1], error.message());
    return 4;
  }
  return dobra::figures::write_all(argv[1], ending, argc == 4 ? argv[3] : "") == 0 ? 0 : 4;
}
