// 1. Measure what does not depend on the scale: titles, colour bars.
// 2. Find the scale (or take it from the views) with a guess of the room round each plot; from it the ticks, from their
// labels
//    the room. Repeat until the room is enough; it only ever grows, so this ends.
// 3. Put everything in its place.
#include "shared/scene/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "shared/base/check.h"
#include "shared/base/text.h"
#include "shared/scene/furniture.h"
#include "shared/scene/text_table.h"

namespace dobra::scene {
namespace {

constexpr double panel_gap = 16.0;
constexpr double bar_gap = 18.0;
constexpr double least_bar = 90.0;
constexpr double label_room = 8.0;   // gaps beside a label, points
constexpr int most_name_rounds = 8;  // each needs less room than the one before
constexpr double most_bar = 280.0;

/// A panel on its way to the page. left, right, top, bottom: the room round its plot, points.
struct Block {
  geom::Box shown;  ///< World.
  double exaggeration = 1.0;
  double left = 0.0;
  double right = 0.0;
  double top = 0.0;
  double bottom = 0.0;
  double plot_width = 0.0;
  double plot_height = 0.0;
  View view;
  Furniture title;
  Furniture x_title;
  Furniture y_title;
  std::vector<Scale> bars;  ///< At its right; empty if all panels share theirs.
  double bars_width = 0.0;
  std::vector<Tick> x_ticks;
  std::vector<Tick> y_ticks;
  [[nodiscard]] double width() const { return left + plot_width + right; }
  [[nodiscard]] double height() const { return top + plot_height + bottom; }
};

class Arranger {
 public:
  Arranger(const Picture& picture, const PageSize& page, std::span<const std::optional<View>> views,
           const TextMeasure& measure, const LayoutOptions& options);

  void arrange();
  [[nodiscard]] Layout place() const;
  /// The size of all that is drawn, with margins.
  [[nodiscard]] PageSize content() const;

 private:
  [[nodiscard]] std::size_t rows() const { return (blocks_.size() + columns_ - 1) / columns_; }
  /// The greatest of `size` in each column, or in each row.
  [[nodiscard]] std::vector<double> in_columns(double (Block::*size)() const) const;
  [[nodiscard]] std::vector<double> in_rows(double (Block::*size)() const) const;
  [[nodiscard]] std::size_t best_columns() const;
  void settle();
  [[nodiscard]] double bars_width(const std::vector<Scale>& bars, double height) const;
  [[nodiscard]] double bars_width() const { return bars_width(scales_, bar_height()); }
  [[nodiscard]] double bars_title(const std::vector<Scale>& bars) const;
  [[nodiscard]] double bar_height() const;
  [[nodiscard]] double header() const { return title_.height > 0.0 ? title_.height + 8.0 : 0.0; }
  [[nodiscard]] double footer() const;
  [[nodiscard]] double panels_width() const;
  [[nodiscard]] double panels_height() const;
  void align_rooms();
  void size_plots_to_content();
  bool make_room_for_names(double scale);
  void size_plots_to_page();
  [[nodiscard]] double scale_that_fits(double width, double height) const;
  bool update_rooms();
  bool update_room(std::size_t i);
  void update_bottom(const PageSize& room);
  void place_panel(std::size_t i, geom::Point corner, Layout& made) const;
  void place_bars(const std::vector<Scale>& bars, double height, geom::Point corner, Layout& made) const;
  void place_footer(double y, Layout& made) const;
  static void put(const Furniture& furniture, geom::Point corner, std::vector<Mark>& marks);

