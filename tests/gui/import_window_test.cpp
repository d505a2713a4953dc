// The import dialog of both programs, driven with the mouse and the keys.

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QTest>
#include <QTimer>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <tuple>

#include "quebra/core/operations.h"
#include "recon/core/operations.h"
#include "shared/gui/importing/import_dialog.h"
#include "shared/gui/main_window.h"
#include "shared/gui/theme/colors.h"
#include "shared/gui/vtk_widget.h"
#include "shared/scenario/entries.h"
#include "shared/scenario/runner.h"
#include "tests/shared/gui/brazilian.h"
#include "tests/shared/gui/fake_program.h"

namespace dobra::gui {
namespace {

using importing::ImportDialog;

/// What Qt says of painting goes to the test, which fails.
void fail_on_painting(QtMsgType, const QMessageLogContext&, const QString& words) {
  if (words.startsWith("QPainter") || words.startsWith("QPaint")) ADD_FAILURE() << words.toStdString();
}

class ImportWindow : public testing::Test {
 protected:
  ~ImportWindow() override { qInstallMessageHandler(nullptr); }
  ImportWindow() {
    qInstallMessageHandler(fail_on_painting);
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window, 10000));
  }
  /// Lets go of the files over the window, and does `work` in the dialog that comes up.
  void drop(const std::vector<std::filesystem::path>& files, const std::function<void(ImportDialog&)>& work) {
    QMimeData data;
    QList<QUrl> urls;
    for (const auto& file : files) urls.push_back(QUrl::fromLocalFile(QString::fromStdString(file.string())));
    data.setUrls(urls);
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window, &enter);
    ASSERT_TRUE(enter.isAccepted());
    bool seen = false;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, [&] {
      auto* dialog = qobject_cast<ImportDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || seen) return;
      seen = true;
      look.stop();
      EXPECT_TRUE(QTest::qWaitForWindowActive(dialog, 5000));
      work(*dialog);
      if (dialog->isVisible()) QTest::keyClick(dialog, Qt::Key_Escape);
    });
    look.start(20);
    QDropEvent let_go({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window, &let_go);
    ASSERT_TRUE(QTest::qWaitFor([&] { return seen && QApplication::activeModalWidget() == nullptr; }, 20000));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.session().busy(); }, 30000));
  }
  template <class Widget = QWidget>
  static Widget* part(ImportDialog& dialog, const char* name) {
    auto* found = dialog.findChild<Widget*>(QString("import.") + name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  static void click(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton); }
  /// With the keys: opened, moved to, Enter.
  static void choose(QComboBox* box, const QString& words) {
    box->setFocus();
    const int at = box->findText(words, Qt::MatchStartsWith);
    ASSERT_GE(at, 0) << words.toStdString();
    for (int tries = 0; box->currentIndex() != at && tries < 50; ++tries)
      QTest::keyClick(box, box->currentIndex() < at ? Qt::Key_Down : Qt::Key_Up);
    ASSERT_EQ(box->currentIndex(), at);
  }
  static void click_row(QTableView* table, int row, Qt::KeyboardModifiers keys = {}) {
    const QRect place = table->visualRect(table->model()->index(row, 1));
    QTest::mouseClick(table->viewport(), Qt::LeftButton, keys, place.center());
  }
  static bool can_import(ImportDialog& dialog) {
    QPushButton* ok = part<QPushButton>(dialog, "ok");
    QTest::qWait(300);  // judged after a pause
    return ok->isEnabled();
  }
  static std::string message(ImportDialog& dialog) { return part<QLabel>(dialog, "message")->text().toStdString(); }
  static void shot(QWidget& widget, const char* name) {
    const std::filesystem::path folder = std::filesystem::path(DOBRA_BIN_DIR).parent_path() / "screenshots";
    std::filesystem::create_directories(folder);
    const std::string file =
        (folder / (std::string(name) + (widget.devicePixelRatio() > 1.5 ? "_200" : "") + ".png")).string();
    EXPECT_TRUE(widget.grab().save(QString::fromStdString(file)));
  }
  std::string text() { return scenario::document_text(window.session().document()); }
  std::vector<std::string> rules() {
    const auto lines = scenario::entries_of(window.session().document().input, "lines");
    const auto* found = lines.empty() ? nullptr : lines[0].find("kind");
    return found == nullptr ? std::vector<std::string>() : std::get<std::vector<std::string>>(*found);
  }

  test::TemporaryFolder folder;
  MainWindow window{recon::core::program()};
};

const char* lines = R"(x,z,name
0,0,Top Sand
500,60,Top Sand
1000,10,Top Sand
0,-250,Base
500,-180,Base
1000,-240,Base
640,130,F3
420,-380,F3
0,130,Topo
1000,135,Topo
)";

