// vtu.h, msh.h and inp.h: what is written reads back, foreign files are read, bad ones refused with their place.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "shared/base/text.h"
#include "shared/io/base64.h"
#include "shared/io/file.h"
#include "shared/io/formats/mesh_file.h"
#include "shared/io/meshes/inp.h"
#include "shared/io/meshes/msh.h"
#include "shared/io/meshes/vtu.h"
#include "tests/shared/io/io_examples.h"

namespace dobra::io::meshes {
namespace {

using base::ErrorCode;
using mesh::ElementMesh;
using mesh::NodeId;
using test::place_text;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

MeshFields example_fields(const ElementMesh& mesh) {
  MeshFields fields;
  MeshField displacement{.name = "displacement <m> & \"more\"", .components = 2, .values = {}};
  for (const geom::Point p : mesh.points)
    displacement.values.insert(displacement.values.end(), {std::sin(p.x), 1e-300 * p.y});
  MeshField alpha{.name = "alpha", .components = 1, .values = {}};
  for (std::size_t t = 0; t < mesh.element_count(); ++t) alpha.values.push_back(1.0 / static_cast<double>(t + 3));
  fields.at_points = {displacement};
  fields.at_elements = {alpha};
  return fields;
}

TEST(Base64, TextsOfRfc4648GoBothWays) {
  const std::pair<std::string, std::string> cases[] = {{"", ""},
                                                       {"f", "Zg=="},
                                                       {"fo", "Zm8="},
                                                       {"foo", "Zm9v"},
                                                       {"foob", "Zm9vYg=="},
                                                       {"fooba", "Zm9vYmE="},
                                                       {"foobar", "Zm9vYmFy"},
                                                       {"\xFF\xFE\xFD", "//79"}};
  for (const auto& [bytes, text] : cases) {
    EXPECT_EQ(base64(bytes), text);
    EXPECT_EQ(from_base64(text), bytes);
  }
  for (const auto* bad : {"Zg=", "Z", "Zg==Zg==", "Z===", "Zm9*", "Zg=v"})
    EXPECT_EQ(from_base64(bad), std::nullopt) << bad;
}

TEST(Vtu, QUE_i_AMeshReadsBackTheSameWithAllItsSets) {
  const test::TemporaryFolder folder;
  for (const ElementMesh& mesh : {test::example_mesh(), test::quadratic_example()}) {
    const MeshFields fields = example_fields(mesh);
    for (const VtuEncoding encoding : {VtuEncoding::Ascii, VtuEncoding::Base64}) {
      ASSERT_TRUE(write_vtu(folder.file("m.vtu"), mesh, fields, encoding).ok());
      const auto read = read_vtu(folder.file("m.vtu"));
      ASSERT_TRUE(read.ok()) << base::to_string(read.error());
      EXPECT_EQ(read->mesh, mesh);
      EXPECT_EQ(read->fields, fields);
    }
  }
}

TEST(Vtu, FieldsOfTheWrongLengthOrNotFiniteAreNotWritten) {
  const ElementMesh mesh = test::example_mesh();
  EXPECT_EQ(vtu_text(mesh, {.at_points = {{"a", 1, {1.0}}}, .at_elements = {}}).error().code, ErrorCode::InvalidOption);
  MeshFields fields = example_fields(mesh);
  fields.at_elements[0].values[3] = NAN;
  EXPECT_EQ(vtu_text(mesh, fields).error().code, ErrorCode::NotFinite);
  ElementMesh bad = mesh;
  bad.points[5].x = INFINITY;
  EXPECT_EQ(vtu_text(bad).error().code, ErrorCode::NotFinite);
}

TEST(Vtu, BadTextIsRefusedWithItsPlace) {
  ElementMesh bare = test::example_mesh(3);
  bare.side_sets.clear();
  bare.node_sets.clear();
  bare.region_names.clear();
  const std::string good = *vtu_text(bare);
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  const std::tuple<std::string, ErrorCode, std::string, std::string> cases[] = {
      {"", ErrorCode::EmptyFile, "f:0:0", "empty"},
      {"hello\n", ErrorCode::BadFormat, "f:0:0", "not a .vtu file"},
      {replaced("\"UnstructuredGrid\"", "\"PolyData\""), ErrorCode::UnknownFormat, "f:2:1", "'PolyData'"},
      {replaced("\"ascii\"", "\"appended\""), ErrorCode::BadFormat, "f:8:1", "does not lie in the appended data"},
      {replaced("<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n",
                "<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n1 "
                "zwei 0 "),
       ErrorCode::BadFormat, "f:29:3", "the value 'zwei' is not a number"},
      {replaced("<DataArray type=\"Int64\" Name=\"connectivity\" NumberOfComponents=\"1\" format=\"ascii\">\n0 ",
                "<DataArray type=\"Int64\" Name=\"connectivity\" NumberOfComponents=\"1\" format=\"ascii\">\n99 "),
       ErrorCode::BadFormat, "f:48:1", "there is no point 99"},
      {good.substr(0, 1200), ErrorCode::BadFormat, "f:48:1", "cut short"},
  };
  for (const auto& [text, code, place, says] : cases) {
    const auto read = parse_vtu(text, "f");
    ASSERT_FALSE(read.ok()) << says;
    EXPECT_EQ(read.error().code, code) << says;
    EXPECT_EQ(place_text(read.error()), place) << says;
    EXPECT_THAT(read.error().message, HasSubstr(says));
  }
}

TEST(Msh, QUE_i_AMeshReadsBackTheSameWithAllItsSets) {
  const test::TemporaryFolder folder;
  for (const ElementMesh& mesh : {test::example_mesh(), test::quadratic_example()}) {
    for (const MshVersion version : {MshVersion::V22, MshVersion::V41}) {
      ASSERT_TRUE(write_msh(folder.file("m.msh"), mesh, version).ok());
      const auto read = read_msh(folder.file("m.msh"));
      ASSERT_TRUE(read.ok()) << base::to_string(read.error());
      EXPECT_EQ(read->mesh, mesh);
      EXPECT_THAT(read->remarks, IsEmpty());
    }
  }
}

// gmsh itself, where it is installed: it checks the mesh, writes it again, and the copy must be the same mesh.
TEST(Msh, QUE_i_GmshTakesTheFileAndWritesTheSameMesh) {
  if (std::system("command -v gmsh > /dev/null 2>&1") != 0) GTEST_SKIP() << "gmsh is not installed";
  const test::TemporaryFolder folder;
  const std::string log = folder.file("log");
  const auto run = [&](const std::string& arguments) {
    return std::system(("LD_PRELOAD= gmsh " + arguments + " > " + log + " 2>&1").c_str());
  };
  const auto counts = [](const auto& sets) {
    std::map<std::string, std::size_t> result;
    for (const auto& [name, items] : sets) result[name] = items.size();
    return result;
  };
  const ElementMesh whole = mesh::element_mesh_of(test::example_triangles());
  const ElementMesh curved = mesh::to_second_order(mesh::recombine(whole, {0.9})).mesh;
  for (const ElementMesh& mesh : {whole, curved, test::example_mesh(), test::quadratic_example()}) {
    for (const MshVersion version : {MshVersion::V22, MshVersion::V41}) {
      ASSERT_TRUE(write_msh(folder.file("m.msh"), mesh, version).ok());
      if (mesh.tips.empty()) {  // To gmsh, lips are duplicate nodes.
        ASSERT_EQ(run(folder.file("m.msh") + " -check"), 0) << *read_text(log);
        const std::string said = *read_text(log);
        EXPECT_THAT(said, testing::Not(testing::AnyOf(HasSubstr("Error"), HasSubstr("Warning")))) << said;
      }
      const std::string format = version == MshVersion::V22 ? "msh22" : "msh41";
      ASSERT_EQ(run(folder.file("m.msh") + " -save -format " + format + " -o " + folder.file("copy.msh")), 0)
          << *read_text(log);
      const auto copy = read_msh(folder.file("copy.msh"));
      ASSERT_TRUE(copy.ok()) << base::to_string(copy.error());
      EXPECT_EQ(copy->mesh.points.size(), mesh.points.size());
      EXPECT_EQ(copy->mesh.element_count(), mesh.element_count());
      EXPECT_NEAR(mesh::area(copy->mesh), mesh::area(mesh), 1e-12);
      EXPECT_EQ(counts(copy->mesh.side_sets), counts(mesh.side_sets));
      EXPECT_EQ(counts(copy->mesh.node_sets), counts(mesh.node_sets));
      EXPECT_EQ(copy->mesh.tips.size(), mesh.tips.size());
      EXPECT_EQ(copy->mesh.region_names, mesh.region_names);
      EXPECT_EQ(std::count(copy->mesh.regions.begin(), copy->mesh.regions.end(), 7),
                std::count(mesh.regions.begin(), mesh.regions.end(), 7));
    }
  }
}

TEST(Msh, AMeshMadeByGmshIsRead) {
  if (std::system("command -v gmsh > /dev/null 2>&1") != 0) GTEST_SKIP() << "gmsh is not installed";
  const test::TemporaryFolder folder;
  ASSERT_TRUE(
      write_file(
          folder.file("a.geo"),
          "SetFactory(\"Built-in\");\nPoint(1)={0,0,0,0.2};Point(2)={2,0,0,0.2};Point(3)={2,1,0,0.2};Point(4)={0,1,0,0."
          "2};\n"
          "Line(1)={1,2};Line(2)={2,3};Line(3)={3,4};Line(4)={4,1};Curve Loop(1)={1,2,3,4};Plane Surface(1)={1};\n"
          "Physical Curve(\"base\")={1};Physical Curve(\"rest\")={2,3,4};Physical Surface(\"plate\",12)={1};\n")
          .ok());
  ASSERT_EQ(std::system(("LD_PRELOAD= gmsh -2 -format msh41 " + folder.file("a.geo") + " -o " + folder.file("a.msh") +
                         " > /dev/null 2>&1")
                            .c_str()),
            0);
  const auto read = read_msh(folder.file("a.msh"));
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_NEAR(mesh::area(read->mesh), 2.0, 1e-12);
  EXPECT_EQ(read->mesh.side_sets.at("base").size(), 10U);
  EXPECT_EQ(read->mesh.side_sets.at("rest").size(), 20U);
  EXPECT_EQ(read->mesh.regions.front(), 12);
}

TEST(Msh, MeshesThatCannotBeWrittenAreRefused) {
  EXPECT_EQ(msh_text(ElementMesh{}).error().code, ErrorCode::CannotMesh);
  ElementMesh mesh = test::example_mesh(3);
  mesh.points[0].y = NAN;
  EXPECT_EQ(msh_text(mesh).error().code, ErrorCode::NotFinite);
}

TEST(Msh, NamesThatCannotStandInQuotesAreRenamed) {
  ElementMesh mesh = test::example_mesh(3);
  mesh.node_sets["a \"b\""] = {NodeId(0)};
  mesh.node_sets["a 'b'"] = {NodeId(1)};
  EXPECT_EQ(msh_renamings(mesh), (std::map<std::string, std::string>{{"a \"b\"", "a 'b'_2"}}));
  for (const MshVersion version : {MshVersion::V22, MshVersion::V41}) {
    const auto read = parse_msh(msh_text(mesh, version).value(), "m.msh");
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    EXPECT_EQ(read->mesh.node_sets.at("a 'b'_2"), std::vector{NodeId(0)});
    EXPECT_EQ(read->mesh.node_sets.at("a 'b'"), std::vector{NodeId(1)});
  }
}

TEST(Msh, BadTextIsRefusedWithItsPlace) {
  const std::string head = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  const std::string nodes = "$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n";
  const std::tuple<std::string, ErrorCode, std::string, std::string> cases[] = {
      {"", ErrorCode::EmptyFile, "f:0:0", "empty"},
      {"$Nodes\n", ErrorCode::BadFormat, "f:1:1", "starts with $MeshFormat"},
      {"$MeshFormat\n1.0 0 8\n$EndMeshFormat\n", ErrorCode::UnknownFormat, "f:2:1",
       "version '1.0' is not read; save it with gmsh"},
      {"$MeshFormat\n4.1 1 8\n", ErrorCode::UnknownFormat, "f:2:5", "binary"},
      {head, ErrorCode::BadFormat, "f:0:0", "no triangles"},
      {head + "$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n2\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n", ErrorCode::BadFormat, "f:12:1",
       "node 2 is given twice"},
      {head + "$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 x 0\n", ErrorCode::BadFormat, "f:11:3",
       "y 'x' is not a number"},
      {head + nodes + "$Elements\n1 1 1 1\n2 1 2 1\n1 1 2 9\n$EndElements\n", ErrorCode::BadFormat, "f:17:7",
       "there is no node 9"},
      {head + nodes + "$Elements\n1 1 1 1\n2 1 5 1\n", ErrorCode::UnknownFormat, "f:16:5", "element type 5"},
      {head + nodes + "$Elements\n1 1 1 1\n2 1 2 1\n1 1 2 3\n", ErrorCode::BadFormat, "f:17:0",
       "ends before $EndElements"},
      {head + "$Foo\n1 2\n", ErrorCode::BadFormat, "f:5:0", "ends before $EndFoo"},
  };
  for (const auto& [text, code, place, says] : cases) {
    const auto read = parse_msh(text, "f");
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.error().code, code) << text;
    EXPECT_EQ(place_text(read.error()), place) << text;
    EXPECT_THAT(read.error().message, HasSubstr(says)) << text;
  }
}

TEST(Inp, QUE_i_AMeshReadsBackTheSameWithAllItsSets) {
  const test::TemporaryFolder folder;
  for (const ElementMesh& mesh : {test::example_mesh(), test::quadratic_example()}) {
    ASSERT_TRUE(
        write_inp(folder.file("m.inp"), mesh, {.element = InpElement::PlaneStrain, .numbers = InpNumbers::Exact}).ok());
    const auto read = read_inp(folder.file("m.inp"));
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    EXPECT_EQ(read->mesh, mesh);
    EXPECT_THAT(read->remarks, IsEmpty());
  }
  EXPECT_THAT(*read_text(folder.file("m.inp")), HasSubstr("*ELEMENT, TYPE=CPE8, ELSET=EALL\n"));
}

TEST(Inp, TwentyColumnsKeepTheNumberWithinOnePartInATrillion) {
  EXPECT_EQ(twenty_columns(0.5), "0.5");
  EXPECT_EQ(twenty_columns(-0.005877852522924731), "-.005877852522924731");
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::ldexp(uniform(random), static_cast<int>(random() % 2000) - 1000);
    const std::string text = twenty_columns(value);
    ASSERT_LE(text.size(), 20U) << text;
    const auto read = base::parse_number(text);
    ASSERT_TRUE(read.has_value()) << text;
    EXPECT_LE(std::abs(*read - value), 1e-12 * std::abs(value)) << text;
  }
}

