#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <span>

#include "shared/base/text.h"
#include "shared/io/base64.h"
#include "shared/io/file.h"
#include "shared/io/meshes/mesh_sides.h"
#include "shared/io/meshes/vtu.h"
#include "shared/io/scan.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;
using mesh::ElementMesh;

namespace {

static_assert(std::endian::native == std::endian::little, "the binary arrays say LittleEndian");

std::string attribute_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += static_cast<unsigned char>(c) < 0x20U ? ' ' : c;
    }
  }
  return result;
}

template <class T>
constexpr std::string_view type_name();
template <>
constexpr std::string_view type_name<double>() {
  return "Float64";
}
template <>
constexpr std::string_view type_name<std::int32_t>() {
  return "Int32";
}
template <>
constexpr std::string_view type_name<std::int64_t>() {
  return "Int64";
}
template <>
constexpr std::string_view type_name<std::uint8_t>() {
  return "UInt8";
}

std::string item_text(double value) { return base::number_text(value); }
template <class T>
std::string item_text(T value) {
  return fmt::format("{}", static_cast<std::int64_t>(value));
}

class Writer {
 public:
  explicit Writer(VtuEncoding encoding) : encoding_(encoding) {}

  /// `a_line` numbers stand on a line of an ASCII array, by default one item.
  template <class T>
  void array(std::string_view name, std::span<const T> values, std::size_t components, std::size_t a_line = 0) {
    begin<T>(name, components, "");
    values_of(values, a_line > 0 ? a_line : components);
  }

  /// An array of the FieldData, which must say how many tuples it has.
  template <class T>
  void tuples(std::string_view name, const std::vector<T>& values, std::size_t components) {
    begin<T>(name, components, fmt::format(" NumberOfTuples=\"{}\"", values.size() / components));
    values_of(std::span<const T>(values), components);
  }

  void fields(const std::vector<MeshField>& all) {
    for (const MeshField& field : all) array<double>(field.name, field.values, field.components);
  }

  std::string text;

 private:
  template <class T>
  void begin(std::string_view name, std::size_t components, const std::string& more) {
    text +=
        fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} format=\"{}\">\n", type_name<T>(),
                    attribute_text(name), components, more, encoding_ == VtuEncoding::Ascii ? "ascii" : "binary");
  }

  template <class T>
  void values_of(std::span<const T> values, std::size_t a_line) {
    if (encoding_ == VtuEncoding::Ascii) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        text += item_text(values[i]);
        text += (i + 1) % a_line == 0 ? '\n' : ' ';
      }
      if (values.size() % a_line != 0) text += '\n';
    } else {
      const std::uint64_t size = values.size() * sizeof(T);
      std::string bytes(sizeof(size) + size, '\0');
      std::memcpy(bytes.data(), &size, sizeof(size));
      if (size > 0) std::memcpy(bytes.data() + sizeof(size), values.data(), size);
      text += base64(bytes) + '\n';
    }
    text += "</DataArray>\n";
  }

  VtuEncoding encoding_;
};

Result<void> check_fields(const std::vector<MeshField>& fields, std::size_t items) {
  for (const MeshField& field : fields) {
    if (field.components == 0 || field.values.size() != items * field.components) {
      return Error{ErrorCode::InvalidOption,
                   fmt::format("field {} has {} values where {} x {} are due", shown(field.name), field.values.size(),
                               items, field.components)};
    }
    for (std::size_t i = 0; i < field.values.size(); ++i) {
      if (std::isfinite(field.values[i])) continue;
      return Error{ErrorCode::NotFinite,
                   fmt::format("value {} of field {} is not finite and cannot be written", i + 1, shown(field.name))};
    }
  }
  return {};
}

std::uint8_t vtk_type(mesh::ElementType type) {
  switch (type) {
    case mesh::ElementType::T3:
      return 5;
    case mesh::ElementType::T6:
      return 22;
    case mesh::ElementType::Q4:
      return 9;
    case mesh::ElementType::Q8:
      return 23;
  }
  return 0;
}

