#include "recon/model/findings.h"

#include <gtest/gtest.h>

namespace recon::model {
namespace {

struct Width {
  int value = 0;
};
struct Height {
  int value = 0;
};

TEST(Findings, AreFoundByTheirTypeInTheOrderInWhichTheyWereMade) {
  Findings findings;
  EXPECT_EQ(findings.get<Width>(), nullptr);
  findings.add(Width{1}, {});
  findings.add(Height{7}, {});
  findings.add(Width{2}, {});
  ASSERT_EQ(findings.all<Width>().size(), 2U);
  EXPECT_EQ(findings.all<Width>()[0]->value, 1);
  EXPECT_EQ(findings.get<Width>()->value, 2);
  EXPECT_EQ(findings.get<Height>()->value, 7);
}

TEST(Findings, SettingOneReplacesThoseOfItsTypeOnly) {
  Findings findings;
  findings.add(Width{1}, {});
  findings.add(Width{2}, {});
  findings.add(Height{7}, {});
  findings.set(Width{3}, {});
  ASSERT_EQ(findings.all<Width>().size(), 1U);
  EXPECT_EQ(findings.get<Width>()->value, 3);
  EXPECT_EQ(findings.all<Height>().size(), 1U);
}

TEST(Findings, WhatRestsOnALaterStateIsForgottenWhenThatIsMadeAnew) {
  Findings findings;
  findings.add(Width{0}, {});
  findings.add(Width{1}, {.state = 1});
  findings.add(Width{2}, {.state = 2});
  findings.forget_after(1);
  ASSERT_EQ(findings.all<Width>().size(), 2U);
  EXPECT_EQ(findings.get<Width>()->value, 1);
  findings.forget_after(0);
  ASSERT_EQ(findings.all<Width>().size(), 1U);
  EXPECT_EQ(findings.get<Width>()->value, 0);
}

TEST(Findings, OneOfTheStageInHandEndsWithItAndACopyKeepsIt) {
  Findings findings;
  findings.add(Width{1}, {.state = 1});
  findings.add(Height{1}, {.state = 1, .outlives = Outlives::Nothing});
  const Findings before = findings;
  findings.begin_stage();
  EXPECT_NE(findings.get<Width>(), nullptr);
  EXPECT_EQ(findings.get<Height>(), nullptr);
  EXPECT_NE(before.get<Height>(), nullptr);
}

}  // namespace
}  // namespace recon::model
