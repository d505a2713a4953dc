#include "recon/core/report.h"

#include <algorithm>

#include "recon/core/palette.h"
#include "recon/core/section_faces.h"
#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/geojson.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace io = dobra::io;

namespace {

double number(std::size_t count) { return static_cast<double>(count); }

void add_grid_quantities(const SourceGrid& source, std::vector<scenario::Quantity>& quantities) {
  quantities.push_back({"grid.curves", number(source.grid.curves.size()), ""});
  quantities.push_back({"grid.rungs", number(source.grid.rungs.size()), ""});
  quantities.push_back({"grid.vanished", number(source.grid.vanished), ""});
  quantities.push_back({"grid.deepest", source.deepest, "m"});
  quantities.push_back({"grid.last_distance", source.options.distances.back(), "m"});
}

void add_cells(const std::string& prefix, const std::vector<RowCell>& cells,
               std::vector<scenario::Quantity>& quantities) {
  for (const RowCell& cell : cells) {
    if (cell.value) quantities.push_back({prefix + cell.name, *cell.value, cell.unit});
  }
}

void add_restored_quantities(const Model& model, std::vector<scenario::Quantity>& quantities) {
  const Restoration& restoration = *model.restoration;
  std::size_t points = 0, outside = 0, beyond = 0, not_reversible = 0, tears = 0;
  double torn = 0.0;
  for (std::size_t i = 0; i < restoration.lengths.size(); ++i) {
    const LineLength& row = restoration.lengths[i];
    add_cells("horizon." + row.name + ".", cells_of(row), quantities);
    if (row.horizon == model.source->top) {
      add_cells("top.", cells_of(row), quantities);
      quantities.push_back({"shortening", row.shortening, "m"});
      quantities.push_back({"shortening_percent", row.shortening_percent, "%"});
    }
    const MappedLine& line = restoration.lines[i];
    points += line.given.size();
    outside += line.without_column;
    beyond += line.beyond_ends;
    not_reversible += line.not_reversible;
    tears += line.tears.size();
    torn += row.torn;
  }
  for (const LineLength& row : totals_of(restoration.lengths))
    add_cells("horizon." + row.name + ".", cells_of(row), quantities);
  const std::vector<UnitRow> units = unit_rows(model);
  for (const UnitRow& row : units) add_cells("unit." + row.name + ".", cells_of(row), quantities);
  for (const UnitRow& row : restoration.ledger.units) {
    const auto same = [&](const UnitRow& unit) { return unit.name == row.name; };
    if (std::none_of(units.begin(), units.end(), same))
      add_cells("unit." + row.name + ".", cells_of(row), quantities);
  }
  quantities.push_back({"points", number(points), ""});
  quantities.push_back({"points_outside", number(outside), ""});
  quantities.push_back({"points_beyond_ends", number(beyond), ""});
  quantities.push_back({"points_not_reversible", number(not_reversible), ""});
  quantities.push_back({"tears", number(tears), ""});
  quantities.push_back({"torn", torn, "m"});
  quantities.push_back({"lean_left", restoration.lean_left, ""});
  quantities.push_back({"lean_right", restoration.lean_right, ""});
  const Balance& balance = restoration.balance;
  quantities.push_back({"greatest_change_percent", balance.greatest_change_percent, "%"});
  quantities.push_back({"greatest_area_change_percent", balance.greatest_area_change_percent, "%"});
  quantities.push_back({"inconsistency_percent", balance.consistency.worst.percent, "%"});
  quantities.push_back({"balanced", balance.balanced ? 1.0 : 0.0, ""});
}

void add_balance_quantities(const Model& model, std::vector<scenario::Quantity>& quantities) {
  if (model.monte_carlo) {
    for (const Spread& spread : model.monte_carlo->spreads) {
      const std::string prefix = "error." + spread.name + '.';
      quantities.push_back({prefix + "mean", spread.mean, spread.unit});
      quantities.push_back({prefix + "deviation", spread.deviation, spread.unit});
      quantities.push_back({prefix + "low", spread.low, spread.unit});
      quantities.push_back({prefix + "median", spread.median, spread.unit});
      quantities.push_back({prefix + "high", spread.high, spread.unit});
    }
    quantities.push_back({"error.failed", number(model.monte_carlo->failed), ""});
    quantities.push_back({"error.balanced_share", model.monte_carlo->balanced_share, ""});
  }
  if (model.area_depth) {
    for (const BedBalance& bed : model.area_depth->beds) add_cells("bed." + bed.name + '.', cells_of(bed), quantities);
    for (const LayerClass& layer : model.area_depth->layers)
      quantities.push_back({"layer." + layer.name + ".isogon_index", layer.fold.index, ""});
    if (const auto& fit = model.area_depth->fit) {
      add_cells("", cells_of(*fit), quantities);
    }
    quantities.push_back({"bed_inconsistency_percent", model.area_depth->consistency.worst.percent, "%"});
  }
  if (model.area_balance) {
    const AreaBalance& balance = *model.area_balance;
    const auto add = [&](const std::string& name, const WithError& number_with, const char* unit) {
      quantities.push_back({name, number_with.value, unit});
      quantities.push_back({name + "_error", number_with.error, unit});
      quantities.push_back({name + "_most", number_with.most, unit});
    };
    add("area", balance.area, "m2");
    add("initial_width", balance.initial_width, "m");
    add("width", balance.width, "m");
    add("area_shortening", balance.shortening, "m");
    add("area_shortening_percent", balance.percent, "%");
  }
}

io::Feature line_feature(std::string name, std::string kind, std::vector<geom::Polyline> parts) {
  io::Feature feature;
  feature.name = std::move(name);
  feature.kind = std::move(kind);
  feature.parts = std::move(parts);
  return feature;
}

std::vector<io::Feature> grid_features(const geom::Polyline& base, const Grid& grid, geom::Point pin, bool has_pin) {
  std::vector<io::Feature> features{line_feature("base", "base", {base})};
  for (std::size_t i = 0; i < grid.curves.size(); ++i) {
    if (grid.curves[i].pieces.empty()) continue;
    io::Feature curve = line_feature("curve " + std::to_string(i + 1), "offset", grid.curves[i].pieces);
    curve.properties = {{"distance", grid.curves[i].distance}};
    features.push_back(std::move(curve));
  }
  if (!grid.rungs.empty()) features.push_back(line_feature("rungs", "rung", grid.rungs));
  if (has_pin) {
    io::Feature feature = line_feature("pin", "pin", {{{pin}, false}});
    feature.type = io::FeatureType::Points;
    features.push_back(std::move(feature));
  }
  return features;
}

void add_feature(io::FeatureType type, const std::string& name, const char* kind, std::size_t id, geom::Polyline line,
                 std::vector<io::Feature>& features) {
  // A jump of no length at a tear, or a bed squeezed to a point, must not make the file invalid.
  if (type != io::FeatureType::Points) line = geom::without_repeated_points(std::move(line));
  const std::size_t least = type == io::FeatureType::Polygons ? 3 : type == io::FeatureType::Lines ? 2 : 1;
  if (line.points.size() < least) return;
  io::Feature feature = line_feature(name, kind, {std::move(line)});
  feature.type = type;
  feature.properties = {{"id", static_cast<std::int64_t>(id)}};
  features.push_back(std::move(feature));
}

}  // namespace

