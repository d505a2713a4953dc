#include "recon/gui/window.h"

#include "recon/core/operations.h"
#include "recon/gui/balance_panel.h"
#include "recon/gui/pin_tool.h"
#include "shared/gui/window_part.h"

namespace recon::gui {

dobra::gui::WindowPart window_part() {
  return {.about = "Restores deformed geological sections.",
          .examples =
              {
                  {"fold.toml", "Fold train", "Five horizons restored to a datum by constant thickness."},
                  {"chain.toml", "Flattened and folded again", "A chain of two restorations, there and back."},
                  {"listric.toml", "Two listric faults", "Normal faults undone by vertical shear, the younger first."},
                  {"thrust.toml", "Thrust with a ramp", "A fault-bend fold moved back along its thrust."},
                  {"cosine.toml", "Cosine fold", "Offset curves of a fold, flattened."},
                  {"space.toml", "Sections in space", "Surfaces through four sections, and a fifth cut and restored."},
                  {"fault_block.toml", "Fault block", "A section carried along strike, cut at an angle, and restored."},
              },
          .tools = {{.name = "pin",
                     .text = "Pin",
                     .help = "Drag the place where the top is held; the restoration follows",
                     .icon = draw_pin,
                     .key = QKeySequence(Qt::Key_N),
                     .make = make_pin_tool}},
          .panels = {{.name = "balance",
                      .title = "Balance",
                      .make = [](const dobra::gui::Desk& desk, QWidget* parent) -> QWidget* {
                        return new BalancePanel(desk, parent);
                      }}}};
}

int run_window(const std::optional<std::filesystem::path>& file, const dobra::gui::WindowOptions& options) {
  return dobra::gui::run_window(core::program(), window_part(), file, options);
}

}  // namespace recon::gui
