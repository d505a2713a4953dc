#include "recon/core/input_picture.h"

#include <fmt/format.h>

#include "recon/input/import.h"

namespace recon::core {
namespace {

namespace scene = dobra::scene;

constexpr scene::Color ink{38, 50, 56};

class Drawing {
 public:
  Drawing(const input::ReadSettings& settings, const dobra::scenario::Context& context)
      : settings_(settings), context_(context) {}

  template <class Line>
  void add(const std::vector<Line>& lines) {
    for (const Line& line : lines) {
      const auto read = read_pieces(line, settings_, context_);
      if (!read) continue;
      panel_.layers.push_back({fmt::format("line.{}", panel_.layers.size()),
                               line.name,
                               {.line = ink, .line_width = 1.2},
                               scene::Lines{read->pieces, {}}});
    }
  }
  [[nodiscard]] const scene::Panel& panel() const { return panel_; }

 private:
  const input::ReadSettings& settings_;
  const dobra::scenario::Context& context_;
  scene::Panel panel_{"section", "", {"x [m]", "z [m]"}, {}, 1.0, {}, {}, {}};
};

}  // namespace

void draw_lines(const input::SectionInput& given, const dobra::scenario::Context& context, scene::Picture& picture) {
  const auto settings = input::read_settings(given);
  if (!settings) return;
  std::vector<std::string> remarks;
  const auto read = with_lines_of_files(given, *settings, context, remarks);
  const input::SectionInput& input = read ? *read : given;
  Drawing drawing(*settings, context);
  drawing.add(input.horizons);
  drawing.add(input.faults);
  for (const auto* lines : {&input.units, &input.topographies, &input.borders, &input.loose_lines}) drawing.add(*lines);
  if (!drawing.panel().layers.empty()) picture.panels.push_back(drawing.panel());
}

}  // namespace recon::core
