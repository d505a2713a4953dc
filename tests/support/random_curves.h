#pragma once
// Seeded polylines of many kinds that make offset curves hard, each with a distance.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>

#include "shared/geom/polyline.h"

namespace dobra::support {

struct RandomCase {
  geom::Polyline base;
  double distance = 1;
  std::string kind;
  bool simple = false;  ///< Closed and without self-crossings: all pieces must be closed.
};

inline constexpr std::uint32_t random_kinds = 17;

namespace detail {

class CurveMaker {
 public:
  explicit CurveMaker(std::uint32_t seed) : seed_(seed), random_(seed) {}

  RandomCase make() {
    using Make = void (CurveMaker::*)();
    static constexpr Make makers[random_kinds] = {&CurveMaker::walk,       &CurveMaker::graph,
                                                  &CurveMaker::star,       &CurveMaker::rectilinear,
                                                  &CurveMaker::backtracks, &CurveMaker::crossing,
                                                  &CurveMaker::collinear,  &CurveMaker::neck,
                                                  &CurveMaker::comb,       &CurveMaker::spiral,
                                                  &CurveMaker::u_turns,    &CurveMaker::duplicates,
                                                  &CurveMaker::extremes,   &CurveMaker::closed_rectilinear,
                                                  &CurveMaker::grid,       &CurveMaker::blob,
                                                  &CurveMaker::tiny_grid};
    count_ = 5 + random_() % 60;
    c_.distance = 0.05 + 0.8 * real();
    (this->*makers[seed_ % random_kinds])();
    return c_;
  }

 private:
  double real() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  double normal() { return std::normal_distribution<double>()(random_); }
  int whole(int from, int to) { return from + static_cast<int>(random_() % static_cast<std::uint32_t>(to - from + 1)); }
  std::vector<geom::Point>& points() { return c_.base.points; }
  void step(double x, double y) { points().push_back(at_ = {at_.x + x, at_.y + y}); }
  double half_steps() { return 0.5 * whole(1, 4); }

