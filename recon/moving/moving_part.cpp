#include "recon/moving/moving_part.h"

#include <algorithm>
#include <utility>

#include "recon/section/face_contours.h"
#include "shared/geom/intersect.h"
#include "shared/topo/locate.h"
#include "shared/topo/region.h"

namespace recon::moving {

namespace {

/// Of the section's size: what is nearer than this is one place.
constexpr double one_place = 1e-9;

/// By face of an arrangement, whether the contours from line `first` on hold it.
base::Result<std::vector<Fate>> fates_in(const section::Arrangement& arrangement, std::uint32_t first,
                                         const std::vector<geom::Polyline>& contours) {
  const std::vector<std::string> names(contours.size(), "block");
  DOBRA_TRY(const auto holders, arrangement.holders(first, names));
  std::vector<Fate> fates;
  for (const std::vector<std::uint32_t>& rings : holders) {
    int held = 0;
    for (const std::uint32_t ring : rings) held += geom::signed_area(contours[ring]) > 0.0 ? 1 : -1;
    fates.push_back(held > 0 ? Fate::Moves : Fate::Stays);
  }
  return fates;
}

/// A line with its cuts as further vertices.
struct Cut {
  geom::Point at;
  bool given = true;  ///< A vertex of the line.
  bool cut = false;   ///< The boundary passes here.
};

void add(Cut next, std::vector<Cut>& cuts) {
  if (cuts.empty() || !(cuts.back().at == next.at)) {
    cuts.push_back(next);
    return;
  }
  cuts.back().given |= next.given;
  cuts.back().cut |= next.cut;
}

/// Segments of a line that are asked together whether the boundary is near.
constexpr std::size_t run = 32;

bool is_near(const geom::SpatialIndex& sides, const geom::Polyline& line, std::size_t from, std::size_t to) {
  geom::Box box;
  for (std::size_t i = from; i < to; ++i) box.add(line.segment(i).box());
  bool near = false;
  sides.for_each_overlapping(box, [&](std::size_t) {
    near = true;
    return geom::Visit::Stop;
  });
  return near;
}

/// A line with vertices where it meets the boundary.
/// @param index  of the sides, grown by what counts as on the boundary.
template <class OnBoundary>
std::vector<Cut> cuts_of(const geom::Polyline& line, const std::vector<geom::Segment>& sides,
                         const geom::SpatialIndex& index, const OnBoundary& on_boundary) {
  std::vector<Cut> cuts;
  bool near = false;
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    if (i % run == 0) near = is_near(index, line, i, std::min(i + run, line.segment_count()));
    const geom::Segment segment = line.segment(i);
    if (!near) {
      add({segment.from, true, false}, cuts);
      add({segment.to, true, false}, cuts);
      continue;
    }
    std::vector<geom::Point> places;
    bool beside = false;
    index.for_each_overlapping(segment.box(), [&](std::size_t side) {
      beside = true;
      const geom::Intersection met = geom::intersect(segment, sides[side]);
      if (met.kind == geom::IntersectionKind::None) return;
      places.push_back(met.start.point);
      if (met.kind == geom::IntersectionKind::Overlap) places.push_back(met.end.point);
    });
    geom::sort_along(segment, places);
    add({segment.from, true, beside && on_boundary(segment.from)}, cuts);
    for (const geom::Point p : places) add({p, false, true}, cuts);
    add({segment.to, true, beside && on_boundary(segment.to)}, cuts);
  }
  return cuts;
}

geom::Point middle_of_longest(const std::vector<Cut>& cuts, std::size_t from, std::size_t to) {
  std::size_t longest = from;
  for (std::size_t i = from; i < to; ++i) {
    if (geom::distance(cuts[i].at, cuts[i + 1].at) > geom::distance(cuts[longest].at, cuts[longest + 1].at))
      longest = i;
  }
  return geom::interpolate(cuts[longest].at, cuts[longest + 1].at, 0.5);
}

double length_of(const std::vector<Cut>& cuts, std::size_t from, std::size_t to) {
  double length = 0.0;
  for (std::size_t i = from; i < to; ++i) length += geom::distance(cuts[i].at, cuts[i + 1].at);
  return length;
}

/// From cut to cut of `cuts`.
struct Range {
  std::size_t from = 0;
  std::size_t to = 0;
  Fate fate = Fate::Stays;
  bool along = false;  ///< It runs along the boundary.
};

/// What runs along the boundary goes with its neighbours; from a part that moves to one that stays it is no part of the
/// line but of the fault.
void settle_along(std::vector<Range>& ranges) {
  std::vector<Range> settled;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    Range range = ranges[i];
    if (range.along) {
      const auto next = std::find_if(ranges.begin() + static_cast<std::ptrdiff_t>(i), ranges.end(),
                                     [](const Range& r) { return !r.along; });
      const Range* before = settled.empty() ? nullptr : &settled.back();
      const Range* behind = next == ranges.end() ? nullptr : &*next;
      if (before != nullptr && behind != nullptr && before->fate != behind->fate) continue;
      if (before != nullptr || behind != nullptr) range.fate = before != nullptr ? before->fate : behind->fate;
    }
    settled.push_back(range);
  }
  ranges = std::move(settled);
}

