#pragma once
// Lines and points of a section as JSON, as several commands print them.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "recon/section/section.h"

namespace recon::cli {

/// [[x, z], ...]
nlohmann::ordered_json points_json(const std::vector<geom::Point>& points);

/// {"name", "kind", "piece_of", "points"}; without piece_of where that is empty.
nlohmann::ordered_json piece_json(const std::string& name, const char* kind, const std::string& piece_of,
                                  const std::vector<geom::Point>& points);

/// All lines, polygons and markers of a section.
nlohmann::ordered_json pieces_json(const section::Section& section);

}  // namespace recon::cli
