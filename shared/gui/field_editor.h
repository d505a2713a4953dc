#pragma once
// One editor widget for each kind of parameter: spin box with free text, check box, combo box, line, file chooser, list
// of points. An editor knows how a value is written, not whether it is a good one: the form judges.

#include <QWidget>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/scenario/field.h"

namespace dobra::gui {

class FieldEditor : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;

  /// How a value stands: written in the document, or the field's default because the document has none.
  enum class Origin { Document, Default };

  /// Shows a value, or "not set" where there is none. Emits nothing; drops what was half typed.
  virtual void show_value(const std::optional<scenario::Value>& value, Origin origin) = 0;

  /// Does what Enter does: what was typed and not yet told is told, by `entered`, `emptied` or `rejected`.
  virtual void commit() {}
  /// What stands in the editor is not the value that it was given to show: still being typed, or refused.
  [[nodiscard]] virtual bool unsettled() const { return false; }

  /// Does what a user does who types `text` and leaves the field; emits `entered` or `rejected`.
  virtual void type(const QString& text) = 0;

  /// Names that the user may pick from; an editor that writes no names ignores them.
  virtual void offer(const std::vector<std::string>& /*names*/) {}

  /// Does what a user does who picks this name: it goes in, beside the others where there may be several.
  virtual void take_name(const QString& name) { type(name); }

  /// Draws the editor as one whose content is wrong, or no longer.
  enum class Judgement { Good, Bad };
  virtual void show_judgement(Judgement judgement);

 signals:
  /// The user settled on a value.
  void entered(const dobra::scenario::Value& value);
  /// The user emptied the editor: no value, that is, the default.
  void emptied();
  /// What the user typed cannot be read.
  void rejected(const QString& message);
};

/// @param folder  where relative file names start.
/// @pre field.kind is not Tables.
FieldEditor* make_field_editor(const scenario::Field& field, const std::filesystem::path& folder, QWidget* parent);

/// How a form calls a choice of the field: its translation, that with the field's key as comment before others; else
/// the code with blanks between its words.
QString choice_text(const scenario::Field& field, const std::string& choice);

}  // namespace dobra::gui
