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

#include "shared/base/check.h"
#include "shared/base/text.h"
#include "shared/scene/decimal_mark.h"
#include "shared/scene/furniture.h"
#include "shared/scene/grid.h"
#include "shared/scene/paper.h"
#include "shared/scene/text_table.h"

namespace dobra::scene {
namespace {

constexpr double least_bar = 90.0;
constexpr double name_margin = 2.0;  // of names within their plot, points
constexpr double names_in_height = 7.0;
// Parts of a sheet's height (of a window's) that legend and tables may take.
constexpr double legend_share = 0.16;
constexpr double table_share = 0.22;
constexpr int most_name_rounds = 8;  // each needs less room than the one before
constexpr double most_bar = 280.0;

/// A panel on its way to the page. left, right, top, bottom: the room round its plot, points.
struct Block {
  geom::Box content;  ///< World: what has to be shown ...
  geom::Box shown;    ///< ... and with the names beside it.
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

double tick_step(const std::vector<Tick>& ticks) { return ticks.size() < 2 ? 0.0 : ticks[1].value - ticks[0].value; }

class Arranger {
 public:
  Arranger(const Picture& picture, const PageSize& page, std::span<const std::optional<View>> views,
           const TextMeasure& measure, const LayoutOptions& options);

  void arrange();
  [[nodiscard]] Layout place() const;
  /// The size of all that is drawn, with margins.
  [[nodiscard]] PageSize content() const;

 private:
  [[nodiscard]] Grid grid() const { return {blocks_.size(), columns_}; }
  /// One a block.
  [[nodiscard]] std::vector<double> widths() const;
  [[nodiscard]] std::vector<double> heights() const;
  [[nodiscard]] double size_to_content(std::size_t columns) const;
  [[nodiscard]] std::size_t best_columns() const;
  void settle();
  [[nodiscard]] ColorBars bars(const std::vector<Scale>& scales, double plot_height) const {
    return color_bars(scales, std::clamp(plot_height, least_bar, most_bar), axis_font_, measure_);
  }
  [[nodiscard]] ColorBars shared_bars() const { return bars(scales_, bar_height()); }
  [[nodiscard]] bool on_paper() const {
    return picture_.paper == Paper::A4Landscape && options_.plots == Plots::ToContent;
  }
  [[nodiscard]] double text_width() const { return page_.width - 2.0 * options_.margin; }
  void make_tables();
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
  [[nodiscard]] double scale_of_page() const;
  bool update_rooms();
  bool update_room(std::size_t i);
  void update_bottom(const PageSize& room);
  [[nodiscard]] bool shares_x_axis(std::size_t i) const;
  [[nodiscard]] Font title_font() const { return {options_.text_size + 1.0, Weight::Bold}; }
  [[nodiscard]] double end_letters_width(const Panel& panel) const;
  void place_panel(std::size_t i, geom::Point corner, Layout& made) const;
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
  std::vector<Scale>
      scales_;  ///< At the right of all panels, where all have the same; else those of each are beside it.
  Furniture title_;
  Furniture legend_;
  Furniture scale_bar_;
  Furniture tables_;  ///< And the notes: empty in windows.
  Furniture notes_;
  bool tables_on_next_pages_ = false;
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
    block.content = block.shown;
    block.exaggeration = panel.vertical_exaggeration;
    block.left = 40.0;
    block.bottom = 30.0;
    block.top = block.right = 4.0;
    blocks_.push_back(std::move(block));
  }
  if (options.plots == Plots::ToContent) make_tables();
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
  bar_title_height_ = shared_bars().title_height;
}

std::vector<double> Arranger::widths() const {
  std::vector<double> sizes;
  for (const Block& block : blocks_) sizes.push_back(block.width());
  return sizes;
}

std::vector<double> Arranger::heights() const {
  std::vector<double> sizes;
  for (const Block& block : blocks_) sizes.push_back(block.height());
  return sizes;
}

/// Tables and notes; on paper they leave the greater part of the page to the plots.
void Arranger::make_tables() {
  const double endless = std::numeric_limits<double>::infinity();
  const Font font{on_paper() ? options_.text_size - 2.0 : options_.text_size - 1.0, Weight::Regular};
  notes_ = notes_of(picture_, text_width(), font, measure_);
  const double most = on_paper() ? table_share * paper_height(page_.width) : endless;
  Tables tables = tables_of(picture_, {text_width(), most}, font, measure_);
  tables_on_next_pages_ = tables.cut && options_.long_tables == LongTables::NextPages;
  if (!tables_on_next_pages_) tables_ = std::move(tables.furniture);
}

double Arranger::bar_height() const {
  double height = 0.0;
  for (std::size_t i = 0; i < std::min(columns_, blocks_.size()); ++i)
    height = std::max(height, blocks_[i].plot_height);
  return std::clamp(height, least_bar, most_bar);
}

double Arranger::footer() const {
  const double height = std::max(legend_.height, scale_bar_.height);
  const auto with_gap = [](double high) { return high > 0.0 ? high + 12.0 : 0.0; };
  return with_gap(height) + with_gap(tables_.height) + with_gap(notes_.height);
}

double Arranger::panels_width() const { return with_gaps(grid().in_columns(widths())); }

double Arranger::panels_height() const {
  double height = with_gaps(grid().in_rows(heights()));
  if (!scales_.empty()) {
    const double above = blocks_.empty() ? bar_title_height_ : blocks_.front().top;
    height = std::max(height, above + bar_height() + 10.0);
  }
  return height;
}

/// Plots of a row begin at one height, plots of a column at one distance from the left.
void Arranger::align_rooms() {
  std::vector<double> left;
  std::vector<double> top;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    left.push_back(blocks_[i].left);
    top.push_back(i < columns_ ? std::max(blocks_[i].top, bar_title_height_) : blocks_[i].top);
  }
  left = grid().in_columns(left);
  top = grid().in_rows(top);
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    blocks_[i].left = left[grid().column_of(i)];
    blocks_[i].top = top[grid().row_of(i)];
  }
}

