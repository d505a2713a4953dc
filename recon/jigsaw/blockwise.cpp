#include "recon/jigsaw/blockwise.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "recon/jigsaw/assemble.h"
#include "recon/jigsaw/join_pieces.h"
#include "recon/jigsaw/rigid_fit.h"
#include "shared/base/parallel.h"
#include "shared/base/text.h"
#include "shared/geom/place.h"

namespace recon::jigsaw {

namespace {

using faults::BlockId;
using section::Section;

/// All that is known before any block is unfolded.
struct Setting {
  std::vector<faults::Fault> faults;
  std::vector<faults::FaultCutoffs> cutoffs;
  faults::Blocks blocks;
  std::string top;
  CutSection cut;
  /// By part: its piece of the top, in the cut section; of rigid blocks without it another bed.
  std::vector<std::optional<std::size_t>> tops;
  double size = 0.0;
  std::optional<TargetLine> target;  ///< Instead of a level datum.
};

base::Result<std::string> name_of_top(const Section& section, const std::string& top) {
  if (section.horizons.empty())
    return base::Error{base::ErrorCode::BadSection, "the section has no horizon to be the top"};
  if (top.empty()) return whole_name(section.horizons.front());
  std::vector<std::string> names;
  for (const section::Horizon& horizon : section.horizons) {
    if (horizon.name == top || whole_name(horizon) == top) return whole_name(horizon);
    names.push_back(whole_name(horizon));
  }
  return base::Error{base::ErrorCode::BadSection,
                     fmt::format("there is no horizon '{}' to be the top{}", top, base::did_you_mean(top, names))};
}

/// The lines of the faults that part blocks.
std::vector<section::LineId> boundary_lines(const Setting& setting) {
  std::vector<section::LineId> lines;
  for (const faults::FaultWall& wall : setting.blocks.walls()) {
    const std::vector<section::LineId>& pieces = setting.faults[wall.fault].pieces;
    lines.insert(lines.end(), pieces.begin(), pieces.end());
  }
  return lines;
}

/// The top in a block; of a rigid block without it another bed.
std::optional<std::size_t> top_in(const CutSection& cut, std::size_t part, const std::string& top,
                                  Constraint constraint) {
  std::optional<std::size_t> other;
  for (std::size_t i = 0; i < cut.horizons.size(); ++i) {
    if (cut.horizons[i].part != part) continue;
    if (whole_name(cut.section.horizons[i]) == top) return i;
    if (!other && constraint == Constraint::Rotation) other = i;
  }
  return other;
}

base::Result<Setting> setting_of(const Section& section, const BlockwiseParams& how, std::vector<Part>& parts) {
  const faults::FaultOptions options{how.cutoff_tolerance.value_or(0.0)};
  Setting setting;
  setting.size = box_of(section).diagonal();
  if (!how.target.empty()) {
    DOBRA_TRY(setting.target, TargetLine::make(how.target, 2.0 * setting.size));
  }
  DOBRA_TRY(setting.top, name_of_top(section, how.top));
  DOBRA_TRY(setting.faults, faults_of(section, options));
  if (setting.faults.empty()) {
    return base::Error{base::ErrorCode::BadSection,
                       "the section has no fault, so that it is one block; restore it without block and jigsaw"};
  }
  setting.cutoffs = cutoffs_of(section, setting.faults, options);
  DOBRA_TRY(setting.blocks, faults::Blocks::make(section, setting.faults, options));
  if (setting.blocks.all().empty()) {
    const faults::Fault& fault = setting.faults.front();
    return base::Error{
        base::ErrorCode::BadSection,
        "the faults part no blocks, since the horizons and their ends at the faults enclose no area; give "
        "a border ([[input.border]]), or a larger tolerance",
        geom::place_at(fault.lower.at, fmt::format("fault '{}'", fault.name))};
  }
  std::vector<BlockId> chosen;
  if (how.jigsaw) {
    for (const faults::Block& block : setting.blocks.all()) chosen.push_back(block.id);
  } else {
    DOBRA_TRY(chosen, setting.blocks.named(how.block));
  }
  DOBRA_TRY(parts, parts_of(section, setting.faults, setting.blocks, chosen));
  DOBRA_TRY(setting.cut, cut(section, parts, setting.cutoffs, boundary_lines(setting), tolerance_of(section, options)));
  for (std::string& remark : setting.blocks.remarks_on_beds(section)) setting.cut.remarks.push_back(std::move(remark));
  if (!is_rigid(how)) DOBRA_TRY_VOID(join_pieces(setting.top, parts, setting.size, setting.cut, setting.cutoffs));
  for (std::size_t i = 0; i < parts.size(); ++i)
    setting.tops.push_back(top_in(setting.cut, i, setting.top, how.constraint));
  return setting;
}

/// Names of the beds in a block, as wholes.
std::vector<std::string> beds_in(const CutSection& cut, std::size_t part) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < cut.horizons.size(); ++i) {
    if (cut.horizons[i].part == part) names.push_back(whole_name(cut.section.horizons[i]));
  }
  return names;
}

