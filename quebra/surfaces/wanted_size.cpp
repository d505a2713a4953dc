#include "quebra/surfaces/wanted_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "quebra/meshing/size_source.h"
#include "shared/base/formula.h"
#include "shared/surf/trim/finding.h"
#include "shared/surf/trim/rings.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Point3;
using surf::trim::TrimmedSurface;

using meshing::is_size;
using meshing::no_size;

namespace {
constexpr const char* whose = "size_formula";
}  // namespace

struct WantedSize::State {
  base::Formula formula;
  std::optional<geom::Vector> units;
  std::vector<surf::trim::Ring> rings = {};  ///< Of the face that is meshed.
  std::optional<Error> fault = std::nullopt;

  [[nodiscard]] double at(Point uv, Point3 p) const {
    const std::array<double, 5> values{p.x, p.y, p.z, units ? uv.x / units->x : 0.0, units ? uv.y / units->y : 0.0};
    return formula.at(std::span<const double>(values).first(units ? 5 : 3));
  }
  [[nodiscard]] bool meant(Point uv) const {
    const std::vector<double> at = surf::trim::meets(rings, uv.y);
    return std::count_if(at.begin(), at.end(), [&](double u) { return u < uv.x; }) % 2 == 1;
  }
  double asked(Point uv, Point3 p) {
    const double value = at(uv, p);
    if (!is_size(value) && !fault && meant(uv))
      fault = no_size(whose, value, {.x = p.x, .y = p.y, .z = p.z, .u = uv.x, .v = uv.y});
    return value;
  }
};

Result<WantedSize> WantedSize::make(const std::string& text, const std::optional<geom::Vector>& units) {
  std::vector<std::string> names{"x", "y", "z"};
  if (units) names.insert(names.end(), {"u", "v"});
  auto formula = base::Formula::make(text, names, {.called = whose, .whole = {}, .begin = 0});
  if (!formula) {
    Error error = formula.error();
    if (!units) error.message += "; u and v are known where one face is meshed that touches no pole";
    return error;
  }
  WantedSize made;
  made.state_ = std::make_shared<State>(State{*std::move(formula), units});
  return made;
}

std::function<double(Point, Point3)> WantedSize::function() const {
  return [state = state_](Point uv, Point3 at) { return state->asked(uv, at); };
}

void WantedSize::enter(const TrimmedSurface& face) { state_->rings = surf::trim::rings_of(face); }

Result<void> WantedSize::on_border(const TrimmedSurface& face) const {
  constexpr int places = 64;
  for (const auto& loop : face.loops) {
    for (const auto& edge : loop.edges) {
      for (int i = 0; i <= places; ++i) {
        const Point uv = edge.at(std::lerp(edge.from, edge.to, static_cast<double>(i) / places));
        const double value = state_->at(uv, face.surface.at(uv));
        if (!is_size(value)) return no_size(whose, value, surf::trim::place_of(face.surface, uv));
      }
    }
  }
  return {};
}

Result<void> WantedSize::inside() const {
  if (state_->fault) return *state_->fault;
  return {};
}

}  // namespace quebra::surfaces
