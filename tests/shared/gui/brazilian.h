#pragma once
// The window in Brazilian Portuguese, as long as this lives.

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

#include "shared/gui/catalogue/catalogue.h"
#include "shared/scene/decimal_mark.h"

namespace dobra::test {

class Brazilian {
 public:
  Brazilian() {
    if (translator.load(QLocale("pt_BR"), "dobra", "_", ":/translations"))
      QCoreApplication::installTranslator(&translator);
    gui::catalogue::install("pt_BR");
    scene::set_decimal_mark(scene::DecimalMark::Comma);
    QLocale numbers("pt_BR");
    numbers.setNumberOptions(QLocale::OmitGroupSeparator);
    QLocale::setDefault(numbers);
  }
  ~Brazilian() {
    scene::set_decimal_mark(scene::DecimalMark::Point);
    QLocale::setDefault(before);
    gui::catalogue::install("en");
    QCoreApplication::removeTranslator(&translator);
  }
  const QLocale before;
  QTranslator translator;
};

}  // namespace dobra::test
