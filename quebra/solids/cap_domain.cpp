#include "quebra/solids/cap_domain.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "quebra/sketch/enclosed.h"

namespace quebra::solids {
namespace {

using namespace dobra;

/// What the faces that were cut in one line are called together.
std::string name_of(const std::vector<std::string>& names, const std::string& fallback) {
  std::vector<std::string> given;
  std::copy_if(names.begin(), names.end(), std::back_inserter(given), [](const auto& name) { return !name.empty(); });
  return given.empty() ? fallback : fmt::format("{}", fmt::join(given, "+"));
}

/// Names that no two curves have.
std::vector<std::string> unique_names(const std::vector<std::string>& stems) {
  std::map<std::string, std::size_t> count;
  for (const std::string& stem : stems) ++count[stem];
  std::set<std::string> taken;
  for (const auto& [stem, times] : count) {
    if (times == 1) taken.insert(stem);
  }
  std::map<std::string, std::size_t> used;
  std::vector<std::string> names;
  for (const std::string& stem : stems) {
    std::string name = stem;
    while (count[stem] > 1 && !taken.insert(name = fmt::format("{}_{}", stem, ++used[stem])).second) {
    }
    names.push_back(std::move(name));
  }
  return names;
}

std::string text_of(geom::Vector3 v) { return fmt::format("({}, {}, {})", v.x + 0.0, v.y + 0.0, v.z + 0.0); }

}  // namespace

sketch::Sketch sketch_of(const solid::Cap& cap, std::span<const std::string> materials, const std::string& fallback) {
  sketch::Sketch sketch;
  std::vector<std::string> stems;
  for (const solid::CapLine& line : cap.lines) stems.push_back(name_of(line.names, fallback));
  const std::vector<std::string> names = unique_names(stems);
  for (std::size_t i = 0; i < cap.lines.size(); ++i) {
    const solid::CapLine& line = cap.lines[i];
    sketch::Curve curve;
    curve.name = names[i];
    curve.role = line.right == solid::outside ? sketch::Role::Boundary : sketch::Role::Internal;
    curve.shape = line.line;
    if (names[i] != stems[i]) curve.groups.push_back(stems[i]);
    for (const std::string& name : line.names) {
      if (!name.empty() && name != stems[i]) curve.groups.push_back(name);
    }
    sketch.curves.push_back(std::move(curve));
    sketch.places.emplace_back();
  }
  for (const solid::CapRegion& region : cap.regions)
    sketch.regions.push_back({materials[region.solid], sketch::inner_point(region.sides)});
  return sketch;
}

std::string message(const solid::SectionOverlap& overlap, std::span<const std::string> materials) {
  const std::string& first = materials[overlap.first];
  const std::string& second = materials[overlap.second];
  return fmt::format(
      "'{}' and '{}' overlap in the section, over {:.6g} m2: it shows '{}' there, which comes first, and "
      "'{}' is lost; subtract one from the other",
      first, second, overlap.area, first, second);
}

scenario::Document document_of(const sketch::Sketch& sketch, const solid::CutPlane& plane,
                               const solid::SectionFrame& frame) {
  scenario::Document document;
  document.program = "quebra";
  document.title = fmt::format("Section {} x + {} y + {} z + {} = 0", plane.a, plane.b, plane.c, plane.d);
  document.comment = fmt::format("A point (x, y) of this plane is in space\n{} + x {} + y {}",
                                 text_of(frame.origin - geom::Point3{}), text_of(frame.along), text_of(frame.up));
  std::vector<scenario::Table> curves;
  for (const sketch::Curve& curve : sketch.curves) {
    const auto& line = std::get<geom::Polyline>(curve.shape);
    scenario::Table table;
    table.set("name", curve.name);
    table.set("kind", std::string(line.closed ? "polygon" : "line"));
    if (curve.role == sketch::Role::Internal) table.set("role", std::string("internal"));
    if (!curve.groups.empty()) table.set("groups", curve.groups);
    table.set("points", line.points);
    curves.push_back(std::move(table));
  }
  std::vector<scenario::Table> regions;
  for (const sketch::RegionName& region : sketch.regions) {
    scenario::Table table;
    table.set("name", region.name);
    table.set("point", region.at);
    regions.push_back(std::move(table));
  }
  document.input.set("curve", std::move(curves));
  document.input.set("region", std::move(regions));
  return document;
}

}  // namespace quebra::solids
