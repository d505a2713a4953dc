#include "shared/io/meshes/neutral.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/meshes/mesh_sides.h"
#include "shared/io/scan.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;
using mesh::ElementId;
using mesh::ElementMesh;
using mesh::ElementSide;
using mesh::ElementType;
using mesh::NodeId;

namespace {

constexpr std::array<std::pair<std::string_view, ElementType>, 4> sections{{{"%ELEMENT.T3", ElementType::T3},
                                                                            {"%ELEMENT.T6", ElementType::T6},
                                                                            {"%ELEMENT.Q4", ElementType::Q4},
                                                                            {"%ELEMENT.Q8", ElementType::Q8}}};

/// Gauss points: one, three (triangles) and two, three a direction (quadrilaterals).
int integration_order(ElementType type) { return mesh::is_quadratic(type) ? 3 : mesh::corner_count(type) == 3 ? 1 : 2; }

void write_sets(const ElementMesh& mesh, std::string& text) {
  if (!mesh.node_sets.empty()) text += fmt::format("\n%NODE.SET\n{}\n", mesh.node_sets.size());
  for (const auto& [name, nodes] : mesh.node_sets) {
    text += fmt::format("'{}' {}\n", name, nodes.size());
    for (const NodeId node : nodes) text += fmt::format("{}\n", node.index() + 1);
  }
  if (!mesh.side_sets.empty()) text += fmt::format("\n%SIDE.SET\n{}\n", mesh.side_sets.size());
  for (const auto& [name, sides] : mesh.side_sets) {
    text += fmt::format("'{}' {}\n", name, sides.size());
    for (const ElementSide& side : sides) text += fmt::format("{} {}\n", side.element.index() + 1, side.side + 1);
  }
}

}  // namespace

Result<std::string> neutral_text(const NeutralFile& file) {
  const ElementMesh& mesh = file.mesh;
  DOBRA_TRY_VOID(check_writable(mesh));
  DOBRA_TRY_VOID(check_names(mesh, "'\r\n", "a neutral file", "one without quotes and line ends"));
  const std::set<std::int32_t> tags(mesh.regions.begin(), mesh.regions.end());
  std::map<std::int32_t, std::size_t> number;
  for (const std::int32_t tag : tags) number.emplace(tag, number.size() + 1);

  std::string text = "%HEADER\nQUEBRA neutral file\n";
  text += fmt::format("\n%NODE\n{0}\n\n%NODE.COORD\n{0}\n", mesh.points.size());
  for (std::size_t n = 0; n < mesh.points.size(); ++n) {
    text +=
        fmt::format("{} {} {} 0\n", n + 1, base::number_text(mesh.points[n].x), base::number_text(mesh.points[n].y));
  }
  text += fmt::format("\n%MATERIAL.ISOTROPIC\n{}\n", tags.size());
  for (const std::int32_t tag : tags) {
    const auto found = file.materials.find(tag);
    const NeutralMaterial material = found == file.materials.end() ? NeutralMaterial{} : found->second;
    text +=
        fmt::format("{} {} {}\n", number[tag], base::number_text(material.young), base::number_text(material.poisson));
  }
  text += fmt::format("\n%REGION\n{}\n", tags.size());
  for (const std::int32_t tag : tags) {
    const auto named = mesh.region_names.find(tag);
    text += fmt::format("{} {} '{}'\n", number[tag], tag, named == mesh.region_names.end() ? "" : named->second);
  }
  text += fmt::format("\n%THICKNESS\n1\n1 {}\n", base::number_text(file.thickness));
  text += "\n%INTEGRATION.ORDER\n3\n";
  for (int order = 1; order <= 3; ++order) text += fmt::format("{0} {0} {0} {0} {0} {0} {0}\n", order);
  text += fmt::format("\n%ELEMENT\n{}\n", mesh.element_count());
  for (const auto& [section, type] : sections) {
    const auto count = std::count(mesh.types.begin(), mesh.types.end(), type);
    if (count == 0) continue;
    text += fmt::format("\n{}\n{}\n", section, count);
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      if (mesh.types[e] != type) continue;
      text += fmt::format("{} {} 1 {}", e + 1, number[mesh.regions[e]], integration_order(type));
      for (const NodeId node : mesh.nodes_of(ElementId(e))) text += fmt::format(" {}", node.index() + 1);
      text += '\n';
    }
  }
  write_sets(mesh, text);
  text += "\n%END\n";
  return text;
}

