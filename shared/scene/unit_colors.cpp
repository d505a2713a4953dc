#include "shared/scene/unit_colors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "shared/base/text.h"

namespace dobra::scene {
namespace {

// Each fill is as far as can be from those before it, in CIE Lab as all see it and as those with protanopia and
// deuteranopia do; the lines are the fills at 0.58 of their lightness.
constexpr std::array<Color, 36> fills{
    {{244, 190, 110}, {112, 138, 216}, {60, 190, 164},  {255, 203, 242}, {112, 151, 73},  {73, 151, 177},
     {216, 112, 125}, {203, 229, 177}, {203, 177, 138}, {86, 190, 255},  {164, 177, 216}, {138, 203, 203},
     {151, 242, 203}, {242, 229, 151}, {216, 138, 99},  {99, 151, 125},  {255, 151, 190}, {190, 151, 229},
     {177, 125, 151}, {99, 151, 203},  {60, 216, 255},  {203, 151, 151}, {125, 242, 255}, {190, 190, 125},
     {60, 164, 164},  {190, 203, 177}, {190, 164, 86},  {255, 190, 151}, {190, 138, 112}, {255, 216, 229},
     {229, 177, 242}, {164, 216, 151}, {99, 242, 216},  {190, 138, 190}, {151, 177, 112}, {99, 164, 242}}};
constexpr std::array<Color, 36> lines{
    {{145, 102, 24}, {39, 78, 148},  {0, 111, 90},  {152, 106, 142}, {50, 89, 12},   {0, 89, 113},
     {143, 47, 65},  {105, 129, 82}, {119, 98, 62}, {0, 109, 168},   {85, 99, 134},  {51, 116, 117},
     {45, 138, 104}, {135, 127, 54}, {137, 70, 35}, {38, 89, 66},    {164, 69, 108}, {112, 78, 150},
     {112, 65, 89},  {16, 87, 134},  {0, 125, 161}, {126, 80, 80},   {0, 138, 151},  {105, 107, 47},
     {0, 97, 98},    {102, 114, 91}, {111, 92, 13}, {155, 100, 65},  {118, 74, 50},  {150, 115, 127},
     {138, 91, 150}, {75, 124, 65},  {0, 139, 118}, {118, 71, 119},  {77, 102, 42},  {0, 94, 164}}};
constexpr std::array<Pattern, 6> further{Pattern::None,   Pattern::Dots,    Pattern::Hatch,
                                         Pattern::Dashes, Pattern::Crosses, Pattern::BackHatch};

const std::array<std::string, 10> patterns = {"none",       "dots",        "bricks",  "dashes",  "hatch",
                                              "back_hatch", "cross_hatch", "circles", "crosses", "vees"};

std::string small_letters(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// What may stand before the number of a piece: "K2p_1" and "K2p (1)". Empty if there is no number.
std::string stem_of(const std::string& name) {
  const bool brackets = name.ends_with(')');
  const std::size_t end = name.size() - (brackets ? 1 : 0);
  std::size_t begin = end;
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(name[begin - 1])) != 0) --begin;
  const std::string sign = brackets ? " (" : "_";
  if (begin == end || begin <= sign.size() || name.compare(begin - sign.size(), sign.size(), sign) != 0) return {};
  return name.substr(0, begin - sign.size());
}

/// Words that number units instead of naming one.
bool is_generic(const std::string& stem) {
  static const std::set<std::string> words = {"unit",  "layer", "bed",     "polygon", "poly", "area",    "feature",
                                              "block", "zone",  "horizon", "body",    "face", "unidade", "camada"};
  return words.contains(small_letters(stem));
}

Color darker(Color color) {
  const auto part = [](std::uint8_t channel) { return static_cast<std::uint8_t>(channel * 11 / 20); };
  return {part(color.red), part(color.green), part(color.blue), color.alpha};
}

bool is_light(Color color) { return 0.30 * color.red + 0.59 * color.green + 0.11 * color.blue > 150.0; }

const ColorEntry* named(const ColorTable& table, const std::string& name) {
  for (const ColorEntry& entry : table.entries) {
    if (entry.name == name) return &entry;
  }
  const std::string small = small_letters(name);
  for (const ColorEntry& entry : table.entries) {
    if (small_letters(entry.name) == small) return &entry;
  }
  return nullptr;
}

std::string upper_of(const std::string& name) { return name.substr(0, name.find(" - ")); }

}  // namespace