/// The largest points per world unit at which all panels fit; too little room gives the smallest sensible one.
double Arranger::scale_that_fits(double width, double height) const {
  std::vector<Stretch> across;
  std::vector<Stretch> down;
  double largest = 0.0;
  for (const Block& block : blocks_) {
    across.push_back({block.left + block.right, block.shown.width()});
    down.push_back({block.top + block.bottom, block.shown.height() * block.exaggeration});
    largest = std::max({largest, across.back().growing, down.back().growing});
  }
  const double scale =
      std::min(grid().scale_across(width - shared_bars().all.width, across), grid().scale_down(height, down));
  return std::max(scale, options_.least_plot / largest);
}

/// The scale that the picture asks for, or at which all panels fit: on paper a round one.
double Arranger::scale_of_page() const {
  if (picture_.points_per_unit) return *picture_.points_per_unit;
  const double height = page_.height - 2.0 * options_.margin - header() - footer();
  const double scale = scale_that_fits(text_width(), height);
  return on_paper() ? points_per_metre / round_ratio(scale) : scale;
}

/// Names beside the ends of lines are as large at every scale: what is shown grows to the sides until they are in it,
/// and in height only where it is lower than a few of them. True if it grew.
bool Arranger::make_room_for_names(double scale) {
  bool grew = false;
  const double few = 0.5 * names_in_height * measure_("0", axis_font_).height();
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (i < views_.size() && views_[i].has_value()) continue;
    geom::Box& shown = blocks_[i].shown;
    const geom::Box& content = blocks_[i].content;
    const geom::Box before = shown;
    const Transform transform{{}, {}, scale, scale * blocks_[i].exaggeration};
    const double middle = transform.to_page(content.centre()).y;
    const double half = std::max(0.5 * content.height() * transform.points_per_y + name_margin, few);
    const double widest = 0.5 * content.width() * scale;
    for (const auto& name :
         places_of_names(picture_.panels[i], transform, widest, middle - half, middle + half, measure_)) {
      if (name) shown.add(transform.to_world(name->grown(name_margin)));
    }
    grew = grew || shown.width() > before.width() * (1.0 + 1e-3) || shown.height() > before.height() * (1.0 + 1e-3);
  }
  return grew;
}

