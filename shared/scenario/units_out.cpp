// From SI to the units that a scenario is told its results in: quantities, tables, pictures, messages.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

#include "shared/base/text.h"
#include "shared/scenario/program.h"
#include "shared/scenario/units.h"

namespace dobra::scenario {
namespace {

/// "Pa" of "young [Pa]", and where it begins; nothing if there are no brackets.
struct Bracketed {
  std::string unit;
  std::size_t at = 0;
};

std::optional<Bracketed> bracketed(const std::string& title) {
  const std::size_t open = title.rfind('[');
  if (open == std::string::npos || title.back() != ']') return std::nullopt;
  return Bracketed{title.substr(open + 1, title.size() - open - 2), open + 1};
}

/// Changes the unit in the brackets of a title. @return how many of the new units one of the old ones is.
Ratio retitle(std::string& title, const UnitSystem& units) {
  const auto found = bracketed(title);
  if (!found) return {};
  title.replace(found->at, found->unit.size(), units.unit(found->unit));
  return units.in_si(found->unit).inverse();
}

class Turn {
 public:
  Turn(const Ratio& x, const Ratio& y, const UnitSystem& units) : x_(x), y_(y), units_(units) {}

  void operator()(geom::Point& p) const { p = {x_.times(p.x), y_.times(p.y)}; }
  void operator()(geom::Box& box) const {
    if (box.empty()) return;
    (*this)(box.low);
    (*this)(box.high);
  }
  void operator()(geom::Polyline& line) const { each(line.points); }
  void operator()(scene::Lines& content) const { each(content.lines.edit()); }
  void operator()(scene::Markers& content) const { each(content.points); }
  void operator()(scene::Regions& content) const {
    for (scene::Region& region : content.regions.edit()) each(region.contours);
  }
  void operator()(scene::Mesh& content) {
    each(content.points.edit());
    if (content.values_at == scene::ValuesAt::None) return;
    scene::Scale& scale = content.scale;
    values_ = retitle(scale.title, units_);
    const double shift = std::log10(values_.times(1.0));
    const auto turned = [&](double value) {
      return scale.ticks == scene::AxisScale::Log10 ? value + shift : values_.times(value);
    };
    for (double& value : content.values.edit()) value = turned(value);
    scale.low = turned(scale.low);
    scale.high = turned(scale.high);
    for (std::optional<double>* end : {&scale.least, &scale.greatest}) {
      if (*end) *end = turned(**end);
    }
  }
  void operator()(scene::Labels& content) const {
    for (scene::Label& label : content.labels) {
      (*this)(label.at);
      if (label.value) label.value = values_.times(*label.value);
    }
  }
  void operator()(scene::Image& content) const { (*this)(content.box); }

 private:
  template <class T>
  void each(std::vector<T>& all) const {
    for (T& one : all) (*this)(one);
  }
  Ratio x_, y_;
  const UnitSystem& units_;
  Ratio values_ = {};  ///< Of the colours, which labels above them have too.
};

/// The same of space; charts of surfaces have no unit.
class SpaceTurn {
 public:
  SpaceTurn(const Ratio& x, const Ratio& y, const Ratio& z, const UnitSystem& units)
      : x_(x), y_(y), z_(z), units_(units) {}

  void operator()(geom::Point3& p) const { p = {x_.times(p.x), y_.times(p.y), z_.times(p.z)}; }
  void operator()(scene::space::Lines& content) const {
    for (std::vector<geom::Point3>& line : content.lines.edit()) each(line);
  }
  void operator()(scene::space::Markers& content) const { each(content.points); }
  void operator()(scene::space::Surface& content) const {
    each(content.points.edit());
    if (content.values_at == scene::ValuesAt::None) return;
    scene::Mesh values;  // the unit of values does not ask where they are
    values.values_at = content.values_at;
    values.values = std::move(content.values);
    values.scale = std::move(content.scale);
    Turn(x_, y_, units_)(values);
    content.values = std::move(values.values);
    content.scale = std::move(values.scale);
  }
  void operator()(scene::space::Labels& content) const {
    for (scene::space::Label& label : content.labels) (*this)(label.at);
  }
  void operator()(scene::space::Curtain& content) const {
    for (geom::Point& p : content.trace) p = {x_.times(p.x), y_.times(p.y)};
    content.first = x_.times(content.first);
    Turn turn(x_, z_, units_);
    for (scene::Layer& layer : content.section.layers) std::visit(turn, layer.content);
  }

 private:
  void each(std::vector<geom::Point3>& all) const {
    for (geom::Point3& one : all) (*this)(one);
  }
  Ratio x_, y_, z_;
  const UnitSystem& units_;
};

bool begins_number(const std::string& text, std::size_t at) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto inside_word = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.';
  };
  if (at > 0 && inside_word(text[at - 1])) return false;
  return is_digit(text[at]) || (text[at] == '-' && at + 1 < text.size() && is_digit(text[at + 1]));
}

std::size_t end_of_number(const std::string& text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '.' ||
                               ((text[end] == '-' || text[end] == '+') && (end == at || text[end - 1] == 'e'))))
    ++end;
  while (end > at && text[end - 1] == '.') --end;
  return end;
}

/// The unit that stands at `at` behind a blank, the longest that is known; empty if none does.
std::string unit_behind(const std::string& text, std::size_t at) {
  if (at >= text.size() || text[at] != ' ') return {};
  for (const char* unit : {"Pa sqrt(m)", "J/m2", "N/m3", "N/m", "m2", "Pa", "m", "N", "J"}) {
    const std::string_view behind = std::string_view(text).substr(at + 1);
    if (!behind.starts_with(unit)) continue;
    const std::size_t end = std::string_view(unit).size();
    const bool whole =
        end == behind.size() || (std::isalnum(static_cast<unsigned char>(behind[end])) == 0 && behind[end] != '^');
    if (whole) return unit;
  }
  return {};
}

