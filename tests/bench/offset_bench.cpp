// Speed of the offset engine against two marks in the same run: "raw", writing the untrimmed offset vertices of the
// same base (the least that any method does), and GEOS (one-sided or polygon buffer, whichever the base calls for). One
// thread. Arguments: size; 13 distances. Counters: raw and geos are the time ratios (ours / raw, GEOS / ours); raw_ns
// that of raw; peak_bytes is the heap above input and output, per base point, geos_runs how many runs of GEOS count.
// tests/bench/offset_table.py makes a table of a run, with the exponents of time in n. The median of at least five runs
// counts, for all three (GEOS: of one where that takes more than 2 s), and memory once taken stays with the process:
// what the system takes to hand out pages tells nothing about them. Single rows: --benchmark_filter='^gear_in/1000/'
// (family and size; any regular expression). --alone leaves out raw and GEOS, for runs that are compared with each
// other (tests/bench/offset_ablation.py). Figures belong in docs/algorithms/offset.md.

#include <benchmark/benchmark.h>
#include <geos_c.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <limits>
#include <numbers>
#include <random>

#include "shared/base/parallel.h"
#include "shared/offset/offset.h"
#include "tests/bench/heap.h"

namespace {

using namespace dobra;
using namespace dobra::offset;
using geom::Point;
using geom::Polyline;
using std::numbers::pi;

// Families: the names are those of the table in issue 3.
Polyline smooth(std::size_t n) {
  Polyline c;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = 100.0 * static_cast<double>(i) / static_cast<double>(n - 1);
    c.points.push_back(
        {x, 3 * std::sin(2 * pi * x / 25) + std::sin(2 * pi * x / 9.1 + 1) + 0.3 * std::sin(2 * pi * x / 4.3 + 2)});
  }
  return c;
}

Polyline fractal(std::size_t n) {  // midpoint displacement, H = 0.6
  std::size_t m = 1;
  while (m + 1 < n) m *= 2;
  std::vector<double> y(m + 1, 0.0);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  double size = 6;
  for (std::size_t step = m; step > 1; step /= 2, size *= std::pow(0.5, 0.6)) {
    for (std::size_t i = step / 2; i < m; i += step)
      y[i] = 0.5 * (y[i - step / 2] + y[i + step / 2]) + size * normal(random);
  }
  Polyline c;
  for (std::size_t i = 0; i < n; ++i)
    c.points.push_back({100.0 * static_cast<double>(i) / static_cast<double>(n - 1), y[i]});
  return c;
}

/// A horizon bent round 225 degrees of a circle, its heights along the radius, so that it comes back under itself as a
/// lying fold does: open, and in no direction a graph.
Polyline bent(Polyline c) {
  constexpr double angle = 1.25 * pi;
  const double radius = c.points.back().x / angle;
  for (Point& p : c.points) {
    const double t = p.x / radius;
    p = {(radius + p.y) * std::sin(t), (radius + p.y) * std::cos(t)};
  }
  return c;
}
Polyline smooth_bent(std::size_t n) { return bent(smooth(n)); }
Polyline fractal_bent(std::size_t n) { return bent(fractal(n)); }

