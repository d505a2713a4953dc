// 1. Every line by the part of its length, or by place; the vertices of all of them are the breaks of u.
// 2. v by the mean chord over all breaks.
// 3. A column across the lines at each break, as Bezier pieces from line to line: by its own ways on the map, or by v.
#include "shared/surf/loft/loft.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace dobra::surf::loft {

using base::Error;
using base::ErrorCode;
using geom::Point3;
using geom::Vector;
using geom::Vector3;

namespace {

constexpr double same_break = 1e-10;  // of the length of a line
constexpr double near_break = 2e-5;   // of different lines: centimetres of a section of a kilometre

base::Place place_at(Point3 p) { return {.x = p.x, .y = p.y, .z = p.z}; }

/// The parts of the length at each point. @error as loft
base::Result<std::vector<double>> parts_of(const std::vector<Point3>& line, std::size_t number) {
  if (line.size() < 2) return Error{ErrorCode::DegenerateCurve, fmt::format("line {} has no two points", number + 1)};
  std::vector<double> parts{0.0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = geom::distance(line[i - 1], line[i]);
    if (!geom::is_finite(line[i]) || !std::isfinite(step))
      return Error{ErrorCode::NotFinite, fmt::format("point {} of line {} is not finite", i + 1, number + 1)};
    if (!(step > 0.0))
      return Error{ErrorCode::DegenerateCurve,
                   fmt::format("points {} and {} of line {} are in one place", i, i + 1, number + 1),
                   place_at(line[i])};
    parts.push_back(parts.back() + step);
  }
  for (double& part : parts) part /= parts.back();
  parts.back() = 1.0;
  return parts;
}

/// A vertex of a line.
struct LineVertex {
  double part = 0.0;
  std::size_t line = 0, vertex = 0;
  bool end = false;  ///< Of a line that others reach beyond.
};

/// Groups of vertices that are at one break, from 0 to 1: the first holds the first vertices of all lines, the last the
/// last; between them each line has one in a group at the most. The border of the surface goes straight from ends that
/// others reach beyond: no vertex is drawn to these.
/// @param ends  of each line, where they are not 0 and 1
std::vector<std::vector<LineVertex>> grouped(const LineParts& parts, const std::vector<std::array<double, 2>>& ends) {
  std::vector<LineVertex> inner;
  std::vector<std::vector<LineVertex>> groups(1);
  std::vector<LineVertex> last;
  for (std::size_t j = 0; j < parts.size(); ++j) {
    const std::vector<double>& of_line = parts[j];
    groups.front().push_back({0.0, j, 0});
    double before = 0.0;
    for (std::size_t k = 1; k + 1 < of_line.size(); ++k) {
      if (of_line[k] - before <= same_break || 1.0 - of_line[k] <= same_break) continue;
      inner.push_back({of_line[k], j, k, !ends.empty() && (of_line[k] == ends[j][0] || of_line[k] == ends[j][1])});
      before = of_line[k];
    }
    last.push_back({1.0, j, of_line.size() - 1});
  }
  std::sort(inner.begin(), inner.end(), [](const LineVertex& a, const LineVertex& b) {
    return std::tie(a.part, a.line) < std::tie(b.part, b.line);
  });
  std::vector<std::size_t> in_group(parts.size(), 0);  // the group of the line's last vertex so far
  bool has_end = false;
  for (const LineVertex& vertex : inner) {
    const double near = vertex.end || has_end ? same_break : near_break;
    const bool begins = groups.size() == 1 || vertex.part - groups.back().front().part > near ||
                        in_group[vertex.line] + 1 == groups.size();
    if (begins) groups.emplace_back();
    groups.back().push_back(vertex);
    has_end = vertex.end || (has_end && !begins);
    in_group[vertex.line] = groups.size() - 1;
  }
  groups.push_back(std::move(last));
  return groups;
}

/// The lines at all breaks: their own vertices as they are.
void add_points(const std::vector<std::vector<Point3>>& lines, const LineParts& parts,
                const std::vector<std::array<double, 2>>& ends, CommonBreaks& common) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  const std::vector<std::vector<LineVertex>> groups = grouped(parts, ends);
  for (const auto& group : groups) common.u.push_back(group.front().part);
  for (std::size_t j = 0; j < lines.size(); ++j) {
    std::vector<std::size_t> own(groups.size(), none);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      for (const LineVertex& vertex : groups[i]) {
        if (vertex.line == j) own[i] = vertex.vertex;
      }
    }
    std::vector<Point3>& points = common.points.emplace_back();
    std::vector<double>& places = common.parts.emplace_back();
    std::size_t k = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      if (own[i] != none) {
        k = own[i];
        points.push_back(lines[j][k]);
        places.push_back(parts[j][k]);
        continue;
      }
      const double u = common.u[i];
      while (k + 2 < parts[j].size() && parts[j][k + 1] < u) ++k;
      const double along = std::clamp((u - parts[j][k]) / (parts[j][k + 1] - parts[j][k]), 0.0, 1.0);
      points.push_back(lines[j][k] + along * (lines[j][k + 1] - lines[j][k]));
      places.push_back(u);
    }
  }
}

