// Seeded random polylines of many kinds against the brute-force oracle, and every contour of the test data.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <random>

#include "shared/offset/arcs.h"
#include "tests/support/offset_oracle.h"

namespace dobra::offset {
namespace {

using geom::Point;
using geom::Polyline;

struct Case {
  Polyline base;
  double distance;
  support::Touching touching = support::Touching::Counted;
  bool simple = false;  ///< Closed and without self-crossings: all pieces must be closed.
};

Case random_case(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> real(0.0, 1.0);
  std::uniform_int_distribution<int> small(-3, 3);
  const std::size_t count = 5 + random() % 60;
  Case c{{{}, false}, 0.0, seed % 6 == 3 ? support::Touching::Allowed : support::Touching::Counted, false};
  auto& points = c.base.points;
  Point p{0, 0};
  switch (seed % 6) {
    case 0:  // random walk
      for (std::size_t i = 0; i < count; ++i) points.push_back(p = p + geom::Vector{normal(random), normal(random)});
      break;
    case 1:  // graph of noise
      for (std::size_t i = 0; i < count; ++i) points.push_back({0.3 * double(i), normal(random)});
      break;
    case 2: {  // noisy star
      c.base.closed = true;
      c.simple = true;
      for (std::size_t i = 0; i < count; ++i) {
        const double a = 2 * std::numbers::pi * double(i) / double(count);
        const double r = 1.0 + 2.0 * real(random);
        points.push_back({r * std::cos(a), r * std::sin(a)});
      }
      break;
    }
    case 3:  // integer rectilinear, with repeats and spikes
      for (std::size_t i = 0; i < count; ++i) {
        const double step = small(random);
        p = i % 2 == 0 ? Point{p.x + step, p.y} : Point{p.x, p.y + step};
        points.push_back(p);
      }
      break;
    case 4:  // spikes and repeated points
      for (std::size_t i = 0; i < count; ++i) {
        const Point next = p + geom::Vector{real(random), 0.6 * normal(random)};
        points.push_back(p);
        if (random() % 4 == 0) points.push_back(p);
        if (random() % 4 == 0) {  // out and exactly back
          points.push_back(p + geom::Vector{normal(random), normal(random)});
          points.push_back(p);
        }
        p = next;
      }
      break;
    default:  // closed and crossing itself
      c.base.closed = true;
      for (std::size_t i = 0; i < count; ++i) points.push_back({3 * real(random), 3 * real(random)});
  }
  const double integer[] = {0.5, 1.0, 1.5};
  c.distance = seed % 6 == 3 ? integer[random() % 3] : 0.05 + 0.8 * real(random);
  return c;
}

bool usable(const Polyline& base) { return geom::validate(geom::without_repeated_points(base)).ok(); }

/// All that the oracle finds wrong with the curves of one base; counts, so that a run tells how many cases fail.
std::string judge(const Case& c, Side side, Join join) {
  OffsetOptions options;
  options.side = side;
  options.join = join;
  const auto result = offset(c.base, std::vector<double>{c.distance}, options);
  if (!result.ok()) return result.error().message;
  const OffsetCurve& curve = result->front();
  const double slack = join == Join::Round ? 1e-4 + 1e-9 : 1e-9;
  std::vector<Polyline> all;
  for (const auto& arcs : curve.pieces) {
    const Chords piece = chords(arcs, c.base, 1e-4);
    all.push_back(piece.polyline);
    if (arcs.edges.size() + (arcs.closed ? 0 : 1) != arcs.points.size()) return "wrong number of edges";
    if (support::least_distance(piece.polyline, c.base) < c.distance * (1.0 - slack)) {
      return "too near: " + std::to_string(support::least_distance(piece.polyline, c.base) / c.distance);
    }
    if (support::crossings(piece.polyline, c.touching) > 0) return "crosses itself";
    if (c.simple && !piece.polyline.closed) return "open piece of a simple contour";
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      for (std::size_t k = 0; k < all[i].segment_count(); ++k) {
        for (std::size_t m = 0; m < all[j].segment_count(); ++m) {
          const auto meet = geom::intersect(all[i].segment(k), all[j].segment(m));
          if (meet.kind == geom::IntersectionKind::Point && meet.start.proper()) return "pieces cross";
        }
      }
    }
  }
  if (join != Join::Round || curve.dropped > 0) return {};
  Polyline seen = c.base;  // the oracle knows only the right side
  if (side == Side::LeftOfTravel) {
    seen = geom::reversed(seen);
  }
  for (const Point p : support::true_points(seen, c.distance, 7)) {
    // What touches itself within rounding counts as closed: such points are not asked for.
    if (support::distance_to_any(all, p) <= 3e-4 * c.distance) continue;
    const double wider = c.distance * (1.0 + 1e-9);
    const geom::Point beyond = p;
    bool touches = false;
    std::size_t feet = 0;
    for (std::size_t i = 0; i < seen.segment_count(); ++i) {
      if (geom::distance(seen.segment(i), beyond) <= wider) ++feet;
    }
    touches = feet > 1;
    if (!touches) return "missing point";
  }
  return {};
}

TEST(OffsetRandom, NoRandomPolylineFails) {
  const char* cases = std::getenv("DOBRA_RANDOM_CASES");
  const std::uint32_t count = cases ? static_cast<std::uint32_t>(std::atoi(cases)) : 1000;
  std::size_t failed = 0;
  for (std::uint32_t seed = 0; seed < count; ++seed) {
    const Case c = random_case(seed);
    if (!usable(c.base)) continue;
    for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
      for (const Join join : {Join::Mitre, Join::Round}) {
        const std::string wrong = judge(c, side, join);
        if (wrong.empty()) continue;
        ++failed;
        ADD_FAILURE() << "seed " << seed << " kind " << seed % 6 << " side " << int(side) << " join " << int(join) << " D "
                      << c.distance << ": " << wrong;
      }
    }
  }
  EXPECT_EQ(failed, 0U);
}

TEST(OffsetRandom, EveryContourOfTheDataKeepsItsDistance) {
  const char* folder = std::getenv("DOBRA_TEST_DATA");
  const std::string path = folder ? folder : "/work/shared/data";
  if (!std::filesystem::exists(path + "/contours")) GTEST_SKIP() << "DOBRA_TEST_DATA is not set to a folder with contours/";
  std::size_t judged = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path + "/contours")) {
    const std::string file = entry.path().string();
    if (!file.ends_with(".dat") && entry.path().filename().string().rfind("cdt_", 0) != 0) continue;
    for (const Polyline& contour : support::read_contours(file)) {
      if (!usable(contour)) continue;
      const double size = contour.box().diagonal();
      for (const double part : {0.002, 0.01, 0.05}) {
        for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
          for (const Join join : {Join::Mitre, Join::Round}) {
            ++judged;
            EXPECT_EQ(judge({contour, part * size, support::Touching::Counted, false}, side, join), "") << file << " " << part;
          }
        }
      }
    }
  }
  EXPECT_GE(judged, 60U);
}

}  // namespace
}  // namespace dobra::offset
