#include "quebra/cli/sheet_commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "shared/cli/findings.h"
#include "shared/cli/parameter_options.h"
#include "shared/cli/staging.h"
#include "shared/io/formats/boundary_file.h"
#include "shared/io/formats/mesh_file.h"
#include "shared/io/meshes/mesh_polygons.h"
#include "shared/surf/mesh/surface_elements.h"
#include "shared/surf/param/discrete_chart.h"
#include "shared/surf/param/recovered.h"
#include "shared/surf/remesh/remesh.h"

namespace quebra::cli {
namespace {

using namespace dobra;
using base::Error;
using base::Result;
using dobra::cli::Command;
using dobra::cli::Job;
using dobra::cli::Session;
using Json = nlohmann::ordered_json;
using Path = std::filesystem::path;

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <class Work>
Result<int> with_refusal(Session& session, Work&& work) {
  Result<int> done = work();
  if (!done) DOBRA_TRY_VOID(dobra::cli::tell_refusal(session, done.error()));
  return done;
}

/// Whether its elements may lie in space.
bool holds_shells(const io::formats::Format& format) {
  return format.mesh.has_value() && format.mesh->parse_in_space != nullptr;
}

/// Boundaries as solids have them, all other files of polygons in space, and elements on a surface.
Result<io::formats::PolygonsAndRemarks> read_sheet(const std::string& path) {
  const io::formats::Format* format = io::formats::format_of(path, io::formats::Use::ReadMesh);
  if (format == nullptr || io::formats::format_of(path, io::formats::Use::ReadPolygons) != nullptr)
    return io::formats::read_polygons_told(path);
  if (!holds_shells(*format)) {
    DOBRA_TRY(dobra::mesh::PolygonMesh boundary, io::formats::read_boundary(path));
    return io::formats::PolygonsAndRemarks{std::move(boundary), {}};
  }
  DOBRA_TRY(const io::formats::MeshContents contents, io::formats::read_mesh_in_space(path));
  return io::formats::PolygonsAndRemarks{io::meshes::polygons_of(contents.mesh, contents.heights), {}};
}

/// What was said of the file comes before what is found.
void put_remarks(const std::vector<io::Remark>& remarks, std::vector<surf::mesh::Finding>& findings) {
  std::vector<surf::mesh::Finding> all;
  for (const io::Remark& remark : remarks) all.push_back({"units_converted", remark.message, remark.place});
  findings.insert(findings.begin(), all.begin(), all.end());
}

std::vector<std::string> sheet_endings() {
  std::vector<std::string> endings = io::formats::boundary_endings();
  const auto add = [&](const std::string& ending) {
    if (std::find(endings.begin(), endings.end(), ending) == endings.end()) endings.push_back(ending);
  };
  for (const std::string& ending : io::formats::endings_for(io::formats::Use::ReadPolygons)) add(ending);
  for (const io::formats::Format& format : io::formats::all_formats()) {
    if (!io::formats::is_for(format, io::formats::Use::ReadMesh) || !holds_shells(format)) continue;
    for (const std::string& ending : format.endings) add(ending);
  }
  return endings;
}

Json point_json(geom::Point3 p) { return {p.x, p.y, p.z}; }

// ---- parametrise

/// What both commands have.
template <class P, class D>
void describe_weights(D& d) {
  d.choice("weights", &P::weights, {"shape-preserving", "mean-value"},
           {.title = "Weights", .help = "Of the neighbours of a point in the chart."});
}

struct ParametriseParams {
  surf::param::Weights weights = surf::param::Weights::ShapePreserving;
  surf::param::BorderShape border = surf::param::BorderShape::Auto;
  base::Angle corner = base::Angle::from_degrees(40.0);

