#include "shared/surf/loft/pieces.h"

#include <algorithm>

#include "shared/geom/intersect.h"

namespace dobra::surf::loft {

using geom::Point;

namespace {

struct Cut {
  double place = 0.0;  // vertices count 1
  Point at;
  std::string fault;
};

void cuts_by(const geom::Polyline& line, const SectionLine& fault, std::vector<Cut>& cuts) {
  const geom::Box box = fault.line.box();
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const geom::Segment a = line.segment(i);
    if (std::max(a.from.x, a.to.x) < box.low.x || std::min(a.from.x, a.to.x) > box.high.x ||
        std::max(a.from.y, a.to.y) < box.low.y || std::min(a.from.y, a.to.y) > box.high.y)
      continue;
    for (std::size_t j = 0; j < fault.line.segment_count(); ++j) {
      const geom::Intersection met = geom::intersect(a, fault.line.segment(j));
      if (met.kind != geom::IntersectionKind::Point) continue;
      const double part = geom::distance(a.from, met.start.point) / geom::distance(a.from, a.to);
      cuts.push_back({static_cast<double>(i) + part, met.start.point, fault.name});
    }
  }
}

/// The fault nearest to a point, if it is near enough.
std::string fault_at(const Section& section, const std::string& name, Point p, double at_fault) {
  std::string nearest;
  double least = at_fault;
  for (const SectionLine& fault : section.lines) {
    if (fault.kind != LineKind::Fault || fault.name == name) continue;
    const double away = geom::distance(fault.line, p);
    if (away <= least) least = away, nearest = fault.name;
  }
  return nearest;
}

geom::Polyline between(const geom::Polyline& line, const Cut& from, const Cut& to) {
  geom::Polyline made{{from.at}, false};
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const auto place = static_cast<double>(i);
    if (place > from.place && place < to.place) made.points.push_back(line.points[i]);
  }
  made.points.push_back(to.at);
  return geom::without_repeated_points(std::move(made));
}

}  // namespace

std::vector<LinePiece> pieces_of(const Section& section, const std::string& name, double at_fault) {
  std::vector<LinePiece> pieces;
  for (const SectionLine& line : section.lines) {
    if (line.name != name) continue;
    std::vector<Cut> cuts;
    for (const SectionLine& fault : section.lines) {
      if (fault.kind == LineKind::Fault && fault.name != name) cuts_by(line.line, fault, cuts);
    }
    std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.place < b.place; });
    const auto& points = line.line.points;
    std::vector<Cut> ends{{0.0, points.front(), fault_at(section, name, points.front(), at_fault)}};
    // What is cut off must reach farther than an end may lie from the fault.
    for (Cut& cut : cuts) {
      if (geom::distance(cut.at, ends.back().at) > at_fault && geom::distance(cut.at, points.back()) > at_fault)
        ends.push_back(std::move(cut));
    }
    ends.push_back(
        {static_cast<double>(points.size() - 1), points.back(), fault_at(section, name, points.back(), at_fault)});
    for (std::size_t i = 1; i < ends.size(); ++i) {
      geom::Polyline part = between(line.line, ends[i - 1], ends[i]);
      if (part.points.size() >= 2) pieces.push_back({std::move(part), ends[i - 1].fault, ends[i].fault});
    }
  }
  return pieces;
}

}  // namespace dobra::surf::loft
