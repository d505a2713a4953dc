#include "quebra/cli/check_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <variant>

#include "quebra/cli/input_file.h"
#include "quebra/core/layers.h"
#include "quebra/domain/selection.h"
#include "quebra/model/model.h"
#include "shared/cli/pictures.h"
#include "shared/cli/staging.h"
#include "shared/io/file.h"
#include "shared/io/formats/boundary_file.h"
#include "shared/io/formats/mesh_file.h"
#include "shared/io/meshes/mesh_polygons.h"
#include "shared/io/scan.h"
#include "shared/mesh/mesh_check.h"
#include "shared/mesh/polygon_surface.h"
#include "shared/scenario/runner.h"
#include "shared/surf/mesh/edge_in_space.h"
#include "shared/surf/trim/area.h"
#include "shared/surf/trim/open.h"

namespace quebra::cli {
namespace {

using namespace dobra;
using base::Result;
using dobra::cli::Command;
using dobra::cli::Job;
using dobra::cli::Session;
using Json = nlohmann::ordered_json;

struct CheckOptions {
  InputFile input;
  std::optional<std::filesystem::path> picture;
};

/// Counts and faults, sets of a mesh; curves, points and regions of geometry.
struct Verdict {
  Json counts;
  Json sets = Json::array();
  Json curves = Json::array();
  Json points = Json::array();
  Json regions = Json::array();
  Json surfaces = Json::array();
  std::vector<std::string> remarks;
  std::vector<std::string> faults;
};

Verdict of_polygons(const mesh::PolygonMesh& polygons, mesh::Closedness wanted) {
  const mesh::PolygonSurface surface = mesh::surface_of(polygons, wanted);
  Verdict verdict;
  const auto placed = [](const std::string& message, geom::Point3 p) {
    return base::to_string({base::ErrorCode::CannotMesh, message, base::Place{.x = p.x, .y = p.y, .z = p.z}});
  };
  for (const auto& fault : surface.faults) verdict.faults.push_back(placed(fault.message, fault.place));
  double furthest = 0.0;
  std::vector<geom::Point3> corners;
  for (const auto& face : polygons.faces) {
    corners.clear();
    for (const std::uint32_t corner : face) {
      if (corner < polygons.points.size()) corners.push_back(polygons.points[corner]);
    }
    if (corners.size() < 3) continue;
    for (const double distance : mesh::distances_from_mean_plane(corners))
      furthest = std::max(furthest, std::abs(distance));
  }
  const Json least = surface.triangles > 0 ? Json(surface.alpha_min) : Json(nullptr);
  verdict.counts = {{"points", polygons.points.size()},
                    {"edges", mesh::edges_of(polygons).size()},
                    {"faces", polygons.faces.size()},
                    {"triangles", surface.triangles},
                    {"parts", surface.parts},
                    {"borders", surface.borders},
                    {"open_edges", surface.open_edges},
                    {"shared_places", surface.shared_places},
                    {"area", surface.area},
                    {"alpha_min", least},
                    {"out_of_plane", furthest}};
  return verdict;
}

/// Name, kind and count of every set and region.
Json sets_of(const mesh::ElementMesh& mesh) {
  Json sets = Json::array();
  std::map<std::int32_t, std::size_t> regions;
  for (const std::int32_t region : mesh.regions) ++regions[region];
  for (const auto& [tag, count] : regions) {
    const auto name = mesh.region_names.find(tag);
    sets.push_back({{"name", name == mesh.region_names.end() ? fmt::format("{}", tag) : name->second},
                    {"kind", "region"},
                    {"count", count}});
  }
  for (const auto& [name, sides] : mesh.side_sets)
    sets.push_back({{"name", name}, {"kind", "sides"}, {"count", sides.size()}});
  for (const auto& [name, nodes] : mesh.node_sets)
    sets.push_back({{"name", name}, {"kind", "nodes"}, {"count", nodes.size()}});
  return sets;
}

/// Nodes that no element uses: what is left of a file that was cut short, or of an editor.
std::vector<std::string> lone_nodes(const mesh::ElementMesh& mesh) {
  std::vector<bool> used(mesh.points.size(), false);
  for (const mesh::NodeId node : mesh.nodes) used[node.index()] = true;
  const auto lone = std::count(used.begin(), used.end(), false);
  if (lone == 0) return {};
  const geom::Point first =
      mesh.points[static_cast<std::size_t>(std::find(used.begin(), used.end(), false) - used.begin())];
  return {fmt::format("nodes that belong to no element: {} of {}, the first at {}, {}; the file may be cut short", lone,
                      used.size(), first.x, first.y)};
}

/// Elements on a surface: their corners as polygons, with the sets that the file has.
Verdict of_shell(const io::formats::MeshContents& contents, mesh::Closedness wanted) {
  Verdict verdict = of_polygons(io::meshes::polygons_of(contents.mesh, contents.heights), wanted);
  verdict.sets = sets_of(contents.mesh);
  verdict.remarks = contents.remarks;
  std::ranges::move(lone_nodes(contents.mesh), std::back_inserter(verdict.remarks));
  if (std::any_of(contents.mesh.types.begin(), contents.mesh.types.end(), mesh::is_quadratic))
    verdict.remarks.emplace_back("nodes at mid-sides are not looked at: elements are judged by their corners");
  return verdict;
}

Result<Verdict> of_elements(const CheckOptions& options, mesh::Closedness wanted) {
  DOBRA_TRY(const io::formats::MeshContents contents,
            io::formats::read_mesh_in_space(options.input.scenario.file.string()));
  if (!contents.heights.empty()) return of_shell(contents, wanted);
  Verdict verdict;
  verdict.counts = {{"nodes", contents.mesh.points.size()}, {"elements", contents.mesh.element_count()}};
  verdict.sets = sets_of(contents.mesh);
  verdict.remarks = contents.remarks;
  std::ranges::move(lone_nodes(contents.mesh), std::back_inserter(verdict.remarks));
  for (const base::Error& inverted : io::formats::inverted_elements(contents))
    verdict.faults.push_back(base::to_string(inverted));
  if (const auto good = mesh::check(contents.mesh); !good) {
    verdict.faults.push_back(base::to_string(good.error()));
    return verdict;
  }
  const mesh::TopologyCounts topology = mesh::topology_of(mesh::triangle_mesh_of(contents.mesh));
  verdict.counts["area"] = mesh::area(contents.mesh);
  verdict.counts["components"] = topology.components;
  verdict.counts["holes"] = topology.holes();
  return verdict;
}

// --- geometry -------------------------------------------------------------------------------------------------------

const char* role_name(sketch::Role role) {
  constexpr std::array names{"boundary", "hole", "internal", "crack"};
  return names[static_cast<std::size_t>(role)];
}

std::string shape_name(const sketch::Curve& curve) {
  if (const auto* line = std::get_if<geom::Polyline>(&curve.shape)) return line->closed ? "polygon" : "line";
  if (std::holds_alternative<geom::Arc>(curve.shape)) return closed(curve) ? "circle" : "arc";
  return "spline";
}

/// Places and lengths in the units of the scenario.
class InUnits {
 public:
  explicit InUnits(const scenario::UnitSystem& units) : units_(units) {}
  Json operator()(geom::Point p) const { return Json::array({(*this)(p.x), (*this)(p.y)}); }
  double operator()(double value, const char* unit = "m") const { return units_.from_si(value, unit); }

