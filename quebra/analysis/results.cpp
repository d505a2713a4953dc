#include "quebra/analysis/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "shared/fem/probe.h"

namespace quebra::analysis {
namespace {

namespace fem = dobra::fem;
using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::geom::Point;
using dobra::geom::Vector;

double stress_value(FieldName field, const fem::Voigt& s, const fem::Material& material) {
  switch (field) {
    case FieldName::StressX:
      return s[0];
    case FieldName::StressY:
      return s[1];
    case FieldName::StressXY:
      return s[2];
    case FieldName::Principal1:
      return fem::principal(s).greatest;
    case FieldName::Principal2:
      return fem::principal(s).least;
    default:
      return fem::von_mises(s, material);
  }
}

constexpr std::array<FieldName, 8> sampled{FieldName::DisplacementX, FieldName::DisplacementY, FieldName::StressX,
                                           FieldName::StressY,       FieldName::StressXY,      FieldName::Principal1,
                                           FieldName::Principal2,    FieldName::VonMises};
using Row = std::array<double, sampled.size()>;

/// The fields of every case at a place. Stresses are interpolated as such; what is derived of them is derived there.
std::vector<Row> rows_at(const Analysis& analysis, const fem::Located& at) {
  const auto& mesh = analysis.meshed->mesh;
  const auto nodes = mesh.nodes_of(dobra::mesh::ElementId(at.element));
  const fem::Material& material = analysis.problem.materials.at(mesh.regions[at.element]);
  std::vector<Row> rows;
  for (std::size_t c = 0; c < analysis.fields.size(); ++c) {
    Vector u;
    fem::Voigt s{};
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      u = u + at.shape.n[a] * analysis.solution.cases[c].displacements[nodes[a].index()];
      const fem::Voigt& own = analysis.fields[c].recovered.at_element_nodes[mesh.first[at.element] + a];
      for (std::size_t k = 0; k < 3; ++k) s[k] += at.shape.n[a] * own[k];
    }
    Row row{u.x, u.y};
    for (std::size_t f = 2; f < sampled.size(); ++f) row[f] = stress_value(sampled[f], s, material);
    rows.push_back(row);
  }
  return rows;
}

Result<model::Model> with_samples(const model::Model& model, model::Samples samples, const std::string& what) {
  if (model.analyses.empty())
    return Error{ErrorCode::BadValue, "there is no analysis: put a step 'analyse' or 'adapt' before"};
  if (std::any_of(model.samples.begin(), model.samples.end(),
                  [&](const model::Samples& other) { return other.name == samples.name; }))
    return Error{ErrorCode::BadValue,
                 fmt::format("there is a line or probe '{}' already; give this one another `label`", samples.name)};
  const auto& mesh = model.analyses.back()->meshed->mesh;
  const auto boxes = fem::element_boxes(mesh);
  const auto inside = std::count_if(samples.points.begin(), samples.points.end(),
                                    [&](Point p) { return fem::locate(mesh, boxes, p).has_value(); });
  if (inside == 0) {
    const Point at = samples.points.front();
    return Error{ErrorCode::BadValue, what + " does not lie in the material",
                 Place{.item = "'" + samples.name + "'", .x = at.x, .y = at.y}};
  }
  model::Model result = model;
  if (const std::size_t outside = samples.points.size() - static_cast<std::size_t>(inside); outside > 0) {
    result.remarks.push_back(fmt::format("line '{}': points outside the material are left out: {} of {}", samples.name,
                                         outside, samples.points.size()));
  }
  result.samples.push_back(std::move(samples));
  return result;
}

}  // namespace

const std::vector<std::string>& field_names() {
  static const std::vector<std::string> names{"von_mises", "s_xx", "s_yy", "s_xy", "s_1",
                                              "s_2",       "u_x",  "u_y",  "u",    "error"};
  return names;
}

std::string unit_of(FieldName field) {
  switch (field) {
    case FieldName::DisplacementX:
    case FieldName::DisplacementY:
    case FieldName::Displacement:
      return "m";
    case FieldName::Error:
      return "J^0.5";
    default:
      return "Pa";
  }
}

