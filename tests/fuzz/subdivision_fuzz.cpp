// libFuzzer target: bytes become points, curves and removals; after every one the oracle looks at the subdivision.
// Byte 0: how coordinates are made (whole numbers; thirds and their neighbours in doubles; hair's breadths; raw
// doubles). Then operations: a byte says what (curve of 2 to 5 points, closed or not; point; removal) and the bytes
// after it where.
//
// Aborts where the subdivision is unsound, where the path of a curve does not lead from its start to its end, and where
// a curve is refused without a reason.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "shared/topo/insert.h"
#include "shared/topo/validate.h"
#include "tests/fuzz/bytes.h"

namespace {

using namespace dobra;
using fuzz::Bytes;
using geom::Point;

constexpr int most_operations = 40;

double coordinate(Bytes& bytes, int mode) {
  if (mode == 3) return bytes.raw();
  const int step = bytes.whole();
  switch (mode) {
    case 0:
      return step % 8;
    case 1: {
      double x = (step / 8) / 3.0;
      for (int i = step & 3; i > 0; --i) x = std::nextafter(x, 32.0);
      return x;
    }
    default:
      return step / 16 + 1e-16 * (step % 16);
  }
}

Point point(Bytes& bytes, int mode) {
  const double x = coordinate(bytes, mode);
  return {x, coordinate(bytes, mode)};
}

[[noreturn]] void broken(const char* what) {
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

void insert_curve(topo::Subdivision& s, Bytes& bytes, int mode, int operation) {
  geom::Polyline curve;
  curve.closed = (operation & 8) != 0;
  for (int i = 0; i < 2 + ((operation >> 4) & 3); ++i) curve.points.push_back(point(bytes, mode));
  const auto in = topo::insert(s, curve);
  if (!in.ok()) {
    if (in.error().message.empty()) broken("refused without a reason");
    return;
  }
  if (in->path.empty() || s.point(s.origin(in->path.front())) != curve.points.front())
    broken("the path starts elsewhere");
  if (s.point(s.target(in->path.back())) != (curve.closed ? curve.points.front() : curve.points.back()))
    broken("the path ends elsewhere");
  for (std::size_t i = 1; i < in->path.size(); ++i) {
    if (s.origin(in->path[i]) != s.target(in->path[i - 1])) broken("the path has a gap");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const int mode = bytes.byte() & 3;
  topo::Subdivision s;
  for (int i = 0; i < most_operations && bytes.left() > 0; ++i) {
    const int operation = bytes.byte();
    if ((operation & 7) == 0) {
      (void)topo::insert(s, point(bytes, mode)).ok();
    } else if ((operation & 7) < 3) {
      const auto edges = s.edges();
      if (edges.empty()) continue;
      const auto removed = topo::remove(s, edges[bytes.byte() % edges.size()],
                                        (operation & 8) != 0 ? topo::Bare::Keep : topo::Bare::Remove);
      if (!removed.ok()) broken("an edge that is there cannot be removed");
    } else {
      insert_curve(s, bytes, mode, operation);
    }
    for (const std::string& wrong : topo::violations(s)) broken(wrong.c_str());
  }
  return 0;
}
