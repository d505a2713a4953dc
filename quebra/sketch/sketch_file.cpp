#include "quebra/sketch/sketch_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>

#include "quebra/sketch/geo_sketch.h"
#include "quebra/sketch/svg_sketch.h"
#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/formats/curves.h"
#include "shared/io/formats/drawing.h"
#include "shared/io/formats/mesh_file.h"

namespace quebra::sketch {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::geom::Point;
using dobra::geom::Polyline;

/// The segments of a file joined into chains wherever just two with the same marker meet.
class Chains {
 public:
  explicit Chains(const dobra::io::meshes::PolyFile& file) : file_(file), used_(file.segments.size(), false) {
    for (std::size_t i = 0; i < file.segments.size(); ++i) {
      for (const std::uint32_t node : file.segments[i]) at_[node].push_back(i);
    }
  }

  /// Of each curve that curves() returned.
  [[nodiscard]] const std::vector<std::int64_t>& markers() const { return markers_; }

  std::vector<Curve> curves() {
    std::vector<Curve> result;
    // Chains with ends first, so that what is left over is closed.
    for (std::size_t i = 0; i < file_.segments.size(); ++i) {
      for (const std::uint32_t node : file_.segments[i]) {
        if (!used_[i] && !goes_on(node, i)) result.push_back(follow(i, node, result.size()));
      }
    }
    for (std::size_t i = 0; i < file_.segments.size(); ++i) {
      if (!used_[i]) result.push_back(follow(i, file_.segments[i][0], result.size()));
    }
    return result;
  }

 private:
  [[nodiscard]] std::int64_t marker(std::size_t segment) const {
    return file_.segment_markers.empty() ? 0 : file_.segment_markers[segment];
  }

  /// The other segment of the chain at `node`, if the chain goes on there.
  [[nodiscard]] std::optional<std::size_t> goes_on(std::uint32_t node, std::size_t segment) const {
    const auto& meeting = at_.at(node);
    if (meeting.size() != 2) return std::nullopt;
    const std::size_t other = meeting[0] == segment ? meeting[1] : meeting[0];
    if (marker(other) != marker(segment)) return std::nullopt;
    return other;
  }

  Curve follow(std::size_t segment, std::uint32_t node, std::size_t number) {
    Polyline line;
    const std::uint32_t first = node;
    line.points.push_back(file_.nodes.points[node]);
    for (std::optional<std::size_t> next = segment; next && !used_[*next];) {
      segment = *next;
      used_[segment] = true;
      const auto& nodes = file_.segments[segment];
      node = nodes[0] == node ? nodes[1] : nodes[0];
      line.points.push_back(file_.nodes.points[node]);
      next = goes_on(node, segment);
    }
    if (node == first) {
      line.closed = true;
      line.points.pop_back();
    }
    markers_.push_back(marker(segment));
    return {fmt::format("curve_{}_marker_{}", number + 1, marker(segment)), Role::Boundary, std::move(line), {}};
  }

