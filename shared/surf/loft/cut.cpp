// 1. For each piece of the trace its plane; the lines on every patch; what is over the piece.
// 2. Of lines that patches share, at borders along the trace, one is kept.
// 3. Lines of one surface whose ends meet are joined: at bends of the trace, and at borders of patches.
#include "shared/surf/loft/cut.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/surf/loft/level.h"

namespace dobra::surf::loft {

using geom::Point;
using geom::Point3;
using geom::Vector;

namespace {

constexpr double in_plane = 1e-10;     // of the size
constexpr double same_end = 1e-9;      // of the size: ends that meet
constexpr double same_at_bend = 1e-3;  // of the size: found on two planes

/// The parts of a line between two distances.
std::vector<CutLine> clipped(const CutLine& whole, double low, double high, double same) {
  std::vector<CutLine> parts;
  const auto begin = [&](Point p, const std::string& fault) {
    parts.push_back(whole);
    parts.back().line.points = {p};
    parts.back().first_fault = fault;
    parts.back().last_fault.clear();
  };
  const auto inside = [&](Point p) { return p.x >= low - same && p.x <= high + same; };
  const auto& points = whole.line.points;
  const auto crossing = [](Point p, Point q, double x) {
    return Point{x, p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y)};
  };
  if (inside(points.front())) begin(points.front(), whole.first_fault);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point p = points[i - 1], q = points[i];
    if (!inside(p) && inside(q)) begin(crossing(p, q, p.x < low ? low : high), "");
    if (!inside(p) && !inside(q) && (p.x < low) != (q.x < low)) {
      begin(crossing(p, q, p.x < low ? low : high), "");
      parts.back().line.points.push_back(crossing(p, q, p.x < low ? high : low));
    }
    if (inside(p) && !inside(q)) parts.back().line.points.push_back(crossing(p, q, q.x < low ? low : high));
    if (inside(q) && (parts.back().line.points.back() != q)) parts.back().line.points.push_back(q);
  }
  if (inside(points.back())) parts.back().last_fault = whole.last_fault;
  std::erase_if(parts, [](const CutLine& part) { return part.line.points.size() < 2; });
  return parts;
}

void turn(CutLine& line) {
  line.line = geom::reversed(std::move(line.line));
  std::swap(line.first_fault, line.last_fault);
}

class Cutting {
 public:
  Cutting(const PlanTrace& trace, double size) : trace_(trace), size_(size) {}

  void cut(const NamedSurface& surface, SectionCut& made) {
    std::vector<CutLine> lines;
    for (std::size_t k = 0; k + 1 < trace_.corners().size(); ++k) {
      for (const Patch& patch : surface.patches) cut(surface, patch, k, lines, made.findings);
    }
    leave_out_doubles(lines);
    join(lines);
    for (CutLine& line : lines) {
      straighten(line);
      const Vector way = line.line.points.back() - line.line.points.front();
      if (way.x < 0.0 || (way.x == 0.0 && way.y < 0.0)) turn(line);
    }
    std::stable_sort(lines.begin(), lines.end(),
                     [](const CutLine& a, const CutLine& b) { return a.line.points.front() < b.line.points.front(); });
    made.lines.insert(made.lines.end(), lines.begin(), lines.end());
  }

 private:
  void cut(const NamedSurface& surface, const Patch& patch, std::size_t k, std::vector<CutLine>& lines,
           std::vector<Finding>& findings) const {
    const Point from = trace_.corners()[k];
    const Vector way = geom::normalised(trace_.corners()[k + 1] - from);
    const Vector across = geom::left_of(way);
    const Linear plane{{across.x, across.y, 0.0}, across.x * from.x + across.y * from.y};
    const LevelSet set = level_set(patch, plane, in_plane * size_);
    if (set.flat > 0)
      findings.push_back(
          {"in_plane",
           fmt::format("{} '{}' lies in the plane of the section over an area of {} triangles; its border "
                       "is drawn there",
                       kind_name(surface.kind), surface.name, set.flat),
           {.item = surface.name, .x = set.flat_at.x, .y = set.flat_at.y, .z = set.flat_at.z}});
    for (const LevelLine& found : set.lines) {
      CutLine line{surface.name, surface.kind, {}, fault_at(patch, found.first), fault_at(patch, found.last)};
      for (const Point3 p : found.points)
        line.line.points.push_back({trace_.distances()[k] + geom::dot(Point{p.x, p.y} - from, way), p.z});
      for (CutLine& part : clipped(line, trace_.distances()[k], trace_.distances()[k + 1], same_end * size_))
        lines.push_back(std::move(part));
    }
  }
  static std::string fault_at(const Patch& patch, PatchEnd end) {
    if (end == PatchEnd::Low) return patch.low_fault;
    return end == PatchEnd::High ? patch.high_fault : std::string();
  }

