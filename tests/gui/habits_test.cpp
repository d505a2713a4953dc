// What both programs' windows never do, whatever a person does: crash, lose, or show what is not the document's.
//   DOBRA_MONKEY=10000  how many things a monkey does in each document (default 60)
//   DOBRA_SEED=7        where chance begins

#include <gtest/gtest.h>

#include "shared/gui/canvas.h"
#include "shared/gui/documents/edit.h"
#include "shared/gui/parameter_form.h"
#include "shared/scenario/runner.h"
#include "tests/gui/examples_folder.h"
#include "tests/gui/monkey.h"

namespace {

using namespace dobra;

int number_of(const char* variable, int otherwise) {
  const char* said = std::getenv(variable);
  return said == nullptr ? otherwise : std::atoi(said);
}

/// A window among the examples.
class Habits : public testing::TestWithParam<const char*> {
 protected:
  Habits() {
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    window_ = std::make_unique<gui::MainWindow>(test::program_of(GetParam()), test::part_of(GetParam()));
    window_->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window_.get(), 20000));
  }
  ~Habits() override {
    window_->session().cancel();
    window_.reset();
  }

  gui::Session& session() { return window_->session(); }
  std::string text() { return scenario::document_text(session().document()); }
  void open() {
    ASSERT_TRUE(window_->open(examples_.file(GetParam())).ok());
    come_to_rest();
  }
  void come_to_rest() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !session().busy(); }, 120000));
    QCoreApplication::processEvents();
  }

  /// What holds at any time.
  void judge() {
    const std::string now = text();
    const base::Result<scenario::Document> again = scenario::parse_document(now, session().document().file);
    ASSERT_TRUE(again.ok()) << base::to_string(again.error()) << "\n" << now;
    ASSERT_EQ(scenario::document_text(*again), now);
    const base::Result<scenario::Document> saved =
        scenario::parse_document(scenario::saved_text(session().document()), session().document().file);
    ASSERT_TRUE(saved.ok()) << base::to_string(saved.error()) << "\n" << scenario::saved_text(session().document());
    ASSERT_EQ(scenario::document_text(*saved), now);
  }

  /// What the window shows is what a run from nothing makes of the document.
  void judge_result() {
    come_to_rest();
    session().run();
    come_to_rest();
    if (!session().outcome() || window_->player().watching()) return;
    const gui::documents::OutcomePtr outcome = session().outcome();
    if (outcome->run.error && outcome->run.error->code == base::ErrorCode::Cancelled) return;
    scenario::Runner fresh(session().program());
    const scenario::Run run = fresh.run(*outcome->document);
    ASSERT_EQ(scenario::report_json(*outcome->document, session().program(), outcome->run),
              scenario::report_json(*outcome->document, session().program(), run));
  }

  /// Back to the beginning and forth again, byte for byte.
  void judge_history() {
    while (window_->canvas().unfinished() && window_->undo()) {
    }
    const std::string now = text();
    int steps = 0;
    for (; session().history().can_undo(); ++steps) session().undo();
    judge();
    for (int i = 0; i < steps; ++i) session().redo();
    ASSERT_EQ(text(), now);
  }

  test::ExamplesFolder examples_;
  std::unique_ptr<gui::MainWindow> window_;
};

/// The files that an example names are found as long as it is untitled, and from wherever it is saved then.
TEST_P(Habits, AnExampleOpenedAsACopyFindsItsFiles) {
  const std::filesystem::path name = std::filesystem::path(GetParam()).filename();
  ASSERT_TRUE(window_->open_example(name.string()).ok());
  come_to_rest();
  EXPECT_TRUE(session().document().file.empty());
  EXPECT_FALSE(session().history().modified());
  const auto judge_run = [&](const char* when) {
    ASSERT_NE(session().outcome(), nullptr) << when;
    EXPECT_FALSE(session().outcome()->run.error) << when << ": " << session().outcome()->run.error->message;
  };
  judge_run("untitled");
  const std::filesystem::path far = examples_.file("far");
  std::filesystem::create_directories(far / "away");
  ASSERT_TRUE(window_->save(far / "away" / "mine.toml").ok());
  std::filesystem::current_path(far);
  ASSERT_TRUE(window_->open(far / "away" / "mine.toml").ok());
  come_to_rest();
  judge_run("saved");
}

