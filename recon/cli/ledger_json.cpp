#include "recon/cli/ledger_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "recon/core/operations.h"
#include "recon/core/report.h"
#include "recon/core/section_faces.h"

namespace recon::cli {

namespace {

using Json = nlohmann::ordered_json;

/// What could not be measured has no key.
void add_cells(const std::vector<core::RowCell>& cells, Json& json) {
  for (const core::RowCell& cell : cells) {
    if (cell.value) json[cell.name] = *cell.value;
  }
}

Json points_json(const std::vector<dobra::geom::Point>& points) {
  Json list = Json::array();
  for (const dobra::geom::Point p : points) list.push_back({p.x, p.y});
  return list;
}

/// The row of the layer below a horizon, if the units are made from horizons.
const core::UnitRow* layer_below(const core::Model& model, std::size_t horizon) {
  const core::Restoration& restoration = *model.restoration;
  const auto units = core::ledger_units(model.section, restoration.order, model.source->side);
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (units[i].upper == horizon) return &restoration.ledger.units[i];
  }
  if (!model.section.faces) return nullptr;
  for (const core::RockUnit& unit : model.section.faces->units) {
    for (const core::UnitRow& row : restoration.ledger.units) {
      if (unit.top == horizon && !unit.whole && row.name == unit.name) return &row;
    }
  }
  return nullptr;
}

Json restored_geometry(const core::Section& section) {
  Json list = Json::array();
  const auto add = [&](const std::string& name, const char* kind, const std::vector<dobra::geom::Point>& points) {
    list.push_back({{"name", name}, {"kind", kind}, {"points", points_json(points)}});
  };
  for (const core::Horizon& horizon : section.horizons) add(horizon.name, "horizon", horizon.line.points);
  for (const core::SectionLine& line : section.lines) add(line.name, core::kind_name(line.kind), line.line.points);
  for (const core::Unit& unit : section.units) add(unit.name, "unit", unit.contour.points);
  for (const core::Marker& marker : section.markers) add(marker.name, "marker", marker.points);
  return list;
}

Json error_bars_json(const core::MonteCarlo& result) {
  Json json = {{"draws", result.params.draws}, {"seed", result.params.seed}, {"failed", result.failed}};
  if (result.balanced_share) json["balanced_share"] = *result.balanced_share;
  Json list = Json::array();
  for (const core::Spread& s : result.spreads) {
    list.push_back({{"quantity", s.name},
                    {"unit", s.unit},
                    {"mean", s.mean},
                    {"deviation", s.deviation},
                    {"low", s.low},
                    {"median", s.median},
                    {"high", s.high}});
  }
  json["quantities"] = std::move(list);
  return json;
}

Json with_error_json(const core::WithError& number) {
  return {{"value", number.value}, {"error", number.error}, {"most", number.most}};
}

}  // namespace

std::string restoration_json(const core::Model& model, Geometry geometry) {
  const core::Restoration& restoration = *model.restoration;
  Json json = {{"method", core::method_name(restoration.params.method)},
               {"keeps", core::what_it_keeps(restoration.params.method)},
               {"percent", restoration.params.percent}};
  Json ledger = Json::array();
  std::set<std::string> layers;
  for (std::size_t i = 0; i < restoration.lengths.size(); ++i) {
    const bool growth = restoration.lengths[i].role == core::BedRole::Growth;
    Json entry = {{"name", restoration.lengths[i].name}, {"kind", growth ? "growth" : "horizon"}};
    add_cells(core::cells_of(restoration.lengths[i]), entry);
    const core::UnitRow* layer = layer_below(model, i);
    if (layer != nullptr) {
      layers.insert(layer->name);
      entry["layer"] = layer->name;
      add_cells(core::cells_of(*layer), entry);
    }
    ledger.push_back(std::move(entry));
  }
  for (const core::LineLength& row : core::totals_of(restoration.lengths)) {
    Json entry = {{"name", row.name}, {"kind", "horizon_in_pieces"}};
    add_cells(core::cells_of(row), entry);
    ledger.push_back(std::move(entry));
  }
  for (const core::UnitRow& row : core::unit_rows(model)) {
    if (model.section.units.empty() && layers.contains(row.name)) continue;
    Json entry = {{"name", row.name}, {"kind", row.role == core::BedRole::Outside ? "outside" : "unit"}};
    add_cells(core::cells_of(row), entry);
    ledger.push_back(std::move(entry));
  }
  json["ledger"] = std::move(ledger);
  const core::Balance& balance = restoration.balance;
  json["greatest_length_change_percent"] = balance.greatest_change_percent;
  json["greatest_area_change_percent"] = balance.greatest_area_change_percent;
  json["inconsistency_percent"] = balance.consistency.worst.percent;
  json["tolerance_percent"] = restoration.params.tolerance;
  json["lean_left"] = restoration.lean_left;
  json["lean_right"] = restoration.lean_right;
  json["verdict"] = core::verdict_name(balance.verdict);
  json["remarks"] = core::program().remarks_of(dobra::scenario::make_state(model));
  if (model.monte_carlo) json["error_bars"] = error_bars_json(*model.monte_carlo);
  if (geometry == Geometry::Include) json["restored"] = restored_geometry(restoration.section);
  return json.dump(2) + '\n';
}