  /// Where the trace runs along the border of two patches, both give the same line.
  void leave_out_doubles(std::vector<CutLine>& lines) const {
    const double same = same_end * size_;
    const auto on = [&](const CutLine& part, const CutLine& whole) {
      const geom::Box box = whole.line.box();
      return std::all_of(part.line.points.begin(), part.line.points.end(), [&](Point p) {
        return p.x >= box.low.x - same && p.x <= box.high.x + same && p.y >= box.low.y - same &&
               p.y <= box.high.y + same && geom::distance(whole.line, p) <= same;
      });
    };
    for (std::size_t i = 0; i < lines.size();) {
      bool is_double = false;
      for (std::size_t j = 0; j < lines.size() && !is_double; ++j)
        is_double = j != i && on(lines[i], lines[j]) && (j < i || !on(lines[j], lines[i]));
      if (is_double) {
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        ++i;
      }
    }
  }

  [[nodiscard]] bool meet(Point p, Point q) const {
    const auto& bends = trace_.distances();
    const bool at_bend = std::any_of(bends.begin() + 1, bends.end() - 1, [&](double s) {
      return std::abs(p.x - s) <= same_end * size_ && std::abs(q.x - s) <= same_end * size_;
    });
    return geom::distance(p, q) <= (at_bend ? same_at_bend : same_end) * size_;
  }

  void join(std::vector<CutLine>& lines) const {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (std::size_t j = i + 1; j < lines.size();) {
        if (!joined(lines[i], lines[j])) {
          ++j;
          continue;
        }
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(j));
        j = i + 1;
      }
    }
  }
  [[nodiscard]] bool joined(CutLine& a, CutLine b) const {
    for (int turns = 0; turns < 4; ++turns) {
      if (a.last_fault.empty() && b.first_fault.empty() && meet(a.line.points.back(), b.line.points.front())) {
        a.line.points.insert(a.line.points.end(), b.line.points.begin() + 1, b.line.points.end());
        a.last_fault = b.last_fault;
        return true;
      }
      turn(turns % 2 == 0 ? b : a);
    }
    return false;
  }

  /// Without vertices on the straight way between their neighbours.
  void straighten(CutLine& cut) const {
    std::vector<Point> kept;
    for (const Point p : cut.line.points) {
      while (kept.size() > 1 && on_way(kept[kept.size() - 2], kept.back(), p)) kept.pop_back();
      if (kept.empty() || geom::distance(kept.back(), p) > in_plane * size_) kept.push_back(p);
    }
    if (kept.size() > 1) cut.line.points = std::move(kept);
  }
  [[nodiscard]] bool on_way(Point a, Point p, Point b) const {
    const Vector way = b - a;
    const double length = geom::length(way);
    return length > 0.0 && geom::dot(p - a, way) >= 0.0 && geom::dot(b - p, way) >= 0.0 &&
           std::abs(geom::cross(way, p - a)) <= 1e-12 * size_ * length;
  }

  const PlanTrace& trace_;
  double size_;
};

}  // namespace

SectionCut cut_along(const std::vector<NamedSurface>& surfaces, const PlanTrace& trace, double size) {
  SectionCut made;
  Cutting cutting(trace, size);
  for (const NamedSurface& surface : surfaces) cutting.cut(surface, made);
  return made;
}

base::Result<std::vector<Contour>> contours(const NamedSurface& surface, double interval) {
  double low = INFINITY, high = -INFINITY, size = 0.0;
  for (const Patch& patch : surface.patches) {
    size = std::max(size, patch.surface.size());
    for (const Point3 p : patch.points) low = std::min(low, p.z), high = std::max(high, p.z);
  }
  std::vector<Contour> made;
  if (!((high - low) / interval < 10'000.0))
    return base::Error{base::ErrorCode::TooManyElements,
                       fmt::format("contours every {:.6g} m of a surface {:.6g} m high are more than 10000; ask for a "
                                   "greater interval",
                                   interval, high - low)};
  for (double k = std::ceil(low / interval); k * interval <= high; ++k) {
    Contour contour{k * interval, {}};
    for (const Patch& patch : surface.patches) {
      for (LevelLine& line : level_set(patch, {{0.0, 0.0, 1.0}, contour.level}, in_plane * size).lines)
        contour.lines.push_back(std::move(line.points));
    }
    if (!contour.lines.empty()) made.push_back(std::move(contour));
  }
  return made;
}

}  // namespace dobra::surf::loft
