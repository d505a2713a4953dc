#include "quebra/core/surface_edits.h"

#include <algorithm>
#include <cmath>

#include "shared/base/short_number.h"
#include "shared/base/text.h"
#include "shared/scenario/entries.h"

namespace quebra::core {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using base::translated;
using geom::Point;
using geom::Point3;

namespace {

/// Beyond a closed direction, the same place within the chart.
Point folded(const surf::Surface& surface, Point uv) {
  const geom::Box& box = surface.chart();
  const auto fold = [](double value, double low, double range) {
    return value - range * std::floor((value - low) / range);
  };
  if (surface.closed_u()) uv.x = fold(uv.x, box.low.x, box.width());
  if (surface.closed_v()) uv.y = fold(uv.y, box.low.y, box.height());
  return uv;
}

/// To `digits` digits of a range.
double rounded(double value, double range, int digits) {
  const double scale = std::pow(10.0, digits - std::floor(std::log10(range)));
  return std::round(value * scale) / scale;
}

/// A place of the part as the user would write it.
Point written_place(const model::SurfaceSet& set, std::size_t face, Point uv, std::size_t part) {
  const surf::Surface& surface = set.faces[face].surface;
  const geom::Vector unit = set.chart_units[face];
  const geom::Box& box = surface.chart();
  const Point own{uv.x / unit.x, uv.y / unit.y};
  for (int digits = 2; digits < 9; ++digits) {
    const Point short_one{rounded(own.x, box.width() / unit.x, digits), rounded(own.y, box.height() / unit.y, digits)};
    const Point back{short_one.x * unit.x, short_one.y * unit.y};
    if (back.x < box.low.x || back.x > box.high.x || back.y < box.low.y || back.y > box.high.y) continue;
    const auto picked = set.parts[face].recognised->pick(back);
    if (picked && *picked == part) return short_one;
  }
  return own;
}

bool contains(const std::vector<std::size_t>& all, std::size_t one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

/// Which of the document's parts lie in one part of a face, or anywhere in the face.
struct Named {
  std::vector<std::size_t> keeps, drops;
  bool others_keep = false;
};
Named named(const model::SurfaceSet& set, std::size_t face, std::size_t part) {
  Named found;
  for (std::size_t i = 0; i < set.chosen.size(); ++i) {
    if (set.chosen[i].face != face) continue;
    const auto at = set.parts[face].recognised->pick(set.chosen[i].at);
    const bool here = at && *at == part;
    if (here) (set.chosen[i].keeps ? found.keeps : found.drops).push_back(i);
    found.others_keep = found.others_keep || (!here && set.chosen[i].keeps);
  }
  return found;
}

}  // namespace

Result<PartEdit> with_part_turned(scenario::Document document, const model::SurfaceSet& set, std::size_t face,
                                  Point uv) {
  if (face >= set.parts.size() || !set.parts[face].recognised)
    return Error{ErrorCode::NotSupported,
                 translated("faces of a file are meshed whole; parts are of surfaces that a scenario describes")};
  const model::SurfaceParts& parts = set.parts[face];
  uv = folded(set.faces[face].surface, uv);
  const auto part = parts.recognised->pick(uv);
  if (!part) return Error{ErrorCode::BadDomain, translated("click inside a part, away from the lines that bound it")};
  const bool is_in = contains(parts.in, *part);
  if (!is_in && !contains(parts.left_out, *part))
    return Error{ErrorCode::BadDomain, translated("this is a hole, or lies outside the outlines; their trims say so")};
  if (is_in && parts.in.size() == 1)
    return Error{ErrorCode::BadDomain, translated("this is the only part that is left; take another one in first")};

  scenario::Entries entries = scenario::entries_of(document.input, "part");
  const Named here = named(set, face, *part);
  const std::vector<std::size_t>& obsolete = is_in ? here.keeps : here.drops;
  for (auto i = obsolete.rbegin(); i != obsolete.rend(); ++i) {
    if (*i < entries.size()) entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(*i));
  }
  // What others say may be enough: a part is out where only others are kept, and in where nothing is.
  const bool needs_one = is_in ? !here.others_keep : here.others_keep && here.keeps.empty();
  if (needs_one) {
    scenario::Table entry;
    if (set.faces.size() > 1) entry.set("surface", parts.surface);
    if (is_in) entry.set("fate", std::string("drop"));
    entry.set("at", written_place(set, face, uv, *part));
    entries.push_back(std::move(entry));
  }
  scenario::set_entries(document.input, "part", std::move(entries));
  return PartEdit{std::move(document), !is_in};
}

Result<scenario::Document> with_crack_on(scenario::Document document, const model::SurfaceSet& set, std::size_t face,
                                         const std::string& name, std::span<const ChartPoint> line) {
  if (face >= set.parts.size())
    return Error{
        ErrorCode::NotSupported,
        translated("faces of a file are meshed as they are; cracks are of surfaces that a scenario describes")};
  const geom::Box& box = set.faces[face].surface.chart();
  const geom::Vector unit = set.chart_units[face];
  const auto written = [](double value, double low, double high, bool exact) {
    const double short_one = rounded(value, high - low, 4);
    if (value <= low || value >= high) return base::without_rounding(std::clamp(value, low, high));
    return exact || short_one <= low || short_one >= high ? base::without_rounding(value) : short_one;
  };
  std::vector<Point> points;
  for (const ChartPoint& each : line)
    points.push_back({written(each.uv.x / unit.x, box.low.x / unit.x, box.high.x / unit.x, each.exact),
                      written(each.uv.y / unit.y, box.low.y / unit.y, box.high.y / unit.y, each.exact)});
  scenario::Table entry;
  entry.set("name", name);
  if (set.faces.size() > 1) entry.set("surface", set.parts[face].surface);
  entry.set("role", std::string("crack"));
  entry.set("points", std::move(points));
  scenario::Entries entries = scenario::entries_of(document.input, "trim");
  entries.push_back(std::move(entry));
  scenario::set_entries(document.input, "trim", std::move(entries));
  return document;
}

Result<scenario::Document> with_control_moved(scenario::Document document, const model::SurfaceSet& set,
                                              std::size_t control, Point3 to) {
  const auto in_document = [&](double shown) {
    if (document.shown_units().text() == document.units.text()) return shown;
    return base::without_rounding(document.units.from_si(document.shown_units().to_si(shown, "m"), "m"));
  };
  const Point3 written{in_document(to.x), in_document(to.y), in_document(to.z)};
  for (const model::ControlPoint& each : set.controls) {
    if (each.at != set.controls[control].at) continue;
    scenario::Entries entries = scenario::entries_of(document.input, each.table);
    const auto* known = each.entry < entries.size() ? entries[each.entry].find("points") : nullptr;
    const auto* points = known != nullptr ? std::get_if<std::vector<Point3>>(known) : nullptr;
    if (points == nullptr || each.point >= points->size())
      return scenario::edit_refused(each.name, "it has no such point any more");
    std::vector<Point3> moved = *points;
    moved[each.point] = written;
    entries[each.entry].set("points", std::move(moved));
    scenario::set_entries(document.input, each.table, std::move(entries));
  }
  return document;
}

}  // namespace quebra::core