UnitStyle unit_style(std::size_t number) {
  const std::size_t place = number % fills.size();
  return {fills[place], lines[place], further[number / fills.size() % further.size()]};
}

std::vector<std::string> whole_names(std::span<const std::string> names) {
  const std::set<std::string> all(names.begin(), names.end());
  std::map<std::string, std::set<std::string>> fellows;
  for (const std::string& name : all) {
    const std::string stem = stem_of(name);
    if (!stem.empty()) fellows[stem].insert(name);
  }
  std::vector<std::string> wholes;
  for (const std::string& name : names) {
    const std::string stem = stem_of(name);
    const auto found = fellows.find(stem);
    const bool fellow = found != fellows.end() && (found->second.size() > 1 || all.contains(stem));
    // Copies of one name are one unit; numbers behind a general word, or behind the only one, are names.
    const bool numbers_only =
        !name.ends_with(')') && (is_generic(stem) || found == fellows.end() || found->second.size() == all.size());
    wholes.push_back(fellow && !numbers_only ? stem : name);
  }
  return wholes;
}

std::vector<std::size_t> numbers_of(std::span<const std::string> names) {
  const std::set<std::string> all(names.begin(), names.end());
  std::map<std::string, std::size_t> places;
  for (const std::string& name : all) places.emplace(name, places.size());
  std::vector<std::size_t> numbers;
  for (const std::string& name : names) numbers.push_back(places.at(name));
  return numbers;
}

std::optional<Color> color_of_text(const std::string& text) {
  static const std::map<std::string, Color> known = {
      {"black", {0, 0, 0}},           {"white", {255, 255, 255}},      {"grey", {128, 128, 128}},
      {"gray", {128, 128, 128}},      {"red", {220, 40, 40}},          {"green", {60, 150, 60}},
      {"blue", {50, 90, 190}},        {"yellow", {250, 230, 80}},      {"orange", {240, 150, 50}},
      {"brown", {150, 100, 60}},      {"purple", {130, 80, 160}},      {"pink", {245, 170, 190}},
      {"cyan", {80, 200, 220}},       {"magenta", {200, 60, 160}},     {"beige", {235, 222, 190}},
      {"olive", {130, 130, 50}},      {"lightgreen", {170, 220, 150}}, {"lightblue", {170, 205, 235}},
      {"lightgrey", {211, 211, 211}}, {"tan", {210, 180, 140}}};
  const std::string small = small_letters(text);
  if (const auto found = known.find(small); found != known.end()) return found->second;
  std::array<int, 3> parts{};
  int read = 0;
  if (small.starts_with('#')) {
    const bool digits = std::all_of(small.begin() + 1, small.end(),
                                    [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; });
    if (!digits || (small.size() != 4 && small.size() != 7)) return std::nullopt;
    const std::size_t length = small.size() == 4 ? 1 : 2;
    for (std::size_t k = 0; k < 3; ++k) {
      const int part = std::stoi(small.substr(1 + k * length, length), nullptr, 16);
      parts[k] = length == 1 ? 17 * part : part;
    }
  } else {
    std::string end(small.size() + 1, 0);
    read = std::sscanf(small.c_str(), " %d %*[, ] %d %*[, ] %d %[^ ]", &parts[0], &parts[1], &parts[2], end.data());
    if (read != 3 || std::any_of(parts.begin(), parts.end(), [](int p) { return p < 0 || p > 255; }))
      return std::nullopt;
  }
  return Color{static_cast<std::uint8_t>(parts[0]), static_cast<std::uint8_t>(parts[1]),
               static_cast<std::uint8_t>(parts[2])};
}

std::span<const std::string> pattern_names() { return patterns; }

std::optional<Pattern> pattern_of_text(const std::string& text) {
  const auto found = std::find(patterns.begin(), patterns.end(), small_letters(text));
  if (found == patterns.end()) return std::nullopt;
  return static_cast<Pattern>(found - patterns.begin());
}

