#include "quebra/core/curve_entries.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "quebra/core/input.h"
#include "quebra/sketch/roles_by_name.h"
#include "shared/scenario/entries.h"

namespace quebra::core {

namespace geom = dobra::geom;
namespace scenario = dobra::scenario;
using geom::Point;

namespace {

class InUnits {
 public:
  explicit InUnits(const scenario::UnitSystem& units) : units_(units) {}
  [[nodiscard]] double operator()(double si) const { return units_.si() ? si : units_.from_si(si, "m"); }
  [[nodiscard]] Point operator()(Point si) const { return {(*this)(si.x), (*this)(si.y)}; }
  [[nodiscard]] std::vector<Point> operator()(const std::vector<Point>& si) const {
    std::vector<Point> made;
    for (const Point p : si) made.push_back((*this)(p));
    return made;
  }

 private:
  const scenario::UnitSystem& units_;
};

void set_shape(scenario::Table& entry, const geom::Polyline& line, const InUnits& units) {
  if (line.closed) entry.set("kind", std::string("polygon"));
  entry.set("points", units(line.points));
}

void set_shape(scenario::Table& entry, const geom::Arc& arc, const InUnits& units) {
  const bool circle = arc.closed() && arc.start().radians() == 0.0;
  entry.set("kind", std::string(circle ? "circle" : "arc"));
  if (!circle) entry.set("points", units(std::vector<Point>{arc.from(), arc.to()}));
  entry.set("centre", units(arc.centre()));
  if (circle) entry.set("radius", units(arc.radius()));
  if (arc.sweep().radians() < 0.0) entry.set("turning", std::string("clockwise"));
}

void set_shape(scenario::Table& entry, const sketch::Smooth& smooth, const InUnits& units) {
  std::vector<Point> vertices;
  for (const geom::HermiteCubic& cubic : smooth.path().cubics()) {
    const geom::Bezier bezier = geom::bezier_of(cubic);
    if (!vertices.empty()) vertices.pop_back();
    vertices.insert(vertices.end(), bezier.vertices().begin(), bezier.vertices().end());
  }
  entry.set("kind", std::string("bezier"));
  entry.set("points", units(vertices));
}

/// Points of the file as [[input.point]], behind those of the document.
void take_points(scenario::Document& document, const model::Model& model, const InUnits& units) {
  scenario::Entries points = scenario::entries_of(document.input, "point");
  for (const sketch::NamedPoint& point : model.domain.points) {
    std::string name = point.name;
    for (int k = 1; name.empty(); ++k) {
      name = fmt::format("size {}", k);
      if (scenario::entry_named(points, name) != points.end()) name.clear();
    }
    if (!point.name.empty() && scenario::entry_named(points, name) != points.end()) continue;
    scenario::Table entry;
    entry.set("name", name);
    entry.set("point", units(point.at));
    if (point.size > 0.0) entry.set("size", units(point.size));
    points.push_back(std::move(entry));
  }
  scenario::set_entries(document.input, "point", std::move(points));
}

/// In the order of their tags, which so stay.
void take_regions(scenario::Document& document, const model::Model& model, const InUnits& units) {
  scenario::Entries own = scenario::entries_of(document.input, "region");
  scenario::Entries regions;
  for (const auto& [tag, name] : model.domain.region_names) {
    const auto before = regions.size();
    for (const scenario::Table& region : own) {
      if (scenario::text_in(region, "name") == name) regions.push_back(region);
    }
    if (regions.size() > before) continue;
    for (const domain::Face& face : model.domain.faces) {
      if (face.region != tag) continue;
      scenario::Table& entry = regions.emplace_back();
      entry.set("name", name);
      entry.set("point", units(face.inside));
    }
  }
  scenario::set_entries(document.input, "region", std::move(regions));
}

/// The keys that say how the file is read.
struct ReadingKeys : sketch::LineInput {
  template <class D>
  static void describe(D& d) {
    sketch::LineInput::describe_in<ReadingKeys>(d);
  }
};

}  // namespace

const char* table_of(const sketch::Curve& curve) { return curve.role == sketch::Role::Crack ? "crack" : "curve"; }

scenario::Table curve_entry(const sketch::Curve& curve, const scenario::UnitSystem& system) {
  const InUnits units(system);
  scenario::Table entry;
  entry.set("name", curve.name);
  std::visit([&](const auto& shape) { set_shape(entry, shape, units); }, curve.shape);
  if (curve.role == sketch::Role::Hole || curve.role == sketch::Role::Internal)
    entry.set("role", sketch::role_name(curve.role));
  if (curve.division.segments > 0) entry.set("segments", std::int64_t{curve.division.segments});
  if (curve.division.size > 0.0) entry.set("size", units(curve.division.size));
  if (curve.role == sketch::Role::Crack) {
    if (curve.tip_size > 0.0) entry.set("tip_size", units(curve.tip_size));
    return entry;
  }
  if (curve.division.ratio != 1.0) entry.set("ratio", curve.division.ratio);
  if (!curve.groups.empty()) entry.set("groups", curve.groups);
  return entry;
}

scenario::Document with_file_taken_in(scenario::Document document, const model::Model& model) {
  const bool mended = scenario::text_in(document.input, "repair") == "yes";
  for (const char* key : {"curve", "crack"}) {
    scenario::Entries own = scenario::entries_of(document.input, key);
    scenario::Entries all;
    for (const sketch::Curve& curve : model.domain.curves) {
      if (std::string_view(table_of(curve)) != key) continue;
      const auto written = scenario::entry_named(own, curve.name);
      all.push_back(written == own.end() || mended ? curve_entry(curve, document.units) : *written);
    }
    scenario::set_entries(document.input, key, std::move(all));
  }
  const InUnits units(document.units);
  take_points(document, model, units);
  take_regions(document, model, units);
  for (const scenario::Field& field : scenario::fields_of<ReadingKeys>()) document.input.erase(field.key);
  for (const char* key : {"file", "kind", "repair", "gap"}) {
    const bool of_repair = std::string_view(key) == "repair" || std::string_view(key) == "gap";
    if (!of_repair || mended) document.input.erase(key);
  }
  return document;
}

}  // namespace quebra::core
