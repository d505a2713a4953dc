#include "shared/offset/general/contact.h"

#include <gtest/gtest.h>

#include <random>

namespace dobra::offset::general {
namespace {

template <class T>
Shape<T> line(VecOf<T> a, VecOf<T> b) {
  Shape<T> made;
  made.a = a;
  made.b = b;
  made.pole = unit(b - a);
  made.size = length(b - a);
  made.error = made.slide = resolution<T> * 10;
  return made;
}

template <class T>
Shape<T> arc(VecOf<T> centre, VecOf<T> from, VecOf<T> to) {
  Shape<T> made;
  made.line = false;
  made.pole = centre;
  made.a = centre + from;
  made.b = centre + to;
  made.size = length(made.b - made.a);
  made.error = made.slide = resolution<T> * 10;
  return made;
}

template <class T>
std::size_t count(const Contacts<T>& contacts) {
  return static_cast<std::size_t>(contacts.end() - contacts.begin());
}

TEST(High, RootIsRightToTheLastBits) {
  std::mt19937_64 random(1);
  for (int exponent = -1000; exponent < 1000; exponent += 7) {
    const High x = ldexp(High(random()) + ldexp(High(random()), -64) + ldexp(High(random()), -128), exponent);
    EXPECT_LE(abs(High(root(x) * root(x) - x)), ldexp(x, -252)) << exponent;
  }
  EXPECT_EQ(root(High(0)), 0);
  EXPECT_EQ(root(High(9)), 3);
}

TEST(High, DistanceIsGreaterByFarLessThanADoubleCanSay) {
  EXPECT_EQ(distance_as<Real>(0.3), Real(0.3));
  EXPECT_GT(distance_as<High>(0.3), High(0.3));
  EXPECT_EQ(static_cast<double>(distance_as<High>(0.3)), 0.3);
}

TEST(Contacts, LinesCrossWhereTheirInteriorsDo) {
  const Contacts<Real> cross(line<Real>({0, 0}, {4, 0}), line<Real>({1, -1}, {1, 3}), 1);
  ASSERT_FALSE(cross.doubtful());
  ASSERT_EQ(count(cross), 1U);
  EXPECT_EQ(cross.begin()->kind, Contact<Real>::Kind::Crossing);
  EXPECT_EQ(cross.begin()->at.x, 1);
  EXPECT_EQ(cross.begin()->at.y, 0);
  EXPECT_EQ(count(Contacts<Real>(line<Real>({0, 0}, {4, 0}), line<Real>({1, 1}, {1, 3}), 1)), 0U);
}

TEST(Contacts, LineCrossesAnArcTwice) {
  const Real half = root(Real(0.5));
  const Contacts<Real> found(line<Real>({-1, Real(4) / Real(5)}, {1, Real(4) / Real(5)}),
                             arc<Real>({0, 0}, {half, half}, {-half, half}), 1);
  ASSERT_FALSE(found.doubtful());
  ASSERT_EQ(count(found), 2U);
  EXPECT_NEAR(static_cast<double>(found.begin()->at.x), -0.6, 1e-17);
}

TEST(Contacts, EndOnALineIsDoubtfulInRealAndKnownInHigh) {
  EXPECT_TRUE(Contacts<Real>(line<Real>({0, 0}, {4, 0}), line<Real>({1, 0}, {1, 3}), 1).doubtful());
  const Contacts<High> known(line<High>({0, 0}, {4, 0}), line<High>({1, 0}, {1, 3}), 1);
  ASSERT_EQ(count(known), 1U);
  EXPECT_EQ(known.begin()->kind, Contact<High>::Kind::StartOfSecond);
  EXPECT_FALSE(known.twins());
  // By 2^-90 it is beside: no contact.
  const High beside = ldexp(High(1), -90);
  EXPECT_EQ(count(Contacts<High>(line<High>({0, 0}, {4, 0}), line<High>({1, beside}, {1, 3}), 1)), 0U);
}

TEST(Contacts, CoincidentLinesAndArcsAreTwins) {
  const Contacts<High> lines(line<High>({0, 0}, {4, 0}), line<High>({1, 0}, {6, 0}), 1);
  EXPECT_TRUE(lines.twins());
  EXPECT_EQ(count(lines), 2U);  // the start of the second, the end of the first
  const Contacts<High> arcs(arc<High>({0, 0}, {1, 0}, {0, 1}), arc<High>({0, 0}, {0.6, 0.8}, {0, 1}), 1);
  EXPECT_TRUE(arcs.twins());
  EXPECT_FALSE(Contacts<High>(line<High>({0, 0}, {4, 0}), line<High>({5, 0}, {6, 0}), 1).twins());
}

TEST(Contacts, EntryIsWhereTheTailGoesIn) {
  const Contact<Real> at =
      entry(line<Real>({-5, Real(3) / Real(5)}, {5, Real(3) / Real(5)}), arc<Real>({0, 0}, {-1, 0}, {0, 1}), Real(1));
  EXPECT_NEAR(static_cast<double>(at.at.x), -0.8, 1e-17);
  const Contact<Real> lines = entry(line<Real>({0, 0}, {1, 0}), line<Real>({3, -1}, {3, 1}), Real(1));
  EXPECT_EQ(lines.at.x, 3);
}

}  // namespace
}  // namespace dobra::offset::general
