#include "quebra/surfaces/surface_input.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "quebra/surfaces/common_borders.h"
#include "quebra/surfaces/trimming.h"
#include "shared/base/text.h"
#include "shared/surf/graph_flaws.h"
#include "shared/surf/trim/rings.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using surf::Curve;
using surf::Surface;

namespace {

/// Whether a message speaks of a key: as a word, one of a letter or two in quotes.
bool speaks_of(const std::string& message, const std::string& key) {
  if (message.find('`' + key + '`') != std::string::npos) return true;
  if (key.size() < 3) return false;
  const auto in_word = [&](std::size_t i) {
    return i < message.size() && (std::isalnum(static_cast<unsigned char>(message[i])) != 0 || message[i] == '_');
  };
  for (std::size_t at = message.find(key); at != std::string::npos; at = message.find(key, at + 1)) {
    if ((at == 0 || !in_word(at - 1)) && !in_word(at + key.size())) return true;
  }
  return false;
}

/// The points of curves and surfaces that are given by some, with the lines between them.
void add_controls(const SurfaceInput& input, Surfaces& made) {
  const auto add = [&](const char* table, const std::string& name, std::size_t entry,
                       const std::vector<geom::Point3>& points) {
    const std::size_t first = made.controls.size();
    for (std::size_t i = 0; i < points.size(); ++i) made.controls.push_back({table, name, entry, i, points[i]});
    return first;
  };
  const auto line = [&](std::size_t first, std::size_t count, std::size_t step) {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers.push_back(first + i * step);
    made.control_lines.push_back(std::move(numbers));
  };
  for (std::size_t i = 0; i < input.space_curves.size(); ++i) {
    const SpaceCurveParams& curve = input.space_curves[i];
    if (curve.kind == SpaceCurveKind::Circle) continue;
    line(add("space_curve", curve.name, i, curve.points), curve.points.size(), 1);
  }
  for (std::size_t i = 0; i < input.surfaces.size(); ++i) {
    const SurfaceParams& surface = input.surfaces[i];
    if (surface.kind != SurfaceKind::Nurbs && surface.kind != SurfaceKind::Through) continue;
    const std::size_t first = add("surface", surface.name, i, surface.points);
    const std::size_t rows = rows_of(surface);
    if (rows == 0 || surface.points.size() % rows != 0) continue;
    const std::size_t columns = surface.points.size() / rows;
    for (std::size_t r = 0; r < rows; ++r) line(first + r * columns, columns, 1);
    for (std::size_t c = 0; c < columns; ++c) line(first + c, rows, columns);
  }
}

const char* words_of(surf::GraphFlawKind kind) {
  switch (kind) {
    case surf::GraphFlawKind::Jump:
      return "the `formula` jumps here: make two surfaces of it whose ranges `u` and `v` end before the jump";
    case surf::GraphFlawKind::Pole:
      return "the `formula` grows without bound here: end the ranges `u` and `v` before it";
    case surf::GraphFlawKind::Steep:
      return "the slope of the `formula` or its bend grows without bound here: end the ranges `u` and `v` before it";
    case surf::GraphFlawKind::NoValue:
      return "the `formula` has no value here: end the ranges `u` and `v` before it";
    case surf::GraphFlawKind::Kink:
      return "the `formula` has a kink here that runs neither along x nor along y, which the mesh cannot follow: make "
             "two surfaces of it that meet there, each of a formula without it";
  }
  return "";
}

/// Makes the faces; each step has the line of the table that it is about.
class SurfaceMaker {
 public:
  SurfaceMaker(const SurfaceInput& input, const scenario::Table& table, const scenario::UnitSystem& units)
      : input_(input), table_(table), units_(units) {}

  Result<Surfaces> run() {
    DOBRA_TRY_VOID(make_curves());
    DOBRA_TRY_VOID(make_all());
    DOBRA_TRY_VOID(check_owners());
    Surfaces made;
    surf::trim::SharedNumbers numbers;
    std::int32_t regions = 0;  // so many tags are taken
    for (std::size_t s = 0; s < input_.surfaces.size(); ++s) {
      if (input_.surfaces[s].use == SurfaceUse::Tool) continue;
      DOBRA_TRY(surf::trim::TrimmedSurface face, trimmed(s, numbers, made));
      if (input_.surfaces[s].kind == SurfaceKind::Graph) DOBRA_TRY_VOID(look_at_formula(s, face, made));
      std::int32_t greatest = regions;
      for (auto& region : face.regions) greatest = std::max(greatest, region.region += regions);
      regions = greatest;
      face.reversed = input_.surfaces[s].facing == Facing::Against;
      face.place = place("surface", s);
      face.place.item.clear();
      made.faces.push_back(std::move(face));
      made.units.push_back(chart_units(input_.surfaces[s].kind, units_));
    }
    sort_chosen(made.chosen);
    add_controls(input_, made);
    share_borders(made.faces, made.findings);
    return made;
  }

