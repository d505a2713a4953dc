#include "shared/io/lines/line_kinds.h"

#include <gtest/gtest.h>

#include "shared/io/formats/line_files.h"

namespace dobra::io::lines {
namespace {

TEST(LineKinds, WordsOfBothLanguagesMeanAKindWhateverTheirCapitalsAccentsAndBlanks) {
  for (const auto& [word, kind] : {std::pair("fault", "fault"),
                                   {"Fault", "fault"},
                                   {"FALHA", "fault"},
                                   {"Falhas", "fault"},
                                   {"thrust_fault", "fault"},
                                   {" Falha de Empurrão ", "fault"},
                                   {"Horizonte", "horizon"},
                                   {"horizontes", "horizon"},
                                   {"BEDS", "horizon"},
                                   {"Pino", "pin"},
                                   {"Pin-Line", "pin"},
                                   {"loose", "loose"},
                                   {"Linha solta", "loose"},
                                   {"Topografia", "topography"},
                                   {"topography", "topography"},
                                   {"Datum", "datum"},
                                   {"Nível de referência", "datum"},
                                   {"erodido", "eroded"},
                                   {"Unidades", "unit"},
                                   {"FORMAÇÃO", "unit"},
                                   {"Limite", "border"},
                                   {"marcadores", "marker"},
                                   {"Marker", "marker"},
                                   {"Crescimento", "growth"},
                                   {"growth strata", "growth"}}) {
    EXPECT_EQ(known_kind(word), std::optional<std::string>(kind)) << word;
  }
  for (const char* word : {"", "Falt", "not a fault", "s", "es", "0", "faultline 3"})
    EXPECT_FALSE(known_kind(word)) << word;
}

TEST(LineKinds, AMisspeltWordIsAnsweredWithTheNearestOrWithAll) {
  EXPECT_NE(kind_hint("Falt").find("'fault'"), std::string::npos);
  EXPECT_NE(kind_hint("horzonte").find("'horizonte'"), std::string::npos);
  EXPECT_NE(kind_hint("qwertyuiop").find("horizon, growth, fault"), std::string::npos);
}

TEST(LineKinds, PatternsFitAsInAShell) {
  for (const auto& [pattern, name] : {std::pair("F*", "F1"),
                                      {"F*", "F"},
                                      {"*", ""},
                                      {"*", "x"},
                                      {"?1", "F1"},
                                      {"*fault*", "a fault here"},
                                      {"a*b*c", "aXbYbZc"},
                                      {"**", "x"},
                                      {"a=b", "a=b"}}) {
    EXPECT_TRUE(fits(pattern, name)) << pattern << ' ' << name;
  }
  for (const auto& [pattern, name] :
       {std::pair("F*", "f1"), {"F", "F1"}, {"?", ""}, {"a*b", "abc"}, {"", "x"}, {"a*bc*d", "abdcd"}}) {
    EXPECT_FALSE(fits(pattern, name)) << pattern << ' ' << name;
  }
}

TEST(LineKinds, ARuleNeedsAPatternAndAKind) {
  EXPECT_EQ(kind_rule("F*=Falha")->kind, "fault");
  EXPECT_EQ(kind_rule("a=b=pin")->pattern, "a=b");
  for (const char* text : {"F*", "=fault", "F*=", "F*=fualt", ""})
    EXPECT_EQ(kind_rule(text).error().code, base::ErrorCode::InvalidOption) << text;
  EXPECT_NE(kind_rule("F*=fualt").error().message.find("did you mean 'fault'"), std::string::npos);
}

TEST(LineKinds, TheFirstRuleThatFitsGoesBeforeTheFileAndOneThatFitsNothingIsTold) {
  formats::LineOptions options;
  options.kinds = {*kind_rule("F1=pin"), *kind_rule("F*=fault"), *kind_rule("G*=datum"), *kind_rule("F1=loose")};
  const auto read = formats::parse_any_lines(
      "x,z,Name,KIND\n0,0,F1,Horizonte\n1,0,F1,Horizonte\n0,1,F2,\n1,1,F2,\n0,2,A,Horizonte\n1,2,A,Horizonte\n",
      "f.csv", options);
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(read->features[0].kind, "pin");
  EXPECT_EQ(read->features[1].kind, "fault");
  EXPECT_EQ(read->features[2].kind, "horizon");
  ASSERT_EQ(read->remarks.size(), 2U);
  EXPECT_NE(read->remarks[0].find("'Horizonte' is taken as 'horizon'"), std::string::npos);
  EXPECT_NE(read->remarks[1].find("no name fits 'G*'"), std::string::npos);
}

TEST(LineKinds, KindsAreThereBeforeRepairsLookForFaults) {
  formats::LineOptions options;
  options.repair.snap = 2.0;
  for (const char* kind : {"fault", "Falha", ""}) {
    options.kinds.clear();
    if (*kind == '\0') options.kinds = {*kind_rule("F=fault")};
    const auto read = formats::parse_any_lines(
        "x,z,name,kind\n0,0,A,\n9,0,A,\n10,5,F," + std::string(kind) + "\n10,-5,F," + kind + "\n", "f.csv", options);
    ASSERT_TRUE(read) << to_string(read.error());
    EXPECT_EQ(read->features[0].parts[0].points.back(), (geom::Point{10, 0})) << kind;
  }
}

}  // namespace
}  // namespace dobra::io::lines
