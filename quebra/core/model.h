#pragma once
// What QUEBRA works on: a domain bounded by curves, internal constraints, and the meshes made so far. A value.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "quebra/core/curve.h"
#include "quebra/core/meshed.h"
#include "shared/fem/fracture/rosette.h"
#include "shared/scenario/units.h"

namespace quebra::core {

/// A point where a curve meets another one away from its ends, or where a point of the domain lies on it: a node of
/// both.
struct Junction {
  std::size_t curve = 0;
  double s = 0.0;
  dobra::geom::Point at;
};

/// A part of the material, bounded by loops and internal lines.
struct Face {
  std::int32_t region = 0;  ///< Tag: 1, 2, ... first the named regions in their order.
  dobra::geom::Point inside;
  double area = 0.0;  ///< m2, arcs followed by trace_turn.
};

/// A node wanted inside or on a curve: a support, a load, a gauge.
struct NamedPoint {
  std::string name;  ///< Of the set that its node belongs to; empty: a size only.
  dobra::geom::Point at;
  double size = 0.0;  ///< Of the elements there, m; 0: no wish.
};

/// Elements of at most `size` within `width` of a line.
struct Zone {
  std::string name;
  dobra::geom::Polyline line;
  double size = 0.0;   ///< m.
  double width = 0.0;  ///< m, to either side.
};

/// Curves joined into loops. Ends that meet are the same point, bit for bit.
struct Domain {
  std::vector<Curve> curves;
  /// One loop: indices of curves in order round it, and whether each is travelled backwards.
  struct Side {
    std::size_t curve = 0;
    bool backwards = false;
  };
  struct Loop {
    std::vector<Side> sides;
    int depth = 0;  ///< 0: outer boundary, 1: hole in it, 2: island in the hole ...
  };
  std::vector<Loop> loops;
  std::vector<Junction> junctions;  ///< By curve, then by distance.
  std::vector<NamedPoint> points;
  std::vector<Face> faces;
  std::map<std::int32_t, std::string> region_names;
  double unit = 1.0;  ///< Of the coordinates in conditions on places (selection.h), m.

  [[nodiscard]] dobra::geom::Box box() const;
  /// As of lone_circles, of these curves and points.
  [[nodiscard]] std::vector<std::uint8_t> lone_circles(double margin) const;
};

/// An offset curve inside the domain, along which the mesh must have edges.
struct Constraint {
  std::string name;       ///< "hole_1": base curve and number.
  double distance = 0.0;  ///< From the base, m.
  double spacing = 0.0;   ///< Wanted distance of its nodes, m.
  dobra::geom::Polyline line;
  /// Where its ends lie on curves of the domain, if they do.
  struct Foot {
    std::size_t curve = 0;
    double s = 0.0;
  };
  std::vector<Foot> feet;
};

/// What was wrong with the drawn geometry (repair.h).
enum class Wrong {
  RepeatedPoint,
  NearlyRepeatedPoint,
  NoExtent,
  CurveTwice,
  Spike,
  Gap,
  Crossing,
  Sliver,
  NearlyTouching,
  CutThrough,
  Outside,
  Apart
};

struct Finding {
  Wrong wrong = Wrong::RepeatedPoint;
  dobra::geom::Point at;
  std::string curve;  ///< Or both, "a, b".
  std::string mend;   ///< What was done; "left as it is: ..." with what to do by hand.
};

/// The tip of a crack of which the model holds one lip, on a line of symmetry (half_crack.h).
struct HalfTip {
  std::string name;      ///< "LIP_start" or "LIP_end".
  std::size_t lip = 0;   ///< Curve behind the tip,
  std::size_t line = 0;  ///< and the one ahead.
  dobra::geom::Point at;
  dobra::geom::Vector ahead;
  dobra::fem::fracture::RosetteHalf half = dobra::fem::fracture::RosetteHalf::Left;  ///< Where the material is.
};

/// Where results are read: along a line, or at a point (results.h).
struct Samples {
  std::string name;
  std::vector<dobra::geom::Point> points;  ///< One: a probe.
  std::vector<double> s;                   ///< Distance of each from the start, m.
};

struct Analysis;       // analysis.h
struct Band;           // band.h
struct ViewParams;     // result_picture.h
struct ProblemParams;  // problem.h

struct Model {
  Domain domain;
  dobra::scenario::UnitSystem
      units;  ///< In which pictures, quantities, tables and exchange files are to be; all else is SI.
  std::vector<std::shared_ptr<const Band>> bands;  ///< In the order given.
  std::vector<Constraint> constraints;             ///< What is left of them all.
  std::vector<Zone> zones;
  std::vector<HalfTip> half_tips;
  std::vector<std::shared_ptr<const Meshed>> meshes;  ///< In the order made; each mesh step adds one.
  std::shared_ptr<const MeshWork> work;               ///< If the last mesh step was stopped; none when a mesh is done.
  std::shared_ptr<const ProblemParams> problem;       ///< Materials, supports, loads; none until a step gives them.
  std::vector<std::shared_ptr<const Analysis>> analyses;  ///< In the order made.
  bool short_of_target = false;  ///< An adaptive loop ended above the error asked for; a remark says why,
  std::string why_short = {};    ///< that of the last loop here too, which a loop from its last cycle takes back.
  std::vector<Samples> samples;
  std::vector<std::shared_ptr<const ViewParams>> views;  ///< Pictures of results; one of the default if there are none.
  std::vector<std::string> remarks;
  std::vector<Finding> findings;  ///< What was repaired, and what looks wrong and was left.
};

}  // namespace quebra::core
