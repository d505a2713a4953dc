#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>
#include <optional>

#include "shared/io/file.h"
#include "shared/io/meshes/mesh_plane.h"
#include "shared/io/meshes/mesh_sides.h"
#include "shared/io/meshes/msh.h"
#include "shared/io/scan.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;
using mesh::NodeId;

namespace {

constexpr std::string_view region_name_prefix = "region:";

using EntityKey = std::pair<std::size_t, std::int64_t>;  // dimension, tag

struct Kind {
  std::size_t type;  // gmsh's number
  std::size_t dimension;
  std::size_t nodes;
  mesh::ElementType element;  // of dimension 2
};
constexpr Kind kinds[] = {{15, 0, 1, {}},
                          {1, 1, 2, {}},
                          {8, 1, 3, {}},
                          {2, 2, 3, mesh::ElementType::T3},
                          {9, 2, 6, mesh::ElementType::T6},
                          {3, 2, 4, mesh::ElementType::Q4},
                          {16, 2, 8, mesh::ElementType::Q8}};

struct Element {
  std::size_t tag = 0;
  std::int64_t entity = 0;
  const Kind* kind = nullptr;
  std::array<std::uint32_t, 8> nodes{};
};

class MshReader {
 public:
  MshReader(std::string_view text, const std::string& file, Flatness flatness)
      : text_(text), records_(text, file, '\0'), flatness_(flatness) {}

  Result<MshContents> run() {
    bool version_known = false;
    while (records_.next()) {
      const std::string section(records_.word(0));
      if (!section.starts_with('$') || section.starts_with("$End")) {
        return records_.error(0, fmt::format("the start of a section is due here, not {}", shown(section)));
      }
      if (section == "$MeshFormat") {
        DOBRA_TRY_VOID(read_format());
        version_known = true;
      } else if (!version_known) {
        return records_.error(0, "a .msh file starts with $MeshFormat");
      } else if (section == "$PhysicalNames") {
        DOBRA_TRY_VOID(read_names());
      } else if (section == "$Entities") {
        DOBRA_TRY_VOID(read_entities());
      } else if (section == "$Nodes") {
        DOBRA_TRY_VOID(old_ ? read_old_nodes() : read_nodes());
      } else if (section == "$Elements") {
        DOBRA_TRY_VOID(old_ ? read_old_elements() : read_elements());
      } else {
        DOBRA_TRY_VOID(skip_section(section));
        continue;
      }
      DOBRA_TRY_VOID(records_.expect("$End" + section.substr(1)));
      if (records_.word(0) != "$End" + section.substr(1)) {
        return records_.error(0, fmt::format("$End{} is due here, not {}", section.substr(1), shown(records_.word(0))));
      }
    }
    if (elements_[2].empty())
      return Error{ErrorCode::BadFormat, "the file holds no triangles and no quadrilaterals",
                   base::Place{.file = records_.file()}};
    DOBRA_TRY_VOID(build());
    return std::move(contents_);
  }

 private:
  Result<void> read_format() {
    DOBRA_TRY_VOID(records_.expect("the version"));
    const auto refuse = [&](std::size_t i, std::string what) {
      return Error{ErrorCode::UnknownFormat, std::move(what) + "; save it with gmsh -format msh41", records_.place(i)};
    };
    old_ = records_.word(0) == "2.2";
    if (records_.word(0) != "4.1" && !old_)
      return refuse(0, fmt::format("version {} is not read", shown(records_.word(0))));
    if (records_.size() < 2 || records_.word(1) != "0") return refuse(1, "binary .msh files are not read");
    return {};
  }

  Result<void> skip_section(const std::string& section) {
    const std::string end = "$End" + section.substr(1);
    do {
      DOBRA_TRY_VOID(records_.expect(end));
    } while (records_.word(0) != end);
    contents_.remarks.push_back(fmt::format("{}: section {} left out", records_.file(), section));
    return {};
  }

