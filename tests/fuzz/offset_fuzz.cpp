// libFuzzer target: bytes become a polyline, a distance and options; the offset curves are judged by the verifier.
// Byte 0: how points are made (bits 0-1: whole numbers, 1/8 steps with small drifts, near-duplicates, raw doubles), closed
// (bit 2), side (3), join (4-5), ends (6-7). Byte 1: distance in quarters. Byte 2: mitre limit and what lies beyond it.
//
// Aborts where the library breaks, and where a curve is malformed, comes too near, or crosses itself. With DOBRA_FUZZ_STRICT set,
// at every finding of the verifier.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "shared/offset/verify.h"
#include "tests/fuzz/bytes.h"

namespace {

using namespace dobra;
using fuzz::Bytes;

struct Case {
  geom::Polyline base;
  offset::OffsetOptions options;
  double distance = 1;
  bool judged = true;
};

constexpr std::size_t most_points = 48;

double coordinate(Bytes& bytes, int mode) {
  switch (mode) {
    case 0: return bytes.whole() % 16;
    case 1: return 0.125 * bytes.whole() + 0x1p-50 * (bytes.byte() % 4);
    case 2: {
      const int step = bytes.whole();
      return step / 8 + 1e-12 * (step % 8);
    }
    default: return bytes.raw();
  }
}

Case case_of(Bytes bytes) {
  Case c;
  const std::uint8_t head = bytes.byte();
  const int mode = head & 3;
  c.base.closed = (head & 4) != 0;
  c.options.side = (head & 8) != 0 ? offset::Side::LeftOfTravel : offset::Side::RightOfTravel;
  c.options.join = static_cast<offset::Join>((head >> 4) & 3);
  c.options.ends = (head >> 6) == 3 ? offset::Ends::Trimmed : static_cast<offset::Ends>(head >> 6);
  c.distance = 0.25 * (1 + bytes.byte() % 32);
  const std::uint8_t limit = bytes.byte();
  c.options.mitre_limit = 1 + 0.25 * (limit & 31);
  if ((limit & 32) != 0) c.options.beyond_limit = offset::BeyondLimit::ChordBevel;
  if ((limit & 192) == 192) c.options.treatment = offset::Treatment::Untreated;
  if (mode == 3) c.distance = std::abs(bytes.raw());
  while (bytes.left() >= 2 && c.base.points.size() < most_points) {
    const double x = coordinate(bytes, mode);
    c.base.points.push_back({x, coordinate(bytes, mode)});
  }
  // Where squares leave the range of doubles nothing is promised but an error or a curve.
  for (const geom::Point p : c.base.points) {
    for (const double v : {p.x, p.y}) c.judged = c.judged && std::abs(v) < 1e6 * c.distance && (v == 0 || std::abs(v) > 1e-6 * c.distance);
  }
  c.judged = c.judged && c.distance > 1e-100 && c.distance < 1e100;
  return c;
}

bool grave(offset::FindingKind kind) {
  using Kind = offset::FindingKind;
  return kind == Kind::Malformed || kind == Kind::TooNear || kind == Kind::Crossing;
}

/// What a test of the finding needs.
void print(const Case& c) {
  std::fprintf(stderr, "closed %d, D %.17g, side %d, join %d, ends %d, treatment %d, mitre limit %g, beyond %d:", int(c.base.closed), c.distance,
               int(c.options.side), int(c.options.join), int(c.options.ends), int(c.options.treatment), c.options.mitre_limit, int(c.options.beyond_limit));
  for (const geom::Point p : c.base.points) std::fprintf(stderr, " {%.17g, %.17g}", p.x, p.y);
  std::fprintf(stderr, "\n");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool strict = std::getenv("DOBRA_FUZZ_STRICT") != nullptr;
  const Case c = case_of({data, size});
  const double distances[] = {c.distance};
  const auto curves = offset::offset(c.base, distances, c.options);
  if (!curves.ok() || !c.judged) return 0;
  // Mitres of any length, of turns as near to a U-turn as doubles go, have no digits left to judge.
  if (c.options.join == offset::Join::Bisector && !strict) return 0;
  const auto verified = offset::verify(c.base, c.options, curves->front());
  if (!verified.ok()) std::abort();  // what can be offset can be judged
  for (const offset::Finding& finding : verified->findings) {
    if (!strict && !grave(finding.kind)) continue;
    std::fprintf(stderr, "%s\n", offset::to_string(finding).c_str());
    print(c);
    std::abort();
  }
  return 0;
}
