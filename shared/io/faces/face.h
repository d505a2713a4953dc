#pragma once
// One face on its way from the file.

#include <map>

#include "shared/io/brep/faces.h"
#include "shared/io/faces/loops.h"

namespace dobra::io::faces {

/// The same but for rounding, by the size of what is moved.
bool same_place(const brep::Placement& a, const brep::Placement& b);

/// Edges of the file in the world: one number for each shape at each place.
class SharedEdges {
 public:
  surf::trim::SharedCurveId id_of(brep::Index edge, const brep::Placement& placement);
  /// For a curve that is of no other face.
  surf::trim::SharedCurveId& next() { return next_; }

 private:
  struct Known {
    brep::Placement placement;
    surf::trim::SharedCurveId id;
  };
  std::map<brep::Index, std::vector<Known>> known_;
  surf::trim::SharedCurveId next_ = 0;
};

Outcome<surf::trim::TrimmedSurface> imported(const brep::Model& model, const brep::TrimmedFace& face,
                                             SharedEdges& shared, const ImportOptions& options, Report& report);

}  // namespace dobra::io::faces
