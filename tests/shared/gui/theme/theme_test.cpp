// Light and dark: what is read has contrast, what is chosen is applied at once and remembered.

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <cmath>

#include "shared/gui/theme/colors.h"
#include "tests/shared/gui/window_fixture.h"

namespace dobra::gui {
namespace {

/// Of WCAG 2; what lies under a colour that is not opaque is given.
double luminance_of(const QColor& color) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}
double contrast_of(const QColor& a, const QColor& b) {
  const auto [low, high] = std::minmax({luminance_of(a), luminance_of(b)});
  return (high + 0.05) / (low + 0.05);
}
QColor over(const QColor& below, const QColor& above) {
  const double a = above.alphaF();
  return QColor::fromRgbF(static_cast<float>((1 - a) * below.redF() + a * above.redF()),
                          static_cast<float>((1 - a) * below.greenF() + a * above.greenF()),
                          static_cast<float>((1 - a) * below.blueF() + a * above.blueF()));
}
QColor paper_of(const theme::CanvasColors& colors) {
  const scene::Color& c = colors.ground.paper;
  return {c.red, c.green, c.blue};
}

void expect_readable(const QPalette& palette) {
  using P = QPalette;
  for (const P::ColorGroup group : {P::Active, P::Inactive, P::Disabled}) {
    for (const auto& [words, back] : {std::pair{P::WindowText, P::Window},
                                      {P::Text, P::Base},
                                      {P::Text, P::AlternateBase},
                                      {P::Text, P::Window},
                                      {P::WindowText, P::Base},
                                      {P::ButtonText, P::Button},
                                      {P::ButtonText, P::Window},
                                      {P::HighlightedText, P::Highlight},
                                      {P::PlaceholderText, P::Base},
                                      {P::PlaceholderText, P::Window},
                                      {P::PlaceholderText, P::AlternateBase},
                                      {P::PlaceholderText, P::Button},
                                      {P::ToolTipText, P::ToolTipBase},
                                      {P::Link, P::Base},
                                      {P::Link, P::Window},
                                      {P::LinkVisited, P::Base},
                                      {P::BrightText, P::Window}}) {
      EXPECT_GE(contrast_of(palette.color(group, words), palette.color(group, back)), 4.5)
          << "group " << group << ": role " << words << " on " << back;
    }
  }
  for (const P::ColorRole back : {P::Window, P::Base, P::AlternateBase}) {
    for (const QColor& words : {theme::wrong_text(palette), theme::right_text(palette), theme::remark_text(palette)})
      EXPECT_GE(contrast_of(words, palette.color(back)), 4.5) << back;
  }
  EXPECT_GE(contrast_of(palette.color(P::Text), theme::wrong_base(palette)), 4.5);
  EXPECT_GE(contrast_of(palette.color(P::PlaceholderText), theme::wrong_base(palette)), 4.5);
  const theme::ErrorColors error = theme::error_colors(palette);
  EXPECT_GE(contrast_of(error.words, error.back), 4.5);
  EXPECT_GE(contrast_of(error.words, error.button), 4.5);
}

TEST(Theme, EveryWordOfBothThemesIsReadable) {
  expect_readable(theme::palette_of(theme::Theme::Light));
  expect_readable(theme::palette_of(theme::Theme::Dark));
  EXPECT_FALSE(theme::is_dark(theme::palette_of(theme::Theme::Light)));
  EXPECT_TRUE(theme::is_dark(theme::palette_of(theme::Theme::Dark)));
}

TEST(Theme, WhatTheWindowWritesOnTheCanvasIsReadable) {
  for (const theme::Canvas canvas : {theme::Canvas::Paper, theme::Canvas::Dark}) {
    const theme::CanvasColors& colors = theme::canvas_colors(canvas);
    EXPECT_GE(contrast_of(colors.quiet, paper_of(colors)), 4.5);
    for (const QColor& below : {QColor(Qt::white), QColor(Qt::black)})
      EXPECT_GE(contrast_of(colors.words, over(below, colors.behind_words)), 4.5);
    for (const QColor& line : {colors.drawn, colors.chosen, colors.snapped})
      EXPECT_GE(contrast_of(line, paper_of(colors)), 3.0);
  }
}

class ThemeTest : public test::WindowFixture {
 protected:
  ~ThemeTest() override {
    window.actions().trigger("theme.system");
    window.actions().trigger("canvas.theme");
    QCoreApplication::processEvents();
  }
  QImage view() {
    QCoreApplication::processEvents();
    return window.view().grabFramebuffer();
  }
};

TEST_F(ThemeTest, IsAppliedAtOnceAndRemembered) {
  open_waves();
  ASSERT_TRUE(window.actions().trigger("theme.dark"));
  EXPECT_TRUE(theme::is_dark(QApplication::palette()));
  expect_readable(QApplication::palette());
  EXPECT_TRUE(window.actions().find("theme.dark")->isChecked());
  EXPECT_TRUE(QTest::qWaitFor([&] { return theme::is_dark(window.steps().palette()); }, 1000));
  const QColor inside = window.grab().toImage().pixelColor(window.steps().mapTo(&window, QPoint(40, 120)));
  EXPECT_LT(luminance_of(inside), 0.1);
  {
    const MainWindow another(program);
    EXPECT_TRUE(theme::is_dark(QApplication::palette()));
  }
  ASSERT_TRUE(window.actions().trigger("theme.light"));
  EXPECT_FALSE(theme::is_dark(QApplication::palette()));
  ASSERT_TRUE(window.actions().trigger("theme.system"));
  EXPECT_EQ(QApplication::palette(), theme::palette_of(theme::Theme::System));
}

/// What was typed is neither lost nor shown in the colours of before.
TEST_F(ThemeTest, AFormThatIsBeingFilledInTakesTheNewColours) {
  open_waves();
  write("count", "7");
  ASSERT_TRUE(window.actions().trigger("theme.dark"));
  // The form is made anew behind the change of the palette.
  ASSERT_TRUE(QTest::qWaitFor([&] { return theme::is_dark(editor("note")->palette()); }, 5000));
  EXPECT_EQ(*window.session().document().steps[0].params.find("count"), scenario::Value(std::int64_t{7}));
  for (const char* key : {"count", "note"}) {
    const QPalette shown = editor(key)->palette();
    EXPECT_GE(contrast_of(shown.color(QPalette::Text), shown.color(QPalette::Base)), 4.5) << key;
    EXPECT_TRUE(theme::is_dark(shown)) << key;
  }
}

/// Of the widgets that show words, those whose lightest and darkest pixels are not 4.5 apart.
QStringList unreadable(MainWindow& window) {
  QStringList found;
  const QImage image = window.grab().toImage();
  for (const QWidget* each : window.findChildren<QWidget*>()) {
    QString words;
    if (const auto* label = qobject_cast<const QLabel*>(each)) words = label->text();
    if (const auto* line = qobject_cast<const QLineEdit*>(each))
      words = line->text().isEmpty() ? line->placeholderText() : line->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(each)) {
      const auto* tool = qobject_cast<const QToolButton*>(each);
      if (tool == nullptr || tool->toolButtonStyle() != Qt::ToolButtonIconOnly) words = button->text();
    }
    if (const auto* box = qobject_cast<const QComboBox*>(each)) words = box->currentText();
    const QRect seen = each->visibleRegion().boundingRect();
    if (!each->isVisible() || words.trimmed().isEmpty() || seen.height() < 10 || seen.width() < 20) continue;
    double low = 1.0;
    double high = 0.0;
    const QPoint corner = each->mapTo(&window, seen.topLeft());
    for (int x = 2; x < seen.width() - 2; ++x) {
      for (int y = 2; y < seen.height() - 2; ++y) {
        const double l = luminance_of(image.pixelColor(corner + QPoint(x, y)));
        low = std::min(low, l);
        high = std::max(high, l);
      }
    }
    if ((high + 0.05) / (low + 0.05) < 4.5)
      found << each->metaObject()->className() + QString(" '") + words + "' " +
                   QString::number((high + 0.05) / (low + 0.05));
  }
  return found;
}

