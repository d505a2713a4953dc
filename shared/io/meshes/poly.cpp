#include "shared/io/meshes/poly.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <sstream>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/scan.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

Result<void> read_segments(Records& records, std::string_view text, PolyFile& poly) {
  DOBRA_TRY_VOID(records.expect("the number of segments"));
  DOBRA_TRY(const std::size_t count, records.count(0, "the number of segments", most_items));
  std::size_t has_markers = 0;
  if (records.size() > 1) {
    DOBRA_TRY(has_markers, records.count(1, "the number of boundary markers", 1));
  }
  poly.segments.reserve(plausible_count(count, text));
  const std::size_t first = poly.nodes.first_number;
  for (std::size_t i = 0; i < count; ++i) {
    DOBRA_TRY_VOID(records.expect(fmt::format("segment {} of {}", i + 1, count)));
    std::array<std::uint32_t, 2> segment{};
    for (std::size_t k = 0; k < 2; ++k) {
      DOBRA_TRY(const std::size_t node, records.count(1 + k, "the segment's end"));
      if (node < first || node - first >= poly.nodes.points.size()) {
        return records.error(1 + k, fmt::format("there is no point {}", node));
      }
      segment[k] = static_cast<std::uint32_t>(node - first);
    }
    if (segment[0] == segment[1]) return records.error(1, "the segment joins a point to itself; remove it");
    poly.segments.push_back(segment);
    if (has_markers == 1) {
      DOBRA_TRY(const std::int64_t marker, records.integer(3, "the boundary marker"));
      poly.segment_markers.push_back(marker);
    }
  }
  return {};
}

Result<void> read_holes(Records& records, PolyFile& poly) {
  DOBRA_TRY_VOID(records.expect("the number of holes"));
  DOBRA_TRY(const std::size_t count, records.count(0, "the number of holes", most_items));
  for (std::size_t i = 0; i < count; ++i) {
    DOBRA_TRY_VOID(records.expect(fmt::format("hole {} of {}", i + 1, count)));
    DOBRA_TRY(const double x, records.number(1, "x"));
    DOBRA_TRY(const double y, records.number(2, "y"));
    poly.holes.push_back({x, y});
  }
  return {};
}

// "number x y attribute [max area]"; with one value behind the point it is the attribute, as in Triangle.
Result<void> read_regions(Records& records, PolyFile& poly) {
  if (!records.next()) return {};  // The section may be absent.
  DOBRA_TRY(const std::size_t count, records.count(0, "the number of regions", most_items));
  for (std::size_t i = 0; i < count; ++i) {
    DOBRA_TRY_VOID(records.expect(fmt::format("region {} of {}", i + 1, count)));
    PolyRegion region;
    DOBRA_TRY(region.at.x, records.number(1, "x"));
    DOBRA_TRY(region.at.y, records.number(2, "y"));
    DOBRA_TRY(region.attribute, records.number(3, "the region's attribute"));
    if (records.size() > 4) {
      DOBRA_TRY(region.max_area, records.number(4, "the largest area"));
    }
    poly.regions.push_back(region);
  }
  return {};
}

// The points inside the file, or `outside` where it gives none.
Result<NodeFile> nodes_of(Records& records, std::string_view text, const NodeFile* outside) {
  DOBRA_TRY_VOID(records.expect("the number of points"));
  DOBRA_TRY(NodeFile nodes, parse_node_section(records, text));
  if (!nodes.points.empty()) return nodes;
  if (outside != nullptr) return *outside;
  return records.error(0, "the file gives no points and there is no .node file beside it");
}

}  // namespace

Result<PolyFile> parse_poly(std::string_view text, const std::string& file, const NodeFile* nodes) {
  DOBRA_TRY_VOID(check_text(text, file));
  Records records(text, file);
  PolyFile poly;
  DOBRA_TRY(poly.nodes, nodes_of(records, text, nodes));
  DOBRA_TRY_VOID(read_segments(records, text, poly));
  DOBRA_TRY_VOID(read_holes(records, poly));
  DOBRA_TRY_VOID(read_regions(records, poly));
  if (records.next()) return records.error(0, fmt::format("{} stands behind the last section", shown(records.line())));
  return poly;
}

