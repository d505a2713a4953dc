#pragma once
// Stress intensity factors at crack tips, by three methods that share nothing but the displacements: displacement
// correlation (DCT), crack closure (MVCCI), domain interaction integral; with J, G and the T-stress. The spread of the
// three is the confidence. Page: docs/algorithms/crack.md.
// Source: [shih1976] (DCT), [raju1987] (closure), [nikishkov1987], [yau1980] (integrals), [kfouri1986] (T-stress).
//
// In the frame of a tip x points ahead and y to the left of the crack's direction of travel. In a symmetric half of a
// model the crack has one lip, and the boundary goes straight on ahead of the tip as a line of symmetry: y then points
// into the material, K_II is 0, and the other half counts as the mirror image.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "shared/fem/fracture/kink.h"
#include "shared/fem/problem.h"
#include "shared/fem/solve.h"

namespace dobra::fem::fracture {

enum class Lips : std::uint8_t { Both, OnlyLeft, OnlyRight };

/// The nearest node to a tip that something acts on by itself: a load, support or spring at a point or a tie, or those
/// of an internal line or on the lips but for their tractions, which the integrals take in.
struct NodeActedOn {
  geom::Point at;
  double distance = std::numeric_limits<double>::infinity();  ///< From the tip; 0: a force acts on the tip itself, m.
  double half_way = std::numeric_limits<double>::infinity();  ///< To the nearest load; supports may bear nothing, m.
  /// Radius of the disc that no element at such a node reaches into, m.
  double clear = std::numeric_limits<double>::infinity();
};

/// Where a tip and the elements of its lips are.
struct TipFrame {
  mesh::CrackTip tip;
  geom::Point at;
  Material material = {};
  Lips lips = Lips::Both;
  mesh::ElementSide left = {};  ///< Side of the left lip that ends in the tip; of the only lip.
  /// Side of the right lip that begins in the tip; ahead of the tip if there is one lip.
  mesh::ElementSide right = {};
  double length = 0.0;   ///< Of the side of the left lip, m.
  bool quarter = false;  ///< Both sides have their mid-side node at a quarter.
  /// Radius of the greatest disc round the tip with nothing in it but the straight end of the crack, m.
  double room = 0.0;
  NodeActedOn acted = {};  ///< Of a load case; tip_frames leaves it out.
  /// Unit, along y of the frame.
  [[nodiscard]] geom::Vector up() const { return (lips == Lips::OnlyRight ? -1.0 : 1.0) * left_of(tip.direction); }
  [[nodiscard]] geom::Vector local(geom::Vector v) const { return {dot(v, tip.direction), dot(v, up())}; }
};
/// BadCrack at the tip.
base::Error bad_tip(const TipFrame& frame, std::string message);
/// One a tip of the mesh, in their order: a tip that has none does not cost the others theirs.
/// @error of a tip, BadCrack with the place: no lips at it, lips (or lip and line ahead) that are not straight,
/// elements of two materials.
std::vector<base::Result<TipFrame>> tip_frames(const mesh::ElementMesh& mesh, const Materials& materials);

/// @error BadCrack: the elements at the tip are not quarter-point ones (the formula would be wrong by 60 %).
base::Result<Intensity> displacement_correlation(const mesh::ElementMesh& mesh, const TipFrame& frame,
                                                 std::span<const geom::Vector> u);

/// Quarter-point and plain quadratic elements; loads of the lips are taken into account.
/// @error BadCrack: not quadratic, no element side straight ahead, or one of another length than behind the tip.
base::Result<Intensity> crack_closure(const mesh::ElementMesh& mesh, const Problem& problem, const LoadCase& load,
                                      const TipFrame& frame, std::span<const geom::Vector> u);

/// The ring in which the weight q falls from 1 to 0, m.
struct Contour {
  double inner = 0.0;
  double outer = 0.0;
};
/// The node acted on that is nearest to a tip in a load case. @cost O(n)
NodeActedOn nearest_acted_on(const mesh::ElementMesh& mesh, const Problem& problem, const LoadCase& load,
                             const TipFrame& frame);
/// The largest ring in the room of the tip and within half the distance to a node with a load, clear of the elements of
/// all nodes acted on; if that is too small for the tip's elements, the smallest that they allow; or that of `outer`.
/// @error BadCrack: the room, or `outer`, does not reach twice the size of the tip's elements; `outer` leaves the room,
/// or holds a node acted on; a force acts on the tip itself.
base::Result<Contour> contour_of(const TipFrame& frame, std::optional<double> outer = std::nullopt);

struct DomainIntegrals {
  double j = 0.0;         ///< J/m2
  Intensity k;            ///< From the interaction integral.
  double t_stress = 0.0;  ///< Pa
};
/// J and the interaction integrals over a ring, with the work of loaded lips and body forces. @cost O(n)
DomainIntegrals domain_integrals(const mesh::ElementMesh& mesh, const LoadCase& load, const TipFrame& frame,
                                 const Contour& contour, std::span<const geom::Vector> u);

struct TipResult {
  std::string name;
  geom::Point at;
  geom::Vector ahead;
  Contour contour = {};
  DomainIntegrals domain = {};
  double inner_j = 0.0;  ///< J of a contour of half the size: how much it depends on the path.
  /// Why J counts for nothing: the ring cannot keep clear of a node acted on, where the energy is infinite.
  std::optional<std::string> no_j = {};
  std::optional<Intensity> correlation = {};  ///< Nothing where the elements do not allow it.
  std::optional<Intensity> closure = {};
  double release = 0.0;  ///< G = (K_I^2 + K_II^2) / E' of the interaction integral, J/m2.
  /// Greatest distance of another method's K from the interaction integral's, relative; nothing if there is no other.
  std::optional<double> spread = {};
  /// Where it turns; nothing if it is closed, or not loaded.
  struct Kinks {
    Kink sigma_theta, s_theta, g_theta;
  };
  std::optional<Kinks> kinks = {};
  std::vector<std::string> remarks = {};  ///< What the user should know: methods left out and why, lips that overlap.
  /// Why the tip has no figures; nothing but name, place and direction counts then. Those of tip_frames and contour_of;
  /// BadCrack: the line ahead of a single lip moves across.
  std::optional<base::Error> refused = {};
};
/// J and G, or K of two methods, that part by more than this have a remark.
constexpr double most_apart = 0.02;
/// Leaves J out where its ring is not clear, and adds remarks on that and on figures that part.
void compare_figures(const TipFrame& frame, TipResult& result);
/// All of it, for every tip, in their order. A crack whose lips overlap has its remark: contact is not modelled.
std::vector<TipResult> crack_tips(const mesh::ElementMesh& mesh, const Problem& problem, const LoadCase& load,
                                  std::span<const geom::Vector> u, std::optional<double> outer = std::nullopt);

}  // namespace dobra::fem::fracture
