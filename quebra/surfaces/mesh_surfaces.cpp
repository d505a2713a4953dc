#include "quebra/surfaces/mesh_surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

#include "quebra/surfaces/common_borders.h"
#include "quebra/surfaces/crossing_doubts.h"
#include "quebra/surfaces/expected_triangles.h"
#include "quebra/surfaces/face_engine.h"
#include "quebra/surfaces/mesh_doubts.h"
#include "quebra/surfaces/wanted_size.h"
#include "shared/surf/mesh/assemble.h"
#include "shared/surf/mesh/free_borders.h"
#include "shared/surf/trim/area.h"
#include "shared/surf/trim/mend.h"
#include "shared/surf/trim/open.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Result;
using surf::mesh::Division;
using surf::mesh::FaceMesh;
using surf::trim::TrimmedSurface;

namespace {

/// Seconds since the last call.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The place in the chart as the user writes it.
base::Error in_written(base::Error error, const model::SurfaceSet& set, std::size_t face) {
  if (!error.place) error.place = base::Place{};
  const geom::Vector units = set.chart_units[face];
  if (error.place->u && units.x != 0.0) *error.place->u /= units.x;
  if (error.place->v && units.y != 0.0) *error.place->v /= units.y;
  base::Place where = set.faces[face].place;
  if (where.item.empty() && !set.faces[face].name.empty())
    where.item = fmt::format("surface '{}'", set.faces[face].name);
  return base::located(std::move(error), where);
}

base::Error in_chart_of_face(base::Error error, const surf::trim::Opened& opened) {
  if (!opened.polar || !error.place || !error.place->u || !error.place->v) return error;
  const geom::Point place = opened.back({*error.place->u, *error.place->v});
  error.place->u = place.x, error.place->v = place.y;
  return error;
}

/// Of surfaces that a scenario draws. Faces of files are judged by their meshes: a normal may be nought on their
/// border.
Result<void> no_folds(const model::SurfaceSet& set) {
  for (std::size_t f = 0; f < set.faces.size(); ++f) {
    if (const auto fold = surf::trim::find_fold(set.faces[f])) return in_written(*fold, set, f);
  }
  return {};
}

/// The faces in charts without poles, and of which face each is.
struct Charts {
  std::vector<TrimmedSurface> faces;
  std::vector<surf::trim::Opened> opened;
  std::vector<std::size_t> owner;
};

Result<Charts> open_charts(const model::SurfaceSet& set) {
  surf::trim::SharedCurveId next = 1U << 20U;
  for (const TrimmedSurface& face : set.faces) {
    for (const auto& loop : face.loops) {
      for (const auto& edge : loop.edges) next = std::max(next, edge.shared.value_or(0) + 1);
    }
    for (const auto& line : face.lines) {
      for (const auto& edge : line.edges) next = std::max(next, edge.shared.value_or(0) + 1);
    }
  }
  surf::trim::SharedNumbers numbers(next);
  Charts charts;
  for (std::size_t f = 0; f < set.faces.size(); ++f) {
    auto opened = surf::trim::open(set.faces[f], numbers);
    if (!opened) return in_written(opened.error(), set, f);
    for (surf::trim::Opened& one : *opened) {
      charts.faces.push_back(one.face);
      charts.owner.push_back(f);
      charts.opened.push_back(std::move(one));
    }
  }
  return charts;
}

/// Places in the charts of the faces as they were given.
void give_back(const Charts& charts, model::SurfaceMeshed& meshed) {
  surf::mesh::SurfaceMesh& mesh = meshed.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t chart = mesh.faces[t];
    if (charts.opened[chart].polar) {
      for (geom::Point& place : mesh.places[t]) place = charts.opened[chart].back(place);
    }
    mesh.faces[t] = static_cast<std::uint32_t>(charts.owner[chart]);
  }
  surf::mesh::SurfaceElements& elements = meshed.elements;
  for (std::size_t e = 0; e < elements.faces.size(); ++e) {
    const std::uint32_t chart = elements.faces[e];
    if (charts.opened[chart].polar) {
      const std::size_t first = elements.mesh.first[e];
      for (std::size_t i = 0; i < mesh::node_count(elements.mesh.types[e]); ++i)
        elements.places[first + i] = charts.opened[chart].back(elements.places[first + i]);
    }
    elements.faces[e] = static_cast<std::uint32_t>(charts.owner[chart]);
  }
}