/// Neighbours of one fate become one.
void join(std::vector<Range>& ranges) {
  std::vector<Range> joined;
  for (const Range& range : ranges) {
    if (!joined.empty() && joined.back().fate == range.fate) {
      joined.back().to = range.to;
    } else {
      joined.push_back(range);
    }
  }
  ranges = std::move(joined);
}

/// Ranges that are hardly there take the fate of a neighbour.
void drop_short(const std::vector<Cut>& cuts, double least, std::vector<Range>& ranges) {
  for (std::size_t i = 0; i < ranges.size() && ranges.size() > 1; ++i) {
    if (length_of(cuts, ranges[i].from, ranges[i].to) >= least) continue;
    ranges[i].fate = i == 0 ? ranges[1].fate : ranges[i - 1].fate;
  }
  join(ranges);
}

geom::Polyline line_of(const std::vector<Cut>& cuts, const Range& range) {
  geom::Polyline line;
  for (std::size_t i = range.from; i <= range.to; ++i) {
    if (cuts[i].given || i == range.from || i == range.to) line.points.push_back(cuts[i].at);
  }
  return line;
}

/// Ends that reach across the boundary by no more than `overshoot` and are shorter than what they belong to. @return
/// what was cut off at both ends, m.
std::pair<double, double> trim(const std::vector<Cut>& cuts, double overshoot, std::vector<Range>& ranges) {
  std::pair<double, double> trimmed{0.0, 0.0};
  const auto settle = [&](Range& end, const Range& next, double& cut_off) {
    const double length = length_of(cuts, end.from, end.to);
    if (length > overshoot || length > length_of(cuts, next.from, next.to)) return;
    if (next.fate == Fate::Moves) {
      cut_off = length;
      end.to = end.from;
    } else {
      end.fate = Fate::Stays;
    }
  };
  if (ranges.size() > 1) settle(ranges.front(), ranges[1], trimmed.first);
  if (ranges.size() > 1) settle(ranges.back(), ranges[ranges.size() - 2], trimmed.second);
  std::erase_if(ranges, [](const Range& range) { return range.from == range.to; });
  join(ranges);
  return trimmed;
}

/// A closed line begins where it is cut: what stands before its first cut goes on behind its last part.
void close_up(std::vector<LinePart>& parts) {
  if (parts.size() < 2 || parts.front().fate != parts.back().fate) return;
  std::vector<geom::Point>& last = parts.back().line.points;
  last.insert(last.end(), parts.front().line.points.begin() + 1, parts.front().line.points.end());
  parts.erase(parts.begin());
}

}  // namespace

void MovingPart::index_sides(const std::vector<geom::Polyline>& lines) {
  std::vector<geom::Box> boxes;
  for (const geom::Polyline& line : lines) {
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
      sides_.push_back(line.segment(i));
      boxes.push_back(sides_.back().box().grown(near_));
    }
  }
  index_ = geom::SpatialIndex(boxes);
}

MovingPart MovingPart::of_walls(kinematics::FaultPath path, double size) {
  MovingPart part;
  part.near_ = one_place * size;
  part.index_sides({path.line});
  part.walls_ = std::move(path);
  return part;
}

base::Result<MovingPart> MovingPart::of_blocks(const std::vector<geom::Polyline>& contours, double size) {
  MovingPart part;
  part.near_ = one_place * size;
  DOBRA_TRY(part.contours_, topo::region(contours, topo::Inside::Positive));
  part.index_sides(part.contours_);
  DOBRA_TRY(section::Arrangement faces, section::Arrangement::make(part.contours_));
  DOBRA_TRY(part.fates_, fates_in(faces, 0, part.contours_));
  part.faces_ = std::make_shared<const section::Arrangement>(std::move(faces));
  return part;
}

bool MovingPart::on_boundary(geom::Point p) const {
  bool found = false;
  index_.for_each_overlapping({p, p}, [&](std::size_t side) {
    found = geom::distance(sides_[side], p) <= near_;
    return found ? geom::Visit::Stop : geom::Visit::Continue;
  });
  return found;
}

Fate MovingPart::fate_of(geom::Point p) const {
  if (on_boundary(p)) return Fate::Stays;
  if (walls_) return wall_of(*walls_, p) == kinematics::Wall::Hanging ? Fate::Moves : Fate::Stays;
  const topo::Location place = topo::locate(faces_->subdivision(), p);
  return place.where == topo::Where::Face ? fates_[place.face.index()] : Fate::Stays;
}

