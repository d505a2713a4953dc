#include "shared/io/brep/brep.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "shared/io/brep/brep_geometry.h"
#include "shared/io/file.h"
#include "shared/io/scan.h"

namespace dobra::io::brep {

using base::Result;

Orientation operator*(Orientation whole, Orientation part) {
  if (whole == Orientation::Forward) return part;
  if (whole != Orientation::Reversed) return whole;
  if (part == Orientation::Forward) return Orientation::Reversed;
  return part == Orientation::Reversed ? Orientation::Forward : part;
}

namespace {

constexpr std::array<const char*, 8> kind_words{"Ve", "Ed", "Wi", "Fa", "Sh", "So", "CS", "Co"};

/// Reads the tables that follow each other; what the shapes refer to is known when they come.
class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : tokens_(text, file) { model_.file = file; }

  Result<Model> read() {
    DOBRA_TRY_VOID(read_header());
    DOBRA_TRY(locations_, read_locations(tokens_));
    DOBRA_TRY(model_.chart_curves, read_curves(tokens_, Room::Chart));
    DOBRA_TRY(model_.curves, read_curves(tokens_, Room::Space));
    DOBRA_TRY(polygons_, pass_over_polygons());
    DOBRA_TRY(traces_, pass_over_traces());
    DOBRA_TRY(model_.surfaces, read_surfaces(tokens_));
    DOBRA_TRY(model_.triangulations, pass_over_triangulations());
    DOBRA_TRY_VOID(tokens_.expect("TShapes"));
    DOBRA_TRY(count_, tokens_.count("the number of shapes", 3));
    while (model_.shapes.size() < count_) {
      DOBRA_TRY(Shape shape, read_shape());
      model_.shapes.push_back(std::move(shape));
    }
    DOBRA_TRY(const std::string_view word, tokens_.word("the whole shape"));
    DOBRA_TRY(model_.root, read_use(word));
    return std::move(model_);
  }

 private:
  Result<void> read_header() {
    if (tokens_.peek() == "DBRep_DrawableShape") DOBRA_TRY_VOID(tokens_.expect("DBRep_DrawableShape"));
    const std::string_view first = tokens_.peek();
    DOBRA_TRY(const std::string_view begin, tokens_.word("'CASCADE Topology'"));
    if (first == "Open") return tokens_.error("this is a binary .brep file; save it in OCCT's text format");
    if (first.starts_with("ISO-10303") || first.starts_with('<'))
      return tokens_.error("this is no OCCT text file but STEP or XML; save it as text .brep");
    if (begin != "CASCADE") return tokens_.error("an OCCT text file begins with 'CASCADE Topology V1', V2 or V3");
    DOBRA_TRY_VOID(tokens_.expect("Topology"));
    DOBRA_TRY(const std::string_view version, tokens_.word("the version"));
    for (const int known : {1, 2, 3}) {
      const std::string said = fmt::format("V{}", known);
      if (version == said || version == said + ',')
        model_.version = known;
      else
        continue;
      tokens_.skip_line();
      return {};
    }
    return tokens_.error(fmt::format("version {} of the format is not known; V1 to V3 are", shown(version)));
  }

  Result<void> pass_over_numbers(std::size_t count, std::string_view what) {
    for (std::size_t i = 0; i < count; ++i) DOBRA_TRY_VOID(tokens_.number(what));
    return {};
  }

  Result<std::size_t> pass_over_polygons() {
    DOBRA_TRY_VOID(tokens_.expect("Polygon3D"));
    DOBRA_TRY(const std::size_t count, tokens_.count("the number of polygons", 3));
    for (std::size_t i = 0; i < count; ++i) {
      DOBRA_TRY(const std::size_t nodes, tokens_.count("the number of nodes", 3));
      DOBRA_TRY(const bool parameters, tokens_.flag("whether there are parameters"));
      DOBRA_TRY_VOID(pass_over_numbers(1 + nodes * (parameters ? 4 : 3), "a polygon"));
    }
    return count;
  }

  Result<std::size_t> pass_over_traces() {
    DOBRA_TRY_VOID(tokens_.expect("PolygonOnTriangulations"));
    DOBRA_TRY(const std::size_t count, tokens_.count("the number of polygons", 4));
    for (std::size_t i = 0; i < count; ++i) {
      DOBRA_TRY(const std::size_t nodes, tokens_.count("the number of nodes", 1));
      DOBRA_TRY_VOID(pass_over_numbers(nodes, "a node"));
      DOBRA_TRY_VOID(tokens_.expect("p"));
      DOBRA_TRY_VOID(tokens_.number("a deflection"));
      DOBRA_TRY(const bool parameters, tokens_.flag("whether there are parameters"));
      if (parameters) DOBRA_TRY_VOID(pass_over_numbers(nodes, "a parameter"));
    }
    return count;
  }

