#include "shared/surf/trim/arcs.h"

#include <algorithm>
#include <cmath>

#include "shared/geom/segment.h"
#include "shared/surf/trim/meetings.h"

namespace dobra::surf::trim {

using geom::Box;
using geom::Point;
using geom::Vector;

Arcs::At Arcs::on(std::size_t strand, double part) const {
  const ChartEdge& edge = strands[strand].edge;
  const double range = edge.to - edge.from;
  const Curve::Jet jet = edge.curve.jet(std::lerp(edge.from, edge.to, part));
  const double w = chart.width(), h = chart.height();
  return {this->part({jet.at.x, jet.at.y}),
          {range * jet.first.x / w, range * jet.first.y / h},
          {range * range * jet.second.x / w, range * range * jet.second.y / h}};
}

double Arcs::bend(std::size_t strand, double from, double to) const {
  const ChartEdge& edge = strands[strand].edge;
  const double a = std::lerp(edge.from, edge.to, from), b = std::lerp(edge.from, edge.to, to);
  const double range = edge.to - edge.from, w = chart.width(), h = chart.height();
  constexpr double uneven = 16.0;
  if (std::max(w, h) < uneven * std::min(w, h))
    return edge.curve.bend(std::min(a, b), std::max(a, b)) * range * range / std::min(w, h);
  double most = 0.0;  // the units of the chart are of other kinds: what is seen at nine places, twice
  for (int i = 0; i <= 8; ++i) most = std::max(most, length(on(strand, std::lerp(from, to, i / 8.0)).second));
  return 2.0 * most;
}

std::size_t Arcs::vertex(Point p, double same) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (geom::distance(vertices[i], p) <= same) return i;
  }
  vertices.push_back(p);
  return vertices.size() - 1;
}

std::vector<double> smooth_parts_of(const Arcs& arcs, std::size_t strand, double from, double to) {
  const ChartEdge& edge = arcs.strands[strand].edge;
  std::vector<double> parts{from};
  std::vector<double> breaks;
  for (const double t : edge.curve.breaks()) breaks.push_back((t - edge.from) / (edge.to - edge.from));
  std::sort(breaks.begin(), breaks.end());
  for (const double at : breaks) {
    if (at > parts.back() + 1e-12 && at < to - 1e-12) parts.push_back(at);
  }
  parts.push_back(to);
  return parts;
}

namespace {

struct Sample {
  double part = 0.0;
  Point at;
};

class Cutter {
 public:
  Cutter(const Surface& surface, Arcs& arcs, const Cutting& options)
      : surface_(surface), arcs_(arcs), same_(options.same), cuts_(arcs.strands.size()), samples_(arcs.strands.size()) {
    for (std::size_t s = 0; s < arcs_.strands.size(); ++s) {
      cuts_[s] = {{0.0, arcs_.strands[s].start}, {1.0, arcs_.strands[s].end}};
      take_samples(s);
    }
  }

  base::Result<std::vector<Meeting>> run(const std::map<SharedCurveId, std::vector<double>>& cuts) {
    add_given(cuts);
    cut_at_breaks();
    cut_at_vertices(0);
    make_arcs();
    merge();
    DOBRA_TRY(const std::vector<Crossing> found, crossings(surface_, arcs_, same_));
    std::vector<Meeting> meetings;
    const std::size_t known = arcs_.vertices.size();
    for (const Crossing& each : found) {
      const std::size_t vertex = arcs_.vertex(each.at, same_);
      add_cut(each.strand_a, each.part_a, vertex);
      add_cut(each.strand_b, each.part_b, vertex);
      meetings.push_back({arcs_.strands[each.strand_a].line, arcs_.strands[each.strand_b].line, arcs_.uv(each.at)});
    }
    cut_at_vertices(known);
    mirror();
    make_arcs();
    merge();
    return meetings;
  }

 private:
  void take_samples(std::size_t s) {
    const std::vector<double> parts = smooth_parts_of(arcs_, s, 0.0, 1.0);
    constexpr int count = 24;
    for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
      for (int i = k == 0 ? 0 : 1; i <= count; ++i) {
        const double part = std::lerp(parts[k], parts[k + 1], static_cast<double>(i) / count);
        samples_[s].push_back({part, arcs_.on(s, part).at});
      }
    }
  }

