#include "recon/input/join.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "recon/faults/between.h"
#include "recon/section/crossings.h"
#include "recon/section/section_faces.h"
#include "shared/base/text.h"
#include "shared/geom/intersect.h"
#include "shared/geom/place.h"
#include "shared/io/formats/repair.h"

namespace recon::input {

namespace io = dobra::io;

namespace {

using Pieces = std::vector<section::Horizon>;

std::vector<std::string> whole_names(const section::Section& section) {
  std::vector<std::string> names;
  for (const section::Horizon& horizon : section.horizons) {
    if (std::find(names.begin(), names.end(), whole_name(horizon)) == names.end()) names.push_back(whole_name(horizon));
  }
  return names;
}

base::Result<void> check_names(const section::Section& section, const std::vector<std::string>& asked) {
  const std::vector<std::string> known = whole_names(section);
  for (const std::string& name : asked) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    return base::Error{base::ErrorCode::BadSection,
                       fmt::format("the section has no horizon '{}'{}", name, base::did_you_mean(name, known))};
  }
  return {};
}

using faults::PieceEnd;
using section::LineEnd;

/// Of the distance between two ends: a line that goes back by more, along a piece, runs over what is drawn already.
constexpr double doubled_back = 0.5;

/// The direction in which a piece leaves by its end, over about a length.
geom::Vector way_out(const PieceEnd& end, double length) {
  const geom::Polyline line = end.end == LineEnd::First ? geom::reversed(end.piece.line) : end.piece.line;
  const geom::Point tip = line.points.back();
  std::size_t i = line.points.size() - 2;
  while (i > 0 && geom::distance(line.points[i], tip) < length) --i;
  return geom::normalised(tip - line.points[i]);
}

/// Joins the pieces of one horizon.
class Joiner {
 public:
  Joiner(JoinWish wish, const std::optional<faults::FaultsBetween>& faults, Pieces& pieces, JoinedPieces& joined)
      : wish_(std::move(wish)), faults_(faults), pieces_(pieces), joined_(joined) {}

  base::Result<void> run() {
    const Pieces before = pieces_;
    std::vector<io::lines::Feature> features;
    for (std::size_t i = 0; i < before.size(); ++i) {
      io::lines::Feature feature;
      feature.kind = "horizon";
      feature.name = wish_.horizon;
      feature.parts = {before[i].line};
      feature.properties = {{"piece", static_cast<std::int64_t>(i)}};
      features.push_back(std::move(feature));
    }
    io::formats::RepairOptions options;
    options.gaps = wish_.tolerance;
    options.may_join = [&](const io::formats::PartEnd& a, const io::formats::PartEnd& b) {
      const auto end_of = [&](const io::formats::PartEnd& end) -> PieceEnd {
        return {before[number_of(end.feature)], end.last ? LineEnd::Last : LineEnd::First};
      };
      return may_join(end_of(a), end_of(b));
    };
    DOBRA_TRY_VOID(io::formats::repair(features, options));
    take(before, features);
    return {};
  }

 private:
  static std::size_t number_of(const io::lines::Feature& feature) {
    return static_cast<std::size_t>(std::get<std::int64_t>(feature.properties[0].second));
  }

  bool may_join(const PieceEnd& a, const PieceEnd& b) {
    const double gap = geom::distance(a.at(), b.at());
    const auto between = faults_ ? faults_->of(a, b) : std::nullopt;
    if (between && between->displaces) {
      refuse(a, b,
             fmt::format("fault '{}' lies between them and still displaces the bed by {:.4g} m along it; move its "
                         "hanging wall back first",
                         between->fault, between->separation));
      return false;
    }
    Join join{wish_.horizon, a.at(), gap <= 1e-6 * wish_.tolerance ? 0.0 : gap};
    const double back = join.gap > 0.0 ? std::max(-geom::dot(way_out(a, gap), b.at() - a.at()),
                                                  -geom::dot(way_out(b, gap), a.at() - b.at()))
                                       : 0.0;
    const bool overlap = back > doubled_back * gap && !between;
    if (overlap && !cross(a.piece.line, b.piece.line)) {
      refuse(a, b,
             fmt::format("the pieces overlap by {:.4g} m, so that the line would turn back on itself; cut one of "
                         "them there, or draw the fault that lies between them",
                         back));
      return false;
    }
    // Pieces that cross are left as they are, and their line is refused.
    if (!overlap && back > 1e-9 * gap) midpoints_.emplace_back(a.at(), b.at());
    joined_.remarks.push_back(
        fmt::format("horizon '{}': two pieces joined over a gap of {:.6g} m, at {}{}", wish_.horizon, join.gap, join.at,
                    between && between->separation > 1e-3 * wish_.tolerance
                        ? fmt::format(", across fault '{}', along which its cutoffs are {:.4g} m apart", between->fault,
                                      between->separation)
                        : ""));
    joined_.joins.push_back(std::move(join));
    return true;
  }

  void refuse(const PieceEnd& a, const PieceEnd& b, const std::string& why) {
    joined_.remarks.push_back(fmt::format("horizon '{}': the ends of two pieces at {} and {} are not joined: {}",
                                          wish_.horizon, a.at(), b.at(), why));
  }

