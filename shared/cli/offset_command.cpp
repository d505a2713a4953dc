#include "shared/cli/offset_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "shared/base/text.h"
#include "shared/cli/offset_report.h"
#include "shared/cli/staging.h"
#include "shared/offset/distances.h"

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
  std::string side = "right";
  std::string join = "mitre";
  std::string ends = "trimmed";
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
const Names<offset::Side> side_names = {{"right", offset::Side::RightOfTravel}, {"left", offset::Side::LeftOfTravel}};
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
        return std::isfinite(*value) && holds(*value) ? std::string() : fmt::format("{} {}", word, rule);
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
  alone(app.add_option("--distance", options.distance, "Distance of the first curve, d")
            ->check(positive)
            ->type_name("D"));
  alone(app.add_option("--count", options.count, "Number of curves; 1 by default")->check(whole)->type_name("N"));
  alone(app.add_option("--factor", options.factor, "F of the distances D_k = F D_(k-1) + d; 1 (equal gaps) by default")
            ->check(positive)
            ->type_name("F"));
}

void add_shape_options(CLI::App& app, Options& options) {
  app.add_option("--side", options.side, "Side of travel: right (default) or left")
      ->check(one_of(side_names))
      ->type_name("NAME");
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
    rule.initial = *options.distance;
    rule.factor = options.factor.value_or(1.0);
    auto distances = offset::distances(rule);
    if (distances) return distances;
    return base::located(distances.error(), base::Place{.item = "--count, --distance, --factor"});
  }
  std::vector<double> distances;
  const std::string& list = *options.distances;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string word = list.substr(begin, end - begin);
    const std::optional<double> value = base::parse_number(word);
    if (!value) return Error{ErrorCode::BadUsage, fmt::format("--distances: '{}' is not a number", word)};
    if (!std::isfinite(*value) || !(*value > 0.0)) {
      return Error{ErrorCode::BadUsage, fmt::format("--distances: {} must be above 0", word)};
    }
    distances.push_back(*value);
    begin = end + 1;
  }
  return distances;
}

Result<offset::OffsetOptions> offset_options(const Options& options) {
  offset::OffsetOptions result;
  result.side = side_names.at(options.side);
  result.join = join_names.at(options.join);
  result.ends = end_names.at(options.ends);
  if (options.untreated) result.treatment = offset::Treatment::Untreated;
  if (options.mitre_limit) {
    if (result.join != offset::Join::Mitre) {
      return Error{ErrorCode::BadUsage,
                   fmt::format("--mitre-limit belongs to --join mitre, not to --join {}; leave one out", options.join)};
    }
    result.mitre_limit = *options.mitre_limit;
  }
  return result;
}

/// Those of the file that --curve means: all of that name, or else the one of that number.
Result<std::vector<io::NamedCurve>> chosen(std::vector<io::NamedCurve> all, const std::optional<std::string>& wanted) {
  if (!wanted) return all;
  std::vector<io::NamedCurve> named;
  std::vector<std::string> names;
  for (const io::NamedCurve& curve : all) {
    names.push_back(curve.name);
    if (curve.name == *wanted) named.push_back(curve);
  }
  if (!named.empty()) return named;
  const std::optional<double> number = base::parse_number(*wanted);
  if (number && *number >= 1.0 && *number <= static_cast<double>(all.size()) && *number == std::floor(*number)) {
    return std::vector<io::NamedCurve>{all[static_cast<std::size_t>(*number) - 1]};
  }
  return Error{ErrorCode::BadUsage, fmt::format("--curve: there is no curve '{}' among the {} of the file{}", *wanted,
                                                all.size(), base::did_you_mean(*wanted, names))};
}

void note_empty(Session& session, const OffsetFamily& family) {
  for (const DrawnOffset& curve : family.curves) {
    if (!curve.lines.empty()) continue;
    session.note(
        fmt::format("{}: nothing remains at distance {}", family.base.name, base::number_text(curve.distance)));
  }
}

/// Rings of one polygon follow each other.
void note_rings(Session& session, const std::vector<io::NamedCurve>& bases) {
  const auto next = std::adjacent_find(
      bases.begin(), bases.end(),
      [](const io::NamedCurve& a, const io::NamedCurve& b) { return a.polygon && a.polygon == b.polygon; });
  if (next == bases.end()) return;
  session.note(
      fmt::format("{}: a polygon of several rings; each ring is a base of its own, whose curves do not mind the others",
                  next->name));
}

