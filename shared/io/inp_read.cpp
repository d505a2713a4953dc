#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <set>

#include "shared/io/file.h"
#include "shared/io/inp.h"
#include "shared/io/mesh_sides.h"
#include "shared/io/scan.h"

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Result;
using mesh::NodeId;

namespace {

constexpr std::string_view constraint_prefix = "CONSTRAINT_";
constexpr std::string_view region_prefix = "REGION_";
constexpr std::size_t longest_range = 100'000'000;

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : records_(text, file, '\0', ',') {}

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
        DOBRA_TRY_VOID(add_numbers(element_index_, "element", element_sets_[set_]));
      } else if (keyword_ == "*SURFACE") {
        DOBRA_TRY_VOID(add_face());
      } else if (keyword_.empty()) {
        return records_.error(0, fmt::format("a keyword such as *NODE is due here, not {}", shown(records_.word(0))));
      }
    }
    if (contents_.mesh.triangles.empty()) {
      return Error{ErrorCode::BadFormat, "the file holds no triangles", base::Place{.file = records_.file()}};
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
      const std::string type = upper(parameters_["TYPE"]);
      constexpr std::array known{"CPS3", "CPE3", "CAX3", "S3", "M3D3"};
      if (std::find(known.begin(), known.end(), type) == known.end()) {
        return Error{ErrorCode::UnknownFormat,
                     fmt::format("element type {} is not read; use CPS3, CPE3 or CAX3", shown(type)),
                     records_.place(0)};
      }
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
    contents_.mesh.points.push_back({x, y});
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
    mesh::Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      DOBRA_TRY(const std::size_t node, find(node_index_, 1 + k, "node"));
      corners[k] = NodeId(node);
    }
    if (!element_index_.try_emplace(number, contents_.mesh.triangles.size()).second) {
      return records_.error(0, fmt::format("element {} is given twice", number));
    }
    contents_.mesh.triangles.push_back(corners);
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
    if (face.size() != 2 || face[0] != 'S' || face[1] < '1' || face[1] > '3') {
      return records_.error(1, fmt::format("face {} is not one of S1, S2, S3", shown(face)));
    }
    const auto side = static_cast<std::size_t>(face[1] - '1');
    const mesh::Corners& corners = contents_.mesh.triangles[element];
    surfaces_[set_].push_back({corners[side], corners[(side + 1) % 3]});
    return {};
  }

  void build() {
    mesh::TriangleMesh& mesh = contents_.mesh;
    mesh.regions.assign(mesh.triangles.size(), 0);
    for (const auto& [name, elements] : element_sets_) {
      std::int32_t region = 0;
      const std::string label = upper(name);
      if (!label.starts_with(region_prefix)) continue;
      const char* const end = label.data() + label.size();
      const auto [stop, status] = std::from_chars(label.data() + region_prefix.size(), end, region);
      if (status != std::errc{} || stop != end) continue;
      for (const std::size_t element : elements) mesh.regions[element] = region;
    }
    for (const auto& [name, edges] : surfaces_) {
      const bool constraint = upper(name).starts_with(constraint_prefix);
      (constraint ? mesh.constraint_sets[name.substr(constraint_prefix.size())] : mesh.boundary_sets[name]) = edges;
    }
    for (const auto& [name, nodes] : node_sets_) {
      if (surfaces_.contains(name)) continue;  // The nodes of a surface, derived from it.
      for (const std::size_t node : nodes) mesh.node_sets[name].push_back(NodeId(node));
    }
    orient(mesh);
  }

  Records records_;
  InpContents contents_;
  std::string keyword_;
  std::map<std::string, std::string> parameters_;
  std::string set_;
  std::map<std::size_t, std::size_t> node_index_;     // number -> position
  std::map<std::size_t, std::size_t> element_index_;  // number -> position
  std::map<std::string, std::vector<std::size_t>> node_sets_;
  std::map<std::string, std::vector<std::size_t>> element_sets_;
  std::map<std::string, std::vector<mesh::Edge>> surfaces_;
  std::set<std::string> left_out_;
};

}  // namespace

Result<InpContents> parse_inp(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  return Reader(text, file).run();
}

Result<InpContents> read_inp(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_inp(text, path);
}

}  // namespace dobra::io
