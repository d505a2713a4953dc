#include "quebra/core/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "quebra/core/curve_entries.h"
#include "shared/base/short_number.h"
#include "shared/base/text.h"
#include "shared/scenario/entries.h"

namespace quebra::core {

namespace geom = dobra::geom;
namespace scenario = dobra::scenario;
namespace scene = dobra::scene;
using dobra::base::Result;
using geom::Point;

namespace {

/// Numbers of the picture, which is in the units of the results, in those of the document.
class Lengths {
 public:
  explicit Lengths(const scenario::Document& document)
      : shown_(document.shown_units()), own_(document.units), same_(shown_.text() == own_.text()) {}

  [[nodiscard]] double in_document(double shown) const {
    return same_ ? shown : dobra::base::without_rounding(own_.from_si(shown_.to_si(shown, "m"), "m"));
  }
  [[nodiscard]] Point in_document(Point shown) const { return {in_document(shown.x), in_document(shown.y)}; }
  [[nodiscard]] Point in_picture(Point si) const { return {shown_.from_si(si.x, "m"), shown_.from_si(si.y, "m")}; }

 private:
  const scenario::UnitSystem& shown_;
  const scenario::UnitSystem& own_;
  bool same_;
};

/// The line in the document; a point that has not moved is the one that is written.
std::vector<Point> points_in_document(const geom::Polyline& line, const std::vector<Point>& written,
                                      const Lengths& lengths) {
  const double rounding = 1e-12 * geom::box_of(written).diagonal();
  std::vector<Point> points;
  const std::ptrdiff_t more = std::ssize(written) - std::ssize(line.points);
  for (const Point shown : line.points) {
    const Point p = lengths.in_document(shown);
    const auto is_it = [&](Point q) { return geom::distance(p, q) <= rounding; };
    // In its old place, counted from either end: most points of a line have not moved.
    std::optional<Point> same;
    for (const std::ptrdiff_t at : {std::ssize(points), std::ssize(points) + more}) {
      if (!same && at >= 0 && at < std::ssize(written) && is_it(written[static_cast<std::size_t>(at)]))
        same = written[static_cast<std::size_t>(at)];
    }
    if (!same) {
      const auto found = std::find_if(written.begin(), written.end(), is_it);
      if (found != written.end()) same = *found;
    }
    points.push_back(same.value_or(p));
  }
  return points;
}

void set_line(scenario::Table& entry, const geom::Polyline& line, const Lengths& lengths) {
  std::vector<Point> points = points_in_document(line, scenario::points_in(entry), lengths);
  const bool polygon = scenario::text_in(entry, "kind") == "polygon";
  if (polygon && !line.closed) entry.set("kind", std::string("line"));
  if (!polygon && line.closed) points.push_back(points.front());
  entry.set("points", std::move(points));
}

/// How far a line has been moved as a whole, if that is all.
std::optional<geom::Vector> moved_by(const geom::Polyline& before, const geom::Polyline& after) {
  if (before.points.size() != after.points.size() || before.closed != after.closed) return std::nullopt;
  const geom::Vector way = after.points.front() - before.points.front();
  const double rounding = 1e-9 * before.box().diagonal();
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    if (geom::length(after.points[i] - before.points[i] - way) > rounding) return std::nullopt;
  }
  return way;
}

/// Its points and its centre.
void move_entry(scenario::Table& entry, geom::Vector way) {
  std::vector<Point> points = scenario::points_in(entry);
  for (Point& p : points) p = p + way;
  if (!points.empty()) entry.set("points", std::move(points));
  const scenario::Value* centre = entry.find("centre");
  if (centre == nullptr) return;
  if (const auto* at = std::get_if<Point>(centre)) {
    entry.set("centre", *at + way);
  } else if (const auto* numbers = std::get_if<std::vector<double>>(centre);
             numbers != nullptr && numbers->size() == 2) {
    entry.set("centre", Point{(*numbers)[0], (*numbers)[1]} + way);
  }
}

Result<void> replace(scenario::Entries& entries, const sketch::Curve& curve, const std::vector<geom::Polyline>& becomes,
                     const Lengths& lengths) {
  const auto entry = scenario::entry_named(entries, curve.name);
  if (becomes.empty()) {
    entries.erase(entry);
    return {};
  }
  if (!std::holds_alternative<geom::Polyline>(curve.shape)) {
    geom::Polyline before = trace(curve).line;
    for (Point& p : before.points) p = lengths.in_picture(p);
    const auto way = becomes.size() == 1 ? moved_by(before, becomes.front()) : std::nullopt;
    if (!way)
      return scenario::edit_refused(curve.name,
                                    "arcs, circles and splines move as a whole here; change their shape in the form");
    move_entry(*entry, lengths.in_document(Point{} + *way) - Point{});
    return {};
  }
  const scenario::Table model = *entry;
  set_line(*entry, becomes.front(), lengths);
  auto at = static_cast<std::size_t>(entry - entries.begin());
  for (std::size_t k = 1; k < becomes.size(); ++k) {
    scenario::Table part = model;
    part.set("name", scenario::free_name(entries, curve.name));
    set_line(part, becomes[k], lengths);
    entries.insert(entries.begin() + static_cast<std::ptrdiff_t>(++at), std::move(part));
  }
  return {};
}

/// To ten digits of `size`: the tenth decimal of a mean of many points is rounding.
double rounded(double value, double size) {
  const double scale = std::pow(10.0, 9.0 - std::floor(std::log10(size)));
  return std::round(value * scale) / scale;
}

/// Centre and radius, if the line is what the circle tool draws.
std::optional<std::pair<Point, double>> circle_of(const geom::Polyline& line) {
  constexpr std::size_t least = 32;
  if (!line.closed || line.points.size() < least) return std::nullopt;
  geom::Vector sum{0.0, 0.0};
  for (const Point p : line.points) sum = sum + (p - Point{});
  const Point centre = Point{} + (1.0 / static_cast<double>(line.points.size())) * sum;
  const double radius = geom::distance(centre, line.points.front());
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const double side = line.segment(i).length();
    if (std::abs(geom::distance(centre, line.points[i]) - radius) > 1e-9 * radius) return std::nullopt;
    if (std::abs(side - line.segment(0).length()) > 1e-9 * radius) return std::nullopt;
  }
  return std::pair(centre, radius);
}