/// v of each line, by the mean of the chords; the trapezoidal rule over u.
base::Result<std::vector<double>> chord_parameters(const std::vector<double>& u,
                                                   const std::vector<std::vector<Point3>>& points) {
  std::vector<double> v{0.0};
  for (std::size_t j = 1; j < points.size(); ++j) {
    const auto& a = points[j - 1];
    const auto& b = points[j];
    double mean = 0.0;
    for (std::size_t i = 1; i < u.size(); ++i) {
      mean += 0.5 * (u[i] - u[i - 1]) * (geom::distance(a[i - 1], b[i - 1]) + geom::distance(a[i], b[i]));
    }
    if (!(mean > 0.0))
      return Error{ErrorCode::DegenerateCurve, fmt::format("lines {} and {} are in one place; leave one out", j, j + 1),
                   place_at(b.front())};
    v.push_back(v.back() + mean);
  }
  for (double& value : v) value /= v.back();
  v.back() = 1.0;
  return v;
}

/// The lines at all breaks, gone on beyond their ends: on the map along their last pieces, in height as the nearest
/// lines go that reach so far.
std::vector<std::vector<Point3>> gone_on(const CommonBreaks& common) {
  std::vector<std::vector<Point3>> whole = common.points;
  const std::size_t count = whole.size();
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t first = common.reach[j][0], last = common.reach[j][1];
    const auto own = [&](std::size_t i) { return std::clamp(i, first, last); };
    for (std::size_t i = 0; i < common.u.size(); ++i) {
      const std::size_t end = own(i);
      if (end == i) continue;
      const std::size_t inside = i < first ? first + 1 : last - 1;
      const auto own_part = [&](std::size_t line, std::size_t at) { return common.parts[line][at]; };
      const double beyond = common.u[i] - own_part(j, end);
      const double steps = beyond / (own_part(j, inside) - own_part(j, end));
      const Point3 at = common.points[j][end], before = common.points[j][inside];
      double rise = 0.0, weights = 0.0;
      const auto like = [&](std::size_t k) {
        const std::size_t low = common.reach[k][0], high = common.reach[k][1];
        if (i < low || i > high) return false;
        const double weight = 1.0 / std::abs(static_cast<double>(k) - static_cast<double>(j));
        const std::size_t beside = std::clamp(end, low, high);
        // Traces that are not parallel dip apart: by what they do where both reach, else on the whole.
        const bool both = std::max(first, low) < std::min(last, high);
        const auto dip = [&](std::size_t line, std::size_t from, std::size_t to) {
          if (both) from = std::max(first, low), to = std::min(last, high);
          return (common.points[line][to].z - common.points[line][from].z) /
                 (own_part(line, to) - own_part(line, from));
        };
        rise += weight * (common.points[k][i].z - common.points[k][beside].z + dip(j, first, last) * beyond -
                          dip(k, low, high) * (own_part(k, i) - own_part(k, beside)));
        weights += weight;
        return true;
      };
      for (std::size_t k = j; k-- > 0;) {
        if (like(k)) break;
      }
      for (std::size_t k = j + 1; k < count; ++k) {
        if (like(k)) break;
      }
      whole[j][i] = {at.x + steps * (before.x - at.x), at.y + steps * (before.y - at.y),
                     at.z + (weights > 0.0 ? rise / weights : 0.0)};
    }
  }
  return whole;
}

