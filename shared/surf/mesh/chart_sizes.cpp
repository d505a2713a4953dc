#include "shared/surf/mesh/chart_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <unordered_map>

#include "shared/surf/mesh/tips.h"
#include "shared/surf/trim/finding.h"

namespace dobra::surf::mesh {

using base::Error;
using base::ErrorCode;
using base::Result;
using dobra::mesh::front::LeafScale;
using dobra::mesh::sizing::QuadCellId;
using dobra::mesh::sizing::Quadtree;
using dobra::mesh::sizing::SizedEdge;
using dobra::mesh::sizing::SizeField;
using geom::Point;
using geom::Vector;

namespace {

Result<void> validate(std::span<const dobra::mesh::delaunay::SizeRequest> requests, const SizeOptions& options) {
  const auto wrong = [](const char* text) { return Error{ErrorCode::InvalidOption, text}; };
  if (!(options.growth > 1.0) || !std::isfinite(options.growth))
    return wrong("growth must be greater than 1: it is the ratio of neighbouring sizes");
  if (!(options.largest >= 0.0)) return wrong("largest must be positive, or 0 for a twentieth of the face");
  if (!(options.turn >= 0.0 && options.turn <= 180.0))
    return wrong("turn must be an angle up to 180 degrees, or 0 for none");
  if (!(options.chord >= 0.0)) return wrong("chord must be positive, or 0 for none");
  if (!(options.least >= 0.0)) return wrong("least must be positive, or 0 for none");
  for (const auto& request : requests) {
    if (!(request.size > 0.0) || !std::isfinite(request.size))
      return wrong("a requested mesh size must be greater than 0");
  }
  return {};
}

double greatest_bend(const Jet& jet) {
  const auto bent = curvature(jet);
  return bent ? std::max(std::abs(bent->least), std::abs(bent->greatest)) : 0.0;
}

/// Radians; 15 degrees where none is asked.
double turn_of(const SizeOptions& options) {
  return (options.turn > 0.0 ? options.turn : 15.0) * std::numbers::pi / 180.0;
}

/// Whether a unit of the chart is so short, or isolines are so nearly one, that rounded coordinates bend the surface.
bool is_narrow(const Surface& surface, const Jet& jet) {
  constexpr double part = 1e-2;
  const Metric m = metric(jet);
  const double u = std::sqrt(m.e) * surface.chart().width(), v = std::sqrt(m.g) * surface.chart().height();
  return std::min(u, v) < part * surface.size() || m.area() < part * std::sqrt(m.e * m.g);
}

/// Whether a bend may be one of the rounding of coordinates, or of so little extent that it is not followed.
bool is_in_doubt(const Surface& surface, const Jet& jet, double bend, double extent, const SizeOptions& options) {
  return bend > turn_of(options) / extent || (bend > 0.0 && is_narrow(surface, jet));
}

/// What a place of the chart asks for and how it is stretched.
struct Sample {
  double size = 0.0;
  double along_x = 0.0, along_y = 0.0;  ///< Length in space of a unit of the chart.
  double area = 0.0;
};

class Builder {
 public:
  Builder(const ScaledChart& chart, const SizeOptions& options, double largest, const geom::Box& box,
          std::span<const Tip> tips)
      : chart_(chart),
        options_(options),
        largest_(largest),
        unnoticed_(unnoticed_bend(largest, options)),
        box_(box),
        tips_(tips) {}

  /// Of what shape and formula ask, the least at a place of the scaled chart, where `jet` is.
  [[nodiscard]] double size(Point p, const Jet& jet) const {
    double by_shape = size_by_bend(bend(p, jet), options_);
    for (const Tip& tip : tips_) {
      const double distance = geom::distance(tip.at, jet.at);
      if (distance < tip_seen * largest_) by_shape *= tip_seen * largest_ / std::max(distance, 1e-12 * largest_);
      by_shape = std::min(by_shape, tip.size + tip_growth * distance);
    }
    by_shape = std::min(by_shape, size_by_chart(jet, options_));
    return std::max(options_.least, std::min({largest_, by_shape, options_.wanted_at(chart_.unscaled(p), jet.at)}));
  }

