// What J, G and K at a tip have to say to each other.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/fem/fracture/crack.h"

namespace dobra::fem::fracture {
namespace {

/// K below this share of T sqrt(size of the elements) says nothing.
constexpr double no_k = 0.01;

}  // namespace

void compare_figures(const TipFrame& frame, TipResult& result) {
  const std::string of = fmt::format("crack tip '{}' at ({:.6g}, {:.6g}): ", frame.tip.name, frame.at.x, frame.at.y);
  const Contour& contour = result.contour;
  if (contour.outer > frame.acted.clear) {
    result.no_j = fmt::format(
        "J is not given: its ring of radius {:.4g} m runs through elements at ({:.6g}, {:.6g}), {:.4g} m from the tip, "
        "where a force or support acts on a single node and the energy is infinite",
        contour.outer, frame.acted.at.x, frame.acted.at.y, frame.acted.distance);
    result.remarks.push_back(
        of + *result.no_j +
        fmt::format("; G stands for it, or mesh with tip_radius = {:.2g} m and elements as small beside the force",
                    frame.acted.distance / 40.0));
  }
  // A crack along the tension has no K but noise.
  const Intensity& k = result.domain.k;
  if (std::hypot(k.one, k.two) <= no_k * std::abs(result.domain.t_stress) * std::sqrt(frame.length)) return;
  const double apart = result.release > 0.0 ? std::abs(result.domain.j / result.release - 1.0) : 0.0;
  const bool j_parts = !result.no_j && apart > most_apart;
  if (!j_parts && !(result.spread.value_or(0.0) > most_apart)) return;
  std::string text = fmt::format("the figures part by more than {:.0f} %:", 100.0 * most_apart);
  if (j_parts) text += fmt::format(" J is {:.4g} J/m2 and G {:.4g} J/m2;", result.domain.j, result.release);
  const auto add = [&](const char* method, const Intensity& own) {
    text += fmt::format(" K_I {:.4g} Pa sqrt(m), K_II {:.4g} Pa sqrt(m) by {};", own.one, own.two, method);
  };
  add("the interaction integral", k);
  if (result.closure) add("crack closure", *result.closure);
  if (result.correlation) add("displacement correlation", *result.correlation);
  const double room = std::min(frame.room, frame.acted.distance);
  text += fmt::format(" the tip's elements are {:.3g} m long, in a room of {:.3g} m: ", frame.length, room);
  text += frame.quarter ? fmt::format("try tip_radius = {:.2g} m, and smaller elements round it",
                                      std::min(0.5 * frame.length, room / 80.0))
                        : std::string("mesh with rosettes = \"yes\" and order = \"2\"");
  result.remarks.push_back(of + text);
}

}  // namespace dobra::fem::fracture
