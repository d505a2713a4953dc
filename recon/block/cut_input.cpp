#include "recon/block/cut_input.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/block/cut.h"
#include "recon/block/unit_map.h"
#include "shared/io/lines/section_plane.h"

namespace recon::block {
namespace {

using base::Error;
using base::ErrorCode;
using dobra::scenario::Table;

Error bad(const std::string& what) { return {ErrorCode::BadValue, what, base::Place{.item = "input"}}; }

Table row_of(const std::string& name, geom::Polyline line) {
  Table row;
  row.set("name", name);
  if (line.closed) line.points.push_back(line.points.front());
  row.set("points", std::move(line.points));
  return row;
}

/// One list of tables after the other.
class Tables {
 public:
  void add(const std::string& key, Table row) {
    auto at = std::find_if(tables_.begin(), tables_.end(), [&](const auto& table) { return table.first == key; });
    if (at == tables_.end()) at = tables_.insert(at, {key, {}});
    at->second.push_back(std::move(row));
  }
  void write(Table& input) {
    for (auto& [key, rows] : tables_) input.set(key, std::move(rows));
  }

 private:
  std::vector<std::pair<std::string, std::vector<Table>>> tables_;
};

Table fault_row(const section::SectionLine& line) {
  Table row = row_of(line.name, line.line);
  if (!line.piece_of.empty()) row.set("piece_of", line.piece_of);
  if (line.order > 0) row.set("order", static_cast<std::int64_t>(line.order));
  if (line.hanging_wall != section::HangingWall::Auto)
    row.set("hanging_wall", std::string(section::hanging_wall_name(line.hanging_wall)));
  return row;
}

}  // namespace

base::Result<input::ReadSection> cut_through(input::ReadSection read, const input::SectionInput& wanted) {
  if (!wanted.along_strike) return bad("cut: say how far the section's beds go on, with along_strike = a length");
  const std::vector<double>& at = wanted.cut;
  if (at.size() != 4) return bad("cut: give four numbers: x and y of its beginning and its end on the map");
  DOBRA_TRY(const Block block, extrude(read.section, {*wanted.along_strike, read.trace}));
  const auto frame = cut_over(block, {at[0], at[1]}, {at[2], at[3]});
  if (!frame) return bad("cut: " + frame.error().message);
  DOBRA_TRY(BlockCut made, cut(block, *frame));
  if (made.empty()) {
    return Error{ErrorCode::BadSection, "cut: " + made.findings.front().message, base::Place{.item = "input"}};
  }
  read.section = std::move(made.section);
  if (!read.section.faces)
    return Error{ErrorCode::BadSection, made.findings.back().message, made.findings.back().place};
  std::erase_if(read.remarks, [&](const std::string& remark) {
    const auto place = read.places.find(remark);
    return place != read.places.end() && is_told(place->second, block.findings);
  });
  for (const base::Finding& finding : block.findings) read.remarks.push_back(finding.message);
  for (const base::Finding& finding : made.findings) read.remarks.push_back("cut: " + finding.message);
  DOBRA_TRY(read.trace, dobra::io::lines::trace_between({at[0], at[1]}, {at[2], at[3]}));
  return read;
}

Table input_table(const section::Section& section) {
  Tables tables;
  for (const section::Horizon& horizon : section.horizons) {
    Table row = row_of(horizon.name, horizon.line);
    if (!horizon.piece_of.empty()) row.set("piece_of", horizon.piece_of);
    if (horizon.role == section::BedRole::Growth) row.set("role", std::string("growth"));
    tables.add("horizon", std::move(row));
  }
  for (const section::SectionLine& line : section.lines) {
    const bool fault = line.kind == section::LineKind::Fault;
    tables.add(kind_name(line.kind), fault ? fault_row(line) : row_of(line.name, line.line));
  }
  for (const section::Unit& unit : section.units) {
    Table row = row_of(unit.name, unit.contour);
    if (!unit.piece_of.empty()) row.set("piece_of", unit.piece_of);
    tables.add("polygon", std::move(row));
  }
  for (const section::Marker& marker : section.markers)
    tables.add("marker", row_of(marker.name, geom::Polyline{marker.points, false}));
  if (section.border) tables.add("border", row_of("border", *section.border));
  for (const section::BlockName& block : section.block_names) {
    Table row;
    row.set("name", block.name);
    row.set("point", block.at);
    if (!block.part_of.empty()) row.set("part_of", block.part_of);
    tables.add("block", std::move(row));
  }
  Table input;
  if (!section.left_end.empty() && !section.right_end.empty())
    input.set("orientation", fmt::format("{} - {}", section.left_end, section.right_end));
  tables.write(input);
  return input;
}

}  // namespace recon::block
