#include "shared/io/formats/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/geom/intersect.h"
#include "shared/geom/spatial_index.h"
#include "shared/io/formats/point_order.h"
#include "shared/io/formats/snap_ends.h"
#include "shared/io/scan.h"

namespace dobra::io::formats {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using geom::Point;
using geom::Polyline;

namespace {

using Repairs = std::vector<Repair>;

std::string label_of(const lines::Feature& feature, std::size_t number) {
  if (feature.name.empty())
    return feature.source.line > 0 ? fmt::format("the line that begins at line {}", feature.source.line)
                                   : fmt::format("feature {}", number);
  return fmt::format("{} '{}'", feature.kind.empty() ? "line" : feature.kind, feature.name);
}

// --- order

Result<void> order_part(Polyline& part, const std::string& item, Repairs& repairs) {
  if (part.points.size() < 3) return {};
  DOBRA_TRY(const PointOrderFound found, order_along_curve(part.points));
  const double before = geom::length(part);
  Polyline ordered;
  for (const std::size_t i : found.order) ordered.points.push_back(part.points[i]);
  if (ordered.points == part.points || ordered.points == geom::reversed(part).points) return {};
  const double after = geom::length(ordered);
  std::string text = fmt::format("{} points put in order along the curve; length {:.6g} m instead of {:.6g} m",
                                 ordered.points.size(), after, before);
  if (found.inserted > 0) text += fmt::format("; {} of them stand beside it", found.inserted);
  if (const std::size_t twice = part.points.size() - ordered.points.size(); twice > 0) {
    text += fmt::format("; {} equal ones dropped", twice);
  }
  repairs.push_back({"order", item, text, ordered.points.front(), 0.0});
  part = std::move(ordered);
  return {};
}

Result<void> order_points(std::vector<lines::Feature>& features, Repairs& repairs) {
  for (std::size_t i = 0; i < features.size(); ++i) {
    lines::Feature& feature = features[i];
    const bool points = feature.type == lines::FeatureType::Points && feature.kind != "marker" &&
                        !feature.parts.empty() && feature.parts[0].points.size() > 2;
    if (feature.type != lines::FeatureType::Lines && !points) continue;
    const std::string item = label_of(feature, i + 1);
    for (Polyline& part : feature.parts) {
      if (auto ordered = order_part(part, item, repairs); !ordered) {
        return base::located(base::located(ordered.error(), feature.source), Place{.item = item});
      }
    }
    feature.type = lines::FeatureType::Lines;
  }
  return {};
}

// --- duplicates

void drop_duplicates(std::vector<lines::Feature>& features, double tolerance, Repairs& repairs) {
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (features[i].type == lines::FeatureType::Points) continue;
    for (Polyline& part : features[i].parts) {
      std::vector<Point> kept{part.points.front()};
      Repair done{"duplicates", label_of(features[i], i + 1), {}, {}, 0.0};
      std::size_t dropped = 0;
      const auto drop = [&](Point p, Point near) {
        if (dropped++ == 0) done.at = p;
        done.moved = std::max(done.moved, geom::distance(p, near));
      };
      for (std::size_t k = 1; k < part.points.size(); ++k) {
        const Point p = part.points[k];
        const bool last = k + 1 == part.points.size() && !part.closed;
        if (geom::distance(p, kept.back()) >= tolerance) {
          kept.push_back(p);
        } else if (last && kept.size() > 1) {  // the end of a line stays
          drop(kept.back(), p);
          kept.back() = p;
        } else {
          drop(p, kept.back());
        }
      }
      while (part.closed && kept.size() > 3 && geom::distance(kept.back(), kept.front()) < tolerance) {
        drop(kept.back(), kept.front());
        kept.pop_back();
      }
      const std::size_t needed = part.closed ? 3 : 2;
      if (dropped == 0 || kept.size() < needed) continue;  // a line that would vanish is left as it is
      part.points = std::move(kept);
      done.text = fmt::format("{} {} nearer than {:g} m to the one before dropped", dropped,
                              dropped == 1 ? "point" : "points", tolerance);
      repairs.push_back(std::move(done));
    }
  }
}

// --- gaps

struct Chain {
  Polyline line;
  std::size_t feature;
};

constexpr std::size_t no_end = std::numeric_limits<std::size_t>::max();

// Ends are numbered: 2 i is the beginning of chain i, 2 i + 1 its end.
Point end_point(const std::vector<Chain>& chains, std::size_t end) {
  const std::vector<Point>& points = chains[end / 2].line.points;
  return end % 2 == 1 ? points.back() : points.front();
}

// For each end the one that it is joined to: nearest pairs first, no ring closed.
template <class MayJoin>
std::vector<std::size_t> partners_of_ends(const std::vector<Chain>& chains, double tolerance, const MayJoin& may_join) {
  std::vector<geom::Box> boxes;
  for (std::size_t end = 0; end < 2 * chains.size(); ++end) {
    geom::Box box;
    box.add(end_point(chains, end));
    boxes.push_back(box.grown(0.5 * tolerance));
  }
  struct Pair {
    double gap;
    std::size_t a;
    std::size_t b;
    auto operator<=>(const Pair&) const = default;
  };
  std::vector<Pair> pairs;
  for (const auto& [a, b] : geom::SpatialIndex(boxes).overlapping_pairs()) {
    const double gap = geom::distance(end_point(chains, a), end_point(chains, b));
    if (gap < tolerance && a / 2 != b / 2) pairs.push_back({gap, a, b});
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<std::size_t> partners(2 * chains.size(), no_end);
  std::vector<std::size_t> group(chains.size());
  for (std::size_t i = 0; i < group.size(); ++i) group[i] = i;
  const auto root = [&](std::size_t i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  for (const Pair& pair : pairs) {
    const std::size_t one = root(pair.a / 2);
    const std::size_t other = root(pair.b / 2);
    if (partners[pair.a] != no_end || partners[pair.b] != no_end || one == other) continue;
    if (!may_join(pair.a, pair.b)) continue;
    partners[pair.a] = pair.b;
    partners[pair.b] = pair.a;
    group[other] = one;
  }
  return partners;
}

// The chains, joined at the partners; each new one keeps the direction of its first chain in the file.
std::vector<Chain> joined(std::vector<Chain> chains, const std::vector<std::size_t>& partners, const std::string& item,
                          double tolerance, Repairs& repairs) {
  const double same_place = 1e-6 * tolerance;  // ends that rounding has parted
  std::vector<Chain> made;
  std::vector<bool> used(chains.size(), false);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (used[i]) continue;
    std::size_t start = 2 * i;  // the free end from which the walk begins
    while (partners[start] != no_end) start = partners[start] ^ 1U;
    Chain whole{{}, chains[i].feature};
    bool turned = false;
    for (std::size_t end = start; end != no_end;) {
      const std::size_t k = end / 2;
      used[k] = true;
      if (k == i) turned = end % 2 == 1;
      Polyline next = end % 2 == 1 ? geom::reversed(std::move(chains[k].line)) : std::move(chains[k].line);
      std::vector<Point>& points = whole.line.points;
      bool same = false;
      if (!points.empty()) {
        const double gap = geom::distance(points.back(), next.points.front());
        same = gap <= same_place;
        repairs.push_back(
            {"gap", item, fmt::format("two parts joined over a gap of {:.6g} m", gap), points.back(), gap});
      }
      points.insert(points.end(), next.points.begin() + (same ? 1 : 0), next.points.end());
      end = partners[end ^ 1U];
    }
    if (turned) whole.line = geom::reversed(std::move(whole.line));
    made.push_back(std::move(whole));
  }
  return made;
}

// A boundary of a unit that returns to its beginning.
void close_unit(lines::Feature& feature, double tolerance, const std::string& item, Repairs& repairs) {
  if (feature.kind != "unit" || feature.parts.size() != 1 || feature.parts[0].points.size() < 4) return;
  std::vector<Point>& points = feature.parts[0].points;
  const double gap = geom::distance(points.front(), points.back());
  if (gap >= tolerance) return;
  repairs.push_back({"gap", item, fmt::format("closed over a gap of {:.6g} m", gap), points.back(), gap});
  lines::Feature closed = feature;
  closed.type = lines::FeatureType::Polygons;
  if (lines::normalise(closed, {0})) feature = std::move(closed);
}

void join_gaps(std::vector<lines::Feature>& features, const RepairOptions& options, Repairs& repairs) {
  const double tolerance = *options.gaps;
  std::vector<bool> taken(features.size(), false);
  for (std::size_t i = 0; i < features.size(); ++i) {
    lines::Feature& feature = features[i];
    if (taken[i] || feature.type != lines::FeatureType::Lines) continue;
    std::vector<Chain> chains;
    for (std::size_t j = i; j < features.size(); ++j) {
      lines::Feature& same = features[j];
      const bool joins = j == i || (!feature.name.empty() && same.name == feature.name && same.kind == feature.kind &&
                                    same.type == lines::FeatureType::Lines);
      if (!joins) continue;
      taken[j] = true;
      for (Polyline& part : same.parts) chains.push_back({std::move(part), j});
      same.parts.clear();
    }
    const std::string item = label_of(feature, i + 1);
    const auto end_of = [&](std::size_t end) -> PartEnd {
      return {features[chains[end / 2].feature], chains[end / 2].line, end % 2 == 1};
    };
    const std::vector<std::size_t> partners = partners_of_ends(chains, tolerance, [&](std::size_t a, std::size_t b) {
      return !options.may_join || options.may_join(end_of(a), end_of(b));
    });
    for (Chain& chain : joined(std::move(chains), partners, item, tolerance, repairs)) {
      features[chain.feature].parts.push_back(std::move(chain.line));
    }
    close_unit(feature, tolerance, item, repairs);
  }
  std::erase_if(features,
                [](const lines::Feature& f) { return f.type == lines::FeatureType::Lines && f.parts.empty(); });
}

// --- edges that polygons share

/// The sides of some parts, to be asked for the nearest one, and to take new vertices.
class Sides {
 public:
  void add(Polyline& part) { parts_.push_back(&part); }
  void build() {
    std::vector<geom::Box> boxes;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      for (std::size_t s = 0; s < parts_[k]->segment_count(); ++s) {
        boxes.push_back(parts_[k]->segment(s).box());
        sides_.emplace_back(k, s);
      }
    }
    index_ = geom::SpatialIndex(boxes);
  }

  struct Foot {
    std::size_t part = 0;
    std::size_t side = 0;
    Point at;
    bool vertex = false;  ///< There is one already.
  };
  /// The nearest vertex within the tolerance, without one the nearest place on a side.
  [[nodiscard]] std::optional<Foot> foot(Point p, double tolerance) const {
    std::optional<Foot> found;
    double nearest = tolerance;
    geom::Box box;
    box.add(p);
    index_.for_each_overlapping(box.grown(tolerance), [&](std::size_t i) {
      const std::size_t k = sides_[i].first;  // clang 14 captures no bindings
      const std::size_t s = sides_[i].second;
      const geom::Segment side = parts_[k]->segment(s);
      const auto offer = [&](Point at, bool vertex) {
        const double distance = geom::distance(p, at);
        const bool better = !found || vertex > found->vertex || (vertex == found->vertex && distance < nearest);
        if (distance >= tolerance || !better) return;
        nearest = distance;
        found = Foot{k, s, at, vertex};
      };
      offer(side.from, true);
      offer(side.to, true);
      offer(geom::interpolate(side.from, side.to, geom::nearest_fraction(side, p)), false);
    });
    return found;
  }
  /// The side of the foot is to pass through `at`.
  void take(const Foot& foot, Point at) { taken_.push_back({foot.part, foot.side, at}); }
  /// Puts what was taken into the parts.
  void finish() {
    // From the last side on, so that the others keep their numbers; along a side from its end.
    std::sort(taken_.begin(), taken_.end(), [&](const Foot& a, const Foot& b) {
      if (a.part != b.part) return a.part < b.part;
      if (a.side != b.side) return a.side > b.side;
      const Point from = parts_[a.part]->points[a.side];
      return geom::distance(from, a.at) > geom::distance(from, b.at);
    });
    for (const Foot& foot : taken_) {
      std::vector<Point>& points = parts_[foot.part]->points;
      points.insert(points.begin() + static_cast<std::ptrdiff_t>(foot.side) + 1, foot.at);
    }
    for (Polyline* part : parts_) *part = geom::without_repeated_points(std::move(*part));
  }

 private:
  std::vector<Polyline*> parts_;
  std::vector<std::pair<std::size_t, std::size_t>> sides_;
  std::vector<Foot> taken_;
  geom::SpatialIndex index_;
};

void share_edges(std::vector<lines::Feature>& features, double tolerance, Repairs& repairs) {
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (features[i].type != lines::FeatureType::Polygons) continue;
    Sides others, own;
    for (std::size_t j = 0; j < features.size(); ++j) {
      if (features[j].type != lines::FeatureType::Lines && (features[j].type != lines::FeatureType::Polygons || j >= i))
        continue;
      for (Polyline& part : features[j].parts) others.add(part);
    }
    others.build();
    Repair done{"edge", label_of(features[i], i + 1), {}, {}, 0.0};
    std::size_t count = 0;
    for (Polyline& part : features[i].parts) {
      for (Point& p : part.points) {
        const auto foot = others.foot(p, tolerance);
        if (!foot) continue;
        if (!foot->vertex) others.take(*foot, foot->at);
        if (p == foot->at) continue;
        if (count++ == 0) done.at = foot->at;
        done.moved = std::max(done.moved, geom::distance(p, foot->at));
        p = foot->at;
      }
      own.add(part);
    }
    others.finish();
    own.build();
    // The other way round: the polygon passes through vertices of the others that lie beside its sides.
    for (std::size_t j = 0; j < features.size(); ++j) {
      if (features[j].type != lines::FeatureType::Lines && (features[j].type != lines::FeatureType::Polygons || j >= i))
        continue;
      for (const Polyline& part : features[j].parts) {
        for (const Point p : part.points) {
          const auto foot = own.foot(p, tolerance);
          if (foot && !foot->vertex) own.take(*foot, p);
        }
      }
    }
    own.finish();
    if (count == 0) continue;
    done.text = fmt::format("{} {} moved onto edges that it shares", count, count == 1 ? "vertex" : "vertices");
    repairs.push_back(std::move(done));
  }
}

