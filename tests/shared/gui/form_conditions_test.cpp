// Forms that show what matters, and names and places that are pointed at instead of typed.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include "shared/gui/canvas.h"
#include "shared/gui/main_window.h"
#include "shared/gui/parameter_form.h"
#include "tests/shared/gui/window_fixture.h"

namespace dobra::gui {
namespace {

using scenario::Table;

enum class Method { Constant, Shear, Flexural };

struct Bend {
  Method method = Method::Constant;
  double angle = 0.0;
  std::string file;
  std::string feature;
  std::vector<test::Bump> bumps;
  double size = 1.0;
  template <class D>
  static void describe(D& d) {
    d.choice("method", &Bend::method, {"constant", "shear", "flexural"}, {.title = "Method"});
    d.field("angle", &Bend::angle, {.title = "Direction of shear", .unit = "deg", .when = "method = shear"});
    d.field("file", &Bend::file, {.title = "File"});
    d.field("feature", &Bend::feature, {.title = "Feature", .when = "file is set"});
    d.tables("bump", &Bend::bumps, {.title = "Bumps", .when = "method in shear, flexural"});
    d.field("size", &Bend::size, {.title = "Size", .unit = "Pa, N if method = shear, deg if method = flexural"});
  }
};

class FormConditionsTest : public testing::Test {
 protected:
  FormConditionsTest() {
    QObject::connect(&form, &TableForm::edited, [this](const Table& table) { tables.push_back(table); });
    form.set_table({});
    form.show();
  }
  QWidget* editor(const char* key) { return form.findChild<QWidget*>(QString("editor.") + key); }
  QToolButton* remove(const char* key) { return form.findChild<QToolButton*>(QString("remove.") + key); }
  /// All words that the form shows now.
  std::string words() {
    std::string all;
    for (const QLabel* label : form.findChildren<QLabel*>()) {
      if (label->isVisible()) all += label->text().toStdString() + "\n";
    }
    return all;
  }
  bool says(const char* what) { return words().find(what) != std::string::npos; }

  TableForm form{scenario::fields_of<Bend>(), {}};
  std::vector<Table> tables;
};

TEST_F(FormConditionsTest, AValueWithoutEffectStaysInSightWithTheReasonAndAButtonThatRemovesIt) {
  Table table;
  table.set("angle", 30.0);
  form.set_table(table);
  EXPECT_TRUE(editor("angle")->isVisible());
  EXPECT_FALSE(editor("angle")->isEnabled());
  EXPECT_TRUE(says("Has no effect with 'Method': constant.")) << words();
  ASSERT_TRUE(remove("angle")->isVisible());
  QTest::mouseClick(remove("angle"), Qt::LeftButton);
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].find("angle"), nullptr);
  EXPECT_FALSE(editor("angle")->isVisible());
  EXPECT_FALSE(says("Direction of shear")) << words();
}

TEST_F(FormConditionsTest, AUnitThatGoesByAChoiceIsTheOneThatHolds) {
  EXPECT_TRUE(says("Pa\n")) << words();
  EXPECT_FALSE(says(" if ")) << words();
  ASSERT_TRUE(form.type("method", "shear").ok());
  EXPECT_TRUE(says("\nN\n")) << words();
  EXPECT_FALSE(says("Pa")) << words();
  ASSERT_TRUE(form.type("method", "flexural").ok());
  EXPECT_TRUE(says("\n\u00b0\n")) << words();
}

TEST_F(FormConditionsTest, AnEmptyTextIsNoFile) {
  Table table;
  table.set("feature", std::string("a"));
  table.set("file", std::string());
  form.set_table(table);
  EXPECT_TRUE(says("Has no effect without 'File'.")) << words();
}

