#pragma once
// What `quebra solid` reads of scenarios, and --cut.

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "shared/cli/solid_command.h"
#include "shared/solid/section.h"

namespace quebra::cli {

/// Runs the steps that make parts, and takes one of them.
/// @param part  the last if empty.
/// @error those of the scenario; BadValue if it makes no parts, or none of that name.
dobra::base::Result<dobra::cli::Bodies> part_of_scenario(dobra::cli::Session& session,
                                                         const std::filesystem::path& file, const std::string& part,
                                                         const std::optional<std::string>& matrix,
                                                         std::vector<dobra::base::Finding>& findings);

/// What the section is.
struct CutFigures {
  double area = 0.0;
  std::size_t pieces = 0, holes = 0, curves = 0;
  std::vector<std::string> regions;  ///< Names of materials, sorted, each once.
  dobra::solid::SectionFrame frame;
};
nlohmann::ordered_json json_of(const CutFigures& figures);

/// The section, written to `out` as a scenario if there is one. An empty section writes nothing; a finding says why.
dobra::base::Result<CutFigures> cut_bodies(dobra::cli::Session& session,
                                           const std::vector<dobra::cli::Bodies::Body>& bodies,
                                           const dobra::solid::CutPlane& plane,
                                           const std::optional<std::filesystem::path>& out,
                                           std::vector<dobra::base::Finding>& findings);

}  // namespace quebra::cli
