#include "shared/gui/importing/file_filter.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QFileDialog>
#include <QTimer>
#include <QToolButton>
#include <memory>

#include "shared/gui/field_editor.h"
#include "tests/shared/gui/brazilian.h"

namespace dobra::gui::importing {
namespace {

const std::vector<scenario::FileKind> kinds{{"Text", {".csv", ".txt"}}, {"Neutral file", {".nf"}}};

TEST(FileFilter, OffersAllAtOnceThenEachKindThenAllFiles) {
  EXPECT_EQ(file_filter(kinds).toStdString(),
            "All that can be read (*.csv *.txt *.nf);;Text (*.csv *.txt);;Neutral file (*.nf);;All files (*)");
  EXPECT_EQ(file_filter({kinds[1]}).toStdString(), "Neutral file (*.nf);;All files (*)");
  EXPECT_EQ(file_filter({}).toStdString(), "");
}

TEST(FileFilter, SpeaksTheLanguageOfTheUser) {
  const test::Brazilian language;
  EXPECT_EQ(file_filter(kinds).toStdString(),
            "Tudo o que pode ser lido (*.csv *.txt *.nf);;Texto (*.csv *.txt);;Arquivo neutro (*.nf);;"
            "Todos os arquivos (*)");
}

TEST(FileFilter, IsThatOfTheDialogOfAField) {
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  scenario::Field field{"file", scenario::Kind::File, {.title = "File", .files = kinds}, {}, {}, {}};
  const std::unique_ptr<QWidget> editor(make_field_editor(field, {}, nullptr));
  QStringList offered;
  QTimer::singleShot(0, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    offered = dialog->nameFilters();
    dialog->reject();
  });
  editor->findChild<QToolButton*>()->click();
  ASSERT_EQ(offered.size(), 4);
  EXPECT_EQ(offered[0].toStdString(), "All that can be read (*.csv *.txt *.nf)");
  EXPECT_EQ(offered[2].toStdString(), "Neutral file (*.nf)");
}

}  // namespace
}  // namespace dobra::gui::importing
