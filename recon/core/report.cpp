#include "recon/core/report.h"

#include <algorithm>

#include "recon/section/palette.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace io = dobra::io;

void append(const std::vector<std::string>& more, std::vector<std::string>& remarks) {
  remarks.insert(remarks.end(), more.begin(), more.end());
}

void add_cells(const std::string& prefix, const std::vector<RowCell>& cells,
               std::vector<scenario::Quantity>& quantities) {
  for (const RowCell& cell : cells) {
    if (cell.value) quantities.push_back({prefix + cell.name, *cell.value, cell.unit});
  }
}

namespace {

io::lines::Feature line_feature(std::string name, std::string kind, std::vector<geom::Polyline> parts) {
  io::lines::Feature feature;
  feature.name = std::move(name);
  feature.kind = std::move(kind);
  feature.parts = std::move(parts);
  return feature;
}

}  // namespace

std::vector<io::lines::Feature> grid_features(const geom::Polyline& base, const unfold::Grid& grid,
                                              std::optional<geom::Point> pin) {
  std::vector<io::lines::Feature> features{line_feature("base", "base", {base})};
  for (std::size_t i = 0; i < grid.curves.size(); ++i) {
    if (grid.curves[i].pieces.empty()) continue;
    io::lines::Feature curve = line_feature("curve " + std::to_string(i + 1), "offset", grid.curves[i].pieces);
    curve.properties = {{"distance", grid.curves[i].distance}};
    features.push_back(std::move(curve));
  }
  if (!grid.rungs.empty()) features.push_back(line_feature("rungs", "rung", grid.rungs));
  if (pin) {
    io::lines::Feature feature = line_feature("pin", "pin", {{{*pin}, false}});
    feature.type = io::lines::FeatureType::Points;
    features.push_back(std::move(feature));
  }
  return features;
}

void add_feature(io::lines::FeatureType type, const std::string& name, const char* kind, std::size_t id,
                 geom::Polyline line, std::vector<io::lines::Feature>& features, Properties further) {
  // A jump of no length at a tear, or a bed squeezed to a point, must not make the file invalid.
  if (type != io::lines::FeatureType::Points) line = geom::without_repeated_points(std::move(line));
  const std::size_t least = type == io::lines::FeatureType::Polygons ? 3
                            : type == io::lines::FeatureType::Lines  ? 2
                                                                     : 1;
  if (line.points.size() < least) return;
  io::lines::Feature feature = line_feature(name, kind, {std::move(line)});
  feature.type = type;
  feature.properties = {{"id", static_cast<std::int64_t>(id)}};
  feature.properties.insert(feature.properties.end(), further.begin(), further.end());
  features.push_back(std::move(feature));
}

namespace {

/// What a piece of something, and a fault, says of itself beside name and kind.
Properties piece_properties(const std::string& whole) {
  return whole.empty() ? Properties{} : Properties{{"piece_of", whole}};
}

Properties line_properties(const section::SectionLine& line) {
  Properties properties = piece_properties(line.piece_of);
  if (line.order > 0) properties.emplace_back("order", static_cast<std::int64_t>(line.order));
  if (line.hanging_wall != section::HangingWall::Auto)
    properties.emplace_back("hanging_wall", std::string(section::hanging_wall_name(line.hanging_wall)));
  return properties;
}

}  // namespace

std::vector<io::lines::Feature> restored_features(const section::Section& section) {
  std::vector<io::lines::Feature> features;
  for (const section::Horizon& horizon : section.horizons) {
    const char* kind = horizon.role == section::BedRole::Growth ? "growth" : "horizon";
    add_feature(io::lines::FeatureType::Lines, horizon.name, kind, horizon.id.index(), horizon.line, features,
                piece_properties(horizon.piece_of));
  }
  for (const section::SectionLine& line : section.lines)
    add_feature(io::lines::FeatureType::Lines, line.name, kind_name(line.kind), line.id.index(), line.line, features,
                line_properties(line));
  for (const section::Unit& unit : section.units)
    add_feature(io::lines::FeatureType::Polygons, unit.name, "unit", unit.id.index(), unit.contour, features,
                piece_properties(unit.piece_of));
  for (const section::Marker& marker : section.markers)
    add_feature(io::lines::FeatureType::Points, marker.name, "marker", marker.id.index(), {marker.points, false},
                features);
  return features;
}

namespace {

/// Adds another piece of the unit.
void add_piece(const balance::UnitRow& piece, balance::UnitRow& whole) {
  ++whole.pieces;
  if (whole.dilatation && piece.dilatation) {
    balance::Range& all = *whole.dilatation;
    const balance::Range& more = *piece.dilatation;
    all.mean = (all.mean * whole.area_before + more.mean * piece.area_before) / (whole.area_before + piece.area_before);
    all.least = std::min(all.least, more.least);
    all.greatest = std::max(all.greatest, more.greatest);
  }
  whole.area_before += piece.area_before;
  whole.area_after += piece.area_after;
  whole.change_percent = 100.0 * (whole.area_after - whole.area_before) / whole.area_before;
}

}  // namespace

