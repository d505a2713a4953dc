#include "shared/scenario/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "shared/base/text.h"

#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

namespace dobra::scenario {
namespace {

using base::Error;
using base::ErrorCode;

base::Place place_at(const toml::source_region& region, const std::string& file) {
  base::Place place;
  place.file = file;
  place.line = region.begin.line;
  place.column = region.begin.column;
  return place;
}

/// The comments of a file by the line of the key or header that they belong to. toml++ drops comments, so they are
/// taken from the lines between what it parsed, and from behind what it parsed.
class Comments {
 public:
  Comments(const std::string& text, const toml::table& root) {
    split(text);
    collect(root);
    std::size_t next = 1;
    for (const auto& [line, end] : spans_) {
      std::string above = between(next, line);
      std::string behind = after(end);
      by_line_[line] = joined_comments(above, behind);
      next = std::max<std::size_t>(next, end.line + 1);
    }
    end_ = between(next, static_cast<toml::source_index>(lines_.size() + 1));
  }

  /// Each comment is handed out once: an implicit table has the line of the first one inside it.
  std::string take(const toml::source_region& region) {
    const auto found = by_line_.find(region.begin.line);
    if (found == by_line_.end()) return {};
    std::string comment = std::move(found->second);
    by_line_.erase(found);
    return comment;
  }
  [[nodiscard]] const std::string& end() const { return end_; }

 private:
  void split(const std::string& text) {
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      lines_.push_back(text.substr(begin, end - begin));
      if (!lines_.back().empty() && lines_.back().back() == '\r') lines_.back().pop_back();
      begin = end + 1;
    }
  }

  void add(toml::source_index line, const toml::source_position& end) {
    auto& known = spans_[line];
    if (known < end) known = end;
  }

  void collect(const toml::table& table) {
    for (auto&& [key, node] : table) {
      const auto* sub_table = node.as_table();
      const auto* array = node.as_array();
      if (sub_table != nullptr && !sub_table->is_inline()) {
        add(node.source().begin.line, node.source().end);
        collect(*sub_table);
      } else if (array != nullptr && is_table_array(*array)) {
        for (auto&& row : *array) {
          add(row.source().begin.line, row.source().end);
          collect(*row.as_table());
        }
      } else {
        add(key.source().begin.line, node.source().end);
      }
    }
  }

  /// [[name]] headers, not a list of inline tables.
  static bool is_table_array(const toml::array& array) {
    return !array.empty() && std::all_of(array.begin(), array.end(), [](const toml::node& row) {
      return row.is_table() && !row.as_table()->is_inline();
    });
  }

  /// The text of a comment, if `line` from `begin` on is nothing else.
  static std::optional<std::string> comment_in(const std::string& line, std::size_t begin) {
    begin = line.find_first_not_of(" \t", begin);
    if (begin == std::string::npos || line[begin] != '#') return std::nullopt;
    ++begin;
    if (begin < line.size() && line[begin] == ' ') ++begin;
    std::string comment = line.substr(begin);
    while (!comment.empty() && (comment.back() == ' ' || comment.back() == '\t')) comment.pop_back();
    return comment;
  }

  [[nodiscard]] std::string between(std::size_t from, std::size_t to) const {
    std::string comment;
    bool first = true;
    for (std::size_t line = from; line < to && line <= lines_.size(); ++line) {
      const auto text = comment_in(lines_[line - 1], 0);
      if (!text) continue;
      comment += (first ? "" : "\n") + *text;
      first = false;
    }
    return comment;
  }

  [[nodiscard]] std::string after(const toml::source_position& end) const {
    if (end.line == 0 || end.line > lines_.size()) return {};
    const std::string& line = lines_[end.line - 1];
    // Columns count characters, not bytes.
    std::size_t byte = 0;
    for (toml::source_index column = 1; column < end.column && byte < line.size(); ++column) {
      ++byte;
      while (byte < line.size() && (static_cast<unsigned char>(line[byte]) & 0xC0U) == 0x80U) ++byte;
    }
    return comment_in(line, byte).value_or("");
  }

  std::vector<std::string> lines_;
  std::map<toml::source_index, toml::source_position> spans_;
  std::map<toml::source_index, std::string> by_line_;
  std::string end_;
};

class Reader {
 public:
  Reader(std::string file, Comments* comments) : file_(std::move(file)), comments_(comments) {}

