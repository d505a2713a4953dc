#include "recon/block/cut.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "recon/block/cap_lines.h"
#include "recon/section/section_faces.h"
#include "shared/geom/contour.h"
#include "shared/io/lines/section_plane.h"
#include "shared/solid/cap.h"

// 1. The units' solids say whether the plane cuts the block and how much of each unit. 2. The sheets are cut: lines,
// polygons and border. 3. Section and solids must agree about the area: otherwise this is told.

namespace recon::block {
namespace {

using base::Finding;
using dobra::solid::Contact;
using dobra::solid::CutPlane;
using geom::Point;
using geom::Point3;
using section::Section;

/// The trace's ends lie in the start or end of the block if they are that near.
double snapped(double y, const Block& block, double reach) {
  if (std::abs(y) <= reach) return 0.0;
  return std::abs(y - block.length) <= reach ? block.length : y;
}

CutPlane turned_over(const CutPlane& plane) { return {-plane.a, -plane.b, -plane.c, -plane.d}; }

/// Where a line over the map of the block is in it; empty if nowhere.
Strip over_block(const Block& block, const geom::Box& section, Point3 origin, geom::Vector3 along) {
  Strip strip;
  for (const auto& [at, step, low, high] : {std::array{origin.x, along.x, section.low.x, section.high.x},
                                            std::array{origin.y, along.y, 0.0, block.length}}) {
    if (step == 0.0 && (at < low || at > high)) return {0.0, 0.0};
    if (step == 0.0) continue;
    const auto [first, last] = std::minmax({(low - at) / step, (high - at) / step});
    strip.from = std::max(strip.from, first);
    strip.to = std::min(strip.to, last);
  }
  return strip;
}

/// From 0 to the length of the trace; an end within `reach` of the block's is none. Empty if the trace ends before the
/// block begins.
Strip strip_of(double length, const Strip& over, double reach) {
  Strip strip{0.0, length};
  if (over.empty()) return strip;
  if (over.from >= length - reach || over.to <= reach) return {0.0, 0.0};
  if (over.from >= -reach) strip.from = Strip().from;
  if (over.to <= length + reach) strip.to = Strip().to;
  return strip;
}

/// How much of each unit the solids have in the plane.
void measure_units(const Block& block, const dobra::solid::Cap& cap, BlockCut& made) {
  std::map<std::uint32_t, CutUnit> units;
  for (const dobra::solid::CapRegion& region : cap.regions) {
    CutUnit within{block.units[region.solid].name, region.area, 1};
    if (made.frame.strip.bounded()) {
      within.area = 0.0;
      within.parts = 0;
      for (const geom::Polyline& loop : loops_within(loops_of(region, cap.frame, made.frame), made.frame.strip)) {
        const double area = geom::signed_area(loop);
        within.area += area;
        if (area > 0.0) ++within.parts;
      }
    }
    if (within.parts == 0) continue;
    CutUnit& unit = units[region.solid];
    unit.name = within.name;
    unit.area += within.area;
    unit.parts += within.parts;
    made.area += within.area;
  }
  for (auto& [number, unit] : units) made.units.push_back(std::move(unit));
}

Finding beside_finding() {
  return {"cut_misses", "the trace ends before it comes to the block; the section is empty", {}};
}

Finding empty_finding(Contact contact) {
  const std::string code = fmt::format("cut_touches_{}", dobra::solid::name(contact));
  switch (contact) {
    case Contact::Vertex:
      return {code, "the plane only touches the block, in a vertex; the section is empty", {}};
    case Contact::Edge:
      return {code, "the plane only touches the block, in an edge; the section is empty", {}};
    case Contact::Face:
      return {code, "the plane only touches the block, in a face; the section is empty", {}};
    case Contact::Nothing:
    case Contact::Volume:
      break;
  }
  return {"cut_misses", "the plane misses the block; the section is empty", {}};
}

/// Whether a border is drawn round a section that none is named in.
enum class Border { AsDrawn, Always };

/// Makes the section of the cut sheets, or where a block has none, of the faces that were cut.
class SectionMaker {
 public:
  SectionMaker(const Block& block, const CutFrame& frame, const PlaneSide& side)
      : block_(block), frame_(frame), side_(side) {}

