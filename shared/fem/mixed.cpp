#include "shared/fem/mixed.h"

#include <cmath>

namespace dobra::fem {
namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// Solves m x = b for a symmetric positive definite matrix, by elimination.
std::array<double, 3> solved(Matrix3 m, std::array<double, 3> b) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = i + 1; k < 3; ++k) {
      const double factor = m[k][i] / m[i][i];
      for (std::size_t j = i; j < 3; ++j) m[k][j] -= factor * m[i][j];
      b[k] -= factor * b[i];
    }
  }
  for (std::size_t i = 3; i-- > 0;) {
    for (std::size_t j = i + 1; j < 3; ++j) b[i] -= m[i][j] * b[j];
    b[i] /= m[i][i];
  }
  return b;
}

}  // namespace

bool nearly_incompressible(const Material& material) {
  return material.state == PlaneState::Strain && material.poisson > mixed_above;
}

Reference reference_at(const ElementGeometry& element, const Mapped& mapped) {
  Reference at;
  for (std::size_t a = 0; a < element.count; ++a) {
    const auto [xi, eta] = reference_node(element.type, a);
    at.xi += xi * mapped.n[a];
    at.eta += eta * mapped.n[a];
    at.xi_x += xi * mapped.d_x[a];
    at.xi_y += xi * mapped.d_y[a];
    at.eta_x += eta * mapped.d_x[a];
    at.eta_y += eta * mapped.d_y[a];
  }
  return at;
}

geom::Vector bubble_slope(ElementType type, const Reference& at) {
  const auto [xi, eta, xi_x, xi_y, eta_x, eta_y] = at;
  const bool triangle = mesh::corner_count(type) == 3;
  const double d_xi = triangle ? 27.0 * eta * (1.0 - 2.0 * xi - eta) : -2.0 * xi * (1.0 - eta * eta);
  const double d_eta = triangle ? 27.0 * xi * (1.0 - xi - 2.0 * eta) : -2.0 * eta * (1.0 - xi * xi);
  return {d_xi * xi_x + d_eta * eta_x, d_xi * xi_y + d_eta * eta_y};
}

MixedElement::MixedElement(const ElementGeometry& element, const Material& material) : dofs_(2 * element.count) {
  const std::size_t corners = mesh::corner_count(element.type);
  geom::Vector sum;
  for (std::size_t i = 0; i < corners; ++i) sum = sum + (element.coordinates[i] - element.coordinates[0]);
  centre_ = element.coordinates[0] + sum / static_cast<double>(corners);
  scale_ = distance(element.coordinates[0], element.coordinates[1]);
  const Elasticity d = elasticity(material);
  const auto points = integration_points(element.type, Rule::Curved);
  const auto shapes = shapes_at(element.type, Rule::Curved);
  Matrix3 mass{};
  std::array<Row, 3> divergence{};
  const std::size_t nodes = element.count + 1;
  for (std::size_t g = 0; g < points.size(); ++g) {
    Mapped m = map(element.points(), shapes[g]);
    const geom::Vector slope = bubble_slope(element.type, reference_at(element, m));
    std::array<double, most_nodes + 1> dx{}, dy{};
    std::copy_n(m.d_x.begin(), element.count, dx.begin());
    std::copy_n(m.d_y.begin(), element.count, dy.begin());
    dx[element.count] = slope.x;
    dy[element.count] = slope.y;
    const double volume = m.determinant * points[g].weight * material.thickness;
    for (std::size_t a = 0; a < nodes; ++a) {  // 2 mu strain : strain
      for (std::size_t b = 0; b < nodes; ++b) {
        const double mu = volume * d.shear;
        k_[2 * a][2 * b] += mu * (2.0 * dx[a] * dx[b] + dy[a] * dy[b]);
        k_[2 * a][2 * b + 1] += mu * dy[a] * dx[b];
        k_[2 * a + 1][2 * b] += mu * dx[a] * dy[b];
        k_[2 * a + 1][2 * b + 1] += mu * (2.0 * dy[a] * dy[b] + dx[a] * dx[b]);
      }
    }
    const auto q = basis(m.at);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) mass[i][j] += volume * q[i] * q[j];
      for (std::size_t a = 0; a < nodes; ++a) {
        divergence[i][2 * a] += volume * q[i] * dx[a];
        divergence[i][2 * a + 1] += volume * q[i] * dy[a];
      }
    }
  }
  for (std::size_t i = 0; i < dofs_ + 2; ++i) {
    const auto column = solved(mass, {divergence[0][i], divergence[1][i], divergence[2][i]});
    for (std::size_t k = 0; k < 3; ++k) dilatation_[k][i] = column[k];
  }
  for (std::size_t i = 0; i < dofs_ + 2; ++i) {
    for (std::size_t j = 0; j < dofs_ + 2; ++j) {
      for (std::size_t k = 0; k < 3; ++k) k_[i][j] += d.xy * divergence[k][i] * dilatation_[k][j];
    }
  }
  eliminate_bubble();
}

void MixedElement::eliminate_bubble() {
  const std::size_t b = dofs_;
  const double xx = k_[b][b], xy = k_[b][b + 1], yy = k_[b + 1][b + 1];
  const double determinant = xx * yy - xy * xy;
  for (std::size_t j = 0; j < dofs_; ++j) {
    bubble_[0][j] = -(yy * k_[b][j] - xy * k_[b + 1][j]) / determinant;
    bubble_[1][j] = -(xx * k_[b + 1][j] - xy * k_[b][j]) / determinant;
  }
  for (std::size_t i = 0; i < dofs_; ++i) {
    for (std::size_t j = 0; j < dofs_; ++j) k_[i][j] += k_[i][b] * bubble_[0][j] + k_[i][b + 1] * bubble_[1][j];
  }
}

double MixedElement::stiffness(std::size_t i, std::size_t j) const { return 0.5 * (k_[i][j] + k_[j][i]); }

geom::Vector MixedElement::bubble(std::span<const geom::Vector> own) const {
  geom::Vector value;
  for (std::size_t a = 0; a < own.size(); ++a) {
    value.x += bubble_[0][2 * a] * own[a].x + bubble_[0][2 * a + 1] * own[a].y;
    value.y += bubble_[1][2 * a] * own[a].x + bubble_[1][2 * a + 1] * own[a].y;
  }
  return value;
}

std::array<double, 3> MixedElement::dilatation(std::span<const geom::Vector> own, geom::Vector bubble) const {
  std::array<double, 3> coefficients{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t a = 0; a <= own.size(); ++a) {
      const geom::Vector u = a < own.size() ? own[a] : bubble;
      coefficients[k] += dilatation_[k][2 * a] * u.x + dilatation_[k][2 * a + 1] * u.y;
    }
  }
  return coefficients;
}

double MixedElement::dilatation_at(const std::array<double, 3>& coefficients, geom::Point p) const {
  const auto q = basis(p);
  return coefficients[0] * q[0] + coefficients[1] * q[1] + coefficients[2] * q[2];
}

std::array<double, 3> MixedElement::basis(geom::Point p) const {
  return {1.0, (p.x - centre_.x) / scale_, (p.y - centre_.y) / scale_};
}

}  // namespace dobra::fem