/// Beds that all blocks with beds have.
std::vector<std::string> beds_in_all(const CutSection& cut, std::size_t parts) {
  std::vector<std::string> shared;
  bool first = true;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::vector<std::string> names = beds_in(cut, part);
    if (names.empty()) continue;
    if (std::exchange(first, false)) shared = names;
    std::erase_if(shared,
                  [&](const std::string& n) { return std::find(names.begin(), names.end(), n) == names.end(); });
  }
  return shared;
}

/// A block without the top has no way to the datum. Where it has beds of others, the section would not be restored;
/// basement stays.
base::Result<void> check_tops(const Setting& setting, const std::vector<Part>& parts, const BlockwiseParams& how,
                              std::vector<std::string>& remarks) {
  std::vector<std::string> restored;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!setting.tops[i]) continue;
    const std::vector<std::string> beds = beds_in(setting.cut, i);
    restored.insert(restored.end(), beds.begin(), beds.end());
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (setting.tops[i]) continue;
    const faults::Block& block = setting.blocks.all()[parts[i].id.index()];
    const std::vector<std::string> beds = beds_in(setting.cut, i);
    const auto shared = [&](const std::string& bed) {
      return std::find(restored.begin(), restored.end(), bed) != restored.end();
    };
    if (how.jigsaw && !restored.empty() && std::none_of(beds.begin(), beds.end(), shared)) {
      remarks.push_back(
          fmt::format("block '{}' has no bed of those that are restored: it stays as it is, and nothing is measured at "
                      "the faults between it and the others",
                      block.name));
      continue;
    }
    const std::vector<std::string> all = beds_in_all(setting.cut, parts.size());
    return base::Error{
        base::ErrorCode::CannotRestore,
        fmt::format("it has no piece of the top '{}', so that nothing says how deep it lies below the "
                    "datum; {}",
                    setting.top,
                    all.empty() ? std::string("draw the top there (eroded, say), or restore the other "
                                              "blocks by their names (block)")
                                : fmt::format("take a top that is in all blocks: {}", fmt::join(all, ", "))),
        place_at(block.inside, fmt::format("block '{}'", block.name))};
  }
  return {};
}

/// The part that stays in place: that with the pin, or the leftmost one.
base::Result<std::size_t> pinned_part(const Setting& setting, const BlockwiseParams& how) {
  std::optional<std::size_t> leftmost;
  double left = 0.0;
  for (std::size_t i = 0; i < setting.tops.size(); ++i) {
    if (!setting.tops[i]) continue;
    const geom::Box box = setting.cut.section.horizons[*setting.tops[i]].line.box();
    if (how.pin && *how.pin >= box.low.x && *how.pin <= box.high.x) return i;
    if (leftmost && box.low.x >= left) continue;
    left = box.low.x;
    leftmost = i;
  }
  if (!how.pin) return *leftmost;
  return base::Error{
      base::ErrorCode::BadValue,
      fmt::format("the pin x = {:.6g} is not on the top '{}' of any of the blocks", *how.pin, setting.top),
      geom::place_at({*how.pin, 0.0}, "pin")};
}

