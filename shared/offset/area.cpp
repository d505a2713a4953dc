#include "shared/offset/area_parts.h"

#include <algorithm>
#include <cmath>

#include "shared/topo/region.h"

namespace dobra::offset {

using base::Result;
using geom::Polyline;

namespace {

std::size_t point_count(std::span<const Polyline> rings) {
  std::size_t count = 0;
  for (const Polyline& ring : rings) count += ring.points.size();
  return count;
}

/// The rings as polygons. What they enclose and how long they are is known for the case that they do not meet.
Result<Area> arranged(std::vector<Polyline> rings, double area, double length, const base::Progress& progress) {
  if (rings.empty()) return Area{};
  DOBRA_TRY(std::vector<Polyline> parted, topo::region(rings, topo::Inside::Positive, progress));
  const bool untouched = parted.size() == rings.size() && point_count(parted) == point_count(rings);
  Area made = measured(std::move(parted));
  if (untouched) made.area = area, made.length = length;
  return made;
}

bool is_one_contour(std::span<const Polyline> rings) { return rings.size() == 1 && geom::signed_area(rings[0]) > 0.0; }

/// Distances of one sign, given without it.
Result<std::vector<Area>> grown_to(std::span<const Polyline> polygon, Side side, std::span<const double> distances,
                                   const AreaOptions& options, const base::Progress& progress) {
  const OffsetOptions settings{.side = side, .join = options.join, .mitre_limit = options.mitre_limit};
  std::vector<Area> all(distances.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double count = static_cast<double>(polygon.size());
    const base::Progress part = progress.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    DOBRA_TRY(std::vector<Area> made, beside(polygon[i], settings, distances, options, part));
    for (std::size_t k = 0; k < distances.size(); ++k) {
      std::move(made[k].rings.begin(), made[k].rings.end(), std::back_inserter(all[k].rings));
      all[k].area += made[k].area;
      all[k].length += made[k].length;
    }
  }
  for (Area& area : all) {
    if (is_one_contour(area.rings)) continue;
    DOBRA_TRY(area, arranged(std::move(area.rings), area.area, area.length, progress));
  }
  return all;
}

geom::Box box_of(const Area& area) {
  geom::Box box;
  for (const Polyline& ring : area.rings) box.add(ring.box());
  return box;
}

}  // namespace

Area measured(std::vector<Polyline> rings) {
  Area made{std::move(rings)};
  for (const Polyline& ring : made.rings) {
    made.area += geom::signed_area(ring);
    made.length += geom::length(ring);
  }
  return made;
}

Result<std::vector<Area>> beside(const Polyline& ring, const OffsetOptions& settings, std::span<const double> distances,
                                 const AreaOptions& options, const base::Progress& progress) {
  DOBRA_TRY(const std::vector<OffsetCurve> curves, offset(ring, distances, settings, progress));
  if (options.judge) DOBRA_TRY_VOID(options.judge(ring, settings, curves));
  std::vector<Area> made(curves.size());
  for (std::size_t k = 0; k < curves.size(); ++k) {
    std::vector<Polyline>& rings = made[k].rings;
    for (const OffsetPiece& piece : curves[k].pieces) {
      made[k].area += signed_area(piece, ring);
      made[k].length += length(piece, ring);
      rings.push_back(chords(piece, ring, options.arc_tolerance).polyline);
    }
    std::stable_partition(rings.begin(), rings.end(), [](const Polyline& r) { return geom::signed_area(r) > 0.0; });
  }
  return made;
}

Result<std::vector<Area>> grown(std::span<const Polyline> polygon, std::span<const double> distances,
                                const AreaOptions& options, const base::Progress& progress) {
  std::vector<Area> all(distances.size());
  for (const Side side : {Side::RightOfTravel, Side::LeftOfTravel}) {
    std::vector<double> wanted;
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < distances.size(); ++k) {
      if ((distances[k] < 0.0) != (side == Side::LeftOfTravel)) continue;
      wanted.push_back(std::abs(distances[k]));
      places.push_back(k);
    }
    if (wanted.empty()) continue;
    DOBRA_TRY(std::vector<Area> made, grown_to(polygon, side, wanted, options, progress));
    for (std::size_t k = 0; k < made.size(); ++k) all[places[k]] = std::move(made[k]);
  }
  return all;
}

Result<std::vector<Area>> around_polygon(std::span<const Polyline> polygon, std::span<const double> distances,
                                         const AreaOptions& options, const base::Progress& progress) {
  DOBRA_TRY(std::vector<Area> outer, grown_to(polygon, Side::RightOfTravel, distances, options, progress.part(0, 0.5)));
  DOBRA_TRY(const std::vector<Area> inner,
            grown_to(polygon, Side::LeftOfTravel, distances, options, progress.part(0.5, 1)));
  for (std::size_t k = 0; k < outer.size(); ++k) {
    Area& band = outer[k];
    for (const Polyline& ring : inner[k].rings) band.rings.push_back(geom::reversed(ring));
    DOBRA_TRY(band,
              arranged(std::move(band.rings), band.area - inner[k].area, band.length + inner[k].length, progress));
  }
  return outer;
}

Result<Area> joined(std::span<const Area> areas, const base::Progress& progress) {
  Area all;
  std::vector<geom::Box> boxes;
  bool apart = true;
  for (const Area& area : areas) {
    DOBRA_TRY_VOID(progress.check());
    if (area.rings.empty()) continue;
    const geom::Box box = box_of(area);
    for (const geom::Box& other : boxes) apart = apart && !other.overlaps(box);
    if (apart) boxes.push_back(box);
    all.rings.insert(all.rings.end(), area.rings.begin(), area.rings.end());
    all.area += area.area;
    all.length += area.length;
  }
  if (apart) return all;
  return arranged(std::move(all.rings), all.area, all.length, progress);
}

std::vector<std::vector<Polyline>> polygons_of(std::span<const Polyline> rings) {
  std::vector<std::vector<Polyline>> polygons;
  for (const Polyline& ring : rings) {
    if (polygons.empty() || geom::signed_area(ring) > 0.0) polygons.emplace_back();
    polygons.back().push_back(ring);
  }
  return polygons;
}

Result<std::vector<std::vector<Polyline>>> mended(std::span<const Polyline> polygon, const base::Progress& progress) {
  const std::vector<std::vector<Polyline>> as_given{{polygon.begin(), polygon.end()}};
  if (polygon.size() == 1) {
    DOBRA_TRY(const bool meets, meets_itself(polygon[0]));
    if (!meets) return as_given;
  }
  DOBRA_TRY(const std::vector<Polyline> rings, topo::region(polygon, topo::Inside::Odd, progress));
  if (rings.size() == polygon.size() && point_count(rings) == point_count(polygon)) return as_given;
  return polygons_of(rings);
}

}  // namespace dobra::offset
