#pragma once
// What a tool of the canvas hands out: edits, what was drawn, words, and what is to be seen. Page: docs/user/canvas.md.

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "shared/canvas/workspace.h"

namespace dobra::canvas {

enum class Shape { Line, Polygon, Point };

/// Something new; the program asks what it is.
struct Drawn {
  Shape shape = Shape::Line;
  geom::Polyline line;
  std::string name{};  ///< What it was called where it comes from.
};

enum class Stage { During, Done };

/// Changed lines. During a gesture only to look at; all of one gesture is one step of undo.
struct Edited {
  std::vector<scene::LineEdit> lines;
  std::string what;  ///< For the Undo menu, translated.
  Stage stage = Stage::Done;
};

/// The gesture has been given up: what was shown during it goes.
struct Dropped {};

/// Why something cannot be done, for the status bar.
struct Told {
  std::string message;
};

/// What only the user can decide: each answer is an edit.
struct Asked {
  std::string question;
  std::vector<std::pair<std::string, Edited>> answers;
};

/// Another part is to be seen: all of the box, `factor` times nearer where that has no size.
struct LookedAt {
  geom::Box box;
  double factor = 1.0;
};

/// Select is to be taken up again.
struct PutAway {};

/// A place that something outside the canvas has asked for.
struct Pointed {
  geom::Point at;                                  ///< With the snap.
  geom::Point under;                               ///< Under the cursor, without it.
  std::optional<scene::Pick> line = std::nullopt;  ///< That lies there.
};

/// What was asked for is not wanted any more.
struct NotPointed {};

using Change = std::variant<Drawn, Edited, Dropped, Told, Asked, LookedAt, PutAway, Pointed, NotPointed>;

}  // namespace dobra::canvas
