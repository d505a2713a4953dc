#include "recon/moving/move_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "recon/faults/blocks.h"
#include "recon/faults/cutoffs.h"
#include "recon/moving/block_area.h"
#include "recon/moving/section_mover.h"
#include "recon/section/section_faces.h"
#include "shared/geom/place.h"
#include "shared/topo/region.h"

namespace recon::moving {

namespace {

using faults::Fault;
using kinematics::FaultPath;
using section::Section;

base::Error bad(base::ErrorCode code, std::string message, geom::Point at, const std::string& fault) {
  return {code, std::move(message), place_at(at, fmt::format("fault '{}'", fault))};
}

std::string at_text(geom::Point p) { return fmt::format("{}", p); }

/// What a move stands on: the fault as its slip is counted, and the horizons that it cuts.
struct Setting {
  Fault fault;
  FaultPath path;  ///< Along which slip is measured: a rigid block goes along the fault's own part.
  faults::FaultCutoffs cutoffs;
  std::vector<CutHorizon> cut;  ///< On both walls, the uppermost first.
  double size = 0.0;            ///< Of the section, m.
  double tolerance = 0.0;       ///< Of cutoffs, m.
};

/// The path so that S > 0 goes towards its last point.
base::Result<void> orient(Fault& fault, Towards towards) {
  FaultPath& path = fault.path;
  const geom::Point first = path.line.points.front();
  if (!path.level) {
    if (towards == Towards::Auto) return {};
    return bad(base::ErrorCode::BadValue,
               "'towards' is for faults with level ends; up is towards the higher end of this one, at " +
                   at_text(path.line.points.back()),
               first, fault.name);
  }
  if (towards == Towards::Auto) {
    return bad(
        base::ErrorCode::BadValue,
        fmt::format("the ends of fault '{}' are equally high, so that up is neither way; say which way the "
                    "hanging wall goes for a slip above 0: towards = \"x\" or \"-x\" (--towards x, --towards=-x)",
                    fault.name),
        first, fault.name);
  }
  const bool to_last = (path.line.points.back().x > first.x) == (towards == Towards::PlusX);
  if (to_last) return {};
  const double length = geom::length(path.line);
  path.line = geom::reversed(std::move(path.line));
  path.hanging = path.hanging == kinematics::Side::Left ? kinematics::Side::Right : kinematics::Side::Left;
  std::swap(path.tip_at_begin, path.tip_at_end);
  fault.own_from = length - std::exchange(fault.own_to, length - fault.own_from);
  return {};
}

/// @param all  by value: the fault runs as its slip is counted.
base::Result<Setting> setting_of(const Section& section, const MoveParams& params, std::vector<Fault> all,
                                 const faults::FaultOptions& options) {
  DOBRA_TRY(const Fault* found, find_fault(all, params.fault));
  if (found->undecided) return *found->undecided;
  const auto which = static_cast<std::size_t>(found - all.data());
  DOBRA_TRY_VOID(orient(all[which], params.towards));
  Setting setting{all[which], {}, {}, {}, box_of(section).diagonal(), tolerance_of(section, options)};
  setting.path = setting.fault.path;
  if (params.method == MoveMethod::Rigid) setting.path.line = own_line(setting.fault);
  setting.cutoffs = cutoffs_at(section, all, which, options);
  for (const faults::CutoffPair& pair : setting.cutoffs.pairs) {
    if (!pair.hanging_wall || !pair.footwall || pair.hanging_wall->passes) continue;
    setting.cut.push_back(
        {pair.horizon, pair.hanging_wall->at, pair.footwall->at, pair.hanging_wall->arc, pair.footwall->arc});
  }
  return setting;
}

/// The pair of a horizon whose cutoffs are to meet.
base::Result<CutHorizon> cut_to_close(const Setting& setting, const std::string& horizon) {
  std::vector<const faults::CutoffPair*> pairs;
  std::string places;
  for (const faults::CutoffPair& pair : setting.cutoffs.pairs) {
    if (pair.horizon != horizon) continue;
    pairs.push_back(&pair);
    for (const auto& wall : {pair.hanging_wall, pair.footwall}) {
      if (wall) places += (places.empty() ? "" : ", ") + at_text(wall->at);
    }
  }
  const std::string& fault = setting.fault.name;
  const geom::Point end = setting.fault.path.line.points.back();
  if (pairs.size() > 1) {
    return bad(base::ErrorCode::BadSection,
               fmt::format("horizon '{}' has several cutoffs on a wall of fault '{}', {}, so that no pair of them is "
                           "certain; close another horizon, or give the slip",
                           horizon, fault, places),
               end, fault);
  }
  for (const CutHorizon& cut : setting.cut) {
    if (cut.horizon == horizon) return cut;
  }
  const char* missing = pairs.empty()                 ? "either wall"
                        : pairs.front()->hanging_wall ? "the footwall"
                                                      : "the hanging wall";
  if (!pairs.empty() && pairs.front()->hanging_wall && pairs.front()->footwall) {
    return bad(base::ErrorCode::BadSection,
               fmt::format("horizon '{}' runs across fault '{}' at {} without being cut, so that there is nothing to "
                           "close; close another horizon, or give the slip",
                           horizon, fault, places),
               pairs.front()->footwall->at, fault);
  }
  return bad(base::ErrorCode::BadSection,
             fmt::format("horizon '{}' has no cutoff on {} of fault '{}', so that no slip closes it; extend it to the "
                         "fault, raise the tolerance, or give the slip",
                         horizon, missing, fault),
             places.empty()
                 ? end
                 : (pairs.front()->hanging_wall ? pairs.front()->hanging_wall->at : pairs.front()->footwall->at),
             fault);
}

/// Where on the path slip is measured: at the uppermost horizon that the fault cuts, or at that of `at`.
base::Result<double> measured_at(const Setting& setting, const MoveParams& params, std::vector<std::string>& remarks) {
  for (const faults::CutoffPair& pair : setting.cutoffs.pairs) {
    if (pair.hanging_wall && (params.at.empty() || pair.horizon == params.at)) return pair.hanging_wall->arc;
  }
  const FaultPath& path = setting.fault.path;
  if (!params.at.empty()) {
    return bad(base::ErrorCode::BadValue,
               fmt::format("horizon '{}' has no cutoff in the hanging wall of fault '{}', so that slip cannot be "
                           "measured there",
                           params.at, setting.fault.name),
               path.line.points.back(), setting.fault.name);
  }
  if (params.method == MoveMethod::Shear)
    remarks.push_back("the fault cuts no horizon; slip is measured at its higher end");
  return geom::length(path.line);
}

base::Result<Motion> motion_of(const Setting& setting, const MoveParams& params, std::vector<std::string>& remarks) {
  DOBRA_TRY(const double arc, measured_at(setting, params, remarks));
  using kinematics::Measure;
  const FaultPath& path = setting.path;
  if (params.slip) return make_motion(path, params, {Measure::Slip, *params.slip}, arc);
  if (params.heave) return make_motion(path, params, {Measure::Heave, *params.heave}, arc);
  if (params.throw_) return make_motion(path, params, {Measure::Throw, *params.throw_}, arc);
  if (params.close.empty()) return make_motion(path, params, {Measure::Slip, 0.0}, arc);  // a turn alone
  std::vector<CutHorizon> close;
  for (const std::string& horizon : params.close) {
    DOBRA_TRY(CutHorizon cut, cut_to_close(setting, horizon));
    close.push_back(std::move(cut));
  }
  return solve_slip(path, params, close, arc, setting.size);
}

/// What moves, with the names of its blocks.
base::Result<void> choose_part(const Section& section, const MoveParams& params, const std::vector<Fault>& all,
                               const faults::FaultOptions& options, const Setting& setting, Moved& moved) {
  if (has_tip(*params.method)) {
    moved.before = MovingPart::of_walls(setting.fault.path, setting.size);
    return {};
  }
  DOBRA_TRY(const faults::Blocks blocks, faults::Blocks::make(section, all, options));
  // Also where blocks are named: a fault that parts nothing moves none.
  DOBRA_TRY(std::vector<faults::BlockId> chosen, blocks.hanging_wall(setting.fault));
  if (!params.block.empty()) {
    const std::vector<faults::BlockId> wall = chosen;
    DOBRA_TRY(chosen, blocks.named(params.block));
    moved.whole_wall = chosen == wall;
  }
  for (std::string& remark : blocks.remarks_on_beds(section)) moved.remarks.push_back(std::move(remark));
  std::vector<geom::Point> inside;
  for (const faults::BlockId id : chosen) {
    const faults::Block& block = blocks.all()[id.index()];
    moved.blocks.push_back(block.name);
    inside.push_back(block.inside);
  }
  DOBRA_TRY(const std::vector<geom::Polyline> contours, area_of_blocks(section, all, &setting.fault, inside));
  DOBRA_TRY(moved.before, MovingPart::of_blocks(contours, setting.size));
  return {};
}

/// Whether most of a polygon moves.
base::Result<bool> moves_mostly(const geom::Polyline& contour, const MovingPart& part) {
  DOBRA_TRY(const std::vector<LinePart> parts, part.split_area(contour));
  double more = 0.0;
  for (const LinePart& one : parts)
    more += (one.fate == Fate::Moves ? 1.0 : -1.0) * std::abs(geom::signed_area(one.line));
  return more > 0.0;
}

/// Polygons of what moves that lie over polygons of what stays.
base::Result<void> refuse_overlap(const Section& section, const Moved& moved) {
  if (!section.faces) return {};
  for (const section::Misfit& misfit : section.faces->misfits) {
    if (misfit.what != "overlap" || misfit.area <= 1e-9 * section.faces->area) continue;
    bool moves = false, stays = false;
    for (const section::Unit& unit : section.units) {
      if (geom::locate(unit.contour, misfit.place) == geom::Side::Outside) continue;
      DOBRA_TRY(const bool mostly, moves_mostly(unit.contour, moved.before));
      (mostly ? moves : stays) = true;
    }
    if (!moves || !stays) continue;
    return base::Error{base::ErrorCode::BadSection,
                       fmt::format("{} lie over each other by {:.6g} m2 before the move, one in the block that moves "
                                   "and one in the rest; correct their contours",
                                   misfit.between, misfit.area),
                       place_at(misfit.place, "units")};
  }
  return {};
}

/// One kind of the areas between a path and what its hanging wall's base became.
void add_areas(const geom::Polyline& ring, double least, double& area, geom::Point& at) {
  const auto regions = topo::region(std::vector{ring}, topo::Inside::Positive);
  double greatest = 0.0;
  for (const geom::Polyline& contour : regions ? *regions : std::vector<geom::Polyline>{}) {
    const double part = geom::signed_area(contour);
    if (std::abs(part) <= least) continue;
    area += part;
    if (part <= greatest) continue;
    greatest = part;
    at = contour.box().low + 0.5 * (contour.box().high - contour.box().low);
  }
}

/// What of a line lies beside the path between two arc lengths of it.
std::vector<geom::Point> beside(const FaultPath& path, const geom::Polyline& line, double from, double to) {
  std::vector<double> arcs;
  for (const geom::Point p : line.points) arcs.push_back(nearest(path, p).arc);
  std::vector<geom::Point> part;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    for (const double end : {from, to}) {
      if (i > 0 && (arcs[i - 1] - end) * (arcs[i] - end) < 0.0)
        part.push_back(
            geom::interpolate(line.points[i - 1], line.points[i], (end - arcs[i - 1]) / (arcs[i] - arcs[i - 1])));
    }
    if (arcs[i] >= from && arcs[i] <= to) part.push_back(line.points[i]);
  }
  return part;
}

/// Between the base of the hanging wall that was on the fault, and the fault, or what became of the footwall's side
/// of it where a tip moves; where both lie beside each other.
OpenedArea opened_along(const FaultPath& path, const kinematics::BlockMap& map, double size) {
  constexpr double everywhere = std::numeric_limits<double>::max();
  const auto tip = map.tip();
  const std::vector<geom::Point>& points = path.line.points;
  const auto is_tip = [&](geom::Point p) { return tip && geom::distance(p, tip->before) <= 1e-9 * size; };
  const geom::Polyline base = map.forward(path.line, kinematics::Wall::Hanging).after;
  const geom::Polyline foot = tip ? map.forward(path.line, kinematics::Wall::Foot).after : path.line;
  const double from = is_tip(points.front()) ? -everywhere : std::max(0.0, nearest(path, base.points.front()).arc);
  const double to =
      is_tip(points.back()) ? everywhere : std::min(geom::length(path.line), nearest(path, base.points.back()).arc);
  geom::Polyline ring{beside(path, foot, from, to), true};
  const std::vector<geom::Point> above = beside(path, base, from, to);
  ring.points.insert(ring.points.end(), above.rbegin(), above.rend());
  OpenedArea opened;
  if (ring.points.size() < 3) return opened;
  geom::Polyline other = geom::reversed(ring);
  if (path.hanging == kinematics::Side::Right) std::swap(ring, other);
  // Curves of trishear are true to a chord.
  const double least = (map.piecewise_affine() ? 1e-12 : 1e-9) * size * size;
  add_areas(ring, least, opened.gap, opened.gap_at);
  add_areas(other, least, opened.overlap, opened.overlap_at);
  return opened;
}

/// The bed beside a cutoff, away from the fault.
geom::Point beside(const Section& section, const faults::Cutoff& cutoff) {
  const std::vector<geom::Point>& points = find_horizon(section, cutoff.piece)->line.points;
  const bool first = cutoff.end == section::LineEnd::First;
  return geom::midpoint(first ? points.front() : points.back(), first ? points[1] : points[points.size() - 2]);
}

/// Of a horizon which walls lie in what moves.
void set_walls(const Section& section, const Setting& setting, const MovingPart& part, CutHorizon& cut) {
  for (const faults::CutoffPair& pair : setting.cutoffs.pairs) {
    if (!pair.hanging_wall || !pair.footwall || pair.hanging_wall->at != cut.hanging_wall) continue;
    cut.hanging_moves = part.fate_of(beside(section, *pair.hanging_wall)) == Fate::Moves;
    cut.foot_moves = part.fate_of(beside(section, *pair.footwall)) == Fate::Moves;
  }
}

/// Cutoffs that left the fault as it was drawn.
void remark_beyond(const Setting& setting, const Moved& moved, std::vector<std::string>& remarks) {
  const FaultPath& path = setting.fault.path;
  const double length = geom::length(path.line);
  for (const CutHorizon& cut : setting.cut) {
    const double arc = nearest(path, moved.motion.map.forward(cut.hanging_wall)).arc;
    const double beyond = std::max(-arc, arc - length);
    if (beyond <= 1e-9 * setting.size) continue;
    remarks.push_back(fmt::format(
        "horizon '{}' is carried {:.6g} m beyond the {} end of fault '{}', where the fault goes on straight",
        cut.horizon, beyond, arc < 0.0 ? "lower" : "higher", setting.fault.name));
  }
}

/// A line whose last point is the tip goes on to where that is now, or back.
void take_to_tip(geom::Point after, std::vector<geom::Point>& points) {
  while (points.size() > 1 && dot(points.back() - after, points.back() - points[points.size() - 2]) >= 0.0)
    points.pop_back();
  points.push_back(after);
  points = kinematics::straightened({{std::move(points), false}}).line.points;
}

/// The fault grows with its tip, or is taken back to it.
base::Result<void> move_tip(const Setting& setting, Moved& moved) {
  const auto tip = moved.motion.map.tip();
  if (!tip) return {};
  const geom::Point after = tip->after;
  const std::string& name = setting.fault.name;
  const bool outside = moved.section.border ? geom::locate(*moved.section.border, after) == geom::Side::Outside
                                            : !box_of(moved.section).overlaps({after, after});
  if (outside) {
    return bad(base::ErrorCode::CannotRestore,
               fmt::format("the tip would leave the section at {}; give a smaller slip{}", at_text(after),
                           moved.params.method == MoveMethod::Trishear ? ", or a smaller propagation (P/S)" : ""),
               tip->before, name);
  }
  for (section::SectionLine& line : moved.section.lines) {
    if (std::find(setting.fault.pieces.begin(), setting.fault.pieces.end(), line.id) == setting.fault.pieces.end())
      continue;
    std::vector<geom::Point>& points = line.line.points;
    const bool at_first = geom::distance(points.front(), tip->before) < geom::distance(points.back(), tip->before);
    if (std::min(geom::distance(points.front(), tip->before), geom::distance(points.back(), tip->before)) >
        setting.tolerance)
      continue;
    if (at_first) std::reverse(points.begin(), points.end());
    take_to_tip(after, points);
    if (at_first) std::reverse(points.begin(), points.end());
    moved.pieces.push_back({line.name, "fault", line.line});
  }
  return {};
}

/// Where the part that moved lies now.
base::Result<void> set_after(const Setting& setting, Moved& moved) {
  if (const auto tip = moved.motion.map.tip()) {
    FaultPath path = setting.fault.path;
    std::vector<geom::Point>& points = path.line.points;
    const bool first = geom::distance(points.front(), tip->before) < geom::distance(points.back(), tip->before);
    if (first) std::reverse(points.begin(), points.end());
    take_to_tip(tip->after, points);
    if (first) std::reverse(points.begin(), points.end());
    if (points.size() < 2) points = setting.fault.path.line.points;
    moved.after = MovingPart::of_walls(std::move(path), setting.size);
    return {};
  }
  std::vector<geom::Polyline> contours;
  for (const geom::Polyline& contour : moved.before.contours())
    contours.push_back(moved.motion.map.forward(contour).after);
  DOBRA_TRY(moved.after, MovingPart::of_blocks(contours, setting.size));
  return {};
}

/// Ends on a younger fault, behind which the fault goes on straight; methods with a tip take an end for one that leaves
/// the section.
void remark_on_ends(const Setting& setting, Moved& moved) {
  for (const faults::FaultEnd& end : {setting.fault.lower, setting.fault.upper}) {
    if (end.kind != faults::EndKind::Cut) continue;
    moved.remarks.push_back(
        fmt::format("fault '{}' ends at {} on '{}', which is younger; its path goes on straight "
                    "there. If it flattens into that one, leave out their order",
                    setting.fault.name, at_text(end.at), end.on));
  }
  const auto tip = moved.motion.map.tip();
  if (!tip) return;
  if (auto remark = faults::remark_on_taken_tip(setting.fault, tip->before))
    moved.remarks.push_back(*std::move(remark));
}

/// Beds that the fault cuts off in its hanging wall though no block that moves holds them, and cutoffs without a
/// partner.
void remark_on_cutoffs(const Section& section, const Setting& setting, Moved& moved) {
  for (const faults::CutoffPair& pair : setting.cutoffs.pairs) {
    if (!pair.hanging_wall || !pair.footwall) moved.remarks.push_back(partner_missing(pair, setting.fault.name));
    if (!pair.hanging_wall || pair.hanging_wall->passes || !moved.params.block.empty()) continue;
    const faults::Cutoff& cutoff = *pair.hanging_wall;
    const section::Horizon& bed = *find_horizon(section, cutoff.piece);
    const std::vector<geom::Point>& points = bed.line.points;
    const bool first = cutoff.end == section::LineEnd::First;
    const geom::Point end = first ? points.front() : points.back();
    const geom::Point inner = first ? points[1] : points[points.size() - 2];
    const bool ends_there = geom::distance(end, cutoff.at) <= 5.0 * setting.tolerance;
    if (!ends_there || moved.before.fate_of(geom::midpoint(end, inner)) == Fate::Moves) continue;
    moved.remarks.push_back(
        fmt::format("horizon '{}' ends in the hanging wall of fault '{}' at {}, but lies in no block that moves, and "
                    "stays: what surrounds it encloses no rock; give a border ([[input.border]])",
                    bed.name, setting.fault.name, at_text(cutoff.at)));
  }
}

void remark_on_misfit(Moved& moved) {
  if (moved.params.close.size() > 1) {
    std::vector<Misfit> closed;
    for (const Misfit& misfit : moved.misfit) {
      const auto& close = moved.params.close;
      if (std::find(close.begin(), close.end(), misfit.horizon) != close.end()) closed.push_back(misfit);
    }
    moved.remarks.push_back(
        fmt::format("{} horizons are closed by least squares: {:.4g} m are left along the fault, "
                    "root mean square",
                    closed.size(), root_mean_square(closed)));
  }
  if (!moved.whole_wall)
    moved.remarks.push_back(
        "the blocks that move are not those of the hanging wall: what opens between them and their neighbours, and "
        "what "
        "they cover of these, is not measured");
  const OpenedArea& opened = moved.opened;
  if (opened.gap > 0.0) {
    moved.remarks.push_back(fmt::format("between the block and the fault {:.6g} m2 are left open, most at {}",
                                        opened.gap, at_text(opened.gap_at)));
  }
  if (opened.overlap > 0.0) {
    moved.remarks.push_back(fmt::format("the block lies over the other wall by {:.6g} m2, most at {}", opened.overlap,
                                        at_text(opened.overlap_at)));
  }
}

}  // namespace