  Section make(const dobra::solid::Cap& cap, Border border, std::vector<Finding>& findings) {
    for (const Sheet& sheet : block_.sheets) add(sheet);
    if (block_.sheets.empty() || border == Border::Always) {
      CapLines faces = block::lines_of(cap, frame_);
      if (!section_.border && (border == Border::Always || faces.named.contains("border")))
        add_border(loops_within(faces.border, frame_.strip));
      if (block_.sheets.empty()) add_faces(std::move(faces), findings);
    }
    add_rails();
    section_.colors = block_.section.colors;
    set_ends();
    if (!split_.empty()) {
      findings.push_back(
          {"cut_in_pieces", fmt::format("the plane cuts {} in several pieces", fmt::join(split_, ", ")), {}});
    }
    if (borders_ > 1) {
      findings.push_back(
          {"cut_border",
           fmt::format("the plane cuts the border in {} loops; the section keeps the greatest", borders_),
           {}});
    }
    return std::move(section_);
  }

 private:
  /// In the plane. What lies on one of the block's ends has one place along it, whatever is rounded.
  [[nodiscard]] Point in_plane(Point3 p) const {
    const bool on_end = p.y == 0.0 || p.y == block_.length;
    const bool upright = frame_.up.x == 0.0 && frame_.up.y == 0.0;
    const geom::Vector3 from = p - frame_.origin;
    if (on_end && upright && frame_.along.y != 0.0) return {from.y / frame_.along.y, dot(from, frame_.up)};
    return {dot(from, frame_.along), dot(from, frame_.up)};
  }

  [[nodiscard]] std::vector<geom::Polyline> lines_of(const Sheet& sheet) const {
    std::vector<geom::Polyline> lines;
    for (const SheetCut& cut : cut_sheet(sheet, side_)) {
      geom::Polyline line{{}, cut.closed};
      for (const Point3 p : cut.points) line.points.push_back(in_plane(p));
      add_within(std::move(line), sheet.origin, lines);
    }
    return from_left(std::move(lines));
  }
  /// What of a line the section has, as lines of its origin run.
  void add_within(geom::Polyline line, Origin origin, std::vector<geom::Polyline>& lines) const {
    line = geom::without_repeated_points(std::move(line));
    if (line.points.size() < (line.closed ? 3U : 2U)) return;
    for (geom::Polyline& piece : line.closed ? loops_within({line}, frame_.strip) : within(line, frame_.strip)) {
      const bool backwards = piece.points.front().x > piece.points.back().x;
      const bool turn = piece.closed ? geom::signed_area(piece) < 0.0 : origin == Origin::Horizon && backwards;
      lines.push_back(turn ? geom::reversed(std::move(piece)) : std::move(piece));
    }
  }
  static std::vector<geom::Polyline> from_left(std::vector<geom::Polyline> lines) {
    std::stable_sort(lines.begin(), lines.end(), [](const geom::Polyline& a, const geom::Polyline& b) {
      return a.box().centre().x < b.box().centre().x;
    });
    return lines;
  }

  /// A name that nothing of this kind has.
  std::string fresh(Origin origin, const std::string& name, std::size_t piece, std::size_t pieces) {
    std::string made = pieces > 1 ? fmt::format("{} ({})", name, piece + 1) : name;
    while (!taken_.insert({origin, made}).second) made += "'";
    return made;
  }

  void add(const Sheet& sheet) { add(sheet.origin, sheet.index, lines_of(sheet)); }
  void add(Origin origin, std::size_t index, std::vector<geom::Polyline> lines) {
    if (origin == Origin::Border) return add_border(std::move(lines));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      switch (origin) {
        case Origin::Horizon:
          add_horizon(block_.section.horizons[index], std::move(lines[i]), i, lines.size());
          break;
        case Origin::Line:
          add_line(block_.section.lines[index], std::move(lines[i]), i, lines.size());
          break;
        default:
          add_unit(block_.section.units[index], std::move(lines[i]), i, lines.size());
          break;
      }
    }
  }

