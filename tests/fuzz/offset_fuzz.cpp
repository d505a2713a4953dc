// libFuzzer target: bytes become a polyline, a distance and options; the offset curves are judged by the verifier.
// Byte 0: how points are made (bits 0-1: whole numbers, 1/8 steps with small drifts, near-duplicates, raw doubles),
// closed (bit 2), side (3), join (4-5), ends (6-7). Byte 1: distance in quarters (bits 0-4), and how many more there
// are (5-7). Byte 2: mitre limit and what lies beyond it. Then a byte for each further distance, in any order: what one
// hides, the greater ones leave out. Then the points. Every curve is judged.
//
// Aborts where the library breaks, and where a curve is malformed, comes too near, or crosses itself. With
// DOBRA_FUZZ_STRICT set, at every finding of the verifier.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "shared/offset/offset.h"
#include "shared/offset/verifier/verify.h"
#include "tests/fuzz/bytes.h"

namespace {

using namespace dobra;
using fuzz::Bytes;

struct Case {
  geom::Polyline base;
  offset::OffsetOptions options;
  std::vector<double> distances;
  bool judged = true;
};

constexpr std::size_t most_points = 48;

double coordinate(Bytes& bytes, int mode) {
  switch (mode) {
    case 0:
      return bytes.whole() % 16;
    case 1:
      return 0.125 * bytes.whole() + 0x1p-50 * (bytes.byte() % 4);
    case 2: {
      const int step = bytes.whole();
      return step / 8 + 1e-12 * (step % 8);
    }
    default:
      return bytes.raw();
  }
}

/// Sixteenths up to four times the first, or the last one by so little that hardly anything changes.
double further_distance(Bytes& bytes, const std::vector<double>& before) {
  const std::uint8_t code = bytes.byte();
  return (code & 192) == 192 ? before.back() * (1 + 0x1p-50 * (code & 63))
                             : before.front() * 0.0625 * (1 + (code & 63));
}

Case case_of(Bytes bytes) {
  Case c;
  const std::uint8_t head = bytes.byte();
  const int mode = head & 3;
  c.base.closed = (head & 4) != 0;
  c.options.side = (head & 8) != 0 ? offset::Side::LeftOfTravel : offset::Side::RightOfTravel;
  c.options.join = static_cast<offset::Join>((head >> 4) & 3);
  c.options.ends = (head >> 6) == 3 ? offset::Ends::Trimmed : static_cast<offset::Ends>(head >> 6);
  const std::uint8_t near = bytes.byte();
  const std::uint8_t limit = bytes.byte();
  c.options.mitre_limit = 1 + 0.25 * (limit & 31);
  if ((limit & 32) != 0) c.options.beyond_limit = offset::BeyondLimit::ChordBevel;
  if ((limit & 192) == 192) c.options.treatment = offset::Treatment::Untreated;
  c.distances = {mode == 3 ? std::abs(bytes.raw()) : 0.25 * (1 + (near & 31))};
  for (int more = (near >> 5) & 3; more > 0; --more) c.distances.push_back(further_distance(bytes, c.distances));
  while (bytes.left() >= 2 && c.base.points.size() < most_points) {
    const double x = coordinate(bytes, mode);
    c.base.points.push_back({x, coordinate(bytes, mode)});
  }
  // Where squares leave the range of doubles nothing is promised but an error or a curve.
  for (const double d : c.distances) {
    for (const geom::Point p : c.base.points) {
      for (const double v : {p.x, p.y})
        c.judged = c.judged && std::abs(v) < 1e6 * d && (v == 0 || std::abs(v) > 1e-6 * d);
    }
    c.judged = c.judged && d > 1e-100 && d < 1e100;
  }
  return c;
}

bool grave(offset::verifier::FindingKind kind) {
  using Kind = offset::verifier::FindingKind;
  return kind == Kind::Malformed || kind == Kind::TooNear || kind == Kind::Crossing;
}

/// What a test of the finding needs.
void print(const Case& c) {
  std::fprintf(stderr, "distances:");
  for (const double d : c.distances) std::fprintf(stderr, " %.17g", d);
  std::fprintf(stderr,
               "\nclosed %d, side %d, join %d, ends %d, treatment %d, mitre limit %g, beyond %d:", int(c.base.closed),
               int(c.options.side), int(c.options.join), int(c.options.ends), int(c.options.treatment),
               c.options.mitre_limit, int(c.options.beyond_limit));
  for (const geom::Point p : c.base.points) std::fprintf(stderr, " {%.17g, %.17g}", p.x, p.y);
  std::fprintf(stderr, "\n");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool strict = std::getenv("DOBRA_FUZZ_STRICT") != nullptr;
  const Case c = case_of({data, size});
  const auto curves = offset::offset(c.base, c.distances, c.options);
  if (!curves.ok() || !c.judged) return 0;
  // Mitres of any length, of turns as near to a U-turn as doubles go, have no digits left to judge.
  if (c.options.join == offset::Join::Bisector && !strict) return 0;
  for (const offset::OffsetCurve& curve : *curves) {
    const auto verified = offset::verifier::verify(c.base, c.options, curve);
    if (!verified.ok()) std::abort();  // what can be offset can be judged
    for (const offset::verifier::Finding& finding : verified->findings) {
      if (!strict && !grave(finding.kind)) continue;
      std::fprintf(stderr, "D %.17g: %s\n", curve.distance, offset::verifier::to_string(finding).c_str());
      print(c);
      std::abort();
    }
  }
  return 0;
}