std::vector<balance::UnitRow> unit_rows(const model::Model& model) {
  const std::vector<balance::UnitRow>& rows = model.restoration->ledger.units;
  const section::Palette palette(model.section);
  std::vector<balance::UnitRow> wholes;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool polygon = i < model.section.units.size();
    const std::string& name = polygon ? palette.whole_of(model.section.units[i].id) : rows[i].name;
    const auto whole =
        std::find_if(wholes.begin(), wholes.end(), [&](const balance::UnitRow& w) { return w.name == name; });
    if (polygon && whole != wholes.end()) {
      add_piece(rows[i], *whole);
      continue;
    }
    wholes.push_back(rows[i]);
    wholes.back().name = name;
  }
  return wholes;
}

std::vector<RowCell> cells_of(const jigsaw::RestoredFault& fault) {
  const auto if_measured = [&](double value) { return fault.measured ? std::optional(value) : std::nullopt; };
  return {{"gap_area", "m2", if_measured(fault.opening.gap)},
          {"overlap_area", "m2", if_measured(fault.opening.overlap)},
          {"dip_restored", "deg", fault.dip},
          {"shortening", "m", fault.shortening},
          {"misfit", "m", fault.misfit},
          {"slide_error", "m", fault.slide_error}};
}

std::vector<RowCell> cells_of(const balance::LineLength& row) {
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

std::vector<RowCell> cells_of(const balance::UnitRow& row) {
  const auto part = [](const std::optional<balance::Range>& range, double balance::Range::*member) {
    return range ? std::optional((*range).*member) : std::nullopt;
  };
  const auto percent = [&](double balance::Range::*member) {
    return row.dilatation ? std::optional(100.0 * (*row.dilatation).*member) : std::nullopt;
  };
  const auto pieces = row.pieces > 1 ? std::optional(count_of(row.pieces)) : std::nullopt;
  return {{"pieces", "", pieces},
          {"area_before", "m2", row.area_before},
          {"area_after", "m2", row.area_after},
          {"area_change_percent", "%", row.change_percent},
          {"thickness_min_before", "m", part(row.thickness_before, &balance::Range::least)},
          {"thickness_mean_before", "m", part(row.thickness_before, &balance::Range::mean)},
          {"thickness_max_before", "m", part(row.thickness_before, &balance::Range::greatest)},
          {"thickness_min_after", "m", part(row.thickness_after, &balance::Range::least)},
          {"thickness_mean_after", "m", part(row.thickness_after, &balance::Range::mean)},
          {"thickness_max_after", "m", part(row.thickness_after, &balance::Range::greatest)},
          {"dilatation_min_percent", "%", percent(&balance::Range::least)},
          {"dilatation_mean_percent", "%", percent(&balance::Range::mean)},
          {"dilatation_max_percent", "%", percent(&balance::Range::greatest)}};
}

std::vector<RowCell> cells_of(const balance::BedBalance& row) {
  return {{"length", "m", row.length},
          {"width", "m", row.width},
          {"shortening", "m", row.shortening},
          {"level", "m", row.level},
          {"excess_area", "m2", row.excess_area},
          {"detachment_depth", "m", row.depth},
          {"layer_strain", "", row.layer_strain}};
}

std::vector<RowCell> cells_of(const balance::AreaDepthFit& fit) {
  return {{"displacement", "m", fit.displacement},
          {"displacement_error", "m", fit.displacement_error},
          {"detachment", "m", fit.detachment},
          {"detachment_error", "m", fit.detachment_error},
          {"r_squared", "", fit.r_squared}};
}

scenario::DataTable table_of_cells(const char* name, const char* what, const std::vector<RowCell>& columns) {
  scenario::DataTable table{name, {what}, {}};
  for (const RowCell& cell : columns) {
    const std::string title = cell.name;
    table.columns.push_back(title.ends_with("_percent") ? title.substr(0, title.size() - 8) + " [%]"
                            : *cell.unit == '\0'        ? title
                                                        : title + " [" + cell.unit + "]");
  }
  return table;
}

void add_row(const std::string& name, const std::vector<RowCell>& cells, scenario::DataTable& table) {
  std::vector<std::variant<double, std::string>> row{name};
  for (const RowCell& cell : cells) {
    if (cell.value) {
      row.emplace_back(*cell.value);
    } else {
      row.emplace_back(std::string());
    }
  }
  table.rows.push_back(std::move(row));
}

}  // namespace recon::core
