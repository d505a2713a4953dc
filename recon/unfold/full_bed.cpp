#include "recon/unfold/full_bed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

#include "shared/geom/place.h"
#include "shared/offset/offset.h"

namespace recon::unfold {

namespace {

/// A horizon, or a piece of one, travelling like the top.
struct Piece {
  section::HorizonId id;
  std::string name;
  BedPart part;
  double first = 0.0;  ///< Places of its ends on the top, m.
  double last = 0.0;
  std::optional<double> pin;  ///< Where the pin line meets it, m.
  section::BedRole role = section::BedRole::Judged;
};

BedPart part_of(geom::Polyline line, section::HorizonId horizon = {}) {
  BedPart part{horizon, std::move(line), {}};
  part.arc = geom::arc_lengths(part.line);
  return part;
}

/// Of a line, from one arc length to another.
geom::Polyline stretch(const BedPart& whole, double from, double to) {
  geom::Polyline line;
  line.points.push_back(geom::point_at(whole.line, whole.arc, from));
  for (std::size_t i = 0; i < whole.arc.size(); ++i) {
    if (whole.arc[i] > from && whole.arc[i] < to) line.points.push_back(whole.line.points[i]);
  }
  line.points.push_back(geom::point_at(whole.line, whole.arc, to));
  return line;
}

/// Arc length of the place of a line that is nearest to p, and how near.
std::pair<double, double> nearest_on(const BedPart& whole, geom::Point p) {
  std::pair<double, double> best{0.0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < whole.line.segment_count(); ++i) {
    const geom::Segment segment = whole.line.segment(i);
    const double distance = geom::distance(segment, p);
    if (distance >= best.second) continue;
    best = {whole.arc[i] + (whole.arc[i + 1] - whole.arc[i]) * geom::nearest_fraction(segment, p), distance};
  }
  return best;
}

/// What missing parts are parallel to: a bed from end to end without a jump.
struct Guide {
  std::string name;
  geom::Polyline line;
  maps::Columns columns;
};

/// The parallel of a guide through the end of a bed.
struct Parallel {
  const Guide* guide = nullptr;
  BedPart whole;
  double at = 0.0;      ///< Of the end, m.
  double depth = 0.0;   ///< Below the guide, m.
  double beside = 0.0;  ///< How far the end lies off it, m: it has no parallel there if that is more than rounding.
};

class Completer {
 public:
  Completer(const section::Section& section, const SourceGrid& source, const maps::Columns& top, double pin_arc,
            BedEnds ends, std::vector<std::string>& remarks)
      : section_(section),
        source_(source),
        top_(top),
        pin_(top, pin_arc),
        pin_arc_(pin_arc),
        ends_(ends),
        remarks_(remarks) {
    tolerance_ = bed_tolerance * box_of(section).diagonal();
    const maps::Columns::Frame& last = top.frame(maps::ColumnId(top.inner_count()));
    length_ = last.arc + last.length;
  }

  base::Result<std::vector<FullBed>> run(const std::vector<section::HorizonId>& order) {
    DOBRA_TRY_VOID(collect(order));
    DOBRA_TRY_VOID(make_top_guide());
    full_.resize(beds_.size());
    guides_.resize(beds_.size());
    for (bed_ = top_bed_; bed_ < beds_.size(); ++bed_) {
      DOBRA_TRY(full_[bed_], complete(beds_[bed_]));
    }
    for (bed_ = top_bed_; bed_-- > 0;) {
      DOBRA_TRY(full_[bed_], complete(beds_[bed_]));
    }
    return std::move(full_);
  }

 private:
  base::Error cannot(const Piece& piece, geom::Point at, const std::string& why) const {
    return {base::ErrorCode::CannotRestore, why, place_at(at, fmt::format("horizon '{}'", piece.name))};
  }

  Piece piece_of(const section::Horizon& horizon) const {
    const bool is_top = horizon.id == source_.top;
    Piece piece;
    piece.id = horizon.id;
    piece.name = horizon.name;
    piece.role = horizon.role;
    piece.part = part_of(is_top                                      ? source_.base
                         : source_.side == section::LayerSide::Above ? geom::reversed(horizon.line)
                                                                     : horizon.line,
                         horizon.id);
    const geom::Polyline& line = piece.part.line;
    piece.pin = is_top ? pin_arc_ : pin_.meets(line, piece.part.arc);
    const auto place = [&](geom::Point p, double top_end, double end) {
      if (is_top) return top_end;
      const maps::Located located = top_.locate(p, tolerance_);
      const double there = place_on(top_, located, p);
      if (ends_ == BedEnds::AsTheyAre || std::abs(there - top_end) > 0.5 * std::abs(located.at.depth)) return there;
      if (std::abs(top_end - pin_arc_) <= tolerance_) {
        piece.pin = end;
      } else if (!piece.pin || std::abs(*piece.pin - end) <= tolerance_) {
        return there;  // the pin is held at the end of the bed, and not at that of the top
      }
      return top_end;
    };
    piece.first = place(line.points.front(), 0.0, 0.0);
    piece.last = place(line.points.back(), length_, piece.part.arc.back());
    return piece;
  }