  /// Lines of the faces between sections go as in the section in front.
  void add_faces(CapLines faces, std::vector<Finding>& findings) {
    std::vector<std::string> lost;
    const auto add_named = [&](Origin origin, std::size_t index, const std::string& name, const std::string& shown) {
      std::vector<geom::Polyline> lines;
      for (geom::Polyline& line : faces.named[name]) add_within(std::move(line), origin, lines);
      if (!bounds_a_unit(name)) {
        lost.push_back(shown);
      } else if (origin == Origin::Line && lines.size() > 1) {
        lost.push_back(fmt::format("{} between its pieces", shown));
      }
      add(origin, index, from_left(std::move(lines)));
    };
    const Section& front = block_.section;
    if (front.units.empty()) {
      for (std::size_t i = 0; i < front.horizons.size(); ++i) {
        const std::string& name = front.horizons[i].name;
        add_named(Origin::Horizon, i, "horizon " + name, fmt::format("horizon '{}'", name));
      }
    } else {
      add_units(faces);
    }
    for (std::size_t i = 0; i < front.lines.size(); ++i) {
      const section::SectionLine& line = front.lines[i];
      if (line.kind != section::LineKind::Fault && line.kind != section::LineKind::Topography) continue;
      const std::string kind = kind_name(line.kind);
      for (geom::Polyline& course : faces.named[kind + " " + line.name]) {
        if (against(course, line.line)) course = geom::reversed(std::move(course));
      }
      add_named(Origin::Line, i, kind + " " + line.name, fmt::format("{} '{}'", kind, line.name));
    }
    for (const section::Marker& marker : front.markers) lost.push_back(fmt::format("marker '{}'", marker.name));
    if (!lost.empty()) {
      findings.push_back({"cut_left_out",
                          fmt::format("what bounds no unit is not of a block between sections: {}; cut through their "
                                      "surfaces to have it",
                                      fmt::join(lost, ", ")),
                          {}});
    }
  }
  [[nodiscard]] bool bounds_a_unit(const std::string& name) const {
    return std::any_of(block_.units.begin(), block_.units.end(), [&](const BlockUnit& unit) {
      return std::find(unit.shape.names.begin(), unit.shape.names.end(), name) != unit.shape.names.end();
    });
  }
  /// Whether a line goes the other way than the one of the section in front.
  [[nodiscard]] bool against(const geom::Polyline& course, const geom::Polyline& drawn) const {
    geom::Vector as_drawn = drawn.points.back() - drawn.points.front();
    if (frame_.along.x < 0.0) as_drawn.x = -as_drawn.x;
    return dot(course.points.back() - course.points.front(), as_drawn) < 0.0;
  }
  void add_units(const CapLines& faces) {
    for (std::size_t u = 0; u < block_.section.units.size(); ++u) {
      const section::Unit& unit = block_.section.units[u];
      const std::string& whole = unit.piece_of.empty() ? unit.name : unit.piece_of;
      const auto same = [&](const section::Unit& other) {
        return (other.piece_of.empty() ? other.name : other.piece_of) == whole;
      };
      if (std::find_if(block_.section.units.begin(), block_.section.units.end(), same) !=
          block_.section.units.begin() + static_cast<std::ptrdiff_t>(u))
        continue;  // its first piece has them all
      std::vector<geom::Polyline> contours;
      for (const auto& [number, contour] : faces.contours) {
        const std::string& name = block_.units[number].name;
        if (name == whole || name == unit.name) add_within(contour, Origin::Unit, contours);
      }
      add(Origin::Unit, u, from_left(std::move(contours)));
    }
  }

  void add_horizon(section::Horizon horizon, geom::Polyline line, std::size_t piece, std::size_t pieces) {
    if (pieces > 1) {
      if (piece == 0) split_.push_back(fmt::format("horizon '{}'", horizon.name));
      horizon.piece_of = whole_name(horizon);
    }
    horizon.name = fresh(Origin::Horizon, horizon.name, piece, pieces);
    horizon.id = section::HorizonId(section_.horizons.size());
    horizon.line = std::move(line);
    section_.horizons.push_back(std::move(horizon));
  }

  void add_line(section::SectionLine line, geom::Polyline course, std::size_t piece, std::size_t pieces) {
    if (pieces > 1) {
      if (piece == 0) split_.push_back(fmt::format("{} '{}'", kind_name(line.kind), line.name));
      if (line.kind == section::LineKind::Fault) line.piece_of = whole_name(line);
    }
    line.name = fresh(Origin::Line, line.name, piece, pieces);
    line.id = section::LineId(section_.lines.size());
    line.line = std::move(course);
    const bool left = line.hanging_wall == section::HangingWall::Left;
    if (left || line.hanging_wall == section::HangingWall::Right) {
      using section::HangingWall;
      line.hanging_wall = frame_.along.x == 0.0            ? HangingWall::Auto
                          : (frame_.along.x < 0.0) == left ? HangingWall::Right
                                                           : HangingWall::Left;
    }
    section_.lines.push_back(std::move(line));
  }

