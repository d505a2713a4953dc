#include "recon/inversion/bed_shapes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "shared/base/text.h"
#include "shared/geom/arc_length.h"

namespace recon::inversion {

namespace {

base::Error bad_beds(std::string message) { return {base::ErrorCode::BadSection, std::move(message)}; }

/// Adds the points of a piece, each with the half of its sides as weight. Its ends may lie on faults: they are taken a
/// millionth of their sides inward, so that they are in the wall of their piece.
void add_piece(const geom::Polyline& line, BedShape& bed) {
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    double weight = 0.0;
    if (i > 0) weight += 0.5 * geom::distance(line.points[i - 1], line.points[i]);
    if (i + 1 < line.points.size()) weight += 0.5 * geom::distance(line.points[i], line.points[i + 1]);
    geom::Point p = line.points[i];
    if (i == 0) p = geom::interpolate(p, line.points[1], 1e-6);
    if (i + 1 == line.points.size()) p = geom::interpolate(p, line.points[i - 1], 1e-6);
    bed.points.push_back(p);
    bed.weights.push_back(weight);
  }
}

void normalise_weights(BedShape& bed) {
  double sum = 0.0;
  for (const double weight : bed.weights) sum += weight;
  for (double& weight : bed.weights) weight *= static_cast<double>(bed.points.size()) / sum;
}

std::vector<std::string> whole_names(const section::Section& section) {
  std::vector<std::string> names;
  for (const section::Horizon& horizon : section.horizons) {
    if (std::find(names.begin(), names.end(), whole_name(horizon)) == names.end()) names.push_back(whole_name(horizon));
  }
  return names;
}

}  // namespace

base::Result<std::vector<BedShape>> bed_shapes(const section::Section& section, const std::vector<std::string>& names) {
  const std::vector<std::string> known = whole_names(section);
  if (known.empty()) return bad_beds("the section has no horizon; add an [[input.horizon]]");
  std::vector<BedShape> beds;
  for (const std::string& name : names.empty() ? known : names) {
    BedShape bed{name, {}, {}};
    for (const section::Horizon& horizon : section.horizons) {
      if (whole_name(horizon) == name) add_piece(horizon.line, bed);
    }
    if (bed.points.empty())
      return bad_beds(fmt::format("the section has no horizon '{}'{}", name, base::did_you_mean(name, known)));
    if (bed.points.size() < 3)
      return bad_beds(
          fmt::format("horizon '{}' has {} points, and any two lie on a straight line; digitise its shape, "
                      "or leave it out with 'horizon'",
                      name, bed.points.size()));
    normalise_weights(bed);
    beds.push_back(std::move(bed));
  }
  return beds;
}

std::vector<BedShape> thinned(const std::vector<BedShape>& beds, std::size_t most) {
  std::vector<BedShape> result;
  for (const BedShape& bed : beds) {
    const std::size_t count = bed.points.size();
    const std::size_t kept = std::min(count, most);
    BedShape thin{bed.name, {}, {}};
    for (std::size_t i = 0; i < kept; ++i) {
      const std::size_t from = i * count / kept;
      const std::size_t to = (i + 1) * count / kept;
      double weight = 0.0;
      for (std::size_t k = from; k < to; ++k) weight += bed.weights[k];
      thin.points.push_back(bed.points[(from + to) / 2]);
      thin.weights.push_back(weight);
    }
    result.push_back(std::move(thin));
  }
  return result;
}

BedLine straight_line(const BedShape& bed, const std::vector<geom::Point>& restored,
                      std::optional<base::Angle> bedding) {
  double weight = 0.0;
  geom::Vector sum;
  for (std::size_t i = 0; i < restored.size(); ++i) {
    weight += bed.weights[i];
    sum = sum + bed.weights[i] * (restored[i] - restored.front());
  }
  BedLine line{restored.front() + (1.0 / weight) * sum, {}};
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < restored.size() && !bedding; ++i) {
    const geom::Vector v = restored[i] - line.at;
    xx += bed.weights[i] * v.x * v.x;
    xy += bed.weights[i] * v.x * v.y;
    yy += bed.weights[i] * v.y * v.y;
  }
  const double angle = bedding ? bedding->radians() : 0.5 * std::atan2(2.0 * xy, xx - yy);
  line.normal = {-std::sin(angle), std::cos(angle)};
  // One sign for neighbouring parameters, so that distances have derivatives.
  if (geom::cross(restored.back() - restored.front(), line.normal) < 0.0 && !bedding) line.normal = -line.normal;
  return line;
}

void deviations(const std::vector<BedShape>& beds, const Restore& restore, std::optional<base::Angle> bedding,
                std::vector<double>& out) {
  out.clear();
  std::vector<geom::Point> restored;
  for (const BedShape& bed : beds) {
    restored.clear();
    for (const geom::Point p : bed.points) restored.push_back(restore(p));
    const BedLine line = straight_line(bed, restored, bedding);
    for (std::size_t i = 0; i < restored.size(); ++i)
      out.push_back(std::sqrt(bed.weights[i]) * geom::dot(restored[i] - line.at, line.normal));
  }
}

double sum_of_squares(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return sum;
}

}  // namespace recon::inversion
