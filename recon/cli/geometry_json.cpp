#include "recon/cli/geometry_json.h"

namespace recon::cli {

using Json = nlohmann::ordered_json;

Json points_json(const std::vector<geom::Point>& points) {
  Json list = Json::array();
  for (const geom::Point p : points) list.push_back({p.x, p.y});
  return list;
}

Json piece_json(const std::string& name, const char* kind, const std::string& piece_of,
                const std::vector<geom::Point>& points) {
  Json json = {{"name", name}, {"kind", kind}};
  if (!piece_of.empty()) json["piece_of"] = piece_of;
  json["points"] = points_json(points);
  return json;
}

Json pieces_json(const section::Section& section) {
  Json list = Json::array();
  for (const section::Horizon& horizon : section.horizons)
    list.push_back(piece_json(horizon.name, "horizon", horizon.piece_of, horizon.line.points));
  for (const section::SectionLine& line : section.lines)
    list.push_back(piece_json(line.name, kind_name(line.kind), line.piece_of, line.line.points));
  for (const section::Unit& unit : section.units)
    list.push_back(piece_json(unit.name, "unit", unit.piece_of, unit.contour.points));
  for (const section::Marker& marker : section.markers)
    list.push_back(piece_json(marker.name, "marker", {}, marker.points));
  return list;
}

}  // namespace recon::cli
