// Tests of windows: one QApplication for all of them. Run under xvfb-run where there is no display; ctest does.

#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <clocale>
#include <cstdio>

#include "shared/gui/app.h"
#include "shared/gui/text.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  if (!dobra::gui::has_display()) {
    std::fprintf(stderr, "these tests open windows: run them with xvfb-run -a\n");
    return 4;
  }
  dobra::gui::prepare_application();
  QApplication application(argc, argv);
  // Nothing of the user's own is read or written.
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
  QStandardPaths::setTestModeEnabled(true);
  std::setlocale(LC_NUMERIC, "C");
  dobra::gui::install_translation("en");
  return RUN_ALL_TESTS();
}