/// Reads the formula of sizes, and refuses sizes that are none or are too small.
Result<void> check_sizes(const model::SurfaceSet& set, const Charts& charts, SurfaceMeshOptions& options,
                         std::optional<WantedSize>& wanted, const base::Progress& progress) {
  const auto as_written = [&](const base::Error& error, std::size_t f) {
    return in_written(in_chart_of_face(error, charts.opened[f]), set, charts.owner[f]);
  };
  if (!options.size_formula.empty()) {
    const bool one = charts.faces.size() == 1 && !charts.opened[0].polar;
    DOBRA_TRY(wanted, WantedSize::make(options.size_formula, one ? std::optional(set.chart_units[0]) : std::nullopt));
    for (std::size_t f = 0; f < charts.faces.size(); ++f) {
      if (const auto sized = wanted->on_border(charts.faces[f]); !sized) return as_written(sized.error(), f);
    }
    options.sizes.wanted = wanted->function();
  }
  for (std::size_t f = 0; f < charts.faces.size(); ++f) {
    DOBRA_TRY_VOID(progress.check());
    if (wanted) wanted->enter(charts.faces[f]);
    const auto enough = not_too_many(charts.faces[f], options.sizes, options.most_triangles);
    if (!enough) return as_written(enough.error(), f);
  }
  return {};
}

}  // namespace

Result<model::SurfaceMeshed> mesh_surfaces(const model::SurfaceSet& set, const SurfaceMeshOptions& asked,
                                           const base::Progress& progress) {
  SurfaceMeshOptions options = asked;
  Stopwatch watch;
  model::SurfaceMeshed meshed;
  const auto done = [&](const char* phase) { meshed.seconds.push_back({phase, watch.lap()}); };
  if (!set.parts.empty()) {
    DOBRA_TRY_VOID(no_folds(set));
    DOBRA_TRY_VOID(check_ways(set.faces));
  }
  DOBRA_TRY(const Charts charts, open_charts(set));
  std::optional<WantedSize> wanted;
  DOBRA_TRY_VOID(check_sizes(set, charts, options, wanted, progress));
  std::vector<double> areas;
  std::vector<surf::mesh::Finding> unsure;
  for (const auto& face : set.faces) {
    const surf::Measured area = surf::trim::area(face);
    doubt_area(face, area, unsure);
    areas.push_back(area.value);
    meshed.area_surface += areas.back();
  }
  done("area");
  surf::mesh::DivisionOptions divide{.sizes = options.sizes};
  if (options.engine == SurfaceEngine::Paper) divide.kind = surf::mesh::DivisionKind::Halving;
  const auto division_made = surf::mesh::divide(charts.faces, divide, progress.part(0.0, 0.1));
  if (!division_made) return division_made.error();
  const Division& division = *division_made;
  meshed.findings = division.findings;
  meshed.findings.insert(meshed.findings.end(), unsure.begin(), unsure.end());
  done("divide");
  std::vector<FaceMesh> faces;
  for (std::size_t f = 0; f < division.faces.size(); ++f) {
    if (wanted) wanted->enter(charts.faces[f]);
    const double from = 0.1 + 0.8 * static_cast<double>(f) / static_cast<double>(division.faces.size());
    auto face = mesh_face(division.faces[f], options,
                          progress.part(from, from + 0.8 / static_cast<double>(division.faces.size())));
    const auto as_written = [&](const base::Error& error) {
      return in_written(in_chart_of_face(error, charts.opened[f]), set, charts.owner[f]);
    };
    if (wanted) {
      if (const auto sized = wanted->inside(); !sized) return as_written(sized.error());
    }
    if (!face) return as_written(face.error());
    faces.push_back(std::move(face->mesh));
    meshed.findings.insert(meshed.findings.end(), face->findings.begin(), face->findings.end());
  }
  done("fill");
  DOBRA_TRY(meshed.mesh, surf::mesh::assemble(charts.faces, division, faces));
  surf::mesh::free_borders(meshed.mesh, charts.faces, charts.owner, surf::trim::artificial_border);
  DOBRA_TRY_VOID(surf::mesh::check(meshed.mesh));
  done("assemble");
  meshed.quality = surf::mesh::quality_of(meshed.mesh);
  doubt_triangles(meshed, set, charts.owner, areas);
  doubt_crossings(meshed, set, charts.faces, charts.owner);
  doubt_details(meshed, charts.faces, options.sizes);
  meshed.elements = surf::mesh::elements_of(meshed.mesh);
  if (options.quadrilaterals) meshed.elements = surf::mesh::recombine(meshed.elements);
  if (options.second_order)
    meshed.elements = surf::mesh::to_second_order(meshed.elements, charts.faces, division.middles);
  DOBRA_TRY_VOID(surf::mesh::check(meshed.elements));
  doubt_elements(meshed, charts.faces);
  give_back(charts, meshed);
  done("elements");
  return meshed;
}

}  // namespace quebra::surfaces
