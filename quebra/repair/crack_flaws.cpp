#include "quebra/repair/crack_flaws.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "quebra/domain/faces.h"
#include "quebra/sketch/enclosed.h"
#include "shared/topo/insert.h"
#include "shared/topo/locate.h"

namespace quebra::repair {
namespace {

using dobra::geom::Point;
using dobra::topo::FaceId;
using dobra::topo::HalfEdgeId;
using dobra::topo::Subdivision;

std::array<Point, 2> ends_of(const sketch::Curve& curve) { return {point(curve, 0.0), point(curve, length(curve))}; }

/// Curves that a crack meets in its end `at`, with the distance of each from the end as it was drawn.
std::map<std::size_t, double> touched(const domain::Domain& domain, std::size_t crack, Point at, Point drawn) {
  std::map<std::size_t, double> gaps;
  for (const domain::Junction& junction : domain.junctions) {
    if (junction.at == at && junction.curve != crack)
      gaps[junction.curve] = distance(point(domain.curves[junction.curve], junction.s), drawn);
  }
  // Ends of open curves and the vertex where a closed one closes are no junctions of theirs.
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    if (c == crack) continue;
    const auto ends = ends_of(domain.curves[c]);
    if (ends[0] == at || ends[1] == at) gaps[c] = distance(at, drawn);
  }
  return gaps;
}

enum class Across { All, Lines, Cracks };

/// The parts of the material, with the cracks and without.
class Parts {
 public:
  explicit Parts(const domain::Domain& domain) : domain_(domain) {}

  std::vector<sketch::Finding> run() {
    if (!divide()) return {};
    const auto whole = groups(Across::All), cut = groups(Across::Lines);
    std::map<FaceId, std::map<FaceId, double>> areas;  // by what was whole: of each part of it
    for (const auto& [face, area] : area_) areas[whole.at(face)][cut.at(face)] += area;
    std::vector<sketch::Finding> findings;
    for (const auto& [piece, parts] : areas) {
      if (parts.size() > 1) findings.push_back(finding(piece, parts, whole, cut));
    }
    return findings;
  }

 private:
  /// False if the curves cannot be divided, which find_faces has told.
  bool divide() {
    std::vector<dobra::geom::Polyline> lines;
    for (std::size_t c = 0; c < domain_.curves.size(); ++c) lines.push_back(chords(domain_, c));
    const auto paths = insert(subdivision_, lines);
    if (!paths) return false;
    for (std::size_t c = 0; c < lines.size(); ++c) {
      if (domain_.curves[c].role != sketch::Role::Crack) continue;
      for (const HalfEdgeId h : (*paths)[c]) crack_of_.try_emplace(Subdivision::edge(h).index(), c);
    }
    const domain::Inside inside(domain_);
    for (const FaceId face : subdivision_.faces()) {
      if (face == Subdivision::unbounded()) continue;
      const auto sides = domain::sides_of(subdivision_, face);
      if (inside(sketch::inner_point(sides))) area_[face] = sketch::area_of(sides);
    }
    return true;
  }

  /// For each face of the material the first one that is joined to it across those curves.
  [[nodiscard]] std::map<FaceId, FaceId> groups(Across across) const {
    std::map<FaceId, FaceId> first;
    for (const auto& [face, area] : area_) first[face] = face;
    const auto root = [&](FaceId f) {
      while (first.at(f) != f) f = first.at(f);
      return f;
    };
    for (const auto edge : subdivision_.edges()) {
      const auto [left, right] = beside(edge);
      if (!area_.contains(left) || !area_.contains(right)) continue;
      if (across != Across::All && crack_of_.contains(edge.index()) != (across == Across::Cracks)) continue;
      const FaceId a = root(left), b = root(right);
      first[std::max(a, b)] = std::min(a, b);
    }
    for (auto& [face, to] : first) to = root(face);
    return first;
  }
  [[nodiscard]] std::pair<FaceId, FaceId> beside(dobra::topo::EdgeId edge) const {
    const HalfEdgeId h = Subdivision::half_edge(edge);
    return {subdivision_.face(h), subdivision_.face(Subdivision::twin(h))};
  }