template <class Radius>
Polyline polar(std::size_t n, Radius&& radius) {
  Polyline c{{}, true};
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
    c.points.push_back({radius(t) * std::cos(t), radius(t) * std::sin(t)});
  }
  return c;
}
Polyline gear(std::size_t n) {
  return polar(n, [](double t) { return 20 + 2 * std::tanh(5 * std::sin(24 * t)); });
}
Polyline blob(std::size_t n) {
  return polar(n, [](double t) { return 20 + 4 * std::sin(3 * t) + 2 * std::sin(7 * t + 1) + std::sin(13 * t + 2); });
}
Polyline circle(std::size_t n) {
  return polar(n, [](double) { return 20.0; });
}
Polyline spiral(std::size_t n) {  // open, and both sides meet
  Polyline c;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2 + 60 * static_cast<double>(i) / static_cast<double>(n - 1);
    const double r = 0.6 * t + 0.3 * std::sin(7 * t);
    c.points.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return c;
}
Polyline coast(
    std::size_t n) {  // rough at all scales and simple: each edge gets a knee in its triangle, on alternate sides
  std::mt19937 random(9);
  std::uniform_real_distribution<double> fresh(0.2, 0.6);  // angles of the triangle, at a new point
  std::uniform_real_distribution<double> share(0.8, 1.0);  // and at an old one, of what the triangle around it leaves
  struct Edge {
    Point from;
    double at_from, at_to;
  };
  std::vector<Edge> edges;
  for (const Point& p : polar(6, [](double) { return 40.0; }).points) edges.push_back({p, 0.5, 0.5});
  for (double side = 1; edges.size() < n; side = -side) {
    std::vector<Edge> finer;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto [from, a, b] = edges[i];
      const geom::Vector along = edges[(i + 1) % edges.size()].from - from;
      const double foot = std::tan(b) / (std::tan(a) + std::tan(b));
      const Point knee = from + foot * along + side * foot * std::tan(a) * geom::right_of(along);
      finer.push_back({from, a * share(random), fresh(random)});
      finer.push_back({knee, fresh(random), b * share(random)});
    }
    edges = std::move(finer);
  }
  Polyline c{{}, true};
  for (const Edge& edge : edges) c.points.push_back(edge.from);
  return c;
}

Polyline random_walk(std::size_t n) {  // open, crosses itself everywhere
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Polyline c;
  Point p{0, 0};
  const double step = 30.0 / std::sqrt(static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i)
    c.points.push_back(p = p + geom::Vector{step * normal(random), step * normal(random)});
  return c;
}
Polyline rough_arc(std::size_t n) {  // half of the coast: open, rough, and not monotone
  Polyline c = coast(n);
  c.closed = false;
  c.points.resize(c.points.size() / 2 + c.points.size() / 6);
  return c;
}

struct Family {
  const char* name;
  Polyline (*make)(std::size_t);
  Side side;
  Join join;
  double step;
  std::size_t greatest;
  std::size_t greatest_geos = 100'000;  ///< Above it GEOS is not asked: on rough curves one call takes minutes.
  double patience = 10.0;               ///< With GEOS: a longer first run does not count, s.
};

/// Of this process on the processor: with one thread the time taken, whatever else the machine does.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double seconds_since(double start) { return processor_seconds() - start; }
double median(std::vector<double> seconds) {
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  return *middle;
}
/// Runs of ours, and of raw.
constexpr int runs_of(std::size_t n) { return n < 5000 ? 51 : 7; }

/// One foot point a segment: a square root, a division and 20 bytes of result.
double raw_seconds(const Polyline& base, const std::vector<double>& distances) {
  std::vector<double> runs;
  while (runs.size() < static_cast<std::size_t>(runs_of(base.points.size()))) {
    const auto start = processor_seconds();
    std::vector<OffsetPiece> curves;
    for (const double d : distances) {
      OffsetPiece piece;
      piece.points.reserve(base.points.size());
      piece.edges.reserve(base.points.size());
      for (std::size_t i = 0; i < base.segment_count(); ++i) {
        const geom::Segment s = base.segment(i);
        const geom::Vector v = s.vector();
        const double f = d / std::sqrt(geom::dot(v, v));
        piece.points.push_back(s.from + f * geom::right_of(v));
        piece.edges.push_back(OffsetEdge::line(i));
      }
      curves.push_back(std::move(piece));
    }
    benchmark::DoNotOptimize(curves.data());
    runs.push_back(seconds_since(start));
  }
  return median(std::move(runs));
}