// --- slivers

double distance_to_segment(Point p, Point a, Point b) {
  return geom::distance(p, geom::interpolate(a, b, geom::nearest_fraction({a, b}, p)));
}

// Whether the corner at `b` is the tip of a spike: the way turns back, and out and back lie within `width`.
bool is_spike(Point a, Point b, Point c, double width) {
  if (geom::dot(b - a, c - b) >= 0.0) return false;
  return std::min(distance_to_segment(a, b, c), distance_to_segment(c, a, b)) < width;
}

void remove_spikes(Polyline& ring, double width, const std::string& item, Repairs& repairs) {
  std::vector<Point>& points = ring.points;
  for (std::size_t i = 0, calm = 0; points.size() > 3 && calm < points.size();) {
    const std::size_t n = points.size();
    const Point a = points[(i + n - 1) % n];
    const Point b = points[i % n];
    const Point c = points[(i + 1) % n];
    if (!is_spike(a, b, c, width)) {
      ++calm;
      i = (i + 1) % n;
      continue;
    }
    const double moved = distance_to_segment(b, a, c);
    repairs.push_back(
        {"spike", item, fmt::format("a spike of {:.6g} m, thinner than {:g} m, removed", moved, width), b, moved});
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(i % n));
    i = (i + n - 2) % (n - 1);  // the corner before may be the tip now
    calm = 0;
  }
}

