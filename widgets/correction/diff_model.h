// The program and its correction line by line: original text, corrected text and reason.
#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <vector>

#include "engine/deflection/deflection_task.h"

namespace lathelier::correction_panel {

using deflection::DeflectionOutcome;

/// Columns Take, Line, Program, Corrected, Reason. A row for each line of the program and for each added block; of
/// changed blocks alone on demand. Take is ticked for a changed block and not for a kept one.
class DiffModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Take, Line, Program, Corrected, Reason, ColumnCount };

    explicit DiffModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    void setOutcome(const std::shared_ptr<const DeflectionOutcome>& outcome);
    void setOnlyChanges(bool only);
    bool onlyChanges() const { return onlyChanges_; }
    void retranslate();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    int firstChange() const;                       ///< row of the first change; -1: none
    std::optional<double> placeOf(int row) const;  ///< z in mm of a changed row
    int rowAt(double z_mm) const;                  ///< row of the change nearest to z; -1: none

signals:
    void taken(qlonglong line, bool take);  ///< request to change this block or to keep it

private:
    /// Content of a row.
    struct Row {
        std::int64_t line = 0;
        int change = -1;        ///< index into the changes; -1: none
        bool is_first = false;  ///< first row of its block
        bool is_kept = false;   ///< the user keeps this block
    };
    void rebuild();
    const deflection::ProgramChange* changeOf(const Row& row) const;
    QString textOf(const Row& row) const;

    std::shared_ptr<const DeflectionOutcome> outcome_;
    std::vector<Row> rows_;
    bool onlyChanges_ = false;
};

}  // namespace lathelier::correction_panel
