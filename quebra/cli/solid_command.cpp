#include "quebra/cli/solid_command.h"

#include "quebra/cli/solid_cut.h"

namespace quebra::cli {

dobra::cli::Command solid_command() {
  return dobra::cli::solid_command(
      {"a scenario of solids (.toml)", part_of_scenario,
       [](dobra::cli::Session& session, const std::vector<dobra::cli::Bodies::Body>& bodies,
          const dobra::solid::CutPlane& plane, const std::optional<std::filesystem::path>& out,
          std::vector<dobra::base::Finding>& findings) -> dobra::base::Result<nlohmann::ordered_json> {
         DOBRA_TRY(const CutFigures figures, cut_bodies(session, bodies, plane, out, findings));
         return json_of(figures);
       }});
}

}  // namespace quebra::cli