  /// Whatever can be drawn.
  Surfaces drawn() {
    Surfaces made;
    for (const SpaceCurveParams& params : input_.space_curves) {
      if (auto curve = make_space_curve(params)) curves_.emplace(params.name, *std::move(curve));
    }
    std::map<std::string, Surface> all;
    for (const SurfaceParams& params : input_.surfaces) {
      std::vector<Curve> curves;
      for (const std::string& name : params.curves) {
        if (const auto known = curves_.find(name); known != curves_.end()) curves.push_back(known->second);
      }
      if (curves.size() != params.curves.size()) continue;
      if (auto surface = make_surface(params, curves)) all.emplace(params.name, *std::move(surface));
    }
    const bool one = std::count_if(input_.surfaces.begin(), input_.surfaces.end(),
                                   [](const auto& params) { return params.use == SurfaceUse::Mesh; }) == 1;
    surf::trim::SharedNumbers numbers;
    for (const SurfaceParams& params : input_.surfaces) {
      const auto surface = all.find(params.name);
      if (params.use == SurfaceUse::Tool || surface == all.end()) continue;
      auto whole = surf::trim::recognise(surface->second, std::span<const surf::trim::TrimLine>{}, numbers);
      if (!whole || whole->faces().empty()) continue;
      surf::trim::TrimmedSurface face = whole->faces().front();
      face.name = params.name;
      const ChartUnits own = chart_units(params.kind, units_);
      Trimming lines(surface->second, params.name, own);
      for (const TrimParams& trim : input_.trims) {
        if (trim.surface.empty() ? !one : trim.surface != params.name) continue;
        const auto tool = all.find(trim.tool);
        (void)lines.add(trim, tool == all.end() ? std::nullopt : std::optional(tool->second));  // or it is left out
      }
      face.lines = lines.drawn_lines();
      made.faces.push_back(std::move(face));
      made.units.push_back(own);
    }
    add_controls(input_, made);
    return made;
  }

 private:
  [[nodiscard]] const scenario::Table& row(const char* key, std::size_t i) const {
    return std::get<std::vector<scenario::Table>>(*table_.find(key))[i];
  }
  [[nodiscard]] Place place(const char* key, std::size_t i) const {
    const scenario::Value* rows = table_.find(key);
    Place at = rows == nullptr ? Place{} : row(key, i).own_place;
    at.item = item(key, i);
    return at;
  }
  [[nodiscard]] std::string item(const std::string& key, std::size_t i) const {
    if (key == "space_curve") return fmt::format("space curve '{}'", input_.space_curves[i].name);
    if (key == "surface") return fmt::format("surface '{}'", input_.surfaces[i].name);
    if (key == "trim") return fmt::format("trim '{}'", input_.trims[i].name);
    if (key == "surface_point") return fmt::format("point '{}'", input_.surface_points[i].name);
    return fmt::format("{} {}", key, i + 1);
  }
  /// With the line of the key that the message names, "knots_u", if the table has it.
  [[nodiscard]] Error at_line(const Error& error, const char* key, std::size_t i) const {
    Place at = place(key, i);
    if (table_.find(key) != nullptr) {
      std::size_t longest = 0;
      for (const auto& entry : row(key, i).entries()) {
        if (entry.key.size() <= longest || !speaks_of(error.message, entry.key)) continue;
        longest = entry.key.size();
        at.line = entry.place.line, at.column = entry.place.column;
      }
    }
    return base::located(error, at);
  }

  Result<void> make_curves() {
    for (std::size_t i = 0; i < input_.space_curves.size(); ++i) {
      auto curve = make_space_curve(input_.space_curves[i]);
      if (!curve) return at_line(curve.error(), "space_curve", i);
      if (!curves_.emplace(input_.space_curves[i].name, *std::move(curve)).second)
        return Error{ErrorCode::BadValue, "two space curves have this name; names must differ",
                     place("space_curve", i)};
    }
    return {};
  }

