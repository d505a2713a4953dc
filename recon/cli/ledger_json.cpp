#include "recon/cli/ledger_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "recon/balance/area_balance.h"
#include "recon/balance/area_depth.h"
#include "recon/cli/geometry_json.h"
#include "recon/core/operations.h"
#include "recon/core/report.h"
#include "recon/section/section_faces.h"
#include "recon/unfold/monte_carlo.h"

namespace recon::cli {

namespace {

using Json = nlohmann::ordered_json;

/// What could not be measured has no key.
void add_cells(const std::vector<core::RowCell>& cells, Json& json) {
  for (const core::RowCell& cell : cells) {
    if (cell.value) json[cell.name] = *cell.value;
  }
}

/// The row of the layer below a horizon, if the units are made from horizons.
const balance::UnitRow* layer_below(const model::Model& model, std::size_t horizon) {
  const unfold::Restoration& restoration = *model.restoration;
  const auto units = balance::ledger_units(model.section, restoration.order, model.source->side);
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (units[i].upper == horizon) return &restoration.ledger.units[i];
  }
  if (!model.section.faces) return nullptr;
  for (const section::RockUnit& unit : model.section.faces->units) {
    for (const balance::UnitRow& row : restoration.ledger.units) {
      if (unit.top == horizon && !unit.whole && row.name == unit.name) return &row;
    }
  }
  return nullptr;
}

Json error_bars_json(const unfold::MonteCarlo& result) {
  Json json = {{"draws", result.params.draws}, {"seed", result.params.seed}, {"failed", result.failed}};
  if (result.balanced_share) json["balanced_share"] = *result.balanced_share;
  Json list = Json::array();
  for (const unfold::Spread& s : result.spreads) {
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

Json with_error_json(const balance::WithError& number) {
  return {{"value", number.value}, {"error", number.error}, {"most", number.most}};
}

}  // namespace

std::string restoration_json(const model::Model& model, Geometry geometry) {
  const unfold::Restoration& restoration = *model.restoration;
  Json json = {{"method", unfold::method_name(restoration.params.method)},
               {"keeps", unfold::what_it_keeps(restoration.params.method)},
               {"percent", restoration.params.percent}};
  Json ledger = Json::array();
  std::set<std::string> layers;
  for (std::size_t i = 0; i < restoration.lengths.size(); ++i) {
    const bool growth = restoration.lengths[i].role == section::BedRole::Growth;
    Json entry = {{"name", restoration.lengths[i].name}, {"kind", growth ? "growth" : "horizon"}};
    add_cells(core::cells_of(restoration.lengths[i]), entry);
    const balance::UnitRow* layer = layer_below(model, i);
    if (layer != nullptr) {
      layers.insert(layer->name);
      entry["layer"] = layer->name;
      add_cells(core::cells_of(*layer), entry);
    }
    ledger.push_back(std::move(entry));
  }
  for (const balance::LineLength& row : balance::totals_of(restoration.lengths)) {
    Json entry = {{"name", row.name}, {"kind", "horizon_in_pieces"}};
    add_cells(core::cells_of(row), entry);
    ledger.push_back(std::move(entry));
  }
  for (const balance::UnitRow& row : core::unit_rows(model)) {
    if (model.section.units.empty() && layers.contains(row.name)) continue;
    Json entry = {{"name", row.name}, {"kind", row.role == section::BedRole::Outside ? "outside" : "unit"}};
    add_cells(core::cells_of(row), entry);
    ledger.push_back(std::move(entry));
  }
  json["ledger"] = std::move(ledger);
  const balance::Balance& balance = restoration.balance;
  json["greatest_length_change_percent"] = balance.greatest_change_percent;
  json["greatest_area_change_percent"] = balance.greatest_area_change_percent;
  json["inconsistency_percent"] = balance.consistency.worst.percent;
  json["tolerance_percent"] = restoration.params.tolerance;
  json["lean_left"] = restoration.lean_left;
  json["lean_right"] = restoration.lean_right;
  json["verdict"] = balance::verdict_name(balance.verdict);
  json["remarks"] = core::program().remarks_of(dobra::scenario::make_state(model));
  if (const auto* bars = model.findings.get<unfold::MonteCarlo>()) json["error_bars"] = error_bars_json(*bars);
  if (geometry == Geometry::Include) json["restored"] = pieces_json(restoration.section);
  return json.dump(2) + '\n';
}

std::string restoration_table(const model::Model& model) {
  const unfold::Restoration& restoration = *model.restoration;
  std::string text = fmt::format("{:<28} {:>12} {:>12} {:>8} {:>12} {:>8}\n", "horizon", "before [m]", "after [m]",
                                 "[%]", "shorter [m]", "[%]");
  std::vector<balance::LineLength> rows = restoration.lengths;
  for (balance::LineLength& total : balance::totals_of(restoration.lengths)) {
    total.name += ", all pieces";
    rows.push_back(std::move(total));
  }
  for (const balance::LineLength& row : rows) {
    text += fmt::format("{:<28} {:>12.3f} {:>12.3f} {:>8.3f} {:>12.3f} {:>8.3f}\n", row.name, row.length_before,
                        row.length_after, row.change_percent, row.shortening, row.shortening_percent);
  }
  text += fmt::format("\n{:<28} {:>12} {:>12} {:>8} {:>10} {:>10} {:>10}\n", "unit", "before [m2]", "after [m2]", "[%]",
                      "det F-1 %", "mean", "greatest");
  for (const balance::UnitRow& row : core::unit_rows(model)) {
    const std::string name = row.pieces > 1 ? fmt::format("{} ({} pieces)", row.name, row.pieces) : row.name;
    text +=
        fmt::format("{:<28} {:>12.6g} {:>12.6g} {:>8.3f}", name, row.area_before, row.area_after, row.change_percent);
    if (row.dilatation) {
      text += fmt::format(" {:>10.3f} {:>10.3f} {:>10.3f}", 100.0 * row.dilatation->least, 100.0 * row.dilatation->mean,
                          100.0 * row.dilatation->greatest);
    }
    text += '\n';
  }
  if (const auto* bars = model.findings.get<unfold::MonteCarlo>()) {
    text += fmt::format("\n{:<44} {:>12} {:>12} {:>12} {:>12}\n", "error bars", "mean", "deviation", "2.5 %", "97.5 %");
    for (const unfold::Spread& s : bars->spreads)
      text +=
          fmt::format("{:<44} {:>12.6g} {:>12.4g} {:>12.6g} {:>12.6g}\n", s.name, s.mean, s.deviation, s.low, s.high);
  }
  return text;
}

std::string balance_json(const model::Model& model) {
  Json json = Json::object();
  if (const auto* found = model.findings.get<balance::AreaDepth>()) {
    Json ledger = Json::array();
    for (const balance::BedBalance& bed : found->beds) {
      Json entry = {{"name", bed.name}};
      add_cells(core::cells_of(bed), entry);
      ledger.push_back(std::move(entry));
    }
    json["ledger"] = std::move(ledger);
    if (const auto& fit = found->fit) {
      Json figures = Json::object();
      add_cells(core::cells_of(*fit), figures);
      if (fit->displacement_error) figures["confidence_percent"] = found->params.confidence;
      json["fit"] = std::move(figures);
    }
    Json layers = Json::array();
    for (const balance::LayerClass& layer : found->layers) {
      layers.push_back({{"name", layer.name},
                        {"class", balance::class_name(layer.fold.value)},
                        {"isogon_index", layer.fold.index},
                        {"hinge_thickness", layer.fold.hinge_thickness}});
    }
    json["layers"] = std::move(layers);
    json["inconsistency_percent"] = found->consistency.worst.percent;
    json["tolerance_percent"] = found->params.tolerance;
    json["verdict"] = balance::verdict_name(found->verdict);
  }
  if (const auto* area = model.findings.get<balance::AreaBalance>()) {
    json["area_balance"] = {{"area", with_error_json(area->area)},
                            {"initial_width", with_error_json(area->initial_width)},
                            {"width", with_error_json(area->width)},
                            {"shortening", with_error_json(area->shortening)},
                            {"shortening_percent", with_error_json(area->percent)}};
  }
  return json.dump(2) + '\n';
}

std::string balance_table(const model::Model& model) {
  std::string text;
  if (const auto* found = model.findings.get<balance::AreaDepth>()) {
    text += fmt::format("{:<28} {:>12} {:>12} {:>12} {:>12} {:>14} {:>12}\n", "horizon", "length [m]", "width [m]",
                        "shorter [m]", "level [m]", "excess [m2]", "depth [m]");
    for (const balance::BedBalance& bed : found->beds) {
      text += fmt::format("{:<28} {:>12.3f} {:>12.3f} {:>12.3f} {:>12.3f} {:>14.6g} {:>12}\n", bed.name, bed.length,
                          bed.width, bed.shortening, bed.level, bed.excess_area,
                          bed.depth ? fmt::format("{:.3f}", *bed.depth) : "-");
    }
  }
  if (const auto* area = model.findings.get<balance::AreaBalance>()) {
    const auto line = [&](const char* name, const balance::WithError& n, double unit, const char* suffix) {
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