  base::Result<Table> table(const toml::table& source, const std::string& path) {
    std::vector<std::pair<const toml::key*, const toml::node*>> in_order;
    for (auto&& [key, node] : source) in_order.emplace_back(&key, &node);
    // toml++ sorts by key; nested tables go last, as they are written.
    std::stable_sort(in_order.begin(), in_order.end(), [](const auto& a, const auto& b) {
      const bool a_nested = is_rows(*a.second);
      const bool b_nested = is_rows(*b.second);
      return a_nested != b_nested ? b_nested : a.first->source().begin < b.first->source().begin;
    });
    Table out;
    for (const auto& [key, node] : in_order) {
      const std::string name(key->str());
      DOBRA_TRY(Value read, value(*node, name, path));
      const bool nested = std::holds_alternative<std::vector<Table>>(read);
      out.set(name, std::move(read), place_at(key->source(), file_));
      if (!nested && !source.is_inline()) out.set_comment(name, comments_->take(key->source()));
    }
    out.own_place = place_at(source.source(), file_);
    if (!source.is_inline()) out.comment = comments_->take(source.source());
    return out;
  }

  base::Result<Value> value(const toml::node& node, const std::string& name, const std::string& path) {
    if (const auto* flag = node.as_boolean()) return Value(flag->get());
    if (const auto* integer = node.as_integer()) return Value(std::int64_t{integer->get()});
    if (const auto* number = node.as_floating_point()) return Value(number->get());
    if (const auto* text = node.as_string()) return Value(text->get());
    if (const auto* array = node.as_array()) return list(*array, name, path);
    if (node.is_table()) {
      return error(
          node,
          fmt::format(
              "'{}' is a table inside a table; write its values as keys of their own, or several such tables under "
              "[[{}{}]]",
              name, path.empty() ? "" : path + ".", name));
    }
    return error(node, fmt::format("'{}' is a date or time, which no key takes; write a text in quotes", name));
  }

  /// The rows under [[name]].
  base::Result<std::vector<Table>> rows(const toml::array& array, const std::string& path) {
    std::vector<Table> out;
    for (auto&& row : array) {
      DOBRA_TRY(Table read, table(*row.as_table(), path));
      out.push_back(std::move(read));
    }
    return out;
  }

 private:
  static bool is_rows(const toml::node& node) {
    const auto* array = node.as_array();
    return array != nullptr && !array->empty() && array->front().is_table();
  }

  Error error(const toml::node& node, std::string message) const {
    return Error{ErrorCode::BadValue, std::move(message), place_at(node.source(), file_)};
  }

  base::Result<Value> list(const toml::array& array, const std::string& name, const std::string& path) {
    if (array.empty()) return Value(std::vector<double>{});
    const auto all = [&](auto&& test) { return std::all_of(array.begin(), array.end(), test); };
    if (all([](const toml::node& item) { return item.is_number(); })) return Value(numbers(array));
    if (all([](const toml::node& item) { return item.is_string(); })) {
      std::vector<std::string> texts;
      for (auto&& item : array) texts.push_back(item.as_string()->get());
      return Value(std::move(texts));
    }
    if (all([](const toml::node& item) { return item.is_table(); })) {
      DOBRA_TRY(std::vector<Table> tables, rows(array, path.empty() ? name : path + "." + name));
      return Value(std::move(tables));
    }
    if (all([](const toml::node& item) { return item.is_array(); })) return points(array, name);
    const auto& first = array.front();
    const auto odd = std::find_if(array.begin(), array.end(), [&](const toml::node& item) {
      return item.is_number() ? !first.is_number() : item.type() != first.type();
    });
    return error(
        odd == array.end() ? static_cast<const toml::node&>(array) : *odd,
        fmt::format("'{}' mixes kinds of values; a list holds only numbers, only points [x, y] or only texts", name));
  }

  static std::vector<double> numbers(const toml::array& array) {
    std::vector<double> out;
    out.reserve(array.size());
    for (auto&& item : array) out.push_back(*item.value<double>());
    return out;
  }

  /// All of two numbers, or all of three.
  base::Result<Value> points(const toml::array& array, const std::string& name) const {
    if (array.front().as_array()->size() == 3) return points_in_space(array, name);
    std::vector<geom::Point> out;
    out.reserve(array.size());
    for (auto&& item : array) {
      const toml::array& pair = *item.as_array();
      if (pair.size() != 2 || !pair[0].is_number() || !pair[1].is_number()) {
        return error(item, fmt::format("point {} of '{}' is not a pair of numbers [x, y]", out.size() + 1, name));
      }
      out.push_back({*pair[0].value<double>(), *pair[1].value<double>()});
    }
    return Value(std::move(out));
  }

  base::Result<Value> points_in_space(const toml::array& array, const std::string& name) const {
    std::vector<geom::Point3> out;
    out.reserve(array.size());
    for (auto&& item : array) {
      const toml::array& triple = *item.as_array();
      if (triple.size() != 3 || !triple[0].is_number() || !triple[1].is_number() || !triple[2].is_number()) {
        return error(item, fmt::format("point {} of '{}' is not a triple of numbers [x, y, z]", out.size() + 1, name));
      }
      out.push_back({*triple[0].value<double>(), *triple[1].value<double>(), *triple[2].value<double>()});
    }
    return Value(std::move(out));
  }

