#include "shared/surf/trim/open.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "shared/surf/measure.h"
#include "shared/surf/trim/chart_curves.h"
#include "shared/surf/trim/rings.h"

namespace dobra::surf::trim {

using base::Error;
using base::ErrorCode;
using geom::Box;
using geom::Point;

namespace {

bool on_side(const Box& chart, Side side, Point uv) {
  switch (side) {
    case Side::Left:
      return uv.x == chart.low.x;
    case Side::Right:
      return uv.x == chart.high.x;
    case Side::Bottom:
      return uv.y == chart.low.y;
    case Side::Top:
      return uv.y == chart.high.y;
  }
  return false;
}
bool lies_on_side(const Box& chart, Side side, const ChartEdge& edge) {
  return on_side(chart, side, edge.start()) && on_side(chart, side, edge.end()) &&
         on_side(chart, side, edge.at(std::lerp(edge.from, edge.to, 0.437)));
}
constexpr std::array<Side, 4> all_sides{Side::Left, Side::Right, Side::Bottom, Side::Top};
constexpr Side opposite(Side side) {
  switch (side) {
    case Side::Left:
      return Side::Right;
    case Side::Right:
      return Side::Left;
    case Side::Bottom:
      return Side::Top;
    default:
      return Side::Bottom;
  }
}
constexpr bool runs_along_u(Side side) { return side == Side::Bottom || side == Side::Top; }

/// Loops as rings of edges in which edges can be taken out.
class Rings {
 public:
  explicit Rings(const std::vector<ChartLoop>& loops) {
    for (const ChartLoop& loop : loops) {
      const std::size_t first = edges_.size(), count = loop.edges.size();
      for (std::size_t i = 0; i < count; ++i) {
        edges_.push_back(loop.edges[i]);
        next_.push_back(first + (i + 1) % count);
        before_.push_back(first + (i + count - 1) % count);
        here_.push_back(true);
      }
    }
  }
  [[nodiscard]] std::size_t size() const { return edges_.size(); }
  [[nodiscard]] bool has(std::size_t i) const { return here_[i]; }
  [[nodiscard]] ChartEdge& edge(std::size_t i) { return edges_[i]; }
  void take_out(std::size_t i) {
    here_[i] = false;
    if (next_[i] != i) link(before_[i], next_[i]);
  }
  /// Both sides of a seam: what came before one goes on after the other.
  void sew(std::size_t i, std::size_t k) {
    here_[i] = here_[k] = false;
    const std::size_t before_i = before_[i], before_k = before_[k], after_i = next_[i], after_k = next_[k];
    if (before_i != k) link(before_i, after_k);
    if (before_k != i) link(before_k, after_i);
  }
  [[nodiscard]] std::vector<ChartLoop> loops() const {
    std::vector<ChartLoop> made;
    std::vector<bool> seen(edges_.size(), false);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (!here_[i] || seen[i]) continue;
      made.emplace_back();
      for (std::size_t k = i; !seen[k]; k = next_[k]) {
        seen[k] = true;
        made.back().edges.push_back(edges_[k]);
      }
    }
    return made;
  }

 private:
  void link(std::size_t a, std::size_t b) { next_[a] = b, before_[b] = a; }
  std::vector<ChartEdge> edges_;
  std::vector<std::size_t> next_, before_;
  std::vector<bool> here_;
};

/// Edges on both sides of a seam, in pairs.
std::vector<std::pair<std::size_t, std::size_t>> seams_in(const Surface& surface, Rings& rings) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t k = 0; k < rings.size(); ++k) {
      if (!rings.has(i) || !rings.has(k)) continue;
      const ChartEdge &a = rings.edge(i), &b = rings.edge(k);
      if (!a.shared || a.shared != b.shared) continue;
      const bool by_u = surface.closed_u() && lies_on_side(surface.chart(), Side::Left, a) &&
                        lies_on_side(surface.chart(), Side::Right, b);
      const bool by_v = surface.closed_v() && lies_on_side(surface.chart(), Side::Bottom, a) &&
                        lies_on_side(surface.chart(), Side::Top, b);
      if (by_u || by_v) pairs.emplace_back(i, k);
    }
  }
  return pairs;
}

/// The name of a line that runs along a seam, on either side of it; none where nothing was drawn there.
std::string drawn_along(const ChartEdge& low, const ChartEdge& high) {
  for (const ChartEdge* const edge : {&low, &high}) {
    const std::string& name = edge->name;
    const bool of_chart = name.empty() || name == "left" || name == "right" || name == "bottom" || name == "top";
    if (!of_chart && name != artificial_border) return name;
  }
  return {};
}

