#include "quebra/surfaces/shell.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "quebra/model/mesh_files.h"
#include "quebra/surfaces/shell_turns.h"
#include "shared/base/text.h"
#include "shared/fem/element.h"
#include "shared/io/file.h"
#include "shared/io/meshes/bdf.h"
#include "shared/io/meshes/inp.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point3;
using geom::Vector3;
using mesh::ElementId;
using mesh::ElementMesh;
using surf::mesh::SurfaceElements;

namespace {

Vector3 vector_of(const ShellLoadParams& load) {
  return {load.x.value_or(0.0), load.y.value_or(0.0), load.z.value_or(0.0)};
}

/// Makes a Shell; the elements must outlive it.
class ShellMaker {
 public:
  ShellMaker(const SurfaceElements& elements, const ShellParams& params) : elements_(elements), params_(params) {}

  Result<Shell> run() {
    DOBRA_TRY_VOID(give_sections());
    if (params_.supports.empty()) return Error{ErrorCode::BadValue, "a shell needs a `support`: it would fly away"};
    for (const ShellSupportParams& support : params_.supports) DOBRA_TRY_VOID(hold(support));
    for (const ShellLoadParams& load : params_.loads) DOBRA_TRY_VOID(add(load));
    return std::move(shell_);
  }

 private:
  [[nodiscard]] const ElementMesh& mesh() const { return elements_.mesh; }

  [[nodiscard]] std::vector<std::string> region_names() const {
    std::vector<std::string> names;
    for (const auto& [tag, name] : mesh().region_names) names.push_back(name);
    return names;
  }
  /// The tags of a name; all for an empty one.
  [[nodiscard]] Result<std::set<std::int32_t>> regions(const std::string& name) const {
    std::set<std::int32_t> tags;
    for (const std::int32_t tag : mesh().regions) {
      const auto known = mesh().region_names.find(tag);
      if (name.empty() || (known != mesh().region_names.end() && known->second == name)) tags.insert(tag);
    }
    if (tags.empty()) return unknown("region", name, region_names());
    return tags;
  }
  static Error unknown(const char* what, const std::string& name, const std::vector<std::string>& known) {
    std::string hint = base::did_you_mean(name, known);
    if (hint.empty() && !known.empty()) hint = fmt::format("; there are: {}", fmt::join(known, ", "));
    return {ErrorCode::BadValue, fmt::format("there is no {} '{}'{}", what, name, hint)};
  }
  [[nodiscard]] Error no_set(const std::string& name) const {
    std::vector<std::string> known;
    for (const auto& [set, sides] : mesh().side_sets) known.push_back(set);
    for (const auto& [set, nodes] : mesh().node_sets) known.push_back(set);
    return unknown("set", name, known);
  }
  [[nodiscard]] Result<std::set<std::size_t>> nodes_of(const std::string& name) const {
    std::set<std::size_t> nodes;
    if (const auto set = mesh().node_sets.find(name); set != mesh().node_sets.end()) {
      for (const auto node : set->second) nodes.insert(node.index());
    } else if (const auto sides = mesh().side_sets.find(name); sides != mesh().side_sets.end()) {
      for (const auto& side : sides->second) {
        for (const auto node : side_nodes(mesh(), side)) {
          if (node.valid()) nodes.insert(node.index());
        }
      }
    }
    if (nodes.empty()) return no_set(name);
    return nodes;
  }

  Result<void> give_sections() {
    for (const bool named : {false, true}) {
      for (const ShellMaterialParams& material : params_.materials) {
        if (material.region.empty() == named) continue;
        DOBRA_TRY(const std::set<std::int32_t> tags, regions(material.region));
        for (const std::int32_t tag : tags)
          shell_.sections[tag] = {material.young, material.poisson, material.thickness};
      }
    }
    for (const std::int32_t tag : mesh().regions) {
      if (shell_.sections.contains(tag)) continue;
      const auto known = mesh().region_names.find(tag);
      return Error{ErrorCode::BadValue,
                   fmt::format("region '{}' has no `material`",
                               known == mesh().region_names.end() ? fmt::format("{}", tag) : known->second)};
    }
    return {};
  }

  Result<void> hold(const ShellSupportParams& support) {
    const auto radians = [](const std::optional<base::Angle>& angle) {
      return angle ? std::optional(angle->radians()) : std::nullopt;
    };
    const std::array<std::optional<double>, 6> wanted{
        support.x, support.y, support.z, radians(support.turn_x), radians(support.turn_y), radians(support.turn_z)};
    if (std::none_of(wanted.begin(), wanted.end(), [](const auto& value) { return value.has_value(); }))
      return Error{ErrorCode::BadValue,
                   fmt::format("the support at '{}' holds nothing: give x, y, z or turns", support.where)};
    DOBRA_TRY(const std::set<std::size_t> nodes, nodes_of(support.where));
    for (const std::size_t node : nodes) {
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        std::optional<double>& held = shell_.held[node][i];
        if (!wanted[i]) continue;
        if (held && *held != *wanted[i]) {
          const Point3 p = elements_.point(mesh::NodeId(node));
          return Error{ErrorCode::BadValue,
                       fmt::format("two supports prescribe different displacements of one node, that at '{}' and one "
                                   "before it",
                                   support.where),
                       base::Place{.x = p.x, .y = p.y, .z = p.z}};
        }
        held = wanted[i];
      }
    }
    return {};
  }

