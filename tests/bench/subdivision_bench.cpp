// Speed of the planar subdivision: insertion of n segments, one curve after the other, and point location; GEOS in the
// same run, which gets all lines at once (node, then polygonise). One thread. Families: offset curves of a smooth curve
// (no crossings), a skew grid of sqrt(n) lines (n crossings), random short segments (about n crossings), random chords
// of a square (1.6 sqrt(n) of them, about n / 2 crossings at all angles), one contour that crosses itself everywhere.
// Counters: edges that came out, ns_edge per such edge, geos (GEOS time / ours), bytes_edge on the heap, exponent of
// time in the number of edges since the size before. Figures belong in docs/algorithms/subdivision.md.

#include <benchmark/benchmark.h>
#include <geos_c.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <map>
#include <random>

#include "shared/topo/insert.h"
#include "shared/topo/locate.h"
#include "tests/bench/heap.h"

namespace {

using namespace dobra;
using namespace dobra::topo;
using geom::Point;
using geom::Polyline;
using Curves = std::vector<Polyline>;

/// Ten curves parallel to a sine, closed to thin layers by verticals at both ends.
Curves offsets(std::size_t n) {
  Curves curves(10);
  const std::size_t each = n / 10;
  for (std::size_t k = 0; k < 10; ++k) {
    for (std::size_t i = 0; i <= each; ++i) {
      const double x = 20.0 * static_cast<double>(i) / static_cast<double>(each);
      const double slope = 0.5 * std::cos(0.5 * x);
      const double d = 0.05 * static_cast<double>(k) / std::hypot(1.0, slope);
      curves[k].points.push_back({x + slope * d, std::sin(0.5 * x) - d});
    }
  }
  curves.push_back({{{1.0, 2.0}, {1.0, -2.0}}, false});
  curves.push_back({{{19.0, 2.0}, {19.0, -2.0}}, false});
  return curves;
}

Curves grid(std::size_t n) {
  Curves curves;
  const auto lines = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)) / 1.42);
  for (std::size_t i = 0; i < lines; ++i) {
    const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(lines);
    curves.push_back({{{0.0, t}, {1.0, t + 0.013}}, false});
    curves.push_back({{{t + 0.017, 0.0}, {t, 1.0}}, false});
  }
  return curves;
}

Curves needles(std::size_t n) {
  Curves curves;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> at(0.0, 1.0);
  const double length = 1.77 / std::sqrt(static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const Point p{at(random), at(random)};
    const double angle = 6.283185307 * at(random);
    curves.push_back({{p, {p.x + length * std::cos(angle), p.y + length * std::sin(angle)}}, false});
  }
  return curves;
}

Curves chords(std::size_t n) {
  Curves curves;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> at(0.0, 1.0);
  const auto count = static_cast<std::size_t>(1.6 * std::sqrt(static_cast<double>(n)));
  const auto on_border = [&](std::size_t side) {
    const double t = at(random);
    return side == 0 ? Point{t, 0.0} : side == 1 ? Point{1.0, t} : side == 2 ? Point{t, 1.0} : Point{0.0, t};
  };
  for (std::size_t i = 0; i < count; ++i) {
    const auto side = static_cast<std::size_t>(4.0 * at(random)) % 4;
    const auto other = (side + 1 + static_cast<std::size_t>(3.0 * at(random)) % 3) % 4;
    const Point p = on_border(side);
    curves.push_back({{p, on_border(other)}, false});
  }
  return curves;
}

/// One closed contour round a centre that goes forth and back: crosses itself some times a segment.
Curves wound(std::size_t n) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> at(-1.0, 1.0);
  const std::size_t count = n / 12;
  Polyline curve;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 6.283185307 * (static_cast<double>(i) + 6.0 * at(random)) / static_cast<double>(count);
    const double radius = 1.0 + 0.3 * at(random);
    curve.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  curve.points.push_back(curve.points.front());
  return {curve};
}

/// Of this process: the machine may be busy with others.
double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

