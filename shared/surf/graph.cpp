// Graphs of formulas.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "shared/base/formula.h"
#include "shared/base/formula_jet.h"
#include "shared/surf/graph_flaws.h"
#include "shared/surf/surface.h"

namespace dobra::surf {

using base::Error;
using base::ErrorCode;
using geom::Box;
using geom::Point;

namespace {

struct GraphShape : Surface::Shape {
  base::Formula formula;
  base::FormulaJet exact;
  Box chart;
  double step = 2e-3;  ///< The step of the differences, part of the chart.
  GraphShape(base::Formula height, base::FormulaJet jets, const Box& where)
      : formula(std::move(height)), exact(std::move(jets)), chart(where) {}

  std::vector<double> breaks_x, breaks_y;  ///< Kinks along lines, with the ends of the chart.

  [[nodiscard]] double height(double x, double y) const { return formula.at(std::array{x, y}); }

  /// The range between two breaks in which a place lies, and the step of its differences.
  struct Range {
    double low, high, h;
  };
  static Range range_at(double at, const std::vector<double>& breaks, double step) {
    const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, at);
    constexpr double stencil_steps = 8.0;
    return {*(above - 1), *above, std::min(step, (*above - *(above - 1)) / stencil_steps)};
  }
  [[nodiscard]] Range range_x(double x, double by) const { return range_at(x, breaks_x, by * chart.width()); }
  [[nodiscard]] Range range_y(double y, double by) const { return range_at(y, breaks_y, by * chart.height()); }
  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    for (std::size_t i = 0; i < uv.size(); ++i) jets[i] = jet(uv[i]);
  }

  /// Values at nine places of a line, -4 .. 4 steps from where the derivatives are wanted, or to one side of it where
  /// the formula ends.
  struct Stencil {
    std::array<double, 9> first{}, second{};
  };
  /// Weights at step `from` .. `from` + 8, by Fornberg's recurrence [fornberg1988].
  static Stencil stencil(int from) {
    std::array<std::array<double, 3>, 9> c{};
    double c1 = 1.0;
    double c4 = from;
    c[0][0] = 1.0;
    for (int i = 1; i < 9; ++i) {
      const int most = std::min(i, 2);
      double c2 = 1.0;
      const double c5 = c4;
      c4 = from + i;
      for (int j = 0; j < i; ++j) {
        const double c3 = i - j;
        c2 *= c3;
        if (j == i - 1) {
          for (int k = most; k > 0; --k) c[i][k] = c1 * (k * c[i - 1][k - 1] - c5 * c[i - 1][k]) / c2;
          c[i][0] = -c1 * c5 * c[i - 1][0] / c2;
        }
        for (int k = most; k > 0; --k) c[j][k] = (c4 * c[j][k] - k * c[j][k - 1]) / c3;
        c[j][0] = c4 * c[j][0] / c3;
      }
      c1 = c2;
    }
    Stencil made;
    for (std::size_t i = 0; i < 9; ++i) made.first[i] = c[i][1], made.second[i] = c[i][2];
    return made;
  }

  /// The stencil whose places lie within the range, from which step on.
  static std::pair<const Stencil&, int> stencil_at(double at, const Range& range) {
    const auto [low, high, h] = range;
    static const std::array<Stencil, 9> stencils = [] {
      std::array<Stencil, 9> made;
      for (int from = -8; from <= 0; ++from) made[static_cast<std::size_t>(from + 8)] = stencil(from);
      return made;
    }();
    int from = -4;
    if (at - 4.0 * h < low) from = -static_cast<int>(std::floor((at - low) / h + 1e-9));
    if (at + 4.0 * h > high) from = static_cast<int>(std::floor((high - at) / h + 1e-9)) - 8;
    from = std::clamp(from, -8, 0);
    return {stencils[static_cast<std::size_t>(from + 8)], from};
  }

