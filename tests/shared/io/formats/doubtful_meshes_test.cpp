// Files of meshes that were cut short, and meshes that are not plane.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shared/io/file.h"
#include "shared/io/formats/mesh_file.h"
#include "tests/shared/io/io_examples.h"

namespace dobra::io::formats {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string written(const test::TemporaryFolder& folder, const std::string& name) {
  const mesh::ElementMesh mesh = test::example_mesh(4);
  EXPECT_TRUE(write_mesh(folder.file(name), mesh, meshes::InpElement::PlaneStress).ok()) << name;
  return read_text(folder.file(name)).value();
}

base::Result<MeshContents> read_back(const test::TemporaryFolder& folder, const std::string& name,
                                     const std::string& text) {
  EXPECT_TRUE(write_text(folder.file(name), text).ok());
  return read_mesh(folder.file(name));
}

std::string refusal_of(const base::Result<MeshContents>& read) {
  return read.ok() ? "read" : base::to_string(read.error());
}

TEST(DoubtfulMeshes, AnStlWithoutItsEndIsRefused) {
  const test::TemporaryFolder folder;
  const std::string whole = written(folder, "m.stl");
  EXPECT_EQ(refusal_of(read_back(folder, "m.stl", whole)), "read");
  const std::size_t end = whole.rfind("endsolid");
  for (const std::size_t size : {end, end + 4, whole.rfind("endloop"), whole.size() / 2}) {
    EXPECT_THAT(refusal_of(read_back(folder, "m.stl", whole.substr(0, size))),
                AllOf(HasSubstr("m.stl:"), HasSubstr("endsolid")))
        << size;
  }
}

TEST(DoubtfulMeshes, ABdfWithoutEnddataAndAnInpWithoutALineEndAreTold) {
  const test::TemporaryFolder folder;
  const std::string bdf = written(folder, "m.bdf");
  EXPECT_THAT(read_back(folder, "m.bdf", bdf)->remarks, IsEmpty());
  const auto cut = read_back(folder, "m.bdf", bdf.substr(0, bdf.rfind("ENDDATA")));
  ASSERT_TRUE(cut.ok());
  EXPECT_THAT(cut->remarks, ElementsAre(AllOf(HasSubstr("m.bdf:"), HasSubstr("ENDDATA"))));

  const std::string head = "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n12, 0, 1\n*ELEMENT, TYPE=CPS3\n1, 1, 2, 3\n2, 1, 3, ";
  EXPECT_THAT(read_back(folder, "m.inp", head + "12\n")->remarks, IsEmpty());
  EXPECT_THAT(read_back(folder, "m.inp", head + "12")->remarks,
              ElementsAre(AllOf(HasSubstr("m.inp:8"), HasSubstr("cut short"), HasSubstr("'2, 1, 3, 12'"))));
}

/// A unit square of two triangles, its corners at these places.
std::string vtu_of(const std::string& points) {
  return R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="4" NumberOfCells="2"><Points>)"
         R"(<DataArray type="Float64" NumberOfComponents="3" format="ascii">)" +
         points +
         R"(</DataArray></Points><Cells><DataArray type="Int64" Name="connectivity" format="ascii">)"
         R"(0 1 2 0 2 3</DataArray>)"
         R"(<DataArray type="Int64" Name="offsets" format="ascii">3 6</DataArray>)"
         R"(<DataArray type="UInt8" Name="types" format="ascii">5 5</DataArray></Cells></Piece>)"
         "</UnstructuredGrid></VTKFile>";
}

std::string msh_of(const std::string& third, const std::string& fourth) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n7 " + third + "\n4 " + fourth +
         "\n$EndNodes\n$Elements\n2\n1 2 2 1 1 1 2 7\n2 2 2 1 1 1 7 4\n$EndElements\n";
}

std::string inp_of(const std::string& third, const std::string& fourth) {
  return "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, " + third + "\n4, " + fourth +
         "\n*ELEMENT, TYPE=CPS3\n1, 1, 2, 3\n2, 1, 3, 4\n";
}

std::string bdf_of(const std::string& third, const std::string& fourth) {
  return "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,," + third + "\nGRID,4,," + fourth +
         "\nCTRIA3,1,1,1,2,3\nCTRIA3,2,1,1,3,4\n";
}

TEST(DoubtfulMeshes, MeshesThatAreNotPlaneInXAndYAreRefusedWithThePlace) {
  const test::TemporaryFolder folder;
  const std::string stl =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "3\nendloop\nendfacet\nendsolid\n";
  const std::pair<std::string, std::string> bad[] = {{"a.vtu", vtu_of("0 0 0 1 0 0 1 1 5 0 1 5")},
                                                     {"b.vtu", vtu_of("0 0 0 1 0 0 1 0 1 0 0 1")},
                                                     {"a.msh", msh_of("1 1 5", "0 1 0")},
                                                     {"b.msh", msh_of("1 0 1", "0 0 1")},
                                                     {"a.inp", inp_of("1, 1, 5", "0, 1, 0")},
                                                     {"a.bdf", bdf_of("1.,1.,5.", "0.,1.,0.")},
                                                     {"a.stl", stl}};
  for (const auto& [name, text] : bad) {
    EXPECT_THAT(refusal_of(read_back(folder, name, text)),
                AllOf(HasSubstr(name), HasSubstr("a node lies at z = "), HasSubstr("(at ")));
  }
  const std::pair<std::string, std::string> good[] = {{"a.vtu", vtu_of("0 0 7 1 0 7 1 1 7 0 1 7")},
                                                      {"b.vtu", vtu_of("0 0 0 1 0 1e-12 1 1 0 0 1 -1e-9")},
                                                      {"a.msh", msh_of("1 1 0", "0 1 0")},
                                                      {"a.inp", inp_of("1, 1", "0, 1, 0")},
                                                      {"a.bdf", bdf_of("1.,1.", "0.,1.,")}};
  for (const auto& [name, text] : good) EXPECT_EQ(refusal_of(read_back(folder, name, text)), "read") << name;
}

}  // namespace
}  // namespace dobra::io::formats
