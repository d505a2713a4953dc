#include "shared/cli/offset_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "shared/base/text.h"
#include "shared/cli/pictures.h"
#include "shared/io/geojson.h"
#include "shared/io/text_points.h"
#include "shared/io/wkt.h"
#include "shared/scene/color_map.h"

namespace dobra::cli {

using base::Error;
using base::ErrorCode;
using offset::OffsetCurve;
using offset::OffsetPiece;

namespace {

constexpr std::array<const char*, 3> exchange_endings = {".geojson", ".wkt", ".csv"};
constexpr std::array<const char*, 3> picture_endings = {".svg", ".pdf", ".png"};
constexpr std::size_t legend_entries = 12;  ///< More distances than these show only some of them in the legend.

template <class Endings>
bool is_one_of(const std::string& ending, const Endings& endings) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

std::string points_json(const geom::Polyline& line) {
  std::string text = "[";
  for (const geom::Point p : line.points) {
    if (text.size() > 1) text += ',';
    text += '[' + base::number_text(p.x) + ',' + base::number_text(p.y) + ']';
  }
  return text + ']';
}

std::string curve_json(const OffsetFamily& family, const OffsetCurve& curve, bool with_name) {
  std::string text = "{";
  if (with_name) {
    const nlohmann::json name = family.base.name;
    text += "\"curve\":" + name.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + ',';
  }
  const std::optional<double> area = area_of(family, curve);
  text += fmt::format("\"distance\":{},\"length\":{},\"area\":{},\"pieces\":[", base::number_text(curve.distance),
                      base::number_text(length_of(curve)), area ? base::number_text(*area) : "null");
  for (std::size_t i = 0; i < curve.pieces.size(); ++i) {
    const geom::Polyline& line = curve.pieces[i].polyline;
    text += fmt::format("{}{{\"closed\":{},\"points\":{}}}", i > 0 ? "," : "", line.closed, points_json(line));
  }
  return text + "]}";
}

std::size_t point_count(const OffsetCurve& curve) {
  std::size_t count = 0;
  for (const OffsetPiece& piece : curve.pieces) count += piece.polyline.points.size();
  return count;
}

/// The smallest contour that has `hole` inside; contours.size() if none has.
std::size_t contour_round(const geom::Polyline& hole, const std::vector<geom::Polyline>& contours) {
  std::size_t best = contours.size();
  double best_area = 0.0;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    // A corner of the hole that lies on the contour decides nothing; the next one does.
    geom::Side side = geom::Side::Boundary;
    for (const geom::Point p : hole.points) {
      side = geom::locate(contours[i], p);
      if (side != geom::Side::Boundary) break;
    }
    const double area = geom::signed_area(contours[i]);
    if (side != geom::Side::Inside || (best < contours.size() && area >= best_area)) continue;
    best = i;
    best_area = area;
  }
  return best;
}

/// Pieces as polygons: each contour anticlockwise, followed by its holes clockwise. Nothing if they are no polygons.
std::optional<std::vector<geom::Polyline>> polygon_parts(const OffsetFamily& family, const OffsetCurve& curve) {
  if (family.treatment == offset::Treatment::Untreated || !area_of(family, curve)) return std::nullopt;
  const bool clockwise_base = geom::signed_area(family.base.line) < 0.0;
  std::vector<geom::Polyline> contours;
  std::vector<geom::Polyline> holes;
  for (const OffsetPiece& piece : curve.pieces) {
    geom::Polyline line = clockwise_base ? geom::reversed(piece.polyline) : piece.polyline;
    (geom::signed_area(line) > 0.0 ? contours : holes).push_back(std::move(line));
  }
  std::vector<std::vector<geom::Polyline>> holes_of(contours.size());
  for (geom::Polyline& hole : holes) {
    const std::size_t outer = contour_round(hole, contours);
    if (outer == contours.size()) return std::nullopt;
    holes_of[outer].push_back(std::move(hole));
  }
  std::vector<geom::Polyline> parts;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    parts.push_back(std::move(contours[i]));
    std::move(holes_of[i].begin(), holes_of[i].end(), std::back_inserter(parts));
  }
  return parts;
}

io::Feature feature_of(const OffsetFamily& family, const OffsetCurve& curve) {
  io::Feature feature;
  feature.name = fmt::format("{} at {}", family.base.name, base::number_text(curve.distance));
  feature.kind = "offset";
  feature.properties = {{"curve", family.base.name}, {"distance", curve.distance}, {"length", length_of(curve)}};
  if (const auto area = area_of(family, curve)) feature.properties.emplace_back("area", *area);
  if (auto parts = polygon_parts(family, curve)) {
    feature.type = io::FeatureType::Polygons;
    feature.parts = std::move(*parts);
    return feature;
  }
  for (const OffsetPiece& piece : curve.pieces) feature.parts.push_back(piece.polyline);
  return feature;
}

/// Curves of which something remains.
std::vector<io::Feature> features_of(const std::vector<OffsetFamily>& families) {
  std::vector<io::Feature> features;
  for (const OffsetFamily& family : families) {
    for (const OffsetCurve& curve : family.curves) {
      if (!curve.pieces.empty()) features.push_back(feature_of(family, curve));
    }
  }
  return features;
}

