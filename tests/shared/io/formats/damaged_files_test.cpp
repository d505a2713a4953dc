// Every reader on damaged copies of a good file: cut short at every place, bytes changed, pieces doubled or left out.
// None may crash (the sanitizers watch); each gives a value, or an error of one line that is the user's to mend.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <random>

#include "shared/io/gis/geojson.h"
#include "shared/io/lines/text_points.h"
#include "shared/io/lines/wkt.h"
#include "shared/io/meshes/inp.h"
#include "shared/io/meshes/msh.h"
#include "shared/io/meshes/poly.h"
#include "shared/io/meshes/vtu.h"
#include "tests/shared/io/io_examples.h"

namespace dobra::io::formats {
namespace {

using Reader = std::function<std::optional<base::Error>(const std::string&)>;

template <class Parse>
Reader reader(Parse parse) {
  return [parse](const std::string& text) -> std::optional<base::Error> {
    const auto read = parse(text);
    if (read.ok()) return std::nullopt;
    return read.error();
  };
}

void expect_value_or_good_error(const Reader& read, const std::string& text) {
  const std::optional<base::Error> error = read(text);
  if (!error) return;
  EXPECT_FALSE(error->message.empty());
  EXPECT_EQ(error->message.find('\n'), std::string::npos) << error->message;
  EXPECT_EQ(base::exit_code(error->code), 3) << base::to_string(*error);
  ASSERT_TRUE(error->place.has_value()) << error->message;
  EXPECT_EQ(error->place->file, "f") << error->message;
}

std::string damaged(std::string text, std::mt19937_64& random) {
  static const std::string spice = "0123456789+-.eE,;:\"'{}[]()<>/$*#=\n\r\t \x7F\xFFnaif";
  for (std::uint64_t hits = 1 + random() % 4; hits > 0 && !text.empty(); --hits) {
    const std::size_t at = random() % text.size();
    const std::size_t length = std::min<std::size_t>(random() % 40, text.size() - at);
    switch (random() % 5) {
      case 0:
        text[at] = static_cast<char>(random() % 256);
        break;
      case 1:
        text[at] = spice[random() % spice.size()];
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(at, text.substr(at, length));
        break;
      default:
        text.insert(at, std::to_string(random() >> (random() % 64)));
        break;
    }
  }
  return text;
}

void damage_everywhere(const Reader& read, const std::string& good, int rounds) {
  ASSERT_FALSE(read(good)) << base::to_string(*read(good));
  const std::size_t step = std::max<std::size_t>(1, good.size() / 500);
  for (std::size_t size = 0; size < good.size(); size += step) expect_value_or_good_error(read, good.substr(0, size));
  std::mt19937_64 random(20240607);
  for (int i = 0; i < rounds; ++i) expect_value_or_good_error(read, damaged(good, random));
}

std::vector<lines::Feature> example_features() {
  lines::Feature line{.type = lines::FeatureType::Lines,
                      .parts = {{{{0, 0}, {1, 2.5}, {3, -1e-3}}, false}, {{{5, 5}, {6, 6}}, false}},
                      .name = "top",
                      .kind = "horizon"};
  line.properties = {{"age", std::int64_t{3}}, {"dip", 0.25}, {"sure", true}};
  return {line,
          {.type = lines::FeatureType::Polygons,
           .parts = {{{{0, 0}, {9, 0}, {9, 9}}, true}, {{{5, 1}, {6, 2}, {6, 1}}, true}},
           .name = "",
           .kind = ""},
          {.type = lines::FeatureType::Points, .parts = {{{{1, 2}, {3, 4}}, false}}, .name = "p", .kind = ""}};
}

TEST(DamagedFiles, TextPointsGiveAValueOrAnError) {
  const auto read = reader([](const std::string& text) {
    return lines::parse_text_points(text, "f", {.blank_lines = lines::BlankLines::SplitLines});
  });
  damage_everywhere(read, "# c\nx,z\n0.5,1\n1,2e3\n\n3,-4\n5,6\n5,7\n", 3000);
}

TEST(DamagedFiles, WktGivesAValueOrAnError) {
  damage_everywhere(reader([](const std::string& text) { return lines::parse_wkt(text, "f"); }),
                    *lines::wkt(example_features()), 3000);
}

TEST(DamagedFiles, GeojsonGivesAValueOrAnError) {
  damage_everywhere(reader([](const std::string& text) { return gis::parse_geojson(text, "f"); }),
                    *gis::geojson(example_features()), 1000);
}

TEST(DamagedFiles, PolyGivesAValueOrAnError) {
  damage_everywhere(reader([](const std::string& text) { return meshes::parse_poly(text, "f"); }),
                    "4 2 1 1\n0 0 0 1 1\n1 1 0 1 1\n2 1 1 1 1\n3 0 1 1 1\n4 1\n0 0 1 1\n1 1 2 1\n2 2 3 1\n3 3 0 "
                    "1\n1\n0 .5 .5\n1\n0 .1 .1 3 .5\n",
                    3000);
}

TEST(DamagedFiles, NodeAndEleGiveAValueOrAnError) {
  const mesh::ElementMesh mesh = test::example_mesh(3);
  const meshes::NodeFile nodes = meshes::node_file_of(mesh);
  damage_everywhere(reader([](const std::string& text) { return meshes::parse_node(text, "f"); }),
                    *meshes::node_text(nodes), 2000);
  damage_everywhere(reader([&](const std::string& text) { return meshes::parse_ele(text, "f", nodes); }),
                    *meshes::ele_text(*meshes::ele_file_of(mesh)), 2000);
}

TEST(DamagedFiles, VtuGivesAValueOrAnError) {
  const auto read = reader([](const std::string& text) { return meshes::parse_vtu(text, "f"); });
  const mesh::ElementMesh mesh = test::example_mesh(3);
  damage_everywhere(read, *meshes::vtu_text(mesh), 2000);
  damage_everywhere(read, *meshes::vtu_text(mesh, {}, meshes::VtuEncoding::Base64), 2000);
}

TEST(DamagedFiles, MshGivesAValueOrAnError) {
  damage_everywhere(reader([](const std::string& text) { return meshes::parse_msh(text, "f"); }),
                    *meshes::msh_text(test::example_mesh(3)), 3000);
}

TEST(DamagedFiles, InpGivesAValueOrAnError) {
  damage_everywhere(reader([](const std::string& text) { return meshes::parse_inp(text, "f"); }),
                    *meshes::inp_text(test::example_mesh(3), {.element = meshes::InpElement::PlaneStress}), 3000);
}

}  // namespace
}  // namespace dobra::io::formats
