#include "shared/io/faces/checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "shared/geom/predicates.h"

namespace dobra::io::faces {

using geom::Box;
using geom::Point;
using geom::Sign;

Apart apart(const surf::Surface& surface, const Piece& piece) {
  Apart most;
  constexpr int places = 32;
  for (int i = 0; i <= places; ++i) {
    const double part = static_cast<double>(i) / places;
    const Point uv = piece.at(std::lerp(piece.from, piece.to, part));
    const double t = std::lerp(piece.space_from, piece.space_to, piece.against ? 1.0 - part : part);
    const double by = distance(surface.at(uv), piece.space->at(t));
    if (by > most.distance) most = {by, uv};
  }
  return most;
}

namespace {

/// A chord of a piece.
struct Chord {
  const Piece* piece = nullptr;
  double from = 0.0, to = 0.0;
  Point a{}, b{};
  [[nodiscard]] Box box() const {
    Box box;
    box.add(a);
    box.add(b);
    return box;
  }
};

bool cross_each_other(const Chord& p, const Chord& q) {
  if (p.a == q.a || p.a == q.b || p.b == q.a || p.b == q.b) return false;
  if (!p.box().overlaps(q.box())) return false;
  return geom::orient2d(p.a, p.b, q.a) * geom::orient2d(p.a, p.b, q.b) == Sign::Negative &&
         geom::orient2d(q.a, q.b, p.a) * geom::orient2d(q.a, q.b, p.b) == Sign::Negative;
}

std::array<Chord, 2> halves(const Chord& chord) {
  const double middle = std::midpoint(chord.from, chord.to);
  const Point at = chord.piece->at(middle);
  return {Chord{chord.piece, chord.from, middle, chord.a, at}, Chord{chord.piece, middle, chord.to, at, chord.b}};
}

/// A crossing of chords is one of the curves if it stays while they are halved.
std::optional<Point> followed(const Chord& p, const Chord& q, double enough, int depth) {
  if (!cross_each_other(p, q)) return std::nullopt;
  const bool small = distance(p.a, p.b) <= enough && distance(q.a, q.b) <= enough;
  if (small || depth > 40) return geom::midpoint(p.a, p.b);
  for (const Chord& half : halves(p)) {
    for (const Chord& other : halves(q)) {
      if (const auto at = followed(half, other, enough, depth + 1)) return at;
    }
  }
  return std::nullopt;
}

void add_chords(const Piece& piece, double from, double to, double off, int depth, std::vector<Chord>& chords) {
  const Point a = piece.at(from), b = piece.at(to);
  const double step = to - from;
  if (depth < 8 && piece.curve.bend(std::min(from, to), std::max(from, to)) * step * step / 8.0 > off) {
    const double middle = std::midpoint(from, to);
    add_chords(piece, from, middle, off, depth + 1, chords);
    add_chords(piece, middle, to, off, depth + 1, chords);
  } else if (a != b) {
    chords.push_back({&piece, from, to, a, b});
  }
}

}  // namespace

std::optional<Crossing> crossing_of(const surf::Surface& surface, const std::vector<Loop>& loops, double close) {
  const Box& chart = surface.chart();
  const double off = 1e-5 * std::min(chart.width(), chart.height());
  const double enough = 1e-9 * std::min(chart.width(), chart.height());
  std::vector<Chord> chords;
  for (const Loop& loop : loops) {
    for (const Piece& piece : loop) {
      const std::vector<double> along = parameters_along(piece, 4);
      for (std::size_t i = 1; i < along.size(); ++i) add_chords(piece, along[i - 1], along[i], off, 0, chords);
    }
  }
  std::sort(chords.begin(), chords.end(), [](const Chord& p, const Chord& q) { return p.box().low.x < q.box().low.x; });
  std::optional<Crossing> found;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const double low = chords[i].box().low.x;
    std::erase_if(open, [&](std::size_t j) { return chords[j].box().high.x < low; });
    for (const std::size_t j : open) {
      const auto at = followed(chords[j], chords[i], enough, 0);
      if (!at) continue;
      const geom::Point3 there = surface.at(*at);
      bool at_end = false;
      for (const Piece* piece : {chords[j].piece, chords[i].piece}) {
        for (const Point end : {piece->begin_at(), piece->end_at()})
          at_end = at_end || distance(surface.at(end), there) <= close;
      }
      if (!found || !at_end) found = Crossing{chords[j].piece->name, chords[i].piece->name, *at, at_end};
      if (!at_end) return found;
    }
    open.push_back(i);
  }
  return found;
}

}  // namespace dobra::io::faces