  const Picture& picture_;
  PageSize page_;
  std::span<const std::optional<View>> views_;
  const TextMeasure& measure_;
  LayoutOptions options_;
  Font axis_font_;
  Font tick_font_;
  std::vector<Block> blocks_;  ///< Row by row.
  std::size_t columns_ = 1;
  std::vector<Scale> scales_;  ///< At the right of all panels, where all have the same; else those of each are beside it.
  Furniture title_;
  Furniture legend_;
  Furniture scale_bar_;
  Furniture tables_;  ///< With the notes; empty in windows.
  double bar_title_height_ = 0.0;
};

Arranger::Arranger(const Picture& picture, const PageSize& page, std::span<const std::optional<View>> views,
                   const TextMeasure& measure, const LayoutOptions& options)
    : picture_(picture),
      page_(page),
      views_(views),
      measure_(measure),
      options_(options),
      axis_font_{options.text_size, Weight::Regular},
      tick_font_{options.text_size - 1.0, Weight::Regular} {
  title_ = heading(picture.title, page.width - 2.0 * options.margin, {options.text_size + 4.0, Weight::Bold}, measure);
  for (std::size_t i = 0; i < picture.panels.size(); ++i) {
    const Panel& panel = picture.panels[i];
    Block block;
    const bool viewed = i < views.size() && views[i].has_value();
    if (!viewed) block.shown = panel.extent && !panel.extent->empty() ? *panel.extent : comfortable(extent(panel));
    if (!viewed && !(block.shown.width() > 0.0 && block.shown.height() > 0.0)) block.shown = comfortable(block.shown);
    block.exaggeration = panel.vertical_exaggeration;
    block.left = 40.0;
    block.bottom = 30.0;
    block.top = block.right = 4.0;
    blocks_.push_back(std::move(block));
  }
  if (options.plots == Plots::ToContent)
    tables_ = tables_and_notes(picture, page.width - 2.0 * options.margin, tick_font_, measure);
  const std::size_t count = std::max<std::size_t>(blocks_.size(), 1);
  columns_ = picture.arrangement == Arrangement::Column ? 1 : count;
  bool common = true;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    blocks_[i].bars = scales_of(picture.panels[i]);
    if (!blocks_[i].bars.empty() && scales_.empty()) scales_ = blocks_[i].bars;
    common = common && (blocks_[i].bars.empty() || same_scales(blocks_[i].bars, scales_));
  }
  if (!common) scales_.clear();
  for (Block& block : blocks_) {
    if (common) block.bars.clear();
  }
  bar_title_height_ = bars_title(scales_);
}

std::vector<double> Arranger::in_columns(double (Block::*size)() const) const {
  std::vector<double> sizes(std::min(columns_, blocks_.size()), 0.0);
  for (std::size_t i = 0; i < blocks_.size(); ++i) sizes[i % columns_] = std::max(sizes[i % columns_], (blocks_[i].*size)());
  return sizes;
}

std::vector<double> Arranger::in_rows(double (Block::*size)() const) const {
  std::vector<double> sizes(rows(), 0.0);
  for (std::size_t i = 0; i < blocks_.size(); ++i) sizes[i / columns_] = std::max(sizes[i / columns_], (blocks_[i].*size)());
  return sizes;
}

double Arranger::bars_title(const std::vector<Scale>& bars) const {
  double highest = 0.0;
  for (const Scale& scale : bars) {
    double title_height = 0.0;
    color_bar(scale, least_bar, axis_font_, measure_, title_height);
    highest = std::max(highest, title_height);
  }
  return highest;
}

double bar_height_beside(double plot_height) { return std::clamp(plot_height, least_bar, most_bar); }

double Arranger::bar_height() const {
  double height = 0.0;
  for (std::size_t i = 0; i < std::min(columns_, blocks_.size()); ++i) height = std::max(height, blocks_[i].plot_height);
  return bar_height_beside(height);
}

double Arranger::bars_width(const std::vector<Scale>& bars, double height) const {
  double width = 0.0;
  double title_height = 0.0;
  for (const Scale& scale : bars) width += bar_gap + color_bar(scale, height, axis_font_, measure_, title_height).width;
  return width;
}

double Arranger::footer() const {
  const double height = std::max(legend_.height, scale_bar_.height);
  return (height > 0.0 ? height + 12.0 : 0.0) + (tables_.height > 0.0 ? tables_.height + 12.0 : 0.0);
}

/// All sizes and the gaps between them.
double with_gaps(const std::vector<double>& sizes) {
  const double gaps = sizes.empty() ? 0.0 : panel_gap * static_cast<double>(sizes.size() - 1);
  return std::accumulate(sizes.begin(), sizes.end(), gaps);
}

double Arranger::panels_width() const { return with_gaps(in_columns(&Block::width)); }

double Arranger::panels_height() const {
  double height = with_gaps(in_rows(&Block::height));
  if (!scales_.empty()) {
    const double above = blocks_.empty() ? bar_title_height_ : blocks_.front().top;
    height = std::max(height, above + bar_height() + 10.0);
  }
  return height;
}

/// Plots of a row begin at one height, plots of a column at one distance from the left.
void Arranger::align_rooms() {
  std::vector<double> left(columns_, 0.0);
  std::vector<double> top(rows(), 0.0);
  if (!top.empty()) top.front() = bar_title_height_;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    left[i % columns_] = std::max(left[i % columns_], blocks_[i].left);
    top[i / columns_] = std::max(top[i / columns_], blocks_[i].top);
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    blocks_[i].left = left[i % columns_];
    blocks_[i].top = top[i / columns_];
  }
}

