#pragma once
// The solids of a scenario: parts by their names, each of one or more bodies with their materials. Page:
// docs/user/solids.md.

#include <array>
#include <string>
#include <vector>

#include "shared/solid/cap.h"
#include "shared/solid/csg/csg.h"

namespace quebra::solids {

/// What is of one material.
struct Body {
  std::string material;
  dobra::solid::csg::Tree tree;
  dobra::solid::Solid solid;  ///< What the tree gives.
};

struct Part {
  std::string name;
  std::vector<Body> bodies;
};

struct Parts {
  std::vector<Part> parts;  ///< In the order made.
  [[nodiscard]] const Part* find(const std::string& name) const {
    for (const Part& part : parts) {
      if (part.name == name) return &part;
    }
    return nullptr;
  }
};

/// All bodies as one solid.  @error those of combine()
dobra::base::Result<dobra::solid::Solid> whole(const Part& part);

}  // namespace quebra::solids
