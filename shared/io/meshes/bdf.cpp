#include "shared/io/meshes/bdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/meshes/mesh_plane.h"
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

constexpr std::string_view mark = "$DOBRA ";

struct Card {
  std::string_view name;
  ElementType type;
};
constexpr Card cards[] = {
    {"CTRIA3", ElementType::T3}, {"CTRIA6", ElementType::T6}, {"CQUAD4", ElementType::Q4}, {"CQUAD8", ElementType::Q8}};

/// "1.5e-07" as Nastran likes it: "1.5-7"; with a point always.
std::string nastran(std::string text) {
  const std::size_t e = text.find('e');
  std::string mantissa = text.substr(0, e);
  if (mantissa.find('.') == std::string::npos) mantissa += '.';
  while (mantissa.ends_with('0')) mantissa.pop_back();
  if (e == std::string::npos) {
    const std::size_t digits = mantissa.starts_with('-') ? 1 : 0;
    if (mantissa.compare(digits, 2, "0.") == 0 && mantissa.size() > digits + 2) mantissa.erase(digits, 1);
    return mantissa;
  }
  const int exponent = std::stoi(text.substr(e + 1));
  return fmt::format("{}{:+}", mantissa, exponent);
}

std::string rounded(double value, std::size_t width) {
  std::string best = nastran(base::number_text(value));
  if (best.size() <= width) return best;
  for (int precision = 16; precision >= 0; --precision) {
    for (const std::string& text :
         {nastran(fmt::format("{:.{}f}", value, precision)), nastran(fmt::format("{:.{}e}", value, precision))}) {
      // Plain digits lose what stands behind them for small numbers.
      const bool plain = text.find_last_of("+-") == std::string::npos || text.find_last_of("+-") == 0;
      if (text.size() <= width && (!plain || std::abs(value) >= 1e-3)) return text;
    }
  }
  return best.substr(0, width);
}

std::optional<double> nastran_value(std::string text) {
  for (char& c : text) {
    if (c == 'd' || c == 'D') c = 'e';
  }
  const std::size_t sign = text.find_last_of("+-");
  if (sign != std::string::npos && sign > 0 && text[sign - 1] != 'e' && text[sign - 1] != 'E') text.insert(sign, "e");
  if (text.starts_with('+')) text.erase(0, 1);
  if (const std::size_t plus = text.find("e+"); plus != std::string::npos) text.erase(plus + 1, 1);
  return base::parse_number(text);
}

/// Cards in small fields, those in large ones that would lose something.
class Writer {
 public:
  void card(const std::string& name, const std::vector<std::string>& fields) {
    const auto is_long = [](const std::string& field) { return field.size() > small; };
    const bool large = std::any_of(fields.begin(), fields.end(), is_long);
    const std::size_t width = large ? 16 : small;
    const std::size_t a_line = large ? 4 : 8;
    text += fmt::format("{:<8}", large ? name + '*' : name);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (i > 0 && i % a_line == 0) {
        trim();
        text += fmt::format("\n{:<8}", large ? "*" : "+");
      }
      text += fmt::format("{:<{}}", fields[i], width);
    }
    trim();
    text += '\n';
  }
  /// As short as it can be: what a large field holds of the value.
  [[nodiscard]] static std::string number(double value) {
    std::string whole = bdf_number(value, 16);
    std::string brief = bdf_number(value, small);
    return nastran_value(brief) == nastran_value(whole) ? brief : whole;
  }

  std::string text;

 private:
  static constexpr std::size_t small = 8;
  void trim() { text.erase(text.find_last_not_of(' ') + 1); }
};

}  // namespace

std::string bdf_number(double value, std::size_t width) {
  const std::string once = rounded(value, width);
  return rounded(nastran_value(once).value_or(value), width);
}