  /// Second derivatives by a step, by the chart's width and height: (zxx, zyy).
  [[nodiscard]] std::array<double, 2> second_by(Point uv, double by) const {
    const Range in_x = range_x(uv.x, by), in_y = range_y(uv.y, by);
    const double hx = in_x.h, hy = in_y.h;
    const auto [across, left] = stencil_at(uv.x, in_x);
    const auto [up, below] = stencil_at(uv.y, in_y);
    double zxx = 0.0, zyy = 0.0;
    for (int i = 0; i < 9; ++i) {
      zxx += across.second[static_cast<std::size_t>(i)] * height(uv.x + (left + i) * hx, uv.y);
      zyy += up.second[static_cast<std::size_t>(i)] * height(uv.x, uv.y + (below + i) * hy);
    }
    const double by_x = hx / chart.width(), by_y = hy / chart.height();
    return {zxx / (by_x * by_x), zyy / (by_y * by_y)};
  }
  /// Takes the step whose second derivatives are nearest to those of half of it, over the chart: a long one leaves
  /// terms out, a short one is all rounding.
  void choose_step() {
    constexpr int places = 13;
    double least = std::numeric_limits<double>::infinity(), best = step;
    for (double by = step; by > 2e-5; by *= 0.5) {
      double apart = 0.0;
      for (int i = 0; i < places * places; ++i) {
        const Point at{geom::interpolate(chart.low, chart.high, (i / places + 0.37) / places).x,
                       geom::interpolate(chart.low, chart.high, (i % places + 0.43) / places).y};
        const std::array<double, 2> whole = second_by(at, by), half = second_by(at, 0.5 * by);
        apart = std::max({apart, std::abs(whole[0] - half[0]), std::abs(whole[1] - half[1])});
      }
      if (apart < 0.7 * least) least = apart, best = by;
    }
    step = best;
  }

  /// Whether a part of the formula lacks derivatives at one of 33 x 33 places.
  [[nodiscard]] bool needs_differences() const {
    constexpr int parts = 32;
    for (int i = 0; i <= parts; ++i) {
      for (int j = 0; j <= parts; ++j) {
        const base::PlaneJet<double> z = of_formula({std::lerp(chart.low.x, chart.high.x, i / double{parts}),
                                                     std::lerp(chart.low.y, chart.high.y, j / double{parts})});
        if (!is_finite(z)) return true;
      }
    }
    return false;
  }

  /// The mixed derivative by a net of 9 x 9 places, by steps.
  [[nodiscard]] double mixed(Point uv, const Range& in_x, const Range& in_y) const {
    const auto [across, left] = stencil_at(uv.x, in_x);
    const auto [up, below] = stencil_at(uv.y, in_y);
    double zxy = 0.0;
    for (std::size_t i = 0; i < 9; ++i) {
      for (std::size_t j = 0; j < 9; ++j)
        zxy += across.first[i] * up.first[j] *
               height(uv.x + (left + static_cast<int>(i)) * in_x.h, uv.y + (below + static_cast<int>(j)) * in_y.h);
    }
    return zxy;
  }