TEST_F(ImportWindow, ADroppedFileIsBroughtInAsTheDialogSaysInOneStepOfUndo) {
  const auto file = folder.write("lines.csv", lines);
  const std::string before = text();
  drop({file}, [&](ImportDialog& dialog) {
    EXPECT_TRUE(can_import(dialog));
    auto* table = part<QTableView>(dialog, "lines");
    ASSERT_EQ(table->model()->rowCount(), 4);
    EXPECT_EQ(table->model()->index(3, 1).data().toString(), "Topography");
    EXPECT_EQ(table->model()->index(3, 2).data().toString(), "guess: its name");
    EXPECT_EQ(table->model()->index(2, 1).data().toString(), "Horizon");
    auto* pattern = part<QLineEdit>(dialog, "pattern");
    click(pattern);
    QTest::keyClicks(pattern, "F?");
    choose(part<QComboBox>(dialog, "pattern_kind"), "Fault");
    click(pattern);
    QTest::keyClick(pattern, Qt::Key_Return);  // applies; the dialog stays
    ASSERT_TRUE(dialog.isVisible());
    EXPECT_EQ(table->model()->index(2, 1).data().toString(), "Fault");
    EXPECT_EQ(table->model()->index(2, 2).data().toString(), "pattern");
    click_row(table, 1);
    choose(part<QComboBox>(dialog, "kind"), "Eroded");
    EXPECT_EQ(table->model()->index(1, 2).data().toString(), "chosen");
    shot(dialog, "import_lines");
    EXPECT_TRUE(can_import(dialog)) << message(dialog);
    click(part(dialog, "ok"));
  });
  EXPECT_EQ(rules(), (std::vector<std::string>{"Base=eroded", "Topo=topography", "F?=fault"}));
  ASSERT_TRUE(window.session().outcome()->run.complete());
  EXPECT_EQ(window.session().history().undo_text(), "Import 'lines.csv'");
  window.session().undo();
  EXPECT_EQ(text(), before);
}

TEST_F(ImportWindow, WhatCannotBeReadIsSaidAndNothingChanges) {
  const std::string before = text();
  std::string noise;
  for (int i = 0; i < 4000; ++i) noise += static_cast<char>((i * 7919) % 256);
  const std::pair<const char*, std::string> files[] = {
      {"empty.csv", ""}, {"noise.csv", noise}, {"one.csv", "x,z\n1,2\n"}, {"noise.png", noise}, {"a.xyzzy", "1 2\n"}};
  for (const auto& [name, content] : files) {
    drop({folder.write(name, content)}, [&](ImportDialog& dialog) {
      EXPECT_FALSE(can_import(dialog)) << name;
      EXPECT_FALSE(message(dialog).empty()) << name;
      QTest::keyClick(&dialog, Qt::Key_Return);  // OK is off: Enter is nothing
      EXPECT_TRUE(dialog.isVisible());
    });
  }
  EXPECT_EQ(text(), before);
  EXPECT_FALSE(window.session().history().can_undo());
}

TEST_F(ImportWindow, ColumnsAxisAndUnitAreAskedBesideTheFirstRows) {
  const auto file = folder.write("picks.txt", "1 7 0.1\n2 8 0.2\n3 9 0.1\n");
  drop({file}, [&](ImportDialog& dialog) {
    EXPECT_FALSE(can_import(dialog));
    EXPECT_EQ(part<QTabWidget>(dialog, "tabs")->currentIndex(), 1);
    shot(dialog, "import_columns");
    choose(part<QComboBox>(dialog, "height"), "3");
    EXPECT_TRUE(can_import(dialog)) << message(dialog);
    choose(part<QComboBox>(dialog, "axis"), "depth");
    choose(part<QComboBox>(dialog, "unit"), "km");
    EXPECT_TRUE(can_import(dialog)) << message(dialog);
    QTest::keyClick(part(dialog, "ok"), Qt::Key_Space);
  });
  const auto horizons = scenario::entries_of(window.session().document().input, "horizon");
  ASSERT_EQ(horizons.size(), 1U) << text();
  EXPECT_EQ(scenario::text_in(horizons[0], "y_axis"), "down");
  EXPECT_EQ(scenario::text_in(horizons[0], "unit"), "km");
  EXPECT_EQ(scenario::text_in(horizons[0], "name"), "picks");
  EXPECT_TRUE(window.session().outcome()->run.complete()) << text();
}

TEST_F(ImportWindow, AColumnThatItsHeaderCallsDepthsIsTakenAsDepthsWhenItIsChosen) {
  const auto file = folder.write("dpe.csv", "E,depth,error\n0,900,1\n100,950,3\n200,1000,2\n");
  drop({file}, [&](ImportDialog& dialog) {
    EXPECT_FALSE(can_import(dialog));
    auto* axis = part<QComboBox>(dialog, "axis");
    choose(part<QComboBox>(dialog, "height"), "3");
    EXPECT_EQ(axis->currentData().toString(), "");
    choose(part<QComboBox>(dialog, "height"), "2");
    EXPECT_EQ(axis->currentData().toString(), "down");
    shot(dialog, "import_depths");
    choose(part<QComboBox>(dialog, "height"), "3");
    EXPECT_EQ(axis->currentData().toString(), "");
    choose(part<QComboBox>(dialog, "height"), "2");
    EXPECT_TRUE(can_import(dialog)) << message(dialog);
    QTest::keyClick(part(dialog, "ok"), Qt::Key_Space);
  });
  const auto horizons = scenario::entries_of(window.session().document().input, "horizon");
  ASSERT_EQ(horizons.size(), 1U) << text();
  EXPECT_EQ(scenario::text_in(horizons[0], "y_axis"), "down");
  // Saved, the document names the file from where it stands.
  std::filesystem::create_directory(file.parent_path() / "sub");
  ASSERT_TRUE(window.session().save(file.parent_path() / "sub/saved.toml").ok());
  const auto saved = scenario::entries_of(window.session().document().input, "horizon");
  EXPECT_EQ(scenario::text_in(saved.at(0), "file"), "../dpe.csv");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.session().busy(); }, 30000));
  EXPECT_TRUE(window.session().outcome()->run.complete()) << text();
}

