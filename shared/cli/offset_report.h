#pragma once
// What the command `offset` gives out: JSON, a table, exchange files, a picture.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shared/operations/offset_curves.h"
#include "shared/operations/offset_stages.h"
#include "shared/scene/layer.h"

namespace dobra::cli {

/// {"curves":[{"distance":d,"length":L,"area":A,"dropped":n,"dropped_length":L,"pieces":[{"closed":b,"points":
/// [[x,y],...]}]}],"dropped":n}, one line, every digit; "curve":name comes first in each where there are several
/// families. Without "area" where it is not known. Of areas each contour comes before its holes. Of work that is not
/// done "stage":{"steps":n,"curve":name,"distance":d,"regions":n,"deleted":n} comes last.
std::string offset_json(const std::vector<operations::OffsetFamily>& families,
                        const std::optional<operations::OffsetStage>& stage = std::nullopt);

/// A line a curve: (name,) distance, pieces, points, length, area, and what was left out, if anything was.
std::string offset_table(const std::vector<operations::OffsetFamily>& families);

/// The base thick, offset curves coloured by distance, on one panel with a legend; work that is not done over them.
scene::Picture offset_picture(const std::vector<operations::OffsetFamily>& families,
                              const std::optional<operations::OffsetStage>& stage = std::nullopt);

/// What the name of a file says that it is to be. @error BadUsage for an ending that is not among these.
enum class OffsetFile { Picture, Lines };
base::Result<OffsetFile> offset_file(const std::filesystem::path& file);

/// Writes the format that the ending says. Areas are polygons with holes; everything else is lines, whose last point
/// repeats the first where they are closed. Ids, properties, and the system or unit of the file are kept where the
/// format can.
/// @param remarks  what it cannot.
/// @error those of offset_file; BadUsage (lines and polygons in a Shapefile), NotFinite, CannotWrite.
base::Result<void> write_offset(const std::vector<operations::OffsetFamily>& families,
                                const operations::OffsetOrigin& origin, const std::filesystem::path& file,
                                std::vector<std::string>& remarks);

}  // namespace dobra::cli