bool MovingPart::crosses(const geom::Polyline& line) const {
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    bool found = false;
    const geom::Segment segment = line.segment(i);
    index_.for_each_overlapping(segment.box(), [&](std::size_t side) {
      found = geom::intersect(segment, sides_[side]).kind != geom::IntersectionKind::None;
      return found ? geom::Visit::Stop : geom::Visit::Continue;
    });
    if (found) return true;
  }
  return false;
}

std::vector<LinePart> MovingPart::split(const geom::Polyline& line, double overshoot) const {
  const std::vector<Cut> cuts = cuts_of(line, sides_, index_, [&](geom::Point p) { return on_boundary(p); });
  std::vector<Range> ranges;
  for (std::size_t from = 0, i = 1; i < cuts.size(); ++i) {
    if (!cuts[i].cut && i + 1 < cuts.size()) continue;
    const geom::Point middle = middle_of_longest(cuts, from, i);
    ranges.push_back({from, i, fate_of(middle), on_boundary(middle)});
    from = i;
  }
  if (!line.closed) settle_along(ranges);
  join(ranges);
  drop_short(cuts, near_, ranges);
  const std::pair<double, double> trimmed = trim(cuts, line.closed ? 0.0 : overshoot, ranges);
  if (ranges.size() < 2 && trimmed.first + trimmed.second == 0.0)
    return {{line, ranges.empty() ? fate_of(line.points.front()) : ranges.front().fate}};
  std::vector<LinePart> parts;
  for (const Range& range : ranges) parts.push_back({line_of(cuts, range), range.fate});
  parts.front().trimmed += trimmed.first;
  parts.back().trimmed += trimmed.second;
  if (line.closed) close_up(parts);
  return parts;
}

base::Result<std::vector<Fate>> MovingPart::fates_of_faces(const section::Arrangement& arrangement) const {
  if (!walls_) return fates_in(arrangement, 1, contours_);
  std::vector<Fate> fates;
  for (const topo::FaceId face : arrangement.subdivision().faces()) {
    geom::Segment longest;
    for (const geom::Polyline& contour : section::contours_of(arrangement, face)) {
      for (std::size_t i = 0; i < contour.segment_count(); ++i) {
        const geom::Segment side = contour.segment(i);
        if (side.length() > longest.length() && !on_boundary(geom::interpolate(side.from, side.to, 0.5)))
          longest = side;
      }
    }
    fates.resize(std::max(fates.size(), face.index() + 1), Fate::Stays);
    fates[face.index()] = fate_of(geom::interpolate(longest.from, longest.to, 0.5));
  }
  return fates;
}

base::Result<std::vector<LinePart>> MovingPart::split_area(const geom::Polyline& contour) const {
  const std::vector<LinePart> outline = split(contour);
  if (outline.size() == 1 && (outline.front().fate == Fate::Moves || !crosses(contour))) return outline;
  std::vector<geom::Polyline> lines{contour};
  lines.insert(lines.end(), contours_.begin(), contours_.end());
  if (walls_) lines.push_back(walls_->line);
  DOBRA_TRY(const section::Arrangement arrangement, section::Arrangement::make(std::move(lines)));
  DOBRA_TRY(const auto inside, arrangement.holders(0, {"unit"}));
  DOBRA_TRY(const std::vector<Fate> fates, fates_of_faces(arrangement));
  std::vector<LinePart> parts;
  for (const topo::FaceId face : arrangement.subdivision().faces()) {
    if (inside[face.index()].empty() || arrangement.area(face) <= near_ * near_) continue;
    for (geom::Polyline& outer : section::contours_of(arrangement, face)) {
      if (geom::signed_area(outer) > 0.0) parts.push_back({std::move(outer), fates[face.index()]});
    }
  }
  if (parts.size() == 1) parts.front().line = contour;
  return parts;
}

geom::Point MovingPart::image(geom::Point p, const kinematics::BlockMap& map) const {
  const bool moves = fate_of(p) == Fate::Moves;
  if (walls_) return map.forward(p, moves ? kinematics::Wall::Hanging : kinematics::Wall::Foot);
  return moves ? map.forward(p) : p;
}

geom::Polyline MovingPart::image(const LinePart& part, const kinematics::BlockMap& map) const {
  if (!walls_ && part.fate == Fate::Stays) return part.line;
  kinematics::MovedLine moved =
      map.forward(part.line, part.fate == Fate::Moves ? kinematics::Wall::Hanging : kinematics::Wall::Foot);
  return moved.before.points == moved.after.points ? part.line : std::move(moved.after);
}

geom::Polyline MovingPart::image(const geom::Polyline& line, const kinematics::BlockMap& map) const {
  geom::Polyline whole{{}, line.closed};
  for (const LinePart& part : split(line)) {
    const geom::Polyline moved = image(part, map);
    whole.points.insert(whole.points.end(), moved.points.begin(), moved.points.end());
  }
  return geom::without_repeated_points(std::move(whole));
}

}  // namespace recon::moving
