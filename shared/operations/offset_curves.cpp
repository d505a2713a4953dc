#include "shared/operations/offset_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/base/text.h"
#include "shared/offset/verifier/verify.h"

namespace dobra::operations {

using base::Error;
using base::ErrorCode;

namespace {

/// Numbers of the curve, then what the base had; a property of the base that has the name of one of ours is
/// "source_...".
io::lines::Feature feature_of(const OffsetFamily& family, const DrawnOffset& curve) {
  io::lines::Feature feature;
  feature.type =
      family.content == OffsetContent::Polygons ? io::lines::FeatureType::Polygons : io::lines::FeatureType::Lines;
  feature.parts = curve.lines;
  feature.name = fmt::format("{} at {}", family.name, base::number_text(curve.distance));
  feature.kind = "offset";
  feature.properties = {{"curve", family.name}, {"distance", curve.distance}, {"length", curve.length}};
  if (curve.area) feature.properties.emplace_back("area", *curve.area);
  if (curve.dropped > 0) feature.properties.emplace_back("dropped", static_cast<std::int64_t>(curve.dropped));
  const io::lines::Feature& source = family.source;
  const auto has = [&](const std::string& key) {
    return std::any_of(feature.properties.begin(), feature.properties.end(),
                       [&](const auto& p) { return p.first == key; });
  };
  const auto add = [&](const std::string& key, const io::lines::PropertyValue& value) {
    feature.properties.emplace_back(has(key) ? "source_" + key : key, value);
  };
  if (!source.kind.empty()) add("source_kind", source.kind);
  for (const auto& [key, value] : source.properties) add(key, value);
  if (source.id && !has("id")) add("id", *source.id);
  return feature;
}

}  // namespace

DrawnOffset drawn(const offset::OffsetCurve& curve, const geom::Polyline& base, double tolerance) {
  DrawnOffset made;
  made.distance = curve.distance;
  made.dropped = curve.dropped;
  const auto is_closed = [](const offset::OffsetPiece& piece) { return piece.closed; };
  const bool closed =
      curve.pieces.empty() ? base.closed : std::all_of(curve.pieces.begin(), curve.pieces.end(), is_closed);
  if (closed) made.area = 0.0;
  made.dropped_length = curve.dropped_length;
  for (const offset::OffsetPiece& piece : curve.pieces) {
    made.length += offset::length(piece, base);
    if (made.area) *made.area += offset::signed_area(piece, base);
    made.lines.push_back(offset::chords(piece, base, tolerance).polyline);
  }
  if (made.area) made.area = std::abs(*made.area);
  return made;
}

DrawnOffset drawn(const offset::Area& area, double distance) {
  return {.distance = distance, .length = area.length, .area = area.area, .lines = area.rings};
}

base::Result<void> verify_offset(const std::string& name, const geom::Polyline& base,
                                 const offset::OffsetOptions& options, const std::vector<offset::OffsetCurve>& curves,
                                 OffsetVerdict& verdict, const base::Progress& progress) {
  for (const offset::OffsetCurve& curve : curves) {
    DOBRA_TRY(const offset::verifier::Verification found, offset::verifier::verify(base, options, curve, {}, progress));
    ++verdict.curves;
    verdict.coarse += found.coarse ? 1 : 0;
    verdict.dropped += curve.dropped;
    verdict.dropped_length += curve.dropped_length;
    verdict.edges += found.edges;
    verdict.samples += found.samples;
    for (const offset::verifier::Finding& finding : found.findings) {
      verdict.findings.push_back(fmt::format("{}: distance {}: {}", name, dobra::base::number_text(curve.distance),
                                             offset::verifier::to_string(finding)));
    }
  }
  return {};
}

std::string not_judged(const OffsetVerdict& verdict, const offset::OffsetOptions& options) {
  std::vector<std::string> all;
  const auto add = [&](std::size_t count, const char* one, const char* more) {
    if (count > 0) all.push_back(fmt::format("{} {}", count, count == 1 ? one : more));
  };
  add(verdict.dropped, "piece left out", "pieces left out");
  if (verdict.dropped > 0)
    all.back() += fmt::format(" ({:.6g} m), and whether more of those curves is missing", verdict.dropped_length);
  add(verdict.cut_tips, "bisector point cut across", "bisector points cut across");
  add(verdict.skipped, "open line at a distance below 0", "open lines at distances below 0");
  add(verdict.mended, "polygon that crosses or touches itself, but what it was taken as",
      "polygons that cross or touch themselves, but what they were taken as");
  add(verdict.coarse, "curve nearer than 64 roundings of the coordinates, as to touching and missing parts",
      "curves nearer than 64 roundings of the coordinates, as to touching and missing parts");
  if (options.treatment == offset::Treatment::Untreated) {
    all.emplace_back("whether untreated curves keep their distance or cross");
  } else if (options.ends == offset::Ends::Paper) {
    all.emplace_back("whether curves with the paper's ends keep their distance or lack anything");
  }
  if (verdict.joined) all.emplace_back("what was joined of several curves");
  return fmt::format("{}", fmt::join(all, "; "));
}

base::Result<void> check_numbers(const std::vector<OffsetFamily>& families) {
  for (const OffsetFamily& family : families) {
    for (const DrawnOffset& curve : family.curves) {
      if (std::isfinite(curve.length) && std::isfinite(curve.area.value_or(0.0))) continue;
      return Error{ErrorCode::NotFinite,
                   fmt::format("the length or the area of {} at distance {} is beyond what a number can hold; "
                               "use larger units",
                               family.name, base::number_text(curve.distance))};
    }
  }
  return {};
}

std::vector<io::lines::Feature> features_of(const std::vector<OffsetFamily>& families) {
  std::vector<io::lines::Feature> features;
  for (const OffsetFamily& family : families) {
    for (const DrawnOffset& curve : family.curves) {
      if (!curve.lines.empty()) features.push_back(feature_of(family, curve));
    }
  }
  return features;
}

std::size_t point_count(const DrawnOffset& curve) {
  std::size_t count = 0;
  for (const geom::Polyline& line : curve.lines) count += line.points.size();
  return count;
}

}  // namespace dobra::operations
