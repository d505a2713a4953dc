#include "shared/cli/offset_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "shared/base/text.h"
#include "shared/cli/offset_families.h"
#include "shared/cli/staging.h"
#include "shared/offset/offset.h"

namespace dobra::cli {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;

struct Options {
  std::string file;
  std::optional<std::int64_t> count;
  std::optional<double> distance;
  std::optional<double> factor;
  std::optional<std::string> distances;
  std::optional<std::string> side;
  std::optional<std::string> caps;
  std::optional<std::string> pieces;
  bool dissolve = false;
  std::string join = "mitre";
  std::optional<std::string> ends;
  std::optional<double> mitre_limit;
  std::optional<double> arc_tolerance;
  bool untreated = false;
  bool closed = false;
  bool verify = false;
  std::optional<std::string> curve;
  std::optional<std::filesystem::path> out;
};

template <class T>
using Names = std::map<std::string, T>;
const Names<OffsetSide> side_names = {
    {"right", OffsetSide::Right}, {"left", OffsetSide::Left}, {"both", OffsetSide::Both}};
const Names<offset::Cap> cap_names = {
    {"round", offset::Cap::Round}, {"flat", offset::Cap::Flat}, {"square", offset::Cap::Square}};
const Names<offset::Keep> piece_names = {{"longest", offset::Keep::LongestPiece}, {"all", offset::Keep::AllPieces}};
const Names<offset::Join> join_names = {{"mitre", offset::Join::Mitre},
                                        {"bisector", offset::Join::Bisector},
                                        {"round", offset::Join::Round},
                                        {"bevel", offset::Join::Bevel}};
const Names<offset::Ends> end_names = {
    {"paper", offset::Ends::Paper}, {"trimmed", offset::Ends::Trimmed}, {"extended", offset::Ends::Extended}};

template <class T>
CLI::Validator one_of(const Names<T>& names) {
  std::vector<std::string> words;
  for (const auto& [name, value] : names) words.push_back(name);
  return CLI::Validator(
      [words](std::string& word) {
        if (std::find(words.begin(), words.end(), word) != words.end()) return std::string();
        const std::string hint = base::did_you_mean(word, words);
        return fmt::format("unknown '{}'{}", word,
                           hint.empty() ? fmt::format("; give {}", fmt::join(words, ", ")) : hint);
      },
      "");
}

/// A number for which `holds` is true; `rule` says which those are.
CLI::Validator number_that(const std::string& rule, bool (*holds)(double)) {
  return CLI::Validator(
      [rule, holds](std::string& word) {
        const std::optional<double> value = base::parse_number(word);
        if (!value) return fmt::format("'{}' is not a number", word);
        if (!std::isfinite(*value)) return fmt::format("'{}' is not a finite number; it {}", word, rule);
        return holds(*value) ? std::string() : fmt::format("'{}' {}", word, rule);
      },
      "");
}

bool is_positive(double value) { return value > 0.0; }

void add_distance_options(CLI::App& app, Options& options) {
  const auto positive = number_that("must be above 0", is_positive);
  const auto whole = number_that("must be a whole number from 1 to 100000", [](double value) {
    return value >= 1.0 && value <= 100000.0 && value == std::floor(value);
  });
  CLI::Option* const list =
      app.add_option("--distances", options.distances, "Distances from the base, such as 0.5,1,2")->type_name("LIST");
  const auto alone = [list](CLI::Option* option) { option->excludes(list); };
  const auto other_than_zero = number_that("must not be 0", [](double value) { return value != 0.0; });
  alone(app.add_option("--distance", options.distance, "Distance of the first curve, d; below 0 polygons shrink")
            ->check(other_than_zero)
            ->type_name("D"));
  alone(app.add_option("--count", options.count, "Number of curves; 1 by default")->check(whole)->type_name("N"));
  alone(app.add_option("--factor", options.factor, "F of the distances D_k = F D_(k-1) + d; 1 (equal gaps) by default")
            ->check(positive)
            ->type_name("F"));
}

void add_shape_options(CLI::App& app, Options& options) {
  app.add_option("--side", options.side,
                 "Side of travel: right (default; outside of polygons), left, or both as an area")
      ->check(one_of(side_names))
      ->type_name("NAME");
  app.add_option("--caps", options.caps, "With both sides, at the ends of lines: round (default), flat or square")
      ->check(one_of(cap_names))
      ->type_name("NAME");
  app.add_option("--pieces", options.pieces, "Of the pieces of an open curve on one side: longest (default) or all")
      ->check(one_of(piece_names))
      ->type_name("NAME");
  app.add_flag("--dissolve", options.dissolve,
               "Join all areas to one; lines get both sides unless --side says otherwise");
  app.add_option("--join", options.join, "At corners: mitre (default), bisector, round or bevel")
      ->check(one_of(join_names))
      ->type_name("NAME");
  app.add_option("--ends", options.ends, "At open ends: trimmed (default), extended, or paper")
      ->check(one_of(end_names))
      ->type_name("NAME");
  app.add_option("--mitre-limit", options.mitre_limit,
                 "Greatest distance of a mitre from its corner, in D; 4 by default")
      ->check(number_that("must be at least 1", [](double value) { return value >= 1.0; }))
      ->type_name("X");
  app.add_option("--arc-tolerance", options.arc_tolerance,
                 "Greatest distance of a chord from its arc, in D; 0.001 by default")
      ->check(number_that("must be above 0 and at most 0.5", [](double value) { return value > 0.0 && value <= 0.5; }))
      ->type_name("X");
  app.add_flag("--untreated", options.untreated, "Raw normals and bisectors: spurious regions stay");
}

/// The distances that the user asked for.
Result<std::vector<double>> distances_of(const Options& options) {
  if (!options.distances) {
    if (!options.distance) {
      return Error{ErrorCode::BadUsage,
                   "no distance is given; give --distance D (with --count N, --factor F), or --distances a,b,c"};
    }
    offset::DistanceRule rule;
    rule.count = static_cast<std::size_t>(options.count.value_or(1));
    rule.initial = std::abs(*options.distance);
    rule.factor = options.factor.value_or(1.0);
    auto distances = offset::distances(rule);
    if (!distances) return base::located(distances.error(), base::Place{.item = "--count, --distance, --factor"});
    for (double& d : *distances) d = std::copysign(d, *options.distance);
    return distances;
  }
  std::vector<double> distances;
  const std::string& list = *options.distances;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string word = list.substr(begin, end - begin);
    const std::optional<double> value = base::parse_number(word);
    if (!value) return Error{ErrorCode::BadUsage, fmt::format("--distances: '{}' is not a number", word)};
    if (!std::isfinite(*value) || *value == 0.0) {
      return Error{ErrorCode::BadUsage, fmt::format("--distances: {} must be a number other than 0", word)};
    }
    distances.push_back(*value);
    begin = end + 1;
  }
  return distances;
}