  std::string file_;
  Comments* comments_;
};

/// What toml++ says, without its opening words.
std::string syntax_message(const toml::parse_error& error) {
  std::string text(error.description());
  std::replace(text.begin(), text.end(), '\n', ' ');
  const std::string opening = "Error while parsing ";
  if (text.starts_with(opening)) text = "in " + text.substr(opening.size());
  return "not valid TOML: " + text;
}

Error wrong_form(const toml::node& node, const std::string& file, std::string message) {
  return Error{ErrorCode::BadValue, std::move(message), place_at(node.source(), file)};
}

base::Result<void> read_part(Reader& reader, const toml::key& key, const toml::node& node, const std::string& file,
                             ScenarioTables& out) {
  static const std::array<std::string, 9> known = {"dobra",      "program", "title", "unit_system", "result_units",
                                                   "lines_file", "input",   "step",  "expect"};
  const std::string name(key.str());
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    std::string message =
        fmt::format("unknown key '{}' at the top of a scenario{}", name, base::did_you_mean(name, known));
    return Error{ErrorCode::UnknownKey, std::move(message), place_at(key.source(), file)};
  }
  if (name == "input") {
    if (!node.is_table()) return wrong_form(node, file, "the input is one table; write [input]");
    DOBRA_TRY(out.input, reader.table(*node.as_table(), name));
    return {};
  }
  if (name == "step" || name == "expect") {
    const auto* array = node.as_array();
    const bool rows = array != nullptr &&
                      std::all_of(array->begin(), array->end(), [](const toml::node& row) { return row.is_table(); });
    if (!rows)
      return wrong_form(node, file, fmt::format("there can be several; write [[{}]] with double brackets", name));
    DOBRA_TRY((name == "step" ? out.steps : out.expects), reader.rows(*array, name));
    return {};
  }
  DOBRA_TRY(Value value, reader.value(node, name, ""));
  out.top.set(name, std::move(value), place_at(key.source(), file));
  return {};
}

}  // namespace

std::string joined_comments(const std::string& first, const std::string& second) {
  return first.empty() ? second : second.empty() ? first : first + '\n' + second;
}

base::Result<ScenarioTables> read_scenario_tables(const std::string& text, const std::string& file) {
  const toml::parse_result parsed = toml::parse(text, file);
  if (!parsed) {
    return Error{ErrorCode::BadSyntax, syntax_message(parsed.error()), place_at(parsed.error().source(), file)};
  }
  const toml::table& root = parsed.table();
  Comments comments(text, root);
  Reader reader(file, &comments);
  ScenarioTables out;
  out.top.own_place.file = file;
  out.top.own_place.line = 1;
  std::vector<std::pair<const toml::key*, const toml::node*>> in_order;
  for (auto&& [key, node] : root) in_order.emplace_back(&key, &node);
  std::sort(in_order.begin(), in_order.end(),
            [](const auto& a, const auto& b) { return a.first->source().begin < b.first->source().begin; });
  for (const auto& [key, node] : in_order) {
    DOBRA_TRY_VOID(read_part(reader, *key, *node, file, out));
    if (!node->is_table() && out.top.find(key->str()) != nullptr) {
      out.top.comment = joined_comments(out.top.comment, comments.take(key->source()));
    }
  }
  out.end_comment = comments.end();
  return out;
}

base::Result<std::vector<Table>> read_rows(const std::string& text, const std::string& file, const std::string& key) {
  const toml::parse_result parsed = toml::parse(text, file);
  if (!parsed) {
    return Error{ErrorCode::BadSyntax, syntax_message(parsed.error()), place_at(parsed.error().source(), file)};
  }
  Comments comments(text, parsed.table());
  Reader reader(file, &comments);
  std::vector<Table> rows;
  for (auto&& [name, node] : parsed.table()) {
    const auto* array = node.as_array();
    const bool tables = array != nullptr && !array->empty() &&
                        std::all_of(array->begin(), array->end(), [](const toml::node& row) { return row.is_table(); });
    if (name.str() != key || !tables) {
      return Error{ErrorCode::UnknownKey, fmt::format("'{}' is not known here; write [[{}]] tables", name.str(), key),
                   place_at(name.source(), file)};
    }
    DOBRA_TRY(rows, reader.rows(*array, key));
  }
  return rows;
}

base::Result<Value> read_value(const std::string& text) {
  const toml::parse_result parsed = toml::parse("value = " + text);
  if (!parsed) return Error{ErrorCode::BadSyntax, syntax_message(parsed.error())};
  const toml::table& root = parsed.table();
  if (root.size() != 1) return Error{ErrorCode::BadSyntax, "not valid TOML: more than one value"};
  Comments comments("", root);
  auto value = Reader("", &comments).value(*root.get("value"), "value", "");
  if (!value) return Error{value.error().code, value.error().message};
  return value;
}

}  // namespace dobra::scenario
