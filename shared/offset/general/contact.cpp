#include "shared/offset/general/contact.h"

#include <algorithm>
#include <type_traits>

namespace dobra::offset::general {

namespace {

/// -1, 1, or 0 where the error hides the sign.
template <class T>
int sign(const T& x, double error) {
  return x > error ? 1 : x < -error ? -1 : 0;
}

template <class T>
double narrow(const T& x) {
  return static_cast<double>(x);
}

/// Half the chord of a circle of radius d at `away` from its centre.
template <class T>
T half_chord(const T& d, const T& away) {
  return away < d ? root(T((d - away) * (d + away))) : T(0);
}

}  // namespace

template <class T>
Contacts<T>::Contacts(const Shape<T>& p, const Shape<T>& q, const T& d) : d_(d) {
  ends_on(p, q, Kind::StartOfSecond, Kind::EndOfSecond);
  ends_on(q, p, Kind::StartOfFirst, Kind::EndOfFirst);
  if (doubtful_) return;
  if (p.line && q.line) {
    lines(p, q);
  } else if (p.line || q.line) {
    line_and_arc(p.line ? p : q, p.line ? q : p);
  } else {
    arcs(p, q);
  }
}

template <class T>
void Contacts<T>::add(const VecOf<T>& at, double slide, Kind kind) {
  if (count_ < list_.size()) list_[count_++] = {kind, at, slide};
}

/// The same for every distance, or in doubt.
template <class T>
void Contacts<T>::coincidence(const VecOf<T>& at, double slide, Kind kind) {
  if constexpr (std::is_same_v<T, High>) {
    add(at, slide, kind);
  } else {
    doubtful_ = true;
  }
}

/// 1 if a place on its circle is on the arc, 0 if it is near an end.
template <class T>
int Contacts<T>::within(const Shape<T>& arc, const VecOf<T>& at, double slide) const {
  const VecOf<T> out = at - arc.pole;
  const double slack = (slide + arc.slide) * narrow(d_);
  return std::min(sign(cross(arc.a - arc.pole, out), slack), sign(cross(out, arc.b - arc.pole), slack));
}

template <class T>
void Contacts<T>::ends_on(const Shape<T>& holder, const Shape<T>& other, Kind start, Kind end) {
  const double error = holder.error + other.slide;
  const auto look = [&](const VecOf<T>& e, Kind kind) {
    if (holder.line) {
      const VecOf<T> to = e - holder.a;
      if (sign(cross(holder.pole, to), error) != 0) return;
      const T t = dot(to, holder.pole);
      const double slide = holder.slide + other.slide;
      if (t < -slide || t - holder.size > slide) return;
    } else {
      const VecOf<T> out = e - holder.pole;
      const double slack = error * (2 * narrow(d_) + error);
      if (sign(T(dot(out, out) - d_ * d_), slack) != 0 || within(holder, e, other.slide) < 0) return;
    }
    coincidence(e, error, kind);
  };
  look(other.a, start);
  look(other.b, end);
}

template <class T>
void Contacts<T>::lines(const Shape<T>& p, const Shape<T>& q) {
  const double error_p = p.error + q.slide;
  const double error_q = q.error + p.slide;
  const T qa = cross(p.pole, q.a - p.a);
  const T qb = cross(p.pole, q.b - p.a);
  const int sides_q = sign(qa, error_p) * sign(qb, error_p);
  if (sides_q > 0) return;
  const T pa = cross(q.pole, p.a - q.a);
  const T pb = cross(q.pole, p.b - q.a);
  const int sides_p = sign(pa, error_q) * sign(pb, error_q);
  if (sides_p > 0) return;
  const double sine = std::abs(narrow(cross(p.pole, q.pole)));
  if (sides_p * sides_q > 0) {
    return add(p.a + T(pa / (pa - pb)) * (p.b - p.a), (p.error + q.error) / sine);
  }
  twins_ = count_ > 0 && sine < 0x1p-200;
  // An end on the line of the other. What is beyond the other's ends is out of reach; what is not was found before.
  if constexpr (!std::is_same_v<T, High>) {
    const auto apart = [](const Shape<T>& s, const Shape<T>& t) {
      const T a = dot(t.a - s.a, s.pole);
      const T b = dot(t.b - s.a, s.pole);
      const double slide = s.slide + t.slide;
      return std::max(a, b) < -slide || std::min(a, b) - s.size > slide;
    };
    doubtful_ = !apart(p, q) && !apart(q, p);
  }
}

/// A place on both whole lines or circles that is inside both pieces (1), near an end (0), or outside.
template <class T>
void Contacts<T>::add_inside(int inside, const VecOf<T>& at, double slide, bool tangent) {
  if (inside < 0) return;
  if (tangent) return coincidence(at, slide);
  if (inside > 0) return add(at, slide);
  doubtful_ = doubtful_ || !std::is_same_v<T, High>;  // in High what is at an end was found before
}

template <class T>
void Contacts<T>::line_and_arc(const Shape<T>& p, const Shape<T>& c) {
  using std::abs;
  const double error = p.error + c.error;
  const VecOf<T> to = c.pole - p.a;
  const T foot = dot(to, p.pole);
  const T across = abs(cross(p.pole, to));
  const int secant = sign(T(d_ - across), error);
  if (secant < 0) return;
  const auto look = [&](const T& t, double slide, bool tangent) {
    const int in_line = std::min(sign(t, slide + p.slide), sign(T(p.size - t), slide + p.slide));
    if (in_line < 0) return;
    const VecOf<T> at = p.a + t * p.pole;
    add_inside(std::min(in_line, within(c, at, slide)), at, slide, tangent);
  };
  const double d = narrow(d_);
  if (secant == 0) return look(foot, std::is_same_v<T, High> ? error : 2 * std::sqrt(error * d), true);
  const T half = half_chord(d_, across);
  const double slide = error * (1 + d / narrow(half));
  look(foot - half, slide, false);
  look(foot + half, slide, false);
}

template <class T>
void Contacts<T>::arcs(const Shape<T>& p, const Shape<T>& q) {
  if (p.pole.x == q.pole.x && p.pole.y == q.pole.y) {  // their ends tell
    twins_ = count_ > 0;
    return;
  }
  const double error = p.error + q.error;
  const VecOf<T> between = q.pole - p.pole;
  const T half = root(dot(between, between)) / 2;
  const int secant = sign(T(d_ - half), error);
  if (secant < 0) return;
  const VecOf<T> middle = p.pole + T(0.5) * between;
  const auto look = [&](const VecOf<T>& at, double slide, bool tangent) {
    add_inside(std::min(within(p, at, slide), within(q, at, slide)), at, slide, tangent);
  };
  const double d = narrow(d_);
  if (secant == 0) return look(middle, std::is_same_v<T, High> ? error : 2 * std::sqrt(error * d), true);
  const T chord = half_chord(d_, half);
  const VecOf<T> across = T(chord / (2 * half)) * left_of(between);
  const double slide = error * (1 + d / narrow(chord));
  look(middle + across, slide, false);
  look(middle - across, slide, false);
}

template <class T>
Contact<T> entry(const Shape<T>& tail, const Shape<T>& head, const T& d) {
  using std::abs;
  const double error = tail.error + head.error;
  Contact<T> found;
  const auto chord_slide = [&](const T& half) { return error * (1 + narrow(d) / narrow(half)); };
  if (tail.line && head.line) {
    const T sine = cross(tail.pole, head.pole);
    found.at = tail.a + T(cross(head.a - tail.a, head.pole) / sine) * tail.pole;
    found.slide = error * (1 + 1 / std::abs(narrow(sine)));
  } else if (tail.line || head.line) {
    const Shape<T>& line = tail.line ? tail : head;
    const VecOf<T> to = (tail.line ? head : tail).pole - line.a;
    const T across = cross(line.pole, to);
    const T half = half_chord(d, T(abs(across)));
    found.at = line.a + T(tail.line ? dot(line.pole, to) - half : dot(line.pole, to) + half) * line.pole;
    found.slide = chord_slide(half);
  } else {
    const VecOf<T> to = head.pole - tail.pole;
    const T gap = root(dot(to, to));
    const T chord = half_chord(d, T(gap / 2));
    found.at = tail.pole + T(0.5) * to + T(chord / gap) * right_of(to);
    found.slide = chord_slide(chord);
  }
  return found;
}

template class Contacts<Real>;
template class Contacts<High>;
template Contact<Real> entry<Real>(const Shape<Real>&, const Shape<Real>&, const Real&);
template Contact<High> entry<High>(const Shape<High>&, const Shape<High>&, const High&);

}  // namespace dobra::offset::general
