#include "shared/gui/view/settings.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <cmath>
#include <limits>

namespace dobra::gui::view {
namespace {

scene::Panel section(geom::Box extent) { return {.key = "section", .axes = {"x [m]", "z [m]"}, .extent = extent}; }

TEST(ViewSettings, WhatIsNoExaggerationIsRefusedAndSaysWhatIs) {
  for (const char* typed : {"", "x", "zero", "0", "-5", "nan", "inf", "1e9", "0.001", "5 5", "1,2,3"}) {
    const auto read = exaggeration_from(typed);
    ASSERT_FALSE(read.ok()) << typed;
    EXPECT_NE(read.error().message.find("0.01 to 10000"), std::string::npos) << read.error().message;
  }
}

TEST(ViewSettings, AnExaggerationIsReadWithItsSignAndWithEitherMark) {
  for (const char* typed : {"2.5", "2,5", " 2.5x", "2.5 X", "2,5×"}) {
    const auto read = exaggeration_from(QString::fromUtf8(typed));
    ASSERT_TRUE(read.ok()) << typed;
    EXPECT_EQ(*read, 2.5);
  }
  EXPECT_EQ(*exaggeration_from("1000"), 1000.0);
}

TEST(ViewSettings, FillingIsFiniteForWhateverThereIsToShow) {
  const geom::Box plot{{0, 0}, {800, 400}};
  const double huge = std::numeric_limits<double>::max();
  const geom::Box boxes[] = {{{0, 0}, {0, 0}},        {{0, 0}, {1000, 0}},   {{5, -3}, {5, 100}},
                             {{-huge, 0}, {huge, 1}}, {{0, 0}, {1e-300, 1}}, {},
                             {{0, 0}, {NAN, 1}}};
  for (const geom::Box& box : boxes) {
    const scene::Panel panel = section(box);
    const double filling = that_fills({&panel, 1}, {&plot, 1});
    EXPECT_TRUE(filling >= 1.0 && filling <= most_exaggeration) << filling;
  }
  EXPECT_EQ(that_fills({}, {}), 1.0);
}

TEST(ViewSettings, AThinSectionFillsItsPlotAndAnotherIsNotFlattened) {
  const geom::Box plot{{100, 20}, {900, 420}};  // twice as wide as high
  const scene::Panel thin = section({{0, 0}, {100000, 2000}});
  EXPECT_EQ(that_fills({&thin, 1}, {&plot, 1}), 25.0);
  const scene::Panel tall = section({{0, 0}, {100, 2000}});
  EXPECT_EQ(that_fills({&tall, 1}, {&plot, 1}), 1.0);
  const scene::Panel both[] = {thin, section({{0, 0}, {100000, 4000}})};
  const geom::Box plots[] = {plot, plot};
  EXPECT_EQ(that_fills(both, plots), 12.0);  // 12.5, and no more than two digits
}

TEST(ViewSettings, AxesAreShownInAnotherUnitAndDiagramsAreLeftAlone) {
  const scene::Axes metres{"x [m]", "z [m]"};
  const scene::Axes feet = axes_in(metres, Unit::Foot);
  EXPECT_EQ(feet.x_title, "x [ft]");
  EXPECT_EQ(feet.y_title, "z [ft]");
  EXPECT_EQ(feet.unit, 0.3048);
  const scene::Axes kilometres = axes_in({"x [km]", "z [km]", scene::AxisScale::Linear, 1000.0}, Unit::Metre);
  EXPECT_EQ(kilometres.x_title, "x [m]");
  EXPECT_EQ(kilometres.unit, 1.0);
  const scene::Axes specimen = axes_in({"x [mm]", "y [mm]"}, Unit::Metre);
  EXPECT_EQ(specimen.unit, 1000.0);
  const scene::Axes diagram{"distance [m]", "slip [m]", scene::AxisScale::Diagram};
  EXPECT_EQ(axes_in(diagram, Unit::Foot).x_title, "distance [m]");
  for (const char* title : {"", "x", "x [", "x ]", "x [furlong]", "alpha [-]"}) {
    const scene::Axes odd{title, title};
    EXPECT_EQ(axes_in(odd, Unit::Kilometre).x_title, title);
    EXPECT_EQ(axes_in(odd, Unit::Kilometre).unit, 1.0);
  }
}

TEST(ViewSettings, AllButTheExaggerationIsKept) {
  const QTemporaryDir folder;
  QSettings kept(folder.filePath("kept.ini"), QSettings::IniFormat);
  EXPECT_EQ(remembered(kept), Settings{});
  Settings wanted{.exaggeration = 5.0,
                  .panels = Panels::Column,
                  .linked = Linked::Yes,
                  .grid = scene::GridLines::On,
                  .legend = scene::Legends::Compact,
                  .unit = Unit::Foot};
  remember(wanted, kept);
  wanted.exaggeration = 1.0;
  EXPECT_EQ(remembered(kept), wanted);
  kept.setValue("view/panels", "upside down");
  EXPECT_EQ(remembered(kept).panels, Panels::AsFits);
}

}  // namespace
}  // namespace dobra::gui::view
