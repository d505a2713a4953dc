// That the verifier raises no false alarm where places are hidden, or slits closed, by next to nothing: contours with
// small integer coordinates at the distances that occur between their sites, at their half, at the radii of circles
// through three points, each an ulp or 1e-13 to 1e-8 of itself more or less; far from the origin too, down to distances
// of an ulp of the coordinates. And that it still finds what is truly wrong there. DOBRA_RANDOM_CASES=100000 for a long
// search.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "shared/offset/offset.h"
#include "shared/offset/verifier/verify.h"

namespace dobra::offset::verifier {
namespace {

using geom::Point;
using geom::Polyline;

struct Case {
  Polyline base;
  OffsetOptions options;
  double distance = 1.0;
};

double circle_through(Point a, Point b, Point c) {
  const double twice = std::abs(geom::cross(b - a, c - a));
  return geom::distance(a, b) * geom::distance(b, c) * geom::distance(c, a) / (2 * twice);
}

double off_line(Point a, Point b, Point p) { return std::abs(geom::cross(b - a, p - a)) / geom::distance(a, b); }

class Source {
 public:
  explicit Source(std::uint64_t seed) : random_(seed) {}
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }

  Case next() {
    Case made;
    made.base = contour();
    made.options.side = below(2) == 0 ? Side::RightOfTravel : Side::LeftOfTravel;
    made.options.join = std::array{Join::Mitre, Join::Bisector, Join::Round, Join::Bevel}[below(4)];
    made.options.keep = Keep::AllPieces;
    made.distance = distance(made.base.points);
    if (below(3) == 0) {
      const Point by{std::ldexp(1.0 + below(7), below(40)), std::ldexp(1.0 + below(7), below(40))};
      for (Point& p : made.base.points) p = p + (by - Point{});
    }
    if (below(8) == 0) {  // about an ulp of the coordinates
      const double greatest = std::max(std::abs(made.base.points[0].x), std::abs(made.base.points[0].y)) + 1;
      made.distance = (1 + below(4)) * std::ldexp(greatest, -53 + below(3));
    }
    return made;
  }

 private:
  Polyline contour() {
    Polyline made{{}, below(2) == 0};
    const int count = 3 + below(6);
    const int size = 3 + below(6);
    while (static_cast<int>(made.points.size()) < count) {
      const Point p{static_cast<double>(below(size)), static_cast<double>(below(size))};
      if (made.points.empty() || (p != made.points.back() && p != made.points.front())) made.points.push_back(p);
    }
    return made;
  }
  double distance(const std::vector<Point>& points) {
    const auto any = [&] { return points[static_cast<std::size_t>(below(static_cast<int>(points.size())))]; };
    double d = 0.0;
    while (!(d > 0.01) || !(d < 100)) {
      const int way = below(3);
      d = way == 0   ? geom::distance(any(), any())
          : way == 1 ? off_line(any(), any(), any())
                     : circle_through(any(), any(), any());
    }
    if (below(2) == 0) d *= 0.5;
    const int change = below(4);
    if (change == 0) return d;
    const double away = below(2) == 0 ? 0.0 : 1000.0;
    if (change == 1) return std::nextafter(d, away);
    return d * (1 + (away > 0 ? 1 : -1) * std::pow(10.0, -8 - below(6)));
  }
  std::mt19937_64 random_;
};

std::string text_of(const Case& c) {
  std::string text = c.base.closed ? "closed" : "open";
  char number[64];
  for (const Point p : c.base.points) {
    std::snprintf(number, sizeof(number), " %.17g,%.17g", p.x, p.y);
    text += number;
  }
  std::snprintf(number, sizeof(number), "; D %.17g join %d side %d", c.distance, static_cast<int>(c.options.join),
                static_cast<int>(c.options.side));
  return text + number;
}

std::size_t cases() {
  const char* const wanted = std::getenv("DOBRA_RANDOM_CASES");
  return wanted != nullptr ? std::stoul(wanted) : 400;
}

TEST(VerifyAlarms, NothingIsFoundWhereSitesAreAsFarAsTheDistanceOrHiddenByNextToNothing) {
  for (std::size_t seed = 1; seed <= cases(); ++seed) {
    const Case c = Source(seed).next();
    const auto made = offset(c.base, std::vector<double>{c.distance}, c.options);
    if (!made.ok()) continue;  // too small or without a length
    const auto verified = verify(c.base, c.options, made->front());
    ASSERT_TRUE(verified.ok());
    const geom::Box box = c.base.box();
    EXPECT_TRUE(!verified->coarse || c.distance < 0x1p-45 * std::max(box.high.x, box.high.y)) << text_of(c);
    for (const Finding& finding : verified->findings)
      ADD_FAILURE() << "seed " << seed << ": " << to_string(finding) << "\n" << text_of(c);
  }
}

TEST(VerifyAlarms, AVertexThatIsOffByATenMillionthOfTheDistanceIsFound) {
  std::size_t asked = 0;
  for (std::size_t seed = 1; seed <= 200; ++seed) {
    Case c = Source(seed).next();
    c.options.join = Join::Round;
    const auto made = offset(c.base, std::vector<double>{c.distance}, c.options);
    if (!made.ok() || made->front().pieces.empty()) continue;
    OffsetCurve curve = made->front();
    Point& moved = curve.pieces[0].points[0];
    const double greatest = std::max(std::abs(moved.x), std::abs(moved.y));
    if (!(1e-7 * c.distance > 0x1p-44 * greatest)) continue;  // the fault would drown in rounding
    moved = moved + geom::Vector{6e-8 * c.distance, 8e-8 * c.distance};
    const auto verified = verify(c.base, c.options, curve);
    ASSERT_TRUE(verified.ok());
    EXPECT_FALSE(verified->coarse);
    EXPECT_FALSE(verified->ok()) << "seed " << seed << ": " << text_of(c);
    ++asked;
  }
  EXPECT_GE(asked, 30U);
}

TEST(VerifyAlarms, CoordinatesTooCoarseForTheDistanceAreSaidToBe) {
  const Polyline bent{{{0, 2}, {1, 4}, {3, 3}, {3, 4}}, false};
  for (const auto& [distance, coarse] : {std::pair{6.7e-16, true}, {1e-14, true}, {1e-13, false}, {1.0, false}}) {
    const OffsetOptions options{.join = Join::Bevel};
    const auto made = offset(bent, std::vector<double>{distance}, options);
    ASSERT_TRUE(made.ok());
    const auto verified = verify(bent, options, made->front());
    ASSERT_TRUE(verified.ok());
    EXPECT_TRUE(verified->ok()) << distance;
    EXPECT_EQ(verified->coarse, coarse) << distance;
  }
}

}  // namespace
}  // namespace dobra::offset::verifier
