#pragma once
// How a file of lines is read: format, columns, unit, axes, the plane of lines in space, kinds.
// Pages: docs/scenario_format.md, docs/user/import.md

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "shared/io/formats/line_files.h"
#include "shared/scenario/lines/line_keys.h"

namespace dobra::scenario::lines {

enum class FileUnit { File, Metre, Kilometre, Foot, Inch, Centimetre, Millimetre };
enum class FileAxis { File, Up, Down };

/// What is said of one file of lines, without repairs. A base of the structs that hold it.
struct LineReading {
  std::string format, columns, name_columns;
  io::lines::Separator separator = io::lines::Separator::Detect;
  io::formats::Coordinates coordinates = io::formats::Coordinates::Detect;
  std::vector<double> trace, fold_axis;
  std::optional<double> plane_tolerance, reference, exaggeration;
  FileAxis y_axis = FileAxis::File;
  FileUnit unit = FileUnit::File;

  template <class P, class D>
  static void describe_in(D& d, const char* when = "") {
    LineKeys<P, D> keys(d, when);
    keys.format();
    keys.columns();
    keys.name_columns();
    keys.separator();
    keys.coordinates();
    keys.trace();
    keys.fold_axis();
    keys.plane_tolerance();
    keys.y_axis("file");
    keys.reference();
    keys.unit("file", {io::formats::file_units.begin(), io::formats::file_units.end()});
    keys.exaggeration();
  }
  bool operator==(const LineReading&) const = default;
};

/// The error of a key that cannot be taken, as the one who asks calls it.
using RefuseKey = std::function<base::Error(const std::string& key, const std::string& what)>;
/// BadValue: "key: what".
base::Error bad_key(const std::string& key, const std::string& what);

/// @error `refuse` with the key.
base::Result<io::formats::LineOptions> line_options(const LineReading& reading, const RefuseKey& refuse = bad_key);
/// Of a list of four numbers, or of trend and plunge in degrees; nothing of an empty list. @error as above
base::Result<std::optional<io::lines::Trace>> trace_of(const std::vector<double>& numbers,
                                                       const RefuseKey& refuse = bad_key);
base::Result<std::optional<io::lines::FoldAxis>> fold_axis_of(const std::vector<double>& numbers,
                                                              const RefuseKey& refuse = bad_key);
/// Of texts such as "F*=fault". @error as above
base::Result<std::vector<io::lines::KindRule>> kind_rules(const std::vector<std::string>& texts,
                                                          const RefuseKey& refuse = bad_key);

}  // namespace dobra::scenario::lines
