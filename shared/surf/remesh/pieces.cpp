// A mesh of several pieces, each meshed anew.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "shared/surf/remesh/estimate.h"
#include "shared/surf/remesh/one_sheet.h"
#include "shared/surf/remesh/slits.h"

namespace dobra::surf::remesh {

using base::Error;
using base::ErrorCode;
using base::Finding;
using base::Result;

namespace {

/// The sheet itself, as a mesh that was made of it.
Remeshed kept(const param::SheetMade& made) {
  Remeshed result;
  result.mesh.points = made.sheet.points;
  for (const auto& [a, b, c] : made.sheet.triangles)
    result.mesh.triangles.push_back({dobra::mesh::NodeId(a), dobra::mesh::NodeId(b), dobra::mesh::NodeId(c)});
  result.mesh.places.resize(result.mesh.triangles.size());
  result.mesh.faces.resize(result.mesh.triangles.size());
  result.mesh.regions.assign(result.mesh.triangles.size(), 0);
  result.area_before = area_of(made.sheet);
  tell_mended(made.mended, result.findings);
  return result;
}

/// Nodes and triangles of one behind those of the other.
void append(mesh::SurfaceMesh& to, const mesh::SurfaceMesh& more) {
  const std::size_t first = to.points.size();
  const auto moved = [first](dobra::mesh::NodeId node) { return dobra::mesh::NodeId(node.index() + first); };
  to.points.insert(to.points.end(), more.points.begin(), more.points.end());
  for (const auto& [a, b, c] : more.triangles) to.triangles.push_back({moved(a), moved(b), moved(c)});
  to.places.insert(to.places.end(), more.places.begin(), more.places.end());
  to.faces.insert(to.faces.end(), more.faces.begin(), more.faces.end());
  to.regions.insert(to.regions.end(), more.regions.begin(), more.regions.end());
  for (const auto& [name, edges] : more.constraint_sets) {
    for (const auto& [a, b] : edges) to.constraint_sets[name].push_back({moved(a), moved(b)});
  }
  for (const auto& [name, edges] : more.boundary_sets) {
    for (const auto& [a, b] : edges) to.boundary_sets[name].push_back({moved(a), moved(b)});
  }
}

/// A code that an earlier piece has told is counted only.
std::vector<Finding> gathered(const std::vector<std::vector<Finding>>& of_pieces) {
  std::vector<Finding> all;
  std::map<std::string, std::size_t> more;
  std::set<std::string> told;
  for (const auto& findings : of_pieces) {
    std::set<std::string> here;
    for (const Finding& finding : findings) {
      const bool first_here = here.insert(finding.code).second;
      if (!told.contains(finding.code))
        all.push_back(finding);
      else if (first_here)
        ++more[finding.code];
    }
    told.insert(here.begin(), here.end());
  }
  for (const auto& [code, times] : more) all.push_back({code, fmt::format("the like in {} more pieces", times), {}});
  return all;
}

/// @error TooManyElements: the size means more triangles than the limit
Result<void> not_too_many(const std::vector<param::SheetMade>& sheets, const RemeshOptions& options, double size) {
  Demand demand;
  for (const param::SheetMade& made : sheets) demand.add(made.sheet, options.crease);
  const double triangles = demand.triangles(size), most = static_cast<double>(options.most_triangles);
  if (triangles <= most) return {};
  constexpr double at_ease = 0.1;  // of the limit
  return Error{ErrorCode::TooManyElements,
               fmt::format("size {:.6g} means about {:.2g} triangles, and the limit is {}: give a greater one, such as "
                           "{:.6g}",
                           size, triangles, options.most_triangles, demand.size_for(at_ease * most)),
               place_of(sheets.front().sheet.points[0])};
}

}  // namespace

Result<Remeshed> remesh(const dobra::mesh::PolygonMesh& mesh, const RemeshOptions& options,
                        const base::Progress& progress) {
  const auto wrong = [](const char* text) { return Error{ErrorCode::InvalidOption, text}; };
  if (!(options.size >= 0.0) || !std::isfinite(options.size)) return wrong("size must be a positive length, or 0");
  if (!(options.chord >= 0.0) || !std::isfinite(options.chord)) return wrong("chord must be a positive length, or 0");
  DOBRA_TRY(const std::vector<param::SheetMade> sheets, param::sheets_of(mesh));
  double sides = 0.0, count = 0.0;
  for (const param::SheetMade& made : sheets) {
    sides += mean_side(made.sheet) * static_cast<double>(made.sheet.twins.size());
    count += static_cast<double>(made.sheet.twins.size());
  }
  const double size = options.size > 0.0 ? options.size : sides / count;
  DOBRA_TRY_VOID(not_too_many(sheets, options, size));
  const std::optional<Finding> slits = slits_of(sheets);
  if (sheets.size() == 1) {
    auto made = remesh_sheet(sheets.front(), options, size, Advice::Size, progress);
    if (made && slits) made->findings.insert(made->findings.begin(), *slits);
    return made;
  }
  Remeshed all;
  std::vector<std::vector<Finding>> findings{
      {{"pieces", fmt::format("the mesh has several pieces, each meshed by itself: {}", sheets.size()), {}}}};
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const double done = static_cast<double>(i), of = static_cast<double>(sheets.size());
    auto made = remesh_sheet(sheets[i], options, size, Advice::None, progress.part(done / of, (done + 1.0) / of));
    if (!made && made.error().code != ErrorCode::InvalidOption) return made;
    if (!made) {
      const Finding stays{"piece_kept",
                          fmt::format("a piece too small for the size stays as it came: {}", made.error().message),
                          made.error().place.value_or(base::Place{})};
      made = kept(sheets[i]);
      made->findings.push_back(stays);
    }
    append(all.mesh, made->mesh);
    all.deviation = std::max(all.deviation, made->deviation);
    all.flipped += made->flipped;
    all.creases += made->creases;
    all.cut_creases += made->cut_creases;
    all.narrow_creases += made->narrow_creases;
    all.short_creases += made->short_creases;
    all.folded += made->folded;
    all.area_before += made->area_before;
    all.rounds = std::max(all.rounds, made->rounds);
    findings.push_back(std::move(made->findings));
  }
  all.quality = mesh::quality_of(all.mesh);
  all.findings = gathered(findings);
  if (slits) all.findings.insert(all.findings.begin(), *slits);
  return all;
}

}  // namespace dobra::surf::remesh
