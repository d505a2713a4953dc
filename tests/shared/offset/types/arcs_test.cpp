#include "shared/offset/types/arcs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shared/offset/offset.h"

namespace dobra::offset {
namespace {

using geom::Polyline;
using std::numbers::pi;

OffsetPiece round_piece(const Polyline& base, double distance, Side side) {
  OffsetOptions options;
  options.join = Join::Round;
  options.side = side;
  return offset(base, std::vector<double>{distance}, options).value().front().pieces.at(0);
}

TEST(Arcs, SquareGrowsToItsClosedForm) {
  const Polyline square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, true};
  for (const double shift : {0.0, 1e6}) {
    for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
      Polyline base = side == Side::RightOfTravel ? square : geom::reversed(square);
      for (auto& p : base.points) p.x += shift;
      const OffsetPiece piece = round_piece(base, 0.5, side);
      EXPECT_EQ(piece.points.size(), 8U);
      EXPECT_NEAR(length(piece, base), 8 + pi, 1e-9);
      EXPECT_NEAR(std::abs(signed_area(piece, base)), 4 + 4 + pi / 4, 1e-9);
      EXPECT_EQ(signed_area(piece, base) > 0, side == Side::RightOfTravel);
    }
  }
}

TEST(Arcs, ChordsKeepTheirToleranceAndTheirBaseEdges) {
  const Polyline spike{{{-3, 0}, {0, 0}, {-3, 0}}, false};  // the arc turns by half a turn
  for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
    const OffsetPiece piece = round_piece({{{-3, 1}, {0, 1}, {-3, 1.5}}, false}, 0.2, side);
    EXPECT_EQ(piece.points.size(), side == Side::RightOfTravel ? 4U : 3U);
  }
  const OffsetPiece piece = round_piece(spike, 1, Side::RightOfTravel);
  EXPECT_NEAR(length(piece, spike), 6 + pi, 1e-12);
  for (const double tolerance : {0.3, 1e-2, 1e-5}) {
    const Chords drawn = chords(piece, spike, tolerance);
    ASSERT_EQ(drawn.base_edge.size(), drawn.polyline.segment_count());
    for (std::size_t i = 0; i < drawn.base_edge.size(); ++i) {
      const geom::Segment s = drawn.polyline.segment(i);
      const bool about_the_tip = s.from.x > 1e-9 || s.to.x > 1e-9;
      if (!about_the_tip) continue;
      EXPECT_EQ(drawn.base_edge[i], 0U);
      EXPECT_NEAR(geom::distance(s.from, spike.points[1]), 1, 1e-14);
      EXPECT_GE(geom::distance(s, spike.points[1]), 1 - tolerance);
    }
  }
}

}  // namespace
}  // namespace dobra::offset
