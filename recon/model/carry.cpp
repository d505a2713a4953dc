#include "recon/model/carry.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/input/input.h"
#include "shared/geom/place.h"

namespace recon::model {

namespace {

/// Beyond this part of the line's and its image's box the way back counts as another way.
constexpr double return_tolerance = 1e-9;

geom::Point through(const std::vector<const Stage*>& chain, std::size_t from, std::size_t to, geom::Point p) {
  for (; from < to; ++from) p = forward(*chain[from], p);
  for (; from > to; --from) p = inverse(*chain[from - 1], p);
  return p;
}

base::Result<std::size_t> state_of(int number, std::size_t restored, const char* key) {
  if (number >= 0 && static_cast<std::size_t>(number) <= restored) return static_cast<std::size_t>(number);
  return base::Error{
      base::ErrorCode::BadValue,
      fmt::format("{} = {}: the section has been restored or moved {} times, so take a state from 0 to {}", key, number,
                  restored, restored)};
}

CarriedLine carried_line(const std::vector<const Stage*>& chain, const CarriedLines& states, geom::Polyline line) {
  if (line.points.size() > 3 && line.points.front() == line.points.back()) {
    line.points.pop_back();
    line.closed = true;
  }
  CarriedLine carried;
  for (const geom::Point p : line.points) carried.points.push_back(carry(chain, states.from, states.to, p));
  carried.after = line.points.size() < 2 ? geom::Polyline{{carried.points.front().at}, false}
                                         : carry(chain, states.from, states.to, line);
  carried.before = std::move(line);
  return carried;
}

/// What is not to be taken for certain of a line.
void remark_on(const CarriedLine& line, std::vector<std::string>& remarks) {
  const auto worst = std::max_element(line.points.begin(), line.points.end(),
                                      [](const CarriedPoint& a, const CarriedPoint& b) { return a.misses < b.misses; });
  const double size = std::max(line.before.box().diagonal(), line.after.box().diagonal()) +
                      geom::distance(line.before.points.front(), {});
  if (worst->misses <= return_tolerance * size) return;
  const auto count = std::count_if(line.points.begin(), line.points.end(),
                                   [&](const CarriedPoint& p) { return p.misses > return_tolerance * size; });
  const geom::Point at = line.before.points[static_cast<std::size_t>(worst - line.points.begin())];
  remarks.push_back(fmt::format(
      "points are carried where a map is not single-valued ({}): the way back misses them, most {} by {:.4g} m", count,
      at, worst->misses));
}

const section::Section& section_of(const std::vector<const Stage*>& chain, std::size_t state) {
  return state < chain.size() ? chain[state]->section : section_made(*chain.back());
}

/// Beyond the section nothing but the straight continuation of its grid tells where a point goes.
void remark_outside(const CarriedLine& line, const section::Section& section, std::vector<std::string>& remarks) {
  const geom::Box box = box_of(section);
  const auto outside = [&](geom::Point p) {
    return p.x < box.low.x || p.x > box.high.x || p.y < box.low.y || p.y > box.high.y;
  };
  const std::vector<geom::Point>& points = line.before.points;
  const auto first = std::find_if(points.begin(), points.end(), outside);
  if (first == points.end()) return;
  remarks.push_back(fmt::format("points that are carried lie outside the section ({}), the first at {}",
                                std::count_if(points.begin(), points.end(), outside), *first));
}

}  // namespace

CarriedPoint carry(const std::vector<const Stage*>& chain, std::size_t from, std::size_t to, geom::Point p) {
  const geom::Point at = through(chain, from, to, p);
  return {at, geom::distance(through(chain, to, from, at), p)};
}

geom::Polyline carry(const std::vector<const Stage*>& chain, std::size_t from, std::size_t to, geom::Polyline line) {
  for (; from < to; ++from) line = forward(*chain[from], line);
  for (; from > to; --from) line = inverse(*chain[from - 1], line);
  return line;
}

base::Result<CarriedLines> carry_lines(const std::vector<const Stage*>& chain, const CarryParams& params,
                                       const dobra::scenario::Context& context) {
  CarriedLines carried;
  DOBRA_TRY(carried.from, state_of(params.from, chain.size(), "from"));
  DOBRA_TRY(carried.to, params.to ? state_of(*params.to, chain.size(), "to") : base::Result(chain.size()));
  if (carried.from == carried.to) {
    return base::Error{base::ErrorCode::BadValue,
                       fmt::format("from and to are both state {}; nothing lies between them", carried.from)};
  }
  input::HorizonInput input;
  input.name = "line";
  input.file = params.file;
  input.feature = params.feature;
  input.points = params.points;
  const section::Convention convention =
      params.file.empty() ? section::Convention{} : chain.front()->section.convention;
  if (params.file.empty() && (params.points.size() == 1 || params.as == CarryAs::Points)) {
    for (const geom::Point p : params.points) carried.lines.push_back(carried_line(chain, carried, {{p}, false}));
  } else {
    DOBRA_TRY(input::ReadPieces read, read_pieces(input, {.convention = convention}, context));
    carried.remarks = std::move(read.remarks);
    for (geom::Polyline& piece : read.pieces) carried.lines.push_back(carried_line(chain, carried, std::move(piece)));
  }
  for (const CarriedLine& line : carried.lines) {
    remark_on(line, carried.remarks);
    remark_outside(line, section_of(chain, carried.from), carried.remarks);
  }
  return carried;
}

}  // namespace recon::model
