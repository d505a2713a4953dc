#include "shared/io/formats/mesh_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <utility>

#include "shared/io/file.h"
#include "shared/io/meshes/bdf.h"
#include "shared/io/meshes/inp.h"
#include "shared/io/meshes/mesh_polygons.h"
#include "shared/io/meshes/mesh_sides.h"
#include "shared/io/meshes/msh.h"
#include "shared/io/meshes/neutral.h"
#include "shared/io/meshes/node_ele.h"
#include "shared/io/meshes/polygon_file.h"
#include "shared/io/meshes/vtu.h"
#include "shared/io/scan.h"
#include "shared/mesh/surface_text.h"

namespace dobra::io::formats {

using base::Error;
using base::ErrorCode;
using base::Result;
using mesh::ElementId;
using mesh::ElementMesh;

namespace {

using Write = Result<void> (*)(const std::string& path, const ElementMesh& mesh, meshes::InpElement element);

Result<void> write_pair(const std::string& path, const ElementMesh& mesh, meshes::InpElement) {
  return meshes::write_node_ele(std::filesystem::path(path).replace_extension().string(), mesh);
}

template <meshes::PolygonFormat format>
Result<void> write_polygons(const std::string& path, const ElementMesh& mesh, meshes::InpElement) {
  DOBRA_TRY_VOID(meshes::check_writable(mesh));
  return write_file(path, meshes::polygons_text(meshes::polygons_of(mesh), format));
}

Result<void> write_stl(const std::string& path, const ElementMesh& mesh, meshes::InpElement) {
  DOBRA_TRY_VOID(meshes::check_writable(mesh));
  return write_text(path, mesh::surface_text(triangle_mesh_of(mesh), mesh::SurfaceFormat::Stl));
}

Result<void> write_graph(const std::string& path, const ElementMesh& mesh, meshes::InpElement) {
  DOBRA_TRY_VOID(meshes::check_writable(mesh));
  return meshes::write_poly(path, meshes::poly_of(mesh));
}

const std::vector<std::pair<std::string, Write>>& writers() {
  static const std::vector<std::pair<std::string, Write>> table = {
      {".vtu", [](const std::string& path, const ElementMesh& mesh,
                  meshes::InpElement) { return meshes::write_vtu(path, mesh); }},
      {".msh", [](const std::string& path, const ElementMesh& mesh,
                  meshes::InpElement) { return meshes::write_msh(path, mesh); }},
      {".msh2", [](const std::string& path, const ElementMesh& mesh,
                   meshes::InpElement) { return meshes::write_msh(path, mesh, meshes::MshVersion::V22); }},
      {".inp", [](const std::string& path, const ElementMesh& mesh,
                  meshes::InpElement element) { return meshes::write_inp(path, mesh, {.element = element}); }},
      {".bdf", [](const std::string& path, const ElementMesh& mesh,
                  meshes::InpElement) { return meshes::write_bdf(path, mesh); }},
      {".nas", [](const std::string& path, const ElementMesh& mesh,
                  meshes::InpElement) { return meshes::write_bdf(path, mesh); }},
      {".nf",
       [](const std::string& path, const ElementMesh& mesh, meshes::InpElement) {
         return meshes::write_neutral(path, {mesh, {}, 1.0});
       }},
      {".node", write_pair},
      {".ele", write_pair},
      {".poly", write_graph},
      {".obj", write_polygons<meshes::PolygonFormat::Obj>},
      {".ply", write_polygons<meshes::PolygonFormat::Ply>},
      {".stl", write_stl},
      {".off", write_polygons<meshes::PolygonFormat::Off>}};
  return table;
}

Write writer_of(const std::string& path) {
  const std::string ending = ending_of(path);
  const auto& all = writers();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.first == ending; });
  return found == all.end() ? nullptr : found->second;
}

template <auto read>
Result<MeshContents> contents_of(const std::string& path) {
  DOBRA_TRY(auto all, read(path));
  MeshContents contents;
  contents.mesh = std::move(all.mesh);
  if constexpr (requires { all.remarks; }) contents.remarks = std::move(all.remarks);
  if constexpr (requires { all.elements; }) contents.elements = std::move(all.elements);
  return contents;
}

