#include "quebra/core/result_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "quebra/core/layers.h"
#include "shared/base/text.h"
#include "shared/scene/color_map.h"
#include "shared/scene/decimal_mark.h"

// 1. Points of the picture: a node once for each region that it belongs to, moved by its displacement. 2. Colours.
// 3. Contours: where the sides of the drawn triangles pass a level, joined into lines. 4. Outlines, marks, panel.

namespace quebra::core {
namespace {

namespace mesh = dobra::mesh;
namespace scene = dobra::scene;
using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Result;
using dobra::base::translated;
using dobra::geom::Point;
using dobra::geom::Polyline;

constexpr scene::Color before_grey{84, 110, 122};
constexpr scene::Color faint_mesh_line{38, 50, 56, 70};
constexpr scene::Color contour_line{255, 255, 255, 210};
/// Displacements are drawn this long, of the size of the model, unless asked otherwise.
constexpr double drawn_displacement = 0.05;

std::string title_of(analysis::FieldName field) {
  switch (field) {
    case analysis::FieldName::VonMises:
      return translated("von Mises stress");
    case analysis::FieldName::StressX:
      return translated("Stress sigma_x");
    case analysis::FieldName::StressY:
      return translated("Stress sigma_y");
    case analysis::FieldName::StressXY:
      return translated("Stress tau_xy");
    case analysis::FieldName::Principal1:
      return translated("Greatest principal stress");
    case analysis::FieldName::Principal2:
      return translated("Least principal stress");
    case analysis::FieldName::DisplacementX:
      return translated("Displacement along x");
    case analysis::FieldName::DisplacementY:
      return translated("Displacement along y");
    case analysis::FieldName::Displacement:
      return translated("Displacement");
    case analysis::FieldName::Error:
      return translated("Error of each element");
  }
  return {};
}

/// 1, 2 or 5 times a power of ten, not above `value`.
double round_number(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= value) return digit * power;
  }
  return power;
}

double scale_of(const analysis::Analysis& analysis, std::size_t load_case, const ViewParams& params) {
  if (params.deformation) return *params.deformation;
  double greatest = 0.0;
  for (const auto u : analysis.solution.cases[load_case].displacements) greatest = std::max(greatest, length(u));
  const double size = dobra::geom::box_of(analysis.meshed->mesh.points).diagonal();
  return greatest > 0.0 ? round_number(drawn_displacement * size / greatest) : 0.0;
}

/// The triangles that draw the mesh, and a value at each of their points.
struct Drawing {
  std::vector<Point> points;
  std::vector<double> values;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::size_t> element;  ///< Of each triangle.
};

Drawing drawing_of(const mesh::ElementMesh& mesh, const std::vector<Point>& moved, const std::vector<double>& values) {
  Drawing drawing;
  std::map<std::pair<std::size_t, std::int32_t>, std::uint32_t> known;
  std::vector<std::array<std::uint32_t, 3>> own;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    std::map<std::uint32_t, std::uint32_t> renamed;
    for (std::size_t k = mesh.first[e]; k < mesh.first[e + 1]; ++k) {
      const std::size_t node = mesh.nodes[k].index();
      const auto [at, added] =
          known.try_emplace({node, mesh.regions[e]}, static_cast<std::uint32_t>(drawing.points.size()));
      if (added) {
        drawing.points.push_back(moved[node]);
        drawing.values.push_back(values[k]);
      }
      renamed[static_cast<std::uint32_t>(node)] = at->second;
    }
    own.clear();
    add_triangles(mesh, e, own);
    for (const auto& t : own) {
      drawing.triangles.push_back({renamed.at(t[0]), renamed.at(t[1]), renamed.at(t[2])});
      drawing.element.push_back(e);
    }
  }
  return drawing;
}

