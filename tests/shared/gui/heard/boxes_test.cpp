#include "shared/gui/heard/boxes.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QTest>

namespace dobra::gui::heard {
namespace {

TEST(Boxes, AreCalledByTheirNameAndHoldWhatIsChosen) {
  name_boxes();
  name_boxes();
  QComboBox box;
  box.addItems({"1", "2"});
  QAccessibleInterface* heard = QAccessible::queryAccessibleInterface(&box);
  ASSERT_NE(heard, nullptr);
  EXPECT_EQ(heard->role(), QAccessible::ComboBox);
  EXPECT_EQ(heard->text(QAccessible::Name), "1");  // nobody has named it
  box.setAccessibleName("Order");
  box.setAccessibleDescription("Of the elements");
  EXPECT_EQ(heard->text(QAccessible::Name), "Order");
  EXPECT_EQ(heard->text(QAccessible::Description), "Of the elements");
  EXPECT_EQ(heard->text(QAccessible::Value), "1");
  QTest::keyClick(&box, Qt::Key_Down);
  EXPECT_EQ(heard->text(QAccessible::Value), "2");
  EXPECT_EQ(heard->text(QAccessible::Name), "Order");
  EXPECT_FALSE(heard->state().editable);
  box.setEditable(true);
  EXPECT_TRUE(heard->state().editable);
}

TEST(Boxes, OpenForWhoeverAsksWithoutAMouse) {
  name_boxes();
  QComboBox box;
  box.addItems({"1", "2"});
  box.setAccessibleName("Order");
  box.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&box, 5000));
  QAccessibleInterface* heard = QAccessible::queryAccessibleInterface(&box);
  ASSERT_NE(heard->actionInterface(), nullptr);
  const QString open = QAccessibleActionInterface::showMenuAction();
  ASSERT_TRUE(heard->actionInterface()->actionNames().contains(open));
  heard->actionInterface()->doAction(open);
  EXPECT_TRUE(QTest::qWaitFor([&] { return QApplication::activePopupWidget() != nullptr; }, 5000));
  box.hidePopup();
  box.setEnabled(false);
  EXPECT_FALSE(heard->actionInterface()->actionNames().contains(open));
}

}  // namespace
}  // namespace dobra::gui::heard
