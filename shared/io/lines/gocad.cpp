// 1. Objects one after another; groups only wrap them.
// 2. In an object: the header gives the name, the coordinate system what z and the units mean, then vertices and
//    segments.
// 3. At the object's end the segments, as a graph over its vertices, become paths.

#include "shared/io/lines/gocad.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>

#include "shared/base/text.h"
#include "shared/io/axis_units.h"
#include "shared/io/file.h"
#include "shared/io/scan.h"

namespace dobra::io::lines {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

std::string lower(std::string_view text) {
  std::string made(text);
  std::transform(made.begin(), made.end(), made.begin(),
                 [](unsigned char c) { return static_cast<char>(c < 128 ? std::tolower(c) : c); });
  return made;
}

struct Vertex {
  geom::Point point;
  double height = 0.0;
};

// What is known of the object that is being read.
struct Object {
  std::string type;  // in small letters
  std::size_t begin = 0;
  std::string name;
  std::string kind;
  std::string feature;
  std::vector<Vertex> vertices;
  std::vector<std::size_t> chain_begins;  // number of the first vertex of each ILINE
  std::unordered_map<std::int64_t, std::size_t> numbers;
  std::vector<std::vector<std::size_t>> neighbours;  // of each vertex, in the order of the segments
  std::size_t segments = 0;
  bool has_direction = false;
};

using Path = std::vector<std::size_t>;
struct Paths {
  std::vector<Path> open;
  std::vector<Path> closed;
  std::size_t branches = 0;
  std::size_t alone = 0;
};

// Follows unused segments from `from` through `to` until the path ends, branches or returns.
Path follow(const Object& object, std::vector<std::vector<bool>>& used, std::size_t from, std::size_t way) {
  Path path{from};
  std::size_t at = from;
  while (true) {
    const std::size_t next = object.neighbours[at][way];
    used[at][way] = true;
    const auto& back = object.neighbours[next];
    used[next][static_cast<std::size_t>(std::find(back.begin(), back.end(), at) - back.begin())] = true;
    path.push_back(next);
    at = next;
    if (back.size() != 2 || at == from) return path;
    if (used[at][0] && used[at][1]) return path;
    way = used[at][0] ? 1 : 0;
  }
}

Paths paths_of(const Object& object) {
  Paths found;
  if (object.segments == 0) {
    // Some writers leave the segments out: then every ILINE is a path.
    std::vector<std::size_t> limits = object.chain_begins;
    limits.insert(limits.begin(), 0);
    limits.push_back(object.vertices.size());
    for (std::size_t i = 0; i + 1 < limits.size(); ++i) {
      Path path;
      for (std::size_t k = limits[i]; k < limits[i + 1]; ++k) path.push_back(k);
      if (path.size() == 1) ++found.alone;
      if (path.size() > 1) found.open.push_back(std::move(path));
    }
    return found;
  }
  std::vector<std::vector<bool>> used;
  for (const auto& list : object.neighbours) used.emplace_back(list.size(), false);
  // Ends and branches first; what is left then are rings.
  for (const bool rings : {false, true}) {
    for (std::size_t i = 0; i < object.vertices.size(); ++i) {
      const std::size_t degree = object.neighbours[i].size();
      if (!rings && degree == 0) ++found.alone;
      if (!rings && degree > 2) ++found.branches;
      if ((degree == 2) != rings) continue;
      for (std::size_t way = 0; way < degree; ++way) {
        if (used[i][way]) continue;
        Path path = follow(object, used, i, way);
        (path.front() == path.back() ? found.closed : found.open).push_back(std::move(path));
      }
    }
  }
  return found;
}

class GocadReader {
 public:
  GocadReader(std::string_view text, const std::string& file) : lines_(text), file_(file) {}

  Result<Features> run() {
    while (next_words()) {
      const std::string key = lower(words_[0].text);
      if (key == "gocad") {
        DOBRA_TRY_VOID(begin_object());
      } else if (!object_) {
        if (groups_ == 0)
          return error(0, fmt::format("{} stands outside any GOCAD object; an object begins with a "
                                      "line such as 'GOCAD PLine 1'",
                                      shown(words_[0].text)));
        if (key == "end") --groups_;
      } else {
        DOBRA_TRY_VOID(object_line(key));
      }
    }
    if (object_ || groups_ > 0) {
      return Error{ErrorCode::BadFormat, "the file ends before END; it may have been cut short",
                   Place{.file = file_, .line = lines_.number()}};
    }
    return finish();
  }