  void walk() {
    c_.kind = "random walk";
    for (std::size_t i = 0; i < count_; ++i) step(normal(), normal());
  }
  void graph() {
    c_.kind = "noise graph";
    for (std::size_t i = 0; i < count_; ++i) points().push_back({0.3 * double(i), normal()});
  }
  void star() {
    c_.kind = "noisy star";
    c_.base.closed = c_.simple = true;
    for (std::size_t i = 0; i < count_; ++i) {
      const double a = 2 * std::numbers::pi * double(i) / double(count_);
      const double r = 1.0 + 2.0 * real();
      points().push_back({r * std::cos(a), r * std::sin(a)});
    }
  }
  void rectilinear() {
    c_.kind = "integer rectilinear with repeats and spikes";
    for (std::size_t i = 0; i < count_; ++i) i % 2 == 0 ? step(whole(-3, 3), 0) : step(0, whole(-3, 3));
    c_.distance = half_steps();
  }
  void backtracks() {
    c_.kind = "exact back-tracks and repeats";
    for (std::size_t i = 0; i < count_; ++i) {
      const geom::Point p = at_;
      points().push_back(p);
      if (random_() % 4 == 0) points().push_back(p);
      if (random_() % 4 == 0) {
        step(normal(), normal());
        points().push_back(at_ = p);
      }
      at_ = {p.x + real(), p.y + 0.6 * normal()};
    }
  }
  void crossing() {
    c_.kind = "closed, crossing itself";
    c_.base.closed = true;
    for (std::size_t i = 0; i < count_; ++i) points().push_back({3 * real(), 3 * real()});
  }
  void collinear() {
    c_.kind = "collinear overlaps";
    c_.base.closed = random_() % 2 == 0;
    const int dx = whole(0, 2);
    const int dy = whole(1, 3);
    points().push_back(at_ = {0, 0});
    for (std::size_t i = 0; i < count_ / 2; ++i) {  // to and fro along a lattice line, now and then to the next one
      const int k = whole(-4, 4);
      if (random_() % 3 == 0) step(whole(-2, 2), whole(-2, 2));
      step(k * dx, k * dy);
    }
    c_.distance = random_() % 2 == 0 ? half_steps() : c_.distance;
  }
  void neck() {
    c_.kind = "neck as wide as two distances, or an ulp off";
    c_.base.closed = c_.simple = true;
    c_.distance = random_() % 2 == 0 ? half_steps() : 0.1 + real();
    double half = c_.distance;
    const int off = whole(-1, 1);
    if (off != 0) half = std::nextafter(half, off * 1e9);
    const double r = c_.distance * (2 + 2 * real());
    const double l = c_.distance * whole(1, 6);
    // A dumbbell with its neck along x, turned by quarter turns or by any angle.
    points() = {{-l - 2 * r, -r}, {-l, -r}, {-l, -half}, {l, -half}, {l, -r}, {l + 2 * r, -r},
                {l + 2 * r, r},   {l, r},   {l, half},   {-l, half}, {-l, r}, {-l - 2 * r, r}};
    if (random_() % 2 == 0) turn(random_() % 2 == 0 ? 0.5 * std::numbers::pi : real());
    if (random_() % 2 == 0) std::reverse(points().begin(), points().end());
    if (random_() % 3 == 0) {  // a slit: the neck alone, open
      c_.base = {{points()[2], points()[3], points()[8], points()[9]}, false};
      c_.simple = false;
    }
  }
  void comb() {
    c_.kind = "comb";
    const double gap = 2 * c_.distance * (random_() % 3 == 0 ? 1.0 : 0.5 + real());
    const double high = 4 * c_.distance * real() + 0.1;
    for (std::size_t i = 0; i < count_ / 2; ++i) {
      const double x = gap * double(i);
      const double wide = random_() % 3 == 0 ? 0.5 * gap : 0.5 * gap * real();
      points().push_back({x, 0});
      points().push_back({x, high});
      points().push_back({x + wide, high});
      points().push_back({x + wide, 0});
    }
    if (random_() % 2 == 0) turn(3 * real());
  }
  void spiral() {
    c_.kind = "spiral";
    const double pitch = c_.distance * (0.5 + 2 * real());
    const double turns = 2 * std::numbers::pi * (1 + 4 * real());
    for (std::size_t i = 0; i <= 4 * count_; ++i) {
      const double a = turns * double(i) / double(4 * count_);
      const double r = pitch * (0.5 + a / (2 * std::numbers::pi));
      points().push_back({r * std::cos(a), r * std::sin(a)});
    }
    if (random_() % 2 == 0) std::reverse(points().begin(), points().end());
  }
  void u_turns() {
    c_.kind = "near U-turns";
    const double small = std::pow(10.0, -1 - 12 * real());
    for (std::size_t i = 0; i < count_ / 2; ++i) {
      step(2 * real(), small * normal());
      step(-2 * real(), small * normal());
      if (random_() % 3 == 0) step(normal(), normal());
    }
  }
  void duplicates() {
    c_.kind = "near-duplicate points";
    c_.base.closed = random_() % 2 == 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (c_.base.closed) {
        const double a = 2 * std::numbers::pi * double(i) / double(count_);
        at_ = {2 * std::cos(a) + 0.3 * normal(), 2 * std::sin(a) + 0.3 * normal()};
        points().push_back(at_);
      } else {
        step(normal(), normal());
      }
      while (random_() % 3 == 0) step(1e-12 * normal(), 1e-12 * normal());
    }
  }
  void extremes() {
    c_.kind = "distance huge or small against the spacing";
    const double length = std::pow(10.0, -4 + 8 * real());
    for (std::size_t i = 0; i < count_; ++i) step(length * (0.2 + real()), length * normal());
  }
  void closed_rectilinear() {
    c_.kind = "integer rectilinear, closed";
    c_.base.closed = true;
    int x = 0;
    int y = 0;
    for (std::size_t i = 0; i < count_ / 2 + 2; ++i) {
      x = whole(0, 8);
      points().push_back({double(x), double(y)});
      y = whole(0, 8);
      points().push_back({double(x), double(y)});
    }
    points().push_back({points().front().x, double(y)});
    c_.distance = half_steps();
  }
  void grid() {
    c_.kind = "integer points, any directions";
    c_.base.closed = random_() % 2 == 0;
    for (std::size_t i = 0; i < count_ / 2 + 3; ++i) points().push_back({double(whole(0, 9)), double(whole(0, 9))});
    c_.distance = half_steps();
  }
  void blob() {
    c_.kind = "dense blob";
    c_.base.closed = c_.simple = true;
    const double p = 6 * real();
    const double q = 6 * real();
    for (std::size_t i = 0; i < 6 * count_; ++i) {
      const double a = 2 * std::numbers::pi * double(i) / double(6 * count_);
      const double r = 3 + 1.2 * std::sin(3 * a + p) + 0.6 * std::sin(7 * a + q);
      points().push_back({r * std::cos(a), r * std::sin(a)});
    }
  }
  void tiny_grid() {
    c_.kind = "few places visited many times";
    c_.base.closed = random_() % 2 == 0;
    for (std::size_t i = 0; i < 4 + count_ / 4; ++i) points().push_back({double(whole(0, 3)), double(whole(0, 2))});
    c_.distance = 0.25 * whole(1, 8);
  }
  void turn(double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    for (geom::Point& p : points()) p = {c * p.x - s * p.y, s * p.x + c * p.y};
  }

  std::uint32_t seed_;
  std::mt19937 random_;
  std::size_t count_ = 0;
  geom::Point at_{0, 0};
  RandomCase c_;
};

}  // namespace detail

inline RandomCase random_case(std::uint32_t seed) { return detail::CurveMaker(seed).make(); }

}  // namespace dobra::support
