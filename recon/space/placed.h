#pragma once
// The sections of a document that stand in space: [[input.section]] with a file and a trace. Page: docs/user/space.md.

#include <string>
#include <vector>

#include "recon/input/input.h"
#include "shared/base/finding.h"
#include "shared/surf/loft/sections.h"

namespace recon::space {

/// One of them, read as a section of its own.
struct PlacedSection {
  std::string name;
  section::Section section;
  dobra::surf::loft::PlanTrace trace;
};

struct PlacedSections {
  std::vector<PlacedSection> sections;
  std::vector<base::Finding> findings;  ///< section_remark: what reading one remarks; beyond_trace: with the place.
};

/// Files are scenarios of RECON, whose [input] is read, or lines in any format, read as the [input] says (unit, y_axis,
/// ...). The trace is that of the table, else that of the scenario's own [input].
/// @param places  of the tables [[input.section]] in their file, as far as they are known
/// @error BadSection: fewer than two, lines of a single section beside them, a file with [[input.section]] itself, a
/// name
///        twice; MissingKey: no trace; BadValue: a trace that is none; those of read_section; each with the section.
base::Result<PlacedSections> read_placed(const input::SectionInput& input, const dobra::scenario::Context& context,
                                         const base::Progress& progress, const std::vector<base::Place>& places = {});

/// A list x0, y0, x1, y1, ... as a trace. @error BadValue beginning with `key`
base::Result<dobra::surf::loft::PlanTrace> plan_trace(const std::vector<double>& numbers, const std::string& key);

/// Its horizons and faults, pieces by the name of their whole.
dobra::surf::loft::Section lines_of(const PlacedSection& placed);

}  // namespace recon::space
