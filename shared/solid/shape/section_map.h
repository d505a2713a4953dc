#pragma once
// The lines of a plane section as a map: which lines follow each other round its regions, and how one map is laid onto
// another that hangs together in the same way. A side of a line is a dart: 2 i runs along line i, 2 i + 1 against it,
// each with its region on its left. Page: docs/algorithms/section_loft.md.

#include <cstdint>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/solid/shape/loft.h"

namespace dobra::solid::shape {

using Dart = std::uint32_t;
constexpr Dart twin(Dart d) { return d ^ 1U; }

/// Where sections differ: what the user hears, and the point in space.
base::Error section_error(std::size_t section, const SectionFrame& frame, geom::Point at, const std::string& what,
                          base::ErrorCode code = base::ErrorCode::InvalidOption);

struct SectionMap {
  SectionFrame frame;
  std::vector<LoftLine> lines;           ///< Pieces joined; islands anticlockwise; nothing that bounds nothing.
  std::vector<Dart> next;                ///< Of each dart the one that follows it round its region.
  std::vector<std::uint32_t> component;  ///< Of each line, which lines hang together.
  std::uint32_t component_count = 0;

  struct Region {
    std::string name;
    std::vector<Dart> loops;  ///< One dart of each: the outer loop first, then those round holes.
  };
  std::vector<Region> regions;           ///< In the order in which darts come to them.
  std::vector<std::uint32_t> region_of;  ///< Of each dart; `none` for outside.

  [[nodiscard]] const std::string& left(Dart d) const { return (d & 1U) == 0 ? lines[d / 2].left : lines[d / 2].right; }
  [[nodiscard]] geom::Point origin(Dart d) const {
    const auto& points = lines[d / 2].line.points;
    return (d & 1U) == 0 || lines[d / 2].line.closed ? points.front() : points.back();
  }
  [[nodiscard]] std::vector<Dart> loop(Dart first) const {
    std::vector<Dart> darts;
    Dart d = first;
    do {
      darts.push_back(d);
      d = next[d];
    } while (d != first);
    return darts;
  }
  [[nodiscard]] bool alike(Dart d, const SectionMap& other, Dart e) const {
    return lines[d / 2].name == other.lines[e / 2].name && left(d) == other.left(e) &&
           left(twin(d)) == other.left(twin(e)) && lines[d / 2].line.closed == other.lines[e / 2].line.closed;
  }
};

/// @param number  of the section, for messages, from 0.
/// @error as loft_sections() says of one section.  @cost O(n log n + lines * loops)
base::Result<SectionMap> section_map(const LoftSection& section, std::size_t number);

/// Of each dart of `from` the dart of `to` that stands for it.
/// @param number  of the section `to`, from 0.
/// @error InvalidOption with the place where the maps differ.
base::Result<std::vector<Dart>> laid_onto(const SectionMap& from, const SectionMap& to, std::size_t number);

}  // namespace dobra::solid::shape
