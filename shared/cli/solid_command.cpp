#include "shared/cli/solid_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "shared/cli/findings.h"
#include "shared/cli/parameter_options.h"
#include "shared/cli/placement.h"
#include "shared/cli/staging.h"
#include "shared/io/formats/boundary_file.h"
#include "shared/mesh/polygon_repair.h"
#include "shared/solid/boolean.h"
#include "shared/solid/check/overlaps.h"
#include "shared/solid/check/settle.h"
#include "shared/solid/measure.h"
#include "shared/solid/mesh_solid.h"
#include "shared/solid/partition/octree.h"

// 1. All files are read, placed and taken as solids; scenarios are run. 2. Operations of one kind that follow each
// other are one: A - B - C is A without B and C. 3. The result is measured, cut where a plane is given, written, and
// told.

namespace dobra::cli {
namespace {

using base::Error;
using base::ErrorCode;
using base::Finding;
using base::Result;
using solid::Contact;
using solid::Operation;
using solid::Solid;
using Path = std::filesystem::path;

/// The options that take another file, each with what it does.
constexpr std::array kinds{std::pair{"--unite", Operation::Union}, std::pair{"--intersect", Operation::Intersection},
                           std::pair{"--subtract", Operation::Difference}};
constexpr const char* place_option = "--place";

/// What is taken of scenarios, what is done before, told beside, and the section.
struct SolidExtras {
  std::string part;
  std::optional<double> repair;
  std::optional<int> octree;
  std::optional<std::string> cut;
  template <class D>
  static void describe(D& d) {
    d.field("part", &SolidExtras::part,
            {.title = "Part",
             .help = "Of a scenario: the part or unit that is meant; where left out, the last part or all units."});
    d.field("repair", &SolidExtras::repair,
            {.title = "Repair",
             .help = "Mend meshes first: points within this distance are one, faces are turned, missing ones put in.",
             .at_least = 0});
    d.field("octree", &SolidExtras::octree,
            {.title = "Octree",
             .help = "Tell bounds of volumes and overlapping bodies by an octree of this depth.",
             .at_least = 0,
             .at_most = 12});
    d.field("cut", &SolidExtras::cut,
            {.title = "Cut",
             .help = "Cut the result by the plane a x + b y + c z + d = 0, given as a,b,c,d: a plane domain."});
  }
};

struct SolidOptions {
  Path file;
  std::array<std::vector<std::string>, kinds.size()> others;
  std::vector<std::string> places;
  OptionsOf<SolidExtras> extra_options{OutOfRange::BadUsage};
  SolidExtras extras;
  std::optional<Path> out;
};

/// Another file, and what is done with it.
struct Step {
  std::size_t kind = 0;
  std::string file;
  std::optional<std::string> matrix;
};

/// The steps as the user wrote them, from left to right. @error BadUsage: a place without a file before it.
Result<std::vector<Step>> steps_of(const CLI::App& app, const SolidOptions& options) {
  std::vector<Step> steps;
  std::array<std::size_t, kinds.size()> used{};
  std::size_t placed = 0;
  for (const CLI::Option* const option : app.parse_order()) {
    const std::string name = option->get_name();
    if (name == place_option) {
      if (steps.empty() || steps.back().matrix) {
        return Error{ErrorCode::BadUsage,
                     "--place stands behind the file that it moves: --unite, --intersect or --subtract with a file, "
                     "then --place, once for each"};
      }
      steps.back().matrix = options.places[placed++];
    }
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
      if (name == kinds[kind].first) steps.push_back({kind, options.others[kind][used[kind]++], std::nullopt});
    }
  }
  return steps;
}

struct Seconds {
  double read = 0.0, boolean = 0.0, write = 0.0;
};

/// Adds the time that `work` takes.
template <class Work>
auto timed(double& seconds, Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  auto done = work();
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return done;
}

struct Outcome {
  std::vector<Bodies::Body> bodies;
  Solid solid;  ///< All of them together.
  std::vector<Finding> findings;
  Seconds seconds;
  std::optional<nlohmann::ordered_json> cut;
  nlohmann::ordered_json octree;
};

base::Place in_file(const std::string& file) { return {.file = file}; }
base::Place in_file_at(const std::string& file, geom::Point3 at) {
  return {.file = file, .x = at.x, .y = at.y, .z = at.z};
}

/// The mesh mended; each repair is a finding.
mesh::PolygonMesh mended(const mesh::PolygonMesh& mesh, double merge, const std::string& file,
                         std::vector<Finding>& findings) {
  mesh::RepairedPolygons repaired = mesh::repaired(mesh, {.merge = merge});
  for (const mesh::PolygonRepair& repair : repaired.repairs)
    findings.push_back({"repaired", repair.message, in_file_at(file, repair.place)});
  return std::move(repaired.mesh);
}

/// @param name  of faces, where a section is to name them; else they have none.
Result<Bodies> read_mesh(const std::string& file, const std::optional<std::string>& matrix, const std::string& name,
                         std::optional<double> repair, std::vector<Finding>& findings) {
  DOBRA_TRY(mesh::PolygonMesh mesh, io::formats::read_boundary(file));
  if (repair) mesh = mended(mesh, *repair, file, findings);
  if (matrix) {
    DOBRA_TRY(const solid::Matrix numbers, parse_matrix(*matrix));
    DOBRA_TRY(Placed placed, place(mesh, numbers));
    if (placed.rounded > 0) {
      findings.push_back(
          {"placed_rounded",
           fmt::format("points ({} of {}) were rounded to the nearest numbers when they were placed; faces "
                       "that are no longer plane are cut into triangles",
                       placed.rounded, placed.mesh.points.size()),
           in_file(file)});
    }
    mesh = std::move(placed.mesh);
  }
  solid::FromMeshOptions from;
  from.name = name;
  auto read = solid::take(mesh, from);
  if (!read) return base::located(read.error(), in_file(file));
  if (read->solid.empty()) {
    return Error{ErrorCode::NotClosed, "bounds nothing: none of its faces has an area", in_file(file)};
  }
  for (const solid::OppositeFaces& faces : read->opposite)
    findings.push_back({"opposite_faces", solid::message(faces), in_file_at(file, faces.at)});
  if (read->warped)
    findings.push_back({"not_plane", solid::message(*read->warped), in_file_at(file, read->warped->at)});
  return Bodies{{{Path(file).stem().string(), std::move(read->solid)}}};
}

/// A mesh file, or the part of a scenario, the last if `part` is empty.
Result<Bodies> read_bodies(Session& session, const SolidCommand& program, const SolidOptions& options,
                           const std::string& file, const std::string& part, const std::optional<std::string>& matrix,
                           std::vector<Finding>& findings) {
  if (Path(file).extension() == ".toml") return program.read(session, file, part, matrix, findings);
  return read_mesh(file, matrix, options.extras.cut ? Path(file).stem().string() : "", options.extras.repair, findings);
}

/// What the operands have in common; nothing to tell if they overlap and something is left.
std::optional<Finding> contact_finding(Contact contact, bool empty, const std::string& operation) {
  const std::string code = fmt::format("contact_{}", solid::name(contact));
  const auto told = [&](const char* text) { return Finding{code, fmt::format(fmt::runtime(text), operation), {}}; };
  switch (contact) {
    case Contact::Nothing:
      return told("{}: no two of the solids meet");
    case Contact::Vertex:
      return told("{}: the solids meet in single points alone");
    case Contact::Edge:
      return told("{}: the solids meet in edges, in no face");
    case Contact::Face:
      return told("{}: the solids meet in faces and do not overlap");
    case Contact::Volume:
      break;
  }
  return empty ? std::optional(told("{}: the solids overlap, and nothing is left")) : std::nullopt;
}

/// One operation on all bodies: united they are one, else each keeps its material.
Result<Contact> combine_bodies(std::vector<Bodies::Body>& bodies, std::span<const Solid> others, Operation operation) {
  Contact most = Contact::Nothing;
  std::vector<Bodies::Body> results;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    std::vector<Solid> operands{bodies[i].solid};
    if (operation == Operation::Union) {
      for (std::size_t j = 1; j < bodies.size(); ++j) operands.push_back(bodies[j].solid);
    }
    operands.insert(operands.end(), others.begin(), others.end());
    DOBRA_TRY(solid::Combined combined, solid::combine(operands, operation));
    most = std::max(most, combined.contact);
    results.push_back({bodies[i].material, std::move(combined.solid)});
    if (operation == Operation::Union) break;
  }
  bodies = std::move(results);
  return most;
}

