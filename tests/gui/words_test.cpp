// The windows of both programs in Portuguese, with the examples: what a run found, and what a form offers, is said in
// words of that language, while the document and report.json keep their keys.

#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QTest>
#include <QTreeWidget>
#include <map>

#include "shared/canvas/entry.h"
#include "shared/gui/layer_tree.h"
#include "shared/gui/main_window.h"
#include "shared/gui/parameter_form.h"
#include "shared/gui/results.h"
#include "shared/gui/vtk_widget.h"
#include "tests/gui/examples_folder.h"
#include "tests/shared/gui/brazilian.h"

namespace {

using namespace dobra;

struct Example {
  const char* document;
  bool portuguese;
  friend void PrintTo(const Example& example, std::ostream* out) {
    *out << example.document << (example.portuguese ? " pt_BR" : " en");
  }
};

class Words : public testing::TestWithParam<Example> {
 protected:
  Words() {
    if (!GetParam().portuguese) return;
    brazilian_.emplace();
    canvas::set_decimal_mark(canvas::DecimalMark::Comma);
  }
  ~Words() override {
    if (window_) window_->session().cancel();
    window_.reset();
    canvas::set_decimal_mark(canvas::DecimalMark::Point);
  }
  void open() {
    window_ =
        std::make_unique<gui::MainWindow>(test::program_of(GetParam().document), test::part_of(GetParam().document));
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get(), 20000));
    ASSERT_TRUE(window_->open(examples_.file(GetParam().document)).ok());
    ASSERT_TRUE(QTest::qWaitFor([this] { return !window_->session().busy(); }, 120000));
    QCoreApplication::processEvents();
  }
  /// Key and item of each row of the results, groups too.
  std::map<QString, QTreeWidgetItem*> rows() {
    std::map<QString, QTreeWidgetItem*> all;
    const auto* tree = window_->findChild<gui::Results*>()->findChild<QTreeWidget*>();
    for (QTreeWidgetItemIterator item(const_cast<QTreeWidget*>(tree)); *item != nullptr; ++item)
      all[(*item)->toolTip(0)] = *item;
    return all;
  }
  static QString last_part(const QString& key) { return key.mid(key.lastIndexOf('.') + 1); }

  std::optional<test::Brazilian> brazilian_;
  test::ExamplesFolder examples_;
  std::unique_ptr<gui::MainWindow> window_;
};

TEST_P(Words, EachQuantityOfEachStateHasWords) {
  open();
  const auto& outcome = window_->session().outcome();
  const auto& program = test::program_of(GetParam().document);
  std::set<QString> keys;
  for (const scenario::State& state : outcome->run.states) {
    for (const scenario::Quantity& quantity : program.quantities_of(state))
      keys.insert(QString::fromStdString(quantity.name));
  }
  EXPECT_GE(keys.size(), 10u);
  for (const QString& key : keys) {
    EXPECT_NE(gui::catalogue::words_of_quantity(key), last_part(key)) << key.toStdString();
    const QString group = key.left(std::max<qsizetype>(key.lastIndexOf('.'), 0));
    if (group.isEmpty()) continue;
    EXPECT_NE(gui::catalogue::words_of_group(group), group) << key.toStdString();
  }
  // And so the table shows them, with the key under the pointer.
  const auto shown = rows();
  for (const scenario::Quantity& quantity : outcome->quantities) {
    const QString key = QString::fromStdString(quantity.name);
    ASSERT_EQ(shown.count(key), 1u) << quantity.name;
    EXPECT_EQ(shown.at(key)->text(0), gui::catalogue::words_of_quantity(key));
    EXPECT_FALSE(shown.at(key)->text(0).contains('_')) << quantity.name;
  }
}

