#include "shared/io/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "shared/io/dxf.h"
#include "shared/io/geojson.h"
#include "shared/io/text_points.h"
#include "shared/io/wkt.h"

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return c < 128 ? static_cast<char>(std::tolower(c)) : static_cast<char>(c); });
  return ending;
}

void add_curve(Curves& curves, std::string name, geom::Polyline line) {
  if (name.empty()) name = fmt::format("curve {}", curves.curves.size() + 1);
  curves.curves.push_back({std::move(name), std::move(line)});
}

Result<Curves> from_text(const std::string& path) {
  TextPointsOptions options;
  options.blank_lines = BlankLines::SplitLines;
  options.closing = Closing::WhenFirstPointRepeats;
  DOBRA_TRY(TextPoints read, read_text_points(path, options));
  Curves curves{{}, std::move(read.remarks)};
  for (geom::Polyline& line : read.lines) add_curve(curves, {}, std::move(line));
  return curves;
}

Result<Curves> from_features(Result<Features> read, const std::string& path) {
  if (!read) return read.error();
  Curves curves{{}, std::move(read->remarks)};
  std::size_t points = 0;
  for (Feature& feature : read->features) {
    if (feature.type == FeatureType::Points) {
      ++points;
      continue;
    }
    for (std::size_t i = 0; i < feature.parts.size(); ++i) {
      const bool further = i > 0 && !feature.name.empty();
      add_curve(curves, further ? fmt::format("{} ({})", feature.name, i + 1) : feature.name,
                std::move(feature.parts[i]));
    }
  }
  if (points > 0) {
    curves.remarks.push_back(fmt::format("{}: {} {} of points left out: only lines and polygons are used", path, points,
                                         points == 1 ? "feature" : "features"));
  }
  return curves;
}

Result<Curves> read_by_ending(const std::string& path) {
  const std::string ending = ending_of(path);
  if (ending == ".txt" || ending == ".csv" || ending == ".tsv" || ending == ".dat") return from_text(path);
  if (ending == ".wkt") return from_features(read_wkt(path), path);
  if (ending == ".geojson" || ending == ".json") return from_features(read_geojson(path), path);
  if (ending == ".dxf") return from_features(read_dxf(path), path);
  return Error{ErrorCode::UnknownFormat,
               "the ending of the name tells no format of curves; give .txt, .csv, .tsv or .dat (columns of numbers), "
               ".wkt, .geojson, .json or .dxf",
               Place{.file = path}};
}

}  // namespace

Result<Curves> read_curves(const std::string& path) {
  DOBRA_TRY(Curves curves, read_by_ending(path));
  if (curves.curves.empty()) {
    return Error{ErrorCode::BadFormat, "there is no line and no polygon in the file", Place{.file = path}};
  }
  return curves;
}

}  // namespace dobra::io
