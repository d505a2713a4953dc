#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>
#include <set>

#include "shared/io/file.h"
#include "shared/io/meshes/inp.h"
#include "shared/io/meshes/mesh_plane.h"
#include "shared/io/meshes/mesh_sides.h"
#include "shared/io/scan.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;
using mesh::NodeId;

namespace {

constexpr std::string_view region_prefix = "REGION_";
constexpr std::size_t longest_range = 100'000'000;

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

/// CPS6, CPE4R, S8R ...: the family, the number of nodes, and letters for the integration, which do not matter here.
std::optional<mesh::ElementType> element_type(const std::string& name) {
  constexpr std::array families{"CPS", "CPE", "CAX", "M3D", "S"};
  for (const std::string_view family : families) {
    if (!name.starts_with(family)) continue;
    const std::string rest = name.substr(family.size());
    if (rest.find_first_not_of("RHIT", 1) != std::string::npos || rest.empty()) return std::nullopt;
    switch (rest[0]) {
      case '3':
        return mesh::ElementType::T3;
      case '4':
        return mesh::ElementType::Q4;
      case '6':
        return mesh::ElementType::T6;
      case '8':
        return mesh::ElementType::Q8;
      default:
        return std::nullopt;
    }
  }
  return std::nullopt;
}

class InpReader {
 public:
  InpReader(std::string_view text, const std::string& file, Flatness flatness)
      : records_(text, file, '\0', ','), flatness_(flatness), whole_(text.ends_with('\n') || text.ends_with('\r')) {}

  Result<InpContents> run() {
    while (records_.next()) {
      if (records_.word(0).starts_with("**")) continue;
      if (records_.word(0).starts_with("*")) {
        DOBRA_TRY_VOID(start_keyword());
      } else if (keyword_ == "*NODE") {
        DOBRA_TRY_VOID(add_node());
      } else if (keyword_ == "*ELEMENT") {
        DOBRA_TRY_VOID(add_element());
      } else if (keyword_ == "*NSET") {
        DOBRA_TRY_VOID(add_numbers(node_index_, "node", node_sets_[set_]));
      } else if (keyword_ == "*ELSET") {
        if (const auto region = region_of(records_.word(0)); region && records_.size() == 1) {
          region_names_[*region] = set_;
          continue;
        }
        DOBRA_TRY_VOID(add_numbers(element_index_, "element", element_sets_[set_]));
      } else if (keyword_ == "*SURFACE") {
        DOBRA_TRY_VOID(add_face());
      } else if (keyword_.empty()) {
        return records_.error(0, fmt::format("a keyword such as *NODE is due here, not {}", shown(records_.word(0))));
      }
    }
    if (contents_.mesh.element_count() == 0) {
      return Error{ErrorCode::BadFormat, "the file holds no triangles and no quadrilaterals",
                   base::Place{.file = records_.file()}};
    }
    DOBRA_TRY(const bool in_space, lies_in_space(contents_.mesh, heights_, records_.file(), flatness_));
    if (in_space) contents_.heights = std::move(heights_);
    if (!whole_) {
      contents_.remarks.push_back(
          fmt::format("{}:{}: the file ends inside a line, perhaps cut short: {}; end the last line if it is whole",
                      records_.file(), records_.line_number(), shown(records_.line())));
    }
    build();
    return std::move(contents_);
  }

 private:
  Result<void> start_keyword() {
    keyword_ = upper(records_.word(0));
    parameters_.clear();
    for (std::size_t i = 1; i < records_.size(); ++i) {
      std::string_view word = records_.word(i);
      const std::size_t equals = std::min(word.find('='), word.size());
      std::string key = upper(word.substr(0, equals));
      while (!key.empty() && key.back() == ' ') key.pop_back();
      word.remove_prefix(std::min(equals + 1, word.size()));
      while (word.starts_with(' ')) word.remove_prefix(1);
      parameters_[key] = std::string(word);
    }
    set_.clear();
    if (keyword_ == "*ELEMENT") {
      const auto type = element_type(upper(parameters_["TYPE"]));
      if (!type) {
        return Error{ErrorCode::UnknownFormat,
                     fmt::format("element type {} is not read; use plane ones such as CPS3, CPE6, CAX4, CPS8R",
                                 shown(upper(parameters_["TYPE"]))),
                     records_.place(0)};
      }
      type_ = *type;
    }
    if (keyword_ == "*NSET") return name_set("NSET");
    if (keyword_ == "*ELSET") return name_set("ELSET");
    if (keyword_ == "*SURFACE") return name_set("NAME");
    if (keyword_ != "*NODE" && keyword_ != "*ELEMENT" && keyword_ != "*HEADING" && left_out_.insert(keyword_).second) {
      contents_.remarks.push_back(fmt::format("{}: {} left out", records_.file(), shown(keyword_)));
    }
    return {};
  }

  Result<void> name_set(const std::string& key) {
    set_ = parameters_[key];
    if (set_.empty()) return records_.error(0, fmt::format("{} needs {}=name", keyword_, key));
    return {};
  }

  Result<void> add_node() {
    DOBRA_TRY(const std::size_t number, records_.count(0, "the node's number"));
    DOBRA_TRY(const double x, records_.number(1, "x"));
    DOBRA_TRY(const double y, records_.number(2, "y"));
    if (!node_index_.try_emplace(number, contents_.mesh.points.size()).second) {
      return records_.error(0, fmt::format("node {} is given twice", number));
    }
    double z = 0.0;
    if (records_.size() > 3 && !records_.word(3).empty()) {
      DOBRA_TRY(z, records_.number(3, "z"));
    }
    contents_.mesh.points.push_back({x, y});
    heights_.push_back(z);
    return {};
  }

