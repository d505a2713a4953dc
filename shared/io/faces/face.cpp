#include "shared/io/faces/face.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "shared/io/faces/checks.h"
#include "shared/io/faces/project.h"

namespace dobra::io::faces {

using geom::Box;
using geom::Point;
using geom::Point3;

bool same_place(const brep::Placement& a, const brep::Placement& b) {
  constexpr double close = 1e-9;
  const double size = std::max(1.0, length(a.origin - Point3{}));
  return length(a.x - b.x) < close && length(a.y - b.y) < close && length(a.z - b.z) < close &&
         distance(a.origin, b.origin) < close * size;
}

surf::trim::SharedCurveId SharedEdges::id_of(brep::Index edge, const brep::Placement& placement) {
  for (const Known& known : known_[edge]) {
    if (same_place(known.placement, placement)) return known.id;
  }
  known_[edge].push_back({placement, next_});
  return next_++;
}

namespace {

Refusal curve_refusal(const std::string& name, const base::Error& error) {
  return {"face_curve", fmt::format("{} cannot be used: {}", name, error.message)};
}

Refusal surface_refusal(const base::Error& error) {
  Refusal refusal{"face_surface", error.message};
  if (!error.place) return refusal;
  const base::Place& place = *error.place;
  if (place.u && place.v) refusal.uv = Point{*place.u, *place.v};
  if (place.x && place.y && place.z) refusal.at = Point3{*place.x, *place.y, *place.z};
  return refusal;
}

class FaceImport {
 public:
  FaceImport(const brep::Model& model, const brep::TrimmedFace& face, SharedEdges& shared, const ImportOptions& options,
             Report& report)
      : model_(model), face_(face), shared_(shared), options_(options), report_(report) {}

  Outcome<surf::trim::TrimmedSurface> run() {
    if (!face_.surface)
      return Refusal{"face_surface", "it has no surface, only triangles; save the model with its surfaces"};
    auto whole = whole_surface(*model_.surfaces[*face_.surface], face_.placement);
    if (!whole) return surface_refusal(whole.error());
    whole_ = *std::move(whole);
    for (const auto& wire : face_.loops) {
      if (auto refusal = add_wire(wire)) return *refusal;
    }
    if (auto refusal = project_missing()) return *refusal;
    drop_tiny();
    if (auto refusal = make_loops()) return *refusal;
    if (auto refusal = cut_surface()) return *refusal;
    if (auto refusal = check()) return *refusal;
    return finished();
  }

 private:
  /// Its number in the words of the user: by the order in which edges come.
  static std::string name_of(surf::trim::SharedCurveId id) { return fmt::format("edge {}", id + 1); }

  std::optional<Refusal> add_wire(const std::vector<brep::LoopEdge>& wire) {
    Loop loop;
    for (const brep::LoopEdge& edge : wire) {
      auto made = piece_of(edge);
      if (auto* refusal = std::get_if<Refusal>(&made)) return *refusal;
      std::optional<Piece>& piece = std::get<std::optional<Piece>>(made);
      if (!piece) continue;
      const bool within =
          edge.orientation == brep::Orientation::Internal || edge.orientation == brep::Orientation::External;
      (within ? lines_ : loop).push_back(*std::move(piece));
    }
    if (!loop.empty()) wires_.push_back(std::move(loop));
    return std::nullopt;
  }

