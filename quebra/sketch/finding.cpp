#include "quebra/sketch/finding.h"

namespace quebra::sketch {

const char* name_of(Wrong wrong) {
  switch (wrong) {
    case Wrong::RepeatedPoint:
      return "repeated point";
    case Wrong::NearlyRepeatedPoint:
      return "nearly repeated point";
    case Wrong::NoExtent:
      return "curve without extent";
    case Wrong::CurveTwice:
      return "curve drawn twice";
    case Wrong::Spike:
      return "spike";
    case Wrong::Gap:
      return "gap";
    case Wrong::Crossing:
      return "crossing";
    case Wrong::Sliver:
      return "sliver";
    case Wrong::NearlyTouching:
      return "crack nearly touching";
    case Wrong::CutThrough:
      return "material cut through";
    case Wrong::Outside:
      return "line outside";
    case Wrong::Apart:
      return "loop outside";
  }
  return "";
}

double gap_limit(const RepairOptions& options, double size) {
  return options.gap.value_or(RepairOptions::gap_fraction * size);
}

}  // namespace quebra::sketch
