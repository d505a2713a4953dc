#pragma once
// The display list: what a model looks like, as plain data. Copies of a picture share its lines, areas and meshes. VTK
// draws it in the window and off-screen, cairo writes it as SVG, PDF and PNG, tests read it. It knows nothing of any
// drawer.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "shared/base/shared.h"
#include "shared/geom/box.h"
#include "shared/geom/polyline.h"

namespace dobra::scene {

/// sRGB, 0..255 each; alpha 255 is opaque.
struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  std::uint8_t alpha = 255;
  friend bool operator==(const Color&, const Color&) = default;
};

enum class Dash { Solid, Dashed, Dotted };

/// What is drawn over the fill of regions, in thin dark lines: the usual signs of rocks (pattern.h).
enum class Pattern { None, Dots, Bricks, Dashes, Hatch, BackHatch, CrossHatch, Circles, Crosses, Vees };

/// Sizes are typographic points (1/72 inch) on paper and device-independent pixels on a screen.
struct Style {
  Color line{};             ///< Colour of lines, outlines, markers and text.
  double line_width = 1.0;  ///< 0 draws no line.
  Dash dash = Dash::Solid;
  std::optional<Color> fill = std::nullopt;  ///< Interior of regions.
  double marker_size = 5.0;                  ///< Diameter of markers.
  double text_size = 9.0;
  Pattern pattern = Pattern::None;  ///< Over the interior of regions.
  friend bool operator==(const Style&, const Style&) = default;
};

/// Open or closed lines. Item i of every content has the identity `ids[i]`, or i where ids is empty.
struct Lines {
  base::Shared<std::vector<geom::Polyline>> lines{};
  std::vector<std::uint32_t> ids{};
  friend bool operator==(const Lines&, const Lines&) = default;
};

struct Markers {
  std::vector<geom::Point> points{};
  std::vector<std::uint32_t> ids{};
  friend bool operator==(const Markers&, const Markers&) = default;
};

/// One filled area: contours under the even-odd rule.
struct Region {
  std::vector<geom::Polyline> contours{};
  friend bool operator==(const Region&, const Region&) = default;
};

struct Regions {
  base::Shared<std::vector<Region>> regions{};
  std::vector<std::uint32_t> ids{};
  friend bool operator==(const Regions&, const Regions&) = default;
};

enum class ColorMapName {
  Viridis,
  Cividis,
  CoolWarm,
  Quality
};  ///< Quality: red (bad) over yellow to blue-green (good).

/// Log10: numbers are decimal logarithms, ticks say of what. Diagram: the axes are no lengths. None: a frame without
/// ticks. Only linear axes have a scale bar.
enum class AxisScale { Linear, Log10, Diagram, None };

/// How numbers become colours; values outside the range take its ends.
struct Scale {
  std::string title{};  ///< Such as "alpha" or "sigma_x [MPa]"; stands above the colour bar.
  ColorMapName map = ColorMapName::Viridis;
  double low = 0.0;
  double high = 1.0;
  AxisScale ticks = AxisScale::Linear;
  /// Of the values, where they are to be said at the ends of the bar; an end that they pass is an arrow.
  std::optional<double> least = std::nullopt, greatest = std::nullopt;
  friend bool operator==(const Scale&, const Scale&) = default;
};

enum class ValuesAt { None, Triangles, Points };

