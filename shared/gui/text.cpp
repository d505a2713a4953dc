#include "shared/gui/text.h"

#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include "shared/base/text.h"
#include "shared/canvas/entry.h"
#include "shared/gui/catalogue/catalogue.h"

// The compiled translations lie in this static library; the linker keeps them only if somebody names them.
// Q_INIT_RESOURCE must stand outside any namespace.
static void keep_translations() {
  Q_INIT_RESOURCE(dobra_translations);
  Q_INIT_RESOURCE(dobra_messages);
}

namespace dobra::gui {

void install_translation(const QString& language) {
  keep_translations();
  QLocale numbers = language.isEmpty() ? QLocale() : QLocale(language);
  numbers.setNumberOptions(QLocale::OmitGroupSeparator);  // it might be taken for the decimal mark
  QLocale::setDefault(numbers);
  canvas::set_decimal_mark(QLocale().decimalPoint() == QLatin1String(",") ? canvas::DecimalMark::Comma
                                                                          : canvas::DecimalMark::Point);
  auto* translator = new QTranslator(QCoreApplication::instance());
  const QLocale locale;
  catalogue::install(locale.name());
  if (auto* dialogs = new QTranslator(QCoreApplication::instance());
      dialogs->load(locale, "qtbase", "_", QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    QCoreApplication::installTranslator(dialogs);  // of Qt's own dialogs, where its translations are installed
  } else {
    delete dialogs;
  }
  if (translator->load(locale, "dobra", "_", ":/translations")) {
    QCoreApplication::installTranslator(translator);
  } else {
    delete translator;
  }
  base::set_translator(+[](const char* source) { return text(source).toStdString(); });
}

}  // namespace dobra::gui
