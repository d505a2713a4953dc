#include "shared/surf/remesh/flatten.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace dobra::surf::remesh {

using base::Error;
using base::ErrorCode;
using base::Finding;
using base::Result;
using geom::Point3;
using param::Sheet;

namespace {

Result<void> lay_flat_cut(Charted& charted, const param::ParametriseOptions& options, double crease) {
  charted.opened = param::open(charted.before, {.crease = crease});
  if (charted.opened.sides > 0) {
    charted.findings.push_back(
        {"cut",
         fmt::format(
             "the mesh is no disk (borders: {}, handles: {}), so it was cut open (sides of the cut: {}, its length: "
             "{:.6g})",
             charted.before.loops.size(), charted.before.genus(), charted.opened.sides, charted.opened.length),
         {}});
  }
  if (!charted.opened.sheet.disk() || charted.opened.sheet.loops[0].size() < 3) {
    return Error{ErrorCode::BadMesh, "the mesh has too few triangles to be cut open",
                 place_of(charted.before.points[0])};
  }
  DOBRA_TRY(charted.parametrisation, param::parametrise(charted.opened.sheet, options));
  return {};
}

/// Holes are filled, so that there is a disk, and the filling is forgotten.
Result<void> lay_flat_with_holes(Charted& charted, const param::ParametriseOptions& options) {
  const Sheet whole = param::filled(charted.before);
  DOBRA_TRY(charted.parametrisation, param::parametrise(whole, options));
  charted.opened.sheet = charted.before;
  charted.opened.origin.resize(charted.before.points.size());
  std::iota(charted.opened.origin.begin(), charted.opened.origin.end(), 0U);
  charted.opened.across.assign(charted.before.twins.size(), param::no_half_edge);
  charted.parametrisation.uv.resize(charted.before.points.size());
  std::erase_if(charted.parametrisation.flipped, [&](std::uint32_t t) { return t >= charted.before.triangles.size(); });
  charted.findings.push_back({"holes",
                              fmt::format("borders that stay holes in the chart, so that the mesh was not cut open: {}",
                                          charted.before.loops.size() - 1),
                              {}});
  return {};
}

}  // namespace

void tell_mended(const param::Mended& mended, std::vector<Finding>& findings) {
  const auto tell = [&](std::size_t count, const char* text) {
    if (count > 0) findings.push_back({"mended", fmt::format(fmt::runtime(text), count), {}});
  };
  tell(mended.merged, "points joined with another one at their place: {}");
  tell(mended.unused, "points of no face, left out: {}");
  tell(mended.dropped, "triangles left out that are doubled or have two corners only: {}");
  tell(mended.flipped, "triangles without area, mended: {}");
  tell(mended.turned, "triangles turned the way of most others: {}");
  if (mended.parted == 0) return;
  constexpr std::size_t most = 5;
  const auto& places = mended.parted_at;
  findings.push_back({"mended",
                      fmt::format("copies made of points in which parts of the mesh meet: {}; the first of the points "
                                  "is here",
                                  mended.parted),
                      place_of(places[0])});
  for (std::size_t i = 1; i < std::min(most, places.size()); ++i)
    findings.push_back({"mended", "parts of the mesh meet in this point too", place_of(places[i])});
  if (places.size() > most)
    findings.push_back({"mended", fmt::format("further points in which parts meet: {}", places.size() - most), {}});
}

base::Place place_of(Point3 p) { return {.x = p.x, .y = p.y, .z = p.z}; }

Point3 centre(const Sheet& sheet, std::uint32_t triangle) {
  const auto& [a, b, c] = sheet.triangles[triangle];
  const Point3 p = sheet.points[a];
  return p + (1.0 / 3.0) * ((sheet.points[b] - p) + (sheet.points[c] - p));
}

double mean_side(const Sheet& sheet) {
  double sum = 0.0;
  for (param::HalfEdge h = 0; h < sheet.twins.size(); ++h)
    sum += geom::distance(sheet.points[sheet.start(h)], sheet.points[sheet.end(h)]);
  return sum / static_cast<double>(sheet.twins.size());
}

double area_of(const Sheet& sheet) {
  double sum = 0.0;
  for (const auto& [a, b, c] : sheet.triangles)
    sum += 0.5 * geom::length(cross(sheet.points[b] - sheet.points[a], sheet.points[c] - sheet.points[a]));
  return sum;
}

bool keeps_holes(const Sheet& sheet) { return sheet.loops.size() > 1 && sheet.genus() == 0; }

bool has_many_holes(const Sheet& sheet) {
  constexpr std::size_t many = 4;
  constexpr double small = 0.5;  // of the longest border
  if (!keeps_holes(sheet) || sheet.loops.size() <= many) return false;
  const std::size_t longest = param::longest_loop(sheet);
  const double most = small * param::loop_length(sheet, sheet.loops[longest]);
  for (std::size_t i = 0; i < sheet.loops.size(); ++i) {
    if (i != longest && param::loop_length(sheet, sheet.loops[i]) > most) return false;
  }
  return true;
}

Result<Charted> chart_sheet(const param::SheetMade& made, const param::ParametriseOptions& options, Holes holes,
                            double crease) {
  Charted charted{made.sheet, {}, {}, {}};
  tell_mended(made.mended, charted.findings);
  if (holes == Holes::Stay && keeps_holes(charted.before)) {
    DOBRA_TRY_VOID(lay_flat_with_holes(charted, options));
  } else {
    DOBRA_TRY_VOID(lay_flat_cut(charted, options, crease));
  }
  const param::Parametrisation& chart = charted.parametrisation;
  if (!chart.why_circle.empty())
    charted.findings.push_back(
        {"circle",
         fmt::format("the border of the chart lies on a circle, not between corners: {}", chart.why_circle),
         {}});
  if (!chart.flipped.empty()) {
    const auto& sheet = charted.opened.sheet;
    charted.findings.push_back({"flipped", fmt::format("triangles flipped in the chart: {}", chart.flipped.size()),
                                place_of(centre(sheet, chart.flipped[0]))});
  }
  return charted;
}

Result<Charted> chart_mesh(const dobra::mesh::PolygonMesh& mesh, const param::ParametriseOptions& options,
                           Holes holes) {
  DOBRA_TRY(const param::SheetMade made, param::sheet_of(mesh));
  return chart_sheet(made, options, holes, 180.0);
}

}  // namespace dobra::surf::remesh
