#include "shared/scene/grid.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace dobra::scene {
namespace {

template <class Group>
std::vector<double> greatest(const std::vector<double>& sizes, std::size_t groups, const Group& group_of) {
  std::vector<double> most(groups, 0.0);
  for (std::size_t i = 0; i < sizes.size(); ++i) most[group_of(i)] = std::max(most[group_of(i)], sizes[i]);
  return most;
}

/// Newton's method, from above, on a convex function of straight pieces.
template <class Group>
double scale_filling(double room, const std::vector<Stretch>& sizes, std::size_t groups, const Group& group_of) {
  room -= with_gaps(std::vector<double>(groups, 0.0));
  double scale = 1e12;
  constexpr int most_steps = 16;
  for (int step = 0; step < most_steps && scale > 0.0; ++step) {
    std::vector<Stretch> widest(groups);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      Stretch& other = widest[group_of(i)];
      if (sizes[i].fixed + scale * sizes[i].growing > other.fixed + scale * other.growing) other = sizes[i];
    }
    Stretch sum;
    for (const Stretch& own : widest) sum = {sum.fixed + own.fixed, sum.growing + own.growing};
    const double next = (room - sum.fixed) / sum.growing;
    if (!(next < scale)) break;
    scale = next;
  }
  return scale;
}

}  // namespace

std::vector<double> Grid::in_columns(const std::vector<double>& sizes) const {
  return greatest(sizes, std::min(columns_, count_), [this](std::size_t i) { return column_of(i); });
}

std::vector<double> Grid::in_rows(const std::vector<double>& sizes) const {
  return greatest(sizes, rows(), [this](std::size_t i) { return row_of(i); });
}

double Grid::scale_across(double room, const std::vector<Stretch>& widths) const {
  return scale_filling(room, widths, std::min(columns_, count_), [this](std::size_t i) { return column_of(i); });
}

double Grid::scale_down(double room, const std::vector<Stretch>& heights) const {
  return scale_filling(room, heights, rows(), [this](std::size_t i) { return row_of(i); });
}

double with_gaps(const std::vector<double>& sizes) {
  const double gaps = sizes.empty() ? 0.0 : panel_gap * static_cast<double>(sizes.size() - 1);
  return std::accumulate(sizes.begin(), sizes.end(), gaps);
}

bool have_extents(const std::vector<Panel>& panels) {
  return std::all_of(panels.begin(), panels.end(), [](const Panel& panel) { return panel.extent.has_value(); });
}

double size_in_window(const std::vector<Panel>& panels, const PageSize& page, std::size_t columns) {
  const double width = page.width / static_cast<double>(columns);
  const double height = page.height / static_cast<double>(Grid(panels.size(), columns).rows());
  if (!have_extents(panels)) return std::min(width / height, height / width);
  double scale = std::numeric_limits<double>::infinity();
  for (const Panel& panel : panels) {
    scale = std::min(
        {scale, width / panel.extent->width(), height / (panel.extent->height() * panel.vertical_exaggeration)});
  }
  return scale;
}

}  // namespace dobra::scene
