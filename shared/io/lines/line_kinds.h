#pragma once
// What a line of a section is: the kinds, the words by which files call them in English and Portuguese, and kinds that
// are given by the names of lines, for files that carry none. Page: docs/user/import.md.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/lines/feature.h"

namespace dobra::io::lines {

/// The kind that a word means, in the spelling that features carry: "fault" for "Fault", "FALHAS" or "thrust fault".
/// Capitals, Portuguese accents, and blanks against '_' and '-' do not count. Nothing for other words.
std::optional<std::string> known_kind(std::string_view word);
/// "; did you mean 'fault'?", or where nothing is near, the kinds there are.
std::string kind_hint(std::string_view word);

/// Lines whose names fit the pattern are of the kind. In the pattern '*' stands for any text, '?' for one character.
struct KindRule {
  std::string pattern;
  std::string kind;
};
/// "F*=fault". @error InvalidOption: no '=', no pattern, a kind that is none (with a suggestion).
base::Result<KindRule> kind_rule(const std::string& text);
bool fits(std::string_view pattern, std::string_view name);

/// Gives features their kinds, by the first rule that fits the name, whatever the file says; words of the file become
/// those of `known_kind`. Remarks tell rules that fit nothing, and words that were changed.
void set_kinds(std::vector<Feature>& features, const std::vector<KindRule>& rules, const std::string& file,
               std::vector<std::string>& remarks);

/// @error BadFormat: the first feature whose kind is none, with file and line, and a suggestion.
base::Result<void> check_kinds(const std::vector<Feature>& features);

/// What a feature says that it is a piece of: its property piece_of, unit or formation; empty if nothing.
std::string stated_unit(const Feature& feature);

}  // namespace dobra::io::lines