GEOSContextHandle_t geos() {
  static const GEOSContextHandle_t context = GEOS_init_r();
  return context;
}

/// Seconds of noding and polygonising.
double geos_time(const Curves& curves) {
  std::vector<GEOSGeometry*> lines;
  for (const Polyline& curve : curves) {
    GEOSCoordSequence* const sequence = GEOSCoordSeq_create_r(geos(), static_cast<unsigned>(curve.points.size()), 2);
    for (unsigned i = 0; i < curve.points.size(); ++i) {
      GEOSCoordSeq_setXY_r(geos(), sequence, i, curve.points[i].x, curve.points[i].y);
    }
    lines.push_back(GEOSGeom_createLineString_r(geos(), sequence));
  }
  GEOSGeometry* const all =
      GEOSGeom_createCollection_r(geos(), GEOS_MULTILINESTRING, lines.data(), static_cast<unsigned>(lines.size()));
  const double start = seconds();
  GEOSGeometry* const noded = GEOSNode_r(geos(), all);
  GEOSGeometry* const polygons = GEOSPolygonize_r(geos(), &noded, 1);
  const double time = seconds() - start;
  GEOSGeom_destroy_r(geos(), polygons);
  GEOSGeom_destroy_r(geos(), noded);
  GEOSGeom_destroy_r(geos(), all);
  return time;
}

Subdivision build(const Curves& curves) {
  Subdivision s;
  for (const Polyline& curve : curves) {
    if (!insert(s, curve).ok()) std::abort();
  }
  return s;
}

void insertion(benchmark::State& state, Curves (*family)(std::size_t)) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const Curves curves = family(n);
  double ours = 0.0;
  double edges = 0.0;
  double bytes = 0.0;
  for (auto _ : state) {
    const double start = seconds();
    const std::size_t before = heap::in_use;
    const Subdivision s = build(curves);
    ours += seconds() - start;
    edges = static_cast<double>(s.edge_count());
    bytes = static_cast<double>(heap::in_use - before);
  }
  ours /= static_cast<double>(state.iterations());
  const double theirs = std::min(geos_time(curves), n > 50000 ? 1e300 : geos_time(curves));
  state.counters["edges"] = edges;
  state.counters["ns_edge"] = 1e9 * ours / edges;
  state.counters["geos"] = theirs / ours;
  state.counters["bytes_edge"] = bytes / edges;
  static std::map<Curves (*)(std::size_t), std::map<double, double>> known;  // by edges; of every family
  auto& times = known[family];
  times[edges] = ours;
  if (const auto at = times.find(edges); at != times.begin()) {
    const auto smaller = std::prev(at);
    state.counters["exponent"] = std::log(ours / smaller->second) / std::log(edges / smaller->first);
  }
}

void location(benchmark::State& state, Curves (*family)(std::size_t)) {
  const Subdivision s = build(family(static_cast<std::size_t>(state.range(0))));
  geom::Box box;
  for (const VertexId v : s.vertices()) box.add(s.point(v));
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> at(0.0, 1.0);
  for (auto _ : state) {
    const Point p{box.low.x + at(random) * box.width(), box.low.y + at(random) * box.height()};
    benchmark::DoNotOptimize(locate(s, p));
  }
}

#define DOBRA_FAMILY(name)                 \
  BENCHMARK_CAPTURE(insertion, name, name) \
      ->Arg(1000)                          \
      ->Arg(3162)                          \
      ->Arg(10000)                         \
      ->Arg(31623)                         \
      ->Arg(100000)                        \
      ->Unit(benchmark::kMillisecond);     \
  BENCHMARK_CAPTURE(location, name, name)->Arg(1000)->Arg(10000)->Arg(100000)
DOBRA_FAMILY(offsets);
DOBRA_FAMILY(grid);
DOBRA_FAMILY(needles);
DOBRA_FAMILY(chords);
DOBRA_FAMILY(wound);

}  // namespace

BENCHMARK_MAIN();
