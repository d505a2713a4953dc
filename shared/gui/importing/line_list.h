#pragma once
// The lines of one file in a table: whether each is taken, what it is, and who says so.

#include <QAbstractTableModel>

#include "shared/gui/importing/import_model.h"

namespace dobra::gui::importing {

class LineList : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Name, Kind, From, Points, Columns };

  /// @pre `model` outlives the list
  explicit LineList(ImportModel& model, QObject* parent = nullptr);

  void show_file(std::size_t file);
  /// Kinds and ticks may be others.
  void refresh();

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 signals:
  /// A tick was set or taken away.
  void ticked();

 private:
  [[nodiscard]] QString words(std::size_t line, int column) const;
  ImportModel& model_;
  std::size_t file_ = 0;
};

/// "Fault": what a kind is called.
QString kind_title(const ImportModel& model, const std::string& kind);

}  // namespace dobra::gui::importing
