#include <algorithm>
#include <cmath>

#include "shared/base/text.h"
#include "shared/canvas/line_edit.h"
#include "shared/canvas/tool.h"
#include "shared/geom/intersect.h"

namespace dobra::canvas {

namespace {

using base::translated;
using geom::Point;
using geom::Polyline;

double page_distance(Point p, Point q, const Pointer& pointer) {
  return std::hypot(p.x - q.x, pointer.exaggeration * (p.y - q.y));
}

/// The line under the cursor.
std::optional<scene::Pick> line_at(const Workspace& work, const Pointer& pointer) {
  SnapWish wish{.reach = pointer.reach, .exaggeration = pointer.exaggeration, .kinds = {SnapKind::OnLine}};
  wish.only = work.editable();
  const std::optional<Snap> found = work.snaps().at(pointer.at, wish);
  if (!found || !found->on || work.line(*found->on) == nullptr) return std::nullopt;
  return found->on;
}

/// The marker under the cursor that can be edited.
std::optional<scene::Pick> marker_at(const Workspace& work, const Pointer& pointer) {
  std::optional<scene::Pick> best;
  double least = pointer.reach;
  for (const auto& [pick, marker] : work.markers()) {
    const double distance = page_distance(marker.points.front(), pointer.at, pointer);
    if (distance > least || (best && distance == least) || !work.is_editable(pick)) continue;
    least = distance;
    best = pick;
  }
  return best;
}

struct VertexOf {
  scene::Pick pick;
  std::size_t vertex = 0;
};

/// The vertex of a selected line under the cursor.
std::optional<VertexOf> handle_at(const Workspace& work, const Pointer& pointer) {
  std::optional<VertexOf> best;
  double least = pointer.reach;
  for (const auto& [pick, chosen] : work.selection) {
    const Polyline* line = work.line(pick);
    for (std::size_t i = 0; line != nullptr && i < line->points.size(); ++i) {
      const double distance = page_distance(line->points[i], pointer.at, pointer);
      if (distance > least || (best && distance == least)) continue;
      least = distance;
      best = VertexOf{pick, i};
    }
  }
  return best;
}

/// Left to right: lines that lie inside; right to left: those that the band meets.
bool banded(const Polyline& line, Point from, Point to) {
  const Point corners[] = {from, to};
  const geom::Box band = geom::box_of(corners);
  if (from.x <= to.x)
    return std::all_of(line.points.begin(), line.points.end(), [&](Point p) { return band.contains(p); });
  if (std::any_of(line.points.begin(), line.points.end(), [&](Point p) { return band.contains(p); })) return true;
  const Polyline frame = rectangle(from, to);
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (geom::intersect(line.segment(i), frame.segment(k)).kind != geom::IntersectionKind::None) return true;
    }
  }
  return false;
}

class SelectTool final : public Tool {
 public:
  [[nodiscard]] std::string hint() const override {
    return translated("Click a line, or drag a box round lines; drag a vertex to move it, Delete removes it");
  }
  [[nodiscard]] Cursor cursor() const override { return Cursor::Arrow; }
  [[nodiscard]] bool snaps() const override { return !dragged_.empty(); }
  [[nodiscard]] std::set<scene::Pick> moving() const override {
    std::set<scene::Pick> picks;
    for (const Dragged& one : dragged_) picks.insert(one.pick);
    return picks;
  }

  void press(Workspace& work, const Pointer& pointer) override {
    if (const auto handle = handle_at(work, pointer)) {
      take_vertex(work, *handle, pointer.modifier);
      return;
    }
    if (const auto pick = marker_at(work, pointer)) {
      choose(work, *pick, pointer.modifier);
      // It moves at once: there is nothing of it but this place.
      if (work.selection.contains(*pick)) take_vertex(work, {*pick, 0}, Modifier::Add);
      return;
    }
    if (const auto pick = line_at(work, pointer)) {
      choose(work, *pick, pointer.modifier);
      return;
    }
    band_ = {pointer.at, pointer.at};
  }

  void move(Workspace&, const Pointer& pointer) override {
    if (band_) band_->second = pointer.at;
    if (dragged_.empty()) return;
    if (!moved_ && page_distance(pointer.at, start_, pointer) <= 0.5 * pointer.reach) return;
    moved_ = true;
    to_ = pointer.place();
    say(edit(Stage::During));
  }

  void release(Workspace& work, const Pointer& pointer) override {
    if (!dragged_.empty()) {
      if (moved_) say(edit(Stage::Done));
      dragged_.clear();
      moved_ = false;
    }
    if (!band_) return;
    if (pointer.modifier == Modifier::None) work.selection.clear();
    for (const auto& [pick, line] : work.lines()) {
      if (work.is_editable(pick) && band_->first != band_->second && banded(*line, band_->first, band_->second))
        work.selection[pick];
    }
    for (const auto& [pick, marker] : work.markers()) {
      if (work.is_editable(pick) && band_->first != band_->second && banded(marker, band_->first, band_->second))
        work.selection[pick];
    }
    band_.reset();
  }