TEST_F(ImportWindow, NegativeDepthsThatAreChosenStayWhatTheFileSays) {
  const auto file = folder.write("tvdss.csv", "E,depth,error\n0,-900,1\n100,-950,3\n200,-1000,2\n");
  drop({file}, [&](ImportDialog& dialog) {
    choose(part<QComboBox>(dialog, "height"), "3");
    choose(part<QComboBox>(dialog, "height"), "2");
    EXPECT_EQ(part<QComboBox>(dialog, "axis")->currentData().toString(), "");
  });
}

TEST_F(ImportWindow, PlacesOnTheMapAreChosenWithAColumnOfY) {
  const auto file = folder.write("map.csv", "x,y,height\n300,400,5\n330,440,6\n360,480,4\n");
  drop({file}, [&](ImportDialog& dialog) {
    EXPECT_FALSE(can_import(dialog));
    EXPECT_NE(message(dialog).find("y too"), std::string::npos) << message(dialog);
    choose(part<QComboBox>(dialog, "height"), "3");
    choose(part<QComboBox>(dialog, "map_y"), "2");
    EXPECT_TRUE(can_import(dialog)) << message(dialog);
    shot(dialog, "import_map");
    click(part(dialog, "ok"));
  });
  const auto horizons = scenario::entries_of(window.session().document().input, "horizon");
  ASSERT_EQ(horizons.size(), 1U) << text();
  EXPECT_EQ(std::get<std::vector<double>>(*horizons[0].find("columns")), (std::vector<double>{1, 2, 3}));
  EXPECT_TRUE(window.session().outcome()->run.complete()) << text();
}

TEST_F(ImportWindow, WhatIsSaidOfAFileSpeaksTheWordsOfTheDialog) {
  const std::pair<const char*, const char*> files[] = {{"x,depth\n0,-900\n100,-950\n", "'Second coordinate'"},
                                                       {"x,z_ft\n0,-900\n100,-950\n", "'Unit of the coordinates'"},
                                                       {"x,TWT_ms\n0,900\n100,950\n", "times"},
                                                       {"lon,lat\n0,900\n100,950\n", "degrees"},
                                                       {"1,234 5,678\n2,345 6,789\n", "'1,234' may be"},
                                                       {"name,kind,east,alt\nA,bed,0,5\nA,bed,9,5\n", "choose which"},
                                                       {"name,x,y,z\nA,0,1,5\nA,10,1,6\n", "choose which"},
                                                       {"x,z,layer\n0,5,A\n9,5,A\n0,3,B\n9,3,B\n", "'Column of names'"},
                                                       {"z,name,x\n5,A,0\n6,A,10\n", "'How the file is read'"}};
  for (const auto& [content, words] : files) {
    drop({folder.write("said.csv", content)}, [&](ImportDialog& dialog) {
      can_import(dialog);
      const std::string said = message(dialog);
      EXPECT_NE(said.find(words), std::string::npos) << content << said;
      EXPECT_EQ(said.find("--"), std::string::npos) << content << said;
      EXPECT_EQ(said.find(" = "), std::string::npos) << content << said;
    });
  }
}

TEST_F(ImportWindow, ThePreviewIsDarkBesideDarkWidgets) {
  const auto file = folder.write("lines.csv", lines);
  const auto corner = [&] {
    QRgb seen = 0;
    drop({file}, [&](ImportDialog& dialog) {
      shot(dialog, "import_theme");
      seen = part(dialog, "preview")->grab().toImage().pixel(3, 3);
    });
    return QColor(seen).lightness();
  };
  EXPECT_GT(corner(), 200);
  theme::apply(theme::Theme::Dark);
  EXPECT_LT(corner(), 80);
  theme::apply(theme::Theme::Light);
}

/// A line that is copied and pasted beside itself gets a name that is free.
TEST_F(ImportWindow, ALineThatIsPastedBesideItselfIsProposedAFreeName) {
  const auto file = folder.write("own.toml",
                                 "dobra = 1\nprogram = \"recon\"\n[input]\n[[input.horizon]]\nname = \"Top\"\n"
                                 "points = [[0, 0], [900, 0]]\n");
  ASSERT_TRUE(window.open(file).ok());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.session().busy(); }, 30000));
  QApplication::clipboard()->setText("# Top\n0\t50\n900\t60\n");
  QString proposed;
  QTimer look;
  QObject::connect(&look, &QTimer::timeout, [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    look.stop();
    proposed = dialog->findChild<QLineEdit*>("name")->text();
    QTest::keyClick(dialog->findChild<QLineEdit*>("name"), Qt::Key_Return);
  });
  look.start(20);
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 5000));
  window.view().setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.view().hasFocus(); }, 5000));
  // The dialog opens within the key press.
  QTimer::singleShot(0, [&] { QTest::keyClick(&window.view(), Qt::Key_V, Qt::ControlModifier); });
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return !proposed.isEmpty() && QApplication::activeModalWidget() == nullptr; }, 10000));
  EXPECT_EQ(proposed.toStdString(), "Top (2)");
  const auto horizons = scenario::entries_of(window.session().document().input, "horizon");
  ASSERT_EQ(horizons.size(), 2U) << text();
  EXPECT_EQ(scenario::text_in(horizons[1], "name"), "Top (2)");
}

