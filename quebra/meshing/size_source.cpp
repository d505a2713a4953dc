#include "quebra/meshing/size_source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "quebra/domain/domain.h"
#include "shared/base/formula.h"
#include "shared/base/text.h"
#include "shared/geom/spatial_index.h"
#include "shared/io/formats/mesh_file.h"

namespace quebra::meshing {

namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Formula;
using dobra::base::Result;
using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Segment;
using dobra::mesh::ElementId;
using dobra::mesh::ElementMesh;

dobra::base::Place place_of(Point p) { return {.x = p.x, .y = p.y}; }

constexpr double no_wish = std::numeric_limits<double>::infinity();

/// Sizes at the corners of triangles, linear between them.
class Background {
 public:
  Background(const ElementMesh& mesh, std::vector<double> sizes) : points_(mesh.points), sizes_(std::move(sizes)) {
    std::vector<Box> boxes;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      const auto nodes = mesh.nodes_of(ElementId(e));
      for (std::size_t i = 2; i < corner_count(mesh.types[e]); ++i) {
        triangles_.push_back({nodes[0].index(), nodes[i - 1].index(), nodes[i].index()});
        Box box;
        for (const std::size_t node : triangles_.back()) {
          box.add(points_[node]);
          greatest_ = std::max(greatest_, sizes_[node]);
        }
        boxes.push_back(box);
      }
    }
    index_ = dobra::geom::SpatialIndex(boxes);
  }

  [[nodiscard]] double at(Point p) const {
    const auto nearest = index_.nearest(
        p, [&](std::size_t t) { return distance(foot(t, p).first, p); }, greatest_);
    if (!nearest) return no_wish;
    const double size = foot(nearest->item, p).second;
    return nearest->distance <= size ? size : no_wish;
  }

 private:
  /// The point of a triangle nearest to p, and the size there.
  [[nodiscard]] std::pair<Point, double> foot(std::size_t triangle, Point p) const {
    const auto [i, j, k] = triangles_[triangle];
    const Point a = points_[i];
    const double whole = cross(points_[j] - a, points_[k] - a);
    const double v = cross(p - a, points_[k] - a) / whole;
    const double w = cross(points_[j] - a, p - a) / whole;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) return {p, (1.0 - v - w) * sizes_[i] + v * sizes_[j] + w * sizes_[k]};
    std::pair<Point, double> best{a, sizes_[i]};
    for (const auto& [from, to] : {std::pair{i, j}, std::pair{j, k}, std::pair{k, i}}) {
      const Segment side{points_[from], points_[to]};
      const double f = nearest_fraction(side, p);
      const Point q = interpolate(side.from, side.to, f);
      if (distance(q, p) < distance(best.first, p)) best = {q, (1.0 - f) * sizes_[from] + f * sizes_[to]};
    }
    return best;
  }

  std::vector<Point> points_;
  std::vector<double> sizes_;
  std::vector<std::array<std::size_t, 3>> triangles_;
  double greatest_ = 0.0;
  dobra::geom::SpatialIndex index_;
};

