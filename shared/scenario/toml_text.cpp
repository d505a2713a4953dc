#include "shared/scenario/toml_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/base/text.h"

namespace dobra::scenario {
namespace {

constexpr std::size_t columns = 120;

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    switch (c) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\b':
        out += "\\b";
        break;
      case '\t':
        out += "\\t";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\f':
        out += "\\f";
        break;
      case '\r':
        out += "\\r";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
          out += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
        else
          out += c;
    }
  }
  return out + '"';
}

std::string key_toml(const std::string& key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  return bare ? key : quoted(key);
}

std::string item_toml(double value) {
  const std::string text = base::number_text(value);
  return text == "-nan" ? "nan" : text;
}
std::string item_toml(const std::string& value) { return quoted(value); }
std::string item_toml(const geom::Point& value) {
  return fmt::format("[{}, {}]", item_toml(value.x), item_toml(value.y));
}
std::string item_toml(const geom::Point3& value) {
  return fmt::format("[{}, {}, {}]", item_toml(value.x), item_toml(value.y), item_toml(value.z));
}
std::string item_toml(const Table& table) {
  std::string out;
  for (const Table::Entry& entry : table.entries()) {
    out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", key_toml(entry.key), value_toml(entry.value));
  }
  return out.empty() ? "{}" : "{ " + out + " }";
}

std::string one_line(const std::vector<std::string>& items) { return fmt::format("[{}]", fmt::join(items, ", ")); }

std::string wrapped(const std::vector<std::string>& items) {
  std::string out = "[\n";
  std::string line = " ";
  for (const std::string& item : items) {
    if (line.size() > 1 && line.size() + item.size() + 2 > columns) {
      out += line + '\n';
      line = " ";
    }
    line += ' ' + item + ',';
  }
  return out + line + "\n]";
}

/// The items of a list; nothing for a value that is no list.
struct Items {
  std::vector<std::string> texts;
  bool is_list = false;

  template <class T>
  void operator()(const T&) {}
  template <class T>
  void operator()(const std::vector<T>& list) {
    is_list = true;
    for (const T& item : list) texts.push_back(item_toml(item));
  }
  void operator()(const Points& list) {
    is_list = true;
    for (const geom::Point& item : list) texts.push_back(item_toml(item));
  }
};

std::string scalar_toml(const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *integer);
  if (const auto* number = std::get_if<double>(&value)) return item_toml(*number);
  if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
  return item_toml(std::get<geom::Point>(value));
}

const std::vector<Table>* nested(const Value& value) {
  const auto* tables = std::get_if<std::vector<Table>>(&value);
  return tables != nullptr && !tables->empty() ? tables : nullptr;
}

}  // namespace

std::string value_toml(const Value& value) {
  Items items;
  std::visit(items, value);
  return items.is_list ? one_line(items.texts) : scalar_toml(value);
}

std::string entry_toml(const std::string& key, const Value& value) {
  const std::string start = key_toml(key) + " = ";
  Items items;
  std::visit(items, value);
  if (!items.is_list) return start + scalar_toml(value) + '\n';
  const std::string text = one_line(items.texts);
  return start + (start.size() + text.size() <= columns ? text : wrapped(items.texts)) + '\n';
}

std::string comment_toml(const std::string& comment) {
  if (comment.empty()) return {};
  std::string out;
  std::size_t begin = 0;
  while (begin <= comment.size()) {
    const std::size_t end = std::min(comment.find('\n', begin), comment.size());
    std::string line = comment.substr(begin, end - begin);
    // TOML allows no control characters in comments, tabs excepted.
    std::replace_if(
        line.begin(), line.end(), [](char c) { return (c >= 0 && c < 0x20 && c != '\t') || c == 0x7F; }, ' ');
    while (!line.empty() && (line.back() == ' ' || line.back() == '\t')) line.pop_back();
    out += line.empty() ? "#\n" : "# " + line + '\n';
    begin = end + 1;
  }
  return out;
}

std::string table_toml(const Table& table, const std::string& path) {
  std::string out;
  for (const Table::Entry& entry : table.entries()) {
    if (nested(entry.value) == nullptr) out += comment_toml(entry.comment) + entry_toml(entry.key, entry.value);
  }
  for (const Table::Entry& entry : table.entries()) {
    const std::vector<Table>* rows = nested(entry.value);
    if (rows == nullptr) continue;
    const std::string name = path + '.' + key_toml(entry.key);
    for (const Table& row : *rows) {
      out += '\n' + comment_toml(row.comment) + fmt::format("[[{}]]\n", name) + table_toml(row, name);
    }
  }
  return out;
}

}  // namespace dobra::scenario