Result<void> write_neutral(const std::string& path, const NeutralFile& file) {
  return write_text(path, neutral_text(file));
}

namespace {

class NeutralReader {
 public:
  NeutralReader(std::string_view text, const std::string& file) : text_(text), records_(text, file, '\0') {}

  Result<NeutralFile> run() {
    bool ended = false;
    while (!ended && records_.next()) {
      const std::string section(records_.word(0));
      if (!section.starts_with('%'))
        return records_.error(0, fmt::format("a section that begins with % is due here, not {}", shown(section)));
      const auto* elements =
          std::find_if(sections.begin(), sections.end(), [&](const auto& s) { return s.first == section; });
      if (section == "%END") {
        ended = true;
      } else if (section == "%NODE.COORD") {
        DOBRA_TRY_VOID(read_nodes());
      } else if (section == "%MATERIAL.ISOTROPIC") {
        DOBRA_TRY_VOID(read_materials());
      } else if (section == "%REGION") {
        DOBRA_TRY_VOID(read_regions());
      } else if (section == "%THICKNESS") {
        DOBRA_TRY_VOID(read_thickness());
      } else if (elements != sections.end()) {
        DOBRA_TRY_VOID(read_elements(elements->second));
      } else if (section == "%NODE.SET" || section == "%SIDE.SET") {
        DOBRA_TRY_VOID(read_sets(section == "%SIDE.SET"));
      } else {
        skip();
      }
    }
    if (!ended) return Error{ErrorCode::BadFormat, "the file ends before %END", base::Place{.file = records_.file()}};
    return build();
  }

 private:
  void skip() {
    while (records_.next()) {
      if (!records_.word(0).starts_with('%')) continue;
      records_.back();
      return;
    }
  }

  /// Reads the number of entries and calls `entry` for each record.
  template <class Entry>
  Result<void> entries(std::string_view what, const Entry& entry) {
    DOBRA_TRY_VOID(records_.expect(fmt::format("the number of {}", what)));
    DOBRA_TRY(const std::size_t count, records_.count(0, fmt::format("the number of {}", what), text_.size()));
    for (std::size_t i = 0; i < count; ++i) {
      DOBRA_TRY_VOID(records_.expect(fmt::format("one of {} {}", count, what)));
      DOBRA_TRY_VOID(entry());
    }
    return {};
  }

  Result<void> read_nodes() {
    return entries("nodes", [&]() -> Result<void> {
      DOBRA_TRY(const std::size_t id, records_.count(0, "the node's number"));
      DOBRA_TRY(const double x, records_.number(1, "x"));
      DOBRA_TRY(const double y, records_.number(2, "y"));
      if (!node_.try_emplace(id, file_.mesh.points.size()).second)
        return records_.error(0, fmt::format("node {} is given twice", id));
      file_.mesh.points.push_back({x, y});
      return {};
    });
  }

  Result<void> read_materials() {
    return entries("materials", [&]() -> Result<void> {
      DOBRA_TRY(const std::size_t id, records_.count(0, "the material's number"));
      NeutralMaterial material;
      DOBRA_TRY(material.young, records_.number(1, "Young's modulus"));
      DOBRA_TRY(material.poisson, records_.number(2, "Poisson's ratio"));
      materials_[id] = material;
      return {};
    });
  }

  Result<std::string> name() const {
    const std::string_view line = records_.line();
    const std::size_t open = line.find('\'');
    const std::size_t close = line.rfind('\'');
    if (open == std::string_view::npos || close == open)
      return records_.error(0, "a name in single quotes is due here");
    after_name_ = close + 1;
    return std::string(line.substr(open + 1, close - open - 1));
  }

  Result<void> read_regions() {
    return entries("regions", [&]() -> Result<void> {
      DOBRA_TRY(const std::size_t id, records_.count(0, "the material's number"));
      DOBRA_TRY(const std::int64_t tag, records_.integer(1, "the region's tag"));
      DOBRA_TRY(const std::string text, name());
      if (std::abs(tag) > 2147483647) return records_.error(1, "the region's tag is too large");
      region_[id] = static_cast<std::int32_t>(tag);
      if (!text.empty()) file_.mesh.region_names[region_[id]] = text;
      return {};
    });
  }

