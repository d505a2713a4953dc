#pragma once
// What the steps of RECON have in common where they tell of a model in numbers, tables, remarks and files.

#include <optional>
#include <string>
#include <vector>

#include "recon/balance/area_depth.h"
#include "recon/model/model.h"
#include "shared/io/lines/feature.h"
#include "shared/scenario/program.h"

namespace recon::core {

inline double count_of(std::size_t count) { return static_cast<double>(count); }
void append(const std::vector<std::string>& more, std::vector<std::string>& remarks);

/// The rows of the ledger, one a unit: polygons that are pieces of one are summed.  @pre the model is restored.
std::vector<balance::UnitRow> unit_rows(const model::Model& model);

/// The names, values and units of a row, in the order of its table's columns; nothing where there is no value.
struct RowCell {
  const char* name;
  const char* unit;
  std::optional<double> value;
};
std::vector<RowCell> cells_of(const balance::UnitRow& row);
std::vector<RowCell> cells_of(const balance::BedBalance& row);
std::vector<RowCell> cells_of(const balance::LineLength& row);
std::vector<RowCell> cells_of(const balance::AreaDepthFit& fit);
std::vector<RowCell> cells_of(const jigsaw::RestoredFault& fault);

/// Quantities "prefix + name" of what has a value.
void add_cells(const std::string& prefix, const std::vector<RowCell>& cells,
               std::vector<dobra::scenario::Quantity>& quantities);

/// A table without rows yet, and a row of it.
dobra::scenario::DataTable table_of_cells(const char* name, const char* what, const std::vector<RowCell>& columns);
void add_row(const std::string& name, const std::vector<RowCell>& cells, dobra::scenario::DataTable& table);
/// A table of rows that have a name and cells.
template <class Row>
dobra::scenario::DataTable row_table(const char* name, const char* what, const std::vector<Row>& rows) {
  dobra::scenario::DataTable table = table_of_cells(name, what, cells_of(Row{}));
  for (const Row& row : rows) add_row(row.name, cells_of(row), table);
  return table;
}

using Properties = std::vector<std::pair<std::string, dobra::io::lines::PropertyValue>>;
/// A line, polygon or point for a file, but for those of no length.
void add_feature(dobra::io::lines::FeatureType type, const std::string& name, const char* kind, std::size_t id,
                 geom::Polyline line, std::vector<dobra::io::lines::Feature>& features, Properties further = {});
/// All lines, polygons and points of a section with their names, kinds and ids.
std::vector<dobra::io::lines::Feature> restored_features(const section::Section& section);
/// Base, curves, rungs and pin.
std::vector<dobra::io::lines::Feature> grid_features(const geom::Polyline& base, const unfold::Grid& grid,
                                                     std::optional<geom::Point> pin);

}  // namespace recon::core