/// An edge on a seam, along the crack that runs there.
ChartEdge along_crack(ChartEdge edge) {
  if (edge.crack == ChartEdge::Crack::Against) {
    std::swap(edge.from, edge.to);
    edge.against = !edge.against;
  }
  edge.crack = ChartEdge::Crack::None;
  return edge;
}

/// A part of a face that touches one pole, in the chart round it.
base::Result<Opened> in_polar_chart(TrimmedSurface face, Side pole) {
  const Surface surface = face.surface;
  const Box& chart = surface.chart();
  const bool along_u = runs_along_u(pole);
  double reach = 0.0;
  for (const std::vector<Point>& ring : rings_of(face)) {
    for (const Point p : ring) {
      const double from_low = along_u ? (p.y - chart.low.y) / chart.height() : (p.x - chart.low.x) / chart.width();
      reach = std::max(reach, pole == Side::Bottom || pole == Side::Left ? from_low : 1.0 - from_low);
    }
  }
  constexpr double room = 1.02;  // for what curves bulge between the points looked at
  DOBRA_TRY(const PolarChart polar, polar_chart(surface, pole, std::min(1.0, room * reach)));
  Rings rings(face.loops);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (lies_on_side(chart, pole, rings.edge(i))) rings.take_out(i);
  }
  for (const auto& [i, k] : seams_in(surface, rings)) {
    const bool crack = rings.edge(i).crack != ChartEdge::Crack::None;
    const std::string name = drawn_along(rings.edge(i), rings.edge(k));
    if (polar.seam) {
      if (!crack) rings.edge(i).name = rings.edge(k).name = name.empty() ? artificial_border : name;
      continue;
    }
    if (crack) {
      face.lines.push_back({{along_crack(rings.edge(i))}, ChartLine::Kind::Crack});
      face.lines.back().edges[0].shared.reset();
    } else if (!name.empty()) {
      face.lines.push_back({{rings.edge(i)}, ChartLine::Kind::Constraint});
      face.lines.back().edges[0].name = name;
      face.lines.back().edges[0].shared.reset();
    }
    rings.sew(i, k);
  }
  face.loops = rings.loops();
  const auto map_all = [&](std::vector<ChartEdge>& edges) {
    for (ChartEdge& edge : edges) edge.curve = polar.mapped(edge.curve);
  };
  for (ChartLoop& loop : face.loops) map_all(loop.edges);
  for (ChartLine& line : face.lines) map_all(line.edges);
  for (ChartPoint& point : face.points) point.at = polar.forward(point.at);
  for (ChartRegion& region : face.regions) region.at = polar.forward(region.at);
  face.surface = polar.surface;
  const Box round = face.surface.chart();
  if (!polar.seam && has_tip(face.surface, {0, 0}, 0.5 * round.width()) && contains(face, {0, 0}))
    face.points.push_back({{0, 0}});
  std::stable_sort(face.loops.begin(), face.loops.end(), [&](const ChartLoop& a, const ChartLoop& b) {
    const auto area = [](const ChartLoop& loop) {
      std::vector<Point> ring;
      for (const ChartEdge& edge : loop.edges) add_points(edge, ring);
      return area_of(ring);
    };
    const double p = area(a), q = area(b);
    return (p > 0.0) != (q > 0.0) ? p > 0.0 : std::abs(p) > std::abs(q);
  });
  return Opened{std::move(face), polar.back, true};
}

/// A straight line across the chart between two opposite poles.
struct PoleCut {
  bool along_u = true;  ///< It runs along u, at this v; else the other way round.
  double at = 0.0;
};

/// By parts of the way between two poles.
struct TakenRange {
  double low = 0.0, high = 0.0;
};

/// Where a cut would run along edges, end with them or touch them.
/// @param flat  steps of edges that rise less than this by their way along the poles are taken as a whole
void add_taken(const std::vector<ChartEdge>& edges, const Box& chart, bool along_u, double flat,
               std::vector<TakenRange>& taken) {
  for (const ChartEdge& edge : edges) {
    std::vector<Point> points;
    add_points(edge, points);
    points.push_back(edge.end());
    std::vector<double> along, across;
    for (const Point p : points) {
      const double u = (p.x - chart.low.x) / chart.width(), v = (p.y - chart.low.y) / chart.height();
      along.push_back(along_u ? u : v);
      across.push_back(along_u ? v : u);
    }
    taken.push_back({across.front(), across.front()});
    taken.push_back({across.back(), across.back()});
    for (std::size_t i = 1; i < across.size(); ++i) {
      const auto [low, high] = std::minmax(across[i - 1], across[i]);
      if (high - low < flat * std::abs(along[i] - along[i - 1])) taken.push_back({low, high});
      if (i + 1 == across.size()) continue;
      const bool turns = (across[i] - across[i - 1]) * (across[i + 1] - across[i]) <= 0.0;
      if (turns) taken.push_back({std::min(low, across[i + 1]), std::max(high, across[i + 1])});
    }
  }
}

