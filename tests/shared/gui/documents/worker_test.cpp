#include "shared/gui/documents/worker.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "tests/shared/gui/fake_program.h"

namespace dobra::gui::documents {
namespace {

class WorkerTest : public testing::Test {
 protected:
  WorkerTest() {
    QObject::connect(&worker, &Worker::finished, [this](const OutcomePtr& outcome) { outcomes.push_back(outcome); });
  }
  static DocumentPtr sleeping(double seconds, double amplitude) {
    scenario::Document document;
    document.program = "waves";
    document.input.set("amplitude", amplitude);
    document.steps.resize(1);
    document.steps[0].operation = "sleep";
    document.steps[0].params.set("seconds", seconds);
    return std::make_shared<const scenario::Document>(std::move(document));
  }
  bool wait(int milliseconds = 20000) {
    return QTest::qWaitFor([this] { return !worker.busy(); }, milliseconds);
  }

  const scenario::Program program = test::fake_program();
  Worker worker{program};
  std::vector<OutcomePtr> outcomes;
};

TEST_F(WorkerTest, RunGivesStatesPictureAndQuantities) {
  worker.request(sleeping(0.0, 70.0));
  ASSERT_TRUE(wait());
  ASSERT_EQ(outcomes.size(), 1u);
  EXPECT_TRUE(outcomes[0]->run.complete());
  EXPECT_EQ(outcomes[0]->run.states.size(), 2u);
  EXPECT_EQ(outcomes[0]->picture->panels.size(), 2u);
  EXPECT_DOUBLE_EQ(outcomes[0]->quantities.at(0).value, 70.0);
}

TEST_F(WorkerTest, RequestReturnsAtOnceAndReportsProgress) {
  QSignalSpy progress(&worker, &Worker::progress);
  worker.request(sleeping(0.3, 1.0));
  EXPECT_TRUE(outcomes.empty());
  EXPECT_TRUE(worker.busy());
  ASSERT_TRUE(wait());
  EXPECT_GE(progress.count(), 2);
  // The runner's own reports, before and after the step, say nothing; which of all are heard depends on the clock.
  EXPECT_TRUE(
      std::any_of(progress.begin(), progress.end(), [](const auto& report) { return report.at(1) == "sleeping"; }));
}

TEST_F(WorkerTest, LatestRequestWinsAndOnlyItIsHeardOf) {
  worker.request(sleeping(30.0, 1.0));
  worker.request(sleeping(30.0, 2.0));
  const DocumentPtr last = sleeping(0.0, 3.0);
  worker.request(last);
  ASSERT_TRUE(wait());
  ASSERT_EQ(outcomes.size(), 1u);
  EXPECT_EQ(outcomes[0]->document, last);
  EXPECT_TRUE(outcomes[0]->run.complete());
  EXPECT_DOUBLE_EQ(outcomes[0]->quantities.at(0).value, 3.0);
}

/// A gesture: requests follow each other faster than runs, and each run is short.
TEST_F(WorkerTest, ShortRunsOfAStreamOfRequestsAreHeardOfAndTheLastIsTheLatest) {
  for (int i = 1; i <= 60; ++i) {
    worker.request(sleeping(0.03, i));
    QTest::qWait(8);
  }
  ASSERT_TRUE(wait());
  EXPECT_GE(outcomes.size(), 5u);
  double before = 0.0;
  for (const OutcomePtr& outcome : outcomes) {
    EXPECT_TRUE(outcome->run.complete());
    EXPECT_GT(outcome->quantities.at(0).value, before);  // in order, none twice
    before = outcome->quantities.at(0).value;
  }
  EXPECT_DOUBLE_EQ(before, 60.0);
}

TEST_F(WorkerTest, ALongRunGivesWayToARequest) {
  worker.request(sleeping(30.0, 1.0));
  QTest::qWait(400);
  QElapsedTimer timer;
  timer.start();
  worker.request(sleeping(0.0, 2.0));
  ASSERT_TRUE(wait());
  EXPECT_LT(timer.elapsed(), 5000);
  ASSERT_EQ(outcomes.size(), 1u);
  EXPECT_DOUBLE_EQ(outcomes[0]->quantities.at(0).value, 2.0);
}

TEST_F(WorkerTest, PicturesShareWhatARunLeavesAsItIs) {
  DocumentPtr document = sleeping(0.0, 70.0);
  scenario::Document stack = *document;
  stack.steps[0].operation = "stack";
  stack.steps[0].params = {};
  for (int k = 0; k < 2; ++k) {
    worker.request(std::make_shared<const scenario::Document>(stack));
    ASSERT_TRUE(wait());
  }
  ASSERT_EQ(outcomes.size(), 2u);
  ASSERT_NE(outcomes[0]->picture, outcomes[1]->picture);
  const auto regions = [&](std::size_t run) {
    return std::get<scene::Regions>(outcomes[run]->picture->panels.at(0).layers.at(0).content).regions;
  };
  ASSERT_FALSE(regions(0).empty());
  EXPECT_TRUE(regions(0).is(regions(1)));
}

TEST_F(WorkerTest, CancelledRunSaysSoAndKeepsTheStatesItReached) {
  worker.request(sleeping(30.0, 1.0));
  ASSERT_TRUE(QTest::qWaitFor([&] { return worker.busy(); }));
  QTest::qWait(50);
  worker.cancel();
  ASSERT_TRUE(wait());
  ASSERT_EQ(outcomes.size(), 1u);
  ASSERT_TRUE(outcomes[0]->run.error);
  EXPECT_EQ(outcomes[0]->run.error->code, base::ErrorCode::Cancelled);
  EXPECT_EQ(outcomes[0]->run.states.size(), 1u);
  EXPECT_NE(outcomes[0]->picture, nullptr);
}

TEST_F(WorkerTest, WorkGoesOnAfterACancel) {
  worker.request(sleeping(30.0, 1.0));
  worker.cancel();
  ASSERT_TRUE(wait());
  worker.request(sleeping(0.0, 5.0));
  ASSERT_TRUE(wait());
  EXPECT_TRUE(outcomes.back()->run.complete());
}

TEST(Worker, DestroyedWhileRunningEndsPromptly) {
  const scenario::Program program = test::fake_program();
  QElapsedTimer timer;
  {
    Worker worker(program);
    scenario::Document document;
    document.program = "waves";
    document.steps.resize(1);
    document.steps[0].operation = "sleep";
    document.steps[0].params.set("seconds", 60.0);
    worker.request(std::make_shared<const scenario::Document>(std::move(document)));
    QTest::qWait(30);
    timer.start();
  }
  EXPECT_LT(timer.elapsed(), 10000);
}

}  // namespace
}  // namespace dobra::gui::documents