TEST_F(ImportWindow, FilesThatAreDroppedTogetherComeInTogether) {
  const auto a = folder.write("a.csv", "x,z\n0,0\n100,5\n");
  const auto b = folder.write("b.csv", "x,z\n0,-50\n100,-45\n");
  const auto bad = folder.write("bad.csv", "x,z\nhere,there\n");
  drop({a, bad, b}, [&](ImportDialog& dialog) {
    EXPECT_FALSE(can_import(dialog));
    EXPECT_NE(message(dialog).find("bad.csv"), std::string::npos) << message(dialog);
    auto* files = part<QComboBox>(dialog, "files");
    choose(files, "bad.csv");
    click(part(dialog, "take_file"));
    QTest::keyClick(part(dialog, "take_file"), Qt::Key_Space);
    if (can_import(dialog)) {
      ADD_FAILURE() << "ticked twice: it is taken again";
    }
    QTest::keyClick(part(dialog, "take_file"), Qt::Key_Space);
    EXPECT_TRUE(can_import(dialog)) << message(dialog);
    click(part(dialog, "ok"));
  });
  EXPECT_EQ(scenario::entries_of(window.session().document().input, "horizon").size(), 2U) << text();
  window.session().undo();
  EXPECT_FALSE(window.session().history().can_undo());
}

TEST_F(ImportWindow, ALineIsLeftOutByItsTickAndFoundByAClickInThePreview) {
  const auto file = folder.write("lines.csv", lines);
  drop({file}, [&](ImportDialog& dialog) {
    auto* table = part<QTableView>(dialog, "lines");
    table->setFocus();
    click_row(table, 0);
    table->setCurrentIndex(table->model()->index(0, 0));
    QTest::keyClick(table, Qt::Key_Space);
    EXPECT_EQ(table->model()->index(0, 0).data(Qt::CheckStateRole).toInt(), Qt::Unchecked);
    QWidget* preview = part(dialog, "preview");
    for (int y = preview->height() - 1; y > preview->height() / 2 && table->selectionModel()->isRowSelected(0); --y)
      QTest::mouseClick(preview, Qt::LeftButton, {}, {preview->width() / 2, y});
    EXPECT_FALSE(table->selectionModel()->isRowSelected(0));
    EXPECT_EQ(table->selectionModel()->selectedRows().size(), 1);
    EXPECT_TRUE(can_import(dialog)) << message(dialog);
    click(part(dialog, "ok"));
  });
  EXPECT_EQ(text().find("Top Sand"), std::string::npos) << text();
  EXPECT_NE(text().find("feature = \"Base\""), std::string::npos) << text();
}

TEST_F(ImportWindow, ThousandsOfLinesKeepTheDialogAlive) {
  std::string many = "x,z,name\n";
  for (int i = 0; i < 5000; ++i)
    many += "0," + std::to_string(i) + ",line " + std::to_string(i) + "\n900," + std::to_string(i) + ",line " +
            std::to_string(i) + "\n";
  const auto file = folder.write("many.csv", many);
  drop({file}, [&](ImportDialog& dialog) {
    auto* table = part<QTableView>(dialog, "lines");
    EXPECT_EQ(table->model()->rowCount(), 5000);
    const std::clock_t begun = std::clock();  // the processor's: what else the machine does is not counted
    table->setFocus();
    QTest::keyClick(table, Qt::Key_A, Qt::ControlModifier);
    choose(part<QComboBox>(dialog, "kind"), "Loose");
    EXPECT_TRUE(can_import(dialog)) << message(dialog);
    EXPECT_LT(static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC, 60.0);
  });
}

/// As spreadsheets and old machines write them: the same three points, whatever stands around them.
TEST_F(ImportWindow, UntidyTextsComeInAsTheyAreMeant) {
  const std::pair<const char*, std::string> files[] = {
      {"bom.csv", "\xEF\xBB\xBFx,z\r\n0,1.5\r\n10,2.5\r\n20,1.5\r\n"},
      {"empty lines.txt", "\n\n# picked by hand\n0   1.5\n\t10\t2.5   \n20 1.5"},
      {"mac.txt", "0 1.5\r10 2.5\r20 1.5\r"},
      {"exponents.txt", "0 15e-1\n1.0E1 2.5e+0\n20 1.5\n"}};
  for (const auto& [name, content] : files) {
    drop({folder.write(name, content)}, [&](ImportDialog& dialog) {
      EXPECT_TRUE(can_import(dialog)) << name << ": " << message(dialog);
      click(part(dialog, "ok"));
    });
    ASSERT_TRUE(window.session().outcome() && window.session().outcome()->input) << name << "\n" << text();
    std::vector<geom::Polyline> shown;
    for (const scene::Panel& panel : window.session().outcome()->input->panels) {
      for (const scene::Layer& layer : panel.layers) {
        const auto* all = std::get_if<scene::Lines>(&layer.content);
        if (all != nullptr) shown.insert(shown.end(), all->lines.begin(), all->lines.end());
      }
    }
    const std::vector<geom::Point> meant{{0, 1.5}, {10, 2.5}, {20, 1.5}};
    EXPECT_TRUE(std::any_of(shown.begin(), shown.end(), [&](const auto& line) { return line.points == meant; }))
        << name << "\n"
        << text();
    window.session().undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.session().busy(); }, 30000));
  }
}

