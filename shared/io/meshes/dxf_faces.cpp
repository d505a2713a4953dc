#include "shared/io/meshes/dxf_faces.h"

#include <array>
#include <map>
#include <tuple>

#include "shared/io/dxf_pairs.h"

namespace dobra::io::meshes {

using base::ErrorCode;
using base::Result;

namespace {

class FaceReader {
 public:
  FaceReader(std::string_view text, const std::string& file) : pairs_(text, file), file_(file) {}

  Result<mesh::PolygonMesh> run() {
    bool names_section = false;
    std::string section;
    for (bool end = false; !end;) {
      DOBRA_TRY_VOID(pairs_.next());
      if (pairs_.code == 0) {
        if (in_face_) finish();
        names_section = pairs_.value == "SECTION";
        if (pairs_.value == "ENDSEC") section.clear();
        in_face_ = section == "ENTITIES" && pairs_.value == "3DFACE";
        corners_ = {};
        end = pairs_.value == "EOF";
      } else if (names_section && pairs_.code == 2) {
        section = pairs_.value;
        names_section = false;
      } else if (in_face_) {
        DOBRA_TRY_VOID(coordinate());
      }
    }
    if (mesh_.faces.empty())
      return base::Error{ErrorCode::BadFormat, "there is no face (3DFACE) with an area in the drawing",
                         base::Place{.file = file_}};
    return std::move(mesh_);
  }

 private:
  /// Codes 10 to 13 are x of the corners, 20 to 23 y, 30 to 33 z.
  Result<void> coordinate() {
    const int axis = pairs_.code / 10 - 1, corner = pairs_.code % 10;
    if (axis < 0 || axis > 2 || corner > 3) return {};
    const auto value = finite_number(pairs_.value, "a coordinate");
    if (!value) return pairs_.error(value.error().message, value.error().code);
    corners_[static_cast<std::size_t>(corner)][static_cast<std::size_t>(axis)] = *value;
    return {};
  }

  void finish() {
    std::vector<std::uint32_t> face;
    for (const auto& c : corners_) {
      const auto [at, is_new] =
          numbers_.try_emplace(std::tuple{c[0], c[1], c[2]}, static_cast<std::uint32_t>(mesh_.points.size()));
      if (is_new) mesh_.points.push_back({c[0], c[1], c[2]});
      if (face.empty() || (face.back() != at->second && face.front() != at->second)) face.push_back(at->second);
    }
    if (face.size() > 2) mesh_.faces.push_back(std::move(face));
  }

  DxfPairs pairs_;
  std::string file_;
  mesh::PolygonMesh mesh_;
  std::map<std::tuple<double, double, double>, std::uint32_t> numbers_;
  std::array<std::array<double, 3>, 4> corners_{};
  bool in_face_ = false;
};

}  // namespace

Result<mesh::PolygonMesh> parse_dxf_faces(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  return FaceReader(text, file).run();
}

}  // namespace dobra::io::meshes