  Result<void> make_all() {
    for (std::size_t i = 0; i < input_.surfaces.size(); ++i) {
      const SurfaceParams& params = input_.surfaces[i];
      std::vector<Curve> curves;
      for (const std::string& name : params.curves) {
        const auto known = curves_.find(name);
        if (known == curves_.end())
          return at_line(unknown("curves", "space curve", name, names_of(curves_)), "surface", i);
        curves.push_back(known->second);
      }
      auto surface = make_surface(params, curves);
      if (!surface) {
        Error error = surface.error();
        if (error.place) error.place->item.clear();  // its kind; its name says more
        return at_line(error, "surface", i);
      }
      if (!number_.emplace(params.name, i).second)
        return Error{ErrorCode::BadValue, "two surfaces have this name; names must differ", place("surface", i)};
      DOBRA_TRY_VOID(near_enough(*surface, i));
      surfaces_.push_back(*std::move(surface));
    }
    return {};
  }

  /// Places beside each other on the surface are different numbers.
  [[nodiscard]] Result<void> near_enough(const Surface& surface, std::size_t i) const {
    constexpr double finest = 1e-8;  // of the surface
    const geom::Point3 p = surface.at(surface.chart().centre());
    const double far = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const double apart = std::numeric_limits<double>::epsilon() * far;
    if (!(apart > finest * surface.size())) return {};
    return at_line({ErrorCode::BadValue,
                    fmt::format("the surface lies {:.3g} m from the `origin` of space and is {:.3g} m large: numbers "
                                "there are {:.3g} m apart; move it nearer",
                                far, surface.size(), apart)},
                   "surface", i);
  }

  template <class T>
  static std::vector<std::string> names_of(const std::map<std::string, T>& all) {
    std::vector<std::string> names;
    for (const auto& [name, value] : all) names.push_back(name);
    return names;
  }
  static Error unknown(const char* key, const char* what, const std::string& name,
                       const std::vector<std::string>& known) {
    std::string hint = base::did_you_mean(name, known);
    if (hint.empty() && !known.empty()) hint = fmt::format("; there are: {}", fmt::join(known, ", "));
    return {ErrorCode::BadValue, fmt::format("`{}`: there is no {} '{}'{}", key, what, name, hint)};
  }

  /// The surface that a trim, part or point lies on.
  [[nodiscard]] Result<std::size_t> owner(const std::string& name) const {
    std::vector<std::string> meshed;
    for (const SurfaceParams& params : input_.surfaces)
      if (params.use == SurfaceUse::Mesh) meshed.push_back(params.name);
    if (name.empty()) {
      if (meshed.size() == 1) return number_.at(meshed[0]);
      return Error{ErrorCode::MissingKey, fmt::format("`surface` is needed: {} surfaces are meshed", meshed.size())};
    }
    const auto known = number_.find(name);
    if (known == number_.end()) return unknown("surface", "surface", name, names_of(number_));
    if (input_.surfaces[known->second].use == SurfaceUse::Tool)
      return Error{ErrorCode::BadValue, fmt::format("`surface`: '{}' is a tool and is not meshed", name)};
    return known->second;
  }

  Result<void> check_owners() {
    const auto check = [&](const auto& rows, const char* key, auto& owners) -> Result<void> {
      for (std::size_t i = 0; i < rows.size(); ++i) {
        auto surface = owner(rows[i].surface);
        if (!surface) return at_line(surface.error(), key, i);
        owners.push_back(*surface);
      }
      return {};
    };
    DOBRA_TRY_VOID(check(input_.trims, "trim", trim_owner_));
    DOBRA_TRY_VOID(check(input_.parts, "part", part_owner_));
    DOBRA_TRY_VOID(check(input_.surface_points, "surface_point", point_owner_));
    std::set<std::string> names;
    for (std::size_t i = 0; i < input_.trims.size(); ++i) {
      if (!names.insert(input_.trims[i].name).second)
        return Error{ErrorCode::BadValue, "two trims have this name; names must differ", place("trim", i)};
    }
    return {};
  }

