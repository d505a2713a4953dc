#include "shared/gui/text.h"

#include <QLocale>
#include <QTranslator>

#include "shared/base/text.h"
#include "shared/canvas/entry.h"

// The compiled translations lie in this static library; the linker keeps them only if somebody names them.
// Q_INIT_RESOURCE must stand outside any namespace.
static void keep_translations() { Q_INIT_RESOURCE(dobra_translations); }

namespace dobra::gui {

void install_translation(const QString& language) {
  keep_translations();
  if (!language.isEmpty()) QLocale::setDefault(QLocale(language));
  canvas::set_decimal_mark(QLocale().decimalPoint() == QLatin1String(",") ? canvas::DecimalMark::Comma
                                                                          : canvas::DecimalMark::Point);
  auto* translator = new QTranslator(QCoreApplication::instance());
  const QLocale locale;
  if (translator->load(locale, "dobra", "_", ":/translations")) {
    QCoreApplication::installTranslator(translator);
  } else {
    delete translator;
  }
  base::set_translator(+[](const char* source) { return text(source).toStdString(); });
}

}  // namespace dobra::gui