  [[nodiscard]] Sample sample(Point p) const {
    const Jet jet = chart_.jet(p);
    const Metric m = metric(jet);
    return {size(p, jet), std::sqrt(m.e), std::sqrt(m.g), m.area()};
  }
  /// Whether a cell must be seen more closely than by its corners.
  /// @param fine  counts those that must for bends of less extent than a thousandth of the largest size
  [[nodiscard]] bool follows_badly(const Quadtree& tree, QuadCellId id, std::uint32_t first_look,
                                   std::size_t& fine) const {
    double least = largest_;
    const bool badly = follows_badly(tree, id, first_look, least);
    if (badly && least < unnoticed_) ++fine;
    return badly;
  }

 private:
  /// The bend that is followed. Cells have their places in common, and looking around is slow: each is looked at once.
  [[nodiscard]] double bend(Point p, const Jet& jet) const {
    const double whole = greatest_bend(jet);
    if (size_by_bend(whole, options_) >= largest_ || !is_in_doubt(chart_.surface(), jet, whole, unnoticed_, options_))
      return whole;
    const auto [at, fresh] = looked_at_.try_emplace(p);
    if (fresh) at->second = followed_bend(chart_.surface(), chart_.held(p), jet, unnoticed_, options_);
    return at->second;
  }

  [[nodiscard]] bool follows_badly(const Quadtree& tree, QuadCellId id, std::uint32_t first_look,
                                   double& least_size) const {
    constexpr double unnoticed = 0.1;
    constexpr double unstretched = 1.6;
    const geom::Box cell = tree.box(id);
    if (!cell.overlaps(box_)) return false;
    if (tree.cell(id).level < first_look) return true;
    std::array<std::array<double, 3>, 3> size{};
    Sample least{largest_, 1e300, 1e300, 1e300}, most{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const Sample s = sample({cell.low.x + 0.5 * static_cast<double>(i) * cell.width(),
                                 cell.low.y + 0.5 * static_cast<double>(j) * cell.height()});
        size[i][j] = s.size;
        least = {std::min(least.size, s.size), std::min(least.along_x, s.along_x), std::min(least.along_y, s.along_y),
                 std::min(least.area, s.area)};
        most = {std::max(most.size, s.size), std::max(most.along_x, s.along_x), std::max(most.along_y, s.along_y),
                std::max(most.area, s.area)};
      }
    }
    least_size = least.size;
    const double side = tree.side(id) * std::max(most.along_x, most.along_y);
    if (side > unnoticed_ && !chart_.seen(cell)) return true;
    if (side <= 0.5 * least.size) return false;
    const double longest = 8.0 * least.size;
    if (side > longest && (most.along_x > unstretched * least.along_x || most.along_y > unstretched * least.along_y ||
                           most.area > unstretched * least.area))
      return true;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const std::array<std::size_t, 2> left = i == 1 ? std::array<std::size_t, 2>{0, 2} : std::array{i, i};
        const std::array<std::size_t, 2> low = j == 1 ? std::array<std::size_t, 2>{0, 2} : std::array{j, j};
        const double between =
            0.25 * (size[left[0]][low[0]] + size[left[1]][low[0]] + size[left[0]][low[1]] + size[left[1]][low[1]]);
        if (std::abs(between - size[i][j]) > unnoticed * size[i][j]) return true;
      }
    }
    return false;
  }

  const ScaledChart& chart_;
  const SizeOptions& options_;
  const double largest_;
  const double unnoticed_;
  const geom::Box box_;
  const std::span<const Tip> tips_;
  struct Bits {
    std::size_t operator()(Point p) const {
      const auto x = std::bit_cast<std::uint64_t>(p.x), y = std::bit_cast<std::uint64_t>(p.y);
      const std::uint64_t mixed = (x ^ (y * 0x9E3779B97F4A7C15ULL)) * 0xFF51AFD7ED558CCDULL;
      return mixed ^ (mixed >> 32U);
    }
  };
  mutable std::unordered_map<Point, double, Bits> looked_at_;  ///< By places of the scaled chart.
};

