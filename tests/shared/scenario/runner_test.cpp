#include "shared/scenario/runner.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/fake_program.h"

namespace dobra::scenario {
namespace {

using base::ErrorCode;

Document document_of(const std::string& body) {
  auto document = parse_document("dobra = 1\nprogram = \"fake\"\n" + body, "f.toml");
  EXPECT_TRUE(document.ok()) << (document ? "" : base::to_string(document.error()));
  return *document;
}

const std::string two_steps =
    "[input]\nnumbers = [1, 2, 4]\n[[step]]\noperation = \"scale\"\nfactor = 3\n[[step]]\noperation = \"scale\"\nname "
    "= \"last\"\nfactor = 0.5\n";

double sum_of(const State& state) { return fake::quantities(state)[0].value; }

TEST(Runner, EachStepWorksOnTheStateBefore) {
  Runner runner(fake::program());
  const scenario::Run run = runner.run(document_of(two_steps));
  ASSERT_TRUE(run.complete());
  ASSERT_EQ(run.states.size(), 3U);
  EXPECT_EQ(sum_of(run.states[0]), 7.0);
  EXPECT_EQ(sum_of(run.states[1]), 21.0);
  EXPECT_EQ(sum_of(run.states[2]), 10.5);
  EXPECT_EQ(runner.computed(), 3U);
}

TEST(Runner, AChangedStepReRunsItselfAndTheLaterOnesOnly) {
  Runner runner(fake::program());
  const Document before = document_of(two_steps);
  runner.run(before);
  Document after = before;
  after.steps[1].params.set("factor", 2.0);
  const scenario::Run changed = runner.run(after);
  EXPECT_EQ(runner.computed(), 1U);
  EXPECT_EQ(sum_of(changed.states[2]), 42.0);
  after.steps[0].params.set("factor", 1.0);
  runner.run(after);
  EXPECT_EQ(runner.computed(), 2U);
  after.input.set("numbers", std::vector<double>{5.0});
  runner.run(after);
  EXPECT_EQ(runner.computed(), 3U);
}

TEST(Runner, ANumberThatIsNotFiniteIsAnErrorOfItsStepAndNamed) {
  Runner runner(fake::program());
  const scenario::Run run = runner.run(document_of(
      "[input]\nnumbers = [1, 2, 4]\n[[step]]\noperation = \"scale\"\nfactor = 1e200\n[[step]]\noperation = "
      "\"scale\"\nname = \"last\"\nfactor = 1e200\n"));
  ASSERT_TRUE(run.error);
  EXPECT_EQ(run.failed_step, 2U);
  EXPECT_EQ(run.states.size(), 2U);
  EXPECT_EQ(base::exit_code(run.error->code), 4);
  EXPECT_NE(run.error->message.find("'" + fake::quantities(run.states[0])[0].name + "' came out as inf"),
            std::string::npos)
      << run.error->message;
}

TEST(Runner, NamesAndCommentsDoNotCountAsChanges) {
  Runner runner(fake::program());
  Document document = document_of(two_steps);
  runner.run(document);
  document.steps[0].name = "renamed";
  document.steps[0].comment = "why";
  document.steps[1].params.set_comment("factor", "half");
  document.title = "another";
  runner.run(document);
  EXPECT_EQ(runner.computed(), 0U);
}

TEST(Runner, UndoAndRedoComputeNothingAndGiveTheSameReport) {
  Runner runner(fake::program());
  const Document before = document_of(two_steps);
  const scenario::Run first = runner.run(before);
  const std::string report = report_json(before, fake::program(), first);
  Document after = before;
  after.steps[0].params.set("factor", 7.0);
  const std::string changed = report_json(after, fake::program(), runner.run(after));
  EXPECT_NE(changed, report);
  const scenario::Run undone = runner.run(before);
  EXPECT_EQ(runner.computed(), 0U);
  EXPECT_EQ(undone.states, first.states);
  EXPECT_EQ(report_json(before, fake::program(), undone), report);
  EXPECT_EQ(report_json(after, fake::program(), runner.run(after)), changed);
  EXPECT_EQ(runner.computed(), 0U);
  Runner fresh(fake::program());
  EXPECT_EQ(report_json(before, fake::program(), fresh.run(before)), report);
}

TEST(Runner, TheNumberOfRememberedStatesIsBounded) {
  Runner runner(fake::program());
  Document document = document_of(two_steps);
  std::weak_ptr<const void> oldest;
  for (int i = 0; i < 100; ++i) {
    document.steps[1].params.set("factor", 1.0 + i);
    const scenario::Run run = runner.run(document);
    EXPECT_EQ(runner.computed(), i == 0 ? 3U : 1U);
    if (i == 0) oldest = run.states[2];
  }
  EXPECT_TRUE(oldest.expired());
  document.steps[1].params.set("factor", 99.0);
  runner.run(document);
  EXPECT_EQ(runner.computed(), 0U);
  document.steps[1].params.set("factor", 1.0);
  runner.run(document);
  EXPECT_EQ(runner.computed(), 1U);
}

TEST(Runner, AFailingStepKeepsTheStatesBeforeAndSaysWhere) {
  Runner runner(fake::program());
  const scenario::Run run =
      runner.run(document_of(two_steps + "[[step]]\noperation = \"fail\"\n[[step]]\noperation = \"scale\"\n"));
  ASSERT_FALSE(run.complete());
  EXPECT_EQ(run.failed_step, 3U);
  EXPECT_EQ(run.states.size(), 3U);
  EXPECT_EQ(base::to_string(*run.error),
            "f.toml:12:1: step 3 (fail): the curve crosses itself; move the point (at 3, 4)");
  EXPECT_EQ(base::exit_code(run.error->code), 4);
}

TEST(Runner, ParametersAreJudgedStepByStepSoThatTheEarlierStatesShow) {
  Runner runner(fake::program());
  Document document = document_of(two_steps);
  document.steps[1].params.set("factor", -1.0);
  const scenario::Run run = runner.run(document);
  ASSERT_FALSE(run.complete());
  EXPECT_EQ(run.states.size(), 2U);
  EXPECT_EQ(run.error->code, ErrorCode::BadValue);
  document.steps[1].operation = "scael";
  EXPECT_EQ(runner.run(document).error->code, ErrorCode::UnknownOperation);
  document.input.set("numbers", true);
  const scenario::Run bad_input = runner.run(document);
  EXPECT_TRUE(bad_input.states.empty());
  EXPECT_EQ(bad_input.failed_step, 0U);
  document.program = "quebra";
  EXPECT_EQ(runner.run(document).error->code, ErrorCode::WrongProgram);
}

TEST(Runner, AChangedFileCountsAsAChangedParameter) {
  const auto folder = std::filesystem::temp_directory_path() / ("dobra_runner_test_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const auto put = [&](const std::string& name, const std::string& text) { std::ofstream(folder / name) << text; };
  put("input.txt", "1\n2\n");
  put("top.txt", "3\n");
  put("more.txt", "10\n");
  Document document = document_of(
      "[input]\nfile = \"input.txt\"\n[[input.horizon]]\nname = \"top\"\nfile = \"top.txt\"\n"
      "[[step]]\noperation = \"import\"\nfile = \"more.txt\"\n[[step]]\noperation = \"scale\"\nfactor = 1\n");
  document.file = folder / "f.toml";
  Runner runner(fake::program());
  EXPECT_EQ(sum_of(runner.run(document).states.back()), 16.0);
  runner.run(document);
  EXPECT_EQ(runner.computed(), 0U);
  put("more.txt", "10\n20\n");
  EXPECT_EQ(sum_of(runner.run(document).states.back()), 36.0);
  EXPECT_EQ(runner.computed(), 2U);
  put("top.txt", "3\n4\n");
  EXPECT_EQ(sum_of(runner.run(document).states.back()), 40.0);
  EXPECT_EQ(runner.computed(), 3U);
  // Same size, another time.
  put("top.txt", "3\n5\n");
  std::filesystem::last_write_time(folder / "top.txt",
                                   std::filesystem::file_time_type::clock::now() + std::chrono::seconds(5));
  EXPECT_EQ(sum_of(runner.run(document).states.back()), 41.0);
  std::filesystem::remove(folder / "more.txt");
  const scenario::Run run = runner.run(document);
  ASSERT_FALSE(run.complete());
  EXPECT_EQ(base::to_string(*run.error), (folder / "more.txt").string() + ": step 1 (import): there is no such file");
  std::filesystem::remove_all(folder);
}

TEST(Runner, ProgressGoesFromZeroToOneAndACancelledRunSaysSo) {
  std::vector<double> fractions;
  const base::CancelToken token;
  Runner runner(fake::program());
  const scenario::Run run = runner.run(
      document_of(two_steps), base::Progress(token, [&](double f, const std::string&) { fractions.push_back(f); }));
  ASSERT_TRUE(run.complete());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.front(), 0.0);
  EXPECT_EQ(fractions.back(), 1.0);
  EXPECT_EQ(std::count(fractions.begin(), fractions.end(), 0.5), 1);  // half of the second of three parts
  token.cancel();
  Runner other(fake::program());
  const scenario::Run cancelled = other.run(document_of(two_steps), base::Progress(token, {}));
  ASSERT_FALSE(cancelled.complete());
  EXPECT_EQ(cancelled.error->code, ErrorCode::Cancelled);
  EXPECT_EQ(base::exit_code(cancelled.error->code), 130);
}

TEST(Runner, ExpectationsAreJudgedByTheLargerToleranceAndByBounds) {
  const auto verdicts_of = [](const std::string& expects) {
    const Document document = document_of(two_steps + expects);
    Runner runner(fake::program());
    return judge(document, fake::program(), runner.run(document));
  };
  const auto one = [&](const std::string& keys) {
    return verdicts_of("[[expect]]\nquantity = \"sum\"\n" + keys).at(0);
  };
  EXPECT_TRUE(one("value = 10.5\n").met);
  EXPECT_TRUE(one("value = 10\ntolerance = 0.5\n").met);
  EXPECT_FALSE(one("value = 10\ntolerance = 0.4\n").met);
  EXPECT_TRUE(one("value = 10\ntolerance = 0.4\nrelative_tolerance = 0.06\n").met);
  EXPECT_TRUE(one("value = 21\nstep = 1\n").met);
  EXPECT_TRUE(one("value = 10.5\nstep = \"last\"\n").met);
  EXPECT_TRUE(one("at_least = 10.5\nat_most = 10.5\n").met);
  EXPECT_FALSE(one("at_least = 10.6\n").met);
  const Verdict off = one("value = 10\ntolerance = 0.4\n");
  EXPECT_EQ(off.found, 10.5);
  EXPECT_EQ(off.message, "sum is 10.5 m, expected 10 +- 0.4");
  EXPECT_TRUE(one("value = 21\nfactor = 2\n").met);
  EXPECT_FALSE(one("value = 10.5\nfactor = 2\n").met);
  EXPECT_EQ(one("value = 5\nfactor = -0.5\n").message, "-0.5 * sum is -5.25 m, expected 5 +- 0");
  // Six digits, or as many as tell the verdict.
  EXPECT_EQ(one("value = 10.500000000123\ntolerance = 1e-3\n").message, "sum is 10.5 m, expected 10.5 +- 0.001");
  EXPECT_EQ(one("value = 10.500000000123\n").message, "sum is 10.5 m, expected 10.5000000001 +- 0");
  EXPECT_EQ(one("at_least = 10.5000004\n").message, "sum is 10.5 m, expected at least 10.5000004");
  EXPECT_EQ(one("at_most = 14715897.4567\n").message, "sum is 10.5 m, expected at most 14715897");
  EXPECT_EQ(one("at_most = 123456789012\n").message, "sum is 10.5 m, expected at most 123456789012");
  const Verdict rate = one("value = 1\nrate_from = 1\n");
  EXPECT_FALSE(rate.met || rate.found);
  EXPECT_EQ(rate.message, "there is no quantity 'unknowns'") << "what the size of the elements would follow from";
  const Verdict unknown = verdicts_of("[[expect]]\nquantity = \"summ\"\nvalue = 1\n").at(0);
  EXPECT_FALSE(unknown.met);
  EXPECT_FALSE(unknown.found);
  EXPECT_EQ(unknown.message, "there is no quantity 'summ'; did you mean 'sum'?");
}

TEST(Runner, TheReportHoldsEffectiveValuesQuantitiesTablesRemarksAndVerdicts) {
  const Document document = document_of("title = \"A \\u00e9\"\n" + two_steps +
                                        "reverse = true\n[[expect]]\nquantity = \"sum\"\nvalue = 10.5\n");
  Runner runner(fake::program());
  const auto report = nlohmann::json::parse(report_json(document, fake::program(), runner.run(document)));
  EXPECT_EQ(report["program"], "fake");
  EXPECT_EQ(report["input"]["values"]["numbers"][2], 4.0);
  EXPECT_EQ(report["input"]["values"]["depth"], "up");
  EXPECT_EQ(report["steps"][0]["values"]["factor"], 3.0);
  EXPECT_EQ(report["steps"][0]["values"]["times"], 1);
  EXPECT_EQ(report["steps"][0]["quantities"]["sum"]["value"], 21.0);
  EXPECT_EQ(report["steps"][0]["remarks"].size(), 0U);
  EXPECT_EQ(report["steps"][1]["remarks"][0], "the numbers were reversed");
  EXPECT_EQ(report["tables"]["numbers"]["rows"][1][1], 3.0);
  EXPECT_EQ(report["expectations"][0]["met"], true);
}

TEST(Runner, TheReportOfTheSavedDocumentIsTheSameBytes) {
  Document document = document_of(two_steps);
  document.steps[0].params.set("pin", geom::Point{0.1, 1.0 / 3.0});
  document.steps[0].params.set("factor", 3.0);
  const auto saved = parse_document(document_text(document), "f.toml");
  ASSERT_TRUE(saved.ok());
  Runner a(fake::program());
  Runner b(fake::program());
  EXPECT_EQ(report_json(document, fake::program(), a.run(document)),
            report_json(*saved, fake::program(), b.run(*saved)));
}

TEST(Runner, WithValueChangesOneValueByItsPath) {
  const Document document =
      document_of("[input]\n[[input.horizon]]\nname = \"top\"\n" + two_steps.substr(two_steps.find("[[step]]")));
  const auto set = [&](const std::string& assignment) { return with_value(document, fake::program(), assignment); };
  EXPECT_EQ(std::get<double>(*set("steps.2.factor=0.4")->steps[1].params.find("factor")), 0.4);
  EXPECT_EQ(std::get<double>(*set("steps.last.factor=0.4")->steps[1].params.find("factor")), 0.4);
  EXPECT_EQ(std::get<std::string>(*set("input.depth=down")->input.find("depth")), "down");
  EXPECT_EQ(std::get<geom::Point>(*set("steps.1.pin=3, 4")->steps[0].params.find("pin")), (geom::Point{3.0, 4.0}));
  const Document renamed = *set("input.horizon.1.name=a=b");
  EXPECT_EQ(std::get<std::string>(*std::get<std::vector<Table>>(*renamed.input.find("horizon"))[0].find("name")),
            "a=b");
}

TEST(Runner, WithValueExplainsWhatIsWrong) {
  const Document document = document_of(two_steps);
  const auto complaint = [&](const std::string& assignment) {
    const auto changed = with_value(document, fake::program(), assignment);
    return changed ? std::string("accepted") : base::to_string(changed.error());
  };
  EXPECT_EQ(complaint("steps.1.factor"), "--set steps.1.factor: write path=value, such as steps.2.distance=0.4");
  EXPECT_EQ(complaint("step.1.factor=2"), "--set step.1.factor=2: unknown path 'step'; did you mean 'steps'?");
  EXPECT_EQ(complaint("steps.9.factor=2"),
            "--set steps.9.factor=2: after 'steps' comes the name or number of one of the 2 steps");
  EXPECT_EQ(
      complaint("steps.lats.factor=2"),
      "--set steps.lats.factor=2: after 'steps' comes the name or number of one of the 2 steps; did you mean 'last'?");
  EXPECT_EQ(complaint("steps.1.facto=2"), "--set steps.1.facto=2: unknown key 'facto'; did you mean 'factor'?");
  EXPECT_EQ(complaint("steps.1.factor=two"), "--set steps.1.factor=two: 'factor' must be a number, found 'two'");
  EXPECT_EQ(complaint("steps.1.factor.x=2"), "--set steps.1.factor.x=2: 'factor' is a value; nothing follows it");
  EXPECT_EQ(complaint("steps.1=2"), "--set steps.1=2: the path ends before a key");
  EXPECT_EQ(complaint("input.horizon.1.name=x").find("after 'horizon' comes a number from 1 to 0") != std::string::npos,
            true);
  EXPECT_EQ(with_value(document, fake::program(), "steps.1.facto=2").error().code, ErrorCode::BadUsage);
  EXPECT_EQ(with_value(document, fake::program(), "steps.1.factor=-2").error().code, ErrorCode::BadValue);
}

}  // namespace
}  // namespace dobra::scenario