TEST(Inp, NamesThatALabelCannotHoldAreChangedAndStayApart) {
  ElementMesh mesh = test::example_mesh(3);
  mesh.node_sets = {{"a b", {NodeId(0)}},
                    {"a,b", {NodeId(1)}},
                    {"A_B", {NodeId(2)}},
                    {"1", {NodeId(3)}},
                    {std::string(100, 'x'), {NodeId(4)}}};
  const auto read = parse_inp(*inp_text(mesh, {.element = InpElement::PlaneStress}), "f");
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  std::vector<std::string> names;
  for (const auto& [name, nodes] : read->mesh.node_sets) names.push_back(name);
  EXPECT_THAT(names, ElementsAre("A_B", "S_1", "a_b_2", "a_b_3", std::string(70, 'x')));
  EXPECT_THAT(*inp_text(mesh, {.element = InpElement::PlaneStress}), HasSubstr("** 'a b' is written as a_b_2\n"));
}

TEST(Inp, ASetMayHaveTheNameOfARegionAndEveryOtherRenamingIsTold) {
  ElementMesh mesh = test::example_mesh(3);
  const std::int32_t region = mesh.regions.front();
  mesh.region_names = {{region, "A"}};
  mesh.side_sets = {{"A", {{mesh::ElementId(0), 0}}}, {"my rim", {{mesh::ElementId(0), 1}}}};
  mesh.node_sets = {{"a", {NodeId(0)}}, {"P", {NodeId(1)}}};
  mesh.tips.clear();
  const auto read = parse_inp(*inp_text(mesh, {.element = InpElement::PlaneStress}), "f");
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_EQ(read->mesh.region_names, mesh.region_names);
  EXPECT_EQ(read->mesh.regions, mesh.regions);
  EXPECT_EQ(read->mesh.side_sets.at("A"), mesh.side_sets.at("A"));
  EXPECT_EQ(read->mesh.node_sets.at("a_2"), mesh.node_sets.at("a"));
  EXPECT_EQ(read->mesh.node_sets.at("P"), mesh.node_sets.at("P"));
  const auto told = formats::losses("m.inp", mesh);
  EXPECT_THAT(told, ElementsAre(HasSubstr("m.inp: the set of sides 'my rim' is written as my_rim"),
                                HasSubstr("the set of nodes 'a' is written as a_2")));
  EXPECT_THAT(formats::losses("m.vtu", mesh), IsEmpty());
  EXPECT_THAT(formats::losses("m.ele", mesh), ElementsAre(HasSubstr("holds no names")));
}