/// Something that takes `fixed` points and `growing` world units.
struct Extent {
  double fixed = 0.0;
  double growing = 0.0;
};

/// The largest scale at which the widest of each group together take `room`: Newton's method, from above, on a convex
/// function of straight pieces.
double scale_filling(double room, const std::vector<std::vector<Extent>>& groups) {
  double scale = 1e12;
  for (std::size_t k = 0; k < 16; ++k) {
    Extent sum;
    for (const std::vector<Extent>& group : groups) {
      const auto size = [&](const Extent& e) { return e.fixed + scale * e.growing; };
      const auto widest = std::max_element(group.begin(), group.end(), [&](const auto& a, const auto& b) { return size(a) < size(b); });
      sum.fixed += widest->fixed;
      sum.growing += widest->growing;
    }
    const double next = (room - sum.fixed) / sum.growing;
    if (!(next < scale)) break;
    scale = next;
    if (scale <= 0.0) break;
  }
  return scale;
}

/// The largest points per world unit at which all panels fit; too little room gives the smallest sensible one.
double Arranger::scale_that_fits(double width, double height) const {
  std::vector<std::vector<Extent>> columns(columns_);
  std::vector<std::vector<Extent>> lines(rows());
  double largest = 0.0;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const Block& block = blocks_[i];
    const Extent across{block.left + block.right, block.shown.width()};
    const Extent up{block.top + block.bottom, block.shown.height() * block.exaggeration};
    columns[i % columns_].push_back(across);
    lines[i / columns_].push_back(up);
    largest = std::max({largest, across.growing, up.growing});
  }
  const double gaps = with_gaps(std::vector<double>(columns.size(), 0.0));
  const double scale = std::min(scale_filling(width - bars_width() - gaps, columns),
                                scale_filling(height - with_gaps(std::vector<double>(lines.size(), 0.0)), lines));
  return std::max(scale, options_.least_plot / largest);
}

/// Names beside the ends of lines are as large at every scale: what is shown grows until they are in it, also those
/// that have to stand below others. True if it grew.
bool Arranger::make_room_for_names(double scale) {
  bool grew = false;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (i < views_.size() && views_[i].has_value()) continue;
    geom::Box& shown = blocks_[i].shown;
    const double up = scale * blocks_[i].exaggeration;
    const geom::Box before = shown;
    std::vector<geom::Box> taken;  // page, from the world's origin
    const std::vector<Layer>& layers = picture_.panels[i].layers;
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
      const auto* content = std::get_if<Labels>(&layer->content);
      if (!layer->visible || content == nullptr) continue;
      for (const Label& label : content->labels) {
        if (label.anchor != Anchor::Left && label.anchor != Anchor::Right) continue;
        const TextSize size = measure_(label.text, {layer->style.text_size, Weight::Regular});
        const double width = size.width + label_room;
        if (width / scale > 0.5 * before.width()) continue;  // wider than what it names: it has to stand over that
        const double x = label.anchor == Anchor::Right ? label.at.x * scale : label.at.x * scale - width;
        const double y = -label.at.y * up;
        const double half = 0.5 * size.height() + 1.0;
        taken.push_back(below_others({{x, y - half}, {x + width, y + half}}, taken));
        shown.low.x = std::min(shown.low.x, x / scale);
        shown.high.x = std::max(shown.high.x, (x + width) / scale);
        shown.low.y = std::min(shown.low.y, -(taken.back().high.y + 2.0) / up);
      }
    }
    grew = grew || shown.width() > before.width() * (1.0 + 1e-3) || shown.height() > before.height() * (1.0 + 1e-3);
  }
  return grew;
}