TEST_F(ThemeTest, EveryWordOnTheScreenIsReadableAlsoWhatIsWrong) {
  open_waves();
  for (const char* theme : {"theme.light", "theme.dark", "theme.system"}) {
    ASSERT_TRUE(window.actions().trigger(theme));
    QTest::qWait(50);
    window.select(1);
    write("count", "999");
    press(Qt::Key_Tab);
    settle();
    QTest::qWait(50);
    EXPECT_EQ(unreadable(window), QStringList()) << theme;
    window.error_bar().say("the wave crosses itself; move it", mending::ErrorBar::CanShow::Yes);
    QTest::qWait(50);
    EXPECT_EQ(unreadable(window), QStringList()) << theme << " with an error";
    write("count", "4");
    press(Qt::Key_Tab);
    settle();
  }
}

TEST_F(ThemeTest, AnErrorHasTheColoursOfTheThemeWhetherItWasInSightBeforeOrNot) {
  const auto is_as_the_theme = [&] {
    return QTest::qWaitFor(
        [&] {
          const QImage seen = window.error_bar().grab().toImage();
          const bool is_dark = seen.pixelColor(seen.width() / 2, 3).lightness() < 128;
          return is_dark == theme::is_dark(QApplication::palette());
        },
        2000);
  };
  for (const auto& [first, then] : {std::pair("theme.dark", "theme.light"), std::pair("theme.light", "theme.dark")}) {
    window.error_bar().clear();
    ASSERT_TRUE(window.actions().trigger(first));
    window.error_bar().say("the wave crosses itself; move it", mending::ErrorBar::CanShow::Yes);
    EXPECT_TRUE(is_as_the_theme()) << first;
    ASSERT_TRUE(window.actions().trigger(then));
    EXPECT_TRUE(is_as_the_theme()) << then << " behind " << first;
  }
}

