#include "recon/faults/blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "recon/faults/outline.h"
#include "recon/faults/parting.h"
#include "recon/section/face_contours.h"
#include "shared/base/text.h"
#include "shared/geom/place.h"
#include "shared/topo/locate.h"

namespace recon::faults {

using topo::EdgeId;
using topo::FaceId;
using topo::HalfEdgeId;
using topo::Structure;

struct BlockDrawing {
  section::Arrangement arrangement;
  std::vector<geom::Polyline> outline;
  std::vector<std::string> remarks;          ///< On the outline.
  std::vector<std::size_t> fault_of;         ///< By line: its fault, of the first lines.
  std::vector<std::string> names;            ///< Of the faults.
  std::vector<std::vector<HalfEdgeId>> own;  ///< Of each fault along its own line, from the lower end.
  std::vector<BlockId> block_of;             ///< By face, also where there is no rock.
  std::vector<bool> rock;                    ///< By face.
  double rounding = 0.0;                     ///< m

  [[nodiscard]] const topo::Subdivision& sub() const { return arrangement.subdivision(); }
  [[nodiscard]] BlockId left_of(HalfEdgeId h) const { return block_of[sub().face(h).index()]; }
  [[nodiscard]] bool in_rock(HalfEdgeId h) const {
    return rock[sub().face(h).index()] && rock[sub().face(Structure::twin(h)).index()];
  }
  [[nodiscard]] bool touches_rock(HalfEdgeId h) const {
    return rock[sub().face(h).index()] || rock[sub().face(Structure::twin(h)).index()];
  }
  /// Numbers of the faults along an edge.
  [[nodiscard]] std::vector<std::size_t> faults_on(EdgeId e) const {
    std::vector<std::size_t> faults;
    for (const std::uint32_t line : arrangement.lines_on(e)) {
      if (line < fault_of.size()) faults.push_back(fault_of[line]);
    }
    return faults;
  }
};

namespace {

/// The middle of the widest stretch of a level line inside a region, and its width.
std::pair<geom::Point, double> widest_stretch(const std::vector<geom::Polyline>& contours, double y) {
  std::vector<double> crossings;
  for (const geom::Polyline& contour : contours) {
    for (std::size_t i = 0; i < contour.segment_count(); ++i) {
      const auto [a, b] = contour.segment(i);
      if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  std::pair<geom::Point, double> best{{0.0, y}, -1.0};
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (crossings[i + 1] - crossings[i] <= best.second) continue;
    best = {{0.5 * (crossings[i] + crossings[i + 1]), y}, crossings[i + 1] - crossings[i]};
  }
  return best;
}

/// A point well within a region: of the level lines half-way between two vertices, for the farthest such pairs, the
/// middle of the stretch round which the widest and highest trapezium lies.
geom::Point point_inside(const std::vector<geom::Polyline>& contours) {
  std::vector<double> heights;
  for (const geom::Polyline& contour : contours) {
    for (const geom::Point p : contour.points) heights.push_back(p.y);
  }
  std::sort(heights.begin(), heights.end());
  std::vector<std::pair<double, double>> levels;  // height of the trapezium, place
  for (std::size_t i = 0; i + 1 < heights.size(); ++i)
    levels.emplace_back(heights[i + 1] - heights[i], 0.5 * (heights[i] + heights[i + 1]));
  constexpr std::size_t tried = 32;  // the outline may have a spike of no width along a fault
  std::sort(levels.begin(), levels.end(), std::greater<>());
  const std::size_t count = std::min(tried, levels.size());
  geom::Point best;
  double most = -1.0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [middle, width] = widest_stretch(contours, levels[i].second);
    if (width * levels[i].first <= most) continue;
    most = width * levels[i].first;
    best = middle;
  }
  return best;
}

bool inside(const std::vector<geom::Polyline>& outline, geom::Point p) {
  const auto holds = [&](const geom::Polyline& ring) { return geom::locate(ring, p) == geom::Side::Inside; };
  return std::count_if(outline.begin(), outline.end(), holds) % 2 == 1;
}

/// Why a fault parts nothing.
base::Error unparted(const Fault& fault, const std::vector<geom::Polyline>& outline) {
  const auto refuse = [&](geom::Point at, std::string message) {
    return base::Error{base::ErrorCode::BadSection, std::move(message),
                       geom::place_at(at, fmt::format("fault '{}'", fault.name))};
  };
  for (const FaultEnd& end : {fault.lower, fault.upper}) {
    if (end.kind != EndKind::Tip) continue;
    double depth = std::numeric_limits<double>::infinity();
    for (const geom::Polyline& ring : outline) depth = std::min(depth, geom::distance(ring, end.at));
    return refuse(end.at, fmt::format("it ends in rock, {:.4g} m from the border, so that it parts no block; extend "
                                      "it, or take trishear or fault_propagation_fold",
                                      depth));
  }
  for (const FaultEnd& end : {fault.lower, fault.upper}) {
    if (end.kind == EndKind::Cut)
      return refuse(end.at, fmt::format("it ends on '{}', which is younger; move on that one first", end.on));
  }
  return refuse(fault.path.line.points.front(), "it parts no rock of the section; correct it, or add a border");
}

/// Puts the faces of a drawing together to blocks.
class Gatherer {
 public:
  explicit Gatherer(BlockDrawing& drawing) : drawing_(drawing), sub_(drawing.sub()), faces_(sub_.faces()) {}

