#pragma once
// The window of a program: the picture in the middle, steps and their parameters at the left, layers and results at the
// right. It holds no algorithm: it shows a Session and passes on what the user does.

#include <QMainWindow>
#include <filesystem>

#include "shared/gui/actions/find.h"
#include "shared/gui/actions/registry.h"
#include "shared/gui/documents/shown.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/player.h"
#include "shared/gui/session.h"
#include "shared/gui/step_list.h"
#include "shared/gui/theme/colors.h"
#include "shared/gui/view/settings.h"
#include "shared/gui/window_part.h"

class QBoxLayout;
class QDockWidget;
class QSplitter;
class QLabel;
class QMenu;
class QSettings;
class QToolBar;

namespace dobra::gui {

namespace actions {
class Palette;
}
class Canvas;
class DrawBar;
class ParameterForm;
class Results;
class VtkWidget;
namespace importing {
class TakenInBar;
}
namespace stage {
class SectionBar;
class SpaceWidget;
}  // namespace stage
namespace view {
class ExaggerationBox;
}
namespace vertices {
class VertexPanel;
}
namespace labels {
class StatusLine;
}
namespace mending {
class ErrorBar;
class Page;
}  // namespace mending
namespace welcome {
class Page;
}

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// @param part  what the program adds to its window.
  /// @pre `program` outlives the window.
  explicit MainWindow(const scenario::Program& program, WindowPart part = {});
  ~MainWindow() override;

