#include "shared/gui/script.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <sstream>

#include "shared/gui/main_window.h"
#include "tests/shared/gui/fake_program.h"

namespace dobra::gui {
namespace {

class ScriptTest : public testing::Test {
 protected:
  /// The exit code of a script in a window on the waves; -1 if it does not end.
  int run(const std::string& commands) {
    folder.write("waves.toml", test::waves_text());
    const std::filesystem::path file = folder.write("script.txt", commands);
    auto lines = Script::read(file);
    EXPECT_TRUE(lines.ok());
    MainWindow window(program);
    EXPECT_TRUE(window.open(folder / "waves.toml").ok());
    window.show();
    Script script(std::move(*lines), file, window);
    QSignalSpy ended(&script, &Script::ended);
    if (ended.isEmpty() && !ended.wait(30000)) return -1;
    return ended.first().first().toInt();
  }
  std::string path(const char* name) { return (folder / name).string(); }

  test::TemporaryFolder folder;
  const scenario::Program program = test::fake_program();
};

TEST_F(ScriptTest, ChangeUndoRedoSaveLeavesTheChangedDocument) {
  EXPECT_EQ(run("# a comment\nwait\nselect grid\nset count 7\nwait\nundo\nwait\nsave " + path("undone.toml") +
                "\nredo\nwait\nsave " + path("redone.toml") + "\nscreenshot " + path("shot.png") + "\nquit\n"),
            0);
  EXPECT_EQ(folder.read("undone.toml"), scenario::document_text(*scenario::read_document(folder / "waves.toml")));
  EXPECT_NE(folder.read("redone.toml").find("count = 7"), std::string::npos);
  EXPECT_GT(folder.read("shot.png").size(), 5000u);
}

TEST_F(ScriptTest, ViewAndLayerCommandsWork) {
  EXPECT_EQ(
      run("wait\nhide after/bed\nshow after/bed\nzoom 2 0.5 0.3\nfit\nsave-picture " + path("p.svg") + "\nquit\n"), 0);
  EXPECT_GT(folder.read("p.svg").size(), 500u);
}

TEST_F(ScriptTest, FailingCommandEndsWithOneAndNamesTheLine) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(run("wait\nselect 1\nset count 0\nquit\n"), 1);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("script.txt:3: "), std::string::npos) << said;
  EXPECT_NE(said.find("count"), std::string::npos) << said;
  for (const char* bad : {"select 9\n", "hide nothing\n", "undo\n", "set nothing 3\n", "add nothing\n", "go-to-error\n",
                          "zoom 0 0 0\n"}) {
    EXPECT_EQ(run(bad), 1) << bad;
  }
}

TEST_F(ScriptTest, ErrorOfARunCanBeExpected) {
  EXPECT_EQ(run("wait\nadd break\nwait\nexpect-error crosses itself\ngo-to-error\nremove\nwait\nquit\n"), 0);
  EXPECT_EQ(run("wait\nexpect-error crosses itself\nquit\n"), 1);
}

TEST_F(ScriptTest, ActionDoesWhatItsMenuDoes) {
  EXPECT_EQ(run("wait\naction step.add.lift\nwait\naction edit.undo\nwait\naction edit.redo\nwait\nsave " +
                path("lifted.toml") + "\nquit\n"),
            0);
  EXPECT_NE(folder.read("lifted.toml").find("operation = \"lift\""), std::string::npos);
  testing::internal::CaptureStderr();
  EXPECT_EQ(run("action edit.unda\n"), 1);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("'edit.undo'"), std::string::npos) << said;
  EXPECT_EQ(run("wait\naction edit.redo\n"), 1);
}

TEST_F(ScriptTest, KeysGoWhereTheOnesBeforeThemHaveMovedTheFocus) {
  EXPECT_EQ(run("wait\ntool line\nkeys 10;20.5\nkeys Enter\nkeys @100<0\nkeys Enter\nkeys Enter\nkeys A long name\n"
                "keys Enter\nwait\nsave " +
                path("drawn.toml") + "\nquit\n"),
            0);
  const std::string drawn = folder.read("drawn.toml");
  EXPECT_NE(drawn.find("name = \"A long name\""), std::string::npos) << drawn;
  EXPECT_NE(drawn.find("[[10.0, 20.5], [110.0, 20.5]]"), std::string::npos) << drawn;
}

TEST_F(ScriptTest, FullFramesAreToldApartFromTheTimeInWhichNothingIsHeard) {
  EXPECT_EQ(run("wait\nfull-frame " + path("opened") + "\nlongest-gap " + path("gap") + "\nquit\n"), 0);
  std::istringstream opened(folder.read("opened"));
  double all = 0.0;
  double deaf = 0.0;
  ASSERT_TRUE(opened >> all >> deaf);
  EXPECT_GT(all, 0.0);
  EXPECT_LE(deaf, all);
  EXPECT_GE(std::stod(folder.read("gap")), deaf - 2.0);  // drawn at once, it is part of the gap
}

TEST(Script, UnknownCommandIsRefusedBeforeAnythingIsDone) {
  const test::TemporaryFolder folder;
  const auto lines = Script::read(folder.write("s.txt", "wait\nscreenshoot a.png\n"));
  ASSERT_FALSE(lines.ok());
  EXPECT_EQ(lines.error().place->line, 2u);
  EXPECT_NE(lines.error().message.find("'screenshot'"), std::string::npos);
  EXPECT_FALSE(Script::read(folder.write("t.txt", "set\n")).ok());
  EXPECT_FALSE(Script::read(folder / "missing.txt").ok());
}

}  // namespace
}  // namespace dobra::gui
