#include "recon/input/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "recon/input/colors.h"
#include "recon/input/import.h"
#include "recon/input/input.h"
#include "recon/input/line_file.h"
#include "recon/input/section_input.h"
#include "shared/base/short_number.h"
#include "shared/base/text.h"
#include "shared/scenario/entries.h"

namespace recon::input {

namespace scenario = dobra::scenario;
namespace scene = dobra::scene;

namespace {

/// Section coordinates and back, as [input] says.
class Coordinates {
 public:
  explicit Coordinates(const scenario::Table& input) {
    const auto read = scenario::from_table<SectionInput>(input);
    convention_ = {read.y_axis, read.reference, read.unit, read.exaggeration};
  }

  [[nodiscard]] geom::Point in_section(geom::Point p) const { return to_section(p, convention_); }

  /// Points that have not moved keep the numbers that the user wrote.
  [[nodiscard]] std::vector<geom::Point> in_document(const geom::Polyline& line,
                                                     const std::vector<geom::Point>& written) const {
    // Most lines differ in few places: what is the same from either end needs no search.
    const std::size_t least = std::min(line.points.size(), written.size());
    const auto same = [&](std::size_t i, std::size_t j) {
      return to_section(written[j], convention_) == line.points[i];
    };
    std::size_t head = 0;
    while (head < least && same(head, head)) ++head;
    std::size_t tail = 0;
    while (tail < least - head && same(line.points.size() - 1 - tail, written.size() - 1 - tail)) ++tail;
    std::map<geom::Point, geom::Point> known;
    for (std::size_t j = head; j < written.size() - tail; ++j)
      known.emplace(to_section(written[j], convention_), written[j]);
    std::vector<geom::Point> points(written.begin(), written.begin() + static_cast<std::ptrdiff_t>(head));
    points.reserve(line.points.size() + 1);
    for (std::size_t i = head; i < line.points.size() - tail; ++i) {
      const auto found = known.find(line.points[i]);
      points.push_back(found == known.end() ? written_as(line.points[i]) : found->second);
    }
    points.insert(points.end(), written.end() - static_cast<std::ptrdiff_t>(tail), written.end());
    if (line.closed) points.push_back(points.front());
    return points;
  }

 private:
  /// Turned back, the numbers of a document carry the rounding of the way there: short ones are taken, unless only the
  /// long ones give the very place.
  [[nodiscard]] geom::Point written_as(geom::Point in_section) const {
    const geom::Point exact = section::from_section(in_section, convention_);
    const geom::Point shorter{base::without_rounding(exact.x), base::without_rounding(exact.y)};
    const geom::Point there = to_section(shorter, convention_);
    const geom::Point back = to_section(exact, convention_);
    return {there.x != in_section.x && back.x == in_section.x ? exact.x : shorter.x,
            there.y != in_section.y && back.y == in_section.y ? exact.y : shorter.y};
  }

