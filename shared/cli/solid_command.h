#pragma once
// The sub-command `solid` that both programs have: solids united, intersected and subtracted exactly, and measured. A
// program says what its scenarios are, and may say what becomes of a section. See docs/user/solids.md.

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "shared/base/finding.h"
#include "shared/cli/cli.h"
#include "shared/solid/section.h"
#include "shared/solid/solid.h"

namespace dobra::cli {

/// Solids side by side, each of one material.
struct Bodies {
  struct Body {
    std::string material;
    solid::Solid solid;
  };
  std::vector<Body> bodies;
};

/// Bodies of a solid tree or block, moved by a matrix where there is one.
/// @param part  which; the last, or all, if empty.
using ReadScenario =
    std::function<base::Result<Bodies>(Session& session, const std::filesystem::path& file, const std::string& part,
                                       const std::optional<std::string>& matrix, std::vector<base::Finding>& findings)>;
/// What --cut prints of the section of bodies, which is written to `out` as a scenario if there is one.
using CutBodies = std::function<base::Result<nlohmann::ordered_json>(
    Session& session, const std::vector<Bodies::Body>& bodies, const solid::CutPlane& plane,
    const std::optional<std::filesystem::path>& out, std::vector<base::Finding>& findings)>;

struct SolidCommand {
  std::string scenario;  ///< What a scenario holds: "a scenario of solids (.toml)".
  ReadScenario read;
  CutBodies cut;  ///< Empty: there is no --cut.
};

/// solid FILE [--unite|--intersect|--subtract B [--place M]]...: applied from left to right; --out writes the result,
/// --json prints its figures, and the findings of a refusal too.
Command solid_command(SolidCommand program);

}  // namespace dobra::cli
