#pragma once
// The window in Brazilian Portuguese, as long as this lives.

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

#include "shared/gui/catalogue/catalogue.h"

namespace dobra::test {

class Brazilian {
 public:
  Brazilian() {
    if (translator.load(QLocale("pt_BR"), "dobra", "_", ":/translations"))
      QCoreApplication::installTranslator(&translator);
    gui::catalogue::install("pt_BR");
  }
  ~Brazilian() {
    gui::catalogue::install("en");
    QCoreApplication::removeTranslator(&translator);
  }
  QTranslator translator;
};

}  // namespace dobra::test
