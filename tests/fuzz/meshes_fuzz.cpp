// libFuzzer target: the readers of meshes. Byte 0 chooses the row of the table of formats, or one of polygons
// in space as they stand; the rest is the file.
// Whatever the bytes: an error with a message, or a mesh that can be written, and read and written again to the same
// bytes; polygon meshes are checked.

#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "shared/io/formats/format.h"
#include "shared/io/meshes/inp.h"
#include "shared/mesh/polygon_mesh.h"

namespace {

using namespace dobra;
namespace formats = io::formats;

/// Formats of polygons, from byte 255 downwards.
constexpr std::string_view polygon_files[] = {"off", "obj", "ply", "vtp", "tsurf"};

/// The row's writer, but numbers of .inp with all their digits: those of twenty columns are rounded each time.
base::Result<std::string> written_text(const formats::Format& format, const mesh::ElementMesh& mesh) {
  using namespace io::meshes;
  if (format.name == "inp") return inp_text(mesh, {.element = InpElement::PlaneStress, .numbers = InpNumbers::Exact});
  return format.mesh->text(mesh, InpElement::PlaneStress, {});
}

/// The first writing may change names to what the format can hold; from then on nothing changes.
void go_round(std::string text, const formats::Format& format) {
  for (int round = 0; round < 3; ++round) {
    const auto contents = format.mesh->parse(text, "f");
    if (!contents.ok()) {
      if (round > 0 || contents.error().message.empty()) std::abort();
      return;
    }
    const auto written = written_text(format, contents->mesh);
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
  if (data[0] > 255 - std::size(polygon_files)) {
    const formats::Format* const format =
        formats::format_named(polygon_files[255 - data[0]], formats::Use::ReadPolygons);
    if (format == nullptr) std::abort();
    const auto polygons = format->mesh->polygons(text, "f");
    if (!polygons.ok() && polygons.error().message.empty()) std::abort();
    if (polygons.ok()) check(*polygons, mesh::Closedness::Solid);
    return 0;
  }
  std::vector<const formats::Format*> of_meshes;
  for (const formats::Format& format : formats::all_formats()) {
    if (format.mesh && format.mesh->parse != nullptr && format.mesh->text != nullptr) of_meshes.push_back(&format);
  }
  const formats::Format& format = *of_meshes[data[0] % of_meshes.size()];
  if (!format.mesh->surface) {
    go_round(text, format);
  } else if (const auto mesh = format.mesh->parse(text, "f"); !mesh.ok() && mesh.error().message.empty()) {
    std::abort();
  }
  return 0;
}
