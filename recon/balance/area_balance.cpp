#include "recon/balance/area_balance.h"

#include <fmt/format.h>

#include <cmath>

#include "shared/io/formats/line_files.h"

namespace recon::balance {

namespace {

/// Adds independent errors, and those that conspire.
class ErrorSum {
 public:
  void add(double part, double most_part) {
    squares_ += part * part;
    most_ += std::abs(most_part);
  }
  void add(double part) { add(part, part); }
  [[nodiscard]] WithError with(double value) const { return {value, std::sqrt(squares_), most_}; }

 private:
  double squares_ = 0.0;
  double most_ = 0.0;
};

base::Result<UncertainPolygon> read_polygon(const std::string& file, double unit, const AreaBalanceParams& params) {
  dobra::io::formats::LineOptions options;
  options.unit = unit;
  options.coordinates = dobra::io::formats::Coordinates::Section;
  options.text.closing = dobra::io::lines::Closing::KeepOpen;
  options.text.blank_lines = dobra::io::lines::BlankLines::Ignore;
  for (const double column : params.columns)
    (options.text.columns.size() < 2 ? options.text.columns : options.text.extra_columns)
        .push_back(fmt::format("{}", column));
  if (params.columns.size() != 2 && params.columns.size() != 4) {
    return base::Error{base::ErrorCode::BadValue, "columns needs two numbers, x and y, or four, x, y and their errors"};
  }
  DOBRA_TRY(const dobra::io::formats::LineWork work, dobra::io::formats::read_any_lines(file, options));
  const base::Place place{.file = file};
  if (work.features.size() != 1 || work.features[0].parts.size() != 1) {
    return base::Error{base::ErrorCode::BadFormat, "the file holds more than one line; keep the polygon alone", place};
  }
  UncertainPolygon polygon;
  polygon.points = work.features[0].parts[0].points;
  polygon.errors.resize(polygon.points.size());
  if (!work.features[0].extras.empty()) {
    const std::vector<double>& errors = work.features[0].extras[0];
    for (std::size_t i = 0; i < polygon.points.size(); ++i)
      polygon.errors[i] = unit * geom::Vector{std::abs(errors[2 * i]), std::abs(errors[2 * i + 1])};
  }
  if (polygon.points.size() > 1 && polygon.points.front() == polygon.points.back()) {
    polygon.points.pop_back();
    polygon.errors.pop_back();
  }
  if (polygon.points.size() < 3)
    return base::Error{base::ErrorCode::BadFormat, "a polygon needs three vertices", place};
  return polygon;
}

base::Result<double> one_of(const std::vector<double>& values, std::size_t which, double unit, const char* name) {
  if (values.empty()) return 0.0;
  if (values.size() > 2) {
    return base::Error{base::ErrorCode::BadValue, fmt::format("{} needs one number or two", name)};
  }
  const double value = values[std::min(which, values.size() - 1)];
  if (!(value >= 0.0)) return base::Error{base::ErrorCode::BadValue, fmt::format("{} must not be negative", name)};
  return unit * value;
}

base::Result<WithError> present_width(const AreaBalanceParams& params, const UncertainPolygon& polygon, double unit) {
  if (params.width) return WithError{unit * *params.width, unit * params.width_error, unit * params.width_error};
  if (params.width_points.empty()) {
    return WithError{geom::box_of(polygon.points).width(), unit * params.width_error, unit * params.width_error};
  }
  const auto count = static_cast<double>(polygon.points.size());
  if (params.width_points.size() != 2) {
    return base::Error{base::ErrorCode::BadValue, "width_points needs two numbers of vertices, such as [1, 12]"};
  }
  for (const double number : params.width_points) {
    if (number >= 1.0 && number <= count && number == std::floor(number)) continue;
    return base::Error{base::ErrorCode::BadValue,
                       fmt::format("width_points: there is no vertex {} among the {}", number, count)};
  }
  const auto first = static_cast<std::size_t>(params.width_points[0]) - 1;
  const auto last = static_cast<std::size_t>(params.width_points[1]) - 1;
  ErrorSum errors;
  errors.add(polygon.errors[first].x);
  errors.add(polygon.errors[last].x);
  return errors.with(std::abs(polygon.points[last].x - polygon.points[first].x));
}

}  // namespace

WithError area_with_error(const UncertainPolygon& polygon) {
  const std::size_t count = polygon.points.size();
  ErrorSum errors;
  for (std::size_t i = 0; i < count; ++i) {
    const geom::Vector across = polygon.points[(i + 1) % count] - polygon.points[(i + count - 1) % count];
    errors.add(0.5 * across.y * polygon.errors[i].x);
    errors.add(0.5 * across.x * polygon.errors[i].y);
  }
  return errors.with(std::abs(geom::signed_area({polygon.points, true})));
}

AreaBalance balance_area(const UncertainPolygon& polygon, WithError thickness_1, WithError thickness_2,
                         WithError width) {
  AreaBalance balance;
  balance.area = area_with_error(polygon);
  balance.width = width;
  const double sum = thickness_1.value + thickness_2.value;
  const double initial = 2.0 * balance.area.value / sum;
  ErrorSum of_initial;
  of_initial.add(2.0 * balance.area.error / sum, 2.0 * balance.area.most / sum);
  of_initial.add(initial / sum * thickness_1.error, initial / sum * thickness_1.most);
  of_initial.add(initial / sum * thickness_2.error, initial / sum * thickness_2.most);
  balance.initial_width = of_initial.with(initial);
  ErrorSum of_shortening;
  of_shortening.add(balance.initial_width.error, balance.initial_width.most);
  of_shortening.add(width.error, width.most);
  balance.shortening = of_shortening.with(initial - width.value);
  ErrorSum of_percent;  // e = 1 - w1 / w0
  of_percent.add(100.0 * width.error / initial, 100.0 * width.most / initial);
  const double by_initial = 100.0 * width.value / (initial * initial);
  of_percent.add(by_initial * balance.initial_width.error, by_initial * balance.initial_width.most);
  balance.percent = of_percent.with(100.0 * (initial - width.value) / initial);
  return balance;
}

base::Result<AreaBalance> balance_area(const AreaBalanceParams& params, const dobra::scenario::Context& context) {
  const double unit = metres_per_unit(params.unit);
  DOBRA_TRY(const UncertainPolygon polygon, read_polygon((context.folder / params.file).string(), unit, params));
  std::vector<WithError> thickness;
  for (const std::size_t end : {0, 1}) {
    DOBRA_TRY(const double value, one_of(params.thickness, end, unit, "thickness"));
    DOBRA_TRY(const double error, one_of(params.thickness_error, end, unit, "thickness_error"));
    if (!(value > 0.0)) return base::Error{base::ErrorCode::BadValue, "thickness must be above 0"};
    thickness.push_back({value, error, error});
  }
  DOBRA_TRY(const WithError width, present_width(params, polygon, unit));
  return balance_area(polygon, thickness[0], thickness[1], width);
}

}  // namespace recon::balance