base::Result<std::vector<UnfoldedBlock>> unfold_all(const Setting& setting, const std::vector<Part>& parts,
                                                    std::size_t pinned, const BlockwiseParams& how,
                                                    const unfold::RestoreParams& params,
                                                    const base::Progress& progress) {
  const auto unfold = [&](std::size_t part, std::optional<double> pin, std::optional<double> datum) {
    if (is_rigid(how)) return rigid_block(setting.cut, parts[part], part, *setting.tops[part], params);
    PlaceOfBlock place{*setting.tops[part], pin, datum, nullptr, std::nullopt, how.simplify.value_or(0.0)};
    if (setting.target && !how.jigsaw) {
      place.target = &*setting.target;
      place.target_pin = how.target_pin;
    }
    return unfold_block(setting.cut, parts[part], part, place, params, {});
  };
  DOBRA_TRY(UnfoldedBlock fixed, unfold(pinned, how.pin, how.elevation));
  progress.report(0.3, "pinned block restored");
  DOBRA_TRY_VOID(progress.check());
  const std::optional<double> datum = how.jigsaw ? std::optional(fixed.datum) : how.elevation;
  std::vector<std::optional<base::Result<UnfoldedBlock>>> made(parts.size());
  base::parallel_for(parts.size(), [&](std::size_t i) {
    if (setting.tops[i] && i != pinned) made[i] = unfold(i, std::nullopt, datum);
  });
  made[pinned] = std::move(fixed);
  std::vector<UnfoldedBlock> blocks;
  for (std::optional<base::Result<UnfoldedBlock>>& one : made) {
    if (!one) continue;
    DOBRA_TRY(UnfoldedBlock block, std::move(*one));
    blocks.push_back(std::move(block));
  }
  DOBRA_TRY_VOID(progress.check());
  return blocks;
}

std::vector<std::string> names_of(const std::vector<UnfoldedBlock>& blocks) {
  std::vector<std::string> names;
  for (const UnfoldedBlock& block : blocks) names.push_back(block.name);
  return names;
}

/// As the blocks are placed; a remark where that cannot be measured.
std::vector<FacingWalls> measured_walls(const FaultSetting& setting, Blockwise& made) {
  auto facing = facing_walls(setting, made.blocks);
  if (facing) return std::move(*facing);
  made.remarks.push_back(fmt::format("gaps and overlaps are not measured: {}", to_string(facing.error())));
  return {};
}

/// Slides the blocks along the datum.
/// @param place  puts them where they slide to, and sets what they lie on.
template <class Place>
base::Result<void> slide_blocks(FaultSetting setting, std::size_t pinned, Fit fit, const Place& place,
                                Blockwise& made) {
  std::vector<Tie>& ties = made.ties;
  made.pinned = pinned;
  if (fit == Fit::Walls) {
    DOBRA_TRY(const std::vector<FacingWalls> facing, facing_walls(setting, made.blocks));
    ties = ties_of_walls(facing, made.blocks, setting.size);
  } else {
    ties = ties_of_top(setting, made.blocks);
  }
  DOBRA_TRY(const std::vector<double> shifts, slide(names_of(made.blocks), pinned, ties));
  for (std::size_t b = 0; b < shifts.size(); ++b) made.blocks[b].slid = shifts[b];
  DOBRA_TRY_VOID(place(setting));
  const std::vector<FacingWalls> facing = measured_walls(setting, made);
  made.faults = restored_faults(setting, facing);
  add_slide_errors(facing, made.blocks, setting.size, made.faults);
  if (fit == Fit::Walls) return {};
  for (const Tie& tie : ties) {
    const double apart = shifts[tie.right] - shifts[tie.left] - tie.apart;
    std::optional<double>& left_apart = made.faults[tie.fault].left_apart;
    left_apart = std::max(left_apart.value_or(0.0), std::abs(apart));
  }
  return {};
}