  base::Result<void> collect(const std::vector<section::HorizonId>& order) {
    std::vector<std::string> names;
    for (const section::HorizonId id : order) {
      const std::string& name = whole_name(*find_horizon(section_, id));
      if (std::find(names.begin(), names.end(), name) != names.end()) continue;
      names.push_back(name);
      std::vector<Piece> pieces;
      for (const section::Horizon& horizon : section_.horizons) {
        if (whole_name(horizon) != name) continue;
        pieces.push_back(piece_of(horizon));
        if (horizon.id == source_.top) top_bed_ = beds_.size();
      }
      std::sort(pieces.begin(), pieces.end(),
                [](const Piece& a, const Piece& b) { return a.first + a.last < b.first + b.last; });
      for (std::size_t i = 1; i < pieces.size(); ++i) {
        if (pieces[i].first >= pieces[i - 1].last - tolerance_) continue;
        return cannot(pieces[i], pieces[i].part.line.points.front(),
                      fmt::format("it lies above or below '{}', a piece of the same horizon, by {:.4g} m along the "
                                  "top; restore the blocks one by one, or take a method without beds",
                                  pieces[i - 1].name, pieces[i - 1].last - pieces[i].first));
      }
      beds_.push_back(std::move(pieces));
    }
    return {};
  }

  /// The top, straight on to where the longest bed ends.
  base::Result<void> make_top_guide() {
    start_ = 0.0;
    end_ = length_;
    for (const std::vector<Piece>& bed : beds_) {
      start_ = std::min(start_, bed.front().first);
      end_ = std::max(end_, bed.back().last);
    }
    top_guide_.name = find_horizon(section_, source_.top)->name;
    top_guide_.line = source_.base;
    std::vector<geom::Point>& points = top_guide_.line.points;
    const geom::Vector first = top_.frame(maps::ColumnId(1)).tangent;
    const geom::Vector last = top_.frame(maps::ColumnId(top_.inner_count())).tangent;
    tell_continued();
    if (start_ < -tolerance_) points.insert(points.begin(), points.front() + start_ * first);
    if (end_ > length_ + tolerance_) points.push_back(points.back() + (end_ - length_) * last);
    DOBRA_TRY(top_guide_.columns, maps::Columns::along(top_guide_.line));
    return {};
  }

  /// What uncovered = "continue" does here.
  void tell_continued() const {
    if (source_.params.uncovered != Uncovered::Continue) return;
    const auto tell = [&](double metres, geom::Point end) {
      if (metres <= 1e4 * tolerance_) return;
      remarks_.push_back(
          fmt::format("the top '{}' does not cover the section: it goes on straight for {:.6g} m from its end at {}, "
                      "to where the longest bed ends",
                      top_guide_.name, metres, end));
    };
    tell(-start_, source_.base.points.front());
    tell(end_ - length_, source_.base.points.back());
  }

  /// A bed as a guide, if it is one line and has parallels.
  const Guide* guide(std::size_t bed) {
    if (bed == top_bed_) return &top_guide_;
    if (beds_[bed].size() > 1 || !beds_[bed].front().pin) return nullptr;
    if (!guides_[bed]) {
      Guide made{beds_[bed].front().name, {}, {}};
      for (const BedPart& part : full_[bed].parts) {
        for (const geom::Point p : part.line.points) {
          if (made.line.points.empty() || geom::distance(made.line.points.back(), p) > tolerance_)
            made.line.points.push_back(p);
        }
      }
      auto columns = maps::Columns::along(made.line);
      if (!columns) return nullptr;  // it turns back on itself
      made.columns = std::move(*columns);
      guides_[bed] = std::move(made);
    }
    return &*guides_[bed];
  }

  /// The parallel through an end, at the depth that the end has below the guide.
  base::Result<Parallel> parallel_of(const Guide& guide, geom::Point end) const {
    Parallel made;
    made.guide = &guide;
    made.depth = guide.columns.locate(end, tolerance_).at.depth;
    if (std::abs(made.depth) <= tolerance_) {
      made.whole = part_of(guide.line);
    } else {
      dobra::offset::OffsetOptions how;
      how.join = dobra::offset::Join::Bisector;
      how.side = made.depth > 0.0 ? dobra::offset::Side::RightOfTravel : dobra::offset::Side::LeftOfTravel;
      const double distance = std::abs(made.depth);
      DOBRA_TRY(const auto curves, dobra::offset::offset(guide.line, std::span(&distance, 1), how));
      if (!curves.front().pieces.empty())
        made.whole = part_of(dobra::offset::chords(curves.front().pieces.front(), guide.line).polyline);
    }
    std::tie(made.at, made.beside) = nearest_on(made.whole, end);
    return made;
  }

