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
#include "shared/offset/verify.h"
#include "shared/scene/color_map.h"

namespace dobra::cli {

using base::Error;
using base::ErrorCode;

namespace {

constexpr std::array<const char*, 3> exchange_endings = {".geojson", ".wkt", ".csv"};
constexpr std::array<const char*, 3> picture_endings = {".svg", ".pdf", ".png"};
constexpr std::size_t legend_entries = 12;  ///< More distances than these show only some of them in the legend.

template <class Endings>
bool is_one_of(const std::string& ending, const Endings& endings) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

void append_points(std::string& text, const geom::Polyline& line) {
  text += '[';
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    text += i > 0 ? ",[" : "[";
    base::append_number(text, line.points[i].x);
    text += ',';
    base::append_number(text, line.points[i].y);
    text += ']';
  }
  text += ']';
}

void append_curve(std::string& text, const OffsetFamily& family, const DrawnOffset& curve, bool with_name) {
  text += '{';
  if (with_name) {
    const nlohmann::json name = family.base.name;
    text += "\"curve\":" + name.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + ',';
  }
    text += fmt::format("\"distance\":{},\"length\":{},\"area\":{},\"pieces\":[", base::number_text(curve.distance),
                      base::number_text(curve.length), curve.area ? base::number_text(*curve.area) : "null");
  for (std::size_t i = 0; i < curve.lines.size(); ++i) {
    const geom::Polyline& line = curve.lines[i];
    text += fmt::format("{}{{\"closed\":{},\"points\":", i > 0 ? "," : "", line.closed);
    append_points(text, line);
    text += '}';
  }
  text += "]}";
}

std::size_t point_count(const DrawnOffset& curve) {
  std::size_t count = 0;
  for (const geom::Polyline& line : curve.lines) count += line.points.size();
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
std::optional<std::vector<geom::Polyline>> polygon_parts(const OffsetFamily& family, const DrawnOffset& curve) {
  if (family.treatment == offset::Treatment::Untreated || !curve.area) return std::nullopt;
  const bool clockwise_base = geom::signed_area(family.base.line) < 0.0;
  std::vector<geom::Polyline> contours;
  std::vector<geom::Polyline> holes;
  for (const geom::Polyline& drawn_line : curve.lines) {
    geom::Polyline line = clockwise_base ? geom::reversed(drawn_line) : drawn_line;
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

io::Feature feature_of(const OffsetFamily& family, const DrawnOffset& curve) {
  io::Feature feature;
  feature.name = fmt::format("{} at {}", family.base.name, base::number_text(curve.distance));
  feature.kind = "offset";
  feature.properties = {{"curve", family.base.name}, {"distance", curve.distance}, {"length", curve.length}};
  if (curve.area) feature.properties.emplace_back("area", *curve.area);
  if (auto parts = polygon_parts(family, curve)) {
    feature.type = io::FeatureType::Polygons;
    feature.parts = std::move(*parts);
    return feature;
  }
  feature.parts = curve.lines;
  return feature;
}

/// Curves of which something remains.
std::vector<io::Feature> features_of(const std::vector<OffsetFamily>& families) {
  std::vector<io::Feature> features;
  for (const OffsetFamily& family : families) {
    for (const DrawnOffset& curve : family.curves) {
      if (!curve.lines.empty()) features.push_back(feature_of(family, curve));
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

DrawnOffset drawn(const offset::OffsetCurve& curve, const geom::Polyline& base, double tolerance) {
  DrawnOffset made;
  made.distance = curve.distance;
  made.area = 0.0;
  made.dropped = curve.dropped;
  if (curve.pieces.empty() && !base.closed) made.area.reset();
  for (const offset::OffsetPiece& piece : curve.pieces) {
    made.length += offset::length(piece, base);
    if (!piece.closed) made.area.reset();
    if (made.area) *made.area += offset::signed_area(piece, base);
    made.lines.push_back(offset::chords(piece, base, tolerance).polyline);
  }
  if (made.area) made.area = std::abs(*made.area);
  return made;
}

base::Result<void> verify_offset(const io::NamedCurve& base, const offset::OffsetOptions& options,
                                 const std::vector<offset::OffsetCurve>& curves, OffsetVerdict& verdict) {
  for (const offset::OffsetCurve& curve : curves) {
    DOBRA_TRY(const offset::Verification found, offset::verify(base.line, options, curve));
    verdict.edges += found.edges;
    verdict.samples += found.samples;
    for (const offset::Finding& finding : found.findings) {
      verdict.findings.push_back(
          fmt::format("{}: distance {}: {}", base.name, dobra::base::number_text(curve.distance), offset::to_string(finding)));
    }
  }
  return {};
}

std::string offset_json(const std::vector<OffsetFamily>& families) {
  std::string text = "{\"curves\":[";
  std::size_t dropped = 0;
  bool first = true;
  for (const OffsetFamily& family : families) {
    for (const DrawnOffset& curve : family.curves) {
      if (!first) text += ',';
      first = false;
      append_curve(text, family, curve, families.size() > 1);
      dropped += curve.dropped;
    }
  }
  text += fmt::format("],\"dropped\":{}}}\n", dropped);
  return text;
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
    for (const DrawnOffset& curve : family.curves) {
      text += row(family.base.name, fmt::format("{:.7g}", curve.distance), curve.lines.size(), point_count(curve),
                  fmt::format("{:.7g}", curve.length), curve.area ? fmt::format("{:.7g}", *curve.area) : std::string("-"));
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
      const auto& drawn_lines = family.curves[k].lines;
      lines.lines.insert(lines.lines.end(), drawn_lines.begin(), drawn_lines.end());
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
    for (const DrawnOffset& curve : family.curves) {
      lines.insert(lines.end(), curve.lines.begin(), curve.lines.end());
    }
  }
  return io::write_points_csv(file.string(), lines);
}

}  // namespace dobra::cli
