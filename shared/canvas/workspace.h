#pragma once
// What the tools of a canvas work on: the lines of one panel of the picture, and which of them are selected.

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "shared/canvas/snap.h"
#include "shared/scene/pick.h"

namespace dobra::canvas {

/// The selected vertices of a line; none: the line as a whole.
using Selection = std::map<scene::Pick, std::set<std::size_t>>;

/// In what lengths are shown and typed.
struct LengthUnit {
  std::string name = "m";
  double size = 1.0;  ///< World.
};

/// What is told of the direction of a line: its dip in a section, its angle to the first axis elsewhere.
enum class Direction { Dip, Angle };

class Workspace {
 public:
  /// Another picture, or another panel of it. Of the selection stays what is still there.
  /// @param hidden  keys of layers that are not shown, besides those whose `visible` says so.
  /// @pre panel < picture->panels.size()
  void show(std::shared_ptr<const scene::Picture> picture, std::size_t panel, std::set<std::string> hidden = {});

  /// The lines that can be selected and edited; the others are only drawn to. Nothing: all.
  void set_editable(std::optional<std::set<scene::Pick>> picks) { editable_ = std::move(picks); }
  [[nodiscard]] const std::set<scene::Pick>* editable() const { return editable_ ? &*editable_ : nullptr; }
  [[nodiscard]] bool is_editable(const scene::Pick& pick) const { return !editable_ || editable_->contains(pick); }

  [[nodiscard]] bool empty() const { return picture_ == nullptr; }
  [[nodiscard]] const scene::Panel& panel() const { return picture_->panels[panel_]; }
  /// Made when first asked for.
  [[nodiscard]] const SnapIndex& snaps() const;
  /// Of a pick; null if it is no line of a visible layer. A marker is a line of one point.
  [[nodiscard]] const geom::Polyline* line(const scene::Pick& pick) const;
  /// What the layer of a pick is called; empty where there is none.
  [[nodiscard]] std::string title(const scene::Pick& pick) const;
  /// What the line itself is called: what `names` gives, or the title of its layer where that gives nothing.
  [[nodiscard]] std::string name(const scene::Pick& pick) const;
  /// Lines of one layer that have names of their own.
  void set_names(std::function<std::string(const scene::Pick&)> names) { names_ = std::move(names); }
  /// All lines of the visible layers.
  [[nodiscard]] std::vector<std::pair<scene::Pick, const geom::Polyline*>> lines() const;
  /// All markers of the visible layers.
  [[nodiscard]] const std::vector<std::pair<scene::Pick, geom::Polyline>>& markers() const { return markers_; }
  /// All lines but one.
  [[nodiscard]] std::vector<geom::Polyline> others(const scene::Pick& pick) const;
  /// Every vertex of a visible line, and every marker, that can be edited and stands exactly there.
  [[nodiscard]] std::vector<std::pair<scene::Pick, std::size_t>> vertices_at(geom::Point at) const;

  Selection selection;
  LengthUnit unit;
  Direction direction = Direction::Dip;

 private:
  std::shared_ptr<const scene::Picture> picture_;
  std::size_t panel_ = 0;
  std::set<std::string> hidden_;
  std::optional<std::set<scene::Pick>> editable_;
  std::function<std::string(const scene::Pick&)> names_;
  std::vector<std::pair<scene::Pick, geom::Polyline>> markers_;
  mutable std::optional<SnapIndex> snaps_;
};

}  // namespace dobra::canvas