/// Levels of the tree before its cells are looked at: each piece of the surface is seen.
std::uint32_t first_look(const Surface& surface) {
  const std::size_t pieces = std::max(surface.breaks().u.size(), surface.breaks().v.size());
  return std::clamp(static_cast<std::uint32_t>(std::ceil(std::log2(static_cast<double>(pieces)))), 4U, 8U);
}

LeafScale scale_of(std::span<const Metric> metrics) {
  constexpr double widest = 16.0;
  double mean = 0.0;
  LeafScale scale{0.0, 0.0, 0.0};
  for (const Metric& m : metrics) {
    const double largest = std::max({m.e, m.g, 1e-300});
    const double det = std::max(m.e * m.g - m.f * m.f, 1e-8 * largest * largest);
    mean += std::pow(det, -0.25) / static_cast<double>(metrics.size());
    scale.reach_u = std::max(scale.reach_u, std::sqrt(m.g / det));
    scale.reach_v = std::max(scale.reach_v, std::sqrt(m.e / det));
  }
  constexpr double reserve = 1.05;
  scale.mean = mean;
  scale.reach_u = std::min(reserve * scale.reach_u, widest * mean);
  scale.reach_v = std::min(reserve * scale.reach_v, widest * mean);
  return scale;
}

Result<Quadtree> tree_of(const ScaledChart& chart, const Builder& builder, std::span<const SizedEdge> edges,
                         std::span<const dobra::mesh::delaunay::SizeRequest> requests, const SizeOptions& options) {
  constexpr double unnoticed = 0.1;
  constexpr double most = 16.0;
  const double coarser = std::clamp(unnoticed / (options.growth - 1.0), 1.0, most);
  const double factor = 1.0 / coarser;
  DOBRA_TRY(Quadtree tree, Quadtree::build(edges, {.refinement_factor = factor,
                                                   .interior = dobra::mesh::sizing::InteriorCells::Free}));
  for (const auto& request : requests) {
    const Sample s = builder.sample(request.at);
    tree.refine_at(request.at, request.size / std::max({s.along_x, s.along_y, 1e-300}), factor);
  }
  const std::uint32_t look = first_look(chart.surface());
  const std::size_t most_fine = options.most_cells / 20;
  std::size_t fine = 0;
  const auto badly = [&](QuadCellId id) { return fine <= most_fine && builder.follows_badly(tree, id, look, fine); };
  if (!tree.refine_where(badly, tree.cell_count() + options.most_cells) || fine > most_fine) {
    const auto leaves = tree.leaves();
    const auto deepest = std::max_element(leaves.begin(), leaves.end(), [&](QuadCellId a, QuadCellId b) {
      return tree.cell(a).level < tree.cell(b).level;
    });
    return Error{ErrorCode::TooManyElements,
                 fmt::format("the sizes that the curvature asks for are too small here, or change too fast, for a tree "
                             "of {} cells: use a greater turn or chord, or trim this part of the surface away",
                             options.most_cells),
                 trim::place_of(chart.surface(), chart.held(tree.box(*deepest).centre()))};
  }
  tree.balance();
  return tree;
}

/// How many windows round a corner of the chart where the isolines touch each other do not count.
constexpr double flat_corner = 16.0;

/// Whether the corner of the chart that is next has isolines that touch each other, and is so near.
bool is_flat_corner(const Surface& surface, Point uv, Vector window) {
  const geom::Box& chart = surface.chart();
  const Point centre = chart.centre();
  const Point corner{uv.x < centre.x ? chart.low.x : chart.high.x, uv.y < centre.y ? chart.low.y : chart.high.y};
  if (std::abs(corner.x - uv.x) > flat_corner * window.x || std::abs(corner.y - uv.y) > flat_corner * window.y)
    return false;
  const Jet jet = surface.jet(corner);
  constexpr double touching = 1e-6;
  return geom::length(cross(jet.u, jet.v)) <= touching * geom::length(jet.u) * geom::length(jet.v);
}