  Result<std::size_t> pass_over_triangulations() {
    DOBRA_TRY_VOID(tokens_.expect("Triangulations"));
    DOBRA_TRY(const std::size_t count, tokens_.count("the number of triangulations", 4));
    for (std::size_t i = 0; i < count; ++i) {
      DOBRA_TRY(const std::size_t nodes, tokens_.count("the number of nodes", 3));
      DOBRA_TRY(const std::size_t triangles, tokens_.count("the number of triangles", 3));
      DOBRA_TRY(const bool chart, tokens_.flag("whether there are parameters"));
      bool normals = false;
      if (model_.version >= 3) {
        DOBRA_TRY(normals, tokens_.flag("whether there are normals"));
      }
      const std::size_t each = 3 + (chart ? 2 : 0) + (normals ? 3 : 0);
      DOBRA_TRY_VOID(pass_over_numbers(1 + nodes * each + 3 * triangles, "a triangulation"));
    }
    return count;
  }

  Result<Placement> read_placement() {
    if (tokens_.peek() == "0") {
      DOBRA_TRY_VOID(tokens_.expect("0"));
      return Placement{};
    }
    DOBRA_TRY(const Index location, tokens_.index("location", locations_.size()));
    return locations_[location];
  }

  Result<Use> read_use(std::string_view word) {
    constexpr std::string_view signs = "+-ie";
    const std::size_t sign = signs.find(word.front());
    Use use;
    long number = 0;
    const char* end = word.data() + word.size();
    const auto [at, bad] = std::from_chars(word.data() + 1, end, number);
    if (sign == std::string_view::npos || bad != std::errc() || at != end)
      return tokens_.error(fmt::format("{} stands where a shape belongs: +, -, i or e and its number", shown(word)));
    // Shapes are numbered from the last to the first.
    const auto known = static_cast<long>(model_.shapes.size());
    const long index = static_cast<long>(count_) - number;
    if (number < 1 || index < 0 || index >= known)
      return tokens_.error(fmt::format("shape {} is not among the {} before this place", number, known));
    use.orientation = static_cast<Orientation>(sign);
    use.shape = static_cast<Index>(index);
    DOBRA_TRY(use.placement, read_placement());
    return use;
  }

  /// Where a vertex lies on curves and surfaces: read over.
  Result<void> pass_over_points_on() {
    while (true) {
      DOBRA_TRY_VOID(tokens_.number("where a vertex lies"));
      DOBRA_TRY(const long kind, tokens_.integer("how a vertex lies on another shape", 0, 3));
      if (kind == 0) return {};
      if (kind == 1) {
        DOBRA_TRY_VOID(tokens_.index("curve", model_.curves.size()));
      } else {
        if (kind == 2) DOBRA_TRY_VOID(tokens_.index("curve of a chart", model_.chart_curves.size()));
        if (kind == 3) DOBRA_TRY_VOID(tokens_.number("where a vertex lies"));
        DOBRA_TRY_VOID(tokens_.index("surface", model_.surfaces.size()));
      }
      DOBRA_TRY_VOID(read_placement());
    }
  }

  Result<void> read_vertex(Shape& shape) {
    DOBRA_TRY(shape.tolerance, tokens_.number("the tolerance of a vertex"));
    Vertex vertex;
    DOBRA_TRY(vertex.at, tokens_.point("a vertex"));
    shape.is = vertex;
    return pass_over_points_on();
  }

  Result<void> read_range(double& from, double& to) {
    DOBRA_TRY(from, tokens_.number("where an edge begins"));
    DOBRA_TRY(to, tokens_.number("where an edge ends"));
    if (!(from < to))
      return tokens_.error(fmt::format("an edge runs from {} to {} of its curve; it must run forward", from, to));
    return {};
  }

  Result<void> read_chart_curve(Edge& edge, bool closed) {
    ChartCurve on;
    DOBRA_TRY(on.curve, tokens_.index("curve of a chart", model_.chart_curves.size()));
    if (closed) {
      DOBRA_TRY(on.reversed, tokens_.index("curve of a chart", model_.chart_curves.size(), Tokens::After::Anything));
      DOBRA_TRY_VOID(tokens_.word("a continuity"));
    }
    DOBRA_TRY(on.surface, tokens_.index("surface", model_.surfaces.size()));
    DOBRA_TRY(on.placement, read_placement());
    DOBRA_TRY_VOID(read_range(on.from, on.to));
    if (model_.version == 2) DOBRA_TRY_VOID(pass_over_numbers(4, "an end of an edge"));
    edge.chart_curves.push_back(on);
    return {};
  }

