#pragma once
// A convex solid that is cut by one plane after another, exactly; each cut looks only at what it takes away and its
// neighbours. Page: docs/algorithms/sweeps.md.

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "shared/solid/section.h"
#include "shared/solid/solid.h"

namespace dobra::solid::shape {

class ConvexCutter {
 public:
  /// All that is at most so far from the origin in x, y and z.
  explicit ConvexCutter(double reach);

  /// Keeps what is on or below the plane. A plane that takes away no corner, as told by nearest doubles, changes
  /// nothing.
  /// @cost O(corners taken away and their neighbours + steps from the last cut to this one)
  void cut(const Plane& plane, const std::string& name);
  void cut(const CutPlane& plane, const std::string& name) {
    cut(Plane{{geom::Point3{plane.a, plane.b, plane.c}, {}, {}}, plane.d}, name);
  }

  /// Nothing with a volume is left.
  [[nodiscard]] bool empty() const { return empty_; }
  /// The nearest doubles of the corners.
  [[nodiscard]] std::vector<geom::Point3> corners() const;
  /// @pre no face of the beginning is left
  [[nodiscard]] Solid solid() const;

 private:
  struct Corner {
    PointId at;
    std::vector<std::uint32_t> faces;  ///< Empty: it is gone.
  };
  struct Face {
    PlaneId plane;
    std::uint32_t name = 0;
    std::vector<std::uint32_t> loop;  ///< Anticlockwise seen from outside; empty: it is gone.
  };
  struct Cut;

  [[nodiscard]] double height(geom::Vector3 normal, std::uint32_t corner) const;
  [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t corner) const;
  [[nodiscard]] std::vector<std::uint32_t> highest(geom::Vector3 normal) const;
  geom::Sign side(Cut& cut, std::uint32_t corner) const;
  void find_above(Cut& cut) const;
  void clip(Cut& cut, std::uint32_t face);
  void close(Cut& cut, std::uint32_t name);
  std::uint32_t crossing(Cut& cut, std::uint32_t face, std::uint32_t from, std::uint32_t to);
  std::uint32_t name_number(const std::string& name);

  Space space_;
  std::vector<Corner> corners_;
  std::vector<Face> faces_;
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
  double reach_;
  std::uint32_t near_ = 0;  ///< A corner that is there, of the last cut.
  bool empty_ = false;
};

}  // namespace dobra::solid::shape