  Result<void> add(const ShellLoadParams& load) {
    if (load.kind == ShellLoadKind::Pressure) {
      if (!load.value)
        return Error{ErrorCode::BadValue, fmt::format("the pressure at '{}' has no `value`: give one", load.where)};
    } else if (!load.x && !load.y && !load.z) {
      return Error{ErrorCode::BadValue, fmt::format("the load at '{}' loads nothing: give x, y or z", load.where)};
    }
    if (load.kind == ShellLoadKind::Force) {
      DOBRA_TRY(const std::set<std::size_t> nodes, nodes_of(load.where));
      for (const std::size_t node : nodes) push(node, vector_of(load));
      return {};
    }
    if (load.kind == ShellLoadKind::Edge) return add_edge(load);
    DOBRA_TRY(const std::set<std::int32_t> tags, regions(load.where));
    for (std::size_t e = 0; e < mesh().element_count(); ++e) {
      if (tags.contains(mesh().regions[e])) add_on(ElementId(e), load);
    }
    return {};
  }
  void push(std::size_t node, Vector3 force) {
    Vector3& known = shell_.forces[node];
    known = known + force;
  }

  /// The integral of shape function times load over an element in space.
  void add_on(ElementId element, const ShellLoadParams& load) {
    const auto nodes = mesh().nodes_of(element);
    const auto type = mesh().types[element.index()];
    const auto points = fem::integration_points(type, fem::Rule::Curved);
    const auto shapes = fem::shapes_at(type, fem::Rule::Curved);
    for (std::size_t g = 0; g < points.size(); ++g) {
      Vector3 xi{}, eta{};
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Point3 p = elements_.point(nodes[i]);
        xi = xi + shapes[g].d_xi[i] * (p - Point3{});
        eta = eta + shapes[g].d_eta[i] * (p - Point3{});
      }
      const Vector3 area = points[g].weight * cross(xi, eta);
      Vector3 force = length(area) * vector_of(load);
      if (load.kind == ShellLoadKind::Pressure) force = -load.value.value_or(0.0) * area;
      if (load.kind == ShellLoadKind::Body)
        force = shell_.sections.at(mesh().regions[element.index()]).thickness * force;
      for (std::size_t i = 0; i < nodes.size(); ++i) push(nodes[i].index(), shapes[g].n[i] * force);
    }
  }

  Result<void> add_edge(const ShellLoadParams& load) {
    const auto set = mesh().side_sets.find(load.where);
    if (set == mesh().side_sets.end()) return no_set(load.where);
    for (const mesh::ElementSide& side : set->second) {
      const auto nodes = side_nodes(mesh(), side);
      const auto type = mesh().types[side.element.index()];
      const std::size_t count = nodes[2].valid() ? 3 : 2;
      for (const fem::IntegrationPoint& gauss : fem::side_points()) {
        const fem::Shape shape = fem::side_shape(type, gauss.xi);
        Vector3 tangent{};
        for (std::size_t i = 0; i < count; ++i)
          tangent = tangent + shape.d_xi[i] * (elements_.point(nodes[i]) - Point3{});
        for (std::size_t i = 0; i < count; ++i)
          push(nodes[i].index(), (shape.n[i] * gauss.weight * length(tangent)) * vector_of(load));
      }
    }
    return {};
  }

  const SurfaceElements& elements_;
  const ShellParams& params_;
  Shell shell_;
};

std::array<double, 3> components(Vector3 v) { return {v.x, v.y, v.z}; }

/// No force, and no support that moves.
bool rests(const Shell& shell) {
  const auto none = [](const auto& each) { return each.second == Vector3{}; };
  const auto stays = [](const auto& each) {
    return std::all_of(each.second.begin(), each.second.end(),
                       [](const auto& value) { return !value || *value == 0.0; });
  };
  return std::all_of(shell.forces.begin(), shell.forces.end(), none) &&
         std::all_of(shell.held.begin(), shell.held.end(), stays);
}

}  // namespace

Result<Shell> make_shell(const SurfaceElements& elements, const ShellParams& params) {
  return ShellMaker(elements, params).run();
}