/// @param verdict  of the verifier, if the user wants it.
Result<std::vector<OffsetFamily>> families_of(Session& session, const Options& options,
                                              const std::vector<double>& distances,
                                              const offset::OffsetOptions& settings, OffsetVerdict& verdict) {
  DOBRA_TRY(io::Curves read, io::read_curves(options.file));
  for (const std::string& remark : read.remarks) session.note(remark);
  DOBRA_TRY(std::vector<io::NamedCurve> bases, chosen(std::move(read.curves), options.curve));
  note_rings(session, bases);
  const base::Progress progress = session.progress();
  std::vector<OffsetFamily> families;
  const double total = static_cast<double>(bases.size());
  for (io::NamedCurve& base_curve : bases) {
    DOBRA_TRY_VOID(session.check());
    if (options.closed) {
      base_curve.line.closed = true;
      base_curve.line = geom::without_repeated_points(std::move(base_curve.line));
    }
    const double done = static_cast<double>(families.size());
    auto curves =
        offset::offset(base_curve.line, distances, settings, progress.part(done / total, (done + 1.0) / total));
    if (!curves) return base::located(curves.error(), base::Place{.file = options.file, .item = base_curve.name});
    if (options.verify) DOBRA_TRY_VOID(verify_offset(base_curve, settings, *curves, verdict));
    OffsetFamily family{.base = std::move(base_curve), .treatment = settings.treatment, .curves = {}};
    const double tolerance = options.arc_tolerance.value_or(offset::default_arc_tolerance);
    for (const offset::OffsetCurve& curve : *curves) family.curves.push_back(drawn(curve, family.base.line, tolerance));
    families.push_back(std::move(family));
    note_empty(session, families.back());
  }
  return families;
}

Result<void> write_out(Session& session, const std::filesystem::path& out, const std::vector<OffsetFamily>& families) {
  DOBRA_TRY(Staging staging, Staging::open(out.parent_path(), TargetFolder::MustExist));
  if (const auto written = write_offset(families, staging.path(out.filename().string())); !written) {
    return staging.for_user(written.error());
  }
  DOBRA_TRY_VOID(session.check());
  DOBRA_TRY_VOID(staging.commit());
  return {};
}

/// Says what the verifier found; the exit code.
int announce(Session& session, const OffsetVerdict& verdict) {
  for (const std::string& finding : verdict.findings) session.error_line(finding);
  session.note(
      fmt::format("verified {} edges, and {} places where the curves must be: {}", verdict.edges, verdict.samples,
                  verdict.findings.empty() ? "nothing is wrong" : fmt::format("{} findings", verdict.findings.size())));
  return verdict.findings.empty() ? 0 : 1;
}

Result<int> offset_job(Session& session, const Options& options) {
  // Everything about the options first: a wrong one is told before a long file is read.
  DOBRA_TRY(const std::vector<double> distances, distances_of(options));
  DOBRA_TRY(const offset::OffsetOptions settings, offset_options(options));
  if (options.out) DOBRA_TRY_VOID(check_offset_ending(*options.out));
  OffsetVerdict verdict;
  DOBRA_TRY(const std::vector<OffsetFamily> families, families_of(session, options, distances, settings, verdict));
  if (options.out) DOBRA_TRY_VOID(write_out(session, *options.out, families));
  if (session.options.format == OutputFormat::Json) {
    DOBRA_TRY_VOID(print(offset_json(families)));
  } else if (!options.out) {
    DOBRA_TRY_VOID(print(offset_table(families)));
  } else if (session.options.verbosity != Verbosity::Quiet) {
    DOBRA_TRY_VOID(print(options.out->string() + '\n'));
  }
  return options.verify ? announce(session, verdict) : 0;
}

}  // namespace

Command offset_command() {
  return {
      "offset", "Curves parallel to the curves of a file", [](CLI::App& app) -> Job {
        const auto options = std::make_shared<Options>();
        app.add_option("file", options->file,
                       "Curves: .txt .csv .tsv .dat .wkt .geojson .json .dxf .asc .pl .shp .gpkg")
            ->required()
            ->type_name("FILE");
        add_distance_options(app, *options);
        add_shape_options(app, *options);
        app.add_flag("--closed", options->closed, "Take every curve as a closed contour");
        app.add_flag("--verify", options->verify, "Judge the curves independently; exit code 1 if anything is wrong");
        app.add_option("--curve", options->curve, "Only the curve of this name or number; all by default")
            ->type_name("NAME|NUMBER");
        app.add_option("--out", options->out, "File to write: .geojson .wkt .csv .svg .pdf .png")->type_name("FILE");
        return [options](Session& session) { return offset_job(session, *options); };
      }};
}

}  // namespace dobra::cli