 private:
  bool next_words() {
    while (lines_.next()) {
      split_words(lines_.line(), words_);
      if (!words_.empty() && words_[0].text[0] != '#') return true;
    }
    return false;
  }
  [[nodiscard]] std::string_view word(std::size_t i) const {
    return i < words_.size() ? words_[i].text : std::string_view{};
  }
  [[nodiscard]] Place place(std::size_t i) const {
    return Place{.file = file_,
                 .line = lines_.number(),
                 .column = i < words_.size() ? words_[i].column : lines_.line().size() + 1};
  }
  [[nodiscard]] Error error(std::size_t i, std::string message) const {
    return {ErrorCode::BadFormat, std::move(message), place(i)};
  }
  void say(const std::string& remark) { features_.remarks.push_back(file_ + ": " + remark); }

  Result<void> begin_object() {
    if (object_)
      return error(0, fmt::format("a new object before END of the one that began at line {}", object_->begin));
    const std::string type = lower(word(1));
    if (type.ends_with("group")) {
      ++groups_;
      return {};
    }
    object_.emplace();
    object_->type = type;
    object_->begin = lines_.number();
    return {};
  }

  Result<void> object_line(const std::string& key) {
    if (key == "end") {
      DOBRA_TRY_VOID(end_object());
      object_.reset();
      return {};
    }
    if (key.starts_with("header")) return header();
    if (object_->type != "pline" && object_->type != "vset") return {};
    if (key == "vrtx" || key == "pvrtx") return vertex(key == "pvrtx");
    if (key == "atom" || key == "patom") return atom();
    if (key == "seg") return segment();
    if (key == "iline") object_->chain_begins.push_back(object_->vertices.size());
    if (key == "zpositive") return z_positive();
    if (key == "axis_unit") return axis_unit();
    if (key == "geological_type") object_->kind = lower(word(1)) == "top" ? "horizon" : std::string(word(1));
    if (key == "geological_feature")
      object_->feature = base::trimmed(lines_.line().substr(words_[0].column - 1 + key.size()));
    if (key == "property_class_header") return skip_braces();
    return {};  // what else an object can say does not concern lines
  }

  // From the line with '{' to the one with '}'.
  Result<void> header() {
    const std::size_t begin = lines_.number();
    std::string_view rest = lines_.line();
    std::size_t open = rest.find('{');
    bool alone = false;  // on a line of its own an entry has no others behind it
    while (open == std::string_view::npos) {
      if (!lines_.next()) return unclosed(begin);
      rest = lines_.line();
      open = rest.find('{');
    }
    rest.remove_prefix(open + 1);
    while (true) {
      const std::size_t close = rest.find('}');
      name_in(rest.substr(0, close), alone);
      if (close != std::string_view::npos) return {};
      if (!lines_.next()) return unclosed(begin);
      rest = lines_.line();
      alone = true;
    }
  }

  void name_in(std::string_view entry, bool alone) {
    entry = base::trimmed(entry);
    if (entry.starts_with('*')) entry.remove_prefix(1);
    if (!lower(entry.substr(0, 4)).starts_with("name")) return;
    entry = base::trimmed(entry.substr(4));
    if (entry.empty() || (entry[0] != ':' && entry[0] != '=')) return;
    entry.remove_prefix(1);
    object_->name = base::trimmed(alone ? entry : entry.substr(0, entry.find(" *")));
  }

  Result<void> skip_braces() {
    const std::size_t begin = lines_.number();
    if (lines_.line().find('{') == std::string_view::npos) return {};
    while (lines_.line().find('}') == std::string_view::npos) {
      if (!lines_.next()) return unclosed(begin);
    }
    return {};
  }

  [[nodiscard]] Error unclosed(std::size_t begin) const {
    return {ErrorCode::BadFormat, "the braces that begin here are not closed; the file may have been cut short",
            Place{.file = file_, .line = begin}};
  }

  Result<void> z_positive() {
    const std::string value = lower(word(1));
    if (value != "elevation" && value != "depth") {
      return error(1, fmt::format("ZPOSITIVE {} is neither Elevation nor Depth", shown(word(1))));
    }
    const YDirection direction = value == "depth" ? YDirection::Down : YDirection::Up;
    if (features_.stated.y_direction && *features_.stated.y_direction != direction) {
      return error(1, "some objects of this file have elevations and others depths; split the file");
    }
    features_.stated.y_direction = direction;
    object_->has_direction = true;
    return {};
  }

  Result<void> axis_unit() {
    const AxisUnits units = axis_units(lines_.line().substr(words_[0].column - 1 + words_[0].text.size()));
    const std::vector<double>& metres = units.metres;
    if (!units.unknown.empty()) unknown_unit_ = units.unknown;
    if (metres.size() != 3) return {};
    if (metres[0] != metres[1] || (features_.stated.unit && *features_.stated.unit != metres[0]) ||
        (features_.stated.height_unit && *features_.stated.height_unit != metres[2])) {
      return error(1, "AXIS_UNIT differs between x and y or between objects; split the file");
    }
    features_.stated.unit = metres[0];
    features_.stated.height_unit = metres[2];
    return {};
  }

