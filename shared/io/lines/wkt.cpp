#include "shared/io/lines/wkt.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/scan.h"

namespace dobra::io::lines {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using geom::Point;
using geom::Polyline;

namespace {

struct Kind {
  std::string_view word;
  FeatureType type;
  bool multi;
};

constexpr std::array kinds{
    Kind{"POINT", FeatureType::Points, false},     Kind{"MULTIPOINT", FeatureType::Points, true},
    Kind{"LINESTRING", FeatureType::Lines, false}, Kind{"MULTILINESTRING", FeatureType::Lines, true},
    Kind{"POLYGON", FeatureType::Polygons, false}, Kind{"MULTIPOLYGON", FeatureType::Polygons, true}};

constexpr std::array<std::string_view, 9> not_read{"GEOMETRYCOLLECTION", "CIRCULARSTRING",    "COMPOUNDCURVE",
                                                   "CURVEPOLYGON",       "MULTICURVE",        "MULTISURFACE",
                                                   "TRIANGLE",           "POLYHEDRALSURFACE", "TIN"};

class WktReader {
 public:
  WktReader(std::string_view text, const std::string& file, Faulty faulty) : text_(text), file_(file), faulty_(faulty) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  Result<Features> run() {
    Features result;
    while (skip_blanks(), at_ < text_.size()) {
      ++number_;
      DOBRA_TRY(std::optional<Feature> feature, geometry());
      if (feature) result.features.push_back(*std::move(feature));
      skip_blanks();
      if (peek() == ';') ++at_;
    }
    result.remarks = std::move(open_);
    if (dropped_coordinates_ > 0) {
      result.remarks.push_back(
          fmt::format("{}: third and further coordinates of {} points dropped", file_, dropped_coordinates_));
    }
    if (repeated_ > 0) result.remarks.push_back(fmt::format("{}: {} repeated points dropped", file_, repeated_));
    result.remarks.insert(result.remarks.end(), left_out_.begin(), left_out_.end());
    return result;
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }
  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  [[nodiscard]] Place here() const { return place_of_byte(text_, at_, file_); }

  // What stands at the current position, for messages.
  std::string found() const {
    if (at_ >= text_.size()) return "the text ends";
    return fmt::format("found {}", shown(text_.substr(at_, text_.find_first_of("\r\n", at_) - at_)));
  }
  Error expected(std::string_view what) const {
    return Error{ErrorCode::BadFormat, fmt::format("{} is needed here, but {}", what, found()), here()};
  }
  Result<void> take(char c) {
    skip_blanks();
    if (peek() != c) return expected(fmt::format("'{}'", c));
    ++at_;
    return {};
  }
  // Takes ',' (more follows) or ')' (the list ends).
  Result<bool> more() {
    skip_blanks();
    if (peek() != ',' && peek() != ')') return expected("',' or ')'");
    return text_[at_++] == ',';
  }

