#include "shared/io/lines/line_kinds.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "shared/base/text.h"
#include "shared/io/lines/text_fields.h"
#include "shared/io/scan.h"

namespace dobra::io::lines {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

/// A kind, and the words for it: small letters, without accents, blanks between words, in the singular.
struct KindWords {
  const char* kind;
  std::vector<std::string> words;
};

const std::vector<KindWords>& all_kinds() {
  static const std::vector<KindWords> kinds{
      {"horizon",
       {"horizon", "horizonte", "bed", "bedding", "layer", "camada", "acamamento", "top", "contact", "contato",
        "unconformity", "discordancia"}},
      {"growth",
       {"growth", "growth bed", "growth horizon", "growth strata", "crescimento", "camada de crescimento",
        "horizonte de crescimento", "estrato de crescimento", "syntectonic", "syn tectonic", "sintectonico"}},
      {"fault",
       {"fault", "falha", "thrust", "thrust fault", "normal fault", "reverse fault", "strike slip fault", "detachment",
        "empurrao", "falha de empurrao", "falha normal", "falha inversa", "falha reversa", "falha transcorrente",
        "descolamento"}},
      {"pin", {"pin", "pin line", "pinline", "pino", "linha de pino"}},
      {"loose", {"loose", "loose line", "solta", "linha solta"}},
      {"topography",
       {"topography", "topografia", "terrain", "terreno", "ground", "ground surface", "topographic profile",
        "perfil topografico", "relevo"}},
      {"datum", {"datum", "reference", "referencia", "nivel de referencia"}},
      {"eroded", {"eroded", "erodido", "erodida"}},
      {"unit",
       {"unit", "unidade", "polygon", "poligono", "formation", "formacao", "member", "membro", "rock unit",
        "geological unit", "unidade geologica"}},
      {"border", {"border", "boundary", "borda", "limite", "contorno", "frame", "moldura"}},
      {"marker", {"marker", "marcador", "marco", "pick", "point", "ponto", "well pick", "well marker", "fossil"}}};
  return kinds;
}

std::optional<std::string> kind_of(const std::string& word) {
  for (const KindWords& kind : all_kinds()) {
    if (std::find(kind.words.begin(), kind.words.end(), word) != kind.words.end()) return kind.kind;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> known_kind(std::string_view word) {
  std::string singular = plain(word);
  auto kind = kind_of(singular);
  for (const std::string_view plural : {"es", "s"}) {
    if (kind || !singular.ends_with(plural)) continue;
    kind = kind_of(singular.substr(0, singular.size() - plural.size()));
  }
  return kind;
}

std::string kind_hint(std::string_view word) {
  std::vector<std::string> words;
  std::vector<std::string> kinds;
  for (const KindWords& kind : all_kinds()) {
    kinds.emplace_back(kind.kind);
    words.insert(words.end(), kind.words.begin(), kind.words.end());
  }
  if (const std::string hint = base::did_you_mean(plain(word), words); !hint.empty()) return hint;
  return fmt::format("; give one of {}", fmt::join(kinds, ", "));
}

Result<KindRule> kind_rule(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0) {
    return Error{ErrorCode::InvalidOption,
                 fmt::format("{} names no pattern and kind; give them as 'F*=fault'", shown(text))};
  }
  const std::string word = text.substr(sign + 1);
  const auto kind = known_kind(word);
  if (!kind)
    return Error{ErrorCode::InvalidOption,
                 fmt::format("{}: unknown kind {}{}", shown(text), shown(word), kind_hint(word))};
  return KindRule{text.substr(0, sign), *kind};
}

bool fits(std::string_view pattern, std::string_view name) {
  std::size_t p = 0;
  std::size_t n = 0;
  std::size_t star = std::string_view::npos;  // the last '*', and where the name went on behind what it stands for
  std::size_t behind = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      behind = n;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p, ++n;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      n = ++behind;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

void set_kinds(std::vector<Feature>& features, const std::vector<KindRule>& rules, const std::string& file,
               std::vector<std::string>& remarks) {
  std::vector<bool> used(rules.size(), false);
  std::set<std::string> told;
  for (Feature& feature : features) {
    bool ruled = false;
    for (std::size_t i = 0; i < rules.size(); ++i) {
      if (!fits(rules[i].pattern, feature.name)) continue;
      used[i] = true;  // also where an earlier rule goes before
      if (!std::exchange(ruled, true)) feature.kind = rules[i].kind;
    }
    const auto kind = ruled || feature.kind.empty() ? std::nullopt : known_kind(feature.kind);
    if (!kind || *kind == feature.kind) continue;
    if (told.insert(feature.kind).second)
      remarks.push_back(fmt::format("{}: kind {} is taken as '{}'", file, shown(feature.kind), *kind));
    feature.kind = *kind;
  }
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (used[i]) continue;
    remarks.push_back(fmt::format("{}: no name fits {}, so that nothing became '{}' by it", file,
                                  shown(rules[i].pattern), rules[i].kind));
  }
}

std::string stated_unit(const Feature& feature) {
  for (const char* const key : {"piece_of", "unit", "formation"}) {
    for (const auto& [name, value] : feature.properties) {
      const auto* text = std::get_if<std::string>(&value);
      if (name == key && text != nullptr && !text->empty()) return *text;
    }
  }
  return {};
}

Result<void> check_kinds(const std::vector<Feature>& features) {
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Feature& feature = features[i];
    if (feature.kind.empty() || known_kind(feature.kind)) continue;
    Place place = feature.source;
    place.item = item_of(i + 1, feature);
    return Error{
        ErrorCode::BadFormat,
        fmt::format("unknown kind {}{} (--kind 'F*=fault', in scenarios kind = [\"F*=fault\"], gives kinds by names)",
                    shown(feature.kind), kind_hint(feature.kind)),
        place};
  }
  return {};
}

}  // namespace dobra::io::lines
