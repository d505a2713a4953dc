// 1. Find the sections (Points, Cells, PointData, CellData, FieldData) and the DataArrays in each of them.
// 2. Turn each DataArray into numbers (ASCII or base64 with a length in front).
// 3. Build the mesh from Points and Cells; what is left are fields, "region" the regions.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>

#include "shared/base/text.h"
#include "shared/io/base64.h"
#include "shared/io/file.h"
#include "shared/io/meshes/mesh_plane.h"
#include "shared/io/meshes/vtu.h"
#include "shared/io/scan.h"
#include "shared/io/xml.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

// Size in bytes and conversion of one binary number.
template <class T>
void append_as(std::string_view bytes, std::vector<double>& values) {
  for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T)) {
    T value;
    std::memcpy(&value, bytes.data() + i, sizeof(T));
    values.push_back(static_cast<double>(value));
  }
}

struct Type {
  std::string_view name;
  std::size_t size;
  void (*append)(std::string_view, std::vector<double>&);
};

constexpr Type types[] = {{"Float64", 8, append_as<double>},     {"Float32", 4, append_as<float>},
                          {"Int64", 8, append_as<std::int64_t>}, {"UInt64", 8, append_as<std::uint64_t>},
                          {"Int32", 4, append_as<std::int32_t>}, {"UInt32", 4, append_as<std::uint32_t>},
                          {"Int16", 2, append_as<std::int16_t>}, {"UInt16", 2, append_as<std::uint16_t>},
                          {"Int8", 1, append_as<std::int8_t>},   {"UInt8", 1, append_as<std::uint8_t>}};

constexpr std::pair<double, mesh::ElementType> element_types[] = {{5.0, mesh::ElementType::T3},
                                                                  {22.0, mesh::ElementType::T6},
                                                                  {9.0, mesh::ElementType::Q4},
                                                                  {23.0, mesh::ElementType::Q8}};

struct Array {
  MeshField field;
  pugi::xml_node node;
};

class VtuReader {
 public:
  VtuReader(const Xml& xml, Flatness flatness) : xml_(xml), flatness_(flatness) {}

  Result<VtuContents> run() {
    DOBRA_TRY_VOID(read_arrays());
    VtuContents contents;
    DOBRA_TRY_VOID(take_points(contents.mesh));
    DOBRA_TRY_VOID(take_elements(contents.mesh));
    DOBRA_TRY_VOID(take_fields("PointData", contents.mesh.points.size(), contents.fields.at_points));
    DOBRA_TRY_VOID(take_fields("CellData", contents.mesh.element_count(), contents.fields.at_elements));
    take_regions(contents);
    DOBRA_TRY_VOID(take_sets(contents.mesh));
    if (in_space_) contents.heights = std::move(heights_);
    return contents;
  }

 private:
  Error error(const pugi::xml_node& at, std::string message, ErrorCode code = ErrorCode::BadFormat) const {
    return Error{code, std::move(message), xml_.place(at)};
  }

  Result<void> read_arrays() {
    const pugi::xml_node file = xml_.root().child("VTKFile");
    if (!file)
      return Error{ErrorCode::BadFormat, "not a .vtu file: there is no VTKFile tag", base::Place{.file = xml_.file()}};
    DOBRA_TRY_VOID(check_header(file));
    const pugi::xml_node grid = file.child("UnstructuredGrid");
    const pugi::xml_node piece = grid.child("Piece");
    if (const pugi::xml_node second = piece.next_sibling("Piece"))
      return error(second, "files of several pieces are not read; join them first", ErrorCode::UnknownFormat);
    for (const pugi::xml_node& parent : {grid, piece}) {
      for (const char* const section : {"FieldData", "PointData", "CellData", "Points", "Cells"}) {
        for (const pugi::xml_node& array : parent.child(section).children("DataArray"))
          DOBRA_TRY_VOID(read_array(array, section));
      }
    }
    return {};
  }

  Result<void> check_header(const pugi::xml_node& file) {
    const auto refuse = [&](std::string message) { return error(file, std::move(message), ErrorCode::UnknownFormat); };
    const std::string type = file.attribute("type").value();
    if (type != "UnstructuredGrid")
      return refuse(fmt::format("VTK type {} is not read; give an UnstructuredGrid", shown(type)));
    if (std::string_view(file.attribute("byte_order").as_string("LittleEndian")) != "LittleEndian")
      return refuse("only LittleEndian files are read");
    if (file.attribute("compressor")) return refuse("compressed files are not read; save it uncompressed");
    const std::string header = file.attribute("header_type").as_string("UInt32");
    if (header != "UInt32" && header != "UInt64")
      return refuse(fmt::format("header type {} is not known", shown(header)));
    header_size_ = header == "UInt64" ? 8 : 4;
    return {};
  }

