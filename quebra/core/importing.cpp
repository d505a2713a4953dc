#include "quebra/core/importing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "quebra/core/curve_entries.h"
#include "quebra/core/input.h"
#include "quebra/domain/roles.h"
#include "quebra/sketch/roles_by_name.h"
#include "quebra/sketch/sketch_file.h"
#include "shared/base/text.h"
#include "shared/scenario/entries.h"
#include "shared/scenario/lines/import_rules.h"

namespace quebra::core {

namespace geom = dobra::geom;
namespace io = dobra::io;
namespace scenario = dobra::scenario;
using dobra::base::Result;
using dobra::base::translated;
using scenario::ImportLine;
using scenario::ImportLook;
using scenario::ImportShape;

namespace {

constexpr const char* found_by_itself = "found";

const std::vector<scenario::Importing::Kind>& import_kinds() {
  using Kind = scenario::Importing::Kind;
  static const std::set<ImportShape> both{ImportShape::Line, ImportShape::Polygon};
  static const std::vector<Kind> kinds{
      Kind{found_by_itself, "As the drawing shows", both}, Kind{"outline", "Outline", both}, Kind{"hole", "Hole", both},
      Kind{"internal", "Internal line", both}, Kind{"crack", "Crack", {ImportShape::Line}}};
  return kinds;
}

bool suits(const std::string& kind, ImportShape shape) {
  return std::any_of(import_kinds().begin(), import_kinds().end(),
                     [&](const auto& known) { return known.name == kind && known.shapes.contains(shape); });
}

/// The keys of the input that name the file and say how it is read.
scenario::Table reading_keys(const scenario::Document& document, const std::filesystem::path& file,
                             const scenario::ImportReading& reading) {
  scenario::Table keys;
  keys.set("file", scenario::lines::import_path(document, file));
  if (const auto columns = scenario::lines::columns_by(reading); !columns.empty())
    keys.set("columns", fmt::format("{}", fmt::join(columns, ",")));
  if (reading.names > 0) keys.set("name_columns", fmt::format("{}", reading.names));
  if (!reading.separator.empty()) keys.set("separator", reading.separator);
  if (!reading.y_axis.empty()) keys.set("y_axis", reading.y_axis);
  if (!reading.unit.empty()) keys.set("unit", reading.unit);
  return keys;
}

/// As reading the document with these keys alone will have it.
Result<sketch::Sketch> sketch_by(const scenario::Document& document, const scenario::Table& keys) {
  scenario::Context context;
  context.folder = document.folder();
  context.units = document.units;
  context.shown_units = document.shown_units();
  return read_drawing(scenario::from_table<InputParams>(keys), keys, context);
}

std::string stated_kind(const sketch::Sketch& sketch, const sketch::Curve& curve) {
  if (sketch.without_role.contains(curve.name)) return found_by_itself;
  return curve.role == sketch::Role::Boundary ? found_by_itself : sketch::role_name(curve.role);
}

ImportLook look(const scenario::Document& document, const std::filesystem::path& file,
                const scenario::ImportReading& reading) {
  ImportLook made;
  const auto* lines = io::formats::format_of(file.string(), io::formats::Use::ReadLines);
  const bool drawing = io::formats::format_of(file.string(), io::formats::Use::ReadDrawing) != nullptr ||
                       io::formats::format_of(file.string(), io::formats::Use::ReadMesh) != nullptr;
  made.asks_reading = lines != nullptr && !drawing;
  if (made.asks_reading && lines->name == "text") made.table = scenario::lines::table_of(file.string(), reading);
  const auto sketch = sketch_by(document, reading_keys(document, file, reading));
  if (!sketch) {
    made.error = sketch.error();
    return made;
  }
  made.remarks = sketch->remarks;
  for (const sketch::Curve& curve : sketch->curves) {
    ImportLine& line = made.lines.emplace_back();
    line.name = curve.name;
    line.parts.push_back(trace(curve).line);
    line.shape = closed(curve) ? ImportShape::Polygon : ImportShape::Line;
    line.kind = line.stated = stated_kind(*sketch, curve);
    if (line.stated != found_by_itself) {
      line.told_by = scenario::ToldBy::File;
      continue;
    }
    const auto kind = scenario::lines::kind_by_words(curve.name);
    if (!kind || !suits(*kind, line.shape)) continue;
    line.kind = *kind;
    line.told_by = scenario::ToldBy::Name;
  }
  return made;
}

dobra::base::Error refused(const std::filesystem::path& file, const std::string& message) {
  return {dobra::base::ErrorCode::BadValue, message, dobra::base::Place{.file = file.string()}};
}

std::set<std::string> names_taken(const scenario::Document& document) {
  std::set<std::string> taken;
  for (const char* key : {"curve", "crack"}) {
    for (const scenario::Table& entry : scenario::entries_of(document.input, key))
      taken.insert(scenario::text_in(entry, "name"));
  }
  if (document.input.find("file") == nullptr) return taken;
  const auto sketch = sketch_by(document, document.input);
  if (!sketch) return taken;  // the window says so of the document
  for (const sketch::Curve& curve : sketch->curves) taken.insert(curve.name);
  return taken;
}

/// "NAME=KIND" as the document's key `kind` takes them.
std::vector<std::string> rules_of(const ImportLook& look, const scenario::ImportFile& file) {
  std::vector<std::string> rules;
  for (std::size_t i = 0; i < look.lines.size(); ++i) {
    if (!file.choices[i].taken) rules.push_back(look.lines[i].name + "=none");
  }
  ImportLook rest = look;
  scenario::ImportFile wanted = file;
  for (std::size_t i = look.lines.size(); i-- > 0;) {
    if (file.choices[i].taken) continue;
    rest.lines.erase(rest.lines.begin() + static_cast<std::ptrdiff_t>(i));
    wanted.choices.erase(wanted.choices.begin() + static_cast<std::ptrdiff_t>(i));
  }
  for (std::string& rule : scenario::lines::rules_for(rest, wanted)) rules.push_back(std::move(rule));
  return rules;
}

/// What the rules make of the file, against what was chosen.
Result<sketch::Sketch> checked(const scenario::Document& document, const scenario::Table& keys, const ImportLook& look,
                               const scenario::ImportFile& file) {
  DOBRA_TRY(sketch::Sketch sketch, sketch_by(document, keys));
  for (std::size_t i = 0; i < look.lines.size(); ++i) {
    const auto at = std::find_if(sketch.curves.begin(), sketch.curves.end(),
                                 [&](const sketch::Curve& curve) { return curve.name == look.lines[i].name; });
    const std::string& wanted = file.choices[i].kind;
    const bool there = at != sketch.curves.end();
    const bool right = there && (wanted == found_by_itself ? stated_kind(sketch, *at) == wanted
                                                           : sketch::role_name(at->role) == wanted);
    if (file.choices[i].taken ? right : !there) continue;
    return refused(
        file.file,
        fmt::format(
            fmt::runtime(translated("'{}' cannot be told from another line by its name; give both the same kind")),
            look.lines[i].name));
  }
  return sketch;
}

/// The file of the document from now on.
Result<scenario::Imported> take_file(scenario::Document document, const scenario::Table& keys) {
  for (const scenario::Table::Entry& entry : keys.entries()) document.input.set(entry.key, entry.value);
  return scenario::Imported{std::move(document), {}};
}

/// The curves as points of the document.
scenario::Imported take_curves(scenario::Document document, sketch::Sketch sketch, std::vector<std::string> notes) {
  geom::Box box;
  for (const sketch::Curve& curve : sketch.curves) box.add(box_of(curve));
  domain::find_roles(sketch, InputParams{}.join_tolerance * box.diagonal());
  std::set<std::string> taken = names_taken(document);
  for (sketch::Curve& curve : sketch.curves) {
    const std::string wanted = curve.name;
    for (int copy = 2; !taken.insert(curve.name).second; ++copy) curve.name = fmt::format("{} ({})", wanted, copy);
    if (curve.name != wanted) {
      notes.push_back(
          fmt::format(fmt::runtime(translated("'{}' is there already; this one becomes '{}'")), wanted, curve.name));
    }
    scenario::Entries entries = scenario::entries_of(document.input, table_of(curve));
    entries.push_back(curve_entry(curve, document.units));
    scenario::set_entries(document.input, table_of(curve), std::move(entries));
  }
  return {std::move(document), std::move(notes)};
}

Result<scenario::Imported> take_in(scenario::Document document, const ImportLook& look,
                                   const scenario::ImportFile& file) {
  if (look.error) return *look.error;
  if (std::none_of(file.choices.begin(), file.choices.end(), [](const auto& choice) { return choice.taken; }))
    return refused(file.file, translated("no line is chosen; tick one"));
  scenario::Table keys = reading_keys(document, file.file, file.reading);
  if (const auto rules = rules_of(look, file); !rules.empty()) keys.set("kind", rules);
  DOBRA_TRY(sketch::Sketch sketch, checked(document, keys, look, file));
  const std::set<std::string> taken = names_taken(document);
  const bool clash = std::any_of(sketch.curves.begin(), sketch.curves.end(),
                                 [&](const sketch::Curve& curve) { return taken.contains(curve.name); });
  if (document.input.find("file") == nullptr && !clash) return take_file(std::move(document), keys);
  const char* why = clash ? "Curves of these names are there already: those of the file become curves of the scenario."
                          : "The scenario has a file already: the curves of this one become curves of the scenario.";
  // A polygon's name is also that of its ring, and stays there.
  const bool names_areas = std::any_of(sketch.areas.begin(), sketch.areas.end(), [](const sketch::Area& area) {
    return !area.name.empty() && (area.rings.size() != 1 || area.rings.front() != area.name);
  });
  if (!sketch.regions.empty() || !sketch.points.empty() || sketch.hole_points || names_areas)
    return refused(file.file, translated("this file names materials, points or holes besides its curves, and only one "
                                         "such file can be in a scenario; open it in a scenario of its own"));
  return take_curves(std::move(document), std::move(sketch), {translated(why)});
}

}  // namespace

scenario::Importing importing() {
  scenario::Importing made;
  made.kinds = import_kinds();
  made.files = scenario::lines::file_kinds(
      {io::formats::Use::ReadDrawing, io::formats::Use::ReadLines, io::formats::Use::ReadMesh});
  made.units = {io::formats::file_units.begin(), io::formats::file_units.end()};
  made.look = look;
  made.take_in = take_in;
  return made;
}

}  // namespace quebra::core
