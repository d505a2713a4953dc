// 1. Mis-ties (ties.h).
// 2. A name of which two lines cross is a network (network.h); else, and where that has no cell, a row of sections.
// 3. In a row: pieces between faults, called by the faults at their ends; each run of sections that follow each other
//    and have such a piece, or have nothing in its place, gives a loft.
#include "shared/surf/loft/through.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "shared/surf/loft/beyond.h"
#include "shared/surf/loft/cut.h"
#include "shared/surf/loft/ends.h"
#include "shared/surf/loft/loft.h"
#include "shared/surf/loft/network.h"
#include "shared/surf/loft/pieces.h"

namespace dobra::surf::loft {

using base::Error;
using base::ErrorCode;
using geom::Point;
using geom::Point3;
using geom::Vector;

namespace {

/// What a piece is called: the faults at its ends, and which of several of those it is.
struct PieceName {
  std::string low, high;
  std::size_t number = 0;
  friend auto operator<=>(const PieceName&, const PieceName&) = default;
};

/// A line of a row, run the way of the first section.
struct Strand {
  std::size_t section = 0;  // number
  PieceName name;
  std::vector<Point3> points;
};

base::Place place_at(Point3 p, std::string item) { return {.item = std::move(item), .x = p.x, .y = p.y, .z = p.z}; }

std::string piece_words(const PieceName& name) {
  if (name.low.empty() && name.high.empty()) return "the piece that ends at no fault";
  if (name.low.empty()) return fmt::format("the piece that ends at fault '{}'", name.high);
  if (name.high.empty()) return fmt::format("the piece that begins at fault '{}'", name.low);
  return fmt::format("the piece between faults '{}' and '{}'", name.low, name.high);
}

/// Whether words are one but for capitals, of A to Z.
bool same_letters(const std::string& a, const std::string& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char p, unsigned char q) { return std::tolower(p) == std::tolower(q); });
}

/// Lines whose ends say little of their way are turned so that they lie along the one before.
void turn_like(const std::vector<Point3>& before, std::vector<Point3>& line) {
  const double straight = geom::distance(before.front(), line.front()) + geom::distance(before.back(), line.back());
  const double crossed = geom::distance(before.front(), line.back()) + geom::distance(before.back(), line.front());
  if (crossed < straight) std::reverse(line.begin(), line.end());
}

class Through {
 public:
  Through(Surfaces made, const ThroughOptions& options) : made_(std::move(made)), options_(options) {}

  base::Result<Surfaces> run() {
    tell_kinds();
    // Faults first: horizons end at them.
    for (const LineKind kind : {LineKind::Fault, LineKind::Horizon}) DOBRA_TRY_VOID(surfaces_of(kind));
    std::stable_sort(made_.surfaces.begin(), made_.surfaces.end(), [&](const NamedSurface& a, const NamedSurface& b) {
      return std::find(names_.begin(), names_.end(), a.name) < std::find(names_.begin(), names_.end(), b.name);
    });
    return std::move(made_);
  }

 private:
  base::Result<void> surfaces_of(LineKind kind) {
    std::set<std::string> done;
    for (std::size_t s = 0; s < made_.sections.size(); ++s) {
      for (std::size_t l = 0; l < made_.sections[s].lines.size(); ++l) {
        const SectionLine line = made_.sections[s].lines[l];
        if (std::find(names_.begin(), names_.end(), line.name) == names_.end()) names_.push_back(line.name);
        if (line.kind != kind || !done.insert(line.name).second) continue;
        DOBRA_TRY_VOID(surface_of(line.name, line.kind));
      }
    }
    return {};
  }

  /// Names that are a fault here and a horizon there.
  void tell_kinds() {
    std::map<std::string, std::pair<std::size_t, const SectionLine*>> first;
    std::set<std::string> told;
    for (std::size_t s = 0; s < made_.sections.size(); ++s) {
      for (const SectionLine& line : made_.sections[s].lines) {
        const auto& [section, other] = first.try_emplace(line.name, s, &line).first->second;
        if (other->kind == line.kind || !told.insert(line.name).second) continue;
        tell("kinds_differ",
             fmt::format("'{}' is a {} in section '{}' and a {} in '{}'; give both one kind, or each a name of its own",
                         line.name, kind_name(other->kind), made_.sections[section].name, kind_name(line.kind),
                         made_.sections[s].name),
             place_at(made_.sections[s].trace.in_space(line.line.points.front()),
                      fmt::format("section '{}'", made_.sections[s].name)));
      }
    }
  }

