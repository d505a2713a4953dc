#include "quebra/cli/check_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "shared/io/file.h"
#include "shared/io/mesh_file.h"
#include "shared/io/polygon_file.h"
#include "shared/io/scan.h"
#include "shared/mesh/mesh_check.h"

namespace quebra::cli {
namespace {

using namespace dobra;
using base::Result;
using dobra::cli::Command;
using dobra::cli::Job;
using dobra::cli::Session;
using Json = nlohmann::ordered_json;

struct Options {
  std::string file;
  bool closed = false;
};

/// Counts, sets and faults of the mesh in the file.
struct Verdict {
  Json counts;
  Json sets = Json::array();
  std::vector<std::string> remarks;
  std::vector<std::string> faults;
};

Result<Verdict> of_polygons(const Options& options) {
  DOBRA_TRY(const mesh::PolygonMesh polygons, io::read_polygons(options.file));
  Verdict verdict;
  for (auto& finding : check(polygons, options.closed ? mesh::Closedness::Solid : mesh::Closedness::Sheet)) {
    verdict.faults.push_back(std::move(finding.message));
  }
  double furthest = 0.0;
  std::vector<mesh::Point3> corners;
  for (const auto& face : polygons.faces) {
    corners.clear();
    for (const std::uint32_t corner : face) corners.push_back(polygons.points[corner]);
    for (const double distance : mesh::distances_from_mean_plane(corners)) furthest = std::max(furthest, std::abs(distance));
  }
  verdict.counts = {{"points", polygons.points.size()},
                    {"edges", mesh::edges_of(polygons).size()},
                    {"faces", polygons.faces.size()},
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
    sets.push_back({{"name", name == mesh.region_names.end() ? fmt::format("{}", tag) : name->second}, {"kind", "region"}, {"count", count}});
  }
  for (const auto& [name, sides] : mesh.side_sets) sets.push_back({{"name", name}, {"kind", "sides"}, {"count", sides.size()}});
  for (const auto& [name, nodes] : mesh.node_sets) sets.push_back({{"name", name}, {"kind", "nodes"}, {"count", nodes.size()}});
  return sets;
}

Result<Verdict> of_elements(const Options& options) {
  DOBRA_TRY(const io::MeshContents contents, io::read_mesh(options.file));
  Verdict verdict;
  verdict.counts = {{"nodes", contents.mesh.points.size()}, {"elements", contents.mesh.element_count()}};
  verdict.sets = sets_of(contents.mesh);
  verdict.remarks = contents.remarks;
  for (const base::Error& inverted : io::inverted_elements(contents)) verdict.faults.push_back(base::to_string(inverted));
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

Result<int> check_job(Session& session, const Options& options) {
  const std::string ending = io::ending_of(options.file);
  DOBRA_TRY(const Verdict verdict, ending == ".obj" || ending == ".off" || ending == ".ply" ? of_polygons(options) : of_elements(options));
  for (const std::string& remark : verdict.remarks) session.note(remark);
  if (session.options.format == dobra::cli::OutputFormat::Json) {
    Json json = verdict.counts;
    json["sets"] = verdict.sets;
    json["faults"] = verdict.faults;
    json["remarks"] = verdict.remarks;
    DOBRA_TRY_VOID(dobra::cli::print(json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'));
  } else {
    std::string text;
    for (const std::string& fault : verdict.faults) text += fault + '\n';
    if (session.options.verbosity != dobra::cli::Verbosity::Quiet) {
      for (const auto& [name, value] : verdict.counts.items()) text += fmt::format("{:<14}{}\n", name, value.dump());
      for (const Json& set : verdict.sets) {
        text += fmt::format("{:<14}{} {}\n", set["kind"].get<std::string>(), set["count"].get<std::size_t>(), io::shown(set["name"].get<std::string>()));
      }
      text += fmt::format("{:<14}{}\n", "faults", verdict.faults.size());
    }
    DOBRA_TRY_VOID(dobra::cli::print(text));
  }
  return verdict.faults.empty() ? 0 : 1;
}

}  // namespace

Command check_command() {
  return {"check", "Say what is wrong with a mesh file", [](CLI::App& app) -> Job {
            const auto options = std::make_shared<Options>();
            app.add_option("file", options->file, "Polygon mesh (.obj .off .ply), or elements (.vtu .msh .msh2 .inp .bdf .nas .nf .ele .stl)")
                ->required()
                ->type_name("FILE");
            app.add_flag("--closed", options->closed, "The polygon mesh is to be closed: an edge of one face is a fault");
            return [options](Session& session) { return check_job(session, *options); };
          }};
}

}  // namespace quebra::cli