Pattern pattern_of_lithology(const std::string& words) {
  // Beginnings of words, English and Portuguese; of several rocks the first here counts: "sandy limestone" is one.
  static const std::vector<std::pair<Pattern, std::vector<const char*>>> rocks = {
      {Pattern::Bricks, {"limestone", "dolomit", "dolostone", "chalk", "marble", "carbonate", "calc", "mármore"}},
      {Pattern::Circles, {"conglomerate", "breccia", "gravel", "diamictite", "conglomerado", "brecha", "diamictito"}},
      {Pattern::Dots, {"sandstone", "quartzite", "sand", "arkose", "arenito", "quartzito", "areia"}},
      {Pattern::Dashes,
       {"shale", "mudstone", "siltstone", "claystone", "marl", "clay", "folhelho", "siltito", "argil"}},
      {Pattern::CrossHatch, {"salt", "halite", "gypsum", "anhydrite", "evaporite", "sal", "gipsita", "evaporito"}},
      {Pattern::Crosses, {"granit", "gneiss", "basement", "pluton", "migmatite", "gnaisse", "embasamento"}},
      {Pattern::Vees, {"basalt", "volcan", "tuff", "lava", "andesite", "rhyolite", "vulc", "tufo"}},
      {Pattern::Hatch, {"schist", "slate", "phyllite", "mica", "xisto", "filito", "ardós"}},
      {Pattern::BackHatch, {"coal", "lignite", "carvão"}}};
  const std::string small = small_letters(words);
  for (const auto& [pattern, names] : rocks) {
    for (const char* const name : names) {
      for (std::size_t at = small.find(name); at != std::string::npos; at = small.find(name, at + 1)) {
        if (at == 0 || std::isalpha(static_cast<unsigned char>(small[at - 1])) == 0) return pattern;
      }
    }
  }
  return Pattern::None;
}

const ColorEntry* entry_for(const ColorTable& table, const std::string& name, const std::string& whole) {
  for (const std::string& wanted : {name, whole, upper_of(name)}) {
    if (const ColorEntry* entry = named(table, wanted)) return entry;
  }
  return nullptr;
}

void paint(Picture& picture, const ColorTable& table) {
  for (Panel& panel : picture.panels) {
    for (Layer& layer : panel.layers) {
      const ColorEntry* entry = entry_for(table, layer.title, legend_name(layer));
      if (entry == nullptr || std::holds_alternative<Mesh>(layer.content)) continue;
      const bool area = std::holds_alternative<Regions>(layer.content);
      if (area) {
        layer.style.pattern = entry->pattern.value_or(pattern_of_lithology(entry->lithology));
        std::string words;
        for (const std::string* text : {&entry->age, &entry->lithology}) {
          if (!text->empty()) words += (words.empty() ? "" : ", ") + *text;
        }
        if (!words.empty()) layer.legend = fmt::format("{} ({})", legend_name(layer), words);
      }
      if (!entry->color) continue;
      if (area && layer.style.fill) {
        const std::uint8_t alpha = layer.style.fill->alpha;
        layer.style.fill = *entry->color;
        layer.style.fill->alpha = alpha;
      } else if (!area) {
        const bool text = std::holds_alternative<Labels>(layer.content);
        const auto usual = std::find(fills.begin(), fills.end(), *entry->color);  // has a line of its own
        layer.style.line = usual != fills.end()              ? lines[static_cast<std::size_t>(usual - fills.begin())]
                           : text && is_light(*entry->color) ? darker(*entry->color)
                                                             : *entry->color;
      }
    }
  }
}

std::vector<std::string> remarks_on(const ColorTable& table, std::span<const std::string> names) {
  const std::vector<std::string> wholes = whole_names(names);
  std::set<const ColorEntry*> used;
  std::vector<std::string> unnamed;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const ColorEntry* entry = entry_for(table, names[i], wholes[i]);
    if (entry != nullptr) used.insert(entry);
    const bool known = std::find(unnamed.begin(), unnamed.end(), wholes[i]) != unnamed.end();
    if (entry == nullptr && !known) unnamed.push_back(wholes[i]);
  }
  std::vector<std::string> unused;
  for (const ColorEntry& entry : table.entries) {
    if (used.contains(&entry)) continue;
    unused.push_back(fmt::format(
        "'{}'{}", entry.name, base::did_you_mean(entry.name, std::vector<std::string>(wholes.begin(), wholes.end()))));
  }
  std::vector<std::string> remarks;
  if (!unused.empty())
    remarks.push_back(fmt::format("colours: the section has nothing of the name {}", fmt::join(unused, ", ")));
  if (!unnamed.empty()) {
    remarks.push_back(
        fmt::format("colours: the table does not name '{}'; they keep the usual colours", fmt::join(unnamed, "', '")));
  }
  return remarks;
}

}  // namespace dobra::scene
