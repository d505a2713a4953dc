#include "quebra/core/input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <set>

#include "quebra/core/surface_start.h"
#include "quebra/repair/crack_flaws.h"
#include "quebra/repair/flaws.h"
#include "quebra/repair/repair.h"
#include "quebra/sketch/roles_by_name.h"
#include "quebra/sketch/sketch_file.h"
#include "quebra/solids/parts.h"
#include "quebra/surfaces/finding_text.h"
#include "shared/geom/drawn_curve.h"
#include "shared/io/faces/import.h"

namespace quebra::core {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::geom::Arc;
using dobra::geom::Orientation;
using dobra::geom::Point;
using dobra::geom::Polyline;

Error lacking(const CurveParams& params, const char* what) {
  return {ErrorCode::BadValue, fmt::format("curve '{}' {}", params.name, what)};
}

Result<sketch::Curve> make_spline(const CurveParams& params) {
  if (params.points.size() < 2) return lacking(params, "needs two `points` or more");
  DOBRA_TRY(dobra::geom::CubicPath path, dobra::geom::spline_through(params.points));
  DOBRA_TRY(sketch::Smooth smooth, sketch::Smooth::make(std::move(path)));
  return sketch::Curve{params.name, params.role, std::move(smooth), {}};
}

/// Vertices of cubics end to end: the last of one is the first of the next.
Result<sketch::Curve> make_bezier(const CurveParams& params) {
  if (params.points.size() < 4 || params.points.size() % 3 != 1)
    return lacking(params, "is a chain of cubics: give it 4 `points`, or 3 more for every further cubic");
  std::vector<dobra::geom::HermiteCubic> cubics;
  for (std::size_t i = 0; i + 3 < params.points.size(); i += 3) {
    DOBRA_TRY(const dobra::geom::Bezier cubic,
              dobra::geom::Bezier::make(
                  {params.points.begin() + std::ptrdiff_t(i), params.points.begin() + std::ptrdiff_t(i + 4)}));
    cubics.push_back(dobra::geom::hermite_of(cubic));
  }
  std::vector<double> knots;
  for (std::size_t k = 0; k <= cubics.size(); ++k) knots.push_back(static_cast<double>(k));
  DOBRA_TRY(sketch::Smooth smooth, sketch::Smooth::make(dobra::geom::CubicPath(std::move(cubics), std::move(knots))));
  return sketch::Curve{params.name, params.role, std::move(smooth), {}};
}

Result<sketch::Curve> make_line(const CurveParams& params) {
  Polyline line{params.points, params.kind == CurveKind::Polygon};
  line = without_repeated_points(std::move(line));
  DOBRA_TRY_VOID(validate(line));
  if (!line.closed && line.points.size() > 3 && line.points.front() == line.points.back()) {
    line.closed = true;
    line.points.pop_back();
  }
  return sketch::Curve{params.name, params.role, std::move(line), {}};
}

Result<sketch::Curve> make_arc(const CurveParams& params) {
  if (!params.centre) return lacking(params, "needs `centre`");
  if (params.points.size() == 2) {
    const auto orientation =
        params.turning == Turning::Anticlockwise ? Orientation::Anticlockwise : Orientation::Clockwise;
    DOBRA_TRY(Arc arc, Arc::from_ends(*params.centre, params.points[0], params.points[1], orientation, 1e-6));
    return sketch::Curve{params.name, params.role, std::move(arc), {}};
  }
  if (!params.points.empty()) return lacking(params, "is an arc: give its first and last point, two in all");
  if (!params.radius || !params.start || !params.sweep) {
    return lacking(params, "needs two `points`, or `radius`, `start` and `sweep`");
  }
  DOBRA_TRY(Arc arc, Arc::from_angles(*params.centre, *params.radius, *params.start, *params.sweep));
  return sketch::Curve{params.name, params.role, std::move(arc), {}};
}

Result<sketch::Curve> make_circle(const CurveParams& params) {
  if (!params.centre) return lacking(params, "needs `centre`");
  if (!params.radius) return lacking(params, "needs `radius`");
  const auto orientation =
      params.turning == Turning::Anticlockwise ? Orientation::Anticlockwise : Orientation::Clockwise;
  DOBRA_TRY(Arc arc, Arc::circle(*params.centre, *params.radius, orientation));
  return sketch::Curve{params.name, params.role, std::move(arc), {}};
}

Result<sketch::Curve> make_curve(const CurveParams& params) {
  const auto made = [&]() -> Result<sketch::Curve> {
    switch (params.kind) {
      case CurveKind::Arc:
        return make_arc(params);
      case CurveKind::Circle:
        return make_circle(params);
      case CurveKind::Spline:
        return make_spline(params);
      case CurveKind::Bezier:
        return make_bezier(params);
      case CurveKind::Line:
      case CurveKind::Polygon:
        break;
    }
    return make_line(params);
  };
  DOBRA_TRY(sketch::Curve curve, made());
  curve.division = {params.segments, params.size, params.ratio};
  curve.groups = params.groups;
  return curve;
}

Result<void> check_names(const std::vector<sketch::Curve>& curves, const std::vector<Place>& places) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (!names.insert(curves[i].name).second) {
      return Error{ErrorCode::BadValue, fmt::format("two curves are called '{}'; names must differ", curves[i].name),
                   places[i]};
    }
  }
  return {};
}