  void tell(std::string code, std::string message, base::Place place) {
    made_.findings.push_back({std::move(code), std::move(message), std::move(place)});
  }

  /// Whether it was told that lines of the name do not meet where the traces cross.
  /// @param item  its kind and name
  [[nodiscard]] bool misses(const std::string& item) const {
    return std::any_of(made_.findings.begin(), made_.findings.end(),
                       [&](const Finding& f) { return f.code == "near_miss" && f.place.item == item; });
  }

  [[nodiscard]] std::vector<std::size_t> sections_with(const std::string& name) const {
    std::vector<std::size_t> which;
    for (std::size_t s = 0; s < made_.sections.size(); ++s) {
      const auto& lines = made_.sections[s].lines;
      if (std::any_of(lines.begin(), lines.end(), [&](const SectionLine& l) { return l.name == name; }))
        which.push_back(s);
    }
    return which;
  }

  base::Result<void> surface_of(const std::string& name, LineKind kind) {
    const std::vector<std::size_t> which = sections_with(name);
    tell_missing(name, kind, which);
    if (which.size() < 2) return {};
    std::vector<Mistie> misties;
    for (const Mistie& m : made_.misties) {
      if (m.line == name) misties.push_back(m);
    }
    NamedSurface surface{name, kind, {}};
    lines_v_.clear(), unjoined_.clear();
    std::vector<std::size_t> left = which;
    if (!misties.empty()) {
      DOBRA_TRY(surface.patches, patches_between(made_.sections, name, misties, options_, made_.size, made_.findings));
      if (surface.patches.empty()) left = without_crossings(which, misties);
    }
    if (surface.patches.empty() && left.size() > 1) {
      DOBRA_TRY(surface.patches, row_patches(name, kind, left));
      surface.unjoined = unjoined_;
    }
    if (surface.patches.empty() && left.size() < 2) {
      const Point3 at = misties.front().at;
      tell(
          "no_surface",
          misses(fmt::format("{} '{}'", kind_name(kind), name))
              ? fmt::format("{} '{}': its sections cross or meet, but its lines do not meet at all of the crossings; "
                            "draw them on to there",
                            kind_name(kind), name)
              : fmt::format("{} '{}': its sections cross or meet, and neither do three of them bound a cell nor do two "
                            "lie side by side; draw one beside them, or leave out those that cross",
                            kind_name(kind), name),
          place_at(at, fmt::format("{} '{}'", kind_name(kind), name)));
    }
    tell_left_out(surface, which, left);
    if (kind == LineKind::Horizon && lines_v_.size() == surface.patches.size())
      lead_to_faults(surface, lines_v_, made_.surfaces, greatest_way * made_.size, made_.findings);
    if (!surface.patches.empty()) made_.surfaces.push_back(std::move(surface));
    return {};
  }

  /// The first name on another section that differs from this one by its capitals alone.
  [[nodiscard]] std::string alike(const std::string& name, const std::vector<std::size_t>& which) const {
    for (std::size_t s = 0; s < made_.sections.size(); ++s) {
      if (std::find(which.begin(), which.end(), s) != which.end()) continue;
      for (const SectionLine& line : made_.sections[s].lines) {
        if (same_letters(line.name, name))
          return fmt::format("; section '{}' has '{}': write both alike if they are one", made_.sections[s].name,
                             line.name);
      }
    }
    return {};
  }

  void tell_missing(const std::string& name, LineKind kind, const std::vector<std::size_t>& which) {
    if (which.size() == made_.sections.size()) return;
    const std::string item = fmt::format("{} '{}'", kind_name(kind), name);
    if (which.size() < 2) {
      const Section& section = made_.sections[which.front()];
      const auto line = std::find_if(section.lines.begin(), section.lines.end(),
                                     [&](const SectionLine& l) { return l.name == name; });
      tell("single",
           fmt::format("{} is in section '{}' alone; a surface takes two", item, section.name) + alike(name, which),
           place_at(section.trace.in_space(line->line.points.front()), item));
    } else {
      const std::string other = alike(name, which);
      for (const bool between : {true, false}) {
        std::vector<std::string> without;
        Point at;
        for (const std::size_t s : sections_without(which, between)) {
          without.push_back(fmt::format("'{}'", made_.sections[s].name));
          at = made_.sections[s].trace.on_map(0.5 * made_.sections[s].trace.length());
        }
        if (without.empty()) continue;
        const std::string all = fmt::format("{}", fmt::join(without, ", "));
        tell("missing",
             (between ? fmt::format("{} is not in {}; its surface passes without", item, all)
                      : fmt::format("{} is not in {}; its surface ends before", item, all)) +
                 other,
             {.item = item, .x = at.x, .y = at.y});
      }
    }
  }