/// All distances with GEOS at the same arc tolerance, each run; none if the first takes longer than the family's
/// patience.
std::vector<double> geos_runs(const Polyline& base, const Family& family, const std::vector<double>& distances) {
  const GEOSContextHandle_t geos = GEOS_init_r();
  const std::size_t count = base.points.size() + (base.closed ? 1 : 0);
  GEOSCoordSequence* const points = GEOSCoordSeq_create_r(geos, static_cast<unsigned>(count), 2);
  for (std::size_t i = 0; i < count; ++i) {
    const Point p = base.points[i % base.points.size()];
    GEOSCoordSeq_setXY_r(geos, points, static_cast<unsigned>(i), p.x, p.y);
  }
  GEOSGeometry* const input =
      base.closed ? GEOSGeom_createPolygon_r(geos, GEOSGeom_createLinearRing_r(geos, points), nullptr, 0)
                  : GEOSGeom_createLineString_r(geos, points);
  const bool outwards = family.side == Side::RightOfTravel;
  const auto once = [&] {
    const auto start = processor_seconds();
    for (const double d : distances) {
      GEOSBufferParams* const params = GEOSBufferParams_create_r(geos);
      GEOSBufferParams_setQuadrantSegments_r(geos, params, 18);
      GEOSBufferParams_setJoinStyle_r(geos, params,
                                      family.join == Join::Round ? GEOSBUF_JOIN_ROUND : GEOSBUF_JOIN_MITRE);
      GEOSBufferParams_setMitreLimit_r(geos, params, 4.0);
      GEOSBufferParams_setSingleSided_r(geos, params, base.closed ? 0 : 1);
      GEOSGeom_destroy_r(geos, GEOSBufferWithParams_r(geos, input, params, (base.closed == outwards) ? d : -d));
      GEOSBufferParams_destroy_r(geos, params);
      if (seconds_since(start) > family.patience) break;
    }
    return seconds_since(start);
  };
  std::vector<double> runs{once()};
  while (runs.front() < 2.0 && runs.size() < 5) runs.push_back(once());
  GEOSGeom_destroy_r(geos, input);
  GEOS_finish_r(geos);
  if (runs.front() > family.patience) runs.clear();
  return runs;
}

enum class Peers { Asked, Left };

void offset_family(benchmark::State& state, const Family& family, Peers peers) {
  base::set_thread_count(1);
  const auto n = static_cast<std::size_t>(state.range(0));
  const Polyline base = family.make(n);
  std::vector<double> distances;
  for (int k = 1; k <= 13; ++k) distances.push_back(family.step * k);
  OffsetOptions options;
  options.side = family.side;
  options.join = family.join;
  std::vector<double> runs;
  std::size_t pieces = 0;
  for (auto _ : state) {
    const auto start = processor_seconds();
    const auto curves = offset::offset(base, distances, options);
    runs.push_back(seconds_since(start));
    if (!curves.ok()) return state.SkipWithError(curves.error().message.c_str());
    pieces = 0;
    for (const auto& curve : *curves) pieces += curve.pieces.size();
  }
  const std::size_t before = heap::in_use;
  heap::peak = heap::in_use;
  const auto one = offset::offset(base, std::vector<double>{distances[6]}, options);
  const std::size_t highest = heap::peak - before;
  std::size_t output = 0;
  for (const auto& piece : one->front().pieces) output += 16 * piece.points.capacity() + 4 * piece.edges.capacity();
  const double points = static_cast<double>(base.points.size());
  const double seconds = median(std::move(runs));
  state.counters["ns_point_curve"] = seconds / 13 / points * 1e9;
  if (peers == Peers::Left) return;
  const double raw = raw_seconds(base, distances);
  state.counters["raw"] = seconds / raw;
  state.counters["raw_ns"] = raw / 13 / points * 1e9;
  const std::vector<double> geos =
      n <= family.greatest_geos ? geos_runs(base, family, distances) : std::vector<double>{};
  state.counters["geos"] = geos.empty() ? 0.0 : median(geos) / seconds;  // 0: not asked, or took too long
  state.counters["geos_runs"] = static_cast<double>(geos.size());
  state.counters["peak_bytes"] = static_cast<double>(highest - std::min(highest, output)) / points;
  state.counters["pieces"] = static_cast<double>(pieces);
}