  void add_unit(section::Unit unit, geom::Polyline contour, std::size_t piece, std::size_t pieces) {
    if (pieces > 1) {
      if (piece == 0) split_.push_back(fmt::format("unit '{}'", unit.name));
      if (unit.piece_of.empty()) unit.piece_of = unit.name;
    }
    unit.name = fresh(Origin::Unit, unit.name, piece, pieces);
    unit.id = section::UnitId(section_.units.size());
    unit.contour = std::move(contour);
    section_.units.push_back(std::move(unit));
  }

  void add_border(std::vector<geom::Polyline> loops) {
    borders_ = loops.size();
    for (geom::Polyline& loop : loops) {
      if (!section_.border || geom::signed_area(loop) > geom::signed_area(*section_.border))
        section_.border = std::move(loop);
    }
  }

  void add_rails() {
    for (const Rail& rail : block_.rails) {
      const auto met = cut_rail(rail, side_);
      if (!met) continue;
      const Point at = in_plane(*met);
      if (!frame_.strip.holds(at)) continue;
      if (rail.origin == Origin::BlockName) {
        section::BlockName named = block_.section.block_names[rail.index];
        named.at = at;
        section_.block_names.push_back(std::move(named));
        continue;
      }
      const section::Marker& marker = block_.section.markers[rail.index];
      if (section_.markers.empty() || section_.markers.back().name != marker.name)
        section_.markers.push_back({section::MarkerId(section_.markers.size()), marker.name, {}, marker.source});
      section_.markers.back().points.push_back(at);
    }
  }

  void set_ends() {
    const geom::Vector3 along = frame_.along;
    if (block_.placed) {
      const dobra::io::lines::Trace& trace = block_.trace;
      const dobra::io::lines::Trace run{0.0, 0.0, along.x * trace.east - along.y * trace.north,
                                        along.x * trace.north + along.y * trace.east};
      std::tie(section_.left_end, section_.right_end) = dobra::io::lines::ends_of(dobra::io::lines::azimuth_of(run));
    } else if (along.y == 0.0) {
      section_.left_end = block_.section.left_end;
      section_.right_end = block_.section.right_end;
      if (along.x < 0.0) std::swap(section_.left_end, section_.right_end);
    }
  }

  const Block& block_;
  const CutFrame& frame_;
  const PlaneSide& side_;
  Section section_;
  std::set<std::pair<Origin, std::string>> taken_;
  std::vector<std::string> split_;
  std::size_t borders_ = 0;
};

/// Of the units that the lines of a section bound.
double area_of(const section::SectionFaces& faces) {
  double area = 0.0;
  for (const section::RockUnit& unit : faces.units) area += unit.area;
  return area;
}

/// Whether the lines of a section bound what the solids have in the plane.
bool agrees(double area, const BlockCut& cut) {
  constexpr double rounding = 1e-9;
  return !cut.section.units.empty() || std::abs(area - cut.area) <= rounding * cut.area;
}

/// Faces of the section, and whether its units have the area that the solids have in the plane.
void make_faces(BlockCut& cut) {
  auto faces = faces_of(cut.section);
  if (!faces) {
    cut.findings.push_back(flaw_finding(faces.error()));
    return;
  }
  const double area = area_of(*faces);
  if (!agrees(area, cut)) {
    cut.findings.push_back(
        {"cut_area",
         fmt::format("the section's lines bound {:.9g} m2, and the block has {:.9g} m2 in the plane; "
                     "give a border",
                     area, cut.area),
         {}});
  }
  cut.section.faces = std::make_shared<const section::SectionFaces>(std::move(*faces));
}

}  // namespace

Finding flaw_finding(const base::Error& error) {
  return {"cut_flawed", fmt::format("RECON has this against the section as it stands: {}", error.message),
          error.place.value_or(base::Place{})};
}

