#include "shared/io/node_ele.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "shared/base/text.h"
#include "shared/geom/predicates.h"
#include "shared/io/file.h"

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

constexpr std::size_t most_items = std::numeric_limits<std::uint32_t>::max() - 1;

Result<void> check_attributes(const std::vector<double>& attributes, std::string_view what) {
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    if (!std::isfinite(attributes[i])) {
      return Error{ErrorCode::NotFinite,
                   fmt::format("attribute {} of the {} is not finite and cannot be written", i, what)};
    }
  }
  return {};
}

}  // namespace

Result<NodeFile> parse_node_section(Records& records, std::string_view text) {
  NodeFile nodes;
  DOBRA_TRY(const std::size_t count, records.count(0, "the number of points", most_items));
  if (records.size() > 1) {
    DOBRA_TRY(const std::size_t dimension, records.count(1, "the dimension"));
    if (dimension != 2)
      return records.error(1, fmt::format("dimension {} is not read; give points of the plane (2)", dimension));
  }
  std::size_t has_markers = 0;
  if (records.size() > 2) {
    DOBRA_TRY(nodes.attribute_count, records.count(2, "the number of attributes", 1000));
  }
  if (records.size() > 3) {
    DOBRA_TRY(has_markers, records.count(3, "the number of boundary markers", 1));
  }
  nodes.points.reserve(plausible_count(count, text));
  for (std::size_t i = 0; i < count; ++i) {
    DOBRA_TRY_VOID(records.expect(fmt::format("point {} of {}", i + 1, count)));
    DOBRA_TRY(const std::size_t number, records.count(0, "the point's number"));
    if (i == 0) nodes.first_number = number;
    if (nodes.first_number > 1)
      return records.error(0, fmt::format("the first point has number {}; start at 0 or 1", number));
    if (number != nodes.first_number + i) {
      return records.error(0, fmt::format("point number {} stands where {} is due", number, nodes.first_number + i));
    }
    DOBRA_TRY(const double x, records.number(1, "x"));
    DOBRA_TRY(const double y, records.number(2, "y"));
    nodes.points.push_back({x, y});
    for (std::size_t k = 0; k < nodes.attribute_count; ++k) {
      DOBRA_TRY(const double attribute, records.number(3 + k, "an attribute"));
      nodes.attributes.push_back(attribute);
    }
    if (has_markers == 1) {
      DOBRA_TRY(const std::int64_t marker, records.integer(3 + nodes.attribute_count, "the boundary marker"));
      nodes.markers.push_back(marker);
    }
  }
  return nodes;
}

Result<NodeFile> parse_node(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  Records records(text, file);
  DOBRA_TRY_VOID(records.expect("the number of points"));
  DOBRA_TRY(NodeFile nodes, parse_node_section(records, text));
  if (nodes.points.empty()) return records.error(0, "the file holds no points");
  return nodes;
}

Result<NodeFile> read_node(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_node(text, path);
}

Result<EleFile> parse_ele(std::string_view text, const std::string& file, const NodeFile& nodes) {
  DOBRA_TRY_VOID(check_text(text, file));
  Records records(text, file);
  EleFile elements;
  DOBRA_TRY_VOID(records.expect("the number of triangles"));
  DOBRA_TRY(const std::size_t count, records.count(0, "the number of triangles", most_items));
  if (records.size() > 1) {
    DOBRA_TRY(const std::size_t corners, records.count(1, "the nodes a triangle"));
    if (corners != 3) return records.error(1, fmt::format("triangles of {} nodes are not read; give 3", corners));
  }
  if (records.size() > 2) {
    DOBRA_TRY(elements.attribute_count, records.count(2, "the number of attributes", 1000));
  }
  elements.triangles.reserve(plausible_count(count, text));
  for (std::size_t i = 0; i < count; ++i) {
    DOBRA_TRY_VOID(records.expect(fmt::format("triangle {} of {}", i + 1, count)));
    DOBRA_TRY(const std::size_t number, records.count(0, "the triangle's number"));
    if (number != nodes.first_number + i) {
      return records.error(0, fmt::format("triangle number {} stands where {} is due", number, nodes.first_number + i));
    }
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      DOBRA_TRY(const std::size_t node, records.count(1 + k, "the point"));
      if (node < nodes.first_number || node - nodes.first_number >= nodes.points.size()) {
        return records.error(1 + k, fmt::format("there is no point {}", node));
      }
      triangle[k] = static_cast<std::uint32_t>(node - nodes.first_number);
    }
    elements.triangles.push_back(triangle);
    for (std::size_t k = 0; k < elements.attribute_count; ++k) {
      DOBRA_TRY(const double attribute, records.number(4 + k, "an attribute"));
      elements.attributes.push_back(attribute);
    }
  }
  return elements;
}

