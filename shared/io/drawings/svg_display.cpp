#include "shared/io/drawings/svg_display.h"
#include "shared/base/text.h"

#include <algorithm>
#include <optional>

#include "shared/io/scan.h"

namespace dobra::io::drawings {
namespace {

/// The pieces of a text between separators, without blanks round them.
std::vector<std::string_view> pieces_of(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    pieces.push_back(base::trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return pieces;
}

/// "a: b; c: d !important": of `c` it is "d".
std::optional<std::string> declared(std::string_view declarations, std::string_view property) {
  std::optional<std::string> value;
  for (const std::string_view piece : pieces_of(declarations, ';')) {
    const std::size_t colon = piece.find(':');
    if (colon == std::string_view::npos || base::trimmed(piece.substr(0, colon)) != property) continue;
    const std::string_view said = piece.substr(colon + 1);
    value = std::string(base::trimmed(said.substr(0, said.find('!'))));
  }
  return value;
}

std::string without_comments(std::string_view sheet) {
  std::string text;
  while (true) {
    const std::size_t begin = sheet.find("/*");
    text += sheet.substr(0, begin);
    const std::size_t end = begin == std::string_view::npos ? begin : sheet.find("*/", begin + 2);
    if (end == std::string_view::npos) return text;
    sheet.remove_prefix(end + 2);
  }
}

/// The place behind the bracket that closes the one at `open`.
std::size_t behind_block(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t at = open; at < text.size(); ++at) {
    if (text[at] == '{') ++depth;
    if (text[at] == '}' && --depth == 0) return at + 1;
  }
  return text.size();
}

bool is_of_class(const pugi::xml_node& element, std::string_view name) {
  std::vector<Word> words;
  split_words(element.attribute("class").value(), words);
  return std::any_of(words.begin(), words.end(), [&](const Word& word) { return word.text == name; });
}

}  // namespace

SvgDisplay::SvgDisplay(const Xml& xml) {
  // The predicate sees every element and takes none.
  xml.root().find_node([&](const pugi::xml_node& node) {
    if (local_name(node) == "style") {
      for (const pugi::xml_node& text : node.children()) add_sheet(text.value());
    }
    return false;
  });
}

void SvgDisplay::add_sheet(std::string_view sheet) {
  const std::string text = without_comments(sheet);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find('{', at);
    if (open == std::string::npos) return;
    const std::string_view selectors = base::trimmed(std::string_view(text).substr(at, open - at));
    at = behind_block(text, open);
    if (selectors.starts_with('@')) continue;  // for some media only
    const std::string declarations = text.substr(open + 1, at - open - 2);
    for (const std::string_view selector : pieces_of(selectors, ',')) {
      const bool simple =
          !selector.empty() && selector.substr(1).find_first_of(" \t\r\n.#:>+~[*") == std::string_view::npos;
      if (simple) rules_.push_back({std::string(selector), declarations});
    }
  }
}

std::string SvgDisplay::value(const pugi::xml_node& element, std::string_view property) const {
  std::optional<std::string> said = declared(element.attribute("style").value(), property);
  std::array<std::optional<std::string>, 3> by_rule;  // of an id, a class, a name
  for (const auto& [selector, declarations] : rules_) {
    const std::string_view name = std::string_view(selector).substr(1);
    const bool of_id = selector.front() == '#', of_class = selector.front() == '.';
    const bool fits = of_id      ? name == element.attribute("id").value()
                      : of_class ? is_of_class(element, name)
                                 : selector == local_name(element);
    if (!fits) continue;
    if (auto own = declared(declarations, property)) by_rule[of_id ? 0 : of_class ? 1 : 2] = std::move(own);
  }
  for (const auto& rule : by_rule) {
    if (!said) said = rule;
  }
  if (!said) said = std::string(base::trimmed(element.attribute(std::string(property).c_str()).value()));
  return *said == "inherit" ? "" : *said;
}

}  // namespace dobra::io::drawings
