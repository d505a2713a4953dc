#include "recon/jigsaw/wall.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace recon::jigsaw {

namespace {

/// x of a branch at two heights that no vertex lies between.
std::pair<double, double> across(const std::vector<geom::Point>& points, double low, double high, std::size_t& hint) {
  while (hint + 2 < points.size() && points[hint + 1].y <= low) ++hint;
  const geom::Point a = points[hint];
  const geom::Point b = points[hint + 1];
  const double rise = b.y - a.y;
  const auto at = [&](double z) {
    if (z == a.y) return a.x;
    if (z == b.y) return b.x;
    return rise > 0.0 ? a.x + (b.x - a.x) * ((z - a.y) / rise) : b.x;
  };
  return {at(low), at(high)};
}

/// Of one straight piece: the areas on both sides of 0, and where the width is greatest.
void add_width(double low, double high, double at_low, double at_high, geom::Point place_low, geom::Point place_high,
               Opening& opening) {
  const double height = high - low;
  const auto add = [&](double area) { (area > 0.0 ? opening.gap : opening.overlap) += std::abs(area); };
  if (at_low * at_high < 0.0) {
    const double zero = at_low / (at_low - at_high);
    add(0.5 * at_low * zero * height);
    add(0.5 * at_high * (1.0 - zero) * height);
  } else {
    add(0.5 * (at_low + at_high) * height);
  }
  for (const auto& [width, place] : {std::pair(at_low, place_low), {at_high, place_high}}) {
    if (width > opening.widest_gap) {
      opening.widest_gap = width;
      opening.gap_at = place;
    } else if (-width > opening.widest_overlap) {
      opening.widest_overlap = -width;
      opening.overlap_at = place;
    }
  }
}

}  // namespace

std::vector<Branch> branches_of(const geom::Polyline& line, double rounding) {
  std::vector<Branch> branches;
  Branch now;
  bool known = false;
  for (const geom::Point p : line.points) {
    if (now.points.empty()) {
      now.points.push_back(p);
      continue;
    }
    const double last = now.points.back().y;
    const double rise = p.y - last;
    if (!known && std::abs(rise) > rounding) {
      known = true;
      now.climbs = rise > 0.0;
    }
    if (known && std::abs(rise) > rounding && (rise > 0.0) != now.climbs) {
      const geom::Point turn = now.points.back();
      branches.push_back(std::move(now));
      now = Branch{rise > 0.0, {turn}};
    }
    const double z = !known ? last : now.climbs ? std::max(p.y, last) : std::min(p.y, last);
    now.points.push_back({p.x, z});
  }
  branches.push_back(std::move(now));
  for (Branch& branch : branches) {
    if (!branch.climbs) std::reverse(branch.points.begin(), branch.points.end());
  }
  return branches;
}

Branch clipped(const Branch& branch, double low, double high) {
  Branch made{branch.climbs, {}};
  for (std::size_t i = 0; i < branch.points.size(); ++i) {
    const geom::Point p = branch.points[i];
    if (i > 0) {
      const geom::Point before = branch.points[i - 1];
      for (const double z : {low, high}) {
        if (before.y < z && z < p.y)
          made.points.push_back({before.x + (p.x - before.x) * ((z - before.y) / (p.y - before.y)), z});
      }
    }
    if (p.y >= low && p.y <= high) made.points.push_back(p);
  }
  return made;
}

double WallPair::height() const {
  double height = 0.0;
  for (const WallPiece& piece : pieces) height += piece.high - piece.low;
  return height;
}

Distance distance_of(const WallPair& pair, const Trust& trust) {
  const auto weight = [&](double z) { return std::pow(1.0 + std::pow(trust.lean * (z - trust.datum), 2), -2); };
  Distance sum;
  for (const WallPiece& p : pair.pieces) {
    const double low = p.right_low - p.left_low, high = p.right_high - p.left_high;
    // Simpson's rule on steps over which the trust hardly changes.
    const double steps = std::clamp(std::ceil(8.0 * trust.lean * (p.high - p.low)), 1.0, 1000.0);
    const double step = (p.high - p.low) / steps;
    for (double k = 0.0; k < steps; k += 1.0) {
      for (const auto& [part, share] : {std::pair(k, 1.0 / 6.0), {k + 0.5, 4.0 / 6.0}, {k + 1.0, 1.0 / 6.0}}) {
        const double w = share * step * weight(p.low + part * step);
        sum.height += w;
        const double apart = low + (high - low) * (part / steps);
        sum.moment += w * apart;
        sum.squared += w * apart * apart;
      }
    }
  }
  return sum;
}

Distance& Distance::operator+=(const Distance& more) {
  height += more.height;
  moment += more.moment;
  squared += more.squared;
  return *this;
}

WallPair pair_of(const Branch& left, const Branch& right) {
  WallPair pair;
  pair.sign = left.climbs ? 1.0 : -1.0;
  if (left.points.size() < 2 || right.points.size() < 2) return pair;
  const double low = std::max(left.points.front().y, right.points.front().y);
  const double high = std::min(left.points.back().y, right.points.back().y);
  if (low >= high) return pair;
  std::vector<double> heights{low, high};
  for (const Branch* branch : {&left, &right}) {
    for (const geom::Point p : branch->points) {
      if (p.y > low && p.y < high) heights.push_back(p.y);
    }
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  std::size_t at_left = 0, at_right = 0;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    WallPiece piece{heights[i], heights[i + 1]};
    std::tie(piece.left_low, piece.left_high) = across(left.points, piece.low, piece.high, at_left);
    std::tie(piece.right_low, piece.right_high) = across(right.points, piece.low, piece.high, at_right);
    pair.pieces.push_back(piece);
  }
  return pair;
}

Opening& Opening::operator+=(const Opening& more) {
  gap += more.gap;
  overlap += more.overlap;
  if (more.widest_gap > widest_gap) {
    widest_gap = more.widest_gap;
    gap_at = more.gap_at;
  }
  if (more.widest_overlap > widest_overlap) {
    widest_overlap = more.widest_overlap;
    overlap_at = more.overlap_at;
  }
  return *this;
}

Opening opening_of(const WallPair& pair) {
  Opening opening;
  for (const WallPiece& p : pair.pieces) {
    add_width(p.low, p.high, pair.sign * (p.right_low - p.left_low), pair.sign * (p.right_high - p.left_high),
              {0.5 * (p.left_low + p.right_low), p.low}, {0.5 * (p.left_high + p.right_high), p.high}, opening);
  }
  return opening;
}

std::vector<geom::Point> mean_of(const WallPair& pair) {
  std::vector<geom::Point> points;
  for (const WallPiece& p : pair.pieces) {
    for (const geom::Point next : {geom::Point{0.5 * (p.left_low + p.right_low), p.low},
                                   geom::Point{0.5 * (p.left_high + p.right_high), p.high}}) {
      if (points.empty() || !(points.back() == next)) points.push_back(next);
    }
  }
  return points;
}

}  // namespace recon::jigsaw