/// Blocks that have slid along a level datum are unfolded anew, each to where it has slid to on the target.
base::Result<void> lay_on_target(const Setting& setting, std::size_t pinned, Blockwise& made) {
  const TargetLine& target = *setting.target;
  const BlockwiseParams& how = made.how;
  const geom::Point pin = made.blocks[pinned].pin;
  geom::Point start = how.target_pin.value_or(geom::Point{pin.x, 0.0});
  const double off = how.target_pin ? std::abs(start.y - target.z(start.x)) : 0.0;
  start.y = target.z(start.x);
  if (off > 1e-9 * setting.size) {
    made.remarks.push_back(
        fmt::format("target_pin lies {:.4g} m above or below the target; the point of the target at "
                    "its x was taken",
                    off));
  }
  std::vector<std::optional<base::Result<UnfoldedBlock>>> laid(made.blocks.size());
  base::parallel_for(made.blocks.size(), [&](std::size_t b) {
    const UnfoldedBlock& flat = made.blocks[b];
    const double by = flat.pin.x + flat.slid - pin.x;  // a pin keeps its x on a level datum
    const PlaceOfBlock place{
        *setting.tops[flat.part],  flat.pin.x, std::nullopt, &target, target.slid(start, by, made.params),
        how.simplify.value_or(0.0)};
    laid[b] = unfold_block(setting.cut, made.parts[flat.part], flat.part, place, made.params, {});
  });
  for (std::size_t b = 0; b < laid.size(); ++b) {
    DOBRA_TRY(UnfoldedBlock block, std::move(*laid[b]));
    block.slid = made.blocks[b].slid;
    made.blocks[b] = std::move(block);
  }
  return {};
}

/// Turns and shifts the blocks as they are.
base::Result<void> turn_blocks(const FaultSetting& setting, std::size_t pinned, Fit fit, Blockwise& made) {
  const std::vector<Match> matches = matches_of(setting, made.blocks, fit);
  DOBRA_TRY(const std::vector<RigidMotion> motions,
            turn_and_shift(names_of(made.blocks), pinned, matches, setting.size));
  for (std::size_t b = 0; b < motions.size(); ++b) made.blocks[b].placed = motions[b];
  made.faults = restored_faults(setting, measured_walls(setting, made));
  return {};
}

/// Puts the unfolded or rigid blocks of a jigsaw together.
/// @param pinned  part.
base::Result<void> fit_blocks(const Setting& setting, const FaultSetting& of_faults, std::size_t pinned,
                              Blockwise& made) {
  const auto is_pinned = [&](const UnfoldedBlock& block) { return block.part == pinned; };
  const auto at = std::find_if(made.blocks.begin(), made.blocks.end(), is_pinned);
  const auto fixed = static_cast<std::size_t>(at - made.blocks.begin());
  const Fit fit = made.how.fit.value_or(Fit::Walls);
  if (is_rigid(made.how)) return turn_blocks(of_faults, fixed, fit, made);
  const auto place = [&](FaultSetting& on) -> base::Result<void> {
    if (setting.target) {
      on.target = &*setting.target;
      return lay_on_target(setting, fixed, made);
    }
    for (UnfoldedBlock& block : made.blocks) block.placed.by = {block.slid, 0.0};
    return {};
  };
  return slide_blocks(of_faults, fixed, fit, place, made);
}

void remark_on_faults(const Blockwise& made, double size, std::vector<std::string>& remarks) {
  for (const RestoredFault& fault : made.faults) {
    const auto at = [](geom::Point p) { return fmt::format("{}", p); };
    if (!fault.measured) {
      remarks.push_back(
          fmt::format("fault '{}' has no two restored walls beside each other; it is left as it was", fault.name));
    }
    if (fault.opening.widest_gap > 1e-9 * size) {
      remarks.push_back(fmt::format("fault '{}': a gap of {:.6g} m2, widest at {}", fault.name, fault.opening.gap,
                                    at(fault.opening.gap_at)));
    }
    if (fault.opening.widest_overlap > 1e-9 * size) {
      remarks.push_back(fmt::format("fault '{}': an overlap of {:.6g} m2, widest at {}", fault.name,
                                    fault.opening.overlap, at(fault.opening.overlap_at)));
    }
    if (fault.left_apart.value_or(0.0) > 1e-9 * size) {
      remarks.push_back(
          fmt::format("fault '{}': the ends of the top miss each other by {:.4g} m, since the blocks "
                      "close a ring",
                      fault.name, *fault.left_apart));
    }
  }
}

}  // namespace

