#include "recon/jigsaw/join_pieces.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/geom/place.h"

namespace recon::jigsaw {

namespace {

/// Of the section's size: what is no farther off is one place.
constexpr double same_place = 1e-6;

std::string text_at(geom::Point p) { return fmt::format("{}", p); }

/// From left to right.
geom::Polyline left_to_right(const geom::Polyline& line) {
  return line.points.front().x <= line.points.back().x ? line : geom::reversed(line);
}

base::Result<geom::Polyline> joined(const std::string& bed, const Part& part, std::vector<geom::Polyline> pieces,
                                    double size, std::vector<std::string>& remarks) {
  std::sort(pieces.begin(), pieces.end(),
            [](const geom::Polyline& a, const geom::Polyline& b) { return a.points.front().x < b.points.front().x; });
  geom::Polyline line = pieces.front();
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const geom::Point from = line.points.back();
    const geom::Point to = pieces[i].points.front();
    if (pieces[i].box().low.x < line.box().high.x - same_place * size) {
      return base::Error{base::ErrorCode::CannotRestore,
                         fmt::format("the top '{}' has pieces in it that lie over each other, one from {} on, so that "
                                     "they are not one line; draw the fault between them, or take another top",
                                     bed, text_at(to)),
                         place_at(to, fmt::format("block '{}'", part.name))};
    }
    remarks.push_back(
        fmt::format("block '{}': the pieces of the top '{}' are joined straight across a gap of {:.4g} m "
                    "from {} to {}",
                    part.name, bed, geom::distance(from, to), text_at(from), text_at(to)));
    line.points.insert(line.points.end(), pieces[i].points.begin(), pieces[i].points.end());
  }
  return geom::without_repeated_points(std::move(line));
}

/// Cutoffs of the pieces become cutoffs of the joined line, or of nothing.
void rename_cutoffs(const std::vector<section::HorizonId>& pieces, const section::Horizon& whole, double near,
                    std::vector<faults::FaultCutoffs>& cutoffs) {
  const auto rename = [&](std::optional<faults::Cutoff>& cutoff) {
    if (!cutoff || std::find(pieces.begin(), pieces.end(), cutoff->piece) == pieces.end()) return;
    const bool first = geom::distance(whole.line.points.front(), cutoff->at) <= near;
    const bool last = geom::distance(whole.line.points.back(), cutoff->at) <= near;
    cutoff->piece = first || last ? whole.id : section::HorizonId();
    cutoff->end = first ? section::LineEnd::First : section::LineEnd::Last;
  };
  for (faults::FaultCutoffs& fault : cutoffs) {
    for (faults::CutoffPair& pair : fault.pairs) {
      rename(pair.hanging_wall);
      rename(pair.footwall);
    }
  }
}

}  // namespace

base::Result<void> join_pieces(const std::string& bed, const std::vector<Part>& parts, double size, CutSection& cut,
                               std::vector<faults::FaultCutoffs>& cutoffs) {
  std::vector<section::Horizon>& horizons = cut.section.horizons;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    std::vector<std::size_t> found;
    std::vector<geom::Polyline> lines;
    std::vector<section::HorizonId> ids;
    for (std::size_t i = 0; i < horizons.size(); ++i) {
      if (cut.horizons[i].part != part || whole_name(horizons[i]) != bed) continue;
      found.push_back(i);
      lines.push_back(left_to_right(horizons[i].line));
      ids.push_back(horizons[i].id);
    }
    if (found.size() < 2) continue;
    DOBRA_TRY(horizons[found.front()].line, joined(bed, parts[part], std::move(lines), size, cut.remarks));
    rename_cutoffs(ids, horizons[found.front()], same_place * size, cutoffs);
    for (std::size_t k = found.size(); k-- > 1;) {
      horizons.erase(horizons.begin() + static_cast<std::ptrdiff_t>(found[k]));
      cut.horizons.erase(cut.horizons.begin() + static_cast<std::ptrdiff_t>(found[k]));
    }
  }
  return {};
}

}  // namespace recon::jigsaw