void Arranger::size_plots_to_content() {
  if (blocks_.empty()) return;
  double scale = scale_of_page();
  for (int i = 0; i < most_name_rounds && make_room_for_names(scale); ++i) scale = scale_of_page();
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
  const double width = page_.width - 2.0 * options_.margin - shared_bars().all.width;
  const double height = page_.height - 2.0 * options_.margin - header() - footer();
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    Block& block = blocks_[i];
    const auto cell = [](double all, std::size_t count) {
      return (all + panel_gap) / static_cast<double>(count) - panel_gap;
    };
    const double cell_width = cell(width, columns_);
    const double cell_height = cell(height, grid().rows());
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
  const double unit = panel.axes.unit;
  const auto read = [unit](double at, const std::optional<Reading>& reading) {
    return reading ? reading->of(at) : at / unit;
  };
  const std::optional<Reading>&x_reading = panel.axes.x_reading, &y_reading = panel.axes.y_reading;
  const auto [x_low, x_high] = std::minmax({read(world.low.x, x_reading), read(world.high.x, x_reading)});
  const auto [y_low, y_high] = std::minmax({read(world.low.y, y_reading), read(world.high.y, y_reading)});
  block.x_ticks = fit(x_low, x_high, block.plot_width, 8.0, 40.0,
                      [&](const std::string& text) { return measure_(text, tick_font_).width; });
  block.y_ticks = fit(y_low, y_high, block.plot_height, 6.0, 26.0, [&](const std::string&) { return line; });
  if (panel.axes.scale == AxisScale::None) block.x_ticks = block.y_ticks = {};
  const auto place = [unit](std::vector<Tick>& ticks, const std::optional<Reading>& reading) {
    for (Tick& tick : ticks) tick.value = reading ? reading->to_world(tick.value) : tick.value * unit;
  };
  place(block.x_ticks, x_reading);
  place(block.y_ticks, y_reading);
  block.y_title =
      turned_heading(y_reading ? y_reading->title : panel.axes.y_title, block.plot_height, axis_font_, measure_);
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
  std::string x_title = shares_x_axis(i) ? "" : x_reading ? x_reading->title : panel.axes.x_title;
  if (block.exaggeration != 1.0 && panel.axes.scale != AxisScale::Diagram) {
    x_title += fmt::format("{}({} {}\u00d7)", x_title.empty() ? "" : "   ", base::translated("vertical exaggeration"),
                           with_decimal_mark(fmt::format("{:g}", block.exaggeration)));
  }
  const ColorBars own_bars = bars(block.bars, block.plot_height);
  block.bars_width = block.bars.empty() ? 0.0 : std::max(block.bars_width, own_bars.all.width);
  const double width = std::max(left + block.plot_width + right, block.width() - block.bars_width);
  block.x_title = heading(x_title, width, axis_font_, measure_);
  const double ends = end_letters_width(panel);
  block.title = heading(panel.title, std::max(width - 2.0 * ends, 40.0), title_font(), measure_);
  double bottom = tick_length + tick_gap + line + (block.x_title.height > 0.0 ? tick_gap : 0.0) + block.x_title.height;
  const double over = std::max(block.title.height, ends > 0.0 ? measure_("W", title_font()).height() : 0.0);
  const double top = std::max({over + 6.0, 0.5 * line + 1.0, own_bars.title_height});
  right =
      std::max(right, std::max(block.title.width, block.x_title.width) - left - block.plot_width) + block.bars_width;
  if (!block.bars.empty())
    bottom = std::max(bottom, own_bars.all.height - own_bars.title_height + 8.0 - block.plot_height);
  const Block old = block;
  block.left = std::max(block.left, left);
  block.right = std::max(block.right, right);
  block.top = std::max(block.top, top);
  block.bottom = std::max(block.bottom, bottom);
  return block.left > old.left || block.right > old.right || block.top > old.top || block.bottom > old.bottom;
}

