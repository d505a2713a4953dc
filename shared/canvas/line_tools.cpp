#include <algorithm>

#include "shared/base/text.h"
#include "shared/canvas/line_edit.h"
#include "shared/canvas/tool.h"

namespace dobra::canvas {

namespace {

using base::translated;
using geom::Point;
using geom::Polyline;

/// Works on the line that is clicked, at the place that is clicked.
class LineTool final : public Tool {
 public:
  explicit LineTool(LineWork work) : work_(work) {}

  [[nodiscard]] std::string hint() const override {
    switch (work_) {
      case LineWork::InsertVertex:
        return translated("Click a line where it is to have one more vertex");
      case LineWork::Split:
        return translated("Click a line where it is to be split");
      case LineWork::Join:
        return first_ ? translated("Click the line to join it with") : translated("Click a line near the end to join");
      case LineWork::Extend:
        return translated("Click a line near the end that is to go on to the next line");
      case LineWork::Trim:
        break;
    }
    return translated("Click the part of a line that is to go");
  }

  void press(Workspace& work, const Pointer& pointer) override {
    const std::optional<Snap> on = under(work, pointer);
    if (!on) {
      say(Told{line_at_all(work, pointer) ? made_by_a_step() : translated("There is no line here.") + " " + hint()});
      return;
    }
    const Polyline& line = *work.line(*on->on);
    const OnSegment where{on->segment, on->at};
    switch (work_) {
      case LineWork::InsertVertex:
        become(*on->on, std::vector{with_vertex(line, where)}, "Insert vertex");
        break;
      case LineWork::Split:
        split(line, *on);
        break;
      case LineWork::Join:
        join(work, *on->on);
        break;
      case LineWork::Extend: {
        const bool first = geom::distance(where.at, line.points.front()) < geom::distance(where.at, line.points.back());
        one(*on->on, extended_to(line, first ? End::First : End::Last, work.others(*on->on)), "Extend line");
        break;
      }
      case LineWork::Trim:
        become(*on->on, trimmed(line, work.others(*on->on), where), "Trim line");
        break;
    }
  }
  void move(Workspace& work, const Pointer& pointer) override {
    const std::optional<Snap> on = under(work, pointer);
    hovered_ = on ? on->on : std::nullopt;
  }
  bool key(Workspace&, Key key) override {
    if (key != Key::Escape || !first_) return false;
    first_.reset();
    return true;
  }
  [[nodiscard]] bool unfinished() const override { return first_.has_value(); }
  [[nodiscard]] Overlay overlay(const Workspace& work) const override {
    Overlay overlay;
    for (const std::optional<scene::Pick>& pick : {first_, hovered_}) {
      const Polyline* line = pick ? work.line(*pick) : nullptr;
      if (line != nullptr) overlay.chosen.push_back(*line);
    }
    return overlay;
  }

 private:
  static bool line_at_all(const Workspace& work, const Pointer& pointer) {
    const SnapWish wish{.reach = pointer.reach, .exaggeration = pointer.exaggeration, .kinds = {SnapKind::OnLine}};
    return work.snaps().at(pointer.at, wish).has_value();
  }
  static std::optional<Snap> under(const Workspace& work, const Pointer& pointer) {
    SnapWish wish{.reach = pointer.reach, .exaggeration = pointer.exaggeration, .kinds = {SnapKind::OnLine}};
    wish.only = work.editable();
    std::optional<Snap> on = work.snaps().at(pointer.place(), wish);
    if (!on) on = work.snaps().at(pointer.at, wish);
    if (!on || !on->on || work.line(*on->on) == nullptr) return std::nullopt;
    return on;
  }

  void split(const Polyline& line, const Snap& on) {
    auto parts = split_at(line, {on.segment, on.at});
    if (!parts) {
      say(Told{parts.error().message});
      return;
    }
    std::vector<Polyline> becomes{std::move(parts->first)};
    if (!parts->second.points.empty()) becomes.push_back(std::move(parts->second));
    become(*on.on, std::move(becomes), "Split line");
  }

  void join(Workspace& work, const scene::Pick& pick) {
    if (first_ && *first_ == pick) {
      say(Told{translated("This is the line itself.") + " " + hint()});
      return;
    }
    if (!first_ || work.line(*first_) == nullptr) {
      first_ = pick;
      return;
    }
    const scene::Pick first = *std::exchange(first_, std::nullopt);
    const base::Result<Polyline> line = joined(*work.line(first), *work.line(pick));
    if (!line) {
      say(Told{line.error().message});
      return;
    }
    const auto as = [&](const scene::Pick& kept, const scene::Pick& gone) {
      return Edited{{{kept, {*line}}, {gone, {}}}, translated("Join lines"), Stage::Done};
    };
    const std::string name = work.name(first), other = work.name(pick);
    if (name == other) {
      say(as(first, pick));
    } else {
      say(Asked{translated("Which of the two is the line that they become?"),
                {{name, as(first, pick)}, {other, as(pick, first)}}});
    }
  }

  void one(const scene::Pick& pick, base::Result<Polyline> line, const char* what) {
    if (line) {
      become(pick, std::vector{*std::move(line)}, what);
    } else {
      say(Told{line.error().message});
    }
  }
  void become(const scene::Pick& pick, base::Result<std::vector<Polyline>> lines, const char* what) {
    if (lines) {
      say(Edited{{{pick, *std::move(lines)}}, translated(what), Stage::Done});
    } else {
      say(Told{lines.error().message});
    }
  }

  LineWork work_;
  std::optional<scene::Pick> first_;
  std::optional<scene::Pick> hovered_;
};

}  // namespace

std::unique_ptr<Tool> make_line_tool(LineWork work) { return std::make_unique<LineTool>(work); }

}  // namespace dobra::canvas