/// By how much a curve through points goes on a unit of its parameter, at each: a cubic whose end pieces are one piece
/// each ("not a knot"), a parabola through three.
/// @param steps  of the parameter, from point to point
std::vector<Vector3> slopes_through(const std::vector<Point3>& points, const std::vector<double>& steps) {
  const std::size_t last = points.size() - 1;
  const auto rise = [&](std::size_t k) { return (1.0 / steps[k]) * (points[k + 1] - points[k]); };
  std::vector<Vector3> slopes(points.size());
  if (last == 1) return {rise(0), rise(0)};
  if (last == 2) {
    const double h = steps[0] + steps[1];
    slopes[1] = (1.0 / h) * (steps[1] * rise(0) + steps[0] * rise(1));
    slopes[0] = 2.0 * rise(0) - slopes[1];
    slopes[2] = 2.0 * rise(1) - slopes[1];
    return slopes;
  }
  // Three numbers a row, solved from the top down.
  std::vector<double> on(points.size()), over(points.size());
  const auto end = [&](std::size_t k, std::size_t inside, std::size_t row) {
    const double h = steps[k], g = steps[inside], both = h + g;
    on[row] = g;
    slopes[row] = (1.0 / both) * ((h + 2.0 * both) * g * rise(k) + h * h * rise(inside));
    return both;
  };
  over[0] = end(0, 1, 0);
  const double under_last = end(last - 1, last - 2, last);
  for (std::size_t k = 1; k <= last; ++k) {
    double under = under_last;
    if (k < last) {
      under = steps[k];
      on[k] = 2.0 * (steps[k - 1] + steps[k]);
      over[k] = steps[k - 1];
      slopes[k] = 3.0 * (steps[k] * rise(k - 1) + steps[k - 1] * rise(k));
    }
    const double by = under / on[k - 1];
    on[k] -= by * over[k - 1];
    slopes[k] = slopes[k] - by * slopes[k - 1];
  }
  slopes[last] = (1.0 / on[last]) * slopes[last];
  for (std::size_t k = last; k-- > 0;) slopes[k] = (1.0 / on[k]) * (slopes[k] - over[k] * slopes[k + 1]);
  return slopes;
}

/// The way across the lines at one break, by the ways between them on the map: where these are straight behind each
/// other, it never turns back.
struct Column {
  std::vector<double> steps;          ///< From line to line.
  std::vector<Vector3> slopes;        ///< At the lines that it goes through,
  std::vector<std::uint8_t> through;  ///< which are all but those that went on into the way of another.
};

