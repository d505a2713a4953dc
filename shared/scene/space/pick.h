#pragma once
// What is under the cursor in space: markers and lines that are seen near it, else the triangle that the ray through it
// meets first. A hierarchy of boxes over the triangles of each surface makes that quick.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shared/scene/pick.h"
#include "shared/scene/space/picture.h"

namespace dobra::scene::space {

struct SpacePick {
  scene::Pick pick{};    ///< Layer (of a curtain "LAYER/SECTION_LAYER") and identity of the item.
  std::size_t item = 0;  ///< Its number in the layer; of a surface the triangle's.
  geom::Point3 place{};  ///< Of the model.
  std::optional<geom::Point> chart = std::nullopt;  ///< In the parameter plane, or in the section of a curtain.
  friend bool operator==(const SpacePick&, const SpacePick&) = default;
};

/// Boxes over triangles; the nearest triangle that a ray meets.
class TriangleTree {
 public:
  /// @cost O(n log n). The lists are shared, not copied.
  explicit TriangleTree(const Surface& surface);
  struct Hit {
    std::size_t triangle = 0;
    double along = 0.0;               ///< Of the ray, m.
    std::array<double, 3> weights{};  ///< Of the corners.
  };
  /// Of equally near triangles the first in the list. @cost O(log n) for usual surfaces
  [[nodiscard]] std::optional<Hit> first_hit(const Ray& ray) const;

 private:
  struct Node {
    geom::Box3 box;
    std::uint32_t begin = 0, end = 0;  ///< Of order_; a leaf has no children.
    std::uint32_t left = 0, right = 0;
  };
  std::uint32_t build(std::uint32_t begin, std::uint32_t end, const std::vector<geom::Point3>& centres);
  void meet(const Ray& ray, std::uint32_t triangle, std::optional<Hit>& best) const;

  base::Shared<std::vector<geom::Point3>> points_;
  base::Shared<std::vector<std::array<std::uint32_t, 3>>> triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

/// Answers for one picture. It may be made on any thread.
class Picker {
 public:
  /// @cost O(n log n), n triangles of all surfaces
  explicit Picker(const SpacePicture& picture);
  void set_visible(std::string_view layer, bool visible);
  /// @param tolerance  round markers and lines, page.
  /// @cost  O(log n + points of visible lines and markers)
  [[nodiscard]] std::optional<SpacePick> pick(const Sheet& sheet, geom::Point page, double tolerance) const;

 private:
  [[nodiscard]] std::optional<SpacePick> surface_at(const Ray& ray, double& along) const;

  std::vector<Layer> layers_;
  std::vector<std::shared_ptr<const TriangleTree>> trees_;  ///< One a layer; null: no surface.
  geom::Box3 extent_;
};

/// The rim of the triangles, the lines and points that a pick means, drawn so as to stand out: what marks it in the
/// picture. Empty where the layer has no such item.
std::vector<Layer> highlight(const SpacePicture& picture, const scene::Pick& pick);

/// A surface of at most so many triangles that looks the same from afar: points of one cell of a grid become their
/// middle. It is itself where it is small enough. @cost O(n) a trial, a few trials
Surface thinned(const Surface& surface, std::size_t most);

}  // namespace dobra::scene::space