Error bad_usage(std::string message) { return {ErrorCode::BadUsage, std::move(message)}; }

/// Options that would have no effect are refused.
Result<void> check_together(const Options& options, const OffsetPlan& plan) {
  const bool both = plan.side == OffsetSide::Both;
  const bool areas = both || options.dissolve;
  if (options.mitre_limit && options.join != "mitre") {
    return bad_usage(
        fmt::format("--mitre-limit belongs to --join mitre, not to --join {}; leave one out", options.join));
  }
  if (options.caps && (!areas || (plan.side && !both)))
    return bad_usage("--caps belongs to --side both; give both, or leave --caps out");
  if (areas && options.ends) return bad_usage("--ends is for curves on one side; with both sides give --caps");
  if (areas && options.pieces) return bad_usage("--pieces is for curves on one side of a line; leave it out");
  if (areas && options.untreated)
    return bad_usage("--untreated curves have no area; leave out --side both and --dissolve");
  const bool negative = std::any_of(plan.distances.begin(), plan.distances.end(), [](double d) { return d < 0.0; });
  if (negative && plan.side) {
    return bad_usage("--distance, --distances: one below 0 says that polygons shrink; it must be above 0 with --side");
  }
  return {};
}

Result<OffsetPlan> plan_of(const Options& options) {
  OffsetPlan plan;
  DOBRA_TRY(plan.distances, distances_of(options));
  if (options.side) plan.side = side_names.at(*options.side);
  plan.curves.join = join_names.at(options.join);
  plan.curves.ends = end_names.at(options.ends.value_or("trimmed"));
  plan.curves.keep = piece_names.at(options.pieces.value_or("longest"));
  if (options.untreated) plan.curves.treatment = offset::Treatment::Untreated;
  plan.curves.mitre_limit = options.mitre_limit.value_or(plan.curves.mitre_limit);
  plan.cap = cap_names.at(options.caps.value_or("round"));
  plan.arc_tolerance = options.arc_tolerance.value_or(plan.arc_tolerance);
  plan.dissolve = options.dissolve ? Dissolve::Yes : Dissolve::No;
  plan.closing = options.closed ? Closing::Closed : Closing::AsGiven;
  plan.verify = options.verify;
  plan.curve = options.curve;
  DOBRA_TRY_VOID(check_together(options, plan));
  return plan;
}