TEST_P(Words, VerdictsAndRemarksAreSaidInTheLanguage) {
  open();
  const auto& outcome = window_->session().outcome();
  const QString said = window_->findChild<gui::Results*>()->findChild<QLabel*>()->text();
  EXPECT_EQ(said.contains(" expected "), !GetParam().portuguese && !outcome->verdicts.empty());
  EXPECT_EQ(said.contains(" esperado "), GetParam().portuguese && !outcome->verdicts.empty());
  if (!GetParam().portuguese) return;
  for (const std::string& remark : outcome->remarks) {
    EXPECT_TRUE(gui::catalogue::current().knows(QString::fromStdString(remark))) << remark;
    for (const char* english : {"balanced", "greatest", "shortening", "numbered", "tolerance"})
      EXPECT_FALSE(gui::catalogue::translated(QString::fromStdString(remark)).contains(english)) << remark;
  }
  for (const scenario::Verdict& verdict : outcome->verdicts) {
    EXPECT_TRUE(
        said.contains(QString::fromStdString(verdict.expect.quantity).toHtmlEscaped() + QString::fromUtf8(" é ")))
        << verdict.message;
  }
  EXPECT_FALSE(said.contains("+-"));
}

/// Fields, their hints, tables, results and verdicts; keys are no numbers.
TEST_P(Words, EachNumberInSightHasTheMarkOfTheLanguage) {
  open();
  const QRegularExpression wrong(GetParam().portuguese ? R"((?<![\w.^])\d+\.\d)" : R"((?<![\w,^])\d+,\d)");
  const QRegularExpression long_number(R"([1-9]\d*[.,]\d{6,}|[.,]0*[1-9]\d{6,})");
  std::size_t seen = 0;
  const auto judge = [&](const QString& words, const char* where) {
    ++seen;
    EXPECT_FALSE(wrong.match(words).hasMatch()) << where << ": " << words.toStdString();
  };
  for (std::size_t part = 0; part <= window_->session().document().steps.size(); ++part) {
    window_->select(part);
    QCoreApplication::processEvents();
    for (const QAbstractSpinBox* box : window_->form().findChildren<QAbstractSpinBox*>()) {
      judge(box->text(), "field");
      judge(box->property("dobra.hint").toString(), "hint");
    }
  }
  for (const auto& [key, row] : rows()) judge(row->text(1), "result");
  const QString said = window_->findChild<gui::Results*>()->findChild<QLabel*>()->text();
  EXPECT_FALSE(long_number.match(said).hasMatch()) << said.toStdString();
  auto& view = window_->view();
  for (std::size_t panel = 0; panel < view.panel_count(); ++panel) {
    const QRectF plot = view.plot(panel);
    QMouseEvent move(QEvent::MouseMove, plot.center(), view.mapToGlobal(plot.center()), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&view, &move);
    judge(window_->findChild<QLabel*>("status.place")->text(), "place");
  }
  EXPECT_GT(seen, 20U);
}

