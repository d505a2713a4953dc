// Pages of nothing but tables: columns of tables from left to right, a table going on in the next column or page.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/base/text.h"
#include "shared/scene/text_table.h"

namespace dobra::scene {
namespace {

constexpr double page_column_gap = 30.0;
constexpr double page_block_gap = 14.0;
constexpr double header_gap = 12.0;
constexpr std::size_t page_least_rows = 4;  ///< A table does not begin where there is room for fewer.

class Flow {
 public:
  Flow(const PageSize& page, const TextMeasure& measure, const LayoutOptions& options)
      : page_(page), measure_(measure), options_(options), font_{options.text_size - 1.0, Weight::Regular} {
    top_ = options.margin + measure("A", {options.text_size + 1.0, Weight::Bold}).height() + header_gap;
    new_page();
  }

  void add(const TextTable& table) {
    for (std::size_t first = 0; first < table.rows.size() || first == 0;) {
      TextTable part{first == 0 ? table.title : fmt::format("{} ({})", table.title, base::translated("continued")),
                     table.columns, table.rows};
      const double width = text_table(part, font_, measure_).width;
      const std::size_t room = rows_that_fit(part);
      if (room < std::min(page_least_rows, table.rows.size() - first) && !(at_.y == top_ && at_.x == options_.margin)) {
        next_column();
        continue;
      }
      if (at_.x + width > page_.width - options_.margin && at_.x > options_.margin) {
        new_page();
        continue;
      }
      const std::size_t end = std::min(first + std::max<std::size_t>(room, 1), table.rows.size());
      part.rows.resize(end);
      const Furniture made = text_table(part, font_, measure_, first);
      for (const Mark& mark : made.marks) pages_.back().marks.push_back(moved(mark, at_ - geom::Point{}));
      at_.y += made.height + page_block_gap;
      column_ = std::max(column_, made.width);
      if (end >= table.rows.size()) return;
      first = end;
      next_column();
    }
  }

  std::vector<Layout> pages(const std::string& title) {
    for (std::size_t i = 0; i < pages_.size(); ++i) {
      // The sheet itself is the first page.
      const std::string number = fmt::format("{} / {}", i + 2, pages_.size() + 1);
      const Font bold{options_.text_size + 1.0, Weight::Bold};
      const double line = options_.margin + 0.5 * measure_("A", bold).height();
      TextMark right = text_mark(number, {0.0, line}, {options_.text_size, Weight::Regular}, measure_);
      right.at.x = page_.width - options_.margin - 0.5 * right.size.width;
      TextMark left = text_mark(title, {0.0, line}, bold, measure_);
      left.at.x = options_.margin + 0.5 * left.size.width;
      pages_[i].marks.emplace_back(std::move(right));
      if (!title.empty()) pages_[i].marks.emplace_back(std::move(left));
    }
    return std::move(pages_);
  }

 private:
  void new_page() {
    pages_.push_back({page_, {}, {}});
    at_ = {options_.margin, top_};
    column_ = 0.0;
  }

  void next_column() {
    at_ = {at_.x + column_ + page_column_gap, top_};
    column_ = 0.0;
    if (at_.x >= page_.width - options_.margin) new_page();
  }

  [[nodiscard]] std::size_t rows_that_fit(const TextTable& table) const {
    TextTable bare{table.title, table.columns, {}};
    const double head = text_table(bare, font_, measure_).height;
    bare.rows.emplace_back();
    const double row = text_table(bare, font_, measure_).height - head;
    return static_cast<std::size_t>(std::max(0.0, std::floor((page_.height - options_.margin - at_.y - head) / row)));
  }

  PageSize page_;
  const TextMeasure& measure_;
  LayoutOptions options_;
  Font font_;
  double top_ = 0.0;
  geom::Point at_;
  double column_ = 0.0;  ///< Width of the widest table in the column.
  std::vector<Layout> pages_;
};

}  // namespace

std::vector<Layout> table_pages(const Picture& picture, const PageSize& page, const TextMeasure& measure,
                                const LayoutOptions& options) {
  if (picture.tables.empty()) return {};
  Flow flow(page, measure, options);
  for (const TextTable& table : picture.tables) flow.add(table);
  return flow.pages(picture.title);
}

}  // namespace dobra::scene