Result<MeshContents> read_pair(const std::string& path) {
  const std::string stem = std::filesystem::path(path).replace_extension().string();
  DOBRA_TRY(const meshes::NodeFile nodes, meshes::read_node(stem + ".node"));
  DOBRA_TRY(const meshes::EleFile triangles, meshes::read_ele(stem + ".ele", nodes));
  MeshContents contents{meshes::mesh_of(nodes, triangles), {}};
  for (std::size_t e = 0; e < triangles.count(); ++e) {
    contents.elements.numbers.push_back(nodes.first_number + e);
    // Turning keeps the first corner and swaps the others.
    const bool kept = contents.mesh.nodes_of(ElementId(e))[1].index() == triangles.nodes[e * triangles.nodes_each + 1];
    if (!kept) contents.elements.turned.emplace_back(e);
  }
  return contents;
}

Result<MeshContents> read_polygon_elements(const std::string& path) {
  DOBRA_TRY(const mesh::PolygonMesh polygons, meshes::read_polygons(path));
  DOBRA_TRY(ElementMesh mesh, meshes::elements_of(polygons, path));
  return MeshContents{std::move(mesh), {}};
}

Result<MeshContents> read_stl(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  const auto triangles = mesh::surface_mesh(text, mesh::SurfaceFormat::Stl);
  if (!triangles) return base::located(triangles.error(), {.file = path});
  return MeshContents{element_mesh_of(*triangles), {}};
}

using Read = Result<MeshContents> (*)(const std::string& path);

const std::vector<std::pair<std::string, Read>>& readers() {
  static const std::vector<std::pair<std::string, Read>> table = {{".vtu", contents_of<meshes::read_vtu>},
                                                                  {".msh", contents_of<meshes::read_msh>},
                                                                  {".msh2", contents_of<meshes::read_msh>},
                                                                  {".inp", contents_of<meshes::read_inp>},
                                                                  {".bdf", contents_of<meshes::read_bdf>},
                                                                  {".nas", contents_of<meshes::read_bdf>},
                                                                  {".nf", contents_of<meshes::read_neutral>},
                                                                  {".ele", read_pair},
                                                                  {".obj", read_polygon_elements},
                                                                  {".off", read_polygon_elements},
                                                                  {".ply", read_polygon_elements},
                                                                  {".stl", read_stl}};
  return table;
}

}  // namespace

const std::vector<std::string>& mesh_endings() {
  static const std::vector<std::string> endings = [] {
    std::vector<std::string> names;
    for (const auto& [ending, write] : writers()) names.push_back(ending);
    return names;
  }();
  return endings;
}

Result<void> check_mesh_ending(const std::string& path) {
  if (writer_of(path) != nullptr) return {};
  return Error{ErrorCode::BadUsage,
               fmt::format("{}: meshes are written to files that end in {}", path, fmt::join(mesh_endings(), " "))};
}

std::vector<std::string> mesh_read_endings() {
  std::vector<std::string> endings;
  for (const auto& [ending, read] : readers()) endings.push_back(ending);
  return endings;
}

bool is_mesh_ending(const std::string& ending) {
  return std::any_of(readers().begin(), readers().end(), [&](const auto& entry) { return entry.first == ending; });
}

Result<MeshContents> read_mesh(const std::string& path) {
  const std::string ending = ending_of(path);
  for (const auto& [known, read] : readers()) {
    if (known != ending) continue;
    DOBRA_TRY(MeshContents contents, read(path));
    if (const std::size_t turned = contents.elements.turned.size(); turned > 0) {
      contents.remarks.push_back(fmt::format("{}: {} of {} elements run clockwise and are turned round", path, turned,
                                             contents.mesh.element_count()));
    }
    return contents;
  }
  return Error{ErrorCode::UnknownFormat,
               fmt::format("{}: meshes are read from {}", path, fmt::join(mesh_read_endings(), " "))};
}

Result<void> add_note(const std::string& path, const std::string& note) {
  struct Form {
    const char* ending;
    const char* behind;  ///< What the comment follows; empty: nothing.
    const char* comment;
  };
  constexpr Form forms[] = {{".vtu", "\n", "<!-- {} -->\n"},
                            {".msh", "$EndMeshFormat\n", "$Comments\n{}\n$EndComments\n"},
                            {".msh2", "$EndMeshFormat\n", "$Comments\n{}\n$EndComments\n"},
                            {".inp", "", "** {}\n"},
                            {".bdf", "", "$ {}\n"},
                            {".nas", "", "$ {}\n"},
                            {".node", "", "# {}\n"},
                            {".ele", "", "# {}\n"},
                            {".poly", "", "# {}\n"},
                            {".obj", "", "# {}\n"}};
  const std::string ending = ending_of(path);
  const auto* form =
      std::find_if(std::begin(forms), std::end(forms), [&](const Form& own) { return ending == own.ending; });
  if (form == std::end(forms)) return {};
  DOBRA_TRY(std::string text, read_text(path));
  const std::size_t at = text.find(form->behind);
  if (at == std::string::npos) return {};
  return write_text(path,
                    text.insert(at + std::string(form->behind).size(), fmt::format(fmt::runtime(form->comment), note)));
}

