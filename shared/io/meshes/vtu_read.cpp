// The mesh is built from Points and Cells; what is left are fields, "region" the regions.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "shared/io/file.h"
#include "shared/io/meshes/mesh_plane.h"
#include "shared/io/meshes/vtk_arrays.h"
#include "shared/io/meshes/vtu.h"
#include "shared/io/scan.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

constexpr std::pair<double, mesh::ElementType> element_types[] = {{5.0, mesh::ElementType::T3},
                                                                  {22.0, mesh::ElementType::T6},
                                                                  {9.0, mesh::ElementType::Q4},
                                                                  {23.0, mesh::ElementType::Q8}};

class VtuReader {
 public:
  VtuReader(VtkArrays arrays, Flatness flatness) : arrays_(std::move(arrays)), flatness_(flatness) {}

  Result<VtuContents> run() {
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
    return arrays_.error(at, std::move(message), code);
  }

  Result<void> take_points(mesh::ElementMesh& mesh) {
    DOBRA_TRY(const VtkArray array, arrays_.take("Points", ""));
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
    DOBRA_TRY(const VtkArray nodes, arrays_.take("Cells", "connectivity"));
    DOBRA_TRY(const VtkArray offsets, arrays_.take("Cells", "offsets"));
    DOBRA_TRY(const VtkArray kinds, arrays_.take("Cells", "types"));
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
    DOBRA_TRY(in_space_, lies_in_space(mesh, heights_, arrays_.file(), flatness_));
    return {};
  }

  /// A whole number below `limit`.
  static std::optional<std::size_t> index(double value, std::size_t limit) {
    if (!(value >= 0.0) || value >= static_cast<double>(limit) || value != std::floor(value)) return std::nullopt;
    return static_cast<std::size_t>(value);
  }

  /// Field data under our names become sets; others are passed over.
  Result<void> take_sets(mesh::ElementMesh& mesh) {
    for (const VtkArray& array : arrays_.of("FieldData")) {
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
    for (VtkArray& array : arrays_.of(section)) {
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

  VtkArrays arrays_;
  const Flatness flatness_;
  bool in_space_ = false;
  std::vector<double> heights_;  // of the points
};

}  // namespace

Result<VtuContents> parse_vtu(std::string_view text, const std::string& file, Flatness flatness) {
  DOBRA_TRY(VtkArrays arrays, VtkArrays::read(text, file, ".vtu", "UnstructuredGrid",
                                              {"FieldData", "PointData", "CellData", "Points", "Cells"}));
  return VtuReader(std::move(arrays), flatness).run();
}

Result<VtuContents> read_vtu(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_vtu(text, path);
}

}  // namespace dobra::io::meshes