TEST(Inp, ARegionWithTheLabelOfAnotherTagLeavesTheTagsAsTheyAre) {
  ElementMesh mesh = test::example_mesh(3);
  std::fill(mesh.regions.begin(), mesh.regions.end(), 1);
  mesh.regions.back() = 2;
  mesh.region_names = {{1, "REGION_2"}};
  const auto read = parse_inp(*inp_text(mesh, {.element = InpElement::PlaneStress}), "f");
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_EQ(read->mesh.regions, mesh.regions);
  EXPECT_THAT(formats::losses("m.inp", mesh),
              testing::Contains(HasSubstr("the region 'REGION_2' is written as REGION_2_2")));
}

TEST(Inp, ADeckOfAnotherProgramIsRead) {
  const auto read = parse_inp(
      "*Heading\n made by hand\n** comment\n*Node\n10, 0., 0.\n20, 1., 0., 0.\n30, 0., 1.\n40, 1, 1\n*Element, "
      "type=cps3, elset=ALL\n"
      "7, 10, 20, 30\n8, 20, 30, 40\n*Nset, nset=left, generate\n10, 30, 20\n*Elset, elset=Region_3\n8\n*Surface, "
      "name=base, type=element\n7, s1\n"
      "*Material, name=steel\n*Elastic\n210000., .3\n*Elastic\n1., .3\n",
      "f");
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_THAT(read->mesh.nodes_of(mesh::ElementId(1)), ElementsAre(NodeId(1), NodeId(3), NodeId(2)));
  EXPECT_THAT(read->mesh.regions, ElementsAre(0, 3));
  EXPECT_THAT(read->mesh.node_sets.at("left"), ElementsAre(NodeId(0), NodeId(2)));
  EXPECT_THAT(read->mesh.side_sets.at("base"), ElementsAre(mesh::ElementSide{mesh::ElementId(0), 0}));
  EXPECT_THAT(read->remarks, ElementsAre(HasSubstr("'*MATERIAL' left out"), HasSubstr("'*ELASTIC' left out")));
}

