#pragma once
// What a document of solids looks like: the faces of its parts by their names, their edges, their shells drawn apart,
// and the section by a plane that a hand moves. Page: docs/user/solids.md.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "quebra/model/model.h"
#include "quebra/solids/parts.h"
#include "shared/scene/space/cut.h"
#include "shared/scene/space/picture.h"
#include "shared/solid/section.h"

namespace quebra::core {

inline constexpr const char* solid_layer = "solid";  ///< The last part; others are "part.NAME".
inline constexpr const char* solid_edges_layer = "solid_edges";
inline constexpr const char* exploded_layer = "exploded";
inline constexpr const char* exploded_edges_layer = "exploded_edges";
inline constexpr const char* section_panel_key = "solid_section";

/// The last part with its edges, all other parts, hidden, and its shells apart, hidden, where it has several. Items of
/// parts are faces by their names: all faces of one name are one.
/// @cost that of to_mesh() for each part
void draw_solids(const model::Model& model, dobra::scene::space::SpacePicture& picture);

/// The names of a part's faces, each once, sorted: the items of its layer.
std::vector<std::string> face_names(const solids::Part& part);

/// The last part cut by planes.
class SolidSections {
 public:
  /// @pre not parts->parts.empty()
  explicit SolidSections(std::shared_ptr<const solids::Parts> parts);
  [[nodiscard]] const std::shared_ptr<const solids::Parts>& parts() const { return parts_; }

  struct Made {
    std::vector<dobra::scene::space::Layer> caps;  ///< The areas of the cut in space; items are bodies.
    dobra::scene::Panel panel;                     ///< The same in its plane; items of lines are those of the part.
  };
  /// In SI; nothing: the plane meets nothing. The section is seen from the side that the normal points to.
  /// @cost O(k log k) for k faces that are cut
  [[nodiscard]] std::optional<Made> cut(const dobra::scene::space::CutPlane& plane) const;

 private:
  std::shared_ptr<const solids::Parts> parts_;
  std::vector<std::string> materials_;  ///< Of each body.
  dobra::solid::Sections sections_;
};

}  // namespace quebra::core
