#include "shared/scenario/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/base/formula.h"
#include "shared/base/text.h"

namespace dobra::scenario {
namespace {

using base::Error;
using base::ErrorCode;

enum class Kinds { Length, Force, Stress };

struct Known {
  const char* name;
  Kinds kind;
  Ratio si;
};

// lbf: 0.45359237 kg times 9.80665 m/s2.
constexpr double pound = 44482216152605.0, tenths = 1e13;

constexpr Known known_units[] = {
    {"m", Kinds::Length, {}},
    {"mm", Kinds::Length, {1.0, 1e3}},
    {"cm", Kinds::Length, {1.0, 1e2}},
    {"km", Kinds::Length, {1e3, 1.0}},
    {"in", Kinds::Length, {254.0, 1e4}},
    {"ft", Kinds::Length, {3048.0, 1e4}},
    {"N", Kinds::Force, {}},
    {"kN", Kinds::Force, {1e3, 1.0}},
    {"MN", Kinds::Force, {1e6, 1.0}},
    {"lbf", Kinds::Force, {pound, tenths}},
    {"kip", Kinds::Force, {pound, 1e10}},
    {"Pa", Kinds::Stress, {}},
    {"kPa", Kinds::Stress, {1e3, 1.0}},
    {"MPa", Kinds::Stress, {1e6, 1.0}},
    {"GPa", Kinds::Stress, {1e9, 1.0}},
    {"psi", Kinds::Stress, {pound / 254.0 / 254.0, 1e5}},
    {"ksi", Kinds::Stress, {pound / 254.0 / 254.0, 1e2}},
    {"psf", Kinds::Stress, {pound / 3048.0 / 3048.0, 1e5}},
};

double value_of(const Ratio& ratio) { return ratio.above / ratio.below; }

bool cohere(const Known& length, const Known& force, const Known& stress) {
  const double made = value_of(force.si) / std::pow(value_of(length.si), 2.0);
  return std::abs(made / value_of(stress.si) - 1.0) < 1e-9;
}

/// What is written in SI as `si`: its powers of length and force, and how a system writes it, with L, F and S for its
/// units of length, force and stress.
struct Derived {
  const char* si;
  double length;
  double force;
  const char* pattern;
};

constexpr Derived derived_units[] = {
    {"m", 1.0, 0.0, "L"},
    {"m2", 2.0, 0.0, "L2"},
    {"m3", 3.0, 0.0, "L3"},
    {"N", 0.0, 1.0, "F"},
    {"Pa", -2.0, 1.0, "S"},
    {"N/m", -1.0, 1.0, "F/L"},
    {"N/m3", -3.0, 1.0, "F/L3"},
    {"J", 1.0, 1.0, "F L"},
    {"J/m2", -1.0, 1.0, "F/L"},
    {"Pa sqrt(m)", -1.5, 1.0, "S sqrt(L)"},
    {"J^0.5", 0.5, 0.5, "sqrt(F L)"},
};

const Derived* derived(std::string_view si) {
  const auto found =
      std::find_if(std::begin(derived_units), std::end(derived_units), [&](const Derived& d) { return si == d.si; });
  return found == std::end(derived_units) ? nullptr : found;
}

Ratio power(const Ratio& ratio, double exponent) {
  const Ratio up{std::pow(ratio.above, std::abs(exponent)), std::pow(ratio.below, std::abs(exponent))};
  return exponent < 0.0 ? up.inverse() : up;
}

/// A common divisor of both goes, as far as they are whole.
Ratio reduced(Ratio ratio) {
  const auto divides = [](double d, double n) { return std::fmod(n, d) == 0.0; };
  if (divides(ratio.below, ratio.above)) return {ratio.above / ratio.below, 1.0};
  if (divides(ratio.above, ratio.below)) return {1.0, ratio.below / ratio.above};
  return ratio;
}

std::string coherent_with(const std::array<const Known*, 3>& chosen) {
  std::vector<std::string> texts;
  const auto add = [&](const Known& l, const Known& f, const Known& s) {
    if (cohere(l, f, s)) texts.push_back(fmt::format("\"{}, {}, {}\"", l.name, f.name, s.name));
  };
  // Two of the three stay: the stress goes first, then the length, then the force.
  for (const Known& other : known_units) {
    if (other.kind == Kinds::Stress) add(*chosen[0], *chosen[1], other);
  }
  for (const Known& other : known_units) {
    if (other.kind == Kinds::Length) add(other, *chosen[1], *chosen[2]);
  }
  for (const Known& other : known_units) {
    if (other.kind == Kinds::Force) add(*chosen[0], other, *chosen[2]);
  }
  return fmt::format("{}", fmt::join(texts, " or "));
}

std::vector<std::string> words_of(const std::string& text, std::string_view between) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(between, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + between.size();
  }
  return words;
}

bool letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool digit(char c) { return c >= '0' && c <= '9'; }

std::string factor_text(const Ratio& ratio) {
  std::string text = ratio.above == 1.0 ? "" : fmt::format("*{}", base::number_text(ratio.above));
  if (ratio.below != 1.0) text += fmt::format("/{}", base::number_text(ratio.below));
  return text;
}

/// f(x, y) of coordinates and with a value in `units` as one of coordinates and with a value in SI. What cannot be read
/// stays as it is, for the one who reads it to tell.
std::string formula_in_si(const std::string& text, std::string_view si, bool of_space, const UnitSystem& units) {
  std::vector<std::string> names{"x", "y", "nx", "ny"};
  if (of_space) names.insert(names.end(), {"z", "u", "v"});
  if (text.empty() || !base::Formula::make(text, names)) return text;
  const std::string coordinate = factor_text(units.in_si("m").inverse());
  std::string made;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    if (letter(text[i])) {
      while (end < text.size() && (letter(text[end]) || digit(text[end]))) ++end;
    } else if (digit(text[i]) || text[i] == '.') {  // the e of 1e6 is no name
      while (end < text.size() &&
             (digit(text[end]) || text[end] == '.' || text[end] == 'e' || text[end] == 'E' ||
              ((text[end] == '-' || text[end] == '+') && (text[end - 1] == 'e' || text[end - 1] == 'E'))))
        ++end;
    } else {
      end = i + 1;
    }
    const std::string word = text.substr(i, end - i);
    made += word == "x" || word == "y" || word == "z" ? "(" + word + coordinate + ")" : word;
    i = end;
  }
  return "(" + made + ")" + factor_text(units.in_si(si));
}

