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
  const std::filesystem::path inside(file);
  const std::string from = inside.has_parent_path() ? inside.parent_path().string() : program;
  const QDir compiled(":/examples/" + QString::fromStdString(from));
  if (!compiled.exists(QString::fromStdString(inside.filename().string())))
    return base::Error{base::ErrorCode::FileNotFound, "the program has no such example", base::Place{file}};
  const std::filesystem::path to = (folder / inside).parent_path();
  std::error_code ignored;  // a folder that cannot be made is told of by the writing
  std::filesystem::create_directories(to, ignored);
  for (const QString& name : compiled.entryList(QDir::Files)) {
    QFile source(compiled.filePath(name));
    if (!source.open(QIODevice::ReadOnly))
      return base::Error{base::ErrorCode::FileNotFound, "the program has no such example", base::Place{file}};
    DOBRA_TRY_VOID(io::write_file(to / name.toStdString(), source.readAll().toStdString()));
  }
  return folder / file;
}

std::filesystem::path examples_folder(const std::string& program) {
  const QString data = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
  return std::filesystem::path(data.toStdString()) / "Dobra" / "examples" / program;
}

}  // namespace dobra::gui::welcome