Result<std::string> bdf_text(const ElementMesh& mesh, Heights heights) {
  DOBRA_TRY_VOID(check_writable(mesh, heights));
  DOBRA_TRY_VOID(check_names(mesh, "\r\n", "a .bdf", "one without line ends"));
  Writer writer;
  const std::set<std::int32_t> tags(mesh.regions.begin(), mesh.regions.end());
  std::map<std::int32_t, std::size_t> number;
  for (const std::int32_t tag : tags) {
    number[tag] = number.size() + 1;
    const auto named = mesh.region_names.find(tag);
    writer.text += fmt::format("{}REGION {} {}{}\n", mark, number[tag], tag,
                               named == mesh.region_names.end() ? "" : ' ' + named->second);
  }
  writer.text += "BEGIN BULK\n";
  for (std::size_t n = 0; n < mesh.points.size(); ++n) {
    writer.card("GRID", {fmt::format("{}", n + 1), "", writer.number(mesh.points[n].x), writer.number(mesh.points[n].y),
                         heights.empty() ? "0." : writer.number(heights[n])});
  }
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    std::vector<std::string> fields{fmt::format("{}", e + 1), fmt::format("{}", number[mesh.regions[e]])};
    for (const NodeId node : mesh.nodes_of(ElementId(e))) fields.push_back(fmt::format("{}", node.index() + 1));
    const auto* card =
        std::find_if(std::begin(cards), std::end(cards), [&](const Card& c) { return c.type == mesh.types[e]; });
    writer.card(std::string(card->name), fields);
  }
  std::size_t set = 0;
  for (const auto& [name, nodes] : mesh.node_sets) {
    writer.text += fmt::format("{}NODESET {} {}\n", mark, ++set, name);
    if (nodes.empty()) continue;
    std::vector<std::string> fields{fmt::format("{}", set)};
    for (const NodeId node : nodes) fields.push_back(fmt::format("{}", node.index() + 1));
    writer.card("SET1", fields);
  }
  for (const auto& [name, sides] : mesh.side_sets) {
    writer.text += fmt::format("{}SIDESET {}\n", mark, name);
    for (const ElementSide& side : sides)
      writer.text += fmt::format("{}SIDE {} {}\n", mark, side.element.index() + 1, side.side + 1);
  }
  writer.text += "ENDDATA\n";
  return std::move(writer.text);
}

Result<void> write_bdf(const std::string& path, const ElementMesh& mesh) { return write_text(path, bdf_text(mesh)); }

namespace {

/// A card with its continuations: the words of its fields and where they stand.
struct Fields {
  std::string name;
  struct Field {
    std::string text;
    std::size_t line = 0;
    std::size_t column = 0;
  };
  std::vector<Field> all;
  std::size_t line = 0;
};

class BdfReader {
 public:
  BdfReader(std::string_view text, const std::string& file, Flatness flatness)
      : lines_(text),
        file_(file),
        flatness_(flatness),
        begun_(text.find("BEGIN BULK") != std::string_view::npos),
        bulk_(!begun_) {}

  Result<BdfContents> run() {
    while (lines_.next()) {
      const std::string_view line = lines_.line();
      if (line.starts_with(mark)) {
        DOBRA_TRY_VOID(flush());
        DOBRA_TRY_VOID(marked(line.substr(mark.size())));
        continue;
      }
      if (base::trimmed(line).empty() || line[0] == '$') continue;
      if (!bulk_) {
        bulk_ = line.starts_with("BEGIN BULK");
        continue;
      }
      const bool goes_on = line[0] == '+' || line[0] == '*' || line[0] == ' ' || line[0] == ',';
      if (!goes_on) DOBRA_TRY_VOID(flush());
      if (line.starts_with("ENDDATA")) ended_ = true;
      if (ended_) break;
      if (line.starts_with("BEGIN BULK")) continue;
      if (goes_on && card_.name.empty()) return error(lines_.number(), 1, "this continuation has no card before it");
      split(line, goes_on);
    }
    DOBRA_TRY_VOID(flush());
    if (begun_ && !ended_) {
      contents_.remarks.push_back(fmt::format(
          "{}:{}: there is no ENDDATA behind BEGIN BULK; the file may be cut short: end it so if it is whole", file_,
          lines_.number()));
    }
    return build();
  }

 private:
  [[nodiscard]] Error error(std::size_t line, std::size_t column, std::string message) const {
    base::Place place;
    place.file = file_;
    place.line = line;
    place.column = column;
    return {ErrorCode::BadFormat, std::move(message), place};
  }

  void split(std::string_view line, bool goes_on) {
    const auto add = [&](std::string_view text, std::size_t column) {
      card_.all.push_back({std::string(base::trimmed(text)), lines_.number(), column + 1});
    };
    const std::size_t comma = line.find(',');
    if (comma != std::string_view::npos) {
      if (!goes_on) start(std::string(base::trimmed(line.substr(0, comma))));
      for (std::size_t begin = comma + 1; begin <= line.size();) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        add(line.substr(begin, end - begin), begin);
        begin = end + 1;
      }
      return;
    }
    const std::string head(base::trimmed(line.substr(0, 8)));
    const bool large = head.ends_with('*') || head.starts_with('*');
    if (!goes_on) start(head);
    const std::size_t width = large ? 16 : 8;
    const std::size_t full = large ? 4 : 8;
    std::size_t count = 0;
    for (std::size_t begin = 8; count < full; begin += width, ++count) {
      add(begin < line.size() ? line.substr(begin, width) : std::string_view(), std::min(begin, line.size()));
    }
  }