  std::vector<Block> run() {
    base::DisjointSets sets = cells_of(drawing_.arrangement, drawing_.fault_of.size());
    find_rock(sets.size());
    std::vector<Block> blocks = blocks_of(sets);
    for (Block& block : blocks) complete(block);
    return blocks;
  }

 private:
  /// By how often the outline winds round each face: it changes over each edge by the contours that run along that.
  void find_rock(std::size_t count) {
    drawing_.block_of.assign(count, BlockId());
    drawing_.rock.assign(count, false);
    std::map<HalfEdgeId, int> turns;  // that the left side has more than the right one
    const std::size_t first = drawing_.fault_of.size() + 1;
    for (std::size_t ring = 0; ring < drawing_.outline.size(); ++ring) {
      for (const HalfEdgeId h : drawing_.arrangement.path(static_cast<std::uint32_t>(first + ring))) {
        ++turns[h];
        --turns[Structure::twin(h)];
      }
    }
    std::vector<std::optional<int>> winding(count);
    std::vector<FaceId> open{Structure::unbounded()};
    winding[open.front().index()] = 0;
    while (!open.empty()) {
      const FaceId f = open.back();
      open.pop_back();
      const int here = *winding[f.index()];
      drawing_.rock[f.index()] = here > 0;
      for (const topo::LoopId loop : sub_.loops(f)) {
        for (const HalfEdgeId h : sub_.half_edges(loop)) {
          const FaceId beyond = sub_.face(Structure::twin(h));
          if (winding[beyond.index()]) continue;
          const auto turn = turns.find(h);
          winding[beyond.index()] = here - (turn == turns.end() ? 0 : turn->second);
          open.push_back(beyond);
        }
      }
    }
    for (const FaceId f : faces_) {
      if (!drawing_.rock[f.index()] && is_sliver(f)) drawing_.rock[f.index()] = has_rock_beside(f);
    }
  }

  /// Between a fault and the outline along it, whose crossings are rounded.
  [[nodiscard]] bool is_sliver(FaceId f) const {
    return f != Structure::unbounded() && drawing_.arrangement.area(f) <= 1e6 * drawing_.rounding * drawing_.rounding;
  }
  /// On its own side of the faults.
  [[nodiscard]] bool has_rock_beside(FaceId f) const {
    for (const topo::LoopId loop : sub_.loops(f)) {
      for (const HalfEdgeId h : sub_.half_edges(loop)) {
        const FaceId beyond = sub_.face(Structure::twin(h));
        if (drawing_.rock[beyond.index()] && !is_sliver(beyond) && drawing_.faults_on(Structure::edge(h)).empty())
          return true;
      }
    }
    return false;
  }

