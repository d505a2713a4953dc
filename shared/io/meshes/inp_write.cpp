#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/meshes/inp.h"
#include "shared/io/meshes/mesh_sides.h"
#include "shared/io/scan.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;
using mesh::ElementId;
using mesh::ElementMesh;
using mesh::ElementSide;
using mesh::NodeId;

namespace {

constexpr std::size_t longest_label = 80;  // that Abaqus and CalculiX take
constexpr std::size_t cut_label = 70;      // of one that is longer; leaves room for "_2"
constexpr std::size_t numbers_a_line = 8;

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// Labels that the programs take, each given once (they do not tell cases apart).
class Labels {
 public:
  std::string take(const std::string& name) {
    std::string label = name;
    for (char& c : label) {
      const auto u = static_cast<unsigned char>(c);
      if (u >= 0x80U || (!std::isalnum(u) && c != '_' && c != '-')) c = '_';
    }
    if (label.empty() || !std::isalpha(static_cast<unsigned char>(label[0]))) label.insert(0, "S_");
    if (label.size() > longest_label) label.resize(cut_label);
    std::string unique = label;
    for (int i = 2; !used_.insert(upper(unique)).second; ++i)
      unique = fmt::format("{}_{}", label.substr(0, cut_label), i);
    return unique;
  }

 private:
  std::set<std::string> used_{"NALL", "EALL"};
};

// Sets of elements have names of their own; those of sides and of nodes are both node sets.
struct AllLabels {
  std::map<std::int32_t, std::string> regions;       // REGION_TAG
  std::map<std::int32_t, std::string> region_names;  // of those that have a name
  std::map<std::string, std::string> sides, nodes;
};

AllLabels labels_of(const ElementMesh& mesh) {
  AllLabels all;
  Labels elements, nodes;
  // The tags come first: the reader knows them by their label.
  for (const std::int32_t region : std::set<std::int32_t>(mesh.regions.begin(), mesh.regions.end())) {
    all.regions[region] = elements.take(fmt::format("REGION_{}", region));
  }
  for (const auto& [region, name] : mesh.region_names) {
    if (all.regions.contains(region)) all.region_names[region] = elements.take(name);
  }
  for (const auto& [name, sides] : mesh.side_sets) all.sides[name] = nodes.take(name);
  for (const auto& [name, set] : mesh.node_sets) all.nodes[name] = nodes.take(name);
  return all;
}

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

// A side set as node set (each node once, in travel order) and surface.
void write_sides(const ElementMesh& mesh, const std::string& name, const std::string& label,
                 const std::vector<ElementSide>& sides, std::string& text) {
  write_renaming(name, label, text);
  if (sides.empty()) return;
  std::vector<std::size_t> nodes;
  std::set<NodeId> seen;
  for (const ElementSide& side : sides) {
    const auto [from, to, middle] = side_nodes(mesh, side);
    for (const NodeId node : {from, middle, to}) {
      if (node.valid() && seen.insert(node).second) nodes.push_back(node.index());
    }
  }
  text += fmt::format("*NSET, NSET={}\n", label);
  write_list(nodes, text);
  text += fmt::format("*SURFACE, NAME={}, TYPE=ELEMENT\n", label);
  for (const ElementSide& side : sides) text += fmt::format("{}, S{}\n", side.element.index() + 1, side.side + 1);
}

std::string type_name(mesh::ElementType type, InpElement element) {
  const char* const family = element == InpElement::Shell         ? "S"
                             : element == InpElement::PlaneStress ? "CPS"
                             : element == InpElement::PlaneStrain ? "CPE"
                                                                  : "CAX";
  return fmt::format("{}{}", family, mesh::node_count(type));
}

void write_elements(const ElementMesh& mesh, const InpOptions& options, const AllLabels& labels, std::string& text) {
  std::map<std::int32_t, std::vector<std::size_t>> regions;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (e == 0 || mesh.types[e] != mesh.types[e - 1]) {
      text += fmt::format("*ELEMENT, TYPE={}, ELSET=EALL\n", type_name(mesh.types[e], options.element));
    }
    text += fmt::format("{}", e + 1);
    for (const NodeId node : mesh.nodes_of(ElementId(e))) text += fmt::format(", {}", node.index() + 1);
    text += '\n';
    regions[mesh.regions[e]].push_back(e);
  }
  for (const auto& [region, elements] : regions) {
    const std::string& label = labels.regions.at(region);
    text += fmt::format("*ELSET, ELSET={}\n", label);
    write_list(elements, text);
    const auto named = labels.region_names.find(region);
    if (named == labels.region_names.end()) continue;
    write_renaming(mesh.region_names.at(region), named->second, text);
    text += fmt::format("*ELSET, ELSET={}\n{}\n", named->second, label);
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

std::vector<InpRenaming> inp_renamings(const ElementMesh& mesh) {
  const AllLabels labels = labels_of(mesh);
  std::vector<InpRenaming> renamings;
  for (const auto& [region, label] : labels.region_names) {
    if (mesh.region_names.at(region) != label) renamings.push_back({"region", mesh.region_names.at(region), label});
  }
  for (const auto& [name, label] : labels.sides) {
    if (name != label) renamings.push_back({"set of sides", name, label});
  }
  for (const auto& [name, label] : labels.nodes) {
    if (name != label) renamings.push_back({"set of nodes", name, label});
  }
  return renamings;
}

Result<std::string> inp_text(const ElementMesh& mesh, const InpOptions& options) {
  DOBRA_TRY_VOID(check_writable(mesh, options.heights));
  const auto number = [&](double value) {
    return options.numbers == InpNumbers::Exact ? base::number_text(value) : twenty_columns(value);
  };
  std::string text = "*NODE, NSET=NALL\n";
  for (std::size_t n = 0; n < mesh.points.size(); ++n) {
    text += fmt::format("{}, {}, {}, {}\n", n + 1, number(mesh.points[n].x), number(mesh.points[n].y),
                        options.heights.empty() ? "0.0" : number(options.heights[n]));
  }
  const AllLabels labels = labels_of(mesh);
  write_elements(mesh, options, labels, text);
  for (const auto& [name, sides] : mesh.side_sets) write_sides(mesh, name, labels.sides.at(name), sides, text);
  for (const auto& [name, nodes] : mesh.node_sets) {
    const std::string& label = labels.nodes.at(name);
    write_renaming(name, label, text);
    if (nodes.empty()) continue;
    text += fmt::format("*NSET, NSET={}\n", label);
    std::vector<std::size_t> numbers;
    for (const NodeId node : nodes) numbers.push_back(node.index());
    write_list(numbers, text);
  }
  return text;
}

Result<void> write_inp(const std::string& path, const ElementMesh& mesh, const InpOptions& options) {
  return write_text(path, inp_text(mesh, options));
}

}  // namespace dobra::io::meshes
