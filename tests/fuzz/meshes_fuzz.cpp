// libFuzzer target: the readers of meshes. Byte 0 chooses the format, the rest is the file. Whatever the bytes: an
// error with a message, or a mesh that can be written, and read and written again to the same bytes; polygon meshes are
// checked.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "shared/io/meshes/bdf.h"
#include "shared/io/meshes/inp.h"
#include "shared/io/meshes/msh.h"
#include "shared/io/meshes/neutral.h"
#include "shared/io/meshes/polygon_file.h"
#include "shared/io/meshes/vtu.h"

namespace {

using namespace dobra;

/// The first writing may change names to what the format can hold; from then on nothing changes.
/// @param read  from text to a mesh.  @param write  from a mesh to text.
template <class Read, class Write>
void go_round(std::string text, const Read& read, const Write& write) {
  for (int round = 0; round < 3; ++round) {
    const auto mesh = read(text);
    if (!mesh.ok()) {
      if (round > 0 || mesh.error().message.empty()) std::abort();
      return;
    }
    const auto written = write(mesh->mesh);
    if (!written.ok()) {
      if (round > 0) std::abort();
      return;  // Such as a name that the format cannot hold.
    }
    if (round == 2 && *written != text) std::abort();
    text = *written;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] >= 254) {
    const auto polygons = data[0] == 254 ? io::meshes::parse_obj(text, "f") : io::meshes::parse_off(text, "f");
    if (!polygons.ok() && polygons.error().message.empty()) std::abort();
    if (polygons.ok()) check(*polygons, mesh::Closedness::Solid);
    return 0;
  }
  switch (data[0] % 5) {
    case 0:
      go_round(
          text, [](const std::string& t) { return io::meshes::parse_msh(t, "f"); },
          [](const mesh::ElementMesh& m) { return io::meshes::msh_text(m); });
      break;
    case 1:
      go_round(
          text, [](const std::string& t) { return io::meshes::parse_inp(t, "f"); },
          [](const mesh::ElementMesh& m) {
            return io::meshes::inp_text(
                m, {.element = io::meshes::InpElement::PlaneStress, .numbers = io::meshes::InpNumbers::Exact});
          });
      break;
    case 2:
      go_round(
          text, [](const std::string& t) { return io::meshes::parse_vtu(t, "f"); },
          [](const mesh::ElementMesh& m) { return io::meshes::vtu_text(m); });
      break;
    case 3:
      go_round(
          text, [](const std::string& t) { return io::meshes::parse_bdf(t, "f"); },
          [](const mesh::ElementMesh& m) { return io::meshes::bdf_text(m); });
      break;
    default:
      go_round(
          text, [](const std::string& t) { return io::meshes::parse_neutral(t, "f"); },
          [](const mesh::ElementMesh& m) {
            return io::meshes::neutral_text({m, {}, 1.0});
          });
  }
  return 0;
}
