#include "recon/core/report.h"

#include <array>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/geojson.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace io = dobra::io;

namespace {

struct Column {
  const char* name;
  const char* unit;
  double LineLength::*member;
};

constexpr std::array<Column, 11> line_length_columns{{{"length_before", "m", &LineLength::length_before},
                                                      {"length_after", "m", &LineLength::length_after},
                                                      {"change_percent", "%", &LineLength::change_percent},
                                                      {"width_before", "m", &LineLength::width_before},
                                                      {"width_after", "m", &LineLength::width_after},
                                                      {"shortening", "m", &LineLength::shortening},
                                                      {"shortening_percent", "%", &LineLength::shortening_percent},
                                                      {"torn", "m", &LineLength::torn},
                                                      {"depth_min", "m", &LineLength::depth_min},
                                                      {"depth_mean", "m", &LineLength::depth_mean},
                                                      {"depth_max", "m", &LineLength::depth_max}}};

double number(std::size_t count) { return static_cast<double>(count); }

void add_grid_quantities(const SourceGrid& source, std::vector<scenario::Quantity>& quantities) {
  quantities.push_back({"grid.curves", number(source.grid.curves.size()), ""});
  quantities.push_back({"grid.rungs", number(source.grid.rungs.size()), ""});
  quantities.push_back({"grid.vanished", number(source.grid.vanished), ""});
  quantities.push_back({"grid.deepest", source.deepest, "m"});
  quantities.push_back({"grid.last_distance", source.options.distances.back(), "m"});
}

void add_restored_quantities(const Model& model, std::vector<scenario::Quantity>& quantities) {
  const Restoration& restoration = *model.restoration;
  const auto add_row = [&](const std::string& prefix, const LineLength& row) {
    for (const Column& column : line_length_columns)
      quantities.push_back({prefix + column.name, row.*column.member, column.unit});
  };
  std::size_t points = 0, outside = 0, beyond = 0, not_reversible = 0, tears = 0;
  double torn = 0.0;
  for (std::size_t i = 0; i < restoration.lengths.size(); ++i) {
    const LineLength& row = restoration.lengths[i];
    add_row("horizon." + row.name + ".", row);
    if (row.horizon == model.source->top) {
      add_row("top.", row);
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
  quantities.push_back({"points", number(points), ""});
  quantities.push_back({"points_outside", number(outside), ""});
  quantities.push_back({"points_beyond_ends", number(beyond), ""});
  quantities.push_back({"points_not_reversible", number(not_reversible), ""});
  quantities.push_back({"tears", number(tears), ""});
  quantities.push_back({"torn", torn, "m"});
  quantities.push_back({"greatest_change_percent", restoration.balance.greatest_change_percent, "%"});
  quantities.push_back({"balanced", restoration.balance.balanced ? 1.0 : 0.0, ""});
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

std::vector<io::Feature> restored_features(const Restoration& restoration) {
  std::vector<io::Feature> features;
  for (const Horizon& horizon : restoration.section.horizons) {
    // A jump of no length at a tear, or a bed squeezed to a point, must not make the file invalid.
    const geom::Polyline line = geom::without_repeated_points(horizon.line);
    if (line.points.size() < 2) continue;
    io::Feature feature = line_feature(horizon.name, "horizon", {line});
    feature.properties = {{"id", static_cast<std::int64_t>(horizon.id.index())}};
    features.push_back(std::move(feature));
  }
  return features;
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
  if (model.source) add_grid_quantities(*model.source, quantities);
  if (model.target) {
    quantities.push_back({"target.curves", number(model.target->grid.curves.size()), ""});
    quantities.push_back({"target.extended", model.target->extended, "m"});
    quantities.push_back({"columns", number(model.target->map.source().inner_count()), ""});
  }
  if (model.restoration) add_restored_quantities(model, quantities);
  return quantities;
}

std::vector<scenario::DataTable> tables_of(const Model& model) {
  if (!model.restoration) return {};
  scenario::DataTable table{"line_length", {"horizon"}, {}};
  for (const Column& column : line_length_columns) {
    const std::string name = column.name;
    table.columns.push_back(name.ends_with("_percent") ? name.substr(0, name.size() - 8) + " [%]"
                                                       : name + " [" + column.unit + "]");
  }
  for (const LineLength& row : model.restoration->lengths) {
    std::vector<std::variant<double, std::string>> cells{row.name};
    for (const Column& column : line_length_columns) cells.emplace_back(row.*column.member);
    table.rows.push_back(std::move(cells));
  }
  return {table};
}

std::vector<std::string> remarks_of(const Model& model) {
  std::vector<std::string> remarks = model.remarks;
  const auto add = [&](const std::vector<std::string>& more) {
    remarks.insert(remarks.end(), more.begin(), more.end());
  };
  if (model.source) add(model.source->remarks);
  if (model.target) add(model.target->remarks);
  if (model.restoration) add(model.restoration->remarks);
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
                         return io::write_geojson(path.string(), restored_features(*model->restoration));
                       }});
    outputs.push_back({"restored.csv",
                       [model](const Path& path) { return io::write_file(path, restored_csv(*model->restoration)); }});
  }
  return outputs;
}

}  // namespace recon::core
