#pragma once
// The keys by which scenarios and commands say how a file of lines is read and repaired: each is described here, once,
// for the inputs of both programs and for the options of every command that reads lines.
// Pages: docs/scenario_format.md, docs/user/import.md

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "shared/io/formats/format.h"
#include "shared/scenario/field.h"

namespace dobra::scenario::lines {

/// The formats for any of the uses, for fields that name a file; each once, in the order of the uses.
std::vector<FileKind> file_kinds(const std::vector<io::formats::Use>& uses);

/// The descriptions of the keys. P is any struct with members of these names; an optional one has no default.
template <class P, class D>
class LineKeys {
 public:
  /// @param when  the condition of all keys, "file is set" where points may be given instead.
  explicit LineKeys(D& d, std::string when = "") : d_(d), when_(std::move(when)) {}

  /// As a member of P where it is one of a base.
  template <class T, class B>
  static constexpr T P::*of(T B::*member) {
    return member;
  }

  void format() {
    field("format", of(&P::format),
          {.title = "Format",
           .help = "Of a file of lines; by its ending otherwise.",
           .words = io::formats::names_for(io::formats::Use::ReadLines)});
  }
  void columns() {
    field("columns", of(&P::columns),
          {.title = "Columns",
           .help = "Of a text: numbers from 1, or headers, of x and height, such as \"1,2\"; of x, y and height for "
                   "lines in space."});
  }
  void name_columns() {
    field("name_columns", of(&P::name_columns),
          {.title = "Columns of names", .help = "Of a text: their words name a line, which ends where they change."});
  }
  void separator() {
    choice("separator", of(&P::separator), {"detect", "blank", "tab", "comma", "semicolon"},
           {.title = "Separator", .help = "Between the columns of a text."});
  }
  void coordinates() {
    choice(
        "coordinates", of(&P::coordinates), {"detect", "section", "map"},
        {.title = "Coordinates", .help = "section: x and y as they stand; map: lines on a vertical plane in space."});
  }
  void trace() {
    field("trace", of(&P::trace),
          {.title = "Trace",
           .help = "The plane of lines in space: x and y of its beginning and its end on the map; found by least "
                   "squares otherwise.",
           .unit = "m"});
  }
  void fold_axis() {
    field("fold_axis", of(&P::fold_axis),
          {.title = "Fold axis",
           .help = "Trend and plunge of the axis along which lines in space are projected.",
           .unit = "deg"});
  }
  void plane_tolerance() {
    field("plane_tolerance", of(&P::plane_tolerance),
          {.title = "Plane tolerance",
           .help = "Largest distance of lines in space from their plane, as a part of the length.",
           .above = 0});
  }
  /// @param unsaid  the choice that leaves it to the file or the section, if there is one.
  void y_axis(const char* unsaid = nullptr) {
    choice("y_axis", of(&P::y_axis), after(unsaid, {"up", "down"}),
           {.title = "Heights grow",
            .help = "down, as depths and images do: the height is the reference less the value. As the file says "
                    "otherwise, else up."});
  }
  void reference() {
    field("reference", of(&P::reference),
          {.title = "Reference",
           .help = "With y_axis = \"down\": the value at height 0, in units of the file.",
           .when = "y_axis != up"});
  }
  void unit(const char* unsaid, std::vector<std::string> names) {
    choice(
        "unit", of(&P::unit), after(unsaid, std::move(names)),
        {.title = "Unit", .help = "Of the coordinates in the file; as the file says otherwise, else as the scenario."});
  }
  void exaggeration() {
    field("exaggeration", of(&P::exaggeration),
          {.title = "Exaggeration", .help = "Heights are stored this many times too large.", .above = 0});
  }
  void kind() {
    field("kind", of(&P::kind),
          {.title = "Kinds by names",
           .help = "Such as 'F*=fault'; the first that fits a name goes before the kind that the file gives."});
  }

  // Repairs.
  void order(const char* key = "order") {
    const FieldOptions options{.title = "Order of the points",
                               .help = "Unordered points are put in order along their curve, with a remark."};
    if constexpr (std::is_same_v<decltype(P::order), bool>) {
      field(key, of(&P::order), options);
    } else {
      choice(key, of(&P::order), {"as_given", "along_curve"}, options);
    }
  }
  void drop_duplicates() {
    length("drop_duplicates", of(&P::drop_duplicates), "Drop points nearer than",
           "To the one before; 0: none but equal ones.");
  }
  void join_gaps() {
    length("join_gaps", of(&P::join_gaps), "Join gaps below",
           "Parts of the same name whose ends are nearer become one line; 0: none.");
  }
  /// @param at_least  0 where 0 says another thing than nothing does.
  void snap_to_faults(std::optional<double> at_least = std::nullopt) {
    length(
        "snap_to_faults", of(&P::snap_to_faults), "Snap ends to faults",
        "Ends of horizons nearer to a fault than this are moved onto it, with a remark; 0: none. Left out, a section "
        "joins those that its rounded coordinates have parted.",
        at_least);
  }
  void share_edges() {
    length("share_edges", of(&P::share_edges), "Make polygons share edges",
           "Their vertices nearer than this to a line or another polygon are moved onto it; 0: none.");
  }
  void slivers() {
    length("slivers", of(&P::slivers), "Remove slivers",
           "Polygons and spikes of polygons thinner than this are removed, with a remark; 0: none.");
  }

 private:
  static std::vector<std::string> after(const char* unsaid, std::vector<std::string> names) {
    if (unsaid != nullptr) names.insert(names.begin(), unsaid);
    return names;
  }
  [[nodiscard]] FieldOptions with_condition(FieldOptions options) const {
    options.when = when_ + (when_.empty() || options.when.empty() ? "" : " and ") + options.when;
    return options;
  }
  template <class T>
  void field(const char* key, T P::*member, const FieldOptions& options) {
    d_.field(key, member, with_condition(options));
  }
  template <class E>
  void choice(const char* key, E P::*member, const std::vector<std::string>& names, const FieldOptions& options) {
    d_.choice(key, member, names, with_condition(options));
  }
  template <class T>
  void length(const char* key, T P::*member, const char* title, const char* help,
              std::optional<double> at_least = std::nullopt) {
    FieldOptions options{.title = title, .help = help, .unit = "m", .at_least = at_least};
    if constexpr (std::is_same_v<T, double>) options.at_least = 0.0;  // else the repair refuses what is not above 0
    d_.field(key, member, with_condition(options));
  }
  D& d_;
  std::string when_;
};

}  // namespace dobra::scenario::lines