/// Bodies that have volume in common, each pair a finding: united, what is in both counts once.
Result<void> tell_overlaps(const std::vector<Bodies::Body>& bodies, std::span<const Solid> solids,
                           const std::string& file, std::vector<Finding>& findings) {
  DOBRA_TRY(const auto overlaps, solid::check::overlaps(solids));
  for (const solid::check::Overlap& overlap : overlaps) {
    findings.push_back({"overlap",
                        fmt::format("'{}' and '{}' overlap: {:.6g} m3 are in both; volume and area are those of all "
                                    "bodies united, which count it once",
                                    bodies[overlap.first].material, bodies[overlap.second].material, overlap.volume),
                        in_file_at(file, overlap.at)});
  }
  return {};
}

/// All bodies of a file as one solid; those that overlap are told.
Result<Solid> together(const std::vector<Bodies::Body>& bodies, const std::string& file,
                       std::vector<Finding>& findings) {
  if (bodies.size() == 1) return bodies[0].solid;
  std::vector<Solid> solids;
  for (const Bodies::Body& body : bodies) solids.push_back(body.solid);
  DOBRA_TRY(solid::Combined combined, solid::combine(solids, Operation::Union));
  if (combined.contact == Contact::Volume) DOBRA_TRY_VOID(tell_overlaps(bodies, solids, file, findings));
  return std::move(combined.solid);
}

