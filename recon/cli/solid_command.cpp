#include "recon/cli/solid_command.h"

#include <fmt/format.h>

#include "recon/cli/block_document.h"
#include "shared/base/text.h"
#include "shared/cli/placement.h"
#include "shared/cli/solid_command.h"
#include "shared/solid/csg/csg.h"

namespace recon::cli {
namespace {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using dobra::cli::Bodies;
using dobra::cli::Session;

Result<Bodies> units_of_block(Session& session, const std::filesystem::path& file, const std::string& unit,
                              const std::optional<std::string>& matrix, std::vector<base::Finding>& findings) {
  DOBRA_TRY(scenario::Document document, scenario::read_document(file));
  DOBRA_TRY(const block::Block block, block_of(session, std::move(document), LengthSaidBy::Document));
  findings.insert(findings.end(), block.findings.begin(), block.findings.end());
  Bodies bodies;
  std::vector<std::string> known;
  std::size_t rounded = 0;
  for (const block::BlockUnit& of : block.units) {
    known.push_back(of.name);
    if (!unit.empty() && of.name != unit) continue;
    solid::csg::Tree tree = solid::csg::leaf(of.name, of.shape);
    if (matrix) {
      DOBRA_TRY(const solid::Matrix numbers, dobra::cli::parse_matrix(*matrix));
      tree = solid::csg::placed(std::move(tree), numbers);
    }
    DOBRA_TRY(solid::csg::Evaluated made, solid::csg::Evaluator().evaluate(tree));
    rounded += made.rounded;
    bodies.bodies.push_back({of.name, std::move(made.solid)});
  }
  if (bodies.bodies.empty()) {
    return Error{ErrorCode::BadValue,
                 fmt::format("--part: the block has no unit '{}'{}", unit, base::did_you_mean(unit, known)),
                 base::Place{.file = file.string()}};
  }
  const io::lines::Trace& trace = block.trace;
  if (trace.x != 0.0 || trace.y != 0.0 || trace.north != 0.0 || trace.east != 1.0) {
    findings.push_back({"block_coordinates",
                        "the solid stands where its section is drawn, not on the map: x along the section, y along "
                        "strike, z up; --place moves other files there",
                        base::Place{.file = file.string()}});
  }
  if (rounded > 0) {
    findings.push_back({"placed_rounded",
                        fmt::format("points ({}) were rounded to the nearest numbers when they were placed; faces "
                                    "that are no longer plane are cut into triangles",
                                    rounded),
                        base::Place{.file = file.string()}});
  }
  return bodies;
}

}  // namespace

dobra::cli::Command solid_command() {
  return dobra::cli::solid_command({"a section that goes on along strike (.toml)", units_of_block, {}});
}

}  // namespace recon::cli
