#include "recon/unfold/picks.h"

#include <algorithm>
#include <cmath>

#include "shared/base/counter_random.h"
#include "shared/geom/segment_tree.h"

namespace recon::unfold {

namespace {

/// A vertex this near to a line lies on it, of the section's size: vertices of a subdivision are rounded.
constexpr double on_line = 1e-9;
/// Sine of the angle below which two lines run alike: where they meet is not a place then.
constexpr double alike = 0.1;

std::vector<geom::Segment> segments_of(const geom::Polyline& line) {
  std::vector<geom::Segment> segments;
  for (std::size_t i = 0; i < line.segment_count(); ++i) segments.push_back(line.segment(i));
  return segments;
}

}  // namespace

Picks::Picks(const section::Section& section, std::vector<geom::Polyline> contours, const PickErrors& errors)
    : how_(errors) {
  for (const section::Horizon& horizon : section.horizons) lines_.push_back(horizon.line);
  horizons_ = lines_.size();
  if (!contours.empty()) {
    for (const section::SectionLine& line : section.lines) {
      if (line.kind == section::LineKind::Fault || line.kind == section::LineKind::Topography)
        lines_.push_back(line.line);
    }
    if (section.border) {
      border_ = lines_.size();
      lines_.push_back(*section.border);
    }
  }
  const std::size_t polygons = lines_.size();
  if (!contours.empty()) {
    for (const section::Unit& unit : section.units) lines_.push_back(unit.contour);
  }
  for (const geom::Polyline& line : lines_) arcs_.push_back(geom::arc_lengths(line));
  anchor(contours, polygons);
}

void Picks::anchor(const std::vector<geom::Polyline>& contours, std::size_t polygons) {
  geom::Box all;
  for (const geom::Polyline& contour : contours) {
    all.add(contour.box());
    contours_.emplace_back();
    for (const geom::Point p : contour.points) contours_.back().push_back({p, {}, {}});
  }
  const double near = on_line * all.diagonal();
  for (std::size_t line = 0; line < lines_.size() && !contours.empty(); ++line) {
    const geom::Box reach = lines_[line].box().grown(near);
    const geom::SegmentTree tree(segments_of(lines_[line]));
    for (std::vector<Vertex>& contour : contours_) {
      for (Vertex& vertex : contour) {
        const bool taken = vertex.second || (vertex.first && line >= polygons);
        // Corners of polygons are picks, whatever the border cuts off.
        const bool ruled_out = polygons < lines_.size() && border_ == line;
        if (taken || ruled_out || !reach.contains(vertex.at)) continue;
        const auto found = tree.nearest(vertex.at, [](std::size_t) { return true; });
        if (!found || found->distance() > near) continue;
        const Anchor at{line, found->index, geom::nearest_fraction(tree.segment(found->index), vertex.at)};
        (vertex.first ? vertex.second : vertex.first) = at;
      }
    }
  }
}

Picks::Errors Picks::errors_of(std::size_t line, std::uint32_t number) const {
  const std::size_t count = lines_[line].points.size();
  Errors errors(count, geom::Vector{0.0, 0.0});
  if (how_.deviation == 0.0 || line == border_) return errors;
  const bool closed = lines_[line].closed;
  // Round a contour the nodes come again, so that it closes.
  const double length = arcs_[line].back();
  const std::uint32_t nodes = closed ? std::max(2U, static_cast<std::uint32_t>(length / how_.correlation)) : 0;
  const double spacing = closed ? length / nodes : how_.correlation;
  const auto at_node = [&](std::uint32_t node) {
    const base::Counter counter{number, static_cast<std::uint32_t>(line), closed ? node % nodes : node, 1};
    const auto pair = base::normal_pair(counter, how_.seed);
    return geom::Vector{pair[0], pair[1]};
  };
  std::uint32_t node = 0;
  geom::Vector left = at_node(0);
  geom::Vector right = at_node(1);
  for (std::size_t i = 0; i < count; ++i) {
    const double place = arcs_[line][i] / spacing;
    for (; place >= node + 1.0; ++node) {
      left = right;
      right = at_node(node + 2);
    }
    const double t = place - node;
    const double scale = how_.deviation / std::hypot(1.0 - t, t);
    errors[i] = scale * ((1.0 - t) * left + t * right);
  }
  return errors;
}

geom::Point Picks::moved(const Vertex& vertex, const std::vector<Errors>& errors) const {
  if (!vertex.first) return vertex.at;
  struct Course {
    geom::Vector move;
    geom::Vector along;
  };
  const auto course = [&](const Anchor& anchor) {
    const geom::Segment segment = lines_[anchor.line].segment(anchor.segment);
    const Errors& of_line = errors[anchor.line];
    const geom::Vector from = of_line[anchor.segment];
    const geom::Vector to = of_line[anchor.segment + 1 == of_line.size() ? 0 : anchor.segment + 1];
    return Course{(1.0 - anchor.part) * from + anchor.part * to, segment.vector() + to - from};
  };
  const Course first = course(*vertex.first);
  if (!vertex.second) return vertex.at + first.move;
  const Course second = course(*vertex.second);
  const double turn = geom::cross(first.along, second.along);
  const double size = std::sqrt(geom::length_squared(first.along) * geom::length_squared(second.along));
  if (std::abs(turn) < alike * size) return vertex.at + first.move;
  return vertex.at + first.move + (geom::cross(second.move - first.move, second.along) / turn) * first.along;
}

Picks::Draw Picks::draw(std::uint32_t number) const {
  std::vector<Errors> errors;
  for (std::size_t line = 0; line < lines_.size(); ++line) errors.push_back(errors_of(line, number));
  Draw drawn;
  for (std::size_t line = 0; line < horizons_; ++line) {
    drawn.horizons.push_back(lines_[line]);
    std::vector<geom::Point>& points = drawn.horizons.back().points;
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = points[i] + errors[line][i];
  }
  for (const std::vector<Vertex>& contour : contours_) {
    geom::Polyline line{{}, true};
    for (const Vertex& vertex : contour) line.points.push_back(moved(vertex, errors));
    drawn.contours.push_back(std::move(line));
  }
  return drawn;
}

}  // namespace recon::unfold