TEST_F(ImportWindow, WhatIsWrongInAFileIsSaidWithItsLine) {
  const std::pair<std::string, const char*> files[] = {
      {"x;z\n0;1\n10,2\n20;3\n", "mixed.csv:3"}, {"x,z\n0,1\n10,two\n20,3\n", "mixed.csv:3"},
      {"x,z\n0,1\n10\n20,3\n", "mixed.csv:3"},   {"x,z\n0,1\n10,nan\n20,3\n", "mixed.csv:3"},
      {"x,z\n0,1\n10,1e999\n", "mixed.csv:3"},   {"x;z\n0;1.5\n10;2,5\n20;1\n", "mixed.csv:3"}};
  for (const auto& [content, place] : files) {
    drop({folder.write("mixed.csv", content)}, [&](ImportDialog& dialog) {
      EXPECT_FALSE(can_import(dialog)) << content;
      EXPECT_NE(message(dialog).find(place), std::string::npos) << content << message(dialog);
      EXPECT_EQ(message(dialog).find("--"), std::string::npos) << "speaks of a command line: " << message(dialog);
    });
  }
  EXPECT_FALSE(window.session().history().can_undo());
}

TEST_F(ImportWindow, AFolderAFileThatIsGoneAndOneThatCannotBeReadAreSaid) {
  const auto closed = folder.write("closed.csv", "0,1\n2,3\n");
  std::filesystem::permissions(closed, std::filesystem::perms::none);
  std::filesystem::create_directory(folder / "folder.csv");
  std::vector<std::filesystem::path> files{folder / "folder.csv", folder / "gone.csv"};
  if (!std::ifstream(closed)) files.push_back(closed);  // root reads everything
  for (const auto& file : files) {
    drop({file}, [&](ImportDialog& dialog) {
      EXPECT_FALSE(can_import(dialog));
      EXPECT_NE(message(dialog).find(file.filename().string()), std::string::npos) << message(dialog);
    });
  }
  std::filesystem::permissions(closed, std::filesystem::perms::owner_all);
}

TEST_F(ImportWindow, ADroppedScenarioIsOpenedWithoutTheDialog) {
  const auto file = folder.write("a.toml",
                                 "dobra = 1\nprogram = \"recon\"\ntitle = \"mine\"\n[[input.horizon]]\n"
                                 "name = \"A\"\npoints = [[0, 0], [9, 1]]\n");
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString(file.string()))});
  QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&window, &enter);
  QDropEvent let_go({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&window, &let_go);
  QTest::qWait(200);
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  EXPECT_EQ(window.session().document().title, "mine");
  EXPECT_FALSE(window.session().history().can_undo());
}