  Result<void> read_names() {
    DOBRA_TRY_VOID(records_.expect("the number of names"));
    DOBRA_TRY(const std::size_t count, records_.count(0, "the number of names", most_items));
    for (std::size_t i = 0; i < count; ++i) {
      DOBRA_TRY_VOID(records_.expect("a physical name"));
      DOBRA_TRY(const std::size_t dimension, records_.count(0, "the dimension", 3));
      DOBRA_TRY(const std::int64_t tag, records_.integer(1, "the physical tag"));
      const std::string_view line = records_.line();
      const std::size_t open = line.find('"');
      const std::size_t close = line.rfind('"');
      if (open == std::string_view::npos || close == open)
        return records_.error(2, "a name in double quotes is due here");
      names_[{dimension, tag}] = std::string(line.substr(open + 1, close - open - 1));
    }
    return {};
  }

  Result<void> read_entities() {
    DOBRA_TRY_VOID(records_.expect("the number of entities"));
    std::array<std::size_t, 4> counts{};
    for (std::size_t d = 0; d < 4; ++d) {
      DOBRA_TRY(counts[d], records_.count(d, "the number of entities", most_items));
    }
    for (std::size_t d = 0; d < 4; ++d) {
      for (std::size_t i = 0; i < counts[d]; ++i) {
        DOBRA_TRY_VOID(records_.expect("an entity"));
        DOBRA_TRY(const std::int64_t tag, records_.integer(0, "the entity's tag"));
        const std::size_t at = d == 0 ? 4 : 7;  // behind the point or the box
        DOBRA_TRY(const std::size_t groups, records_.count(at, "the number of physical groups", records_.size()));
        for (std::size_t k = 0; k < groups; ++k) {
          DOBRA_TRY(const std::int64_t group, records_.integer(at + 1 + k, "a physical tag"));
          groups_[{d, tag}].push_back(group < 0 ? -group : group);
        }
      }
    }
    return {};
  }

  Result<void> read_nodes() {
    DOBRA_TRY_VOID(records_.expect("the number of nodes"));
    DOBRA_TRY(const std::size_t blocks, records_.count(0, "the number of blocks", most_items));
    DOBRA_TRY(const std::size_t total, records_.count(1, "the number of nodes", most_items));
    for (std::size_t b = 0; b < blocks; ++b) {
      DOBRA_TRY_VOID(records_.expect("a block of nodes"));
      DOBRA_TRY(const std::size_t count, records_.count(3, "the number of nodes of the block", total));
      std::vector<std::size_t> tags;
      tags.reserve(plausible_count(count, text_));
      for (std::size_t i = 0; i < count; ++i) {
        DOBRA_TRY_VOID(records_.expect("a node's tag"));
        DOBRA_TRY(const std::size_t tag, records_.count(0, "a node's tag"));
        tags.push_back(tag);
      }
      for (const std::size_t tag : tags) {
        DOBRA_TRY_VOID(records_.expect("a node's coordinates"));
        DOBRA_TRY(const double x, records_.number(0, "x"));
        DOBRA_TRY(const double y, records_.number(1, "y"));
        DOBRA_TRY_VOID(add_height(tag, 2));
        nodes_.emplace_back(tag, geom::Point{x, y});
        if (nodes_.size() > total)
          return records_.error(0, fmt::format("there are more than the {} nodes announced", total));
      }
    }
    if (nodes_.size() != total)
      return records_.error(0, fmt::format("{} nodes are announced, {} given", total, nodes_.size()));
    return sort_nodes();
  }

  Result<void> add_height(std::size_t tag, std::size_t word) {
    double z = 0.0;
    if (records_.size() > word) {
      DOBRA_TRY(z, records_.number(word, "z"));
    }
    heights_.emplace_back(tag, z);
    return {};
  }

