#pragma once
// Lines and sections that several tests of RECON share.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "recon/input/line_input.h"
#include "recon/maps/columns.h"
#include "recon/maps/trace.h"
#include "recon/section/section.h"

namespace recon::test {

/// A cosine, y = -cos x over [0, 4 pi], 129 points.
inline geom::Polyline cosine() {
  geom::Polyline line;
  for (int i = 0; i <= 128; ++i) {
    const double x = 4.0 * std::numbers::pi * i / 128.0;
    line.points.push_back({x, -std::cos(x)});
  }
  return line;
}

/// A concentric anticline: radius 10 about the origin, 90 degrees in 64 chords, left to right.
inline geom::Polyline arc(double radius = 10.0) {
  geom::Polyline line;
  for (int i = 0; i <= 64; ++i) {
    const double angle = std::numbers::pi * (0.75 - 0.5 * i / 64.0);
    line.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return line;
}

/// Mitre offset of a line on its right-hand side: the rungs at one depth.
inline geom::Polyline parallel(const geom::Polyline& line, double depth) {
  const maps::Columns columns = maps::Columns::along(line).value();
  geom::Polyline result;
  for (std::size_t i = 0; i < columns.rung_count(); ++i) {
    result.points.push_back(columns.foot(i) + depth * columns.rung_vector(i));
  }
  return result;
}

inline section::Section section_of(const std::vector<geom::Polyline>& lines) {
  section::Section section;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    section.horizons.push_back({section::HorizonId(i), i == 0 ? "top" : "bed" + std::to_string(i), lines[i], {}});
  }
  return section;
}

/// A random section: a gentle fold train with beds below it, not parallel to it.
inline section::Section random_section(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double height = 100.0 + 150.0 * unit(random);
  const double phase = 6.28 * unit(random);
  const double wave = 2000.0 + 1500.0 * unit(random);
  std::vector<geom::Polyline> lines(3);
  for (std::size_t bed = 0; bed < 3; ++bed) {
    const double fade = 1.0 - 0.15 * static_cast<double>(bed);
    for (int i = 0; i <= 200; ++i) {
      const double x = 50.0 * i + (i % 200 == 0 ? 0.0 : 20.0 * (unit(random) - 0.5));
      const double z = fade * height * std::sin(2.0 * std::numbers::pi * x / wave + phase) + 0.01 * x;
      lines[bed].points.push_back({x, z - 120.0 * static_cast<double>(bed) - 10.0 * unit(random)});
    }
  }
  section::Section section = test::section_of(lines);
  // The base of the grid is smooth; beds are as picked.
  section.horizons[0].line.points.clear();
  for (int i = 0; i <= 200; ++i) {
    const double x = 50.0 * i;
    section.horizons[0].line.points.push_back(
        {x, height * std::sin(2.0 * std::numbers::pi * x / wave + phase) + 0.01 * x});
  }
  return section;
}

/// Greatest distance of points of the same number; infinity if the numbers of points differ.
inline double greatest_distance(const std::vector<geom::Point>& a, const std::vector<geom::Point>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double greatest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, geom::distance(a[i], b[i]));
  return greatest;
}

/// Images of the given vertices of a line.
inline std::vector<geom::Point> given_images(const maps::MappedLine& mapped) {
  std::vector<geom::Point> points;
  for (const std::size_t i : mapped.given) points.push_back(mapped.after.points[i]);
  return points;
}

/// One line of a section as the input has it.
inline input::HorizonInput item(const std::string& name, std::vector<geom::Point> points) {
  input::HorizonInput input;
  input.name = name;
  input.points = std::move(points);
  return input;
}

}  // namespace recon::test
