#include "shared/gui/view/history.h"

#include <gtest/gtest.h>

namespace dobra::gui::view {
namespace {

Looks at(double x) { return {{"section", {{x, 0.0}, 1.0}}}; }

TEST(ViewHistory, BackWhereNothingWasIsNothing) {
  History history;
  EXPECT_FALSE(history.back(at(0)));
  EXPECT_FALSE(history.forward(at(0)));
}

TEST(ViewHistory, MovesThatFollowEachOtherAreOneWay) {
  History history;
  for (int i = 0; i < 50; ++i) history.before(at(i), Move::Glide, 100 * i);
  EXPECT_EQ(history.back(at(50)), at(0));
  EXPECT_FALSE(history.can_go_back());
  EXPECT_EQ(history.forward(at(0)), at(50));
}

TEST(ViewHistory, APauseOrAJumpBeginsAnother) {
  History history;
  history.before(at(0), Move::Glide, 0);
  history.before(at(1), Move::Glide, 2000);
  history.before(at(2), Move::Jump, 2010);
  history.before(at(3), Move::Glide, 2020);
  for (const double x : {3.0, 2.0, 1.0, 0.0}) EXPECT_EQ(history.back(at(x + 1)), at(x));
  EXPECT_FALSE(history.back(at(0)));
  for (const double x : {1.0, 2.0, 3.0, 4.0}) EXPECT_EQ(history.forward(at(x - 1)), at(x));
}

TEST(ViewHistory, AnotherWayFromThePastForgetsTheFuture) {
  History history;
  history.before(at(0), Move::Jump, 0);
  history.before(at(1), Move::Jump, 1);
  EXPECT_EQ(history.back(at(2)), at(1));
  history.before(at(1), Move::Jump, 2);
  EXPECT_FALSE(history.can_go_forward());
  EXPECT_EQ(history.back(at(7)), at(1));
  EXPECT_EQ(history.back(at(1)), at(0));
}

TEST(ViewHistory, WhatIsSeenAlreadyIsPassedOver) {
  History history;
  history.before(at(0), Move::Jump, 0);
  history.before(at(5), Move::Jump, 1);
  EXPECT_EQ(history.back(at(5)), at(0));
}

}  // namespace
}  // namespace dobra::gui::view