  /// Of all others: those between the given ones, or those beside them.
  [[nodiscard]] std::vector<std::size_t> sections_without(const std::vector<std::size_t>& which, bool between) const {
    std::vector<std::size_t> all(made_.sections.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const Row row = row_of(made_.sections, all);
    const auto has = [&](std::size_t s) { return std::find(which.begin(), which.end(), s) != which.end(); };
    const auto first = std::find_if(row.order.begin(), row.order.end(), has);
    const auto last = std::find_if(row.order.rbegin(), row.order.rend(), has).base();
    std::vector<std::size_t> found;
    for (auto s = row.order.begin(); s != row.order.end(); ++s) {
      if (!has(*s) && (first < s && s < last) == between) found.push_back(*s);
    }
    return found;
  }

  /// Takes away the section with most crossings, the last of them, until none cross.
  static std::vector<std::size_t> without_crossings(std::vector<std::size_t> which,
                                                    const std::vector<Mistie>& misties) {
    while (true) {
      std::map<std::size_t, std::size_t> count;
      for (const Mistie& m : misties) {
        const auto has = [&](std::size_t s) { return std::find(which.begin(), which.end(), s) != which.end(); };
        if (has(m.first) && has(m.second)) ++count[m.first], ++count[m.second];
      }
      if (count.empty()) return which;
      const auto most = std::max_element(count.begin(), count.end(),
                                         [](const auto& a, const auto& b) { return a.second <= b.second; });
      std::erase(which, most->first);
    }
  }

  /// How far lines that no surface was laid through are from it.
  void tell_left_out(const NamedSurface& surface, const std::vector<std::size_t>& which,
                     const std::vector<std::size_t>& left) {
    if (left.size() == which.size() || surface.patches.empty()) return;
    const bool missed = misses(fmt::format("{} '{}'", kind_name(surface.kind), surface.name));
    for (const std::size_t s : which) {
      if (std::find(left.begin(), left.end(), s) != left.end()) continue;
      const Section& section = made_.sections[s];
      const SectionCut cut = cut_along({surface}, section.trace, made_.size);
      double most = -1.0;
      Point3 at{};
      double low = INFINITY, high = -INFINITY;
      for (const CutLine& line : cut.lines) {
        const geom::Box box = line.line.box();
        low = std::min(low, box.low.x), high = std::max(high, box.high.x);
      }
      for (const SectionLine& line : section.lines) {
        if (line.name != surface.name) continue;
        for (const Point p : line.line.points) {
          if (p.x < low || p.x > high) continue;
          double least = INFINITY;
          for (const CutLine& other : cut.lines) least = std::min(least, geom::distance(other.line, p));
          if (least > most) most = least, at = section.trace.in_space(p);
        }
      }
      if (most < 0.0) {
        const auto line = std::find_if(section.lines.begin(), section.lines.end(),
                                       [&](const SectionLine& l) { return l.name == surface.name; });
        tell("left_out",
             missed
                 ? fmt::format("{} '{}': its lines do not meet at all of the crossings; the surface goes through the "
                               "sections side by side, and does not reach the line of '{}'",
                               kind_name(surface.kind), surface.name, section.name)
                 : fmt::format("{} '{}': no cell of crossing sections; the surface goes through those side by side, "
                               "and does not reach the line of '{}'",
                               kind_name(surface.kind), surface.name, section.name),
             place_at(section.trace.in_space(line->line.points.front()), fmt::format("section '{}'", section.name)));
        continue;
      }
      constexpr double rounded = 1e-9;
      if (most <= rounded * made_.size) continue;  // it lies on the surface
      tell("left_out",
           missed
               ? fmt::format("{} '{}': its lines do not meet at all of the crossings; the surface goes through the "
                             "sections side by side, and the line of '{}' is up to {:.6g} m from it",
                             kind_name(surface.kind), surface.name, section.name, most)
               : fmt::format("{} '{}': no cell of crossing sections; the surface goes through those side by side, and "
                             "the line of '{}' is up to {:.6g} m from it",
                             kind_name(surface.kind), surface.name, section.name, most),
           place_at(at, fmt::format("section '{}'", section.name)));
    }
  }

  base::Result<std::vector<Patch>> row_patches(const std::string& name, LineKind kind,
                                               const std::vector<std::size_t>& which) {
    const std::string item = fmt::format("{} '{}'", kind_name(kind), name);
    const Row row = row_of(made_.sections, which);
    if (row.end_to_end) {
      const Point p = made_.sections[row.order.front()].trace.corners().front();
      tell("end_to_end",
           fmt::format("{}: its sections lie behind each other in one line, and no surface goes through them", item),
           {.item = item, .x = p.x, .y = p.y});
      return std::vector<Patch>{};
    }
    std::vector<std::vector<Strand>> strands;
    for (std::size_t k = 0; k < row.order.size(); ++k)
      strands.push_back(strands_of(row.order[k], row.against[k], name, kind));
    pass_over(item, kind, strands);
    for (std::size_t k = 1; k < strands.size(); ++k) keep_unjoined(strands, k - 1, k);
    uneven_told_ = false;
    DOBRA_TRY(std::vector<Patch> patches, runs(item, strands));
    if (!uneven_told_) tell_uneven(item, strands);
    return patches;
  }

  std::vector<Strand> strands_of(std::size_t number, bool against, const std::string& name, LineKind kind) {
    const Section& section = made_.sections[number];
    geom::Box box;
    for (const SectionLine& line : section.lines) {
      for (const Point p : line.line.points) box.add(p);
    }
    std::vector<LinePiece> pieces = pieces_of(section, name, options_.at_fault * box.diagonal());
    const auto ascends = [&](const geom::Polyline& line) {
      const Vector way = line.points.back() - line.points.front();
      if (kind == LineKind::Horizon) return (way.x > 0.0) != against;
      return std::abs(way.y) > 0.1 * std::abs(way.x) ? way.y < 0.0 : (way.x > 0.0) != against;
    };
    std::vector<Strand> strands;
    for (LinePiece& piece : pieces) {
      if (!ascends(piece.line)) {
        piece.line = geom::reversed(std::move(piece.line));
        std::swap(piece.first_fault, piece.last_fault);
      }
    }
    std::stable_sort(pieces.begin(), pieces.end(), [&](const LinePiece& a, const LinePiece& b) {
      const Point p = a.line.box().centre(), q = b.line.box().centre();
      if (kind == LineKind::Fault) return p.y > q.y;
      return against ? p.x > q.x : p.x < q.x;
    });
    // A fault that is whole is one piece, wherever it ends.
    const bool by_faults = kind == LineKind::Horizon || pieces.size() > 1;
    for (LinePiece& piece : pieces) {
      PieceName called{by_faults ? piece.first_fault : "", by_faults ? piece.last_fault : "", 0};
      for (const Strand& other : strands) {
        if (other.name.low == called.low && other.name.high == called.high) ++called.number;
      }
      strands.push_back({number, called, without_twins(in_space(section.trace, piece.line), twin * made_.size)});
    }
    return strands;
  }

  void tell_uneven(const std::string& item, const std::vector<std::vector<Strand>>& strands) {
    // From end to end, what faults part it by along with it.
    const auto length = [](const std::vector<Strand>& of_section) {
      return geom::distance(of_section.front().points.front(), of_section.back().points.back());
    };
    const auto by_length = [&](const auto& a, const auto& b) { return length(a) < length(b); };
    const auto [least, most] = std::minmax_element(strands.begin(), strands.end(), by_length);
    if (length(*most) <= options_.uneven * length(*least)) return;
    const std::string &a = made_.sections[least->front().section].name, &b = made_.sections[most->front().section].name;
    tell(
        "uneven",
        fmt::format("{} reaches {:.6g} m in section '{}' and {:.6g} m in '{}'; beyond the shorter one the surface runs "
                    "to its end",
                    item, length(*least), a, length(*most), b),
        place_at(least->back().points.back(), item));
  }

  static const Strand* piece_of(const std::vector<Strand>& of_section, const PieceName& name) {
    const auto found =
        std::find_if(of_section.begin(), of_section.end(), [&](const Strand& strand) { return strand.name == name; });
    return found == of_section.end() ? nullptr : &*found;
  }

  /// A section that lacks a piece which others on both sides of it have is passed over as one that lacks the whole line
  /// is, unless it has another piece in that place.
  void pass_over(const std::string& item, LineKind kind, const std::vector<std::vector<Strand>>& strands) {
    passed_.clear();
    // Places along the first line, or heights.
    const Point3 origin = strands.front().front().points.front(), last = strands.front().back().points.back();
    const Vector way = geom::normalised(Vector{last.x - origin.x, last.y - origin.y});
    const auto reach = [&](const Strand& strand) {
      std::array<double, 2> low_high{INFINITY, -INFINITY};
      for (const Point3 p : strand.points) {
        const double at = kind == LineKind::Fault ? p.z : geom::dot(Vector{p.x - origin.x, p.y - origin.y}, way);
        low_high = {std::min(low_high[0], at), std::max(low_high[1], at)};
      }
      return low_high;
    };
    const auto one_place = [&](const Strand& a, const Strand& b) {
      constexpr double most = 0.5;  // of the shorter one
      const auto p = reach(a), q = reach(b);
      return std::min(p[1], q[1]) - std::max(p[0], q[0]) > most * std::min(p[1] - p[0], q[1] - q[0]);
    };
    std::set<PieceName> names;
    for (const auto& of_section : strands) {
      for (const Strand& strand : of_section) names.insert(strand.name);
    }
    for (const PieceName& name : names) {
      const Strand* before = nullptr;
      std::size_t from = 0;
      for (std::size_t k = 0; k < strands.size(); ++k) {
        const Strand* here = piece_of(strands[k], name);
        if (here == nullptr) continue;
        const auto free = [&](std::size_t between) {
          return std::all_of(strands[between].begin(), strands[between].end(), [&](const Strand& other) {
            const bool on_both =
                piece_of(strands[from], other.name) != nullptr && piece_of(strands[k], other.name) != nullptr;
            return on_both || (!one_place(other, *before) && !one_place(other, *here));
          });
        };
        bool all = before != nullptr;
        for (std::size_t between = from + 1; all && between < k; ++between) all = free(between);
        for (std::size_t between = from + 1; all && between < k; ++between) {
          passed_.insert({name, between});
          const Section& section = made_.sections[strands[between].front().section];
          const Point at = section.trace.on_map(0.5 * section.trace.length());
          tell("missing",
               fmt::format("{}: {} is not in '{}'; its surface passes without", item, piece_words(name), section.name),
               {.item = item, .x = at.x, .y = at.y});
        }
        before = here, from = k;
      }
    }
  }

  /// Pieces of one of two sections beside each other that the other has not.
  void keep_unjoined(const std::vector<std::vector<Strand>>& strands, std::size_t number_a, std::size_t number_b) {
    const std::vector<Strand>&a = strands[number_a], &b = strands[number_b];
    Unjoined both;
    double longest = 0.0, apart = 0.0;
    const auto keep = [&](const std::vector<Strand>& of, const std::vector<Strand>& other) {
      const std::size_t number = &other == &a ? number_a : number_b;
      const geom::Polyline across{made_.sections[other.front().section].trace.corners(), false};
      double sum = 0.0;
      for (const Strand& strand : of) {
        if (piece_of(other, strand.name) != nullptr || passed_.contains({strand.name, number})) continue;
        for (std::size_t i = 0; i < strand.points.size(); ++i) {
          const Point p{strand.points[i].x, strand.points[i].y};
          apart = std::max(apart, geom::distance(across, p));
          if (i > 0) sum += geom::distance(p, Point{strand.points[i - 1].x, strand.points[i - 1].y});
          both.points.push_back(strand.points[i]);
        }
      }
      longest = std::max(longest, sum);
    };
    keep(a, b);
    const std::size_t of_a = both.points.size();
    keep(b, a);
    if (both.points.empty()) return;
    if (of_a == 0 || of_a == both.points.size()) {  // on one of them alone: a patch might go as far as the other
      const auto middle = [&](const std::vector<Strand>& of) {
        const PlanTrace& trace = made_.sections[of.front().section].trace;
        return trace.on_map(0.5 * trace.length());
      };
      const Vector way = of_a == 0 ? middle(a) - middle(b) : middle(b) - middle(a);
      for (std::size_t i = 0, n = both.points.size(); i < n; ++i) {
        const Point3 p = both.points[i];
        both.points.push_back({p.x + way.x, p.y + way.y, p.z});
      }
    }
    both.first = made_.sections[a.front().section].name;
    both.second = made_.sections[b.front().section].name;
    both.plan = longest * apart;
    unjoined_.push_back(std::move(both));
  }

  /// A loft for each run of sections that follow each other and have a piece of one name, or are passed over.
  base::Result<std::vector<Patch>> runs(const std::string& item, const std::vector<std::vector<Strand>>& strands) {
    std::set<PieceName> names;
    for (const auto& of_section : strands) {
      for (const Strand& strand : of_section) names.insert(strand.name);
    }
    std::vector<Patch> patches;
    lines_v_.clear();
    for (const PieceName& name : names) {
      std::vector<const Strand*> run;
      for (std::size_t k = 0; k < strands.size(); ++k) {
        if (const Strand* found = piece_of(strands[k], name)) {
          run.push_back(found);
        } else if (!passed_.contains({name, k})) {
          DOBRA_TRY_VOID(add_loft(item, name, run, patches));
          run.clear();
        }
      }
      DOBRA_TRY_VOID(add_loft(item, name, run, patches));
    }
    return patches;
  }

  /// @param way  along the sections, out of the end that is looked at
  void tell_beyond(const std::string& item, const std::vector<const Strand*>& run,
                   const std::vector<std::vector<Point3>>& lines, Vector way, bool high) {
    const Beyond beyond = beyond_ends(lines, way, high);
    if (beyond.off <= uneven_height * made_.size) return;
    uneven_told_ = true;
    tell("uneven",
         fmt::format("{} reaches {:.6g} m farther along the map in section '{}' than in '{}'; beyond the shorter one "
                     "the surface runs to its end. Over {:.4g} m2 of the map its heights are a guess: the shape of the "
                     "longer line, gone on with along the sections, would be up to about {:.3g} m from them here",
                     item, beyond.ahead, made_.sections[run[beyond.longer]->section].name,
                     made_.sections[run[beyond.shorter]->section].name, beyond.area, beyond.off),
         place_at(beyond.at, item));
  }

  /// Horizons are joined by place. Nothing, which is by their length, for faults and where a horizon turns back along
  /// the common direction of the traces; then ends that are not beside each other are told.
  LineParts horizon_parts(const std::string& item, const PieceName& name, const std::vector<const Strand*>& run,
                          const std::vector<std::vector<Point3>>& lines) {
    if (!item.starts_with("horizon")) return {};
    Vector way{};
    for (const auto& line : lines) {
      const Vector one{line.back().x - line.front().x, line.back().y - line.front().y};
      if (geom::length(one) > 0.0) way = way + geom::normalised(one);
    }
    if (!(geom::length(way) > 0.0)) return {};
    way = geom::normalised(way);
    if (auto parts = parts_by_place(lines, way, {!name.low.empty(), !name.high.empty()})) {
      if (name.low.empty()) tell_beyond(item, run, lines, -1.0 * way, false);
      if (name.high.empty()) tell_beyond(item, run, lines, way, true);
      return std::move(*parts);
    }
    for (const bool high : {false, true}) {
      if (!(high ? name.high : name.low).empty()) continue;
      std::size_t least = 0, most = 0;
      const auto place = [&](std::size_t k) {
        const Point3 p = high ? lines[k].back() : lines[k].front();
        return (p.x - lines[0][0].x) * way.x + (p.y - lines[0][0].y) * way.y;
      };
      for (std::size_t k = 1; k < lines.size(); ++k) {
        if (place(k) < place(least)) least = k;
        if (place(k) > place(most)) most = k;
      }
      if (place(most) - place(least) <= uneven_end * made_.size) continue;
      tell("uneven",
           fmt::format("{} turns back along the sections, so that its lines are joined by parts of their lengths; its "
                       "ends in '{}' and '{}' are {:.6g} m apart along them, and heights between the sections are off",
                       item, made_.sections[run[least]->section].name, made_.sections[run[most]->section].name,
                       place(most) - place(least)),
           place_at(high ? lines[most].back() : lines[most].front(), item));
    }
    return {};
  }

  /// Lines by place run one way, and so must the surface.
  /// @param missed  whether its lines do not meet where the traces cross
  void tell_turned(const std::string& item, const Patch& patch, bool missed) {
    const auto area = [&](const std::array<std::uint32_t, 3>& t) {
      const Point3 a = patch.points[t[0]], b = patch.points[t[1]], c = patch.points[t[2]];
      return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    };
    double sum = 0.0, all = 0.0;
    for (const auto& t : patch.triangles) sum += area(t), all += std::abs(area(t));
    const double turned = 0.5 * (all - std::abs(sum));
    constexpr double rounded = 1e-9;
    if (turned <= rounded * all) return;
    const auto least = [&](const auto& s, const auto& t) {
      return (sum > 0.0 ? area(s) < area(t) : area(s) > area(t));
    };
    const auto& worst = *std::min_element(patch.triangles.begin(), patch.triangles.end(), least);
    tell("turns_back",
         missed ? fmt::format("{}: between the sections its surface turns back over {:.4g} m2 of the map, where areas, "
                              "volumes and new sections are wrong; draw its lines on to where the traces cross",
                              item, turned)
                : fmt::format("{}: between the sections its surface turns back over {:.4g} m2 of the map, where areas, "
                              "volumes and new sections are wrong; draw a section there, or leave out the one whose "
                              "trace is nearest to another one",
                              item, turned),
         place_at(patch.points[worst[0]], item));
  }

  base::Result<void> add_loft(const std::string& item, const PieceName& name, const std::vector<const Strand*>& run,
                              std::vector<Patch>& patches) {
    if (run.empty()) return {};
    const std::string& section = made_.sections[run.front()->section].name;
    if (run.size() == 1) {
      tell("piece_alone",
           fmt::format("{}: {} is in section '{}' and in none beside it; it stays a line there", item,
                       piece_words(name), section),
           place_at(run.front()->points.front(), item));
      return {};
    }
    std::vector<std::vector<Point3>> lines;
    for (const Strand* strand : run) {
      lines.push_back(strand->points);
      if (lines.size() > 1 && item.starts_with("fault")) turn_like(lines[lines.size() - 2], lines.back());
    }
    const LineParts parts = horizon_parts(item, name, run, lines);
    const auto made = loft(lines, parts);
    if (!made) {
      tell("no_surface", fmt::format("{}: {}", item, made.error().message),
           base::located(made.error(), {.item = item}).place.value_or(base::Place{}));
      return {};
    }
    const std::size_t breaks = made->surface.breaks().u.size();
    std::size_t rows = options_.rows;
    while (rows > 1 && 2 * breaks * (run.size() - 1) * rows > options_.triangles) --rows;
    DOBRA_TRY(Patch patch, lattice(made->surface, {{}, made->lines_v, breaks == 2 ? options_.rows : 1, rows}));
    if (!parts.empty()) tell_turned(item, patch, misses(item));
    for (const Strand* strand : run) patch.sections.push_back(strand->section);
    patch.sections_v = made->lines_v;
    patch.low_fault = name.low;
    patch.high_fault = name.high;
    patches.push_back(std::move(patch));
    lines_v_.push_back(made->lines_v);
    return {};
  }

  static constexpr double twin = 1e-9;           // of the size: vertices that are one but for rounding
  static constexpr double uneven_end = 0.001;    // of the size: ends that are beside each other
  static constexpr double uneven_height = 1e-4;  // of the size: heights beyond a shorter line that are told
  static constexpr double greatest_way = 0.05;   // of the size: from the border of a horizon to its fault

  Surfaces made_;
  const ThroughOptions& options_;
  std::vector<std::string> names_;                      // in the order in which sections name them
  std::vector<std::vector<double>> lines_v_;            // of the patches of a row
  std::vector<Unjoined> unjoined_;                      // of a row
  bool uneven_told_ = false;                            // of a row
  std::set<std::pair<PieceName, std::size_t>> passed_;  // pieces that a row lacks at a place and goes on without
};

}  // namespace

base::Result<Surfaces> surfaces_through(std::vector<Section> sections, const ThroughOptions& options) {
  if (sections.empty()) return Error{ErrorCode::BadSection, "no section to lay surfaces through"};
  DOBRA_TRY(Tied tied, tie(std::move(sections), options.ties));
  Surfaces made{{}, std::move(tied.sections), std::move(tied.misties), std::move(tied.findings), 0.0};
  made.size = size_of(made.sections);
  return Through(std::move(made), options).run();
}

}  // namespace dobra::surf::loft