std::string restoration_table(const core::Model& model) {
  const core::Restoration& restoration = *model.restoration;
  std::string text = fmt::format("{:<28} {:>12} {:>12} {:>8} {:>12} {:>8}\n", "horizon", "before [m]", "after [m]",
                                 "[%]", "shorter [m]", "[%]");
  std::vector<core::LineLength> rows = restoration.lengths;
  for (core::LineLength& total : core::totals_of(restoration.lengths)) {
    total.name += ", all pieces";
    rows.push_back(std::move(total));
  }
  for (const core::LineLength& row : rows) {
    text += fmt::format("{:<28} {:>12.3f} {:>12.3f} {:>8.3f} {:>12.3f} {:>8.3f}\n", row.name, row.length_before,
                        row.length_after, row.change_percent, row.shortening, row.shortening_percent);
  }
  text += fmt::format("\n{:<28} {:>12} {:>12} {:>8} {:>10} {:>10} {:>10}\n", "unit", "before [m2]", "after [m2]", "[%]",
                      "det F-1 %", "mean", "greatest");
  for (const core::UnitRow& row : core::unit_rows(model)) {
    const std::string name = row.pieces > 1 ? fmt::format("{} ({} pieces)", row.name, row.pieces) : row.name;
    text +=
        fmt::format("{:<28} {:>12.6g} {:>12.6g} {:>8.3f}", name, row.area_before, row.area_after, row.change_percent);
    if (row.dilatation) {
      text += fmt::format(" {:>10.3f} {:>10.3f} {:>10.3f}", 100.0 * row.dilatation->least, 100.0 * row.dilatation->mean,
                          100.0 * row.dilatation->greatest);
    }
    text += '\n';
  }
  if (model.monte_carlo) {
    text += fmt::format("\n{:<44} {:>12} {:>12} {:>12} {:>12}\n", "error bars", "mean", "deviation", "2.5 %", "97.5 %");
    for (const core::Spread& s : model.monte_carlo->spreads)
      text +=
          fmt::format("{:<44} {:>12.6g} {:>12.4g} {:>12.6g} {:>12.6g}\n", s.name, s.mean, s.deviation, s.low, s.high);
  }
  return text;
}

std::string balance_json(const core::Model& model) {
  Json json = Json::object();
  if (model.area_depth) {
    Json ledger = Json::array();
    for (const core::BedBalance& bed : model.area_depth->beds) {
      Json entry = {{"name", bed.name}};
      add_cells(core::cells_of(bed), entry);
      ledger.push_back(std::move(entry));
    }
    json["ledger"] = std::move(ledger);
    if (const auto& fit = model.area_depth->fit) {
      Json figures = Json::object();
      add_cells(core::cells_of(*fit), figures);
      if (fit->displacement_error) figures["confidence_percent"] = model.area_depth->params.confidence;
      json["fit"] = std::move(figures);
    }
    Json layers = Json::array();
    for (const core::LayerClass& layer : model.area_depth->layers) {
      layers.push_back({{"name", layer.name},
                        {"class", core::class_name(layer.fold.value)},
                        {"isogon_index", layer.fold.index},
                        {"hinge_thickness", layer.fold.hinge_thickness}});
    }
    json["layers"] = std::move(layers);
    json["inconsistency_percent"] = model.area_depth->consistency.worst.percent;
    json["tolerance_percent"] = model.area_depth->params.tolerance;
    json["verdict"] = core::verdict_name(model.area_depth->verdict);
  }
  if (const auto& area = model.area_balance) {
    json["area_balance"] = {{"area", with_error_json(area->area)},
                            {"initial_width", with_error_json(area->initial_width)},
                            {"width", with_error_json(area->width)},
                            {"shortening", with_error_json(area->shortening)},
                            {"shortening_percent", with_error_json(area->percent)}};
  }
  return json.dump(2) + '\n';
}

std::string balance_table(const core::Model& model) {
  std::string text;
  if (model.area_depth) {
    text += fmt::format("{:<28} {:>12} {:>12} {:>12} {:>12} {:>14} {:>12}\n", "horizon", "length [m]", "width [m]",
                        "shorter [m]", "level [m]", "excess [m2]", "depth [m]");
    for (const core::BedBalance& bed : model.area_depth->beds) {
      text += fmt::format("{:<28} {:>12.3f} {:>12.3f} {:>12.3f} {:>12.3f} {:>14.6g} {:>12}\n", bed.name, bed.length,
                          bed.width, bed.shortening, bed.level, bed.excess_area,
                          bed.depth ? fmt::format("{:.3f}", *bed.depth) : "-");
    }
  }
  if (const auto& area = model.area_balance) {
    const auto line = [&](const char* name, const core::WithError& n, double unit, const char* suffix) {
      text += fmt::format("{:<16} {:>12.2f} +- {:.2f} {} (at most {:.2f})\n", name, n.value / unit, n.error / unit,
                          suffix, n.most / unit);
    };
    line("area", area->area, 1e6, "km2");
    line("initial width", area->initial_width, 1e3, "km");
    line("width", area->width, 1e3, "km");
    line("shortening", area->shortening, 1e3, "km");
    line("shortening", area->percent, 1.0, "%");
  }
  return text;
}

}  // namespace recon::cli