  Result<surf::trim::TrimmedSurface> trimmed(std::size_t s, surf::trim::SharedNumbers& numbers, Surfaces& made) const {
    const ChartUnits units = chart_units(input_.surfaces[s].kind, units_);
    Trimming work(surfaces_[s], input_.surfaces[s].name, units);
    for (std::size_t i = 0; i < input_.trims.size(); ++i) {
      if (trim_owner_[i] != s) continue;
      const TrimParams& trim = input_.trims[i];
      std::optional<Surface> tool;
      if (trim.kind == TrimKind::Surface) {
        const auto known = number_.find(trim.tool);
        if (known == number_.end()) return at_line(unknown("tool", "surface", trim.tool, names_of(number_)), "trim", i);
        if (known->second == s)
          return at_line({ErrorCode::BadValue, "`tool`: a surface does not cut itself"}, "trim", i);
        tool = surfaces_[known->second];
      }
      if (const auto added = work.add(trim, tool); !added) return at_line(added.error(), "trim", i);
    }
    for (std::size_t i = 0; i < input_.parts.size(); ++i) {
      if (part_owner_[i] != s) continue;
      if (const auto added = work.add(input_.parts[i]); !added) return at_line(added.error(), "part", i);
    }
    for (std::size_t i = 0; i < input_.surface_points.size(); ++i) {
      if (point_owner_[i] != s) continue;
      if (const auto added = work.add(input_.surface_points[i]); !added)
        return at_line(added.error(), "surface_point", i);
    }
    model::SurfaceParts parts;
    auto face = work.face(numbers, made.findings, parts);
    if (!face) return base::located(face.error(), place("surface", s));
    made.parts.push_back(std::move(parts));
    std::vector<model::ChosenPart> chosen = work.chosen(made.parts.size() - 1);
    made.chosen.insert(made.chosen.end(), chosen.begin(), chosen.end());
    return face;
  }

  /// Where a formula is not smooth. Across a jump or a pole nothing is measured, trimmed away or not; kinks count where
  /// the surface is left, and one alone is a point, as that of a cone.
  Result<void> look_at_formula(std::size_t s, const surf::trim::TrimmedSurface& face, Surfaces& made) const {
    DOBRA_TRY(const surf::GraphFlaws found, surf::graph_flaws(input_.surfaces[s].formula, face.surface.chart()));
    const std::vector<surf::trim::Ring> rings = surf::trim::rings_of(face);
    std::vector<Place> kinks;
    for (const surf::GraphFlaw& flaw : found.flaws) {
      const geom::Point3 p = face.surface.at(flaw.at);
      Place where{.x = p.x, .y = p.y, .u = flaw.at.x, .v = flaw.at.y};
      if (std::isfinite(p.z)) where.z = p.z;
      if (flaw.kind != surf::GraphFlawKind::Kink)
        return at_line({ErrorCode::OutsideDomain, words_of(flaw.kind), where}, "surface", s);
      const std::vector<double> at = surf::trim::meets(rings, flaw.at.y);
      if (std::count_if(at.begin(), at.end(), [&](double u) { return u < flaw.at.x; }) % 2 == 1) kinks.push_back(where);
    }
    if (kinks.size() > 1)
      return at_line({ErrorCode::OutsideDomain, words_of(surf::GraphFlawKind::Kink), kinks[0]}, "surface", s);
    if (!kinks.empty())
      made.findings.push_back(
          {"kink", "the `formula` has a point here, where the mesh has no node of its own", kinks[0]});
    return {};
  }

  /// In the order of the document, where parts of several surfaces may follow each other in any order.
  void sort_chosen(std::vector<model::ChosenPart>& chosen) const {
    std::vector<std::size_t> order;  // of the document's entries, as they were chosen: surface by surface
    for (std::size_t s = 0; s < input_.surfaces.size(); ++s) {
      for (std::size_t i = 0; i < part_owner_.size(); ++i) {
        if (part_owner_[i] == s) order.push_back(i);
      }
    }
    std::vector<model::ChosenPart> sorted(chosen.size());
    for (std::size_t k = 0; k < order.size(); ++k) sorted[order[k]] = chosen[k];
    chosen = std::move(sorted);
  }

  const SurfaceInput& input_;
  const scenario::Table& table_;
  const scenario::UnitSystem& units_;
  std::map<std::string, Curve> curves_;
  std::map<std::string, std::size_t> number_;
  std::vector<Surface> surfaces_;
  std::vector<std::size_t> trim_owner_, part_owner_, point_owner_;
};

}  // namespace

Result<Surfaces> make_surfaces(const SurfaceInput& input, const scenario::Table& table,
                               const scenario::UnitSystem& units) {
  return SurfaceMaker(input, table, units).run();
}

Surfaces drawn_surfaces(const SurfaceInput& input, const scenario::Table& table, const scenario::UnitSystem& units) {
  return SurfaceMaker(input, table, units).drawn();
}

}  // namespace quebra::surfaces