/// With what its file holds as tables of its own.
Result<scenario::Document> taken_in(scenario::Document document, const model::Model& model, const std::string& name) {
  const std::string specimen = scenario::text_in(document.input, "specimen");
  if (!specimen.empty() && specimen != "none")
    return scenario::edit_refused(name, "a specimen has it by its sizes; change these in the form");
  if (document.input.find("file") == nullptr)
    return scenario::edit_refused(name, "reading has made this; it cannot be edited by itself");
  return with_file_taken_in(std::move(document), model);
}

/// A named point or region: the entry of the document, moved or gone.
Result<scenario::Document> with_place_edited(scenario::Document document, const model::Model& model,
                                             const scene::LineEdit& edit, const Lengths& lengths) {
  const bool point = edit.pick.layer == "points";
  const char* key = point ? "point" : "region";
  const std::size_t count = point ? model.domain.points.size() : model.domain.regions.size();
  if (edit.pick.id >= count) return scenario::edit_refused(edit.pick.layer, "it is no longer there; run again");
  const std::string name = point ? model.domain.points[edit.pick.id].name : model.domain.regions[edit.pick.id].name;
  scenario::Entries entries = scenario::entries_of(document.input, key);
  // Regions may share a name: the document's own are the last ones.
  const std::size_t before = count - std::min(count, entries.size());
  auto entry =
      entries.begin() + static_cast<std::ptrdiff_t>(edit.pick.id - std::min<std::size_t>(edit.pick.id, before));
  if (edit.pick.id < before || entry == entries.end() || scenario::text_in(*entry, "name") != name)
    entry = scenario::entry_named(entries, name);
  if (entry == entries.end()) {
    DOBRA_TRY(document, taken_in(std::move(document), model, name));
    entries = scenario::entries_of(document.input, key);
    entry = scenario::entry_named(entries, name);
  }
  if (entry == entries.end())
    return scenario::edit_refused(name, "reading has made this; it cannot be edited by itself");
  if (edit.becomes.empty()) {
    entries.erase(entry);
  } else {
    entry->set("point", lengths.in_document(edit.becomes.front().points.front()));
  }
  scenario::set_entries(document.input, key, std::move(entries));
  return document;
}

bool is_taken(const scenario::Table& input, const std::string& name) {
  for (const char* key : {"curve", "crack"}) {
    scenario::Entries entries = scenario::entries_of(input, key);
    if (scenario::entry_named(entries, name) != entries.end()) return true;
  }
  return false;
}

}  // namespace