/// The dialog takes less than five seconds where there are no sanitizers. With four times the points the processor's
/// time grows less than eight times, the power 1.5 of their number, in every build.
TEST_F(ImportWindow, TwoHundredThousandPointsComeIn) {
  const auto seconds_for = [&](int points, bool taken) {
    std::string many = "x,z\n";
    for (int i = 0; i < points; ++i) many += std::to_string(i) + "," + std::to_string((i * 7919) % 101) + "\n";
    const auto file = folder.write("many.csv", many);
    QElapsedTimer clock;
    clock.start();
    const std::clock_t begun = std::clock();
    double seconds = 0.0;
    drop({file}, [&](ImportDialog& dialog) {
      EXPECT_TRUE(can_import(dialog)) << message(dialog);
      EXPECT_EQ(part<QTableView>(dialog, "lines")->model()->index(0, 3).data().toString(), QString::number(points));
      seconds = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
#ifndef __SANITIZE_ADDRESS__
      EXPECT_LT(clock.elapsed(), 5000);
#endif
      if (taken) click(part(dialog, "ok"));
    });
    return seconds;
  };
  const double few = seconds_for(50'000, false);
  EXPECT_LT(seconds_for(200'000, true), 8.0 * few);
  EXPECT_LT(text().size(), 500U);  // the file stays the source
}

TEST_F(ImportWindow, EveryWidgetOfTheDialogHasANameAndIsWhole) {
  const test::Brazilian language;
  const auto a = folder.write("linhas.csv", lines);
  const auto b = folder.write("picks.txt", "1 7 0.1\n2 8 0.2\n3 9 0.1\n");
  drop({a, b}, [&](ImportDialog& dialog) {
    shot(dialog, "import_lines_pt_BR");
    for (const QWidget* widget : dialog.findChildren<QWidget*>()) {
      if (!widget->isVisible() || widget->focusPolicy() == Qt::NoFocus) continue;
      const auto* button = qobject_cast<const QAbstractButton*>(widget);
      const bool inner = widget->objectName().startsWith("qt_") || qobject_cast<const QAbstractScrollArea*>(widget) ||
                         widget->metaObject()->className() == std::string("QTabBar") ||
                         qobject_cast<const QSplitterHandle*>(widget);
      EXPECT_TRUE(inner || !widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty()))
          << widget->metaObject()->className() << " " << widget->objectName().toStdString();
    }
    part<QTabWidget>(dialog, "tabs")->setCurrentIndex(1);
    choose(part<QComboBox>(dialog, "files"), "picks.txt");
    QTest::qWait(300);
    shot(dialog, "import_columns_pt_BR");
    const QSize room = dialog.screen()->availableSize();
    EXPECT_LE(dialog.width(), room.width());
    EXPECT_LE(dialog.height(), room.height());
  });
}

/// Clicks the line at `on`, and takes one of its vertices along the way; nothing snaps.
void drag_vertex(MainWindow& window, geom::Point on, const std::vector<geom::Point>& way) {
  VtkWidget& view = window.view();
  const auto pixel = [&](geom::Point p) { return view.pixel_of(0, p).toPoint(); };
  QTest::keyClick(&window, Qt::Key_S);
  QTest::mouseClick(&view, Qt::LeftButton, {}, pixel(on));
  QTest::mousePress(&view, Qt::LeftButton, {}, pixel(way.front()));
  for (const geom::Point p : way) {
    QMouseEvent move(QEvent::MouseMove, pixel(p), view.mapToGlobal(pixel(p)), Qt::NoButton, Qt::LeftButton,
                     Qt::AltModifier);
    QCoreApplication::sendEvent(&view, &move);
  }
  QTest::mouseRelease(&view, Qt::LeftButton, Qt::AltModifier, pixel(way.back()));
}

TEST(ImportWindowQuebra, ADrawingIsBroughtInAndItsCurveDragged) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("plate.csv",
                                 "x,y,name\n0,0,plate\n10,0,plate\n10,6,plate\n0,6,plate\n0,0,plate\n"
                                 "2,3,crack 1\n4,3,crack 1\n");
  MainWindow window(quebra::core::program());
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, 10000));
  QTimer::singleShot(200, [] {
    auto* dialog = qobject_cast<ImportDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    QTest::qWait(300);
    QTest::mouseClick(dialog->findChild<QWidget*>("import.ok"), Qt::LeftButton);
  });
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString(file.string()))});
  QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&window, &enter);
  QDropEvent let_go({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&window, &let_go);
  const auto quiet = [&] { return !window.session().busy() && QApplication::activeModalWidget() == nullptr; };
  QTest::qWait(100);
  ASSERT_TRUE(QTest::qWaitFor(quiet, 20000));
  ASSERT_TRUE(window.session().outcome() && window.session().outcome()->run.complete());
  ASSERT_NE(window.session().document().input.find("file"), nullptr);
  QCoreApplication::processEvents();
  // The crack's line is selected by a click, its end dragged.
  drag_vertex(window, {3, 3}, {{4, 3}, {4.5, 3.5}, {5.2, 4.1}});
  ASSERT_TRUE(QTest::qWaitFor(quiet, 20000));
  const scenario::Table& input = window.session().document().input;
  EXPECT_EQ(input.find("file"), nullptr) << scenario::document_text(window.session().document());
  auto cracks = scenario::entries_of(input, "crack");
  ASSERT_EQ(cracks.size(), 1U);
  const auto points = scenario::points_in(cracks[0]);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0], (geom::Point{2, 3}));
  EXPECT_NEAR(points[1].x, 5.2, 0.15);
  EXPECT_NEAR(points[1].y, 4.1, 0.15);
  window.session().undo();
  EXPECT_NE(window.session().document().input.find("file"), nullptr);
}

