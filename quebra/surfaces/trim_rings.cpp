#include "quebra/surfaces/trim_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/surf/trim/finding.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Vector;

namespace {

class RingMaker {
 public:
  RingMaker(const surf::Surface& surface, const TrimParams& trim, std::span<const std::vector<Point>> pieces)
      : surface_(surface), trim_(trim), pieces_(pieces), used_(pieces.size(), 0) {
    const geom::Box& box = surface.chart();
    near_ = 1e-7 * std::max(box.width(), box.height());
  }

  Result<std::vector<TrimRing>> run() {
    std::vector<TrimRing> rings;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (used_[i] != 0) continue;
      used_[i] = 1;
      TrimRing ring{trim_.role, trim_.name, pieces_[i]};
      while (!comes_back(ring.places) && goes_on(ring.places)) {
      }
      DOBRA_TRY_VOID(has_inside(ring.places));
      rings.push_back(std::move(ring));
    }
    return rings;
  }

 private:
  /// From `to` to `from`, whole periods of the surface taken off.
  [[nodiscard]] Vector less_periods(Vector way) const {
    const geom::Box& box = surface_.chart();
    if (surface_.closed_u()) way.x -= box.width() * std::round(way.x / box.width());
    if (surface_.closed_v()) way.y -= box.height() * std::round(way.y / box.height());
    return way;
  }
  [[nodiscard]] bool meet(Point a, Point b) const { return length(less_periods(b - a)) <= near_; }
  [[nodiscard]] bool comes_back(const std::vector<Point>& way) const { return meet(way.back(), way.front()); }

  /// Adds a piece that has an end where the way ends or begins, in either sense.
  bool goes_on(std::vector<Point>& way) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (used_[i] != 0) continue;
      std::vector<Point> piece = pieces_[i];
      if (meet(way.back(), piece.back()) || meet(way.front(), piece.front())) std::reverse(piece.begin(), piece.end());
      const bool after = meet(way.back(), piece.front());
      if (!after && !meet(piece.back(), way.front())) continue;
      const Vector by = after ? way.back() - piece.front() : way.front() - piece.back();
      for (Point& p : piece) p = p + by;
      way.insert(after ? way.end() : way.begin(), piece.begin(), piece.end());
      used_[i] = 1;
      return true;
    }
    return false;
  }

  [[nodiscard]] Result<void> has_inside(const std::vector<Point>& way) const {
    const Point first = way.front(), last = way.back();
    if (comes_back(way)) {
      if (distance(first, last) <= near_) return {};
      return refused(true, first);
    }
    const geom::Box& box = surface_.chart();
    const auto both_at = [&](double a, double b, double side) {
      return std::abs(a - side) <= near_ && std::abs(b - side) <= near_;
    };
    for (const double side : {box.low.x, box.high.x}) {
      if (!surface_.closed_u() && both_at(first.x, last.x, side)) return {};
    }
    for (const double side : {box.low.y, box.high.y}) {
      if (!surface_.closed_v() && both_at(first.y, last.y, side)) return {};
    }
    return refused(false, first);
  }
  [[nodiscard]] Error refused(bool round, Point uv) const {
    const char* const role = trim_.role == TrimRole::Hole ? "hole" : "outline";
    return {ErrorCode::BadDomain,
            round
                ? fmt::format("a line of role `{}` that goes round the surface does not say which side of it is meant: "
                              "give it role = \"cut\", and name a place that stays by an [[input.part]]",
                              role)
                : fmt::format("a line of role `{}` that goes from border to border does not say which side of it is "
                              "meant: give it role = \"cut\", and name a place that stays by an [[input.part]]",
                              role),
            surf::trim::place_of(surface_, uv)};
  }

  const surf::Surface& surface_;
  const TrimParams& trim_;
  std::span<const std::vector<Point>> pieces_;
  std::vector<std::uint8_t> used_;
  double near_ = 0.0;
};

}  // namespace

Result<std::vector<TrimRing>> rings_of_cut(const surf::Surface& surface, const TrimParams& trim,
                                           std::span<const std::vector<Point>> pieces) {
  return RingMaker(surface, trim, pieces).run();
}

}  // namespace quebra::surfaces