  Result<void> sort_nodes() {
    std::sort(nodes_.begin(), nodes_.end());
    std::sort(heights_.begin(), heights_.end());
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      if (nodes_[i].first == nodes_[i + 1].first)
        return records_.error(0, fmt::format("node {} is given twice", nodes_[i].first));
    }
    return {};
  }

  Result<std::uint32_t> node(std::size_t word) const {
    DOBRA_TRY(const std::size_t tag, records_.count(word, "a node's tag"));
    const auto at =
        std::lower_bound(nodes_.begin(), nodes_.end(), tag, [](const auto& n, std::size_t t) { return n.first < t; });
    if (at == nodes_.end() || at->first != tag) return records_.error(word, fmt::format("there is no node {}", tag));
    return static_cast<std::uint32_t>(at - nodes_.begin());
  }

  Result<void> read_old_nodes() {
    DOBRA_TRY_VOID(records_.expect("the number of nodes"));
    DOBRA_TRY(const std::size_t total, records_.count(0, "the number of nodes", most_items));
    for (std::size_t i = 0; i < total; ++i) {
      DOBRA_TRY_VOID(records_.expect("a node"));
      DOBRA_TRY(const std::size_t tag, records_.count(0, "a node's tag"));
      DOBRA_TRY(const double x, records_.number(1, "x"));
      DOBRA_TRY(const double y, records_.number(2, "y"));
      DOBRA_TRY_VOID(add_height(tag, 3));
      nodes_.emplace_back(tag, geom::Point{x, y});
    }
    return sort_nodes();
  }

