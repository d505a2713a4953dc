#pragma once
// The picture in space as plain data, as layer.h is the one of the plane: lines, triangle surfaces, markers, labels,
// and sections hung on their traces. VTK draws it in the window and off-screen, cairo as SVG, PDF and PNG, tests read
// it.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shared/base/shared.h"
#include "shared/geom/box3.h"
#include "shared/scene/layer.h"
#include "shared/scene/space/camera.h"

namespace dobra::scene::space {

/// Open lines; a closed one repeats its first point. Item i of every content has the identity `ids[i]`, or i where ids
/// is empty.
struct Lines {
  base::Shared<std::vector<std::vector<geom::Point3>>> lines{};
  std::vector<std::uint32_t> ids{};
  friend bool operator==(const Lines&, const Lines&) = default;
};

struct Markers {
  std::vector<geom::Point3> points{};
  std::vector<std::uint32_t> ids{};
  friend bool operator==(const Markers&, const Markers&) = default;
};

/// Triangles, filled by value, by their own colours or by style.fill, and outlined with style.line. Items are
/// triangles.
struct Surface {
  base::Shared<std::vector<geom::Point3>> points{};
  base::Shared<std::vector<std::array<std::uint32_t, 3>>> triangles{};
  ValuesAt values_at = ValuesAt::None;
  base::Shared<std::vector<double>> values{};
  Scale scale{};
  base::Shared<std::vector<Color>> colors{};  ///< One a triangle, where there are no values; empty: style.fill.
  base::Shared<std::vector<geom::Point>>
      chart{};  ///< One a point: its place in the parameter plane; empty: there is none.
  base::Shared<std::vector<std::uint32_t>> ids{};
  friend bool operator==(const Surface&, const Surface&) = default;
};

struct Label {
  geom::Point3 at;
  std::string text{};
  Anchor anchor = Anchor::Centre;
  friend bool operator==(const Label&, const Label&) = default;
};

struct Labels {
  std::vector<Label> labels{};
  friend bool operator==(const Labels&, const Labels&) = default;
};

/// A section on its vertical curtain: x of the section runs along the trace, y of the section is z.
/// Its layers are shown where they are visible; patterns and callouts are not.
struct Curtain {
  std::vector<geom::Point> trace{};  ///< Seen from above, m; at least two points.
  double first = 0.0;                ///< x of the section at the first point of the trace.
  Panel section{};
};

struct Layer {
  std::string key{};    ///< Stable, unique. Visibility and picks refer to it.
  std::string title{};  ///< As shown in the tree of layers and the legend; translated.
  Style style{};        ///< line_width 0: no edges of triangles.
  std::variant<Lines, Markers, Surface, Labels, Curtain> content;
  bool visible = true;
  InLegend in_legend = InLegend::Yes;
  std::string legend{};                            ///< What the legend calls it; empty: title.
  base::Shared<std::vector<std::string>> names{};  ///< What its items are called, by their identities; empty: numbers.
};

/// Goes with the viewer. A face that it falls on squarely has its own colour, one that it does not reach `ambient` of
/// it.
struct Light {
  double ambient = 0.45;                    ///< 0 .. 1; 1: all faces have their own colour.
  geom::Vector3 from{-0.35, 0.55, 0.7583};  ///< To the right, upwards, towards the viewer; a unit vector.
  friend bool operator==(const Light&, const Light&) = default;
};

enum class AxesBox { Shown, Hidden };

struct Axes {
  std::string x_title = "x [m]";
  std::string y_title = "y [m]";
  std::string z_title = "z [m]";
  double unit = 1.0;             ///< World lengths in one unit of the ticks: 1000 for "x [km]".
  AxesBox box = AxesBox::Shown;  ///< Three edges of the box of the picture, with ticks.
  friend bool operator==(const Axes&, const Axes&) = default;
};

struct SpacePicture {
  std::string title{};
  std::vector<Layer> layers{};
  Axes axes{};
  Light light{};
  double vertical_exaggeration = 1.0;               ///< Of the view only; stated below it when not 1.
  Camera camera{};                                  ///< How it is looked at first.
  std::optional<geom::Box3> extent = std::nullopt;  ///< What to show; by default all of the visible layers.
  std::vector<TextTable> tables{};                  ///< Below the legend, in files only.
  std::vector<std::string> notes{};
};

/// The identity of an item.
template <class Ids>
std::uint32_t id_of(const Ids& ids, std::size_t item) {
  return item < ids.size() ? ids[item] : static_cast<std::uint32_t>(item);
}

/// Smallest box round everything in a layer, visible or not; empty if there is nothing. @cost O(points)
geom::Box3 extent(const Layer& layer);

/// Its `extent` where given, else that of the visible layers; if there is nothing in them, of all; a cube of 1 m where
/// that is nothing too.
geom::Box3 extent(const SpacePicture& picture);

/// The layer with its curtain as lines, surfaces, markers and labels in space: as many layers as its section has, with
/// keys "LAYER/SECTION_LAYER"; any other layer alone, as it is. An image becomes a surface of as many cells as it has
/// pixels, 128 a side at most.
/// @cost O(points + triangles times bends of the trace)
std::vector<Layer> unrolled(const Layer& layer);

/// All layers of a picture, unrolled, in their order. @cost copies share their points
std::vector<Layer> unrolled(const SpacePicture& picture);

/// The planar picture that has the same title, legend, colour scales, tables and notes, and nothing drawn: what the
/// layout and the tree of layers go by. Its panel has the key "space".
Picture described(const SpacePicture& picture);

inline constexpr const char* panel_key = "space";

/// Areas of a curtain are a surface of the layer's key and lines of that key with this behind it: one layer to the
/// user.
inline constexpr std::string_view outline_end = ".outline";
/// The line along which a plane cuts a surface (cut.h).
inline constexpr std::string_view cut_end = ".cut";
/// The area with which a plane closes what it has cut of a solid.
inline constexpr std::string_view cap_end = ".cap";
/// The key of the layer that the user knows.
constexpr std::string_view known_key(std::string_view layer) {
  for (const std::string_view end : {outline_end, cut_end, cap_end}) {
    if (layer.ends_with(end)) return layer.substr(0, layer.size() - end.size());
  }
  return layer;
}

}  // namespace dobra::scene::space
