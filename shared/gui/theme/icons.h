#pragma once
// Icons drawn by the program itself in the colours of the palette: sharp at every pixel ratio, no image plugin needed.

#include <QBrush>
#include <QColor>
#include <QIcon>

class QPainter;

namespace dobra::gui::theme {

/// Draws on a square of 24 x 24 units; the pen is set to the colour of text, 1.8 units wide.
using Draw = void (*)(QPainter& painter);

enum class Symbol {
  Open,
  Save,
  SavePicture,
  Undo,
  Redo,
  Fit,
  Run,
  Cancel,
  Add,
  Remove,
  Up,
  Down,
  Done,
  Failed,
  Running,
  Pending,
  Warning,
  Play,
  Pause,
  Step,
  Select,
  Measure,
  Line,
  Polygon,
  Rectangle,
  Circle,
  Point,
  InsertVertex,
  Split,
  Join,
  Extend,
  Trim,
  Move,
  Rotate,
  Mirror,
  Copy,
  Snap,
  ShowInput,
  ShowResult,
  ShowBoth,
  Hand,
  ZoomWindow
};

QIcon icon(Symbol symbol);
QIcon icon(Draw draw);

/// A filled square with a thin outline: the colour of a layer. Gradients run over a square of 28 units.
QIcon swatch(const QBrush& fill, const QColor& line);

/// A letter: the colour of a layer of labels.
QIcon letter_swatch(const QColor& color);

/// What the programs show in the task bar: two folded layers.
QIcon application_icon();

}  // namespace dobra::gui::theme
