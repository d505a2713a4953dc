// Sections that are not parallel and reach unequally far: no surface turns back on the map, planes stay planes, and the
// map of a surface is the polygon through the ends of its lines.

#include <gtest/gtest.h>

#include <random>

#include "shared/surf/loft/measures.h"
#include "tests/shared/surf/loft/placed.h"

namespace dobra::test {
namespace {

/// By the shoelace formula.
double area_of(const std::vector<Point>& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return 0.5 * twice;
}

struct Trace {
  Point from, to;
};

loft::Surfaces through_all(const std::vector<Trace>& traces, const Height& height, int n = 12) {
  std::vector<loft::Section> sections;
  for (const Trace& t : traces) {
    sections.push_back(section("S" + std::to_string(sections.size()), {t.from, t.to}));
    add(sections.back(), "top", sampled(sections.back(), height, n));
  }
  return through(std::move(sections));
}

/// The ring through the ends of traces that lie behind each other.
std::vector<Point> ring_of(const std::vector<Trace>& traces) {
  std::vector<Point> ring;
  for (const Trace& t : traces) ring.push_back(t.to);
  for (auto t = traces.rbegin(); t != traces.rend(); ++t) ring.push_back(t->from);
  return ring;
}

/// The area on the map of what looks down, m2, if the most of it looks up, and the other way.
double turned(const loft::NamedSurface& surface) {
  double up = 0.0, down = 0.0;
  for (const loft::Patch& patch : surface.patches) {
    for (const auto& t : patch.triangles) {
      const auto at = [&](std::size_t i) { return Point{patch.points[t[i]].x, patch.points[t[i]].y}; };
      const double area = area_of({at(0), at(1), at(2)});
      (area > 0.0 ? up : down) += std::abs(area);
    }
  }
  return std::min(up, down);
}

void expect_sound(const std::vector<Trace>& traces, const std::string& what) {
  SCOPED_TRACE(what);
  const auto plane = [](double x, double y) { return -500.0 + 0.2 * x - 0.1 * y; };
  const auto made = through_all(traces, plane);
  ASSERT_EQ(made.surfaces.size(), 1U);
  const double map = std::abs(area_of(ring_of(traces)));
  const loft::Measures measures = loft::measures(made.surfaces[0]);
  EXPECT_NEAR(measures.plan, map, 1e-9 * map);
  EXPECT_NEAR(measures.area, map * std::sqrt(1.0 + 0.2 * 0.2 + 0.1 * 0.1), 1e-9 * map);
  EXPECT_LT(turned(made.surfaces[0]), 1e-9 * map);
  EXPECT_EQ(finding(made.findings, "turns_back"), nullptr);
  for (const loft::Patch& patch : made.surfaces[0].patches) {
    for (const geom::Point3 p : patch.points) ASSERT_NEAR(p.z, plane(p.x, p.y), 1e-8);
  }
}

TEST(UnlikeTraces, APlaneStaysOneAndItsMapIsThePolygonOfTheEnds) {
  expect_sound({{{0, 0}, {1000, 0}}, {{0, 500}, {1000, 500}}, {{0, 900}, {1000, 1000}}}, "the last one turned");
  expect_sound({{{0, 0}, {1000, 200}}, {{100, 400}, {1100, 300}}, {{0, 900}, {900, 1200}}}, "all turned");
  expect_sound({{{0, 0}, {1000, 0}}, {{200, 500}, {600, 500}}, {{0, 1000}, {1000, 1000}}}, "a short one between");
  expect_sound({{{300, 0}, {700, 0}}, {{0, 500}, {1000, 500}}, {{300, 1000}, {700, 1000}}}, "a long one between");
  expect_sound({{{0, 0}, {400, 0}}, {{500, 500}, {1000, 500}}, {{0, 1000}, {400, 1000}}},
               "one beside none of the others");
  expect_sound({{{0, 0}, {1000, 0}}, {{0, 10}, {1000, 300}}, {{0, 1000}, {1000, 1000}}}, "two that come near");
  expect_sound({{{0, 0}, {1000, 0}}, {{400, 60}, {700, 90}}, {{0, 300}, {1000, 100}}, {{0, 900}, {1000, 900}}},
               "one that would run into the next, gone on");
}

TEST(UnlikeTraces, RandomFansTurnBackNowhere) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int k = 0; k < 200; ++k) {
    std::vector<Trace> traces;
    double left = 0.0, right = 0.0;
    for (int i = 0; i < 3 + k % 4; ++i) {
      const double low = 400.0 * any(random), high = 1000.0 - 400.0 * any(random);
      const auto at = [&](double x) { return Point{x, std::lerp(left, right, x / 1000.0)}; };
      traces.push_back({at(low), at(high)});
      left += 20.0 + 500.0 * any(random), right += 20.0 + 500.0 * any(random);
    }
    expect_sound(traces, "fan " + std::to_string(k));
    if (HasFailure()) return;
  }
}