  Result<void> read_thickness() {
    return entries("thicknesses", [&]() -> Result<void> {
      DOBRA_TRY(file_.thickness, records_.number(1, "the thickness"));
      return {};
    });
  }

  Result<void> read_elements(ElementType type) {
    return entries("elements", [&]() -> Result<void> {
      Element element{type, 0, {}};
      DOBRA_TRY(const std::size_t id, records_.count(0, "the element's number"));
      DOBRA_TRY(element.material, records_.count(1, "the material's number"));
      for (std::size_t k = 0; k < mesh::node_count(type); ++k) {
        DOBRA_TRY(const std::size_t node, records_.count(4 + k, "a node's number"));
        const auto found = node_.find(node);
        if (found == node_.end()) return records_.error(4 + k, fmt::format("there is no node {}", node));
        element.nodes.emplace_back(found->second);
      }
      if (!elements_.try_emplace(id, std::move(element)).second)
        return records_.error(0, fmt::format("element {} is given twice", id));
      return {};
    });
  }

  Result<void> read_sets(bool sides) {
    return entries("sets", [&]() -> Result<void> {
      DOBRA_TRY(const std::string set, name());
      Records rest(records_.line().substr(after_name_), records_.file());
      if (!rest.next()) return records_.error(records_.size(), "the number of members is missing");
      const auto members = rest.count(0, "the number of members", text_.size());
      if (!members) return records_.error(records_.size() - 1, members.error().message);
      if (sides) {
        side_sets_[set];
      } else {
        file_.mesh.node_sets[set];
      }
      for (std::size_t i = 0; i < *members; ++i) {
        DOBRA_TRY_VOID(records_.expect("a member of the set"));
        DOBRA_TRY(const std::size_t item, records_.count(0, sides ? "the element's number" : "the node's number"));
        if (sides) {
          DOBRA_TRY(const std::size_t side, records_.count(1, "the side's number"));
          const auto element = elements_.find(item);
          if (element == elements_.end() || side < 1 || side > mesh::corner_count(element->second.type)) {
            return records_.error(0, fmt::format("there is no side {} of an element {}", side, item));
          }
          const auto& nodes = element->second.nodes;
          side_sets_[set].push_back({nodes[side - 1], nodes[side % mesh::corner_count(element->second.type)]});
        } else {
          const auto node = node_.find(item);
          if (node == node_.end()) return records_.error(0, fmt::format("there is no node {}", item));
          file_.mesh.node_sets[set].emplace_back(node->second);
        }
      }
      return {};
    });
  }

  Result<NeutralFile> build() {
    if (elements_.empty())
      return Error{ErrorCode::BadFormat, "the file holds no elements", base::Place{.file = records_.file()}};
    for (const auto& [id, element] : elements_) {
      const auto tag = region_.find(element.material);
      const auto region = tag == region_.end() ? static_cast<std::int32_t>(element.material) : tag->second;
      mesh::add_element(file_.mesh, element.type, element.nodes, region);
      const auto material = materials_.find(element.material);
      if (material != materials_.end()) file_.materials[region] = material->second;
    }
    if (elements_.begin()->first != 1 || elements_.rbegin()->first != elements_.size()) {
      for (const auto& [id, element] : elements_) file_.elements.numbers.push_back(id);
    }
    file_.elements.turned = finish(file_.mesh, side_sets_).turned;
    return std::move(file_);
  }

  struct Element {
    ElementType type;
    std::size_t material;
    std::vector<NodeId> nodes;
  };

  std::string_view text_;
  Records records_;
  mutable std::size_t after_name_ = 0;
  NeutralFile file_;
  std::map<std::size_t, std::size_t> node_;
  std::map<std::size_t, NeutralMaterial> materials_;
  std::map<std::size_t, std::int32_t> region_;
  std::map<std::size_t, Element> elements_;
  EdgeSets side_sets_;
};

}  // namespace

Result<NeutralFile> parse_neutral(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  return NeutralReader(text, file).run();
}

Result<NeutralFile> read_neutral(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_neutral(text, path);
}

}  // namespace dobra::io::meshes
