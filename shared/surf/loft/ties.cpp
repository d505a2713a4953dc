// 1. Crossings of traces, exactly; ends of lines that are just beside one are led to it (reach.h).
// 2. At each, the heights of lines of one name, paired by height.
// 3. Places of one line on the map that coincide get one mean height; vertices there, then the lines are moved.
#include "shared/surf/loft/ties.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "shared/geom/intersect.h"
#include "shared/surf/loft/reach.h"

namespace dobra::surf::loft {

using base::Error;
using base::ErrorCode;
using geom::Point;

namespace {

base::Place place_at(Point p, double z, std::string item) {
  return {.item = std::move(item), .x = p.x, .y = p.y, .z = z};
}

double along(const PlanTrace& trace, std::size_t segment, Point p) {
  return trace.distances()[segment] + geom::distance(trace.corners()[segment], p);
}

/// Adds where two traces meet. @error BadSection: along a length
base::Result<void> cross(const std::vector<Section>& sections, std::size_t a, std::size_t b, double same,
                         std::vector<Crossing>& crossings) {
  const geom::Polyline first{sections[a].trace.corners(), false}, second{sections[b].trace.corners(), false};
  for (std::size_t i = 0; i < first.segment_count(); ++i) {
    for (std::size_t j = 0; j < second.segment_count(); ++j) {
      const geom::Intersection met = geom::intersect(first.segment(i), second.segment(j));
      if (met.kind == geom::IntersectionKind::None) continue;
      if (met.kind == geom::IntersectionKind::Overlap)
        return Error{ErrorCode::BadSection,
                     fmt::format("the traces of '{}' and '{}' run along one another; leave one of them out, or part it",
                                 sections[a].name, sections[b].name),
                     place_at(met.start.point, 0.0, fmt::format("section '{}'", sections[a].name))};
      const Point at = met.start.point;
      const bool known = std::any_of(crossings.begin(), crossings.end(), [&](const Crossing& c) {
        return c.first == a && c.second == b && geom::distance(c.at, at) <= same;
      });
      if (!known) crossings.push_back({a, b, along(sections[a].trace, i, at), along(sections[b].trace, j, at), at});
    }
  }
  return {};
}

/// Ends of traces that stop short of another trace. Of two that end beside each other the nearer end is told.
void tell_near_misses(const std::vector<Section>& sections, double near, double same, std::vector<Finding>& findings) {
  struct Miss {
    const Section *ends, *other;
    Point end;
    double gap;
  };
  const auto misses_of = [&](const Section& a, const Section& b) {
    std::vector<Miss> misses;
    const geom::Polyline other{b.trace.corners(), false};
    for (const Point end : {a.trace.corners().front(), a.trace.corners().back()}) {
      const double gap = geom::distance(other, end);
      if (gap > same && gap <= near) misses.push_back({&a, &b, end, gap});
    }
    return misses;
  };
  for (std::size_t a = 0; a < sections.size(); ++a) {
    for (std::size_t b = a + 1; b < sections.size(); ++b) {
      std::vector<Miss> misses = misses_of(sections[a], sections[b]);
      for (const Miss& miss : misses_of(sections[b], sections[a])) {
        const auto beside = std::find_if(misses.begin(), misses.end(), [&](const Miss& other) {
          return other.ends != miss.ends && geom::distance(other.end, miss.end) <= near;
        });
        if (beside == misses.end()) {
          misses.push_back(miss);
        } else if (miss.gap < beside->gap) {
          *beside = miss;
        }
      }
      for (const Miss& miss : misses)
        findings.push_back({"near_miss",
                            fmt::format("the trace of '{}' ends {:.6g} m from that of '{}' and does not meet it there; "
                                        "draw it on to the other if they are to be tied",
                                        miss.ends->name, miss.gap, miss.other->name),
                            place_at(miss.end, 0.0, fmt::format("section '{}'", miss.ends->name))});
    }
  }
}

/// One line of a section over a place.
struct Hit {
  std::size_t section = 0, line = 0;
  double s = 0.0;
  Passage passage;
};

std::vector<Hit> hits_of(const Section& section, std::size_t number, const std::string& name, double s, double same) {
  std::vector<Hit> hits;
  for (std::size_t l = 0; l < section.lines.size(); ++l) {
    if (section.lines[l].name != name) continue;
    for (const Passage& passage : passages(section.lines[l].line, s, same)) hits.push_back({number, l, s, passage});
  }
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.passage.z < b.passage.z; });
  return hits;
}