  static bool is_finite(const base::PlaneJet<double>& z) {
    return std::isfinite(z.x + z.y) && std::isfinite(z.xx + z.xy + z.yy);
  }
  /// A hair inside the range, where the place lies at one of its ends: derivatives are those of the side.
  static double inside(double at, const std::vector<double>& breaks) {
    const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, at);
    const double low = *(above - 1), high = *above;
    const double hair = hair_beside(high - low, std::max(std::abs(breaks.front()), std::abs(breaks.back())));
    if (std::abs(at - low) < hair) return low + hair;
    return std::abs(at - high) < hair ? high - hair : at;
  }
  /// Of the formula; not finite where one of its parts has no derivative.
  [[nodiscard]] base::PlaneJet<double> of_formula(Point uv) const {
    if (breaks_x.empty()) return exact.at(uv.x, uv.y);
    const Point at{inside(uv.x, breaks_x), inside(uv.y, breaks_y)};
    base::PlaneJet<double> z = exact.at(at.x, at.y);
    if (at != uv) z.value = height(uv.x, uv.y);
    return z;
  }
  [[nodiscard]] Jet jet(Point uv) const {
    const base::PlaneJet<double> z = of_formula(uv);
    if (!is_finite(z) && std::isfinite(z.value)) return by_differences(uv);
    return {{uv.x, uv.y, z.value}, {1.0, 0.0, z.x},  {0.0, 1.0, z.y},
            {0.0, 0.0, z.xx},      {0.0, 0.0, z.xy}, {0.0, 0.0, z.yy}};
  }
  [[nodiscard]] Jet by_differences(Point uv) const {
    const Range in_x = range_x(uv.x, step), in_y = range_y(uv.y, step);
    const double hx = in_x.h, hy = in_y.h;
    const auto [across, left] = stencil_at(uv.x, in_x);
    const auto [up, below] = stencil_at(uv.y, in_y);
    double zx = 0.0, zxx = 0.0, zy = 0.0, zyy = 0.0, zxy = 0.0, diagonal = 0.0;
    for (std::size_t i = 0; i < 9; ++i) {
      const double z = height(uv.x + (left + static_cast<int>(i)) * hx, uv.y);
      zx += across.first[i] * z;
      zxx += across.second[i] * z;
      const double w = height(uv.x, uv.y + (below + static_cast<int>(i)) * hy);
      zy += up.first[i] * w;
      zyy += up.second[i] * w;
      const int k = left + static_cast<int>(i);
      if (left == below) diagonal += across.second[i] * height(uv.x + k * hx, uv.y + k * hy);
    }
    // Along the diagonal the second derivative is zxx + 2 zxy + zyy, by steps.
    zxy = left == below ? 0.5 * (diagonal - zxx - zyy) : mixed(uv, in_x, in_y);
    return {{uv.x, uv.y, height(uv.x, uv.y)}, {1.0, 0.0, zx / hx},         {0.0, 1.0, zy / hy},
            {0.0, 0.0, zxx / (hx * hx)},      {0.0, 0.0, zxy / (hx * hy)}, {0.0, 0.0, zyy / (hy * hy)}};
  }

  /// Of the second derivatives at places `gaps` x `gaps` and then of blocks of 2 x 2, 4 x 4 ... of them the greatest.
  static constexpr int gaps = 256;
  mutable std::vector<std::vector<Bend>> levels;
  mutable std::once_flag looked;
  void look_at_bends() const {
    const double hx = chart.width() / gaps, hy = chart.height() / gaps;
    std::vector<double> z;
    for (int i = 0; i <= gaps; ++i) {
      for (int j = 0; j <= gaps; ++j)
        z.push_back(height(std::lerp(chart.low.x, chart.high.x, static_cast<double>(i) / gaps),
                           std::lerp(chart.low.y, chart.high.y, static_cast<double>(j) / gaps)));
    }
    const auto at = [&](int i, int j) { return z[static_cast<std::size_t>(i * (gaps + 1) + j)]; };
    std::vector<Bend> cells(gaps * gaps);
    constexpr double safe = 1.5;
    const std::vector<std::uint8_t> broken_x = with_breaks(breaks_x), broken_y = with_breaks(breaks_y);
    for (int i = 1; i < gaps; ++i) {
      for (int j = 1; j < gaps; ++j) {
        // Across a kink there is no second derivative.
        const double smooth_x = broken_x[static_cast<std::size_t>(i)] != 0 ? 0.0 : 1.0;
        const double smooth_y = broken_y[static_cast<std::size_t>(j)] != 0 ? 0.0 : 1.0;
        const Bend here{smooth_x * safe * std::abs(at(i - 1, j) - 2.0 * at(i, j) + at(i + 1, j)) / (hx * hx),
                        safe * std::abs(at(i + 1, j + 1) - at(i - 1, j + 1) - at(i + 1, j - 1) + at(i - 1, j - 1)) /
                            (4.0 * hx * hy),
                        smooth_y * safe * std::abs(at(i, j - 1) - 2.0 * at(i, j) + at(i, j + 1)) / (hy * hy)};
        // A cell knows what its neighbours know: the border's have no second difference of their own.
        for (int k = std::max(0, i - 2); k <= std::min(gaps - 1, i + 1); ++k) {
          for (int l = std::max(0, j - 2); l <= std::min(gaps - 1, j + 1); ++l)
            take(cells[static_cast<std::size_t>(k * gaps + l)], here);
        }
      }
    }
    levels.push_back(std::move(cells));
    for (int n = gaps / 2; n > 0; n /= 2) {
      std::vector<Bend> coarse(static_cast<std::size_t>(n * n));
      for (int i = 0; i < 2 * n; ++i) {
        for (int j = 0; j < 2 * n; ++j)
          take(coarse[static_cast<std::size_t>((i / 2) * n + j / 2)],
               levels.back()[static_cast<std::size_t>(i * 2 * n + j)]);
      }
      levels.push_back(std::move(coarse));
    }
  }
  /// Of the places between the gaps: whether a break lies between their neighbours.
  static std::vector<std::uint8_t> with_breaks(const std::vector<double>& breaks) {
    std::vector<std::uint8_t> broken(gaps + 1, 0);
    for (std::size_t b = 1; b + 1 < breaks.size(); ++b) {
      for (int i = 1; i < gaps; ++i) {
        const auto place = [&](int k) {
          return std::lerp(breaks.front(), breaks.back(), static_cast<double>(k) / gaps);
        };
        if (place(i - 1) < breaks[b] && breaks[b] < place(i + 1)) broken[static_cast<std::size_t>(i)] = 1;
      }
    }
    return broken;
  }
  static void take(Bend& most, const Bend& other) {
    most = {std::max(most.uu, other.uu), std::max(most.uv, other.uv), std::max(most.vv, other.vv)};
  }
  /// The parts between kinks along lines, where none of these is met.
  [[nodiscard]] std::vector<base::Range> ranges(double low, double high, const std::vector<double>& breaks) const {
    if (breaks.size() <= 2) return {{low, high}};
    return between_lines({low, high}, {breaks.begin() + 1, breaks.end() - 1},
                         std::max(std::abs(breaks.front()), std::abs(breaks.back())));
  }
  /// Of the second derivatives over a part of the chart, but on kinks along lines.
  [[nodiscard]] Bend bounds(const Box& part) const {
    Bend most;
    const auto ys = ranges(part.low.y, part.high.y, breaks_y);
    for (const base::Range& x : ranges(part.low.x, part.high.x, breaks_x)) {
      for (const base::Range& y : ys) {
        const base::PlaneJet<base::Range> z = exact.over(x, y).of;
        take(most, {z.xx.size(), z.xy.size(), z.yy.size()});
      }
    }
    return most;
  }
  [[nodiscard]] bool seen(const Box& part) const override {
    constexpr double least = 5e-3, more = 2.0;
    const Bend bend = bounds(part);
    const double w = part.width(), h = part.height();
    const double by_x = bend.uu * w + bend.uv * h, by_y = bend.uv * w + bend.vv * h;
    if (by_x <= least && by_y <= least) return true;
    if (!std::isfinite(by_x + by_y)) return false;
    // A narrow peak may be met by one place, or a ridge by a row of them: the mean counts too.
    double most_x = 0.0, most_y = 0.0, sum_x = 0.0, sum_y = 0.0;
    for (int i = 0; i < 9; ++i) {
      const base::PlaneJet<double> at = of_formula(
          {std::lerp(part.low.x, part.high.x, 0.5 * (i / 3)), std::lerp(part.low.y, part.high.y, 0.5 * (i % 3))});
      if (!is_finite(at)) continue;
      const double here_x = std::abs(at.xx) * w + std::abs(at.xy) * h;
      const double here_y = std::abs(at.xy) * w + std::abs(at.yy) * h;
      most_x = std::max(most_x, here_x), most_y = std::max(most_y, here_y);
      sum_x += here_x, sum_y += here_y;
    }
    constexpr double more_than_mean = 2.5 / 9.0;
    return by_x <= std::min(more * most_x, more_than_mean * sum_x) + least &&
           by_y <= std::min(more * most_y, more_than_mean * sum_y) + least;
  }
  [[nodiscard]] Bend bend(const Box& part) const override {
    Bend most;
    const Point m = part.centre();
    for (const Box& quarter : {Box{part.low, m}, Box{{m.x, part.low.y}, {part.high.x, m.y}},
                               Box{{part.low.x, m.y}, {m.x, part.high.y}}, Box{m, part.high}}) {
      take(most, bounds(quarter));
    }
    if (std::isfinite(most.uu + most.uv + most.vv)) return most;
    std::call_once(looked, [&] { look_at_bends(); });
    return by_table(part);
  }
  [[nodiscard]] Bend by_table(const Box& part) const {
    const double across = std::max(part.width() / chart.width(), part.height() / chart.height());
    std::size_t level = 0;
    while (level + 1 < levels.size() && across * gaps > static_cast<double>(std::size_t{1} << level)) ++level;
    const int n = gaps >> level;
    const auto cell = [n](double at, double low, double high) {
      return std::clamp(static_cast<int>((at - low) / (high - low) * n), 0, n - 1);
    };
    Bend most;
    for (int i = cell(part.low.x, chart.low.x, chart.high.x); i <= cell(part.high.x, chart.low.x, chart.high.x); ++i) {
      for (int j = cell(part.low.y, chart.low.y, chart.high.y); j <= cell(part.high.y, chart.low.y, chart.high.y); ++j)
        take(most, levels[level][static_cast<std::size_t>(i * n + j)]);
    }
    return most;
  }
};

}  // namespace

