#pragma once
// How a picture is looked at: what a person sets in the View menu. It changes the view only, never the model.
// Page: docs/user/view.md

#include <QSettings>
#include <QString>
#include <optional>
#include <span>
#include <vector>

#include "shared/base/result.h"
#include "shared/scene/layout.h"

namespace dobra::gui::view {

/// In which the axes, the status bar and what is typed on the canvas are. AsRead: in that of the picture.
enum class Unit { AsRead, Metre, Kilometre, Foot };

/// How panels stand to each other. Overlay: the input, faint, under the result.
enum class Panels { AsFits, Row, Column, Overlay };

enum class Linked { No, Yes };

struct Settings {
  /// How much longer a length along z is drawn than one along x; nothing: what fills the canvas.
  std::optional<double> exaggeration = 1.0;
  Panels panels = Panels::AsFits;
  Linked linked = Linked::No;  ///< Panels pan and zoom together.
  scene::GridLines grid = scene::GridLines::Off;
  scene::Legends legend = scene::Legends::Usual;
  Unit unit = Unit::AsRead;
  friend bool operator==(const Settings&, const Settings&) = default;
};

constexpr double least_exaggeration = 0.01;
constexpr double most_exaggeration = 10000.0;

/// "5", "5x", "2,5×".
/// @error BadValue: no number, or none from least_exaggeration to most_exaggeration; translated.
base::Result<double> exaggeration_from(const QString& typed);
/// "2.5×", with the user's decimal mark.
QString exaggeration_text(double exaggeration);

/// All but the exaggeration is kept from one window to the next.
Settings remembered(const QSettings& kept);
void remember(const Settings& settings, QSettings& kept);

/// What is on axes: the scale of lengths, no diagram.
bool shows_lengths(const scene::Panel& panel);

/// Axes in another unit; those of diagrams, and those in no known unit of length, as they are.
scene::Axes axes_in(const scene::Axes& axes, Unit unit);

/// How the page is laid out by these settings.
scene::LayoutOptions with(const Settings& settings, scene::LayoutOptions options);

/// The exaggeration at which the panels of lengths fill their plots: two digits, at least 1; 1 where there is none.
/// @param plots  one a panel, page units.
double that_fills(std::span<const scene::Panel> panels, std::span<const geom::Box> plots);

}  // namespace dobra::gui::view