std::vector<double> field_at_element_nodes(const Analysis& analysis, std::size_t load_case, FieldName field) {
  const auto& mesh = analysis.meshed->mesh;
  const auto& stresses = analysis.fields[load_case].recovered.at_element_nodes;
  const auto& u = analysis.solution.cases[load_case].displacements;
  std::vector<double> values(mesh.nodes.size());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const fem::Material& material = analysis.problem.materials.at(mesh.regions[e]);
    for (std::size_t k = mesh.first[e]; k < mesh.first[e + 1]; ++k) {
      const Vector own = u[mesh.nodes[k].index()];
      switch (field) {
        case FieldName::DisplacementX:
          values[k] = own.x;
          break;
        case FieldName::DisplacementY:
          values[k] = own.y;
          break;
        case FieldName::Displacement:
          values[k] = length(own);
          break;
        case FieldName::Error:
          values[k] = analysis.fields[load_case].estimate.elements[e];
          break;
        default:
          values[k] = stress_value(field, stresses[k], material);
      }
    }
  }
  return values;
}

Result<model::Model> add_line(const model::Model& model, const LineParams& params, const dobra::scenario::Context&,
                              const dobra::base::Progress&) {
  if (params.from == params.to) return Error{ErrorCode::BadValue, "`from` and `to` of the line are the same point"};
  model::Samples samples{params.label, {}, {}};
  for (int i = 0; i < params.count; ++i) {
    const double t = static_cast<double>(i) / (params.count - 1);
    samples.points.push_back(i + 1 == params.count ? params.to : interpolate(params.from, params.to, t));
    samples.s.push_back(t * distance(params.from, params.to));
  }
  return with_samples(model, std::move(samples), "the line");
}

Result<model::Model> add_probe(const model::Model& model, const ProbeParams& params, const dobra::scenario::Context&,
                               const dobra::base::Progress&) {
  return with_samples(model, {params.label, {params.at}, {0.0}}, "the point");
}

void add_sample_tables(const model::Model& model, std::vector<dobra::scenario::DataTable>& tables) {
  if (model.samples.empty() || model.analyses.empty()) return;
  const Analysis& analysis = *model.analyses.back();
  const auto boxes = fem::element_boxes(analysis.meshed->mesh);
  for (const model::Samples& samples : model.samples) {
    if (samples.points.size() < 2) continue;
    dobra::scenario::DataTable table{"line_" + samples.name, {"case", "s [m]", "x [m]", "y [m]"}, {}};
    for (const FieldName field : sampled)
      table.columns.push_back(fmt::format("{} [{}]", field_names()[static_cast<std::size_t>(field)], unit_of(field)));
    std::vector<std::vector<Row>> values(samples.points.size());
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
      if (const auto at = fem::locate(analysis.meshed->mesh, boxes, samples.points[i]))
        values[i] = rows_at(analysis, *at);
    }
    for (std::size_t c = 0; c < analysis.fields.size(); ++c) {
      for (std::size_t i = 0; i < samples.points.size(); ++i) {
        if (values[i].empty()) continue;
        auto& row = table.rows.emplace_back();
        row.reserve(table.columns.size());
        row.emplace_back(analysis.solution.cases[c].name);
        for (const double value : {samples.s[i], samples.points[i].x, samples.points[i].y}) row.emplace_back(value);
        for (const double value : values[i][c]) row.emplace_back(value);
      }
    }
    tables.push_back(std::move(table));
  }
}

void add_sample_quantities(const model::Model& model, std::vector<dobra::scenario::Quantity>& quantities) {
  if (model.samples.empty() || model.analyses.empty()) return;
  const Analysis& analysis = *model.analyses.back();
  const auto boxes = fem::element_boxes(analysis.meshed->mesh);
  for (const model::Samples& samples : model.samples) {
    if (samples.points.size() > 1) continue;
    const auto at = fem::locate(analysis.meshed->mesh, boxes, samples.points.front());
    if (!at) continue;
    const auto rows = rows_at(analysis, *at);
    for (std::size_t c = 0; c < rows.size(); ++c) {
      for (std::size_t f = 0; f < sampled.size(); ++f) {
        quantities.push_back({fmt::format("probe.{}.{}.{}", samples.name, analysis.solution.cases[c].name,
                                          field_names()[static_cast<std::size_t>(sampled[f])]),
                              rows[c][f], unit_of(sampled[f])});
      }
    }
  }
}

}  // namespace quebra::analysis
