// Where a result cannot go is told before the work: here before a missing file is looked for.

#include <filesystem>

#include "quebra/cli/analysis_commands.h"
#include "quebra/cli/mesh_command.h"
#include "quebra/core/operations.h"
#include "tests/support/command_line.h"

namespace quebra::cli {
namespace {

std::vector<dobra::cli::Command> commands() {
  std::vector<dobra::cli::Command> all = analysis_commands();
  all.push_back(mesh_command());
  return all;
}

class OutputPlaces : public dobra::test::CommandLine {
 protected:
  OutputPlaces() : CommandLine(core::program(), commands()) {}
};

TEST_F(OutputPlaces, OfMeshesAndAnalysesAreToldBeforeTheWork) {
  const std::string missing = path("missing.toml");
  const std::string file = put("file", "");
  for (const std::string command : {"solve", "adapt", "crack"}) {
    refuses({command, missing, "--line", "0,0,1,1", "--out", path("not/there.csv")}, 4, {"No such file or directory"});
    refuses({command, missing, "--picture", file + "/x.svg"}, 4, {"Not a directory"});
  }
  refuses({"adapt", missing, "--curve", path("not/there.svg")}, 4, {"No such file or directory"});
  for (const std::string option : {"--picture", "--histogram", "--size-field"})
    refuses({"mesh", missing, option, path("not/there.svg")}, 4, {"No such file or directory"});
  std::filesystem::create_directory(path("folder.msh"));
  refuses({"mesh", missing, "--out", path("folder.msh")}, 4, {"folder.msh", "Is a directory"});
  refuses({"validate", "--out", file}, 4, {"Not a directory"});
  refuses({"solve", missing, "--picture", path("x.svg")}, 3, {"missing.toml"});  // a place that is good
}

}  // namespace
}  // namespace quebra::cli
