#include "shared/surf/spline_basis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dobra::surf {

using base::Error;
using base::ErrorCode;

base::Result<SplineBasis> SplineBasis::make(std::size_t degree, std::vector<double> knots, const std::string& called) {
  if (degree < 1 || degree > highest_degree)
    return Error{ErrorCode::InvalidOption,
                 fmt::format("{}: degree {} is not between 1 and {}", called, degree, highest_degree)};
  if (knots.size() < 2 * (degree + 1))
    return Error{ErrorCode::InvalidOption, fmt::format("{}: {} knots, but degree {} needs {} at least", called,
                                                       knots.size(), degree, 2 * (degree + 1))};
  std::size_t equal = 1;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i]))
      return Error{ErrorCode::NotFinite, fmt::format("{}: knot {} is not finite", called, i + 1)};
    if (i == 0) continue;
    if (knots[i] < knots[i - 1])
      return Error{ErrorCode::InvalidOption, fmt::format("{}: knot {} ({}) is below the one before it ({})", called,
                                                         i + 1, knots[i], knots[i - 1])};
    equal = knots[i] == knots[i - 1] ? equal + 1 : 1;
    if (equal > degree + 1)
      return Error{ErrorCode::InvalidOption,
                   fmt::format("{}: knot {} ({}) stands more than {} times", called, i + 1, knots[i], degree + 1)};
  }
  SplineBasis basis(degree, std::move(knots));
  if (!(basis.low() < basis.high()))
    return Error{ErrorCode::InvalidOption,
                 fmt::format("{}: the range from {} to {} is empty", called, basis.low(), basis.high())};
  return basis;
}

std::vector<double> SplineBasis::breaks() const {
  std::vector<double> breaks(knots_.begin() + static_cast<std::ptrdiff_t>(degree_),
                             knots_.begin() + static_cast<std::ptrdiff_t>(count()) + 1);
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

std::vector<std::size_t> SplineBasis::jumps() const {
  std::vector<std::size_t> found;
  for (std::size_t i = degree_ + 1; i < count(); ++i) {
    if (knots_[i] == knots_[i + degree_] && knots_[i] > low() && knots_[i] < high()) found.push_back(i);
  }
  return found;
}

std::size_t SplineBasis::span_of(double t) const {
  // The last knot that is not above t, among those that begin a piece.
  const auto begin = knots_.begin() + static_cast<std::ptrdiff_t>(degree_);
  const auto end = knots_.begin() + static_cast<std::ptrdiff_t>(count());
  // Where it is if the knots are even; else by halving.
  const double share = (t - low()) / (high() - low()) * static_cast<double>(end - begin);
  auto above =
      begin + (share > 0.0 ? static_cast<std::ptrdiff_t>(std::min(share, static_cast<double>(end - begin - 1))) : 0);
  constexpr int few = 3;
  int steps = 0;
  for (; steps < few && above != end && *above <= t; ++steps) ++above;
  for (; steps < few && above != begin && *(above - 1) > t; ++steps) --above;
  if (steps == few) above = std::upper_bound(begin, end, t);
  if (above == begin) ++above;
  std::size_t span = static_cast<std::size_t>(above - knots_.begin()) - 1;
  while (span > degree_ && knots_[span] == knots_[span + 1]) --span;
  while (knots_[span] == knots_[span + 1]) ++span;
  return span;
}

std::vector<std::pair<double, double>> SplineBasis::pieces(double from, double to) const {
  std::vector<std::pair<double, double>> found;
  double last = from;
  for (std::size_t i = degree_ + 1; i < count(); ++i) {
    if (knots_[i] <= last) continue;
    if (knots_[i] >= to) break;
    found.emplace_back(last, knots_[i]);
    last = knots_[i];
  }
  found.emplace_back(last, to);
  return found;
}

SplineBasis::ToBezier SplineBasis::bezier(double from, double to) const {
  const std::size_t p = degree_, span = span_of(0.5 * (from + to));
  ToBezier made;
  made.first = span - p;
  for (std::size_t i = 0; i <= p; ++i) {
    for (std::size_t j = 0; j <= p; ++j) {
      // The blossom of function j at `from` (p - i times) and `to` (i times), by de Boor's rule.
      std::array<double, highest_degree + 1> d{};
      d[j] = 1.0;
      for (std::size_t r = 1; r <= p; ++r) {
        const double t = r <= p - i ? from : to;
        for (std::size_t k = p; k >= r; --k) {
          const double low = knots_[span - p + k], high = knots_[span + 1 + k - r];
          const double part = (t - low) / (high - low);
          d[k] = (1.0 - part) * d[k - 1] + part * d[k];
        }
      }
      made.of[i][j] = d[p];
    }
  }
  return made;
}

SplineBasis::Values SplineBasis::at(double t) const {
  const std::size_t p = degree_, span = span_of(t);
  // The triangle of functions of rising degree; below the diagonal the knot differences.
  std::array<std::array<double, highest_degree + 1>, highest_degree + 1> table;  // what is read is written before
  std::array<double, highest_degree + 1> left, right;
  table[0][0] = 1.0;
  for (std::size_t j = 1; j <= p; ++j) {
    left[j] = t - knots_[span + 1 - j];
    right[j] = knots_[span + j] - t;
    double saved = 0.0;
    for (std::size_t r = 0; r < j; ++r) {
      table[j][r] = right[r + 1] + left[j - r];
      const double part = table[r][j - 1] / table[j][r];
      table[r][j] = saved + right[r + 1] * part;
      saved = left[j - r] * part;
    }
    table[j][j] = saved;
  }
  Values values;
  values.first = span - p;
  for (std::size_t r = 0; r <= p; ++r) values.of[0][r] = table[r][p];
  // Derivative k is a difference of functions of degree p - k.
  for (std::size_t r = 0; r <= p; ++r) {
    std::array<std::array<double, 3>, 2> a{};
    a[0][0] = 1.0;
    std::size_t now = 0;
    double factor = static_cast<double>(p);
    for (std::size_t k = 1; k <= std::min<std::size_t>(2, p); ++k) {
      const std::size_t next = 1 - now;
      double sum = 0.0;
      const auto function = [&](std::size_t i) { return table[i][p - k]; };
      if (r >= k) {
        a[next][0] = a[now][0] / table[p - k + 1][r - k];
        sum = a[next][0] * function(r - k);
      } else {
        a[next][0] = 0.0;
      }
      const std::size_t from = r + 1 >= k ? 1 : k - r;
      const std::size_t to = r <= p - k + 1 ? k - 1 : p - r;
      for (std::size_t j = from; j <= to; ++j) {
        a[next][j] = (a[now][j] - a[now][j - 1]) / table[p - k + 1][r + j - k];
        sum += a[next][j] * function(r + j - k);
      }
      if (r <= p - k) {
        a[next][k] = -a[now][k - 1] / table[p - k + 1][r];
        sum += a[next][k] * function(r);
      } else {
        a[next][k] = 0.0;
      }
      values.of[k][r] = sum * factor;
      factor *= static_cast<double>(p - k);
      now = next;
    }
  }
  return values;
}

}  // namespace dobra::surf
