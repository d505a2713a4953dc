#include "recon/maps/ruled_map.h"

namespace recon::maps {

RuledMap::RuledMap(std::vector<RuledLine> lines, const MapOptions& options) {
  DOBRA_CHECK(lines.size() >= 2);
  geom::Box from_box;
  geom::Box to_box;
  std::vector<std::vector<double>> places;
  std::vector<std::vector<geom::Point>> from;
  std::vector<std::vector<geom::Point>> to;
  for (RuledLine& line : lines) {
    from_box.add(geom::box_of(line.from));
    to_box.add(geom::box_of(line.to));
    places.push_back(std::move(line.u));
    from.push_back(std::move(line.from));
    to.push_back(std::move(line.to));
  }
  tolerances_ = tolerances_for(from_box, to_box, options);
  const double by = from_box.diagonal() + to_box.diagonal();
  const auto rulings = std::make_shared<const Rulings>(std::move(places));
  from_ = std::make_shared<const RuledStack>(rulings, std::move(from), by, tolerances_.side);
  to_ = std::make_shared<const RuledStack>(rulings, std::move(to), by, tolerances_.side);
}

RuledMap RuledMap::swapped() const {
  RuledMap back = *this;
  std::swap(back.from_, back.to_);
  return back;
}

Carried RuledMap::carry(const Entered& at, geom::Point p) {
  const StripPlace place = RuledStack::place_in(at.from, p);
  return {{ColumnId(at.cell.first), place.across, static_cast<double>(at.cell.second) + place.down},
          RuledStack::point_at(at.to, place)};
}

geom::Point RuledMap::across(const RuledStack& from, const RuledStack& to, geom::Point p, Hint& hint) {
  from.locate(p, hint);
  return RuledStack::point_at(to.strip(hint.cell), RuledStack::place_in(hint.at, p));
}

}  // namespace recon::maps
