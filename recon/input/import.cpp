#include "recon/input/import.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "recon/input/line_file.h"
#include "shared/geom/place.h"
#include "shared/io/lines/line_kinds.h"
#include "shared/io/scan.h"

namespace recon::input {

namespace io = dobra::io;

namespace {

/// The lists of [input] for lines of each kind.
struct TableOfKind {
  const char* kind;
  const char* table;
};
constexpr std::array<TableOfKind, 11> tables{{{"horizon", "horizon"},
                                              {"growth", "horizon"},
                                              {"fault", "fault"},
                                              {"pin", "pin"},
                                              {"loose", "loose"},
                                              {"topography", "topography"},
                                              {"datum", "datum"},
                                              {"eroded", "eroded"},
                                              {"unit", "polygon"},  // a line that is to close
                                              {"border", "border"},
                                              {"marker", "marker"}}};

base::Result<std::string> table_of(const io::lines::Feature& feature, std::size_t number) {
  const bool polygon = feature.type == io::lines::FeatureType::Polygons;
  if (feature.type == io::lines::FeatureType::Points) return std::string("marker");
  if (feature.kind.empty()) return std::string(polygon ? "polygon" : "horizon");
  const auto found = std::find_if(tables.begin(), tables.end(),
                                  [&](const TableOfKind& t) { return io::lines::known_kind(feature.kind) == t.kind; });
  const std::string table = found->table;
  if (!polygon || table == "polygon" || table == "border") return table;
  base::Place place = feature.source;
  place.item = io::lines::item_of(number, feature);
  return base::Error{
      base::ErrorCode::BadFormat,
      fmt::format("a polygon cannot be of kind '{}', which is a line; give it kind 'unit' or 'border', or "
                  "do not repeat its first point at the end",
                  feature.kind),
      place};
}

std::string name_of(const io::lines::Feature& feature, std::size_t index) {
  return feature.name.empty() ? fmt::format("feature {}", index + 1) : feature.name;
}

/// A property that is a text; empty without it.
std::string text_of(const io::lines::Feature& feature, const char* key) {
  for (const auto& [name, value] : feature.properties) {
    const auto* text = std::get_if<std::string>(&value);
    if (name == key && text != nullptr) return *text;
  }
  return {};
}

/// A property that is a whole number, written as any kind of number or as text; nothing without it.
std::optional<std::string> number_of(const io::lines::Feature& feature, const char* key) {
  for (const auto& [name, value] : feature.properties) {
    if (name != key) continue;
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
    if (const auto* number = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *number);
    return std::string("true or false");
  }
  return std::nullopt;
}

/// Of a fault: its properties order and hanging_wall.
base::Result<void> read_fault(const io::lines::Feature& feature, std::size_t number, ImportedLine& made) {
  const auto refuse = [&](std::string message) {
    base::Place place = feature.source;
    place.item = io::lines::item_of(number, feature);
    return base::Error{base::ErrorCode::BadFormat, std::move(message), place};
  };
  if (const auto order = number_of(feature, "order"); order && !order->empty()) {
    const auto value = io::finite_number(*order, "order");
    if (!value || *value != std::floor(*value) || *value < 0.0 || *value > 1e6) {
      return refuse(
          fmt::format("order = {} is no age of a fault; give a whole number, 1 for the youngest, 0 where it "
                      "is not known",
                      *order));
    }
    made.order = static_cast<int>(*value);
  }
  const std::string side = text_of(feature, "hanging_wall");
  if (side.empty()) return {};
  for (const auto wall : {section::HangingWall::Auto, section::HangingWall::Left, section::HangingWall::Right,
                          section::HangingWall::Above, section::HangingWall::Below}) {
    made.hanging_wall = wall;
    if (side == section::hanging_wall_name(wall)) return {};
  }
  return refuse(fmt::format("hanging_wall = '{}' is no side; give left, right, above, below or auto", side));
}

struct Place {
  double from_left = 0.0;
  std::size_t feature = 0;
  std::size_t part = 0;
};

class Importer {
 public:
  explicit Importer(const std::vector<io::lines::Feature>& features) : features_(features) {}

  base::Result<Import> run() {
    DOBRA_TRY_VOID(io::lines::check_kinds(features_));
    for (std::size_t i = 0; i < features_.size(); ++i) {
      DOBRA_TRY(tables_.emplace_back(), table_of(features_[i], i + 1));
    }
    find_numbered();
    find_pieces();
    for (std::size_t i = 0; i < features_.size(); ++i) {
      for (std::size_t part = 0; part < features_[i].parts.size(); ++part) {
        add(i, part);
        if (tables_[i] == "fault") DOBRA_TRY_VOID(read_fault(features_[i], i + 1, made_.lines.back()));
      }
    }
    for (const auto& [item, count] : repeated_) {
      const auto& [table, name] = item;
      made_.remarks.push_back(fmt::format("{} {}s are called '{}': from the second on they are '{} (2)' and so on{}",
                                          count, table, name, name, table == "polygon" ? ", pieces of one unit" : ""));
    }
    return std::move(made_);
  }