struct Times {
  Ratio ratio;
  Value operator()(bool flag) const { return flag; }
  Value operator()(std::int64_t integer) const { return ratio.times(static_cast<double>(integer)); }
  Value operator()(double number) const { return ratio.times(number); }
  Value operator()(const std::string& text) const { return text; }
  Value operator()(geom::Point p) const { return geom::Point{ratio.times(p.x), ratio.times(p.y)}; }
  Value operator()(std::vector<double> list) const {
    for (double& number : list) number = ratio.times(number);
    return list;
  }
  Value operator()(const Points& points) const {
    std::vector<geom::Point> list = points.list();
    for (geom::Point& p : list) p = {ratio.times(p.x), ratio.times(p.y)};
    return Points(list);
  }
  Value operator()(std::vector<geom::Point3> points) const {
    for (geom::Point3& p : points) p = {ratio.times(p.x), ratio.times(p.y), ratio.times(p.z)};
    return points;
  }
  Value operator()(const std::vector<std::string>& list) const { return list; }
  Value operator()(const std::vector<Table>& list) const { return list; }
};

}  // namespace

base::Result<UnitSystem> UnitSystem::make(const std::string& text) {
  const auto bad = [&](const std::string& message) {
    return Error{ErrorCode::BadValue, fmt::format(" = \"{}\": {}", text, message)};
  };
  if (text == "SI") return UnitSystem();
  std::array<const Known*, 3> chosen{};
  std::vector<std::string> names;
  for (const Known& unit : known_units) names.emplace_back(unit.name);
  for (std::string word : words_of(text, ",")) {
    word.erase(0, std::min(word.find_first_not_of(' '), word.size()));
    word.erase(word.find_last_not_of(' ') + 1);
    const auto found = std::find_if(std::begin(known_units), std::end(known_units),
                                    [&](const Known& unit) { return word == unit.name; });
    if (found == std::end(known_units)) {
      std::string hint = base::did_you_mean(word, names);
      if (hint.empty()) hint = fmt::format("; known units: {}", fmt::join(names, ", "));
      return bad(fmt::format("'{}' is no unit of length, force or stress{}", word, hint));
    }
    const Known*& place = chosen[static_cast<std::size_t>(found->kind)];
    if (place != nullptr)
      return bad(fmt::format("{} and {} are of one kind; give one unit of length, one of force and one of stress",
                             place->name, word));
    place = found;
  }
  if (std::find(chosen.begin(), chosen.end(), nullptr) != chosen.end())
    return bad("give a unit of length, one of force and one of stress, such as \"mm, N, MPa\"");
  const auto& [length, force, stress] = chosen;
  if (!cohere(*length, *force, *stress))
    return bad(fmt::format("{} / {}2 is not {}, so the units do not cohere; give {}", force->name, length->name,
                           stress->name, coherent_with(chosen)));
  UnitSystem made;
  made.names_ = {length->name, force->name, stress->name};
  made.text_ = fmt::format("{}, {}, {}", length->name, force->name, stress->name);
  made.length_ = length->si;
  made.force_ = force->si;
  return made;
}

