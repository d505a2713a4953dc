#include "shared/base/formula_jet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "shared/base/formula_steps.h"

namespace dobra::base {
namespace formula_jets {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

// ---- Ranges

constexpr Range everything{-inf, inf};
constexpr bool is_nought(Range a) { return a.low == 0.0 && a.high == 0.0; }
constexpr bool is_nought(double a) { return a == 0.0; }
/// Not a number is no bound.
Range tidy(double low, double high) { return {low == low ? low : -inf, high == high ? high : inf}; }
Range hull(Range a, Range b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }
Range within(Range a, double low, double high) { return {std::clamp(a.low, low, high), std::clamp(a.high, low, high)}; }

Range operator+(Range a, Range b) { return tidy(a.low + b.low, a.high + b.high); }
Range operator-(Range a, Range b) { return tidy(a.low - b.high, a.high - b.low); }
Range operator-(Range a) { return {-a.high, -a.low}; }
Range operator*(Range a, Range b) {
  if (is_nought(a) || is_nought(b)) return {};
  const auto times = [](double p, double q) { return p == 0.0 || q == 0.0 ? 0.0 : p * q; };
  const double p = times(a.low, b.low), q = times(a.low, b.high), r = times(a.high, b.low), s = times(a.high, b.high);
  return {std::min({p, q, r, s}), std::max({p, q, r, s})};
}
Range operator*(double a, Range b) { return Range{a, a} * b; }
Range square(Range a) {
  const double p = a.low * a.low, q = a.high * a.high;
  return {a.low <= 0.0 && a.high >= 0.0 ? 0.0 : std::min(p, q), std::max(p, q)};
}
double square(double a) { return a * a; }

/// Of a function that rises.
template <class Function>
Range rising(Range a, Function f) {
  return tidy(f(a.low), f(a.high));
}
template <class Function>
Range falling(Range a, Function f) {
  return tidy(f(a.high), f(a.low));
}
/// Of a function that falls on both sides of nought, and is even.
template <class Function>
Range peaked(Range a, Function f) {
  const double near = a.low <= 0.0 && a.high >= 0.0 ? 0.0 : std::min(std::abs(a.low), std::abs(a.high));
  return tidy(f(a.size()), f(near));
}

Range sine(Range a) {
  if (!(a.high - a.low < 2.0 * std::numbers::pi) || a.size() > 1e9) return {-1.0, 1.0};
  const double p = std::sin(a.low), q = std::sin(a.high);
  const auto holds = [&](double top) {
    const double turns = std::ceil((a.low - top) / (2.0 * std::numbers::pi));
    return top + turns * 2.0 * std::numbers::pi <= a.high;
  };
  return {holds(-0.5 * std::numbers::pi) ? -1.0 : std::min(p, q), holds(0.5 * std::numbers::pi) ? 1.0 : std::max(p, q)};
}
Range cosine(Range a) { return sine(a + Range{0.5 * std::numbers::pi, 0.5 * std::numbers::pi}); }

// ---- Functions of one value, with their slopes

template <class T>
struct Slopes {
  T value{}, first{}, second{};
};

Slopes<double> power(double a, double p) {
  return {std::pow(a, p), p == 0.0 ? 0.0 : p * std::pow(a, p - 1.0),
          p == 0.0 || p == 1.0 ? 0.0 : p * (p - 1.0) * std::pow(a, p - 2.0)};
}
Range power_of(Range a, double p) {
  if (p == 0.0) return {1.0, 1.0};
  const auto f = [p](double t) { return std::pow(t, p); };
  const bool whole = p == std::floor(p);
  if (a.low >= 0.0) return p > 0.0 ? rising(a, f) : falling(a, f);
  if (!whole)
    return a.high < 0.0 ? everything : p > 0.0 ? Range{0.0, f(a.high)} : Range{a.high > 0.0 ? f(a.high) : 0.0, inf};
  const bool even = std::fmod(p, 2.0) == 0.0;
  if (p > 0.0) return even ? -peaked(a, [p](double t) { return -std::pow(t, p); }) : rising(a, f);
  if (a.high >= 0.0) return even ? Range{std::min(f(a.low), f(a.high)), inf} : everything;
  return even ? rising(a, f) : falling(a, f);
}
Slopes<Range> power(Range a, double p) {
  return {power_of(a, p), p == 0.0 ? Range{} : p * power_of(a, p - 1.0),
          p == 0.0 || p == 1.0 ? Range{} : (p * (p - 1.0)) * power_of(a, p - 2.0)};
}

Slopes<double> slopes(std::uint8_t operation, double a, bool& /*kink*/) {
  switch (operation) {
    case Sin:
      return {std::sin(a), std::cos(a), -std::sin(a)};
    case Cos:
      return {std::cos(a), -std::sin(a), -std::cos(a)};
    case Tan: {
      const double t = std::tan(a);
      return {t, 1.0 + t * t, 2.0 * t * (1.0 + t * t)};
    }
    case Asin:
    case Acos: {
      const double rest = (1.0 - a) * (1.0 + a), sign = operation == Asin ? 1.0 : -1.0;
      return {operation == Asin ? std::asin(a) : std::acos(a), sign / std::sqrt(rest),
              sign * a / (rest * std::sqrt(rest))};
    }
    case Atan: {
      const double d = 1.0 / (1.0 + a * a);
      return {std::atan(a), d, -2.0 * a * d * d};
    }
    case Sinh:
      return {std::sinh(a), std::cosh(a), std::sinh(a)};
    case Cosh:
      return {std::cosh(a), std::sinh(a), std::cosh(a)};
    case Tanh: {
      const double t = std::tanh(a), c = std::cosh(a), d = 1.0 / (c * c);
      return {t, d, -2.0 * t * d};
    }
    case Exp: {
      const double e = std::exp(a);
      return {e, e, e};
    }
    case Log:
      return {std::log(a), 1.0 / a, -1.0 / (a * a)};
    case Log10:
      return {std::log10(a), 1.0 / (a * std::numbers::ln10), -1.0 / (a * a * std::numbers::ln10)};
    case Sqrt: {
      const double r = std::sqrt(a);
      return {r, 0.5 / r, -0.25 / (a * r)};
    }
    case Cbrt: {
      const double r = std::cbrt(a);
      return {r, 1.0 / (3.0 * r * r), -2.0 / (9.0 * r * r * a)};
    }
    case Abs:
      return {std::abs(a), a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : 0.0, 0.0};
    case Sign:
      return {a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : 0.0, 0.0, 0.0};
    default:
      return {std::floor(a), 0.0, 0.0};
  }
}

Slopes<Range> slopes(std::uint8_t operation, Range a, bool& kink) {
  const auto exp = [](double t) { return std::exp(t); };
  switch (operation) {
    case Sin:
      return {sine(a), cosine(a), -sine(a)};
    case Cos:
      return {cosine(a), -sine(a), -cosine(a)};
    case Tan: {
      const double branch = std::floor(a.low / std::numbers::pi + 0.5);
      if (!(a.high < (branch + 0.5) * std::numbers::pi)) return {everything, everything, everything};
      const Range t = rising(a, [](double u) { return std::tan(u); }), d = Range{1.0, 1.0} + square(t);
      return {t, d, 2.0 * t * d};
    }
    case Asin:
    case Acos: {
      if (!(a.low > -1.0 && a.high < 1.0)) {
        const Range clipped = within(a, -1.0, 1.0);
        return {operation == Asin ? rising(clipped, [](double t) { return std::asin(t); })
                                  : falling(clipped, [](double t) { return std::acos(t); }),
                everything, everything};
      }
      const double sign = operation == Asin ? 1.0 : -1.0;
      const Range d = -peaked(a, [](double t) { return -1.0 / std::sqrt((1.0 - t) * (1.0 + t)); });
      const Range dd = rising(a, [](double t) { return t * std::pow((1.0 - t) * (1.0 + t), -1.5); });
      return {operation == Asin ? rising(a, [](double t) { return std::asin(t); })
                                : falling(a, [](double t) { return std::acos(t); }),
              sign * d, sign * dd};
    }
    case Atan: {
      const Range d = peaked(a, [](double t) { return 1.0 / (1.0 + t * t); });
      constexpr double most = 0.6495190528383290;  // 3 sqrt(3) / 8
      return {rising(a, [](double t) { return std::atan(t); }), d, within(-2.0 * a * d * d, -most, most)};
    }
    case Sinh:
    case Cosh: {
      const Range s = rising(a, [](double t) { return std::sinh(t); });
      const Range c = -peaked(a, [](double t) { return -std::cosh(t); });
      return operation == Sinh ? Slopes<Range>{s, c, s} : Slopes<Range>{c, s, c};
    }
    case Tanh: {
      const Range t = rising(a, [](double u) { return std::tanh(u); });
      const Range d = peaked(a, [](double u) {
        const double c = std::cosh(u);
        return 1.0 / (c * c);
      });
      constexpr double most = 0.7698003589195010;  // 4 / (3 sqrt(3))
      return {t, d, within(-2.0 * t * d, -most, most)};
    }
    case Exp: {
      const Range e = rising(a, exp);
      return {e, e, e};
    }
    case Log:
    case Log10: {
      if (!(a.high > 0.0)) return {everything, everything, everything};
      const double low = std::max(a.low, 0.0), by = operation == Log ? 1.0 : 1.0 / std::numbers::ln10;
      const Range r{1.0 / a.high, low > 0.0 ? 1.0 / low : inf};
      return {Range{low > 0.0 ? by * std::log(low) : -inf, by * std::log(a.high)}, by * r, -by * square(r)};
    }
    case Sqrt: {
      if (!(a.high >= 0.0)) return {everything, everything, everything};
      const Range u{std::max(a.low, 0.0), a.high};
      return {rising(u, [](double t) { return std::sqrt(t); }), falling(u, [](double t) { return 0.5 / std::sqrt(t); }),
              rising(u, [](double t) { return -0.25 / (t * std::sqrt(t)); })};
    }
    case Cbrt: {
      const Range r = rising(a, [](double t) { return std::cbrt(t); });
      if (a.low <= 0.0 && a.high >= 0.0) return {r, Range{0.0, inf}, everything};
      return {r, peaked(a, [](double t) { return 1.0 / (3.0 * square(std::cbrt(t))); }),
              rising(a, [](double t) { return -2.0 / (9.0 * square(std::cbrt(t)) * t); })};
    }
    case Abs: {
      if (a.low >= 0.0) return {a, {1.0, 1.0}, {}};
      if (a.high <= 0.0) return {-a, {-1.0, -1.0}, {}};
      kink = true;
      return {{0.0, a.size()}, {-1.0, 1.0}, {}};
    }
    case Sign: {
      const auto f = [](double t) { return t > 0.0 ? 1.0 : t < 0.0 ? -1.0 : 0.0; };
      const Range s = rising(a, f);
      if (s.low != s.high) kink = true;
      return {s, {}, {}};
    }
    default: {
      const Range s = rising(a, [](double t) { return std::floor(t); });
      if (s.low != s.high) kink = true;
      return {s, {}, {}};
    }
  }
}

// ---- Jets

template <class T>
PlaneJet<T> chain(const PlaneJet<T>& u, const Slopes<T>& f) {
  if (is_nought(u.x) && is_nought(u.y) && is_nought(u.xx) && is_nought(u.xy) && is_nought(u.yy))
    return {f.value, {}, {}, {}, {}, {}};
  return {f.value,
          f.first * u.x,
          f.first * u.y,
          f.second * square(u.x) + f.first * u.xx,
          f.second * (u.x * u.y) + f.first * u.xy,
          f.second * square(u.y) + f.first * u.yy};
}
template <class T>
PlaneJet<T> operator+(const PlaneJet<T>& a, const PlaneJet<T>& b) {
  return {a.value + b.value, a.x + b.x, a.y + b.y, a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
}
template <class T>
PlaneJet<T> operator-(const PlaneJet<T>& a, const PlaneJet<T>& b) {
  return {a.value - b.value, a.x - b.x, a.y - b.y, a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
}
template <class T>
PlaneJet<T> operator-(const PlaneJet<T>& a) {
  return {-a.value, -a.x, -a.y, -a.xx, -a.xy, -a.yy};
}
template <class T>
PlaneJet<T> operator*(const PlaneJet<T>& a, const PlaneJet<T>& b) {
  return {a.value * b.value,
          a.x * b.value + a.value * b.x,
          a.y * b.value + a.value * b.y,
          a.xx * b.value + 2.0 * (a.x * b.x) + a.value * b.xx,
          a.xy * b.value + a.x * b.y + a.y * b.x + a.value * b.xy,
          a.yy * b.value + 2.0 * (a.y * b.y) + a.value * b.yy};
}
template <class T>
bool is_constant(const PlaneJet<T>& a) {
  return is_nought(a.x) && is_nought(a.y) && is_nought(a.xx) && is_nought(a.xy) && is_nought(a.yy);
}
std::optional<double> single(double a) { return a; }
std::optional<double> single(Range a) { return a.low == a.high ? std::optional(a.low) : std::nullopt; }

/// What is known of a condition: no, yes, or either.
enum class Truth { No, Yes, Either };
Truth truth(double a) { return a != 0.0 ? Truth::Yes : Truth::No; }
Truth truth(Range a) { return is_nought(a) ? Truth::No : a.low > 0.0 || a.high < 0.0 ? Truth::Yes : Truth::Either; }
Truth compared(std::uint8_t operation, double a, double b) {
  switch (operation) {
    case Less:
      return a < b ? Truth::Yes : Truth::No;
    case LessEqual:
      return a <= b ? Truth::Yes : Truth::No;
    case Greater:
      return a > b ? Truth::Yes : Truth::No;
    case GreaterEqual:
      return a >= b ? Truth::Yes : Truth::No;
    case Equal:
      return a == b ? Truth::Yes : Truth::No;
    default:
      return a != b ? Truth::Yes : Truth::No;
  }
}
Truth compared(std::uint8_t operation, Range a, Range b) {
  if (operation == Greater || operation == GreaterEqual) {
    std::swap(a, b);
    operation = operation == Greater ? Less : LessEqual;
  }
  if (operation == Less) return a.high < b.low ? Truth::Yes : a.low >= b.high ? Truth::No : Truth::Either;
  if (operation == LessEqual) return a.high <= b.low ? Truth::Yes : a.low > b.high ? Truth::No : Truth::Either;
  const bool apart = a.high < b.low || b.high < a.low, one = a.low == a.high && b.low == b.high && a.low == b.low;
  if (!apart && !one) return Truth::Either;
  return one == (operation == Equal) ? Truth::Yes : Truth::No;
}
PlaneJet<double> flag_of(Truth truth, double) { return {truth == Truth::Yes ? 1.0 : 0.0, 0, 0, 0, 0, 0}; }
PlaneJet<Range> flag_of(Truth truth, Range) {
  return {{truth == Truth::Yes ? 1.0 : 0.0, truth == Truth::No ? 0.0 : 1.0}, {}, {}, {}, {}, {}};
}
PlaneJet<double> both(const PlaneJet<double>& a, const PlaneJet<double>&) { return a; }
PlaneJet<Range> both(const PlaneJet<Range>& a, const PlaneJet<Range>& b) {
  return {hull(a.value, b.value), hull(a.x, b.x), hull(a.y, b.y), hull(a.xx, b.xx), hull(a.xy, b.xy), hull(a.yy, b.yy)};
}

double angle_of(double a, double b, bool& /*kink*/) { return std::atan2(a, b); }
Range angle_of(Range a, Range b, bool& kink) {
  if (a.low <= 0.0 && a.high >= 0.0 && b.low <= 0.0) {
    kink = true;
    return {-std::numbers::pi, std::numbers::pi};
  }
  const std::array all{std::atan2(a.low, b.low), std::atan2(a.low, b.high), std::atan2(a.high, b.low),
                       std::atan2(a.high, b.high)};
  return {*std::min_element(all.begin(), all.end()), *std::max_element(all.begin(), all.end())};
}

template <class T>
PlaneJet<T> reciprocal(const PlaneJet<T>& a) {
  return chain(a, power(a.value, -1.0));
}
template <class T>
PlaneJet<T> raised(const PlaneJet<T>& a, const PlaneJet<T>& b, bool& kink) {
  const auto exponent = single(b.value);
  if (exponent && is_constant(b)) return chain(a, power(a.value, *exponent));
  const PlaneJet<T> logarithm = chain(a, slopes(Log, a.value, kink));
  const PlaneJet<T> product = b * logarithm;
  return chain(product, slopes(Exp, product.value, kink));
}
template <class T>
PlaneJet<T> turned(const PlaneJet<T>& a, const PlaneJet<T>& b, bool& kink) {
  const T r = power(square(a.value) + square(b.value), -1.0).value, rr = square(r);
  const auto along = [&](T da, T db) { return b.value * da - a.value * db; };
  const T nx = along(a.x, b.x), ny = along(a.y, b.y);
  const T dx = 2.0 * (a.value * a.x + b.value * b.x), dy = 2.0 * (a.value * a.y + b.value * b.y);
  return {angle_of(a.value, b.value, kink),
          nx * r,
          ny * r,
          along(a.xx, b.xx) * r - nx * dx * rr,
          (b.y * a.x - a.y * b.x + along(a.xy, b.xy)) * r - nx * dy * rr,
          along(a.yy, b.yy) * r - ny * dy * rr};
}

template <class T>
class Machine {
 public:
  Machine(T x, T y, std::size_t depth) : x_(x), y_(y), stack_(of_thread()) { stack_.reserve(depth); }

  PlaneJet<T> run(std::span<const FormulaJet::Step> steps) {
    for (const FormulaJet::Step& step : steps) {
      const std::size_t count = taken_by(step.operation);
      const bool before = std::exchange(kink_, false);
      const PlaneJet<T> made = count == 0 ? leaf(step) : of(step.operation, stack_.data() + stack_.size() - count);
      kink_in_last_ = kink_;
      kink_ = kink_ || before;
      stack_.resize(stack_.size() - count);
      stack_.push_back(made);
    }
    return stack_.back();
  }
  [[nodiscard]] bool kink() const { return kink_; }
  /// In the last step itself.
  [[nodiscard]] bool kink_in_last() const { return kink_in_last_; }

 private:
  [[nodiscard]] PlaneJet<T> leaf(const FormulaJet::Step& step) const {
    PlaneJet<T> made;
    if constexpr (std::is_same_v<T, double>) {
      made.value = step.operation == X ? x_ : step.operation == Y ? y_ : step.number;
      if (step.operation == X) made.x = 1.0;
      if (step.operation == Y) made.y = 1.0;
    } else {
      made.value = step.operation == X ? x_ : step.operation == Y ? y_ : T{step.number, step.number};
      if (step.operation == X) made.x = {1.0, 1.0};
      if (step.operation == Y) made.y = {1.0, 1.0};
    }
    return made;
  }
  PlaneJet<T> decided(Truth truth) {
    if (truth == Truth::Either) kink_ = true;
    return flag_of(truth, x_);
  }
  PlaneJet<T> chosen(Truth first, const PlaneJet<T>& a, const PlaneJet<T>& b) {
    if (first == Truth::Yes) return a;
    if (first == Truth::No) return b;
    kink_ = true;
    return both(a, b);
  }
  PlaneJet<T> of(std::uint8_t operation, const PlaneJet<T>* a) {
    switch (operation) {
      case Add:
        return a[0] + a[1];
      case Subtract:
        return a[0] - a[1];
      case Multiply:
        return a[0] * a[1];
      case Divide:
        return a[0] * reciprocal(a[1]);
      case Power:
        return raised(a[0], a[1], kink_);
      case Negate:
        return -a[0];
      case And:
      case Or: {
        const Truth p = truth(a[0].value), q = truth(a[1].value), last = operation == And ? Truth::No : Truth::Yes;
        return decided(p == last || q == last ? last : p == q ? p : Truth::Either);
      }
      case Choose:
        return chosen(truth(a[0].value), a[1], a[2]);
      case Atan2:
        return turned(a[0], a[1], kink_);
      case Hypot: {
        const PlaneJet<T> sum = chain(a[0], power(a[0].value, 2.0)) + chain(a[1], power(a[1].value, 2.0));
        return chain(sum, slopes(Sqrt, sum.value, kink_));
      }
      case Min:
        return chosen(compared(LessEqual, a[0].value, a[1].value), a[0], a[1]);
      case Max:
        return chosen(compared(GreaterEqual, a[0].value, a[1].value), a[0], a[1]);
      default:
        if (operation >= Less && operation <= Unequal) return decided(compared(operation, a[0].value, a[1].value));
        return chain(a[0], slopes(operation, a[0].value, kink_));
    }
  }

  /// Kept from formula to formula: to ask for memory takes longer than to run one. One machine at a time has it.
  static std::vector<PlaneJet<T>>& of_thread() {
    thread_local std::vector<PlaneJet<T>> stack;
    stack.clear();
    return stack;
  }

  T x_, y_;
  std::vector<PlaneJet<T>>& stack_;
  bool kink_ = false, kink_in_last_ = false;
};

bool is_choice(std::uint8_t operation) {
  return (operation >= Less && operation <= Unequal) || operation == Abs || operation == Sign || operation == Floor ||
         operation == Min || operation == Max;
}

/// A choice with all that it looks at, as steps of their own.
struct Choice {
  std::size_t first = 0, last = 0;
  bool of_x = false, of_y = false;
};
std::vector<Choice> choices_in(const std::vector<FormulaJet::Step>& steps) {
  std::vector<Choice> stack, found;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Choice made{i, i, steps[i].operation == X, steps[i].operation == Y};
    for (std::size_t taken = taken_by(steps[i].operation); taken > 0; --taken) {
      const Choice& part = stack.back();
      made = {part.first, i, made.of_x || part.of_x, made.of_y || part.of_y};
      stack.pop_back();
    }
    stack.push_back(made);
    if (is_choice(steps[i].operation)) found.push_back(made);
  }
  return found;
}

/// Halves a range until numbers end where `undecided` holds; nothing where that is so of too many parts. Parts reach
/// over their ends by a digit: what changes over at the end of two is decided in either.
template <class Undecided>
std::vector<Range> narrowed(Range whole, const Undecided& undecided) {
  constexpr std::size_t most = 4096;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double nought = 0.25 * epsilon * (whole.high - whole.low);
  std::vector<Range> parts{whole};
  for (bool halved = true; halved;) {
    halved = false;
    std::vector<Range> next;
    for (const Range part : parts) {
      const Range wider{std::max(whole.low, std::nextafter(part.low, -inf)),
                        std::min(whole.high, std::nextafter(part.high, inf))};
      if (!undecided(wider)) continue;
      const double middle = 0.5 * (part.low + part.high);
      if (part.high - part.low <= std::max(nought, 4.0 * epsilon * part.size())) {
        next.push_back(part);
        continue;
      }
      next.push_back({part.low, middle});
      next.push_back({middle, part.high});
      halved = true;
    }
    if (next.size() > most) return {};
    parts = std::move(next);
  }
  return parts;
}

/// Ascending; those that touch are one.
std::vector<Range> joined(std::vector<Range> ranges) {
  std::sort(ranges.begin(), ranges.end(), [](Range a, Range b) { return a.low < b.low; });
  std::vector<Range> apart;
  for (const Range range : ranges) {
    if (!apart.empty() && range.low <= apart.back().high) {
      apart.back().high = std::max(apart.back().high, range.high);
    } else {
      apart.push_back(range);
    }
  }
  return apart;
}

}  // namespace
}  // namespace formula_jets

using formula_jets::Machine;

Result<FormulaJet> FormulaJet::make(const std::string& text, const std::array<std::string, 2>& names) {
  FormulaJet made;
  DOBRA_TRY(made.steps_, formula_jets::steps_of(text, names));
  std::size_t depth = 0;
  for (const Step& step : made.steps_) {
    depth = depth + 1 - formula_jets::taken_by(step.operation);
    made.depth_ = std::max(made.depth_, depth + 1);
  }
  return made;
}

PlaneJet<double> FormulaJet::at(double x, double y) const { return Machine<double>(x, y, depth_).run(steps_); }

FormulaJet::Bounds FormulaJet::over(Range x, Range y) const {
  Machine<Range> machine(x, y, depth_);
  Bounds bounds{machine.run(steps_), false};
  bounds.kink = machine.kink();
  return bounds;
}

FormulaJet::Changes FormulaJet::changes(Range x, Range y) const {
  Changes found;
  for (const formula_jets::Choice& choice : formula_jets::choices_in(steps_)) {
    if (choice.of_x == choice.of_y) continue;
    const std::span own(steps_.data() + choice.first, choice.last + 1 - choice.first);
    const auto undecided = [&](Range part) {
      Machine<Range> machine(part, part, depth_);
      machine.run(own);
      return machine.kink_in_last();
    };
    std::vector<Range>& along = choice.of_x ? found.x : found.y;
    const std::vector<Range> more = formula_jets::narrowed(choice.of_x ? x : y, undecided);
    along.insert(along.end(), more.begin(), more.end());
  }
  return {formula_jets::joined(std::move(found.x)), formula_jets::joined(std::move(found.y))};
}

}  // namespace dobra::base
