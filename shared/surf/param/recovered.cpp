#include "shared/surf/param/recovered.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shared/base/check.h"
#include "shared/surf/param/recover_patches.h"

namespace dobra::surf::param {

using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector;
using geom::Vector3;

namespace {

/// A polynomial with its derivatives.
struct Term {
  Vector3 at, u, v, uu, uv, vv;
};
Term term(const Quadratic& a, Vector d) {
  return {a[0] + d.x * a[1] + d.y * a[2] + (d.x * d.x) * a[3] + (d.x * d.y) * a[4] + (d.y * d.y) * a[5],
          a[1] + (2.0 * d.x) * a[3] + d.y * a[4],
          a[2] + d.x * a[4] + (2.0 * d.y) * a[5],
          2.0 * a[3],
          a[4],
          2.0 * a[5]};
}

}  // namespace

struct Recovered::State {
  std::shared_ptr<const DiscreteChart> chart;
  PatchReport report;
  std::vector<Quadratic> means;  ///< One a vertex, about it: the mean of the patches of its triangles, (10).
  bool meets_border = false;
  BorderPieces pieces;

  [[nodiscard]] Term mean(std::uint32_t vertex, Point uv) const {
    return term(means[vertex], uv - chart->uv()[vertex]);
  }
  /// Where the curve of a side of the border is at a part of its way, with derivatives by that part.
  [[nodiscard]] Curve::Jet border(HalfEdge h, double t) const {
    const Sheet& sheet = chart->sheet();
    if (!pieces.empty() && pieces[h]) {
      const BorderPiece& piece = *pieces[h];
      const double by = piece.to - piece.from;
      const Curve::Jet jet = piece.curve.jet(piece.from + t * by);
      return {jet.at, by * jet.first, (by * by) * jet.second};
    }
    const Point3 from = sheet.points[sheet.start(h)];
    const Vector3 along = sheet.points[sheet.end(h)] - from;
    return {from + t * along, along, {}};
  }
  [[nodiscard]] Jet jet(const Located& place) const;
  void meet(HalfEdge h, const Located& place, const std::array<Vector, 3>& slopes, Jet& jet) const;
};

/// What the means of both ends leave between a side of the border and its curve, faded out towards the third corner:
/// r(t) d^2, with t the part of the way along the side and d the sum of the coordinates of its ends.
void Recovered::State::meet(HalfEdge h, const Located& place, const std::array<Vector, 3>& slopes, Jet& jet) const {
  const std::size_t i = h % 3, j = (i + 1) % 3;
  const double n = place.at[j], d = place.at[i] + n;
  constexpr double none = 1e-12;
  if (!(std::abs(d) > none)) return;
  const double t = n / d;
  const std::uint32_t a = chart->sheet().start(h), b = chart->sheet().end(h);
  const Point from = chart->uv()[a];
  const Vector along = chart->uv()[b] - from;
  const Point p = from + t * along;
  const Curve::Jet curve = border(h, t);
  const auto slope = [&](const Term& m) { return along.x * m.u + along.y * m.v; };
  const auto bend = [&](const Term& m) {
    return (along.x * along.x) * m.uu + (2.0 * along.x * along.y) * m.uv + (along.y * along.y) * m.vv;
  };
  const Term ma = mean(a, p), mb = mean(b, p);
  const Vector3 r = (curve.at - Point3{}) - ((1.0 - t) * ma.at + t * mb.at);
  const Vector3 r1 = curve.first - (mb.at - ma.at + (1.0 - t) * slope(ma) + t * slope(mb));
  const Vector3 r2 = curve.second - (2.0 * (slope(mb) - slope(ma)) + (1.0 - t) * bend(ma) + t * bend(mb));
  const Vector dn = slopes[j], dd = slopes[i] + slopes[j];
  const double qu = dn.x * d - n * dd.x, qv = dn.y * d - n * dd.y, k = dn.x * dd.y - dn.y * dd.x;
  jet.at = jet.at + (d * d) * r;
  jet.u = jet.u + qu * r1 + (2.0 * d * dd.x) * r;
  jet.v = jet.v + qv * r1 + (2.0 * d * dd.y) * r;
  jet.uu = jet.uu + (qu * qu / (d * d)) * r2 + (2.0 * qu * dd.x / d) * r1 + (2.0 * dd.x * dd.x) * r;
  jet.uv = jet.uv + (qu * qv / (d * d)) * r2 + (k + 2.0 * qv * dd.x / d) * r1 + (2.0 * dd.x * dd.y) * r;
  jet.vv = jet.vv + (qv * qv / (d * d)) * r2 + (2.0 * qv * dd.y / d) * r1 + (2.0 * dd.y * dd.y) * r;
}

Jet Recovered::State::jet(const Located& place) const {
  const auto& t = chart->sheet().triangles[place.triangle];
  const auto& uv = chart->uv();
  const Point p = uv[t[0]] + place.at[1] * (uv[t[1]] - uv[t[0]]) + place.at[2] * (uv[t[2]] - uv[t[0]]);
  const std::array<Vector, 3> slopes = chart->slopes(place.triangle);
  Jet jet{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Term m = mean(t[i], p);
    const double c = place.at[i];
    const Vector s = slopes[i];
    jet.at = jet.at + c * m.at;
    jet.u = jet.u + s.x * m.at + c * m.u;
    jet.v = jet.v + s.y * m.at + c * m.v;
    jet.uu = jet.uu + (2.0 * s.x) * m.u + c * m.uu;
    jet.uv = jet.uv + s.x * m.v + s.y * m.u + c * m.uv;
    jet.vv = jet.vv + (2.0 * s.y) * m.v + c * m.vv;
  }
  for (HalfEdge h = 3 * place.triangle; meets_border && h < 3 * place.triangle + 3; ++h) {
    if (chart->sheet().twins[h] == no_half_edge) meet(h, place, slopes, jet);
  }
  if (!place.inside) jet = {jet.at + place.beyond.x * jet.u + place.beyond.y * jet.v, jet.u, jet.v, {}, {}, {}};
  return jet;
}

Recovered::Recovered(std::shared_ptr<const DiscreteChart> chart, const RecoverOptions& options, BorderPieces pieces) {
  DOBRA_CHECK(pieces.empty() || pieces.size() == chart->sheet().twins.size());
  auto state = std::make_shared<State>();
  Patches patches = patches_of(*chart, options);
  const Sheet& sheet = chart->sheet();
  state->means.assign(sheet.points.size(), {});
  std::vector<double> count(sheet.points.size(), 0.0);
  for (std::uint32_t t = 0; t < sheet.triangles.size(); ++t) {
    const std::uint32_t patch = patches.report.patch_of[t];
    for (const std::uint32_t v : sheet.triangles[t]) {
      const Quadratic here = shifted(patches.polynomials[patch], chart->uv()[v] - patches.centres[patch]);
      for (std::size_t k = 0; k < 6; ++k) state->means[v][k] = state->means[v][k] + here[k];
      count[v] += 1.0;
    }
  }
  for (std::size_t v = 0; v < count.size(); ++v) {
    for (Vector3& each : state->means[v]) each = each / count[v];
  }
  state->meets_border = options.meets != Meets::Nothing;
  if (options.meets == Meets::Points) {
    for (std::size_t v = 0; v < count.size(); ++v) state->means[v][0] = sheet.points[v] - Point3{};
  } else if (options.meets == Meets::Border) {
    for (const auto& loop : sheet.loops) {
      for (const std::uint32_t v : loop) state->means[v][0] = sheet.points[v] - Point3{};
    }
  }
  state->chart = std::move(chart);
  state->report = std::move(patches.report);
  state->pieces = std::move(pieces);
  state_ = std::move(state);
}

Jet Recovered::jet(const Located& place) const { return state_->jet(place); }
Jet Recovered::jet(Point uv) const { return state_->jet(state_->chart->locate(uv)); }
const PatchReport& Recovered::patches() const { return state_->report; }
const DiscreteChart& Recovered::chart() const { return *state_->chart; }

Jet Recovered::recovered(const Located& place) const {
  const auto& t = state_->chart->sheet().triangles[place.triangle];
  const auto& uv = state_->chart->uv();
  const Point p = uv[t[0]] + place.at[1] * (uv[t[1]] - uv[t[0]]) + place.at[2] * (uv[t[2]] - uv[t[0]]);
  Jet jet{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Term m = state_->mean(t[i], p);
    const double c = place.at[i];
    jet.at = jet.at + c * m.at;
    jet.u = jet.u + c * m.u;
    jet.v = jet.v + c * m.v;
    jet.uu = jet.uu + c * m.uu;
    jet.uv = jet.uv + c * m.uv;
    jet.vv = jet.vv + c * m.vv;
  }
  return jet;
}

base::Result<Surface> Recovered::surface() const {
  struct Shape : Surface::Shape {
    Recovered of;
    explicit Shape(Recovered recovered) : of(std::move(recovered)) {}
    void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
      std::optional<std::uint32_t> hint;
      for (std::size_t i = 0; i < uv.size(); ++i) {
        const Located place = of.chart().locate(uv[i], hint);
        hint = place.triangle;
        jets[i] = of.jet(place);
      }
    }
    [[nodiscard]] Bend bend(const Box& part) const override {
      constexpr double safe = 1.5, third = 1.0 / 3.0;
      constexpr std::array<std::array<double, 3>, 7> places{
          {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {third, third, third}}};
      Bend most;
      of.chart().for_each_in(part, [&](std::uint32_t t) {
        for (const auto& at : places) {
          const Jet jet = of.jet(Located{t, at, true});
          most = {std::max(most.uu, safe * geom::length(jet.uu)), std::max(most.uv, safe * geom::length(jet.uv)),
                  std::max(most.vv, safe * geom::length(jet.vv))};
        }
      });
      return most;
    }
  };
  return Surface::of(std::make_shared<const Shape>(*this), state_->chart->box());
}