/// The place nearest to the middle that is `margin` from what is taken, or else the middle of the widest gap.
std::optional<double> free_place(std::vector<TakenRange> taken, double margin) {
  std::sort(taken.begin(), taken.end(), [](const TakenRange& a, const TakenRange& b) { return a.low < b.low; });
  std::optional<double> best;
  double least = 1.0, widest = 1e-4;
  double last = taken.front().high;
  for (const TakenRange& range : taken) {
    const double gap = range.low - last;
    if (gap >= 2.0 * margin) {
      const double at = std::clamp(0.5, last + margin, range.low - margin);
      if (std::abs(at - 0.5) < least) least = std::abs(at - 0.5), best = at;
    } else if (gap > widest && least == 1.0) {
      widest = gap, best = last + 0.5 * gap;
    }
    last = std::max(last, range.high);
  }
  return best;
}

/// Where a face that touches two opposite poles is cut apart: in the middle, unless a line or loop runs along there,
/// ends there or touches it. What runs along the cut would be taken as the cut.
PoleCut cut_between_poles(const TrimmedSurface& face, bool along_u) {
  const Box& chart = face.surface.chart();
  constexpr double margin = 0.03, outermost = 0.25;  // parts of the way between the poles
  const auto place = [&](double flat) {
    std::vector<TakenRange> taken{{0.0, outermost}, {1.0 - outermost, 1.0}};
    for (const ChartLoop& loop : face.loops) add_taken(loop.edges, chart, along_u, flat, taken);
    for (const ChartLine& line : face.lines) add_taken(line.edges, chart, along_u, flat, taken);
    const auto add = [&](Point p) {
      const double at = along_u ? (p.y - chart.low.y) / chart.height() : (p.x - chart.low.x) / chart.width();
      taken.push_back({at, at});
    };
    for (const ChartPoint& point : face.points) add(point.at);
    for (const ChartRegion& region : face.regions) add(region.at);
    return free_place(std::move(taken), margin);
  };
  constexpr double flat = 0.2;
  std::optional<double> part = place(flat);
  if (!part) part = place(0.0);  // Slanting lines fill the way between the poles: the cut crosses one of them.
  const double low = along_u ? chart.low.y : chart.low.x, high = along_u ? chart.high.y : chart.high.x;
  return {along_u, std::lerp(low, high, part.value_or(0.5))};
}

/// Recognised anew, with its seams numbered and, where asked, cut apart between two poles.
base::Result<Recognised> recognised_again(const TrimmedSurface& face, const std::optional<PoleCut>& cut,
                                          SharedNumbers& numbers, const RecogniseOptions& options) {
  std::vector<TrimLine> lines, cracks;
  if (cut) {
    const Box& chart = face.surface.chart();
    lines.push_back({{{cut->along_u ? straight({chart.low.x, cut->at}, {chart.high.x, cut->at}, artificial_border)
                                    : straight({cut->at, chart.low.y}, {cut->at, chart.high.y}, artificial_border)}}});
  }
  for (const ChartLoop& loop : face.loops) {
    lines.push_back({{loop.edges}, true});
    for (ChartEdge& edge : lines.back().line.edges) {
      if (edge.crack == ChartEdge::Crack::None) continue;
      TrimLine crack{{{along_crack(edge)}, ChartLine::Kind::Crack}, false, false};
      crack.line.edges[0].shared.reset();
      cracks.push_back(std::move(crack));
      edge.name.clear();
      edge.crack = ChartEdge::Crack::None;
    }
  }
  lines.insert(lines.end(), cracks.begin(), cracks.end());
  for (const ChartLine& line : face.lines) lines.push_back({line, false, false});
  RecogniseOptions nameless = options;
  nameless.name_sides = false;
  return recognise(face.surface, lines, numbers, nameless);
}

}  // namespace

