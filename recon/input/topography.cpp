#include "recon/input/topography.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/section/crossings.h"
#include "recon/section/section_faces.h"
#include "shared/geom/place.h"

namespace recon::input {

namespace {

struct Piece {
  geom::Polyline line;
  bool above = false;
};

/// Whether a point lies over the surface: from there upwards the surface is not met an odd number of times.
bool lies_above(geom::Point p, const geom::Polyline& surface) {
  bool under = false;
  bool beside = true;
  for (std::size_t i = 0; i < surface.segment_count(); ++i) {
    const geom::Segment s = surface.segment(i);
    if ((s.from.x > p.x) == (s.to.x > p.x)) continue;
    beside = false;
    const double z = s.from.y + (s.to.y - s.from.y) * (p.x - s.from.x) / (s.to.x - s.from.x);
    if (z >= p.y) under = !under;
  }
  return !under && !beside;
}

/// A line in pieces between the places where it meets the surface, which gets those places as vertices.
base::Result<std::vector<Piece>> pieces_of(const geom::Polyline& line, geom::Polyline& surface) {
  DOBRA_TRY(const section::Arrangement arrangement, section::Arrangement::make({line, surface}));
  const topo::Subdivision& sub = arrangement.subdivision();
  const auto on_surface = [&](topo::VertexId v) {
    const auto round = sub.round(v);
    return std::any_of(round.begin(), round.end(),
                       [&](topo::HalfEdgeId h) { return arrangement.runs_along(topo::Structure::edge(h), 1); });
  };
  std::vector<Piece> pieces(1);
  const std::vector<topo::HalfEdgeId> path = arrangement.path(0);
  for (const topo::HalfEdgeId h : path) {
    arrangement.append(h, pieces.back().line.points);
    if (!on_surface(sub.target(h)) && h != path.back()) continue;
    pieces.back().line.points.push_back(sub.point(sub.target(h)));
    pieces.emplace_back();
  }
  pieces.pop_back();
  std::vector<Piece> joined;
  for (Piece& piece : pieces) {
    const std::size_t middle = piece.line.segment_count() / 2;
    const geom::Segment segment = piece.line.segment(middle);
    piece.above = lies_above(geom::midpoint(segment.from, segment.to), surface);
    if (!joined.empty() && joined.back().above == piece.above) {  // it only touched the surface
      std::vector<geom::Point>& points = joined.back().line.points;
      points.insert(points.end(), piece.line.points.begin() + 1, piece.line.points.end());
    } else {
      joined.push_back(std::move(piece));
    }
  }
  geom::Polyline cut;
  const std::vector<topo::HalfEdgeId> surface_path = arrangement.path(1);
  for (const topo::HalfEdgeId h : surface_path) arrangement.append(h, cut.points);
  cut.points.push_back(sub.point(sub.target(surface_path.back())));
  surface = std::move(cut);
  return joined;
}

class Cutter {
 public:
  explicit Cutter(ReadSection& read) : read_(read), section_(read.section) {
    for (const section::Horizon& horizon : section_.horizons) next_id_ = std::max(next_id_, horizon.id.index() + 1);
  }

  base::Result<void> cut_at(std::size_t surface) {
    std::vector<section::Horizon> below;
    for (const section::Horizon& horizon : section_.horizons) {
      DOBRA_TRY(const std::vector<Piece> pieces, pieces_of(horizon.line, section_.lines[surface].line));
      const auto below_count = std::count_if(pieces.begin(), pieces.end(), [](const Piece& p) { return !p.above; });
      double eroded = 0.0;
      std::size_t kept = 0;
      for (const Piece& piece : pieces) {
        if (piece.above) {
          eroded += geom::length(piece.line);
          section_.lines.push_back({section::LineId(section_.lines.size()), section::LineKind::Eroded,
                                    whole_name(horizon), piece.line, horizon.source});
          continue;
        }
        section::Horizon part = horizon;
        part.line = piece.line;
        if (++kept > 1) part.id = section::HorizonId(next_id_++);
        if (below_count > 1) {
          part.piece_of = whole_name(horizon);
          part.name = fmt::format("{} ({})", horizon.name, kept);
          if (find_horizon(section_, part.name) != nullptr)
            return base::Error{
                base::ErrorCode::BadSection,
                "a part of another horizon below the topography has this name already; change one of them",
                place_at(part.line.points.front(), fmt::format("horizon '{}'", part.name))};
        }
        below.push_back(std::move(part));
      }
      if (eroded == 0.0) continue;
      read_.remarks.push_back(
          fmt::format("horizon '{}': {:.6g} m of {:.6g} m lie above the topography '{}'; they are drawn dashed and not "
                      "restored{}",
                      horizon.name, eroded, geom::length(horizon.line), section_.lines[surface].name,
                      kept > 1 ? fmt::format(", and it falls into {} parts", kept) : ""));
    }
    if (below.empty() && !section_.horizons.empty()) {
      return base::Error{base::ErrorCode::BadSection,
                         "all horizons lie above it; check its heights, or set above_topography = \"restore\"",
                         place_at(section_.lines[surface].line.points.front(),
                                  fmt::format("topography '{}'", section_.lines[surface].name))};
    }
    section_.horizons = std::move(below);
    return {};
  }

 private:
  ReadSection& read_;
  section::Section& section_;
  std::size_t next_id_ = 0;
};

}  // namespace

base::Result<void> cut_at_topography(ReadSection& read) {
  Cutter cutter(read);
  const std::size_t count = read.section.lines.size();
  for (std::size_t i = 0; i < count; ++i) {
    const section::SectionLine& line = read.section.lines[i];
    if (line.kind != section::LineKind::Topography) continue;
    if (const auto crossings = section::self_crossings(line.line); !crossings.empty()) {
      return base::Error{base::ErrorCode::BadSection, "the line crosses itself here; correct it",
                         place_at(crossings.front().place, fmt::format("topography '{}'", line.name))};
    }
    DOBRA_TRY_VOID(cutter.cut_at(i));
  }
  return {};
}

base::Result<section::Section> with_topography_as_horizon(section::Section section, const std::string& name) {
  const auto found = std::find_if(section.lines.begin(), section.lines.end(), [&](const section::SectionLine& line) {
    return line.kind == section::LineKind::Topography && line.name == name;
  });
  if (name.empty() || found == section.lines.end() || find_horizon(section, name) != nullptr) return section;
  std::size_t id = 0;
  for (const section::Horizon& horizon : section.horizons) id = std::max(id, horizon.id.index() + 1);
  section.horizons.push_back({section::HorizonId(id), found->name, found->line, found->source});
  section.lines.erase(found);
  DOBRA_TRY(section::SectionFaces faces, faces_of(section));
  section.faces = std::make_shared<const section::SectionFaces>(std::move(faces));
  return section;
}

}  // namespace recon::input
