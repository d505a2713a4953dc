#include "shared/io/drawings/dxf_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include "shared/base/text.h"
#include "shared/io/dxf_pairs.h"

// 1. Group codes into entities. 2. Each entity into pieces, those of a mirrored plane mirrored. 3. Names.

namespace dobra::io::drawings {
namespace {

using geom::Point;
using geom::Vector;

constexpr double full_turn = 2.0 * std::numbers::pi;

/// The pairs of one entity, those of a POLYLINE without its vertices.
struct Entity {
  std::string type;
  std::vector<std::pair<int, std::string>> pairs;

  [[nodiscard]] double number(int code, double unsaid = 0.0) const {
    for (const auto& [c, value] : pairs) {
      if (c == code) return base::parse_number(value).value_or(unsaid);
    }
    return unsaid;
  }
  [[nodiscard]] int flags() const { return static_cast<int>(std::clamp(number(70), 0.0, 1e6)); }
  [[nodiscard]] Point point(int code) const { return {number(code), number(code + 10)}; }
  [[nodiscard]] std::string layer() const {
    for (const auto& [c, value] : pairs) {
      if (c == 8) return value;
    }
    return {};
  }
  /// +1 or -1 for a plane seen from above or from below; 0 for any other.
  [[nodiscard]] int facing() const {
    if (number(210) != 0.0 || number(220) != 0.0) return 0;
    return number(230, 1.0) > 0.0 ? 1 : -1;
  }
};

std::vector<Entity> entities_of(std::string_view text) {
  std::vector<Entity> entities;
  std::string section;
  bool names_section = false;
  DxfPairs pairs(text, {});
  while (pairs.next()) {
    const int code = pairs.code;
    std::string value(pairs.value);
    if (code == 0) {
      names_section = value == "SECTION";
      if (value == "ENDSEC") section.clear();
      if (section == "ENTITIES") entities.push_back({value, {}});
    } else if (names_section && code == 2) {
      section = value;
      names_section = false;
    } else if (section == "ENTITIES" && !entities.empty()) {
      entities.back().pairs.emplace_back(code, std::move(value));
    }
  }
  return entities;
}

Point on_ellipse(const SvgPiece& arc, double t) { return arc.centre + std::cos(t) * arc.u + std::sin(t) * arc.v; }

SvgPiece straight(Point from, Point to) { return {SvgPieceKind::Line, from, to, {}, {}, {}, {}, 0.0, 0.0}; }

/// Its ends follow from the rest; a full turn ends where it starts.
SvgPiece arc_piece(Point centre, Vector u, Vector v, double start, double sweep) {
  SvgPiece arc{SvgPieceKind::Arc, {}, {}, {}, centre, u, v, start, sweep};
  arc.from = on_ellipse(arc, start);
  arc.to = std::abs(sweep) >= full_turn ? arc.from : on_ellipse(arc, start + sweep);
  return arc;
}

/// From one angle anticlockwise to another.
double sweep_between(double start, double end) {
  double sweep = std::fmod(end - start, full_turn);
  if (sweep <= 1e-12) sweep += full_turn;
  return sweep;
}

struct Vertex {
  Point at;
  double bulge = 0.0;  ///< Tangent of a quarter of the angle to the next vertex.
};

SvgPath path_through(const std::vector<Vertex>& vertices, bool closed) {
  SvgPath path;
  path.closed = closed;
  const std::size_t count = vertices.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
    const auto& [p, bulge] = vertices[i];
    const Point q = vertices[(i + 1) % count].at;
    if (p == q) continue;
    if (bulge == 0.0) {
      path.pieces.push_back(straight(p, q));
      continue;
    }
    const Vector chord = q - p;
    const Point centre = midpoint(p, q) + ((1.0 - bulge * bulge) / (4.0 * bulge)) * Vector{-chord.y, chord.x};
    const double radius = distance(centre, p);
    SvgPiece arc = arc_piece(centre, {radius, 0.0}, {0.0, radius}, std::atan2(p.y - centre.y, p.x - centre.x),
                             4.0 * std::atan(bulge));
    arc.from = p;
    arc.to = q;
    path.pieces.push_back(arc);
  }
  if (!closed && !path.pieces.empty())
    path.closed = path.pieces.size() > 1 && path.pieces.front().from == path.pieces.back().to;
  return path;
}

std::vector<Vertex> vertices_of(const Entity& line) {
  std::vector<Vertex> vertices;
  for (const auto& [code, value] : line.pairs) {
    const double number = base::parse_number(value).value_or(0.0);
    if (code == 10) vertices.push_back({{number, 0.0}, 0.0});
    if (code == 20 && !vertices.empty()) vertices.back().at.y = number;
    if (code == 42 && !vertices.empty()) vertices.back().bulge = number;
  }
  return vertices;
}

/// The piece seen from below: x turned about.
void mirror(SvgPath& path) {
  for (SvgPiece& piece : path.pieces) {
    for (Point* p : {&piece.from, &piece.to, &piece.centre}) p->x = -p->x;
    for (Vector* v : {&piece.u, &piece.v}) v->x = -v->x;
  }
}

bool is_level_zero(const Entity& entity) {
  return std::all_of(entity.pairs.begin(), entity.pairs.end(), [](const auto& pair) {
    const bool height = pair.first == 30 || pair.first == 31 || pair.first == 38;
    return !height || base::parse_number(pair.second).value_or(0.0) == 0.0;
  });
}

/// A B-spline of degree 1 to 3.
struct Spline {
  std::size_t degree = 0;
  std::vector<double> knots;
  std::vector<Point> control;

