#include "shared/gui/parameter_form.h"

#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "shared/gui/theme/colors.h"
#include "tests/shared/gui/fake_program.h"

namespace dobra::gui {
namespace {

using scenario::Table;

class ParameterFormTest : public testing::Test {
 protected:
  ParameterFormTest() {
    QObject::connect(&form, &TableForm::edited, [this](const Table& table, const QString& key) {
      tables.push_back(table);
      keys << key;
    });
    form.set_table({});
    form.show();
  }
  template <class Widget>
  Widget* inside(const char* key) {
    auto* editor = form.findChild<QWidget*>(QString("editor.") + key);
    return editor != nullptr ? editor->findChild<Widget*>() : nullptr;
  }
  QToolButton* reset(const char* key) { return form.findChild<QToolButton*>(QString("reset.") + key); }

  TableForm form{scenario::fields_of<test::StackParams>(), {}};
  std::vector<Table> tables;
  QStringList keys;
};

TEST_F(ParameterFormTest, ShowsDefaultsAndNoResetWhereTheTableIsEmpty) {
  EXPECT_EQ(inside<QLineEdit>("count")->text(), "3");
  EXPECT_TRUE(inside<QLineEdit>("distance")->text().startsWith("50"));
  EXPECT_EQ(inside<QComboBox>("corners")->currentText(), "mitre");
  EXPECT_TRUE(inside<QCheckBox>("filled")->isChecked());
  EXPECT_EQ(inside<QLineEdit>("limit")->text(), "");
  EXPECT_FALSE(reset("count")->isVisible());
  EXPECT_TRUE(tables.empty());
}

TEST_F(ParameterFormTest, TypingAndReturnGivesATableWithTheValue) {
  auto* line = inside<QLineEdit>("count");
  line->selectAll();
  QTest::keyClicks(line, "7");
  EXPECT_TRUE(tables.empty());
  QTest::keyClick(line, Qt::Key_Return);
  ASSERT_EQ(tables.size(), 1u);
  EXPECT_EQ(keys.last(), "count");
  EXPECT_EQ(std::get<std::int64_t>(*tables[0].find("count")), 7);
  EXPECT_TRUE(reset("count")->isVisible());
}

TEST_F(ParameterFormTest, GUI_c_BadValuesAreRefusedInPlaceAndChangeNothing) {
  for (const auto& [key, typed] : std::vector<std::pair<std::string, const char*>>{{"count", "0"},
                                                                                   {"count", "41"},
                                                                                   {"count", "2.5"},
                                                                                   {"count", "many"},
                                                                                   {"distance", "-1"},
                                                                                   {"distance", "0"},
                                                                                   {"distance", "nan"},
                                                                                   {"distance", "1e999"},
                                                                                   {"limit", "-3"},
                                                                                   {"corners", "sharp"},
                                                                                   {"datum", "1, 2; 3"}}) {
    form.set_table({});
    const base::Result<void> done = form.type(key, typed);
    EXPECT_FALSE(done.ok()) << key << " " << typed;
    EXPECT_FALSE(form.message_at(key).isEmpty()) << key << " " << typed;
  }
  EXPECT_TRUE(tables.empty());
}

TEST_F(ParameterFormTest, GoodValueClearsTheMessage) {
  EXPECT_FALSE(form.type("distance", "-1").ok());
  EXPECT_TRUE(form.type("distance", "0.25").ok());
  EXPECT_EQ(form.message_at("distance"), "");
  EXPECT_EQ(*scenario::as_kind(*tables.back().find("distance"), scenario::Kind::Number), scenario::Value(0.25));
}

TEST_F(ParameterFormTest, ResetReturnsToTheDefault) {
  EXPECT_TRUE(form.type("count", "9").ok());
  QTest::mouseClick(reset("count"), Qt::LeftButton);
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[1].find("count"), nullptr);
  EXPECT_EQ(inside<QLineEdit>("count")->text(), "3");
}

TEST_F(ParameterFormTest, EmptiedEditorMeansTheDefault) {
  EXPECT_TRUE(form.type("limit", "4").ok());
  EXPECT_TRUE(form.type("limit", "").ok());
  EXPECT_EQ(tables.back().find("limit"), nullptr);
}

TEST_F(ParameterFormTest, SteppingStaysInTheRangeAndIsOneEdit) {
  EXPECT_TRUE(form.type("count", "39").ok());
  auto* spin = inside<QAbstractSpinBox>("count");
  for (int i = 0; i < 5; ++i) spin->stepUp();
  EXPECT_EQ(tables.size(), 1u);
  ASSERT_TRUE(QTest::qWaitFor([&] { return tables.size() == 2; }, 5000));
  EXPECT_EQ(std::get<std::int64_t>(*tables.back().find("count")), 40);
}

TEST_F(ParameterFormTest, CheckBoxAndChoiceChangeAtAClick) {
  inside<QCheckBox>("filled")->click();
  EXPECT_EQ(*tables.back().find("filled"), scenario::Value(false));
  EXPECT_TRUE(form.type("corners", "round").ok());
  EXPECT_EQ(*tables.back().find("corners"), scenario::Value(std::string("round")));
}

TEST_F(ParameterFormTest, ALongTextShowsItsBeginningAndTheWholeUnderThePointer) {
  const QString name = QString("Upper Sandstone of the eastern block, ").repeated(6).trimmed();
  auto* line = inside<QLineEdit>("note");
  EXPECT_TRUE(form.type("note", name).ok());
  EXPECT_EQ(line->text(), name);
  EXPECT_EQ(line->cursorPosition(), 0);
  Table table;
  table.set("note", name.toStdString());
  form.set_table({});
  form.set_table(table);
  EXPECT_EQ(line->cursorPosition(), 0);
  const auto hover = [&](QLineEdit* over) {
    QHelpEvent event(QEvent::ToolTip, over->rect().center(), over->mapToGlobal(over->rect().center()));
    QCoreApplication::sendEvent(over, &event);
  };
  hover(line);
  EXPECT_TRUE(QToolTip::text().contains(name));
  // What is not cut off leaves the help of the field there.
  EXPECT_TRUE(form.type("note", "short").ok());
  hover(line);
  EXPECT_FALSE(QToolTip::text().contains("short"));
  // Written with keys, it shows its beginning as soon as it is left.
  QApplication::setActiveWindow(&form);
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, name);
  EXPECT_EQ(line->cursorPosition(), name.size());
  QTest::keyClick(line, Qt::Key_Tab);
  EXPECT_EQ(line->cursorPosition(), 0);
}