std::vector<io::Feature> restored_features(const Section& section) {
  std::vector<io::Feature> features;
  for (const Horizon& horizon : section.horizons)
    add_feature(io::FeatureType::Lines, horizon.name, "horizon", horizon.id.index(), horizon.line, features);
  for (const SectionLine& line : section.lines)
    add_feature(io::FeatureType::Lines, line.name, kind_name(line.kind), line.id.index(), line.line, features);
  for (const Unit& unit : section.units)
    add_feature(io::FeatureType::Polygons, unit.name, "unit", unit.id.index(), unit.contour, features);
  for (const Marker& marker : section.markers)
    add_feature(io::FeatureType::Points, marker.name, "marker", marker.id.index(), {marker.points, false}, features);
  return features;
}

namespace {

/// Every bed and unit in every state that the chain has gone through, and what changed since the input.
scenario::DataTable stages_table(const std::vector<const Stage*>& chain) {
  scenario::DataTable table{"stages", {"state", "kind", "name", "before [m or m2]", "after", "change since input [%]"}, {}};
  for (std::size_t k = 1; k <= chain.size(); ++k) {
    const Comparison whole = compare(chain, 0, k);
    const auto add = [&](const char* kind, const std::vector<Compared>& rows) {
      for (const Compared& row : rows)
        table.rows.push_back({number(k), kind, row.name, row.before, row.after, row.change_percent()});
    };
    add("horizon", whole.beds);
    add("unit", whole.units);
  }
  return table;
}

scenario::DataTable carried_table(const CarriedLines& carried) {
  scenario::DataTable table{
      "carried", {"line", "x before [m]", "z before [m]", "x after [m]", "z after [m]", "way back misses [m]"}, {}};
  for (std::size_t l = 0; l < carried.lines.size(); ++l) {
    const CarriedLine& line = carried.lines[l];
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const geom::Point before = line.before.points[i];
      const CarriedPoint& after = line.points[i];
      table.rows.push_back({number(l + 1), before.x, before.y, after.at.x, after.at.y, after.misses});
    }
  }
  return table;
}

