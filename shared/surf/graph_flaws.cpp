#include "shared/surf/graph_flaws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <string>

#include "shared/base/formula.h"

namespace dobra::surf {

using geom::Box;
using geom::Point;

namespace {

class Looker {
 public:
  Looker(const std::function<double(double, double)>& height, const Box& chart, const GraphFlawOptions& options)
      : height_(height), chart_(chart), options_(options) {}

  GraphFlaws run() {
    find_range();
    for (const bool along_x : {true, false}) {
      kinks_.clear();
      for (int i = 0; i < options_.lines; ++i) {
        // No line of symmetry, where kinks of both directions would meet.
        const double part = (i + 0.4637) / options_.lines;
        look_along(along_x, along_x ? std::lerp(chart_.low.y, chart_.high.y, part)
                                    : std::lerp(chart_.low.x, chart_.high.x, part));
      }
      sort_kinks(along_x);
    }
    look_round(most_bent());
    return std::move(found_);
  }

  /// Adds what changes along lines on which choices of the formula change over; kinks that were found there by the
  /// numbers are these.
  GraphFlaws add_changes(GraphFlaws found, const base::FormulaJet& formula) {
    found_ = std::move(found);
    find_range();
    const base::FormulaJet::Changes changes =
        formula.changes({chart_.low.x, chart_.high.x}, {chart_.low.y, chart_.high.y});
    for (const bool along_x : {true, false}) {
      const double low = along_x ? chart_.low.x : chart_.low.y, high = along_x ? chart_.high.x : chart_.high.y;
      std::vector<double> lines;
      for (const base::Range& change : along_x ? changes.x : changes.y) {
        constexpr double wide = 1e-9;
        if (change.high - change.low > wide * (high - low)) continue;
        if (is_kink(formula, along_x, change)) lines.push_back(0.5 * (change.low + change.high));
      }
      take_lines(along_x, lines, high - low);
    }
    return std::move(found_);
  }

  /// Goes on with parts in which a flaw may be, looked at through their middles, where none was found near them.
  GraphFlaws go_on(GraphFlaws found, const std::vector<Box>& suspects) {
    found_ = std::move(found);
    find_range();
    for (const Box& part : suspects) {
      const Point m = part.centre();
      const double near = 3.0 * part.diagonal() + 1e-6 * chart_.diagonal();
      if (std::any_of(found_.flaws.begin(), found_.flaws.end(),
                      [&](const GraphFlaw& flaw) { return geom::distance(flaw.at, m) <= near; }))
        continue;
      for (const bool along_x : {true, false}) {
        kinks_.clear();
        const double half = along_x ? part.width() : part.height();
        const double low = along_x ? chart_.low.x : chart_.low.y, high = along_x ? chart_.high.x : chart_.high.y;
        const double at = along_x ? m.x : m.y;
        look_closer({height_, along_x, along_x ? m.y : m.x}, std::max(low, at - half), std::min(high, at + half),
                    high - low);
        for (const Kink& kink : kinks_) add_kink(kink.at);
      }
      kinks_.clear();
      look_round(m, std::max(part.width() / chart_.width(), part.height() / chart_.height()));
    }
    return std::move(found_);
  }