  bool key(Workspace& work, Key key) override {
    if (key == Key::Escape) return give_up(work);
    if (key != Key::Delete || work.selection.empty()) return false;
    remove(work);
    return true;
  }

  [[nodiscard]] std::optional<Point> last() const override { return moved_ ? std::optional(start_) : std::nullopt; }

  [[nodiscard]] Overlay overlay(const Workspace& work) const override {
    Overlay overlay;
    show_selection(work, overlay);
    if (band_) overlay.lines.push_back(rectangle(band_->first, band_->second));
    if (moved_) {
      for (const scene::LineEdit& line : edit(Stage::During).lines) overlay.lines.push_back(line.becomes.front());
      overlay.texts.push_back({to_, measure_text(start_, to_, work.unit, work.direction)});
    }
    return overlay;
  }

 private:
  /// A line with the vertices of it that go along.
  struct Dragged {
    scene::Pick pick;
    Polyline line;
    std::vector<std::size_t> vertices;
  };

  /// Vertices of other lines at the same place go along.
  void take_vertex(Workspace& work, const VertexOf& handle, Modifier modifier) {
    std::set<std::size_t>& chosen = work.selection[handle.pick];
    const bool was = chosen.contains(handle.vertex);
    if (modifier == Modifier::None && !was) {
      for (auto& [pick, vertices] : work.selection) vertices.clear();
    }
    if (modifier == Modifier::Toggle && was) {
      chosen.erase(handle.vertex);
      return;
    }
    chosen.insert(handle.vertex);
    start_ = work.line(handle.pick)->points[handle.vertex];
    dragged_.clear();
    for (const auto& [pick, vertex] : work.vertices_at(start_)) {
      if (dragged_.empty() || dragged_.back().pick != pick) dragged_.push_back({pick, *work.line(pick), {}});
      dragged_.back().vertices.push_back(vertex);
    }
  }

  void choose(Workspace& work, const scene::Pick& pick, Modifier modifier) {
    const bool was = work.selection.contains(pick);
    if (modifier == Modifier::None) work.selection.clear();
    if (modifier == Modifier::Toggle && was) {
      work.selection.erase(pick);
    } else {
      work.selection[pick];
    }
  }

  bool give_up(Workspace& work) {
    const bool busy = band_ || !dragged_.empty() || !work.selection.empty();
    if (moved_) {
      say(Dropped{});
    } else if (!band_) {
      work.selection.clear();
    }
    band_.reset();
    dragged_.clear();
    moved_ = false;
    return busy;
  }

  [[nodiscard]] Edited edit(Stage stage) const {
    Edited edited{{}, translated("Move vertex"), stage};
    for (const Dragged& one : dragged_) {
      Polyline line = one.line;
      for (const std::size_t i : one.vertices) line = with_vertex_moved(std::move(line), i, to_);
      edited.lines.push_back({one.pick, {std::move(line)}});
    }
    return edited;
  }

  /// The selected vertices, or where a line has none of them selected and no other line has, the lines.
  void remove(Workspace& work) {
    const bool vertices =
        std::any_of(work.selection.begin(), work.selection.end(), [](const auto& one) { return !one.second.empty(); });
    Edited edited{{}, translated(vertices ? "Delete vertices" : "Delete lines"), Stage::Done};
    for (const auto& [pick, chosen] : work.selection) {
      if (!vertices) edited.lines.push_back({pick, {}});
      if (chosen.empty()) continue;
      if (vertices && work.line(pick)->points.size() == 1) {  // a marker goes as a whole
        edited.lines.push_back({pick, {}});
        continue;
      }
      base::Result<Polyline> left = without_vertices(*work.line(pick), chosen);
      if (!left) {
        say(Told{left.error().message});
        return;
      }
      edited.lines.push_back({pick, {*std::move(left)}});
    }
    // Of the lines that are left none is selected: ids may pass on to others.
    if (vertices) {
      std::erase_if(work.selection, [&](const auto& one) { return work.line(one.first)->points.size() == 1; });
      for (auto& [pick, chosen] : work.selection) chosen.clear();
    } else {
      work.selection.clear();
    }
    say(std::move(edited));
  }

  std::optional<std::pair<Point, Point>> band_;
  std::vector<Dragged> dragged_;
  Point start_;  ///< Of the vertex that is dragged.
  Point to_;
  bool moved_ = false;
};

}  // namespace

void show_selection(const Workspace& work, Overlay& overlay) {
  if (work.empty()) return;
  for (const auto& [pick, chosen] : work.selection) {
    const Polyline* line = work.line(pick);
    if (line == nullptr) continue;
    overlay.chosen.push_back(*line);
    for (std::size_t i = 0; i < line->points.size(); ++i)
      (chosen.contains(i) ? overlay.chosen_handles : overlay.handles).push_back(line->points[i]);
  }
}

std::unique_ptr<Tool> make_select_tool() { return std::make_unique<SelectTool>(); }

}  // namespace dobra::canvas