  std::vector<Block> blocks_of(base::DisjointSets& sets) {
    std::map<std::size_t, std::vector<FaceId>> rock;  // by set
    std::map<std::size_t, double> areas;
    double all = 0.0;
    for (const FaceId f : faces_) {
      if (!drawing_.rock[f.index()]) continue;
      const double area = drawing_.arrangement.area(f);
      rock[sets.root(f.index())].push_back(f);
      areas[sets.root(f.index())] += area;
      all += area;
    }
    std::vector<std::pair<std::size_t, Block>> found;
    for (const auto& [set, faces] : rock) {
      if (areas.at(set) <= 1e-9 * all) continue;  // between a fault and an outline that are drawn along each other
      Block block;
      block.area = areas.at(set);
      const std::set<FaceId> members(faces.begin(), faces.end());
      block.contours =
          section::contours_round(drawing_.arrangement, faces, [&](FaceId f) { return members.contains(f); });
      block.inside = point_inside(block.contours);
      found.emplace_back(set, std::move(block));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.second.inside < b.second.inside; });
    std::vector<Block> blocks;
    for (auto& [set, block] : found) {
      block.id = BlockId(blocks.size());
      for (const FaceId f : faces_) {
        if (sets.root(f.index()) == set) drawing_.block_of[f.index()] = block.id;
      }
      blocks.push_back(std::move(block));
    }
    return blocks;
  }

  /// The faults that part it from others.
  void complete(Block& block) const {
    std::set<std::size_t> faults;
    for (const EdgeId e : sub_.edges()) {
      const HalfEdgeId h = Structure::half_edge(e);
      const bool here = drawing_.left_of(h) == block.id;
      if (here == (drawing_.left_of(Structure::twin(h)) == block.id)) continue;
      if (!drawing_.rock[sub_.face(here ? h : Structure::twin(h)).index()]) continue;
      for (const std::size_t fault : drawing_.faults_on(e)) faults.insert(fault);
    }
    for (const std::size_t fault : faults) block.faults.push_back(drawing_.names[fault]);
  }

  BlockDrawing& drawing_;
  const topo::Subdivision& sub_;
  std::vector<FaceId> faces_;
};

base::Result<void> name_blocks(const section::Section& section, const std::vector<geom::Polyline>& outline,
                               const Blocks& places, std::vector<Block>& blocks) {
  for (const section::BlockName& name : section.block_names) {
    const auto refuse = [&](const std::string& what) {
      return base::Error{base::ErrorCode::BadSection, what,
                         geom::place_at(name.at, fmt::format("block '{}'", name.name))};
    };
    const BlockId id = places.at(name.at);
    if (!id.valid() || !inside(outline, name.at))
      return refuse("its point lies on a fault or outside the section; give one between the faults that bound it");
    Block& block = blocks[id.index()];
    if (!block.name.empty()) return refuse(fmt::format("its point lies in the block that is called '{}'", block.name));
    block.name = name.name;
    block.part_of = name.part_of;
  }
  int number = 0;
  for (Block& block : blocks) {
    const auto taken = [&](const Block& other) { return other.name == fmt::format("block {}", number); };
    if (!block.name.empty()) continue;
    do ++number;
    while (std::any_of(blocks.begin(), blocks.end(), taken));
    block.name = fmt::format("block {}", number);
  }
  return {};
}

}  // namespace

base::Result<Blocks> Blocks::make(const section::Section& section, const std::vector<Fault>& faults,
                                  const FaultOptions& options) {
  auto drawing = std::make_shared<BlockDrawing>();
  DOBRA_TRY(Outline outline, outline_of(section, faults, options));
  drawing->outline = std::move(outline.rings);
  drawing->remarks = std::move(outline.remarks);
  geom::Box box = box_of(section);
  for (const geom::Polyline& ring : drawing->outline) box.add(ring.box());
  const double size = box.diagonal();
  drawing->rounding = 1e-9 * size;
  const std::vector<geom::Polyline> parting = parting_lines(faults, size);
  std::vector<geom::Polyline> lines;  // one a segment, so that each is an edge as it runs
  for (std::size_t i = 0; i < faults.size(); ++i) {
    const geom::Polyline& line = parting[i];
    drawing->names.push_back(faults[i].name);
    for (std::size_t k = 0; k < line.segment_count(); ++k) {
      lines.push_back({{line.points[k], line.points[k + 1]}, false});
      drawing->fault_of.push_back(i);
    }
  }
  lines.push_back(frame_of(box, size));
  lines.insert(lines.end(), drawing->outline.begin(), drawing->outline.end());
  DOBRA_TRY(drawing->arrangement, section::Arrangement::make(std::move(lines)));
  drawing->own.resize(faults.size());
  for (std::size_t line = 0; line < drawing->fault_of.size(); ++line) {
    const auto path = drawing->arrangement.path(static_cast<std::uint32_t>(line));
    std::vector<HalfEdgeId>& own = drawing->own[drawing->fault_of[line]];
    own.insert(own.end(), path.begin(), path.end());
  }
  Blocks made;
  made.blocks_ = Gatherer(*drawing).run();
  made.drawing_ = std::move(drawing);
  DOBRA_TRY_VOID(name_blocks(section, made.drawing_->outline, made, made.blocks_));
  return made;
}