void Arranger::size_plots_to_content() {
  if (blocks_.empty()) return;
  const double width = page_.width - 2.0 * options_.margin;
  const double height = page_.height - 2.0 * options_.margin - header() - footer();
  double scale = picture_.points_per_unit.value_or(scale_that_fits(width, height));
  for (int i = 0; i < most_name_rounds && make_room_for_names(scale); ++i)
    scale = picture_.points_per_unit.value_or(scale_that_fits(width, height));
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    Block& block = blocks_[i];
    const bool viewed = i < views_.size() && views_[i].has_value();
    block.view = viewed ? *views_[i] : View{block.shown.centre(), 1.0 / scale};
    block.plot_width = std::max(block.shown.width() * scale, options_.least_plot);
    block.plot_height = std::max(block.shown.height() * block.exaggeration * scale, options_.least_plot);
  }
}

void Arranger::size_plots_to_page() {
  if (blocks_.empty()) return;
  const double width = page_.width - 2.0 * options_.margin - bars_width();
  const double height = page_.height - 2.0 * options_.margin - header() - footer();
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    Block& block = blocks_[i];
    const auto cell = [](double all, std::size_t count) {
      return (all + panel_gap) / static_cast<double>(count) - panel_gap;
    };
    const double cell_width = cell(width, columns_);
    const double cell_height = cell(height, rows());
    block.plot_width = std::max(cell_width - block.left - block.right, options_.least_plot);
    block.plot_height = std::max(cell_height - block.top - block.bottom, options_.least_plot);
    // A window too narrow for plots and colour bars keeps the plots.
    if (cell_width - block.left - block.right < options_.least_plot && !(scales_.empty() && block.bars.empty())) {
      scales_.clear();
      for (Block& own : blocks_) {
        own.bars.clear();
        own.right -= own.bars_width;
      }
      return size_plots_to_page();
    }
  }
  const auto scale_that_fits_plots = [&] {
    double scale = std::numeric_limits<double>::infinity();
    for (const Block& block : blocks_) {
      if (block.shown.empty()) continue;
      const View whole = fit(block.shown, block.plot_width, block.plot_height, block.exaggeration);
      scale = std::min(scale, 1.0 / whole.world_per_point);
    }
    return scale;
  };
  double scale = scale_that_fits_plots();
  for (int i = 0; i < most_name_rounds && std::isfinite(scale) && make_room_for_names(scale); ++i)
    scale = scale_that_fits_plots();
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    Block& block = blocks_[i];
    const bool viewed = i < views_.size() && views_[i].has_value();
    block.view = viewed ? *views_[i] : View{block.shown.centre(), 1.0 / scale};
  }
}