/// An operation that can be watched, over an input in which nothing is yet.
TEST_P(Habits, NothingIsWatchedWhereThereIsNothingYet) {
  open();
  const std::size_t part = session().document().steps.size();
  const bool watched = window_->player().can_watch(part);
  scenario::Document document = session().document();
  document.input = {};
  document.steps.assign(1, {});
  document.steps[0].operation = "offset";
  session().edit(std::move(document), "Empty it");
  come_to_rest();
  window_->select(1);
  EXPECT_FALSE(window_->player().can_watch(1));
  for (const int key : {Qt::Key_F7, Qt::Key_F6}) {
    QTest::keyClick(window_.get(), static_cast<Qt::Key>(key));
    come_to_rest();
    EXPECT_FALSE(window_->player().watching());
  }
  session().undo();
  come_to_rest();
  EXPECT_EQ(window_->player().can_watch(part), watched);
}

/// A window that goes while something is being typed in it. The sanitizers judge.
TEST_P(Habits, TheWindowGoesWhateverHasTheFocus) {
  for (const int what : {0, 1, 2}) {
    open();
    QWidget* field = what == 0   ? window_->findChild<QWidget*>("exaggeration")
                     : what == 1 ? window_->form().findChild<QLineEdit*>()
                                 : static_cast<QWidget*>(&window_->view());
    ASSERT_NE(field, nullptr);
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get(), 5000));
    field->setFocus();
    QTest::keyClicks(QApplication::focusWidget(), "7");
    window_ = std::make_unique<gui::MainWindow>(test::program_of(GetParam()));
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get(), 20000));
  }
}

TEST_P(Habits, AMonkeyDoesNoHarm) {
  const int count = number_of("DOBRA_MONKEY", 60);
  const auto seed = static_cast<std::uint32_t>(number_of("DOBRA_SEED", 1));
  open();
  test::Monkey monkey(*window_, seed);
  for (int i = 1; i <= count; ++i) {
    monkey.act();
    if (i % 25 == 0) judge();
    if (i % 500 == 0 || i == count) {
      judge_result();
      judge_history();
    }
    if (HasFatalFailure()) FAIL() << GetParam() << ", seed " << seed << ", after " << i << ":\n" << monkey.last();
  }
}

/// Random edits of a document: lines of the picture, what the form writes, and steps.
class Editor {
 public:
  Editor(gui::Session& session, std::uint32_t seed) : session_(session), random_(seed) {}

  /// @return whether the document has become another.
  bool edit() {
    const int what = below(20);
    const base::Result<scenario::Document> made = what < 15 ? edit_line() : what == 15 ? add_line() : edit_step(what);
    if (!made) return false;
    session_.edit(*made, "An edit");
    return true;
  }

 private:
  static base::Error nothing() { return {base::ErrorCode::BadValue, "nothing to edit"}; }
  int below(std::size_t count) { return static_cast<int>(random_() % static_cast<std::uint32_t>(count)); }
  geom::Point near(geom::Point at) { return {at.x + below(2001) / 7.0 - 142.0, at.y + below(2001) / 7.0 - 142.0}; }

  base::Result<scenario::Document> edit_line() {
    const scenario::Document& document = session_.document();
    const scenario::Program& program = session_.program();
    const scenario::Context context{document.folder(), document.units, document.units};
    DOBRA_TRY(const scenario::State input, program.read_input(document.input, context, {}));
    const scene::Picture picture = program.picture_of(input);
    std::vector<std::pair<scene::Pick, geom::Polyline>> lines;
    for (const scene::Layer& layer : picture.panels.at(0).layers) {
      const auto* content = std::get_if<scene::Lines>(&layer.content);
      for (std::size_t i = 0; content != nullptr && i < content->lines.size(); ++i) {
        const auto id = content->ids.empty() ? static_cast<std::uint32_t>(i) : content->ids[i];
        lines.push_back({{layer.key, id}, content->lines[i]});
      }
    }
    if (lines.empty()) return nothing();
    auto [pick, line] = lines[static_cast<std::size_t>(below(lines.size()))];
    const int at = below(line.points.size());
    const int how = below(20);
    if (how < 14)
      line.points[static_cast<std::size_t>(at)] = near(line.points[static_cast<std::size_t>(at)]);
    else if (how < 17)
      line.points.insert(line.points.begin() + at, near(line.points[static_cast<std::size_t>(at)]));
    else if (how < 18 && line.points.size() > 3)
      line.points.erase(line.points.begin() + at);
    scene::LineEdit edit{pick, {line}};
    if (how >= 18 && lines.size() > 3) edit.becomes.clear();
    return program.drawing.edit(document, input, std::span(&edit, 1));
  }