/// A triangle mesh, its triangles filled by value (or by style.fill) and outlined with style.line.
struct Mesh {
  base::Shared<std::vector<geom::Point>> points{};
  base::Shared<std::vector<std::array<std::uint32_t, 3>>> triangles{};
  ValuesAt values_at = ValuesAt::None;
  base::Shared<std::vector<double>> values{};
  Scale scale{};
  base::Shared<std::vector<std::uint32_t>> ids{};  ///< One a triangle.
  friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// Where the text stands with respect to its point. Callout: in the nearest room where it hides no line of the legend,
/// no marker and no other label, at the end of a leader.
enum class Anchor { Centre, Left, Right, Above, Below, Callout };

struct Label {
  geom::Point at;
  std::string text{};
  Anchor anchor = Anchor::Centre;
  std::optional<double> value = std::nullopt;  ///< Written behind the text, in the unit of the panel's colours.
  friend bool operator==(const Label&, const Label&) = default;
};

struct Labels {
  std::vector<Label> labels{};
  friend bool operator==(const Labels&, const Labels&) = default;
};

/// A picture of width * height pixels, row by row from the top, four bytes each: red, green, blue, opacity.
struct Pixels {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> rgba{};
};

/// Pixels stretched over a box of the world: a scanned section, a seismic line.
struct Image {
  std::shared_ptr<const Pixels> pixels{};
  geom::Box box{};
  double opacity = 1.0;  ///< 0 .. 1, times that of the pixels.
  friend bool operator==(const Image&, const Image&) = default;
};

enum class InLegend { Yes, No };

struct Layer {
  std::string key{};    ///< Stable, unique in its panel: "source_grid". Visibility and picks refer to it.
  std::string title{};  ///< As shown in the tree of layers and the legend; translated.
  Style style{};
  std::variant<Lines, Markers, Regions, Mesh, Labels, Image> content;
  bool visible = true;
  InLegend in_legend = InLegend::Yes;
  /// What the legend calls it, once for all layers of that name and style: the unit of several pieces. Empty: title.
  std::string legend{};
};

/// What the legend calls a layer.
inline const std::string& legend_name(const Layer& layer) { return layer.legend.empty() ? layer.title : layer.legend; }

/// What an axis says instead of its lengths: degrees round a cylinder that is drawn as it is unrolled.
struct Reading {
  std::string title{};    ///< As "u [\u00b0]".
  double at_zero = 0.0;   ///< What stands at world coordinate 0.
  double per_unit = 1.0;  ///< How much more that is a world length of 1 farther; not 0.
  [[nodiscard]] double of(double world) const { return at_zero + per_unit * world; }
  [[nodiscard]] double to_world(double read) const { return (read - at_zero) / per_unit; }
};

struct Axes {
  std::string x_title = "x [m]";
  std::string y_title = "y [m]";
  AxisScale scale = AxisScale::Linear;
  double unit = 1.0;  ///< World lengths in one unit of linear ticks and of the scale bar: 1000 for "x [km]".
  /// Of linear axes: ticks and title are these, lengths go by the titles above.
  std::optional<Reading> x_reading = std::nullopt, y_reading = std::nullopt;
};

/// One view on a plane, drawn to scale (no exaggeration unless stated).
struct Panel {
  std::string key{};
  std::string title{};
  Axes axes{};
  std::vector<Layer> layers{};                     ///< Drawn in this order, the last on top.
  double vertical_exaggeration = 1.0;              ///< Display only; stated beside the axes when not 1.
  std::optional<geom::Box> extent = std::nullopt;  ///< What to show; by default all of the visible layers.
  std::string left_end{};                          ///< Stands over the left end of the plot: "W".
  std::string right_end{};
};

/// Grid: as many rows and columns as make the panels largest.
enum class Arrangement { Row, Column, Grid };

/// Words and numbers in rows, shown below the plots of a file; windows show them elsewhere.
struct TextTable {
  std::string title{};
  std::vector<std::string> columns{};
  std::vector<std::vector<std::string>> rows{};  ///< As many cells as columns.
};

/// A4Landscape: the page is never higher than that format for its width (usually that of A4), whatever there is to
/// tell; the scale is a round 1:n for a world in metres, and stated; long legends and tables are cut.
enum class Paper { ToContent, A4Landscape };

/// All panels of a picture share one scale, so that lengths compare across them.
struct Picture {
  std::string title{};
  std::vector<Panel> panels{};
  Arrangement arrangement = Arrangement::Row;
  /// A true scale, points on the page for a world unit along x: the page takes the size that it needs. Of files only;
  /// by default the content is made as large as the page allows.
  std::optional<double> points_per_unit = std::nullopt;
  std::vector<TextTable> tables{};   ///< Below the legend, in files only.
  std::vector<std::string> notes{};  ///< One line each (wrapped), below the tables.
  Paper paper = Paper::ToContent;    ///< Of files only.
};

/// Whether there is nothing in a layer. @cost O(1) where there is something
bool is_empty(const Layer& layer);

/// Smallest box round everything in a layer, visible or not; empty if there is nothing.
geom::Box extent(const Layer& layer);

/// Smallest box round the visible layers of a panel, or its `extent` where given; empty if there is nothing.
geom::Box extent(const Panel& panel);

}  // namespace dobra::scene