/// The page was made in the theme before, and was hidden when the theme changed.
TEST_F(ThemeTest, TheWelcomePageIsReadableInTheThemeChosenWhileItWasHidden) {
  for (const char* theme : {"theme.dark", "theme.light"}) {
    ASSERT_TRUE(window.actions().trigger(theme));
    QTest::qWait(50);
    window.welcome();
    QTest::qWait(50);
    EXPECT_EQ(unreadable(window), QStringList()) << theme;
    window.begin_new();
  }
}

TEST_F(ThemeTest, TheCanvasGoesWithTheThemeUntilAnotherIsChosen) {
  open_waves();
  ASSERT_TRUE(window.actions().trigger("canvas.theme"));
  ASSERT_TRUE(window.actions().trigger("theme.dark"));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return view().pixelColor(3, 3) == paper_of(theme::canvas_colors(theme::Canvas::Dark)); }, 2000));
  ASSERT_TRUE(window.actions().trigger("canvas.paper"));
  EXPECT_EQ(view().pixelColor(3, 3), QColor(Qt::white));
  ASSERT_TRUE(window.actions().trigger("theme.light"));
  ASSERT_TRUE(window.actions().trigger("canvas.dark"));
  QTest::qWait(20);
  EXPECT_EQ(view().pixelColor(3, 3), paper_of(theme::canvas_colors(theme::Canvas::Dark)));
  ASSERT_TRUE(window.actions().trigger("canvas.theme"));
  EXPECT_EQ(view().pixelColor(3, 3), QColor(Qt::white));
}

/// What is not ticked is a box, not nothing.
TEST_F(ThemeTest, BoxesToTickAreSeen) {
  open_waves();
  ASSERT_TRUE(window.actions().trigger("theme.dark"));
  QTest::qWait(50);
  auto* box = window.findChild<QCheckBox*>();
  ASSERT_NE(box, nullptr);
  for (const bool on : {true, false}) {
    box->setChecked(on);
    const QImage image = box->grab().toImage();
    double lightest = 0.0;
    for (int x = 0; x < 10; ++x)
      lightest = std::max(lightest, luminance_of(image.pixelColor(x, 2 + image.height() / 2)));
    const QColor back = box->palette().color(QPalette::Window);
    EXPECT_GE((lightest + 0.05) / (luminance_of(back) + 0.05), 3.0) << on;
  }
}

TEST_F(ThemeTest, TheCanvasIsDarkByChoiceAndThePictureThatIsSavedIsNot) {
  open_waves();
  const QColor paper = view().pixelColor(3, 3);
  ASSERT_TRUE(window.save_picture(folder / "before.svg").ok());
  ASSERT_TRUE(window.actions().trigger("canvas.dark"));
  const QImage dark = view();
  EXPECT_EQ(paper, QColor(Qt::white));
  EXPECT_EQ(dark.pixelColor(3, 3), paper_of(theme::canvas_colors(theme::Canvas::Dark)));
  // Words round the plots are light now.
  double lightest = 0.0;
  const QRectF plot = window.view().plot(0);
  for (int x = 0; x < plot.left() - 2; ++x) {
    for (int y = static_cast<int>(plot.top()); y < plot.bottom(); ++y)
      lightest = std::max(lightest, luminance_of(dark.pixelColor(x, y)));
  }
  EXPECT_GT(lightest, 0.4);
  ASSERT_TRUE(window.save_picture(folder / "after.svg").ok());
  EXPECT_EQ(folder.read("before.svg"), folder.read("after.svg"));
  MainWindow another(program);
  EXPECT_EQ(another.view().colors().ground, theme::canvas_colors(theme::Canvas::Dark).ground);
  ASSERT_TRUE(window.actions().trigger("canvas.paper"));
  EXPECT_EQ(view().pixelColor(3, 3), QColor(Qt::white));
}

}  // namespace
}  // namespace dobra::gui
