#include "quebra/surfaces/trim_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

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
      TrimRing ring{trim_.role, trim_.name, pieces_[i], {i}};
      int tries = most_tries;
      if (!closes(ring, tries)) {
        while (!comes_back(ring.places) && goes_on(ring)) {
        }
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

  /// The piece in the sense in which it goes on from a place, moved there; none where it does not.
  [[nodiscard]] std::optional<std::vector<Point>> from(Point at, std::size_t number) const {
    std::vector<Point> piece = pieces_[number];
    if (meet(at, piece.back()) && !meet(at, piece.front())) std::reverse(piece.begin(), piece.end());
    if (!meet(at, piece.front())) return std::nullopt;
    const Vector by = at - piece.front();
    for (Point& p : piece) p = p + by;
    return piece;
  }

  /// Adds pieces until the way is a ring that does not go round the surface. Where curves cross in a touching several
  /// go on, and each is tried.
  bool closes(TrimRing& ring, int& tries) {
    std::vector<Point>& way = ring.places;
    if (comes_back(way)) return distance(way.front(), way.back()) <= near_;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (used_[i] != 0) continue;
      const auto piece = from(way.back(), i);
      if (!piece) continue;
      if (--tries < 0) return false;
      const std::size_t before = way.size();
      way.insert(way.end(), piece->begin(), piece->end());
      ring.lines.push_back(i);
      used_[i] = 1;
      if (closes(ring, tries)) return true;
      ring.lines.pop_back();
      way.resize(before);
      used_[i] = 0;
    }
    return false;
  }

  /// Adds a piece that goes on from the end of the way, or from its beginning.
  bool goes_on(TrimRing& ring) {
    std::vector<Point>& way = ring.places;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (used_[i] != 0) continue;
      if (const auto after = from(way.back(), i)) {
        way.insert(way.end(), after->begin(), after->end());
      } else if (const auto before = from(way.front(), i)) {
        way.insert(way.begin(), before->rbegin(), before->rend());
      } else {
        continue;
      }
      ring.lines.push_back(i);
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
  static constexpr int most_tries = 1000;
};

}  // namespace

Result<std::vector<TrimRing>> rings_of_cut(const surf::Surface& surface, const TrimParams& trim,
                                           std::span<const std::vector<Point>> pieces) {
  return RingMaker(surface, trim, pieces).run();
}

}  // namespace quebra::surfaces