  /// What the place of a missing part decides.
  enum class Missing {
    Inside,  ///< Where the rest of the bed goes: it lies between that and the pin.
    AtEnd,   ///< Only how the rulings go on beyond the bed.
  };

  /// A bed that was laid down while the section deformed was never parallel to an older one.
  [[nodiscard]] bool may_guide(std::size_t bed, const Piece& piece, Missing where) const {
    const bool younger = beds_[bed].front().role == section::BedRole::Growth && piece.role != section::BedRole::Growth;
    return !younger || (bed == top_bed_ && where == Missing::AtEnd);
  }

  /// Of the next bed towards the top that reaches the pin in one line, covers the end and has a parallel there.
  base::Result<Parallel> parallel(const Piece& piece, geom::Point end, Missing where) {
    Parallel made;
    for (std::size_t bed = bed_;;) {
      if (bed != top_bed_) bed = bed > top_bed_ ? bed - 1 : bed + 1;
      const Guide* found = may_guide(bed, piece, where) ? guide(bed) : nullptr;
      const bool is_last = bed == top_bed_;
      if (found != nullptr && (is_last || !found->columns.is_outer(found->columns.find(end, tolerance_).column))) {
        DOBRA_TRY(made, parallel_of(*found, end));
        if (made.beside <= 1e4 * tolerance_) return made;
      }
      if (is_last) break;
    }
    if (made.guide == nullptr) {
      return cannot(piece, end,
                    fmt::format("it ends here, and the beds above it are growth beds such as '{}', to which its "
                                "missing part was never parallel; take an older top, lengthen it, or take another "
                                "method",
                                top_guide_.name));
    }
    return cannot(piece, end,
                  fmt::format("it ends here, {:.6g} m from '{}', where that has no parallel (beyond its medial axis), "
                              "so that its missing part cannot be told; lengthen it, or take another method",
                              made.depth, made.guide->name));
  }

  /// Where a missing part comes to the pin line, which lies before the end (-1) or behind it (+1).
  base::Result<double> pin_on(const Parallel& missing, double side, const Piece& piece, geom::Point end) {
    const auto pin = pin_.meets(missing.whole.line, missing.whole.arc);
    if (pin && side * (*pin - missing.at) >= -tolerance_) {
      laid_along_ = missing.guide;
      return side < 0.0 ? std::min(*pin, missing.at) : std::max(*pin, missing.at);
    }
    return cannot(piece, end,
                  fmt::format("it ends here, before the pin line, and the parallel of '{}' at this depth ({:.6g} m) "
                              "does not reach that either; move the pin, or take another method",
                              missing.guide->name, missing.depth));
  }

  void add(geom::Polyline line, std::vector<BedPart>& parts) const {
    if (geom::length(line) > tolerance_) parts.push_back(part_of(std::move(line)));
  }

  base::Result<FullBed> complete(const std::vector<Piece>& pieces) {
    FullBed bed;
    bed.id = pieces.front().id;
    const auto pinned = std::find_if(pieces.begin(), pieces.end(), [](const Piece& p) { return p.pin.has_value(); });
    const bool reaches = pinned != pieces.end();
    // So many pieces lie before the pin, or before the one that it holds. Beside a corner the pin line may leave its
    // column, so that a piece may stand on both sides of the pin and yet not meet its line.
    std::size_t before = 0;
    while (before < pieces.size() && (reaches ? pieces.begin() + static_cast<std::ptrdiff_t>(before) != pinned
                                              : pieces[before].first + pieces[before].last <= 2.0 * pin_arc_))
      ++before;
    DOBRA_TRY_VOID(add_start(pieces.front(), !reaches && before == 0, bed));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (reaches && i == before) {
        bed.pin_part = bed.parts.size();
        bed.pin_arc = *pieces[i].pin;
      }
      bed.parts.push_back(pieces[i].part);
      if (i + 1 == pieces.size()) break;
      if (!reaches && i + 1 == before) {
        DOBRA_TRY_VOID(add_gap_at_pin(pieces[i], pieces[i + 1], bed));
      } else {
        DOBRA_TRY_VOID(add_gap(pieces[i], pieces[i + 1], i >= before, bed));
      }
    }
    DOBRA_TRY_VOID(add_end(pieces.back(), !reaches && before == pieces.size(), bed));
    if (bed.pin_part == bed.parts.size()) bed.pin_arc = bed.parts[--bed.pin_part].arc.back();
    bed.pin_arc = std::min(bed.pin_arc, bed.parts[bed.pin_part].arc.back());
    if (!reaches) {
      remarks_.push_back(
          fmt::format("horizon '{}' does not reach the pin: it is laid out along the parallel of '{}' "
                      "through its end",
                      whole_name(*find_horizon(section_, bed.id)), laid_along_->name));
    }
    return bed;
  }

