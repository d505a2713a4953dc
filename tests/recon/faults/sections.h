#pragma once
// Sections with faults for tests.

#include <string>
#include <utility>
#include <vector>

#include "recon/input/input.h"
#include "tests/recon/shapes.h"

namespace recon::test {

using NamedPoints = std::pair<std::string, std::vector<geom::Point>>;

/// Horizons "A/1" are pieces of "A"; faults likewise.
inline section::Section faulted(const std::vector<NamedPoints>& horizons, std::vector<input::FaultInput> faults,
                                std::vector<geom::Point> border = {}, std::vector<input::BlockInput> blocks = {}) {
  input::SectionInput input;
  for (const auto& [name, points] : horizons) {
    input.horizons.push_back(item(name, points));
    if (name.find('/') != std::string::npos) input.horizons.back().piece_of = name.substr(0, name.find('/'));
  }
  for (input::FaultInput& fault : faults) {
    if (fault.name.find('/') != std::string::npos) fault.piece_of = fault.name.substr(0, fault.name.find('/'));
  }
  input.faults = std::move(faults);
  input.blocks = std::move(blocks);
  if (!border.empty()) input.borders = {item("border", std::move(border))};
  return read_section(input, {}, {}).value().section;
}

inline std::vector<geom::Point> box(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}, {left, bottom}};
}

/// Level beds at 0 and -300, cut by a fault of 45 degrees that dips to +x; the hanging wall has gone `slip` down it
/// along x and z.
inline section::Section normal_fault(double slip, double mirror = 1.0) {
  const auto at = [&](double x, double z) { return geom::Point{mirror * x, z}; };
  return faulted({{"A/1", {at(0, 0), at(500, 0)}},
                  {"A/2", {at(500 + slip, -slip), at(1500, -slip)}},
                  {"B/1", {at(0, -300), at(800, -300)}},
                  {"B/2", {at(800 + slip, -300 - slip), at(1500, -300 - slip)}}},
                 {item("F", {at(400, 100), at(1200, -700)})});
}

}  // namespace recon::test