/// Applies the steps; those of one kind that follow each other at once.
Result<void> apply(const std::vector<Step>& steps, std::span<const Solid> solids, Session& session,
                   const std::string& file, Outcome& outcome) {
  for (std::size_t first = 0; first < steps.size();) {
    DOBRA_TRY_VOID(session.check());
    std::vector<std::string> files;
    std::size_t end = first;
    for (; end < steps.size() && steps[end].kind == steps[first].kind; ++end) files.push_back(steps[end].file);
    const auto [option, operation] = kinds[steps[first].kind];
    DOBRA_TRY(const Contact contact, combine_bodies(outcome.bodies, solids.subspan(first, end - first), operation));
    const bool empty =
        std::all_of(outcome.bodies.begin(), outcome.bodies.end(), [](const auto& body) { return body.solid.empty(); });
    const std::string named = fmt::format("{} {}", option, fmt::join(files, ", "));
    if (auto finding = contact_finding(contact, empty, named)) outcome.findings.push_back(std::move(*finding));
    first = end;
  }
  DOBRA_TRY(outcome.solid, together(outcome.bodies, file, outcome.findings));
  return {};
}

/// Faces as the format of the file can hold them.
Result<solid::check::SettledMesh> faces_for(const std::string& file, const Solid& solid) {
  const std::size_t most = io::formats::most_corners(file);
  if (most <= 3) return solid::check::settle(solid, {.as = solid::FacesAs::Triangles});
  DOBRA_TRY(solid::check::SettledMesh faces, solid::check::settle(solid));
  const bool fits = std::all_of(faces.mesh.faces.begin(), faces.mesh.faces.end(),
                                [&](const auto& face) { return face.size() <= most; });
  return fits ? Result<solid::check::SettledMesh>(std::move(faces))
              : solid::check::settle(solid, {.as = solid::FacesAs::Triangles});
}

/// What rounding did to the boundary that is written; nothing to tell where it did nothing.
std::optional<Finding> rounding_finding(const solid::check::SettledMesh& faces, const Solid& exact,
                                        const std::string& file) {
  if (faces.displacement == 0.0) return std::nullopt;
  Finding finding{
      "written_rounded",
      fmt::format("corners were rounded to the nearest numbers in the file, by {:.3g} m at most", faces.displacement),
      in_file(file)};
  if (faces.merged > 0) {
    finding.message = fmt::format(
        "corners were rounded to the nearest numbers in the file, and so that faces do not cross by that, {} "
        "of them became one with another or were led onto an edge: the boundary moved by {:.3g} m at most",
        faces.merged, faces.displacement);
  }
  if (faces.at) finding.place = in_file_at(file, *faces.at);
  const solid::Counts counts = exact.counts();
  if (faces.counts.shells != counts.shells || faces.counts.handles != counts.handles) {
    finding.message += fmt::format(
        "; what is thinner than that is gone: shells {} and genus {} in the file, {} and {} of "
        "the result",
        faces.counts.shells, faces.counts.handles, counts.shells, counts.handles);
  }
  return finding;
}