 private:
  /// Whether the slope jumps from one side of a change to the other, as it does a thousand times as far beside it; a
  /// height that jumps is a flaw.
  bool is_kink(const base::FormulaJet& formula, bool along_x, const base::Range& change) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const double low = along_x ? chart_.low.x : chart_.low.y, high = along_x ? chart_.high.x : chart_.high.y;
    const double beside = std::max(4.0 * epsilon * change.size(), 4.0 * epsilon * (high - low));
    if (change.low - beside <= low || change.high + beside >= high) return false;
    const auto jump = [&](double t, double by) {
      const auto at = [&](double s) { return along_x ? formula.at(s, t) : formula.at(t, s); };
      const base::PlaneJet<double> a = at(std::max(low, change.low - by)), b = at(std::min(high, change.high + by));
      return std::array{std::abs(b.value - a.value), along_x ? std::abs(b.x - a.x) : std::abs(b.y - a.y),
                        std::max(std::abs(a.value), std::abs(b.value))};
    };
    for (int i = 0; i < options_.lines; ++i) {
      const double part = (i + 0.4637) / options_.lines;
      const double t =
          along_x ? std::lerp(chart_.low.y, chart_.high.y, part) : std::lerp(chart_.low.x, chart_.high.x, part);
      const auto [height, slope, size] = jump(t, beside);
      if (!std::isfinite(height + slope)) continue;
      if (height > options_.jump * range_ && height > 1e3 * epsilon * size) {
        const double middle = 0.5 * (change.low + change.high);
        add_flaw(GraphFlawKind::Jump, along_x ? Point{middle, t} : Point{t, middle});
        return false;
      }
      if (!(slope > options_.kink)) continue;
      // Nearer and nearer to a place without bound the slope itself grows.
      constexpr double farther = 1e3, alike = 2.0;
      const double far = jump(t, farther * beside)[1];
      if (far > slope / alike && far < slope * alike) return true;
    }
    return false;
  }
  void add_flaw(GraphFlawKind kind, Point at) {
    const double same = 1e-6 * chart_.diagonal();
    if (std::none_of(found_.flaws.begin(), found_.flaws.end(),
                     [&](const GraphFlaw& flaw) { return flaw.kind == kind && geom::distance(flaw.at, at) <= same; }))
      add(kind, at);
  }
  /// @param lines  ascending
  void take_lines(bool along_x, const std::vector<double>& lines, double width) {
    std::vector<double>& kinks = along_x ? found_.kinks_x : found_.kinks_y;
    const double same = 1e-9 * width;
    const auto known = [&](double at) {
      const auto above = std::lower_bound(lines.begin(), lines.end(), at - same);
      return above != lines.end() && *above <= at + same;
    };
    std::erase_if(kinks, known);
    kinks.insert(kinks.end(), lines.begin(), lines.end());
    std::sort(kinks.begin(), kinks.end());
    std::erase_if(found_.flaws, [&](const GraphFlaw& flaw) {
      return flaw.kind == GraphFlawKind::Kink && known(along_x ? flaw.at.x : flaw.at.y);
    });
  }

  /// But where one is known.
  void add_kink(Point at) {
    constexpr double beside = 1e-6;
    const auto on = [&](const std::vector<double>& lines, double c, double range) {
      return std::any_of(lines.begin(), lines.end(), [&](double l) { return std::abs(l - c) <= beside * range; });
    };
    if (on(found_.kinks_x, at.x, chart_.width()) || on(found_.kinks_y, at.y, chart_.height())) return;
    if (std::any_of(found_.flaws.begin(), found_.flaws.end(),
                    [&](const GraphFlaw& flaw) { return geom::distance(flaw.at, at) <= beside * chart_.diagonal(); }))
      return;
    add(GraphFlawKind::Kink, at);
  }

  void find_range() {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    constexpr int places = 64;
    for (int i = 0; i <= places * places; ++i) {
      const double z = height_(std::lerp(chart_.low.x, chart_.high.x, (i / places + 0.31) / (places + 1.0)),
                               std::lerp(chart_.low.y, chart_.high.y, (i % places + 0.57) / (places + 1.0)));
      if (std::isfinite(z)) low = std::min(low, z), high = std::max(high, z);
    }
    range_ = std::max(high - low, 0.0);
  }

  /// The height along a line, by the way along it.
  struct Line {
    const std::function<double(double, double)>& height;
    bool along_x;
    double at;
    [[nodiscard]] Point place(double s) const { return along_x ? Point{s, at} : Point{at, s}; }
    [[nodiscard]] double operator()(double s) const { return along_x ? height(s, at) : height(at, s); }
  };