  void start(std::string name) {
    if (name.ends_with('*')) name.pop_back();
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    card_ = {std::move(name), {}, lines_.number()};
  }

  Result<void> marked(std::string_view line) {
    Records records(line, file_);
    if (!records.next()) return {};
    const std::string what(records.word(0));
    const auto rest = [&](std::size_t words) {
      std::size_t at = 0;
      for (std::size_t i = 0; i < words; ++i)
        at = line.find_first_not_of(' ', std::min(line.find(' ', at), line.size()));
      return at == std::string_view::npos ? std::string() : std::string(line.substr(at));
    };
    const auto located_error = [&](const Error& e) { return error(lines_.number(), 1, e.message); };
    if (what == "REGION") {
      const auto number = records.count(1, "the region's number");
      const auto tag = records.integer(2, "the region's tag");
      if (!number) return located_error(number.error());
      if (!tag) return located_error(tag.error());
      region_[*number] = static_cast<std::int32_t>(*tag);
      if (records.size() > 3) contents_.mesh.region_names[static_cast<std::int32_t>(*tag)] = rest(3);
    } else if (what == "NODESET") {
      const auto number = records.count(1, "the set's number");
      if (!number) return located_error(number.error());
      set_name_[*number] = rest(2);
      contents_.mesh.node_sets[rest(2)];
    } else if (what == "SIDESET") {
      side_set_ = rest(1);
      sides_[side_set_];
    } else if (what == "SIDE") {
      const auto element = records.count(1, "the element's number");
      const auto side = records.count(2, "the side's number");
      if (!element) return located_error(element.error());
      if (!side) return located_error(side.error());
      sides_[side_set_].push_back({*element, *side, lines_.number()});
    }
    return {};
  }

  Result<double> number(std::size_t i) const {
    if (i >= card_.all.size()) return error(card_.line, 1, fmt::format("{} has too few fields", card_.name));
    const auto& field = card_.all[i];
    if (field.text.empty()) return 0.0;
    const auto value = nastran_value(field.text);
    if (!value) return error(field.line, field.column, fmt::format("{} is not a number", shown(field.text)));
    if (!std::isfinite(*value))
      return Error{ErrorCode::NotFinite, fmt::format("{} is not finite", shown(field.text)),
                   error(field.line, field.column, "").place};
    return *value;
  }
  Result<std::size_t> count(std::size_t i) const {
    DOBRA_TRY(const double value, number(i));
    if (value >= 1.0 && value < 4294967295.0 && value == std::floor(value)) return static_cast<std::size_t>(value);
    const auto& field = card_.all[i];
    return error(field.line, field.column,
                 fmt::format("{} is not a number of a node, element or set", shown(field.text)));
  }

  Result<void> flush() {
    const std::string name = card_.name;
    if (name.empty()) return {};
    const auto* card = std::find_if(std::begin(cards), std::end(cards),
                                    [&](const Card& c) { return name == c.name || name == std::string(c.name) + "R"; });
    if (name == "GRID") {
      DOBRA_TRY_VOID(add_grid());
    } else if (card != std::end(cards)) {
      DOBRA_TRY_VOID(add_element(card->type));
    } else if (name == "SET1") {
      DOBRA_TRY_VOID(add_set());
    } else if (left_out_.insert(name).second) {
      contents_.remarks.push_back(fmt::format("{}: {} left out", file_, shown(name)));
    }
    card_ = {};
    return {};
  }

  Result<void> add_grid() {
    DOBRA_TRY(const std::size_t id, count(0));
    DOBRA_TRY(const double x, number(2));
    DOBRA_TRY(const double y, number(3));
    if (!node_.try_emplace(id, contents_.mesh.points.size()).second)
      return error(card_.line, 1, fmt::format("grid point {} is given twice", id));
    const bool short_card = card_.all.size() <= 4;
    DOBRA_TRY(const double z, short_card ? Result<double>(0.0) : number(4));
    contents_.mesh.points.push_back({x, y});
    heights_.push_back(z);
    return {};
  }

