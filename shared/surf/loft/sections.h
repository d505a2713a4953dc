#pragma once
// Sections as they stand in space: each hangs from its trace on the map, and its lines have names. Surfaces are made
// through lines of one name. Page: docs/algorithms/loft.md.

#include <cstdint>
#include <string>
#include <vector>

#include "shared/base/finding.h"
#include "shared/base/result.h"
#include "shared/geom/point3.h"
#include "shared/geom/polyline.h"

namespace dobra::surf::loft {

using Finding = base::Finding;  ///< Codes: docs/user/space.md.

/// A vertical surface over a polyline of the map. A point of a section is (s, z): s the distance along the trace from
/// its first corner, z the height.
class PlanTrace {
 public:
  /// @error NotFinite; DegenerateCurve: fewer than two corners, a corner twice in turn, or a trace that meets itself,
  ///        with the place.
  static base::Result<PlanTrace> make(std::vector<geom::Point> corners);

  /// Before the first corner and behind the last the end pieces go straight on.
  [[nodiscard]] geom::Point on_map(double s) const { return geom::point_at({corners_, false}, distances_, s); }
  [[nodiscard]] geom::Point3 in_space(geom::Point sz) const {
    const geom::Point p = on_map(sz.x);
    return {p.x, p.y, sz.y};
  }
  [[nodiscard]] double length() const { return distances_.back(); }
  [[nodiscard]] const std::vector<geom::Point>& corners() const { return corners_; }
  /// Of each corner from the first, m.
  [[nodiscard]] const std::vector<double>& distances() const { return distances_; }

 private:
  PlanTrace(std::vector<geom::Point> corners, std::vector<double> distances)
      : corners_(std::move(corners)), distances_(std::move(distances)) {}
  std::vector<geom::Point> corners_;
  std::vector<double> distances_;
};

enum class LineKind : std::uint8_t { Horizon, Fault };
const char* kind_name(LineKind kind);

/// Lines of one section that share a name are pieces of one line.
struct SectionLine {
  std::string name;
  LineKind kind = LineKind::Horizon;
  geom::Polyline line;  ///< (s, z); open, two points at least.
};

struct Section {
  std::string name;
  PlanTrace trace;
  std::vector<SectionLine> lines;
};

/// The line in space, with a vertex where the trace bends. A vertex of the line that is there but for rounding (1e-6 of
/// the trace's length, or half a unit of its last decimal up to 1e-5 of it) is put there.
std::vector<geom::Point3> in_space(const PlanTrace& trace, const geom::Polyline& line);

/// The line without vertices that are not farther than `near` from the one before them, or from its end. Its ends stay.
std::vector<geom::Point3> without_twins(const std::vector<geom::Point3>& line, double near);

/// Diagonal of the box of all lines in space: what tolerances are measured by, m.
double size_of(const std::vector<Section>& sections);

}  // namespace dobra::surf::loft
