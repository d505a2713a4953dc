#include "recon/kinematics/fault_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using recon::kinematics::FaultPath;
using recon::kinematics::nearest;
using recon::kinematics::Side;
using recon::kinematics::Wall;
using recon::kinematics::wall_of;
namespace geom = dobra::geom;

FaultPath path_of(std::vector<geom::Point> points, Side hanging) { return {{std::move(points), false}, hanging}; }

TEST(FaultPath, WallsOfAFlatAndARampAreBySideOfTravel) {
  const FaultPath fault = path_of({{0, 0}, {10, 0}, {20, 10}}, Side::Left);
  EXPECT_EQ(wall_of(fault, {5, 1}), Wall::Hanging);
  EXPECT_EQ(wall_of(fault, {5, -1}), Wall::Foot);
  EXPECT_EQ(wall_of(fault, {15, 6}), Wall::Hanging);
  EXPECT_EQ(wall_of(fault, {15, 4}), Wall::Foot);
  FaultPath mirrored = fault;
  mirrored.hanging = Side::Right;
  EXPECT_EQ(wall_of(mirrored, {5, 1}), Wall::Foot);
}

TEST(FaultPath, WallsGoOnBeyondBothEnds) {
  const FaultPath fault = path_of({{0, 0}, {10, 0}, {20, 10}}, Side::Left);
  EXPECT_EQ(wall_of(fault, {-100, 1e-9}), Wall::Hanging);
  EXPECT_EQ(wall_of(fault, {-100, -1e-9}), Wall::Foot);
  EXPECT_EQ(wall_of(fault, {100, 90.5}), Wall::Hanging);
  EXPECT_EQ(wall_of(fault, {100, 89.5}), Wall::Foot);
}

TEST(FaultPath, APointOnItOrOnWhatItGoesOnWithHasNoWall) {
  const FaultPath fault = path_of({{0, 0}, {10, 0}, {20, 10}}, Side::Left);
  EXPECT_EQ(wall_of(fault, {-7, 0}), std::nullopt);
  EXPECT_EQ(wall_of(fault, {10, 0}), std::nullopt);
  EXPECT_EQ(wall_of(fault, {13, 3}), std::nullopt);
  EXPECT_EQ(wall_of(fault, {40, 30}), std::nullopt);
}

TEST(FaultPath, OneUlpBesideALineIsInAWall) {
  const FaultPath fault = path_of({{0, 0}, {3, 1}, {9, 3}}, Side::Left);
  const double above = std::nextafter(2.0, 3.0);
  EXPECT_EQ(wall_of(fault, {6, 2}), std::nullopt);
  EXPECT_EQ(wall_of(fault, {6, above}), Wall::Hanging);
}

TEST(FaultPath, CornersAreRoundedOnTheirOuterSide) {
  // A ramp down to a flat: above the corner its inner side, below it the outer one.
  const FaultPath fault = path_of({{0, 0}, {10, 0}, {10.5, 20}}, Side::Left);
  EXPECT_EQ(wall_of(fault, {10.4, -3}), Wall::Foot);
  EXPECT_EQ(wall_of(fault, {12, -0.1}), Wall::Foot);
  EXPECT_EQ(wall_of(fault, {9.9, 0.1}), Wall::Hanging);
  const auto below = nearest(fault, {13, -4});
  EXPECT_DOUBLE_EQ(below.arc, 10.0);
  EXPECT_DOUBLE_EQ(below.distance, -5.0);
}

TEST(FaultPath, ArcAndDistanceTellThePointAgain) {
  const FaultPath fault = path_of({{0, 0}, {10, 0}, {20, 10}}, Side::Right);
  const auto beyond = nearest(fault, {-3, 4});
  EXPECT_DOUBLE_EQ(beyond.arc, -3.0);
  EXPECT_DOUBLE_EQ(beyond.distance, -4.0);
  const double root = std::sqrt(2.0);
  const auto ramp = nearest(fault, {16, 4});
  EXPECT_NEAR(ramp.arc, 10.0 + 5.0 * root, 1e-12);
  EXPECT_NEAR(ramp.distance, root, 1e-12);
  const geom::Point p = recon::kinematics::point_at(fault, 10.0 + 5.0 * root);
  EXPECT_NEAR(p.x, 15.0, 1e-12);
  EXPECT_NEAR(p.y, 5.0, 1e-12);
}

}  // namespace