  std::string word() {
    skip_blanks();
    std::string result;
    while (std::isalpha(static_cast<unsigned char>(peek()))) {
      result += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[at_++])));
    }
    return result;
  }

  /// Passes over "(...)", whatever stands in it.
  Result<void> pass_over() {
    DOBRA_TRY_VOID(take('('));
    for (int depth = 1; depth > 0; ++at_) {
      if (at_ >= text_.size()) return expected("')'");
      depth += text_[at_] == '(' ? 1 : text_[at_] == ')' ? -1 : 0;
    }
    return {};
  }

  /// Nothing where it is left out.
  Result<std::optional<Feature>> geometry() {
    const Place start = here();
    const std::string name = word();
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.word == name; });
    if (kind == kinds.end()) {
      if (name.empty()) return expected("a geometry such as LINESTRING");
      if (const bool known = std::find(not_read.begin(), not_read.end(), name) != not_read.end();
          known && faulty_ == Faulty::Skip) {
        DOBRA_TRY_VOID(pass_over());
        left_out_.push_back(fmt::format("{}: {} is not read; left out", here_is(start), name));
        return std::optional<Feature>();
      }
      std::vector<std::string> names;
      for (const Kind& k : kinds) names.emplace_back(k.word);
      return Error{ErrorCode::BadFormat,
                   fmt::format("geometry {} is not one of POINT, LINESTRING, POLYGON and their MULTI forms{}",
                               shown(name), base::did_you_mean(name, names)),
                   start};
    }
    Feature feature;
    feature.type = kind->type;
    std::size_t before = at_;
    std::string flag = word();
    if (flag == "Z" || flag == "M" || flag == "ZM") before = at_, flag = word();
    if (flag == "EMPTY") return std::optional(std::move(feature));
    at_ = before;
    std::vector<std::size_t> ring_of_polygon;
    if (auto read = body(*kind, feature, ring_of_polygon); !read) return read.error();
    if (const std::string open = open_rings(feature); !open.empty())
      open_.push_back(fmt::format("{}:{}: {}", file_, start.line, open));
    const Result<std::size_t> repeated = faulty_ == Faulty::Refuse
                                             ? normalise(feature, ring_of_polygon)
                                             : normalise_sound(feature, ring_of_polygon, here_is(start), left_out_);
    if (!repeated) return base::located(repeated.error(), start);
    repeated_ += *repeated;
    if (feature.parts.empty()) return std::optional<Feature>();
    return std::optional(std::move(feature));
  }
  [[nodiscard]] std::string here_is(const Place& start) const {
    return fmt::format("{}: geometry {}", where(start), number_);
  }

  Result<void> body(const Kind& kind, Feature& feature, std::vector<std::size_t>& ring_of_polygon) {
    if (kind.type == FeatureType::Points) {
      DOBRA_TRY(Polyline part, points());
      if (!kind.multi && part.points.size() != 1) return expected("one point in a POINT; use MULTIPOINT; that");
      feature.parts.push_back(std::move(part));
      return {};
    }
    if (kind.type == FeatureType::Lines && !kind.multi) {
      DOBRA_TRY(Polyline part, points());
      feature.parts.push_back(std::move(part));
      return {};
    }
    if (!kind.multi || kind.type == FeatureType::Lines) return rings(feature, ring_of_polygon);
    DOBRA_TRY_VOID(take('('));
    while (true) {
      DOBRA_TRY_VOID(rings(feature, ring_of_polygon));
      DOBRA_TRY(const bool another, more());
      if (!another) return {};
    }
  }

  // "((...), (...))", counted from 0.
  Result<void> rings(Feature& feature, std::vector<std::size_t>& ring_of_polygon) {
    DOBRA_TRY_VOID(take('('));
    for (std::size_t ring = 0;; ++ring) {
      DOBRA_TRY(Polyline part, points());
      feature.parts.push_back(std::move(part));
      ring_of_polygon.push_back(ring);
      DOBRA_TRY(const bool another, more());
      if (!another) return {};
    }
  }

  // "(x y, x y)" or, as MULTIPOINT may, "((x y), (x y))".
  Result<Polyline> points() {
    DOBRA_TRY_VOID(take('('));
    Polyline part;
    while (true) {
      skip_blanks();
      const bool wrapped = peek() == '(';
      if (wrapped) ++at_;
      DOBRA_TRY(const double x, number("x"));
      DOBRA_TRY(const double y, number("y"));
      part.points.push_back({x, y});
      bool extra = false;
      while (skip_blanks(), peek() != ',' && peek() != ')') {
        DOBRA_TRY_VOID(number("a further coordinate"));
        extra = true;
      }
      dropped_coordinates_ += extra ? 1 : 0;
      if (wrapped) DOBRA_TRY_VOID(take(')'));
      DOBRA_TRY(const bool another, more());
      if (!another) return part;
    }
  }

  Result<double> number(std::string_view what) {
    skip_blanks();
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n\v\f,();", at_), text_.size());
    Result<double> value = finite_number(text_.substr(at_, end - at_), what);
    if (!value) return base::located(value.error(), here());
    at_ = end;
    return value;
  }

  std::string_view text_;
  std::string file_;
  Faulty faulty_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
  std::vector<std::string> left_out_;
  std::size_t dropped_coordinates_ = 0;
  std::size_t repeated_ = 0;
  std::vector<std::string> open_;  ///< Remarks on rings that were closed.
};

std::string points_text(const Polyline& part) {
  std::string text = "(";
  for (const Point p : part.points) {
    if (text.size() > 1) text += ", ";
    text += base::number_text(p.x) + ' ' + base::number_text(p.y);
  }
  if (part.closed) text += ", " + base::number_text(part.points[0].x) + ' ' + base::number_text(part.points[0].y);
  return text + ')';
}

std::string parts_text(const Feature& feature, std::size_t first, std::size_t last) {
  std::string text = "(";
  for (std::size_t i = first; i < last; ++i) text += (i > first ? ", " : "") + points_text(feature.parts[i]);
  return text + ')';
}

std::string geometry_text(const Feature& feature) {
  const bool none = feature.parts.empty() || feature.parts[0].points.empty();
  if (feature.type == FeatureType::Points) {
    if (none) return "MULTIPOINT EMPTY";
    return (feature.parts[0].points.size() == 1 ? "POINT " : "MULTIPOINT ") + points_text(feature.parts[0]);
  }
  if (feature.type == FeatureType::Lines) {
    if (none) return "LINESTRING EMPTY";
    if (feature.parts.size() == 1) return "LINESTRING " + points_text(feature.parts[0]);
    return "MULTILINESTRING " + parts_text(feature, 0, feature.parts.size());
  }
  if (none) return "POLYGON EMPTY";
  const auto polygons = polygons_of(feature);
  if (polygons.size() == 1) return "POLYGON " + parts_text(feature, 0, feature.parts.size());
  std::string text;
  for (const auto& [first, last] : polygons) text += (text.empty() ? "" : ", ") + parts_text(feature, first, last);
  return "MULTIPOLYGON (" + text + ')';
}

}  // namespace

Result<Features> parse_wkt(std::string_view text, const std::string& file, Faulty faulty) {
  DOBRA_TRY_VOID(check_text(text, file));
  return WktReader(text, file, faulty).run();
}

Result<Features> read_wkt(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_wkt(text, path);
}

Result<std::string> wkt(std::span<const Feature> features) {
  std::string text;
  for (std::size_t i = 0; i < features.size(); ++i) {
    for (const Polyline& part : features[i].parts) {
      DOBRA_TRY_VOID(check_finite(part.points, fmt::format("geometry {}", i + 1)));
    }
    text += geometry_text(features[i]) + '\n';
  }
  return text;
}

Result<void> write_wkt(const std::string& path, std::span<const Feature> features) {
  return write_text(path, wkt(features));
}

}  // namespace dobra::io::lines
