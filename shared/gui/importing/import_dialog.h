#pragma once
// Asks how files are to be brought into a document: a preview, how each is read, what each line is. OK is there only
// where all that is taken can be read as the document will read it; else the dialog says why not.

#include <QDialog>
#include <QTimer>
#include <functional>

#include "shared/gui/importing/import_model.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;
class QTableWidget;
class QTabWidget;

namespace dobra::gui::importing {

class ImportPreview;
class LineList;

/// A message about the input, in the words of the window.
using Wording = std::function<QString(const base::Error&)>;

class ImportDialog : public QDialog {
  Q_OBJECT

 public:
  /// @pre `program` outlives the dialog and can import.
  ImportDialog(const scenario::Program& program, const scenario::Document& document,
               const std::vector<std::filesystem::path>& files, Wording wording, QWidget* parent = nullptr);

  /// The document with what was chosen. @pre the dialog was accepted
  [[nodiscard]] const scenario::Document& document() const { return made_->document; }
  /// "Import 'top.csv'": for the Undo menu.
  [[nodiscard]] QString what() const;
  [[nodiscard]] ImportModel& model() { return model_; }
  /// What was changed or guessed is judged anew after a short pause; at once from here.
  void judge();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* make_file_row();
  QWidget* make_lines_page();
  QWidget* make_reading_page();
  QComboBox* add_choice(QFormLayout* form, const QString& title, const char* name);
  void show_file(std::size_t file);
  void show_reading();
  void show_table();
  void show_lines();
  /// What is said in the form, to the model.
  void read_again();
  [[nodiscard]] std::optional<QString> asked_above(const base::Error& error) const;
  void choose_kind(int index);
  void apply_rule();
  void selection_changed();
  [[nodiscard]] std::vector<std::size_t> selected_lines() const;
  [[nodiscard]] std::vector<scenario::Importing::Kind> kinds_of_selection() const;
  void changed();

  ImportModel model_;
  Wording wording_;
  std::size_t file_ = 0;
  std::set<std::size_t> axis_chosen_;  ///< Files of which the user has said where heights grow.
  std::optional<scenario::Imported> made_;
  QTimer pause_;
  bool showing_ = false;  ///< The form is being filled: nothing is said by the user.

  QComboBox* files_ = nullptr;
  QCheckBox* take_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  LineList* list_ = nullptr;
  QTableView* lines_ = nullptr;
  QComboBox* kind_ = nullptr;
  QLineEdit* pattern_ = nullptr;
  QComboBox* pattern_kind_ = nullptr;
  QPushButton* apply_ = nullptr;
  QLabel* rules_ = nullptr;
  QTableWidget* table_ = nullptr;
  QComboBox *x_ = nullptr, *map_y_ = nullptr, *height_ = nullptr, *names_ = nullptr;
  QComboBox *separator_ = nullptr, *axis_ = nullptr, *unit_ = nullptr;
  QFormLayout* reading_ = nullptr;
  QLineEdit* corners_ = nullptr;
  QPushButton* all_alike_ = nullptr;
  ImportPreview* preview_ = nullptr;
  QLabel* message_ = nullptr;
  QPushButton* ok_ = nullptr;
};

}  // namespace dobra::gui::importing