TEST_F(FormConditionsTest, ChoosingShowsAndHidesWhatHangsOnTheChoice) {
  EXPECT_FALSE(editor("angle")->isVisible());
  EXPECT_FALSE(editor("feature")->isVisible());
  EXPECT_FALSE(says("Bumps")) << words();
  ASSERT_TRUE(form.type("method", "shear").ok());
  EXPECT_TRUE(editor("angle")->isVisible());
  EXPECT_TRUE(editor("angle")->isEnabled());
  EXPECT_TRUE(says("Bumps"));
  ASSERT_TRUE(form.type("method", "flexural").ok());
  EXPECT_FALSE(editor("angle")->isVisible());
  EXPECT_TRUE(says("Bumps"));
  ASSERT_TRUE(form.type("file", "a.csv").ok());
  EXPECT_TRUE(editor("feature")->isVisible());
}

TEST_F(FormConditionsTest, AValueIsNeverLostByAnotherChoice) {
  ASSERT_TRUE(form.type("method", "shear").ok());
  ASSERT_TRUE(form.type("angle", "30").ok());
  ASSERT_TRUE(form.type("method", "constant").ok());
  EXPECT_EQ(*scenario::as_kind(*tables.back().find("angle"), scenario::Kind::Number), scenario::Value(30.0));
  EXPECT_FALSE(editor("angle")->isEnabled());
  ASSERT_TRUE(form.type("method", "shear").ok());
  EXPECT_TRUE(editor("angle")->isEnabled());
  EXPECT_FALSE(remove("angle")->isVisible());
}

class PointingTest : public test::WindowFixture {
 protected:
  void open_break() {
    open_waves(std::string(test::waves_text()) + "\n[[step]]\noperation = \"break\"\nat = [500.0, -50.0]\n");
    window.select(2);
  }
  QToolButton* point_at() { return window.form().findChild<QToolButton*>("point.at"); }
  void click_canvas(geom::Point at) {
    QTest::mouseClick(&window.view(), Qt::LeftButton, {}, window.view().pixel_of(0, at).toPoint());
    QCoreApplication::processEvents();
  }
  std::string at_text() {
    const scenario::Value* at = window.session().document().steps.at(1).params.find("at");
    return at != nullptr ? scenario::value_text(*at) : "";
  }
};

TEST_F(PointingTest, EscapeAndAnotherToolLeaveTheFieldAsItWas) {
  open_break();
  const std::string before = text();
  QTest::mouseClick(point_at(), Qt::LeftButton);
  ASSERT_TRUE(window.canvas().is_asking());
  QTest::keyClick(&window.view(), Qt::Key_Escape);
  EXPECT_FALSE(window.canvas().is_asking());
  QTest::mouseClick(point_at(), Qt::LeftButton);
  ASSERT_TRUE(window.actions().trigger("draw.measure"));
  EXPECT_FALSE(window.canvas().is_asking());
  click_canvas({400, 0});
  EXPECT_EQ(text(), before);
}

TEST_F(PointingTest, APlaceThatIsClickedGoesInAndIsOneStepOfUndo) {
  open_break();
  QTest::mouseClick(point_at(), Qt::LeftButton);
  click_canvas({300, 40});
  settle();
  EXPECT_FALSE(window.canvas().is_asking());
  const auto at = std::get<geom::Point>(
      *scenario::as_kind(*window.session().document().steps.at(1).params.find("at"), scenario::Kind::Point));
  const double pixel = window.view().view(0).world_per_point;
  EXPECT_NEAR(at.x, 300.0, 8.0 * pixel);
  EXPECT_NEAR(at.y, 40.0, 8.0 * pixel);
  window.session().undo();
  EXPECT_EQ(at_text(), "[500.0, -50.0]");
  EXPECT_FALSE(window.session().history().can_undo());
}

TEST_F(PointingTest, TheFocusedFieldSaysWhatItIsForAndMayHold) {
  open_waves();
  window.select(1);
  click(editor("count"));
  auto* hint = window.findChild<QLabel*>("form.hint");
  EXPECT_EQ(hint->text().toStdString(), "Number of curves: How many curves. At least 1, at most 40, default 3.");
}

}  // namespace
}  // namespace dobra::gui
