#include "shared/scenario/document.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "shared/io/file.h"

namespace dobra::scenario {
namespace {

using base::ErrorCode;

const std::string head = "dobra = 1\nprogram = \"fake\"\n";

Document parsed(const std::string& text) {
  auto document = parse_document(text, "f.toml");
  EXPECT_TRUE(document.ok()) << (document ? "" : base::to_string(document.error()));
  return document ? *document : Document{};
}

std::string complaint(const std::string& text) {
  const auto document = parse_document(text, "f.toml");
  return document ? "" : base::to_string(document.error());
}

TEST(Document, EveryPartIsReadInTheWrittenOrder) {
  const Document document = parsed(head + R"(title = "A fold"
[input]
z = 1
a = [1, 2.5]
points = [[0, 0], [1, 2]]
tags = ["x", "y"]
none = []
[[input.horizon]]
name = "top"
[[input.horizon]]
name = "base"
[[step]]
operation = "grid"
name = "first"
distance = 0.4
deep = true
[[expect]]
quantity = "sum"
step = 1
value = 3
tolerance = 0.5
[[expect]]
quantity = "count"
step = "first"
at_least = 1
at_most = 2.5
)");
  EXPECT_EQ(document.program, "fake");
  EXPECT_EQ(document.title, "A fold");
  ASSERT_EQ(document.input.entries().size(), 6U);
  EXPECT_EQ(document.input.entries()[0].key, "z");
  EXPECT_EQ(document.input.entries()[1].key, "a");
  EXPECT_EQ(std::get<std::int64_t>(*document.input.find("z")), 1);
  EXPECT_EQ(std::get<std::vector<double>>(*document.input.find("a")), (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(std::get<Points>(*document.input.find("points"))[1], (geom::Point{1.0, 2.0}));
  const auto& horizons = std::get<std::vector<Table>>(*document.input.find("horizon"));
  ASSERT_EQ(horizons.size(), 2U);
  EXPECT_EQ(std::get<std::string>(*horizons[1].find("name")), "base");
  EXPECT_EQ(horizons[1].own_place.line, 12U);
  ASSERT_EQ(document.steps.size(), 1U);
  EXPECT_EQ(document.steps[0].operation, "grid");
  EXPECT_EQ(document.steps[0].name, "first");
  EXPECT_EQ(document.steps[0].params.entries().size(), 2U);
  EXPECT_EQ(document.steps[0].params.place("distance").line, 17U);
  EXPECT_EQ(document.steps[0].place.line, 14U);
  ASSERT_EQ(document.expects.size(), 2U);
  EXPECT_EQ(document.expects[0].step, "1");
  EXPECT_EQ(document.expects[0].value, 3.0);
  EXPECT_EQ(document.expects[1].at_most, 2.5);
  EXPECT_EQ(find_step(document, "first"), 1U);
  EXPECT_EQ(find_step(document, "1"), 1U);
  EXPECT_FALSE(find_step(document, "2"));
  EXPECT_FALSE(find_step(document, ""));
  EXPECT_EQ(step_label(document, 1), "step 1 (grid)");
}

TEST(Document, ErrorsNameFileLineAndColumn) {
  EXPECT_EQ(complaint(head + "titel = \"x\"\n"),
            "f.toml:3:1: unknown key 'titel' at the top of a scenario; did you mean 'title'?");
  EXPECT_EQ(complaint("program = \"fake\"\n"), "f.toml:1: the key 'dobra' is missing; it must be a whole number");
  EXPECT_EQ(complaint("dobra = 1\n"), "f.toml:1: the key 'program' is missing; it must be a text in quotes");
  EXPECT_EQ(complaint("dobra = 2\nprogram = \"fake\"\n"),
            "f.toml:1:1: format version 2 is not known to this program, which reads versions 1 to 1");
  EXPECT_EQ(complaint(head + "[step]\noperation = \"x\"\n"),
            "f.toml:3:1: there can be several; write [[step]] with double brackets");
  EXPECT_EQ(complaint(head + "[[input]]\n"), "f.toml:3:1: the input is one table; write [input]");
  EXPECT_EQ(complaint(head + "[[step]]\ndistance = 1\n"),
            "f.toml:3:1: step 1: the key 'operation' is missing; it must be a text in quotes");
  EXPECT_EQ(complaint(head + "[[step]]\noperation = 3\n"),
            "f.toml:4:1: step 1: 'operation' must be a text in quotes, found 3");
  EXPECT_EQ(complaint(head + "[[step]]\noperation = \"a\"\nname = \"12\"\n"),
            "f.toml:5:1: step 1: the name '12' would be taken for a step's number; add a letter");
  EXPECT_EQ(complaint(head + "[[expect]]\nquantity = \"a\"\nvalu = 3\n"),
            "f.toml:5:1: expectation 1: unknown key 'valu'; did you mean 'value'?");
  EXPECT_EQ(complaint(head + "[[expect]]\nquantity = \"a\"\nvalue = nan\n"),
            "f.toml:5:1: expectation 1: 'value' must be a finite number, found nan");
  EXPECT_EQ(complaint(head + "[[expect]]\nquantity = \"a\"\n"),
            "f.toml:3:1: expectation 1: says nothing about the quantity; add value, at_least or at_most");
}

TEST(Document, ValuesThatNoParameterTakesAreRefusedWithAdvice) {
  EXPECT_EQ(complaint(head + "[input]\n[input.grid]\nx = 1\n"),
            "f.toml:4:1: 'grid' is a table inside a table; write its values as keys of their own, or several such "
            "tables under [[input.grid]]");
  EXPECT_EQ(complaint(head + "[input]\nwhen = 2020-01-01\n"),
            "f.toml:4:8: 'when' is a date or time, which no key takes; write a text in quotes");
  EXPECT_EQ(complaint(head + "[input]\np = [[1, 2], [1, 2, 3]]\n"),
            "f.toml:4:14: point 2 of 'p' is not a pair of numbers [x, y]");
  EXPECT_EQ(complaint(head + "[input]\np = [1, \"a\"]\n"),
            "f.toml:4:9: 'p' mixes kinds of values; a list holds only numbers, only points [x, y] or only texts");
  EXPECT_EQ(complaint(head + "[input]\np = [true, false]\n"),
            "f.toml:4:5: 'p' mixes kinds of values; a list holds only numbers, only points [x, y] or only texts");
}

TEST(Document, SyntaxErrorsSayWhereAndWhat) {
  const auto code = [](const std::string& text) { return parse_document(text, "f.toml").error().code; };
  EXPECT_EQ(complaint(head + "[input]\nx = \n").substr(0, 46), "f.toml:4:5: not valid TOML: in key-value pair:");
  for (const std::string bad :
       {"[input\n", "x = 'abc\n", "dobra = 2\n", "x = 99999999999999999999\n", "x = 1e999\n", "\x01", "x = [1,\n2"}) {
    EXPECT_EQ(code(head + bad), ErrorCode::BadSyntax) << bad;
    EXPECT_EQ(complaint(head + bad).find('\n'), std::string::npos) << bad;
    EXPECT_EQ(base::exit_code(code(head + bad)), 3);
  }
  EXPECT_EQ(code(head + "x = " + std::string(100000, '[')), ErrorCode::BadSyntax);
}

TEST(Document, ReadingNamesMissingEmptyAndBinaryFilesAndFolders) {
  const auto folder = std::filesystem::temp_directory_path() / ("dobra_document_test_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const auto put = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
    return folder / name;
  };
  EXPECT_EQ(read_document(folder / "missing.toml").error().code, ErrorCode::FileNotFound);
  EXPECT_EQ(read_document(folder).error().code, ErrorCode::NotAFile);
  EXPECT_EQ(read_document(put("empty.toml", "")).error().code, ErrorCode::EmptyFile);
  EXPECT_EQ(read_document(put("nul.toml", head + std::string(3, '\0'))).error().code, ErrorCode::BadFormat);
  EXPECT_EQ(read_document(put("binary.toml", "\x89PNG\r\n\x1a\n")).error().code, ErrorCode::BadFormat);
  const auto data = read_document(put("section.CSV", "x;z\n0;1\n"));
  EXPECT_EQ(to_string(data.error()).find((folder / "section.CSV").string() + ":1:2: no scenario, which is a .toml"), 0U)
      << to_string(data.error());
  const auto good = read_document(put("good.toml", "\xEF\xBB\xBF" + head));
  ASSERT_TRUE(good.ok());
  EXPECT_EQ(good->folder(), folder);
  ASSERT_TRUE(write_document(*good, folder / "copy.toml").ok());
  EXPECT_EQ(*io::read_bytes(folder / "copy.toml"), head);
  EXPECT_EQ(write_document(*good, "/dev/full").error().code, ErrorCode::CannotWrite);
  std::filesystem::remove_all(folder);
}

TEST(Document, CommentsSurvive) {
  const std::string text = R"(# A title of several lines,
#
#   with an indent
dobra = 1 # behind
program = "fake"

# about the input
[input] # behind the header
# above x
x = 1  # behind x: dó
s = "no # comment"

# detached

# above y
y = [  # dropped
  1.0, 2.0
]
# the top
[[input.horizon]]
name = "top" # its name

# first step
[[step]]
# what it does
operation = "grid"
# k
distance = 2

# why
[[expect]]
quantity = "a"
value = 1
# [[step]]
# operation = "off"
)";
  const Document document = parsed(text);
  EXPECT_EQ(document.comment, "A title of several lines,\n\n  with an indent\nbehind");
  EXPECT_EQ(document.input_comment, "about the input\nbehind the header");
  EXPECT_EQ(document.input.entries()[0].comment, "above x\nbehind x: dó");
  EXPECT_EQ(document.input.entries()[1].comment, "");
  EXPECT_EQ(document.input.entries()[2].comment, "detached\nabove y");
  const auto& horizon = std::get<std::vector<Table>>(*document.input.find("horizon"))[0];
  EXPECT_EQ(horizon.comment, "the top");
  EXPECT_EQ(horizon.entries()[0].comment, "its name");
  EXPECT_EQ(document.steps[0].comment, "first step\nwhat it does");
  EXPECT_EQ(document.steps[0].params.entries()[0].comment, "k");
  EXPECT_EQ(document.expects[0].comment, "why");
  EXPECT_EQ(document.end_comment, "[[step]]\noperation = \"off\"");
  const std::string canonical = document_text(document);
  EXPECT_EQ(document_text(parsed(canonical)), canonical);
  EXPECT_EQ(parsed(canonical).end_comment, document.end_comment);
}

TEST(Document, AnInputOfNestedTablesOnlyKeepsItsComments) {
  const Document document = parsed(head + "# the top\n[[input.horizon]]\nname = \"top\"\n");
  EXPECT_EQ(document.input_comment, "");
  EXPECT_EQ(std::get<std::vector<Table>>(*document.input.find("horizon"))[0].comment, "the top");
}

TEST(Document, TheCanonicalTextIsWhatAUserWouldWrite) {
  Document document;
  document.program = "fake";
  document.title = "A \"fold\"\n";
  document.input.set("file", std::string("top.csv"));
  Table horizon;
  horizon.set("name", std::string("top"));
  horizon.set("points", std::vector<geom::Point>{{0.0, 0.1}, {1e30, -2.5}});
  document.input.set("horizon", std::vector<Table>{horizon});
  document.input.set("count", std::int64_t{3});
  Step step;
  step.operation = "grid";
  step.name = "first";
  step.params.set("pin", geom::Point{1.0, 2.0});
  step.params.set("odd key", true);
  document.steps = {step};
  Expect expect;
  expect.quantity = "sum";
  expect.step = "1";
  expect.value = 2.0;
  expect.relative_tolerance = 1e-9;
  document.expects = {expect};
  EXPECT_EQ(document_text(document), R"(dobra = 1
program = "fake"
title = "A \"fold\"\n"

[input]
file = "top.csv"
count = 3

[[input.horizon]]
name = "top"
points = [[0.0, 0.1], [1e+30, -2.5]]

[[step]]
operation = "grid"
name = "first"
pin = [1.0, 2.0]
"odd key" = true

[[expect]]
quantity = "sum"
step = 1
value = 2.0
relative_tolerance = 1e-09
)");
}

TEST(Document, LongListsAreWrappedBelow120Columns) {
  Document document;
  document.program = "fake";
  std::vector<geom::Point> points;
  for (int i = 0; i < 100; ++i) points.push_back({0.1 * i, 100.0 / 3.0 * i});
  document.input.set("points", points);
  const std::string text = document_text(document);
  std::size_t begin = 0;
  std::size_t lines = 0;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin);
    EXPECT_LE(end - begin, 120U);
    begin = end + 1;
    ++lines;
  }
  EXPECT_LT(lines, 45U);
  EXPECT_EQ(std::get<Points>(*parsed(text).input.find("points")), points);
}

// Random documents: any text, any double, any list, nested tables, comments.

std::string random_text() {
  static const std::vector<std::string> pieces = {"a", "B", "9", " ", "\"", "\\", "\n",   "\t",   "#",
                                                  "]", "[", "=", "'", "é",  "😀",  "\x01", "\x7F", "\r"};
  std::string text;
  const int length = *rc::gen::inRange(0, 8);
  for (int i = 0; i < length; ++i) text += *rc::gen::elementOf(pieces);
  return text;
}

double random_double() {
  const double value = *rc::gen::arbitrary<double>();
  const int kind = *rc::gen::inRange(0, 4);
  return kind == 0 ? std::round(value) : kind == 1 ? value * 1e-300 : value;
}

Value random_value(int depth);

Table random_table(int depth) {
  Table table;
  const int count = *rc::gen::inRange(0, 5);
  for (int i = 0; i < count; ++i) {
    const std::string key = *rc::gen::arbitrary<bool>() ? "key" + std::to_string(i) : random_text();
    if (key == "operation" || key == "name") continue;
    table.set(key, random_value(depth));
    if (!std::holds_alternative<std::vector<Table>>(*table.find(key))) table.set_comment(key, random_text());
  }
  return table;
}

Value random_value(int depth) {
  const auto list = [](auto&& make) {
    std::vector<std::decay_t<decltype(make())>> out;
    const int count = *rc::gen::inRange(0, 40);
    for (int i = 0; i < count; ++i) out.push_back(make());
    return Value(out);
  };
  switch (*rc::gen::inRange(0, depth > 0 ? 9 : 8)) {
    case 0:
      return *rc::gen::arbitrary<bool>();
    case 1:
      return *rc::gen::arbitrary<std::int64_t>();
    case 2:
      return random_double();
    case 3:
      return random_text();
    case 4:
      return geom::Point{random_double(), random_double()};
    case 5:
      return list([] { return random_double(); });
    case 6:
      return list([] { return geom::Point{random_double(), random_double()}; });
    case 7:
      return list([] { return random_text(); });
    default: {
      std::vector<Table> rows;
      const int count = *rc::gen::inRange(0, 3);
      for (int i = 0; i < count; ++i) {
        rows.push_back(random_table(depth - 1));
        rows.back().comment = random_text();
      }
      return rows;
    }
  }
}

RC_GTEST_PROP(Document, ReadWriteReadGivesTheSameBytesAndTheSameValues, ()) {
  Document document;
  document.program = random_text();
  document.title = random_text();
  document.comment = random_text();
  document.input = random_table(2);
  document.input_comment = random_text();
  document.end_comment = random_text();
  const int steps = *rc::gen::inRange(0, 4);
  for (int i = 0; i < steps; ++i) {
    Step step;
    step.operation = random_text();
    step.name = *rc::gen::arbitrary<bool>() ? "s" + std::to_string(i) : "";
    step.params = random_table(1);
    step.comment = random_text();
    document.steps.push_back(step);
  }
  Expect expect;
  expect.quantity = random_text();
  expect.value = random_double();
  expect.tolerance = std::abs(random_double());
  expect.at_most = random_double();
  if (*rc::gen::arbitrary<bool>()) expect.step = "0012";
  if (*rc::gen::arbitrary<bool>()) expect.rate_from = "1";
  expect.factor = random_double();
  expect.name = random_text();
  expect.section = random_text();
  expect.source = random_text();
  expect.note = random_text();
  document.expects.push_back(expect);

  const std::string text = document_text(document);
  const auto read = parse_document(text, "f.toml");
  if (!read) RC_FAIL(base::to_string(read.error()) + "\n" + text);
  const std::string first = document_text(*read);
  const auto again = parse_document(first, "f.toml");
  RC_ASSERT(again.ok());
  RC_ASSERT(document_text(*again) == first);
  RC_ASSERT(read->input == document.input);
  RC_ASSERT(read->title == document.title);
  RC_ASSERT(read->steps.size() == document.steps.size());
  for (std::size_t i = 0; i < document.steps.size(); ++i) {
    RC_ASSERT(read->steps[i].params == document.steps[i].params);
    RC_ASSERT(read->steps[i].operation == document.steps[i].operation);
  }
  const Expect& same = read->expects.at(0);
  RC_ASSERT(same.value == expect.value && same.factor == expect.factor && same.rate_from == expect.rate_from);
  RC_ASSERT(same.name == expect.name && same.section == expect.section);
  RC_ASSERT(same.source == expect.source && same.note == expect.note);
}

}  // namespace
}  // namespace dobra::scenario
