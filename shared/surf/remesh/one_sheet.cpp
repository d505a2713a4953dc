#include "shared/surf/remesh/one_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "shared/geom/box3.h"
#include "shared/surf/remesh/estimate.h"

namespace dobra::surf::remesh {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

bool has_far_area(const Remeshed& made, const RemeshOptions& options) {
  return std::abs(made.quality.area - made.area_before) > options.most_area_off * made.area_before;
}

/// Less than the size given; it was tried. None where none is found among those that mean few triangles.
Result<std::optional<double>> working_size(const param::SheetMade& made, RemeshOptions options, double size,
                                           const base::Progress& progress) {
  constexpr double few = 20'000.0;
  constexpr int tries = 8;
  Demand demand;
  demand.add(made.sheet, options.crease);
  geom::Box3 box;
  for (const geom::Point3 p : made.sheet.points) box.add(p);
  options.chord = 0.0;
  double next = rounded_down(0.5 * std::min(size, box.diagonal()));
  for (int i = 0; i < tries && demand.triangles(next) <= few; ++i, next = rounded_down(0.5 * next)) {
    const auto tried = remesh_once(made, options, next, progress);
    if (!tried && tried.error().code == ErrorCode::Cancelled) return tried.error();
    if (tried && tried->folded == 0 && !has_far_area(*tried, options)) return std::optional(next);
  }
  return std::optional<double>();
}

}  // namespace

Result<Remeshed> remesh_sheet(const param::SheetMade& made, const RemeshOptions& options, double size, Advice advice,
                              const base::Progress& progress) {
  auto done = remesh_once(made, options, size, progress);
  if (!done && done.error().code != ErrorCode::InvalidOption) return done;
  const bool far = done && has_far_area(*done, options);
  constexpr std::size_t simple = 1000;  // triangles: no rough scan, which folds whatever the size is
  const bool folds = done && done->folded > 0 && (size > mean_side(made.sheet) || made.sheet.triangles.size() < simple);
  if (done && !far && !folds) return done;
  std::optional<double> works;
  if (advice == Advice::Size) {
    DOBRA_TRY(works, working_size(made, options, size, progress));
  }
  if (!far && done && !works) return done;  // it folds whatever the size is, and tells so
  Error error = done ? Error{ErrorCode::InvalidOption, ""} : done.error();
  if (done) {
    const auto told = std::ranges::find(done->findings, far ? "area_off" : "folded", &base::Finding::code);
    if (told != done->findings.end()) error.place = told->place;
    const std::string why =
        far ? fmt::format("its area would be {:.4g} of {:.4g}", done->quality.area, done->area_before)
            : fmt::format("triangles would face against it: {}", done->folded);
    error.message = fmt::format("size {:.6g} is too large for this mesh ({}): give a smaller one", size, why);
  }
  if (works) error.message += fmt::format(", such as {:.6g}", *works);
  return error;
}

}  // namespace dobra::surf::remesh
