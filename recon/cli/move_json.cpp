#include "recon/cli/move_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "recon/cli/geometry_json.h"
#include "recon/core/operations.h"

namespace recon::cli {

namespace {

using Json = nlohmann::ordered_json;

Json moved_json(const std::vector<moving::MovedPiece>& pieces) {
  Json list = Json::array();
  for (const moving::MovedPiece& piece : pieces)
    list.push_back(piece_json(piece.name, piece.kind.c_str(), {}, piece.after.points));
  return list;
}

}  // namespace

std::string move_json(const model::Model& model, Geometry geometry) {
  const moving::Moved& moved = *model.moved;
  const bool forward = moved.params.direction == moving::Direction::Forward;
  Json json = {{"method", method_name(*moved.params.method)},
               {"fault", moved.params.fault},
               {"direction", forward ? "forward" : "restore"},
               {"slip", moved.motion.slip},
               {"blocks", moved.blocks}};
  Json misfits = Json::array();
  for (const moving::Misfit& misfit : moved.misfit) {
    misfits.push_back(
        {{"horizon", misfit.horizon}, {"along", misfit.along}, {"gap", misfit.gap}, {"overlap", misfit.overlap}});
  }
  json["misfit"] = std::move(misfits);
  if (moved.whole_wall) {
    json["gap_area"] = moved.opened.gap;
    json["overlap_area"] = moved.opened.overlap;
  }
  Json figures = Json::object();
  for (const auto& [name, value] : moved.motion.figures) figures[name] = value;
  json["figures"] = std::move(figures);
  if (const auto tip = moved.motion.map.tip()) {
    json["tip"] = {{"before", {tip->before.x, tip->before.y}}, {"after", {tip->after.x, tip->after.y}}};
  }
  json["remarks"] = core::program().remarks_of(dobra::scenario::make_state(model));
  if (geometry == Geometry::Include) {
    json["moved"] = moved_json(moved.pieces);
    json["pieces"] = pieces_json(moved.section);
  }
  return json.dump(2) + '\n';
}

std::string move_table(const model::Model& model) {
  const moving::Moved& moved = *model.moved;
  std::string text = fmt::format("fault {}, {}: slip {:.6g} m\n", moved.params.fault, method_name(*moved.params.method),
                                 moved.motion.slip);
  if (!moved.blocks.empty()) text += fmt::format("blocks moved: {}\n", fmt::join(moved.blocks, ", "));
  text += fmt::format("pieces moved: {}", moved.pieces.size());
  if (moved.whole_wall)
    text += fmt::format("; gap {:.6g} m2, overlap {:.6g} m2 along the fault", moved.opened.gap, moved.opened.overlap);
  text += '\n';
  for (const auto& [name, value] : moved.motion.figures) text += fmt::format("{:<28} {:>14.7g}\n", name, value);
  if (moved.misfit.empty()) return text;
  text += fmt::format("\n{:<28} {:>14} {:>12} {:>12}\n", "horizon", "along [m]", "gap [m]", "overlap [m]");
  for (const moving::Misfit& misfit : moved.misfit) {
    text +=
        fmt::format("{:<28} {:>14.6g} {:>12.6g} {:>12.6g}\n", misfit.horizon, misfit.along, misfit.gap, misfit.overlap);
  }
  return text;
}

}  // namespace recon::cli