std::string UnitSystem::unit(std::string_view si) const {
  const Derived* known = derived(si);
  if (known == nullptr || this->si()) return std::string(si);
  std::string made;
  for (const char* c = known->pattern; *c != '\0'; ++c) {
    if (*c == 'L')
      made += names_[0];
    else if (*c == 'F')
      made += names_[1];
    else if (*c == 'S')
      made += names_[2];
    else
      made += *c;
  }
  return made;
}

std::string UnitSystem::si_of(std::string_view unit) const {
  const auto found = std::find_if(std::begin(derived_units), std::end(derived_units),
                                  [&](const Derived& d) { return this->unit(d.si) == unit; });
  return found == std::end(derived_units) ? std::string(unit) : found->si;
}

Ratio UnitSystem::in_si(std::string_view si) const {
  const Derived* known = derived(si);
  if (known == nullptr) return {};
  const Ratio length = power(length_, known->length), force = power(force_, known->force);
  return reduced({length.above * force.above, length.below * force.below});
}

std::string si_unit(const Field& field, const Table& table, const std::vector<Field>& fields) {
  const std::vector<std::string> cases = words_of(field.options.unit, ", ");
  for (std::size_t i = 1; i < cases.size(); ++i) {
    const std::vector<std::string> parts = words_of(cases[i], " if ");
    const std::vector<std::string> condition = words_of(parts.back(), " = ");
    const Value* value = table.find(condition.front());
    if (value == nullptr) {
      const auto other =
          std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.key == condition.front(); });
      if (other != fields.end() && other->default_value) value = &*other->default_value;
    }
    if (value != nullptr && *value == Value(condition.back())) return parts.front();
  }
  return cases.front();
}

Table in_si(const Table& table, const std::vector<Field>& fields, const UnitSystem& units) {
  if (units.si()) return table;
  Table made = table;
  for (const Field& field : fields) {
    const Value* value = table.find(field.key);
    if (value == nullptr) continue;
    if (const auto* rows = std::get_if<std::vector<Table>>(value)) {
      std::vector<Table> turned;
      for (const Table& row : *rows) turned.push_back(in_si(row, field.fields, units));
      made.set(field.key, std::move(turned));
      continue;
    }
    const std::string unit = si_unit(field, table, fields);
    if (derived(unit) == nullptr) continue;
    if (field.kind == Kind::Text)
      made.set(field.key, formula_in_si(std::get<std::string>(*value), unit, field.options.of_space, units));
    else
      made.set(field.key, std::visit(Times{units.in_si(unit)}, *value));
  }
  return made;
}

std::vector<Field> fields_in(std::vector<Field> fields, const UnitSystem& units) {
  if (units.si()) return fields;
  for (Field& field : fields) {
    field.fields = fields_in(std::move(field.fields), units);
    const std::vector<std::string> cases = words_of(field.options.unit, ", ");
    if (field.default_value && field.kind != Kind::Text && derived(cases.front()) != nullptr)
      field.default_value = std::visit(Times{units.in_si(cases.front()).inverse()}, *field.default_value);
    for (std::optional<double>* const limit : {&field.options.above, &field.options.at_least, &field.options.at_most}) {
      if (*limit && derived(cases.front()) != nullptr) **limit = units.in_si(cases.front()).inverse().times(**limit);
    }
    field.options.unit.clear();
    for (const std::string& one : cases) {
      const std::size_t end = std::min(one.find(" if "), one.size());
      field.options.unit += (field.options.unit.empty() ? "" : ", ") + units.unit(one.substr(0, end)) + one.substr(end);
    }
  }
  return fields;
}

}  // namespace dobra::scenario
