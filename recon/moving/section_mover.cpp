#include "recon/moving/section_mover.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/balance/percent.h"
#include "recon/moving/piece_names.h"
#include "recon/section/section_faces.h"
#include "shared/base/parallel.h"
#include "shared/geom/place.h"
#include "shared/topo/region.h"

namespace recon::moving {

namespace {

using section::Section;

/// One line after the move: in its parts.
struct Image {
  std::vector<LinePart> parts;  ///< Before.
  std::vector<geom::Polyline> after;
  [[nodiscard]] bool moved(std::size_t part) const { return !(after[part] == parts[part].line); }
};

/// Whether lines that a tip has passed are cut where the fault is now.
enum class Cutting { None, ByTip };

Image image_of(const Moved& moved, const std::vector<LinePart>& parts, Cutting cutting) {
  Image image;
  for (const LinePart& part : parts) {
    geom::Polyline after = moved.before.image(part, moved.motion.map);
    std::vector<LinePart> cut{{after, part.fate}};
    if (cutting == Cutting::ByTip && moved.motion.map.tip() && !(after == part.line)) cut = moved.after.split(after);
    for (LinePart& one : cut) {
      image.parts.push_back(part);
      if (&one != &cut.front()) image.parts.back().trimmed = 0.0;
      image.after.push_back(std::move(one.line));
    }
  }
  return image;
}

/// The item becomes its first part; the others stand at the end, with names of their own.
/// @param place  sets the line of an item.
template <class Item, class SetLine>
void put(const Image& image, const char* kind, std::size_t index, PieceNames& names, std::vector<Item>& items,
         SetLine set_line, std::vector<MovedPiece>& pieces) {
  const bool cut = image.parts.size() > 1;
  const std::string whole = items[index].piece_of.empty() ? items[index].name : items[index].piece_of;
  for (std::size_t k = 0; k < image.parts.size(); ++k) {
    const bool first = k == 0;
    if (!first) items.push_back(items[index]);
    Item& item = first ? items[index] : items.back();
    if (cut && (!first || item.piece_of.empty())) item.name = names.next(whole);
    if (cut) item.piece_of = whole;
    if (!first) item.id = decltype(item.id)(names.next_id());
    set_line(item, image.after[k]);
    if (image.moved(k)) pieces.push_back({item.name, kind, image.after[k]});
  }
}

void remark_on_trims(const Image& image, const std::string& item, std::vector<std::string>& remarks) {
  for (const LinePart& part : image.parts) {
    if (part.trimmed > 0.0)
      remarks.push_back(fmt::format("{}: {:.4g} m that reached across the fault were cut off", item, part.trimmed));
  }
}

void move_horizons(const Section& section, double overshoot, Moved& moved) {
  const auto images = base::parallel_map<Image>(section.horizons.size(), [&](std::size_t i) {
    return image_of(moved, moved.before.split(section.horizons[i].line, overshoot), Cutting::ByTip);
  });
  PieceNames names(section.horizons);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const section::Horizon& horizon = section.horizons[i];
    moved.lengths.push_back(balance::line_length(horizon, images[i].after));
    remark_on_trims(images[i], fmt::format("horizon '{}'", horizon.name), moved.remarks);
    put(
        images[i], horizon.role == section::BedRole::Growth ? "growth" : "horizon", i, names, moved.section.horizons,
        [](section::Horizon& item, const geom::Polyline& line) {
          item.line = line.points.front().x > line.points.back().x ? geom::reversed(line) : line;
        },
        moved.pieces);
  }
}

/// Other faults, pins, topography, loose and eroded lines; a datum stays.
void move_other_lines(const Section& section, const std::vector<section::LineId>& fault, double overshoot,
                      Moved& moved) {
  PieceNames names(section.lines);
  for (std::size_t i = 0; i < section.lines.size(); ++i) {
    const section::SectionLine& line = section.lines[i];
    if (line.kind == section::LineKind::Datum || std::find(fault.begin(), fault.end(), line.id) != fault.end())
      continue;
    const Image image = image_of(moved, moved.before.split(line.line, overshoot), Cutting::ByTip);
    remark_on_trims(image, fmt::format("{} '{}'", kind_name(line.kind), line.name), moved.remarks);
    put(
        image, kind_name(line.kind), i, names, moved.section.lines,
        [](section::SectionLine& item, const geom::Polyline& after) { item.line = after; }, moved.pieces);
  }
}

balance::UnitRow unit_row(const std::string& name, double before, double after) {
  balance::UnitRow row;
  row.name = name;
  row.area_before = before;
  row.area_after = after;
  row.change_percent = balance::percent(after - before, before);
  return row;
}

double area_of(const std::vector<geom::Polyline>& contours) {
  double area = 0.0;
  for (const geom::Polyline& contour : contours) area += geom::signed_area(contour);
  return area;
}

base::Result<void> move_polygons(const Section& section, Moved& moved) {
  PieceNames names(section.units);
  for (std::size_t i = 0; i < section.units.size(); ++i) {
    const section::Unit& unit = section.units[i];
    DOBRA_TRY(std::vector<LinePart> parts, moved.before.split_area(unit.contour));
    const Image image = image_of(moved, parts, Cutting::None);
    moved.units.push_back(unit_row(unit.name, geom::signed_area(unit.contour), area_of(image.after)));
    put(
        image, "unit", i, names, moved.section.units,
        [](section::Unit& item, const geom::Polyline& contour) { item.contour = contour; }, moved.pieces);
  }
  return {};
}

/// Without polygons: what lies between horizons.
base::Result<void> measure_rock_units(const Section& section, Moved& moved) {
  if (!section.units.empty() || !section.faces) return {};
  for (const section::RockUnit& unit : section.faces->units) {
    double after = 0.0;
    for (const geom::Polyline& contour : unit.contours) {
      const bool hole = geom::signed_area(contour) < 0.0;
      DOBRA_TRY(std::vector<LinePart> parts, moved.before.split_area(hole ? geom::reversed(contour) : contour));
      after += (hole ? -1.0 : 1.0) * area_of(image_of(moved, parts, Cutting::None).after);
    }
    moved.units.push_back(unit_row(unit.name, unit.area, after));
  }
  return {};
}

void move_markers(Moved& moved) {
  for (section::Marker& marker : moved.section.markers) {
    const std::vector<geom::Point> points = marker.points;
    for (geom::Point& p : marker.points) p = moved.before.image(p, moved.motion.map);
    if (marker.points != points) moved.pieces.push_back({marker.name, "marker", {marker.points, false}});
  }
  for (section::BlockName& block : moved.section.block_names) block.at = moved.before.image(block.at, moved.motion.map);
}

/// The border of what moved and what stayed together.
base::Result<void> move_border(Moved& moved) {
  if (!moved.section.border) return {};
  DOBRA_TRY(std::vector<LinePart> parts, moved.before.split_area(*moved.section.border));
  const Image image = image_of(moved, parts, Cutting::None);
  DOBRA_TRY(std::vector<geom::Polyline> contours, topo::region(image.after, topo::Inside::Positive));
  const auto larger = [](const auto& a, const auto& b) { return geom::signed_area(a) < geom::signed_area(b); };
  const auto outer = std::max_element(contours.begin(), contours.end(), larger);
  if (outer == contours.end()) return {};
  if (contours.size() > 1) {
    moved.remarks.push_back(
        fmt::format("the border of the section falls into {} rings after the move; the largest is taken, from {} on",
                    contours.size(), outer->points.front()));
  }
  moved.section.border = std::move(*outer);
  return {};
}

}  // namespace

base::Result<void> move_lines(const Section& section, const std::vector<section::LineId>& fault, double overshoot,
                              Moved& moved) {
  moved.section = section;
  moved.section.faces.reset();
  move_horizons(section, overshoot, moved);
  move_other_lines(section, fault, overshoot, moved);
  DOBRA_TRY_VOID(move_polygons(section, moved));
  DOBRA_TRY_VOID(measure_rock_units(section, moved));
  move_markers(moved);
  DOBRA_TRY_VOID(move_border(moved));
  if (!section.backdrops.empty()) {
    moved.remarks.push_back("pictures behind the section do not move; they show it as it was");
  }
  return {};
}

}  // namespace recon::moving
