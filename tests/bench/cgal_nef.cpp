#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>

#include <ctime>

#include "tests/bench/solid_peers.h"

namespace bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

class Builder : public CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
 public:
  explicit Builder(const dobra::mesh::PolygonMesh& mesh) : mesh_(mesh) {}
  void operator()(Polyhedron::HalfedgeDS& target) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(target, true);
    builder.begin_surface(mesh_.points.size(), mesh_.faces.size());
    for (const auto p : mesh_.points) builder.add_vertex({p.x, p.y, p.z});
    for (const auto& face : mesh_.faces) builder.add_facet(face.begin(), face.end());
    builder.end_surface();
  }

 private:
  const dobra::mesh::PolygonMesh& mesh_;
};

Nef nef_of(const dobra::mesh::PolygonMesh& mesh) {
  Polyhedron polyhedron;
  Builder builder(mesh);
  polyhedron.delegate(builder);
  return Nef(polyhedron);
}

}  // namespace

NefUnion cgal_nef_union(const dobra::mesh::PolygonMesh& a, const dobra::mesh::PolygonMesh& b) {
  const Nef first = nef_of(a);
  const Nef second = nef_of(b);
  const std::clock_t start = std::clock();
  const Nef united = first + second;
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return {seconds, united.number_of_vertices()};
}

}  // namespace bench