  base::Result<void> add_start(const Piece& piece, bool holds_pin, FullBed& bed) {
    const geom::Point end = piece.part.line.points.front();
    if (!holds_pin && (piece.first <= start_ + tolerance_)) return {};
    DOBRA_TRY(const Parallel missing, parallel(piece, end, holds_pin ? Missing::Inside : Missing::AtEnd));
    if (holds_pin) {
      DOBRA_TRY(bed.pin_arc, pin_on(missing, -1.0, piece, end));
    }
    add(stretch(missing.whole, 0.0, missing.at), bed.parts);
    return {};
  }

  base::Result<void> add_end(const Piece& piece, bool holds_pin, FullBed& bed) {
    const geom::Point end = piece.part.line.points.back();
    if (!holds_pin && (piece.last >= end_ - tolerance_)) return {};
    DOBRA_TRY(const Parallel missing, parallel(piece, end, holds_pin ? Missing::Inside : Missing::AtEnd));
    if (holds_pin) {
      DOBRA_TRY(const double pin, pin_on(missing, 1.0, piece, end));
      bed.pin_part = bed.parts.size();
      bed.pin_arc = pin - missing.at;
    }
    add(stretch(missing.whole, missing.at, missing.whole.arc.back()), bed.parts);
    return {};
  }

  /// The two sides of the pin each at the depth of their own end.
  base::Result<void> add_gap_at_pin(const Piece& left, const Piece& right, FullBed& bed) {
    const geom::Point end = left.part.line.points.back();
    const geom::Point start = right.part.line.points.front();
    DOBRA_TRY(const Parallel after, parallel(left, end, Missing::Inside));
    DOBRA_TRY(const double from_left, pin_on(after, 1.0, left, end));
    DOBRA_TRY(const Parallel before, parallel(right, start, Missing::Inside));
    DOBRA_TRY(const double from_right, pin_on(before, -1.0, right, start));
    add(stretch(after.whole, after.at, from_left), bed.parts);
    bed.pin_part = bed.parts.size() - 1;
    bed.pin_arc = bed.parts.back().arc.back();
    add(stretch(before.whole, from_right, before.at), bed.parts);
    return {};
  }

  /// At the depth of the end that lies farther from the pin, from beside the other.
  base::Result<void> add_gap(const Piece& left, const Piece& right, bool behind_pin, FullBed& bed) {
    const geom::Point near = behind_pin ? left.part.line.points.back() : right.part.line.points.front();
    const geom::Point far = behind_pin ? right.part.line.points.front() : left.part.line.points.back();
    DOBRA_TRY(const Parallel missing, parallel(behind_pin ? right : left, far, Missing::Inside));
    maps::ColumnPoint beside = missing.guide->columns.locate(near, tolerance_).at;
    beside.depth = missing.depth;
    const double at = nearest_on(missing.whole, missing.guide->columns.point(beside)).first;
    add(stretch(missing.whole, behind_pin ? std::min(at, missing.at) : missing.at,
                behind_pin ? missing.at : std::max(at, missing.at)),
        bed.parts);
    return {};
  }

  const section::Section& section_;
  const SourceGrid& source_;
  const maps::Columns& top_;
  PinLine pin_;
  double pin_arc_ = 0.0;
  BedEnds ends_;
  std::vector<std::string>& remarks_;
  double tolerance_ = 0.0;
  double length_ = 0.0;  ///< Of the top, m.
  double start_ = 0.0;   ///< Places on the top where the longest bed begins and ends, m.
  double end_ = 0.0;
  std::vector<std::vector<Piece>> beds_;  ///< From the top of the section down.
  std::size_t top_bed_ = 0;
  Guide top_guide_;
  std::size_t bed_ = 0;                       ///< That is completed now.
  std::vector<FullBed> full_;                 ///< Those that are.
  std::vector<std::optional<Guide>> guides_;  ///< Of the beds, once needed.
  const Guide* laid_along_ = nullptr;         ///< What brought the last bed to the pin.
};

}  // namespace

base::Result<std::vector<FullBed>> full_beds(const section::Section& section, const SourceGrid& source,
                                             const maps::Columns& top, double pin_arc,
                                             const std::vector<section::HorizonId>& order, BedEnds ends,
                                             std::vector<std::string>& remarks) {
  return Completer(section, source, top, pin_arc, ends, remarks).run(order);
}

}  // namespace recon::unfold