Result<std::string> shell_inp(const SurfaceElements& elements, const Shell& shell, const scenario::UnitSystem& units) {
  const SurfaceElements written = model::in_units(elements, units);
  DOBRA_TRY(std::string text,
            io::meshes::inp_text(written.mesh, {.element = io::meshes::InpElement::Shell, .heights = written.heights}));
  text = "** " + model::note_of(units) + '\n' + text;
  const auto in = [&](double value, const char* si) { return io::meshes::twenty_columns(units.from_si(value, si)); };
  for (const auto& [tag, section] : shell.sections) {
    text += fmt::format(
        "*MATERIAL, NAME=MATERIAL_{0}\n*ELASTIC\n{1}, {2}\n*SHELL SECTION, ELSET=REGION_{0}, "
        "MATERIAL=MATERIAL_{0}\n{3}\n",
        tag, in(section.young, "Pa"), io::meshes::twenty_columns(section.poisson), in(section.thickness, "m"));
  }
  text += "*STEP\n*STATIC\n*BOUNDARY\n";
  const auto turns = turns_to_hold(elements, shell);
  for (const auto& [node, values] : shell.held) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] && (i < 3 || turns.at(node)[i - 3]))
        text += fmt::format("{0}, {1}, {1}, {2}\n", node + 1, i + 1, in(*values[i], i < 3 ? "m" : ""));
    }
  }
  if (!shell.forces.empty()) text += "*CLOAD\n";
  for (const auto& [node, force] : shell.forces) {
    const auto values = components(force);
    for (std::size_t i = 0; i < 3; ++i) {
      if (values[i] != 0.0) text += fmt::format("{}, {}, {}\n", node + 1, i + 1, in(values[i], "N"));
    }
  }
  return text + "*NODE PRINT, NSET=NALL\nU\n*NODE FILE, OUTPUT=2D\nU\n*EL FILE\nS\n*END STEP\n";
}

Result<std::string> shell_bdf(const SurfaceElements& elements, const Shell& shell, const scenario::UnitSystem& units) {
  const SurfaceElements written = model::in_units(elements, units);
  DOBRA_TRY(std::string text, io::meshes::bdf_text(written.mesh, written.heights));
  const auto in = [&](double value, const char* si) {
    return fmt::format("{:<16}", io::meshes::bdf_number(units.from_si(value, si), 16));
  };
  const auto whole = [](std::size_t value) { return fmt::format("{:<16}", value); };
  std::string cards;
  std::size_t number = 0;
  for (const auto& [tag, section] : shell.sections) {
    ++number;  // as bdf_text numbers regions
    cards +=
        fmt::format("{:<8}{}{}{}{}\n*\n", "PSHELL*", whole(number), whole(number), in(section.thickness, "m"), number);
    cards += fmt::format("{:<8}{}{}{:<16}{}\n*\n", "MAT1*", whole(number), in(section.young, "Pa"), "",
                         in(section.poisson, ""));
  }
  for (const auto& [node, values] : shell.held) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i])
        cards += fmt::format("{:<8}{}{}{}{}\n*\n", "SPC*", whole(1), whole(node + 1), whole(i + 1),
                             in(*values[i], i < 3 ? "m" : ""));
    }
  }
  for (const auto& [node, force] : shell.forces) {
    const auto values = components(force);
    cards += fmt::format("{:<8}{}{}{}{}\n{:<8}{}{}{}\n", "FORCE*", whole(1), whole(node + 1), whole(0), in(1.0, ""),
                         "*", in(values[0], "N"), in(values[1], "N"), in(values[2], "N"));
  }
  text.insert(text.rfind("ENDDATA"), cards);
  const std::string control = "SOL 101\nCEND\nSPC = 1\nLOAD = 1\nDISPLACEMENT = ALL\nSTRESS = ALL\n";
  text.insert(text.find("BEGIN BULK"), control);
  return "$ " + model::note_of(units) + '\n' + text;
}

Result<model::Model> add_shell(const model::Model& model, const ShellParams& params, const scenario::Context&,
                               const base::Progress&) {
  if (model.surface_meshes.empty())
    return Error{ErrorCode::BadValue, "a shell is made of a mesh of surfaces: put the step `mesh` before it"};
  DOBRA_TRY(Shell shell, make_shell(model.surface_meshes.back()->elements, params));
  model::Model result = model;
  result.shell = std::make_shared<const Shell>(std::move(shell));
  result.shell_mesh = model.surface_meshes.back();
  if (rests(*result.shell))
    result.remarks.push_back(
        "nothing loads the shell: its displacements are 0; give a `load`, or a support that moves");
  const auto& types = result.shell_mesh->elements.mesh.types;
  if (std::find(types.begin(), types.end(), mesh::ElementType::T3) != types.end()) {
    result.remarks.push_back(
        "shell.inp has triangles of first order, S3, which CalculiX makes much too stiff in bending: take order = "
        "\"2\" in the step before");
  }
  return result;
}

void add_shell_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  if (!model->shell) return;
  const auto add = [&](const char* name, auto text_of) {
    outputs.push_back({name, [model, text_of](const auto& path) -> Result<void> {
                         return io::write_text(path.string(),
                                               text_of(model->shell_mesh->elements, *model->shell, model->units));
                       }});
  };
  add("shell.inp", shell_inp);
  add("shell.bdf", shell_bdf);
}

void add_shell_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  if (!model.shell) return;
  Vector3 total{};
  for (const auto& [node, force] : model.shell->forces) total = total + force;
  quantities.push_back({"shell.force_x", total.x, "N"});
  quantities.push_back({"shell.force_y", total.y, "N"});
  quantities.push_back({"shell.force_z", total.z, "N"});
  quantities.push_back({"shell.nodes_held", static_cast<double>(model.shell->held.size()), ""});
}

}  // namespace quebra::surfaces