  Result<double> number(std::size_t i, std::string_view what) const {
    Result<double> value = finite_number(word(i), what);
    if (!value) return base::located(value.error(), place(i));
    return value;
  }

  Result<std::int64_t> integer(std::size_t i, std::string_view what) const {
    const auto value = base::parse_number(word(i));
    if (value && std::abs(*value) < 9e15 && *value == std::floor(*value)) return static_cast<std::int64_t>(*value);
    return error(i, fmt::format("{} {} is not a whole number", what, shown(word(i))));
  }

  // The vertex of that number in this object.
  Result<std::size_t> known(std::size_t i) const {
    DOBRA_TRY(const std::int64_t id, integer(i, "the number of a vertex"));
    const auto at = object_->numbers.find(id);
    if (at == object_->numbers.end()) return error(i, fmt::format("there is no vertex {} before this line", id));
    return at->second;
  }

  Result<void> add_vertex(std::int64_t id, const Vertex& vertex) {
    if (!object_->numbers.emplace(id, object_->vertices.size()).second) {
      return error(1, fmt::format("there are two vertices {}", id));
    }
    object_->vertices.push_back(vertex);
    object_->neighbours.emplace_back();
    return {};
  }

  Result<void> vertex(bool with_properties) {
    DOBRA_TRY(const std::int64_t id, integer(1, "the number of a vertex"));
    DOBRA_TRY(const double x, number(2, "x"));
    DOBRA_TRY(const double y, number(3, "y"));
    DOBRA_TRY(const double z, number(4, "z"));
    properties_ = properties_ || (with_properties && words_.size() > 5);
    return add_vertex(id, {{x, y}, z});
  }

  Result<void> atom() {
    DOBRA_TRY(const std::int64_t id, integer(1, "the number of a vertex"));
    DOBRA_TRY(const std::size_t same, known(2));
    return add_vertex(id, object_->vertices[same]);
  }

  Result<void> segment() {
    DOBRA_TRY(const std::size_t a, known(1));
    DOBRA_TRY(const std::size_t b, known(2));
    if (a == b) return error(1, "a segment joins a vertex to itself; remove it");
    std::vector<std::size_t>& from = object_->neighbours[a];
    if (std::find(from.begin(), from.end(), b) != from.end()) return {};  // said twice
    from.push_back(b);
    object_->neighbours[b].push_back(a);
    ++object_->segments;
    return {};
  }

  Result<void> end_object() {
    if (object_->type == "pline" || object_->type == "vset") {
      doubtful_ = doubtful_ || !object_->has_direction;
    } else {
      ++left_out_[object_->type];
      return {};
    }
    if (object_->vertices.empty()) {
      say(fmt::format("object {} has no vertices, left out", shown(object_->name)));
      return {};
    }
    if (object_->type == "vset") {
      Path all;
      for (std::size_t i = 0; i < object_->vertices.size(); ++i) all.push_back(i);
      return add(FeatureType::Points, {all});
    }
    const Paths paths = paths_of(*object_);
    if (paths.branches > 0)
      say(fmt::format("object {} branches at {} vertices and is split there", shown(object_->name), paths.branches));
    if (paths.alone > 0)
      say(fmt::format("object {}: {} vertices that no segment uses dropped", shown(object_->name), paths.alone));
    if (!paths.open.empty()) DOBRA_TRY_VOID(add(FeatureType::Lines, paths.open));
    for (const Path& ring : paths.closed) DOBRA_TRY_VOID(add(FeatureType::Polygons, {ring}));
    return {};
  }

  Result<void> add(FeatureType type, const std::vector<Path>& paths) {
    Feature feature;
    feature.type = type;
    feature.name = object_->name;
    feature.kind = object_->kind;
    feature.source = Place{.file = file_, .line = object_->begin};
    if (!object_->feature.empty()) feature.properties.emplace_back("geological_feature", object_->feature);
    for (const Path& path : paths) {
      geom::Polyline& part = feature.parts.emplace_back();
      std::vector<double>& heights = feature.heights.emplace_back();
      for (const std::size_t i : path) {
        part.points.push_back(object_->vertices[i].point);
        heights.push_back(object_->vertices[i].height);
      }
    }
    const Result<std::size_t> repeated = normalise(feature, std::vector<std::size_t>(paths.size(), 0));
    if (!repeated) {
      return base::located(repeated.error(), Place{.file = file_, .line = object_->begin, .item = shown(feature.name)});
    }
    if (*repeated > 0) say(fmt::format("object {}: {} repeated points dropped", shown(feature.name), *repeated));
    features_.features.push_back(std::move(feature));
    return {};
  }

