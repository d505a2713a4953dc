// 1. At each crossing, for each name that both sections have there: the ends within reach of it.
// 2. Of the crossings that an end reaches, the outermost: then the line passes the others.
// 3. The end is put there.
#include "shared/surf/loft/reach.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

namespace dobra::surf::loft {

using geom::Point;

namespace {

constexpr double same_place = 1e-9;      // of the size of all
constexpr double told_from = 1e-6;       // of the size of all
constexpr double within_reach = 1e-4;    // of the length of the trace
constexpr double greatest_reach = 1e-3;  // of the length of the trace, for lines of few decimals

/// One section at a crossing, and the other.
struct Side {
  std::size_t section = 0, other = 0;
  double s = 0.0, s_other = 0.0;
  Point at;
};

/// An end of a line.
struct LineEnd {
  std::size_t section = 0, line = 0;
  bool high = false;  ///< The last point.
  friend auto operator<=>(const LineEnd&, const LineEnd&) = default;
};

/// How an end comes to a crossing.
struct Way {
  double ahead = 0.0;   ///< Of the crossing before the end, the way the line runs, m along the trace; negative: behind.
  double length = 0.0;  ///< Of the piece that is put on or cut off, m.
  Point to;             ///< (s, z)
  std::size_t cut = 0;  ///< Points that are cut off.
};

const Point& point_from(const geom::Polyline& line, bool high, std::size_t k) {
  return high ? line.points[line.points.size() - 1 - k] : line.points[k];
}

/// None where the end piece goes away from the place, or straight down, or the line is wholly behind it.
std::optional<Way> way_to(const geom::Polyline& line, bool high, double s, double same) {
  const Point end = point_from(line, high, 0), inside = point_from(line, high, 1);
  const double run = end.x - inside.x;
  if (run == 0.0) return std::nullopt;
  Way way;
  way.ahead = run > 0.0 ? s - end.x : end.x - s;
  if (way.ahead >= 0.0) {
    const double part = way.ahead / std::abs(run);
    way.to = {s, end.y + part * (end.y - inside.y)};
    way.length = geom::distance(end, way.to);
    return way;
  }
  for (std::size_t k = 1; k < line.points.size(); ++k) {
    const Point p = point_from(line, high, k - 1), q = point_from(line, high, k);
    way.cut = k;
    if ((p.x - s) * (q.x - s) > 0.0) {
      way.length += geom::distance(p, q);
      continue;
    }
    if (p.x == q.x) return std::nullopt;
    way.to = {s, p.y + (s - p.x) / (q.x - p.x) * (q.y - p.y)};
    way.length += geom::distance(p, way.to);
    if (geom::distance(way.to, q) > same) return way;
    ++way.cut;  // the new end takes the place of the vertex that is there
    if (way.cut == line.points.size()) return std::nullopt;
    return way;
  }
  return std::nullopt;
}

/// m. What is written to whole units, tenths and so on is known no better.
double reach_of(const Section& section, const geom::Polyline& line) {
  const double length = section.trace.length();
  for (int decimals = 0; std::pow(10.0, -decimals) > within_reach * length; ++decimals) {
    const double units = std::pow(10.0, decimals);
    const bool written = std::all_of(line.points.begin(), line.points.end(),
                                     [&](Point p) { return std::abs(p.x * units - std::round(p.x * units)) <= 1e-6; });
    if (written) return std::min(1.0 / units, greatest_reach * length);
  }
  return within_reach * length;
}

/// Whether a fault, other than the line itself, is not farther from an end than `away`.
bool fault_beside(const Section& section, const SectionLine& line, Point end, double away) {
  return std::any_of(section.lines.begin(), section.lines.end(), [&](const SectionLine& other) {
    return other.kind == LineKind::Fault && other.name != line.name && geom::distance(other.line, end) <= away;
  });
}

bool passes(const Section& section, const std::string& name, double s, double same) {
  return std::any_of(section.lines.begin(), section.lines.end(), [&](const SectionLine& line) {
    return line.name == name && !passages(line.line, s, same).empty();
  });
}

/// An end of a line of a name that has not come to a place.
struct Shortfall {
  LineEnd which;
  Way way;
};
std::optional<Shortfall> nearest_short(const Section& section, std::size_t number, const std::string& name, double s,
                                       double same) {
  std::optional<Shortfall> nearest;
  for (std::size_t l = 0; l < section.lines.size(); ++l) {
    if (section.lines[l].name != name) continue;
    for (const bool high : {false, true}) {
      const auto way = way_to(section.lines[l].line, high, s, same);
      if (!way || way->ahead < 0.0 || (nearest && nearest->way.length <= way->length)) continue;
      nearest = {{number, l, high}, *way};
    }
  }
  return nearest;
}

bool can_be_led(const Section& section, const Shortfall& end) {
  const SectionLine& line = section.lines[end.which.line];
  return end.way.length <= reach_of(section, line.line) &&
         !fault_beside(section, line, point_from(line.line, end.which.high, 0), end.way.length);
}

/// Whether the section has the name at a place, or is led there.
bool comes_to(const Section& section, std::size_t number, const std::string& name, double s, double same) {
  if (passes(section, name, s, same)) return true;
  const auto end = nearest_short(section, number, name, s, same);
  return end && can_be_led(section, *end);
}

/// In the order of the first.
std::vector<std::string> common_names(const Section& a, const Section& b) {
  std::vector<std::string> both;
  for (const SectionLine& line : a.lines) {
    const bool in_b =
        std::any_of(b.lines.begin(), b.lines.end(), [&](const SectionLine& other) { return other.name == line.name; });
    if (in_b && std::find(both.begin(), both.end(), line.name) == both.end()) both.push_back(line.name);
  }
  return both;
}

std::string item_of(const SectionLine& line) { return fmt::format("{} '{}'", kind_name(line.kind), line.name); }

class Leading {
 public:
  Leading(const std::vector<Section>& sections, double size) : sections_(sections), size_(size) {}

