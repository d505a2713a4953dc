#pragma once
// Where everything stands on the page: plots to one common scale, axes with ticks, titles, labels, legend, colour bars,
// scale bar. Both drawers draw the same layout. Text is measured, so that none is cut off or overlaps another: tick
// labels that have no room are left out, long titles go on the next line.

#include <optional>
#include <span>
#include <vector>

#include "shared/scene/layer.h"
#include "shared/scene/marks.h"
#include "shared/scene/view.h"

namespace dobra::scene {

/// Points (1/72 inch) on paper, device-independent pixels on a screen.
struct PageSize {
  double width = 720.0;
  double height = 540.0;
};

constexpr PageSize a4_landscape{841.89, 595.28};

/// The width of a file's page if nobody asks for another.
double usual_width(const Picture& picture);

/// What becomes of tables that are too long for the page of a picture on A4Landscape.
enum class LongTables { Cut, NextPages };

/// How large the plots are: as their content asks (files), or all that the page leaves (windows).
enum class Plots { ToContent, FillPage };

/// Lines over a plot at the ticks of its axes.
enum class GridLines { Off, On };

/// Compact: one line of small print.
enum class Legends { Usual, Compact, Off };

struct LayoutOptions {
  Plots plots = Plots::ToContent;
  double margin = 10.0;      ///< Blank border of the page, points.
  double text_size = 9.0;    ///< Axis titles, legend; tick labels are one point smaller, titles larger.
  double least_plot = 48.0;  ///< Width and height that a plot has at least, points.
  LongTables long_tables = LongTables::Cut;
  /// Row or Column: all panels so, whatever draws them larger.
  std::optional<Arrangement> arrangement = std::nullopt;
  GridLines grid = GridLines::Off;
  Legends legend = Legends::Usual;
};

struct PanelLayout {
  geom::Box plot;       ///< Page coordinates; layers are clipped to it.
  View view;            ///< What the plot shows.
  Transform transform;  ///< World to page.
  /// From one tick to the next, world; 0 where there are less than two.
  geom::Vector tick_step{0.0, 0.0};
};

struct Layout {
  PageSize page;                    ///< At least the one asked for: it grows rather than cut anything off.
  std::vector<PanelLayout> panels;  ///< In the order of the picture.
  std::vector<Mark> marks;          ///< Drawn in this order, over the layers: labels, frames, ticks, text, legend.
  /// LongTables::NextPages: the tables have no room here and are not drawn; table_pages has them.
  bool tables_on_next_pages = false;
};

/// @param page   a request: with Plots::ToContent the page grows where the content cannot be made small enough; with
///               FillPage it is kept, and the legend and the colour bars are left out where they would take the plots'
///               room.
/// @param views  empty, or one a panel; nothing means that the whole panel is shown. Without any, all panels share the
///               largest scale at which they fit, a page length standing for one world length in every panel.
/// @cost  O(layers + labels + marks); does not look at the geometry of layers whose panel has a view.
Layout layout(const Picture& picture, const PageSize& page, std::span<const std::optional<View>> views,
              const TextMeasure& measure, const LayoutOptions& options = {});

/// Pages of that size with all tables of a picture, in columns, and no plot.
std::vector<Layout> table_pages(const Picture& picture, const PageSize& page, const TextMeasure& measure,
                                const LayoutOptions& options = {});

/// The smallest round n for which a world in metres, drawn to 1:n, is not larger than at this scale: 1, 1.25, 1.5, 2,
/// 2.5, 3, 4, 5, 6 or 7.5 times a power of ten.  @pre points_per_metre > 0.
double round_ratio(double points_per_metre);

/// The page, not wider than `width` nor higher than 1.4 times that if it can be helped, that the picture fills; for
/// A4Landscape of that width and at most as high as the format.
PageSize suggested_page(const Picture& picture, double width, const TextMeasure& measure,
                        const LayoutOptions& options = {});

}  // namespace dobra::scene
