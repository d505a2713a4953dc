#include "shared/surf/trim/strands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/surf/trim/chart_curves.h"

namespace dobra::surf::trim {

using base::Error;
using base::ErrorCode;
using geom::Point;
using geom::Vector;

namespace {

constexpr int samples = 48;  ///< Between two breaks.

/// Parts of an edge's way, from 0 to 1, at which it is looked at.
std::vector<double> looks(const ChartEdge& edge) {
  std::vector<double> breaks{0.0, 1.0};
  for (const double t : edge.curve.breaks()) {
    const double part = (t - edge.from) / (edge.to - edge.from);
    if (part > 1e-12 && part < 1.0 - 1e-12) breaks.push_back(part);
  }
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> parts{0.0};
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    for (int i = 1; i <= samples; ++i)
      parts.push_back(std::lerp(breaks[k], breaks[k + 1], static_cast<double>(i) / samples));
  }
  return parts;
}

Point at(const ChartEdge& edge, double part) { return edge.at(std::lerp(edge.from, edge.to, part)); }

class Maker {
 public:
  Maker(const Surface& surface, const RecogniseOptions& options) : surface_(surface), options_(options) {
    made_.arcs.chart = surface.chart();
  }

  base::Result<Strands> run(std::span<const TrimLine> lines) {
    for (const Point corner : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}})
      made_.arcs.vertices.push_back(corner);
    for (std::size_t i = 0; i < lines.size(); ++i) DOBRA_TRY_VOID(add(lines[i], i));
    add_sides(lines.size());
    return std::move(made_);
  }

 private:
  /// The parts of an edge between seams, each in the chart.
  base::Result<std::vector<Strand>> in_chart(const ChartEdge& edge, const TrimLine& line, std::size_t number) {
    std::vector<double> cuts{0.0, 1.0};
    const geom::Box& chart = surface_.chart();
    const std::vector<double> parts = looks(edge);
    for (const double part : parts) {
      const Point p = made_.arcs.part(at(edge, part));
      if (!geom::is_finite(p)) return Error{ErrorCode::NotFinite, "a line in the chart has a point that is not finite"};
      constexpr double far = 1000.0;
      if (std::abs(p.x) > far || std::abs(p.y) > far) return beside_chart(p);
    }
    const auto cut_at_borders = [&](bool closed, auto coordinate, double low, double range) {
      const auto place = [&](double part) { return (coordinate(at(edge, part)) - low) / range; };
      const bool leaves = std::any_of(parts.begin(), parts.end(), [&](double part) {
        return place(part) > 1.0 + options_.same || place(part) < -options_.same;
      });
      if (!leaves) return;
      for (std::size_t i = 1; i < parts.size(); ++i) {
        const double a = place(parts[i - 1]), b = place(parts[i]);
        if (std::max(a, b) <= 1.0 && std::min(a, b) >= 0.0) continue;
        for (double seam = std::ceil(std::min(a, b)); seam <= std::max(a, b); ++seam) {
          if (!closed && seam != 0.0 && seam != 1.0) continue;
          if (std::abs(a - seam) <= options_.same && std::abs(b - seam) <= options_.same) continue;  // along it
          double from = parts[i - 1], to = parts[i];
          for (int k = 0; k < 60; ++k) {
            const double middle = 0.5 * (from + to);
            const bool before = (place(middle) < seam) == (a < b);
            (before ? from : to) = middle;
          }
          cuts.push_back(0.5 * (from + to));
        }
      }
    };
    cut_at_borders(
        surface_.closed_u(), [](Point p) { return p.x; }, chart.low.x, chart.width());
    cut_at_borders(
        surface_.closed_v(), [](Point p) { return p.y; }, chart.low.y, chart.height());
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end(), [](double a, double b) { return b - a < 1e-9; }), cuts.end());
    cuts.back() = 1.0;
    std::vector<Strand> strands;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      Strand strand{.edge = edge, .line = number, .bounds = line.bounds, .kind = line.line.kind};
      strand.whole_from = edge.from, strand.whole_to = edge.to;
      strand.edge.from = i == 0 ? edge.from : std::lerp(edge.from, edge.to, cuts[i]);
      strand.edge.to = i + 2 == cuts.size() ? edge.to : std::lerp(edge.from, edge.to, cuts[i + 1]);
      const Point middle = made_.arcs.part(at(edge, 0.5 * (cuts[i] + cuts[i + 1])));
      const auto periods = [&](bool closed, double part) {
        return closed && (part < -options_.same || part > 1.0 + options_.same) ? -std::floor(part) : 0.0;
      };
      const Vector by{chart.width() * periods(surface_.closed_u(), middle.x),
                      chart.height() * periods(surface_.closed_v(), middle.y)};
      if (!(by == Vector{})) strand.edge.curve = moved(edge.curve, by);
      if (!line.closed) to_low_side(strand.edge);
      DOBRA_TRY(const double beyond, how_far_beyond(strand.edge));
      if (beyond > options_.same) {
        if (!pull_in(strand, beyond)) continue;
      }
      strands.push_back(std::move(strand));
    }
    return strands;
  }

  /// What runs along the high side of a seam is taken to its low one, so that lines there find each other.
  void to_low_side(ChartEdge& edge) const {
    const std::vector<double> parts = looks(edge);
    const auto along = [&](bool closed, auto coordinate) {
      return closed && std::all_of(parts.begin(), parts.end(), [&](double part) {
               return std::abs(coordinate(made_.arcs.part(at(edge, part))) - 1.0) <= options_.same;
             });
    };
    const geom::Box& chart = surface_.chart();
    if (along(surface_.closed_u(), [](Point p) { return p.x; })) edge.curve = moved(edge.curve, {-chart.width(), 0.0});
    if (along(surface_.closed_v(), [](Point p) { return p.y; })) edge.curve = moved(edge.curve, {0.0, -chart.height()});
  }

  /// By how much of its ranges an edge lies beyond the chart at most.
  [[nodiscard]] base::Result<double> how_far_beyond(const ChartEdge& edge) const {
    double worst = 0.0;
    Point where;
    for (const double part : looks(edge)) {
      const Point p = made_.arcs.part(at(edge, part));
      const double off = std::max({-p.x, p.x - 1.0, -p.y, p.y - 1.0});
      if (off > worst) worst = off, where = p;
    }
    if (worst <= options_.close) return worst;
    return beside_chart(where);
  }
  [[nodiscard]] Error beside_chart(Point part) const {
    const Point uv = made_.arcs.uv(part);
    const geom::Box& chart = surface_.chart();
    return {
        ErrorCode::OutsideDomain, "a line leaves the chart of its surface here; keep it within the ranges of u and v",
        place_of(surface_, {std::clamp(uv.x, chart.low.x, chart.high.x), std::clamp(uv.y, chart.low.y, chart.high.y)})};
  }

  /// What lies a little beyond a border runs along it; false if nothing is left of it.
  bool pull_in(Strand& strand, double beyond) {
    const auto into = [](Point p) { return Point{std::clamp(p.x, 0.0, 1.0), std::clamp(p.y, 0.0, 1.0)}; };
    const Point a = into(made_.arcs.part(strand.edge.start())), b = into(made_.arcs.part(strand.edge.end()));
    const Point uv = made_.arcs.uv(a);
    made_.findings.push_back({"pulled_in",
                              fmt::format("a line ran {:.3g} of the range beyond the chart and was pulled in", beyond),
                              place_of(surface_, uv)});
    if (geom::distance(a, b) <= options_.same) return false;
    ChartEdge along = straight(uv, made_.arcs.uv(b), strand.edge.name);
    strand.edge = std::move(along);
    return true;
  }

  /// On a side of the chart if it is nearly there.
  [[nodiscard]] Point snapped(Point p) const {
    const auto to_side = [&](double x) {
      if (x < options_.same) return 0.0;
      return x > 1.0 - options_.same ? 1.0 : x;
    };
    return {to_side(p.x), to_side(p.y)};
  }
  [[nodiscard]] Point part_at(const Strand& strand, bool at_end) const {
    return snapped(made_.arcs.part(at_end ? strand.edge.end() : strand.edge.start()));
  }

  /// Which side that is one point two places lie on, if they do.
  [[nodiscard]] bool one_pole(Point a, Point b) const {
    return (a.x == b.x &&
            ((a.x == 0.0 && surface_.collapsed(Side::Left)) || (a.x == 1.0 && surface_.collapsed(Side::Right)))) ||
           (a.y == b.y &&
            ((a.y == 0.0 && surface_.collapsed(Side::Bottom)) || (a.y == 1.0 && surface_.collapsed(Side::Top))));
  }
  /// Differ by whole periods only.
  [[nodiscard]] bool one_place_over_seams(Point a, Point b) const {
    const auto same = [&](double p, double q, bool closed) {
      return std::abs(p - q) <= options_.same || (closed && std::abs(std::abs(p - q) - 1.0) <= options_.same);
    };
    return same(a.x, b.x, surface_.closed_u()) && same(a.y, b.y, surface_.closed_v());
  }

  base::Result<void> add(const TrimLine& line, std::size_t number) {
    std::vector<Strand> strands;
    std::vector<bool> follows;  // an edge before it, rather than its own part beyond a seam
    for (const ChartEdge& edge : line.line.edges) {
      if (edge.from == edge.to) continue;
      DOBRA_TRY(std::vector<Strand> parts, in_chart(edge, line, number));
      for (std::size_t i = 0; i < parts.size(); ++i) {
        follows.push_back(i == 0);
        strands.push_back(std::move(parts[i]));
      }
    }
    if (strands.empty())
      return Error{ErrorCode::DegenerateCurve,
                   fmt::format("line {} of the chart has no edge; draw it or leave it out", number + 1)};
    Arcs& arcs = made_.arcs;
    for (Strand& each : strands) {
      each.start = arcs.vertex(part_at(each, false), options_.same);
      each.end = arcs.vertex(part_at(each, true), options_.same);
    }
    std::vector<Strand> along_poles;
    for (std::size_t i = 0; i < strands.size(); ++i) {
      const bool first = i == 0;
      if (first && !line.closed) continue;
      Strand& before = strands[first ? strands.size() - 1 : i - 1];
      Strand& next = strands[i];
      if (before.end == next.start) continue;
      const Point a = arcs.vertices[before.end], b = arcs.vertices[next.start];
      if (one_place_over_seams(a, b)) continue;
      if (one_pole(a, b)) {
        Strand strand{.edge = straight(arcs.uv(a), arcs.uv(b)), .line = number, .bounds = line.bounds};
        strand.start = before.end, strand.end = next.start;
        along_poles.push_back(std::move(strand));
        continue;
      }
      const double gap = geom::distance(a, b);
      const Point uv = arcs.uv(a);
      const double metres = geom::distance(surface_.at(uv), surface_.at(arcs.uv(b)));
      if (gap > options_.close || !follows[i]) {
        const std::string what =
            first ? fmt::format("the line does not close: its ends are {:.6g} m apart here; draw it to its beginning",
                                metres)
                  : fmt::format(
                        "edges that follow each other are {:.6g} m apart here; let each end where the next begins",
                        metres);
        return Error{ErrorCode::CannotMesh, what, place_of(surface_, uv)};
      }
      made_.findings.push_back({"gap_closed",
                                fmt::format("a gap of {:.3g} m between edges of a line was closed", metres),
                                place_of(surface_, uv)});
      if (strands.size() == 1) {
        next.end = next.start;
      } else {
        const bool keep_before = a.x == 0.0 || a.x == 1.0 || a.y == 0.0 || a.y == 1.0;
        (keep_before ? next.start : before.end) = keep_before ? before.end : next.start;
      }
    }
    for (Strand& each : strands) arcs.strands.push_back(with_exact_ends(std::move(each)));
    for (Strand& each : along_poles) arcs.strands.push_back(std::move(each));
    return {};
  }

  [[nodiscard]] Strand with_exact_ends(Strand strand) const {
    const Arcs& arcs = made_.arcs;
    strand.edge = with_ends(strand.edge, arcs.chart, arcs.uv(arcs.vertices[strand.start]),
                            arcs.uv(arcs.vertices[strand.end]), 1e-13);
    return strand;
  }

  void add_sides(std::size_t number) {
    const auto add = [&](Side side, std::size_t from, std::size_t to, const char* name) {
      const Arcs& arcs = made_.arcs;
      Strand strand{
          .edge = straight(arcs.uv(arcs.vertices[from]), arcs.uv(arcs.vertices[to]), options_.name_sides ? name : ""),
          .line = number++,
          .side = side};
      strand.start = from, strand.end = to;
      made_.arcs.strands.push_back(std::move(strand));
    };
    add(Side::Bottom, 0, 1, "bottom");
    add(Side::Right, 1, 2, "right");
    add(Side::Top, 3, 2, "top");
    add(Side::Left, 0, 3, "left");
  }

  const Surface& surface_;
  const RecogniseOptions& options_;
  Strands made_;
};

}  // namespace

base::Result<Strands> strands_of(const Surface& surface, std::span<const TrimLine> lines,
                                 const RecogniseOptions& options) {
  return Maker(surface, options).run(lines);
}

}  // namespace dobra::surf::trim