  Result<const Kind*> kind(std::size_t word) const {
    DOBRA_TRY(const std::size_t type, records_.count(word, "the element type"));
    const auto* found = std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& k) { return k.type == type; });
    if (found != std::end(kinds)) return found;
    return Error{
        ErrorCode::UnknownFormat,
        fmt::format("element type {} is not read; mesh with triangles or quadrilaterals of order 1 or 2", type),
        records_.place(word)};
  }

  /// @param first  word of the first node.
  Result<void> add_element(Element element, std::size_t first) {
    DOBRA_TRY(element.tag, records_.count(0, "the element's tag"));
    for (std::size_t k = 0; k < element.kind->nodes; ++k) {
      DOBRA_TRY(element.nodes[k], node(first + k));
    }
    elements_[element.kind->dimension].push_back(element);
    return {};
  }

  Result<void> read_elements() {
    DOBRA_TRY_VOID(records_.expect("the number of elements"));
    DOBRA_TRY(const std::size_t blocks, records_.count(0, "the number of blocks", most_items));
    for (std::size_t b = 0; b < blocks; ++b) {
      DOBRA_TRY_VOID(records_.expect("a block of elements"));
      DOBRA_TRY(const std::int64_t entity, records_.integer(1, "the entity's tag"));
      DOBRA_TRY(const Kind* const type, kind(2));
      DOBRA_TRY(const std::size_t count, records_.count(3, "the number of elements of the block", most_items));
      for (std::size_t i = 0; i < count; ++i) {
        DOBRA_TRY_VOID(records_.expect("an element"));
        DOBRA_TRY_VOID(add_element({.entity = entity, .kind = type}, 1));
      }
    }
    return {};
  }

  /// The physical group of an element stands for its entity.
  Result<void> read_old_elements() {
    DOBRA_TRY_VOID(records_.expect("the number of elements"));
    DOBRA_TRY(const std::size_t count, records_.count(0, "the number of elements", most_items));
    for (std::size_t i = 0; i < count; ++i) {
      DOBRA_TRY_VOID(records_.expect("an element"));
      DOBRA_TRY(const Kind* const type, kind(1));
      DOBRA_TRY(const std::size_t tags, records_.count(2, "the number of tags", records_.size()));
      std::int64_t group = 0;
      if (tags > 0) {
        DOBRA_TRY(group, records_.integer(3, "the physical tag"));
      }
      if (group > 0) groups_[{type->dimension, group}] = {group};
      DOBRA_TRY_VOID(add_element({.entity = group, .kind = type}, 3 + tags));
    }
    return {};
  }

  Result<void> build() {
    for (auto& elements : elements_) {
      std::stable_sort(elements.begin(), elements.end(),
                       [](const Element& a, const Element& b) { return a.tag < b.tag; });
    }
    mesh::ElementMesh& mesh = contents_.mesh;
    mesh.points.reserve(nodes_.size());
    for (const auto& [tag, point] : nodes_) mesh.points.push_back(point);
    std::vector<NodeId> own;
    for (const Element& element : elements_[2]) {
      own.clear();
      for (std::size_t k = 0; k < element.kind->nodes; ++k) own.emplace_back(element.nodes[k]);
      mesh::add_element(mesh, element.kind->element, own, region(element.entity));
      contents_.elements.numbers.push_back(element.tag);
    }
    std::vector<double> heights;
    for (const auto& [tag, z] : heights_) heights.push_back(z);
    DOBRA_TRY(const bool in_space, lies_in_space(mesh, heights, records_.file(), flatness_));
    if (in_space) contents_.heights = std::move(heights);
    EdgeSets sets;
    for (const Element& element : elements_[1]) {
      for (const std::int64_t group : groups_[{1, element.entity}]) {
        sets[name_of(1, group)].push_back({NodeId(element.nodes[0]), NodeId(element.nodes[1])});
      }
    }
    for (const Element& element : elements_[0]) {
      for (const std::int64_t group : groups_[{0, element.entity}]) {
        mesh.node_sets[name_of(0, group)].push_back(NodeId(element.nodes[0]));
      }
    }
    Finished done = finish(mesh, sets, contents_.heights);
    contents_.elements.turned = std::move(done.turned);
    if (done.lost > 0) {
      contents_.remarks.push_back(
          fmt::format("{}: {} lines that are no side of an element are left out", records_.file(), done.lost));
    }
    return {};
  }

  std::string name_of(std::size_t dimension, std::int64_t group) const {
    const auto found = names_.find({dimension, group});
    return found != names_.end() ? found->second : fmt::format("physical {}", group);
  }

  /// The tag of the region that an entity stands for; its name is noted.
  std::int32_t region(std::int64_t entity) {
    const auto found = groups_.find({2, entity});
    if (found == groups_.end() || found->second.empty()) return 0;
    const std::int64_t group = found->second.front();
    const auto named = names_.find({2, group});
    auto tag = static_cast<std::int32_t>(group);
    if (named == names_.end()) return tag;
    std::string name = named->second;
    if (name.starts_with(region_name_prefix)) {
      const char* const end = name.data() + name.size();
      const auto [stop, status] = std::from_chars(name.data() + region_name_prefix.size(), end, tag);
      if (status != std::errc{} || (stop != end && *stop != ':')) return static_cast<std::int32_t>(group);
      name = stop == end ? "" : std::string(stop + 1, end);
    }
    if (!name.empty()) contents_.mesh.region_names[tag] = name;
    return tag;
  }

  std::string_view text_;
  Records records_;
  Flatness flatness_;
  bool old_ = false;  // version 2.2
  MshContents contents_;
  std::map<EntityKey, std::string> names_;                 // (dimension, physical tag)
  std::map<EntityKey, std::vector<std::int64_t>> groups_;  // (dimension, entity) -> physical tags
  std::vector<std::pair<std::size_t, geom::Point>> nodes_;
  std::vector<std::pair<std::size_t, double>> heights_;  // of the nodes
  std::array<std::vector<Element>, 3> elements_;         // by dimension
};

}  // namespace

Result<MshContents> parse_msh(std::string_view text, const std::string& file, Flatness flatness) {
  DOBRA_TRY_VOID(check_text(text, file));
  return MshReader(text, file, flatness).run();
}

Result<MshContents> read_msh(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_msh(text, path);
}

}  // namespace dobra::io::meshes