/// Makes ticks, titles and the room that they need; true if any room had to grow.
bool Arranger::update_room(std::size_t i) {
  Block& block = blocks_[i];
  const Panel& panel = picture_.panels[i];
  const geom::Box plot{{0.0, 0.0}, {block.plot_width, block.plot_height}};
  const Transform transform = transform_of(block.view, plot, block.exaggeration);
  const geom::Box world = transform.to_world(plot);
  const double line = measure_("0", tick_font_).height();
  const auto fit = panel.axes.scale == AxisScale::Log10 ? logarithmic_ticks_that_fit : ticks_that_fit;
  block.x_ticks = fit(world.low.x, world.high.x, block.plot_width, 8.0, 40.0,
                      [&](const std::string& text) { return measure_(text, tick_font_).width; });
  block.y_ticks =
      fit(world.low.y, world.high.y, block.plot_height, 6.0, 26.0, [&](const std::string&) { return line; });
  block.y_title = turned_heading(panel.axes.y_title, block.plot_height, axis_font_, measure_);
  double widest = 0.0;
  for (const Tick& tick : block.y_ticks) widest = std::max(widest, measure_(tick.label, tick_font_).width);
  // In a window the plots must not jump while the view moves: the room for labels goes in steps of four digits.
  const double step = 4.0 * measure_("0", tick_font_).width;
  if (options_.plots == Plots::FillPage) widest = std::ceil(widest / step) * step;
  double left = tick_length + tick_gap + widest + (block.y_title.width > 0.0 ? tick_gap + block.y_title.width : 0.0);
  double right = options_.plots == Plots::FillPage ? 0.5 * step : 2.0;
  for (const Tick& tick : block.x_ticks) {
    const double x = transform.to_page({tick.value, 0.0}).x;
    const double half = 0.5 * measure_(tick.label, tick_font_).width;
    left = std::max(left, half - x);
    right = std::max(right, x + half - block.plot_width);
  }
  std::string x_title = panel.axes.x_title;
  if (block.exaggeration != 1.0) {
    x_title += fmt::format("{}({} {:g}\u00d7)", x_title.empty() ? "" : "   ", base::translated("vertical exaggeration"),
                           block.exaggeration);
  }
  block.bars_width = std::max(block.bars_width, bars_width(block.bars, bar_height_beside(block.plot_height)));
  if (block.bars.empty()) block.bars_width = 0.0;
  const double width = std::max(left + block.plot_width + right, block.width() - block.bars_width);
  block.x_title = heading(x_title, width, axis_font_, measure_);
  block.title = heading(panel.title, width, {options_.text_size + 1.0, Weight::Bold}, measure_);
  double bottom = tick_length + tick_gap + line + (block.x_title.height > 0.0 ? tick_gap : 0.0) + block.x_title.height;
  const double top = std::max({block.title.height + 6.0, 0.5 * line + 1.0, bars_title(block.bars)});
  right = std::max(right, std::max(block.title.width, block.x_title.width) - left - block.plot_width) + block.bars_width;
  if (!block.bars.empty()) bottom = std::max(bottom, bar_height_beside(block.plot_height) + 12.0 - block.plot_height);
  const Block old = block;
  block.left = std::max(block.left, left);
  block.right = std::max(block.right, right);
  block.top = std::max(block.top, top);
  block.bottom = std::max(block.bottom, bottom);
  return block.left > old.left || block.right > old.right || block.top > old.top || block.bottom > old.bottom;
}

bool Arranger::update_rooms() {
  bool grew = false;
  for (std::size_t i = 0; i < blocks_.size(); ++i) grew = update_room(i) || grew;
  align_rooms();
  return grew;
}

/// Legend and scale bar, side by side in the page's width.
void Arranger::update_bottom(const PageSize& room) {
  const double width = room.width - 2.0 * options_.margin;
  scale_bar_ = {};
  bool common = !blocks_.empty();
  for (const Panel& panel : picture_.panels) common = common && panel.axes.scale == AxisScale::Linear;
  for (const Block& block : blocks_) {
    common = common && block.exaggeration == 1.0 && block.view.world_per_point == blocks_.front().view.world_per_point;
  }
  if (common) {
    const std::string unit = unit_of(picture_.panels.front().axes.x_title);
    scale_bar_ = scale_bar(1.0 / blocks_.front().view.world_per_point, unit, axis_font_, measure_);
    if (scale_bar_.width > 0.4 * width) scale_bar_ = {};
  }
  const double beside = scale_bar_.width > 0.0 ? scale_bar_.width + 24.0 : 0.0;
  legend_ = legend(picture_, width - beside, axis_font_, measure_);
  const bool crowded = room.height - legend_.height < 0.6 * room.height;
  if (options_.plots == Plots::FillPage && crowded) legend_ = {};
}

