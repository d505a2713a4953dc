#include "shared/fem/error/new_sizes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace dobra::fem::error {
namespace {

using mesh::ElementMesh;

/// The exponent of the error in the size of each element: p, or lambda near a singular vertex.
std::vector<double> error_exponents(const ElementMesh& mesh, const std::vector<SingularVertex>& singular, int rings) {
  std::vector<double> exponents(mesh.element_count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) exponents[e] = mesh::is_quadratic(mesh.types[e]) ? 2.0 : 1.0;
  for (const SingularVertex& vertex : singular) {
    std::set<mesh::NodeId> reached{vertex.node};
    for (int ring = 0; ring < rings; ++ring) {
      std::set<mesh::NodeId> next = reached;
      for (std::size_t e = 0; e < mesh.element_count(); ++e) {
        const auto nodes = mesh.nodes_of(mesh::ElementId(e));
        if (std::none_of(nodes.begin(), nodes.end(), [&](mesh::NodeId n) { return reached.contains(n); })) continue;
        exponents[e] = std::min(exponents[e], vertex.exponent);
        next.insert(nodes.begin(), nodes.end());
      }
      reached = std::move(next);
    }
  }
  return exponents;
}

/// r_i = (mu a_i e_i^2)^(-1 / (2 a_i + 2)), with mu so that the sum of e_i^2 r_i^(2 a_i) is the square of `allowed`.
std::vector<double> optimal_factors(const std::vector<double>& errors, const std::vector<double>& exponents,
                                    double allowed) {
  std::vector<double> factors(errors.size());
  const auto fill = [&](double log_mu) {
    double sum = 0.0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const double a = exponents[i];
      const double log_r = -(log_mu + std::log(a) + 2.0 * std::log(errors[i])) / (2.0 * a + 2.0);
      factors[i] = std::exp(log_r);
      sum += errors[i] > 0.0 ? std::exp(2.0 * std::log(errors[i]) + 2.0 * a * log_r) : 0.0;
    }
    return sum;
  };
  // The sum falls as mu grows; its logarithm is bracketed from the errors themselves and halved.
  const double unit = -2.0 * std::log(allowed);
  double low = unit - 200.0;
  double high = unit + 200.0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (fill(middle) > allowed * allowed ? low : high) = middle;
  }
  fill(high);
  return factors;
}

}  // namespace

double element_size(const ElementMesh& mesh, std::size_t element) {
  const double a = std::abs(area(mesh, mesh::ElementId(element)));
  return mesh::corner_count(mesh.types[element]) == 3 ? std::sqrt(4.0 * a / std::sqrt(3.0)) : std::sqrt(a);
}

base::Result<std::vector<double>> new_sizes(const ElementMesh& mesh, const ErrorEstimate& estimate,
                                            const std::vector<SingularVertex>& singular,
                                            const NewSizeOptions& options) {
  const auto wrong = [](const char* message) { return base::Error{base::ErrorCode::InvalidOption, message}; };
  if (!(options.target > 0.0 && options.target < 1.0)) return wrong("the target of the error must lie between 0 and 1");
  if (!(options.least_factor > 0.0 && options.least_factor <= 1.0 && options.most_factor >= 1.0))
    return wrong("the factors of the size must hold 0 < least <= 1 <= most");
  if (options.max_size > 0.0 && options.min_size > options.max_size)
    return wrong("the least size must not be above the greatest");

  const std::size_t count = mesh.element_count();
  const double allowed = options.target * std::hypot(estimate.norm, estimate.error);
  const std::vector<double> exponents = error_exponents(mesh, singular, options.singular_rings);
  std::vector<double> factors(count);
  if (options.rule == SizeRule::Optimal) {
    factors = optimal_factors(estimate.elements, exponents, allowed);
  } else {
    // What is left out of the error takes no part of it.
    const auto judged =
        std::count_if(estimate.elements.begin(), estimate.elements.end(), [](double e) { return e > 0.0; });
    const double each = allowed / std::sqrt(static_cast<double>(std::max<std::ptrdiff_t>(judged, 1)));
    for (std::size_t i = 0; i < count; ++i) factors[i] = std::pow(estimate.elements[i] / each, -1.0 / exponents[i]);
  }
  std::vector<double> sizes(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double now = element_size(mesh, i);
    const bool singular_one = exponents[i] < (mesh::is_quadratic(mesh.types[i]) ? 2.0 : 1.0);
    // The equal rule asks for far too little there at once.
    const bool far = singular_one && options.rule == SizeRule::Optimal;
    const double least = far ? options.least_factor * options.least_factor : options.least_factor;
    sizes[i] = now * std::clamp(factors[i], least, options.most_factor);
    if (options.max_size > 0.0) sizes[i] = std::min(sizes[i], options.max_size);
    sizes[i] = std::max(sizes[i], options.min_size);
  }
  return sizes;
}

}  // namespace dobra::fem::error
