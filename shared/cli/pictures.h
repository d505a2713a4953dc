#pragma once
// Which pictures a command writes, and with which drawer.

#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "shared/base/result.h"
#include "shared/scenario/document.h"
#include "shared/scenario/program.h"
#include "shared/scene/layer.h"
#include "shared/scene/space/picture.h"

namespace dobra::cli {

enum class Drawer { Cairo, Vtk };

enum class PictureKind { Svg, Pdf, Png, Vtk };  ///< Vtk: a PNG drawn by VTK off-screen.

/// "svg,pdf,png,vtk" or "none".
/// @error BadUsage with a suggestion.
base::Result<std::set<PictureKind>> picture_kinds(const std::string& list);

/// picture.svg, picture.pdf, picture.png, picture_vtk.png
std::string picture_file_name(PictureKind kind);

/// The picture of a state; a sheet is called after its document, or after the document's file.
scene::Picture picture_of(const scenario::Program& program, const scenario::Document& document,
                          const scenario::State& state);

/// Draws in the format that the ending of the file says.
/// @param width  of the page in points; the drawer's usual one by default. The height follows from the content.
/// @error BadUsage for an ending that the drawer cannot write; CannotDraw (VTK: no EGL); CannotWrite.
base::Result<void> draw(const scene::Picture& picture, const std::filesystem::path& file, Drawer drawer,
                        std::optional<double> width = std::nullopt);

/// A picture in space, from its usual side. @error as draw
base::Result<void> draw(const scene::space::SpacePicture& picture, const std::filesystem::path& file, Drawer drawer);
/// space.svg, space.pdf, space.png, space_vtk.png: beside picture.svg and so on, where a state has a picture in space.
std::string space_file_name(PictureKind kind);

/// ".svg, .pdf or .png", for help and errors. @param last  the word before the last one
std::string picture_endings(const char* last = "or");

/// @error BadUsage for an ending that the drawer cannot write.
base::Result<void> check_ending(const std::filesystem::path& file, Drawer drawer);

}  // namespace dobra::cli