/// Room for the wider of the two, with a gap; 0 without any.
double Arranger::end_letters_width(const Panel& panel) const {
  double width = 0.0;
  for (const std::string* text : {&panel.left_end, &panel.right_end}) {
    if (!text->empty()) width = std::max(width, measure_(*text, title_font()).width + 8.0);
  }
  return width;
}

/// Panels over each other on a sheet have the title of their common axis below the last.
bool Arranger::shares_x_axis(std::size_t i) const {
  return on_paper() && columns_ == 1 && i + 1 < blocks_.size() &&
         picture_.panels[i].axes.x_title == picture_.panels[i + 1].axes.x_title && !picture_.panels[i].axes.x_reading &&
         !picture_.panels[i + 1].axes.x_reading;
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
    const Axes& axes = picture_.panels.front().axes;
    const double scale = 1.0 / blocks_.front().view.world_per_point;
    scale_bar_ =
        scale_bar(scale * axes.unit, unit_of(axes.x_title), on_paper() ? ratio_text(scale) : "", axis_font_, measure_);
    if (scale_bar_.width > 0.4 * width) scale_bar_ = {};
  }
  const double beside = scale_bar_.width > 0.0 ? scale_bar_.width + 24.0 : 0.0;
  const bool window = options_.plots == Plots::FillPage;
  const double unlimited = std::numeric_limits<double>::infinity();
  const double most = legend_share * (on_paper() ? paper_height(page_.width) : window ? room.height : unlimited);
  legend_ = {};
  if (options_.legend == Legends::Usual) {
    legend_ = legend(picture_, {width - beside, most}, on_paper() ? tick_font_ : axis_font_, measure_,
                     window ? SmallPrint::No : SmallPrint::Yes);
  } else if (options_.legend == Legends::Compact) {
    legend_ = legend(picture_, {width - beside, 1.0}, tick_font_, measure_, SmallPrint::No);
  }
  if (window && legend_.height > 0.4 * room.height) legend_ = {};
}

/// The scale of the plots where so many columns take the room that they need.
double Arranger::size_to_content(std::size_t columns) const {
  Arranger trial(*this);
  trial.columns_ = columns;
  trial.settle();
  const auto [width, height] = trial.content();
  const bool fits = height <= page_.height + 0.5 && width <= page_.width + 0.5;
  // What does not fit counts only among others that do not.
  return (fits ? 1.0 : 1e-6) / trial.blocks_.front().view.world_per_point;
}

/// As many columns as give the largest scale; those asked for unless others are clearly better.
std::size_t Arranger::best_columns() const {
  std::size_t best = columns_;
  double most = 0.0;
  const double clearly = picture_.arrangement == Arrangement::Grid ? 1.02 : 1.2;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const std::size_t columns = picture_.arrangement == Arrangement::Column ? i + 1 : blocks_.size() - i;
    const double size =
        options_.plots == Plots::FillPage ? size_in_window(picture_.panels, page_, columns) : size_to_content(columns);
    if (size <= clearly * most) continue;
    best = columns;
    most = size;
  }
  return best;
}