  /// A piece, still without a curve in the chart where the file has none; nothing for a point without one.
  Outcome<std::optional<Piece>> piece_of(const brep::LoopEdge& use) {
    const brep::Shape& shape = model_.shapes[use.edge];
    const brep::Edge& edge = std::get<brep::Edge>(shape.is);
    Piece piece{.curve = unknown()};
    piece.edge = use.edge;
    piece.still = edge.degenerated;
    piece.tolerance = shape.tolerance;
    if (!piece.still) piece.shared = shared_.id_of(use.edge, use.placement);
    piece.name = piece.shared ? name_of(*piece.shared) : "a point edge";
    for (const brep::Use& part : shape.parts) {
      const brep::Shape& vertex = model_.shapes[part.shape];
      piece.tolerance = std::max(piece.tolerance, vertex.tolerance);
      if (part.orientation == brep::Orientation::Forward) piece.start = part.shape + 1;
      if (part.orientation == brep::Orientation::Reversed) piece.end = part.shape + 1;
    }
    // Tolerances grow with what is scaled.
    piece.tolerance *= std::cbrt(std::abs(use.placement.scale_of_volume()));
    if (edge.curve) {
      auto space = to_curve(*model_.curves[edge.curve->curve], edge.curve->from, edge.curve->to);
      if (!space) return curve_refusal(piece.name, space.error());
      piece.space = placed(*space, use.placement * edge.curve->placement);
      piece.space_from = piece.from = edge.curve->from;
      piece.space_to = piece.to = edge.curve->to;
    }
    if (use.chart) {
      auto curve = to_curve(*model_.chart_curves[use.chart->curve], use.chart->from, use.chart->to);
      if (!curve) return curve_refusal(piece.name, curve.error());
      piece.curve = *curve;
      piece.from = use.chart->from;
      piece.to = use.chart->to;
      piece.drawn = use.chart->curve;
    } else if (!piece.space) {
      if (piece.still) return std::optional<Piece>{};
      return Refusal{"face_curve", fmt::format("{} has no curve, neither in space nor in the chart", piece.name)};
    }
    if (use.orientation == brep::Orientation::Reversed) piece = turned(std::move(piece));
    return std::optional<Piece>{std::move(piece)};
  }

