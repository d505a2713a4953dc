#include "recon/balance/ledger.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "recon/balance/face_ledger.h"
#include "recon/balance/percent.h"
#include "recon/maps/area_change.h"
#include "shared/base/parallel.h"
#include "shared/geom/contour.h"
#include "shared/geom/segment_tree.h"
#include "shared/mesh/front/triangulate.h"

namespace recon::balance {

namespace {

namespace mesh = dobra::mesh;

/// Collects a Range.
class RangeSum {
 public:
  void add(double value, double weight) {
    range_.least = weight_ > 0.0 ? std::min(range_.least, value) : value;
    range_.greatest = weight_ > 0.0 ? std::max(range_.greatest, value) : value;
    sum_ += weight * value;
    weight_ += weight;
  }
  [[nodiscard]] std::optional<Range> range() const {
    if (!(weight_ > 0.0)) return std::nullopt;
    return Range{range_.least, sum_ / weight_, range_.greatest};
  }

 private:
  Range range_;
  double sum_ = 0.0;
  double weight_ = 0.0;
};

/// What one unit adds to the ledger; made in parallel, joined in order.
struct Part {
  UnitRow row;
  DilatationField field;
  std::vector<maps::Strain> strains;
  std::optional<base::Error> error;
};

double triangle_area(geom::Point a, geom::Point b, geom::Point c) { return 0.5 * std::abs(geom::cross(b - a, c - a)); }

/// det F - 1 at the middle of each triangle of `field`; triangles that no cell holds are dropped.
/// @return the mean by area.
double evaluate(DilatationField& field, const maps::SectionMap& map, std::optional<maps::AreaChange>& extremes) {
  RangeSum sum;
  std::vector<std::array<std::uint32_t, 3>> kept;
  maps::Cell hint;
  for (const auto& t : field.triangles) {
    const geom::Point a = field.points[t[0]];
    const geom::Point b = field.points[t[1]];
    const geom::Point c = field.points[t[2]];
    const geom::Point middle{(a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0};
    double determinant = 0.0;
    const std::optional<maps::Cell> cell = map.cell_of(middle, hint);
    if (!cell) continue;
    map.determinants(*cell, {&middle, 1}, {&determinant, 1});
    if (!std::isfinite(determinant)) continue;
    kept.push_back(t);
    field.values.push_back(determinant - 1.0);
    include(extremes, field.values.back(), middle);
    sum.add(field.values.back(), triangle_area(a, b, c));
  }
  field.triangles = std::move(kept);
  const std::optional<Range> range = sum.range();
  return range ? range->mean : 0.0;
}

/// det F - 1 of a unit: on its triangles, its extremes as they are known, and its mean: the change of area, unless the
/// area after has holes where the unit is torn.
void measure_dilatation(std::optional<maps::AreaChange> extremes, bool torn, const maps::SectionMap& map, Part& part) {
  const double sampled = evaluate(part.field, map, extremes);
  if (!extremes) return;
  UnitRow& row = part.row;
  row.dilatation = Range{extremes->least, torn ? sampled : 0.01 * row.change_percent, extremes->greatest};
  row.least_at = extremes->least_at;
  row.greatest_at = extremes->greatest_at;
}

/// `count` + 1 places evenly by length along a line, from its first point to its last.
std::vector<geom::Point> even_places(const geom::Polyline& line, int count) {
  const std::vector<double> arc = geom::arc_lengths(line);
  std::vector<geom::Point> places;
  for (int i = 0; i <= count; ++i) places.push_back(geom::point_at(line, arc, arc.back() * i / count));
  return places;
}

/// A mapped horizon, as the units above and below it need it.
struct Bed {
  const maps::MappedLine* line = nullptr;
  std::vector<geom::Point> before;  ///< Evenly spaced.
  std::vector<geom::Point> after;
};

/// The band between two lines cut into triangles, from place to place along and `levels` across.
DilatationField band_between(const std::vector<geom::Point>& upper, const std::vector<geom::Point>& lower, int levels) {
  DilatationField field;
  const auto width = static_cast<std::uint32_t>(levels + 1);
  for (std::size_t i = 0; i < upper.size(); ++i) {
    for (int k = 0; k <= levels; ++k)
      field.points.push_back(geom::interpolate(upper[i], lower[i], static_cast<double>(k) / levels));
    if (i == 0) continue;
    const auto first = static_cast<std::uint32_t>(i - 1) * width;
    for (std::uint32_t k = 0; k + 1 < width; ++k) {
      const std::uint32_t a = first + k, b = first + k + 1, c = first + width + k, d = first + width + k + 1;
      field.triangles.push_back({a, b, c});
      field.triangles.push_back({c, b, d});
    }
  }
  return field;
}

/// From places on one line to another line, across the beds.
std::optional<Range> thickness_from(const std::vector<geom::Point>& places, const geom::Polyline& lower) {
  std::vector<geom::Segment> segments;
  segments.reserve(lower.segment_count());
  for (std::size_t i = 0; i < lower.segment_count(); ++i) segments.push_back(lower.segment(i));
  const geom::SegmentTree tree(std::move(segments));
  RangeSum sum;
  std::optional<geom::SegmentTree::Nearest> nearest;
  for (const geom::Point p : places) {
    const auto any = [](std::size_t) { return true; };
    nearest = nearest ? tree.nearest_from(nearest->index, p, any) : tree.nearest(p, any);
    if (!nearest) return std::nullopt;
    const geom::Segment& segment = tree.segment(nearest->index);
    const double t = geom::nearest_fraction(segment, p);
    // Beyond an end of the lower line the nearest point is that end: no thickness.
    const bool at_end = (nearest->index == 0 && t == 0.0) || (nearest->index + 1 == tree.size() && t == 1.0);
    const geom::Vector along = geom::normalised(segment.vector());
    const bool square =
        std::abs(geom::dot(p - geom::interpolate(segment.from, segment.to, t), along)) <= 1e-6 * nearest->distance();
    if (!at_end || square) sum.add(nearest->distance(), 1.0);
  }
  return sum.range();
}

void add_strains(const DilatationField& field, const maps::SectionMap& map, const LedgerOptions& options,
                 std::vector<maps::Strain>& strains) {
  const std::size_t count = field.triangles.size();
  const auto wanted = static_cast<std::size_t>(options.ellipses);
  for (std::size_t i = 0; i < wanted && count > 0; ++i) {
    const auto& t = field.triangles[(2 * i + 1) * count / (2 * wanted)];
    const geom::Point middle{(field.points[t[0]].x + field.points[t[1]].x + field.points[t[2]].x) / 3.0,
                             (field.points[t[0]].y + field.points[t[1]].y + field.points[t[2]].y) / 3.0};
    const maps::Gradient f = map.gradient(middle);
    if (f.determinant() != 0.0) strains.push_back(strain_of(middle, f));
  }
}

Part part_between(const Bed& upper, const Bed& lower, const std::string& name, const maps::SectionMap& ends,
                  const LedgerOptions& options) {
  Part part;
  UnitRow& row = part.row;
  row.name = name;
  const UnitAreas areas = areas_between(*upper.line, *lower.line, ends);
  row.area_before = areas.before;
  row.area_after = areas.after;
  row.thickness_before = thickness_from(upper.before, lower.line->before);
  row.thickness_after = thickness_from(upper.after, lower.line->after);
  part.field = band_between(upper.before, lower.before, options.levels);
  return part;
}

Part part_of_polygon(const section::Unit& unit, const maps::SectionMap& map, const LedgerOptions& options) {
  Part part;
  part.row.name = unit.name;
  part.row.area_before = std::abs(geom::signed_area(unit.contour));
  maps::MappedLine mapped = map.forward(unit.contour);
  part.row.contour_after = std::move(mapped.after);
  part.row.tears = std::move(mapped.tears);
  part.row.area_after = std::abs(geom::signed_area(part.row.contour_after));
  mesh::delaunay::MeshInput input;
  mesh::delaunay::add_chain(input, unit.contour.points, mesh::delaunay::Closure::Closed,
                            {unit.name, mesh::delaunay::EdgeKind::Boundary});
  mesh::front::MeshOptions how;
  how.sizes.max_size = std::sqrt(4.0 * part.row.area_before / (options.places * options.levels));
  auto made = mesh::front::triangulate(input, how);
  if (!made) {
    part.error = base::located(made.error(), base::Place{.item = fmt::format("unit '{}'", unit.name)});
    return part;
  }
  part.field.points = made->points;
  for (const mesh::Corners& t : made->triangles) {
    part.field.triangles.push_back({static_cast<std::uint32_t>(t[0].index()), static_cast<std::uint32_t>(t[1].index()),
                                    static_cast<std::uint32_t>(t[2].index())});
  }
  return part;
}

void join(Part part, Ledger& ledger) {
  ledger.units.push_back(std::move(part.row));
  const auto first = static_cast<std::uint32_t>(ledger.field.points.size());
  ledger.field.points.insert(ledger.field.points.end(), part.field.points.begin(), part.field.points.end());
  for (const auto& t : part.field.triangles)
    ledger.field.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  ledger.field.values.insert(ledger.field.values.end(), part.field.values.begin(), part.field.values.end());
  ledger.strains.insert(ledger.strains.end(), part.strains.begin(), part.strains.end());
}

}  // namespace

std::vector<LedgerUnit> ledger_units(const section::Section& section, std::vector<section::HorizonId> order,
                                     section::LayerSide side) {
  std::vector<LedgerUnit> units;
  for (const section::Unit& unit : section.units) units.push_back({unit.name, unit.id, {}, {}});
  if (!units.empty() || order.empty()) return units;
  if (section.faces) {  // neighbours in depth may be two pieces of one horizon: the faces know what lies on what
    for (const section::RockUnit& unit : section.faces->units) {
      if (unit.whole) units.push_back({unit.name, {}, unit.top, unit.base});
    }
    return units;
  }
  if (side == section::LayerSide::Above) std::reverse(order.begin(), order.end());
  const auto index_of = [&](section::HorizonId id) {
    const auto is = [&](const section::Horizon& horizon) { return horizon.id == id; };
    return static_cast<std::size_t>(std::find_if(section.horizons.begin(), section.horizons.end(), is) -
                                    section.horizons.begin());
  };
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const std::size_t upper = index_of(order[i]);
    const std::size_t lower = index_of(order[i + 1]);
    units.push_back(
        {fmt::format("{} - {}", section.horizons[upper].name, section.horizons[lower].name), {}, upper, lower});
  }
  return units;
}

std::optional<Range> thickness_between(const geom::Polyline& upper, const geom::Polyline& lower, int count) {
  return thickness_from(even_places(upper, count), lower);
}

UnitAreas areas_between(const maps::MappedLine& upper, const maps::MappedLine& lower, const maps::SectionMap& ends) {
  // Only the two ends are lines that are not mapped yet.
  const auto image_of = [&](const maps::MappedLine& from, const maps::MappedLine& to, auto end) {
    geom::Polyline image = ends.forward(geom::Polyline{{end(from.before), end(to.before)}, false}).after;
    const std::vector<double> arc = geom::arc_lengths(image);
    const geom::Vector at_from = end(from.after) - image.points.front();
    const geom::Vector at_to = end(to.after) - image.points.back();
    for (std::size_t i = 0; i < arc.size(); ++i) {
      const double part = arc.back() > 0.0 ? arc[i] / arc.back() : 0.0;
      image.points[i] = image.points[i] + (1.0 - part) * at_from + part * at_to;
    }
    return image.points;
  };
  const std::vector<geom::Point> right =
      image_of(upper, lower, [](const geom::Polyline& line) { return line.points.back(); });
  const std::vector<geom::Point> left =
      image_of(lower, upper, [](const geom::Polyline& line) { return line.points.front(); });
  geom::Polyline after;
  after.points.reserve(upper.after.points.size() + right.size() + lower.after.points.size() + left.size());
  after.points = upper.after.points;
  after.points.insert(after.points.end(), right.begin(), right.end());
  after.points.insert(after.points.end(), lower.after.points.rbegin(), lower.after.points.rend());
  after.points.insert(after.points.end(), left.begin(), left.end());
  after.closed = true;
  return {std::abs(geom::signed_area(contour_between(upper.before, lower.before))), std::abs(geom::signed_area(after))};
}

base::Result<Ledger> draw_up(const section::Section& section, const std::vector<LedgerUnit>& units,
                             const std::vector<maps::MappedLine>& lines, const maps::SectionMap& map,
                             const maps::SectionMap& ends, const LedgerOptions& options,
                             const base::Progress& progress) {
  std::vector<Part> parts(units.size());
  const bool between_beds = std::any_of(units.begin(), units.end(), [](const LedgerUnit& u) { return !u.unit; });
  const auto beds = base::parallel_map<Bed>(between_beds ? lines.size() : 0, [&](std::size_t i) {
    return Bed{&lines[i], even_places(lines[i].before, options.places), even_places(lines[i].after, options.places)};
  });
  std::vector<geom::Polyline> rulings_start;  // which a polygon may hold
  if (!between_beds && map.columns() == nullptr) {
    for (const maps::MappedLine& line : lines) rulings_start.push_back(line.before);
  }
  base::parallel_for(units.size(), [&](std::size_t i) {
    if (progress.cancelled()) return;
    const LedgerUnit& unit = units[i];
    parts[i] = unit.unit ? part_of_polygon(section.units[unit.unit->index()], map, options)
                         : part_between(beds[*unit.upper], beds[*unit.lower], unit.name, ends, options);
    if (parts[i].error) return;
    UnitRow& row = parts[i].row;
    if (!unit.unit) row.role = role_of(section, unit.upper, unit.lower);
    row.change_percent = percent(row.area_after - row.area_before, row.area_before);
    const bool torn =
        unit.unit ? !row.tears.empty() : !lines[*unit.upper].tears.empty() || !lines[*unit.lower].tears.empty();
    measure_dilatation(
        unit.unit ? area_change_in(std::span(&section.units[unit.unit->index()].contour, 1), map, rulings_start)
                  : area_change_between(lines[*unit.upper], lines[*unit.lower], map),
        torn, map, parts[i]);
    add_strains(parts[i].field, map, options, parts[i].strains);
  });
  DOBRA_TRY_VOID(progress.check());
  Ledger ledger;
  for (Part& part : parts) {
    if (part.error) return *part.error;
    join(std::move(part), ledger);
  }
  return ledger;
}

}  // namespace recon::balance