/// Lines along which the field has the value `level`.
void add_contour(const Drawing& drawing, double level, std::vector<Polyline>& lines) {
  using Side = std::pair<std::uint32_t, std::uint32_t>;
  std::map<Side, std::vector<Side>> next;
  const auto above = [&](std::uint32_t p) { return drawing.values[p] >= level; };
  for (const auto& t : drawing.triangles) {
    std::vector<Side> cut;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      if (above(a) != above(b)) cut.push_back(std::minmax(a, b));
    }
    if (cut.size() != 2) continue;
    next[cut[0]].push_back(cut[1]);
    next[cut[1]].push_back(cut[0]);
  }
  const auto place = [&](const Side& side) {
    const double a = drawing.values[side.first], b = drawing.values[side.second];
    return interpolate(drawing.points[side.first], drawing.points[side.second], (level - a) / (b - a));
  };
  const auto walk = [&](Side from) {
    Polyline line{{place(from)}, false};
    for (auto at = next.find(from); at != next.end() && !at->second.empty(); at = next.find(from)) {
      const Side to = at->second.back();
      at->second.pop_back();
      auto& back = next.at(to);
      back.erase(std::find(back.begin(), back.end(), from));
      line.points.push_back(place(to));
      from = to;
    }
    if (line.points.size() > 1) lines.push_back(std::move(line));
  };
  // Lines with ends first, then the closed ones.
  for (const auto& [side, sides] : next) {
    if (sides.size() == 1) walk(side);
  }
  for (const auto& [side, sides] : next) {
    if (!sides.empty()) walk(side);
  }
}

/// Sides as lines, mid-sides included.
Polyline side_line(const mesh::ElementMesh& mesh, const std::vector<Point>& points, mesh::ElementSide side) {
  const auto [from, to, middle] = side_nodes(mesh, side);
  if (!middle.valid()) return {{points[from.index()], points[to.index()]}, false};
  return {{points[from.index()], points[middle.index()], points[to.index()]}, false};
}

/// Each side once.
scene::Lines sides_of(const mesh::ElementMesh& mesh, const std::vector<Point>& points) {
  scene::Lines lines;
  const auto neighbours = neighbours_of(mesh);
  std::size_t k = 0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (std::uint32_t i = 0; i < mesh::corner_count(mesh.types[e]); ++i, ++k) {
      const auto other = neighbours[k].element;
      if (!other.valid() || other.index() > e) lines.lines.push_back(side_line(mesh, points, {mesh::ElementId(e), i}));
    }
  }
  return lines;
}

scene::Lines boundary_of(const mesh::ElementMesh& mesh, const std::vector<Point>& points) {
  scene::Lines lines;
  for (const mesh::ElementSide side : boundary_sides(mesh)) lines.lines.push_back(side_line(mesh, points, side));
  return lines;
}

/// The range of colours: all of the values, unless a peak (a crack tip) stands out of what nearly all of the area has.
std::pair<double, double> range_of(const Drawing& drawing, ColorRange range) {
  constexpr double nearly_all = 0.995;
  constexpr double stands_out = 0.5;
  const auto [least, greatest] = std::minmax_element(drawing.values.begin(), drawing.values.end());
  if (range == ColorRange::Full) return {*least, *greatest};
  struct Part {
    double value, area;
  };
  std::vector<Part> parts;
  double all = 0.0;
  for (const auto& [a, b, c] : drawing.triangles) {
    const double area = std::abs(cross(drawing.points[b] - drawing.points[a], drawing.points[c] - drawing.points[a]));
    parts.push_back({(drawing.values[a] + drawing.values[b] + drawing.values[c]) / 3.0, area});
    all += area;
  }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.value < b.value; });
  const auto value_at = [&](double share) {
    double sum = 0.0;
    for (const Part& part : parts) {
      if ((sum += part.area) >= share * all) return part.value;
    }
    return parts.back().value;
  };
  const double rest = 1.0 - nearly_all;
  const double room = stands_out * (value_at(nearly_all) - value_at(rest));
  const bool below = *least<value_at(rest) - room, above = *greatest> value_at(nearly_all) + room;
  // What is cut off is the same part of the area, whether at one end or half of it at each.
  const double cut = below && above ? 0.5 * rest : rest;
  return {below ? value_at(cut) : *least, above ? value_at(1.0 - cut) : *greatest};
}