  Result<Features> finish() {
    for (const auto& [type, count] : left_out_) {
      say(fmt::format("{} of type {} left out: only PLine and VSet are read", count, type));
    }
    if (features_.features.empty()) {
      return Error{ErrorCode::BadFormat, "there is no PLine and no VSet in the file", Place{.file = file_}};
    }
    if (properties_) say("properties of vertices are not kept");
    if (doubtful_) {
      features_.stated.y_direction.reset();
      features_.stated.questions.push_back(
          {Question::About::YDirection,
           "the file does not say by ZPOSITIVE whether z is elevation or depth; give y_axis = up or down (--y-axis)"});
    }
    if (!unknown_unit_.empty()) {
      features_.stated.unit.reset();
      features_.stated.height_unit.reset();
      features_.stated.questions.push_back(
          {Question::About::Unit,
           fmt::format("AXIS_UNIT {} is not m, km or ft; give unit = m, km or ft (--unit)", shown(unknown_unit_))});
    }
    return std::move(features_);
  }

  Lines lines_;
  std::string file_;
  std::vector<Word> words_;
  std::optional<Object> object_;
  std::size_t groups_ = 0;
  Features features_;
  std::map<std::string, std::size_t> left_out_;
  bool properties_ = false;
  bool doubtful_ = false;
  std::string unknown_unit_;
};

// The opening of an object, up to its first vertex.
std::string opening(const Feature& feature, std::string_view type) {
  std::string text = fmt::format(
      "GOCAD {} 1\nHEADER {{\nname:{}\n}}\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME Default\nAXIS_NAME \"X\" \"Y\" "
      "\"Z\"\nAXIS_UNIT \"m\" \"m\" \"m\"\nZPOSITIVE Elevation\nEND_ORIGINAL_COORDINATE_SYSTEM\n",
      type, gocad_name(feature.name));
  for (const auto& [key, value] : feature.properties) {
    const auto* name = std::get_if<std::string>(&value);
    if (key == "geological_feature" && name != nullptr) text += "GEOLOGICAL_FEATURE " + gocad_name(*name) + '\n';
  }
  std::string kind = feature.kind == "horizon" || lower(feature.kind) == "top" ? "top" : gocad_name(feature.kind);
  std::replace_if(
      kind.begin(), kind.end(), [](unsigned char c) { return std::isspace(c) != 0; }, '_');
  if (!kind.empty()) text += "GEOLOGICAL_TYPE " + kind + '\n';
  return text;
}

void append_vertices(std::string& text, const Feature& feature, std::size_t part, std::size_t first) {
  const std::vector<geom::Point>& points = feature.parts[part].points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += fmt::format("VRTX {} ", first + i);
    base::append_number(text, points[i].x);
    text += ' ';
    base::append_number(text, points[i].y);
    text += ' ';
    base::append_number(text, feature.heights[part][i]);
    text += '\n';
  }
}

void append_path(std::string& text, const Feature& feature, std::size_t part, std::size_t& first) {
  const geom::Polyline& line = feature.parts[part];
  const std::size_t count = line.points.size();
  text += "ILINE\n";
  append_vertices(text, feature, part, first);
  for (std::size_t i = 0; i + 1 < count; ++i) text += fmt::format("SEG {} {}\n", first + i, first + i + 1);
  if (line.closed) text += fmt::format("SEG {} {}\n", first + count - 1, first);
  first += count;
}

}  // namespace

std::string gocad_name(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\0' || c == '\n' || c == '\r' || c == '{' || c == '}'; },
      ' ');
  return std::string(base::trimmed(name));
}

Result<Features> parse_gocad(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  return GocadReader(text, file).run();
}

Result<Features> read_gocad(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_gocad(text, path);
}

Result<std::string> gocad(std::span<const Feature> given) {
  const std::vector<Feature> features = rings_apart(given);
  std::string text;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Feature& feature = features[i];
    for (const geom::Polyline& part : feature.parts) {
      DOBRA_TRY_VOID(check_finite(part.points, item_of(i + 1, feature)));
    }
    if (feature.type == FeatureType::Points) {
      text += opening(feature, "VSet");
      if (!feature.parts.empty()) append_vertices(text, feature, 0, 1);
      text += "END\n";
      continue;
    }
    std::size_t first = 1;
    for (std::size_t part = 0; part < feature.parts.size(); ++part) {
      if (part == 0) text += opening(feature, "PLine");
      append_path(text, feature, part, first);
      if (part + 1 == feature.parts.size()) text += "END\n";
    }
  }
  return text;
}

}  // namespace dobra::io::lines
