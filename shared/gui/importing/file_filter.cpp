#include "shared/gui/importing/file_filter.h"

#include <QStringList>

#include "shared/gui/words/words.h"

namespace dobra::gui::importing {
namespace {

QString filter(const QString& title, const std::vector<std::string>& endings) {
  QStringList patterns;
  for (const std::string& ending : endings) patterns << "*" + QString::fromStdString(ending);
  return title + " (" + patterns.join(' ') + ")";
}

}  // namespace

QString filter_of(const scenario::FileKind& kind) { return filter(text(kind.title.c_str()), kind.endings); }

QString file_filter(const std::vector<scenario::FileKind>& kinds) {
  if (kinds.empty()) return {};
  QStringList filters;
  if (kinds.size() > 1) {
    std::vector<std::string> all;
    for (const scenario::FileKind& kind : kinds) all.insert(all.end(), kind.endings.begin(), kind.endings.end());
    filters << filter(text("All that can be read"), all);
  }
  for (const scenario::FileKind& kind : kinds) filters << filter_of(kind);
  filters << text("All files (*)");
  return filters.join(";;");
}

}  // namespace dobra::gui::importing
