#pragma once
// Colours of rock units: a palette that repeats after many, which unit a piece belongs to, and tables of colours that
// users give (a geological survey's, or a paper's).

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shared/scene/layer.h"

namespace dobra::scene {

/// How a unit is drawn if nobody says.
struct UnitStyle {
  Color fill;
  Color line;  ///< The same hue, dark enough for lines and text on white.
  Pattern pattern = Pattern::None;
};

/// Number 0, 1, 2 ... in stratigraphic order, or in that of names. 36 fills are told apart by colour, the first twelve
/// also by those who do not see red and green alike; then they come again with patterns, 216 in all.
UnitStyle unit_style(std::size_t number);

/// The units that these names are of, in their order: "K2p" of "K2p_1" and "K2p_2", or of "K2p" and "K2p (2)". A name
/// without fellows is its own; so are "unit_1" and "unit_2", and names that would all be one unit.
std::vector<std::string> whole_names(std::span<const std::string> names);

/// The place of each name among all different ones in alphabetical order: the number for unit_style.
std::vector<std::size_t> numbers_of(std::span<const std::string> names);

/// What a table of colours says of one unit or line.
struct ColorEntry {
  std::string name;
  std::optional<Color> color = std::nullopt;
  std::optional<Pattern> pattern = std::nullopt;  ///< Else that of the lithology.
  std::string age{};
  std::string lithology{};
};

struct ColorTable {
  std::vector<ColorEntry> entries;  ///< Names differ.
};

/// "#1a2b3c", "#abc", "26, 43, 60" or a common name such as "orange".
std::optional<Color> color_of_text(const std::string& text);
/// "none", "dots", "bricks", "dashes", "hatch", "back_hatch", "cross_hatch", "circles", "crosses", "vees".
std::span<const std::string> pattern_names();
std::optional<Pattern> pattern_of_text(const std::string& text);
/// The usual sign of a rock, from the words for it; None for words that it does not know.
Pattern pattern_of_lithology(const std::string& words);

/// The entry for something of that name: its own, that of the unit that it is a piece of, or of the first name in
/// "A - B", the rock below A. Null if there is none.
const ColorEntry* entry_for(const ColorTable& table, const std::string& name, const std::string& whole);

/// Draws the layers as the table says; ages and lithologies go to the legend. Layers that it does not name stay.
void paint(Picture& picture, const ColorTable& table);

/// What is to be said of names that only one of the two has, one line each; empty if there are none.
std::vector<std::string> remarks_on(const ColorTable& table, std::span<const std::string> names);

}  // namespace dobra::scene