std::vector<Error> inverted_elements(const MeshContents& contents) {
  const ElementMesh& mesh = contents.mesh;
  std::vector<std::uint8_t> clockwise(mesh.element_count(), 0);
  for (const ElementId element : contents.elements.turned) clockwise[element.index()] = 1;
  struct Count {
    std::size_t all = 0, clockwise = 0;
  };
  std::map<std::int32_t, Count> regions;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    Count& own = regions[mesh.regions[e]];
    ++own.all;
    own.clockwise += clockwise[e];
  }
  const Count whole{mesh.element_count(), contents.elements.turned.size()};
  std::vector<Error> errors;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const Count& own = regions[mesh.regions[e]];
    const Count& others = own.all == 1 ? whole : own;
    const bool most = 2 * others.clockwise > others.all;
    if ((clockwise[e] != 0) == most) continue;
    const auto nodes = mesh.nodes_of(ElementId(e)).first(mesh::corner_count(mesh.types[e]));
    base::Place place;
    place.item =
        fmt::format("element {} of the file", contents.elements.numbers.empty() ? e + 1 : contents.elements.numbers[e]);
    place.x = place.y = 0.0;
    for (const mesh::NodeId node : nodes) {
      *place.x += mesh.point(node).x / static_cast<double>(nodes.size());
      *place.y += mesh.point(node).y / static_cast<double>(nodes.size());
    }
    errors.push_back({ErrorCode::CannotMesh,
                      fmt::format("it is inverted: its corners run {}, those of most others {}",
                                  most ? "anticlockwise" : "clockwise", most ? "clockwise" : "anticlockwise"),
                      place});
  }
  return errors;
}

Result<void> write_mesh(const std::string& path, const ElementMesh& mesh, meshes::InpElement element) {
  DOBRA_TRY_VOID(check_mesh_ending(path));
  return writer_of(path)(path, mesh, element);
}

std::vector<std::string> losses(const std::string& path, const ElementMesh& mesh) {
  const std::string ending = ending_of(path);
  std::vector<std::string> remarks;
  const auto say = [&](std::string what) { remarks.push_back(fmt::format("{}: {}", path, what)); };
  const bool second = std::any_of(mesh.types.begin(), mesh.types.end(), mesh::is_quadratic);
  const auto quads =
      std::count_if(mesh.types.begin(), mesh.types.end(), [](auto type) { return mesh::corner_count(type) == 4; });
  const bool surface = ending == ".obj" || ending == ".ply" || ending == ".off" || ending == ".stl";
  if (surface && second) say(fmt::format("a {} file holds corners only; the nodes at mid-sides are left out", ending));
  if (surface) say(fmt::format("a {} file holds no names; sets and regions are left out", ending));
  if (ending == ".stl" && quads > 0)
    say(fmt::format("an .stl file holds triangles only; {} quadrilaterals are cut in two", quads));
  if (ending == ".poly")
    say("a .poly file holds the lines of the geometry: elements, named points and the lips of cracks are left out, "
        "side sets are marked 1, 2 ... in the order of their names");
  if (ending == ".msh" || ending == ".msh2") {
    for (const auto& [name, written] : meshes::msh_renamings(mesh))
      say(fmt::format("the name '{}' is written as '{}': names in a .msh stand in quotes, on one line", name, written));
  }
  if (ending == ".inp") {
    for (const auto& [kind, name, label] : meshes::inp_renamings(mesh)) {
      say(
          fmt::format("the {} {} is written as {}: labels are letters, digits, _ and -, begin with a letter, are no "
                      "longer than 80 and differ not only by cases",
                      kind, shown(name), label));
    }
  }
  const bool named = !mesh.side_sets.empty() || !mesh.node_sets.empty() || !mesh.region_names.empty();
  if ((ending == ".node" || ending == ".ele") && named) {
    say("a .node and .ele pair holds no names: sets of nodes and names of regions are left out, nodes of side sets are "
        "marked 1, 2 ... in the order of their names");
  }
  return remarks;
}

}  // namespace dobra::io::formats