base::Result<CutFrame> cut_over(const Block& block, Point from, Point to, const CutOptions& options) {
  DOBRA_TRY_VOID(dobra::io::lines::trace_between(from, to));
  Point3 a = block.in_block({from.x, from.y, 0.0});
  Point3 b = block.in_block({to.x, to.y, 0.0});
  geom::Box section;
  for (const Sheet& sheet : block.sheets) {
    for (const Point3 p : sheet.stations[0]) section.add(Point{p.x, p.z});
  }
  if (block.sheets.empty()) {
    for (const BlockUnit& unit : block.units) {
      for (const Point3 p : unit.shape.mesh.points) section.add(Point{p.x, p.z});
    }
  }
  const double reach = options.snap * std::max({block.length, std::abs(section.low.x), std::abs(section.high.x),
                                                std::abs(block.trace.x), std::abs(block.trace.y)});
  const double a_snapped = snapped(a.y, block, reach);
  const double b_snapped = snapped(b.y, block, reach);
  if (a_snapped == b_snapped) {
    a.y = a_snapped;
    b.y = b_snapped;
  }
  CutFrame frame;
  frame.origin = a;
  frame.along = a.y == b.y ? geom::Vector3{b.x > a.x ? 1.0 : -1.0, 0.0, 0.0} : normalised(b - a);
  frame.up = {0.0, 0.0, 1.0};
  // Not divided by the length of the trace, so that a plane through round numbers is one exactly.
  const geom::Vector3 run = a.y == b.y ? frame.along : b - a;
  frame.plane = {run.y, -run.x, 0.0, run.x * a.y - run.y * a.x};
  frame.strip = strip_of(length(b - a), over_block(block, section, a, frame.along), reach);
  return frame;
}

base::Result<CutFrame> cut_by(const Block& block, const CutPlane& on_map) {
  const auto& trace = block.trace;
  const CutPlane plane{on_map.a * trace.east + on_map.b * trace.north, on_map.b * trace.east - on_map.a * trace.north,
                       on_map.c, on_map.d + on_map.a * trace.x + on_map.b * trace.y};
  DOBRA_TRY(const dobra::solid::SectionFrame frame, dobra::solid::frame_of(plane));
  return CutFrame{plane, frame.origin, frame.along, frame.up, {}};
}

base::Result<BlockCut> cut(const Block& block, const CutFrame& frame) {
  BlockCut made;
  made.frame = frame;
  if (frame.strip.empty()) {
    made.findings.push_back(beside_finding());
    return made;
  }
  DOBRA_TRY(const dobra::solid::Section section, block.sections->cut(frame.plane));
  dobra::solid::Cap cap = cap_of(section);
  std::vector<dobra::solid::Solid> solids;
  for (const BlockUnit& unit : block.units) solids.push_back(unit.solid);
  DOBRA_TRY(const dobra::solid::PlaneContact contact, contact_with(solids, frame.plane));
  made.contact = cap.empty() ? contact.most : Contact::Volume;
  if (contact.in_face) {
    const CutPlane over = turned_over(frame.plane);
    DOBRA_TRY(dobra::solid::Section other, block.sections->cut(over));
    dobra::solid::Cap other_cap = cap_of(other);
    if (cap.empty()) {  // the block lies on the other side
      made.frame.plane = over;
      cap = std::move(other_cap);
    } else if (!other_cap.empty()) {
      made.findings.push_back(
          {"cut_in_face", "a face of the block lies in the plane; the section has the units on one side of it", {}});
    }
  }
  if (cap.empty()) {
    made.findings.push_back(empty_finding(made.contact));
    return made;
  }
  measure_units(block, cap, made);
  if (made.empty()) {
    made.contact = Contact::Nothing;
    made.findings.push_back(beside_finding());
    return made;
  }
  const PlaneSide side(made.frame.plane);
  std::vector<Finding> of_lines;
  made.section = SectionMaker(block, made.frame, side).make(cap, Border::AsDrawn, of_lines);
  if (const auto faces = faces_of(made.section); !faces || !agrees(area_of(*faces), made)) {
    // Sides are drawn straight from end to end of the horizons, where the block has a fault, or what bends.
    std::vector<Finding> of_bordered;
    BlockCut bordered = made;
    bordered.section = SectionMaker(block, made.frame, side).make(cap, Border::Always, of_bordered);
    const auto better = faces_of(bordered.section);
    if (block.sheets.empty() || (better && agrees(area_of(*better), bordered))) {
      made.section = std::move(bordered.section);
      of_lines = std::move(of_bordered);
    }
  }
  made.findings.insert(made.findings.end(), of_lines.begin(), of_lines.end());
  make_faces(made);
  return made;
}

}  // namespace recon::block