  /// The blossom of the polynomial between knots k and k + 1: its Bezier points are those of arguments at these knots.
  [[nodiscard]] Point blossom(std::size_t k, const std::array<double, 3>& arguments) const {
    std::array<Point, 4> d{};
    for (std::size_t i = 0; i <= degree; ++i) d[i] = control[k - degree + i];
    for (std::size_t r = 1; r <= degree; ++r) {
      for (std::size_t i = 0; i + r <= degree; ++i) {
        const double low = knots[k - degree + r + i], high = knots[k + 1 + i];
        d[i] = interpolate(d[i], d[i + 1], (arguments[r - 1] - low) / (high - low));
      }
    }
    return d[0];
  }
};

/// Nothing for a spline that is rational, of another degree, given by fit points alone, or not consistent.
std::optional<Spline> spline_of(const Entity& entity) {
  Spline spline;
  std::vector<double> weights;
  for (const auto& [code, value] : entity.pairs) {
    const double number = base::parse_number(value).value_or(0.0);
    if (code == 40) spline.knots.push_back(number);
    if (code == 41) weights.push_back(number);
    if (code == 10) spline.control.push_back({number, 0.0});
    if (code == 20 && !spline.control.empty()) spline.control.back().y = number;
  }
  const double degree = entity.number(71);
  if (degree != 1.0 && degree != 2.0 && degree != 3.0) return std::nullopt;
  spline.degree = static_cast<std::size_t>(degree);
  const bool fits =
      spline.control.size() > spline.degree && spline.knots.size() == spline.control.size() + spline.degree + 1;
  const bool ascending = std::is_sorted(spline.knots.begin(), spline.knots.end());
  const bool rational =
      std::any_of(weights.begin(), weights.end(), [&](double weight) { return weight != weights.front(); });
  if (!fits || !ascending || rational) return std::nullopt;
  return spline;
}

/// Whether `piece` leaves in the direction in which `before` arrives.
bool is_smooth(const SvgPiece& before, const SvgPiece& piece) {
  if (before.kind != SvgPieceKind::Cubic || piece.kind != SvgPieceKind::Cubic) return false;
  constexpr double parallel = 1e-9;
  const Vector u = before.to - before.control[1];
  const Vector v = piece.control[0] - piece.from;
  return dot(u, v) > 0.0 && std::abs(cross(u, v)) <= parallel * length(u) * length(v);
}

std::optional<SvgPath> spline_path(const Entity& entity) {
  const auto spline = spline_of(entity);
  if (!spline) return std::nullopt;
  SvgPath path;
  double extent = 0.0;
  for (std::size_t k = spline->degree; k < spline->control.size(); ++k) {
    const double a = spline->knots[k], b = spline->knots[k + 1];
    if (!(a < b)) continue;
    const Point begin = spline->blossom(k, {a, a, a});
    const Point from = path.pieces.empty() ? begin : path.pieces.back().to;
    if (distance(from, begin) > 1e-9 * (extent + distance(from, begin))) return std::nullopt;  // it jumps
    SvgPiece piece = straight(from, spline->blossom(k, {b, b, b}));
    extent += distance(piece.from, piece.to);
    if (spline->degree > 1) piece.kind = SvgPieceKind::Cubic;
    if (spline->degree == 2) {
      const Point corner = spline->blossom(k, {a, b, b});
      piece.control = {interpolate(piece.from, corner, 2.0 / 3.0), interpolate(piece.to, corner, 2.0 / 3.0)};
    }
    if (spline->degree == 3) piece.control = {spline->blossom(k, {a, a, b}), spline->blossom(k, {a, b, b})};
    piece.goes_on = !path.pieces.empty() && is_smooth(path.pieces.back(), piece);
    path.pieces.push_back(piece);
  }
  if (path.pieces.empty()) return std::nullopt;
  constexpr double same = 1e-9;
  path.closed = path.pieces.size() > 1 && distance(path.pieces.front().from, path.pieces.back().to) <= same * extent;
  if (path.closed) path.pieces.back().to = path.pieces.front().from;
  if ((entity.flags() & 1) != 0 && !path.closed) return std::nullopt;
  return path;
}

/// The path of an entity but POLYLINE; nothing for another type.
std::optional<SvgPath> path_of(const Entity& entity) {
  SvgPath path;
  constexpr double degree = std::numbers::pi / 180.0;
  if (entity.type == "LINE") {
    path.pieces.push_back(straight(entity.point(10), entity.point(11)));
  } else if (entity.type == "CIRCLE" || entity.type == "ARC") {
    const double radius = entity.number(40);
    const double start = entity.type == "ARC" ? entity.number(50) * degree : 0.0;
    const double sweep = entity.type == "ARC" ? sweep_between(start, entity.number(51) * degree) : full_turn;
    path.pieces.push_back(arc_piece(entity.point(10), {radius, 0.0}, {0.0, radius}, start, sweep));
    path.closed = sweep >= full_turn;
  } else if (entity.type == "ELLIPSE") {
    const Vector u = entity.point(11) - Point{};
    const double start = entity.number(41);
    const double sweep = sweep_between(start, entity.number(42, full_turn));
    path.pieces.push_back(
        arc_piece(entity.point(10), u, entity.number(40, 1.0) * entity.facing() * Vector{-u.y, u.x}, start, sweep));
    path.closed = sweep >= full_turn;
  } else if (entity.type == "LWPOLYLINE") {
    path = path_through(vertices_of(entity), (entity.flags() & 1) != 0);
  } else if (entity.type == "SPLINE") {
    return spline_path(entity);
  } else {
    return std::nullopt;
  }
  return path;
}

bool holds_no_line(const std::string& type) {
  return type == "POINT" || type == "TEXT" || type == "MTEXT" || type == "VIEWPORT" || type == "SEQEND" ||
         type == "ENDSEC" || type == "EOF";
}

}  // namespace

