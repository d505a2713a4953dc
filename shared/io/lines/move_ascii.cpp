#include "shared/io/lines/move_ascii.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/lines/line_kinds.h"
#include "shared/io/scan.h"

namespace dobra::io::lines {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

/// Blanks within a field: a tab parts fields.
constexpr std::string_view no_tab = " \r\v\f";

// Fields between tabs; where there are none, between blanks (an editor may have changed them).
void split_row(std::string_view line, std::vector<Word>& fields) {
  if (line.find('\t') == std::string_view::npos) return split_words(line, fields);
  fields.clear();
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find('\t', begin), line.size());
    fields.push_back({base::trimmed(line.substr(begin, end - begin), no_tab), begin + 1});
    begin = end + 1;
  }
}

class MoveAsciiReader {
 public:
  MoveAsciiReader(std::string_view text, const std::string& file) : lines_(text), file_(file) {}

  Result<Features> run() {
    while (lines_.next()) {
      if (lines_.line().find_first_not_of(" \t\v\f") == std::string_view::npos) {
        DOBRA_TRY_VOID(finish());
        continue;
      }
      split_row(lines_.line(), fields_);
      if (std::exchange(first_, false) && is_header()) continue;
      DOBRA_TRY_VOID(add_row());
    }
    DOBRA_TRY_VOID(finish());
    if (features_.features.empty()) {
      return Error{ErrorCode::EmptyFile, "the file holds no points", Place{.file = file_}};
    }
    if (repeated_ > 0) features_.remarks.push_back(fmt::format("{}: {} repeated points dropped", file_, repeated_));
    if (varying_ > 0) {
      features_.remarks.push_back(
          fmt::format("{}: attributes of {} lines change along the line and are not kept", file_, varying_));
    }
    return std::move(features_);
  }

 private:
  [[nodiscard]] std::string_view field(std::size_t i) const {
    return i < fields_.size() ? fields_[i].text : std::string_view{};
  }

  [[nodiscard]] bool is_header() const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (base::parse_number(field(i))) return false;
    }
    return true;
  }

  [[nodiscard]] Result<double> number(std::size_t i, std::string_view what) const {
    Result<double> value = finite_number(field(i), what);
    if (value) return value;
    const std::size_t column = i < fields_.size() ? fields_[i].column : lines_.line().size() + 1;
    return base::located(value.error(), Place{.file = file_, .line = lines_.number(), .column = column});
  }

  Result<void> add_row() {
    DOBRA_TRY(const double x, number(0, "x"));
    DOBRA_TRY(const double y, number(1, "y"));
    DOBRA_TRY(const double z, number(2, "z"));
    if (!heights_.empty() && (field(3) != name_ || field(4) != id_)) DOBRA_TRY_VOID(finish());
    if (heights_.empty()) {
      name_ = field(3);
      id_ = field(4);
      attribute_ = field(5);
      varies_ = false;
      begin_ = lines_.number();
    }
    varies_ = varies_ || field(5) != attribute_;
    line_.points.push_back({x, y});
    heights_.push_back(z);
    return {};
  }

  // Ends the current line.
  Result<void> finish() {
    if (heights_.empty()) return {};
    Feature feature;
    feature.source = Place{.file = file_, .line = begin_};
    feature.name = name_;
    if (!id_.empty()) feature.properties.emplace_back("id", id_value());
    feature.kind = varies_ ? "" : known_kind(attribute_).value_or("");
    if (feature.kind.empty() && !attribute_.empty() && !varies_)
      feature.properties.emplace_back("attribute", attribute_);
    varying_ += varies_ ? 1 : 0;
    const std::size_t count = heights_.size();
    const bool closed = count > 3 && line_.points.front() == line_.points.back() && heights_.front() == heights_.back();
    feature.type = count == 1 ? FeatureType::Points : closed ? FeatureType::Polygons : FeatureType::Lines;
    feature.parts.push_back(std::exchange(line_, {}));
    feature.heights.push_back(std::exchange(heights_, {}));
    const Result<std::size_t> repeated = normalise(feature, {0});
    if (!repeated) return base::located(repeated.error(), feature.source);
    repeated_ += *repeated;
    features_.features.push_back(std::move(feature));
    return {};
  }

  // A whole number where it is one and is written as we would write it.
  [[nodiscard]] PropertyValue id_value() const {
    const auto value = base::parse_number(id_);
    const bool whole = value && std::abs(*value) < 1e15 && *value == std::floor(*value);
    if (whole && fmt::format("{}", static_cast<std::int64_t>(*value)) == id_) return static_cast<std::int64_t>(*value);
    return id_;
  }

  Lines lines_;
  std::string file_;
  std::vector<Word> fields_;
  bool first_ = true;
  std::string name_;
  std::string id_;
  std::string attribute_;
  bool varies_ = false;
  std::size_t begin_ = 0;
  geom::Polyline line_;
  std::vector<double> heights_;
  Features features_;
  std::size_t repeated_ = 0;
  std::size_t varying_ = 0;
};

// Text of a property, or nothing.
std::string property(const Feature& feature, std::string_view wanted) {
  for (const auto& [key, value] : feature.properties) {
    if (key != wanted) continue;
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *integer);
    if (const auto* number = std::get_if<double>(&value)) return base::number_text(*number);
    return std::get<bool>(value) ? "true" : "false";
  }
  return {};
}

}  // namespace

std::string move_name(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\0' || c == '\t' || c == '\n' || c == '\r'; }, ' ');
  return std::string(base::trimmed(name, no_tab));
}

Result<Features> parse_move_ascii(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  return MoveAsciiReader(text, file).run();
}

Result<Features> read_move_ascii(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_move_ascii(text, path);
}

Result<std::string> move_ascii(std::span<const Feature> given) {
  const std::vector<Feature> features = rings_apart(given);
  std::string text;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Feature& feature = features[i];
    std::string id = move_name(property(feature, "id"));
    if (id.empty()) id = fmt::format("{}", i + 1);
    std::string attribute = feature.kind.empty() ? property(feature, "attribute") : feature.kind;
    attribute = known_kind(attribute).value_or(attribute);  // as it is read back
    const std::string tail = '\t' + move_name(feature.name) + '\t' + id + '\t' + move_name(attribute) + '\n';
    for (std::size_t part = 0; part < feature.parts.size(); ++part) {
      const std::vector<geom::Point>& points = feature.parts[part].points;
      DOBRA_TRY_VOID(check_finite(points, item_of(i + 1, feature)));
      // Points of one feature would read back as a line.
      const bool apart = feature.type == FeatureType::Points;
      for (std::size_t k = 0; k < points.size() + (feature.parts[part].closed ? 1 : 0); ++k) {
        const std::size_t at = k == points.size() ? 0 : k;
        if (!text.empty() && (k == 0 || apart)) text += '\n';
        base::append_number(text, points[at].x);
        text += '\t';
        base::append_number(text, points[at].y);
        text += '\t';
        base::append_number(text, feature.heights[part][at]);
        text += tail;
      }
    }
  }
  return text;
}

}  // namespace dobra::io::lines
