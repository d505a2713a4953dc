#include "shared/scenario/lines/import_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>

#include "shared/io/file.h"
#include "shared/io/lines/line_kinds.h"
#include "shared/io/lines/text_columns.h"
#include "shared/io/lines/text_rows.h"

namespace dobra::scenario::lines {

namespace {

constexpr std::size_t most_rows = 12;
constexpr std::size_t most_bytes = 1 << 18;

/// Words of one name, in small letters.
std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : name) {
    const bool part = (static_cast<unsigned char>(c) & 0x80U) != 0 || std::isalpha(static_cast<unsigned char>(c)) != 0;
    if (part)
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

struct Separators {
  const char* name;
  io::lines::Separator separator;
};
constexpr std::array<Separators, 4> separators{{{"blank", io::lines::Separator::Blank},
                                                {"tab", io::lines::Separator::Tab},
                                                {"comma", io::lines::Separator::Comma},
                                                {"semicolon", io::lines::Separator::Semicolon}}};

}  // namespace

std::vector<ImportChoice> choices_by(const std::vector<ImportRule>& rules, const ImportLook& look,
                                     const std::vector<Importing::Kind>& kinds) {
  std::vector<ImportChoice> choices;
  for (const ImportLine& line : look.lines) {
    const auto counts = [&](const ImportRule& rule) {
      const bool for_shape = std::any_of(kinds.begin(), kinds.end(), [&](const Importing::Kind& kind) {
        return kind.name == rule.kind && kind.shapes.contains(line.shape);
      });
      return for_shape && io::lines::fits(rule.pattern, line.name);
    };
    const auto rule = std::find_if(rules.begin(), rules.end(), counts);
    choices.push_back({rule == rules.end() ? line.kind : rule->kind, line.problem.empty()});
  }
  return choices;
}

std::vector<std::string> rules_for(const ImportLook& look, const ImportFile& file) {
  const auto line_rule = [](const std::string& pattern, const std::string& kind) { return pattern + '=' + kind; };
  // One rule for lines without a name would take all others: they then need rules of their own.
  std::optional<std::string> nameless;
  for (std::size_t i = 0; i < look.lines.size(); ++i) {
    if (look.lines[i].name.empty() && file.choices[i].kind != look.lines[i].stated) nameless = file.choices[i].kind;
  }
  const auto given = [&](const ImportLine& line) {
    for (const ImportRule& rule : file.rules) {
      if (io::lines::fits(rule.pattern, line.name)) return rule.kind;
    }
    return nameless ? *nameless : line.stated;
  };
  std::vector<std::string> made;
  std::vector<bool> used(file.rules.size(), false);
  for (std::size_t i = 0; i < look.lines.size(); ++i) {
    const ImportLine& line = look.lines[i];
    if (file.choices[i].kind == given(line)) {
      for (std::size_t k = 0; k < used.size(); ++k) {
        if (!io::lines::fits(file.rules[k].pattern, line.name)) continue;
        used[k] = true;
        break;
      }
      continue;
    }
    if (line.name.empty()) continue;
    std::string rule = line_rule(line.name, file.choices[i].kind);
    if (std::find(made.begin(), made.end(), rule) == made.end()) made.push_back(std::move(rule));
  }
  for (std::size_t k = 0; k < used.size(); ++k) {
    if (used[k]) made.push_back(line_rule(file.rules[k].pattern, file.rules[k].kind));
  }
  if (nameless) made.push_back(line_rule("*", *nameless));
  return made;
}

std::optional<std::string> kind_by_words(const std::string& name) {
  if (const auto kind = io::lines::known_kind(name)) return kind;
  static const std::map<std::string, std::string> more{
      {"topo", "topography"}, {"dem", "topography"}, {"crack", "crack"},   {"cracks", "crack"},  {"fracture", "crack"},
      {"fractures", "crack"}, {"trinca", "crack"},   {"trincas", "crack"}, {"fratura", "crack"}, {"fraturas", "crack"},
      {"fissura", "crack"},   {"fissuras", "crack"}, {"hole", "hole"},     {"furo", "hole"}};
  for (const std::string& word : words_of(name)) {
    // A word that is a kind; "top" and "marker" in a longer name say nothing of it.
    const auto kind = io::lines::known_kind(word);
    if (kind && *kind != "horizon" && *kind != "unit" && *kind != "marker" && *kind != "datum") return kind;
    std::string small = word;
    std::transform(small.begin(), small.end(), small.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (const auto found = more.find(small); found != more.end()) return found->second;
  }
  return std::nullopt;
}

std::optional<ImportTable> table_of(const std::string& path, const ImportReading& reading) {
  std::ifstream file(path, std::ios::binary);
  std::string text(most_bytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() == most_bytes) text.resize(text.rfind('\n') + 1);
  if (text.find('\0') != std::string::npos || io::first_byte_outside_utf8(text)) return std::nullopt;
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  auto separator = io::lines::Separator::Detect;
  for (const Separators& known : separators) {
    if (reading.separator == known.name) separator = known.separator;
  }
  io::lines::TextRows rows = io::lines::first_rows(text, separator, most_rows);
  if (rows.rows.empty()) return std::nullopt;
  ImportTable table{std::move(rows.header), std::move(rows.rows), rows.x, rows.height, rows.names};
  if (reading.x > 0) table.x = reading.x;
  if (reading.height > 0) table.height = reading.height;
  if (reading.names > 0) table.names = reading.names;
  table.depth =
      table.height > 0 && table.height <= table.header.size() && io::lines::says_depth(table.header[table.height - 1]);
  table.negative = std::ranges::none_of(table.rows, [&](const std::vector<std::string>& row) {
    return table.height > 0 && table.height <= row.size() && io::lines::is_above_nought(row[table.height - 1]);
  });
  return table;
}

std::string import_path(const Document& document, const std::filesystem::path& file) {
  const std::filesystem::path target = std::filesystem::absolute(file).lexically_normal();
  if (document.file.empty()) return target.generic_string();
  const std::filesystem::path relative =
      target.lexically_relative(std::filesystem::absolute(document.file).lexically_normal().parent_path());
  return (relative.empty() ? target : relative).generic_string();
}

std::string stem_of(const std::filesystem::path& file) { return file.stem().string(); }

std::vector<std::string> columns_by(const ImportReading& reading) {
  if (reading.x == 0 && reading.height == 0) return {};
  if (reading.map_y > 0)
    return {fmt::format("{}", reading.x), fmt::format("{}", reading.map_y), fmt::format("{}", reading.height)};
  return {fmt::format("{}", reading.x), fmt::format("{}", reading.height)};
}

}  // namespace dobra::scenario::lines
