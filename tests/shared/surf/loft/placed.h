#pragma once
// Sections sampled from formulas of space, for the tests of surfaces through them.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "shared/surf/loft/cut.h"
#include "shared/surf/loft/through.h"

namespace dobra::test {

namespace loft = surf::loft;
using geom::Point;
using Height = std::function<double(double x, double y)>;

inline loft::PlanTrace trace(std::vector<Point> corners) { return loft::PlanTrace::make(std::move(corners)).value(); }

inline loft::Section section(std::string name, std::vector<Point> corners) {
  return {std::move(name), trace(std::move(corners)), {}};
}

/// n + 1 points of z = height(x, y) between two parts of the trace.
inline geom::Polyline sampled(const loft::Section& on, const Height& height, int n, double from = 0.0,
                              double to = 1.0) {
  geom::Polyline line;
  for (int i = 0; i <= n; ++i) {
    const double s = on.trace.length() * (from + (to - from) * i / n);
    const Point p = on.trace.on_map(s);
    line.points.push_back({s, height(p.x, p.y)});
  }
  return line;
}

inline void add(loft::Section& to, std::string name, geom::Polyline line,
                loft::LineKind kind = loft::LineKind::Horizon) {
  to.lines.push_back({std::move(name), kind, std::move(line)});
}

/// `count` sections from west to east at equal distances from y = 0 to `width`, with a horizon each.
inline std::vector<loft::Section> row(int count, double length, double width, const Height& height, int n,
                                      const std::string& name = "top") {
  std::vector<loft::Section> sections;
  for (int k = 0; k < count; ++k) {
    const double y = width * k / (count - 1);
    sections.push_back(section("S" + std::to_string(k + 1), {{0.0, y}, {length, y}}));
    add(sections.back(), name, sampled(sections.back(), height, n));
  }
  return sections;
}

inline loft::Surfaces through(std::vector<loft::Section> sections, const loft::ThroughOptions& options = {}) {
  auto made = loft::surfaces_through(std::move(sections), options);
  EXPECT_TRUE(made) << (made ? "" : made.error().message);
  return made ? std::move(*made) : loft::Surfaces{};
}

inline const loft::Finding* finding(const std::vector<loft::Finding>& findings, const std::string& code) {
  for (const loft::Finding& f : findings) {
    if (f.code == code) return &f;
  }
  return nullptr;
}

/// Greatest distance of the vertices of a line from another.
inline double away(const geom::Polyline& line, const geom::Polyline& other) {
  double most = 0.0;
  for (const Point p : line.points) most = std::max(most, geom::distance(other, p));
  return most;
}

}  // namespace dobra::test
