#include "shared/io/meshes/node_ele.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/meshes/mesh_sides.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

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
    if (corners != 3 && corners != 6) {
      return records.error(1, fmt::format("triangles of {} nodes are not read; give 3 or 6", corners));
    }
    elements.nodes_each = corners;
  }
  if (records.size() > 2) {
    DOBRA_TRY(elements.attribute_count, records.count(2, "the number of attributes", 1000));
  }
  elements.nodes.reserve(elements.nodes_each * plausible_count(count, text));
  for (std::size_t i = 0; i < count; ++i) {
    DOBRA_TRY_VOID(records.expect(fmt::format("triangle {} of {}", i + 1, count)));
    DOBRA_TRY(const std::size_t number, records.count(0, "the triangle's number"));
    if (number != nodes.first_number + i) {
      return records.error(0, fmt::format("triangle number {} stands where {} is due", number, nodes.first_number + i));
    }
    for (std::size_t k = 0; k < elements.nodes_each; ++k) {
      DOBRA_TRY(const std::size_t node, records.count(1 + k, "the point"));
      if (node < nodes.first_number || node - nodes.first_number >= nodes.points.size()) {
        return records.error(1 + k, fmt::format("there is no point {}", node));
      }
      elements.nodes.push_back(static_cast<std::uint32_t>(node - nodes.first_number));
    }
    for (std::size_t k = 0; k < elements.attribute_count; ++k) {
      DOBRA_TRY(const double attribute, records.number(1 + elements.nodes_each + k, "an attribute"));
      elements.attributes.push_back(attribute);
    }
  }
  return elements;
}

Result<EleFile> read_ele(const std::string& path, const NodeFile& nodes) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_ele(text, path, nodes);
}

NodeFile node_file_of(const mesh::ElementMesh& mesh) {
  NodeFile nodes;
  nodes.points = mesh.points;
  nodes.markers.assign(mesh.points.size(), 0);
  std::int64_t marker = 0;
  for (const auto& [name, sides] : mesh.side_sets) {
    ++marker;
    for (const mesh::ElementSide& side : sides) {
      for (const mesh::NodeId node : side_nodes(mesh, side)) {
        if (node.valid() && nodes.markers[node.index()] == 0) nodes.markers[node.index()] = marker;
      }
    }
  }
  return nodes;
}

Result<EleFile> ele_file_of(const mesh::ElementMesh& mesh) {
  EleFile elements;
  elements.attribute_count = 1;
  elements.nodes_each = mesh.types.empty() ? 3 : mesh::node_count(mesh.types[0]);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.nodes_of(mesh::ElementId(e));
    if (mesh::corner_count(mesh.types[e]) != 3 || nodes.size() != elements.nodes_each) {
      return Error{ErrorCode::InvalidOption,
                   "a .ele file holds triangles of one order only; write another format of meshes"};
    }
    const auto add = [&](std::size_t k) { elements.nodes.push_back(static_cast<std::uint32_t>(nodes[k].index())); };
    for (std::size_t k = 0; k < 3; ++k) add(k);
    for (std::size_t k = 3; k < nodes.size(); ++k) add(k == 5 ? 3 : k + 1);
  }
  elements.attributes.assign(mesh.regions.begin(), mesh.regions.end());
  return elements;
}

mesh::ElementMesh mesh_of(const NodeFile& nodes, const EleFile& elements) {
  mesh::ElementMesh result;
  result.points = nodes.points;
  const auto type = elements.nodes_each == 3 ? mesh::ElementType::T3 : mesh::ElementType::T6;
  for (std::size_t i = 0; i < elements.count(); ++i) {
    std::vector<mesh::NodeId> own;
    const auto add = [&](std::size_t k) { own.emplace_back(elements.nodes[i * elements.nodes_each + k]); };
    for (std::size_t k = 0; k < 3; ++k) add(k);
    for (std::size_t k = 3; k < elements.nodes_each; ++k) add(k == 3 ? 5 : k - 1);
    const double region = elements.attribute_count > 0 ? elements.attributes[i * elements.attribute_count] : 0.0;
    // A region that is not a 32-bit integer (an attribute with another meaning) counts as the default one.
    const bool fits = std::abs(region) < 2147483648.0 && region == std::floor(region);
    add_element(result, type, own, fits ? static_cast<std::int32_t>(region) : 0);
  }
  finish(result, {});
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
  std::string text = fmt::format("{} {} {}\n", elements.count(), elements.nodes_each, elements.attribute_count);
  for (std::size_t i = 0; i < elements.count(); ++i) {
    text += fmt::format("{}", i + first_number);
    for (std::size_t k = 0; k < elements.nodes_each; ++k) {
      text += fmt::format(" {}", elements.nodes[i * elements.nodes_each + k] + first_number);
    }
    for (std::size_t k = 0; k < elements.attribute_count; ++k) {
      text += ' ' + base::number_text(elements.attributes[i * elements.attribute_count + k]);
    }
    text += '\n';
  }
  return text;
}

Result<void> write_node_ele(const std::string& stem, const mesh::ElementMesh& mesh) {
  DOBRA_TRY(const std::string nodes, node_text(node_file_of(mesh)));
  DOBRA_TRY(const EleFile triangles, ele_file_of(mesh));
  DOBRA_TRY(const std::string elements, ele_text(triangles));
  DOBRA_TRY_VOID(write_file(stem + ".node", nodes));
  return write_file(stem + ".ele", elements);
}

Result<mesh::ElementMesh> read_node_ele(const std::string& stem) {
  DOBRA_TRY(const NodeFile nodes, read_node(stem + ".node"));
  DOBRA_TRY(const EleFile elements, read_ele(stem + ".ele", nodes));
  return mesh_of(nodes, elements);
}

}  // namespace dobra::io::meshes