scene::Scale color_scale(const ViewParams& params, const Drawing& drawing, std::pair<double, double> range) {
  const auto [least, greatest] = std::minmax_element(drawing.values.begin(), drawing.values.end());
  scene::Scale scale{.title = fmt::format("{} [{}]", title_of(params.field), unit_of(params.field)),
                     .map = scene::ColorMapName::Viridis,
                     .low = range.first,
                     .high = range.second,
                     .least = *least,
                     .greatest = *greatest};
  if (range.first < 0.0 && range.second > 0.0) {  // as much blue as red
    scale.map = scene::ColorMapName::CoolWarm;
    scale.high = std::max(-range.first, range.second);
    scale.low = -scale.high;
  }
  if (!(scale.high > scale.low)) scale.low = *least, scale.high = *greatest;  // all but a peak is one value
  return scale;
}

/// The greatest of the numbers that a field is made of.
double size_of(const analysis::Analysis& analysis, std::size_t load_case, analysis::FieldName field) {
  if (field == analysis::FieldName::Error) return analysis.fields[load_case].estimate.norm;
  const auto greatest = [&](analysis::FieldName name) {
    double most = 0.0;
    for (const double value : field_at_element_nodes(analysis, load_case, name)) most = std::max(most, std::abs(value));
    return most;
  };
  const bool moved = field == analysis::FieldName::DisplacementX || field == analysis::FieldName::DisplacementY ||
                     field == analysis::FieldName::Displacement;
  if (moved) return greatest(analysis::FieldName::Displacement);
  return std::max(greatest(analysis::FieldName::Principal1), greatest(analysis::FieldName::Principal2));
}

/// Where the greatest and the least value are, each once.
void add_extremes(const Drawing& drawing, std::vector<scene::Layer>& layers) {
  const auto [least, greatest] = std::minmax_element(drawing.values.begin(), drawing.values.end());
  scene::Markers markers;
  scene::Labels labels;
  for (const auto& [at, word] : {std::pair{greatest, "max"}, std::pair{least, "min"}}) {
    const Point p = drawing.points[static_cast<std::size_t>(at - drawing.values.begin())];
    markers.points.push_back(p);
    labels.labels.push_back({p, translated(word), scene::Anchor::Callout, *at});
  }
  layers.push_back({"extremes",
                    translated("Extremes"),
                    {.line = ink, .marker_size = 6.0},
                    std::move(markers),
                    true,
                    scene::InLegend::Yes});
  layers.push_back({"extreme_values",
                    translated("Extreme values"),
                    {.line = ink, .text_size = 9.0},
                    std::move(labels),
                    true,
                    scene::InLegend::No});
}

/// The analysis that a view shows; null: there is no such cycle.
const analysis::Analysis* analysis_of(const model::Model& model, const ViewParams& params) {
  if (params.cycle == 0) return model.analyses.back().get();
  const auto found = std::find_if(model.analyses.rbegin(), model.analyses.rend(),
                                  [&](const auto& own) { return own->cycle == params.cycle; });
  return found == model.analyses.rend() ? nullptr : found->get();
}

}  // namespace

Result<model::Model> add_view(const model::Model& model, const ViewParams& params, const dobra::scenario::Context&,
                              const dobra::base::Progress&) {
  if (model.analyses.empty())
    return Error{ErrorCode::BadValue, "there is no analysis: put a step 'analyse' or 'adapt' before"};
  const analysis::Analysis* const shown = analysis_of(model, params);
  if (shown == nullptr)
    return Error{ErrorCode::BadValue,
                 fmt::format("there is no cycle {}: the last is {}", params.cycle, model.analyses.back()->cycle)};
  std::vector<std::string> names;
  for (const auto& own : shown->solution.cases) names.push_back(own.name);
  if (!params.load_case.empty() && std::find(names.begin(), names.end(), params.load_case) == names.end())
    return Error{ErrorCode::BadValue, fmt::format("there is no load case '{}'{}", params.load_case,
                                                  dobra::base::did_you_mean(params.load_case, names))};
  model::Model result = model;
  result.views.push_back(std::make_shared<const ViewParams>(params));
  return result;
}