  static const surf::Curve& unknown() {
    static const surf::Curve line = *surf::Curve::line({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    return line;
  }

  template <class Do>
  void for_each_piece(Do&& with) {
    for (Loop& wire : wires_) std::for_each(wire.begin(), wire.end(), with);
    std::for_each(lines_.begin(), lines_.end(), with);
  }

  /// The part of the chart that curves in it and in space reach.
  Box reached() {
    Box box;
    for_each_piece([&](const Piece& piece) {
      if (piece.drawn) {
        for (const double t : parameters_along(piece)) box.add(piece.at(t));
      } else if (piece.space && whole_.place_of) {
        for (int i = 0; i <= 16; ++i) {
          const auto uv = whole_.place_of(piece.space->at(std::lerp(piece.space_from, piece.space_to, i / 16.0)));
          if (uv) box.add(*uv);
        }
      }
    });
    return box;
  }

  std::optional<Refusal> project_missing() {
    Box box = reached();
    if (!geom::is_finite(box.low) || !geom::is_finite(box.high)) {
      if (!box.empty()) return Refusal{"face_curve", "a curve of its loops is not finite"};
      box = whole_.range;
    }
    const auto widened = [](double& low, double& high, double from, double to, double period) {
      if (period > 0.0) {
        low = std::min(low, from) - period;
        high = std::max(high, to) + period;
      } else if (std::isfinite(from) && std::isfinite(to)) {
        low = from, high = to;
      } else {
        if (!std::isfinite(low)) low = std::isfinite(high) ? high - 1.0 : -1.0;
        if (!std::isfinite(high)) high = low + 1.0;
        const double more = std::max(0.5 * (high - low), 1e-9 * std::max(std::abs(low), std::abs(high)));
        low = std::max(low - (more > 0.0 ? more : 1.0), from);
        high = std::min(high + (more > 0.0 ? more : 1.0), to);
      }
    };
    widened(box.low.x, box.high.x, whole_.range.low.x, whole_.range.high.x, whole_.period_u);
    widened(box.low.y, box.high.y, whole_.range.low.y, whole_.range.high.y, whole_.period_v);
    stop_at_points(box.low.x, box.high.x, whole_.points_u);
    stop_at_points(box.low.y, box.high.y, whole_.points_v);
    auto surface = whole_.over(box);
    if (!surface) return surface_refusal(surface.error());
    scratch_ = *surface;
    measure();
    std::optional<Refusal> refusal;
    for_each_piece([&](Piece& piece) {
      if (piece.drawn || refusal) return;
      auto made = projected(whole_, *scratch_, piece, diagonal_, options_, report_);
      if (auto* why = std::get_if<Refusal>(&made))
        refusal = *why;
      else
        piece = std::get<Piece>(std::move(made));
    });
    return refusal;
  }

  /// A cone does not go on behind its apex; the side on which most of the range lies is meant.
  static void stop_at_points(double& low, double& high, const std::vector<double>& points) {
    for (const double at : points) {
      if (!(low < at && at < high)) continue;
      if (at - low < high - at)
        low = at;
      else
        high = at;
    }
  }

  void measure() {
    Point3 low{endless, endless, endless}, high{-endless, -endless, -endless};
    const auto add = [&](Point3 p) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    };
    for_each_piece([&](const Piece& piece) {
      if (piece.drawn) {
        for (const Point uv : spread(piece)) add(scratch_->at(uv));
      } else if (piece.space) {
        for (int i = 0; i <= 16; ++i) add(piece.space->at(std::lerp(piece.space_from, piece.space_to, i / 16.0)));
      }
    });
    diagonal_ = low.x <= high.x ? distance(low, high) : scratch_->size();
    if (!(diagonal_ > 0.0)) diagonal_ = scratch_->size();
  }

  [[nodiscard]] double length_of(const Piece& piece) const {
    constexpr int chords = 64;
    const auto at = [&](int i) {
      const double part = static_cast<double>(i) / chords;
      return piece.space ? piece.space->at(std::lerp(piece.space_from, piece.space_to, part))
                         : scratch_->at(piece.at(std::lerp(piece.from, piece.to, part)));
    };
    double sum = 0.0;
    for (int i = 1; i <= chords; ++i) sum += distance(at(i - 1), at(i));
    return sum;
  }

  /// Edges shorter than their own tolerance, seen in space so that every face of an edge drops it.
  void drop_tiny() {
    const auto is_tiny = [&](const Piece& piece) {
      if (piece.still) return false;
      const double size = length_of(piece);
      if (size > piece.tolerance) return false;
      const Point at = piece.begin_at();
      report_.say("edge_dropped",
                  fmt::format("{} is {:.6g} m long, within its tolerance of {:.6g} m; taken as one point", piece.name,
                              size, piece.tolerance),
                  at, scratch_->at(at));
      return true;
    };
    for (Loop& wire : wires_) std::erase_if(wire, is_tiny);
    std::erase_if(wires_, [](const Loop& wire) { return wire.empty(); });
    std::erase_if(lines_, is_tiny);
  }

  std::optional<Refusal> make_loops() {
    const bool had_edges =
        std::any_of(face_.loops.begin(), face_.loops.end(), [](const auto& w) { return !w.empty(); });
    if (had_edges && wires_.empty() && lines_.empty())
      return Refusal{"face_empty", "all edges of its loops are shorter than their tolerance"};
    const Bench bench{whole_, *scratch_, diagonal_, options_, report_, shared_.next()};
    take_out_twice(bench, wires_, lines_);
    std::vector<Chain> chains;
    for (Loop& wire : wires_) {
      auto some = chained(bench, std::move(wire));
      if (auto* refusal = std::get_if<Refusal>(&some)) return *refusal;
      for (Chain& chain : std::get<std::vector<Chain>>(some)) chains.push_back(std::move(chain));
    }
    auto loops = loops_of(bench, std::move(chains), lines_);
    if (auto* refusal = std::get_if<Refusal>(&loops)) return *refusal;
    loops_ = std::get<std::vector<Loop>>(std::move(loops));
    return std::nullopt;
  }

  /// The range of a parameter: that of the loops with a margin, but not beyond the surface.
  void range_of_chart(double& low, double& high, double from, double to, double period,
                      const std::vector<double>& points) const {
    const double width = high - low;
    double margin = options_.margin * width;
    if (period > 0.0) {
      if (std::abs(width - period) <= 1e-9 * period) {
        high = low + period;
        return;
      }
      if (width < period) margin = std::min(margin, 0.5 * (period - width));
      const double middle = std::midpoint(low, high);
      const double first = low, last = high;
      low -= margin;
      high += margin;
      for (const double point : points) {  // those of this turn
        const double at = point + std::round((middle - point) / period) * period;
        if (at > low && at <= first + 1e-9 * period) low = at;
        if (at < high && at >= last - 1e-9 * period) high = at;
      }
      return;
    }
    const double close = 1e-9 * (std::isfinite(to - from) ? to - from : width);
    double least = from, most = to;
    for (const double at : points) {
      if (at <= low + close) least = std::max(least, at);
      if (at >= high - close) most = std::min(most, at);
    }
    low = low - margin <= least + close ? least : low - margin;
    high = high + margin >= most - close ? most : high + margin;
  }

  std::optional<Refusal> cut_surface() {
    Box box;
    for (const Loop& loop : loops_) box.add(geom::box_of(outline(loop)));
    if (!(box.width() > 0.0) || !(box.height() > 0.0))
      return Refusal{"face_empty", "its loops enclose nothing in the chart of the surface"};
    const Box tight = box;
    range_of_chart(box.low.x, box.high.x, whole_.range.low.x, whole_.range.high.x, whole_.period_u, whole_.points_u);
    range_of_chart(box.low.y, box.high.y, whole_.range.low.y, whole_.range.high.y, whole_.period_v, whole_.points_v);
    if (!(box.low.x < box.high.x && box.low.y < box.high.y))
      return Refusal{"face_outside", "its loops lie outside the range of its surface", tight.centre()};
    auto surface = whole_.over(box);
    if (!surface && !(box == tight)) {  // what is beyond the loops may be no good
      const Box held{{std::max(tight.low.x, box.low.x), std::max(tight.low.y, box.low.y)},
                     {std::min(tight.high.x, box.high.x), std::min(tight.high.y, box.high.y)}};
      surface = whole_.over(held);
    }
    if (!surface) return surface_refusal(surface.error());
    surface_ = *surface;
    return hold_in_chart();
  }

  std::optional<Refusal> hold_in_chart() {
    const Box& chart = surface_->chart();
    const geom::Vector hair{1e-12 * chart.width(), 1e-12 * chart.height()};
    const Box within{chart.low + hair, chart.high - hair};
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      for (Piece& piece : loops_[i]) {
        Point worst{};
        double displaced = 0.0;
        bool leaves = false;
        for (const Point p : spread(piece)) {
          if (within.contains(p)) continue;  // at the border rounding may lead out between the places seen
          leaves = true;
          if (chart.contains(p)) continue;
          const Point in{std::clamp(p.x, chart.low.x, chart.high.x), std::clamp(p.y, chart.low.y, chart.high.y)};
          const double by = distance(surface_->at(p), surface_->at(in));
          if (by > displaced) displaced = by, worst = in;
        }
        if (!leaves) continue;
        const Point3 at = surface_->at(worst);
        if (displaced > options_.beyond_part * diagonal_)
          return Refusal{
              "face_outside",
              fmt::format("{} leaves the range of the surface by {:.6g} m; extend the surface", piece.name, displaced),
              worst, at};
        if (displaced > 1e-9 * diagonal_)
          report_.say(
              "curve_held",
              fmt::format("{} leaves the range of the surface by {:.6g} m; held at its border", piece.name, displaced),
              worst, at);
        piece.curve = piece.curve.held(chart.low, chart.high);
      }
    }
    return std::nullopt;
  }

