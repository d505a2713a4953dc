#include "quebra/domain/selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "shared/base/formula.h"
#include "shared/base/text.h"
#include "shared/geom/spatial_index.h"

// 1. The text: alternatives ("or") of comparisons ("and"), each of two formulas. 2. A comparison holds at a place if
// the difference of its formulas has the sign asked for there or a tolerance beside. 3. Parts of curves are asked at
// samples.

namespace quebra::domain {
namespace {

namespace mesh = dobra::mesh;
using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Formula;
using dobra::base::Result;
using dobra::geom::Point;

/// Of the domain's diagonal.
constexpr double tolerance = 1e-6;

enum class Relation { Equal, Less, Greater };

/// A part of the user's text, and where in it that begins.
struct Part {
  std::string text;
  std::size_t begin = 0;
};

struct Comparison {
  Formula left, right;
  Relation relation = Relation::Equal;
  Part part = {};
};

Error unreadable(const std::string& condition, std::size_t at, const std::string& why) {
  return {ErrorCode::BadValue,
          fmt::format("the condition '{}', character {}: {}; write such as \"x = 0\" or \"y = 2 and x > 1\"", condition,
                      dobra::base::character_number(condition, at), why)};
}

/// The parts between whole words.
std::vector<Part> split(const Part& whole, const std::string& word) {
  std::vector<Part> parts{{"", whole.begin}};
  const std::string separator = ' ' + word + ' ';
  for (std::size_t i = 0; i < whole.text.size();) {
    if (whole.text.compare(i, separator.size(), separator) == 0) {
      i += separator.size();
      parts.push_back({"", whole.begin + i});
    } else {
      parts.back().text += whole.text[i++];
    }
  }
  return parts;
}

/// Words and signs that join comparisons in other languages, or stand where nothing is joined.
Result<void> check_joints(const Part& part, const std::string& condition) {
  for (const char* sign : {"&&", "||", ";"}) {
    if (const std::size_t at = part.text.find(sign); at != std::string::npos)
      return unreadable(condition, part.begin + at,
                        fmt::format("'{}' joins nothing here; comparisons are joined by 'and' and 'or'", sign));
  }
  const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t begin = 0; begin < part.text.size();) {
    std::size_t end = begin;
    while (end < part.text.size() && is_letter(part.text[end])) ++end;
    const std::string word = part.text.substr(begin, end - begin);
    std::string small = word;
    std::transform(small.begin(), small.end(), small.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (small == "and" || small == "or" || small == "not")
      return unreadable(
          condition, part.begin + begin,
          fmt::format("'{}' joins nothing here; 'and' and 'or', in small letters, stand between two comparisons",
                      word));
    begin = std::max(end, begin + 1);
  }
  return {};
}

/// "0 < x <= 2": two comparisons.
Result<std::vector<Comparison>> comparisons_of(const Part& part, const std::string& condition) {
  DOBRA_TRY_VOID(check_joints(part, condition));
  const std::string& text = part.text;
  static const std::vector<std::string> names{"x", "y"};
  std::vector<Formula> formulas;
  std::vector<Relation> relations;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find_first_of("=<>!", begin), text.size());
    const std::string side = text.substr(begin, end - begin);
    if (side.find_first_not_of(' ') == std::string::npos)
      return unreadable(condition, part.begin + begin, "a side of a comparison is missing");
    DOBRA_TRY(Formula formula, Formula::make(side, names, {"the condition", condition, part.begin + begin}));
    formulas.push_back(std::move(formula));
    if (end == text.size()) break;
    if (text[end] == '!')
      return unreadable(condition, part.begin + end, "'!' is not expected: a side is named by what holds for it");
    relations.push_back(text[end] == '=' ? Relation::Equal : text[end] == '<' ? Relation::Less : Relation::Greater);
    begin = end + (text.compare(end + 1, 1, "=") == 0 ? 2 : 1);
  }
  if (relations.empty()) return unreadable(condition, part.begin, fmt::format("'{}' compares nothing", text));
  std::vector<Comparison> comparisons;
  for (std::size_t i = 0; i < relations.size(); ++i)
    comparisons.push_back({formulas[i], formulas[i + 1], relations[i], part});
  return comparisons;
}

