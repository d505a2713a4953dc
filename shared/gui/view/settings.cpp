#include "shared/gui/view/settings.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "shared/base/text.h"
#include "shared/canvas/entry.h"

namespace dobra::gui::view {

namespace {

constexpr const char* panels_key = "view/panels";
constexpr const char* linked_key = "view/linked";
constexpr const char* grid_key = "view/grid";
constexpr const char* legend_key = "view/legend";
constexpr const char* unit_key = "view/unit";

constexpr std::array panels_names{"as_fits", "row", "column", "overlay"};
constexpr std::array legend_names{"usual", "compact", "off"};
constexpr std::array unit_names{"as_read", "m", "km", "ft"};

/// The choice of that name; the first where there is none.
template <class Choice, std::size_t count>
Choice choice_of(const QSettings& kept, const char* key, const std::array<const char*, count>& names) {
  const std::string name = kept.value(key).toString().toStdString();
  const auto at = std::find(names.begin(), names.end(), std::string_view(name));
  return at == names.end() ? Choice{} : static_cast<Choice>(at - names.begin());
}

/// Metres in one of a unit of length.
std::optional<double> metres_in(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, double>, 7> known{
      {{"m", 1.0}, {"km", 1000.0}, {"ft", 0.3048}, {"mm", 1e-3}, {"cm", 1e-2}, {"um", 1e-6}, {"in", 0.0254}}};
  const auto at = std::find_if(known.begin(), known.end(), [&](const auto& each) { return each.first == unit; });
  return at == known.end() ? std::nullopt : std::optional(at->second);
}

struct Bracketed {
  std::string before;  ///< "x ["
  std::string unit;
};
std::optional<Bracketed> bracketed(const std::string& title) {
  const std::size_t open = title.rfind('[');
  if (open == std::string::npos || !title.ends_with(']')) return std::nullopt;
  return Bracketed{title.substr(0, open + 1), title.substr(open + 1, title.size() - open - 2)};
}

}  // namespace

base::Result<double> exaggeration_from(const QString& typed) {
  QString plain = typed.trimmed().toLower();
  for (const QChar sign : {QChar('x'), QChar(0xd7)}) {
    if (plain.endsWith(sign)) plain.chop(1);
  }
  const std::optional<double> value = base::parse_number(plain.trimmed().replace(',', '.').toStdString());
  if (value && *value >= least_exaggeration && *value <= most_exaggeration) return *value;
  return base::Error{base::ErrorCode::BadValue,
                     base::translated("A vertical exaggeration is a number from 0.01 to 10000, such as 5"),
                     {}};
}

QString exaggeration_text(double exaggeration) {
  return QString::fromStdString(canvas::with_decimal_mark(QString::number(exaggeration, 'g', 4).toStdString())) +
         QChar(0xd7);
}

Settings remembered(const QSettings& kept) {
  Settings settings;
  settings.panels = choice_of<Panels>(kept, panels_key, panels_names);
  settings.linked = kept.value(linked_key, false).toBool() ? Linked::Yes : Linked::No;
  settings.grid = kept.value(grid_key, false).toBool() ? scene::GridLines::On : scene::GridLines::Off;
  settings.legend = choice_of<scene::Legends>(kept, legend_key, legend_names);
  settings.unit = choice_of<Unit>(kept, unit_key, unit_names);
  return settings;
}

void remember(const Settings& settings, QSettings& kept) {
  kept.setValue(panels_key, panels_names[static_cast<std::size_t>(settings.panels)]);
  kept.setValue(linked_key, settings.linked == Linked::Yes);
  kept.setValue(grid_key, settings.grid == scene::GridLines::On);
  kept.setValue(legend_key, legend_names[static_cast<std::size_t>(settings.legend)]);
  kept.setValue(unit_key, unit_names[static_cast<std::size_t>(settings.unit)]);
}

bool shows_lengths(const scene::Panel& panel) { return panel.axes.scale == scene::AxisScale::Linear; }

scene::Axes axes_in(const scene::Axes& axes, Unit unit) {
  const auto x = bracketed(axes.x_title);
  const auto y = bracketed(axes.y_title);
  const std::optional<double> before = x ? metres_in(x->unit) : std::nullopt;
  if (unit == Unit::AsRead || axes.scale != scene::AxisScale::Linear || !before || !y || y->unit != x->unit)
    return axes;
  const std::string name = unit_names[static_cast<std::size_t>(unit)];
  if (name == x->unit) return axes;
  scene::Axes made = axes;
  made.x_title = x->before + name + "]";
  made.y_title = y->before + name + "]";
  // Whole numbers of metres stay whole: 1000 / 1.
  made.unit = axes.unit * (*metres_in(name) / *before);
  return made;
}

scene::LayoutOptions with(const Settings& settings, scene::LayoutOptions options) {
  options.arrangement.reset();
  if (settings.panels == Panels::Row) options.arrangement = scene::Arrangement::Row;
  if (settings.panels == Panels::Column) options.arrangement = scene::Arrangement::Column;
  options.grid = settings.grid;
  options.legend = settings.legend;
  return options;
}

double that_fills(std::span<const scene::Panel> panels, std::span<const geom::Box> plots) {
  std::optional<double> least;
  for (std::size_t i = 0; i < std::min(panels.size(), plots.size()); ++i) {
    const std::optional<geom::Box>& extent = panels[i].extent;
    const geom::Box& plot = plots[i];
    if (!shows_lengths(panels[i]) || !extent || extent->empty() || plot.empty()) continue;
    const double filling = (plot.height() / plot.width()) * (extent->width() / extent->height());
    if (std::isfinite(filling) && filling > 0.0) least = std::min(least.value_or(filling), filling);
  }
  if (!least || *least <= 1.0) return 1.0;
  const double digit = std::pow(10.0, std::floor(std::log10(*least)) - 1.0);
  // Divided by a power of ten, the number is the nearest to what is written.
  const double steps = std::floor(*least / digit);
  return std::min(digit < 1.0 ? steps / std::round(1.0 / digit) : steps * digit, most_exaggeration);
}

}  // namespace dobra::gui::view