void remove_slivers(std::vector<lines::Feature>& features, double width, Repairs& repairs) {
  for (std::size_t i = 0; i < features.size(); ++i) {
    lines::Feature& feature = features[i];
    if (feature.type != lines::FeatureType::Polygons) continue;
    const std::string item = label_of(feature, i + 1);
    std::vector<Polyline> kept;
    bool drop_holes = false;  // with their contour
    for (Polyline& part : feature.parts) {
      remove_spikes(part, width, item, repairs);
      const double area = geom::signed_area(part);
      const double mean_width = 2.0 * std::abs(area) / geom::length(part);
      const bool hole = area < 0.0 && !feature.parts.empty() && &part != &feature.parts.front();
      if (!hole) drop_holes = mean_width < width;
      if (mean_width >= width && !drop_holes) {
        kept.push_back(std::move(part));
        continue;
      }
      repairs.push_back({"sliver", item,
                         fmt::format("a {} of {:.6g} m2, {:.3g} m wide on average, removed", hole ? "hole" : "polygon",
                                     std::abs(area), mean_width),
                         part.points.front(), mean_width});
    }
    feature.parts = std::move(kept);
  }
  std::erase_if(features,
                [](const lines::Feature& f) { return f.type == lines::FeatureType::Polygons && f.parts.empty(); });
}

