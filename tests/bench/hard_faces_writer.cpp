// Writes the seeded faces of tests/support/hard_faces.h as files, and faces.json with what is known of them: the area
// by another rule, the outline in space. `hard_faces.py` gives the files to the program and checks its meshes.
//
//     hard_faces_writer FOLDER FIRST COUNT [KIND]...      KIND: a number below 30, seed modulo 30

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "tests/support/hard_faces.h"

namespace {

using namespace dobra;

std::string json_of(std::uint32_t seed, const support::HardFace& face) {
  std::string text =
      fmt::format(R"({{"seed": {}, "kind": "{}", "sound": {}, "wrong": "{}", "area": {:.17g}, "unsure": {:.17g}, )"
                  R"("tolerance": {:.17g}, "handles": {}, "edges": [)",
                  seed, face.kind, face.sound, face.wrong, face.area, face.unsure, face.tolerance, face.handles);
  const char* before = "";
  for (const support::HardEdge& edge : face.outline) {
    text += fmt::format(R"({}{{"a": {}, "b": {}, "points": [)", before, edge.a, edge.b);
    before = ", ";
    for (const geom::Point3& p : edge.points)
      text += fmt::format("{}[{:.17g}, {:.17g}, {:.17g}]", &p == edge.points.data() ? "" : ", ", p.x, p.y, p.z);
    text += "]}";
  }
  return text + "]}";
}

}  // namespace

int main(int count, char** words) {
  if (count < 4) {
    std::fputs("hard_faces_writer FOLDER FIRST COUNT [KIND]...\n", stderr);
    return 2;
  }
  const std::string folder = words[1];
  const auto first = static_cast<std::uint32_t>(std::strtoul(words[2], nullptr, 10));
  const auto faces = static_cast<std::uint32_t>(std::strtoul(words[3], nullptr, 10));
  std::ofstream list(folder + "/faces.json");
  for (std::uint32_t seed = first; seed < first + faces; ++seed) {
    bool wanted = count == 4;
    for (int i = 4; i < count; ++i)
      wanted = wanted || std::strtoul(words[i], nullptr, 10) == seed % support::hard_face_kinds;
    if (!wanted) continue;
    const support::HardFace face = support::hard_face(seed);
    std::ofstream(folder + fmt::format("/face_{}.brep", seed), std::ios::binary) << face.text;
    list << json_of(seed, face) << "\n";
  }
  return list.good() ? 0 : 1;
}