  std::optional<Refusal> check() {
    for (Loop& loop : loops_) {
      for (Piece& piece : loop) {
        if (auto refusal = check_space(piece)) return refusal;
      }
    }
    for (Piece& line : lines_) {
      if (auto refusal = check_space(line)) return refusal;
    }
    if (auto refusal = check_crossing()) return refusal;
    return check_areas();
  }

  std::optional<Refusal> check_crossing() {
    const auto crossing = crossing_of(*surface_, loops_, options_.gap_part * diagonal_);
    if (!crossing) return std::nullopt;
    const Point3 at = surface_->at(crossing->uv);
    const auto& [first, second, uv, at_end] = *crossing;
    const bool itself = first == second;
    if (!at_end)
      return Refusal{"face_crossing",
                     itself ? fmt::format("{} crosses itself in the chart of the surface; mend the face", first)
                            : fmt::format("{} and {} cross in the chart of the surface; mend the face", first, second),
                     uv, at};
    report_.say(
        "edges_cross",
        itself ? fmt::format("{} crosses itself in the chart of the surface, by less than gaps may be", first)
               : fmt::format("{} and {} cross in the chart of the surface, by less than gaps may be", first, second),
        uv, at);
    return std::nullopt;
  }

  std::optional<Refusal> check_areas() {
    for (auto loop = loops_.begin(); loop != loops_.end();) {
      const std::vector<Point> places = outline(*loop);
      const Box box = geom::box_of(places);
      if (std::abs(area_of(places)) > 1e-9 * box.width() * box.height()) {
        ++loop;
        continue;
      }
      const Point at = loop->front().begin_at();
      if (loops_.size() == 1) return Refusal{"face_empty", "its loop encloses no area", at, surface_->at(at)};
      report_.say("loop_dropped", "a loop encloses no area; left out", at, surface_->at(at));
      loop = loops_.erase(loop);
    }
    return std::nullopt;
  }

