#include "shared/io/lines/text_fields.h"

#include <algorithm>
#include <array>
#include <utility>

#include "shared/io/lines/text_numbers.h"

namespace dobra::io::lines {

bool is_comment(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && line[first] == '#';
}

bool is_empty(std::string_view line) { return line.find_first_not_of(" \t\v\f") == std::string_view::npos; }

char sign_of(Separator separator) {
  switch (separator) {
    case Separator::Tab:
      return '\t';
    case Separator::Comma:
      return ',';
    case Separator::Semicolon:
      return ';';
    default:
      return ' ';
  }
}

void split_fields(std::string_view line, Separator separator, std::vector<Word>& fields) {
  if (separator == Separator::Blank) {
    split_words(line, fields);
    return;
  }
  fields.clear();
  const char sign = sign_of(separator);
  std::size_t begin = 0;
  bool in_quotes = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') in_quotes = !in_quotes;
    if (i < line.size() && (line[i] != sign || in_quotes)) continue;
    std::size_t low = begin;
    std::size_t high = i;
    const auto strip = [&](std::string_view what) {
      while (low < high && what.find(line[low]) != std::string_view::npos) ++low;
      while (low < high && what.find(line[high - 1]) != std::string_view::npos) --high;
    };
    strip(" \t\v\f");
    if (high - low >= 2 && line[low] == '"' && line[high - 1] == '"') ++low, --high;
    strip(" \t\v\f");
    fields.push_back({line.substr(low, high - low), low + 1});
    begin = i + 1;
  }
}

void split_header(std::string_view line, Separator separator, std::vector<Word>& fields) {
  split_fields(line, separator, fields);
  if (separator != Separator::Blank) return;
  if (std::any_of(fields.begin(), fields.end(), [](const Word& field) { return may_be_number(field.text); })) return;
  std::vector<Word> joined;
  for (const Word& field : fields) {
    if (joined.empty() || (field.text.front() != '(' && field.text.front() != '[')) {
      joined.push_back(field);
      continue;
    }
    const char* const begin = joined.back().text.data();
    joined.back().text = {begin, static_cast<std::size_t>(field.text.data() + field.text.size() - begin)};
  }
  fields = std::move(joined);
}

Separator separator_of_header(std::string_view header) {
  Separator best = Separator::Blank;
  std::size_t most = 1;
  std::vector<Word> fields;
  for (const Separator candidate : {Separator::Semicolon, Separator::Tab, Separator::Comma}) {
    split_fields(header, candidate, fields);
    if (fields.size() > most) most = fields.size(), best = candidate;
  }
  return best;
}

std::string_view first_row(std::string_view text) {
  Lines lines(text);
  while (lines.next()) {
    if (!is_empty(lines.line()) && !is_comment(lines.line())) return lines.line();
  }
  return {};
}

std::string plain(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, char>, 26> accents{
      {{"á", 'a'}, {"à", 'a'}, {"â", 'a'}, {"ã", 'a'}, {"é", 'e'}, {"ê", 'e'}, {"í", 'i'}, {"ó", 'o'}, {"ô", 'o'},
       {"õ", 'o'}, {"ú", 'u'}, {"ü", 'u'}, {"ç", 'c'}, {"Á", 'a'}, {"À", 'a'}, {"Â", 'a'}, {"Ã", 'a'}, {"É", 'e'},
       {"Ê", 'e'}, {"Í", 'i'}, {"Ó", 'o'}, {"Ô", 'o'}, {"Õ", 'o'}, {"Ú", 'u'}, {"Ü", 'u'}, {"Ç", 'c'}}};
  std::string made;
  for (std::size_t i = 0; i < word.size();) {
    const auto accent = std::find_if(accents.begin(), accents.end(),
                                     [&](const auto& a) { return word.substr(i).starts_with(a.first); });
    if (accent != accents.end()) {
      made += accent->second;
      i += accent->first.size();
      continue;
    }
    const char c = word[i++];
    const bool blank = c == ' ' || c == '_' || c == '-' || c == '\t';
    if (blank && (made.empty() || made.back() == ' ')) continue;
    made += blank ? ' ' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  while (!made.empty() && made.back() == ' ') made.pop_back();
  return made;
}

}  // namespace dobra::io::lines
