#pragma once
// Shortening of a thrust belt from the area of its section, with errors: the area, taken back to the thickness that the
// layers had, gives the initial width.
//   A    = |sum (x_i y_{i+1} - x_{i+1} y_i)| / 2
//   dA^2 = sum ((y_{i+1} - y_{i-1}) dx_i / 2)^2 + ((x_{i+1} - x_{i-1}) dy_i / 2)^2
//   w0   = 2 A / (t1 + t2)      S = w0 - w1      e = S / w0
// Errors are given for independent picks (root of squares) and at most (sum of absolute values).
// Source: [judge2011].  Page: docs/algorithms/ledger.md

#include <string>
#include <vector>

#include "recon/section/section.h"
#include "shared/scenario/program.h"

namespace recon::balance {

/// Parameters of the step `area_balance`.
struct AreaBalanceParams {
  std::string file;
  std::vector<double> columns = {1.0, 2.0, 3.0, 4.0};
  section::LengthUnit unit = section::LengthUnit::Metre;
  std::vector<double> thickness;
  std::vector<double> thickness_error;
  std::vector<double> width_points;
  std::optional<double> width;
  double width_error = 0.0;
  template <class D>
  static void describe(D& d) {
    d.file(
        "file", &AreaBalanceParams::file,
        {.title = "Polygon",
         .help = "Text with columns x, y and, for errors, dx, dy; one vertex a line. Or a polygon in any other format.",
         .presence = dobra::scenario::Presence::Required});
    d.field(
        "columns", &AreaBalanceParams::columns,
        {.title = "Columns of x, y, dx and dy", .help = "In a text file, counted from 1; two leave the errors out."});
    d.choice("unit", &AreaBalanceParams::unit, {"m", "km", "ft"},
             {.title = "Unit of the file and of the lengths here"});
    d.field("thickness", &AreaBalanceParams::thickness,
            {.title = "Thickness before shortening",
             .help = "At the two ends, or one for both.",
             .presence = dobra::scenario::Presence::Required});
    d.field("thickness_error", &AreaBalanceParams::thickness_error, {.title = "Their errors"});
    d.field("width_points", &AreaBalanceParams::width_points,
            {.title = "Vertices that bound the present width",
             .help = "Two numbers counted from 1; the distance along x between them."});
    d.field(
        "width", &AreaBalanceParams::width,
        {.title = "Present width", .help = "Instead of width_points; by default that of the polygon.", .above = 0.0});
    d.field("width_error", &AreaBalanceParams::width_error,
            {.title = "Its error", .help = "With width_points the errors of the vertices are used.", .at_least = 0.0});
  }
};

/// A value with its independent error and the greatest that it can be. SI.
struct WithError {
  double value = 0.0;
  double error = 0.0;
  double most = 0.0;
};

struct AreaBalance {
  WithError area;           ///< m2
  WithError initial_width;  ///< m
  WithError width;          ///< m
  WithError shortening;     ///< m
  WithError percent;        ///< Of the initial width.
};

/// A polygon with the error of each coordinate, m.
struct UncertainPolygon {
  std::vector<geom::Point> points;
  std::vector<geom::Vector> errors;  ///< One a point, >= 0.
};

WithError area_with_error(const UncertainPolygon& polygon);

/// @param thickness at the two ends, each with its error, m.
AreaBalance balance_area(const UncertainPolygon& polygon, WithError thickness_1, WithError thickness_2,
                         WithError width);

/// @error those of the file, with line and column; BadValue (parameters).
base::Result<AreaBalance> balance_area(const AreaBalanceParams& params, const dobra::scenario::Context& context);

}  // namespace recon::balance
