#pragma once
// What stands on the page round and over the plots: plain primitives in page coordinates (points, y down), the same for
// every drawer, so that a window and a file look alike. Also how a drawer says how large its text is.

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shared/scene/layer.h"

namespace dobra::scene {

enum class Weight { Regular, Bold };

struct Font {
  double size = 9.0;  ///< Points from baseline to baseline, nominally.
  Weight weight = Weight::Regular;
};

/// Points; height of a line of text is ascent + descent of its font, whatever letters it has.
struct TextSize {
  double width = 0.0;
  double ascent = 0.0;
  double descent = 0.0;
  [[nodiscard]] double height() const { return ascent + descent; }
};

/// Size of one line of UTF-8 text as a drawer will draw it.
using TextMeasure = std::function<TextSize(std::string_view text, const Font& font)>;

/// Sizes that are right within some 20 %, for tests and for estimates without a drawer.
TextMeasure approximate_text_measure();

struct LineMark {
  geom::Point from;
  geom::Point to;
  Color color{};
  double width = 0.75;
  Dash dash = Dash::Solid;
};

struct BoxMark {
  geom::Box box;
  std::optional<Color> fill;
  Color line{};
  double line_width = 0.0;  ///< 0: no outline.
  Pattern pattern = Pattern::None;
};

struct DiscMark {
  geom::Point centre;
  double diameter = 5.0;
  Color fill{};
};

struct TriangleMark {
  std::array<geom::Point, 3> corners;
  Color fill{};
  double seam = 0.0;  ///< In files it is grown by half of this, so that no paper shines between neighbours.
};

/// A box filled with a colour map.
struct GradientMark {
  geom::Box box;
  ColorMapName map = ColorMapName::Viridis;
  enum class Direction { Right, Up } direction = Direction::Up;  ///< From the low end to the high one.
};

/// One line of text, the middle of its box at `at`.
struct TextMark {
  geom::Point at;
  std::string text;
  Font font{};
  Color color{};
  enum class Turn { None, Up } turn = Turn::None;  ///< Up: reads from the bottom to the top.
  TextSize size{};                                 ///< As measured.
};

using Mark = std::variant<LineMark, BoxMark, DiscMark, TriangleMark, GradientMark, TextMark>;

/// `text` fit for drawing: bytes that are not UTF-8 and control characters become U+FFFD.
std::string readable(std::string_view text);

/// Page box of a mark: of a text, all of its line.
geom::Box box_of(const Mark& mark);

/// The mark moved by a page vector.
Mark moved(Mark mark, geom::Vector by);

/// Lengths of the strokes and gaps of a line, points, in turn; empty for a solid one.
std::vector<double> dash_lengths(Dash dash, double line_width);

/// The strokes of a dashed line inside `window`; a stroke that turns a corner comes as one segment a side.
/// @param pattern  dash_lengths of a line that is not solid, in the units of the line; all > 0.
/// @cost  O(points + strokes in the window).
std::vector<geom::Segment> strokes_of(const geom::Polyline& line, const std::vector<double>& pattern,
                                      const geom::Box& window);

/// Fractions [from, to] of a segment that lie in a box (Liang-Barsky); false if none does.
bool part_inside(const geom::Segment& segment, const geom::Box& box, double& from, double& to);

/// `text` in lines not wider than `width` points, broken at spaces; a word that is wider still stands alone, and `font`
/// is made small enough for it.
std::vector<std::string> wrapped(const std::string& text, double width, Font& font, const TextMeasure& measure);

}  // namespace dobra::scene