  void look_at(const Side& side) {
    const Section &mine = sections_[side.section], &other = sections_[side.other];
    const double same = same_place * size_;
    for (const std::string& name : common_names(mine, other)) {
      if (!comes_to(other, side.other, name, side.s_other, same)) continue;
      if (!passes(mine, name, side.s, same)) {
        const auto end = nearest_short(mine, side.section, name, side.s, same);
        if (end && can_be_led(mine, *end)) keep(end->which, end->way, side);
        continue;
      }
      for (std::size_t l = 0; l < mine.lines.size(); ++l) {
        const SectionLine& line = mine.lines[l];
        if (line.name != name) continue;
        for (const bool high : {false, true}) {
          const auto way = way_to(line.line, high, side.s, same);
          if (!way || way->ahead >= -same || way->length > reach_of(mine, line.line)) continue;
          if (!fault_beside(mine, line, point_from(line.line, high, 0), way->length))
            keep({side.section, l, high}, *way, side);
        }
      }
    }
  }

  void move(std::vector<Section>& sections, std::vector<Finding>& findings) const {
    for (const auto& [end, best] : led_) {
      SectionLine& line = sections[end.section].lines[end.line];
      auto& points = line.line.points;
      if (best.way.ahead >= 0.0) {
        (end.high ? points.back() : points.front()) = best.way.to;
      } else {
        const auto cut = static_cast<std::ptrdiff_t>(best.way.cut);
        if (end.high) {
          points.erase(points.end() - cut, points.end());
          points.push_back(best.way.to);
        } else {
          points.erase(points.begin(), points.begin() + cut);
          points.insert(points.begin(), best.way.to);
        }
      }
      if (best.way.length <= told_from * size_) continue;
      const std::string words =
          best.way.ahead >= 0.0
              ? fmt::format(
                    "{} of section '{}' ends {:.6g} m before the place where its trace crosses that of '{}'; it "
                    "is led on to there",
                    item_of(line), sections[end.section].name, best.way.length, sections[best.other].name)
              : fmt::format(
                    "{} of section '{}' ends {:.6g} m behind the place where its trace crosses that of '{}'; "
                    "it is cut there",
                    item_of(line), sections[end.section].name, best.way.length, sections[best.other].name);
      findings.push_back(
          {"end_moved", words, {.item = item_of(line), .x = best.at.x, .y = best.at.y, .z = best.way.to.y}});
    }
  }

 private:
  struct Best {
    Way way;
    std::size_t other = 0;
    Point at;
  };
  void keep(const LineEnd& end, const Way& way, const Side& side) {
    const auto [found, added] = led_.try_emplace(end, Best{way, side.other, side.at});
    if (!added && found->second.way.ahead < way.ahead) found->second = {way, side.other, side.at};
  }

  const std::vector<Section>& sections_;
  double size_;
  std::map<LineEnd, Best> led_;
};

}  // namespace

void lead_to_crossings(std::vector<Section>& sections, const std::vector<Crossing>& crossings, double size,
                       std::vector<Finding>& findings) {
  Leading leading(sections, size);
  for (const Crossing& c : crossings) {
    leading.look_at({c.first, c.second, c.s_first, c.s_second, c.at});
    leading.look_at({c.second, c.first, c.s_second, c.s_first, c.at});
  }
  leading.move(sections, findings);
}

std::vector<Finding> short_lines(const std::vector<Section>& sections, const std::vector<Crossing>& crossings,
                                 double near, double size) {
  std::vector<Finding> findings;
  const double same = same_place * size;
  for (const Crossing& c : crossings) {
    const Section &a = sections[c.first], &b = sections[c.second];
    for (const std::string& name : common_names(a, b)) {
      const bool in_a = passes(a, name, c.s_first, same), in_b = passes(b, name, c.s_second, same);
      if (in_a && in_b) continue;
      const auto near_end = [&](const Section& section, std::size_t number, double s) {
        auto end = nearest_short(section, number, name, s, same);
        if (!end || end->way.ahead > near) return std::optional<Shortfall>{};
        const SectionLine& line = section.lines[end->which.line];
        const Point at = point_from(line.line, end->which.high, 0);
        if (end->way.length > reach_of(section, line.line) && fault_beside(section, line, at, end->way.length))
          end = {};
        return end;
      };
      const auto end_a = in_a ? std::nullopt : near_end(a, c.first, c.s_first);
      const auto end_b = in_b ? std::nullopt : near_end(b, c.second, c.s_second);
      if ((!in_a && !end_a) || (!in_b && !end_b)) continue;
      const Shortfall& end = end_a ? *end_a : *end_b;
      const std::string item = item_of(sections[end.which.section].lines[end.which.line]);
      const std::string words =
          end_a && end_b
              ? fmt::format(
                    "{} ends {:.6g} m in section '{}' and {:.6g} m in '{}' before the place where their traces "
                    "cross, so that they do not meet; draw both on to there",
                    item, end_a->way.ahead, a.name, end_b->way.ahead, b.name)
              : fmt::format(
                    "{} of section '{}' ends {:.6g} m before the place where its trace crosses that of '{}', "
                    "so that it does not meet the line there; draw it on to there",
                    item, end_a ? a.name : b.name, end.way.ahead, end_a ? b.name : a.name);
      findings.push_back({"near_miss", words, {.item = item, .x = c.at.x, .y = c.at.y, .z = end.way.to.y}});
    }
  }
  return findings;
}

}  // namespace dobra::surf::loft