  /// The nearest place of a strand between two parts of it, by the samples near which it is.
  [[nodiscard]] Sample nearest(std::size_t s, Point p, double from, double to) const {
    Sample best{from, arcs_.on(s, from).at};
    double least = geom::distance(best.at, p);
    const auto try_from = [&](double part) {
      for (int round = 0; round < 12; ++round) {
        const Arcs::At c = arcs_.on(s, part);
        const double speed = length_squared(c.first);
        if (!(speed > 0.0)) break;
        const double next = std::clamp(part - dot(c.at - p, c.first) / speed, from, to);
        if (std::abs(next - part) < 1e-16) break;
        part = next;
      }
      const Point at = arcs_.on(s, part).at;
      if (geom::distance(at, p) < least) least = geom::distance(at, p), best = {part, at};
    };
    try_from(to);
    for (std::size_t i = 1; i < samples_[s].size(); ++i) {
      const Sample &a = samples_[s][i - 1], &b = samples_[s][i];
      if (b.part <= from || a.part >= to) continue;
      const geom::Segment segment{a.at, b.at};
      if (geom::distance(segment, p) > 0.2 * segment.length() + same_) continue;
      try_from(std::clamp(std::lerp(a.part, b.part, nearest_fraction(segment, p)), from, to));
    }
    return best;
  }

  void add_cut(std::size_t s, double part, std::size_t vertex) { cuts_[s].emplace_back(part, vertex); }

  void add_given(const std::map<SharedCurveId, std::vector<double>>& cuts) {
    for (std::size_t s = 0; s < arcs_.strands.size(); ++s) {
      const ChartEdge& edge = arcs_.strands[s].edge;
      if (!edge.shared || !cuts.contains(*edge.shared)) continue;
      for (const double t : cuts.at(*edge.shared)) {
        const double part = (t - edge.from) / (edge.to - edge.from);
        if (part > 1e-9 && part < 1.0 - 1e-9) add_cut(s, part, arcs_.vertex(arcs_.on(s, part).at, same_));
      }
    }
  }

  /// Where pieces of a strand meet on another strand: from there on it may run along that one.
  void cut_at_breaks() {
    std::vector<Box> boxes;
    for (const std::vector<Sample>& samples : samples_) {
      Box box;
      for (const Sample& sample : samples) box.add(sample.at);
      boxes.push_back(box.grown(0.1 * box.diagonal() + same_));
    }
    for (std::size_t s = 0; s < arcs_.strands.size(); ++s) {
      const std::vector<double> parts = smooth_parts_of(arcs_, s, 0.0, 1.0);
      for (std::size_t k = 1; k + 1 < parts.size(); ++k) {
        const Point p = arcs_.on(s, parts[k]).at;
        bool on_another = false;
        for (std::size_t t = 0; t < arcs_.strands.size() && !on_another; ++t)
          on_another = t != s && boxes[t].contains(p) && geom::distance(nearest(t, p, 0.0, 1.0).at, p) <= same_;
        if (on_another) add_cut(s, parts[k], arcs_.vertex(p, same_));
      }
    }
  }

  /// Cuts each strand at vertices, from number `first` on, that lie on it.
  void cut_at_vertices(std::size_t first) {
    for (std::size_t s = 0; s < arcs_.strands.size(); ++s) {
      Box box;
      for (const Sample& sample : samples_[s]) box.add(sample.at);
      box = box.grown(0.1 * box.diagonal() + same_);
      for (std::size_t v = first; v < arcs_.vertices.size(); ++v) {
        const Point p = arcs_.vertices[v];
        if (!box.contains(p)) continue;
        const auto is_v = [v](const auto& c) { return c.second == v; };
        const bool known = std::any_of(cuts_[s].begin(), cuts_[s].end(), is_v);
        // A line may pass its own end.
        constexpr double beyond = 0.02;
        const bool of_ends = std::all_of(cuts_[s].begin(), cuts_[s].end(), [&](const auto& c) {
          return !is_v(c) || c.first <= beyond || c.first >= 1.0 - beyond;
        });
        if (known && !of_ends) continue;
        const Sample there = known ? nearest(s, p, beyond, 1.0 - beyond) : nearest(s, p, 0.0, 1.0);
        if (geom::distance(there.at, p) <= same_) add_cut(s, there.part, v);
      }
    }
  }