BlockId Blocks::at(geom::Point p) const {
  const topo::Subdivision& sub = drawing_->sub();
  const topo::Location place = topo::locate(sub, p);
  if (place.where == topo::Where::Face) return drawing_->block_of[place.face.index()];
  if (place.where == topo::Where::Edge) {
    const bool fault = !drawing_->faults_on(place.edge).empty();
    return fault ? BlockId() : drawing_->left_of(Structure::half_edge(place.edge));
  }
  BlockId found;
  for (const HalfEdgeId h : sub.round(place.vertex)) {
    if (!drawing_->faults_on(Structure::edge(h)).empty()) return {};
    found = drawing_->left_of(h);
  }
  return found;
}

std::vector<std::string> Blocks::remarks_on_beds(const section::Section& section) const {
  const double beside = 1e3 * drawing_->rounding;
  const auto bare = [&](const geom::Segment& s) {
    const geom::Vector off = beside * geom::normalised(geom::left_of(s.to - s.from));
    const geom::Point middle = geom::midpoint(s.from, s.to);
    return !inside(drawing_->outline, middle + off) && !inside(drawing_->outline, middle - off);
  };
  std::vector<std::string> remarks = drawing_->remarks;
  for (const section::Horizon& horizon : section.horizons) {
    const std::size_t count = horizon.line.segment_count();
    for (const std::size_t k : {count / 2, count / 4, 3 * count / 4}) {
      const geom::Segment segment = horizon.line.segment(k);
      if (!bare(segment)) continue;
      const geom::Point at = geom::midpoint(segment.from, segment.to);
      remarks.push_back(
          fmt::format("horizon '{}' has rock on neither side at {}: what encloses it is open, so that a block lacks it "
                      "or is missing, and areas there are too small; close the gap (--join-gaps, a larger tolerance), "
                      "let faults reach below the lowest bed, or give a border ([[input.border]])",
                      horizon.name, at));
      break;
    }
  }
  return remarks;
}

base::Result<std::vector<BlockId>> Blocks::hanging_wall(const Fault& fault) const {
  if (fault.undecided) return *fault.undecided;
  const auto number = static_cast<std::size_t>(std::find(drawing_->names.begin(), drawing_->names.end(), fault.name) -
                                               drawing_->names.begin());
  std::set<BlockId> hanging, foot;
  for (const HalfEdgeId h : drawing_->own.at(number)) {
    const bool left = fault.path.hanging == kinematics::Side::Left;
    const BlockId here = drawing_->left_of(left ? h : Structure::twin(h));
    const BlockId there = drawing_->left_of(left ? Structure::twin(h) : h);
    if (here == there || !drawing_->touches_rock(h)) continue;  // in one block: what leads to a tip, or over an end
    hanging.insert(here);
    foot.insert(there);
  }
  hanging.erase(BlockId());
  spread(fault, number, hanging);
  const auto shared = [&](BlockId id) { return hanging.contains(id); };
  if (!hanging.empty() && std::none_of(foot.begin(), foot.end(), shared))
    return std::vector<BlockId>(hanging.begin(), hanging.end());
  return unparted(fault, drawing_->outline);
}

void Blocks::spread(const Fault& fault, std::size_t number, std::set<BlockId>& reached) const {
  const topo::Subdivision& sub = drawing_->sub();
  const bool goes_on = fault.lower.kind == EndKind::Branch || fault.upper.kind == EndKind::Branch;
  std::vector<std::pair<BlockId, BlockId>> neighbours;
  for (const EdgeId e : sub.edges()) {
    const HalfEdgeId h = Structure::half_edge(e);
    const BlockId a = drawing_->left_of(h);
    const BlockId b = drawing_->left_of(Structure::twin(h));
    if (a == b || !a.valid() || !b.valid() || !drawing_->in_rock(h)) continue;
    const std::vector<std::size_t> on = drawing_->faults_on(e);
    if (std::find(on.begin(), on.end(), number) != on.end()) continue;
    const geom::Point middle = geom::midpoint(sub.segment(h).from, sub.segment(h).to);
    if (goes_on && std::abs(kinematics::nearest(fault.path, middle).distance) <= 10.0 * drawing_->rounding) continue;
    neighbours.emplace_back(a, b);
  }
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const auto& [a, b] : neighbours) {
      if (reached.contains(a)) reached.insert(b);
      if (reached.contains(b)) reached.insert(a);
    }
  }
}