  std::optional<Refusal> check_space(Piece& piece) {
    if (!piece.space || !piece.drawn) return std::nullopt;
    const Apart most = apart(*surface_, piece);
    const Point3 at = surface_->at(most.uv);
    if (most.distance > std::max(options_.apart_part * diagonal_, options_.gap_tolerances * piece.tolerance))
      return Refusal{"face_apart",
                     fmt::format("the curve of {} in the chart is {:.6g} m from its curve in space; save it with both "
                                 "the same",
                                 piece.name, most.distance),
                     most.uv, at};
    if (most.distance > std::max(piece.tolerance, 1e-7 * diagonal_))
      report_.say(
          "curves_apart",
          fmt::format("the curve of {} in the chart is {:.6g} m from its curve in space, more than its tolerance "
                      "of {:.6g} m; the one in the chart is used",
                      piece.name, most.distance, piece.tolerance),
          most.uv, at);
    piece.tolerance = std::max(piece.tolerance, most.distance);
    return std::nullopt;
  }

  static surf::trim::ChartEdge edge_of(const Piece& piece) {
    return {piece.curve, piece.from, piece.to, piece.name, piece.shared, piece.against, piece.tolerance};
  }

  /// Both sides of a seam are one curve; it bounds nothing and has no name, so that nothing is kept along it.
  [[nodiscard]] bool is_seam(const Piece& piece) const {
    std::size_t sides = 0;
    for (const Loop& loop : loops_) {
      for (const Piece& other : loop) sides += piece.shared && other.shared == piece.shared ? 1U : 0U;
    }
    return sides > 1;
  }

  surf::trim::TrimmedSurface finished() {
    surf::trim::TrimmedSurface made{.surface = *surface_, .loops = {}};
    for (const Loop& loop : loops_) {
      surf::trim::ChartLoop edges;
      for (const Piece& piece : loop) {
        edges.edges.push_back(edge_of(piece));
        if (is_seam(piece)) edges.edges.back().name.clear();
      }
      made.loops.push_back(std::move(edges));
    }
    for (const Piece& line : lines_) made.lines.push_back({.edges = {edge_of(line)}});
    const bool mirrored = face_.placement.scale_of_volume() < 0.0;
    made.reversed = face_.reversed != mirrored;
    made.place = report_.place(std::nullopt, std::nullopt);
    made.name = made.place.item;
    return made;
  }

  const brep::Model& model_;
  const brep::TrimmedFace& face_;
  SharedEdges& shared_;
  const ImportOptions& options_;
  Report& report_;
  WholeSurface whole_;
  std::vector<Loop> wires_, loops_;
  Loop lines_;
  std::optional<surf::Surface> scratch_, surface_;
  double diagonal_ = 0.0;
};

}  // namespace

Outcome<surf::trim::TrimmedSurface> imported(const brep::Model& model, const brep::TrimmedFace& face,
                                             SharedEdges& shared, const ImportOptions& options, Report& report) {
  return FaceImport(model, face, shared, options, report).run();
}

}  // namespace dobra::io::faces
