#pragma once
// The window in Brazilian Portuguese, as long as this lives.

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

namespace dobra::test {

class Brazilian {
 public:
  Brazilian() {
    if (translator.load(QLocale("pt_BR"), "dobra", "_", ":/translations"))
      QCoreApplication::installTranslator(&translator);
  }
  ~Brazilian() { QCoreApplication::removeTranslator(&translator); }
  QTranslator translator;
};

}  // namespace dobra::test