  template <class D>
  static void describe(D& d) {
    describe_weights<ParametriseParams>(d);
    d.choice(
        "border", &ParametriseParams::border, {"stones", "circle", "auto"},
        {.title = "Border", .help = "Straight between stones, on a circle, or auto: stones where no triangle flips."});
    d.field("corner", &ParametriseParams::corner,
            {.title = "Corner",
             .help = "The border turns by at least so much at a stone.",
             .at_least = 1.0,
             .at_most = 179.0});
  }
};

struct ParametriseCommand {
  Path file;
  dobra::cli::OptionsOf<ParametriseParams> options{dobra::cli::OutOfRange::BadUsage};
  std::optional<Path> out;
};

const io::formats::Format& chart_format() { return *io::formats::format_named("vtu", io::formats::Use::WriteMesh); }

/// The chart as a plane mesh, with the place in space of its points and what is flipped.
Result<void> write_chart(const std::string& path, const surf::remesh::Charted& charted,
                         const std::vector<std::uint32_t>& patch_of) {
  const auto& sheet = charted.opened.sheet;
  dobra::mesh::TriangleMesh plane;
  plane.points = charted.parametrisation.uv;
  for (const auto& t : sheet.triangles)
    plane.triangles.push_back({dobra::mesh::NodeId(t[0]), dobra::mesh::NodeId(t[1]), dobra::mesh::NodeId(t[2])});
  plane.regions.assign(plane.triangles.size(), 0);
  io::meshes::MeshField position{"position", 3, {}}, flipped{"flipped", 1, {}}, patch{"patch", 1, {}};
  for (const geom::Point3 p : sheet.points) position.values.insert(position.values.end(), {p.x, p.y, p.z});
  flipped.values.assign(plane.triangles.size(), 0.0);
  for (const std::uint32_t t : charted.parametrisation.flipped) flipped.values[t] = 1.0;
  io::meshes::MeshFields fields{{position}, {flipped}};
  if (!patch_of.empty()) {
    patch.values.assign(patch_of.begin(), patch_of.end());
    fields.at_elements.push_back(std::move(patch));
  }
  return io::meshes::write_vtu(path, dobra::mesh::element_mesh_of(plane), fields);
}

/// The surfaces recovered from the chart; nothing of them where triangles are flipped.
std::vector<std::uint32_t> tell_recovery(const surf::remesh::Charted& charted, Json& json) {
  for (const char* key : {"border_gap", "border_gap_treated", "patches", "patches_merged", "patches_degraded"})
    json[key] = nullptr;
  if (!charted.parametrisation.flipped.empty()) return {};
  const auto chart =
      std::make_shared<const surf::param::DiscreteChart>(charted.opened.sheet, charted.parametrisation.uv);
  const surf::param::Recovered recovered(chart, {.meets = surf::param::Meets::Nothing});
  json["border_gap"] = recovered.border_gap();
  json["border_gap_treated"] = surf::param::Recovered(chart).border_gap();
  json["patches"] = recovered.patches().patches;
  json["patches_merged"] = recovered.patches().merged;
  json["patches_degraded"] = recovered.patches().degraded;
  const surf::param::Continuity jumps = recovered.continuity();
  json["jumps"] = {{"value", jumps.value}, {"recovered_derivative", jumps.recovered}, {"derivative", jumps.derivative}};
  return recovered.patches().patch_of;
}

Result<int> parametrise_job(Session& session, const ParametriseCommand& command) {
  DOBRA_TRY(const ParametriseParams params, command.options.read());
  if (command.out) {
    if (io::formats::format_of(command.out->string(), io::formats::Use::WriteMesh) != &chart_format())
      return Error{base::ErrorCode::BadUsage, fmt::format("--out {}: the chart is written as {}", command.out->string(),
                                                          fmt::join(chart_format().endings, " "))};
    DOBRA_TRY_VOID(dobra::cli::check_writable(*command.out));
  }
  const Stopwatch watch;
  DOBRA_TRY(const io::formats::PolygonsAndRemarks sheet, read_sheet(command.file.string()));
  auto charted = surf::remesh::chart_mesh(
      sheet.mesh, {.weights = params.weights, .border = params.border, .stones = {.turn = params.corner.degrees()}});
  if (!charted) return base::located(charted.error(), {.file = command.file.string()});
  put_remarks(sheet.remarks, charted->findings);
  const auto& chart = charted->parametrisation;
  Json json;
  json["stones"] = chart.stones.size();
  json["flipped"] = chart.flipped.size();
  Json recovery;
  const auto patch_of = tell_recovery(*charted, recovery);
  json.update(recovery);
  json["border"] = chart.border == surf::param::BorderShape::Circle ? "circle" : "stones";
  json["vertices"] = charted->opened.sheet.points.size();
  json["triangles"] = charted->opened.sheet.triangles.size();
  json["cut_sides"] = charted->opened.sides;
  json["cut_length"] = charted->opened.length;
  json["stone_places"] = Json::array();
  for (const std::uint32_t v : chart.stones) {
    json["stone_places"].push_back(
        {{"point", point_json(charted->opened.sheet.points[v])}, {"uv", Json{chart.uv[v].x, chart.uv[v].y}}});
  }
  json["seconds"] = watch.seconds();
  json["findings"] = dobra::cli::findings_json(charted->findings, {});
  if (command.out) {
    DOBRA_TRY_VOID(dobra::cli::write_whole(
        session, *command.out, [&](const Path& path) { return write_chart(path.string(), *charted, patch_of); }));
  }
  DOBRA_TRY_VOID(dobra::cli::tell(session, json, charted->findings));
  return 0;
}

// ---- remesh

struct RemeshParams {
  std::optional<double> size, chord;
  base::Angle crease = base::Angle::from_degrees(surf::remesh::RemeshOptions{}.crease);
  base::Angle corner = base::Angle::from_degrees(surf::remesh::RemeshOptions{}.corner);
  double growth = surf::remesh::RemeshOptions{}.growth;
  surf::param::Weights weights = surf::param::Weights::ShapePreserving;

