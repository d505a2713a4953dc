#pragma once
// What `recon restore` prints with --block and --jigsaw. Page: docs/user/restore.md

#include "recon/cli/ledger_json.h"

namespace recon::cli {

/// @pre the model is restored block by block.
std::string blockwise_json(const model::Model& model, Geometry geometry);
std::string blockwise_table(const model::Model& model);

}  // namespace recon::cli
