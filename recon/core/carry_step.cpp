#include "recon/core/carry_step.h"

#include <algorithm>

#include "recon/core/report.h"
#include "shared/base/text.h"
#include "shared/io/gis/geojson.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace io = dobra::io;

namespace scene = dobra::scene;
using base::translated;

namespace {

constexpr scene::Color carried_color{190, 30, 140, 255};

void add_carried_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  const auto all = model.findings.all<model::CarriedLines>();
  if (all.empty()) return;
  scenario::DataTable table{"carried",
                            {"carry", "from state", "to state", "line", "x before [m]", "z before [m]", "x after [m]",
                             "z after [m]", "way back misses [m]"},
                            {}};
  for (std::size_t c = 0; c < all.size(); ++c) {
    const model::CarriedLines& carried = *all[c];
    for (std::size_t l = 0; l < carried.lines.size(); ++l) {
      const model::CarriedLine& line = carried.lines[l];
      for (std::size_t i = 0; i < line.points.size(); ++i) {
        const geom::Point before = line.before.points[i];
        const model::CarriedPoint& after = line.points[i];
        table.rows.push_back({count_of(c + 1), count_of(carried.from), count_of(carried.to), count_of(l + 1), before.x,
                              before.y, after.at.x, after.at.y, after.misses});
      }
    }
  }
  tables.push_back(std::move(table));
}

void add_carried_features(const model::CarriedLines& carried, std::size_t number,
                          std::vector<io::lines::Feature>& features) {
  for (std::size_t l = 0; l < carried.lines.size(); ++l) {
    const auto add = [&](const geom::Polyline& line, const char* kind) {
      const io::lines::FeatureType type = line.closed              ? io::lines::FeatureType::Polygons
                                          : line.points.size() > 1 ? io::lines::FeatureType::Lines
                                                                   : io::lines::FeatureType::Points;
      const std::string name = "carry " + std::to_string(number) + ", line " + std::to_string(l + 1);
      add_feature(type, name, kind, l, line, features);
    };
    add(carried.lines[l].before, "before");
    add(carried.lines[l].after, "after");
  }
}

void add_carried_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  if (model->findings.get<model::CarriedLines>() == nullptr) return;
  outputs.push_back({"carried.geojson", [model](const std::filesystem::path& path) {
                       std::vector<io::lines::Feature> features;
                       const auto all = model->findings.all<model::CarriedLines>();
                       for (std::size_t c = 0; c < all.size(); ++c) add_carried_features(*all[c], c + 1, features);
                       return io::gis::write_geojson(path.string(), features);
                     }});
}

void add_carried_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  for (const auto* carried : model.findings.all<model::CarriedLines>()) append(carried->remarks, remarks);
}

/// What was carried from or to a state, in its panel.
void draw_carried(const std::vector<const model::CarriedLines*>& all, std::size_t state, scene::Panel& panel) {
  scene::Style style;
  style.line = carried_color;
  style.line_width = 1.4;
  scene::Lines lines;
  std::vector<geom::Point> points;
  for (const model::CarriedLines* carried : all) {
    if (state != carried->from && state != carried->to) continue;
    for (const model::CarriedLine& line : carried->lines) {
      const geom::Polyline& shown = state == carried->from ? line.before : line.after;
      if (shown.points.size() == 1) {
        points.push_back(shown.points.front());
      } else {
        lines.lines.push_back(shown);
      }
    }
  }
  if (!lines.lines.empty()) {
    panel.layers.push_back(
        {"carried", translated("Carried lines"), style, std::move(lines), true, scene::InLegend::Yes});
  }
  if (!points.empty()) {
    panel.layers.push_back({"carried_points", translated("Carried points"), style,
                            scene::Markers{std::move(points), {}}, true, scene::InLegend::Yes});
  }
}

/// The panels are the state of the stage in hand and, where it is restored, the one after it.
void draw_carried(const model::Model& model, scene::Picture& picture) {
  for (std::size_t i = 0; i < picture.panels.size(); ++i)
    draw_carried(model.findings.all<model::CarriedLines>(), model.earlier.size() + i, picture.panels[i]);
}

}  // namespace

base::Result<model::Model> run_carry(const model::Model& model, const model::CarryParams& params,
                                     const scenario::Context& context, const base::Progress&) {
  const std::vector<const model::Stage*> chain = restored_stages(model);
  if (chain.empty()) {
    return base::Error{
        base::ErrorCode::CannotRestore,
        "nothing is restored or moved yet that could carry a line; put a step 'restore' or 'move' before it"};
  }
  model::Model next = model;
  DOBRA_TRY(model::CarriedLines carried, carry_lines(chain, params, context));
  const std::size_t last = std::max(carried.from, carried.to);
  next.findings.add(std::move(carried), {.state = last});
  return next;
}

scenario::Operation carry_step() {
  return scenario::make_operation<model::Model, model::CarryParams>(
      "carry", "Carry", "Points, lines or polygons of one state of the section, carried to another, forward or back.",
      run_carry,
      {.tables = add_carried_tables,
       .remarks = add_carried_remarks,
       .outputs = add_carried_outputs,
       .draw = draw_carried});
}

}  // namespace recon::core