double on_map(Point3 a, Point3 b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// Lines that have ended count where they keep a part of the room that they had at their end.
std::vector<std::uint8_t> lines_through(const CommonBreaks& common, const std::vector<std::vector<Point3>>& whole,
                                        std::size_t i) {
  constexpr double room = 0.25;
  const std::size_t count = whole.size();
  std::vector<std::uint8_t> through(count, 0);
  std::vector<std::size_t> own;
  for (std::size_t j = 0; j < count; ++j) {
    through[j] = common.reach[j][0] <= i && i <= common.reach[j][1] ? 1 : 0;
    if (through[j] != 0) own.push_back(j);
  }
  if (own.size() < 2) return through;
  const auto way = [&](std::size_t at) {
    const Point3 a = whole[own.front()][at], b = whole[own.back()][at];
    return Vector{b.x - a.x, b.y - a.y};
  };
  const auto gap = [&](std::size_t a, std::size_t b, std::size_t at) {
    const Point3 p = whole[a][at], q = whole[b][at];
    return dot(Vector{q.x - p.x, q.y - p.y}, way(at)) / geom::length(way(at));
  };
  for (std::size_t j = 0; j < count; ++j) {
    if (through[j] != 0) continue;
    const std::size_t end = std::clamp(i, common.reach[j][0], common.reach[j][1]);
    const auto has_room = [&](std::size_t a, std::size_t b) { return gap(a, b, i) > room * std::abs(gap(a, b, end)); };
    const auto after = std::upper_bound(own.begin(), own.end(), j);
    through[j] = (j == 0 || has_room(j - 1, j)) && (j + 1 == count || has_room(j, j + 1)) &&
                         (after == own.begin() || has_room(*(after - 1), j)) &&
                         (after == own.end() || has_room(j, *after))
                     ? 1
                     : 0;
  }
  return through;
}

Column column_through(const CommonBreaks& common, const std::vector<std::vector<Point3>>& whole, std::size_t i) {
  constexpr double least = 1e-3;  // of the mean step: lines that meet
  const std::size_t count = whole.size();
  Column column{{}, std::vector<Vector3>(count), lines_through(common, whole, i)};
  double sum = 0.0;
  for (std::size_t j = 0; j + 1 < count; ++j) {
    column.steps.push_back(on_map(whole[j][i], whole[j + 1][i]));
    sum += column.steps.back();
  }
  const double mean = sum > 0.0 ? sum / static_cast<double>(count - 1) : 1.0;
  for (double& step : column.steps) step = std::max(step, least * mean);
  std::vector<Point3> points;
  std::vector<double> steps;
  std::vector<std::size_t> lines;
  for (std::size_t j = 0; j < count; ++j) {
    if (column.through[j] == 0) continue;
    if (!lines.empty()) {
      const bool next = lines.back() + 1 == j;
      steps.push_back(next ? column.steps[lines.back()] : std::max(on_map(points.back(), whole[j][i]), least * mean));
    }
    points.push_back(whole[j][i]);
    lines.push_back(j);
  }
  if (points.size() < 2) return column;
  const std::vector<Vector3> slopes = slopes_through(points, steps);
  for (std::size_t k = 0; k < lines.size(); ++k) column.slopes[lines[k]] = slopes[k];
  return column;
}

/// The Bezier points across the lines at break i. Where both lines of a strip reach, they are those of the column
/// through all lines, gone on; beyond, what a line has further is led to the end of the other in straight proportion.
std::vector<Point3> bezier_points(const CommonBreaks& common, const std::vector<std::vector<Point3>>& whole,
                                  const std::vector<Column>& columns, std::size_t i) {
  std::vector<Point3> points{common.points[0][i]};
  for (std::size_t k = 0; k + 1 < common.points.size(); ++k) {
    const std::size_t low = std::max(common.reach[k][0], common.reach[k + 1][0]);
    const std::size_t high = std::min(common.reach[k][1], common.reach[k + 1][1]);
    const std::size_t c = std::min(std::max(i, low), std::max(low, high));
    const Point3 from = whole[k][c], to = whole[k + 1][c];
    const Vector3 more = common.points[k][i] - from, more_next = common.points[k + 1][i] - to;
    const Vector chord{to.x - from.x, to.y - from.y};
    const double square = dot(chord, chord);
    const auto add = [&](Point3 at, double t) {
      const double part = square > 0.0 ? dot(Vector{at.x - from.x, at.y - from.y}, chord) / square : t;
      points.push_back(at + (1.0 - part) * more + part * more_next);
    };
    if (whole.size() > 2) {
      const Column& column = columns[c];
      const bool through = column.through[k] != 0 && column.through[k + 1] != 0;
      const Vector3 straight = (1.0 / column.steps[k]) * (to - from);
      const double third = column.steps[k] / 3.0;
      add(from + third * (through ? column.slopes[k] : straight), 1.0 / 3.0);
      add(to - third * (through ? column.slopes[k + 1] : straight), 2.0 / 3.0);
    }
    points.push_back(common.points[k + 1][i]);
  }
  return points;
}

/// By parts of lengths all columns go by v.
Column column_by(const std::vector<double>& v, const std::vector<std::vector<Point3>>& lines, std::size_t i) {
  Column column;
  std::vector<Point3> points;
  for (std::size_t j = 0; j < lines.size(); ++j) {
    if (j > 0) column.steps.push_back(v[j] - v[j - 1]);
    points.push_back(lines[j][i]);
  }
  column.slopes = slopes_through(points, column.steps);
  column.through.assign(lines.size(), 1);
  return column;
}

}  // namespace

