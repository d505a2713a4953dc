#include "quebra/core/input.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "quebra/core/domain.h"
#include "shared/io/poly.h"

namespace quebra::core {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::geom::Arc;
using dobra::geom::Orientation;
using dobra::geom::Point;
using dobra::geom::Polyline;

Error lacking(const CurveParams& params, const char* what) {
  return {ErrorCode::BadValue, fmt::format("curve '{}' {}", params.name, what)};
}

Result<Curve> make_line(const CurveParams& params) {
  Polyline line{params.points, params.kind == CurveKind::Polygon};
  line = without_repeated_points(std::move(line));
  DOBRA_TRY_VOID(validate(line));
  if (!line.closed && line.points.size() > 3 && line.points.front() == line.points.back()) {
    line.closed = true;
    line.points.pop_back();
  }
  return Curve{params.name, params.role, std::move(line), {}};
}

Result<Curve> make_arc(const CurveParams& params) {
  if (!params.centre) return lacking(params, "needs `centre`");
  if (params.points.size() == 2) {
    const auto orientation = params.turning == Turning::Anticlockwise ? Orientation::Anticlockwise : Orientation::Clockwise;
    DOBRA_TRY(Arc arc, Arc::from_ends(*params.centre, params.points[0], params.points[1], orientation, 1e-6));
    return Curve{params.name, params.role, std::move(arc), {}};
  }
  if (!params.points.empty()) return lacking(params, "is an arc: give its first and last point, two in all");
  if (!params.radius || !params.start || !params.sweep) {
    return lacking(params, "needs two `points`, or `radius`, `start` and `sweep`");
  }
  DOBRA_TRY(Arc arc, Arc::from_angles(*params.centre, *params.radius, *params.start, *params.sweep));
  return Curve{params.name, params.role, std::move(arc), {}};
}

Result<Curve> make_circle(const CurveParams& params) {
  if (!params.centre) return lacking(params, "needs `centre`");
  if (!params.radius) return lacking(params, "needs `radius`");
  const auto orientation = params.turning == Turning::Anticlockwise ? Orientation::Anticlockwise : Orientation::Clockwise;
  DOBRA_TRY(Arc arc, Arc::circle(*params.centre, *params.radius, orientation));
  return Curve{params.name, params.role, std::move(arc), {}};
}

Result<Curve> make_curve(const CurveParams& params) {
  const auto made = [&]() -> Result<Curve> {
    switch (params.kind) {
      case CurveKind::Arc: return make_arc(params);
      case CurveKind::Circle: return make_circle(params);
      case CurveKind::Line:
      case CurveKind::Polygon: break;
    }
    return make_line(params);
  };
  DOBRA_TRY(Curve curve, made());
  curve.division = {params.segments, params.size, params.ratio};
  return curve;
}

Result<void> check_names(const std::vector<Curve>& curves, const std::vector<Place>& places) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (!names.insert(curves[i].name).second) {
      return Error{ErrorCode::BadValue, fmt::format("two curves are called '{}'; names must differ", curves[i].name), places[i]};
    }
  }
  return {};
}

/// The segments of a file joined into chains wherever just two with the same marker meet.
class Chains {
 public:
  explicit Chains(const dobra::io::PolyFile& file) : file_(file), used_(file.segments.size(), false) {
    for (std::size_t i = 0; i < file.segments.size(); ++i) {
      for (const std::uint32_t node : file.segments[i]) at_[node].push_back(i);
    }
  }

  std::vector<Curve> curves() {
    std::vector<Curve> result;
    // Chains with ends first, so that what is left over is closed.
    for (std::size_t i = 0; i < file_.segments.size(); ++i) {
      for (const std::uint32_t node : file_.segments[i]) {
        if (!used_[i] && !goes_on(node, i)) result.push_back(follow(i, node, result.size()));
      }
    }
    for (std::size_t i = 0; i < file_.segments.size(); ++i) {
      if (!used_[i]) result.push_back(follow(i, file_.segments[i][0], result.size()));
    }
    return result;
  }

 private:
  [[nodiscard]] std::int64_t marker(std::size_t segment) const {
    return file_.segment_markers.empty() ? 0 : file_.segment_markers[segment];
  }

