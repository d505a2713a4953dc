#include "quebra/core/surface_start.h"

#include <algorithm>
#include <cmath>

#include "quebra/core/input.h"
#include "quebra/surfaces/expected_triangles.h"
#include "shared/geom/box3.h"
#include "shared/io/faces/import.h"

namespace quebra::core {

using namespace dobra;

namespace {

constexpr double sides_a_diagonal = 30.0;

/// 1, 2 or 5 times a power of ten, not above `value`.
double round_number(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= value) return digit * power;
  }
  return power;
}

geom::Box3 box_of(const std::vector<surf::trim::TrimmedSurface>& faces) {
  constexpr int samples = 16;
  geom::Box3 box;
  for (const auto& face : faces) {
    for (const auto& loop : face.loops) {
      for (const auto& edge : loop.edges) {
        for (int i = 0; i < samples; ++i)
          box.add(face.surface.at(edge.at(edge.from + (edge.to - edge.from) * i / samples)));
      }
    }
  }
  return box;
}

}  // namespace

scenario::FileKind brep_files() { return {"Boundary model", {".brep"}}; }

double usual_turn(std::span<const surf::trim::TrimmedSurface> faces, double size) {
  constexpr double usual = 10.0, most = 40.0, many = 2e5;
  constexpr int lines = 64;
  double turn = usual;
  const auto makes_many = [&](const surf::trim::TrimmedSurface& face) {
    return surfaces::expected_triangles(face, {.largest = size, .turn = turn}, lines).count > many;
  };
  while (turn < most && std::any_of(faces.begin(), faces.end(), makes_many)) turn *= 2.0;
  return turn;
}

base::Result<scenario::Document> document_of_brep(const std::filesystem::path& file) {
  DOBRA_TRY(const io::faces::Imported imported, io::faces::faces_of_file(file.string()));
  scenario::Document document;
  document.program = "quebra";
  document.title = file.stem().string();
  document.input.set("file", file.string());
  const double diagonal = box_of(imported.faces).diagonal();
  if (!(diagonal > 0.0)) return document;  // the run says why there is nothing to mesh
  scenario::Step mesh;
  mesh.operation = "mesh";
  const double size = round_number(diagonal / sides_a_diagonal);
  mesh.params.set("size", size);
  mesh.params.set("turn", usual_turn(imported.faces, size));
  document.steps.push_back(std::move(mesh));
  return document;
}

}  // namespace quebra::core
