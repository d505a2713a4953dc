#pragma once
// Blocks out of documents, and documents out of their cuts.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "recon/block/cut.h"
#include "shared/cli/session.h"
#include "shared/scenario/document.h"

namespace recon::cli {

/// What the user may say the length along strike by: the command has an option for it, or the document alone has it.
enum class LengthSaidBy : std::uint8_t { Option, Document };

/// The block of the section that a document's input describes, extruded, or of its several sections in space, lofted;
/// `cut` of the input is passed over.
/// @error those of reading, of extrude() and of loft(); MissingKey: no length along strike; BadValue: a bent trace.
base::Result<block::Block> block_of(dobra::cli::Session& session, dobra::scenario::Document document,
                                    LengthSaidBy said_by);

/// The four numbers of `cut`, in metres. @error BadUsage: none, or not four
base::Result<std::vector<double>> trace_of_cut(const dobra::scenario::Document& document);

/// The section as a scenario without steps.
/// @param original  the input that the block was made of; lines keep its colours.
dobra::scenario::Document document_of_cut(const block::BlockCut& cut, const dobra::scenario::Table& original,
                                          const std::vector<double>& trace);
/// The table of colours of the original, as it is seen from another folder.
void take_colours(const dobra::scenario::Table& original, const std::filesystem::path& folder,
                  const std::filesystem::path& to, dobra::scenario::Document& document);

/// What RECON has against it as it stands.
std::optional<base::Finding> flaw_of(dobra::cli::Session& session, const dobra::scenario::Document& document,
                                     const std::filesystem::path& file);

}  // namespace recon::cli
