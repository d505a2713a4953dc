#pragma once
// The parts of a page that stand round the plots, each made by itself at the origin and then moved to its place.
// Internal to scene: layout.h is what callers use.

#include <optional>
#include <string>
#include <vector>

#include "shared/scene/layout.h"
#include "shared/scene/names.h"
#include "shared/scene/ticks.h"

namespace dobra::scene {

constexpr Color ink{38, 38, 42};
constexpr Color frame_color{96, 96, 102};
constexpr Color grid_color{70, 80, 95, 70};
constexpr double tick_length = 4.0;
constexpr double tick_gap = 3.0;  ///< Between a tick and its label, and a label and an axis title.

/// Marks with their upper left corner at (0, 0).
struct Furniture {
  std::vector<Mark> marks;
  double width = 0.0;
  double height = 0.0;
};

/// A text mark with its size measured.
TextMark text_mark(const std::string& text, geom::Point middle, const Font& font, const TextMeasure& measure,
                   TextMark::Turn turn = TextMark::Turn::None);

/// Lines of text under each other, centred in their width.
Furniture heading(const std::string& text, double width, Font font, const TextMeasure& measure);

/// The same turned to read upwards, its lines from left to right, in a height of `height`.
Furniture turned_heading(const std::string& text, double height, Font font, const TextMeasure& measure);

enum class SmallPrint { No, Yes };

/// Visible layers of all panels with their swatches, in columns; identical entries once. Where there is not room for
/// all, in small print if that is allowed, and the last place says how many are left out. Empty if there are none.
Furniture legend(const Picture& picture, const PageSize& room, const Font& font, const TextMeasure& measure,
                 SmallPrint small_print);

/// The different scales of the visible meshes with values of a panel, in order of appearance.
std::vector<Scale> scales_of(const Panel& panel);
bool same_scales(const std::vector<Scale>& a, const std::vector<Scale>& b);

/// Whether there are values above or below the colours of a scale; the bar ends in an arrow there.
bool passes_high(const Scale& scale);
bool passes_low(const Scale& scale);

/// A vertical colour bar: its title above it, the bar `height` points high without its arrows, ticks at its right, and
/// the least and the greatest value where the scale has them.
/// @param[out] title_height  how far below the top of the furniture the bar begins.
Furniture color_bar(const Scale& scale, double height, const Font& font, const TextMeasure& measure,
                    double& title_height);

/// Bars side by side, begun at one height, with a gap before each.
struct ColorBars {
  Furniture all;
  double title_height = 0.0;  ///< How far below the top the bars begin.
};
ColorBars color_bars(const std::vector<Scale>& scales, double height, const Font& font, const TextMeasure& measure);

/// Four digits, with a true minus sign and a short exponent: "2.15", "4e6".
std::string short_number(double value);

/// The text of a label with its value.
std::string text_of(const Label& label);

/// A bar of a round length, at most 100 points long, with that length beside it.
/// @param unit   such as "m"; may be empty.
/// @param ratio  such as "1:25 000", stands beside it; may be empty.
Furniture scale_bar(double points_per_unit, const std::string& unit, const std::string& ratio, const Font& font,
                    const TextMeasure& measure);

/// "m" of "x [m]"; empty if there are no brackets.
std::string unit_of(const std::string& axis_title);

/// The labels of the visible layers of a panel that have room in its plot: none is cut off, none overlaps another.
/// Names beside ends come first, then the labels of the topmost layer; a name that had to move has a line to its end.
void add_labels(const Panel& panel, const PanelLayout& place, const TextMeasure& measure, std::vector<Mark>& marks);

/// The labels with Anchor::Callout; they keep out of `taken` and of each other. One that has no room is left out.
/// @cost O(labels times lines of the layers in the legend)
void add_callouts(const Panel& panel, const PanelLayout& place, const TextMeasure& measure,
                  std::vector<geom::Box> taken, std::vector<Mark>& marks);

/// Where the names beside the ends of lines would stand between two heights; those wider than `widest` are left out.
std::vector<std::optional<geom::Box>> places_of_names(const Panel& panel, const Transform& transform, double widest,
                                                      double low, double high, const TextMeasure& measure);

/// The letters of a panel over the corners of its plot.
void add_end_letters(const Panel& panel, const geom::Box& plot, const Font& font, const TextMeasure& measure,
                     std::vector<Mark>& marks);

/// Faint lines across a plot at the ticks.
void add_grid(const PanelLayout& place, const std::vector<Tick>& x_ticks, const std::vector<Tick>& y_ticks,
              std::vector<Mark>& marks);

/// Frame, ticks and tick labels of a plot. Labels stand left of it and below it.
void add_axes(const PanelLayout& place, const std::vector<Tick>& x_ticks, const std::vector<Tick>& y_ticks,
              const Font& font, const TextMeasure& measure, std::vector<Mark>& marks);

}  // namespace dobra::scene