  /// What cuts one side of a seam cuts the other too.
  void mirror() {
    const auto both = [&](bool closed, Side low, Side high, bool along_y) {
      if (!closed) return;
      const std::size_t count = arcs_.vertices.size();
      for (std::size_t v = 0; v < count; ++v) {
        Point p = arcs_.vertices[v];
        double& across = along_y ? p.x : p.y;
        if (across > same_ && across < 1.0 - same_) continue;
        across = across < 0.5 ? 1.0 : 0.0;
        const std::size_t twin = arcs_.vertex(p, same_);
        for (std::size_t s = 0; s < arcs_.strands.size(); ++s) {
          const std::optional<Side> side = arcs_.strands[s].side;
          if (side != (across == 0.0 ? low : high)) continue;
          const bool known =
              std::any_of(cuts_[s].begin(), cuts_[s].end(), [twin](const auto& c) { return c.second == twin; });
          if (!known) add_cut(s, nearest(s, p, 0.0, 1.0).part, twin);
        }
      }
    };
    both(surface_.closed_u(), Side::Left, Side::Right, true);
    both(surface_.closed_v(), Side::Bottom, Side::Top, false);
  }

  void make_arcs() {
    arcs_.arcs.clear();
    for (std::size_t s = 0; s < arcs_.strands.size(); ++s) {
      auto& cuts = cuts_[s];
      std::stable_sort(cuts.begin(), cuts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      for (std::size_t i = 0; i + 1 < cuts.size();) {
        std::size_t k = i + 1;
        // What does not leave the vertex is none.
        while (k < cuts.size() && cuts[k].second == cuts[i].second && stays(s, cuts[i].first, cuts[k].first)) ++k;
        if (k == cuts.size()) break;
        arcs_.arcs.push_back({s, cuts[k - 1].first, cuts[k].first, cuts[i].second, cuts[k].second, {}});
        arcs_.arcs.back().along = {{s, cuts[k - 1].first, cuts[k].first, false}};
        i = k;
      }
    }
  }
  [[nodiscard]] bool stays(std::size_t s, double from, double to) const {
    const Point p = arcs_.on(s, from).at;
    for (const double part : {0.25, 0.5, 0.75, 1.0}) {
      if (geom::distance(arcs_.on(s, std::lerp(from, to, part)).at, p) > 4.0 * same_) return false;
    }
    return true;
  }

  /// Of arcs that coincide one is left; a side of the chart before others.
  void merge() {
    std::vector<Arc>& all = arcs_.arcs;
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = i + 1; k < all.size(); ++k) {
        const bool with = all[i].start == all[k].start && all[i].end == all[k].end;
        const bool against = all[i].start == all[k].end && all[i].end == all[k].start;
        if (!(with || against) || !coincide(all[i], all[k])) continue;
        if (arcs_.strands[all[k].strand].side && !arcs_.strands[all[i].strand].side) std::swap(all[i], all[k]);
        const bool turned = all[i].start == all[i].end ? runs_against(all[i], all[k]) : !with;
        for (Along each : all[k].along) {
          each.against = each.against != turned;
          all[i].along.push_back(each);
        }
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(k--));
      }
    }
  }
  [[nodiscard]] bool coincide(const Arc& a, const Arc& b) const {
    const auto lies_on = [&](const Arc& inner, const Arc& outer) {
      for (int i = 1; i < 8; ++i) {
        const Point p = arcs_.on(inner.strand, std::lerp(inner.from, inner.to, i / 8.0)).at;
        if (geom::distance(nearest(outer.strand, p, outer.from, outer.to).at, p) > 2.0 * same_) return false;
      }
      return true;
    };
    return lies_on(a, b) && lies_on(b, a);
  }
  [[nodiscard]] bool runs_against(const Arc& a, const Arc& b) const {
    const Arcs::At p = arcs_.on(a.strand, std::lerp(a.from, a.to, 0.37));
    const Arcs::At q = arcs_.on(b.strand, nearest(b.strand, p.at, b.from, b.to).part);
    return dot(p.first, q.first) < 0.0;
  }

  const Surface& surface_;
  Arcs& arcs_;
  double same_;
  std::vector<std::vector<std::pair<double, std::size_t>>> cuts_;
  std::vector<std::vector<Sample>> samples_;
};

}  // namespace

base::Result<std::vector<Meeting>> cut(const Surface& surface, Arcs& arcs, const Cutting& options,
                                       const std::map<SharedCurveId, std::vector<double>>& cuts) {
  return Cutter(surface, arcs, options).run(cuts);
}

}  // namespace dobra::surf::trim