  /// Opens without asking about unsaved changes; what went wrong is also said in the error bar.
  base::Result<void> open(const std::filesystem::path& file);
  /// As open. A scenario that cannot be read is shown as text, to be mended; where there is nothing to show, and no
  /// document, the welcome page stands below the message.
  base::Result<void> open_or_mend(const std::filesystem::path& file);
  /// One of the program's examples, as a document without a file; its input files stay in the user's folder of
  /// examples, where the document finds them wherever it is saved.
  base::Result<void> open_example(const std::string& file);
  /// An empty document, without asking about unsaved changes.
  void begin_new();
  /// Shows how to begin, instead of the picture, until something is begun.
  void welcome();
  /// Panels, bars and size as the last window left them; this one will leave its own when it is closed.
  void restore_layout();
  /// Panels, bars and size as at the first start.
  void reset_layout();
  base::Result<void> save(const std::filesystem::path& file);
  /// SVG, PDF and PNG with cairo, by the ending; layers as they are shown.
  base::Result<void> save_picture(const std::filesystem::path& file);
  /// The whole window as a PNG. @error CannotDraw if the view came out blank; CannotWrite.
  base::Result<void> save_screenshot(const std::filesystem::path& file);
  /// Asks whether what a window lost is to be taken up, if the document has any.
  void offer_recovery();
  /// Selects the input (0) or a step, and shows its form.
  void select(std::size_t part);
  /// Takes back the last point of what is being drawn, else the last edit. @return false if there is neither.
  bool undo();
  /// SVG, PDF and PNG of what stands in space, as it is looked at.
  base::Result<void> save_space_picture(const std::filesystem::path& file);
  /// "input", "result", "both"; remembered. @return false if it is none of them.
  bool look_at(const QString& what);

  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] Player& player() { return player_; }
  /// The step that the player would show: the one selected, else the last that can be watched; 0 if there is none.
  [[nodiscard]] std::size_t watched_part() const;
  [[nodiscard]] VtkWidget& view() { return *view_; }
  [[nodiscard]] stage::SpaceWidget& space() { return *space_; }
  [[nodiscard]] Canvas& canvas() { return *canvas_; }
  [[nodiscard]] DrawBar& draw_bar() { return *draw_bar_; }
  [[nodiscard]] actions::Registry& actions() { return actions_; }
  [[nodiscard]] actions::Palette& palette() { return *palette_; }
  [[nodiscard]] LayerTree& layers() { return *layers_; }
  [[nodiscard]] StepList& steps() { return *steps_; }
  [[nodiscard]] ParameterForm& form() { return *form_; }
  [[nodiscard]] vertices::VertexPanel& vertices() { return *vertices_; }
  [[nodiscard]] mending::ErrorBar& error_bar() { return *error_bar_; }

 protected:
  void childEvent(QChildEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void moveEvent(QMoveEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void make_center();
  void make_docks();
  /// Where panels are at first.
  /// Frame and all, as far as its panels let it; its title is on the screen in any case.
  void keep_on_screen();
  void place_docks();
  void make_actions();
  void add_file_actions();
  void add_edit_actions();
  void add_view_actions();
  void add_color_actions();
  void add_panel_action(QDockWidget& panel);
  void add_run_actions();
  void add_help_actions();
  void make_status_bar();
  void connect_session();
  void show_player();
  /// How the picture is looked at, and what is done with what is selected.
  void add_look_actions();
  void add_selection_actions();
  /// One of the settings of the view: a choice in a menu of its own.
  template <class Choice>
  void add_look_choices(const char* name, const char* title, Choice view::Settings::*setting,
                        const std::vector<std::tuple<Choice, const char*, const char*>>& choices);
  void add_look_switch(const char* name, const char* title, QKeySequence keys, std::function<void()> turn,
                       std::function<bool()> is_on);
  void set_exaggeration(const std::optional<double>& exaggeration);
  void show_look();
  /// The view in space, its actions, and what picking links in both views.
  void make_space_view();
  void add_space_actions();
  /// What the bar over the picture in space has: layers, colours, the section plane.
  void add_space_switches();
  void show_section(bool on);
  [[nodiscard]] std::vector<LayerTree::Listed> layers_in_space(const std::vector<std::string>& keys) const;
  [[nodiscard]] bool shows_layers(const std::vector<std::string>& keys) const;
  /// As the switches want it: without the colours of values.
  void without_colors(scene::Picture& plane) const;
  [[nodiscard]] bool has_space() const;
  /// Of the last run, as the list of layers has it; adds its layers to the `listed`.
  [[nodiscard]] std::optional<scene::space::SpacePicture> space_shown(scene::Picture& listed) const;
  void show_space(const std::optional<scene::space::SpacePicture>& picture);
  void show_views();
  void arrange_views();
  void point_at(const stage::ItemAt& item);
  /// Brings the panel into sight in which the item is drawn.
  void ask_for_panel(const stage::ItemAt& item);
  void add_asked_panel(scene::Picture& picture);
  /// Of what the section plane cuts, in the plane; made again as the plane moves.
  [[nodiscard]] std::optional<SectionMade> section_by(const scene::space::CutPlane& plane);
  void add_section_panel(scene::Picture& picture);
  void show_moved_section();
  /// As it is listed: with the panels that were asked for.
  [[nodiscard]] scene::Picture picture_wanted();
  void show_plane(const scene::Picture& picture);
  void ask_save_space_picture();
  [[nodiscard]] scene::Picture picture_shown() const;
  /// Whether the program has an operation that can be watched at work.
  [[nodiscard]] bool can_watch() const;
  /// What the palette offers now.
  [[nodiscard]] std::vector<actions::Choice> choices();
  void add_choices_of_document(std::vector<actions::Choice>& all);
  void show_keys();
  [[nodiscard]] theme::Theme kept_theme() const;
  [[nodiscard]] theme::CanvasChoice kept_canvas() const;
  void set_theme(theme::Theme theme);
  /// The canvas that is chosen, in the theme as it is.
  void show_canvas();
  void copy_step();
  void paste_step();
  void copy_command();
  [[nodiscard]] QString undo_text() const;
  [[nodiscard]] QString redo_text() const;

  /// Puts what is typed into the document. False, and the error bar says why, if some of it is refused.
  bool settle();
  void ask_open();
  bool ask_save();
  bool ask_save_as();
  void ask_save_picture();
  void ask_import();
  /// What becomes of lines that an edit has taken out of files is said, and asked.
  void make_taken_in_bar(QBoxLayout& column);
  void keep_lines_beside(bool beside);
  /// Asks how the files are to be read, and brings them into the document as one edit.
  void import_files(const std::vector<std::filesystem::path>& files);
  void open_asking(const std::filesystem::path& file);
  [[nodiscard]] QString open_filter() const;
  [[nodiscard]] const OtherFile* other_file(const std::filesystem::path& file) const;
  base::Result<void> begin_with(const OtherFile& kind, const std::filesystem::path& file);
  [[nodiscard]] QSettings settings() const;
  void remember_file(const std::filesystem::path& file);
  [[nodiscard]] QStringList recent_files() const;
  void fill_recent_menu(QMenu& list);
  /// False if the user wants to stay with the unsaved document.
  bool may_discard();
  /// The same of a text that is being mended.
  bool may_discard_text();
  void about();

  void leave_welcome();
  /// The text of a file that could not be read, in the place of the picture.
  void show_mending(const std::filesystem::path& file, const std::string& text, const base::Error& error);
  void save_mended();
  void leave_mending();
  void show_other_document();
  /// An empty sheet to draw on.
  void show_nothing();
  void show_document();
  void show_undo();
  void show_picture();
  void show_form();
  /// Those of the model before the part of the document whose form is shown.
  void offer_names(std::size_t part);
  void show_run_started();
  void show_progress(double fraction, const QString& what);
  void show_outcome();
  void show_error(const base::Error& error);
  void go_to_error();
  void go_to_place(const base::Place& place);
  void mark_place(const base::Place& place);
  [[nodiscard]] std::optional<std::pair<std::size_t, geom::Point>> place_in_plane(const base::Place& place) const;
  void mark_error();
  [[nodiscard]] std::vector<PartState> part_states() const;

  const scenario::Program& program_;
  WindowPart part_;
  Session session_;
  Player player_;
  actions::Registry actions_;
  actions::Palette* palette_ = nullptr;
  VtkWidget* view_ = nullptr;
  QWidget* space_side_ = nullptr;  ///< The picture in space with its bars.
  QToolBar* space_bar_ = nullptr;
  stage::SectionBar* section_ = nullptr;
  stage::SpaceWidget* space_ = nullptr;
  std::string
      asked_panel_;         ///< Of the plane, that the picture does not have: what was clicked in space is drawn there.
  bool colored_ = true;     ///< Surfaces have the colours of their values.
  bool has_plane_ = false;  ///< There is something to show in the plane.
  QSplitter* views_ = nullptr;
  enum class Views { Both, Plane, Space } looked_at_ = Views::Both;  ///< Where there is a picture in space.
  Canvas* canvas_ = nullptr;
  DrawBar* draw_bar_ = nullptr;
  QLabel* hint_ = nullptr;  ///< What to do where there is nothing to see yet.
  mending::ErrorBar* error_bar_ = nullptr;
  importing::TakenInBar* taken_in_bar_ = nullptr;
  welcome::Page* welcome_ = nullptr;
  mending::Page* mending_ = nullptr;
  bool keeps_layout_ = false;
  bool frame_known_ = false;  ///< The frame that the window manager draws has been taken into account.
  StepList* steps_ = nullptr;
  ParameterForm* form_ = nullptr;
  LayerTree* layers_ = nullptr;
  Results* results_ = nullptr;
  vertices::VertexPanel* vertices_ = nullptr;
  labels::StatusLine* status_ = nullptr;
  view::Settings look_;
  view::ExaggerationBox* exaggeration_ = nullptr;
  documents::Shown shown_ = documents::Shown::Result;
  std::optional<base::Error> error_;  ///< What the error bar says.
  std::size_t form_part_ = 0;         ///< Whose parameters the form shows.
  bool fit_next_ = true;              ///< The next picture is another document's: look at all of it.
};

}  // namespace dobra::gui