CurveParams as_curve(const CrackParams& params) {
  CurveParams curve;
  curve.name = params.name;
  curve.kind = params.kind;
  curve.points = params.points;
  curve.centre = params.centre;
  curve.turning = params.turning;
  curve.role = sketch::Role::Crack;
  curve.segments = params.segments;
  curve.size = params.size;
  return curve;
}

/// The place of row i of the tables under `key`.
Place place_of(const dobra::scenario::Table& table, const char* key, std::size_t i, const std::string& item) {
  const auto* rows = table.find(key);
  Place place = std::get<std::vector<dobra::scenario::Table>>(*rows)[i].own_place;
  place.item = item;
  return place;
}

Result<void> add_curve(sketch::Sketch& sketch, const CurveParams& params, double tip_size, const Place& place) {
  auto curve = make_curve(params);
  if (!curve) return located(curve.error(), place);
  curve->tip_size = tip_size;
  sketch.curves.push_back(*std::move(curve));
  Place plain = place;
  plain.item.clear();  // What is said about finished curves names them itself.
  sketch.places.push_back(plain);
  return {};
}

std::string text_of(const sketch::Finding& finding) {
  return fmt::format("{} at ({:.6g}, {:.6g}) of {}: {}", name_of(finding.wrong), finding.at.x, finding.at.y,
                     finding.curve, finding.mend);
}

/// What was repaired may be why there is no domain: a domain may vanish.
Error with_findings(Error error, const std::vector<sketch::Finding>& findings) {
  constexpr std::size_t most = 5;
  for (std::size_t i = 0; i < std::min(most, findings.size()); ++i)
    error.message += fmt::format("{}{}", i == 0 ? "; repaired before: " : "; ", text_of(findings[i]));
  if (findings.size() > most) error.message += fmt::format("; and {} more", findings.size() - most);
  return error;
}

}  // namespace

Result<sketch::Sketch> read_drawing(const InputParams& params, const dobra::scenario::Table& table,
                                    const dobra::scenario::Context& context) {
  const auto append = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  sketch::Sketch sketch;
  const sketch::SpecimenParams specimen{params.specimen, params.width,    params.height, params.radius,
                                        params.crack,    params.position, params.angle};
  if (const auto sizes = check_sizes(specimen); !sizes) return located(sizes.error(), table.place("specimen"));
  if (params.specimen != sketch::SpecimenKind::None) {
    auto made = make_specimen(specimen);
    if (!made) return located(made.error(), table.place("specimen"));
    sketch = *std::move(made);
    sketch.places.assign(sketch.curves.size(), table.place("specimen"));
  }
  if (!params.file.empty()) {
    auto options = sketch_options(params);
    if (!options) return located(options.error(), table.place("file"));
    options->silent_unit = options->lines.silent_unit = context.units.to_si(1.0, "m");
    DOBRA_TRY(sketch::Sketch file, sketch::read_sketch((context.folder / params.file).string(), *options));
    auto roles = sketch::set_roles(file, params.kinds);
    if (!roles) return located(roles.error(), table.place("kind"));
    append(sketch.curves, file.curves);
    append(sketch.places, file.places);
    append(sketch.regions, file.regions);
    append(sketch.points, file.points);
    append(sketch.remarks, file.remarks);
    sketch.without_role = std::move(file.without_role);
    sketch.hole_points = std::move(file.hole_points);
    sketch.areas = std::move(file.areas);
  }
  DOBRA_TRY(const sketch::SketchOptions lines, sketch_options(params));
  if (params.file.empty() && lines.chosen && params.unit == dobra::scenario::lines::FileUnit::File)
    return Error{ErrorCode::BadValue,
                 "`format`, `columns`, `separator`, `coordinates`, `y_axis`, `closed` and the like say how `file` is "
                 "read, and there is no file; remove them"};
  if (params.file.empty() && !params.kinds.empty())
    return Error{ErrorCode::BadValue, "`kind` says what curves of `file` are, and there is no file; remove it",
                 table.place("kind")};
  if (params.file.empty() && params.unit != dobra::scenario::lines::FileUnit::File)
    return Error{ErrorCode::BadValue,
                 "`unit` is of the coordinates in `file`, and there is no file; numbers of the scenario are in the "
                 "units of `unit_system`",
                 table.place("unit")};
  if (params.gap && params.repair == Repair::No)
    return Error{ErrorCode::BadValue, "`gap` is how wide a gap repair closes: give --repair (repair = \"yes\") with it",
                 table.place("gap")};
  for (std::size_t i = 0; i < params.curves.size(); ++i) {
    const auto& curve = params.curves[i];
    DOBRA_TRY_VOID(add_curve(sketch, curve, 0.0, place_of(table, "curve", i, fmt::format("curve '{}'", curve.name))));
  }
  for (std::size_t i = 0; i < params.cracks.size(); ++i) {
    const auto& crack = params.cracks[i];
    DOBRA_TRY_VOID(add_curve(sketch, as_curve(crack), crack.tip_size,
                             place_of(table, "crack", i, fmt::format("crack '{}'", crack.name))));
  }
  for (const RegionParams& region : params.regions) sketch.regions.push_back({region.name, region.point});
  for (const PointParams& point : params.points) sketch.points.push_back({point.name, point.point, point.size});
  return sketch;
}

