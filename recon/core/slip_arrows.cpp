#include "recon/core/slip_arrows.h"

#include "recon/core/section_picture.h"
#include "shared/base/text.h"

namespace recon::core {
namespace {

// Parts of the section's size.
constexpr double length_of_arrow = 0.05;
constexpr double away_from_fault = 0.009;
// Parts of the arrow's length.
constexpr double barb_back = 0.3;
constexpr double barb_aside = 0.17;

/// From its tail over its head to the end of its one barb.
geom::Polyline half_arrow(geom::Point middle, geom::Vector along, geom::Vector aside) {
  const geom::Point head = middle + 0.5 * along;
  const double length = geom::length(along);
  return {{middle + -0.5 * along, head, head + -barb_back * along + barb_aside * length * aside}, false};
}

}  // namespace

dobra::scene::Layer slip_arrows(const std::string& key, const faults::Fault& fault, SlipSign sign, double size) {
  const double middle = 0.5 * (fault.own_from + fault.own_to);
  const double length = std::min(length_of_arrow * size, 0.8 * (fault.own_to - fault.own_from));
  const geom::Point from = kinematics::point_at(fault.path, middle - 0.5 * length);
  const geom::Point to = kinematics::point_at(fault.path, middle + 0.5 * length);
  const geom::Vector up = normalised(to - from);
  const geom::Vector left{-up.y, up.x};
  const geom::Vector aside = fault.path.hanging == kinematics::Side::Left ? left : -left;
  const geom::Vector along = (sign == SlipSign::Up ? length : -length) * up;
  const geom::Point centre = from + 0.5 * (to - from);
  const double off = away_from_fault * size;
  dobra::scene::Style style;
  style.line = ink;
  style.line_width = 1.3;
  dobra::scene::Layer layer =
      lines_layer(key, base::translated("Slip"), style,
                  {half_arrow(centre + off * aside, along, aside), half_arrow(centre + -off * aside, -along, -aside)});
  layer.in_legend = dobra::scene::InLegend::No;
  return layer;
}

}  // namespace recon::core