Result<PolyFile> read_poly(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  Records records(text, path);
  // Only "0 ..." in front asks for the .node file; whatever else is wrong is said by parse_poly.
  if (records.next() && records.word(0) == "0") {
    const std::string beside = std::filesystem::path(path).replace_extension(".node").string();
    DOBRA_TRY(const NodeFile nodes, read_node(beside));
    return parse_poly(text, path, &nodes);
  }
  return parse_poly(text, path);
}

std::optional<PolyFile> counted_graph(std::string_view text) {
  std::vector<geom::Point> rows;
  Lines lines(text);
  while (lines.next()) {
    std::istringstream words{std::string(lines.line())};
    std::string x, y, more;
    if (!(words >> x)) continue;
    if (!(words >> y) || words >> more) return std::nullopt;
    const auto first = base::parse_number(x);
    const auto second = base::parse_number(y);
    if (!first || !second || !is_finite(geom::Point{*first, *second})) return std::nullopt;
    rows.push_back({*first, *second});
  }
  const auto whole = [](double value) { return value >= 0.0 && value < 4e9 && value == std::floor(value); };
  if (rows.empty() || !whole(rows[0].x) || !whole(rows[0].y)) return std::nullopt;
  const auto points = static_cast<std::size_t>(rows[0].x);
  const auto segments = static_cast<std::size_t>(rows[0].y);
  if (points < 3 || segments < 3 || rows.size() != 1 + points + segments) return std::nullopt;
  PolyFile graph;
  const auto links = rows.begin() + 1 + static_cast<std::ptrdiff_t>(points);
  graph.nodes.points.assign(rows.begin() + 1, links);
  for (auto link = links; link != rows.end(); ++link) {
    if (!whole(link->x) || !whole(link->y) || std::max(link->x, link->y) >= rows[0].x || link->x == link->y)
      return std::nullopt;
    graph.segments.push_back({static_cast<std::uint32_t>(link->x), static_cast<std::uint32_t>(link->y)});
  }
  return graph;
}

Result<std::string> poly_text(const PolyFile& poly) {
  DOBRA_TRY(std::string text, node_text(poly.nodes));
  DOBRA_TRY_VOID(check_finite(poly.holes, "the holes"));
  const std::size_t first = poly.nodes.first_number;
  const bool markers = !poly.segment_markers.empty();
  text += fmt::format("{} {}\n", poly.segments.size(), markers ? 1 : 0);
  for (std::size_t i = 0; i < poly.segments.size(); ++i) {
    text += fmt::format("{} {} {}", i + first, poly.segments[i][0] + first, poly.segments[i][1] + first);
    text += markers ? fmt::format(" {}\n", poly.segment_markers[i]) : "\n";
  }
  text += fmt::format("{}\n", poly.holes.size());
  for (std::size_t i = 0; i < poly.holes.size(); ++i) {
    text +=
        fmt::format("{} {} {}\n", i + first, base::number_text(poly.holes[i].x), base::number_text(poly.holes[i].y));
  }
  text += fmt::format("{}\n", poly.regions.size());
  for (std::size_t i = 0; i < poly.regions.size(); ++i) {
    const PolyRegion& region = poly.regions[i];
    DOBRA_TRY_VOID(check_finite(std::array{region.at, geom::Point{region.attribute, region.max_area}}, "a region"));
    text += fmt::format("{} {} {} {} {}\n", i + first, base::number_text(region.at.x), base::number_text(region.at.y),
                        base::number_text(region.attribute), base::number_text(region.max_area));
  }
  return text;
}

Result<void> write_poly(const std::string& path, const PolyFile& poly) { return write_text(path, poly_text(poly)); }

}  // namespace dobra::io::meshes