 private:
  /// Wholes of lines called "A (1)" to "A (n)", all of them and each once, as moves call pieces.
  void find_numbered() {
    std::map<std::pair<std::string, std::string>, std::map<std::size_t, std::vector<std::size_t>>> families;
    for (std::size_t i = 0; i < features_.size(); ++i) {
      const auto numbered = may_be_piece(i) ? numbered_name(features_[i].name) : std::nullopt;
      if (numbered) families[{tables_[i], numbered->first}][numbered->second].push_back(i);
    }
    for (const auto& [item, numbers] : families) {
      const bool once = std::all_of(numbers.begin(), numbers.end(), [](const auto& n) { return n.second.size() == 1; });
      if (!once || numbers.size() < 2 || numbers.rbegin()->first != numbers.size()) continue;
      for (const auto& [number, features] : numbers) wholes_[features.front()] = item.second;
      made_.remarks.push_back(fmt::format("'{0} (1)' to '{0} ({1})' are taken for the pieces of {2} '{0}'", item.second,
                                          numbers.size(), item.first));
    }
  }

  /// Where the pieces of each horizon stand, from the left: lines of one name, and the parts of one line.
  void find_pieces() {
    for (std::size_t i = 0; i < features_.size(); ++i) {
      if (!may_be_piece(i)) continue;
      for (std::size_t part = 0; part < features_[i].parts.size(); ++part)
        pieces_[{tables_[i], name_of(features_[i], i)}].push_back({features_[i].parts[part].box().centre().x, i, part});
    }
    for (auto& [item, places] : pieces_) {
      std::stable_sort(places.begin(), places.end(),
                       [](const Place& a, const Place& b) { return a.from_left < b.from_left; });
      if (places.size() > 1) {
        made_.remarks.push_back(
            fmt::format("{2} '{0}' is in {1} pieces, numbered from the left: '{0} (1)' to '{0} ({1})'", item.second,
                        places.size(), item.first));
      }
    }
  }

  /// Of the feature: a horizon or a fault that does not say itself what it is a piece of.
  [[nodiscard]] bool may_be_piece(std::size_t i) const {
    return (tables_[i] == "horizon" || tables_[i] == "fault") && text_of(features_[i], "piece_of").empty();
  }

  void add(std::size_t i, std::size_t part) {
    const io::lines::Feature& feature = features_[i];
    const section::BedRole role =
        io::lines::known_kind(feature.kind) == "growth" ? section::BedRole::Growth : section::BedRole::Judged;
    ImportedLine made{tables_[i], name_of(feature, i), {}, role, feature.parts[part], feature.source};
    if (feature.type == io::lines::FeatureType::Points && !feature.kind.empty() && feature.kind != "marker")
      made_.remarks.push_back(fmt::format("'{}': points of kind '{}' are taken as a marker", made.name, feature.kind));
    if (feature.type == io::lines::FeatureType::Polygons && geom::signed_area(made.line) < 0.0) {
      const geom::Point at = made.line.points.front();
      made_.remarks.push_back(
          fmt::format("unit '{}': its hole at {} is left out; what fills it is a polygon of its own", made.name, at));
      return;
    }
    if (made.line.closed) made.line.points.push_back(made.line.points.front());  // it says that it closes
    made.line.closed = false;
    if (const auto found = pieces_.find({made.table, made.name}); may_be_piece(i) && found->second.size() > 1) {
      const auto at = std::find_if(found->second.begin(), found->second.end(),
                                   [&](const Place& p) { return p.feature == i && p.part == part; });
      made.piece_of = made.name;
      made.name = fmt::format("{} ({})", made.name, at - found->second.begin() + 1);
    }
    // Names must differ within a table; a file may repeat them.
    const std::string wanted = made.name;
    for (int copy = 2; !names_.insert(made.table + '\n' + made.name).second; ++copy)
      made.name = fmt::format("{} ({})", wanted, copy);
    if (made.name != wanted) ++repeated_.try_emplace({made.table, wanted}, 1).first->second;
    if (made.table == "horizon" || made.table == "fault") {
      if (const std::string whole = text_of(feature, "piece_of"); !whole.empty()) made.piece_of = whole;
      if (const auto whole = wholes_.find(i); whole != wholes_.end()) made.piece_of = whole->second;
    }
    if (made.table == "polygon") made.piece_of = io::lines::stated_unit(feature);
    if (made.table == "polygon" && made.piece_of.empty() && made.name != wanted) made.piece_of = wanted;
    made_.lines.push_back(std::move(made));
  }

