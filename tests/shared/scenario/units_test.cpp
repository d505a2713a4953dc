#include "shared/scenario/units.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "shared/base/formula.h"
#include "shared/scenario/document.h"
#include "shared/scenario/program.h"

namespace dobra::scenario {
namespace {

using testing::AllOf;
using testing::HasSubstr;

UnitSystem system_of(const std::string& text) {
  const auto made = UnitSystem::make(text);
  EXPECT_TRUE(made.ok()) << text;
  return made ? *made : UnitSystem{};
}

std::string trouble(const std::string& text) {
  const auto made = UnitSystem::make(text);
  EXPECT_FALSE(made.ok()) << text;
  return made ? "" : made.error().message;
}

TEST(Units, SystemsThatCohereAreTakenInAnyOrder) {
  for (const char* text : {"m, N, Pa", "mm, N, MPa", "m, kN, kPa", "in, lbf, psi", "m, MN, MPa", "mm, kN, GPa",
                           "ft, lbf, psf", "in, kip, ksi"})
    EXPECT_EQ(system_of(text).text(), text);
  EXPECT_EQ(system_of("MPa,mm,N").text(), "mm, N, MPa");
  EXPECT_TRUE(system_of("SI").si());
  EXPECT_FALSE(system_of("m, kN, kPa").si());
}

TEST(Units, WhatDoesNotCohereIsRefusedWithWhatWould) {
  EXPECT_THAT(trouble("mm, N, Pa"),
              AllOf(HasSubstr("N / mm2 is not Pa"), HasSubstr("\"mm, N, MPa\""), HasSubstr("\"m, N, Pa\"")));
  EXPECT_THAT(trouble("m, kN, MPa"), AllOf(HasSubstr("\"m, kN, kPa\""), HasSubstr("\"m, MN, MPa\"")));
  EXPECT_THAT(trouble("in, lbf, ksi"), AllOf(HasSubstr("\"in, lbf, psi\""), HasSubstr("\"in, kip, ksi\"")));
  EXPECT_THAT(trouble("mm, N, Mpa"), HasSubstr("'Mpa' is no unit of length, force or stress; did you mean 'MPa'?"));
  EXPECT_THAT(trouble("mm, cm, MPa"), HasSubstr("mm and cm are of one kind"));
  EXPECT_THAT(trouble("mm, N"), HasSubstr("one of stress"));
  EXPECT_THAT(trouble(""), HasSubstr(" = \"\": "));
}

TEST(Units, FactorsAreThoseOfTheHandbooks) {
  const UnitSystem mm = system_of("mm, N, MPa"), inch = system_of("in, lbf, psi"), kilo = system_of("m, kN, kPa");
  // 1 MPa sqrt(m) = 31.6228 MPa sqrt(mm); 1 ksi sqrt(in) = 1.0988 MPa sqrt(m).
  EXPECT_NEAR(mm.from_si(1e6, "Pa sqrt(m)"), std::sqrt(1000.0), 1e-12);
  EXPECT_NEAR(inch.to_si(1000.0, "Pa sqrt(m)"), 1.0988435e6, 1.0);
  EXPECT_NEAR(inch.to_si(1.0, "Pa"), 6894.757293168, 1e-8);
  EXPECT_NEAR(inch.to_si(1.0, "J"), 0.1129848290276, 1e-12);
  EXPECT_NEAR(mm.to_si(1.0, "J^0.5"), std::sqrt(1e-3), 1e-15);
  EXPECT_EQ(mm.to_si(1.0, "J/m2"), 1000.0);
  EXPECT_EQ(mm.to_si(1.0, "N/m3"), 1e9);
  EXPECT_EQ(mm.from_si(2.0, "m2"), 2e6);
  EXPECT_EQ(kilo.to_si(3.0, "N/m"), 3000.0);
  EXPECT_EQ(mm.to_si(30.0, "deg"), 30.0);
}

TEST(Units, DecimalNumbersInMillimetresAreTheSameBitsAsInMetres) {
  const UnitSystem mm = system_of("mm, N, MPa");
  for (const int i : {1, 3, 7, 49, 333, 1001, 123457})
    EXPECT_EQ(mm.to_si(i, "m"), std::strtod((std::to_string(i) + "e-3").c_str(), nullptr));
  EXPECT_EQ(mm.to_si(210000.0, "Pa"), 2.1e11);
}

TEST(Units, NamesOfDerivedUnitsAreOfTheSystemAndLeadBack) {
  const UnitSystem mm = system_of("mm, N, MPa"), inch = system_of("in, lbf, psi");
  EXPECT_EQ(mm.unit("Pa sqrt(m)"), "MPa sqrt(mm)");
  EXPECT_EQ(mm.unit("J/m2"), "N/mm");
  EXPECT_EQ(mm.unit("J^0.5"), "sqrt(N mm)");
  EXPECT_EQ(inch.unit("N/m3"), "lbf/in3");
  EXPECT_EQ(inch.unit("%"), "%");
  for (const char* si : {"m", "m2", "N", "Pa", "N/m3", "J", "Pa sqrt(m)", "J^0.5", "deg"})
    EXPECT_EQ(mm.si_of(mm.unit(si)), si);
  EXPECT_EQ(UnitSystem().unit("J/m2"), "J/m2");
}

struct Row {
  int kind = 0;
  double x = 0.0;
  std::string x_formula;
  template <class D>
  static void describe(D& d) {
    d.choice("kind", &Row::kind, {"traction", "force"}, {.title = "Kind"});
    d.field("x", &Row::x, {.title = "x", .unit = "Pa, N if kind = force"});
    d.field("x_formula", &Row::x_formula, {.title = "x", .unit = "Pa, N if kind = force"});
  }
};

TEST(Units, AUnitThatGoesByAChoiceGoesByTheTableAndItsDefault) {
  const auto fields = fields_of<Row>();
  const UnitSystem mm = system_of("mm, N, MPa");
  Table traction, force;
  traction.set("x", std::int64_t{3});
  force.set("x", 3.0);
  force.set("kind", std::string("force"));
  EXPECT_EQ(std::get<double>(*in_si(traction, fields, mm).find("x")), 3e6);
  EXPECT_EQ(std::get<double>(*in_si(force, fields, mm).find("x")), 3.0);
  EXPECT_EQ(fields_in(fields, mm)[1].options.unit, "MPa, N if kind = force");
}

TEST(Units, FormulasAreOfTheCoordinatesOfTheScenario) {
  const auto fields = fields_of<Row>();
  const UnitSystem mm = system_of("mm, N, MPa");
  static const std::vector<std::string> names{"x", "y", "nx", "ny"};
  for (const std::string text :
       {"2 * x + exp(y / 1e2) * nx", "x>1.5e1?x^2:-y", "max(x, 1e-3*y)-ny", "hypot(x,y)", "5"}) {
    Table table;
    table.set("x_formula", text);
    const auto there = base::Formula::make(text, names);
    const auto here = base::Formula::make(std::get<std::string>(*in_si(table, fields, mm).find("x_formula")), names);
    ASSERT_TRUE(there.ok() && here.ok()) << text;
    // f in MPa at (20, 50) mm is 1e6 f in Pa at (0.02, 0.05) m.
    const double value = 1e6 * there->at(std::array{20.0, 50.0, 0.6, 0.8});
    EXPECT_NEAR(here->at(std::array{0.02, 0.05, 0.6, 0.8}), value, 1e-12 * std::abs(value)) << text;
  }
  Table wrong;
  wrong.set("x_formula", std::string("2 * z"));
  EXPECT_EQ(std::get<std::string>(*in_si(wrong, fields, mm).find("x_formula")), "2 * z")
      << "whose fault is told as it was written";
}

TEST(Units, MessagesTellLengthsAndPlacesInTheUnitsOfTheScenario) {
  const UnitSystem mm = system_of("mm, N, MPa");
  EXPECT_EQ(message_in_units("tip 'a 5 m (1, 2)' at (0.5, -1e-05) lies 0.25 m from 'b', 3 % of 2e+06 Pa.", mm),
            "tip 'a 5 m (1, 2)' at (500, -0.01) lies 250 mm from 'b', 3 % of 2 MPa.");
  EXPECT_EQ(message_in_units(
                "(0, 1000) N in all; Young's modulus at (1, 2); 7 metres, step 2 (mesh), K is 1e+06 Pa sqrt(m)", mm),
            "(0, 1000) N in all; Young's modulus at (1000, 2000); 7 metres, step 2 (mesh), K is 31.6228 MPa sqrt(mm)");
  EXPECT_EQ(message_in_units("0.1 m", UnitSystem()), "0.1 m");
  EXPECT_EQ(message_in_units("it is short; at (1, -0.5, 2e-3)", mm), "it is short; at (1000, -500, 2)");
  EXPECT_EQ(message_in_units("of (1, 2, 3, 4) and (u 1, v 2)", mm), "of (1, 2, 3, 4) and (u 1, v 2)");
}

TEST(Units, PicturesInSpaceHaveTheirAxesColoursAndCurtainsInThem) {
  scene::space::Surface surface;
  surface.points = {{0, 0, 0}, {2, 0, 0}, {0, 1, 3}};
  surface.triangles = {{0, 1, 2}};
  surface.values_at = scene::ValuesAt::Triangles;
  surface.values = {2e6};
  surface.scale = {.title = "stress [Pa]", .low = 1e6, .high = 3e6};
  surface.chart = {{0, 0}, {1, 0}, {0, 1}};
  scene::space::Curtain curtain{{{0, 0}, {4, 0}}, 1.0, {}};
  curtain.section.layers.push_back({"line", "", {}, scene::Lines{{{{{1, -1}, {2, -2}}, false}}, {}}});
  scene::space::SpacePicture picture;
  picture.layers.push_back({.key = "surface", .content = surface});
  picture.layers.push_back({.key = "section", .content = curtain});
  const scene::space::SpacePicture made = in_units(picture, system_of("mm, N, MPa"));
  EXPECT_EQ(made.axes.z_title, "z [mm]");
  const auto& turned = std::get<scene::space::Surface>(made.layers[0].content);
  EXPECT_EQ(turned.points[2], (geom::Point3{0, 1000, 3000}));
  EXPECT_EQ(turned.values, (std::vector<double>{2}));
  EXPECT_EQ(turned.scale.title, "stress [MPa]");
  EXPECT_EQ(turned.chart[1], (geom::Point{1, 0}));
  const geom::Box3 section = extent(made.layers[1]);
  EXPECT_EQ(section.low, (geom::Point3{0, 0, -2000}));
  EXPECT_EQ(section.high, (geom::Point3{1000, 0, -1000}));
}

TEST(Units, PicturesHaveTheirAxesColoursAndLabelsInThem) {
  scene::Panel panel{.key = "a", .axes = {}};
  scene::Mesh mesh{.points = {{0, 0}, {2, 0}, {0, 1}},
                   .triangles = {{0, 1, 2}},
                   .values_at = scene::ValuesAt::Points,
                   .values = {1e6, 2e6, 3e6}};
  mesh.scale = {.title = "stress [Pa]", .low = 1e6, .high = 2e6, .least = 1e6, .greatest = 3e6};
  scene::Mesh sizes = mesh;
  sizes.values = {-2.0, -1.0, 0.0};
  sizes.scale = {.title = "size [m]", .low = -2.0, .high = 0.0, .ticks = scene::AxisScale::Log10};
  panel.layers.push_back({"mesh", "", {}, mesh});
  panel.layers.push_back({"labels", "", {}, scene::Labels{{{{2, 0}, "max", scene::Anchor::Callout, 3e6}}}});
  panel.layers.push_back({"sizes", "", {}, sizes});
  const scene::Picture picture = in_units(scene::Picture{"", {panel}}, system_of("mm, N, MPa"));
  const scene::Panel& made = picture.panels[0];
  EXPECT_EQ(made.axes.x_title, "x [mm]");
  EXPECT_EQ(extent(made).high, (geom::Point{2000, 1000}));
  const auto& colours = std::get<scene::Mesh>(made.layers[0].content);
  EXPECT_EQ(colours.scale.title, "stress [MPa]");
  EXPECT_EQ(colours.values, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(*colours.scale.greatest, 3.0);
  EXPECT_EQ(*std::get<scene::Labels>(made.layers[1].content).labels[0].value, 3.0);
  const auto& logs = std::get<scene::Mesh>(made.layers[2].content);
  EXPECT_NEAR(logs.values[0], 1.0, 1e-12);  // 0.01 m are 10 mm
  EXPECT_NEAR(logs.scale.high, 3.0, 1e-12);
}

TEST(Units, ADocumentKeepsItsUnitsAndSaysWhereTheyAreWrong) {
  const std::string head = "dobra = 1\nprogram = \"quebra\"\n";
  const auto read = parse_document(head + "unit_system = \"MPa, mm, N\"\nresult_units = \"SI\"\n", "a.toml");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->units.text(), "mm, N, MPa");
  EXPECT_TRUE(read->shown_units().si());
  const auto again = parse_document(document_text(*read), "a.toml");
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(document_text(*again), document_text(*read));
  const auto wrong = parse_document(head + "unit_system = \"mm, N, Pa\"\n", "a.toml");
  ASSERT_FALSE(wrong.ok());
  EXPECT_THAT(to_string(wrong.error()), HasSubstr("a.toml:3:1: unit_system = \"mm, N, Pa\": N / mm2 is not Pa"));
}

TEST(Units, AProgramWhoseNumbersAreInMetresRefusesOthers) {
  const auto read = parse_document("dobra = 1\nprogram = \"p\"\nunit_system = \"mm, N, MPa\"\n", "a.toml");
  ASSERT_TRUE(read.ok());
  Program program;
  program.name = "p";
  EXPECT_FALSE(check_program(*read, program).ok());
  program.takes_units = TakesUnits::Any;
  EXPECT_TRUE(check_program(*read, program).ok());
}

}  // namespace
}  // namespace dobra::scenario
