#pragma once
// The tools of a canvas: what the mouse and the keys do. A tool knows nothing of a window: it is told where the cursor
// is in the world, says what to draw over the picture, and hands out changes. Page: docs/user/canvas.md.

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "shared/canvas/change.h"

namespace dobra::canvas {

enum class Modifier { None, Add, Toggle };  ///< Add: Shift; Toggle: Ctrl.

struct Pointer {
  geom::Point at;                           ///< Under the cursor.
  std::optional<Snap> snap = std::nullopt;  ///< Where it is drawn to.
  Modifier modifier = Modifier::None;
  double reach = 0.0;  ///< How far "there" reaches, m along x.
  double exaggeration = 1.0;
  [[nodiscard]] geom::Point place() const { return snap ? snap->at : at; }
};

enum class Key { Enter, Escape, Backspace, Delete };

enum class Cursor { Arrow, Cross, Hand, Magnifier };

/// Drawn over the picture while a tool works.
struct Overlay {
  std::vector<geom::Polyline> lines{};
  std::vector<geom::Polyline> chosen{};  ///< What is selected.
  std::vector<geom::Point> handles{};
  std::vector<geom::Point> chosen_handles{};
  struct Text {
    geom::Point at;
    std::string text;
  };
  std::vector<Text> texts{};
};

class Tool {
 public:
  virtual ~Tool() = default;
  /// What to do next, translated.
  [[nodiscard]] virtual std::string hint() const = 0;
  [[nodiscard]] virtual Cursor cursor() const { return Cursor::Cross; }
  /// Whether the cursor is drawn to what is there.
  [[nodiscard]] virtual bool snaps() const { return true; }
  /// Lines that move now, to which the cursor is not drawn.
  [[nodiscard]] virtual std::set<scene::Pick> moving() const { return {}; }

  virtual void press(Workspace& work, const Pointer& pointer) = 0;
  virtual void move(Workspace& work, const Pointer& pointer) = 0;
  virtual void release(Workspace&, const Pointer&) {}
  /// After press and release of the second click.
  virtual void double_click(Workspace&, const Pointer&) {}
  /// @return whether the tool had a use for it.
  virtual bool key(Workspace&, Key) { return false; }
  /// Another tool is taken up: what can be finished is.
  virtual void put_down(Workspace&) {}
  /// Undo belongs to what is being made before it belongs to the document.
  [[nodiscard]] virtual bool unfinished() const { return last().has_value(); }
  /// The last point, or where there is none to take, all that is unfinished. @return false if nothing is.
  bool take_back(Workspace& work) { return unfinished() && (key(work, Key::Backspace) || key(work, Key::Escape)); }

  /// The last place of what is being made: perpendicular, angles and typed places need it.
  [[nodiscard]] virtual std::optional<geom::Point> last() const { return std::nullopt; }
  /// The place that a typed number alone means, where that is no length towards the cursor.
  [[nodiscard]] virtual std::optional<geom::Point> place_of_number(double) const { return std::nullopt; }
  [[nodiscard]] virtual Overlay overlay(const Workspace& work) const = 0;

  /// What has happened since it was asked last.
  std::vector<Change> take() { return std::exchange(changes_, {}); }

 protected:
  void say(Change change) { changes_.push_back(std::move(change)); }

 private:
  std::vector<Change> changes_;
};

enum class Drawing { Line, Polygon, Rectangle, Circle, Point };

std::unique_ptr<Tool> make_select_tool();
std::unique_ptr<Tool> make_draw_tool(Drawing drawing);
std::unique_ptr<Tool> make_measure_tool();

std::unique_ptr<Tool> make_hand_tool();
std::unique_ptr<Tool> make_zoom_tool();

/// Waits for one click, snaps on the way, and says Pointed, or NotPointed at Escape.
/// @param hint  what is to be clicked, translated.
std::unique_ptr<Tool> make_point_tool(std::string hint);

enum class LineWork { InsertVertex, Split, Join, Extend, Trim };
std::unique_ptr<Tool> make_line_tool(LineWork work);

enum class Carrying { Move, Rotate, Mirror, Copy };
/// Works on what is selected.
std::unique_ptr<Tool> make_carry_tool(Carrying carrying);

/// The outline of what is selected, with its vertices as handles.
void show_selection(const Workspace& work, Overlay& overlay);

/// Length and direction of a way: "125.3 m, dip 30.2°" (below the horizontal, to the side where it falls) or "125.3 m,
/// angle -30.2°" (from the first axis, anticlockwise). Here and in all that is shown beside the cursor, decimals stand
/// behind the user's mark.
std::string measure_text(geom::Point from, geom::Point to, const LengthUnit& unit = {},
                         Direction direction = Direction::Dip);

/// Why a line cannot be edited, and where it can.
std::string made_by_a_step();

}  // namespace dobra::canvas