  Result<std::size_t> find(const std::map<std::size_t, std::size_t>& index, std::size_t word,
                           std::string_view what) const {
    DOBRA_TRY(const std::size_t number, records_.count(word, fmt::format("the {}'s number", what)));
    const auto found = index.find(number);
    if (found == index.end()) return records_.error(word, fmt::format("there is no {} {}", what, number));
    return found->second;
  }

  Result<void> add_element() {
    DOBRA_TRY(const std::size_t number, records_.count(0, "the element's number"));
    std::vector<NodeId> nodes;
    for (std::size_t k = 0; k < mesh::node_count(type_); ++k) {
      DOBRA_TRY(const std::size_t node, find(node_index_, 1 + k, "node"));
      nodes.emplace_back(node);
    }
    if (!element_index_.try_emplace(number, contents_.mesh.element_count()).second) {
      return records_.error(0, fmt::format("element {} is given twice", number));
    }
    mesh::add_element(contents_.mesh, type_, nodes, 0);
    return {};
  }

  Result<void> add_numbers(const std::map<std::size_t, std::size_t>& index, std::string_view what,
                           std::vector<std::size_t>& set) {
    if (!parameters_.contains("GENERATE")) {
      for (std::size_t i = 0; i < records_.size(); ++i) {
        DOBRA_TRY(const std::size_t item, find(index, i, what));
        set.push_back(item);
      }
      return {};
    }
    DOBRA_TRY(const std::size_t first, records_.count(0, "the first number"));
    DOBRA_TRY(const std::size_t last, records_.count(1, "the last number"));
    std::size_t step = 1;
    if (records_.size() > 2) {
      DOBRA_TRY(step, records_.count(2, "the step"));
    }
    if (step == 0 || last < first || (last - first) / step > longest_range)
      return records_.error(0, "this range of numbers is not valid");
    // Over the items there are, not over the range: a range may be far longer.
    for (auto at = index.lower_bound(first); at != index.end() && at->first <= last; ++at) {
      if ((at->first - first) % step == 0) set.push_back(at->second);
    }
    return {};
  }

  Result<void> add_face() {
    DOBRA_TRY(const std::size_t element, find(element_index_, 0, "element"));
    const std::string face = records_.size() > 1 ? upper(records_.word(1)) : std::string{};
    const mesh::ElementMesh& mesh = contents_.mesh;
    const std::size_t corners = mesh::corner_count(mesh.types[element]);
    if (face.size() != 2 || face[0] != 'S' || face[1] < '1' || face[1] > '0' + static_cast<char>(corners)) {
      return records_.error(1, fmt::format("face {} is not one of S1 to S{}", shown(face), corners));
    }
    const auto [from, to, middle] =
        side_nodes(mesh, {mesh::ElementId(element), static_cast<std::uint32_t>(face[1] - '1')});
    surfaces_[set_].push_back({from, to});
    return {};
  }

  /// The tag in a label REGION_TAG.
  static std::optional<std::int32_t> region_of(std::string_view name) {
    const std::string label = upper(name);
    if (!label.starts_with(region_prefix)) return std::nullopt;
    std::int32_t region = 0;
    const char* const end = label.data() + label.size();
    const auto [stop, status] = std::from_chars(label.data() + region_prefix.size(), end, region);
    if (status != std::errc{} || stop != end) return std::nullopt;
    return region;
  }

  void build() {
    mesh::ElementMesh& mesh = contents_.mesh;
    for (const auto& [name, elements] : element_sets_) {
      const auto region = region_of(name);
      if (!region) continue;
      for (const std::size_t element : elements) mesh.regions[element] = *region;
    }
    mesh.region_names = region_names_;
    for (const auto& [name, nodes] : node_sets_) {
      if (surfaces_.contains(name)) continue;  // The nodes of a surface, derived from it.
      for (const std::size_t node : nodes) mesh.node_sets[name].push_back(NodeId(node));
    }
    contents_.elements.numbers.resize(mesh.element_count());
    for (const auto& [number, position] : element_index_) contents_.elements.numbers[position] = number;
    contents_.elements.turned = finish(mesh, surfaces_, contents_.heights).turned;
  }

  Records records_;
  Flatness flatness_;
  bool whole_;  // the last line has its end
  InpContents contents_;
  std::string keyword_;
  std::map<std::string, std::string> parameters_;
  std::string set_;
  std::vector<double> heights_;                       // of the nodes
  std::map<std::size_t, std::size_t> node_index_;     // number -> position
  std::map<std::size_t, std::size_t> element_index_;  // number -> position
  std::map<std::string, std::vector<std::size_t>> node_sets_;
  std::map<std::string, std::vector<std::size_t>> element_sets_;
  EdgeSets surfaces_;
  std::map<std::int32_t, std::string> region_names_;
  mesh::ElementType type_ = mesh::ElementType::T3;
  std::set<std::string> left_out_;
};

}  // namespace

Result<InpContents> parse_inp(std::string_view text, const std::string& file, Flatness flatness) {
  DOBRA_TRY_VOID(check_text(text, file));
  return InpReader(text, file, flatness).run();
}

Result<InpContents> read_inp(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_inp(text, path);
}

}  // namespace dobra::io::meshes