/// The bend round a place, 1/m, from the normals at four places diagonally beside it, `extent` away; none where these
/// turn by more than the turn: that bend is no smaller than the extent. Six jets.
std::optional<double> bend_around(const Surface& surface, Point uv, double extent, const SizeOptions& options) {
  const Metric here = metric(surface.jet(uv));
  const geom::Box& chart = surface.chart();
  const double half_u = std::min(extent / std::max(std::sqrt(here.e), 1e-300), 0.25 * chart.width());
  const double half_v = std::min(extent / std::max(std::sqrt(here.g), 1e-300), 0.25 * chart.height());
  // The window lies inside, as a side of the chart that is one point has no normal, nor has a corner where it is flat.
  const double off = is_flat_corner(surface, uv, {half_u, half_v}) ? flat_corner : 2.0;
  const auto window = [off](double at, double low, double high, double half) {
    half = std::min(half, 0.25 * (high - low) / std::max(1.0, 0.5 * off));
    const double middle = std::clamp(at, low + off * half, high - off * half);
    return std::array{middle - half, middle + half};
  };
  const std::array us = window(uv.x, chart.low.x, chart.high.x, half_u);
  const std::array vs = window(uv.y, chart.low.y, chart.high.y, half_v);
  std::array<geom::Point3, 4> at;
  std::array<geom::Vector3, 4> normals;
  for (std::size_t i = 0; i < 4; ++i) {
    const Jet jet = surface.jet({us[i % 2], vs[i / 2]});
    at[i] = jet.at;
    normals[i] = cross(jet.u, jet.v);
    const double length = geom::length(normals[i]);
    if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
    normals[i] = (1.0 / length) * normals[i];
  }
  const double turn = turn_of(options);
  const double most = turn / extent;
  double bend = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double angle = std::atan2(geom::length(cross(normals[i], normals[j])), dot(normals[i], normals[j]));
      if (!(angle <= turn)) return std::nullopt;
      const double apart = geom::distance(at[i], at[j]);
      if (apart > 0.0) bend = std::max(bend, angle / apart);
    }
  }
  return std::min(bend, most);
}

Error too_small_to_tell(const ScaledChart& chart, Point at, double size) {
  return {
      ErrorCode::TooManyElements,
      fmt::format("the size {:.3g} m asked for here is too small to be told apart in the chart of the face: ask for "
                  "a greater size, or trim this part of the surface away",
                  size),
      trim::place_of(chart.surface(), chart.held(at))};
}

}  // namespace

double largest_size(const Surface& surface, const SizeOptions& options) {
  return options.largest > 0.0 ? options.largest : surface.size() / 20.0;
}

double size_by_bend(double bend, const SizeOptions& options) {
  constexpr double none = std::numeric_limits<double>::infinity();
  if (!(bend > 0.0)) return none;
  double size = options.turn > 0.0 ? 2.0 * std::sin(options.turn * std::numbers::pi / 360.0) / bend : none;
  // A triangle with sides h is h^2 k / 6 off in its middle, and sides may be longer than the size.
  constexpr double longer = 1.6;
  if (options.chord > 0.0) size = std::min(size, std::sqrt(6.0 * options.chord / bend) / longer);
  return size;
}

double size_by_chart(const Jet& jet, const SizeOptions& options) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const auto is_upright = [](geom::Vector3 bent) { return bent.x == 0.0 && bent.y == 0.0; };
  if (!is_upright(jet.uu) || !is_upright(jet.uv) || !is_upright(jet.vv)) return none;
  const Metric m = metric(jet);
  const geom::Vector3 across = cross(jet.u, jet.v);
  const double area = m.area(), along = std::sqrt(m.e);
  if (!(area > 0.0 && std::isfinite(area))) return none;
  const geom::Vector3 normal = across / area, first = jet.u / along, second = cross(normal, first);
  constexpr int ways = 12;
  double most = 0.0;
  for (int i = 0; i < ways; ++i) {
    const double angle = std::numbers::pi * i / ways;
    // A unit step on the surface, and in the chart.
    const geom::Vector3 step = std::cos(angle) * first + std::sin(angle) * second;
    const double by_u = dot(step, jet.u), by_v = dot(step, jet.v);
    const double u = (m.g * by_u - m.f * by_v) / (area * area), v = (m.e * by_v - m.f * by_u) / (area * area);
    most = std::max(most, std::abs(dot(u * u * jet.uu + 2.0 * u * v * jet.uv + v * v * jet.vv, cross(normal, step))));
  }
  // A side h is h^2 k / 8 off to the side in its middle; a triangle over it is 0.87 h high.
  return most > 0.0 ? options.sideways / most : none;
}

