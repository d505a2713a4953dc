// A scenario that cannot be read is shown as text, with the place that is wrong, and nothing of it is lost.

#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTextBlock>
#include <QTimer>
#include <fstream>

#include "shared/gui/mending/page.h"
#include "shared/io/file.h"
#include "tests/shared/gui/window_fixture.h"

namespace dobra::gui::mending {
namespace {

class Mending : public test::WindowFixture {
 protected:
  std::string file_of(const std::string& text) { return folder.write("broken.toml", text); }
  static std::string read(const std::string& file) { return io::read_bytes(file).value(); }
  Page& page() { return *window.findChild<Page*>(); }
  QPlainTextEdit& edit() { return *page().findChild<QPlainTextEdit*>("mending.text"); }
  std::string message() { return page().findChild<QLabel*>("mending.message")->text().toStdString(); }
  void click_button(const char* name) {
    QTest::mouseClick(page().findChild<QPushButton*>(name), Qt::LeftButton);
    QCoreApplication::processEvents();
  }
  bool is_shown() { return page().isVisible() && !window.view().isVisible(); }
  /// Clicks the button of the next question.
  void answer(const char* words) {
    QTimer::singleShot(100, &window, [words] {
      auto* box = QApplication::activeModalWidget();
      ASSERT_NE(box, nullptr);
      for (auto* button : box->findChildren<QPushButton*>()) {
        if (button->text() == words) return button->click();
      }
      FAIL() << "no button " << words;
    });
  }
};

TEST_F(Mending, WhatIsNotATextIsToldAndNothingIsShownOfIt) {
  const std::string missing = (folder / "missing.toml").string();
  EXPECT_FALSE(window.open_or_mend(missing).ok());
  EXPECT_FALSE(page().isVisible());
  EXPECT_TRUE(window.findChild<QWidget*>("welcome")->isVisible());
  EXPECT_NE(window.error_bar().message().toStdString().find("missing.toml"), std::string::npos);
  for (const std::string& bytes : {std::string("dobra\0= 1", 9), std::string("\xff\xfe\x00", 3), std::string()}) {
    EXPECT_FALSE(window.open_or_mend(file_of(bytes)).ok());
    EXPECT_FALSE(page().isVisible());
    EXPECT_NE(window.error_bar().message().toStdString().find("broken.toml"), std::string::npos);
  }
  EXPECT_FALSE(window.open_or_mend(folder / "").ok());
  EXPECT_FALSE(page().isVisible());
}

TEST_F(Mending, TheWrongLineIsMendedWithTheKeyboardSavedAndOpened) {
  const std::string wrong = std::string(test::waves_text()) + "\n[[step]\noperation = \"lift\"\n# the end\r\n";
  const std::string file = file_of(wrong);
  EXPECT_FALSE(window.open_or_mend(file).ok());
  ASSERT_TRUE(is_shown());
  EXPECT_NE(message().find("broken.toml:"), std::string::npos) << message();
  EXPECT_EQ(edit().textCursor().block().text(), "[[step]");
  ASSERT_EQ(edit().extraSelections().size(), 1);
  // As it is, it is not written.
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 5000));
  edit().setFocus();
  QTest::keyClick(focus(), Qt::Key_Home);
  QTest::keyClicks(focus(), "#");
  QTest::keyClick(focus(), Qt::Key_Backspace);
  click_button("mending.save");
  EXPECT_TRUE(is_shown());
  EXPECT_EQ(read(file), wrong);
  QTest::keyClick(focus(), Qt::Key_End);
  QTest::keyClicks(focus(), "]");
  click_button("mending.save");
  settle();
  EXPECT_FALSE(page().isVisible());
  EXPECT_TRUE(window.view().isVisible());
  EXPECT_EQ(window.session().document().steps.size(), 2U);
  EXPECT_EQ(window.session().document().file, file);
  EXPECT_NE(read(file).find("[[step]]"), std::string::npos);
  EXPECT_NE(read(file).find("# the end\r\n"), std::string::npos);
}

TEST_F(Mending, EscapeLeavesTheFileAndTheDocumentBeforeAsTheyAre) {
  open_waves();
  const std::string before = text();
  const std::string file = file_of("dobra = 1\nprogram = \"waves\"\n[input\n");
  EXPECT_FALSE(window.open_or_mend(file).ok());
  ASSERT_TRUE(is_shown());
  EXPECT_EQ(text(), before);
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 5000));
  edit().setFocus();
  QTest::keyClick(focus(), Qt::Key_Escape);
  EXPECT_TRUE(window.view().isVisible());
  EXPECT_FALSE(page().isVisible());
  EXPECT_EQ(text(), before);
  EXPECT_EQ(read(file), "dobra = 1\nprogram = \"waves\"\n[input\n");
}

TEST_F(Mending, WhatWasTypedIsNotLostWithoutAQuestion) {
  const std::string file = file_of("dobra = 1\nprogram = \"waves\"\n[input\n");
  EXPECT_FALSE(window.open_or_mend(file).ok());
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 5000));
  edit().setFocus();
  QTest::keyClicks(focus(), "x");
  answer("Cancel");
  EXPECT_FALSE(window.close());
  EXPECT_TRUE(window.isVisible());
  answer("Cancel");
  QTest::keyClick(&edit(), Qt::Key_Escape);
  EXPECT_TRUE(is_shown());
  answer("Discard");
  QTest::keyClick(&edit(), Qt::Key_Escape);
  EXPECT_FALSE(is_shown());
}

TEST_F(Mending, WhatAnotherProgramWroteMeanwhileIsNotReplacedUnasked) {
  const std::string good = test::waves_text();
  const std::string file = file_of(good + "[[step]\n");
  EXPECT_FALSE(window.open_or_mend(file).ok());
  std::ofstream(file) << "somebody else's\n";
  edit().setPlainText(QString::fromStdString(good));
  click_button("mending.save");
  EXPECT_TRUE(is_shown());
  EXPECT_NE(message().find("Another program"), std::string::npos) << message();
  EXPECT_EQ(read(file), "somebody else's\n");
  click_button("mending.save");
  settle();
  EXPECT_FALSE(page().isVisible());
  EXPECT_EQ(read(file), good);
}

TEST_F(Mending, ADocumentOfAnotherProgramIsShownToo) {
  EXPECT_FALSE(window.open_or_mend(file_of("dobra = 1\nprogram = \"quebra\"\n")).ok());
  EXPECT_TRUE(is_shown());
  EXPECT_NE(message().find("quebra"), std::string::npos) << message();
}

}  // namespace
}  // namespace dobra::gui::mending
