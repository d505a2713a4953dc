#include "shared/gui/text.h"

#include <QLocale>
#include <QTranslator>

#include "shared/base/text.h"

// The compiled translations lie in this static library; the linker keeps them only if somebody names them.
// Q_INIT_RESOURCE must stand outside any namespace.
static void keep_translations() { Q_INIT_RESOURCE(dobra_translations); }

namespace dobra::gui {

void install_translation(const QString& language) {
  keep_translations();
  auto* translator = new QTranslator(QCoreApplication::instance());
  const QLocale locale = language.isEmpty() ? QLocale() : QLocale(language);
  if (translator->load(locale, "dobra", "_", ":/translations")) {
    QCoreApplication::installTranslator(translator);
  } else {
    delete translator;
  }
  base::set_translator(+[](const char* source) { return text(source).toStdString(); });
}

}  // namespace dobra::gui