base::Result<void> check_params(const BlockwiseParams& params) {
  const auto refuse = [](const char* message) { return base::Error{base::ErrorCode::BadValue, message}; };
  if (params.jigsaw && !params.block.empty())
    return refuse("block restores some blocks alone, jigsaw all of them together; give one of the two");
  if (params.fit && !params.jigsaw) return refuse("fit says how the blocks of a jigsaw slide together; set jigsaw");
  const bool more = !params.top.empty() || params.pin || params.elevation || params.simplify ||
                    params.cutoff_tolerance || !params.target.empty() || params.target_pin;
  if (!is_blockwise(params) && more) {
    return refuse(
        "top, pin, elevation, target, target_pin, simplify and cutoff_tolerance belong to block and jigsaw; without "
        "these give them to the steps grid and target");
  }
  if (is_rigid(params) && !params.jigsaw)
    return refuse("constraint = \"rotation\" says how the blocks of a jigsaw fit together; set jigsaw");
  if (is_rigid(params) && (params.elevation || params.simplify || !params.target.empty()))
    return refuse("constraint = \"rotation\" has no datum; leave out elevation, target and simplify");
  if (params.elevation && !params.target.empty())
    return refuse("elevation is that of a level datum; leave it out, or the target");
  if (params.target_pin && params.target.empty())
    return refuse("target_pin is a point of the target; give that too, or elevation for a level datum");
  if (params.block.size() > 1 && (params.pin || params.target_pin))
    return refuse("one pin for several blocks; restore them one by one, or leave out the pin");
  return {};
}

base::Result<Blockwise> restore_blockwise(const Section& section, const BlockwiseParams& how,
                                          const unfold::RestoreParams& params, const base::Progress& progress) {
  DOBRA_TRY_VOID(check_params(how));
  DOBRA_TRY_VOID(progress.check());
  if (how.jigsaw && params.percent != 100.0) {
    return base::Error{base::ErrorCode::BadValue,
                       "a jigsaw joins restored blocks; percent is to be 100 (or restore one block on its own)"};
  }
  if (is_rigid(how) && params.method != unfold::RestoreMethod::Constant) {
    return base::Error{base::ErrorCode::BadValue,
                       "blocks of constraint = \"rotation\" stay rigid and are not unfolded; leave out the method"};
  }
  Blockwise made;
  made.params = params;
  made.how = how;
  DOBRA_TRY(const Setting setting, setting_of(section, how, made.parts));
  made.size = setting.size;
  DOBRA_TRY_VOID(check_tops(setting, made.parts, how, made.remarks));
  DOBRA_TRY(const std::size_t pinned, pinned_part(setting, how));
  DOBRA_TRY(made.blocks, unfold_all(setting, made.parts, pinned, how, params, progress));
  progress.report(0.8, "blocks restored");
  const FaultSetting of_faults{setting.faults, setting.cutoffs, setting.blocks.walls(), setting.top, setting.size};
  if (how.jigsaw) DOBRA_TRY_VOID(fit_blocks(setting, of_faults, pinned, made));
  made.remarks.insert(made.remarks.end(), setting.cut.remarks.begin(), setting.cut.remarks.end());
  for (const faults::FaultCutoffs& cutoffs : setting.cutoffs)
    made.remarks.insert(made.remarks.end(), cutoffs.remarks.begin(), cutoffs.remarks.end());
  for (const UnfoldedBlock& block : made.blocks)
    made.remarks.insert(made.remarks.end(), block.restoration.remarks.begin(), block.restoration.remarks.end());
  assemble(setting.cut, setting.faults, setting.blocks, made);
  remark_on_faults(made, setting.size, made.remarks);
  judge(setting.blocks, of_faults.walls, setting.cutoffs, setting.target ? &*setting.target : nullptr, made);
  made.remarks.push_back(is_rigid(how) ? "blocks stay rigid: lengths, areas and angles within them are kept"
                                       : what_it_keeps(params.method));
  made.remarks.push_back(verdict_text(made));
  progress.report(1.0, "restored");
  return made;
}

}  // namespace recon::jigsaw
