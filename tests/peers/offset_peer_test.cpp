// Areas by distance against those of GEOS, which no program links: polygons with holes, grown and shrunk, and lines
// with caps, at the same tolerance of arcs.

#include <geos_c.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "shared/offset/area.h"

namespace dobra::offset {
namespace {

using geom::Point;
using geom::Polyline;

using std::numbers::pi;
constexpr int quadrant_segments = 60;
/// GEOS simplifies its input by up to D / 100, rounds differently at crossings, and its chords are a little longer or
/// shorter.
constexpr double tolerance = 1e-4;

class Peer {
 public:
  Peer() : geos_(GEOS_init_r()) {}
  ~Peer() { GEOS_finish_r(geos_); }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  double area(const std::vector<Polyline>& polygon, double distance, int join) const {
    std::vector<GEOSGeometry*> holes;
    for (std::size_t i = 1; i < polygon.size(); ++i)
      holes.push_back(GEOSGeom_createLinearRing_r(geos_, points(polygon[i])));
    GEOSGeometry* const shell = GEOSGeom_createLinearRing_r(geos_, points(polygon[0]));
    return buffered(GEOSGeom_createPolygon_r(geos_, shell, holes.data(), static_cast<unsigned>(holes.size())), distance,
                    join, GEOSBUF_CAP_ROUND);
  }
  double area(const Polyline& line, double distance, int join, int cap) const {
    return buffered(GEOSGeom_createLineString_r(geos_, points(line)), distance, join, cap);
  }

 private:
  GEOSCoordSequence* points(const Polyline& line) const {
    const std::size_t count = line.points.size() + (line.closed ? 1 : 0);
    GEOSCoordSequence* const made = GEOSCoordSeq_create_r(geos_, static_cast<unsigned>(count), 2);
    for (std::size_t i = 0; i < count; ++i) {
      const Point p = line.points[i % line.points.size()];
      GEOSCoordSeq_setXY_r(geos_, made, static_cast<unsigned>(i), p.x, p.y);
    }
    return made;
  }
  double buffered(GEOSGeometry* input, double distance, int join, int cap) const {
    GEOSGeometry* const made = GEOSBufferWithStyle_r(geos_, input, distance, quadrant_segments, cap, join, 4.0);
    double area = -1;
    GEOSArea_r(geos_, made, &area);
    GEOSGeom_destroy_r(geos_, made);
    GEOSGeom_destroy_r(geos_, input);
    return area;
  }
  GEOSContextHandle_t geos_;
};

std::vector<Polyline> random_holed(std::mt19937_64& random) {
  std::uniform_real_distribution<double> from(0, 1);
  const auto star = [&](Point centre, double least, double most, int n) {
    Polyline ring{{}, true};
    for (int i = 0; i < n; ++i) {
      const double r = least + (most - least) * from(random);
      ring.points.push_back({centre.x + r * std::cos(2 * pi * i / n), centre.y + r * std::sin(2 * pi * i / n)});
    }
    return ring;
  };
  std::vector<Polyline> polygon{star({0, 0}, 6, 10, 40)};
  for (const Point centre : {Point{-2.6, -1}, {2.4, 1.2}, {0, 4}, {1, -3.5}}) {
    if (random() % 4 != 0) polygon.push_back(geom::reversed(star(centre, 0.4, 1.2, 12)));
  }
  return polygon;
}

TEST(AreaPeer, OFF_c_RandomPolygonsWithHolesHaveTheAreasOfGeos) {
  const Peer peer;
  const AreaOptions options{.join = Join::Round, .arc_tolerance = 1e-4};
  double worst = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937_64 random(seed);
    const std::vector<Polyline> polygon = random_holed(random);
    for (const double d : {0.1, 0.5, 1.1, 2.5, -0.1, -0.4, -0.9, -1.6}) {
      const auto made = grown(polygon, {{d}}, options);
      ASSERT_TRUE(made.ok());
      const double theirs = peer.area(polygon, d, GEOSBUF_JOIN_ROUND);
      // Of the size of what changes.
      const double scale = std::abs(d) * made->front().length + 1e-3;
      worst = std::max(worst, std::abs(made->front().area - theirs) / scale);
      EXPECT_NEAR(made->front().area, theirs, tolerance * scale) << "seed " << seed << " d " << d;
    }
  }
  RecordProperty("worst", std::to_string(worst));
  std::printf("greatest difference: %.2g of D times the length of the outline\n", worst);
}

TEST(AreaPeer, OFF_c_RandomLinesHaveTheAreasOfGeosWithEveryCap) {
  const Peer peer;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> from(-1, 1);
    Polyline line{{{0, 0}}, false};
    for (int i = 0; i < 30; ++i) {
      const Point p = line.points.back();
      line.points.push_back({p.x + 1.5 + from(random), p.y + 1.5 * from(random)});
    }
    for (const auto& [cap, theirs] :
         {std::pair{Cap::Round, GEOSBUF_CAP_ROUND}, {Cap::Flat, GEOSBUF_CAP_FLAT}, {Cap::Square, GEOSBUF_CAP_SQUARE}}) {
      const auto made = around_line(line, {{0.3}}, {.join = Join::Round, .cap = cap, .arc_tolerance = 1e-4});
      ASSERT_TRUE(made.ok());
      const double scale = 0.3 * made->front().length;
      EXPECT_NEAR(made->front().area, peer.area(line, 0.3, GEOSBUF_JOIN_ROUND, theirs), tolerance * scale)
          << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace dobra::offset