void Arranger::arrange() {
  const bool window = options_.plots == Plots::FillPage && have_extents(picture_.panels);
  if (options_.arrangement && *options_.arrangement != Arrangement::Grid) {
    columns_ = *options_.arrangement == Arrangement::Column ? 1 : std::max<std::size_t>(blocks_.size(), 1);
  } else if ((picture_.arrangement == Arrangement::Grid || on_paper() || window) && blocks_.size() > 1) {
    columns_ = best_columns();
  }
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
  const double body = panels_width() + shared_bars().all.width;
  const double foot =
      legend_.width + (scale_bar_.width > 0.0 ? scale_bar_.width + (legend_.width > 0.0 ? 24.0 : 0.0) : 0.0);
  return {std::max({body, foot, title_.width, tables_.width, notes_.width}) + 2.0 * options_.margin,
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
  place.tick_step = {tick_step(block.x_ticks), tick_step(block.y_ticks)};
  made.panels.push_back(place);
  add_labels(panel, place, measure_, made.marks);
  if (options_.grid == GridLines::On) add_grid(place, block.x_ticks, block.y_ticks, made.marks);
  add_axes(place, block.x_ticks, block.y_ticks, tick_font_, measure_, made.marks);

  // Titles stand over the middle of the plot, moved inwards where they would leave the panel.
  const auto centred = [&](double width) {
    const double wanted = place.plot.centre().x - 0.5 * width;
    return std::max(corner.x, std::min(wanted, corner.x + block.width() - block.bars_width - width));
  };
  put(block.title, {centred(block.title.width), place.plot.low.y - block.title.height - 5.0}, made.marks);
  add_end_letters(panel, place.plot, title_font(), measure_, made.marks);
  const double x_title_y = place.plot.high.y + tick_length + tick_gap + measure_("0", tick_font_).height() + tick_gap;
  put(block.x_title, {centred(block.x_title.width), x_title_y}, made.marks);
  double widest = 0.0;
  for (const Tick& tick : block.y_ticks) widest = std::max(widest, measure_(tick.label, tick_font_).width);
  const bool fixed = options_.plots == Plots::FillPage;
  const double y_title_x =
      fixed ? corner.x : place.plot.low.x - tick_length - 2.0 * tick_gap - widest - block.y_title.width;
  put(block.y_title, {y_title_x, place.plot.centre().y - 0.5 * block.y_title.height}, made.marks);
  const ColorBars own_bars = bars(block.bars, block.plot_height);
  put(own_bars.all, {corner.x + block.width() - block.bars_width, place.plot.low.y - own_bars.title_height},
      made.marks);
}

void Arranger::place_footer(double y, Layout& made) const {
  const double between = legend_.width > 0.0 && scale_bar_.width > 0.0 ? 24.0 : 0.0;
  double x = 0.5 * (made.page.width - legend_.width - between - scale_bar_.width);
  put(legend_, {x, y}, made.marks);
  x += legend_.width + between;
  put(scale_bar_, {x, y}, made.marks);
  const auto below = [](double height) { return height > 0.0 ? height + 12.0 : 0.0; };
  y += below(std::max(legend_.height, scale_bar_.height));
  put(tables_, {0.5 * (made.page.width - tables_.width), y}, made.marks);
  y += below(tables_.height);
  put(notes_, {0.5 * (made.page.width - notes_.width), y}, made.marks);
}

Layout Arranger::place() const {
  Layout made;
  made.tables_on_next_pages = tables_on_next_pages_;
  const PageSize needed = content();
  const bool fill = options_.plots == Plots::FillPage;
  made.page = fill ? page_ : PageSize{std::max(page_.width, needed.width), std::max(page_.height, needed.height)};
  double y = options_.margin;
  if (!fill) y += 0.5 * (made.page.height - needed.height);
  put(title_, {0.5 * (made.page.width - title_.width), y}, made.marks);
  y += header();
  const double left = 0.5 * (made.page.width - panels_width() - shared_bars().all.width);
  const std::vector<double> across = grid().in_columns(widths());
  const std::vector<double> down = grid().in_rows(heights());
  geom::Point corner{left, y};
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    place_panel(i, corner, made);
    corner.x += across[grid().column_of(i)] + panel_gap;
    if ((i + 1) % columns_ == 0) corner = {left, corner.y + down[grid().row_of(i)] + panel_gap};
  }
  if (!made.panels.empty())
    put(shared_bars().all, {left + panels_width(), made.panels.front().plot.low.y - bar_title_height_}, made.marks);
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
  if (picture.paper == Paper::A4Landscape) {
    const PageSize paper{width, paper_height(width)};
    Arranger arranger(picture, paper, {}, measure, options);
    arranger.arrange();
    return {width, std::min(paper.height, std::ceil(arranger.content().height))};
  }
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
