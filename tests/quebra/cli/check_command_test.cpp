#include "quebra/cli/check_command.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "quebra/core/operations.h"
#include "tests/support/command_line.h"

namespace quebra::cli {
namespace {

using Json = nlohmann::json;

class CheckCommand : public dobra::test::CommandLine {
 protected:
  CheckCommand() : CommandLine(core::program(), {check_command()}) {}
  /// A square of four triangles round its middle.
  [[nodiscard]] std::string square(const std::string& elements) const {
    return put("square.inp",
               "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n5, 0.5, 0.5\n*ELEMENT, TYPE=CPS3, ELSET=EALL\n" + elements +
                   "*NSET, NSET=corners\n1, 2, 3, 4\n*SURFACE, NAME=base, TYPE=ELEMENT\n1, S1\n*ELSET, "
                   "ELSET=REGION_7\n1, 2, 3, 4\n*ELSET, ELSET=plate\nREGION_7\n");
  }
};

TEST_F(CheckCommand, AnInvertedElementIsAFaultWithItsNumberAndPlace) {
  const auto told = call({"check", square("1, 1, 2, 5\n2, 2, 3, 5\n3, 4, 3, 5\n4, 4, 1, 5\n"), "--json"});
  EXPECT_EQ(told.code, 1) << told.err;
  const Json json = Json::parse(told.out);
  ASSERT_EQ(json["faults"].size(), 1u);
  EXPECT_EQ(json["faults"][0],
            "element 3 of the file: it is inverted: its corners run clockwise, those of most others anticlockwise (at "
            "0.5, 0.8333333333)");
  EXPECT_EQ(json["area"], 1.0);
}

TEST_F(CheckCommand, AClockwiseMeshIsSoundWithARemark) {
  const auto told = call({"check", square("1, 2, 1, 5\n2, 3, 2, 5\n3, 4, 3, 5\n4, 1, 4, 5\n"), "--json"});
  EXPECT_EQ(told.code, 0) << told.err;
  const Json json = Json::parse(told.out);
  EXPECT_TRUE(json["faults"].empty());
  ASSERT_EQ(json["remarks"].size(), 1u);
  EXPECT_NE(json["remarks"][0].get<std::string>().find("4 of 4 elements run clockwise"), std::string::npos);
  EXPECT_NE(told.err.find("4 of 4 elements run clockwise"), std::string::npos);
}

TEST_F(CheckCommand, SetsAreListedWithKindAndCount) {
  const std::string file = square("1, 1, 2, 5\n2, 2, 3, 5\n3, 3, 4, 5\n4, 4, 1, 5\n");
  const auto told = call({"check", file, "--json"});
  EXPECT_EQ(told.code, 0) << told.err;
  const Json sets = Json::array({{{"name", "plate"}, {"kind", "region"}, {"count", 4}},
                                 {{"name", "base"}, {"kind", "sides"}, {"count", 1}},
                                 {{"name", "corners"}, {"kind", "nodes"}, {"count", 4}}});
  EXPECT_EQ(Json::parse(told.out)["sets"], sets);
  const auto plain = call({"check", file});
  EXPECT_NE(plain.out.find("region        4 'plate'\nsides         1 'base'\nnodes         4 'corners'\n"),
            std::string::npos)
      << plain.out;
}

}  // namespace
}  // namespace quebra::cli