  Result<void> read_array(const pugi::xml_node& node, const std::string& section) {
    Array array{{}, node};
    array.field.name = node.attribute("Name").value();
    const std::string components = node.attribute("NumberOfComponents").as_string("1");
    const std::optional<double> count = base::parse_number(components);
    if (!count || !(*count >= 1.0) || *count > 1000.0 || *count != std::floor(*count)) {
      return error(node, fmt::format("NumberOfComponents {} is not a count", shown(components)));
    }
    array.field.components = static_cast<std::size_t>(*count);
    const auto is_text = [](const pugi::xml_node& child) { return child.type() != pugi::node_element; };
    const auto text = std::find_if(node.begin(), node.end(), is_text);
    if (text != node.end()) DOBRA_TRY_VOID(read_values(node, *text, array.field.values));
    arrays_[section].push_back(std::move(array));
    return {};
  }

  Result<void> read_values(const pugi::xml_node& node, const pugi::xml_node& text, std::vector<double>& values) {
    const std::string format = node.attribute("format").as_string("ascii");
    const std::string name = node.attribute("type").value();
    const auto* type = std::find_if(std::begin(types), std::end(types), [&](const Type& t) { return t.name == name; });
    if (type == std::end(types)) return error(node, fmt::format("number type {} is not known", shown(name)));
    if (format == "ascii") return read_ascii(text.value(), values);
    if (format != "binary") {
      return error(node, fmt::format("format {} is not read; save it as ASCII or inline binary", shown(format)),
                   ErrorCode::UnknownFormat);
    }
    const std::optional<std::string> bytes = from_base64(text.value());
    if (!bytes || bytes->size() < header_size_) return error(text, "this array is not valid base64");
    std::uint64_t size = 0;
    std::memcpy(&size, bytes->data(), header_size_);
    if (size != bytes->size() - header_size_ || size % type->size != 0) {
      return error(text, fmt::format("the array says {} bytes and holds {}", size, bytes->size() - header_size_));
    }
    type->append(std::string_view(*bytes).substr(header_size_), values);
    for (const double value : values) {
      if (!std::isfinite(value))
        return error(text, "the array holds a number that is not finite", ErrorCode::NotFinite);
    }
    return {};
  }

  Result<void> read_ascii(std::string_view text, std::vector<double>& values) {
    constexpr std::string_view blanks = " \t\r\n";
    while (true) {
      const std::size_t begin = text.find_first_not_of(blanks);
      if (begin == std::string_view::npos) return {};
      text.remove_prefix(begin);
      const std::string_view word = text.substr(0, text.find_first_of(blanks));
      const Result<double> value = finite_number(word, "the value");
      if (!value) return base::located(value.error(), xml_.place(word.data()));
      values.push_back(*value);
      text.remove_prefix(word.size());
    }
  }

  Result<Array> take(const std::string& section, std::string_view name) {
    std::vector<Array>& arrays = arrays_[section];
    for (auto it = arrays.begin(); it != arrays.end(); ++it) {
      if (!name.empty() && it->field.name != name) continue;
      Array array = std::move(*it);
      arrays.erase(it);
      return array;
    }
    return Error{ErrorCode::BadFormat, fmt::format("there is no array {} in {}", shown(name), section),
                 base::Place{.file = xml_.file()}};
  }

  Result<void> take_points(mesh::ElementMesh& mesh) {
    DOBRA_TRY(const Array array, take("Points", ""));
    const std::vector<double>& values = array.field.values;
    if (array.field.components != 3 || values.size() % 3 != 0)
      return error(array.node, "points need three coordinates each");
    if (values.size() / 3 >= std::numeric_limits<std::uint32_t>::max())
      return error(array.node, "there are too many points");
    for (std::size_t i = 0; i < values.size(); i += 3) {
      mesh.points.push_back({values[i], values[i + 1]});
      heights_.push_back(values[i + 2]);
    }
    return {};
  }