  section::Convention convention_;
};

/// What says how a file is read, or what its points mean: of no use beside points of the document.
constexpr std::array<const char*, 13> keys_of_files{"file",  "feature",     "columns", "separator",       "y_axis",
                                                    "unit",  "point_order", "order",   "drop_duplicates", "join_gaps",
                                                    "curve", "tangents",    "weights"};

void set_points(scenario::Table& entry, const std::string& table, std::vector<geom::Point> points) {
  for (const char* key : keys_of_files) {
    if (table == "fault" && key == std::string_view("order")) continue;  // there it is the age
    entry.erase(key);
  }
  entry.set("points", std::move(points));
}

/// A line of the section: in which table of the input it stands, and under which name.
struct Item {
  std::string table;
  std::string name;
  std::string piece_of;
};

base::Result<Item> item_of(const section::Section& section, const scene::Pick& pick) {
  if (pick.layer.starts_with("horizon_") && pick.id < section.horizons.size()) {
    const section::Horizon& horizon = section.horizons[pick.id];
    return Item{"horizon", horizon.name, horizon.piece_of};
  }
  if (pick.layer.starts_with("line_") && pick.id < section.lines.size()) {
    const section::SectionLine& line = section.lines[pick.id];
    return Item{kind_name(line.kind), line.name, line.piece_of};
  }
  return scenario::edit_refused(pick.layer,
                                "this is drawn by the program and cannot be edited; edit horizons, faults and lines");
}

/// The line as an entry of its table.
scenario::Table entry_of(const std::string& name, const std::string& piece_of, section::BedRole role,
                         std::vector<geom::Point> points) {
  scenario::Table entry;
  entry.set("name", name);
  entry.set("points", std::move(points));
  if (!piece_of.empty()) entry.set("piece_of", piece_of);
  if (role == section::BedRole::Growth) entry.set("role", std::string("growth"));
  return entry;
}

/// All lines of the files of many lines, as tables of their own; horizons that reading has joined, as the section has
/// them.
base::Result<scenario::Document> with_files_taken_in(scenario::Document document, const section::Section& section) {
  auto input = scenario::from_table<SectionInput>(document.input);
  if (input.lines.empty()) return document;
  DOBRA_TRY(const ReadSettings settings, read_settings(input));
  const Coordinates coordinates(document.input);
  std::map<std::string, scenario::Entries> made;
  for (const LinesInput& wanted : input.lines) {
    DOBRA_TRY(const auto work, work_of_file(wanted, (document.folder() / wanted.file).string(), settings));
    DOBRA_TRY(const Import import, import_lines(work.features));
    std::set<std::string> joined;
    for (const ImportedLine& line : import.lines) {
      const bool bed = line.table == "horizon";
      const std::string& whole = line.piece_of.empty() ? line.name : line.piece_of;
      if (bed && wanted.join_gaps > 0.0) {
        if (!joined.insert(whole).second) continue;
        for (const section::Horizon& piece : section.horizons) {
          if (whole_name(piece) == whole)
            made[line.table].push_back(
                entry_of(piece.name, piece.piece_of, piece.role, coordinates.in_document(piece.line, {})));
        }
        continue;
      }
      scenario::Table entry = entry_of(line.name, bed || line.table == "fault" ? line.piece_of : "", line.role,
                                       coordinates.in_document(line.line, {}));
      if (line.order > 0) entry.set("order", std::int64_t{line.order});
      if (line.hanging_wall != section::HangingWall::Auto)
        entry.set("hanging_wall", std::string(section::hanging_wall_name(line.hanging_wall)));
      made[line.table].push_back(std::move(entry));
    }
  }
  document.input.erase("lines");
  for (auto& [table, entries] : made) {
    scenario::Entries all = scenario::entries_of(document.input, table);
    all.insert(all.end(), std::make_move_iterator(entries.begin()), std::make_move_iterator(entries.end()));
    scenario::set_entries(document.input, table, std::move(all));
  }
  return document;
}

/// Puts the lines in the place of the entry.
void replace(scenario::Entries& tables, const Item& item, const Coordinates& coordinates,
             const std::vector<geom::Polyline>& becomes) {
  const auto entry = scenario::entry_named(tables, item.name);
  const std::vector<geom::Point> written = scenario::points_in(*entry);
  if (becomes.empty()) {
    tables.erase(entry);
    return;
  }
  set_points(*entry, item.table, coordinates.in_document(becomes.front(), written));
  if (becomes.size() == 1) return;
  scenario::Table part = *entry;
  const std::string whole = item.piece_of.empty() ? item.name : item.piece_of;
  const bool pieces = item.table == "horizon" || item.table == "fault";
  if (pieces) part.set("piece_of", whole);
  if (pieces && item.piece_of.empty()) {  // no piece is called as the whole is
    entry->set("piece_of", whole);
    entry->set("name", fmt::format("{} (1)", whole));
  }
  std::size_t at = static_cast<std::size_t>(entry - tables.begin());
  for (std::size_t k = 1; k < becomes.size(); ++k) {
    part.set("name", scenario::free_name(tables, whole));
    set_points(part, item.table, coordinates.in_document(becomes[k], written));
    tables.insert(tables.begin() + static_cast<std::ptrdiff_t>(++at), part);
  }
}

/// The edits of one marker's points, by their numbers.
using MarkerEdits = std::map<std::size_t, const scene::LineEdit*>;

/// The marker of a layer "marker_3"; nothing for other layers.
std::optional<std::size_t> marker_of(const section::Section& section, const scene::Pick& pick) {
  for (const section::Marker& marker : section.markers) {
    if (pick.layer == "marker_" + std::to_string(marker.id.index())) return marker.id.index();
  }
  return std::nullopt;
}

/// Points that move or go; a marker without points goes.
base::Result<scenario::Document> with_marker_edited(scenario::Document document, const section::Section& section,
                                                    const section::Marker& marker, const MarkerEdits& edits) {
  scenario::Entries markers = scenario::entries_of(document.input, "marker");
  if (scenario::entry_named(markers, marker.name) == markers.end()) {
    DOBRA_TRY(document, with_files_taken_in(std::move(document), section));
    markers = scenario::entries_of(document.input, "marker");
  }
  const auto entry = scenario::entry_named(markers, marker.name);
  if (entry == markers.end())
    return scenario::edit_refused(marker.name,
                                  "reading the section has made or cut this line, so that it cannot be edited by "
                                  "itself; edit the line that it was made from");
  geom::Polyline points;
  for (std::size_t i = 0; i < marker.points.size(); ++i) {
    const auto edit = edits.find(i);
    if (edit == edits.end())
      points.points.push_back(marker.points[i]);
    else if (!edit->second->becomes.empty())
      points.points.push_back(edit->second->becomes.front().points.front());
  }
  if (points.points.empty()) {
    markers.erase(entry);
  } else {
    const std::vector<geom::Point> written = scenario::points_in(*entry);
    set_points(*entry, "marker", Coordinates(document.input).in_document(points, written));
  }
  scenario::set_entries(document.input, "marker", std::move(markers));
  return document;
}

}  // namespace

base::Result<scenario::Document> with_lines_edited(scenario::Document document, const section::Section& section,
                                                   std::span<const scene::LineEdit> edits) {
  std::set<std::string> gone;
  std::map<std::size_t, MarkerEdits> of_markers;
  for (const scene::LineEdit& edit : edits) {
    if (const auto marker = marker_of(section, edit.pick)) {
      if (edit.pick.id < section.markers[*marker].points.size()) of_markers[*marker][edit.pick.id] = &edit;
      continue;
    }
    DOBRA_TRY(const Item item, item_of(section, edit.pick));
    scenario::Entries tables = scenario::entries_of(document.input, item.table);
    if (scenario::entry_named(tables, item.name) == tables.end()) {
      DOBRA_TRY(document, with_files_taken_in(std::move(document), section));
      tables = scenario::entries_of(document.input, item.table);
    }
    if (scenario::entry_named(tables, item.name) == tables.end()) {
      return scenario::edit_refused(
          item.name,
          "reading the section has made or cut this line, so that it cannot be edited by itself; edit the "
          "line that it was made from");
    }
    replace(tables, item, Coordinates(document.input), edit.becomes);
    scenario::set_entries(document.input, item.table, std::move(tables));
    if (item.table == "horizon" && edit.becomes.empty()) gone.insert(item.piece_of.empty() ? item.name : item.piece_of);
  }
  for (const auto& [marker, changes] : of_markers) {
    DOBRA_TRY(document, with_marker_edited(std::move(document), section, section.markers[marker], changes));
  }
  return with_colors_kept(std::move(document), section, gone);
}

double unit_length(const scenario::Document& document) {
  const std::string unit = scenario::text_in(document.input, "unit");
  return section::metres_per_unit(unit == "km"   ? section::LengthUnit::Kilometre
                                  : unit == "ft" ? section::LengthUnit::Foot
                                                 : section::LengthUnit::Metre);
}

base::Result<scenario::Document> with_line(scenario::Document document, const std::string& table,
                                           const std::string& name, const geom::Polyline& line) {
  scenario::Entries tables = scenario::entries_of(document.input, table);
  if (base::trimmed(name).empty()) return scenario::edit_refused(name, "give it a name");
  if (scenario::entry_named(tables, name) != tables.end())
    return scenario::edit_refused(name, "another one has this name already; give another name");
  scenario::Table& entry = tables.emplace_back();
  entry.set("name", name);
  entry.set("points", Coordinates(document.input).in_document(line, {}));
  scenario::set_entries(document.input, table, std::move(tables));
  return document;
}

}  // namespace recon::input