base::Result<Surface> Surface::graph(const std::string& formula, const Box& chart) {
  const std::array<std::string, 2> names{"x", "y"};
  DOBRA_TRY(base::Formula height, base::Formula::make(formula, names));
  DOBRA_TRY(base::FormulaJet exact, base::FormulaJet::make(formula, names));
  const auto shape = std::make_shared<GraphShape>(std::move(height), std::move(exact), chart);
  constexpr int parts = 32;
  for (int i = 0; i <= parts; ++i) {
    for (int j = 0; j <= parts; ++j) {
      const Point at = {geom::interpolate(chart.low, chart.high, i / static_cast<double>(parts)).x,
                        geom::interpolate(chart.low, chart.high, j / static_cast<double>(parts)).y};
      if (geom::is_finite(at) && !std::isfinite(shape->height(at.x, at.y)))
        return Error{ErrorCode::OutsideDomain,
                     fmt::format("the formula '{}' has no value at x = {}, y = {}", formula, at.x, at.y),
                     base::Place{.item = "graph", .x = at.x, .y = at.y}};
    }
  }
  Breaks kinks;
  if (geom::is_finite(chart.low) && geom::is_finite(chart.high) && !chart.empty()) {
    const auto z = [&](double x, double y) { return shape->height(x, y); };
    const GraphFlaws flaws = graph_flaws(z, shape->exact, chart);
    kinks = {flaws.kinks_x, flaws.kinks_y};
    const auto with_ends = [](std::vector<double> inside, double low, double high) {
      inside.insert(inside.begin(), low);
      inside.push_back(high);
      return inside;
    };
    shape->breaks_x = with_ends(kinks.u, chart.low.x, chart.high.x);
    shape->breaks_y = with_ends(kinks.v, chart.low.y, chart.high.y);
    if (shape->needs_differences()) shape->choose_step();
  }
  return make(shape, chart, std::move(kinks));
}

}  // namespace dobra::surf
