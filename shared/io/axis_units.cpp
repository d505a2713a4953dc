#include "shared/io/axis_units.h"

#include <algorithm>
#include <cctype>

#include "shared/io/scan.h"

namespace dobra::io {

AxisUnits axis_units(std::string_view text) {
  std::string plain(text);
  plain.erase(std::remove(plain.begin(), plain.end(), '"'), plain.end());
  std::vector<Word> words;
  split_words(plain, words);
  AxisUnits units;
  for (const Word& word : words) {
    std::string name(word.text);
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (name == "m" || name == "meter" || name == "meters" || name == "metre" || name == "metres")
      units.metres.push_back(1.0);
    else if (name == "km")
      units.metres.push_back(1000.0);
    else if (name == "ft" || name == "foot" || name == "feet")
      units.metres.push_back(0.3048);
    else
      units.unknown = word.text;
  }
  return units;
}

std::string_view name_of_unit(double metres) { return metres == 1.0 ? "m" : metres == 1000.0 ? "km" : "ft"; }

}  // namespace dobra::io