std::vector<io::Feature> carried_features(const CarriedLines& carried) {
  std::vector<io::Feature> features;
  for (std::size_t l = 0; l < carried.lines.size(); ++l) {
    const auto add = [&](const geom::Polyline& line, const char* kind) {
      const io::FeatureType type = line.closed              ? io::FeatureType::Polygons
                                   : line.points.size() > 1 ? io::FeatureType::Lines
                                                            : io::FeatureType::Points;
      add_feature(type, "line " + std::to_string(l + 1), kind, l, line, features);
    };
    add(carried.lines[l].before, "before");
    add(carried.lines[l].after, "after");
  }
  return features;
}

scenario::DataTable strain_table(const std::vector<Strain>& strains) {
  scenario::DataTable table{
      "strain",
      {"x [m]", "z [m]", "dilatation [%]", "greatest stretch", "least stretch", "direction [deg]", "rotation [deg]"},
      {}};
  for (const Strain& s : strains) {
    table.rows.push_back(
        {s.at.x, s.at.y, 100.0 * s.dilatation, s.greatest, s.least, s.direction.degrees(), s.rotation.degrees()});
  }
  return table;
}

/// A table of rows that have a name and cells.
template <class Row>
scenario::DataTable row_table(const char* name, const char* what, const std::vector<Row>& rows) {
  scenario::DataTable table{name, {what}, {}};
  for (const RowCell& cell : cells_of(Row{})) {
    const std::string title = cell.name;
    table.columns.push_back(title.ends_with("_percent") ? title.substr(0, title.size() - 8) + " [%]"
                            : *cell.unit == '\0'        ? title
                                                        : title + " [" + cell.unit + "]");
  }
  for (const Row& row : rows) {
    std::vector<std::variant<double, std::string>> cells{row.name};
    for (const RowCell& cell : cells_of(row)) {
      if (cell.value) {
        cells.emplace_back(*cell.value);
      } else {
        cells.emplace_back(std::string());
      }
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string restored_csv(const Restoration& restoration) {
  std::string text = "horizon,x [m],z [m],x_before [m],z_before [m],depth [m]\n";
  for (std::size_t h = 0; h < restoration.lines.size(); ++h) {
    const MappedLine& line = restoration.lines[h];
    for (std::size_t i = 0; i < line.names.size(); ++i) {
      text += csv_field(restoration.section.horizons[h].name);
      const geom::Point after = line.after.points[i];
      const geom::Point before = line.before.points[i];
      for (const double value : {after.x, after.y, before.x, before.y, line.names[i].depth})
        text += ',' + base::number_text(value);
      text += '\n';
    }
  }
  return text;
}

}  // namespace

std::vector<scenario::Quantity> quantities_of(const Model& model) {
  std::vector<scenario::Quantity> quantities{{"horizons", number(model.section.horizons.size()), ""}};
  if (!model.restoration) {
    for (const Horizon& horizon : model.section.horizons) {
      quantities.push_back({"horizon." + horizon.name + ".length_before", geom::length(horizon.line), "m"});
    }
  }
  if (model.section.faces) {
    double units = 0.0;
    for (const RockUnit& unit : model.section.faces->units) units += unit.area;
    quantities.push_back({"section.area", model.section.faces->area, "m2"});
    quantities.push_back({"section.units_area", units, "m2"});
    quantities.push_back({"section.misfits", number(model.section.faces->misfits.size()), ""});
  }
  if (model.source) add_grid_quantities(*model.source, quantities);
  if (model.target) {
    quantities.push_back({"target.curves", number(model.target->grid.curves.size()), ""});
    quantities.push_back({"target.extended", model.target->extended, "m"});
    quantities.push_back({"columns", number(model.target->map.source().inner_count()), ""});
  }
  if (model.restoration) add_restored_quantities(model, quantities);
  if (!model.earlier.empty()) {
    quantities.push_back({"stages", number(model.earlier.size()), ""});
    const auto chain = restored_stages(model);
    const Comparison whole = compare(chain, 0, chain.size());
    for (const Compared& row : whole.beds)
      quantities.push_back({"since_input.horizon." + row.name + ".change_percent", row.change_percent(), "%"});
    for (const Compared& row : whole.units)
      quantities.push_back({"since_input.unit." + row.name + ".change_percent", row.change_percent(), "%"});
  }
  add_balance_quantities(model, quantities);
  return quantities;
}

namespace {

/// Adds another piece of the unit.
void add_piece(const UnitRow& piece, UnitRow& whole) {
  ++whole.pieces;
  if (whole.dilatation && piece.dilatation) {
    Range& all = *whole.dilatation;
    const Range& more = *piece.dilatation;
    all.mean = (all.mean * whole.area_before + more.mean * piece.area_before) / (whole.area_before + piece.area_before);
    all.least = std::min(all.least, more.least);
    all.greatest = std::max(all.greatest, more.greatest);
  }
  whole.area_before += piece.area_before;
  whole.area_after += piece.area_after;
  whole.change_percent = 100.0 * (whole.area_after - whole.area_before) / whole.area_before;
}

}  // namespace

std::vector<UnitRow> unit_rows(const Model& model) {
  const std::vector<UnitRow>& rows = model.restoration->ledger.units;
  const Palette palette(model.section);
  std::vector<UnitRow> wholes;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool polygon = i < model.section.units.size();
    const std::string& name = polygon ? palette.whole_of(model.section.units[i].id) : rows[i].name;
    const auto whole = std::find_if(wholes.begin(), wholes.end(), [&](const UnitRow& w) { return w.name == name; });
    if (polygon && whole != wholes.end()) {
      add_piece(rows[i], *whole);
      continue;
    }
    wholes.push_back(rows[i]);
    wholes.back().name = name;
  }
  return wholes;
}

std::vector<RowCell> cells_of(const LineLength& row) {
  return {{"length_before", "m", row.length_before},
          {"length_after", "m", row.length_after},
          {"change_percent", "%", row.change_percent},
          {"width_before", "m", row.width_before},
          {"width_after", "m", row.width_after},
          {"shortening", "m", row.shortening},
          {"shortening_percent", "%", row.shortening_percent},
          {"torn", "m", row.torn},
          {"depth_min", "m", row.depth_min},
          {"depth_mean", "m", row.depth_mean},
          {"depth_max", "m", row.depth_max}};
}

std::vector<RowCell> cells_of(const UnitRow& row) {
  const auto part = [](const std::optional<Range>& range, double Range::*member) {
    return range ? std::optional((*range).*member) : std::nullopt;
  };
  const auto percent = [&](double Range::*member) {
    return row.dilatation ? std::optional(100.0 * (*row.dilatation).*member) : std::nullopt;
  };
  const auto pieces = row.pieces > 1 ? std::optional(number(row.pieces)) : std::nullopt;
  return {{"pieces", "", pieces},
          {"area_before", "m2", row.area_before},
          {"area_after", "m2", row.area_after},
          {"area_change_percent", "%", row.change_percent},
          {"thickness_min_before", "m", part(row.thickness_before, &Range::least)},
          {"thickness_mean_before", "m", part(row.thickness_before, &Range::mean)},
          {"thickness_max_before", "m", part(row.thickness_before, &Range::greatest)},
          {"thickness_min_after", "m", part(row.thickness_after, &Range::least)},
          {"thickness_mean_after", "m", part(row.thickness_after, &Range::mean)},
          {"thickness_max_after", "m", part(row.thickness_after, &Range::greatest)},
          {"dilatation_min_percent", "%", percent(&Range::least)},
          {"dilatation_mean_percent", "%", percent(&Range::mean)},
          {"dilatation_max_percent", "%", percent(&Range::greatest)}};
}

std::vector<RowCell> cells_of(const BedBalance& row) {
  return {{"length", "m", row.length},
          {"width", "m", row.width},
          {"shortening", "m", row.shortening},
          {"level", "m", row.level},
          {"excess_area", "m2", row.excess_area},
          {"detachment_depth", "m", row.depth},
          {"layer_strain", "", row.layer_strain}};
}

std::vector<RowCell> cells_of(const AreaDepthFit& fit) {
  return {{"displacement", "m", fit.displacement},
          {"displacement_error", "m", fit.displacement_error},
          {"detachment", "m", fit.detachment},
          {"detachment_error", "m", fit.detachment_error},
          {"r_squared", "", fit.r_squared}};
}

std::vector<scenario::DataTable> tables_of(const Model& model) {
  std::vector<scenario::DataTable> tables;
  if (model.restoration) {
    tables.push_back(row_table("line_length", "horizon", model.restoration->lengths));
    if (const auto totals = totals_of(model.restoration->lengths); !totals.empty())
      tables.push_back(row_table("horizons_in_pieces", "horizon", totals));
    tables.push_back(row_table("units", "unit", unit_rows(model)));
    tables.push_back(strain_table(model.restoration->ledger.strains));
  }
  if (!model.earlier.empty()) tables.push_back(stages_table(restored_stages(model)));
  if (model.carried) tables.push_back(carried_table(*model.carried));
  if (model.monte_carlo) {
    scenario::DataTable table{"error_bars", {"quantity", "unit", "mean", "deviation", "low", "median", "high"}, {}};
    for (const Spread& s : model.monte_carlo->spreads)
      table.rows.push_back({s.name, s.unit, s.mean, s.deviation, s.low, s.median, s.high});
    tables.push_back(std::move(table));
  }
  if (model.area_depth) tables.push_back(row_table("area_depth", "horizon", model.area_depth->beds));
  return tables;
}

std::vector<std::string> remarks_of(const Model& model) {
  std::vector<std::string> remarks = model.remarks;
  const auto add = [&](const std::vector<std::string>& more) {
    remarks.insert(remarks.end(), more.begin(), more.end());
  };
  for (std::size_t k = 0; k < model.earlier.size(); ++k) {
    for (const std::string& remark : model.earlier[k]->restoration->remarks)
      remarks.push_back("restoration " + std::to_string(k + 1) + ": " + remark);
  }
  if (model.source) add(model.source->remarks);
  if (model.target) add(model.target->remarks);
  if (model.restoration) add(model.restoration->remarks);
  if (model.monte_carlo) add(model.monte_carlo->remarks);
  if (model.area_depth) add(model.area_depth->remarks);
  if (model.carried) add(model.carried->remarks);
  return remarks;
}

std::vector<scenario::Output> outputs_of(const std::shared_ptr<const Model>& model) {
  std::vector<scenario::Output> outputs;
  using Path = std::filesystem::path;
  if (model->source) {
    outputs.push_back({"source_grid.geojson", [model](const Path& path) {
                         const bool pinned = model->target.has_value();
                         return io::write_geojson(
                             path.string(), grid_features(model->source->base, model->source->grid,
                                                          pinned ? model->target->source_pin : geom::Point{}, pinned));
                       }});
  }
  if (model->target) {
    outputs.push_back({"target_grid.geojson", [model](const Path& path) {
                         return io::write_geojson(
                             path.string(), grid_features(model->target->map.target().base_line(), model->target->grid,
                                                          model->target->target_pin, true));
                       }});
  }
  if (model->restoration) {
    outputs.push_back({"restored.geojson", [model](const Path& path) {
                         return io::write_geojson(path.string(), restored_features(model->restoration->section));
                       }});
    outputs.push_back({"restored.csv",
                       [model](const Path& path) { return io::write_file(path, restored_csv(*model->restoration)); }});
  }
  if (model->carried) {
    outputs.push_back({"carried.geojson", [model](const Path& path) {
                         return io::write_geojson(path.string(), carried_features(*model->carried));
                       }});
  }
  return outputs;
}

}  // namespace recon::core
