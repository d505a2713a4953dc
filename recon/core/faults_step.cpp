#include "recon/core/faults_step.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "recon/core/report.h"
#include "recon/core/section_picture.h"
#include "recon/core/slip_arrows.h"
#include "shared/base/text.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace scene = dobra::scene;
using base::translated;

namespace {

const faults::FaultReport* fault_report(const model::Model& model) {
  const auto* found = model.findings.get<FoundFaults>();
  return found == nullptr ? nullptr : &found->report;
}

std::optional<double> x_at(const std::optional<faults::Cutoff>& cutoff) {
  return cutoff ? std::optional(cutoff->at.x) : std::nullopt;
}
std::optional<double> z_at(const std::optional<faults::Cutoff>& cutoff) {
  return cutoff ? std::optional(cutoff->at.y) : std::nullopt;
}

std::vector<RowCell> cells_of(const faults::CutoffPair& pair) {
  return {{"x_hanging_wall", "m", x_at(pair.hanging_wall)},
          {"z_hanging_wall", "m", z_at(pair.hanging_wall)},
          {"x_footwall", "m", x_at(pair.footwall)},
          {"z_footwall", "m", z_at(pair.footwall)},
          {"separation", "m", pair.separation},
          {"throw", "m", pair.throw_},
          {"heave", "m", pair.heave},
          {"gap", "m", pair.gap},
          {"overlap", "m", pair.overlap},
          {"distance", "m", pair.distance}};
}

void add_fault_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  const faults::FaultReport* report = fault_report(model);
  if (report == nullptr) return;
  for (const faults::FaultCutoffs& fault : report->cutoffs) {
    for (const faults::CutoffPair& pair : fault.pairs) {
      const std::string prefix = fmt::format("fault.{}.{}.", fault.fault, pair.horizon);
      add_cells(prefix, {{"separation", "m", pair.separation}, {"throw", "m", pair.throw_}, {"heave", "m", pair.heave}},
                quantities);
    }
  }
  for (const faults::Block& block : report->blocks)
    quantities.push_back({fmt::format("block.{}.area", block.name), block.area, "m2"});
}

/// What a profile marks before a pair.
std::string profile_mark(const std::vector<faults::ProfilePoint>& profile, const faults::CutoffPair& pair) {
  const auto at = std::find_if(profile.begin(), profile.end(), [&](const faults::ProfilePoint& point) {
    return point.horizon == pair.horizon && point.distance == pair.distance;
  });
  return at == profile.end() || !pair.separation ? std::string() : faults::name_of(at->mark);
}

void add_fault_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  const faults::FaultReport* report = fault_report(model);
  if (report == nullptr) return;
  scenario::DataTable cutoffs = table_of_cells("cutoffs", "fault", cells_of(faults::CutoffPair()));
  cutoffs.columns.insert(cutoffs.columns.begin() + 1, "horizon");
  cutoffs.columns.push_back("mark");
  for (std::size_t i = 0; i < report->faults.size(); ++i) {
    for (const faults::CutoffPair& pair : report->cutoffs[i].pairs) {
      add_row(report->faults[i].name, cells_of(pair), cutoffs);
      auto& row = cutoffs.rows.back();
      row.insert(row.begin() + 1, pair.horizon);
      row.emplace_back(profile_mark(report->profiles[i], pair));
    }
  }
  scenario::DataTable blocks{"blocks", {"block", "area [m2]", "faults", "group"}, {}};
  for (const faults::Block& block : report->blocks)
    blocks.rows.push_back({block.name, block.area, fmt::format("{}", fmt::join(block.faults, ", ")), block.part_of});
  tables.push_back(std::move(cutoffs));
  tables.push_back(std::move(blocks));
}

void add_fault_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  if (const faults::FaultReport* report = fault_report(model)) append(report->remarks, remarks);
}

/// Soft colours that neighbours tell apart.
constexpr std::array<scene::Color, 8> block_colors{{{141, 188, 216, 255},
                                                    {246, 205, 144, 255},
                                                    {168, 209, 158, 255},
                                                    {226, 167, 163, 255},
                                                    {196, 180, 214, 255},
                                                    {238, 226, 140, 255},
                                                    {160, 206, 200, 255},
                                                    {214, 190, 165, 255}}};

std::vector<scene::Layer> block_layers(const std::vector<faults::Block>& blocks) {
  std::vector<scene::Layer> layers;
  scene::Style text;
  text.line = ink;
  text.text_size = 8.0;
  scene::Labels names;
  for (const faults::Block& block : blocks) {
    scene::Style style;
    style.line_width = 0.0;
    style.fill = block_colors[block.id.index() % block_colors.size()];
    layers.push_back({fmt::format("block_{}", block.id.index()), block.name, style,
                      scene::Regions{{{block.contours}}, {}}, true, scene::InLegend::Yes});
    names.labels.push_back({block.inside, block.name, scene::Anchor::Centre});
  }
  layers.push_back({"block_names", translated("Blocks"), text, std::move(names), true, scene::InLegend::No});
  return layers;
}