Result<void> check(const RepairOptions& options) {
  for (const auto& [value, name] :
       {std::pair{options.duplicates, "duplicates"}, std::pair{options.gaps, "gaps"}, std::pair{options.snap, "snap"},
        std::pair{options.edges, "edges"}, std::pair{options.slivers, "slivers"}}) {
    if (!value || (std::isfinite(*value) && *value > 0.0)) continue;
    return Error{ErrorCode::InvalidOption,
                 fmt::format("the tolerance of the repair '{}' is {}; give 0 m (none) or more", name, *value)};
  }
  return {};
}

}  // namespace

Result<std::vector<Repair>> repair(std::vector<lines::Feature>& features, const RepairOptions& options) {
  DOBRA_TRY_VOID(check(options));
  Repairs repairs;
  if (options.order == PointOrder::AlongTheCurve) DOBRA_TRY_VOID(order_points(features, repairs));
  if (options.duplicates) drop_duplicates(features, *options.duplicates, repairs);
  if (options.gaps) join_gaps(features, options, repairs);
  if (options.snap) {
    for (const SnappedEnd& end : snap_ends(features, options)) {
      repairs.push_back({"snap", label_of(features[end.feature], end.feature + 1),
                         fmt::format("an end moved onto {}", label_of(features[end.onto], end.onto + 1)), end.at,
                         end.moved});
    }
  }
  if (options.edges) share_edges(features, *options.edges, repairs);
  if (options.slivers) remove_slivers(features, *options.slivers, repairs);
  return repairs;
}

std::string to_string(const Repair& repair) {
  return fmt::format("{}: {}: {}, at ({:.7g}, {:.7g}){}", repair.what, repair.item, repair.text, repair.at.x,
                     repair.at.y, repair.moved > 0.0 ? fmt::format(", moved {:.4g} m", repair.moved) : "");
}

}  // namespace dobra::io::formats
