#pragma once
// Sections that the tests of blocks and cuts share.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "recon/block/block.h"
#include "recon/section/section_faces.h"

namespace recon::block::test {

using geom::Point;
using geom::Polyline;

inline section::Horizon horizon(const std::string& name, std::vector<Point> points, const std::string& piece_of = "") {
  return {section::HorizonId(), name, {std::move(points), false}, {}, piece_of};
}
inline section::SectionLine line(section::LineKind kind, const std::string& name, std::vector<Point> points) {
  return {section::LineId(), kind, name, {std::move(points), false}, {}};
}
inline section::Unit unit(const std::string& name, std::vector<Point> points) {
  return {section::UnitId(), name, {std::move(points), true}, {}};
}

/// With ids, and faces as reading makes them.
inline section::Section made(section::Section section) {
  for (std::size_t i = 0; i < section.horizons.size(); ++i) section.horizons[i].id = section::HorizonId(i);
  for (std::size_t i = 0; i < section.lines.size(); ++i) section.lines[i].id = section::LineId(i);
  for (std::size_t i = 0; i < section.units.size(); ++i) section.units[i].id = section::UnitId(i);
  auto faces = section::faces_of(section);
  EXPECT_TRUE(faces) << to_string(faces.error());
  if (faces) section.faces = std::make_shared<const section::SectionFaces>(std::move(*faces));
  return section;
}

/// Two layers of 100 m by 10 m.
inline section::Section layers() {
  section::Section section;
  section.horizons = {horizon("top", {{0, 0}, {50, 4}, {100, 0}}), horizon("middle", {{0, -10}, {100, -10}}),
                      horizon("base", {{0, -20}, {30, -20}, {100, -20}})};
  return made(std::move(section));
}

/// The same with a fault through all of it, displaced, and one that ends within.
inline section::Section faulted() {
  section::Section section;
  section.horizons = {horizon("top (1)", {{0, 0}, {40, 0}}, "top"), horizon("top (2)", {{50, -4}, {100, -4}}, "top"),
                      horizon("base (1)", {{0, -20}, {60, -20}}, "base"),
                      horizon("base (2)", {{70, -24}, {100, -24}}, "base")};
  section.lines = {line(section::LineKind::Fault, "F", {{30, 8}, {40, 0}, {50, -4}, {60, -20}, {70, -24}, {75, -30}}),
                   line(section::LineKind::Fault, "blind", {{10, -5}, {15, -12}})};
  return made(std::move(section));
}

inline Block block(const section::Section& section, double length,
                   std::optional<dobra::io::lines::Trace> trace = std::nullopt) {
  auto made = extrude(section, {length, trace});
  EXPECT_TRUE(made) << to_string(made.error());
  return made ? std::move(*made) : Block{};
}

inline const BlockUnit* find(const Block& block, const std::string& name) {
  for (const BlockUnit& unit : block.units) {
    if (unit.name == name) return &unit;
  }
  return nullptr;
}

inline bool told(const std::vector<base::Finding>& findings, const std::string& code) {
  for (const base::Finding& finding : findings) {
    if (finding.code == code) return true;
  }
  return false;
}

}  // namespace recon::block::test