geom::Point Moved::forward(geom::Point p) const { return before.image(p, motion.map); }
geom::Polyline Moved::forward(const geom::Polyline& line) const { return before.image(line, motion.map); }
geom::Point Moved::inverse(geom::Point p) const { return after.image(p, motion.map.swapped()); }
geom::Polyline Moved::inverse(const geom::Polyline& line) const { return after.image(line, motion.map.swapped()); }

base::Result<Moved> move_block(const Section& section, const MoveParams& params, const base::Progress& progress) {
  DOBRA_TRY_VOID(check_params(params));
  DOBRA_TRY_VOID(progress.check());
  const faults::FaultOptions options{params.tolerance.value_or(0.0)};
  DOBRA_TRY(const std::vector<Fault> all, faults_of(section, options));
  DOBRA_TRY(const Setting setting, setting_of(section, params, all, options));
  Moved moved;
  moved.params = params;
  moved.fault = setting.fault;
  DOBRA_TRY_VOID(choose_part(section, params, all, options, setting, moved));
  DOBRA_TRY_VOID(refuse_overlap(section, moved));
  DOBRA_TRY(moved.motion, motion_of(setting, params, moved.remarks));
  progress.report(0.3, "map built");
  DOBRA_TRY_VOID(progress.check());
  DOBRA_TRY_VOID(set_after(setting, moved));
  DOBRA_TRY_VOID(move_lines(section, setting.fault.pieces, setting.tolerance, moved));
  DOBRA_TRY_VOID(move_tip(setting, moved));
  for (CutHorizon cut : setting.cut) {
    if (!moved.whole_wall) set_walls(section, setting, moved.before, cut);
    moved.misfit.push_back(misfit_of(cut, setting.path, params, moved.motion.map));
  }
  if (moved.whole_wall) moved.opened = opened_along(setting.fault.path, moved.motion.map, setting.size);
  moved.remarks.insert(moved.remarks.end(), moved.motion.remarks.begin(), moved.motion.remarks.end());
  remark_on_ends(setting, moved);
  remark_on_cutoffs(section, setting, moved);
  remark_beyond(setting, moved, moved.remarks);
  remark_on_misfit(moved);
  progress.report(1.0, "moved");
  return moved;
}

}  // namespace recon::moving
