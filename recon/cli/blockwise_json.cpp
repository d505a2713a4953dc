#include "recon/cli/blockwise_json.h"

#include <fmt/format.h>

#include "recon/cli/geometry_json.h"
#include "recon/core/operations.h"
#include "recon/core/report.h"

namespace recon::cli {

namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

template <class Row>
void add_rows(const std::vector<Row>& rows, const char* kind, Json& ledger) {
  for (const Row& row : rows) {
    const bool growth = row.role == section::BedRole::Growth;
    Json entry = {{"name", row.name}, {"kind", growth && std::string(kind) == "horizon" ? "growth" : kind}};
    for (const core::RowCell& cell : core::cells_of(row)) {
      if (cell.value) entry[cell.name] = *cell.value;
    }
    ledger.push_back(std::move(entry));
  }
}

/// What could not be measured is null.
Json faults_json(const std::vector<jigsaw::RestoredFault>& faults) {
  Json list = Json::array();
  for (const jigsaw::RestoredFault& fault : faults) {
    Json entry = {{"name", fault.name}};
    for (const core::RowCell& cell : core::cells_of(fault)) entry[cell.name] = or_null(cell.value);
    if (fault.opening.gap > 0.0) entry["gap_at"] = {fault.opening.gap_at.x, fault.opening.gap_at.y};
    if (fault.opening.overlap > 0.0) entry["overlap_at"] = {fault.opening.overlap_at.x, fault.opening.overlap_at.y};
    if (fault.left_apart) entry["misclosure"] = *fault.left_apart;
    if (!fault.line.points.empty()) entry["line"] = points_json(fault.line.points);
    list.push_back(std::move(entry));
  }
  return list;
}

void add_jigsaw(const jigsaw::Blockwise& made, Json& json) {
  json["constraint"] = is_rigid(made.how) ? "rotation" : "datum";
  json["fit"] = made.how.fit.value_or(jigsaw::Fit::Walls) == jigsaw::Fit::Walls ? "walls" : "top";
  json["faults"] = faults_json(made.faults);
  json["width_before"] = made.widths.before;
  json["width_after"] = made.widths.after;
  json["shortening"] = made.widths.shortening();
  json["shortening_percent"] = 100.0 * made.widths.shortening() / made.widths.after;
  json["shortening_by_folding"] = made.widths.folding();
  json["greatest_opening_percent"] = made.greatest_opening_percent;
}

}  // namespace

std::string blockwise_json(const model::Model& model, Geometry geometry) {
  const jigsaw::Blockwise& made = *model.blockwise;
  Json json = Json::object();
  if (!is_rigid(made.how)) {
    json["method"] = unfold::method_name(made.params.method);
    json["keeps"] = unfold::what_it_keeps(made.params.method);
  }
  json["percent"] = made.params.percent;
  Json blocks = Json::array();
  for (const jigsaw::BlockRow& row : made.rows) {
    Json block = {{"name", row.name}, {"shift", or_null(row.shift)}};
    if (row.raise) block["raise"] = *row.raise;
    if (row.turn) block["turn"] = *row.turn;
    if (!made.ties.empty()) block["shift_error"] = or_null(row.shift_error);
    blocks.push_back(std::move(block));
  }
  json["blocks"] = std::move(blocks);
  if (made.how.jigsaw) add_jigsaw(made, json);
  Json ledger = Json::array();
  add_rows(made.lengths, "horizon", ledger);
  add_rows(balance::totals_of(made.lengths), "horizon_in_pieces", ledger);
  add_rows(made.units, "unit", ledger);
  json["ledger"] = std::move(ledger);
  json["greatest_length_change_percent"] = made.balance.greatest_change_percent;
  json["greatest_area_change_percent"] = made.balance.greatest_area_change_percent;
  json["inconsistency_percent"] = made.balance.consistency.worst.percent;
  json["tolerance_percent"] = made.params.tolerance;
  json["verdict"] = balance::verdict_name(made.balance.verdict);
  json["remarks"] = core::program().remarks_of(dobra::scenario::make_state(model));
  if (geometry == Geometry::Include) json["restored"] = pieces_json(made.section);
  return json.dump(2) + '\n';
}

std::string blockwise_table(const model::Model& model) {
  const jigsaw::Blockwise& made = *model.blockwise;
  const bool rigid = is_rigid(made.how);
  std::string text = fmt::format("{:<28} {:>14}", "block", "shift [m]");
  const bool slid = !made.ties.empty();
  text += rigid  ? fmt::format(" {:>14} {:>14}\n", "raise [m]", "turn [deg]")
          : slid ? fmt::format(" {:>14}\n", "error [m]")
                 : "\n";
  for (const jigsaw::BlockRow& row : made.rows) {
    const auto cell = [](const std::optional<double>& value) {
      return fmt::format(" {:>14}", value ? fmt::format("{:.6g}", *value) : "-");
    };
    text += fmt::format("{:<28}{}{}\n", row.name, cell(row.shift),
                        rigid  ? cell(row.raise) + cell(row.turn)
                        : slid ? cell(row.shift_error)
                               : "");
  }
  if (made.how.jigsaw) {
    text += fmt::format("\n{:<28} {:>12} {:>12} {:>10} {:>12} {:>10} {:>10}\n", "fault", "gap [m2]", "overlap [m2]",
                        "dip [deg]", "shorter [m]", "misfit [m]", "error [m]");
    for (const jigsaw::RestoredFault& fault : made.faults) {
      text += fmt::format("{:<28}", fault.name);
      constexpr int widths[] = {12, 12, 10, 12, 10, 10};
      const int* width = widths;
      for (const core::RowCell& cell : core::cells_of(fault))
        text += fmt::format(" {:>{}}", cell.value ? fmt::format("{:.6g}", *cell.value) : "-", *width++);
      text += '\n';
    }
    text += fmt::format(
        "\nwidth {:.6g} m, restored {:.6g} m; shorter by {:.6g} m, of which {:.6g} m by folds and tilt "
        "of the blocks\n",
        made.widths.before, made.widths.after, made.widths.shortening(), made.widths.folding());
  }
  text += fmt::format("\n{:<28} {:>12} {:>12} {:>8}\n", "horizon", "before [m]", "after [m]", "[%]");
  for (const balance::LineLength& row : balance::whole_beds(made.lengths)) {
    text += fmt::format("{:<28} {:>12.3f} {:>12.3f} {:>8.3f}\n", row.name, row.length_before, row.length_after,
                        row.change_percent);
  }
  text += fmt::format("\n{:<28} {:>12} {:>12} {:>8}\n", "unit", "before [m2]", "after [m2]", "[%]");
  for (const balance::UnitRow& row : made.units) {
    text += fmt::format("{:<28} {:>12.6g} {:>12.6g} {:>8.3f}\n", row.name, row.area_before, row.area_after,
                        row.change_percent);
  }
  return text + '\n' + made.remarks.back() + '\n';
}

}  // namespace recon::cli
