#pragma once
// What a window shows of a scenario file that cannot be read: its text, with the line that is wrong, to be mended and
// saved there. Page: docs/user/window.md, "Files".

#include <QWidget>
#include <filesystem>

#include "shared/base/error.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace dobra::gui::mending {

class Page : public QWidget {
  Q_OBJECT

 public:
  explicit Page(QWidget* parent);

  /// Shows `written`, which stands in `file`, with the cursor where `error` lies.
  /// @param message  what is wrong, as a user reads it.
  void show_file(const std::filesystem::path& file, const std::string& written, const base::Error& error,
                 const QString& message);
  /// The text stays as it is; something else is wrong with it.
  void show_error(const base::Error& error, const QString& message);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// Line ends are those of the file.
  [[nodiscard]] std::string written() const;
  /// What the file held when it was read.
  [[nodiscard]] const std::string& text_of_file() const { return text_of_file_; }
  /// The file holds another text by now.
  void set_text_of_file(std::string text) { text_of_file_ = std::move(text); }
  [[nodiscard]] bool modified() const;

 signals:
  /// The text is to be saved in the file, and opened.
  void save_asked();
  /// Another file is to be chosen.
  void open_asked();
  /// The file is to stay as it is.
  void left();

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// Behind the line that is wrong.
  void mark_line();

  std::filesystem::path file_;
  std::string text_of_file_;
  std::size_t line_ = 0;  ///< 1-based; 0 if unknown.
  bool carriage_returns_ = false;
  QLabel* title_;
  QLabel* message_;
  QPlainTextEdit* edit_;
};

}  // namespace dobra::gui::mending