  const std::vector<io::lines::Feature>& features_;
  std::vector<std::string> tables_;
  std::map<std::pair<std::string, std::string>, std::vector<Place>> pieces_;  ///< By table and name.
  std::map<std::size_t, std::string> wholes_;                                 ///< Of features that are numbered pieces.
  std::set<std::string> names_;
  std::map<std::pair<std::string, std::string>, std::size_t> repeated_;  ///< How many, by table and name.
  Import made_;
};

std::vector<HorizonInput>& list_of(SectionInput& input, const std::string& table) {
  if (table == "pin") return input.pins;
  if (table == "loose") return input.loose_lines;
  if (table == "topography") return input.topographies;
  if (table == "datum") return input.datums;
  if (table == "eroded") return input.eroded;
  if (table == "polygon") return input.units;
  if (table == "border") return input.borders;
  if (table == "marker") return input.markers;
  return input.horizons;
}

}  // namespace

std::optional<std::pair<std::string, std::size_t>> numbered_name(const std::string& name) {
  const std::size_t open = name.rfind(" (");
  if (open == std::string::npos || open == 0 || name.back() != ')') return std::nullopt;
  std::size_t number = 0;
  const char* begin = name.data() + open + 2;
  const char* end = name.data() + name.size() - 1;
  const auto [read, error] = std::from_chars(begin, end, number);
  if (error != std::errc() || read != end || *begin == '0' || number > 999999) return std::nullopt;
  return std::pair{name.substr(0, open), number};
}

bool is_horizon(const io::lines::Feature& feature) {
  if (feature.type != io::lines::FeatureType::Lines) return false;
  const auto same = [&](const TableOfKind& t) { return io::lines::known_kind(feature.kind) == t.kind; };
  const auto found = std::find_if(tables.begin(), tables.end(), same);
  return feature.kind.empty() || (found != tables.end() && std::string_view(found->table) == "horizon");
}

base::Result<Import> import_lines(const std::vector<io::lines::Feature>& features) { return Importer(features).run(); }

base::Result<SectionInput> with_lines_of_files(SectionInput input, const ReadSettings& settings,
                                               const dobra::scenario::Context& context,
                                               std::vector<std::string>& remarks) {
  for (const LinesInput& wanted : std::exchange(input.lines, {})) {
    DOBRA_TRY(const io::formats::LineWork work,
              work_of_file(wanted, (context.folder / wanted.file).string(), settings));
    remarks.insert(remarks.end(), work.remarks.begin(), work.remarks.end());
    for (const io::formats::Repair& repair : work.repairs) remarks.push_back(io::formats::to_string(repair));
    DOBRA_TRY(Import import, import_lines(work.features));
    remarks.insert(remarks.end(), import.remarks.begin(), import.remarks.end());
    for (ImportedLine& line : import.lines) {
      HorizonInput made;
      made.name = std::move(line.name);
      made.file = wanted.file;
      made.piece_of = std::move(line.piece_of);
      made.role = line.role;
      made.unit = wanted.unit;
      if (line.table == "horizon") made.join_gaps = wanted.join_gaps;
      made.placed = PlacedLine{std::move(line.line), work.trace};
      if (line.table == "fault") {
        FaultInput& fault = input.faults.emplace_back(std::move(made));
        if (line.order > 0) fault.age = line.order;
        fault.hanging_wall = line.hanging_wall;
      } else {
        list_of(input, line.table).push_back(std::move(made));
      }
    }
  }
  return input;
}

void tell_numbered_names(const SectionInput& input, ReadSection& read) {
  const auto tell = [&](const auto& inputs, const char* kind, auto&& words, auto&& line_of) {
    std::map<std::string, std::size_t> members;
    std::map<std::string, std::vector<std::string>> alone;  // those that do not say what they are pieces of
    for (const auto& line : inputs) {
      const auto numbered = numbered_name(line.name);
      if (!numbered) continue;
      ++members[numbered->first];
      if (line.piece_of.empty()) alone[numbered->first].push_back(line.name);
    }
    for (const auto& [whole, names] : alone) {
      if (members[whole] < 2) continue;
      std::string text = words(fmt::format("'{}'", fmt::join(names, "', '")), whole);
      if (const geom::Polyline* const line = line_of(names.front()))
        read.places[text] = geom::place_at(line->points.front(), fmt::format("{} '{}'", kind, names.front()));
      read.remarks.push_back(std::move(text));
    }
  };
  tell(
      input.horizons, "horizon",
      [](const std::string& names, const std::string& whole) {
        return fmt::format(
            "{}: numbers in names make no pieces, so that these are beds of their own, and their ends "
            "within the section are not looked at; if they are pieces of one horizon, give each of them "
            "piece_of = \"{}\"",
            names, whole);
      },
      [&](const std::string& name) {
        const section::Horizon* const horizon = find_horizon(read.section, name);
        return horizon != nullptr ? &horizon->line : nullptr;
      });
  tell(
      input.faults, "fault",
      [](const std::string& names, const std::string& whole) {
        return fmt::format(
            "{}: numbers in names make no pieces, so that these are faults of their own; if they are "
            "pieces of one fault, give each of them piece_of = \"{}\"",
            names, whole);
      },
      [&](const std::string& name) {
        const auto& lines = read.section.lines;
        const auto same = [&](const section::SectionLine& line) {
          return line.kind == section::LineKind::Fault && line.name == name;
        };
        const auto found = std::find_if(lines.begin(), lines.end(), same);
        return found != lines.end() ? &found->line : nullptr;
      });
}

}  // namespace recon::input
