#include "recon/cli/fault_commands.h"

#include "recon/cli/faults_json.h"
#include "recon/cli/one_step.h"
#include "recon/faults/report.h"

namespace recon::cli {

dobra::cli::Command faults_command() {
  return one_step_command("faults", "Cutoffs and displacement along the faults of a section, and its blocks",
                          dobra::scenario::fields_of<faults::FaultsParams>(), faults_json, faults_table);
}

}  // namespace recon::cli