base::Result<Loft> loft(const std::vector<std::vector<Point3>>& lines, const LineParts& parts) {
  if (lines.size() < 2)
    return Error{ErrorCode::InvalidOption, fmt::format("a surface through {} lines; give two at least", lines.size())};
  DOBRA_TRY(const CommonBreaks common, common_breaks(lines, parts));
  const bool by_place = !parts.empty();
  const std::vector<std::vector<Point3>> whole = by_place ? gone_on(common) : common.points;
  DOBRA_TRY(std::vector<double> v, chord_parameters(common.u, whole));
  std::vector<Column> columns;
  for (std::size_t i = 0; i < common.u.size(); ++i)
    columns.push_back(by_place ? column_through(common, whole, i) : column_by(v, whole, i));
  std::vector<Point3> controls;
  for (std::size_t i = 0; i < common.u.size(); ++i) {
    const std::vector<Point3> column = bezier_points(common, whole, columns, i);
    controls.insert(controls.end(), column.begin(), column.end());
  }
  std::vector<double> knots_u{0.0};
  knots_u.insert(knots_u.end(), common.u.begin(), common.u.end());
  knots_u.push_back(1.0);
  const std::size_t degree = v.size() > 2 ? 3 : 1;
  std::vector<double> knots_v{v.front()};
  for (const double line : v) knots_v.insert(knots_v.end(), degree, line);
  knots_v.push_back(v.back());
  DOBRA_TRY(Surface surface, Surface::nurbs(1, std::move(knots_u), degree, std::move(knots_v), controls));
  return Loft{std::move(surface), std::move(v)};
}

base::Result<CommonBreaks> common_breaks(const std::vector<std::vector<Point3>>& lines, const LineParts& parts) {
  CommonBreaks common;
  std::vector<std::vector<Point3>> whole = lines;
  LineParts of_lines;
  std::vector<std::array<double, 2>> ends;
  for (std::size_t j = 0; j < lines.size(); ++j) {
    DOBRA_TRY(std::vector<double> of_line, parts_of(lines[j], j));
    if (!parts.empty()) {
      of_line = parts[j];
      if (of_line.front() <= near_break && of_line[1] > of_line.front()) of_line.front() = 0.0;
      if (of_line.back() >= 1.0 - near_break) of_line.back() = 1.0;
      ends.push_back({of_line.front(), of_line.back()});
      if (of_line.front() > 0.0) {
        of_line.insert(of_line.begin(), 0.0);
        whole[j].insert(whole[j].begin(), lines[j].front());
      }
      if (of_line.back() < 1.0) {
        of_line.push_back(1.0);
        whole[j].push_back(lines[j].back());
      }
    }
    of_lines.push_back(std::move(of_line));
  }
  add_points(whole, of_lines, ends, common);
  for (std::size_t j = 0; j < whole.size(); ++j) {
    if (parts.empty()) {
      common.reach.push_back({0, common.u.size() - 1});
      continue;
    }
    const auto at = [&](double part) {
      const auto found = std::find(common.parts[j].begin(), common.parts[j].end(), part);
      return static_cast<std::size_t>(found - common.parts[j].begin());
    };
    common.reach.push_back({at(ends[j][0]), at(ends[j][1])});
  }
  return common;
}

std::optional<LineParts> parts_by_place(const std::vector<std::vector<Point3>>& lines, geom::Vector way,
                                        std::array<bool, 2> held) {
  LineParts places;
  const Point3 origin = lines.front().front();
  double low = INFINITY, high = -INFINITY;
  for (const auto& line : lines) {
    std::vector<double>& of_line = places.emplace_back();
    for (const Point3 p : line) of_line.push_back((p.x - origin.x) * way.x + (p.y - origin.y) * way.y);
    low = std::min(low, of_line.front());
    high = std::max(high, of_line.back());
  }
  for (std::vector<double>& of_line : places) {
    const double from = held[0] ? of_line.front() : low, to = held[1] ? of_line.back() : high;
    for (std::size_t i = 0; i < of_line.size(); ++i) {
      of_line[i] = (of_line[i] - from) / (to - from);
      // Vertices that would be one break, and lines that turn back.
      if (i > 0 && !(of_line[i] - of_line[i - 1] > 4.0 * same_break)) return std::nullopt;
    }
  }
  return places;
}

}  // namespace dobra::surf::loft
