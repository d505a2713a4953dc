#pragma once
// What loops in charts must fulfil, and areas by Green's formula along their own curves.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "shared/surf/trim/recognise.h"

namespace dobra::surf::test {

/// Of f(point, derivative) along an edge, by Gauss's rule with three points on 64 parts between breaks.
template <class F>
double integral(const trim::ChartEdge& edge, const F& f) {
  std::vector<double> breaks{edge.from, edge.to};
  for (const double t : edge.curve.breaks()) {
    if (t > std::min(edge.from, edge.to) && t < std::max(edge.from, edge.to)) breaks.push_back(t);
  }
  std::sort(breaks.begin(), breaks.end());
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    constexpr int n = 64;
    for (int i = 0; i < n; ++i) {
      const double a = std::lerp(breaks[k], breaks[k + 1], 1.0 * i / n),
                   b = std::lerp(breaks[k], breaks[k + 1], (i + 1.0) / n);
      for (const auto& [x, w] : {std::pair{-std::sqrt(0.6), 5.0 / 9}, {0.0, 8.0 / 9}, {std::sqrt(0.6), 5.0 / 9}}) {
        const Curve::Jet jet = edge.curve.jet(0.5 * (a + b) + 0.5 * (b - a) * x);
        sum += 0.5 * (b - a) * w * f(geom::Point{jet.at.x, jet.at.y}, geom::Vector{jet.first.x, jet.first.y});
      }
    }
  }
  return edge.to < edge.from ? -sum : sum;
}

inline double loop_area(const trim::ChartLoop& loop) {
  double sum = 0.0;
  for (const trim::ChartEdge& edge : loop.edges)
    sum += integral(edge, [](geom::Point p, geom::Vector way) { return 0.5 * (p.x * way.y - p.y * way.x); });
  return sum;
}

inline double chart_area(const trim::TrimmedSurface& face) {
  double sum = 0.0;
  for (const trim::ChartLoop& loop : face.loops) sum += loop_area(loop);
  return sum;
}

/// Every edge ends where the next begins, in the chart.
inline void check_loops(const trim::TrimmedSurface& face) {
  ASSERT_FALSE(face.loops.empty());
  const double size = face.surface.chart().diagonal();
  for (const trim::ChartLoop& loop : face.loops) {
    for (std::size_t i = 0; i < loop.edges.size(); ++i) {
      const trim::ChartEdge& next = loop.edges[(i + 1) % loop.edges.size()];
      EXPECT_LE(geom::distance(loop.edges[i].end(), next.start()), 1e-11 * size);
      EXPECT_TRUE(face.surface.chart().grown(1e-11 * size).contains(loop.edges[i].start()));
    }
  }
}

/// Edges on seams come in pairs of one number, run opposite ways and have the same ends in space.
inline void check_seams(const trim::TrimmedSurface& face) {
  const geom::Box& chart = face.surface.chart();
  std::map<trim::SharedCurveId, std::vector<const trim::ChartEdge*>> seams;
  for (const trim::ChartLoop& loop : face.loops) {
    for (const trim::ChartEdge& edge : loop.edges) {
      const geom::Point p = edge.start(), q = edge.end(), m = edge.at(0.5 * (edge.from + edge.to));
      const bool along_v = p.x == q.x && p.x == m.x && (p.x == chart.low.x || p.x == chart.high.x);
      const bool along_u = p.y == q.y && p.y == m.y && (p.y == chart.low.y || p.y == chart.high.y);
      if (!(face.surface.closed_u() && along_v) && !(face.surface.closed_v() && along_u)) continue;
      ASSERT_TRUE(edge.shared.has_value());
      seams[*edge.shared].push_back(&edge);
    }
  }
  EXPECT_FALSE(seams.empty());
  for (const auto& [number, edges] : seams) {
    ASSERT_EQ(edges.size(), 2U);
    EXPECT_NE(edges[0]->against, edges[1]->against);
    const double off = 1e-10 * face.surface.size();
    EXPECT_LE(geom::distance(face.surface.at(edges[0]->start()), face.surface.at(edges[1]->end())), off);
    EXPECT_LE(geom::distance(face.surface.at(edges[0]->end()), face.surface.at(edges[1]->start())), off);
  }
}

inline trim::TrimLine circle(geom::Point middle, double radius, double from = 0.0) {
  const double turn = 2.0 * 3.14159265358979323846;
  const Curve arc = *Curve::arc({middle.x, middle.y, 0}, {radius, 0, 0}, {0, radius, 0}, from, from + turn);
  return {{{{.curve = arc, .from = from, .to = from + turn}}}, true};
}

}  // namespace dobra::surf::test