/// Whether entry `i` of `count` is among those that a legend of limited length shows; the first and the last are.
bool in_legend(std::size_t i, std::size_t count) {
  if (count <= legend_entries) return true;
  const std::size_t step = (count - 1 + legend_entries - 2) / (legend_entries - 1);
  return i == count - 1 || (i % step == 0 && i + step / 2 < count - 1);
}

}  // namespace

double length_of(const OffsetCurve& curve) {
  double sum = 0.0;
  for (const OffsetPiece& piece : curve.pieces) sum += geom::length(piece.polyline);
  return sum;
}

std::optional<double> area_of(const OffsetFamily& family, const OffsetCurve& curve) {
  if (curve.pieces.empty()) return family.base.line.closed ? std::optional(0.0) : std::nullopt;
  double sum = 0.0;
  for (const OffsetPiece& piece : curve.pieces) {
    if (!piece.polyline.closed) return std::nullopt;
    sum += geom::signed_area(piece.polyline);
  }
  return std::abs(sum);
}

std::string offset_json(const std::vector<OffsetFamily>& families) {
  std::string text = "{\"curves\":[";
  std::size_t dropped = 0;
  bool first = true;
  for (const OffsetFamily& family : families) {
    for (const OffsetCurve& curve : family.curves) {
      if (!first) text += ',';
      first = false;
      text += curve_json(family, curve, families.size() > 1);
      dropped += curve.dropped;
    }
  }
  return text + fmt::format("],\"dropped\":{}}}\n", dropped);
}

std::string offset_table(const std::vector<OffsetFamily>& families) {
  std::size_t width = 0;
  if (families.size() > 1) {
    width = std::string_view("curve").size();
    for (const OffsetFamily& family : families) width = std::max(width, family.base.name.size());
    width += 2;
  }
  const auto row = [&](const std::string& name, auto... cells) {
    std::string text = fmt::format("{:<{}}", width > 0 ? name : "", width);
    ((text += fmt::format("{:>14}", cells)), ...);
    return text + '\n';
  };
  std::string text = row("curve", "distance", "pieces", "points", "length", "area");
  for (const OffsetFamily& family : families) {
    for (const OffsetCurve& curve : family.curves) {
      const auto area = area_of(family, curve);
      text += row(family.base.name, fmt::format("{:.7g}", curve.distance), curve.pieces.size(), point_count(curve),
                  fmt::format("{:.7g}", length_of(curve)), area ? fmt::format("{:.7g}", *area) : std::string("-"));
    }
  }
  return text;
}

scene::Picture offset_picture(const std::vector<OffsetFamily>& families) {
  scene::Panel panel{.key = "offset"};
  const std::size_t count = families.empty() ? 0 : families.front().curves.size();
  for (std::size_t k = 0; k < count; ++k) {
    scene::Lines lines;
    for (const OffsetFamily& family : families) {
      for (const OffsetPiece& piece : family.curves[k].pieces) lines.lines.push_back(piece.polyline);
    }
    // Viridis without its light yellow end, which is hard to see on white.
    const double fraction = count > 1 ? 0.85 * static_cast<double>(k) / static_cast<double>(count - 1) : 0.4;
    scene::Layer layer{.key = fmt::format("offset_{}", k + 1),
                       .title = fmt::format("D = {:.6g}{}", families.front().curves[k].distance,
                                            lines.lines.empty() ? " (nothing remains)" : ""),
                       .style = {.line = scene::color_at(scene::ColorMapName::Viridis, fraction), .line_width = 1.0},
                       .content = std::move(lines)};
    if (!in_legend(k, count)) layer.in_legend = scene::InLegend::No;
    panel.layers.push_back(std::move(layer));
  }
  scene::Lines bases;
  for (const OffsetFamily& family : families) bases.lines.push_back(family.base.line);
  panel.layers.push_back({.key = "base",
                          .title = families.size() == 1 ? families.front().base.name : "base curves",
                          .style = {.line = {20, 20, 24}, .line_width = 2.5},
                          .content = std::move(bases)});
  scene::Picture picture;
  picture.panels.push_back(std::move(panel));
  return picture;
}

base::Result<void> check_offset_ending(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (is_one_of(ending, exchange_endings) || is_one_of(ending, picture_endings)) return {};
  return Error{ErrorCode::BadUsage,
               fmt::format("--out {}: the name must end in .geojson, .wkt, .csv, .svg, .pdf or .png", file.string())};
}

base::Result<void> write_offset(const std::vector<OffsetFamily>& families, const std::filesystem::path& file) {
  DOBRA_TRY_VOID(check_offset_ending(file));
  const std::string ending = file.extension().string();
  if (is_one_of(ending, picture_endings)) return draw(offset_picture(families), file, Drawer::Cairo);
  if (ending == ".geojson") return io::write_geojson(file.string(), features_of(families));
  if (ending == ".wkt") return io::write_wkt(file.string(), features_of(families));
  std::vector<geom::Polyline> lines;
  for (const OffsetFamily& family : families) {
    for (const OffsetCurve& curve : family.curves) {
      for (const OffsetPiece& piece : curve.pieces) lines.push_back(piece.polyline);
    }
  }
  return io::write_points_csv(file.string(), lines);
}

}  // namespace dobra::cli