std::string number_in(const std::string& number, const std::string& unit, const UnitSystem& units) {
  const auto value = base::parse_number(number);
  return value && units.unit(unit) != unit ? fmt::format("{:.6g}", units.from_si(*value, unit)) : number;
}

/// "(x, y)" or "(x, y, z)" at `at`; nothing if no point begins there.
struct PointText {
  std::vector<std::string> numbers;
  std::size_t end = 0;  ///< Behind the bracket.
};

std::optional<PointText> point_at(const std::string& text, std::size_t at) {
  if (text[at] != '(' || at + 1 >= text.size() || !begins_number(text, at + 1)) return std::nullopt;
  PointText point;
  std::size_t begin = at + 1;
  for (;;) {
    const std::size_t end = end_of_number(text, begin);
    point.numbers.push_back(text.substr(begin, end - begin));
    if (end < text.size() && text[end] == ')' && point.numbers.size() >= 2) {
      point.end = end + 1;
      return point;
    }
    begin = end + 2;
    if (point.numbers.size() == 3 || text.compare(end, 2, ", ") != 0 || begin >= text.size() ||
        !begins_number(text, begin))
      return std::nullopt;
  }
}

}  // namespace

std::vector<Quantity> in_units(std::vector<Quantity> quantities, const UnitSystem& units) {
  if (units.si()) return quantities;
  for (Quantity& quantity : quantities) {
    quantity.value = units.from_si(quantity.value, quantity.unit);
    quantity.unit = units.unit(quantity.unit);
  }
  return quantities;
}

std::vector<DataTable> in_units(std::vector<DataTable> tables, const UnitSystem& units) {
  if (units.si()) return tables;
  for (DataTable& table : tables) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const Ratio ratio = retitle(table.columns[i], units);
      for (auto& row : table.rows) {
        if (auto* number = std::get_if<double>(&row[i])) *number = ratio.times(*number);
      }
    }
  }
  return tables;
}

scene::space::SpacePicture in_units(scene::space::SpacePicture picture, const UnitSystem& units) {
  if (units.si()) return picture;
  const Ratio x = retitle(picture.axes.x_title, units);
  const Ratio y = retitle(picture.axes.y_title, units);
  const Ratio z = retitle(picture.axes.z_title, units);
  const SpaceTurn turn(x, y, z, units);
  for (scene::space::Layer& layer : picture.layers) std::visit(turn, layer.content);
  if (picture.camera.target) turn(*picture.camera.target);
  if (picture.extent) turn(picture.extent->low), turn(picture.extent->high);
  picture.camera.distance = x.times(picture.camera.distance);
  return picture;
}

scene::Picture in_units(scene::Picture picture, const UnitSystem& units) {
  if (units.si()) return picture;
  for (scene::Panel& panel : picture.panels) {
    const Ratio x = retitle(panel.axes.x_title, units);
    const Ratio y = retitle(panel.axes.y_title, units);
    Turn turn(x, y, units);
    for (scene::Layer& layer : panel.layers) std::visit(turn, layer.content);
    if (panel.extent) turn(*panel.extent);
    // What is read stays; the lengths below it are others.
    if (panel.axes.x_reading) panel.axes.x_reading->per_unit = x.inverse().times(panel.axes.x_reading->per_unit);
    if (panel.axes.y_reading) panel.axes.y_reading->per_unit = y.inverse().times(panel.axes.y_reading->per_unit);
    if (picture.points_per_unit && &panel == &picture.panels.front())
      picture.points_per_unit = x.inverse().times(*picture.points_per_unit);
  }
  return picture;
}

std::string message_in_units(const std::string& message, const UnitSystem& units) {
  if (units.si()) return message;
  std::string made;
  bool quoted = false;
  for (std::size_t i = 0; i < message.size();) {
    if (message[i] == '\'') {
      // An apostrophe inside a word begins no quotation.
      const bool within = !quoted && i > 0 && std::isalnum(static_cast<unsigned char>(message[i - 1])) != 0;
      if (!within) quoted = !quoted;
    }
    if (!quoted) {
      if (const auto point = point_at(message, i)) {
        const std::string unit = unit_behind(message, point->end);
        const std::string of = unit.empty() ? "m" : unit;
        std::vector<std::string> numbers = point->numbers;
        for (std::string& number : numbers) number = number_in(number, of, units);
        made += fmt::format("({})", fmt::join(numbers, ", "));
        if (!unit.empty()) made += " " + units.unit(unit);
        i = point->end + (unit.empty() ? 0 : unit.size() + 1);
        continue;
      }
      if (begins_number(message, i)) {
        const std::size_t end = end_of_number(message, i);
        const std::string unit = unit_behind(message, end);
        const std::string number = message.substr(i, end - i);
        made += unit.empty() ? number : number_in(number, unit, units) + " " + units.unit(unit);
        i = end + (unit.empty() ? 0 : unit.size() + 1);
        continue;
      }
    }
    made += message[i++];
  }
  return made;
}

base::Error in_units(base::Error error, const UnitSystem& units) {
  if (units.si()) return error;
  error.message = message_in_units(error.message, units);
  if (error.place) {
    for (std::optional<double>* at : {&error.place->x, &error.place->y, &error.place->z}) {
      if (*at) *at = units.from_si(**at, "m");
    }
  }
  return error;
}

}  // namespace dobra::scenario