  /// The other segment of the chain at `node`, if the chain goes on there.
  [[nodiscard]] std::optional<std::size_t> goes_on(std::uint32_t node, std::size_t segment) const {
    const auto& meeting = at_.at(node);
    if (meeting.size() != 2) return std::nullopt;
    const std::size_t other = meeting[0] == segment ? meeting[1] : meeting[0];
    if (marker(other) != marker(segment)) return std::nullopt;
    return other;
  }

  Curve follow(std::size_t segment, std::uint32_t node, std::size_t number) {
    Polyline line;
    const std::uint32_t first = node;
    line.points.push_back(file_.nodes.points[node]);
    for (std::optional<std::size_t> next = segment; next && !used_[*next];) {
      segment = *next;
      used_[segment] = true;
      const auto& nodes = file_.segments[segment];
      node = nodes[0] == node ? nodes[1] : nodes[0];
      line.points.push_back(file_.nodes.points[node]);
      next = goes_on(node, segment);
    }
    if (node == first) {
      line.closed = true;
      line.points.pop_back();
    }
    return {fmt::format("curve_{}_marker_{}", number + 1, marker(segment)), Role::Boundary, std::move(line), {}};
  }

  const dobra::io::PolyFile& file_;
  std::vector<bool> used_;
  std::map<std::uint32_t, std::vector<std::size_t>> at_;
};

/// Number of the innermost contour that holds p; nothing if none does.
std::optional<std::size_t> innermost(const Domain& domain, const std::vector<Polyline>& contours, Point p) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (found && domain.loops[*found].depth > domain.loops[i].depth) continue;
    if (locate(contours[i], p) == dobra::geom::Side::Inside) found = i;
  }
  return found;
}

/// In a .poly file a loop inside a loop is a hole only where a hole point says so; else it divides material from material.
Result<void> apply_holes(std::vector<Curve>& curves, const dobra::io::PolyFile& file, const Place& place) {
  DOBRA_TRY(const Domain domain, make_domain(curves, std::vector<Place>(curves.size(), place)));
  std::vector<Polyline> contours;
  for (const auto& loop : domain.loops) contours.push_back(contour(domain, loop));
  std::vector<bool> is_void(domain.loops.size(), false);
  for (const Point hole : file.holes) {
    const auto loop = innermost(domain, contours, hole);
    if (!loop) {
      Place at = place;
      at.x = hole.x;
      at.y = hole.y;
      return Error{ErrorCode::OutsideDomain, "a hole point lies outside every loop; move it inside or remove it", at};
    }
    is_void[*loop] = true;
  }
  for (std::size_t i = 0; i < domain.loops.size(); ++i) {
    bool surrounded_by_void = true;
    int depth = -1;
    for (std::size_t j = 0; j < domain.loops.size(); ++j) {
      if (j == i || domain.loops[j].depth >= domain.loops[i].depth || domain.loops[j].depth < depth) continue;
      if (locate(contours[j], contours[i].points.front()) != dobra::geom::Side::Inside) continue;
      depth = domain.loops[j].depth;
      surrounded_by_void = is_void[j];
    }
    if (surrounded_by_void != is_void[i]) continue;
    for (const auto& side : domain.loops[i].sides) curves[side.curve].role = Role::Internal;
  }
  return {};
}

}  // namespace

Result<Model> read_input(const InputParams& params, const dobra::scenario::Table& table,
                         const dobra::scenario::Context& context) {
  std::vector<Curve> curves;
  std::vector<Place> places;
  if (!params.file.empty()) {
    const std::string path = (context.folder / params.file).string();
    DOBRA_TRY(const dobra::io::PolyFile file, dobra::io::read_poly(path));
    curves = Chains(file).curves();
    Place place;
    place.file = path;
    places.assign(curves.size(), place);
    if (!curves.empty()) DOBRA_TRY_VOID(apply_holes(curves, file, place));
  }
  const auto* rows = table.find("curve");
  for (std::size_t i = 0; i < params.curves.size(); ++i) {
    const Place& place = std::get<std::vector<dobra::scenario::Table>>(*rows)[i].own_place;
    auto curve = make_curve(params.curves[i]);
    if (!curve) {
      Place named = place;
      named.item = fmt::format("curve '{}'", params.curves[i].name);
      return located(curve.error(), named);
    }
    curves.push_back(*std::move(curve));
    places.push_back(place);
  }
  DOBRA_TRY_VOID(check_names(curves, places));
  Model model;
  DOBRA_TRY(model.domain, make_domain(std::move(curves), places, {params.join_tolerance}));
  return model;
}

}  // namespace quebra::core
