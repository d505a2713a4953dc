#pragma once
// Files that a user is bringing into a document: how each is read, what it holds, what becomes of each line. No Qt.
// Page: docs/user/import.md.

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "shared/scenario/program.h"

namespace dobra::gui::importing {

/// Who says what kind a line is.
enum class KindFrom { File, Name, Shape, Rule, User };

class ImportModel {
 public:
  /// @pre `program` outlives the model and can import.
  ImportModel(const scenario::Program& program, scenario::Document document,
              const std::vector<std::filesystem::path>& files);

  [[nodiscard]] std::size_t size() const { return files_.size(); }
  [[nodiscard]] const std::filesystem::path& path(std::size_t file) const { return files_[file].said.file; }
  [[nodiscard]] const scenario::ImportLook& look(std::size_t file) const { return files_[file].look; }
  [[nodiscard]] const scenario::ImportReading& reading(std::size_t file) const { return files_[file].said.reading; }
  [[nodiscard]] const std::vector<scenario::ImportRule>& rules(std::size_t file) const {
    return files_[file].said.rules;
  }
  /// One a line of the look.
  [[nodiscard]] const std::vector<scenario::ImportChoice>& choices(std::size_t file) const {
    return files_[file].said.choices;
  }
  [[nodiscard]] KindFrom kind_from(std::size_t file, std::size_t line) const { return files_[file].from[line]; }
  [[nodiscard]] bool taken(std::size_t file) const { return files_[file].taken; }
  [[nodiscard]] const scenario::Importing& importing() const { return program_.importing; }
  /// The kinds that a line of the shape may be.
  [[nodiscard]] std::vector<scenario::Importing::Kind> kinds_for(scenario::ImportShape shape) const;

  /// Reads the file again, in this way; what the user has said of lines that are still there stays.
  void read_as(std::size_t file, const scenario::ImportReading& reading);
  /// All files that can be read as this one is: separator, columns, axis and unit alike.
  void read_all_as(std::size_t file);
  void take(std::size_t file, bool taken) { files_[file].taken = taken; }
  void take_lines(std::size_t file, const std::vector<std::size_t>& lines, bool taken);
  /// Lines whose shape the kind is not for stay as they are. @return how many are of the kind now.
  std::size_t set_kind(std::size_t file, const std::vector<std::size_t>& lines, const std::string& kind);
  /// A pattern goes before those that were given earlier, and before what the user has said of single lines that fit.
  /// @return how many lines of the file fit it.
  std::size_t add_rule(std::size_t file, const scenario::ImportRule& rule);
  void drop_rules(std::size_t file);

  /// The document with all that is taken. @error why that cannot be, with the file.
  [[nodiscard]] base::Result<scenario::Imported> result() const;

 private:
  using LineKey = std::pair<std::string, scenario::ImportShape>;
  struct File {
    scenario::ImportFile said;
    scenario::ImportLook look;
    std::vector<KindFrom> from;
    std::map<LineKey, std::string> kinds;  ///< Of single lines, by the user.
    std::set<LineKey> left_out;
    bool taken = true;
  };
  static LineKey key_of(const scenario::ImportLine& line) { return {line.name, line.shape}; }
  void choose(File& file) const;

  const scenario::Program& program_;
  scenario::Document document_;
  std::vector<File> files_;
};

}  // namespace dobra::gui::importing