class Condition {
 public:
  static Result<Condition> make(const Domain& domain, const std::string& text) {
    Condition condition;
    condition.tolerance_ = tolerance * domain.box().diagonal();
    condition.unit_ = domain.unit;
    for (const Part& alternative : split({text, 0}, "or")) {
      auto& all = condition.alternatives_.emplace_back();
      for (const Part& one : split(alternative, "and")) {
        DOBRA_TRY(const auto comparisons, comparisons_of(one, text));
        all.insert(all.end(), comparisons.begin(), comparisons.end());
      }
    }
    return condition;
  }

  /// The first comparison that has no finite value at any of those points, "x = 1/0".
  [[nodiscard]] std::optional<std::string> undefined_at(const std::set<Point>& points) const {
    for (const auto& all : alternatives_) {
      for (const Comparison& one : all) {
        const auto finite = [&](Point p) {
          const std::array at{p.x / unit_, p.y / unit_};
          return std::isfinite(one.left.at(at)) && std::isfinite(one.right.at(at));
        };
        if (std::none_of(points.begin(), points.end(), finite)) return one.part.text;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::size_t alternatives() const { return alternatives_.size(); }
  [[nodiscard]] double close() const { return tolerance_; }
  [[nodiscard]] bool holds(std::size_t alternative, Point p) const {
    const auto& all = alternatives_[alternative];
    return std::all_of(all.begin(), all.end(), [&](const Comparison& one) { return holds(one, p); });
  }

 private:
  [[nodiscard]] bool holds(const Comparison& one, Point p) const {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const auto& [dx, dy] : {std::array{0.0, 0.0}, {1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) {
      const std::array at{(p.x + dx * tolerance_) / unit_, (p.y + dy * tolerance_) / unit_};
      const double difference = one.left.at(at) - one.right.at(at);
      if (std::isnan(difference)) continue;
      least = std::min(least, difference);
      greatest = std::max(greatest, difference);
    }
    switch (one.relation) {
      case Relation::Equal:
        return least <= 0.0 && greatest >= 0.0;
      case Relation::Less:
        return least <= 0.0;
      case Relation::Greater:
        return greatest >= 0.0;
    }
    return false;
  }

  std::vector<std::vector<Comparison>> alternatives_;
  double tolerance_ = 0.0;
  double unit_ = 1.0;
};

/// Distances along a part that are asked: both ends, places near them, and between.
std::vector<double> samples_of(const CurvePart& part, double close) {
  constexpr int pieces = 16;
  const double all = part.to - part.from;
  const double near_end = std::max(1e-3 * all, 4.0 * close);
  std::vector<double> samples;
  for (int i = 0; i <= pieces; ++i) samples.push_back(part.from + all * i / pieces);
  samples.back() = part.to;
  if (near_end < all / pieces) {
    samples.insert(samples.begin() + 1, part.from + near_end);
    samples.insert(samples.end() - 1, part.to - near_end);
  }
  return samples;
}

enum class Holds { Nowhere, Partly, All };

Holds how_far(std::span<const Point> along, const Condition& condition, std::size_t alternative) {
  bool all = true, stretch = false, before = false;
  for (const Point p : along) {
    const bool here = condition.holds(alternative, p);
    all = all && here;
    stretch = stretch || (here && before);
    before = here;
  }
  return all ? Holds::All : stretch ? Holds::Partly : Holds::Nowhere;
}

/// How far the condition holds along each part.
std::vector<Holds> how_far(const Domain& domain, std::span<const CurvePart> parts, const Condition& condition) {
  std::vector<Holds> result(parts.size(), Holds::Nowhere);
  for (std::size_t first = 0; first < parts.size();) {
    // All parts of a curve at once: a point of a chain costs a pass over it.
    std::vector<double> s;
    std::vector<std::size_t> ends;
    std::size_t i = first;
    for (; i < parts.size() && parts[i].curve == parts[first].curve; ++i) {
      const auto own = samples_of(parts[i], condition.close());
      s.insert(s.end(), own.begin(), own.end());
      ends.push_back(s.size());
    }
    const auto at = points(domain.curves[parts[first].curve], s);
    for (std::size_t k = 0, begin = 0; k < ends.size(); begin = ends[k++]) {
      for (std::size_t a = 0; a < condition.alternatives(); ++a) {
        result[first + k] =
            std::max(result[first + k], how_far(std::span(at).subspan(begin, ends[k] - begin), condition, a));
      }
    }
    first = i;
  }
  return result;
}

std::string text_of(const Domain& domain, const CurvePart& part) {
  const std::string& name = domain.curves[part.curve].name;
  if (part.start == part.end)
    return fmt::format("'{}', closed, through ({:.6g}, {:.6g})", name, part.start.x, part.start.y);
  return fmt::format("'{}' from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g})", name, part.start.x, part.start.y, part.end.x,
                     part.end.y);
}

Error only_partly(const Domain& domain, const CurvePart& part, const std::string& condition) {
  const Point middle = point(domain.curves[part.curve], 0.5 * (part.from + part.to));
  return {
      ErrorCode::BadValue,
      fmt::format("the condition '{}' holds for a stretch only of the side {}: put a point ([[input.point]]) on the "
                  "side where the stretch ends, or select all of it",
                  condition, text_of(domain, part)),
      dobra::base::Place{.x = middle.x, .y = middle.y}};
}

/// Of the sides of a curve those that lie along selected parts of it.
class PartsOfCurve {
 public:
  /// @param all  parts of this curve, in order; `wanted` those that are selected, by their starts.
  PartsOfCurve(const sketch::Curve& curve, std::span<const CurvePart> all, const std::set<double>& wanted) {
    const sketch::Trace along = trace(curve);
    std::vector<dobra::geom::Box> boxes;
    const auto add = [&](Point from, Point to, bool is_wanted) {
      chords_.push_back({from, to});
      wanted_.push_back(is_wanted);
      boxes.push_back(chords_.back().box());
    };
    std::size_t part = 0;
    for (std::size_t i = 0; i < along.line.segment_count(); ++i) {
      const auto [from, to] = along.line.segment(i);
      Point start = from;
      // Chords of a bent curve may pass a junction, where parts end.
      for (; part + 1 < all.size() && all[part].to < along.s[i + 1]; ++part) {
        add(start, all[part].end, wanted.contains(all[part].from));
        start = all[part].end;
      }
      add(start, to, wanted.contains(all[part].from));
      if (part + 1 < all.size() && all[part].to <= along.s[i + 1]) ++part;
    }
    index_ = dobra::geom::SpatialIndex(boxes);
  }

  [[nodiscard]] bool holds(Point middle) const {
    const auto nearest = index_.nearest(middle, [&](std::size_t i) { return distance(chords_[i], middle); });
    return nearest && wanted_[nearest->item];
  }

 private:
  std::vector<dobra::geom::Segment> chords_;
  std::vector<bool> wanted_;
  dobra::geom::SpatialIndex index_;
};

void add_sides(const Domain& domain, const Selection& selection, const std::string& name, mesh::ElementMesh& result) {
  std::map<std::size_t, std::set<double>> wanted;
  for (const CurvePart& part : selection.parts) wanted[part.curve].insert(part.from);
  const auto all = boundary_parts(domain);
  std::vector<mesh::ElementSide> chosen;
  for (const auto& [c, starts] : wanted) {
    const auto set = result.side_sets.find(domain.curves[c].name);
    if (set == result.side_sets.end()) continue;
    const auto own = std::equal_range(all.begin(), all.end(), CurvePart{c, 0.0, 0.0, {}, {}},
                                      [](const auto& a, const auto& b) { return a.curve < b.curve; });
    const PartsOfCurve parts(domain.curves[c], {own.first, own.second}, starts);
    for (const mesh::ElementSide& side : set->second) {
      const auto nodes = side_nodes(result, side);
      if (parts.holds(midpoint(result.point(nodes[0]), result.point(nodes[1])))) chosen.push_back(side);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  result.side_sets[name] = std::move(chosen);
}

/// The nodes nearest to the corners, which are nodes themselves.
void add_nodes(const Selection& selection, const std::string& name, mesh::ElementMesh& result) {
  std::set<mesh::NodeId> chosen;
  for (const Point corner : selection.corners) {
    const auto nearest = std::min_element(result.points.begin(), result.points.end(),
                                          [&](Point a, Point b) { return distance(a, corner) < distance(b, corner); });
    chosen.insert(mesh::NodeId(static_cast<std::size_t>(nearest - result.points.begin())));
  }
  result.node_sets[name] = {chosen.begin(), chosen.end()};
}

}  // namespace

std::vector<CurvePart> boundary_parts(const Domain& domain) {
  std::vector<CurvePart> parts;
  auto junction = domain.junctions.begin();
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    const sketch::Curve& curve = domain.curves[c];
    std::vector<double> ends = corners(curve);
    for (; junction != domain.junctions.end() && junction->curve <= c; ++junction) {
      if (junction->curve == c) ends.push_back(junction->s);
    }
    if (curve.role != sketch::Role::Boundary && curve.role != sketch::Role::Hole) continue;
    std::sort(ends.begin(), ends.end());
    const double least = 1e-9 * ends.back();
    ends.erase(std::unique(ends.begin(), ends.end(), [&](double a, double b) { return b - a <= least; }), ends.end());
    const auto at = points(curve, ends);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) parts.push_back({c, ends[i], ends[i + 1], at[i], at[i + 1]});
  }
  return parts;
}

bool is_condition(const std::string& where) { return where.find_first_of("=<>") != std::string::npos; }

Result<Selection> select(const Domain& domain, const std::string& condition) {
  DOBRA_TRY(const Condition wanted, Condition::make(domain, condition));
  Selection selection;
  const auto parts = boundary_parts(domain);
  const auto holds = how_far(domain, parts, wanted);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (holds[i] == Holds::Partly) return only_partly(domain, parts[i], condition);
    if (holds[i] == Holds::All) selection.parts.push_back(parts[i]);
  }
  if (!selection.parts.empty()) return selection;
  std::set<Point> at;
  for (const CurvePart& part : parts) {
    at.insert(part.start);
    at.insert(part.end);
  }
  for (const Point p : at) {
    for (std::size_t i = 0; i < wanted.alternatives(); ++i) {
      if (!wanted.holds(i, p)) continue;
      selection.corners.push_back(p);
      break;
    }
  }
  if (!selection.corners.empty()) return selection;
  if (const auto undefined = wanted.undefined_at(at))
    return Error{ErrorCode::BadValue,
                 fmt::format("the condition '{}': '{}' has no finite value at any corner of the boundary", condition,
                             *undefined)};
  return Error{ErrorCode::BadValue,
               fmt::format("the condition '{}' holds for no side and no corner of the boundary, which has {}",
                           condition, listed(domain))};
}

std::vector<std::size_t> curves_meant(const Domain& domain, const std::string& where) {
  std::set<std::size_t> curves;
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    if (domain.curves[c].name == where) curves.insert(c);
  }
  if (curves.empty() && is_condition(where)) {
    if (const auto selection = select(domain, where)) {
      for (const CurvePart& part : selection->parts) curves.insert(part.curve);
    }
  }
  return {curves.begin(), curves.end()};
}

Result<mesh::ElementMesh> with_sets(const Domain& domain, const mesh::ElementMesh& own,
                                    std::span<const std::string> words) {
  mesh::ElementMesh result = own;
  for (const std::string& where : words) {
    if (!is_condition(where) || result.side_sets.contains(where) || result.node_sets.contains(where)) continue;
    DOBRA_TRY(const Selection selection, select(domain, where));
    if (!selection.parts.empty()) {
      add_sides(domain, selection, where, result);
    } else {
      add_nodes(selection, where, result);
    }
  }
  return result;
}

std::string what_there_is(const std::string& word, const std::vector<std::string>& names) {
  if (names.empty()) return "; there is none at all";
  constexpr std::size_t most = 12;
  const std::string meant = dobra::base::did_you_mean(word, names);
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    text += fmt::format("{}'{}'", i == 0 ? "" : ", ", names[i]);
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return (meant.empty() ? "; there is " : meant + " There is ") + text;
}

std::string listed(const Domain& domain, std::size_t most) {
  const auto parts = boundary_parts(domain);
  std::string text;
  for (std::size_t i = 0; i < std::min(most, parts.size()); ++i)
    text += (i == 0 ? "" : ", ") + text_of(domain, parts[i]);
  return parts.size() > most ? text + fmt::format(" and {} more", parts.size() - most) : text;
}

}  // namespace quebra::domain