std::vector<dobra::scenario::FileKind> input_files() {
  using dobra::io::formats::Use;
  std::vector<dobra::scenario::FileKind> kinds =
      dobra::scenario::lines::file_kinds({Use::ReadDrawing, Use::ReadLines, Use::ReadMesh});
  kinds.push_back(brep_files());
  return kinds;
}

bool is_brep(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".brep";
}

namespace {

/// A model of faces.
model::Model model_of(model::SurfaceSet set, std::vector<dobra::surf::mesh::Finding> findings,
                      const dobra::scenario::Context& context) {
  model::Model model;
  model.units = context.shown_units;
  model.domain.unit = context.units.to_si(1.0, "m");
  model.surfaces = std::make_shared<const model::SurfaceSet>(std::move(set));
  model.surface_findings = std::move(findings);
  for (const auto& finding : model.surface_findings)
    model.remarks.push_back(surfaces::line_of(finding, finding.place.item.empty()));
  return model;
}

/// Whatever lies on surfaces of the scenario and stands there without any.
Result<void> check_without_surfaces(const InputParams& params, const dobra::scenario::Table& table) {
  for (const char* const key : {"trim", "part", "surface_point", "space_curve"}) {
    if (table.find(key) == nullptr) continue;
    if (!is_brep(params.file))
      return Error{ErrorCode::BadValue,
                   fmt::format("`{}` is of surfaces, and there is no [[input.surface]]; for a plane domain there are "
                               "`curve`, `crack`, `region` and `point`",
                               key),
                   table.place(key)};
    return Error{
        ErrorCode::BadValue,
        fmt::format("`{}` is of surfaces of the scenario; the faces of '{}' are meshed as the file bounds them", key,
                    params.file),
        table.place(key)};
  }
  return {};
}

/// Surfaces and faces are mended unasked, or refused.
Result<void> no_repair(const InputParams& params, const dobra::scenario::Table& table) {
  if (params.repair != Repair::Yes) return {};
  return Error{ErrorCode::BadValue,
               "`repair` mends drawings of plane domains; loops of faces are mended without it: leave it out",
               table.place("repair")};
}

/// The faces of a boundary model, whose numbers are in the document's length.
Result<model::Model> read_faces(const InputParams& params, const dobra::scenario::Table& table,
                                const dobra::scenario::Context& context) {
  for (const char* const plane : {"specimen", "curve", "crack", "region", "point"}) {
    if (table.find(plane) == nullptr) continue;
    return Error{ErrorCode::BadValue,
                 fmt::format("`{}` is of a plane domain and stands beside faces of '{}'", plane, params.file),
                 table.place(plane)};
  }
  DOBRA_TRY_VOID(no_repair(params, table));
  const std::string path = (context.folder / params.file).string();
  DOBRA_TRY(dobra::io::faces::Imported imported, dobra::io::faces::faces_of_file(path));
  if (imported.faces.empty()) {
    const auto refused = std::find_if(imported.findings.begin(), imported.findings.end(),
                                      [](const auto& finding) { return finding.code.starts_with("face_"); });
    Error error{ErrorCode::BadDomain, "the file has no faces that could be meshed", Place{.file = path}};
    if (refused != imported.findings.end()) error.message = refused->message, error.place = refused->place;
    return error;
  }
  std::vector<dobra::geom::Vector> units(imported.faces.size(), {1.0, 1.0});
  return model_of({std::move(imported.faces), std::move(units)}, std::move(imported.findings), context);
}

/// The surfaces without what was found.
model::SurfaceSet set_of(surfaces::Surfaces& made) {
  model::SurfaceSet set;
  for (const surfaces::ChartUnits& own : made.units) {
    set.chart_units.push_back({own.u, own.v});
    set.unit_names.push_back({own.u_name, own.v_name});
  }
  set.faces = std::move(made.faces), set.parts = std::move(made.parts), set.chosen = std::move(made.chosen);
  set.controls = std::move(made.controls), set.control_lines = std::move(made.control_lines);
  return set;
}

Result<model::Model> read_surfaces(const InputParams& params, const dobra::scenario::Table& table,
                                   const dobra::scenario::Context& context) {
  for (const char* const plane : {"specimen", "file", "curve", "crack", "region", "point"}) {
    if (table.find(plane) == nullptr) continue;
    return Error{
        ErrorCode::BadValue,
        fmt::format("`{}` is of a plane domain and stands beside surfaces; lines, cracks and points of surfaces "
                    "are `trim` and `surface_point`",
                    plane),
        table.place(plane)};
  }
  DOBRA_TRY_VOID(no_repair(params, table));
  DOBRA_TRY(surfaces::Surfaces made, surfaces::make_surfaces(params, table, context.units));
  if (made.faces.empty())
    return Error{ErrorCode::BadValue, "every surface is a tool; give one with use = \"mesh\"", table.place("surface")};
  model::SurfaceSet set = set_of(made);
  return model_of(std::move(set), std::move(made.findings), context);
}

/// A model whose steps make its parts.
Result<model::Model> read_solids(const dobra::scenario::Table& table, const dobra::scenario::Context& context) {
  for (const auto& entry : table.entries()) {
    if (entry.key == "solids") continue;
    return Error{ErrorCode::BadValue,
                 fmt::format("`{}` stands beside solids = true, where steps alone make the model", entry.key),
                 table.place(entry.key)};
  }
  model::Model model;
  model.units = context.shown_units;
  model.domain.unit = context.units.to_si(1.0, "m");
  model.solids = std::make_shared<const solids::Parts>();
  return model;
}

}  // namespace

