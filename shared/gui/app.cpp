#include "shared/gui/app.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QTimer>
#include <clocale>
#include <cstdio>

#include "shared/gui/main_window.h"
#include "shared/gui/script.h"
#include "shared/gui/text.h"

namespace dobra::gui {

bool has_display() {
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  // Under Wayland we go through XWayland, which sets DISPLAY: system GLEW knows X only.
  return set("DISPLAY");
}

void prepare_application() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  // A forward-compatible context refuses lines wider than a pixel, and VTK takes the width that the driver names as
  // given.
  format.setOption(QSurfaceFormat::DeprecatedFunctions);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  QSurfaceFormat::setDefaultFormat(format);
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "xcb");
}

int run_window(const scenario::Program& program, const WindowPart& part,
               const std::optional<std::filesystem::path>& file, const WindowOptions& options) {
  if (!has_display()) {
    std::fprintf(stderr,
                 "%s: no display: the window needs an X server (DISPLAY is not set); without one use '%s run FILE.toml "
                 "--out DIR', or xvfb-run\n",
                 program.name.c_str(), program.name.c_str());
    return 4;
  }
  std::vector<Script::Line> lines;
  if (options.script) {
    base::Result<std::vector<Script::Line>> read = Script::read(*options.script);
    if (!read) {
      std::fprintf(stderr, "%s\n", base::to_string(read.error()).c_str());
      return 2;
    }
    lines = std::move(*read);
  }
  prepare_application();
  int argument_count = 1;
  std::string name = program.name;
  char* arguments[] = {name.data(), nullptr};
  QApplication application(argument_count, arguments);
  // Qt has set the user's locale for all of C: readers and writers of numbers need the point.
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setApplicationName(QString::fromStdString(program.name));
  QApplication::setApplicationDisplayName({});
  install_translation(QString::fromStdString(options.language));

  MainWindow window(program, part);
  if (!options.script) window.restore_layout();
  if (file) {
    const base::Result<void> opened = options.script ? window.open(*file) : window.open_or_mend(*file);
    if (!opened && options.script) {
      std::fprintf(stderr, "%s\n", base::to_string(opened.error()).c_str());
      return base::exit_code(opened.error().code);
    }
  }
  if (!file && !options.script) window.welcome();
  window.show();
  // Once the event loop runs: the question needs the window behind it.
  if (!options.script) QTimer::singleShot(0, &window, &MainWindow::offer_recovery);
  if (options.script) {
    auto* script = new Script(std::move(lines), *options.script, window);
    QObject::connect(script, &Script::ended, &application, &QCoreApplication::exit);
  }
  return QApplication::exec();
}

}  // namespace dobra::gui