/// The result as faces of the format, with what rounding to doubles did to it.
Result<void> write_out(Session& session, const Path& out, Outcome& outcome) {
  if (outcome.solid.empty()) {
    outcome.findings.push_back({"empty", "the result is empty; no file is written", {}});
    return {};
  }
  DOBRA_TRY(const solid::check::SettledMesh faces, faces_for(out.string(), outcome.solid));
  if (auto finding = rounding_finding(faces, outcome.solid, out.string()))
    outcome.findings.push_back(*std::move(finding));
  if (faces.flaw) {
    outcome.findings.push_back(
        {"written_flawed", fmt::format("by that rounding the file no longer bounds a solid: {}", faces.flaw->message),
         base::located(*faces.flaw, in_file(out.string())).place.value_or(base::Place{})});
  }
  return write_whole(session, out,
                     [&](const Path& path) { return io::formats::write_boundary(path.string(), faces.mesh); });
}

/// Every body in cells of one cube: volumes with bounds, and pairs that may overlap.
Result<nlohmann::ordered_json> octree_json(const std::vector<Bodies::Body>& bodies, int depth) {
  namespace partition = solid::partition;
  std::vector<Solid> solids;
  std::vector<std::string> names;
  for (const Bodies::Body& body : bodies) {
    if (body.solid.empty()) continue;
    solids.push_back(body.solid);
    names.push_back(body.material);
  }
  nlohmann::ordered_json json;
  json["depth"] = depth;
  json["bodies"] = nlohmann::json::array();
  if (solids.empty()) return json;
  const partition::Box<3> box = partition::cube_round(solids);
  json["edge"] = box.high[0] - box.low[0];
  std::vector<partition::Octree> trees;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    DOBRA_TRY(auto made, partition::octree_of(solids[i], box, depth));
    trees.push_back(std::move(made));
    const partition::Octree& tree = trees.back();
    const partition::Bounds volume = tree.volume();
    nlohmann::ordered_json told;
    told["material"] = names[i];
    told["volume"] = {volume.low, volume.high};
    told["leaves"] = tree.leaves().size();
    told["full"] = tree.count(partition::Fill::Full);
    told["partial"] = tree.count(partition::Fill::Partial);
    json["bodies"].push_back(std::move(told));
  }
  json["clashes"] = nlohmann::json::array();
  for (std::size_t i = 0; i < trees.size(); ++i) {
    for (std::size_t j = i + 1; j < trees.size(); ++j) {
      const partition::Clash found = partition::clash(trees[i], trees[j]);
      if (found == partition::Clash::None) continue;
      json["clashes"].push_back({{"bodies", {names[i], names[j]}}, {"sure", found == partition::Clash::Sure}});
    }
  }
  return json;
}

nlohmann::ordered_json json_of(const Outcome& outcome) {
  const solid::Measures measures = solid::measure(outcome.solid);
  const solid::Counts counts = outcome.solid.counts();
  nlohmann::ordered_json json;
  json["volume"] = measures.volume;
  json["area"] = measures.area;
  json["shells"] = counts.shells;
  json["genus"] = counts.handles;
  json["vertices"] = counts.vertices;
  json["edges"] = counts.edges;
  json["faces"] = counts.faces;
  json["centroid"] = {measures.centre.x, measures.centre.y, measures.centre.z};
  json["inertia"] = measures.inertia;
  json["seconds"] = {
      {"read", outcome.seconds.read}, {"boolean", outcome.seconds.boolean}, {"write", outcome.seconds.write}};
  if (outcome.cut) json["cut"] = *outcome.cut;
  if (!outcome.octree.is_null()) json["octree"] = outcome.octree;
  json["findings"] = findings_json(outcome.findings, {});
  return json;
}

/// What can be said before anything is read.
Result<void> check_options(const SolidOptions& options, const std::vector<Step>& steps) {
  if (options.extras.cut) {
    DOBRA_TRY_VOID(parse_plane(*options.extras.cut));
    if (options.out && options.out->extension() != ".toml") {
      return Error{ErrorCode::BadUsage,
                   fmt::format("--out {}: the section that --cut makes is a scenario; give a name that ends in .toml",
                               options.out->string())};
    }
  } else if (options.out) {
    DOBRA_TRY_VOID(io::formats::check_boundary_ending(options.out->string()));
  }
  if (!options.extras.part.empty() && options.file.extension() != ".toml")
    return Error{ErrorCode::BadUsage, "--part names a part of a scenario, and FILE is none"};
  if (options.out) DOBRA_TRY_VOID(check_writable(*options.out));
  for (const Step& step : steps) {
    if (step.matrix) DOBRA_TRY_VOID(parse_matrix(*step.matrix));
  }
  return {};
}