TEST(Inp, BadTextIsRefusedWithItsPlace) {
  const std::string nodes = "*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n";
  const std::tuple<std::string, ErrorCode, std::string, std::string> cases[] = {
      {"", ErrorCode::EmptyFile, "f:0:0", "empty"},
      {"1, 2, 3\n", ErrorCode::BadFormat, "f:1:1", "a keyword such as *NODE"},
      {nodes, ErrorCode::BadFormat, "f:0:0", "no triangles"},
      {"*NODE\n1, 0, a\n", ErrorCode::BadFormat, "f:2:7", "y 'a' is not a number"},
      {"*NODE\n1, 0\n", ErrorCode::BadFormat, "f:2:5", "y is missing"},
      {nodes + "2, 5, 5\n", ErrorCode::BadFormat, "f:5:1", "node 2 is given twice"},
      {nodes + "*ELEMENT, TYPE=C3D8\n", ErrorCode::UnknownFormat, "f:5:1", "'C3D8'"},
      {nodes + "*ELEMENT, TYPE=CPS3\n1, 1, 2, 4\n", ErrorCode::BadFormat, "f:6:10", "there is no node 4"},
      {nodes + "*ELEMENT, TYPE=CPS3\n1, 1, 2, 3\n*SURFACE, NAME=a\n1, S4\n", ErrorCode::BadFormat, "f:8:4", "'S4'"},
      {nodes + "*NSET\n1\n", ErrorCode::BadFormat, "f:5:1", "*NSET needs NSET=name"},
      {nodes + "*NSET, NSET=a, GENERATE\n3, 1\n", ErrorCode::BadFormat, "f:6:1", "range"},
  };
  for (const auto& [text, code, place, says] : cases) {
    const auto read = parse_inp(text, "f");
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.error().code, code) << text;
    EXPECT_EQ(place_text(read.error()), place) << text;
    EXPECT_THAT(read.error().message, HasSubstr(says)) << text;
  }
}

TEST(Inp, MeshesThatCannotBeWrittenAreRefused) {
  EXPECT_EQ(inp_text(ElementMesh{}, {.element = InpElement::PlaneStress}).error().code, ErrorCode::CannotMesh);
  ElementMesh mesh = test::example_mesh(3);
  mesh.side_sets["wrong"] = {{mesh::ElementId(0), 3}};
  EXPECT_EQ(inp_text(mesh, {.element = InpElement::PlaneStress}).error().code, ErrorCode::InvalidOption);
}

}  // namespace
}  // namespace dobra::io::meshes
