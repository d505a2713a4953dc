#pragma once
// One line of a scenario's [input] out of a data file in any format of lines (shared/io/formats/line_files.h).

#include <string>

#include "recon/input/input.h"
#include "shared/io/formats/line_files.h"

namespace recon::input {

/// The line that `input` names in the file at `path`, in section coordinates: the only one of the file, or the one
/// whose name is `input.feature`; in pieces where several lines of the file have that name. Where there is no line, the
/// contour of a polygon (its first point repeated at the end) or the points of a points feature.
/// @error BadSection: none, one without points, or several to choose from; BadValue: columns; those of read_any_lines.
base::Result<ReadPieces> lines_of_file(const HorizonInput& input, const std::string& path,
                                       const ReadSettings& settings);

/// Gaps of horizons are left for join_horizons(), which knows the faults between their pieces.
void leave_horizons_apart(dobra::io::formats::RepairOptions& repair);

/// All lines of the file at `path`, with their kinds by the rules of `input`.
/// @error BadValue: a rule that is none; those of read_any_lines.
base::Result<dobra::io::formats::LineWork> work_of_file(const LinesInput& input, const std::string& path,
                                                        const ReadSettings& settings);

}  // namespace recon::input
