// Whoever hears a window instead of seeing it: each control that takes the focus has a name, and no two neighbours have
// the same, in both programs with every example, every operation's form, every panel and every dialog.

#include <QAccessible>
#include <QAction>
#include <QDialog>
#include <QDockWidget>
#include <QDropEvent>
#include <QMimeData>
#include <QTimer>
#include <map>
#include <set>

#include "shared/gui/actions/palette.h"
#include "shared/gui/documents/edit.h"
#include "shared/gui/importing/import_dialog.h"
#include "shared/gui/mending/error_bar.h"
#include "tests/gui/program_window.h"
#include "tests/shared/gui/brazilian.h"

namespace {

using namespace dobra;

std::string path_of(const QWidget* widget) {
  std::string path;
  for (; widget != nullptr; widget = widget->parentWidget())
    path += std::string(widget->metaObject()->className()) + "(" + widget->objectName().toStdString() + ") ";
  return path;
}

QString name_of(QWidget* widget) {
  QAccessibleInterface* heard = QAccessible::queryAccessibleInterface(widget);
  return heard == nullptr ? QString() : heard->text(QAccessible::Name);
}

/// @return how many controls there are.
int judge_names(QWidget& top, const std::string& where) {
  int controls = 0;
  std::map<const QWidget*, std::map<QString, QWidget*>> siblings;
  QWidget* before = nullptr;
  QWidget* widget = &top;
  std::set<QWidget*> seen;
  const auto judge = [&](QWidget* control) {
    if (!seen.insert(control).second) return;
    if (!control->isVisibleTo(&top) || control->focusPolicy() == Qt::NoFocus || control->focusProxy() != nullptr)
      return;
    ++controls;
    const QString name = name_of(control);
    EXPECT_TRUE(std::any_of(name.begin(), name.end(), [](QChar c) { return c.isLetter(); }))
        << where << ": no name: " << path_of(control);
    QWidget*& other = siblings[control->parentWidget()][name];
    EXPECT_EQ(other, nullptr) << where << ": '" << name.toStdString() << "' twice: " << path_of(control);
    other = control;
    if (before != nullptr && !before->isAncestorOf(control) && !control->isAncestorOf(before)) {
      EXPECT_NE(name_of(before), name) << where << ": neighbours: " << path_of(before) << "\n" << path_of(control);
    }
    before = control;
  };
  // In the order in which Tab goes, and then whatever that does not reach.
  do {
    if (&top == widget || top.isAncestorOf(widget)) judge(widget);
    widget = widget->nextInFocusChain();
  } while (widget != &top);
  before = nullptr;
  for (QWidget* each : top.findChildren<QWidget*>()) judge(each);
  return controls;
}

/// Opens a question, judges it and answers no.
int judge_question(const std::function<void()>& open, const std::string& where) {
  int controls = -1;
  QTimer clock;
  int waited = 0;
  QObject::connect(&clock, &QTimer::timeout, &clock, [&] {
    QWidget* dialog = QApplication::activeModalWidget();
    if (dialog == nullptr || !dialog->isVisible()) {
      if (++waited > 500) clock.stop();
      return;
    }
    clock.stop();
    controls = judge_names(*dialog, where);
    if (auto* question = qobject_cast<QDialog*>(dialog)) question->reject();
  });
  clock.start(10);
  open();
  (void)QTest::qWaitFor([&] { return controls >= 0; }, 5000);
  clock.stop();
  EXPECT_GT(controls, 0) << where << " was not opened";
  return controls;
}

void show_all_panels(gui::MainWindow& window) {
  for (auto* panel : window.findChildren<QDockWidget*>()) {
    panel->show();
    panel->raise();
    QCoreApplication::processEvents();
    judge_names(*panel, panel->objectName().toStdString());
  }
}

class Names : public testing::TestWithParam<const char*> {};

TEST_P(Names, OfEveryControlWithAnExampleAreThereAndTellNeighboursApart) {
  test::ProgramWindow window(GetParam());
  window.open();
  show_all_panels(*window);
  for (std::size_t part = 0; part <= window.document().steps.size(); ++part) {
    window->select(part);
    QCoreApplication::processEvents();
    EXPECT_GT(judge_names(*window, std::string(GetParam()) + " part " + std::to_string(part)), 20);
  }
  window.focus();
  window.press(Qt::Key_L);
  window.write_keys("1");  // the field of a place
  judge_names(*window, "typing a place");
}

INSTANTIATE_TEST_SUITE_P(Examples, Names,
                         testing::Values("recon/chain.toml", "recon/cosine.toml", "recon/fold.toml",
                                         "recon/listric.toml", "recon/thrust.toml", "quebra/cracked_plate.toml",
                                         "quebra/edge_crack.toml", "quebra/plate_with_hole.toml"));

/// Every operation's form, with one entry in each of its lists; the input's too.
void judge_forms(const char* example, bool all_choices) {
  test::ProgramWindow window(example);
  window.open();
  const scenario::Program& program = window->session().program();
  std::vector<std::string> operations{""};
  for (const scenario::Operation& operation : program.operations) operations.push_back(operation.name);
  int lists = 0;
  for (const std::string& operation : operations) {
    scenario::Document document = gui::documents::empty_document(program);
    if (!operation.empty()) document = gui::documents::with_step(std::move(document), 0, operation);
    window->session().begin(std::move(document));
    window.come_to_rest();
    window->select(operation.empty() ? 0 : 1);
    QCoreApplication::processEvents();
    EXPECT_GT(judge_names(window->form(), operation), 0);
    QList<QAbstractButton*> adders;
    for (auto* button : window->form().findChildren<QAbstractButton*>()) {
      if (button->objectName().startsWith("add.") && button->isVisibleTo(&window->form())) adders.push_back(button);
    }
    for (const QString& name : [&] {
           QStringList names;
           for (auto* button : adders) names << button->objectName();
           return names;
         }()) {
      for (int twice = 0; twice < 2; ++twice) {
        auto* button = window->form().findChild<QAbstractButton*>(name);
        if (button == nullptr) break;
        button->click();
        QCoreApplication::processEvents();
        ++lists;
      }
    }
    if (!adders.isEmpty()) judge_names(window->form(), operation + " with entries");
    if (!all_choices) continue;
    for (const scenario::Field& field :
         scenario::fields_in(gui::documents::fields_of(window.document(), program, operation.empty() ? 0 : 1), {})) {
      for (const std::string& choice : field.choices) {
        scenario::Document chosen = window.document();
        scenario::Table table = gui::documents::table_of(chosen, operation.empty() ? 0 : 1);
        table.set(field.key, choice);
        window->session().edit(gui::documents::with_table(std::move(chosen), operation.empty() ? 0 : 1, table), "");
        judge_names(window->form(), operation + " " + field.key + "=" + choice);
      }
    }
  }
  EXPECT_GT(lists, 1);
}

TEST(NamesOfForms, OfReconAreThereForEveryOperationAndChoice) { judge_forms("recon/fold.toml", true); }
TEST(NamesOfForms, OfQuebraAreThereForEveryOperationAndChoice) { judge_forms("quebra/plate_with_hole.toml", true); }
TEST(NamesOfForms, InPortugueseToo) {
  const test::Brazilian language;
  judge_forms("recon/fold.toml", false);
  judge_forms("quebra/plate_with_hole.toml", false);
}

class NamesOfQuestions : public testing::TestWithParam<const char*> {};

TEST_P(NamesOfQuestions, AndOfPagesAndBarsAreThere) {
  test::ProgramWindow window(GetParam());
  const bool recon = std::string(GetParam()).starts_with("recon");
  window->welcome();
  QCoreApplication::processEvents();
  EXPECT_GT(judge_names(*window, "welcome page"), 5);
  window.open();
  // The palette is a window of its own.
  ASSERT_TRUE(window->actions().trigger("help.palette"));
  QCoreApplication::processEvents();
  gui::actions::Palette& palette = window->palette();
  ASSERT_TRUE(palette.isVisible());
  EXPECT_GE(judge_names(palette, "palette"), 1);
  palette.hide();
  judge_question([&] { window->actions().trigger("help.keys"); }, "keys");
  judge_question([&] { window->actions().trigger("help.about"); }, "about");
  const auto draw = [&] {
    window.focus();
    window.press(Qt::Key_L);
    window.click(window->view().plot(0).center());
    window.click(window->view().plot(0).center() + QPointF(30, 10));
    window.press(Qt::Key_Return);
  };
  judge_question(draw, "what was drawn");
  judge_question(
      [&] { emit window->canvas().rename_asked(recon ? "horizon" : "outline", recon ? "Limestone" : "plate"); },
      "name and kind");
  // Files: the dialog that asks what they are.
  const std::filesystem::path file = window.write("lines.csv", "x,z,name\n0,0,a\n1,1,a\n2,0,b\n3,1,b\n");
  judge_question(
      [&] {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(QString::fromStdString(file.string()))});
        QDragEnterEvent enter({400, 300}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&*window, &enter);
        QDropEvent drop(QPointF(400, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&*window, &drop);
      },
      "import");
  // What is not saved.
  scenario::Document other = window.document();
  other.title = "Another";
  window->session().edit(std::move(other), "title");
  judge_question([&] { window->close(); }, "unsaved");
  EXPECT_TRUE(window->isVisible());
  // An error stands in its bar.
  EXPECT_FALSE(window->open("/nowhere/there.toml").ok());
  EXPECT_TRUE(window->error_bar().isVisible());
  judge_names(window->error_bar(), "error bar");
}

INSTANTIATE_TEST_SUITE_P(Programs, NamesOfQuestions, testing::Values("recon/fold.toml", "quebra/cracked_plate.toml"));

}  // namespace