/// As many columns as give the largest scale, in windows the squarest cells: what is shown there must not move the panels.
std::size_t Arranger::best_columns() const {
  std::size_t best = columns_;
  double most = 0.0;
  for (std::size_t columns = blocks_.size(); columns > 0; --columns) {
    if (options_.plots == Plots::FillPage) {
      const double rows = std::ceil(static_cast<double>(blocks_.size()) / static_cast<double>(columns));
      const double aspect = page_.width / static_cast<double>(columns) / (page_.height / rows);
      const double squareness = std::min(aspect, 1.0 / aspect);
      if (squareness > most) best = columns;
      most = std::max(most, squareness);
      continue;
    }
    Arranger trial(*this);
    trial.columns_ = columns;
    trial.settle();
    const PageSize content = trial.content();
    const bool fits = content.height <= page_.height + 0.5 && content.width <= page_.width + 0.5;
    // What does not fit counts only among others that do not.
    const double scale = (fits ? 1.0 : 1e-6) / trial.blocks_.front().view.world_per_point;
    if (scale > 1.02 * most) {
      best = columns;
      most = scale;
    }
  }
  return best;
}

void Arranger::arrange() {
  if (picture_.arrangement == Arrangement::Grid && blocks_.size() > 1) columns_ = best_columns();
  settle();
}

void Arranger::settle() {
  constexpr int at_most = 12;
  for (int i = 0; i < at_most; ++i) {
    if (options_.plots == Plots::FillPage) {
      size_plots_to_page();
    } else {
      size_plots_to_content();
    }
    const double before = footer();
    const bool grew = update_rooms();
    update_bottom(page_);
    // The first round only guesses rooms; start again from what the labels really need.
    if (i == 0) {
      for (Block& block : blocks_) block.left = block.right = block.top = block.bottom = 0.0;
      update_rooms();
      continue;
    }
    if (!grew && footer() == before) return;
  }
}

PageSize Arranger::content() const {
  const double body = panels_width() + bars_width();
  const double foot =
      legend_.width + (scale_bar_.width > 0.0 ? scale_bar_.width + (legend_.width > 0.0 ? 24.0 : 0.0) : 0.0);
  return {std::max({body, foot, title_.width, tables_.width}) + 2.0 * options_.margin,
          header() + panels_height() + footer() + 2.0 * options_.margin};
}

void Arranger::put(const Furniture& furniture, geom::Point corner, std::vector<Mark>& marks) {
  for (const Mark& mark : furniture.marks) marks.push_back(moved(mark, corner - geom::Point{}));
}

void Arranger::place_panel(std::size_t i, geom::Point corner, Layout& made) const {
  const Block& block = blocks_[i];
  const Panel& panel = picture_.panels[i];
  PanelLayout place;
  place.plot.low = corner + geom::Vector{block.left, block.top};
  place.plot.high = place.plot.low + geom::Vector{block.plot_width, block.plot_height};
  place.view = block.view;
  place.transform = transform_of(block.view, place.plot, block.exaggeration);
  made.panels.push_back(place);
  add_labels(panel, place, measure_, made.marks);
  add_axes(place, block.x_ticks, block.y_ticks, tick_font_, measure_, made.marks);

  // Titles stand over the middle of the plot, moved inwards where they would leave the panel.
  const auto centred = [&](double width) {
    const double wanted = place.plot.centre().x - 0.5 * width;
    return std::max(corner.x, std::min(wanted, corner.x + block.width() - block.bars_width - width));
  };
  put(block.title, {centred(block.title.width), place.plot.low.y - block.title.height - 5.0}, made.marks);
  const double x_title_y = place.plot.high.y + tick_length + tick_gap + measure_("0", tick_font_).height() + tick_gap;
  put(block.x_title, {centred(block.x_title.width), x_title_y}, made.marks);
  double widest = 0.0;
  for (const Tick& tick : block.y_ticks) widest = std::max(widest, measure_(tick.label, tick_font_).width);
  const bool fixed = options_.plots == Plots::FillPage;
  const double y_title_x =
      fixed ? corner.x : place.plot.low.x - tick_length - 2.0 * tick_gap - widest - block.y_title.width;
  put(block.y_title, {y_title_x, place.plot.centre().y - 0.5 * block.y_title.height}, made.marks);
  const double bars_x = corner.x + block.width() - block.bars_width;
  place_bars(block.bars, bar_height_beside(block.plot_height), {bars_x, place.plot.low.y}, made);
}

