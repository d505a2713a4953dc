#pragma once
// What a program adds to the window from its own folder: tools of the canvas, panels, examples. The window knows no
// program by name. Page: docs/architecture.md

#include <QKeySequence>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "shared/canvas/tool.h"
#include "shared/gui/stage/space_gesture.h"
#include "shared/gui/theme/icons.h"
#include "shared/gui/welcome/examples.h"
#include "shared/scenario/document.h"
#include "shared/scenario/field.h"
#include "shared/scene/space/cut.h"

class QWidget;

namespace dobra::gui {

class Canvas;
class Session;

/// What tools and panels work on, there as long as they are. What happens is heard of by the signals of both: another
/// document, a run that has ended, other lines or another selection.
struct Desk {
  Session& session;
  Canvas& canvas;
};

/// Shows and hides layers of the picture in space, and of the panels of the plane that have them too.
struct LayerSwitch {
  std::string name;  ///< Its action is "view.space.show.NAME".
  std::string text;  ///< As menus and the bar over the picture show it, English source.
  std::string help;  ///< A sentence, English source.
  theme::Draw icon;  ///< As of theme::icon.
  std::vector<std::string> layers;
  std::vector<std::string> instead = {};  ///< Hidden where they are shown, and shown where they are hidden.
};

/// What a plane cuts out of what stands in space.
struct SectionMade {
  std::vector<scene::space::Layer> caps = {};  ///< What closes the cut. Keys end with scene::space::cap_end.
  scene::Panel panel = {};                     ///< The same in the plane of the section.
};

/// A file that is no scenario and becomes a document of its own.
struct OtherFile {
  scenario::FileKind kind;
  /// A document that reads it. @error what is wrong with the file
  std::function<base::Result<scenario::Document>(const std::filesystem::path&)> begin;
};

/// What the program makes of gestures on its picture in space. Edits go to the session, as those of tools do.
struct SpacePart {
  std::function<void(const Desk&, const stage::ItemAt&)> clicked =
      {};                                   ///< In space, or in a panel of the plane beside it.
  std::vector<std::string> draggable = {};  ///< Layers of markers that can be dragged.
  std::vector<LayerSwitch> switches = {};
  /// The key of the panel of the plane in which an item of space is drawn; empty: in none.
  std::function<std::string(const Desk&, const stage::ItemAt&)> panel_of = {};
  /// Such a panel, where the picture does not have it: shown in the place of its last one. In the document's units.
  std::function<std::optional<scene::Panel>(const Desk&, const std::string& key)> panel = {};
  /// The section by a plane, in the document's units, as quickly as a hand moves it; nothing: there is none.
  std::function<std::optional<SectionMade>(const Desk&, const scene::space::CutPlane&)> section = {};
  /// A marker on its way in the plane of the screen through it.
  std::function<void(const Desk&, stage::MarkerDrag, const stage::ItemAt&, const geom::Point3& to)> dragged = {};
};

/// A tool that only this program has. What a gesture makes it gives to the session: while it lasts to be looked at, at
/// its end as one edit.
struct ToolPart {
  std::string name;       ///< Its action is "draw.NAME".
  std::string text;       ///< As menus show it, English source.
  std::string help;       ///< A sentence, English source.
  theme::Draw icon;       ///< As of theme::icon.
  QKeySequence key = {};  ///< None that the window has itself.
  std::function<std::unique_ptr<canvas::Tool>(const Desk&)> make;
};

/// A panel that stands among the results, with an entry in the menu of panels.
struct PanelPart {
  std::string name;   ///< Its action is "view.panel.NAME".
  std::string title;  ///< English source.
  std::function<QWidget*(const Desk&, QWidget* parent)> make;
};

struct WindowPart {
  std::string about = {};                       ///< What the program is for, one sentence in English source text.
  std::vector<welcome::Example> examples = {};  ///< Those that the welcome page offers.
  std::vector<ToolPart> tools = {};
  std::vector<PanelPart> panels = {};
  SpacePart space = {};
  std::vector<OtherFile> files = {};  ///< Opened beside scenarios.
};

}  // namespace dobra::gui
