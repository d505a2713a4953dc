#pragma once
// Exact points and planes under numbers. A point is three doubles, or where planes and edges meet, four exact numbers
// (x, y, z, w) with w > 0 and the nearest doubles of x/w, y/w, z/w beside; where an edge between doubles meets a plane,
// the exact numbers are worked out only where they are asked for. A plane runs through three points of doubles, or has
// four doubles as coefficients. Equal places have equal numbers, so that everything built on them is combinatorial.
// Every sign is decided by a filter in doubles, then exactly. Page: docs/algorithms/boolean.md.

#include <memory>
#include <optional>
#include <unordered_map>
#include <variant>
#include <vector>

#include "shared/base/id.h"
#include "shared/geom/point3.h"
#include "shared/geom/predicates.h"
#include "shared/solid/dyadic.h"

namespace dobra::solid {

struct PointTag {
  static constexpr const char* prefix = "p";
};
struct PlaneTag {
  static constexpr const char* prefix = "q";
};
using PointId = base::Id<PointTag>;
using PlaneId = base::Id<PlaneTag>;

/// x/w, y/w, z/w with w > 0.
struct Homogeneous {
  Dyadic3 place;
  Dyadic weight;
};

/// A plane n x + d = 0 as it was given; its upper side is where n x + d > 0.
struct Plane {
  std::array<geom::Point3, 3> through;  ///< Anticlockwise seen from above; or, by coefficients, n in through[0].
  std::optional<double> constant;       ///< d, if the plane is given by coefficients.
  friend bool operator==(const Plane&, const Plane&) = default;
};

/// The two axes that are left where the third is dropped, in an order in which turns to the left stay so.
struct Projection {
  int u = 0, v = 1;
};

class Space {
 public:
  Space();

  /// The number of the place; a new one only if it is not there yet.  @pre finite
  PointId add(geom::Point3 place);
  PointId add(Homogeneous place);
  /// The same place in this space.
  PointId add(const Space& other, PointId point);
  /// @pre the points are not collinear, or n is not zero.
  PlaneId add(const Plane& plane);

  /// Room for as many in all.
  void reserve(std::size_t points, std::size_t planes);

  [[nodiscard]] std::size_t point_count() const { return rounded_.size(); }
  [[nodiscard]] std::size_t plane_count() const { return planes_.size(); }
  /// The nearest doubles; the place itself where is_exact().
  [[nodiscard]] geom::Point3 rounded(PointId p) const { return rounded_[p.index()]; }
  [[nodiscard]] bool is_exact(PointId p) const { return exact_[p.index()] == nothing; }
  [[nodiscard]] Homogeneous place(PointId p) const;
  [[nodiscard]] double coordinate(PointId p, int axis) const {
    const geom::Point3& at = rounded_[p.index()];
    return axis == 0 ? at.x : axis == 1 ? at.y : at.z;
  }
  [[nodiscard]] const Plane& plane(PlaneId q) const { return planes_[q.index()].given; }
  /// n exactly.
  [[nodiscard]] const Dyadic3& normal(PlaneId q) const { return coefficients(q).place; }
  /// n and d exactly.
  [[nodiscard]] const Homogeneous& coefficients(PlaneId q) const;
  /// The normal in doubles; its length means nothing.
  [[nodiscard]] geom::Vector3 rough_normal(PlaneId q) const { return planes_[q.index()].normal; }
  [[nodiscard]] geom::Sign normal_sign(PlaneId q, int axis) const;
  /// Drops the axis along which the normal is greatest; seen from above the plane.
  [[nodiscard]] Projection projection(PlaneId q) const;

  /// Positive above the plane.
  [[nodiscard]] geom::Sign side(PlaneId q, PointId p) const;
  /// The same for a place that need not be in the space.  @pre finite
  [[nodiscard]] geom::Sign side(PlaneId q, geom::Point3 p) const;
  /// Whether all of one plane lies in the other.
  [[nodiscard]] bool coplanar(PlaneId a, PlaneId b) const;
  /// Positive if a, b, c turn left in the projection.
  [[nodiscard]] geom::Sign orient(Projection onto, PointId a, PointId b, PointId c) const;
  [[nodiscard]] bool collinear(PointId a, PointId b, PointId c) const;
  /// Of the coordinates.
  [[nodiscard]] std::strong_ordering compare(int axis, PointId a, PointId b) const;
  /// By u, then by v.
  [[nodiscard]] std::strong_ordering compare(Projection onto, PointId a, PointId b) const;

  /// Where the line through a and b meets the plane.  @pre one of them is above it and one below
  PointId meet(PointId a, PointId b, PlaneId q);
  /// @pre the planes have one point in common
  PointId meet(PlaneId a, PlaneId b, PlaneId c);
  /// Where the lines a-b and c-d of one plane cross.  @pre they do so properly in the projection
  PointId meet(Projection onto, PointId a, PointId b, PointId c, PointId d);
  /// Half way.
  [[nodiscard]] Homogeneous middle(PointId a, PointId b) const;

 private:
  static constexpr std::uint32_t nothing = 0xffffffffU;
  struct KeptPlane {
    Plane given;
    geom::Vector3 normal;
    geom::Vector3 error;  // of the normal
    mutable std::unique_ptr<Homogeneous> exact;
  };

  /// Where the line through a and b meets the plane, one of them above it and one below.
  struct Crossing {
    geom::Point3 a, b;
    Plane plane;
    friend bool operator==(const Crossing&, const Crossing&) = default;
  };
  /// What is not three doubles.
  using Implicit = std::variant<std::shared_ptr<const Homogeneous>, Crossing>;
  /// An edge, its lesser end first, and a plane.
  struct EdgeAndPlane {
    PointId a, b;
    PlaneId plane;
    friend bool operator==(const EdgeAndPlane&, const EdgeAndPlane&) = default;
  };
  struct Hash {
    std::size_t operator()(const EdgeAndPlane& key) const;
  };

  /// @param exact  gives the place, where the filter cannot tell.
  template <class Exact>
  [[nodiscard]] geom::Sign side(PlaneId q, geom::Point3 at, bool is_exact, Exact&& exact) const;
  PointId find_or_add(geom::Point3 rounded, const Implicit* exact);
  void resize_slots(std::size_t count);
  [[nodiscard]] bool same(std::uint32_t number, const Implicit* exact) const;
  [[nodiscard]] static Homogeneous place(const Implicit& implicit);
  PointId add_crossing(PointId a, PointId b, PlaneId q);
  /// Whether all are known to be on the line of one edge, as they were made on it; no says nothing.
  [[nodiscard]] bool on_one_edge(PointId a, PointId b, PointId c) const;
  [[nodiscard]] Dyadic exact_orient(Projection onto, PointId a, PointId b, PointId c) const;

  std::vector<geom::Point3> rounded_;
  std::vector<std::uint32_t> exact_;
  std::vector<Implicit> places_;
  std::vector<KeptPlane> planes_;
  std::vector<std::uint32_t> slots_;
  std::unordered_map<EdgeAndPlane, PointId, Hash> crossings_;
};

}  // namespace dobra::solid