/// Curves of a file, dragged and kept in a file beside: the source stays, undo gives back every byte, and what is
/// opened again and run by a runner is the same.
TEST(ImportWindowQuebra, EditedCurvesAreKeptInAFileBesideWhereAskedFor) {
  const test::TemporaryFolder folder;
  const std::string source =
      "x,y,name\n0,0,plate\n10,0,plate\n10,6,plate\n0,6,plate\n0,0,plate\n"
      "2,3,crack 1\n4,3,crack 1\n";
  folder.write("plate.csv", source);
  const std::string toml =
      "# mine\ndobra = 1\nprogram = \"quebra\"\n\n[input]\nfile =   \"plate.csv\"\n"
      "kind = [\"crack*=crack\"]\n";
  const auto file = folder.write("plate.toml", toml);
  MainWindow window(quebra::core::program());
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, 10000));
  ASSERT_TRUE(window.open(file));
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window, 5000));
  const auto quiet = [&] { return !window.session().busy(); };
  ASSERT_TRUE(QTest::qWaitFor(quiet, 20000));
  QCoreApplication::processEvents();
  drag_vertex(window, {3, 3}, {{4, 3}, {4.5, 3.5}, {5.2, 4.1}});
  ASSERT_TRUE(QTest::qWaitFor(quiet, 20000));
  auto* said = window.findChild<QLabel*>("taken_in_bar.words");
  ASSERT_NE(said, nullptr);
  EXPECT_TRUE(said->isVisible());
  EXPECT_TRUE(said->text().contains("plate.csv")) << said->text().toStdString();
  const std::filesystem::path shots = std::filesystem::path(DOBRA_BIN_DIR).parent_path() / "screenshots";
  std::filesystem::create_directories(shots);
  EXPECT_TRUE(window.grab().save(QString::fromStdString((shots / "taken_in.png").string())));
  QTest::mouseClick(window.findChild<QPushButton*>("taken_in_bar.beside"), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor(quiet, 20000));
  EXPECT_FALSE(said->isVisible());
  QTest::keyClick(&window.view(), Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(folder.read("plate.csv"), source);
  EXPECT_EQ(folder.read("plate.toml").find("points"), std::string::npos) << folder.read("plate.toml");
  EXPECT_NE(folder.read("plate.toml").find("lines_file = \"plate.lines.toml\""), std::string::npos);
  EXPECT_NE(folder.read("plate.lines.toml").find("[[input.crack]]"), std::string::npos);
  EXPECT_EQ(window.session().changed_on_disk(), std::nullopt);
  const std::string report =
      scenario::report_json(window.session().document(), quebra::core::program(), window.session().outcome()->run);
  const auto read = scenario::read_document(file);
  ASSERT_TRUE(read) << base::to_string(read.error());
  scenario::Runner runner(quebra::core::program());
  EXPECT_EQ(scenario::report_json(*read, quebra::core::program(), runner.run(*read)), report);
  // The same picture in another window.
  MainWindow again(quebra::core::program());
  ASSERT_TRUE(again.open(file));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !again.session().busy(); }, 20000));
  const auto lines_of = [](MainWindow& of) {
    std::map<std::pair<std::string, std::uint32_t>, geom::Polyline> lines;
    for (const scene::Panel& panel : of.session().outcome()->input->panels) {
      for (const scene::Layer& layer : panel.layers) {
        const auto* all = std::get_if<scene::Lines>(&layer.content);
        for (std::uint32_t i = 0; all != nullptr && i < all->lines.size(); ++i) lines[{layer.key, i}] = all->lines[i];
      }
    }
    return lines;
  };
  EXPECT_EQ(lines_of(again), lines_of(window));
  // Another program changes the file beside: that is seen.
  folder.write("plate.lines.toml", folder.read("plate.lines.toml") + "# theirs\n");
  EXPECT_EQ(window.session().changed_on_disk(), folder / "plate.lines.toml");
  // Undone to the end and saved: the first bytes.
  for (int k = 0; k < 2; ++k) QTest::keyClick(&window.view(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(window.session().history().can_undo());
  ASSERT_TRUE(window.save(file));
  EXPECT_EQ(folder.read("plate.toml"), toml);
  EXPECT_EQ(folder.read("plate.csv"), source);
}

/// What the bar offers is not lost without it: the action of the menu says it both ways, and saving elsewhere takes the
/// lines along under the new name.
TEST(ImportWindowQuebra, LinesGoBesideAndBackByTheMenuAndAlongWithSaveAs) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("a.toml",
                                 "dobra = 1\nprogram = \"recon\"\n\n[[input.horizon]]\nname = \"A\"\n"
                                 "points = [[0, 0], [9, 1]]\n");
  folder.write("a.lines.toml", "somebody's");
  MainWindow window(recon::core::program());
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, 10000));
  ASSERT_TRUE(window.open(file));
  auto* action = window.findChild<QAction*>("file.lines_beside");
  ASSERT_NE(action, nullptr);
  EXPECT_FALSE(action->isChecked());
  action->trigger();
  EXPECT_TRUE(action->isChecked());
  ASSERT_TRUE(window.save(file));
  EXPECT_EQ(folder.read("a.lines.toml"), "somebody's");
  EXPECT_NE(folder.read("a (2).lines.toml").find("points"), std::string::npos);
  ASSERT_TRUE(window.save(folder / "b.toml"));
  EXPECT_NE(folder.read("b.toml").find("\"b.lines.toml\""), std::string::npos) << folder.read("b.toml");
  EXPECT_NE(folder.read("b.lines.toml").find("points"), std::string::npos);
  folder.write("c.lines.toml", "theirs");
  EXPECT_FALSE(window.save(folder / "c.toml"));
  EXPECT_EQ(folder.read("c.lines.toml"), "theirs");
  EXPECT_EQ(window.session().document().file, folder / "b.toml");
  action->trigger();
  EXPECT_FALSE(action->isChecked());
  ASSERT_TRUE(window.save(folder / "b.toml"));
  EXPECT_NE(folder.read("b.toml").find("points"), std::string::npos);
  EXPECT_EQ(folder.read("b.toml").find("lines_file"), std::string::npos);
}