namespace {

/// Where the nearest point of a line to p is along it, m; nothing if that is farther off than `near`.
std::optional<double> arc_beside(const geom::Polyline& line, const std::vector<double>& arcs, geom::Point p,
                                 double near) {
  std::optional<double> found;
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const geom::Segment segment = line.segment(i);
    const double distance = geom::distance(segment, p);
    if (distance > near) continue;
    near = distance;
    found = arcs[i] + (arcs[i + 1] - arcs[i]) * geom::nearest_fraction(segment, p);
  }
  return found;
}

/// The part of a line along which a block has corners; empty where these are one place.
geom::Polyline beside(const geom::Polyline& line, const Block& block, double near) {
  const std::vector<double> arcs = geom::arc_lengths(line);
  double from = arcs.back(), to = 0.0;
  for (const geom::Polyline& contour : block.contours) {
    for (const geom::Point p : contour.points) {
      const auto arc = arc_beside(line, arcs, p, near);
      if (!arc) continue;
      from = std::min(from, *arc);
      to = std::max(to, *arc);
    }
  }
  geom::Polyline part;
  if (to - from <= near) return part;
  part.points.push_back(geom::point_at(line, arcs, from));
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (arcs[i] > from + 1e-3 * near && arcs[i] < to - 1e-3 * near) part.points.push_back(line.points[i]);
  }
  part.points.push_back(geom::point_at(line, arcs, to));
  return part;
}

}  // namespace

std::vector<FaultWall> Blocks::walls() const {
  const topo::Subdivision& sub = drawing_->sub();
  std::vector<FaultWall> walls;
  for (std::size_t fault = 0; fault < drawing_->own.size(); ++fault) {
    const std::vector<HalfEdgeId>& own = drawing_->own[fault];
    for (const kinematics::Side side : {kinematics::Side::Left, kinematics::Side::Right}) {
      std::map<BlockId, std::pair<std::size_t, std::size_t>> reaches;  // first and last half-edge
      for (std::size_t i = 0; i < own.size(); ++i) {
        const HalfEdgeId here = side == kinematics::Side::Left ? own[i] : Structure::twin(own[i]);
        const BlockId block = drawing_->left_of(here);
        if (!block.valid() || block == drawing_->left_of(Structure::twin(here))) continue;  // what leads to a tip
        reaches.try_emplace(block, i, i).first->second.second = i;
      }
      for (const auto& [block, reach] : reaches) {
        geom::Polyline line{{sub.segment(own[reach.first]).from}, false};
        for (std::size_t i = reach.first; i <= reach.second; ++i) line.points.push_back(sub.segment(own[i]).to);
        // The outline and the fault may be drawn along each other, with slivers of no rock between them.
        FaultWall wall{fault, side, block, beside(line, blocks_[block.index()], 100.0 * drawing_->rounding)};
        if (!wall.line.points.empty()) walls.push_back(std::move(wall));
      }
    }
  }
  return walls;
}

base::Result<std::vector<BlockId>> Blocks::named(std::span<const std::string> names) const {
  std::set<BlockId> ids;
  for (const std::string& name : names) {
    std::vector<std::string> known;
    bool found = false;
    for (const Block& block : blocks_) {
      known.push_back(block.name);
      if (!block.part_of.empty()) known.push_back(block.part_of);
      if (block.name != name && block.part_of != name) continue;
      ids.insert(block.id);
      found = true;
    }
    if (!found) {
      return base::Error{base::ErrorCode::BadSection,
                         fmt::format("the section has no block '{}'{}", name, base::did_you_mean(name, known)),
                         base::Place{.item = "blocks"}};
    }
  }
  return std::vector<BlockId>(ids.begin(), ids.end());
}

}  // namespace recon::faults
