// Volumes between horizons that faults part, against closed forms by hand: plane horizons of vertical distance `apart`,
// moved by `throw_` across the plane x = strike(y) - per_depth z.
#include <gtest/gtest.h>

#include "shared/surf/loft/measures.h"
#include "tests/shared/surf/loft/placed.h"

namespace dobra::test {
namespace {

using loft::LineKind;

struct Faulted {
  double slope = 0.0;      // of the horizons, along x
  double per_depth = 0.5;  // of the fault: how far east a metre deeper
  double throw_ = 100.0;   // down in the east; less than 0: up
  double turned = 0.0;     // of the fault's strike: how far east a metre farther north
  double apart = 200.0;
  [[nodiscard]] double fault_x(double y, double z) const { return 900.0 + turned * y - per_depth * z; }
  /// Where z = slope x - down meets the fault.
  [[nodiscard]] double cutoff(double y, double down) const {
    return (fault_x(y, 0.0) + per_depth * down) / (1.0 + per_depth * slope);
  }
};
constexpr double length = 2000.0;

geom::Polyline straight(double x0, double x1, double slope, double down) {
  return {{{x0, slope * x0 - down}, {x1, slope * x1 - down}}, false};
}

std::vector<loft::Section> faulted(const Faulted& f, bool west = true, bool east = true) {
  std::vector<loft::Section> sections;
  for (const double y : {0.0, 300.0, 800.0}) {
    sections.push_back(section("S" + std::to_string(static_cast<int>(y)), {{0.0, y}, {length, y}}));
    auto& s = sections.back();
    add(s, "F", {{{f.fault_x(y, 900.0), 900.0}, {f.fault_x(y, -900.0), -900.0}}, false}, LineKind::Fault);
    for (const auto& [name, down] : {std::pair("upper", 0.0), {"lower", f.apart}}) {
      if (west) add(s, name, straight(0.0, f.cutoff(y, down), f.slope, down));
      if (east) add(s, name, straight(f.cutoff(y, down + f.throw_), length, f.slope, down + f.throw_));
    }
  }
  return sections;
}

const loft::NamedSurface& called(const loft::Surfaces& made, const std::string& name) {
  return *std::find_if(made.surfaces.begin(), made.surfaces.end(), [&](const auto& s) { return s.name == name; });
}

loft::Volume between(const loft::Surfaces& made) {
  return loft::volume_between(called(made, "upper"), called(made, "lower"), made.surfaces).value();
}

/// West of the fault the bed ends half-way between its cutoffs in the mean, and so it begins in the east.
double of_bed(const Faulted& f, bool west = true, bool east = true) {
  const double y = 400.0;  // the middle: all is linear in y
  const double to = 0.5 * (f.cutoff(y, 0.0) + f.cutoff(y, f.apart));
  const double from = 0.5 * (f.cutoff(y, f.throw_) + f.cutoff(y, f.throw_ + f.apart));
  return 800.0 * f.apart * ((west ? to : 0.0) + (east ? length - from : 0.0));
}

void expect_volume(const Faulted& f, bool west = true, bool east = true) {
  const auto made = through(faulted(f, west, east));
  ASSERT_EQ(made.surfaces.size(), 3U);
  const loft::Volume volume = between(made);
  EXPECT_NEAR(volume.value / of_bed(f, west, east), 1.0, 1e-9)
      << "slope " << f.slope << ", fault " << f.per_depth << ", throw " << f.throw_ << ", turned " << f.turned;
  EXPECT_EQ(volume.unsure, 0.0);
  EXPECT_TRUE(volume.findings.empty());
}

TEST(FaultVolume, NormalFaultsKeepTheWedgeBetweenTheCutoffs) {
  for (const double throw_ : {5.0, 100.0, 190.0, 300.0}) {
    expect_volume({0.0, 0.5, throw_, 0.0});
    expect_volume({0.1, 0.5, throw_, 0.3});
    expect_volume({-0.2, -0.8, -throw_, 0.1});  // it dips to the west
  }
}

TEST(FaultVolume, ThrustsCountEachBlockOnce) {
  for (const double throw_ : {-5.0, -100.0, -300.0}) {
    expect_volume({0.0, 1.5, throw_, 0.0});
    expect_volume({0.1, 1.5, throw_, 0.3});
    expect_volume({-0.2, -1.5, -throw_, 0.1});
  }
}

TEST(FaultVolume, TheMapAreaCountsAPlaceOnce) {
  const Faulted thrust{0.0, 1.5, -300.0, 0.0};
  EXPECT_NEAR(between(through(faulted(thrust))).plan, 800.0 * length, 1e-3);
}

TEST(FaultVolume, ABlockOnOneSideAloneEndsAtTheFault) {
  for (const double throw_ : {100.0, -300.0}) {
    expect_volume({0.1, 0.5, throw_, 0.3}, true, false);
    expect_volume({0.1, 0.5, throw_, 0.3}, false, true);
  }
}

TEST(FaultVolume, AFaultThatEndsBetweenTheHorizonsLeavesTheRockBelowIt) {
  // The lower horizon lies below the fault's tip and is whole: the east is thinner by the throw.
  const Faulted f{0.0, 0.5, 100.0, 0.0, 200.0};
  auto sections = faulted(f);
  for (auto& s : sections) {
    std::erase_if(s.lines, [](const loft::SectionLine& l) { return l.name == "lower"; });
    s.lines[0].line.points.back() = {f.fault_x(0.0, -150.0), -150.0};
    add(s, "lower", straight(0.0, length, 0.0, f.apart));
  }
  const auto made = through(std::move(sections));
  // West to the fault at z = 0, then down along it to z = -100: 200 high, 150 high over 50 m, 100 high.
  EXPECT_NEAR(between(made).value / (800.0 * (900.0 * 200.0 + 50.0 * 150.0 + 1050.0 * 100.0)), 1.0, 1e-9);
}

TEST(FaultVolume, AHorizonThatEndsAtAFaultWhereTheOtherGoesOnIsToldWithABound) {
  const Faulted f{0.0, 0.5, 100.0, 0.0, 200.0};
  auto sections = faulted(f);
  for (auto& s : sections)  // the upper horizon is eroded in the west
    std::erase_if(s.lines,
                  [](const loft::SectionLine& l) { return l.name == "upper" && l.line.points.front().x == 0.0; });
  const auto made = through(std::move(sections));
  const loft::Volume volume = between(made);
  const auto* told = finding(volume.findings, "volume_at_fault");
  ASSERT_NE(told, nullptr);
  EXPECT_NEAR(*told->place.x, f.fault_x(0.0, -100.0), 1.0);
  // Of the eastern block alone.
  const double block = of_bed(f, false, true);
  EXPECT_GT(volume.unsure, 0.0);
  EXPECT_LT(std::abs(volume.value - block), volume.unsure);
}

TEST(FaultVolume, AHorizonThatEndsAtAFaultAboveTheOtherIsToldWithABound) {
  // The upper horizon is in the east alone; the fault's tip is above the lower one, which is whole.
  for (const double tip : {-190.0, -120.0}) {
    const Faulted f{0.0, 0.5, 100.0, 0.0, 200.0};
    auto sections = faulted(f, false, true);
    for (auto& s : sections) {
      std::erase_if(s.lines, [](const loft::SectionLine& l) { return l.name == "lower"; });
      s.lines[0].line.points.back() = {f.fault_x(0.0, tip), tip};
      add(s, "lower", straight(0.0, length, 0.0, f.apart));
    }
    const auto made = through(std::move(sections));
    const loft::Volume volume = between(made);
    // East of the fault, gone on to the lower horizon: from x = 950 at z = -100 to x = 1000 at z = -200.
    const double block = 800.0 * 100.0 * (length - 975.0);
    EXPECT_NEAR(volume.value, 800.0 * 100.0 * (length - 950.0), 1e-3);
    EXPECT_LE(std::abs(volume.value - block), volume.unsure);
    EXPECT_LE(volume.unsure, 4.0 * std::abs(volume.value - block));
    const auto* told = finding(volume.findings, "volume_at_fault");
    ASSERT_NE(told, nullptr);
    EXPECT_NEAR(*told->place.x, 950.0, 1e-6);
    EXPECT_NEAR(*told->place.z, -100.0, 1e-6);
  }
}

TEST(FaultVolume, AnUprightFaultThatEndsAboveTheOtherHorizonLeavesNothingUnsure) {
  const Faulted f{0.0, 0.0, 100.0, 0.0, 200.0};
  auto sections = faulted(f, false, true);
  for (auto& s : sections) {
    std::erase_if(s.lines, [](const loft::SectionLine& l) { return l.name == "lower"; });
    s.lines[0].line.points.back() = {900.0, -150.0};
    add(s, "lower", straight(0.0, length, 0.0, f.apart));
  }
  const loft::Volume volume = between(through(std::move(sections)));
  EXPECT_NEAR(volume.value / (800.0 * 100.0 * (length - 900.0)), 1.0, 1e-9);
  EXPECT_EQ(volume.unsure, 0.0);
}

TEST(FaultVolume, AFaultThatIsShallowerOnOneSectionLeavesABoundForWhatIsNotJoined) {
  // On the last section the fault ends above the lower horizon, which is whole there: its pieces go no farther than
  // the section before. The rock between, for any throw of the lower horizon from 0 to 100 m, is within the bound.
  const Faulted f{0.0, 0.5, 100.0, 0.0, 200.0};
  auto sections = faulted(f);
  auto& last = sections.back();
  std::erase_if(last.lines, [](const loft::SectionLine& l) { return l.name == "lower"; });
  last.lines[0].line.points.back() = {f.fault_x(0.0, -150.0), -150.0};
  add(last, "lower", straight(0.0, length, 0.0, f.apart));
  const auto made = through(std::move(sections));
  const loft::Volume volume = between(made);
  const double of_bed_to_300 = of_bed(f) * 300.0 / 800.0;
  // Between y = 300 and 800 by hand: the west is 200 thick up to the upper cutoff at 900; from there to 950, down the
  // fault, 150 in the mean; east of it 100 and, moved by its throw, up to 200.
  const double least = 500.0 * (900.0 * 200.0 + 50.0 * 150.0 + 1050.0 * 100.0);
  const double most = 500.0 * 200.0 * length;
  EXPECT_GE(of_bed_to_300 + least, volume.value - volume.unsure);
  EXPECT_LE(of_bed_to_300 + most, volume.value + volume.unsure);
  EXPECT_LE(volume.unsure, 3.0 * most);
  const auto* told = finding(volume.findings, "volume_at_fault");
  ASSERT_NE(told, nullptr);
  EXPECT_GE(*told->place.y, 300.0);
  EXPECT_LE(*told->place.y, 800.0);
}

TEST(FaultVolume, WhatBothHorizonsLeaveOutAtOnePlaceIsToldAsANumberOnce) {
  // On the last section the fault ends above both horizons, which are whole there.
  const Faulted f{0.0, 0.5, 100.0, 0.0, 200.0};
  auto sections = faulted(f);
  auto& last = sections.back();
  std::erase_if(last.lines, [](const loft::SectionLine& l) { return l.kind == LineKind::Horizon; });
  last.lines[0].line.points.back() = {f.fault_x(0.0, 200.0), 200.0};
  add(last, "upper", straight(0.0, length, 0.0, 0.0));
  add(last, "lower", straight(0.0, length, 0.0, f.apart));
  const auto made = through(std::move(sections));
  const loft::Volume volume = between(made);
  std::size_t told = 0, numbers = 0;
  for (const loft::Finding& one : volume.findings) {
    if (one.message.find("in other pieces") == std::string::npos) continue;
    ++told;
    EXPECT_EQ(one.message.find("less than 0 m3"), std::string::npos) << one.message;
    if (one.message.find("less than") != std::string::npos) ++numbers;
  }
  EXPECT_EQ(told, 2u);
  EXPECT_EQ(numbers, 1u);
  EXPECT_GT(volume.unsure, 0.0);
}

TEST(FaultVolume, CurvedFaultsAreFollowedBetweenTheCutoffs) {
  // x = 600 + (z + 700)^2 / 1000: flat-lying below. The bed west of it ends there; that in the east begins there.
  const auto fault_x = [](double z) { return 600.0 + 1e-3 * (z + 700.0) * (z + 700.0); };
  const auto integral = [](double low, double high) {  // of fault_x over z
    const auto at = [](double z) { return 600.0 * z + 1e-3 / 3.0 * std::pow(z + 700.0, 3.0); };
    return at(high) - at(low);
  };
  std::vector<loft::Section> sections;
  for (const double y : {0.0, 300.0, 800.0}) {
    sections.push_back(section("S" + std::to_string(static_cast<int>(y)), {{0.0, y}, {length, y}}));
    auto& s = sections.back();
    geom::Polyline fault;
    for (int i = 0; i <= 200; ++i) fault.points.push_back({fault_x(300.0 - 5.0 * i), 300.0 - 5.0 * i});
    add(s, "F", fault, LineKind::Fault);
    for (const auto& [name, z] : {std::pair("upper", 0.0), {"lower", -200.0}}) {
      add(s, name, straight(0.0, fault_x(z), 0.0, -z));
      add(s, name, straight(fault_x(z + 150.0), length, 0.0, -z - 150.0));
    }
  }
  const auto made = through(std::move(sections));
  const double exact = 800.0 * (integral(-200.0, 0.0) + 200.0 * length - integral(-50.0, 150.0));
  // The chords of 5 m of the fault miss it by 0.5e-3 (2.5 m)^2; 8 chords between cutoffs 150 m apart by more.
  EXPECT_NEAR(between(made).value / exact, 1.0, 2e-5);
}

}  // namespace
}  // namespace dobra::test
