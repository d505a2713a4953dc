#pragma once
// How two pieces of the raw outline meet, in Real or in High. What Real finds within the bound of its error is in
// doubt, and the pair is to be asked again in High. A tie in High is a tie at every distance (high.h).

#include <array>

#include "shared/offset/kernel/high.h"

namespace dobra::offset::general {

/// A line, or an arc of at most a right angle, anticlockwise.
template <class T>
struct Shape {
  bool line = true;
  VecOf<T> a, b;     ///< Ends.
  VecOf<T> pole;     ///< Unit direction of a line, centre of an arc.
  T size = 0;        ///< |b - a|.
  double error = 0;  ///< Bound for all its places, across.
  double slide = 0;  ///< Bound for its ends, along; not below `error`.
};

template <class T>
struct Contact {
  enum class Kind : std::uint8_t { Crossing, StartOfFirst, EndOfFirst, StartOfSecond, EndOfSecond };
  Kind kind = Kind::Crossing;
  VecOf<T> at;
  double slide = 0;  ///< Bound of its error along either.
};

template <class T>
class Contacts {
 public:
  /// @param d  distance_as<T>: the radius of arcs.
  Contacts(const Shape<T>& p, const Shape<T>& q, const T& d);
  [[nodiscard]] bool doubtful() const { return doubtful_; }
  /// They lie on one line or circle and touch. Known in High; in Real they are then doubtful.
  [[nodiscard]] bool twins() const { return twins_; }
  [[nodiscard]] const Contact<T>* begin() const { return list_.data(); }
  [[nodiscard]] const Contact<T>* end() const { return list_.data() + count_; }

 private:
  using Kind = typename Contact<T>::Kind;
  void add(const VecOf<T>& at, double slide, Kind kind = Kind::Crossing);
  void coincidence(const VecOf<T>& at, double slide, Kind kind = Kind::Crossing);
  void ends_on(const Shape<T>& holder, const Shape<T>& other, Kind start, Kind end);
  void add_inside(int inside, const VecOf<T>& at, double slide, bool tangent);
  void lines(const Shape<T>& p, const Shape<T>& q);
  void line_and_arc(const Shape<T>& p, const Shape<T>& c);
  void arcs(const Shape<T>& p, const Shape<T>& q);
  [[nodiscard]] int within(const Shape<T>& arc, const VecOf<T>& at, double slide) const;

  T d_;
  bool doubtful_ = false;
  bool twins_ = false;
  std::size_t count_ = 0;
  std::array<Contact<T>, 6> list_;
};

/// Where `tail`, going on, enters what `head` is the boundary of, if both are taken as whole lines and circles.
template <class T>
Contact<T> entry(const Shape<T>& tail, const Shape<T>& head, const T& d);

}  // namespace dobra::offset::general