Result<void> write_out(Session& session, const std::filesystem::path& out, const std::vector<OffsetFamily>& families,
                       const OffsetOrigin& origin) {
  DOBRA_TRY(Staging staging, Staging::open(out.parent_path(), TargetFolder::MustExist));
  std::vector<std::string> remarks;
  const auto written = write_offset(families, origin, staging.path(out.filename().string()), remarks);
  if (!written) return staging.for_user(written.error());
  for (const std::string& remark : remarks) session.note(fmt::format("{}: {}", out.string(), remark));
  DOBRA_TRY_VOID(session.check());
  DOBRA_TRY_VOID(staging.commit());
  return {};
}

/// Says what the verifier found, and what it was not asked about; the exit code.
int announce(Session& session, const OffsetVerdict& verdict, const OffsetPlan& plan) {
  for (const std::string& finding : verdict.findings) session.error_line(finding);
  session.note(fmt::format(
      "verified {} edges of {} curves, and {} places where they must be: {}", verdict.edges, verdict.curves,
      verdict.samples,
      verdict.findings.empty() ? "nothing is wrong with them" : fmt::format("{} findings", verdict.findings.size())));
  if (const std::string rest = not_judged(verdict, plan.curves); !rest.empty()) session.note("not judged: " + rest);
  return verdict.findings.empty() ? 0 : 1;
}

Result<int> offset_job(Session& session, const Options& options) {
  // Everything about the options first: a wrong one is told before a long file is read.
  DOBRA_TRY(const OffsetPlan plan, plan_of(options));
  if (options.out) {
    DOBRA_TRY_VOID(check_offset_ending(*options.out));
    DOBRA_TRY_VOID(check_writable(*options.out));
  }
  DOBRA_TRY(const OffsetInput input, offset_input(session, options.file, plan));
  OffsetVerdict verdict;
  DOBRA_TRY(const std::vector<OffsetFamily> families, offset_families(session, options.file, input, plan, verdict));
  DOBRA_TRY_VOID(check_numbers(families));
  if (options.out) DOBRA_TRY_VOID(write_out(session, *options.out, families, input.origin));
  if (session.options.format == OutputFormat::Json) {
    DOBRA_TRY_VOID(print(offset_json(families)));
  } else if (!options.out) {
    DOBRA_TRY_VOID(print(offset_table(families)));
  } else if (session.options.verbosity != Verbosity::Quiet) {
    DOBRA_TRY_VOID(print(options.out->string() + '\n'));
  }
  return options.verify ? announce(session, verdict, plan) : 0;
}

}  // namespace

Command offset_command() {
  return {"offset", "Curves parallel to the curves of a file", [](CLI::App& app) -> Job {
            const auto options = std::make_shared<Options>();
            app.add_option("file", options->file,
                           "Curves: .txt .csv .tsv .dat .wkt .geojson .json .dxf .asc .pl .shp .gpkg")
                ->required()
                ->type_name("FILE");
            add_distance_options(app, *options);
            add_shape_options(app, *options);
            app.add_flag("--closed", options->closed, "Take every curve as a closed contour");
            app.add_flag("--verify", options->verify,
                         "Judge the curves independently; exit code 1 if anything is wrong");
            app.add_option("--curve", options->curve, "Only the curve of this name or number; all by default")
                ->type_name("NAME|NUMBER");
            app.add_option("--out", options->out, "File to write: .geojson .gpkg .shp .dxf .wkt .csv .svg .pdf .png")
                ->type_name("FILE");
            return [options](Session& session) { return offset_job(session, *options); };
          }};
}

}  // namespace dobra::cli