bool has_tip(const Surface& surface, Point at, double radius) {
  constexpr double near = 1e-4;       // of the radius
  constexpr double blunt = 0.996195;  // the cosine of 5 degrees
  std::optional<geom::Vector3> first;
  for (const geom::Vector towards : {geom::Vector{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
    const auto normal = surf::normal(surface, at + near * radius * towards);
    if (first && normal && dot(*first, *normal) < blunt) return true;
    if (!first) first = normal;
  }
  return false;
}

bool contains(const TrimmedSurface& face, Point uv) {
  const std::vector<double> at = meets(rings_of(face), uv.y);
  return std::count_if(at.begin(), at.end(), [&](double u) { return u < uv.x; }) % 2 == 1;
}

std::vector<Side> poles_touched(const TrimmedSurface& face) {
  std::vector<Side> touched;
  for (const Side side : all_sides) {
    if (!face.surface.collapsed(side)) continue;
    const auto ends_there = [&](const ChartEdge& edge) {
      return on_side(face.surface.chart(), side, edge.start()) || on_side(face.surface.chart(), side, edge.end());
    };
    const bool is = std::any_of(face.loops.begin(), face.loops.end(), [&](const ChartLoop& loop) {
      return std::any_of(loop.edges.begin(), loop.edges.end(), ends_there);
    });
    if (is) touched.push_back(side);
  }
  return touched;
}

base::Result<std::vector<Opened>> open(const TrimmedSurface& face, SharedNumbers& numbers,
                                       const RecogniseOptions& options) {
  const std::vector<Side> poles = poles_touched(face);
  const Box& chart = face.surface.chart();
  if (poles.empty()) {
    Opened same{face, [](Point p) { return p; }, false};
    Rings rings(face.loops);
    for (const auto& [i, k] : seams_in(face.surface, rings)) {
      if (rings.edge(i).crack != ChartEdge::Crack::None) continue;
      const std::string name = drawn_along(rings.edge(i), rings.edge(k));
      rings.edge(i).name = rings.edge(k).name = name.empty() ? artificial_border : name;
    }
    same.face.loops = rings.loops();
    return std::vector{std::move(same)};
  }
  for (const Side side : poles) {
    if (side == poles.front() || side == opposite(poles.front())) continue;
    const Point corner{side == Side::Right || poles.front() == Side::Right ? chart.high.x : chart.low.x,
                       side == Side::Top || poles.front() == Side::Top ? chart.high.y : chart.low.y};
    return Error{
        ErrorCode::NotSupported,
        "the face touches two sides of its chart that are points and meet; cut it in two by a line between them",
        place_of(face.surface, corner)};
  }
  // A face that comes near to the other pole is cut too: there the chart of this one is as bad.
  const bool along_u = runs_along_u(poles.front());
  bool apart = poles.size() > 1;
  if (face.surface.collapsed(opposite(poles.front()))) {
    for (const std::vector<Point>& ring : rings_of(face)) {
      for (const Point p : ring) {
        const double part = along_u ? (p.y - chart.low.y) / chart.height() : (p.x - chart.low.x) / chart.width();
        const bool at_low = poles.front() == Side::Bottom || poles.front() == Side::Left;
        apart = apart || (at_low ? part : 1.0 - part) > 0.75;
      }
    }
  }
  std::optional<PoleCut> cut;
  if (apart) cut = cut_between_poles(face, along_u);
  DOBRA_TRY(const Recognised again, recognised_again(face, cut, numbers, options));
  std::vector<Opened> opened;
  for (const Side pole : cut ? std::vector{poles.front(), opposite(poles.front())} : poles) {
    const auto beside_pole = [&](Point p) {
      if (!cut) return true;
      const bool low = (along_u ? p.y : p.x) < cut->at;
      return low == (pole == Side::Bottom || pole == Side::Left);
    };
    std::vector<std::size_t> picked;
    for (std::size_t i = 0; i < again.faces().size(); ++i) {
      const Point inside = inner_point(again.faces()[i]);
      if (beside_pole(inside) && contains(face, inside)) picked.push_back(i);
    }
    if (picked.empty()) continue;
    TrimmedSurface part = again.united(picked, CommonLines::Keep);
    for (const ChartPoint& point : face.points) {
      if (beside_pole(point.at)) part.points.push_back(point);
    }
    for (const ChartRegion& region : face.regions) {
      if (beside_pole(region.at)) part.regions.push_back(region);
    }
    part.reversed = face.reversed, part.name = face.name, part.place = face.place;
    DOBRA_TRY(Opened one, in_polar_chart(std::move(part), pole));
    opened.push_back(std::move(one));
  }
  return opened;
}

}  // namespace dobra::surf::trim