  void look_along(bool along_x, double at) {
    const Line line{height_, along_x, at};
    const double low = along_x ? chart_.low.x : chart_.low.y, high = along_x ? chart_.high.x : chart_.high.y;
    const int n = options_.places;
    std::vector<double> z;
    for (int i = 0; i <= n; ++i) z.push_back(line(std::lerp(low, high, static_cast<double>(i) / n)));
    std::vector<double> bent(z.size(), 0.0), stands_out(z.size(), 0.0);
    for (std::size_t i = 1; i + 1 < z.size(); ++i) {
      bent[i] = std::abs(z[i - 1] - 2.0 * z[i] + z[i + 1]);
      if (!std::isfinite(bent[i])) bent[i] = std::numeric_limits<double>::max();
    }
    for (std::size_t i = 1; i + 1 < z.size(); ++i) {
      const double beside = (i > 2 ? bent[i - 2] : 0.0) + (i + 3 < z.size() ? bent[i + 2] : 0.0);
      stands_out[i] = bent[i] / (beside + 1e-14 * (range_ + 1e-300));
    }
    const double step = (high - low) / n;
    std::vector<std::size_t> chosen;
    for (std::vector<double>* by : {&bent, &stands_out}) {
      for (int k = 0; k < options_.candidates; ++k) {
        const auto most = static_cast<std::size_t>(std::max_element(by->begin(), by->end()) - by->begin());
        if (!((*by)[most] > 0.0)) break;
        chosen.push_back(most);
        for (std::size_t i = most > 0 ? most - 1 : 0; i <= std::min(most + 1, by->size() - 1); ++i) (*by)[i] = 0.0;
      }
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    for (const std::size_t i : chosen) {
      const double middle = std::lerp(low, high, static_cast<double>(i) / n);
      look_closer(line, std::max(low, middle - step), std::min(high, middle + step), high - low);
    }
  }

  /// The greatest second difference of 16 steps between two places, and where.
  struct Sharpest {
    double difference = 0.0, at = 0.0, step = 0.0, greatest = 0.0;
    bool finite = true;
  };
  static Sharpest sharpest(const Line& line, double from, double to) {
    constexpr int steps = 16;
    std::array<double, steps + 1> z{};
    Sharpest found;
    found.step = (to - from) / steps;
    for (std::size_t i = 0; i <= steps; ++i) {
      const double s = std::lerp(from, to, static_cast<double>(i) / steps);
      z[i] = line(s);
      if (!std::isfinite(z[i])) return {0.0, s, found.step, 0.0, false};
      found.greatest = std::max(found.greatest, std::abs(z[i]));
    }
    for (std::size_t i = 1; i < steps; ++i) {
      const double difference = std::abs(z[i - 1] - 2.0 * z[i] + z[i + 1]);
      if (difference > found.difference)
        found.difference = difference, found.at = std::lerp(from, to, static_cast<double>(i) / steps);
    }
    return found;
  }

  void look_closer(const Line& line, double from, double to, double width) {
    const double low = from, high = to;
    std::vector<Sharpest> levels;
    constexpr double noise = 1e3 * std::numeric_limits<double>::epsilon();
    const double nearest = std::max(1e-11 * width, noise * std::max(std::abs(low), std::abs(high)));
    while (to - from > nearest) {
      const Sharpest next = sharpest(line, from, to);
      if (!next.finite)
        return add(levels.size() > 1 && grows(levels) ? GraphFlawKind::Pole : GraphFlawKind::NoValue,
                   line.place(next.at));
      if (!(next.difference > noise * next.greatest)) break;
      levels.push_back(next);
      from = std::max(low, next.at - next.step), to = std::min(high, next.at + next.step);
    }
    constexpr std::size_t fewest = 5;
    if (levels.size() < fewest) return;
    judge(line, line.place(levels.back().at), levels, width);
  }
  static bool grows(const std::vector<Sharpest>& levels) {
    return levels.back().difference > levels.front().difference;
  }

  /// Of a net of places, where the second differences along x and along y are greatest.
  [[nodiscard]] Point most_bent() const {
    constexpr int places = 96;
    const double dx = chart_.width() / places, dy = chart_.height() / places;
    Point most = chart_.centre();
    double greatest = -1.0;
    for (int i = 1; i < places; ++i) {
      for (int j = 1; j < places; ++j) {
        const Point p{chart_.low.x + i * dx, chart_.low.y + j * dy};
        const double bent = bent_at(p, dx, dy);
        if (bent > greatest) greatest = bent, most = p;
      }
    }
    return most;
  }
  [[nodiscard]] double bent_at(Point p, double dx, double dy) const {
    const double twice = 2.0 * height_(p.x, p.y);
    return std::abs(height_(p.x - dx, p.y) - twice + height_(p.x + dx, p.y)) +
           std::abs(height_(p.x, p.y - dy) - twice + height_(p.x, p.y + dy));
  }
  /// Closer and closer to a place that no line may pass, as the point of a cone.
  void look_round(Point middle, double start = 1.0 / 64.0) {
    constexpr int half = 4;
    constexpr double noise = 1e3 * std::numeric_limits<double>::epsilon(), closer = 1.0 / half;
    std::vector<Sharpest> levels;
    for (double part = start; part > 1e-10; part *= closer) {
      const double dx = part * chart_.width() / half, dy = part * chart_.height() / half;
      const Point before = middle;
      Sharpest here{0.0, 0.0, dx, std::abs(height_(middle.x, middle.y)), true};
      for (int i = -half; i <= half; ++i) {
        for (int j = -half; j <= half; ++j) {
          const Point p = before + geom::Vector{i * dx, j * dy};
          if (p.x - dx < chart_.low.x || p.x + dx > chart_.high.x || p.y - dy < chart_.low.y ||
              p.y + dy > chart_.high.y)
            continue;
          const double bent = bent_at(p, dx, dy);
          if (!(bent > here.difference)) continue;
          here.difference = bent, middle = p;
        }
      }
      if (!std::isfinite(here.difference) || !(here.difference > noise * here.greatest)) break;
      levels.push_back(here);
    }
    constexpr std::size_t fewest = 5;
    if (levels.size() < fewest) return;
    const std::size_t kinks = kinks_.size();
    judge({height_, true, middle.y}, middle, levels, chart_.width());
    if (kinks_.size() == kinks) return;
    add_kink(middle);
  }

  void judge(const Line& line, Point at, const std::vector<Sharpest>& levels, double width) {
    const Sharpest &last = levels.back(), &before = levels[levels.size() - 4];
    const double power = std::log(before.difference / last.difference) / std::log(before.step / last.step);
    const double slope = last.difference / last.step, bend = slope / last.step;
    constexpr double smooth = 1.7, kink_most = 1.25, kink_least = 0.75, jump_most = 0.12;
    constexpr double steep = 1.0, curved = 1e3;
    if (power > smooth) return;
    if (power > kink_most) {
      if (bend * width > curved) add(GraphFlawKind::Steep, at);
    } else if (power > kink_least) {
      if (slope > options_.kink) kinks_.push_back({at, line.along_x ? at.x : at.y});
    } else if (power > jump_most) {
      if (slope > steep) add(GraphFlawKind::Steep, at);
    } else if (power > -jump_most) {
      if (last.difference > options_.jump * range_) add(GraphFlawKind::Jump, at);
    } else {
      add(GraphFlawKind::Pole, at);
    }
  }

  void add(GraphFlawKind kind, Point at) { found_.flaws.push_back({kind, at}); }

  struct Kink {
    Point at;
    double along;
  };
  /// Kinks at one place of three lines and more run across them.
  void sort_kinks(bool along_x) {
    std::sort(kinks_.begin(), kinks_.end(), [](const Kink& a, const Kink& b) { return a.along < b.along; });
    const double same = 1e-9 * (along_x ? chart_.width() : chart_.height());
    for (std::size_t i = 0; i < kinks_.size();) {
      std::size_t end = i + 1;
      while (end < kinks_.size() && kinks_[end].along - kinks_[i].along <= same) ++end;
      constexpr std::size_t fewest = 3;
      if (end - i >= fewest) {
        (along_x ? found_.kinks_x : found_.kinks_y).push_back(kinks_[i + (end - i) / 2].along);
      } else {
        add(GraphFlawKind::Kink, kinks_[i].at);
      }
      i = end;
    }
  }

  const std::function<double(double, double)>& height_;
  const Box& chart_;
  const GraphFlawOptions& options_;
  double range_ = 0.0;
  std::vector<Kink> kinks_;  ///< Of lines in one direction.
  GraphFlaws found_;
};

double size_of(double low, double high) { return std::max(std::abs(low), std::abs(high)); }

/// Whether a formula may have a kink or a jump over a part of the chart, or derivatives without bound, but on known
/// lines.
bool is_suspect(const base::FormulaJet& formula, const Box& part, const Box& chart, const GraphFlaws& known) {
  const auto ys = between_lines({part.low.y, part.high.y}, known.kinks_y, size_of(chart.low.y, chart.high.y));
  for (const base::Range& x :
       between_lines({part.low.x, part.high.x}, known.kinks_x, size_of(chart.low.x, chart.high.x))) {
    for (const base::Range& y : ys) {
      const base::FormulaJet::Bounds bounds = formula.over(x, y);
      const base::PlaneJet<base::Range>& z = bounds.of;
      if (bounds.kink || !std::isfinite(z.value.size() + z.xx.size() + z.xy.size() + z.yy.size())) return true;
    }
  }
  return false;
}

/// Small parts of a chart over which a formula may have a kink or a jump, or its derivatives have no bound, but for
/// kinks along lines that are known.
std::vector<Box> suspects_in(const base::FormulaJet& formula, const Box& chart, const GraphFlaws& known) {
  constexpr std::size_t most_looks = 4000, most = 32;
  constexpr double finest = 1e-5;  // of the chart
  std::deque<Box> next{chart};     // the coarsest first
  std::vector<Box> found;
  for (std::size_t looks = 0; !next.empty(); ++looks) {
    const Box part = next.front();
    next.pop_front();
    if (!is_suspect(formula, part, chart, known)) continue;
    if (part.width() <= finest * chart.width() || looks + next.size() > most_looks) {
      found.push_back(part);
      continue;
    }
    const Point m = part.centre();
    for (const Box& quarter : {Box{part.low, m}, Box{{m.x, part.low.y}, {part.high.x, m.y}},
                               Box{{part.low.x, m.y}, {m.x, part.high.y}}, Box{m, part.high}})
      next.push_back(quarter);
  }
  std::vector<Box> kept;
  const std::size_t step = found.size() / most + 1;
  for (std::size_t i = 0; i < found.size(); i += step) kept.push_back(found[i]);
  return kept;
}

}  // namespace

double hair_beside(double gap, double size) {
  constexpr double part = 1e-10, digits = 8.0 * std::numeric_limits<double>::epsilon();
  return std::min(0.25 * gap, std::max(part * gap, digits * size));
}

std::vector<base::Range> between_lines(base::Range range, const std::vector<double>& lines, double size) {
  std::vector<base::Range> parts;
  double low = range.low, before = -std::numeric_limits<double>::infinity();
  const auto add = [&](double high) {
    if (low < high) parts.push_back({low, high});
  };
  const auto from = std::lower_bound(lines.begin(), lines.end(), range.low - hair_beside(range.high - range.low, size));
  for (auto line = from; line != lines.end(); ++line) {
    const double gap = std::min(
        {*line - before, line + 1 == lines.end() ? range.high - range.low : line[1] - *line, range.high - range.low});
    const double hair = hair_beside(gap, size);
    if (*line - hair > range.high) break;
    add(*line - hair);
    low = std::max(low, *line + hair);
    before = *line;
  }
  add(range.high);
  if (parts.empty()) parts.push_back(range);
  return parts;
}

GraphFlaws graph_flaws(const std::function<double(double, double)>& height, const Box& chart,
                       const GraphFlawOptions& options) {
  return Looker(height, chart, options).run();
}

GraphFlaws graph_flaws(const std::function<double(double, double)>& height, const base::FormulaJet& formula,
                       const Box& chart, const GraphFlawOptions& options) {
  return Looker(height, chart, options).add_changes(graph_flaws(height, chart, options), formula);
}

base::Result<GraphFlaws> graph_flaws(const std::string& formula, const Box& chart, const GraphFlawOptions& options) {
  const std::array<std::string, 2> names{"x", "y"};
  DOBRA_TRY(const base::Formula height, base::Formula::make(formula, names));
  DOBRA_TRY(const base::FormulaJet jets, base::FormulaJet::make(formula, names));
  const std::function<double(double, double)> z = [&](double x, double y) { return height.at(std::array{x, y}); };
  GraphFlaws found = graph_flaws(z, jets, chart, options);
  const std::vector<Box> suspects = suspects_in(jets, chart, found);
  return suspects.empty() ? found : Looker(z, chart, options).go_on(std::move(found), suspects);
}

}  // namespace dobra::surf