  static bool cross(const geom::Polyline& a, const geom::Polyline& b) {
    for (std::size_t i = 0; i < a.segment_count(); ++i) {
      for (std::size_t k = 0; k < b.segment_count(); ++k) {
        if (geom::intersect(a.segment(i), b.segment(k)).kind != geom::IntersectionKind::None) return true;
      }
    }
    return false;
  }

  /// Each line that is left has the id and the role of the first of its pieces.
  void take(const Pieces& before, std::vector<io::lines::Feature>& features) {
    pieces_.clear();
    for (io::lines::Feature& feature : features) {
      for (geom::Polyline& line : feature.parts) {
        section::Horizon piece = before[number_of(feature)];
        for (const auto& [a, b] : midpoints_) meet_halfway(a, b, line.points);
        const bool turned = line.points.front().x > line.points.back().x;
        piece.line = turned ? geom::reversed(std::move(line)) : std::move(line);
        pieces_.push_back(std::move(piece));
      }
    }
    if (pieces_.size() > 1) return;
    pieces_.front().name = wish_.horizon;
    pieces_.front().piece_of.clear();
  }

  /// Ends that lie a little past each other become one point, so that the line does not turn back.
  static void meet_halfway(geom::Point a, geom::Point b, std::vector<geom::Point>& points) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const bool here = (points[i] == a && points[i + 1] == b) || (points[i] == b && points[i + 1] == a);
      if (!here || points.size() < 3) continue;
      const geom::Point middle = geom::midpoint(a, b);
      const double half = 0.5 * geom::distance(a, b);
      std::size_t from = i, to = i + 1;
      while (from > 1 && geom::distance(points[from - 1], points[i]) <= half) --from;
      while (to + 2 < points.size() && geom::distance(points[to + 1], points[i + 1]) <= half) ++to;
      points[from] = middle;
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(from) + 1,
                   points.begin() + static_cast<std::ptrdiff_t>(to) + 1);
      return;
    }
  }

  JoinWish wish_;
  const std::optional<faults::FaultsBetween>& faults_;
  Pieces& pieces_;
  JoinedPieces& joined_;
  std::vector<std::pair<geom::Point, geom::Point>> midpoints_;
};

base::Result<void> check_lines(const Pieces& pieces) {
  for (const section::Horizon& piece : pieces) {
    const auto crossings = section::self_crossings(piece.line);
    if (crossings.empty()) continue;
    return base::Error{base::ErrorCode::BadSection,
                       "it crosses itself where its pieces are joined: they overlap; move the blocks farther apart, or "
                       "join with a smaller tolerance",
                       place_at(crossings.front().place, fmt::format("horizon '{}'", piece.name))};
  }
  return {};
}

}  // namespace

std::string in_pieces(const std::vector<section::Horizon>& pieces) {
  double least = -1.0;
  geom::Point at;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t k = i + 1; k < pieces.size(); ++k) {
      for (const geom::Point p : {pieces[i].line.points.front(), pieces[i].line.points.back()}) {
        for (const geom::Point q : {pieces[k].line.points.front(), pieces[k].line.points.back()}) {
          if (least >= 0.0 && geom::distance(p, q) >= least) continue;
          least = geom::distance(p, q);
          at = p;
        }
      }
    }
  }
  return fmt::format("in {} pieces; their nearest ends are {:.6g} m apart, at {}", pieces.size(), least, at);
}

base::Result<JoinedPieces> join_horizons(section::Section section, const std::vector<JoinWish>& wishes) {
  JoinedPieces joined;
  std::optional<faults::FaultsBetween> faults;
  const auto is_fault = [](const section::SectionLine& line) { return line.kind == section::LineKind::Fault; };
  if (std::any_of(section.lines.begin(), section.lines.end(), is_fault)) {
    DOBRA_TRY(faults, faults::FaultsBetween::make(section));
  }
  std::vector<section::Horizon> all;
  for (const std::string& whole : whole_names(section)) {
    Pieces pieces;
    for (section::Horizon& horizon : section.horizons) {
      if (whole_name(horizon) == whole) pieces.push_back(horizon);
    }
    const auto wish = std::find_if(wishes.begin(), wishes.end(), [&](const JoinWish& w) { return w.horizon == whole; });
    if (wish != wishes.end() && pieces.size() > 1) {
      DOBRA_TRY_VOID(Joiner(*wish, faults, pieces, joined).run());
      DOBRA_TRY_VOID(check_lines(pieces));
      if (pieces.size() > 1)
        joined.remarks.push_back(fmt::format("horizon '{}' is still {}", whole, in_pieces(pieces)));
    }
    all.insert(all.end(), std::make_move_iterator(pieces.begin()), std::make_move_iterator(pieces.end()));
  }
  section.horizons = std::move(all);
  joined.section = std::move(section);
  return joined;
}

base::Result<JoinedPieces> join_pieces(section::Section section, const JoinParams& params) {
  DOBRA_TRY_VOID(check_names(section, params.horizon));
  const double tolerance = params.tolerance.value_or(0.005 * box_of(section).diagonal());
  std::vector<JoinWish> wishes;
  for (const std::string& whole : params.horizon.empty() ? whole_names(section) : params.horizon)
    wishes.push_back({whole, tolerance});
  DOBRA_TRY(JoinedPieces joined, join_horizons(std::move(section), wishes));
  DOBRA_TRY(section::SectionFaces faces, faces_of(joined.section));
  joined.section.faces = std::make_shared<const section::SectionFaces>(std::move(faces));
  return joined;
}

}  // namespace recon::input
