#pragma once
// Triangle's .poly files: a planar straight-line graph with attributes, boundary markers, holes and regions.
// Source: [shewchuk1996triangle].

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/meshes/node_ele.h"

namespace dobra::io::meshes {

/// A region: every triangle reached from the point `at` without crossing a segment.
struct PolyRegion {
  geom::Point at;
  double attribute = 0.0;
  double max_area = -1.0;  ///< m2; none where not above 0.
  friend bool operator==(const PolyRegion&, const PolyRegion&) = default;
};

struct PolyFile {
  NodeFile nodes;
  std::vector<std::array<std::uint32_t, 2>> segments;  ///< Indices of points, from 0.
  std::vector<std::int64_t> segment_markers;           ///< One a segment, or empty where the file has none.
  std::vector<geom::Point> holes;                      ///< A point inside each hole.
  std::vector<PolyRegion> regions;
  friend bool operator==(const PolyFile&, const PolyFile&) = default;
};

/// A .poly file; where it gives no points they are read from the .node file of the same name.
/// @error FileNotFound, NotAFile, CannotRead, EmptyFile; BadFormat, NotFinite with line and column.
base::Result<PolyFile> read_poly(const std::string& path);

/// The same from text.
/// @param nodes  the points where the text gives none; an error if they are needed and not there.
base::Result<PolyFile> parse_poly(std::string_view text, const std::string& file, const NodeFile* nodes = nullptr);

/// The graphs of CDT's test files: "points segments", then "x y" a point, then the two indices (from 0) of each
/// segment; two numbers a line and nothing else. Nothing where the text is anything else.
std::optional<PolyFile> counted_graph(std::string_view text);

/// Text with the points inside and every digit; parse_poly gives the same value back. @error NotFinite
base::Result<std::string> poly_text(const PolyFile& poly);
/// @error NotFinite, CannotWrite
base::Result<void> write_poly(const std::string& path, const PolyFile& poly);

}  // namespace dobra::io::meshes
