#include "recon/input/importing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "recon/input/import.h"
#include "recon/input/line_file.h"
#include "recon/input/section_input.h"
#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/gis/raster.h"
#include "shared/io/lines/line_kinds.h"
#include "shared/scenario/entries.h"
#include "shared/scenario/lines/import_rules.h"

namespace recon::input {

namespace io = dobra::io;
namespace scenario = dobra::scenario;
using scenario::ImportLine;
using scenario::ImportLook;
using scenario::ImportShape;

namespace {

constexpr std::array<const char*, 5> picture_files{".png", ".jpg", ".jpeg", ".tif", ".tiff"};

bool is_picture(const std::filesystem::path& file) {
  const std::string ending = io::ending_of(file);
  return std::any_of(picture_files.begin(), picture_files.end(), [&](const char* known) { return ending == known; });
}

ImportShape shape_of(io::lines::FeatureType type) {
  if (type == io::lines::FeatureType::Polygons) return ImportShape::Polygon;
  return type == io::lines::FeatureType::Points ? ImportShape::Points : ImportShape::Line;
}

const std::vector<scenario::Importing::Kind>& import_kinds() {
  using Kind = scenario::Importing::Kind;
  static const std::vector<Kind> kinds{Kind{"horizon", "Horizon", {ImportShape::Line}},
                                       Kind{"growth", "Growth horizon", {ImportShape::Line}},
                                       Kind{"fault", "Fault", {ImportShape::Line}},
                                       Kind{"topography", "Topography", {ImportShape::Line}},
                                       Kind{"pin", "Pin line", {ImportShape::Line}},
                                       Kind{"loose", "Loose line", {ImportShape::Line}},
                                       Kind{"datum", "Datum", {ImportShape::Line}},
                                       Kind{"eroded", "Eroded line", {ImportShape::Line}},
                                       Kind{"unit", "Unit polygon", {ImportShape::Line, ImportShape::Polygon}},
                                       Kind{"border", "Border", {ImportShape::Line, ImportShape::Polygon}},
                                       Kind{"marker", "Marker", {ImportShape::Points}}};
  return kinds;
}

bool suits(const std::string& kind, ImportShape shape) {
  return std::any_of(import_kinds().begin(), import_kinds().end(),
                     [&](const auto& known) { return known.name == kind && known.shapes.contains(shape); });
}

std::string table_of_kind(const std::string& kind) {
  if (kind == "growth") return "horizon";
  return kind == "unit" ? "polygon" : kind;
}

scenario::Table lines_entry(const scenario::Document& document, const std::filesystem::path& file,
                            const scenario::ImportReading& reading) {
  scenario::Table entry;
  entry.set("file", scenario::lines::import_path(document, file));
  if (const auto columns = scenario::lines::columns_by(reading); !columns.empty()) entry.set("columns", columns);
  if (reading.names > 0) entry.set("name_columns", std::vector<std::string>{fmt::format("{}", reading.names)});
  if (!reading.separator.empty()) entry.set("separator", reading.separator);
  if (!reading.y_axis.empty()) entry.set("y_axis", reading.y_axis);
  if (!reading.unit.empty()) entry.set("unit", reading.unit);
  return entry;
}

base::Result<ReadSettings> settings_of(const scenario::Document& document) {
  return read_settings(scenario::from_table<SectionInput>(document.input));
}

/// What the lines of one name and shape are: as they say, by words of the name or of the layer, else as all are that
/// say nothing.
void judge(const io::lines::Feature& first, ImportLine& line) {
  const std::string usual = line.shape == ImportShape::Line      ? "horizon"
                            : line.shape == ImportShape::Polygon ? "unit"
                                                                 : "marker";
  const auto said = first.kind.empty() ? std::nullopt : io::lines::known_kind(first.kind);
  line.stated = first.kind.empty() || line.shape == ImportShape::Points ? usual : said.value_or("");
  if (said && suits(*said, line.shape)) {
    line.kind = *said;
    line.told_by = scenario::ToldBy::File;
    return;
  }
  line.kind = usual;
  std::vector<std::string> hints{first.name};
  for (const auto& [key, value] : first.properties) {
    const auto* words = std::get_if<std::string>(&value);
    if (words != nullptr && (key == "Layer" || key == "layer" || key == "attribute" || key == "type"))
      hints.push_back(*words);
  }
  for (const std::string& hint : hints) {
    const auto kind = scenario::lines::kind_by_words(hint);
    if (!kind || !suits(*kind, line.shape)) continue;
    line.kind = *kind;
    line.told_by = scenario::ToldBy::Name;
    return;
  }
}

ImportLook look_at_picture(const scenario::Document& document, const std::filesystem::path& file,
                           const scenario::ImportReading& reading) {
  ImportLook look;
  look.asks_reading = false;
  io::gis::RasterOptions options;
  using Place = io::gis::RasterOptions::Place;
  options.place = reading.corners.empty() ? Place::AsTheFileSays : Place::GivenByTheCaller;
  options.most_pixels = 500'000;
  auto raster = io::gis::read_raster(file.string(), options);
  if (!raster) {
    look.error = base::located(raster.error(), base::Place{.file = file.string()});
    return look;
  }
  const auto& [width, height] = std::pair(raster->pixels.width, raster->pixels.height);
  geom::Box box{{0.0, 0.0}, {static_cast<double>(width) / static_cast<double>(height), 1.0}};
  look.placed = raster->box.has_value() || reading.corners.size() == 4;
  if (raster->box) box = *raster->box;
  if (reading.corners.size() == 4)
    box = {{reading.corners[0], reading.corners[1]}, {reading.corners[2], reading.corners[3]}};
  if (!(box.width() > 0.0 && box.height() > 0.0)) look.placed = false;
  const auto settings = settings_of(document);
  if (settings && settings->convention.y_axis == section::VerticalAxis::Down && box.low.y > box.high.y)
    std::swap(box.low.y, box.high.y);
  look.picture = dobra::scene::Image{std::make_shared<const dobra::scene::Pixels>(std::move(raster->pixels)), box, 1.0};
  return look;
}

base::Result<io::formats::LineWork> work_of(const scenario::Document& document, const std::filesystem::path& file,
                                            const scenario::Table& entry) {
  DOBRA_TRY_VOID(scenario::check(entry, scenario::fields_of<LinesInput>(), "import"));
  DOBRA_TRY(const ReadSettings settings, settings_of(document));
  return work_of_file(scenario::from_table<LinesInput>(entry), file.string(), settings);
}

ImportLook look(const scenario::Document& document, const std::filesystem::path& file,
                const scenario::ImportReading& reading) {
  if (is_picture(file)) return look_at_picture(document, file, reading);
  ImportLook made;
  const auto* format = io::formats::format_of(file.string(), io::formats::Use::ReadLines);
  if (format != nullptr && format->name == "text") made.table = scenario::lines::table_of(file.string(), reading);
  const auto work = work_of(document, file, lines_entry(document, file, reading));
  if (!work) {
    made.error = work.error();
    return made;
  }
  made.remarks = work->remarks;
  std::map<std::pair<std::string, ImportShape>, std::size_t> known;
  for (const io::lines::Feature& feature : work->features) {
    const ImportShape shape = shape_of(feature.type);
    const auto [at, fresh] = known.try_emplace({feature.name, shape}, made.lines.size());
    if (fresh) {
      ImportLine& line = made.lines.emplace_back();
      line.name = feature.name;
      line.shape = shape;
      judge(feature, line);
    }
    auto& parts = made.lines[at->second].parts;
    parts.insert(parts.end(), feature.parts.begin(), feature.parts.end());
  }
  return made;
}

/// Names of the tables that lines are added to, those in files of many lines among them.
std::map<std::string, std::set<std::string>> names_taken(const scenario::Document& document) {
  std::map<std::string, std::set<std::string>> taken;
  for (const auto& kind : import_kinds()) {
    const std::string table = table_of_kind(kind.name);
    for (const scenario::Table& entry : scenario::entries_of(document.input, table)) {
      taken[table].insert(scenario::text_in(entry, "name"));
      if (const std::string whole = scenario::text_in(entry, "piece_of"); !whole.empty()) taken[table].insert(whole);
    }
  }
  for (const scenario::Table& entry : scenario::entries_of(document.input, "lines")) {
    const auto work = work_of(document, document.folder() / scenario::text_in(entry, "file"), entry);
    const auto import = work ? import_lines(work->features) : base::Result<Import>(work.error());
    if (!import) continue;  // the window says so of the document
    for (const ImportedLine& line : import->lines) {
      taken[line.table].insert(line.name);
      if (!line.piece_of.empty()) taken[line.table].insert(line.piece_of);
    }
  }
  return taken;
}

std::string shown_name(const ImportLine& line, const std::filesystem::path& file) {
  return line.name.empty() ? scenario::lines::stem_of(file) : line.name;
}

base::Error refused(const std::filesystem::path& file, const std::string& message) {
  return {base::ErrorCode::BadValue, message, base::Place{.file = file.string()}};
}

/// The kinds that the file of all lines gives, against those that were chosen.
base::Result<void> check_kinds_given(const std::vector<io::lines::Feature>& features, const ImportLook& look,
                                     const scenario::ImportFile& file) {
  for (std::size_t i = 0; i < look.lines.size(); ++i) {
    const ImportLine& line = look.lines[i];
    for (const io::lines::Feature& feature : features) {
      if (feature.name != line.name || shape_of(feature.type) != line.shape || line.shape == ImportShape::Points)
        continue;
      const std::string usual = line.shape == ImportShape::Polygon ? "unit" : "horizon";
      const std::string kind =
          feature.kind.empty() ? usual : io::lines::known_kind(feature.kind).value_or(feature.kind);
      if (kind == file.choices[i].kind) continue;
      return refused(file.file,
                     fmt::format(fmt::runtime(dobra::base::translated(
                                     "'{}' cannot be told from another line by its name; give both the same kind")),
                                 line.name));
    }
  }
  return {};
}

/// One [[input.lines]] for all of the file.
base::Result<scenario::Imported> take_whole(scenario::Document document, const ImportLook& look,
                                            const scenario::ImportFile& file) {
  scenario::Table entry = lines_entry(document, file.file, file.reading);
  if (const auto rules = scenario::lines::rules_for(look, file); !rules.empty()) entry.set("kind", rules);
  DOBRA_TRY(const io::formats::LineWork work, work_of(document, file.file, entry));
  DOBRA_TRY_VOID(check_kinds_given(work.features, look, file));
  DOBRA_TRY_VOID(import_lines(work.features));
  scenario::Entries entries = scenario::entries_of(document.input, "lines");
  entries.push_back(std::move(entry));
  scenario::set_entries(document.input, "lines", std::move(entries));
  return scenario::Imported{std::move(document), {}};
}

/// The entry of one line, checked to read what was looked at.
base::Result<scenario::Table> line_entry(const scenario::Document& document, const ImportLook& look,
                                         const scenario::ImportFile& file, std::size_t i, const std::string& name) {
  const ImportLine& line = look.lines[i];
  const std::string& kind = file.choices[i].kind;
  const std::string table = table_of_kind(kind);
  const auto apart = [&](const std::string& why) {
    return refused(
        file.file,
        fmt::format(fmt::runtime(dobra::base::translated(
                        "'{}' cannot be taken by itself ({}); take all lines of the file, under their names")),
                    shown_name(line, file.file), why));
  };
  scenario::Table entry;
  entry.set("name", name);
  entry.set("file", scenario::lines::import_path(document, file.file));
  if (look.lines.size() > 1) {
    if (line.name.empty()) return apart(dobra::base::translated("it has no name"));
    entry.set("feature", line.name);
  }
  if (file.reading.x > 0) {
    const auto number = [](std::size_t column) { return static_cast<double>(column); };
    std::vector<double> columns{number(file.reading.x), number(file.reading.height)};
    if (file.reading.map_y > 0) columns.insert(columns.begin() + 1, number(file.reading.map_y));
    entry.set("columns", columns);
  }
  if (!file.reading.separator.empty()) entry.set("separator", file.reading.separator);
  if (!file.reading.y_axis.empty()) entry.set("y_axis", file.reading.y_axis);
  if (!file.reading.unit.empty()) entry.set("unit", file.reading.unit);
  if (kind == "growth") entry.set("role", std::string("growth"));
  DOBRA_TRY(const ReadSettings settings, settings_of(document));
  const auto read = lines_of_file(scenario::from_table<HorizonInput>(entry), file.file.string(), settings);
  if (!read) return apart(read.error().message);
  if (read->pieces.size() > 1 && table != "horizon") return apart(dobra::base::translated("it is in several parts"));
  std::vector<geom::Polyline> seen = line.parts;
  for (geom::Polyline& part : seen) {
    if (part.closed) part.points.push_back(part.points.front());
    part.closed = false;
  }
  if (read->pieces != seen) return apart(dobra::base::translated("another line has its name"));
  return entry;
}

base::Result<scenario::Imported> take_one_by_one(scenario::Document document, const ImportLook& look,
                                                 const scenario::ImportFile& file) {
  std::map<std::string, std::set<std::string>> taken = names_taken(document);
  std::map<std::string, scenario::Entries> fresh;
  scenario::Imported made;
  for (std::size_t i = 0; i < look.lines.size(); ++i) {
    if (!file.choices[i].taken) continue;
    const std::string wanted = shown_name(look.lines[i], file.file);
    const std::string table = table_of_kind(file.choices[i].kind);
    std::string name = wanted;
    for (int copy = 2; !taken[table].insert(name).second; ++copy) name = fmt::format("{} ({})", wanted, copy);
    if (name != wanted) {
      made.notes.push_back(fmt::format(
          fmt::runtime(dobra::base::translated("'{}' is there already; this one becomes '{}'")), wanted, name));
    }
    DOBRA_TRY(scenario::Table entry, line_entry(document, look, file, i, name));
    fresh[table].push_back(std::move(entry));
  }
  for (auto& [table, entries] : fresh) {
    scenario::Entries all = scenario::entries_of(document.input, table);
    std::move(entries.begin(), entries.end(), std::back_inserter(all));
    scenario::set_entries(document.input, table, std::move(all));
  }
  made.document = std::move(document);
  return made;
}

base::Result<scenario::Imported> take_picture(scenario::Document document, const ImportLook& look,
                                              const scenario::ImportFile& file) {
  if (!look.placed)
    return refused(
        file.file,
        dobra::base::translated("the picture does not say where it lies; give its lower left and upper right corner"));
  scenario::Entries entries = scenario::entries_of(document.input, "backdrop");
  const std::string stem = scenario::lines::stem_of(file.file);
  scenario::Table entry;
  entry.set("name", scenario::entry_named(entries, stem) == entries.end() ? stem : scenario::free_name(entries, stem));
  entry.set("file", scenario::lines::import_path(document, file.file));
  const std::vector<double>& at = file.reading.corners;
  if (at.size() == 4) entry.set("corners", std::vector<geom::Point>{{at[0], at[1]}, {at[2], at[3]}});
  entries.push_back(std::move(entry));
  scenario::set_entries(document.input, "backdrop", std::move(entries));
  return scenario::Imported{std::move(document), {}};
}

base::Result<scenario::Imported> take_in(scenario::Document document, const ImportLook& look,
                                         const scenario::ImportFile& file) {
  if (look.error) return *look.error;
  if (look.picture) return take_picture(std::move(document), look, file);
  const std::size_t wanted = static_cast<std::size_t>(
      std::count_if(file.choices.begin(), file.choices.end(), [](const auto& choice) { return choice.taken; }));
  if (wanted == 0) return refused(file.file, dobra::base::translated("no line is chosen; tick one"));
  const auto borders = [&](std::size_t i) {
    return file.choices[i].taken && file.choices[i].kind == "border" ? look.lines[i].parts.size() : 0;
  };
  std::size_t count = scenario::entries_of(document.input, "border").size();
  for (std::size_t i = 0; i < look.lines.size(); ++i) count += borders(i);
  if (count > 1)
    return refused(file.file, dobra::base::translated("a section has one border; choose another kind for the others"));
  const auto taken = names_taken(document);
  bool clash = false;
  for (std::size_t i = 0; i < look.lines.size(); ++i) {
    const auto names = taken.find(table_of_kind(file.choices[i].kind));
    const auto holds = [&](const std::string& name) { return names != taken.end() && names->second.contains(name); };
    clash = clash || holds(look.lines[i].name);
    for (std::size_t k = 1; k <= look.lines[i].parts.size() && !clash; ++k)
      clash = holds(fmt::format("{} ({})", look.lines[i].name, k)) ||
              (look.lines[i].name.empty() && holds(fmt::format("feature {}", k)));
  }
  const bool one = look.lines.size() == 1 && look.lines.front().parts.size() == 1 && file.reading.names == 0;
  if (one || wanted < look.lines.size() || clash) return take_one_by_one(std::move(document), look, file);
  return take_whole(std::move(document), look, file);
}

}  // namespace

scenario::Importing importing() {
  scenario::Importing made;
  made.kinds = import_kinds();
  made.files = scenario::lines::file_kinds({io::formats::Use::ReadLines});
  made.files.push_back({"Pictures", {picture_files.begin(), picture_files.end()}});
  made.units = {"m", "km", "ft"};
  made.look = look;
  made.take_in = take_in;
  return made;
}

}  // namespace recon::input