  template <class D>
  static void describe(D& d) {
    d.field("size", &RemeshParams::size,
            {.title = "Size", .help = "Length of sides; the mean of the mesh where left out.", .above = 0.0});
    d.field(
        "chord", &RemeshParams::chord,
        {.title = "Chord", .help = "Most that the meshes may be apart; sides get smaller where needed.", .above = 0.0});
    d.field("crease", &RemeshParams::crease,
            {.title = "Crease",
             .help = "Where the mesh folds by more it keeps a line; 180 keeps none.",
             .at_least = 1.0,
             .at_most = 180.0});
    d.field("corner", &RemeshParams::corner,
            {.title = "Corner",
             .help = "Where the border turns by more it keeps a node.",
             .at_least = 1.0,
             .at_most = 179.0});
    d.field(
        "growth", &RemeshParams::growth,
        {.title = "Growth", .help = "Greatest ratio of the sizes of neighbours.", .at_least = 1.01, .at_most = 10.0});
    describe_weights<RemeshParams>(d);
  }
};

struct RemeshCommand {
  Path file;
  dobra::cli::OptionsOf<RemeshParams> options{dobra::cli::OutOfRange::BadUsage};
  std::optional<Path> out;
};

Result<surf::remesh::RemeshOptions> options_of(const RemeshCommand& command) {
  DOBRA_TRY(const RemeshParams params, command.options.read());
  surf::remesh::RemeshOptions options;
  options.size = params.size.value_or(0.0);
  options.chord = params.chord.value_or(0.0);
  options.crease = params.crease.degrees();
  options.corner = params.corner.degrees();
  options.growth = params.growth;
  options.weights = params.weights;
  return options;
}

bool is_boundary(const Path& path) { return io::formats::check_boundary_ending(path.string()).ok(); }

Result<void> write_remeshed(const std::string& path, const surf::mesh::SurfaceMesh& mesh) {
  if (is_boundary(path)) return io::formats::write_boundary(path, surf::mesh::to_polygon_mesh(mesh));
  const surf::mesh::SurfaceElements elements = surf::mesh::elements_of(mesh);
  return io::formats::write_mesh(path, elements.mesh, io::meshes::InpElement::Shell, elements.heights);
}

Json figures_of(const surf::remesh::Remeshed& made) {
  const surf::mesh::SurfaceQuality& quality = made.quality;
  Json json;
  json["elements"] = quality.triangles;
  json["nodes"] = quality.nodes;
  json["area"] = quality.area;
  json["alpha_mean"] = quality.alpha_mean;
  json["alpha_90"] = 100.0 * quality.alpha_90;
  json["alpha_min"] = quality.alpha_min;
  json["min_angle"] = quality.angle_min.degrees();
  json["max_angle"] = quality.angle_max.degrees();
  json["deviation"] = made.deviation;
  json["flipped"] = made.flipped;
  json["creases"] = made.creases;
  json["tips"] = made.tips;
  json["rounds"] = made.rounds;
  json["euler"] = quality.euler;
  json["borders"] = quality.loops;
  return json;
}

Result<int> remesh_job(Session& session, const RemeshCommand& command) {
  DOBRA_TRY(const surf::remesh::RemeshOptions options, options_of(command));
  if (command.out) {
    if (!is_boundary(*command.out))
      DOBRA_TRY_VOID(io::formats::check_mesh_ending(command.out->string(), io::formats::Use::WriteSpaceMesh));
    DOBRA_TRY_VOID(dobra::cli::check_writable(*command.out));
  }
  const Stopwatch watch;
  DOBRA_TRY(const io::formats::PolygonsAndRemarks sheet, read_sheet(command.file.string()));
  const double read = watch.seconds();
  auto made = surf::remesh::remesh(sheet.mesh, options, session.progress());
  if (!made) return base::located(made.error(), {.file = command.file.string()});
  put_remarks(sheet.remarks, made->findings);
  const double meshed = watch.seconds();
  Json json = figures_of(*made);
  if (command.out) {
    DOBRA_TRY_VOID(dobra::cli::write_whole(
        session, *command.out, [&](const Path& path) { return write_remeshed(path.string(), made->mesh); }));
  }
  json["seconds"] = {
      {"read", read}, {"remesh", meshed - read}, {"write", watch.seconds() - meshed}, {"total", watch.seconds()}};
  json["findings"] = dobra::cli::findings_json(made->findings, {});
  DOBRA_TRY_VOID(dobra::cli::tell(session, json, made->findings));
  return 0;
}

void add_mesh(CLI::App& app, Path& file) {
  app.add_option("mesh", file, fmt::format("Triangle mesh: {}", fmt::join(sheet_endings(), " ")))
      ->required()
      ->type_name("MESH");
}

}  // namespace

Command parametrise_command() {
  return {"parametrise", "Find the parameter space of a triangle mesh", [](CLI::App& app) -> Job {
            const auto command = std::make_shared<ParametriseCommand>();
            add_mesh(app, command->file);
            command->options.add(app);
            app.add_option("--out", command->out,
                           fmt::format("The chart as a plane mesh: {}", fmt::join(chart_format().endings, " ")))
                ->type_name("FILE");
            return [command](Session& session) {
              return with_refusal(session, [&] { return parametrise_job(session, *command); });
            };
          }};
}

Command remesh_command() {
  return {"remesh", "Mesh a triangle mesh anew through its parameter space", [](CLI::App& app) -> Job {
            const auto command = std::make_shared<RemeshCommand>();
            add_mesh(app, command->file);
            command->options.add(app);
            app.add_option("--out", command->out,
                           fmt::format("File to write: {}, or a format of meshes in space",
                                       fmt::join(io::formats::boundary_endings(), " ")))
                ->type_name("FILE");
            return [command](Session& session) {
              return with_refusal(session, [&] { return remesh_job(session, *command); });
            };
          }};
}

}  // namespace quebra::cli
