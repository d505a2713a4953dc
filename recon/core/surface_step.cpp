#include "recon/core/surface_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/core/report.h"
#include "recon/space/surface_file.h"
#include "shared/io/formats/line_files.h"

namespace recon::core {

namespace io = dobra::io;
namespace loft = dobra::surf::loft;
namespace scenario = dobra::scenario;

namespace {

const space::MadeSurfaces* surfaces_of(const model::Model& model) { return model.findings.get<space::MadeSurfaces>(); }

double greatest_mistie(const space::SurfaceRow& row) {
  double most = 0.0;
  for (const loft::Mistie& mistie : row.misties) most = std::max(most, std::abs(mistie.difference));
  return most;
}

void add_surface_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  const auto* made = surfaces_of(model);
  if (made == nullptr) return;
  quantities.push_back({"surfaces", count_of(made->rows.size()), ""});
  for (const space::SurfaceRow& row : made->rows) {
    const std::string prefix = "surface." + row.name + ".";
    quantities.push_back({prefix + "area", row.measures.area, "m2"});
    quantities.push_back({prefix + "dip_mean", row.measures.dip_mean.degrees(), "deg"});
    quantities.push_back({prefix + "pieces", count_of(row.pieces), ""});
    quantities.push_back({prefix + "greatest_mistie", greatest_mistie(row), "m"});
  }
  for (const space::VolumeRow& row : made->volumes)
    quantities.push_back({fmt::format("between.{}.{}.volume", row.upper, row.lower), row.volume.value, "m3"});
}

void add_surface_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  const auto* made = surfaces_of(model);
  if (made == nullptr) return;
  scenario::DataTable surfaces{
      "surfaces", {"surface", "kind", "area [m2]", "area on the map [m2]", "mean dip [deg]", "pieces"}, {}};
  scenario::DataTable misties{"misties", {"line", "section", "other section", "x [m]", "y [m]", "difference [m]"}, {}};
  scenario::DataTable volumes{"volumes", {"upper", "lower", "volume [m3]", "area on the map [m2]"}, {}};
  for (const space::SurfaceRow& row : made->rows)
    surfaces.rows.push_back({row.name, std::string(loft::kind_name(row.kind)), row.measures.area, row.measures.plan,
                             row.measures.dip_mean.degrees(), count_of(row.pieces)});
  for (const loft::Mistie& m : made->made.misties)
    misties.rows.push_back(
        {m.line, made->made.sections[m.first].name, made->made.sections[m.second].name, m.at.x, m.at.y, m.difference});
  for (const space::VolumeRow& row : made->volumes)
    volumes.rows.push_back({row.upper, row.lower, row.volume.value, row.volume.plan});
  tables.push_back(std::move(surfaces));
  if (!misties.rows.empty()) tables.push_back(std::move(misties));
  if (!volumes.rows.empty()) tables.push_back(std::move(volumes));
}

void add_surface_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  if (const auto* made = surfaces_of(model)) append(surface_remarks(made->made.findings), remarks);
}

std::vector<io::lines::Feature> contour_features(const space::MadeSurfaces& made) {
  std::vector<io::lines::Feature> features;
  for (std::size_t i = 0; i < made.contours.size(); ++i) {
    for (const loft::Contour& contour : made.contours[i]) {
      io::lines::Feature feature;
      feature.name = fmt::format("{} {:g} m", made.rows[i].name, contour.level);
      feature.kind = "contour";
      for (const auto& line : contour.lines) {
        geom::Polyline& part = feature.parts.emplace_back();
        std::vector<double>& heights = feature.heights.emplace_back();
        for (const geom::Point3 p : line) {
          if (!part.points.empty() && part.points.back() == geom::Point{p.x, p.y}) continue;
          part.points.push_back({p.x, p.y});
          heights.push_back(contour.level);
        }
        if (part.points.size() < 2) feature.parts.pop_back(), feature.heights.pop_back();
      }
      if (!feature.parts.empty()) features.push_back(std::move(feature));
    }
  }
  return features;
}

void add_surface_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  const auto* made = surfaces_of(*model);
  if (made == nullptr) return;
  outputs.push_back({"surfaces.ts", [model](const std::filesystem::path& path) {
                       return space::write_surfaces(path.string(), *surfaces_of(*model));
                     }});
  if (made->contours.empty()) return;
  outputs.push_back({"contours.geojson", [model](const std::filesystem::path& path) -> base::Result<void> {
                       io::formats::LineWork work;
                       work.features = contour_features(*surfaces_of(*model));
                       std::vector<std::string> losses;
                       return io::formats::write_any_lines(path.string(), work, {}, losses);
                     }});
}

}  // namespace

std::vector<std::string> surface_remarks(const std::vector<loft::Finding>& findings) {
  std::vector<std::string> remarks;
  for (const loft::Finding& finding : findings) {
    std::string at;
    if (finding.place.x && finding.place.y) {
      at = finding.place.z
               ? fmt::format(" at ({:.6g}, {:.6g}, {:.6g})", *finding.place.x, *finding.place.y, *finding.place.z)
               : fmt::format(" at ({:.6g}, {:.6g})", *finding.place.x, *finding.place.y);
    }
    remarks.push_back(finding.message + at);
  }
  return remarks;
}

base::Result<model::Model> run_surface(const model::Model& model, const space::SurfaceParams& params,
                                       const scenario::Context&, const base::Progress&) {
  const auto* placed = model.findings.get<space::PlacedSections>();
  if (placed == nullptr)
    return base::Error{base::ErrorCode::CannotRestore,
                       "the document holds one section; name several in [[input.section]], each with its file and its "
                       "trace"};
  model::Model next = model;
  DOBRA_TRY(space::MadeSurfaces made, make_surfaces(*placed, params));
  next.findings.set(std::move(made), {});
  return next;
}

scenario::Operation surface_step() {
  return scenario::make_operation<model::Model, space::SurfaceParams>(
      "surface", "Surfaces", "Horizons and faults as surfaces through equally named lines of several sections.",
      run_surface,
      {.quantities = add_surface_quantities,
       .tables = add_surface_tables,
       .remarks = add_surface_remarks,
       .outputs = add_surface_outputs});
}

}  // namespace recon::core
