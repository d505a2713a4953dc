#include "quebra/meshing/half_crack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "quebra/domain/domain.h"
#include "quebra/domain/selection.h"

namespace quebra::meshing {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::fem::fracture::RosetteHalf;
using dobra::geom::Point;
using dobra::geom::Vector;

/// Sine of the angle between curves that go straight on.
constexpr double same_direction = 1e-6;

bool on_boundary(const sketch::Curve& curve) {
  return curve.role == sketch::Role::Boundary || curve.role == sketch::Role::Hole;
}

/// The boundary curve that goes on from `at` in the direction `ahead`.
std::optional<std::size_t> curve_ahead(const domain::Domain& domain, std::size_t own, Point at, Vector ahead) {
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    const sketch::Curve& curve = domain.curves[c];
    if (c == own || !on_boundary(curve)) continue;
    const double all = length(curve);
    for (const double s : {0.0, all}) {
      const Vector away = s == 0.0 ? direction(curve, 0.0) : -direction(curve, all);
      if (point(curve, s) == at && dot(away, ahead) > 0.0 && std::abs(cross(away, ahead)) < same_direction) return c;
    }
  }
  return std::nullopt;
}

}  // namespace

Result<model::Model> add_half_crack(const model::Model& model, const HalfCrackParams& params,
                                    const dobra::scenario::Context&, const dobra::base::Progress&) {
  const domain::Domain& domain = model.domain;
  std::vector<std::string> names;
  for (const sketch::Curve& curve : domain.curves) {
    if (on_boundary(curve)) names.push_back(curve.name);
  }
  const auto lip = std::find_if(domain.curves.begin(), domain.curves.end(), [&](const sketch::Curve& curve) {
    return curve.name == params.lip && on_boundary(curve);
  });
  if (lip == domain.curves.end())
    return Error{ErrorCode::BadValue, fmt::format("there is no curve '{}' on the boundary{}", params.lip,
                                                  domain::what_there_is(params.lip, names))};
  const auto own = static_cast<std::size_t>(lip - domain.curves.begin());
  const double all = length(*lip);
  const domain::Inside inside(domain);
  model::Model result = model;
  const std::size_t before = result.half_tips.size();
  for (const bool end : {false, true}) {
    const Point at = point(*lip, end ? all : 0.0);
    const Vector ahead = end ? direction(*lip, all) : -direction(*lip, 0.0);
    const auto next = curve_ahead(domain, own, at, ahead);
    if (!next) continue;
    const double step = 1e-3 * std::min(all, length(domain.curves[*next]));
    const RosetteHalf half = inside(at + step * left_of(ahead)) ? RosetteHalf::Left : RosetteHalf::Right;
    result.half_tips.push_back({lip->name + (end ? "_end" : "_start"), own, *next, at, ahead, half});
  }
  if (result.half_tips.size() == before) {
    const Point at = point(*lip, 0.5 * all);
    return Error{ErrorCode::BadValue,
                 "the boundary goes straight on at neither end; draw the line of symmetry ahead of the tip as a curve "
                 "of its own",
                 Place{.item = "curve '" + lip->name + "'", .x = at.x, .y = at.y}};
  }
  return result;
}

Result<void> name_half_tips(dobra::mesh::ElementMesh& mesh, const std::vector<model::HalfTip>& tips) {
  for (const model::HalfTip& tip : tips) {
    const auto found = std::find(mesh.points.begin(), mesh.points.end(), tip.at);
    if (found == mesh.points.end())
      return Error{ErrorCode::BadCrack, "the mesh has no node at the tip",
                   Place{.item = "crack tip '" + tip.name + "'", .x = tip.at.x, .y = tip.at.y}};
    const dobra::mesh::NodeId node(static_cast<std::size_t>(found - mesh.points.begin()));
    mesh.tips.push_back({tip.name, node, tip.ahead});
    mesh.node_sets[tip.name] = {node};
  }
  return {};
}

}  // namespace quebra::meshing
