#include "shared/io/formats/curves.h"

#include <fmt/format.h>

#include <algorithm>

namespace dobra::io::formats {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

void add_curve(Curves& curves, std::string name, geom::Polyline line) {
  if (name.empty()) name = fmt::format("curve {}", curves.curves.size() + 1);
  curves.curves.push_back({std::move(name), std::move(line), {}, {}});
}

}  // namespace

Result<Curves> read_curves(const std::string& path) {
  // Curves are taken as they stand: a plane, whatever it is, and whatever its unit is.
  LineOptions options;
  options.coordinates = Coordinates::Section;
  options.y_direction = lines::YDirection::Up;
  options.unit = 1.0;
  return read_curves(path, options);
}

Result<Curves> read_curves(const std::string& path, const LineOptions& options) {
  DOBRA_TRY(LineWork read, read_any_lines(path, options));
  Curves curves{{}, std::move(read.remarks), read.format, read.unit, read.y_direction};
  std::size_t points = 0;
  std::size_t polygons = 0;
  for (lines::Feature& feature : read.features) {
    if (feature.type == lines::FeatureType::Points) {
      ++points;
      continue;
    }
    std::vector<std::optional<std::size_t>> polygon_of(feature.parts.size());
    if (feature.type == lines::FeatureType::Polygons) {
      for (const auto& [first, last] : lines::polygons_of(feature)) {
        std::fill(polygon_of.begin() + static_cast<std::ptrdiff_t>(first),
                  polygon_of.begin() + static_cast<std::ptrdiff_t>(last), polygons);
        ++polygons;
      }
    }
    for (std::size_t i = 0; i < feature.parts.size(); ++i) {
      const bool further = i > 0 && !feature.name.empty();
      add_curve(curves, further ? fmt::format("{} ({})", feature.name, i + 1) : feature.name,
                std::move(feature.parts[i]));
      curves.curves.back().polygon = polygon_of[i];
      curves.curves.back().feature = feature.name;
    }
  }
  if (points > 0) {
    curves.remarks.push_back(fmt::format("{}: {} {} of points left out: only lines and polygons are used", path, points,
                                         points == 1 ? "feature" : "features"));
  }
  if (curves.curves.empty()) {
    return Error{ErrorCode::BadFormat, "there is no line and no polygon in the file", Place{.file = path}};
  }
  return curves;
}

}  // namespace dobra::io::formats