  const dobra::io::meshes::PolyFile& file_;
  std::vector<std::int64_t> markers_;
  std::vector<bool> used_;
  std::map<std::uint32_t, std::vector<std::size_t>> at_;
};

/// @param holes  whether hole points, rather than nesting, tell what is a hole.
Sketch sketch_of_graph(const dobra::io::meshes::PolyFile& file, const std::string& path, bool holes) {
  Sketch sketch;
  sketch.curves = Chains(file).curves();
  for (const Curve& curve : sketch.curves) sketch.without_role.insert(curve.name);
  Place place;
  place.file = path;
  if (holes) sketch.hole_points = HolePoints{sketch.without_role, file.holes, place};
  for (const auto& region : file.regions)
    sketch.regions.push_back({fmt::format("region_{}", dobra::base::number_text(region.attribute)), region.at});
  return sketch;
}

// --- curves without roles
// -----------------------------------------------------------------------------------------------

/// A drawing with its arcs as they are drawn; nothing where chords must do, or no drawing.
Result<std::optional<Sketch>> true_curves(const std::string& path, const dobra::io::formats::Curves& read,
                                          const SketchOptions& options) {
  const dobra::io::formats::LineOptions& lines = options.lines;
  const dobra::io::formats::LineRow& row = *read.format->lines;
  if (row.true_curves == nullptr || lines.coordinates == dobra::io::formats::Coordinates::Map)
    return std::optional<Sketch>();
  DOBRA_TRY(const std::string text, dobra::io::read_text(path));
  auto paths = row.true_curves(text, path);
  if (!paths) return std::optional<Sketch>();
  const bool down = read.y_direction == dobra::io::lines::YDirection::Down;
  const double up = (down ? -1.0 : 1.0) * read.unit / lines.exaggeration;
  const double base = down ? lines.y_reference * read.unit / lines.exaggeration : 0.0;
  for (auto& outline : *paths) {
    for (auto& piece : outline.pieces) {
      scale(piece, read.unit, up);
      for (Point* p : {&piece.from, &piece.to, &piece.control[0], &piece.control[1], &piece.centre}) p->y += base;
    }
    if (options.open_lines == OpenLines::Close && !outline.closed && outline.pieces.size() > 1) {
      outline.pieces.push_back({dobra::io::drawings::SvgPieceKind::Line,
                                outline.pieces.back().to,
                                outline.pieces.front().from,
                                {},
                                {},
                                {},
                                {},
                                0.0,
                                0.0});
      outline.closed = true;
    }
  }
  auto made = sketch_of_paths(*paths);
  if (!made) return std::optional<Sketch>();  // the chords that have been read will do
  Sketch sketch = *std::move(made);
  for (Curve& curve : sketch.curves) {
    curve.role = Role::Boundary;
    sketch.without_role.insert(curve.name);
  }
  for (Area& area : sketch.areas) {
    if (area.name.starts_with("curve ")) area.name.clear();
  }
  sketch.remarks = read.remarks;
  const auto of_chords = [&](const std::string& remark) { return remark.ends_with(row.chords); };
  if (!row.chords.empty()) std::erase_if(sketch.remarks, of_chords);
  return std::optional(std::move(sketch));
}

Result<Sketch> from_curves(const std::string& path, const SketchOptions& options) {
  DOBRA_TRY(dobra::io::formats::Curves read, dobra::io::formats::read_curves(path, options.lines));
  DOBRA_TRY(auto exact, true_curves(path, read, options));
  if (exact) return *std::move(exact);
  Sketch sketch;
  sketch.remarks = std::move(read.remarks);
  std::map<std::string, int> used;
  for (auto& curve : read.curves) {
    // Names may repeat in a file; sets of the mesh must not.
    const int number = ++used[curve.name];
    if (number > 1) curve.name += fmt::format(" ({})", number);
    if (options.open_lines == OpenLines::Close && curve.line.points.size() > 2) curve.line.closed = true;
    if (curve.polygon) {
      if (sketch.areas.size() <= *curve.polygon) sketch.areas.resize(*curve.polygon + 1);
      Area& area = sketch.areas[*curve.polygon];
      area.name = curve.feature;
      area.rings.push_back(curve.name);
      area.outline.push_back(curve.line);
    }
    sketch.without_role.insert(curve.name);
    sketch.curves.push_back({std::move(curve.name), Role::Boundary, std::move(curve.line), {}});
  }
  return sketch;
}

void scale(std::vector<Point>& points, double unit) {
  for (Point& p : points) p = {unit * p.x, unit * p.y};
}

void scale(dobra::io::meshes::PolyFile& file, double unit) {
  scale(file.nodes.points, unit);
  scale(file.holes, unit);
  for (auto& region : file.regions) region.at = {unit * region.at.x, unit * region.at.y};
}

/// Lines, or the graph that the text is instead where the user named no format.
Result<Sketch> from_lines(const std::string& path, const SketchOptions& options) {
  const auto* const format = dobra::io::formats::format_of(path, dobra::io::formats::Use::ReadLines);
  if (options.lines.format != nullptr || format->lines->graph == nullptr) return from_curves(path, options);
  DOBRA_TRY(const std::string text, dobra::io::read_text(path));
  auto graph = format->lines->graph(text, path);
  if (!graph) return from_curves(path, options);
  scale(*graph, options.silent_unit);
  Sketch sketch = sketch_of_graph(*graph, path, false);
  sketch.remarks.push_back(fmt::format("{}: read as {} points and the {} segments between them", path,
                                       graph->nodes.points.size(), graph->segments.size()));
  return sketch;
}

// --- meshes
// ---------------------------------------------------------------------------------------------------------------

/// The boundary of a mesh, its internal sets and its cracks; regions by a point of one of their elements.
Sketch from_mesh(const dobra::mesh::ElementMesh& mesh) {
  using dobra::mesh::ElementSide;
  Sketch sketch;
  dobra::io::meshes::PolyFile file;
  file.nodes.points = mesh.points;
  std::vector<std::string> names{"boundary"};
  std::map<ElementSide, std::int64_t> set_of;
  std::set<std::int64_t> lips;
  for (const auto& [name, sides] : mesh.side_sets) {
    const bool left = name.ends_with("_left") && mesh.side_sets.contains(name.substr(0, name.size() - 5) + "_right");
    const bool right = name.ends_with("_right") && mesh.side_sets.contains(name.substr(0, name.size() - 6) + "_left");
    const auto number = static_cast<std::int64_t>(names.size());
    for (const ElementSide& side : sides) set_of.emplace(side, right ? -1 : number);
    if (left) lips.insert(number);
    names.push_back(left ? name.substr(0, name.size() - 5) : name);
  }
  const auto outer = dobra::mesh::boundary_sides(mesh);
  std::set<std::int64_t> internal;
  const auto add = [&](const ElementSide& side, std::int64_t set) {
    const auto nodes = side_nodes(mesh, side);
    file.segments.push_back(
        {static_cast<std::uint32_t>(nodes[0].index()), static_cast<std::uint32_t>(nodes[1].index())});
    file.segment_markers.push_back(set);
  };
  for (const ElementSide& side : outer) {
    const auto set = set_of.find(side);
    const std::int64_t number = set == set_of.end() ? 0 : set->second;
    if (number >= 0) add(side, number);
  }
  for (const auto& [side, number] : set_of) {
    if (std::binary_search(outer.begin(), outer.end(), side)) continue;
    internal.insert(number);
    add(side, number);
  }
  std::map<std::int64_t, int> used;
  std::size_t at = 0;
  Chains chains(file);
  for (Curve& curve : chains.curves()) {
    const std::int64_t set = chains.markers()[at++];
    curve.role = lips.contains(set) ? Role::Crack : internal.contains(set) ? Role::Internal : Role::Boundary;
    const int number = ++used[set];
    curve.name = names[static_cast<std::size_t>(set)] + (number == 1 ? "" : fmt::format("_{}", number));
    sketch.curves.push_back(std::move(curve));
  }
  for (const auto& [tag, name] : mesh.region_names) {
    const auto element = std::find(mesh.regions.begin(), mesh.regions.end(), tag);
    if (element == mesh.regions.end()) continue;
    const auto nodes = mesh.nodes_of(dobra::mesh::ElementId(static_cast<std::size_t>(element - mesh.regions.begin())));
    const Point a = mesh.point(nodes[0]), b = mesh.point(nodes[1]), c = mesh.point(nodes[2]);
    sketch.regions.push_back({name, {(a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0}});
  }
  return sketch;
}

/// @param unit  metres in one of the file.
Result<Sketch> from_drawing(const std::string& path, double unit) {
  DOBRA_TRY(dobra::io::formats::Drawing drawing, dobra::io::formats::read_drawing(path));
  return std::visit(
      [&](auto& file) -> Result<Sketch> {
        if constexpr (std::is_same_v<decltype(file), dobra::io::meshes::PolyFile&>) {
          scale(file, unit);
          return sketch_of_graph(file, path, true);
        } else {
          return sketch_of(std::move(file), unit);
        }
      },
      drawing.held);
}

/// @param unit  metres in one of the file.
Result<Sketch> from_mesh_file(const std::string& path, double unit) {
  DOBRA_TRY(auto contents, dobra::io::formats::read_mesh(path));
  scale(contents.mesh.points, unit);
  Sketch sketch = from_mesh(contents.mesh);
  sketch.remarks = std::move(contents.remarks);
  return sketch;
}

Result<Sketch> read_by_ending(const std::string& path, const SketchOptions& options) {
  Place place;
  place.file = path;
  using dobra::io::formats::Use;
  const bool drawing = dobra::io::formats::format_of(path, Use::ReadDrawing) != nullptr;
  const bool mesh = dobra::io::formats::format_of(path, Use::ReadMesh) != nullptr;
  if ((drawing || mesh) && options.chosen) {
    return Error{ErrorCode::BadValue,
                 fmt::format("units, axes, columns and closing are asked of files of lines only, not of {} files; "
                             "leave these options out",
                             dobra::io::ending_of(path)),
                 place};
  }
  if (drawing) return from_drawing(path, options.silent_unit);
  if (mesh) return from_mesh_file(path, options.silent_unit);
  if (!options.lines.format && !dobra::io::formats::line_format_of(path)) {
    return Error{
        ErrorCode::UnknownFormat,
        fmt::format("the ending of the name tells no format; geometry is read from {} {}, the boundary of a mesh "
                    "from {}",
                    fmt::join(dobra::io::formats::endings_for(Use::ReadDrawing), " "),
                    fmt::join(dobra::io::formats::endings_for(Use::ReadLines), " "),
                    fmt::join(dobra::io::formats::endings_for(Use::ReadMesh), " ")),
        place};
  }
  return from_lines(path, options);
}

}  // namespace

Result<Sketch> read_sketch(const std::string& path, const SketchOptions& options) {
  DOBRA_TRY_VOID(dobra::io::check_readable(path));
  DOBRA_TRY(Sketch sketch, read_by_ending(path, options));
  Place place;
  place.file = path;
  if (sketch.places.empty()) sketch.places.assign(sketch.curves.size(), place);
  return sketch;
}

}  // namespace quebra::sketch