const Family families[] = {
    {"smooth_round", smooth, Side::RightOfTravel, Join::Round, 0.2, 1'000'000},
    {"smooth_mitre", smooth, Side::RightOfTravel, Join::Mitre, 0.2, 1'000'000},
    {"fractal_round", fractal, Side::RightOfTravel, Join::Round, 0.2, 1'000'000, 10'000, 60.0},
    {"fractal_mitre", fractal, Side::RightOfTravel, Join::Mitre, 0.2, 1'000'000, 1000},
    {"smooth_bent", smooth_bent, Side::RightOfTravel, Join::Round, 0.2, 1'000'000},
    {"smooth_bent_mitre", smooth_bent, Side::RightOfTravel, Join::Mitre, 0.2, 1'000'000},
    {"fractal_bent", fractal_bent, Side::RightOfTravel, Join::Round, 0.2, 1'000'000, 1000},
    {"fractal_bent_mitre", fractal_bent, Side::RightOfTravel, Join::Mitre, 0.2, 100'000, 1000},
    {"spiral", spiral, Side::RightOfTravel, Join::Round, 0.1, 1'000'000},
    {"spiral_mitre", spiral, Side::RightOfTravel, Join::Mitre, 0.1, 1'000'000},
    {"walk_round", random_walk, Side::RightOfTravel, Join::Round, 0.1, 100'000, 1000},
    {"walk_mitre", random_walk, Side::RightOfTravel, Join::Mitre, 0.1, 100'000, 1000},
    {"rough_arc_round", rough_arc, Side::RightOfTravel, Join::Round, 0.2, 100'000, 1000},
    {"rough_arc_mitre", rough_arc, Side::RightOfTravel, Join::Mitre, 0.2, 100'000, 1000},
    {"gear_in", gear, Side::LeftOfTravel, Join::Round, 0.18, 100'000},
    {"gear_out", gear, Side::RightOfTravel, Join::Round, 0.18, 100'000},
    {"blob_in", blob, Side::LeftOfTravel, Join::Round, 0.18, 100'000},
    {"blob_out", blob, Side::RightOfTravel, Join::Round, 0.18, 100'000},
    {"circle_in", circle, Side::LeftOfTravel, Join::Round, 0.18, 100'000},
    {"coast_in", coast, Side::LeftOfTravel, Join::Round, 0.2, 100'000, 10'000},
    {"coast_out", coast, Side::RightOfTravel, Join::Round, 0.2, 100'000, 10'000},
    {"gear_in_mitre", gear, Side::LeftOfTravel, Join::Mitre, 0.18, 100'000},
    {"gear_out_mitre", gear, Side::RightOfTravel, Join::Mitre, 0.18, 100'000},
    {"blob_in_mitre", blob, Side::LeftOfTravel, Join::Mitre, 0.18, 100'000},
    {"blob_out_mitre", blob, Side::RightOfTravel, Join::Mitre, 0.18, 100'000},
    {"coast_in_mitre", coast, Side::LeftOfTravel, Join::Mitre, 0.2, 100'000, 10'000},
    {"coast_out_mitre", coast, Side::RightOfTravel, Join::Mitre, 0.2, 100'000, 10'000},
};

}  // namespace

int main(int count, char** arguments) {
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  char** const last =
      std::remove_if(arguments + 1, arguments + count, [](const char* a) { return std::strcmp(a, "--alone") == 0; });
  const Peers peers = last == arguments + count ? Peers::Asked : Peers::Left;
  count = static_cast<int>(last - arguments);
  for (const Family& family : families) {
    for (std::size_t n = 1000; n <= family.greatest; n *= 10) {
      auto* const entry = benchmark::RegisterBenchmark(
          family.name, [&family, peers](benchmark::State& state) { offset_family(state, family, peers); });
      entry->Arg(static_cast<std::int64_t>(n))->Unit(benchmark::kMillisecond)->Iterations(runs_of(n));
    }
  }
  benchmark::Initialize(&count, arguments);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