/// A comma is typed, shown and kept; the file has a point.
TEST_P(Words, ATypedCommaIsShownAsOneAndWrittenAsAPoint) {
  open();
  window_->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get(), 5000));
  for (std::size_t part = 1; part <= window_->session().document().steps.size(); ++part) {
    window_->select(part);
    QCoreApplication::processEvents();
    for (auto* box : window_->form().findChildren<QAbstractSpinBox*>()) {
      auto* line = box->findChild<QLineEdit*>();
      if (!box->isVisible() || line->text().contains('e')) continue;
      const std::string before = scenario::document_text(window_->session().document());
      box->setFocus();
      QTest::keyClick(line, Qt::Key_A, Qt::ControlModifier);
      QTest::keyClicks(line, "1,25");
      QTest::keyClick(line, Qt::Key_Return);
      if (scenario::document_text(window_->session().document()) == before) continue;  // a whole number is asked for
      EXPECT_EQ(line->text(), GetParam().portuguese ? "1,25" : "1.25");
      EXPECT_NE(scenario::document_text(window_->session().document()).find("= 1.25"), std::string::npos);
      return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Examples, Words,
                         testing::Values(Example{"recon/chain.toml", true}, Example{"recon/cosine.toml", true},
                                         Example{"recon/fold.toml", true}, Example{"recon/listric.toml", true},
                                         Example{"recon/thrust.toml", true}, Example{"quebra/cracked_plate.toml", true},
                                         Example{"quebra/edge_crack.toml", true},
                                         Example{"quebra/plate_with_hole.toml", true},
                                         Example{"recon/fold.toml", false}, Example{"recon/listric.toml", false},
                                         Example{"quebra/edge_crack.toml", false}));

class WordsOfListric : public Words {};

TEST_P(WordsOfListric, GroupsKeepNamesAndCopyKeepsTheKey) {
  open();
  const auto shown = rows();
  EXPECT_EQ(shown.at("since_input.horizon.Top (1)")->text(0), "Desde a entrada: horizonte Top (1)");
  EXPECT_EQ(shown.at("section")->text(0), QString::fromUtf8("Seção"));
  EXPECT_EQ(shown.at("section.units_area")->text(0), QString::fromUtf8("Área das unidades"));
  auto* tree = window_->findChild<gui::Results*>()->findChild<QTreeWidget*>();
  tree->setFocus();
  tree->setCurrentItem(shown.at("section.units_area"));
  QTest::keyClick(tree, Qt::Key_C, Qt::ControlModifier);
  const QStringList copied = QApplication::clipboard()->text().split('\t');
  ASSERT_EQ(copied.size(), 3);
  EXPECT_EQ(copied[0], "section.units_area");
  EXPECT_NEAR(copied[1].toDouble(), 1.47159e7, 100.0);  // with a point, whatever the language
  EXPECT_EQ(copied[2], "m2");
}

TEST_P(WordsOfListric, NumbersOfVerdictsHaveTheDecimalMark) {
  open();
  const QString said = window_->findChild<gui::Results*>()->findChild<QLabel*>()->text();
  EXPECT_TRUE(said.contains(QString::fromUtf8("move.shear_heave é -419,539"))) << said.toStdString();
  EXPECT_TRUE(said.contains(QString::fromUtf8(", esperado -420 ± 2"))) << said.toStdString();
}

INSTANTIATE_TEST_SUITE_P(Example, WordsOfListric, testing::Values(Example{"recon/listric.toml", true}));

class WordsOfThePlate : public Words {};

TEST_P(WordsOfThePlate, PanelsOfMeshesAreTitledInTheLanguage) {
  open();
  const auto* tree = window_->findChild<gui::LayerTree*>();
  ASSERT_GT(tree->topLevelItemCount(), 0);
  EXPECT_EQ(tree->topLevelItem(tree->topLevelItemCount() - 1)->text(0), "Malha 1: 1393 elementos");
}

TEST_P(WordsOfThePlate, ChoicesShowWordsAndTheDocumentKeepsCodes) {
  open();
  window_->select(1);
  auto* editor = window_->form().findChild<QWidget*>("editor.spacing");
  ASSERT_NE(editor, nullptr);
  auto* box = editor->findChild<QComboBox*>();
  EXPECT_EQ(box->currentText(), "anel");
  EXPECT_EQ(box->currentData().toString(), "ring");
  auto* side = window_->form().findChild<QWidget*>("editor.side")->findChild<QComboBox*>();
  EXPECT_EQ(side->currentText(), "dentro");
  // Letters of the code choose, where no word begins so; those of the word too.
  side->setFocus();
  QTest::keyClicks(side, "le");
  EXPECT_EQ(side->currentText(), "esquerda");
  const auto says = [this](const char* line) {
    return scenario::document_text(window_->session().document()).find(line) != std::string::npos;
  };
  EXPECT_TRUE(says("side = \"left\""));
  QTest::qWait(QApplication::keyboardInputInterval() + 100);
  side = window_->form().findChild<QWidget*>("editor.side")->findChild<QComboBox*>();
  side->setFocus();
  QTest::keyClicks(side, "dir");
  EXPECT_EQ(side->currentText(), "direita");
  EXPECT_TRUE(says("side = \"right\""));
  EXPECT_FALSE(says("direita"));
}

INSTANTIATE_TEST_SUITE_P(Example, WordsOfThePlate, testing::Values(Example{"quebra/cracked_plate.toml", true}));

}  // namespace