TEST_F(ParameterFormTest, WhatIsWrittenInTheTableIsJudgedWhenShown) {
  Table table;
  table.set("count", std::int64_t{0});
  table.set("distanse", 3.0);
  form.set_table(table);
  EXPECT_FALSE(form.message_at("count").isEmpty());
  EXPECT_TRUE(form.message_at("distance").isEmpty());
  EXPECT_TRUE(tables.empty());
}

TEST_F(ParameterFormTest, ErrorWithAPlaceInTheFileMarksItsRow) {
  Table table;
  table.set("distance", 3.0, base::Place{"a.toml", 12, 12, {}, {}, {}});
  form.set_table(table);
  EXPECT_FALSE(form.mark(base::Place{"a.toml", 11, 1, {}, {}, {}}, "no"));
  EXPECT_TRUE(form.mark(base::Place{"a.toml", 12, 12, {}, {}, {}}, "too far"));
  EXPECT_EQ(form.message_at("distance"), "too far");
}

double luminance(const QColor& color) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

/// Of WCAG 2.
double contrast(const QColor& a, const QColor& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

TEST(ParameterForm, WhatIsWrongIsReadableOnLightAndOnDarkPalettes) {
  const QPalette before = QApplication::palette();
  for (const auto& [back, base, front] :
       {std::tuple{"#efefef", "#ffffff", "#000000"}, {"#31363b", "#232629", "#eff0f1"}}) {
    QPalette palette(QColor(front), QColor(back), Qt::white, Qt::black, Qt::gray, QColor(front), QColor(base));
    QApplication::setPalette(palette);
    TableForm form{scenario::fields_of<test::StackParams>(), {}};
    form.set_table({});
    EXPECT_FALSE(form.type("count", "many").ok());
    const auto* line = form.findChild<QWidget*>("editor.count")->findChild<QLineEdit*>();
    const QPalette shown = line->parentWidget()->palette();
    EXPECT_NE(shown.color(QPalette::Base), QColor(base));
    EXPECT_GE(contrast(shown.color(QPalette::Base), shown.color(QPalette::Text)), 4.5) << back;
    const QColor quiet = theme::with_quiet_words(palette).color(QPalette::PlaceholderText);
    for (const QColor& words :
         {theme::wrong_text(palette), theme::right_text(palette), theme::remark_text(palette), quiet}) {
      EXPECT_GE(contrast(words, QColor(back)), 4.5) << back;
      EXPECT_GE(contrast(words, QColor(base)), 4.5) << base;
    }
  }
  QApplication::setPalette(before);
}

TEST_F(ParameterFormTest, ANumberMayHaveADecimalComma) {
  ASSERT_TRUE(form.type("distance", "12,5").ok());
  EXPECT_EQ(*tables.back().find("distance"), scenario::Value(12.5));
  EXPECT_FALSE(form.type("distance", "1,234.5").ok());
  EXPECT_FALSE(form.type("distance", "1,2,3").ok());
  EXPECT_FALSE(form.type("count", "1,5").ok());
}

TEST_F(ParameterFormTest, UnknownKeyGetsASuggestion) {
  const base::Result<void> done = form.type("distanse", "3");
  ASSERT_FALSE(done.ok());
  EXPECT_NE(done.error().message.find("'distance'"), std::string::npos) << done.error().message;
}

TEST(TableForm, TablesInATableAreAddedEditedAndRemoved) {
  TableForm form(scenario::fields_of<test::WaveInput>(), {});
  Table last;
  QObject::connect(&form, &TableForm::edited, [&](const Table& table) { last = table; });
  form.set_table({});
  form.show();
  auto* add = form.findChild<QToolButton*>("add.bump");
  ASSERT_NE(add, nullptr);
  add->click();
  add->click();
  ASSERT_TRUE(form.type("bump.2.height", "4.5").ok());
  ASSERT_TRUE(form.type("bump.1.points", "0, 0; 1, 2").ok());
  const std::vector<Table> bumps = scenario::detail::tables_of(*last.find("bump"));
  ASSERT_EQ(bumps.size(), 2u);
  EXPECT_EQ(scenario::detail::number_of(*bumps[1].find("height")), 4.5);
  EXPECT_EQ(scenario::detail::points_of(*bumps[0].find("points")).size(), 2u);
  EXPECT_FALSE(form.type("bump.2.height", "0").ok());
  EXPECT_FALSE(form.message_at("bump.2.height").isEmpty());
  EXPECT_FALSE(form.type("bump.3.height", "1").ok());
}

std::vector<Table> many_bumps(std::size_t count) {
  std::vector<Table> bumps(count);
  for (std::size_t i = 0; i < count; ++i) {
    bumps[i].set("name", "bump " + std::to_string(i));
    bumps[i].set("height", 1.0 + static_cast<double>(i));
  }
  return bumps;
}

Table with_bumps(const std::vector<Table>& bumps) {
  Table table;
  table.set("bump", bumps);
  return table;
}

TEST(TableForm, OnlyOpenedTablesHaveForms) {
  TableForm form(scenario::fields_of<test::WaveInput>(), {});
  Table last;
  QObject::connect(&form, &TableForm::edited, [&](const Table& table) { last = table; });
  form.set_table(with_bumps(many_bumps(100)));
  form.show();
  EXPECT_EQ(form.findChildren<TableForm*>().size(), 0);
  QList<QToolButton*> headers;
  for (QToolButton* button : form.findChildren<QToolButton*>()) {
    if (button->isCheckable() && button->text().contains("bump ")) headers << button;
  }
  ASSERT_EQ(headers.size(), 100);
  QTest::mouseClick(headers[41], Qt::LeftButton);
  ASSERT_EQ(form.findChildren<TableForm*>().size(), 1);
  auto* opened = form.findChild<TableForm*>();
  EXPECT_TRUE(opened->isVisible());
  EXPECT_EQ(opened->findChild<QWidget*>("editor.height")->findChild<QLineEdit*>()->text(), "42");
  QTest::mouseClick(headers[41], Qt::LeftButton);
  EXPECT_FALSE(opened->isVisible());
  // An edit of one says the others as they are, whether they have been open or not.
  ASSERT_TRUE(form.type("bump.8.height", "4.5").ok());
  EXPECT_EQ(form.findChildren<TableForm*>().size(), 2);
  std::vector<Table> expected = many_bumps(100);
  expected[7].set("height", 4.5);
  EXPECT_TRUE(last == with_bumps(expected));
  // Back in an older document, what is open shows its values, and what was never open takes them too.
  form.set_table(with_bumps(many_bumps(50)));
  EXPECT_EQ(opened->findChild<QWidget*>("editor.height")->findChild<QLineEdit*>()->text(), "42");
  ASSERT_TRUE(form.type("bump.50.height", "1.5").ok());
  expected = many_bumps(50);
  expected[49].set("height", 1.5);
  EXPECT_TRUE(last == with_bumps(expected));
}

/// Counts what is told to a widget of its looks.
class LooksChanged : public QObject {
 public:
  using QObject::QObject;
  int count = 0;

 protected:
  bool eventFilter(QObject* object, QEvent* event) override {
    const QEvent::Type type = event->type();
    if (type == QEvent::PaletteChange || type == QEvent::FontChange || type == QEvent::LayoutRequest) ++count;
    return QObject::eventFilter(object, event);
  }
};

TEST(TableForm, AnEditTouchesTheRowThatItChanges) {
  TableForm form(scenario::fields_of<test::StackParams>(), {});
  Table table;
  table.set("note", std::string("first"));
  form.set_table(table);
  form.show();
  QApplication::processEvents();
  LooksChanged others;
  for (const char* key : {"count", "distance", "tilt", "corners", "filled", "limit", "datum"}) {
    for (QWidget* inside : form.findChild<QWidget*>(QString("editor.") + key)->findChildren<QWidget*>())
      inside->installEventFilter(&others);
  }
  for (int i = 0; i < 20; ++i) {
    table.set("note", "note " + std::to_string(i));
    form.set_table(table);
    QApplication::processEvents();
  }
  EXPECT_EQ(form.findChild<QWidget*>("editor.note")->findChild<QLineEdit*>()->text(), "note 19");
  EXPECT_EQ(others.count, 0);
  table.set("distance", 12.0);  // which does change something
  form.set_table(table);
  QApplication::processEvents();
  EXPECT_GT(others.count, 0);
}

TEST(TableForm, WordsTakeTheColoursOfAnotherTheme) {
  TableForm form(scenario::fields_of<test::StackParams>(), {});
  Table table;
  table.set("count", std::int64_t{4});
  form.set_table(table);
  form.show();
  const QPalette before = QApplication::palette();
  const QPalette dark(QColor("#eff0f1"), QColor("#31363b"), Qt::white, Qt::black, Qt::gray, QColor("#eff0f1"),
                      QColor("#232629"));
  QApplication::setPalette(dark);
  QApplication::processEvents();
  form.set_table(table);
  const auto* line = form.findChild<QWidget*>("editor.count")->findChild<QLineEdit*>();
  EXPECT_EQ(line->palette().color(QPalette::Text), QColor("#eff0f1"));
  EXPECT_EQ(line->palette().color(QPalette::Base), QColor("#232629"));
  QApplication::setPalette(before);
}

/// Names one thing of the model, and several.
struct Named {
  std::string one;
  std::vector<std::string> several;
  template <class D>
  static void describe(D& d) {
    d.field("one", &Named::one, {.names = "fault"});
    d.field("several", &Named::several, {.names = "bed"});
  }
};

TEST(TableForm, NamesOfTheModelArePickedFromAMenu) {
  TableForm form{scenario::fields_of<Named>(), {}};
  form.set_table({});
  form.show();
  const auto pick = [&](const char* key) { return form.findChild<QToolButton*>(QString("pick.") + key); };
  const auto trigger = [&](const char* key, int entry) {
    emit pick(key)->menu()->aboutToShow();
    ASSERT_GT(pick(key)->menu()->actions().size(), entry);
    pick(key)->menu()->actions()[entry]->trigger();
  };
  EXPECT_FALSE(pick("one")->isVisible());  // nothing to offer yet
  form.offer([](const std::string& what) {
    return what == "fault" ? std::vector<std::string>{"East", "West & more"} : std::vector<std::string>{"A", "B", "C"};
  });
  ASSERT_TRUE(pick("one")->isVisible());
  trigger("one", 1);
  EXPECT_EQ(std::get<std::string>(*form.table().find("one")), "West & more");
  ASSERT_TRUE(form.type("several", "B, C"));  // as typed, without brackets
  EXPECT_EQ(std::get<std::vector<std::string>>(*form.table().find("several")), (std::vector<std::string>{"B", "C"}));
  trigger("several", 1);
  trigger("several", 2);
  trigger("several", 0);
  trigger("several", 2);
  EXPECT_EQ(std::get<std::vector<std::string>>(*form.table().find("several")), (std::vector<std::string>{"A", "C"}));
  emit pick("several")->menu()->aboutToShow();
  EXPECT_TRUE(pick("several")->menu()->actions()[0]->isChecked());
  EXPECT_FALSE(pick("several")->menu()->actions()[1]->isChecked());
  trigger("several", 0);
  trigger("several", 2);
  EXPECT_EQ(form.table().find("several"), nullptr);
}

}  // namespace
}  // namespace dobra::gui
