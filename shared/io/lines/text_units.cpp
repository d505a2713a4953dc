#include "shared/io/lines/text_units.h"

#include <algorithm>
#include <array>
#include <optional>

#include "shared/io/lines/text_fields.h"

namespace dobra::io::lines {

namespace {

struct LengthWord {
  std::string_view word;
  double metres;
};
constexpr double foot = 0.3048;
constexpr std::array<LengthWord, 51> length_words{{{"m", 1.0},
                                                   {"meter", 1.0},
                                                   {"meters", 1.0},
                                                   {"metre", 1.0},
                                                   {"metres", 1.0},
                                                   {"metro", 1.0},
                                                   {"metros", 1.0},
                                                   {"mts", 1.0},
                                                   {"km", 1000.0},
                                                   {"kms", 1000.0},
                                                   {"kilometer", 1000.0},
                                                   {"kilometers", 1000.0},
                                                   {"kilometre", 1000.0},
                                                   {"kilometres", 1000.0},
                                                   {"quilometro", 1000.0},
                                                   {"quilometros", 1000.0},
                                                   {"ft", foot},
                                                   {"foot", foot},
                                                   {"feet", foot},
                                                   {"pe", foot},
                                                   {"pes", foot},
                                                   {"usft", 1200.0 / 3937.0},
                                                   {"ftus", 1200.0 / 3937.0},
                                                   {"in", 0.0254},
                                                   {"inch", 0.0254},
                                                   {"inches", 0.0254},
                                                   {"polegada", 0.0254},
                                                   {"polegadas", 0.0254},
                                                   {"yd", 0.9144},
                                                   {"yard", 0.9144},
                                                   {"yards", 0.9144},
                                                   {"jarda", 0.9144},
                                                   {"jardas", 0.9144},
                                                   {"mi", 1609.344},
                                                   {"mile", 1609.344},
                                                   {"miles", 1609.344},
                                                   {"milha", 1609.344},
                                                   {"milhas", 1609.344},
                                                   {"dm", 0.1},
                                                   {"cm", 0.01},
                                                   {"centimeter", 0.01},
                                                   {"centimeters", 0.01},
                                                   {"centimetre", 0.01},
                                                   {"centimetres", 0.01},
                                                   {"centimetro", 0.01},
                                                   {"centimetros", 0.01},
                                                   {"mm", 0.001},
                                                   {"millimeters", 0.001},
                                                   {"millimetres", 0.001},
                                                   {"milimetro", 0.001},
                                                   {"milimetros", 0.001}}};
constexpr std::array<std::string_view, 13> time_units{
    "ms",      "s",        "sec",  "secs",         "seg",          "second",       "seconds",
    "segundo", "segundos", "msec", "milliseconds", "milissegundo", "milissegundos"};
constexpr std::array<std::string_view, 6> time_words{"twt", "twtt", "owt", "owtt", "time", "tempo"};
constexpr std::array<std::string_view, 4> angle_units{"deg", "degree", "degrees", "graus"};
constexpr std::array<std::string_view, 4> angle_words{"lon", "longitude", "lat", "latitude"};

template <std::size_t Count>
bool holds(const std::array<std::string_view, Count>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::optional<double> metres_of(std::string_view word) {
  const auto found = std::find_if(length_words.begin(), length_words.end(),
                                  [&](const LengthWord& known) { return known.word == word; });
  return found == length_words.end() ? std::nullopt : std::optional(found->metres);
}

/// Letters and digits together: "x_m2 (km)" as x, m2, km.
std::vector<std::string> words_and_numbers(std::string_view header) {
  std::vector<std::string> words(1);
  for (const char c : plain(header)) {
    const bool part = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
    if (part) words.back() += c;
    if (!part && !words.back().empty()) words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

}  // namespace

HeaderUnit unit_of(std::string_view header) {
  using Of = HeaderUnit::Of;
  const std::vector<std::string> words = words_and_numbers(header);
  if (words.empty()) return {};
  const std::string& last = words.back();
  const bool alone = words.size() == 1;
  if (const auto metres = metres_of(last); metres && !(alone && last == "in")) {
    const bool survey = *metres == foot && !alone && words[words.size() - 2] == "us";
    return {Of::Length, survey ? 1200.0 / 3937.0 : *metres, last};
  }
  if (holds(time_units, last) && (!alone || last == "ms")) return {Of::Time, 1.0, last};
  if (header.ends_with("\xC2\xB0") || header.ends_with("\xC2\xB0)") || holds(angle_units, last))
    return {Of::Angle, 1.0, "degrees"};
  for (const std::string& word : words) {
    if (holds(time_words, word)) return {Of::Time, 1.0, word};
    if (holds(angle_words, word)) return {Of::Angle, 1.0, word};
  }
  return {};
}

bool is_units_row(const std::vector<Word>& fields) {
  std::size_t units = 0;
  for (const Word& field : fields) {
    const std::vector<std::string> words = words_and_numbers(field.text);
    if (words.empty()) continue;  // nothing, "-", "()"
    const bool unit =
        words.size() == 1 && (metres_of(words[0]) || holds(time_units, words[0]) || holds(angle_units, words[0]));
    if (!unit) return false;
    ++units;
  }
  return units >= 2;
}

}  // namespace dobra::io::lines
