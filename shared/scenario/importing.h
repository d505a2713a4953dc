#pragma once
// How a file is brought into a document in a window: what a look at the file shows, what the user says of it, and the
// edit of the document. A program tells what it can by an Importing. Page: docs/user/import.md.

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/polyline.h"
#include "shared/scenario/document.h"
#include "shared/scenario/field.h"
#include "shared/scene/layer.h"

namespace dobra::scenario {

/// How the user says that a file is to be read; what is left out, the file says itself.
struct ImportReading {
  std::size_t x = 0, height = 0;  ///< Columns of a text, from 1; 0: not said. Both or neither.
  std::size_t map_y = 0;          ///< The column of y, where x is one of the map too; 0: none.
  std::size_t names = 0;          ///< The column that names the lines; 0: not said.
  std::string separator;          ///< "blank", "tab", "comma", "semicolon", or empty.
  std::string y_axis;             ///< "up", "down" or empty.
  std::string unit;               ///< One of Importing::units, or empty.
  std::vector<double> corners;    ///< Of a picture: x and height of its lower left and of its upper right corner.
  friend bool operator==(const ImportReading&, const ImportReading&) = default;
};

enum class ImportShape { Line, Polygon, Points };

/// Why a line is taken for what it is.
enum class ToldBy { File, Name, Shape };

/// The lines of one name and shape of a file.
struct ImportLine {
  std::string name;  ///< As the file says; empty where it says nothing.
  ImportShape shape = ImportShape::Line;
  std::vector<geom::Polyline> parts;  ///< m, x right, y up.
  std::string kind;                   ///< Of Importing::kinds: what it is, or seems to be.
  ToldBy told_by = ToldBy::Shape;
  std::string stated;   ///< What reading the file alone makes of it: `kind`, where nothing was guessed.
  std::string problem;  ///< Why it cannot be taken, translated; empty if it can.
};

/// The first rows of a text.
struct ImportTable {
  std::vector<std::string> header;  ///< Empty without one.
  std::vector<std::vector<std::string>> rows;
  std::size_t x = 0, height = 0, names = 0;  ///< Columns as they are taken, from 1; 0: none.
  bool depth = false;                        ///< The header calls the column of heights one of depths.
  bool negative = false;                     ///< No number of that column, in these rows, is above nought.
};

/// What a file holds, read in one way.
struct ImportLook {
  std::vector<ImportLine> lines;
  std::optional<ImportTable> table;     ///< Of a text.
  std::optional<scene::Image> picture;  ///< Of a picture: its place is the unit square where it has none.
  bool placed = true;                   ///< Of a picture: it says itself, or the user has said, where it lies.
  bool asks_reading = true;             ///< Whether separator, axis and unit can be said of this format.
  std::vector<std::string> remarks;
  std::optional<base::Error> error;  ///< Why it cannot be read so; then there are no lines.
};

/// What becomes of one line of a look.
struct ImportChoice {
  std::string kind;
  bool taken = true;
};

/// Lines whose names fit the pattern ('*': any text, '?': one character; capitals count) are of the kind.
struct ImportRule {
  std::string pattern;
  std::string kind;
};

struct ImportFile {
  std::filesystem::path file;  ///< Absolute.
  ImportReading reading;
  std::vector<ImportRule> rules;      ///< As the user has given them; the first that fits a name counts.
  std::vector<ImportChoice> choices;  ///< One a line of the look, after the rules.
};

struct Imported {
  Document document;
  std::vector<std::string> notes;  ///< What the user should know: names that were changed; translated.
};

/// What a program can bring into a document; without `look` nothing.
struct Importing {
  struct Kind {
    std::string name;   ///< "fault"
    std::string title;  ///< "Fault", English source text.
    std::set<ImportShape> shapes;
  };
  std::vector<Kind> kinds{};
  std::vector<FileKind> files{};     ///< What can be read.
  std::vector<std::string> units{};  ///< As `reading.unit` takes them.
  std::function<ImportLook(const Document&, const std::filesystem::path&, const ImportReading&)> look{};
  /// The document with what was chosen of one file, as entries that name the file. The file is read again as the
  /// document will read it.
  /// @error BadValue: nothing is chosen, what was chosen cannot be said of this file; those of reading.
  std::function<base::Result<Imported>(Document, const ImportLook&, const ImportFile&)> take_in{};
};

}  // namespace dobra::scenario