  base::Result<scenario::Document> add_line() {
    const scenario::Drawing& drawing = session_.program().drawing;
    const scenario::Drawing::Kind& kind = drawing.kinds[static_cast<std::size_t>(below(drawing.kinds.size()))];
    geom::Polyline line;
    const int corners = kind.of == scenario::Drawing::Kind::Of::Points ? 1 : 3 + below(4);
    for (int i = 0; i < corners; ++i) line.points.push_back(near({500.0 * i, -100.0}));
    line.closed = kind.of == scenario::Drawing::Kind::Of::Polygons;
    return drawing.add(session_.document(), kind.table, "new " + std::to_string(++named_), line);
  }

  base::Result<scenario::Document> edit_step(int what) {
    const scenario::Document& document = session_.document();
    const std::size_t steps = document.steps.size();
    const auto& operations = session_.program().operations;
    if (what == 16 || steps == 0) {
      const auto& added = operations[static_cast<std::size_t>(below(operations.size()))];
      return gui::documents::with_step(document, static_cast<std::size_t>(below(steps + 1)), added.name);
    }
    const std::size_t part = 1 + static_cast<std::size_t>(below(steps));
    if (what == 17) return gui::documents::without_step(document, part);
    if (what == 18 && part < steps) return gui::documents::with_step_lowered(document, part);
    const std::vector<scenario::Field> fields = gui::documents::fields_of(document, session_.program(), part);
    if (fields.empty()) return nothing();
    const scenario::Field& field = fields[static_cast<std::size_t>(below(fields.size()))];
    scenario::Table table = gui::documents::table_of(document, part);
    if (field.kind == scenario::Kind::Number)
      table.set(field.key, below(1000001) / 977.0);
    else if (field.kind == scenario::Kind::Flag)
      table.set(field.key, below(2) == 0);
    else if (field.kind == scenario::Kind::Choice)
      table.set(field.key, field.choices[static_cast<std::size_t>(below(field.choices.size()))]);
    else
      table.erase(field.key);
    return gui::documents::with_table(document, part, table);
  }

  gui::Session& session_;
  std::mt19937 random_;
  int named_ = 0;
};

/// GUI-b: undo restores the previous dump, here ten thousand times over.
TEST_P(Habits, GUI_b_TenThousandEditsAreUndoneAndDoneAgainToTheByte) {
  open();
  Editor editor(session(), 11);
  std::vector<std::size_t> texts{std::hash<std::string>()(text())};
  const int count = number_of("DOBRA_EDITS", 100);
  for (int tries = 0; static_cast<int>(texts.size()) <= count && tries < 5 * count; ++tries) {
    if (editor.edit()) texts.push_back(std::hash<std::string>()(text()));
    // As the loop of a window does between two edits of a person.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  ASSERT_EQ(static_cast<int>(texts.size()), count + 1);
  const std::string last = text();
  for (std::size_t i = texts.size() - 1; i > 0; --i) {
    session().undo();
    ASSERT_EQ(std::hash<std::string>()(text()), texts[i - 1]) << i;
  }
  ASSERT_FALSE(session().history().can_undo());
  for (std::size_t i = 1; i < texts.size(); ++i) {
    session().redo();
    ASSERT_EQ(std::hash<std::string>()(text()), texts[i]) << i;
  }
  EXPECT_EQ(text(), last);
}

INSTANTIATE_TEST_SUITE_P(Documents, Habits,
                         testing::Values("recon/fold.toml", "recon/listric.toml", "quebra/plate_with_hole.toml",
                                         "quebra/cracked_plate.toml"),
                         [](const auto& document) {
                           std::string name = document.param;
                           for (char& c : name) {
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           }
                           return name;
                         });

}  // namespace