  /// The names of the regions that each part has faces of.
  [[nodiscard]] std::map<FaceId, std::set<std::string>> regions_of(const std::map<FaceId, FaceId>& cut) const {
    // Cracks cut faces, of which one piece has the point.
    const auto faces = groups(Across::Cracks);
    std::map<FaceId, std::string> name;
    for (const domain::Face& face : domain_.faces) {
      const auto where = dobra::topo::locate(subdivision_, face.inside);
      FaceId id = where.face;
      if (where.where == dobra::topo::Where::Edge) id = beside(where.edge).first;
      if (where.where == dobra::topo::Where::Vertex) id = subdivision_.face(subdivision_.leaving(where.vertex));
      const auto named = domain_.region_names.find(face.region);
      if (faces.contains(id))
        name[faces.at(id)] = named == domain_.region_names.end() ? fmt::format("region {}", face.region)
                                                                 : fmt::format("region '{}'", named->second);
    }
    std::map<FaceId, std::set<std::string>> regions;
    for (const auto& [face, part] : cut) {
      if (const auto known = name.find(faces.at(face)); known != name.end()) regions[part].insert(known->second);
    }
    return regions;
  }

  [[nodiscard]] sketch::Finding finding(FaceId piece, const std::map<FaceId, double>& parts,
                                        const std::map<FaceId, FaceId>& whole,
                                        const std::map<FaceId, FaceId>& cut) const {
    std::set<std::string> cracks;
    Point at;
    for (const auto& [edge, crack] : crack_of_) {
      const dobra::topo::EdgeId id(edge);
      const auto [left, right] = beside(id);
      if (!area_.contains(left) || !area_.contains(right) || whole.at(left) != piece || cut.at(left) == cut.at(right))
        continue;
      const auto side = subdivision_.segment(Subdivision::half_edge(id));
      if (cracks.empty()) at = midpoint(side.from, side.to);
      cracks.insert(domain_.curves[crack].name);
    }
    std::map<FaceId, std::set<std::string>> regions = regions_of(cut);
    std::vector<std::string> texts;
    for (const auto& [part, area] : parts)
      texts.push_back(fmt::format("{:.4g} m2 of {}", area, fmt::join(regions[part], " and ")));
    return {sketch::Wrong::CutThrough, at, fmt::format("{}", fmt::join(cracks, ", ")),
            fmt::format("left as it is: the material falls into {} parts, {}, and each needs supports of its own; end "
                        "the crack inside if that is not meant",
                        parts.size(), fmt::join(texts, "; "))};
  }

  const domain::Domain& domain_;
  Subdivision subdivision_;
  std::map<std::size_t, std::size_t> crack_of_;  ///< By edge.
  std::map<FaceId, double> area_;                ///< Of the faces of the material, m2.
};

}  // namespace

CrackEnds crack_ends(const sketch::Sketch& sketch) {
  CrackEnds ends;
  for (const sketch::Curve& curve : sketch.curves) {
    if (curve.role == sketch::Role::Crack) ends[curve.name] = ends_of(curve);
  }
  return ends;
}

std::vector<sketch::Finding> crack_flaws(const domain::Domain& domain, const CrackEnds& drawn) {
  constexpr double rounding = 1e-12;
  std::vector<sketch::Finding> findings;
  std::size_t contacts = 0;
  if (drawn.empty()) return findings;
  const double size = domain.box().diagonal();
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    const auto known = drawn.find(domain.curves[c].name);
    if (domain.curves[c].role != sketch::Role::Crack || known == drawn.end()) continue;
    const auto ends = ends_of(domain.curves[c]);
    contacts += static_cast<std::size_t>(std::count_if(domain.junctions.begin(), domain.junctions.end(),
                                                       [&](const domain::Junction& j) { return j.curve == c; }));
    for (std::size_t k = 0; k < 2; ++k) {
      const auto gaps = touched(domain, c, ends[k], known->second[k]);
      contacts += gaps.size();
      for (const auto& [other, gap] : gaps) {
        if (gap <= rounding * size) continue;
        findings.push_back(
            {sketch::Wrong::NearlyTouching, ends[k], fmt::format("{}, {}", known->first, domain.curves[other].name),
             fmt::format("the crack ends {:.3g} m from '{}', is taken to touch it, and opens into it; "
                         "let it touch, or end it farther away than {:.3g} m (join_tolerance)",
                         gap, domain.curves[other].name, domain::DomainOptions{}.join_tolerance * size)});
      }
    }
  }
  if (contacts < 2) return findings;
  for (sketch::Finding& finding : Parts(domain).run()) findings.push_back(std::move(finding));
  return findings;
}

}  // namespace quebra::repair