Result<EleFile> read_ele(const std::string& path, const NodeFile& nodes) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_ele(text, path, nodes);
}

NodeFile node_file_of(const mesh::TriangleMesh& mesh) {
  NodeFile nodes;
  nodes.points = mesh.points;
  nodes.markers.assign(mesh.points.size(), 0);
  std::int64_t marker = 0;
  for (const auto& [name, edges] : mesh.boundary_sets) {
    ++marker;
    for (const mesh::Edge& edge : edges) {
      for (const mesh::NodeId node : edge) {
        if (nodes.markers[node.index()] == 0) nodes.markers[node.index()] = marker;
      }
    }
  }
  return nodes;
}

EleFile ele_file_of(const mesh::TriangleMesh& mesh) {
  EleFile elements;
  elements.attribute_count = mesh.regions.empty() ? 0 : 1;
  for (const mesh::Corners& corners : mesh.triangles) {
    const auto number = [](mesh::NodeId node) { return static_cast<std::uint32_t>(node.index()); };
    elements.triangles.push_back({number(corners[0]), number(corners[1]), number(corners[2])});
  }
  elements.attributes.assign(mesh.regions.begin(), mesh.regions.end());
  return elements;
}

mesh::TriangleMesh mesh_of(const NodeFile& nodes, const EleFile& elements) {
  mesh::TriangleMesh result;
  result.points = nodes.points;
  for (std::size_t i = 0; i < elements.triangles.size(); ++i) {
    auto [a, b, c] = elements.triangles[i];
    if (geom::orient2d(nodes.points[a], nodes.points[b], nodes.points[c]) == geom::Sign::Negative) std::swap(b, c);
    result.triangles.push_back({mesh::NodeId(a), mesh::NodeId(b), mesh::NodeId(c)});
    const double region = elements.attribute_count > 0 ? elements.attributes[i * elements.attribute_count] : 0.0;
    // A region that is not a 32-bit integer (an attribute with another meaning) counts as the default one.
    const bool fits = std::abs(region) < 2147483648.0 && region == std::floor(region);
    result.regions.push_back(fits ? static_cast<std::int32_t>(region) : 0);
  }
  return result;
}

std::string node_section_text(const NodeFile& nodes) {
  const bool markers = !nodes.markers.empty();
  std::string text = fmt::format("{} 2 {} {}\n", nodes.points.size(), nodes.attribute_count, markers ? 1 : 0);
  for (std::size_t i = 0; i < nodes.points.size(); ++i) {
    text += fmt::format("{} {} {}", i + nodes.first_number, base::number_text(nodes.points[i].x),
                        base::number_text(nodes.points[i].y));
    for (std::size_t k = 0; k < nodes.attribute_count; ++k) {
      text += ' ' + base::number_text(nodes.attributes[i * nodes.attribute_count + k]);
    }
    if (markers) text += fmt::format(" {}", nodes.markers[i]);
    text += '\n';
  }
  return text;
}

Result<std::string> node_text(const NodeFile& nodes) {
  DOBRA_TRY_VOID(check_finite(nodes.points, "the nodes"));
  DOBRA_TRY_VOID(check_attributes(nodes.attributes, "nodes"));
  return node_section_text(nodes);
}

Result<std::string> ele_text(const EleFile& elements, std::size_t first_number) {
  DOBRA_TRY_VOID(check_attributes(elements.attributes, "triangles"));
  std::string text = fmt::format("{} 3 {}\n", elements.triangles.size(), elements.attribute_count);
  for (std::size_t i = 0; i < elements.triangles.size(); ++i) {
    const auto& triangle = elements.triangles[i];
    text += fmt::format("{} {} {} {}", i + first_number, triangle[0] + first_number, triangle[1] + first_number,
                        triangle[2] + first_number);
    for (std::size_t k = 0; k < elements.attribute_count; ++k) {
      text += ' ' + base::number_text(elements.attributes[i * elements.attribute_count + k]);
    }
    text += '\n';
  }
  return text;
}

Result<void> write_node_ele(const std::string& stem, const mesh::TriangleMesh& mesh) {
  DOBRA_TRY(const std::string nodes, node_text(node_file_of(mesh)));
  DOBRA_TRY(const std::string elements, ele_text(ele_file_of(mesh)));
  DOBRA_TRY_VOID(write_file(stem + ".node", nodes));
  return write_file(stem + ".ele", elements);
}

Result<mesh::TriangleMesh> read_node_ele(const std::string& stem) {
  DOBRA_TRY(const NodeFile nodes, read_node(stem + ".node"));
  DOBRA_TRY(const EleFile elements, read_ele(stem + ".ele", nodes));
  return mesh_of(nodes, elements);
}

}  // namespace dobra::io