/// On every fault whose cutoffs tell its sense.
std::vector<scene::Layer> sense_layers(const faults::FaultReport& report, double size) {
  std::vector<scene::Layer> layers;
  for (std::size_t i = 0; i < report.faults.size(); ++i) {
    const faults::Sense sense = report.cutoffs[i].sense;
    if (sense != faults::Sense::Normal && sense != faults::Sense::Reverse) continue;
    layers.push_back(slip_arrows(fmt::format("sense_{}", i), report.faults[i],
                                 sense == faults::Sense::Normal ? SlipSign::Down : SlipSign::Up, size));
  }
  return layers;
}

/// World lengths for a metre of the diagram: it is as wide as 0.6 of the section at least, to which it stands.
double unit_of_profiles(const faults::FaultReport& report, double section_width) {
  geom::Box box;
  for (const auto& profile : report.profiles) {
    for (const faults::ProfilePoint& point : profile) box.add(geom::Point{point.distance, point.separation});
  }
  return !box.empty() && box.width() > 0.0 ? std::max(1.0, 0.6 * section_width / box.width()) : 1.0;
}

/// One line a fault, the horizons as points of it; of faults with both walls of two horizons at least.
scene::Panel profile_panel(const faults::FaultReport& report, double section_width) {
  const double unit = unit_of_profiles(report, section_width);
  scene::Panel panel;
  panel.key = "displacement";
  panel.title = translated("Displacement along faults");
  panel.axes = {translated("distance from the higher end [m]"), translated("separation [m]"), scene::AxisScale::Diagram,
                unit};
  geom::Box box;
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < report.faults.size(); ++i) {
    geom::Polyline line;
    scene::Labels names;
    for (const faults::ProfilePoint& point : report.profiles[i]) {
      line.points.push_back({unit * point.distance, unit * point.separation});
      const std::string mark =
          point.mark == faults::ProfileMark::None ? std::string() : fmt::format(" ({})", faults::name_of(point.mark));
      names.labels.push_back({line.points.back(), point.horizon + mark, scene::Anchor::Above});
    }
    if (line.points.size() < 2) continue;
    box.add(line.box());
    scene::Style style;
    style.line = block_colors[drawn++ % block_colors.size()];
    style.line = {static_cast<std::uint8_t>(style.line.red / 2), static_cast<std::uint8_t>(style.line.green / 2),
                  static_cast<std::uint8_t>(style.line.blue / 2), 255};
    style.line_width = 1.4;
    style.text_size = 7.0;
    const std::string key = fmt::format("profile_{}", i);
    panel.layers.push_back(lines_layer(key, report.faults[i].name, style, {line}));
    panel.layers.push_back(
        {key + "_points", report.faults[i].name, style, scene::Markers{line.points, {}}, true, scene::InLegend::No});
    panel.layers.push_back({key + "_names", report.faults[i].name, style, std::move(names), true, scene::InLegend::No});
  }
  if (box.empty()) return panel;
  // Equal separations, or one horizon alone, still make a diagram.
  const double greatest = std::max(std::abs(box.low.y), std::abs(box.high.y));
  const double least = std::max(0.1 * greatest, 1e-3 * box.width());
  if (box.height() < least) {
    box.low.y -= 0.5 * least;
    box.high.y += 0.5 * least;
    panel.extent = box;
  }
  if (box.height() > 0.0) panel.vertical_exaggeration = std::max(1.0, 0.4 * box.width() / box.height());
  return panel;
}

void draw_faults(const model::Model& model, scene::Picture& picture) {
  const auto* found = model.findings.get<FoundFaults>();
  if (found == nullptr || (model.source && !is_done(model))) return;
  const section::Palette palette(found->section);
  PanelParts parts;
  parts.under = over_backdrops(found->section, block_layers(found->report.blocks));
  parts.pin = sense_layers(found->report, box_of(found->section).diagonal());
  std::vector<scene::Panel> panels{section_panel(empty_panel("faults", translated("Faults and blocks"), found->section),
                                                 found->section, palette, std::move(parts))};
  scene::Panel profile = profile_panel(found->report, box_of(found->section).width());
  if (!profile.layers.empty()) panels.push_back(std::move(profile));
  show(std::move(panels), found->section, picture);
}

}  // namespace

base::Result<model::Model> run_faults(const model::Model& model, const faults::FaultsParams& params,
                                      const scenario::Context&, const base::Progress&) {
  FoundFaults found;
  found.section = model.section;
  std::vector<std::string> remarks;
  if (is_done(model)) {
    DOBRA_TRY(found.section, section_after(model, remarks));
  }
  DOBRA_TRY(found.report, faults::report_faults(found.section, params));
  append(remarks, found.report.remarks);
  model::Model next = model;
  const std::size_t state = model.earlier.size() + (is_done(model) ? 1U : 0U);
  next.findings.set(std::move(found), {.state = state, .outlives = model::Outlives::Nothing});
  return next;
}

scenario::Operation faults_step() {
  return scenario::make_operation<model::Model, faults::FaultsParams>(
      "faults", "Faults", "Cutoffs and displacement along the faults of the section as it is, and its blocks.",
      run_faults,
      {.quantities = add_fault_quantities,
       .tables = add_fault_tables,
       .remarks = add_fault_remarks,
       .draw = draw_faults});
}

}  // namespace recon::core