scene::Panel view_panel(const analysis::Analysis& analysis, std::size_t load_case, const ViewParams& params) {
  const mesh::ElementMesh& mesh = analysis.meshed->mesh;
  const double factor = scale_of(analysis, load_case, params);
  std::vector<Point> moved = mesh.points;
  for (std::size_t n = 0; n < moved.size(); ++n)
    moved[n] = moved[n] + factor * analysis.solution.cases[load_case].displacements[n];
  const Drawing drawing = drawing_of(mesh, moved, field_at_element_nodes(analysis, load_case, params.field));
  const auto [least, greatest] = range_of(drawing, params.range);
  const scene::Scale scale = color_scale(params, drawing, {least, greatest});

  scene::Panel panel{.key = "analysis"};
  panel.title = fmt::format("{}: {}", analysis.solution.cases[load_case].name, title_of(params.field));
  if (params.cycle > 0) panel.title = shown_name(analysis.meshed->name) + ", " + panel.title;
  if (factor > 0.0)
    panel.title += fmt::format(", {}\u00a0\u00d7\u00a0{}", translated("displacements"),
                               dobra::scene::with_decimal_mark(fmt::format("{:g}", factor)));
  panel.title += fmt::format("; eta\u00a0{}\u00a0%", dobra::scene::with_decimal_mark(fmt::format(
                                                         "{:.2g}", 100.0 * analysis.fields[load_case].estimate.eta)));
  const auto add = [&](const char* key, std::string title, const scene::Style& style, auto content,
                       scene::InLegend legend) {
    panel.layers.push_back({key, std::move(title), style, std::move(content), true, legend});
  };
  scene::Mesh colors{.points = drawing.points,
                     .triangles = drawing.triangles,
                     .values_at = scene::ValuesAt::Points,
                     .values = drawing.values,
                     .scale = scale};
  if (params.field == analysis::FieldName::Error) {
    colors.values_at = scene::ValuesAt::Triangles;
    colors.values = {};
    for (const std::size_t e : drawing.element)
      colors.values.push_back(analysis.fields[load_case].estimate.elements[e]);
  }
  const bool constant = scene::settle_constant(colors, size_of(analysis, load_case, params.field));
  add("field", title_of(params.field), {.line_width = 0.0}, std::move(colors), scene::InLegend::No);
  if (params.mesh == Shown::Yes)
    add("elements", translated("Elements"), {.line = faint_mesh_line, .line_width = outline_width(mesh)},
        sides_of(mesh, moved), scene::InLegend::No);
  if (params.contours > 0 && params.field != analysis::FieldName::Error && !constant) {
    scene::Lines contours;
    for (int i = 1; i <= params.contours; ++i)
      add_contour(drawing, least + (greatest - least) * i / (params.contours + 1), contours.lines.edit());
    add("contours", translated("Contours"), {.line = contour_line, .line_width = 0.8}, std::move(contours),
        scene::InLegend::No);
  }
  if (factor > 0.0)
    add("before", translated("Before"), {.line = before_grey, .line_width = 0.9, .dash = scene::Dash::Dashed},
        boundary_of(mesh, mesh.points), scene::InLegend::Yes);
  add("boundary", translated("Boundary"), {.line = ink, .line_width = boundary_width}, boundary_of(mesh, moved),
      scene::InLegend::Yes);
  if (params.extremes == Shown::Yes && params.field != analysis::FieldName::Error && !constant)
    add_extremes(drawing, panel.layers);
  return panel;
}

void add_views(const model::Model& model, scene::Picture& picture) {
  if (model.analyses.empty()) return;
  const auto panel_of = [&](const ViewParams& view) {
    const analysis::Analysis& analysis = *analysis_of(model, view);
    const auto& cases = analysis.solution.cases;
    const auto found =
        std::find_if(cases.begin(), cases.end(), [&](const auto& own) { return own.name == view.load_case; });
    return view_panel(analysis, found == cases.end() ? std::size_t{0} : static_cast<std::size_t>(found - cases.begin()),
                      view);
  };
  if (model.views.empty()) {
    picture.panels.push_back(panel_of({}));
    return;
  }
  picture.panels.clear();
  for (const auto& view : model.views) {
    picture.panels.push_back(panel_of(*view));
    picture.panels.back().key = fmt::format("view_{}", picture.panels.size());
  }
}

}  // namespace quebra::core