/// Bars side by side, each `height` high from the height of `corner` down.
void Arranger::place_bars(const std::vector<Scale>& bars, double height, geom::Point corner, Layout& made) const {
  for (const Scale& scale : bars) {
    double title_height = 0.0;
    const Furniture bar = color_bar(scale, height, axis_font_, measure_, title_height);
    put(bar, corner + geom::Vector{bar_gap, -title_height}, made.marks);
    corner.x += bar_gap + bar.width;
  }
}

void Arranger::place_footer(double y, Layout& made) const {
  const double between = legend_.width > 0.0 && scale_bar_.width > 0.0 ? 24.0 : 0.0;
  double x = 0.5 * (made.page.width - legend_.width - between - scale_bar_.width);
  put(legend_, {x, y}, made.marks);
  x += legend_.width + between;
  put(scale_bar_, {x, y}, made.marks);
  const double above = std::max(legend_.height, scale_bar_.height);
  put(tables_, {0.5 * (made.page.width - tables_.width), y + (above > 0.0 ? above + 12.0 : 0.0)}, made.marks);
}

Layout Arranger::place() const {
  Layout made;
  const PageSize needed = content();
  const bool fill = options_.plots == Plots::FillPage;
  made.page = fill ? page_ : PageSize{std::max(page_.width, needed.width), std::max(page_.height, needed.height)};
  double y = options_.margin;
  if (!fill) y += 0.5 * (made.page.height - needed.height);
  put(title_, {0.5 * (made.page.width - title_.width), y}, made.marks);
  y += header();
  const double left = 0.5 * (made.page.width - panels_width() - bars_width());
  const std::vector<double> widths = in_columns(&Block::width);
  const std::vector<double> heights = in_rows(&Block::height);
  geom::Point corner{left, y};
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    place_panel(i, corner, made);
    corner.x += widths[i % columns_] + panel_gap;
    if ((i + 1) % columns_ == 0) corner = {left, corner.y + heights[i / columns_] + panel_gap};
  }
  if (!made.panels.empty())
    place_bars(scales_, bar_height(), {left + panels_width(), made.panels.front().plot.low.y}, made);
  place_footer(y + panels_height() + 12.0, made);
  return made;
}

}  // namespace

Layout layout(const Picture& picture, const PageSize& page, std::span<const std::optional<View>> views,
              const TextMeasure& measure, const LayoutOptions& options) {
  DOBRA_CHECK(views.empty() || views.size() == picture.panels.size());
  Arranger arranger(picture, page, views, measure, options);
  arranger.arrange();
  return arranger.place();
}

PageSize suggested_page(const Picture& picture, double width, const TextMeasure& measure,
                        const LayoutOptions& options) {
  constexpr double tallest = 1.4;
  constexpr double blank = 0.97;  // a page that would be emptier than this is made narrower
  PageSize page{width, tallest * width};
  PageSize needed;
  for (int i = 0; i < 3; ++i) {
    Arranger arranger(picture, page, {}, measure, options);
    arranger.arrange();
    needed = arranger.content();
    if (needed.width >= blank * page.width) break;
    page = {std::ceil(needed.width), std::max(page.height, std::ceil(needed.height))};
  }
  return {std::max(std::ceil(needed.width), page.width), std::ceil(needed.height)};
}

}  // namespace dobra::scene
