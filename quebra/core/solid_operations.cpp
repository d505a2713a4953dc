#include "quebra/core/solid_operations.h"

#include "quebra/core/solid_layers.h"
#include "quebra/solids/steps.h"

namespace quebra::core {

using namespace dobra;

std::vector<scenario::Operation> solid_operations() {
  return {
      scenario::make_operation<model::Model, solids::BlockParams>(
          "block", "Block", "A box by its three sizes.", solids::add_block,
          {.quantities = solids::add_part_quantities, .outputs = solids::add_part_outputs, .draw_space = draw_solids}),
      scenario::make_operation<model::Model, solids::PrismParams>("prism", "Prism", "Over a regular polygon.",
                                                                  solids::add_prism),
      scenario::make_operation<model::Model, solids::PyramidParams>(
          "pyramid", "Pyramid", "Over a regular polygon, to a point.", solids::add_pyramid),
      scenario::make_operation<model::Model, solids::CylinderParams>(
          "cylinder", "Cylinder", "Over a polygon that stands for a circle.", solids::add_cylinder),
      scenario::make_operation<model::Model, solids::ConeParams>(
          "cone", "Cone", "Over a polygon that stands for a circle, to a point or a smaller circle.", solids::add_cone),
      scenario::make_operation<model::Model, solids::SphereParams>(
          "sphere", "Sphere", "About its origin, with corners on the sphere.", solids::add_sphere),
      scenario::make_operation<model::Model, solids::TorusParams>("torus", "Torus", "A ring about its z axis.",
                                                                  solids::add_torus),
      scenario::make_operation<model::Model, solids::ExtrudeParams>(
          "extrude", "Extruded profile", "A plane contour with holes, moved along a vector.", solids::add_extruded),
      scenario::make_operation<model::Model, solids::SweepParams>(
          "sweep", "Profile along a path", "A plane contour with holes, moved along straight legs with mitred corners.",
          solids::add_swept),
      scenario::make_operation<model::Model, solids::RevolveParams>(
          "revolve", "Turned profile",
          "A contour of (radius, z) turned about the z axis, all the way round or part of it.", solids::add_revolved),
      scenario::make_operation<model::Model, solids::LoftParams>(
          "loft", "Profiles joined", "Plane contours in space, each joined to the next by triangles.",
          solids::add_lofted),
      scenario::make_operation<model::Model, solids::SolidFileParams>(
          "solid_file", "Solid of a file", "A solid whose boundary a file holds.", solids::add_solid_file),
      scenario::make_operation<model::Model, solids::UniteParams>(
          "unite", "United parts", "What is in any of the parts, as one body.", solids::add_united),
      scenario::make_operation<model::Model, solids::IntersectParams>(
          "intersect", "Common part", "What of the first part is in all the others.", solids::add_intersected),
      scenario::make_operation<model::Model, solids::SubtractParams>("subtract", "Part without others",
                                                                     "What of the first part is in none of the others.",
                                                                     solids::add_subtracted),
      scenario::make_operation<model::Model, solids::GroupParams>(
          "group", "Group of parts", "Parts side by side, each with its material; it is placed and cut as one.",
          solids::add_group),
      scenario::make_operation<model::Model, solids::PlaceParams>(
          "place", "Placed part", "Parts scaled, turned and moved, or placed by a matrix; those they are made of stay.",
          solids::add_placed),
      scenario::make_operation<model::Model, solids::RoundParams>(
          "round", "Rounded part", "All edges and corners of a convex part rounded.", solids::add_rounded),
      scenario::make_operation<model::Model, solids::CutParams>(
          "cut", "Section by a plane", "The section of parts becomes the plane domain: outlines, holes and materials.",
          solids::cut_to_domain),
  };
}

}  // namespace quebra::core
