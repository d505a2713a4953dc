#include "shared/gui/welcome/examples.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>

#include "shared/io/file.h"

// The compiled examples lie in a static library; the linker keeps them only if somebody names them.
static void keep_examples() { Q_INIT_RESOURCE(dobra_examples); }

namespace dobra::gui::welcome {

base::Result<std::filesystem::path> write_example(const std::string& program, const std::string& file,
                                                  const std::filesystem::path& folder) {
  keep_examples();
  const QDir compiled(":/examples/" + QString::fromStdString(program));
  if (!compiled.exists(QString::fromStdString(file)))
    return base::Error{base::ErrorCode::FileNotFound, "the program has no such example", base::Place{file}};
  std::error_code ignored;  // a folder that cannot be made is told of by the writing
  std::filesystem::create_directories(folder, ignored);
  for (const QString& name : compiled.entryList(QDir::Files)) {
    QFile source(compiled.filePath(name));
    if (!source.open(QIODevice::ReadOnly))
      return base::Error{base::ErrorCode::FileNotFound, "the program has no such example", base::Place{file}};
    DOBRA_TRY_VOID(io::write_file(folder / name.toStdString(), source.readAll().toStdString()));
  }
  return folder / file;
}

std::filesystem::path examples_folder(const std::string& program) {
  const QString data = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
  return std::filesystem::path(data.toStdString()) / "Dobra" / "examples" / program;
}

}  // namespace dobra::gui::welcome
