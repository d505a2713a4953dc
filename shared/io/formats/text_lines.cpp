#include "shared/io/formats/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "shared/base/text.h"
#include "shared/io/lines/text_columns.h"
#include "shared/io/lines/text_units.h"
#include "shared/io/scan.h"

namespace dobra::io::formats {

using base::Place;
using base::Result;

namespace {

// Whether the header says that the first two columns are x and height (as in what is written here), or that the third
// holds names, which may be numbers.
bool names_its_columns(const lines::TextPoints& read, const lines::TextPointsOptions& options) {
  static constexpr std::array<std::string_view, 1> x_word{"x"};
  static constexpr std::array<std::string_view, 1> z_word{"z"};
  const std::vector<std::string>& names = options.name_columns;
  const auto is_third = [&](const std::string& column) {
    return column == "3" || (read.header.size() > 2 && column == read.header[2]);
  };
  if (std::any_of(names.begin(), names.end(), is_third)) return true;
  if (read.header.size() < 3) return false;
  return (lines::is_word(read.header[0], x_word) && lines::is_word(read.header[1], z_word)) ||
         lines::is_word(read.header[2], lines::text_name_words) ||
         lines::is_word(read.header[2], lines::text_kind_words);
}

// A third column of numbers may be the height of map coordinates, or anything else.
std::optional<lines::Question> question_of_columns(const lines::TextPoints& read,
                                                   const lines::TextPointsOptions& options) {
  if (!read.third_is_number || names_its_columns(read, options)) return std::nullopt;
  std::string header;
  for (const std::string& name : read.header) header += (header.empty() ? ": " : ", ") + name;
  return lines::Question{
      lines::Question::About::Coordinates,
      fmt::format("the file has {} columns{}; say which are x and height of the section (columns = [1, 2], "
                  "--columns 1,2), or x, y and height of map coordinates (--columns 1,2,3)",
                  read.column_count, header)};
}

/// Columns of words that no header explains: names of lines perhaps. @error Unclear with the place.
Result<void> check_words(std::string_view text, const std::string& file, const lines::TextPointsOptions& options,
                         lines::TextPoints& read) {
  std::vector<std::size_t> used;
  for (const std::string& column : options.columns) used.push_back(static_cast<std::size_t>(std::stoul(column)));
  for (std::size_t i = 0; i < read.header.size(); ++i) {
    if (lines::is_word(read.header[i], lines::text_name_words)) return {};
    if (lines::is_word(read.header[i], lines::text_kind_words)) used.push_back(i + 1);
  }
  if (!options.name_columns.empty()) return {};
  const lines::WordColumn words = lines::word_column(text, read.separator, read.header, used);
  if (words.words == lines::WordsAre::Unclear) return asked(words, file, used[0], used[1]);
  if (words.words == lines::WordsAre::LeftOut) read.remarks.push_back(told(words, file));
  return {};
}

/// The header of the heights, or of the depths.
std::string height_header(const lines::TextPoints& read, const lines::TextPointsOptions& options) {
  const std::string& column = options.columns.back();
  for (std::size_t i = 0; i < read.header.size(); ++i) {
    if (column == read.header[i] || column == fmt::format("{}", i + 1)) return read.header[i];
  }
  return {};
}

/// Depths by the word of the header, if they are not all negative: then they may be heights all the same. Columns that
/// were asked for (`chosen`) are taken as they stand, with a remark.
void note_depths(const lines::TextPoints& read, const std::string& header, bool chosen, lines::Features& features,
                 const std::string& file) {
  if (!lines::says_depth(header)) return;
  if (chosen) {
    features.remarks.push_back(
        fmt::format("{}: the column {} is taken as heights; --y-axis down takes it as depths", file, shown(header)));
    return;
  }
  double least = 0.0;
  double most = 0.0;
  for (const geom::Polyline& line : read.lines) {
    for (const geom::Point p : line.points) least = std::min(least, p.y), most = std::max(most, p.y);
  }
  if (least < 0.0 && most <= 0.0) {
    features.stated.questions.push_back(
        {lines::Question::About::YDirection,
         fmt::format("the header {} says depth, and the values are negative; say whether they grow downwards or "
                     "upwards: give y_axis = up or down (--y-axis)",
                     shown(header))});
    return;
  }
  features.stated.y_direction = lines::YDirection::Down;
}

/// A column that is taken: its header, and the unit that this or the row below states.
struct StatedColumn {
  std::string header;
  lines::HeaderUnit unit;
};

/// @error BadFormat: header and row below contradict each other.
Result<StatedColumn> stated_of(const lines::TextPoints& read, std::size_t column, const Place& at) {
  StatedColumn made;
  if (column > read.header.size()) return made;
  made.header = shown(read.header[column - 1]);
  made.unit = lines::unit_of(read.header[column - 1]);
  if (column > read.units.size()) return made;
  const lines::HeaderUnit below = lines::unit_of(read.header[column - 1] + " (" + read.units[column - 1] + ")");
  using Of = lines::HeaderUnit::Of;
  const bool same = below.of == made.unit.of && below.metres == made.unit.metres;
  const std::string& row = read.units[column - 1];
  if (made.unit.of != Of::Nothing && below.of != Of::Nothing && !same && made.unit.word != "twt" &&
      made.unit.word != "time") {
    return base::Error{base::ErrorCode::BadFormat,
                       fmt::format("the header {} and the unit {} in the row below it are different ones; correct one",
                                   made.header, shown(row)),
                       at};
  }
  if (below.of == Of::Nothing) return made;
  made.unit = below;
  made.header = shown(read.header[column - 1] + " " + row);
  return made;
}

/// Times and degrees are no places in a section. @error BadFormat, Unclear
Result<void> check_length(const StatedColumn& column, Coordinates coordinates, const Place& at) {
  using Of = lines::HeaderUnit::Of;
  if (column.unit.of == Of::Time) {
    return base::Error{base::ErrorCode::BadFormat,
                       fmt::format("the header {} says that the column holds times ({}), and a section is made of "
                                   "lengths; turn the times into depths first, or take another column",
                                   column.header, column.unit.word),
                       at};
  }
  if (column.unit.of != Of::Angle || coordinates != Coordinates::Detect) return {};
  return base::Error{
      base::ErrorCode::Unclear,
      fmt::format("the header {} says that the column holds degrees; project the coordinates to metres "
                  "first, or say that they are no degrees: coordinates = section (--coordinates section)",
                  column.header),
      at};
}

/// What the headers of the columns that are taken say of their units.
/// @error BadFormat: times; units that one unit for all cannot be; Unclear: degrees
Result<void> state_units(const lines::TextPoints& read, const std::string& file, const LineOptions& options,
                         lines::Features& features) {
  using Of = lines::HeaderUnit::Of;
  const Place at{.file = file, .line = read.header_line};
  std::vector<StatedColumn> columns;
  for (const std::size_t column : read.columns) {
    DOBRA_TRY(columns.emplace_back(), stated_of(read, column, at));
    DOBRA_TRY_VOID(check_length(columns.back(), options.coordinates, at));
  }
  const StatedColumn& across = columns.front();
  const StatedColumn& height = columns.back();
  const auto says = [](const StatedColumn& column) { return column.unit.of == Of::Length; };
  const auto same = [](const StatedColumn& a, const StatedColumn& b) {
    return a.unit.of == b.unit.of && a.unit.metres == b.unit.metres;
  };
  if (columns.size() == 3 && !same(across, columns[1]) && (says(across) || says(columns[1]))) {
    return base::Error{base::ErrorCode::BadFormat,
                       fmt::format("the headers {} and {} of the map coordinates state different units; bring both to "
                                   "one",
                                   across.header, columns[1].header),
                       at};
  }
  if (says(across) && says(height) && !same(across, height)) {
    if (options.unit || options.unit_wanted == UnitWanted::OfTheFile) {
      return base::Error{base::ErrorCode::BadFormat,
                         fmt::format("the headers {} and {} state different units, and one is asked for; leave the "
                                     "unit to the file, or bring both columns to one",
                                     across.header, height.header),
                         at};
    }
    features.stated.unit = across.unit.metres;
    features.stated.height_unit = height.unit.metres;
    features.remarks.push_back(fmt::format("{}: {} is taken in {} and {} in {}, as their headers say", file,
                                           across.header, across.unit.word, height.header, height.unit.word));
    return {};
  }
  if (!says(across) && !says(height)) return {};
  const StatedColumn& stated = says(across) ? across : height;
  const StatedColumn& silent = says(across) ? height : across;
  const bool one = says(across) && says(height);
  if (!one && stated.unit.metres == options.silent_unit) return {};
  features.stated.unit = stated.unit.metres;
  if (one || options.unit_wanted == UnitWanted::OfTheFile) return {};
  features.stated.questions.push_back(
      {lines::Question::About::Unit,
       fmt::format("the header {} states a unit, {}, and {} states none; write it in both, or give the unit of both: "
                   "unit = m, km, ft, in, cm or mm (--unit)",
                   stated.header, stated.unit.word, silent.header)});
  return {};
}

/// The i-th line that was read, which is taken.
Result<void> add_line(std::size_t i, const std::string& file, lines::Faulty faulty, lines::TextPoints& read,
                      lines::Features& features) {
  lines::Feature feature;
  feature.type = read.lines[i].closed ? lines::FeatureType::Polygons : lines::FeatureType::Lines;
  feature.name = read.names[i];
  feature.kind = read.kinds[i];
  feature.source = Place{.file = file, .line = read.begins[i]};
  feature.parts.push_back(std::move(read.lines[i]));
  if (!read.heights.empty()) feature.heights.push_back(std::move(read.heights[i]));
  if (!read.extras.empty()) feature.extras.push_back(std::move(read.extras[i]));
  const auto normal = faulty == lines::Faulty::Refuse
                          ? lines::normalise(feature, {0})
                          : lines::normalise_sound(feature, {0}, lines::where(feature.source), features.remarks);
  if (!normal) return base::located(normal.error(), feature.source);
  if (!feature.parts.empty()) features.features.push_back(std::move(feature));
  return {};
}

// The outlines of poly2tri's test files: a line HOLE stands before each inner one. It becomes a blank line, which parts
// lines.
std::string without_hole_words(std::string_view text, std::size_t& count) {
  std::string result(text);
  for (std::size_t begin = 0; begin < result.size();) {
    const std::size_t end = std::min(result.find('\n', begin), result.size());
    const std::string_view line = std::string_view(result).substr(begin, end - begin);
    const std::size_t word = line.find_first_not_of(" \t\r");
    if (word != std::string_view::npos && line.substr(word, line.find_last_not_of(" \t\r") - word + 1) == "HOLE") {
      result.replace(begin + word, 4, "    ");
      ++count;
    }
    begin = end + 1;
  }
  return result;
}

// A field in quotes; the format has no way to write a quote inside.
std::string quoted(std::string text) {
  for (char& c : text) {
    if (c == '"') c = '\'';
    if (c == '\n' || c == '\r') c = ' ';
  }
  const bool plain =
      text.find_first_of(",#") == std::string::npos && (text.empty() || (text.front() != ' ' && text.back() != ' '));
  return plain ? text : '"' + text + '"';
}

}  // namespace

Result<lines::Features> features_of_text(std::string_view given, const std::string& file, const LineOptions& options) {
  std::size_t holes = 0;
  const std::string text = without_hole_words(given, holes);
  lines::TextPointsOptions wanted = options.text;
  const bool chosen = !wanted.columns.empty();
  std::optional<lines::PositionColumns> by_header;
  if (!chosen) {
    DOBRA_TRY(by_header, lines::position_columns(text, wanted.separator, file));
    const lines::PositionColumns columns = by_header.value_or(lines::PositionColumns{});
    wanted.columns = {fmt::format("{}", columns.x), fmt::format("{}", columns.height)};
  }
  if (options.repair.order == PointOrder::AlongTheCurve) {
    wanted.rows = lines::Rows::Gathered;  // what is out of order may be mixed, too
    wanted.closing = lines::Closing::KeepOpen;
  }
  DOBRA_TRY(lines::TextPoints read, lines::parse_text_points(text, file, wanted));
  if (!chosen) DOBRA_TRY_VOID(check_words(text, file, wanted, read));
  lines::Features features{{}, std::move(read.remarks)};
  DOBRA_TRY_VOID(state_units(read, file, options, features));
  if (!options.y_direction) note_depths(read, height_header(read, wanted), chosen, features, file);
  if (holes > 0)
    features.remarks.push_back(fmt::format("{}: {} lines HOLE taken for the beginnings of further lines", file, holes));
  if (by_header) {
    features.remarks.push_back(
        fmt::format("{}: x and height are the columns {} and {} by their headers; --columns "
                    "says others",
                    file, shown(read.header[by_header->x - 1]), shown(read.header[by_header->height - 1])));
  } else if (!chosen && options.coordinates == Coordinates::Detect) {
    if (auto question = question_of_columns(read, wanted)) features.stated.questions.push_back(*std::move(question));
  }
  for (std::size_t i = 0; i < read.lines.size(); ++i) DOBRA_TRY_VOID(add_line(i, file, options.faulty, read, features));
  return features;
}

Result<std::string> text_of(std::span<const lines::Feature> given) {
  const bool map = !given.empty() && !given[0].heights.empty();
  const std::vector<lines::Feature> features = lines::rings_apart(given);
  const bool named =
      std::any_of(features.begin(), features.end(), [](const lines::Feature& f) { return !f.name.empty(); });
  const bool sorted =
      std::any_of(features.begin(), features.end(), [](const lines::Feature& f) { return !f.kind.empty(); });
  std::string text = map ? "x,y,z" : "x,z";
  text += std::string(named ? ",name" : "") + (sorted ? ",kind" : "") + '\n';
  bool first = true;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const lines::Feature& feature = features[i];
    const std::string tail =
        (named ? ',' + quoted(feature.name) : "") + (sorted ? ',' + quoted(feature.kind) : "") + '\n';
    for (std::size_t part = 0; part < feature.parts.size(); ++part) {
      const std::vector<geom::Point>& points = feature.parts[part].points;
      DOBRA_TRY_VOID(check_finite(points, lines::item_of(i + 1, feature)));
      if (!std::exchange(first, false)) text += '\n';
      for (std::size_t k = 0; k < points.size() + (feature.parts[part].closed ? 1 : 0); ++k) {
        const std::size_t at = k == points.size() ? 0 : k;
        base::append_number(text, points[at].x);
        text += ',';
        base::append_number(text, points[at].y);
        if (map) text += ',', base::append_number(text, feature.heights[part][at]);
        text += tail;
      }
    }
  }
  return text;
}

}  // namespace dobra::io::formats