Result<scenario::Document> with_curves_edited(scenario::Document document, const model::Model& model,
                                              std::span<const scene::LineEdit> edits) {
  const std::vector<sketch::Curve>& curves = model.domain.curves;
  const Lengths lengths(document);
  for (const scene::LineEdit& edit : edits) {
    if (edit.pick.layer == "points" || edit.pick.layer == "regions") {
      DOBRA_TRY(document, with_place_edited(std::move(document), model, edit, lengths));
      continue;
    }
    const bool drawn = edit.pick.layer == "boundary" || edit.pick.layer == "internal" || edit.pick.layer == "cracks";
    if (!drawn || edit.pick.id >= curves.size())
      return scenario::edit_refused(
          edit.pick.layer,
          "this is drawn by the program and cannot be edited; edit curves, cracks, points and regions");
    const sketch::Curve& curve = curves[edit.pick.id];
    const char* key = curve.role == sketch::Role::Crack ? "crack" : "curve";
    scenario::Entries entries = scenario::entries_of(document.input, key);
    if (scenario::entry_named(entries, curve.name) == entries.end()) {
      DOBRA_TRY(document, taken_in(std::move(document), model, curve.name));
      entries = scenario::entries_of(document.input, key);
    }
    if (scenario::entry_named(entries, curve.name) == entries.end())
      return scenario::edit_refused(curve.name, "reading has made this; it cannot be edited by itself");
    DOBRA_TRY_VOID(replace(entries, curve, edit.becomes, lengths));
    scenario::set_entries(document.input, key, std::move(entries));
  }
  return document;
}

Result<scenario::Document> with_curve(scenario::Document document, const std::string& kind, const std::string& name,
                                      const geom::Polyline& line) {
  if (document.input.find("surface") != nullptr || scenario::text_in(document.input, "file").ends_with(".brep"))
    return scenario::edit_refused(
        name,
        "this document is of surfaces, whose lines are trims: draw cracks with the crack tool, others in the form");
  if (dobra::base::trimmed(name).empty()) return scenario::edit_refused(name, "give it a name");
  const bool places = kind == "point" || kind == "region";
  const std::string key = places || kind == "crack" ? kind : "curve";
  scenario::Entries entries = scenario::entries_of(document.input, key);
  if (places ? scenario::entry_named(entries, name) != entries.end() : is_taken(document.input, name))
    return scenario::edit_refused(name, "another one has this name already; give another name");
  const Lengths lengths(document);
  scenario::Table entry;
  entry.set("name", name);
  if (const auto circle = places ? std::nullopt : circle_of(line)) {
    entry.set("kind", std::string("circle"));
    const Point centre = lengths.in_document(circle->first);
    const double radius = lengths.in_document(circle->second);
    entry.set("centre", Point{rounded(centre.x, radius), rounded(centre.y, radius)});
    entry.set("radius", rounded(radius, radius));
  } else if (places) {
    entry.set("point", lengths.in_document(line.points.front()));
  } else {
    if (line.closed) entry.set("kind", std::string("polygon"));
    entry.set("points", points_in_document(line, {}, lengths));
  }
  if (kind == "hole" || kind == "internal") entry.set("role", kind);
  entries.push_back(std::move(entry));
  scenario::set_entries(document.input, key, std::move(entries));
  return document;
}

std::string name_of(const domain::Domain& domain, const scene::Pick& pick) {
  if (pick.layer == "points" && pick.id < domain.points.size()) return domain.points[pick.id].name;
  if (pick.layer == "regions" && pick.id < domain.regions.size()) return domain.regions[pick.id].name;
  const bool curve = pick.layer == "boundary" || pick.layer == "internal" || pick.layer == "cracks";
  return curve && pick.id < domain.curves.size() ? domain.curves[pick.id].name : std::string();
}

scenario::Drawing drawing() {
  using Of = scenario::Drawing::Kind::Of;
  return {
      .kinds = {{"outline", "Outline", Of::Polygons, "curve"},
                {"hole", "Hole", Of::Polygons, "curve"},
                {"crack", "Crack", Of::Lines, "curve"},
                {"internal", "Internal line", Of::Lines, "curve"},
                {"boundary", "Part of the boundary", Of::Lines, "curve"},
                {"point", "Point", Of::Points},
                {"region", "Region", Of::Points}},
      .height = "y",
      .edit =
          [](const scenario::Document& document, const scenario::State& input, std::span<const scene::LineEdit> edits) {
            return with_curves_edited(document, scenario::model_of<model::Model>(input), edits);
          },
      .add = [](const scenario::Document& document, const std::string& kind, const std::string& name,
                const geom::Polyline& line) { return with_curve(document, kind, name, line); },
      .unit_length =
          [](const scenario::Document& document) {
            return document.shown_units().from_si(document.units.to_si(1.0, "m"), "m");
          },
      .name_of = [](const scenario::State& input,
                    const scene::Pick& pick) { return name_of(scenario::model_of<model::Model>(input).domain, pick); }};
}

}  // namespace quebra::core