Result<int> solid_job(Session& session, const SolidCommand& program, const CLI::App& app, SolidOptions& options) {
  DOBRA_TRY(const std::vector<Step> steps, steps_of(app, options));
  DOBRA_TRY(options.extras, options.extra_options.read());
  DOBRA_TRY_VOID(check_options(options, steps));
  Outcome outcome;
  std::vector<Solid> solids;
  const auto read = [&](const std::string& file, const std::string& part, const std::optional<std::string>& matrix) {
    return timed(outcome.seconds.read,
                 [&] { return read_bodies(session, program, options, file, part, matrix, outcome.findings); });
  };
  DOBRA_TRY(Bodies first, read(options.file.string(), options.extras.part, std::nullopt));
  outcome.bodies = std::move(first.bodies);
  for (const Step& step : steps) {
    DOBRA_TRY_VOID(session.check());
    DOBRA_TRY(const Bodies other, read(step.file, "", step.matrix));
    DOBRA_TRY(Solid solid, together(other.bodies, step.file, outcome.findings));
    solids.push_back(std::move(solid));
  }
  DOBRA_TRY_VOID(
      timed(outcome.seconds.boolean, [&] { return apply(steps, solids, session, options.file.string(), outcome); }));
  if (options.extras.octree) {
    DOBRA_TRY(outcome.octree, octree_json(outcome.bodies, *options.extras.octree));
  }
  if (options.extras.cut) {
    DOBRA_TRY(const solid::CutPlane plane, parse_plane(*options.extras.cut));
    DOBRA_TRY(outcome.cut, timed(outcome.seconds.write, [&] {
                return program.cut(session, outcome.bodies, plane, options.out, outcome.findings);
              }));
  } else if (options.out) {
    DOBRA_TRY_VOID(timed(outcome.seconds.write, [&] { return write_out(session, *options.out, outcome); }));
  }
  nlohmann::ordered_json told = json_of(outcome);
  if (outcome.cut && session.options.format != OutputFormat::Json) {
    // What is printed as lines has no nested values.
    for (const char* key : {"area", "pieces", "holes", "curves"})
      told[fmt::format("cut_{}", key)] = (*outcome.cut)[key];
  }
  DOBRA_TRY_VOID(tell(session, told, outcome.findings));
  return 0;
}

void add_options(CLI::App& app, const SolidCommand& program, SolidOptions& options) {
  const std::string endings = fmt::format("{}", fmt::join(io::formats::boundary_endings(), " "));
  app.add_option("file", options.file, fmt::format("Boundary of a solid: {}; or {}", endings, program.scenario))
      ->required()
      ->type_name("FILE");
  const std::array help{"What is in either", "What is in both", "What is not in the other file"};
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    app.add_option(kinds[kind].first, options.others[kind],
                   fmt::format("{}; may be repeated, and the three apply from left to right", help[kind]))
        ->allow_extra_args(false)
        ->type_name("FILE");
  }
  app.add_option(place_option, options.places,
                 "Move the file before it: the 16 numbers of a matrix, row by row, with commas between them")
      ->allow_extra_args(false)
      ->type_name("M");
  std::vector<OptionOf> extras{"part", "repair", "octree"};
  if (program.cut) extras.emplace_back("cut");
  options.extra_options.add(app, extras);
  app.add_option("--out", options.out,
                 fmt::format("File to write: {}{}", endings, program.cut ? "; with --cut a scenario (.toml)" : ""))
      ->type_name("FILE");
}

}  // namespace

Command solid_command(SolidCommand program) {
  return {"solid", "Unite, intersect and subtract solids exactly, and measure them",
          [program = std::move(program)](CLI::App& app) -> Job {
            const auto options = std::make_shared<SolidOptions>();
            add_options(app, program, *options);
            return [program, options, &app](Session& session) -> Result<int> {
              auto done = solid_job(session, program, app, *options);
              if (!done) DOBRA_TRY_VOID(tell_refusal(session, done.error()));
              return done;
            };
          }};
}

}  // namespace dobra::cli