  Result<void> add_element(ElementType type) {
    Element element{type, 0, 0, {}, card_.line};
    DOBRA_TRY(element.id, count(0));
    DOBRA_TRY(element.property, count(1));
    for (std::size_t k = 0; k < node_count(type); ++k) {
      DOBRA_TRY(const std::size_t node, count(2 + k));
      element.nodes.push_back(node);
    }
    elements_.push_back(std::move(element));
    return {};
  }

  Result<void> add_set() {
    DOBRA_TRY(const std::size_t id, count(0));
    const auto named = set_name_.find(id);
    auto& set = sets_[named == set_name_.end() ? fmt::format("set {}", id) : named->second];
    for (std::size_t i = 1; i < card_.all.size(); ++i) {
      if (card_.all[i].text.empty()) continue;
      DOBRA_TRY(const std::size_t node, count(i));
      set.emplace_back(node, card_.line);
    }
    return {};
  }

  Result<NodeId> node(std::size_t id, std::size_t line) const {
    const auto found = node_.find(id);
    if (found == node_.end()) return error(line, 1, fmt::format("there is no grid point {}", id));
    return NodeId(found->second);
  }

  Result<BdfContents> build() {
    ElementMesh& mesh = contents_.mesh;
    if (elements_.empty())
      return Error{ErrorCode::BadFormat, "the file holds no triangles and no quadrilaterals",
                   base::Place{.file = file_}};
    std::map<std::size_t, std::size_t> position;
    for (const Element& element : elements_) {
      std::vector<NodeId> own;
      for (const std::size_t id : element.nodes) {
        DOBRA_TRY(const NodeId n, node(id, element.line));
        own.push_back(n);
      }
      if (!position.try_emplace(element.id, mesh.element_count()).second)
        return error(element.line, 1, fmt::format("element {} is given twice", element.id));
      const auto tag = region_.find(element.property);
      mesh::add_element(mesh, element.type, own,
                        tag == region_.end() ? static_cast<std::int32_t>(element.property) : tag->second);
    }
    DOBRA_TRY(const bool in_space, lies_in_space(mesh, heights_, file_, flatness_));
    if (in_space) contents_.heights = std::move(heights_);
    for (const auto& [name, nodes] : sets_) {
      for (const auto& [id, line] : nodes) {
        DOBRA_TRY(const NodeId n, node(id, line));
        mesh.node_sets[name].push_back(n);
      }
    }
    EdgeSets edges;
    for (const auto& [name, sides] : sides_) {
      auto& set = edges[name];
      for (const Side& side : sides) {
        const auto element = position.find(side.element);
        if (element == position.end() || side.side < 1 || side.side > corner_count(mesh.types[element->second])) {
          return error(side.line, 1, fmt::format("there is no side {} of an element {}", side.side, side.element));
        }
        const auto nodes = side_nodes(mesh, {ElementId(element->second), static_cast<std::uint32_t>(side.side - 1)});
        set.push_back({nodes[0], nodes[1]});
      }
    }
    for (const Element& element : elements_) contents_.elements.numbers.push_back(element.id);
    contents_.elements.turned = finish(mesh, edges, contents_.heights).turned;
    return std::move(contents_);
  }

  struct Element {
    ElementType type;
    std::size_t id, property;
    std::vector<std::size_t> nodes;
    std::size_t line;
  };
  struct Side {
    std::size_t element, side, line;
  };

  Lines lines_;
  std::string file_;
  Flatness flatness_;
  bool begun_;  // the file has BEGIN BULK
  bool bulk_;
  bool ended_ = false;
  BdfContents contents_;
  Fields card_;
  std::vector<double> heights_;  // of the grid points
  std::map<std::size_t, std::size_t> node_;
  std::vector<Element> elements_;
  std::map<std::size_t, std::int32_t> region_;
  std::map<std::size_t, std::string> set_name_;
  std::map<std::string, std::vector<std::pair<std::size_t, std::size_t>>> sets_;
  std::map<std::string, std::vector<Side>> sides_;
  std::string side_set_;
  std::set<std::string> left_out_;
};

}  // namespace

Result<BdfContents> parse_bdf(std::string_view text, const std::string& file, Flatness flatness) {
  DOBRA_TRY_VOID(check_text(text, file));
  return BdfReader(text, file, flatness).run();
}

Result<BdfContents> read_bdf(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_bdf(text, path);
}

}  // namespace dobra::io::meshes
