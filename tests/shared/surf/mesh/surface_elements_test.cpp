#include "shared/surf/mesh/surface_elements.h"

#include "tests/shared/surf/mesh/faces.h"

namespace dobra::surf::mesh {
namespace {

using dobra::mesh::ElementId;
using dobra::mesh::ElementType;
using geom::Point3;
using test::pi;
using test::polygon;
using trim::TrimmedSurface;

struct Made {
  std::vector<TrimmedSurface> surfaces;
  Division division;
  SurfaceMesh mesh;
};
Made made(std::vector<TrimmedSurface> surfaces, double largest, double turn, int inside) {
  Made result{std::move(surfaces), {}, {}};
  DivisionOptions options;
  options.sizes.largest = largest;
  options.sizes.turn = turn;
  result.division = test::divided(result.surfaces, options);
  auto mesh = test::meshed(result.surfaces, result.division, inside);
  if (!mesh) {
    ADD_FAILURE() << base::to_string(mesh.error());
    return result;
  }
  result.mesh = *std::move(mesh);
  return result;
}

/// A quarter of a cylinder of radius 5 along y, and the plane that its lower edge lies in.
std::vector<TrimmedSurface> bend() {
  TrimmedSurface roof{
      .surface = *Surface::cylinder({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, 5.0, {{0, -4}, {0.5 * pi, 0}}),
      .loops = {polygon({{0, -4}, {0.5 * pi, -4}, {0.5 * pi, 0}, {0, 0}})}};
  TrimmedSurface floor{.surface = *Surface::plane({.origin = {5, 0, 0}}, {{0, 0}, {3, 4}}),
                       .loops = {polygon({{0, 0}, {3, 0}, {3, 4}, {0, 4}}, "rim")}};
  roof.loops[0].edges[3].shared = floor.loops[0].edges[3].shared = 1;
  floor.loops[0].edges[3].against = true;
  return {roof, floor};
}

TEST(SurfaceElements, CheckFindsWhatIsWrong) {
  const Made all = made({{.surface = test::flat(4, 4)}}, 1, 15, 2);
  const SurfaceElements good = to_second_order(elements_of(all.mesh), all.surfaces);
  ASSERT_TRUE(check(good).ok());
  SurfaceElements folded = good;
  const NodeId middle = folded.mesh.nodes_of(ElementId(0))[3];
  folded.mesh.points[middle.index()].x += 2.0;
  EXPECT_FALSE(check(folded).ok());
  SurfaceElements torn = good;
  torn.heights.pop_back();
  EXPECT_FALSE(check(torn).ok());
  SurfaceElements twice = good;
  const auto nodes = good.mesh.nodes_of(ElementId(0));
  dobra::mesh::add_element(twice.mesh, ElementType::T6, std::vector<NodeId>(nodes.begin(), nodes.end()), 0);
  twice.faces.push_back(0);
  twice.places.insert(twice.places.end(), twice.places.begin(), twice.places.begin() + 6);
  EXPECT_FALSE(check(twice).ok());
}

TEST(SurfaceElements, MiddlesOfSidesLieOnTheSurfaceAndAreSharedByFaces) {
  const Made all = made(bend(), 1, 15, 4);
  ASSERT_FALSE(all.mesh.triangles.empty());
  const SurfaceElements elements = to_second_order(elements_of(all.mesh), all.surfaces, all.division.middles);
  EXPECT_TRUE(check(elements).ok()) << base::to_string(check(elements).error());
  std::size_t edges = quality_of(all.mesh).edges;
  EXPECT_EQ(elements.mesh.points.size(), all.mesh.points.size() + edges);
  for (std::size_t e = 0; e < elements.mesh.element_count(); ++e) {
    ASSERT_EQ(elements.mesh.types[e], ElementType::T6);
    const auto nodes = elements.mesh.nodes_of(ElementId(e));
    for (std::size_t i = 0; i < 6; ++i) {
      const Point3 p = elements.point(nodes[i]);
      if (elements.faces[e] == 0) {
        EXPECT_NEAR(std::hypot(p.x, p.z), 5.0, 1e-9);
      } else {
        EXPECT_NEAR(p.z, 0.0, 1e-9);
      }
      const auto place = elements.places[elements.mesh.first[e] + i];
      EXPECT_LE(geom::distance(all.surfaces[elements.faces[e]].surface.at(place), p), 1e-9);
    }
  }
}

TEST(SurfaceElements, TheMiddleOfABorderLiesOnItsCurveThoughTheSurfaceIsPlane) {
  TrimmedSurface disc{.surface = *Surface::plane({}, {{-1, -1}, {1, 1}}),
                      .loops = {{{test::circle({0, 0}, 1, "rim")}}}};
  const Made all = made({disc}, 0.5, 30, 2);
  const SurfaceElements elements = to_second_order(elements_of(all.mesh), all.surfaces, all.division.middles);
  for (const auto& side : elements.mesh.side_sets.at("rim")) {
    const NodeId middle = dobra::mesh::side_nodes(elements.mesh, side)[2];
    const Point3 p = elements.point(middle);
    EXPECT_NEAR(std::hypot(p.x, p.y), 1.0, 1e-9);
  }
  EXPECT_TRUE(check(elements).ok());
}

TEST(SurfaceElements, QuadrilateralsAreMadeInSpaceWithinAFace) {
  const Made all = made(bend(), 0.5, 15, 8);
  const SurfaceElements triangles = elements_of(all.mesh);
  const SurfaceElements mixed = recombine(triangles, {.least_quality = 0.2});
  EXPECT_TRUE(check(mixed).ok());
  std::size_t quads = 0;
  for (std::size_t e = 0; e < mixed.mesh.element_count(); ++e) {
    quads += mixed.mesh.types[e] == ElementType::Q4 ? 1 : 0;
    const auto nodes = mixed.mesh.nodes_of(ElementId(e));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto place = mixed.places[mixed.mesh.first[e] + i];
      EXPECT_LE(geom::distance(all.surfaces[mixed.faces[e]].surface.at(place), mixed.point(nodes[i])), 1e-9);
    }
  }
  EXPECT_GT(quads, 20u);
  EXPECT_EQ(2 * quads + (mixed.mesh.element_count() - quads), triangles.mesh.element_count());
  EXPECT_EQ(mixed.mesh.side_sets.at("rim").size(), triangles.mesh.side_sets.at("rim").size());
  const SurfaceElements quadratic = to_second_order(mixed, all.surfaces, all.division.middles);
  EXPECT_TRUE(check(quadratic).ok());
}

}  // namespace
}  // namespace dobra::surf::mesh