std::optional<std::vector<SvgPath>> dxf_paths(std::string_view text, const std::string& file) {
  const std::vector<Entity> entities = entities_of(text);
  const std::set<std::string> hidden_layers = hidden_dxf_layers(text);
  std::vector<SvgPath> paths;
  std::map<std::string, std::size_t> used;
  bool bent = false;
  for (std::size_t i = 0; i < entities.size(); ++i) {
    const Entity& entity = entities[i];
    if (holds_no_line(entity.type)) continue;
    if (hidden_layers.contains(entity.layer()) || entity.number(60) == 1.0) {
      while (i + 1 < entities.size() && entities[i + 1].type == "VERTEX") ++i;
      continue;
    }
    if (entity.facing() == 0 || !is_level_zero(entity) || entity.number(67) != 0.0) return std::nullopt;
    std::optional<SvgPath> path;
    if (entity.type == "POLYLINE") {
      if ((entity.flags() & ~(1 | 128)) != 0) return std::nullopt;
      std::vector<Vertex> vertices;
      while (i + 1 < entities.size() && entities[i + 1].type == "VERTEX") {
        const Entity& vertex = entities[++i];
        if (vertex.flags() != 0 || !is_level_zero(vertex)) return std::nullopt;
        vertices.push_back({vertex.point(10), vertex.number(42)});
      }
      path = path_through(vertices, (entity.flags() & 1) != 0);
    } else {
      path = path_of(entity);
    }
    if (!path || path->pieces.empty()) return std::nullopt;
    if (entity.facing() < 0 && entity.type != "LINE" && entity.type != "ELLIPSE" && entity.type != "SPLINE")
      mirror(*path);
    bent = bent || std::any_of(path->pieces.begin(), path->pieces.end(),
                               [](const SvgPiece& piece) { return piece.kind != SvgPieceKind::Line; });
    const std::string layer = entity.layer();
    const bool unnamed = layer.empty() || layer == "0";
    const std::size_t number = unnamed ? 0 : ++used[layer];
    path->name = unnamed       ? fmt::format("curve {}", paths.size() + 1)
                 : number == 1 ? layer
                               : fmt::format("{} {}", layer, number);
    path->place = base::Place{.file = file, .item = {}};
    paths.push_back(*std::move(path));
  }
  if (!bent) return std::nullopt;
  return paths;
}

}  // namespace dobra::io::drawings