/// All lines of one name that meet at one place.
struct Knot {
  std::vector<Hit> hits;
};

std::vector<std::pair<Hit, Hit>> pair_up(const std::vector<Hit>& a, const std::vector<Hit>& b) {
  std::vector<std::pair<Hit, Hit>> pairs;
  if (a.size() == b.size()) {
    for (std::size_t i = 0; i < a.size(); ++i) pairs.emplace_back(a[i], b[i]);
    return pairs;
  }
  if (a.empty() || b.empty()) return pairs;
  std::pair<Hit, Hit> best{a.front(), b.front()};
  for (const Hit& p : a) {
    for (const Hit& q : b) {
      if (std::abs(p.passage.z - q.passage.z) < std::abs(best.first.passage.z - best.second.passage.z)) best = {p, q};
    }
  }
  return {best};
}

class Tying {
 public:
  Tying(std::vector<Section> sections, const TieOptions& options) : options_(options) {
    tied_.sections = std::move(sections);
    size_ = size_of(tied_.sections);
    same_ = 1e-9 * size_;
  }

  base::Result<Tied> run() {
    const std::size_t count = tied_.sections.size();
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = a + 1; b < count; ++b) DOBRA_TRY_VOID(cross(tied_.sections, a, b, same_, tied_.crossings));
    }
    lead_to_crossings(tied_.sections, tied_.crossings, size_, tied_.findings);
    tell_near_misses(tied_.sections, options_.near_miss * size_, same_, tied_.findings);
    const std::vector<Finding> missed = short_lines(tied_.sections, tied_.crossings, options_.near_miss * size_, size_);
    tied_.findings.insert(tied_.findings.end(), missed.begin(), missed.end());
    for (const Crossing& crossing : tied_.crossings) find_misties(crossing);
    DOBRA_TRY_VOID(judge());
    share_out();
    return std::move(tied_);
  }

 private:
  void find_misties(const Crossing& crossing) {
    const Section& a = tied_.sections[crossing.first];
    const Section& b = tied_.sections[crossing.second];
    std::vector<std::string> done;
    for (const SectionLine& line : a.lines) {
      if (std::find(done.begin(), done.end(), line.name) != done.end()) continue;
      done.push_back(line.name);
      const auto first = hits_of(a, crossing.first, line.name, crossing.s_first, same_);
      const auto second = hits_of(b, crossing.second, line.name, crossing.s_second, same_);
      if (!first.empty() && !second.empty() && first.size() != second.size())
        tied_.findings.push_back(
            {"unequal_heights",
             fmt::format("{} '{}' passes the crossing of '{}' and '{}' {} times in the one and {} "
                         "in the other; the nearest two are tied",
                         kind_name(line.kind), line.name, a.name, b.name, first.size(), second.size()),
             place_at(crossing.at, first.front().passage.z, line.name)});
      for (const auto& [p, q] : pair_up(first, second)) {
        knot_at(line.name, p, q);
        tied_.misties.push_back({line.name,
                                 line.kind,
                                 crossing.first,
                                 crossing.second,
                                 {crossing.at.x, crossing.at.y, 0.5 * (p.passage.z + q.passage.z)},
                                 p.passage.z - q.passage.z});
      }
    }
  }

  /// Puts both into the knot that has one of them, or a new one.
  void knot_at(const std::string& name, const Hit& p, const Hit& q) {
    const auto same = [&](const Hit& a, const Hit& b) {
      return a.section == b.section && a.line == b.line && std::abs(a.passage.place - b.passage.place) < 1e-6;
    };
    const auto has = [&](const Knot& knot, const Hit& hit) {
      return std::any_of(knot.hits.begin(), knot.hits.end(), [&](const Hit& h) { return same(h, hit); });
    };
    for (Knot& knot : knots_[name]) {
      const bool first = has(knot, p), second = has(knot, q);
      if (!first && !second) continue;
      if (!first) knot.hits.push_back(p);
      if (!second) knot.hits.push_back(q);
      return;
    }
    knots_[name].push_back({{p, q}});
  }

  [[nodiscard]] base::Result<void> judge() const {
    const double most = options_.most.value_or(0.02 * size_);
    const Mistie* worst = nullptr;
    for (const Mistie& m : tied_.misties) {
      if (std::abs(m.difference) > most && (!worst || std::abs(m.difference) > std::abs(worst->difference))) worst = &m;
    }
    if (worst == nullptr) return {};
    return Error{
        ErrorCode::BadSection,
        fmt::format("{} '{}' is {:.6g} m apart where '{}' and '{}' cross, more than the {:.6g} m that are "
                    "shared out; mend a section or allow more (mistie_tolerance)",
                    kind_name(worst->kind), worst->line, std::abs(worst->difference), tied_.sections[worst->first].name,
                    tied_.sections[worst->second].name, most),
        place_at({worst->at.x, worst->at.y}, worst->at.z, fmt::format("{} '{}'", kind_name(worst->kind), worst->line))};
  }

  /// What a line is moved by, where.
  struct Move {
    double place = 0.0, z = 0.0, by = 0.0;
    double s = 0.0;
  };

  void share_out() {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Move>> moves;
    for (const auto& [name, knots] : knots_) {
      for (const Knot& knot : knots) {
        double mean = 0.0;
        for (const Hit& hit : knot.hits) mean += hit.passage.z / static_cast<double>(knot.hits.size());
        for (const Hit& hit : knot.hits) {
          moves[{hit.section, hit.line}].push_back({hit.passage.place, hit.passage.z, mean - hit.passage.z, hit.s});
        }
      }
    }
    for (auto& [which, of_line] : moves) move(tied_.sections[which.first].lines[which.second].line, of_line);
  }

  /// Vertices at the places, then every vertex up or down; before the first place and behind the last as there.
  void move(geom::Polyline& line, std::vector<Move>& moves) const {
    std::sort(moves.begin(), moves.end(), [](const Move& a, const Move& b) { return a.place < b.place; });
    struct Vertex {
      double place;
      Point at;
    };
    std::vector<Vertex> vertices;
    std::size_t next = 0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const double number = static_cast<double>(i);
      for (; next < moves.size() && moves[next].place < number; ++next) {
        const Move& m = moves[next];
        const Point at{m.s, m.z};
        if (geom::distance(at, line.points[i]) > same_ && geom::distance(at, vertices.back().at) > same_)
          vertices.push_back({m.place, at});
      }
      vertices.push_back({number, line.points[i]});
    }
    line.points.clear();
    for (const Vertex& vertex : vertices)
      line.points.push_back({vertex.at.x, vertex.at.y + by_at(moves, vertex.place)});
  }
  static double by_at(const std::vector<Move>& moves, double place) {
    if (place <= moves.front().place) return moves.front().by;
    for (std::size_t k = 1; k < moves.size(); ++k) {
      const Move &a = moves[k - 1], &b = moves[k];
      if (place > b.place) continue;
      return b.place > a.place ? a.by + (place - a.place) / (b.place - a.place) * (b.by - a.by) : b.by;
    }
    return moves.back().by;
  }

  TieOptions options_;
  Tied tied_;
  double size_ = 0.0, same_ = 0.0;
  std::map<std::string, std::vector<Knot>> knots_;
};

}  // namespace

std::vector<Passage> passages(const geom::Polyline& line, double s, double tolerance) {
  std::vector<Passage> found;
  const auto add = [&](double place, double z) {
    if (found.empty() || place - found.back().place > 1e-9) found.push_back({place, z});
  };
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const Point p = line.points[i], q = line.points[i + 1];
    const double number = static_cast<double>(i);
    if (std::abs(p.x - s) <= tolerance && std::abs(q.x - s) <= tolerance) {
      add(number + 0.5, 0.5 * (p.y + q.y));
    } else if (std::abs(p.x - s) <= tolerance) {
      if (found.empty() || found.back().place < number - 0.75) add(number, p.y);
    } else if (std::abs(q.x - s) <= tolerance) {
      add(number + 1.0, q.y);
    } else if ((p.x - s) * (q.x - s) < 0.0) {
      const double t = (s - p.x) / (q.x - p.x);
      add(number + t, p.y + t * (q.y - p.y));
    }
  }
  return found;
}

base::Result<Tied> tie(std::vector<Section> sections, const TieOptions& options) {
  return Tying(std::move(sections), options).run();
}

}  // namespace dobra::surf::loft