 private:
  const scenario::UnitSystem& units_;
};

Json json_of(const sketch::Curve& curve, const InUnits& in_units) {
  const double all = length(curve);
  Json json{{"name", curve.name},      {"kind", role_name(curve.role)},       {"shape", shape_name(curve)},
            {"length", in_units(all)}, {"from", in_units(point(curve, 0.0))}, {"to", in_units(point(curve, all))}};
  if (curve.role == sketch::Role::Crack) {
    json["lips"] = {curve.name + "_left", curve.name + "_right"};
    json["tips"] = {curve.name + "_start", curve.name + "_end"};
  }
  if (!curve.groups.empty()) json["groups"] = curve.groups;
  return json;
}

/// The names that steps may use, each with its place.
Verdict of_domain(const model::Model& model) {
  const domain::Domain& domain = model.domain;
  const InUnits in_units(model.units);
  Verdict verdict;
  verdict.counts = {{"curves", domain.curves.size()}, {"loops", domain.loops.size()}, {"parts", domain.faces.size()}};
  for (const sketch::Curve& curve : domain.curves) verdict.curves.push_back(json_of(curve, in_units));
  // Sides of an outline have no names: they are found by their place.
  constexpr std::size_t few = 12;
  const auto parts = domain::boundary_parts(domain);
  for (std::size_t i = 0; i < parts.size();) {
    const auto end = std::find_if(parts.begin() + static_cast<std::ptrdiff_t>(i), parts.end(),
                                  [&](const auto& part) { return part.curve != parts[i].curve; });
    const auto count = static_cast<std::size_t>(end - parts.begin()) - i;
    Json& sides = verdict.curves[parts[i].curve]["sides"];
    sides = count;
    if (count > 1 && count <= few) {
      sides = Json::array();
      for (std::size_t k = i; k < i + count; ++k)
        sides.push_back({{"from", in_units(parts[k].start)}, {"to", in_units(parts[k].end)}});
    }
    i += count;
  }
  for (const sketch::NamedPoint& point : domain.points) {
    if (!point.name.empty()) verdict.points.push_back({{"name", point.name}, {"at", in_units(point.at)}});
  }
  for (const auto& [tag, name] : domain.region_names) {
    double area = 0.0;
    for (const domain::Face& face : domain.faces) area += face.region == tag ? face.area : 0.0;
    verdict.regions.push_back({{"name", name}, {"area", in_units(area, "m2")}});
  }
  return verdict;
}

/// Names of borders and lines of a face, with their lengths in space.
Json lines_of(const surf::trim::TrimmedSurface& face, const InUnits& in_units) {
  Json lines = Json::array();
  const auto add = [&](const surf::trim::ChartEdge& edge, const char* kind, double part = 1.0) {
    if (edge.name.empty() || edge.name == surf::trim::artificial_border) return;
    const double own = part * in_units(surf::mesh::EdgeInSpace(face.surface, edge).length());
    const auto known =
        std::find_if(lines.begin(), lines.end(), [&](const Json& line) { return line["name"] == edge.name; });
    if (known != lines.end()) {
      (*known)["length"] = (*known)["length"].get<double>() + own;
    } else {
      lines.push_back({{"name", edge.name}, {"kind", kind}, {"length", own}});
    }
  };
  for (const auto& loop : face.loops) {
    for (const auto& edge : loop.edges) {
      if (edge.crack == surf::trim::ChartEdge::Crack::None) {
        add(edge, "border");
      } else {
        add(edge, "crack", 0.5);  // the seam has two sides
      }
    }
  }
  for (const auto& line : face.lines) {
    const bool crack = line.kind == surf::trim::ChartLine::Kind::Crack;
    for (const auto& edge : line.edges) add(edge, crack ? "crack" : "internal");
  }
  return lines;
}

/// Surfaces, by their names: areas, borders, lines and points.
Verdict of_surfaces(const model::Model& model) {
  const InUnits in_units(model.units);
  Verdict verdict;
  verdict.counts = {{"surfaces", model.surfaces->faces.size()}};
  for (const surf::trim::TrimmedSurface& face : model.surfaces->faces) {
    Json points = Json::array();
    for (const auto& point : face.points) {
      const geom::Point3 at = face.surface.at(point.at);
      if (!point.name.empty())
        points.push_back({{"name", point.name}, {"at", {in_units(at.x), in_units(at.y), in_units(at.z)}}});
    }
    verdict.surfaces.push_back({{"name", face.name},
                                {"area", in_units(surf::trim::area(face).value, "m2")},
                                {"lines", lines_of(face, in_units)},
                                {"points", points}});
  }
  return verdict;
}

/// A scenario's input, or a file of geometry.
Result<Verdict> of_geometry(Session& session, const CheckOptions& options) {
  if (options.picture) DOBRA_TRY_VOID(dobra::cli::check_writable(*options.picture));
  DOBRA_TRY(scenario::Document document, document_of(session, options.input));
  document.steps.clear();
  document.expects.clear();
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  scenario::Runner runner(session.program);
  const scenario::Run run = runner.run(document, session.progress());
  if (run.error) return *run.error;
  const auto& model = scenario::model_of<model::Model>(run.states.back());
  if (options.picture && model.surfaces) {
    return base::Error{base::ErrorCode::BadUsage,
                       "--picture draws the curves of a plane domain, and these are surfaces; `quebra mesh --picture` "
                       "draws them with their mesh"};
  }
  if (options.picture)
    DOBRA_TRY_VOID(dobra::cli::draw(in_units(core::names_picture(model), model.units), *options.picture,
                                    dobra::cli::Drawer::Cairo));
  Verdict verdict = model.surfaces ? of_surfaces(model) : of_domain(model);
  verdict.remarks = session.program.remarks_of(run.states.back());
  return verdict;
}

std::string place_text(const Json& at) {
  return fmt::format("({:.6g}, {:.6g})", at[0].get<double>(), at[1].get<double>());
}

/// A line for every curve with its place, below it those of its sides.
std::string curves_text(const Verdict& verdict) {
  std::string text;
  const auto name_of = [](const Json& item) { return io::shown(item["name"].get<std::string>()); };
  const auto from_to = [](const Json& item) {
    if (item["from"] == item["to"]) return fmt::format("closed, through {}", place_text(item["from"]));
    return fmt::format("from {} to {}", place_text(item["from"]), place_text(item["to"]));
  };
  for (const Json& curve : verdict.curves) {
    text += fmt::format("{:<13} {:<9} {:<8} length {:<10.6g} {}\n", name_of(curve), curve["kind"].get<std::string>(),
                        curve["shape"].get<std::string>(), curve["length"].get<double>(), from_to(curve));
    for (const char* const key : {"lips", "tips", "groups"}) {
      if (curve.contains(key))
        text += fmt::format("  {} {}\n", key, fmt::join(curve[key].get<std::vector<std::string>>(), ", "));
    }
    if (!curve.contains("sides") || !curve["sides"].is_array()) continue;
    for (const Json& side : curve["sides"]) text += fmt::format("  side {}\n", from_to(side));
  }
  for (const Json& point : verdict.points)
    text += fmt::format("{:<13} point     at {}\n", name_of(point), place_text(point["at"]));
  for (const Json& region : verdict.regions)
    text += fmt::format("{:<13} region    area {:.6g}\n", name_of(region), region["area"].get<double>());
  return text;
}

/// A line for every surface, below it those of its borders, lines and points.
std::string surfaces_text(const Verdict& verdict) {
  std::string text;
  const auto name_of = [](const Json& item) { return io::shown(item["name"].get<std::string>()); };
  for (const Json& surface : verdict.surfaces) {
    text += fmt::format("{:<13} surface   area {:.6g}\n", name_of(surface), surface["area"].get<double>());
    for (const Json& line : surface["lines"])
      text += fmt::format("  {:<8} {:<20} length {:.6g}\n", line["kind"].get<std::string>(), name_of(line),
                          line["length"].get<double>());
    for (const Json& point : surface["points"])
      text += fmt::format("  {:<8} {:<20} at ({:.6g}, {:.6g}, {:.6g})\n", "point", name_of(point),
                          point["at"][0].get<double>(), point["at"][1].get<double>(), point["at"][2].get<double>());
  }
  return text;
}

// --- either ----------------------------------------------------------------------------------------------------------

/// In a plane z = constant.
bool lies_flat(const mesh::PolygonMesh& polygons) {
  const auto above = [](geom::Point3 a, geom::Point3 b) { return a.z < b.z; };
  const auto [low, high] = std::minmax_element(polygons.points.begin(), polygons.points.end(), above);
  return low == polygons.points.end() || low->z == high->z;
}

Result<Verdict> verdict_of(Session& session, const CheckOptions& options) {
  using io::formats::format_of, io::formats::Use;
  const std::string file = options.input.scenario.file.string();
  if (format_of(file, Use::ReadMesh) == nullptr) return of_geometry(session, options);
  if (options.picture)
    return base::Error{base::ErrorCode::BadUsage,
                       "--picture draws the curves of a scenario or a file of geometry, and this is a mesh; `quebra "
                       "convert` and `quebra mesh` draw others"};
  scenario::Table said;
  DOBRA_TRY_VOID(options.input.input.set(session.program.input_fields, said));
  const bool solid = said.find("closed") != nullptr;
  const mesh::Closedness wanted = solid ? mesh::Closedness::Solid : mesh::Closedness::Sheet;
  if (format_of(file, Use::ReadPolygons) != nullptr) {
    DOBRA_TRY(const io::formats::PolygonsAndRemarks read, io::formats::read_polygons_told(file));
    Verdict verdict = of_polygons(read.mesh, wanted);
    for (const io::Remark& remark : read.remarks) verdict.remarks.push_back(to_string(remark));
    return verdict;
  }
  if (io::formats::check_boundary_ending(file).ok()) {
    DOBRA_TRY(const mesh::PolygonMesh polygons, io::formats::read_boundary(file));
    if (!lies_flat(polygons)) return of_polygons(polygons, wanted);
  }
  return of_elements(options, wanted);
}

std::string plain_text(const Verdict& verdict) {
  std::string text;
  for (const auto& [name, value] : verdict.counts.items()) text += fmt::format("{:<13} {}\n", name, value.dump());
  for (const Json& set : verdict.sets) {
    text += fmt::format("{:<13} {} {}\n", set["kind"].get<std::string>(), set["count"].get<std::size_t>(),
                        io::shown(set["name"].get<std::string>()));
  }
  return text + curves_text(verdict) + surfaces_text(verdict) +
         fmt::format("{:<13} {}\n", "faults", verdict.faults.size());
}

Json json_of(const Verdict& verdict) {
  Json json = verdict.counts;
  if (!verdict.surfaces.empty()) {
    json["surfaces"] = verdict.surfaces;
  } else if (!verdict.curves.empty()) {
    json["curves"] = verdict.curves;
    json["points"] = verdict.points;
    json["regions"] = verdict.regions;
  } else {
    json["sets"] = verdict.sets;
  }
  json["faults"] = verdict.faults;
  json["remarks"] = verdict.remarks;
  return json;
}

Result<int> check_job(Session& session, const CheckOptions& options) {
  if (options.picture) DOBRA_TRY_VOID(dobra::cli::check_ending(*options.picture, dobra::cli::Drawer::Cairo));
  DOBRA_TRY(const Verdict verdict, verdict_of(session, options));
  for (const std::string& remark : verdict.remarks) session.note(remark);
  if (session.options.format == dobra::cli::OutputFormat::Json) {
    DOBRA_TRY_VOID(dobra::cli::print(json_of(verdict).dump(2, ' ', false, Json::error_handler_t::replace) + '\n'));
  } else {
    std::string text;
    for (const std::string& fault : verdict.faults) text += fault + '\n';
    if (session.options.verbosity != dobra::cli::Verbosity::Quiet) text += plain_text(verdict);
    DOBRA_TRY_VOID(dobra::cli::print(text));
  }
  return verdict.faults.empty() ? 0 : 1;
}

}  // namespace

Command check_command() {
  return {"check",
          "Say what is wrong with a mesh file (with --closed an open edge of a polygon mesh too); list the names of a "
          "scenario or a file of geometry",
          [](CLI::App& app) -> Job {
            const auto options = std::make_shared<CheckOptions>();
            app.add_option("file", options->input.scenario.file,
                           fmt::format("Mesh ({}), scenario (.toml) or geometry ({} {})",
                                       fmt::join(io::formats::endings_for(io::formats::Use::ReadMesh), " "),
                                       fmt::join(io::formats::endings_for(io::formats::Use::ReadDrawing), " "),
                                       fmt::join(io::formats::endings_for(io::formats::Use::ReadLines), " ")))
                ->required()
                ->type_name("FILE");
            add_input_options(app, options->input);
            app.add_option("--picture", options->picture, "Draw the curves with their names")
                ->type_name("FILE.svg|pdf|png");
            return [options](Session& session) { return check_job(session, *options); };
          }};
}

}  // namespace quebra::cli
