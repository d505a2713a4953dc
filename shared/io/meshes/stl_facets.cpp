#include "shared/io/meshes/stl_facets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "shared/io/scan.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point3;

namespace {

/// Of a binary file, in bytes.
constexpr std::size_t head_size = 80;   // text before the count
constexpr std::size_t facet_size = 50;  // normal, three corners, two bytes more
constexpr std::size_t normal_size = 12;
constexpr std::size_t corner_size = 12;

std::uint32_t little_endian_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

float real_at(std::string_view bytes, std::size_t at) { return std::bit_cast<float>(little_endian_at(bytes, at)); }

/// Points by their coordinates.
class MergedPoints {
 public:
  explicit MergedPoints(mesh::PolygonMesh& mesh) : mesh_(mesh) {}
  std::uint32_t number(Point3 p) {
    // The two zeros are one number.
    const Key key{std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
                  std::bit_cast<std::uint64_t>(p.z + 0.0)};
    const auto [at, fresh] = numbers_.try_emplace(key, static_cast<std::uint32_t>(mesh_.points.size()));
    if (fresh) mesh_.points.push_back(p);
    return at->second;
  }

 private:
  using Key = std::array<std::uint64_t, 3>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::uint64_t hash = 0;
      for (const std::uint64_t part : key) hash = (hash ^ part ^ (hash >> 29U)) * 0x9e3779b97f4a7c15U;
      return hash ^ (hash >> 32U);
    }
  };
  mesh::PolygonMesh& mesh_;
  std::unordered_map<Key, std::uint32_t, Hash> numbers_;
};

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= head_size + 4 &&
         bytes.size() == head_size + 4 + facet_size * std::size_t{little_endian_at(bytes, head_size)};
}

/// Capitals do not count.
bool keyword_is(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

Result<mesh::PolygonMesh> parse_binary_stl(std::string_view bytes, const std::string& file) {
  mesh::PolygonMesh mesh;
  MergedPoints points(mesh);
  const std::uint32_t count = little_endian_at(bytes, head_size);
  mesh.faces.reserve(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    std::vector<std::uint32_t> face;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = head_size + 4 + facet_size * t + normal_size + corner_size * c;
      const Point3 p{real_at(bytes, at), real_at(bytes, at + 4), real_at(bytes, at + 8)};
      if (!is_finite(p)) {
        return Error{ErrorCode::NotFinite,
                     fmt::format("triangle {} of the file has a coordinate that is not a finite number", t),
                     base::Place{.file = file}};
      }
      face.push_back(points.number(p));
    }
    mesh.faces.push_back(std::move(face));
  }
  return mesh;
}

Result<mesh::PolygonMesh> parse_stl_text(std::string_view text, const std::string& file) {
  mesh::PolygonMesh mesh;
  MergedPoints points(mesh);
  Records records(text, file, '\0');
  std::vector<std::uint32_t> face;
  bool in_facet = false;
  bool in_solid = false;
  while (records.next()) {
    const std::string_view word = records.word(0);
    if (keyword_is(word, "vertex")) {
      Point3 p;
      DOBRA_TRY(p.x, records.number(1, "x"));
      DOBRA_TRY(p.y, records.number(2, "y"));
      DOBRA_TRY(p.z, records.number(3, "z"));
      if (!in_facet || face.size() == 3) return records.error(0, "a facet has three corners; this is one too many");
      face.push_back(points.number(p));
    } else if (keyword_is(word, "facet")) {
      if (in_facet) return records.error(0, "the facet before has no endfacet");
      in_facet = in_solid = true;
    } else if (keyword_is(word, "endfacet")) {
      if (face.size() != 3)
        return records.error(0, fmt::format("the facet has {} corners and must have 3", face.size()));
      mesh.faces.push_back(std::move(face));
      face.clear();
      in_facet = false;
    } else if (keyword_is(word, "solid")) {
      in_solid = true;
    } else if (keyword_is(word, "endsolid")) {
      in_solid = false;
    } else if (!keyword_is(word, "outer") && !keyword_is(word, "endloop")) {
      return records.error(0, fmt::format("{} is no word of an STL file", shown(word)));
    }
    if (keyword_is(word, "endsolid") && in_facet) return records.error(0, "the facet before has no endfacet");
  }
  if (!in_solid && !in_facet) return mesh;
  return Error{ErrorCode::BadFormat, "the file ends without endsolid, as if it were cut short; write it again",
               base::Place{.file = file, .line = records.line_number()}};
}

}  // namespace

Result<mesh::PolygonMesh> parse_stl_facets(std::string_view bytes, const std::string& file) {
  if (is_binary_stl(bytes)) return parse_binary_stl(bytes, file);
  if (bytes.find('\0') == std::string_view::npos) {
    DOBRA_TRY_VOID(check_text(bytes, file));
    return parse_stl_text(bytes, file);
  }
  if (bytes.size() < head_size + 4) {
    return Error{ErrorCode::BadFormat, "is no STL: neither text nor as long as the head of a binary file",
                 base::Place{.file = file}};
  }
  const std::uint32_t count = little_endian_at(bytes, head_size);
  return Error{ErrorCode::BadFormat,
               fmt::format("is a binary STL of {} triangles, which takes {} bytes, but has {}: it was cut short or "
                           "changed; write it again",
                           count, head_size + 4 + facet_size * std::size_t{count}, bytes.size()),
               base::Place{.file = file}};
}

}  // namespace dobra::io::meshes