  Result<void> read_edge(Shape& shape) {
    DOBRA_TRY(shape.tolerance, tokens_.number("the tolerance of an edge"));
    DOBRA_TRY_VOID(tokens_.flag("whether parameters are the same"));
    DOBRA_TRY_VOID(tokens_.flag("whether ranges are the same"));
    Edge edge;
    DOBRA_TRY(edge.degenerated, tokens_.flag("whether an edge is a point"));
    while (true) {
      DOBRA_TRY(const long kind, tokens_.integer("what an edge has", 0, 7));
      if (kind == 0) break;
      if (kind == 1) {
        SpaceCurve curve;
        DOBRA_TRY(curve.curve, tokens_.index("curve", model_.curves.size()));
        DOBRA_TRY(curve.placement, read_placement());
        DOBRA_TRY_VOID(read_range(curve.from, curve.to));
        edge.curve = curve;
      } else if (kind <= 3) {
        DOBRA_TRY_VOID(read_chart_curve(edge, kind == 3));
      } else if (kind == 4) {
        DOBRA_TRY_VOID(tokens_.word("a continuity"));
        for (int side = 0; side < 2; ++side) {
          DOBRA_TRY_VOID(tokens_.index("surface", model_.surfaces.size()));
          DOBRA_TRY_VOID(read_placement());
        }
      } else if (kind == 5) {
        DOBRA_TRY_VOID(tokens_.index("polygon", polygons_));
        DOBRA_TRY_VOID(read_placement());
      } else {
        for (long k = 6; k <= kind; ++k) DOBRA_TRY_VOID(tokens_.index("polygon of a triangulation", traces_));
        DOBRA_TRY_VOID(tokens_.index("triangulation", model_.triangulations));
        DOBRA_TRY_VOID(read_placement());
      }
    }
    shape.is = std::move(edge);
    return {};
  }

  Result<void> read_face(Shape& shape) {
    Face face;
    DOBRA_TRY(const long kind, tokens_.integer("how a face is bounded", 0, 2));
    if (kind < 2) {
      face.natural = kind == 1;
      DOBRA_TRY(shape.tolerance, tokens_.number("the tolerance of a face"));
      if (tokens_.peek() == "0") {
        DOBRA_TRY_VOID(tokens_.expect("0"));
      } else {
        DOBRA_TRY(face.surface, tokens_.index("surface", model_.surfaces.size()));
      }
      DOBRA_TRY(face.placement, read_placement());
    }
    // The flags of the shape, which come next, begin with 0 or 1.
    if (kind == 2 || tokens_.peek() == "2") {
      if (kind < 2) DOBRA_TRY_VOID(tokens_.expect("2"));
      DOBRA_TRY_VOID(tokens_.index("triangulation", model_.triangulations));
    }
    shape.is = face;
    return {};
  }

  Result<Shape> read_shape() {
    Shape shape;
    DOBRA_TRY(const std::string_view word, tokens_.word("a shape"));
    shape.line = tokens_.line();
    const auto* kind = std::find(kind_words.begin(), kind_words.end(), word);
    if (kind == kind_words.end())
      return tokens_.error(fmt::format("{} is no kind of shape: Ve, Ed, Wi, Fa, Sh, So, CS or Co", shown(word)));
    shape.kind = static_cast<ShapeKind>(kind - kind_words.begin());
    if (shape.kind == ShapeKind::Vertex) DOBRA_TRY_VOID(read_vertex(shape));
    if (shape.kind == ShapeKind::Edge) DOBRA_TRY_VOID(read_edge(shape));
    if (shape.kind == ShapeKind::Face) DOBRA_TRY_VOID(read_face(shape));
    DOBRA_TRY(const std::string_view flags, tokens_.word("the flags of a shape"));
    if (flags.size() != 7 || flags.find_first_not_of("01") != std::string_view::npos)
      return tokens_.error(fmt::format("{} stands where the seven flags of a shape belong, each 0 or 1", shown(flags)));
    while (true) {
      DOBRA_TRY(const std::string_view part, tokens_.word("the parts of a shape"));
      if (part == "*") return shape;
      DOBRA_TRY(const Use use, read_use(part));
      const ShapeKind used = model_.shapes[use.shape].kind;
      if (used >= shape.kind && shape.kind != ShapeKind::Compound)
        return tokens_.error(fmt::format("a shape of kind {} cannot be a part of one of kind {}",
                                         kind_words[static_cast<std::size_t>(used)], word));
      shape.parts.push_back(use);
    }
  }

  Tokens tokens_;
  Model model_;
  std::vector<Placement> locations_;
  std::size_t count_ = 0, polygons_ = 0, traces_ = 0;
};

}  // namespace

Result<Model> parse_brep(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  return Reader(text, file).read();
}

Result<Model> read_brep(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_brep(text, path);
}

}  // namespace dobra::io::brep