/// A named point and the place of a region, dragged: the run goes along, one step of Undo each gives every byte back.
TEST(ImportWindowQuebra, PointsAndRegionsAreDraggedLiveInOneStepOfUndo) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("a.toml", R"(dobra = 1
program = "quebra"

[[input.curve]]
name = "plate"
kind = "polygon"
points = [[0, 0], [10, 0], [10, 6], [0, 6]]

[[input.region]]
name = "rock"
point = [3, 2]

[[input.point]]
name = "gauge"
point = [7, 4]
)");
  MainWindow window(quebra::core::program());
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, 10000));
  window.activateWindow();
  ASSERT_TRUE(window.open(file));
  const auto quiet = [&] { return !window.session().busy(); };
  ASSERT_TRUE(QTest::qWaitFor(quiet, 20000));
  QCoreApplication::processEvents();
  VtkWidget& view = window.view();
  const auto pixel = [&](geom::Point p) { return view.pixel_of(0, p).toPoint(); };
  const auto marked = [&](const std::string& layer) {
    for (const scene::Panel& panel : window.session().outcome()->input->panels) {
      for (const scene::Layer& one : panel.layers) {
        const auto* markers = std::get_if<scene::Markers>(&one.content);
        if (one.key == layer && markers != nullptr && !markers->points.empty()) return markers->points.front();
      }
    }
    return geom::Point{-1, -1};
  };
  const auto move_to = [&](geom::Point p) {
    QMouseEvent move(QEvent::MouseMove, pixel(p), view.mapToGlobal(pixel(p)), Qt::NoButton, Qt::LeftButton,
                     Qt::AltModifier);
    QCoreApplication::sendEvent(&view, &move);
    ASSERT_TRUE(QTest::qWaitFor(quiet, 20000));
  };
  QTest::keyClick(&view, Qt::Key_S);
  for (const auto& [layer, from, to] : {std::tuple("regions", geom::Point{3, 2}, geom::Point{5, 3}),
                                        std::tuple("points", geom::Point{7, 4}, geom::Point{8, 5})}) {
    const std::string before = scenario::document_text(window.session().document());
    ASSERT_EQ(marked(layer), from);
    QTest::mousePress(&view, Qt::LeftButton, {}, pixel(from));
    for (const double t : {0.3, 0.6, 1.0}) {
      const geom::Point p = from + t * (to - from);
      move_to(p);
      EXPECT_NEAR(geom::distance(marked(layer), p), 0.0, 0.1) << layer << ": not live";
      EXPECT_EQ(scenario::document_text(window.session().document()), before);  // until it is let go
    }
    QTest::mouseRelease(&view, Qt::LeftButton, Qt::AltModifier, pixel(to));
    ASSERT_TRUE(QTest::qWaitFor(quiet, 20000));
    EXPECT_NEAR(geom::distance(marked(layer), to), 0.0, 0.1) << layer;
    EXPECT_NE(scenario::document_text(window.session().document()), before);
    window.session().undo();
    ASSERT_TRUE(QTest::qWaitFor(quiet, 20000));
    EXPECT_EQ(scenario::document_text(window.session().document()), before);
    EXPECT_FALSE(window.session().history().can_undo());
  }
}

/// The same with a section: the horizon of a text is dragged, and kept beside.
TEST(ImportWindowRecon, AnEditedHorizonOfAFileIsKeptBesideWhereAskedFor) {
  const test::TemporaryFolder folder;
  const std::string source = "x,z\r\n0,0\r\n500,60\r\n1000,10\r\n";
  folder.write("top.csv", source);
  const std::string toml =
      "dobra = 1\nprogram = \"recon\"\n\n[[input.horizon]]   # the roof\nname = \"top\"\n"
      "file = \"top.csv\"\n\n[[input.horizon]]\nname = \"base\"\npoints = [[0, -90], [1000, -90]]\n";
  const auto file = folder.write("a.toml", toml);
  MainWindow window(recon::core::program());
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, 10000));
  window.activateWindow();
  ASSERT_TRUE(window.open(file));
  const auto quiet = [&] { return !window.session().busy(); };
  ASSERT_TRUE(QTest::qWaitFor(quiet, 20000));
  QCoreApplication::processEvents();
  drag_vertex(window, {250, 30}, {{500, 60}, {510, 90}});
  ASSERT_TRUE(QTest::qWaitFor(quiet, 20000));
  ASSERT_TRUE(window.findChild<QLabel*>("taken_in_bar.words")->isVisible());
  QTest::mouseClick(window.findChild<QPushButton*>("taken_in_bar.beside"), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor(quiet, 20000));
  QTest::keyClick(&window.view(), Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(folder.read("top.csv"), source);
  EXPECT_EQ(folder.read("a.toml").find("points"), std::string::npos) << folder.read("a.toml");
  const std::string beside = folder.read("a.lines.toml");
  EXPECT_LT(beside.find("\"top\""), beside.find("\"base\"")) << beside;
  const std::string report =
      scenario::report_json(window.session().document(), recon::core::program(), window.session().outcome()->run);
  const auto read = scenario::read_document(file);
  ASSERT_TRUE(read) << base::to_string(read.error());
  scenario::Runner runner(recon::core::program());
  EXPECT_EQ(scenario::report_json(*read, recon::core::program(), runner.run(*read)), report);
  for (int k = 0; k < 2; ++k) QTest::keyClick(&window.view(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(window.save(file));
  EXPECT_EQ(folder.read("a.toml"), toml);
}

}  // namespace
}  // namespace dobra::gui