double size_by_shape(const Jet& jet, const SizeOptions& options) { return size_by_bend(greatest_bend(jet), options); }

double unnoticed_bend(double largest, const SizeOptions& options) {
  const double extent = 1e-3 * largest;
  return options.chord > 0.0 ? std::min(extent, 0.25 * options.chord) : extent;
}

double followed_bend(const Surface& surface, Point uv, const Jet& jet, double extent, const SizeOptions& options) {
  const double bend = greatest_bend(jet);
  if (!is_in_doubt(surface, jet, bend, extent, options)) return bend;
  const auto around = bend_around(surface, uv, extent, options);
  return around ? std::min(bend, *around) : bend;
}

Result<ChartSizes> chart_sizes(const ScaledChart& chart, std::span<const GivenSide> sides,
                               std::span<const dobra::mesh::delaunay::SizeRequest> requests, std::span<const Tip> tips,
                               const SizeOptions& options, const base::Progress& progress) {
  DOBRA_TRY_VOID(validate(requests, options));
  geom::Box box;
  std::vector<SizedEdge> edges;
  for (const GivenSide& side : sides) {
    edges.push_back({side.chart, {}});
    box.add(side.chart.box());
  }
  const double largest = largest_size(chart.surface(), options);
  const Builder builder(chart, options, largest, box, tips);
  DOBRA_TRY(Quadtree tree, tree_of(chart, builder, edges, requests, options));
  DOBRA_TRY_VOID(progress.check());
  ChartSizes made{SizeField::on(std::move(tree)), {}, {}};
  SizeField& field = made.field;
  const std::vector<Point> places = field.corner_places();
  std::vector<geom::Point3> at(places.size());
  std::vector<Metric> metrics(places.size());
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    const Jet jet = chart.jet(places[i]);
    at[i] = jet.at;
    metrics[i] = metric(jet);
    if (!geom::is_finite(jet.at) || !std::isfinite(metrics[i].e + metrics[i].g)) {
      return Error{ErrorCode::CannotMesh, "the surface has no place, or no length, that is a number here",
                   trim::place_of(chart.surface(), chart.held(places[i]))};
    }
    field.ask(i, builder.size(places[i], jet));
  }
  const auto ask = [&](Point p, double size) {
    for (const std::uint32_t corner : field.corners(field.quadtree().leaf_at(p))) field.ask(corner, size);
  };
  for (const GivenSide& side : sides) {
    if (side.length > 0.0) ask(geom::midpoint(side.chart.from, side.chart.to), side.length);
  }
  for (const auto& request : requests) ask(request.at, std::max(options.least, request.size));
  field.spread(options.growth - 1.0, largest, at);

  made.scale.resize(field.quadtree().cell_count());
  made.triangles.assign(made.scale.size(), 0.0);
  for (const QuadCellId leaf : field.quadtree().leaves()) {
    std::array<Metric, 5> around{};
    double area = 0.0;
    for (std::size_t k = 0; k < 4; ++k) around[k] = metrics[field.corners(leaf)[k]];
    const geom::Box cell = field.quadtree().box(leaf);
    around[4] = metric(chart.jet(cell.centre()));
    made.scale[leaf.index()] = scale_of(around);
    for (const Metric& m : around) area += 0.2 * m.area();
    const double width = std::max(0.0, std::min(cell.high.x, box.high.x) - std::max(cell.low.x, box.low.x));
    const double height = std::max(0.0, std::min(cell.high.y, box.high.y) - std::max(cell.low.y, box.low.y));
    const auto size = field.corner_sizes(leaf);
    const double mean = 0.25 * (size[0] + size[1] + size[2] + size[3]);
    made.triangles[leaf.index()] = 4.0 / std::numbers::sqrt3 * area * width * height / (mean * mean);
    constexpr double most_in_last = 4096.0;  // nodes that are sought one by one
    if (field.quadtree().cell(leaf).level == Quadtree::max_level && made.triangles[leaf.index()] > most_in_last)
      return too_small_to_tell(chart, cell.centre(), mean);
  }
  return made;
}

}  // namespace dobra::surf::mesh
