// What forms offer as names is found by the worker.
#include <gtest/gtest.h>

#include <QMenu>
#include <QThread>
#include <QToolButton>
#include <atomic>
#include <set>

#include "tests/shared/gui/window_fixture.h"

namespace dobra::gui {
namespace {

struct PointAt {
  std::string bump;
  template <class D>
  static void describe(D& d) {
    d.field("bump", &PointAt::bump, {.title = "Bump", .names = "bump"});
  }
};

base::Result<test::Waves> point_at(const test::Waves& waves, const PointAt&, const scenario::Context&,
                                   const base::Progress&) {
  return waves;
}

class OfferedNames : public testing::Test {
 protected:
  OfferedNames() {
    program.operations.push_back(
        scenario::make_operation<test::Waves, PointAt>("point", "Point", "Names a bump.", point_at));
    program.names_of = [this](const scenario::State& state, const std::string& what) {
      if (QThread::currentThread() == QCoreApplication::instance()->thread()) ++in_the_window;
      ++asked;
      while (slow) QThread::msleep(1);
      return what == "bump" ? scenario::model_of<test::Waves>(state).names : std::vector<std::string>{};
    };
    window.emplace(program);
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&*window, 10000));
  }
  ~OfferedNames() override { slow = false; }
  void open(const char* bumps) {
    const std::string text = std::string("dobra = 1\nprogram = \"waves\"\n[input]\namplitude = 50.0\n") + bumps +
                             "[[step]]\noperation = \"point\"\n[[step]]\noperation = \"stack\"\ncount = 3\n"
                             "distance = 10.0\n";
    ASSERT_TRUE(window->open(folder.write("waves.toml", text)).ok());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->session().busy(); }, 30000));
    window->select(1);
  }
  /// As the menu beside the field says.
  std::vector<std::string> offered() {
    auto* pick = window->form().findChild<QToolButton*>("pick.bump");
    if (pick == nullptr || pick->isHidden()) return {};
    emit pick->menu()->aboutToShow();
    std::vector<std::string> names;
    for (const QAction* action : pick->menu()->actions()) names.push_back(action->text().toStdString());
    return names;
  }
  bool comes(const std::vector<std::string>& names) {
    return QTest::qWaitFor([&] { return offered() == names; }, 30000);
  }
  test::TemporaryFolder folder;
  std::atomic<int> in_the_window = 0;
  std::atomic<int> asked = 0;
  std::atomic<bool> slow = false;
  scenario::Program program = test::fake_program();
  std::optional<MainWindow> window;
};

const char* const two = "[[input.bump]]\nname = \"left\"\n[[input.bump]]\nname = \"right\"\n";
const char* const one = "[[input.bump]]\nname = \"only\"\n";

TEST_F(OfferedNames, AreFoundElsewhereWhileTheWindowGoesOn) {
  slow = true;
  open(two);
  ASSERT_TRUE(QTest::qWaitFor([&] { return asked > 0; }, 30000));
  QTest::qWait(20);
  EXPECT_TRUE(offered().empty());
  slow = false;
  EXPECT_TRUE(comes({"left", "right"}));
  EXPECT_EQ(in_the_window, 0);
}

TEST_F(OfferedNames, FollowTheDocumentAndAreAskedOnceAState) {
  open(two);
  ASSERT_TRUE(comes({"left", "right"}));
  const int before = asked;
  window->select(2);
  window->select(1);
  EXPECT_EQ(offered(), (std::vector<std::string>{"left", "right"}));
  QTest::qWait(50);
  EXPECT_EQ(asked, before);
  open(one);
  EXPECT_NE(offered(), (std::vector<std::string>{"left", "right"}));  // not of the document before
  ASSERT_TRUE(comes({"only"}));
  open(two);
  ASSERT_TRUE(comes({"left", "right"}));
  EXPECT_EQ(in_the_window, 0);
}

TEST_F(OfferedNames, OfAnEditedInputAreThoseOfItsRun) {
  open(one);
  ASSERT_TRUE(comes({"only"}));
  scenario::Document other = window->session().document();
  std::vector<scenario::Table> bumps(1);
  bumps[0].set("name", std::string("other"));
  other.input.set("bump", bumps);
  window->session().edit(other, "Another name");
  EXPECT_TRUE(comes({"other"}));
  window->undo();
  EXPECT_TRUE(comes({"only"}));
  EXPECT_EQ(in_the_window, 0);
}

}  // namespace
}  // namespace dobra::gui