/// What is alike along strike is right wherever one section reaches.
TEST(UnlikeTraces, AShortSectionBendsNothingBesideIt) {
  const auto fold = [](double x, double) { return -300.0 + 80.0 * std::sin(x / 120.0); };
  std::vector<loft::Section> sections;
  const std::vector<std::array<double, 2>> reach{{0, 1200}, {0, 1200}, {240, 960}, {0, 1200}};
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const double y = 400.0 * static_cast<double>(i);
    sections.push_back(section("S" + std::to_string(i), {{reach[i][0], y}, {reach[i][1], y}}));
    add(sections.back(), "top", sampled(sections.back(), fold, static_cast<int>((reach[i][1] - reach[i][0]) / 10.0)));
  }
  const auto made = through(std::move(sections));
  ASSERT_EQ(made.surfaces.size(), 1U);
  for (const loft::Patch& patch : made.surfaces[0].patches) {
    for (const geom::Point3 p : patch.points) {
      if (p.y <= 400.0) {
        ASSERT_NEAR(p.z, fold(p.x, 0.0), 1e-9) << p.x << "," << p.y;
      }
    }
  }
}

/// Of which one lies beside all others, and one between them.
TEST(UnlikeTraces, ALineThatIsMissingIsToldAsBetweenOrBeside) {
  std::vector<loft::Section> sections;
  for (int i = 0; i < 5; ++i) {
    sections.push_back(section("S" + std::to_string(i), {{0, 100.0 * i}, {1000, 100.0 * i}}));
    add(sections.back(), "all", {{{0, 0}, {1000, 0}}});
    if (i == 1 || i == 3) add(sections.back(), "some", {{{0, -50}, {1000, -50}}});
  }
  const auto made = through(std::move(sections));
  std::vector<std::pair<std::string, double>> told;
  for (const loft::Finding& f : made.findings) {
    if (f.code == "missing") told.emplace_back(f.message, *f.place.y);
  }
  ASSERT_EQ(told.size(), 2U);
  EXPECT_NE(told[0].first.find("'some' is not in 'S2'; its surface passes without"), std::string::npos);
  EXPECT_EQ(told[0].second, 200.0);
  EXPECT_NE(told[1].first.find("'some' is not in 'S0', 'S4'; its surface ends before"), std::string::npos);
}

/// Two planes that cross along x = 300: wedges of 100 m by the dips of 0.2 and 0.1.
TEST(UnlikeTraces, HorizonsThatCrossHaveBothPartsOfTheirVolumeTold) {
  for (const bool shorter : {false, true}) {
    std::vector<loft::Section> sections;
    for (int i = 0; i < 2; ++i) {
      sections.push_back(section("S" + std::to_string(i), {{0, 100.0 * i}, {1000, 100.0 * i}}));
      add(sections.back(), "a", {{{0, 60}, {shorter ? 900.0 : 1000.0, shorter ? -120.0 : -140.0}}});
      add(sections.back(), "b", {{{0, -30}, {1000, 70}}});
    }
    const auto made = through(std::move(sections));
    ASSERT_EQ(made.surfaces.size(), 2U);
    const bool first = loft::measures(made.surfaces[0]).mean_z > loft::measures(made.surfaces[1]).mean_z;
    const auto volume = loft::volume_between(made.surfaces[first ? 0 : 1], made.surfaces[first ? 1 : 0]).value();
    const double low = 0.5 * 300.0 * 90.0 * 100.0, width = shorter ? 600.0 : 700.0;
    const double high = 0.5 * width * 0.3 * width * 100.0;
    EXPECT_NEAR(volume.below, low, 1e-6);
    EXPECT_NEAR(volume.value, high - low, 1e-4);
    EXPECT_EQ(volume.exact, !shorter);
    ASSERT_EQ(volume.findings.size(), 1U);
    EXPECT_EQ(volume.findings[0].code, "cross");
    EXPECT_NEAR(*volume.findings[0].place.x, 0.0, 1e-9);
  }
  // Beds that touch do not cross.
  std::vector<loft::Section> sections;
  for (int i = 0; i < 2; ++i) {
    sections.push_back(section("S" + std::to_string(i), {{0, 100.0 * i}, {1000, 100.0 * i}}));
    add(sections.back(), "a", {{{0, 0}, {400, 0}, {1000, 60}}});
    add(sections.back(), "b", {{{0, 0}, {400, 0}, {1000, -60}}});
  }
  const auto made = through(std::move(sections));
  const auto volume = loft::volume_between(made.surfaces[0], made.surfaces[1]).value();
  EXPECT_EQ(volume.below, 0.0);
  EXPECT_TRUE(volume.findings.empty());
}

/// Ribs that turn back are no horizon by place: there the surface may look down, and nothing is said of it.
TEST(UnlikeTraces, AnOverturnedHorizonIsNotSaidToTurnBack) {
  std::vector<loft::Section> sections;
  for (int i = 0; i < 3; ++i) {
    sections.push_back(section("S" + std::to_string(i), {{0, 300.0 * i}, {1000, 300.0 * i}}));
    add(sections.back(), "top", {{{0, 0}, {600, 0}, {400, -100}, {1000, -100}}});
  }
  const auto made = through(std::move(sections));
  ASSERT_EQ(made.surfaces.size(), 1U);
  EXPECT_GT(turned(made.surfaces[0]), 1.0);
  EXPECT_EQ(finding(made.findings, "turns_back"), nullptr);
}

}  // namespace
}  // namespace dobra::test