/// At each corner the mean length of the sides that meet there.
std::vector<double> element_sizes(const ElementMesh& mesh) {
  std::vector<double> sum(mesh.points.size(), 0.0);
  std::vector<double> count(mesh.points.size(), 0.0);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.nodes_of(ElementId(e));
    const std::size_t corners = corner_count(mesh.types[e]);
    for (std::size_t i = 0; i < corners; ++i) {
      const std::array ends{nodes[i].index(), nodes[(i + 1) % corners].index()};
      for (const std::size_t node : ends) {
        sum[node] += distance(mesh.points[ends[0]], mesh.points[ends[1]]);
        count[node] += 1.0;
      }
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = count[i] > 0.0 ? sum[i] / count[i] : 1.0;
  return sum;
}

/// @param unit  metres in one unit of the file.
Result<Background> read_background(const std::string& path, const std::string& name, double unit) {
  const auto scale = [unit](ElementMesh& mesh) {
    for (Point& p : mesh.points) p = {unit * p.x, unit * p.y};
  };
  if (name.empty()) {
    DOBRA_TRY(auto contents, dobra::io::formats::read_mesh(path));
    scale(contents.mesh);
    return Background(contents.mesh, element_sizes(contents.mesh));
  }
  using dobra::io::formats::Use;
  if (dobra::io::formats::format_of(path, Use::ReadFields) == nullptr)
    return Error{ErrorCode::BadValue,
                 fmt::format("'{}' holds no fields; give a {} with the field '{}', or leave "
                             "background_field empty to take the sizes of the elements",
                             path, fmt::join(dobra::io::formats::endings_for(Use::ReadFields), " "), name)};
  DOBRA_TRY(auto contents, dobra::io::formats::read_fields(path));
  scale(contents.mesh);
  std::vector<std::string> names;
  for (auto& field : contents.fields.at_points) {
    if (field.components == 1) names.push_back(field.name);
    if (field.name != name || field.components != 1) continue;
    for (std::size_t i = 0; i < field.values.size(); ++i) {
      field.values[i] *= unit;
      if (!is_size(field.values[i]))
        return no_size(fmt::format("field '{}' of '{}'", name, path), field.values[i],
                       place_of(contents.mesh.points[i]));
    }
    return Background(contents.mesh, std::move(field.values));
  }
  return Error{ErrorCode::BadValue, fmt::format("'{}' has no field '{}' of one number at each point{}; it has: {}",
                                                path, name, dobra::base::did_you_mean(name, names),
                                                names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")))};
}

}  // namespace

bool is_size(double value) { return value > 0.0 && std::isfinite(value); }

Error no_size(const std::string& whose, double value, const dobra::base::Place& place) {
  if (!std::isfinite(value))
    return {ErrorCode::BadValue,
            fmt::format("{} has no finite value here; sizes must be: bound it, as with min(..., 1), or leave out where "
                        "it is not defined",
                        whose),
            place};
  return {
      ErrorCode::BadValue,
      fmt::format(
          "{} gives the size {:.6g} m here; sizes must be greater than 0: bound it from below, as with max(..., 0.01)",
          whose, value),
      place};
}

struct SizeSource::Wishes {
  explicit Wishes(const domain::Domain& domain) : inside(domain) {
    std::vector<Box> boxes;
    for (const sketch::Curve& curve : domain.curves) {
      const auto line = trace(curve).line;
      for (std::size_t i = 0; i < line.segment_count(); ++i) boxes.push_back(line.segment(i).box());
    }
    chords = dobra::geom::SpatialIndex(boxes);
  }

  /// The least wish; what is no size inside the domain is remembered.
  double at(Point p) {
    double size = background ? background->at(p) : no_wish;
    if (!formula) return size;
    const double value = formula->at(std::array{p.x, p.y});
    if (is_size(value)) return std::min(size, value);
    if (!fault && inside(p)) fault = no_size("size_formula", value, place_of(p));
    return size;
  }

  [[nodiscard]] bool concerns(const Box& box) const {
    bool found = false;
    chords.for_each_overlapping(box, [&](std::size_t) {
      found = true;
      return dobra::geom::Visit::Stop;
    });
    return found || inside(box.centre());
  }

  domain::Inside inside;
  dobra::geom::SpatialIndex chords;
  std::optional<Formula> formula;
  std::optional<Background> background;
  std::optional<Error> fault;
};

Result<SizeSource> SizeSource::make(const domain::Domain& domain, const std::string& formula,
                                    const std::string& background, const std::string& field,
                                    const dobra::scenario::Context& context) {
  SizeSource source;
  if (background.empty() && !field.empty())
    return Error{ErrorCode::BadValue, "background_field names a field of no file: give `background` too"};
  if (formula.empty() && background.empty()) return source;
  source.wishes_ = std::make_shared<Wishes>(domain);
  if (!background.empty()) {
    DOBRA_TRY(source.wishes_->background,
              read_background((context.folder / background).string(), field, context.units.to_si(1.0, "m")));
  }
  if (formula.empty()) return source;
  static const std::vector<std::string> names{"x", "y"};
  auto read = Formula::make(formula, names);
  if (!read) {
    Error error = read.error();
    error.message = fmt::format("size_formula: {}", error.message);
    return error;
  }
  source.wishes_->formula = *read;
  // On the boundary, which is not inside, it is asked here.
  for (const sketch::Curve& curve : domain.curves) {
    const auto line = trace(curve).line;
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
      constexpr int looks = 8;
      for (int k = 0; k < looks; ++k) {
        const Point p = interpolate(line.segment(i).from, line.segment(i).to, static_cast<double>(k) / looks);
        const double value = read->at(std::array{p.x, p.y});
        if (!is_size(value)) return no_size("size_formula", value, place_of(p));
      }
    }
  }
  return source;
}

dobra::mesh::sizing::SizeFunction SizeSource::function() const {
  if (empty()) return {};
  return {[wishes = wishes_](Point p) { return wishes->at(p); },
          [wishes = wishes_](const Box& box) { return wishes->concerns(box); }};
}

Result<void> SizeSource::check() const {
  if (!empty() && wishes_->fault) return *wishes_->fault;
  return {};
}

}  // namespace quebra::meshing