  Result<void> take_elements(mesh::ElementMesh& mesh) {
    DOBRA_TRY(const Array nodes, take("Cells", "connectivity"));
    DOBRA_TRY(const Array offsets, take("Cells", "offsets"));
    DOBRA_TRY(const Array kinds, take("Cells", "types"));
    const std::size_t count = kinds.field.values.size();
    if (offsets.field.values.size() != count) return error(offsets.node, "there is not one offset an element");
    std::size_t at = 0;
    std::vector<mesh::NodeId> own;
    for (std::size_t e = 0; e < count; ++e) {
      const double kind = kinds.field.values[e];
      const auto* type = std::find_if(std::begin(element_types), std::end(element_types),
                                      [&](const auto& t) { return t.first == kind; });
      if (type == std::end(element_types)) {
        return error(kinds.node,
                     fmt::format("cell type {} is not read; give triangles (5, 22) or quadrilaterals (9, 23)", kind),
                     ErrorCode::UnknownFormat);
      }
      own.clear();
      for (std::size_t k = 0; k < node_count(type->second); ++k, ++at) {
        if (at >= nodes.field.values.size())
          return error(nodes.node, fmt::format("the nodes of element {} are missing", e));
        const double node = nodes.field.values[at];
        if (!(node >= 0.0) || node >= static_cast<double>(mesh.points.size()) || node != std::floor(node)) {
          return error(nodes.node, fmt::format("element {}: there is no point {}", e, node));
        }
        own.emplace_back(static_cast<std::size_t>(node));
      }
      if (offsets.field.values[e] != static_cast<double>(at)) {
        return error(offsets.node, fmt::format("the offset of element {} does not fit its type", e));
      }
      add_element(mesh, type->second, own, 0);
    }
    if (mesh.element_count() == 0) return error(kinds.node, "the file holds no elements");
    DOBRA_TRY(in_space_, lies_in_space(mesh, heights_, xml_.file(), flatness_));
    return {};
  }

  /// A whole number below `limit`.
  static std::optional<std::size_t> index(double value, std::size_t limit) {
    if (!(value >= 0.0) || value >= static_cast<double>(limit) || value != std::floor(value)) return std::nullopt;
    return static_cast<std::size_t>(value);
  }

  /// Field data under our names become sets; others are passed over.
  Result<void> take_sets(mesh::ElementMesh& mesh) {
    for (const Array& array : arrays_["FieldData"]) {
      const std::size_t blank = array.field.name.find(' ');
      const std::string kind = array.field.name.substr(0, blank);
      const std::string name = blank == std::string::npos ? "" : array.field.name.substr(blank + 1);
      const std::vector<double>& values = array.field.values;
      const auto refuse = [&] {
        return error(array.node, fmt::format("field data {} are not valid for this mesh", shown(array.field.name)));
      };
      if (kind == "side_set") {
        auto& set = mesh.side_sets[name];
        for (std::size_t i = 0; i + 1 < values.size(); i += 2) {
          const auto element = index(values[i], mesh.element_count());
          const auto side = element ? index(values[i + 1], corner_count(mesh.types[*element])) : std::nullopt;
          if (!side) return refuse();
          set.push_back({mesh::ElementId(*element), static_cast<std::uint32_t>(*side)});
        }
      } else if (kind == "node_set") {
        auto& set = mesh.node_sets[name];
        for (const double value : values) {
          const auto node = index(value, mesh.points.size());
          if (!node) return refuse();
          set.emplace_back(*node);
        }
      } else if (kind == "tip") {
        const auto node = values.size() == 3 ? index(values[0], mesh.points.size()) : std::nullopt;
        if (!node) return refuse();
        mesh.tips.push_back({name, mesh::NodeId(*node), {values[1], values[2]}});
      } else if (kind == "region" && values.size() == 1 && std::abs(values[0]) < 2147483648.0) {
        mesh.region_names[static_cast<std::int32_t>(values[0])] = name;
      }
    }
    return {};
  }

  Result<void> take_fields(const std::string& section, std::size_t items, std::vector<MeshField>& fields) {
    for (Array& array : arrays_[section]) {
      if (array.field.values.size() != items * array.field.components) {
        return error(array.node, fmt::format("field {} has {} values where {} x {} are due", shown(array.field.name),
                                             array.field.values.size(), items, array.field.components));
      }
      fields.push_back(std::move(array.field));
    }
    return {};
  }

  // A "region" of 32-bit integers becomes the regions; any other field of that name stays a field.
  static void take_regions(VtuContents& contents) {
    std::vector<MeshField>& fields = contents.fields.at_elements;
    contents.mesh.regions.assign(contents.mesh.element_count(), 0);
    const auto found = std::find_if(fields.begin(), fields.end(), [](const MeshField& f) {
      return f.name == "region" && f.components == 1 && std::all_of(f.values.begin(), f.values.end(), [](double v) {
               return std::abs(v) < 2147483648.0 && v == std::floor(v);
             });
    });
    if (found == fields.end()) return;
    for (std::size_t t = 0; t < found->values.size(); ++t)
      contents.mesh.regions[t] = static_cast<std::int32_t>(found->values[t]);
    fields.erase(found);
  }

  const Xml& xml_;
  const Flatness flatness_;
  bool in_space_ = false;
  std::size_t header_size_ = 4;
  std::vector<double> heights_;  // of the points
  std::map<std::string, std::vector<Array>> arrays_;
};

}  // namespace

Result<VtuContents> parse_vtu(std::string_view text, const std::string& file, Flatness flatness) {
  DOBRA_TRY(const Xml xml, Xml::parse(text, file));
  return VtuReader(xml, flatness).run();
}

Result<VtuContents> read_vtu(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_vtu(text, path);
}

}  // namespace dobra::io::meshes
