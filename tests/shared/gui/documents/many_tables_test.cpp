// Forms of tables: what many lines, drawn one after the other, leave open.
#include <gtest/gtest.h>

#include <QLineEdit>
#include <QToolButton>

#include "shared/gui/parameter_form.h"
#include "shared/gui/tables_editor.h"
#include "tests/shared/gui/window_fixture.h"

namespace dobra::gui {
namespace {

class ManyTables : public test::WindowFixture {
 protected:
  void draw(int count) {
    for (int i = 0; i < count; ++i) {
      const double y = 10.0 * ++drawn;
      const geom::Polyline line{{{0.0, y}, {500.0, y + 5.0}}, false};
      const auto made = program.drawing.add(window.session().document(), "bump", "b" + std::to_string(drawn), line);
      ASSERT_TRUE(made.ok());
      window.session().edit(*made, "Draw");
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  TablesEditor& bumps() { return *window.form().findChild<TablesEditor*>(); }
  /// The headers of the bumps, as a person clicks them.
  QToolButton* header(int i) {
    QList<QToolButton*> headers;
    for (QToolButton* button : bumps().findChildren<QToolButton*>()) {
      if (button->isCheckable() && button->text().startsWith(QString::number(i) + " ")) headers.push_back(button);
    }
    EXPECT_EQ(headers.size(), 1);
    return headers.value(0);
  }
  int drawn = 0;
};

TEST_F(ManyTables, LinesDrawnOneAfterTheOtherLeaveTheLastOpen) {
  open_waves();
  window.select(0);
  draw(3);
  const auto forms = bumps().made_forms().size();
  const auto widgets = window.findChildren<QWidget*>().size();
  draw(40);
  EXPECT_EQ(bumps().made_forms().size(), forms);
  EXPECT_TRUE(header(43)->isChecked());
  EXPECT_FALSE(header(42)->isChecked());
  EXPECT_LE(window.findChildren<QWidget*>().size(), widgets + 40 * 8);
  for (int i = 0; i < 40; ++i) window.undo();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_LE(window.findChildren<QWidget*>().size(), widgets + 8);
}

TEST_F(ManyTables, WhatAPersonHasOpenedOrTypedInStaysOpen) {
  open_waves();
  window.select(0);
  draw(3);
  QTest::mouseClick(header(2), Qt::LeftButton);
  ASSERT_TRUE(header(2)->isChecked());
  auto* name = header(3)->parentWidget()->findChild<QLineEdit*>();
  ASSERT_NE(name, nullptr);
  click(name);
  QTest::keyClick(name, Qt::Key_X);
  draw(2);
  EXPECT_TRUE(header(2)->isChecked());
  EXPECT_TRUE(header(3)->isChecked());
  EXPECT_FALSE(header(4)->isChecked());
  EXPECT_TRUE(header(5)->isChecked());
  QTest::mouseClick(header(4), Qt::LeftButton);
  EXPECT_TRUE(header(4)->isChecked());
  EXPECT_EQ(header(4)->parentWidget()->findChildren<TableForm*>().size(), 1);
}

}  // namespace
}  // namespace dobra::gui