std::optional<model::Model> drawn_surfaces(const InputParams& params, const dobra::scenario::Table& table,
                                           const dobra::scenario::Context& context) {
  if (params.surfaces.empty()) return std::nullopt;
  surfaces::Surfaces made = surfaces::drawn_surfaces(params, table, context.units);
  model::SurfaceSet set = set_of(made);
  if (set.faces.empty()) return std::nullopt;
  auto model = model_of(std::move(set), {}, context);
  return model;
}

Result<model::Model> read_input(const InputParams& params, const dobra::scenario::Table& table,
                                const dobra::scenario::Context& context) {
  if (params.solids) return read_solids(table, context);
  if (!params.surfaces.empty()) return read_surfaces(params, table, context);
  DOBRA_TRY_VOID(check_without_surfaces(params, table));
  if (is_brep(params.file)) return read_faces(params, table, context);
  DOBRA_TRY(sketch::Sketch sketch, read_drawing(params, table, context));
  const auto append = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  DOBRA_TRY_VOID(check_names(sketch.curves, sketch.places));
  model::Model model;
  model.units = context.shown_units;
  std::optional<sketch::RepairOptions> repaired_by;
  if (params.repair == Repair::Yes) {
    repaired_by = sketch::RepairOptions{.gap = params.gap};
    auto repaired = repair::repair(std::move(sketch), *repaired_by);
    if (!repaired) return repaired.error();
    sketch = std::move(repaired->sketch);
    model.findings = std::move(repaired->findings);
  }
  model.remarks = std::move(sketch.remarks);
  const repair::CrackEnds drawn = repair::crack_ends(sketch);
  auto domain = domain::make_domain(std::move(sketch), {params.join_tolerance, repaired_by});
  if (!domain) return with_findings(domain.error(), model.findings);
  model.domain = *std::move(domain);
  model.domain.unit = context.units.to_si(1.0, "m");
  std::vector<sketch::Finding> flaws = repair::flaws_of(model.domain, {.repaired = repaired_by});
  append(model.findings, flaws);
  std::vector<sketch::Finding> cracks = repair::crack_flaws(model.domain, drawn);
  append(model.findings, cracks);
  for (const sketch::Finding& finding : model.findings) {
    model.remarks.push_back(text_of(finding));
  }
  return model;
}

}  // namespace quebra::core