void write_cells(const ElementMesh& mesh, Writer& writer) {
  std::vector<std::int64_t> connectivity;
  std::vector<std::uint8_t> types;
  connectivity.reserve(mesh.nodes.size());
  for (const mesh::NodeId node : mesh.nodes) connectivity.push_back(static_cast<std::int64_t>(node.index()));
  for (const mesh::ElementType type : mesh.types) types.push_back(vtk_type(type));
  const std::vector<std::int64_t> offsets(mesh.first.begin() + 1, mesh.first.end());
  writer.text += "<Cells>\n";
  writer.array<std::int64_t>("connectivity", connectivity, 1, 3);  // VTK takes no other number of components.
  writer.array<std::int64_t>("offsets", offsets, 1);
  writer.array<std::uint8_t>("types", types, 1);
  writer.text += "</Cells>\n";
}

void write_sets(const ElementMesh& mesh, Writer& writer) {
  if (mesh.side_sets.empty() && mesh.node_sets.empty() && mesh.tips.empty() && mesh.region_names.empty()) return;
  writer.text += "<FieldData>\n";
  for (const auto& [tag, name] : mesh.region_names) {
    writer.tuples<std::int64_t>("region " + name, std::vector<std::int64_t>{tag}, 1);
  }
  for (const auto& [name, sides] : mesh.side_sets) {
    std::vector<std::int64_t> numbers;
    for (const mesh::ElementSide& side : sides) {
      numbers.insert(numbers.end(), {static_cast<std::int64_t>(side.element.index()), side.side});
    }
    writer.tuples<std::int64_t>("side_set " + name, numbers, 2);
  }
  for (const auto& [name, nodes] : mesh.node_sets) {
    std::vector<std::int64_t> numbers;
    for (const mesh::NodeId node : nodes) numbers.push_back(static_cast<std::int64_t>(node.index()));
    writer.tuples<std::int64_t>("node_set " + name, numbers, 1);
  }
  for (const mesh::CrackTip& tip : mesh.tips) {
    const std::vector<double> numbers{static_cast<double>(tip.node.index()), tip.direction.x, tip.direction.y};
    writer.tuples<double>("tip " + tip.name, numbers, 3);
  }
  writer.text += "</FieldData>\n";
}

}  // namespace

Result<std::string> vtu_text(const ElementMesh& mesh, const MeshFields& fields, VtuEncoding encoding, Heights heights) {
  DOBRA_TRY_VOID(check_writable(mesh, heights));
  DOBRA_TRY_VOID(check_fields(fields.at_points, mesh.points.size()));
  DOBRA_TRY_VOID(check_fields(fields.at_elements, mesh.element_count()));
  std::vector<double> coordinates;
  coordinates.reserve(3 * mesh.points.size());
  for (std::size_t n = 0; n < mesh.points.size(); ++n)
    coordinates.insert(coordinates.end(), {mesh.points[n].x, mesh.points[n].y, height(heights, n)});

  Writer writer(encoding);
  writer.text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n";
  write_sets(mesh, writer);
  writer.text += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData>\n", mesh.points.size(),
                             mesh.element_count());
  writer.fields(fields.at_points);
  writer.text += "</PointData>\n<CellData>\n";
  writer.array<std::int32_t>("region", mesh.regions, 1);
  writer.fields(fields.at_elements);
  writer.text += "</CellData>\n<Points>\n";
  writer.array<double>("Points", coordinates, 3);
  writer.text += "</Points>\n";
  write_cells(mesh, writer);
  writer.text += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return std::move(writer.text);
}

Result<void> write_vtu(const std::string& path, const ElementMesh& mesh, const MeshFields& fields, VtuEncoding encoding,
                       Heights heights) {
  return write_text(path, vtu_text(mesh, fields, encoding, heights));
}

}  // namespace dobra::io::meshes