Continuity Recovered::continuity() const {
  const Sheet& sheet = state_->chart->sheet();
  Continuity most;
  for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
    const HalfEdge twin = sheet.twins[h];
    if (twin == no_half_edge || twin < h) continue;
    for (const double part : {0.25, 0.5, 0.75}) {
      const auto on = [&](HalfEdge side, double along) {
        Located place{side / 3, {}, true};
        place.at[side % 3] = 1.0 - along;
        place.at[(side + 1) % 3] = along;
        return place;
      };
      const Located here = on(h, part), there = on(twin, 1.0 - part);
      const Jet a = jet(here), b = jet(there);
      most.value = std::max(most.value, geom::distance(a.at, b.at));
      most.derivative = std::max({most.derivative, geom::length(a.u - b.u), geom::length(a.v - b.v)});
      const Jet c = recovered(here), d = recovered(there);
      most.recovered = std::max({most.recovered, geom::length(c.u - d.u), geom::length(c.v - d.v)});
    }
  }
  return most;
}

double Recovered::border_gap() const {
  const Sheet& sheet = state_->chart->sheet();
  constexpr int places = 8;
  double most = 0.0;
  for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
    if (sheet.twins[h] != no_half_edge) continue;
    for (int i = 0; i <= places; ++i) {
      const double part = static_cast<double>(i) / places;
      Located place{h / 3, {}, true};
      place.at[h % 3] = 1.0 - part;
      place.at[(h + 1) % 3] = part;
      most = std::max(most, geom::distance(jet(place).at, state_->border(h, part).at));
    }
  }
  return most;
}

}  // namespace dobra::surf::param
