#include "recon/input/join.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/section/crossings.h"
#include "recon/section/section_faces.h"
#include "shared/base/text.h"
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

/// What the repair of files joins; each line that is left has the id and the role of the first of its pieces.
base::Result<void> join(const std::string& whole, double tolerance, Pieces& pieces, std::vector<Join>& joins) {
  std::vector<io::lines::Feature> features;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    io::lines::Feature feature;
    feature.kind = "horizon";
    feature.name = whole;
    feature.parts = {std::move(pieces[i].line)};
    feature.properties = {{"piece", static_cast<std::int64_t>(i)}};
    features.push_back(std::move(feature));
  }
  io::formats::RepairOptions options;
  options.gaps = tolerance;
  DOBRA_TRY(const std::vector<io::formats::Repair> repairs, io::formats::repair(features, options));
  const double same_place = 1e-6 * tolerance;  // as the repair has it
  for (const io::formats::Repair& repair : repairs)
    joins.push_back({whole, repair.at, repair.moved <= same_place ? 0.0 : repair.moved});
  Pieces left;
  for (io::lines::Feature& feature : features) {
    for (geom::Polyline& line : feature.parts) {
      section::Horizon piece = pieces[static_cast<std::size_t>(std::get<std::int64_t>(feature.properties[0].second))];
      const bool turned = line.points.front().x > line.points.back().x;
      piece.line = turned ? geom::reversed(std::move(line)) : std::move(line);
      left.push_back(std::move(piece));
    }
  }
  if (left.size() == 1) {
    left.front().name = whole;
    left.front().piece_of.clear();
  }
  pieces = std::move(left);
  return {};
}

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

std::string nearest_ends(const std::string& whole, const Pieces& pieces) {
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
  return fmt::format("horizon '{}' is still in {} pieces; their nearest ends are {:.6g} m apart, at ({:.6g}, {:.6g})",
                     whole, pieces.size(), least, at.x, at.y);
}

}  // namespace

base::Result<JoinedPieces> join_pieces(section::Section section, const JoinParams& params) {
  DOBRA_TRY_VOID(check_names(section, params.horizon));
  const double tolerance = params.tolerance.value_or(0.005 * box_of(section).diagonal());
  JoinedPieces joined;
  std::vector<section::Horizon> all;
  for (const std::string& whole : whole_names(section)) {
    Pieces pieces;
    for (section::Horizon& horizon : section.horizons) {
      if (whole_name(horizon) == whole) pieces.push_back(horizon);
    }
    const bool asked = params.horizon.empty() ||
                       std::find(params.horizon.begin(), params.horizon.end(), whole) != params.horizon.end();
    if (asked && pieces.size() > 1) {
      const std::size_t before = joined.joins.size();
      DOBRA_TRY_VOID(join(whole, tolerance, pieces, joined.joins));
      DOBRA_TRY_VOID(check_lines(pieces));
      for (std::size_t i = before; i < joined.joins.size(); ++i) {
        const Join& one = joined.joins[i];
        joined.remarks.push_back(
            fmt::format("horizon '{}': two pieces joined over a gap of {:.6g} m, at ({:.6g}, "
                        "{:.6g})",
                        whole, one.gap, one.at.x, one.at.y));
      }
      if (pieces.size() > 1) joined.remarks.push_back(nearest_ends(whole, pieces));
    }
    all.insert(all.end(), std::make_move_iterator(pieces.begin()), std::make_move_iterator(pieces.end()));
  }
  section.horizons = std::move(all);
  DOBRA_TRY(section::SectionFaces faces, faces_of(section));
  section.faces = std::make_shared<const section::SectionFaces>(std::move(faces));
  joined.section = std::move(section);
  return joined;
}

}  // namespace recon::input
