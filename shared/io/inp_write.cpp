#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/inp.h"
#include "shared/io/mesh_sides.h"
#include "shared/io/scan.h"

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Result;
using mesh::Edge;
using mesh::NodeId;
using mesh::TriangleMesh;

namespace {

constexpr std::size_t longest_label = 70;  // of the 80 that Abaqus and CalculiX take; leaves room for "_2"
constexpr std::size_t numbers_a_line = 8;

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// Labels that the programs take, each given once (they do not tell cases apart).
class Labels {
 public:
  std::string take(const std::string& name) {
    std::string label = name.substr(0, longest_label);
    for (char& c : label) {
      const auto u = static_cast<unsigned char>(c);
      if (u >= 0x80U || (!std::isalnum(u) && c != '_' && c != '-')) c = '_';
    }
    if (label.empty() || !std::isalpha(static_cast<unsigned char>(label[0]))) label.insert(0, "S_");
    std::string unique = label;
    for (int i = 2; !used_.insert(upper(unique)).second; ++i) unique = fmt::format("{}_{}", label, i);
    return unique;
  }

 private:
  std::set<std::string> used_{"NALL", "EALL"};
};

template <class Range>
void write_list(const Range& numbers, std::string& text) {
  std::size_t i = 0;
  for (const std::size_t number : numbers) {
    text += fmt::format("{}{}", i == 0 ? "" : (i % numbers_a_line == 0 ? ",\n" : ", "), number + 1);
    ++i;
  }
  text += '\n';
}

void write_renaming(const std::string& name, const std::string& label, std::string& text) {
  if (name != label) text += fmt::format("** {} is written as {}\n", shown(name), label);
}

// A set of edges as node set (each node once, in travel order) and surface.
Result<void> write_edges(const std::string& name, const std::string& label, const std::vector<Edge>& edges,
                         const MeshSides& sides, std::string& text) {
  write_renaming(name, label, text);
  if (edges.empty()) return {};
  std::vector<std::size_t> nodes;
  std::set<NodeId> seen;
  for (const Edge& edge : edges) {
    for (const NodeId node : edge) {
      if (seen.insert(node).second) nodes.push_back(node.index());
    }
  }
  text += fmt::format("*NSET, NSET={}\n", label);
  write_list(nodes, text);
  text += fmt::format("*SURFACE, NAME={}, TYPE=ELEMENT\n", label);
  for (const Edge& edge : edges) {
    // A constraint may run along the boundary with the domain on its right only.
    auto side = sides.left_of(edge);
    if (!side) side = sides.left_of({edge[1], edge[0]});
    if (!side) {
      return Error{ErrorCode::InvalidOption, fmt::format("edge {}-{} of set {} is not the side of a triangle",
                                                         edge[0].index() + 1, edge[1].index() + 1, shown(name))};
    }
    text += fmt::format("{}, S{}\n", side->triangle.index() + 1, side->side + 1);
  }
  return {};
}

void write_elements(const TriangleMesh& mesh, const InpOptions& options, std::string& text) {
  const std::string_view type = options.element == InpElement::PlaneStress   ? "CPS3"
                                : options.element == InpElement::PlaneStrain ? "CPE3"
                                                                             : "CAX3";
  text += fmt::format("*ELEMENT, TYPE={}, ELSET=EALL\n", type);
  std::map<std::int32_t, std::vector<std::size_t>> regions;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const mesh::Corners& corners = mesh.triangles[t];
    text +=
        fmt::format("{}, {}, {}, {}\n", t + 1, corners[0].index() + 1, corners[1].index() + 1, corners[2].index() + 1);
    regions[region_of(mesh, mesh::TriangleId(t))].push_back(t);
  }
  for (const auto& [region, triangles] : regions) {
    text += fmt::format("*ELSET, ELSET=REGION_{}\n", region);
    write_list(triangles, text);
  }
}

}  // namespace

std::string twenty_columns(double value) {
  constexpr std::size_t columns = 20;
  const auto shortened = [](std::string text) {
    // "0.5" and "-0.5" may lose their zero, "e-05" too.
    const std::size_t digits = text.starts_with('-') ? 1 : 0;
    if (text.compare(digits, 2, "0.") == 0 && text.size() > columns) text.erase(digits, 1);
    const std::size_t e = text.find('e');
    if (e != std::string::npos && text.size() > columns && text[e + 1] == '+') text.erase(e + 1, 1);
    const std::size_t zero = e == std::string::npos ? e : text.find_first_of("0123456789", e);
    if (zero != std::string::npos && text.size() > columns && text[zero] == '0' && zero + 1 < text.size())
      text.erase(zero, 1);
    return text;
  };
  const std::string exact = shortened(base::number_text(value));
  if (exact.size() <= columns) return exact;
  for (int precision = 16; precision > 0; --precision) {
    const std::string rounded = shortened(fmt::format("{:.{}e}", value, precision));
    if (rounded.size() <= columns) return rounded;
  }
  return exact;
}

Result<std::string> inp_text(const TriangleMesh& mesh, const InpOptions& options) {
  if (mesh.triangles.empty())
    return Error{ErrorCode::CannotMesh, "the mesh has no triangles; there is nothing to write"};
  DOBRA_TRY_VOID(check_finite(mesh.points, "the mesh"));
  const auto number = [&](double value) {
    return options.numbers == InpNumbers::Exact ? base::number_text(value) : twenty_columns(value);
  };
  std::string text = "*NODE, NSET=NALL\n";
  for (std::size_t n = 0; n < mesh.points.size(); ++n) {
    text += fmt::format("{}, {}, {}, 0.0\n", n + 1, number(mesh.points[n].x), number(mesh.points[n].y));
  }
  write_elements(mesh, options, text);
  Labels labels;
  const MeshSides sides(mesh);
  for (const auto& [name, edges] : mesh.boundary_sets)
    DOBRA_TRY_VOID(write_edges(name, labels.take(name), edges, sides, text));
  for (const auto& [name, edges] : mesh.constraint_sets) {
    const std::string prefixed = "CONSTRAINT_" + name;
    DOBRA_TRY_VOID(write_edges(prefixed, labels.take(prefixed), edges, sides, text));
  }
  for (const auto& [name, nodes] : mesh.node_sets) {
    const std::string label = labels.take(name);
    write_renaming(name, label, text);
    if (nodes.empty()) continue;
    text += fmt::format("*NSET, NSET={}\n", label);
    std::vector<std::size_t> numbers;
    for (const NodeId node : nodes) numbers.push_back(node.index());
    write_list(numbers, text);
  }
  return text;
}

Result<void> write_inp(const std::string& path, const TriangleMesh& mesh, const InpOptions& options) {
  DOBRA_TRY(const std::string text, inp_text(mesh, options));
  return write_file(path, text);
}

}  // namespace dobra::io
