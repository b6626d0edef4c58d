// The table of rows: every value with its uncertainty, the suggested sizes as buttons that accept them.
#pragma once

#include <QPushButton>
#include <QWidget>
#include <optional>

#include "engine/cad/task/recognize_task.h"
#include "widgets/core/panel/copy_table.h"

namespace lathelier::recognise_panel {

class RowsView : public QWidget {
    Q_OBJECT

public:
    explicit RowsView(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const cad::RecognizeOutcome>& outcome);
    void markRow(std::optional<std::size_t> row);  ///< index into Recognition::segments
    CopyTable* table() const { return table_; }
    void retranslate();

signals:
    void rowPointedAt(int row);  ///< row of the outside, from 0; -1: none, or a row of a bore
    /// The sizes of one suggestion, accepted together.
    void sizesAccepted(const std::vector<lathelier::features::AcceptedSize>& sizes);
    void allAccepted();

private:
    void show();
    void addChips(int row, int column);
    void acceptFirst(int row);
    std::vector<features::AcceptedSize> together(int row, const features::Suggestion& suggestion) const;
    bool isAccepted(const features::AcceptedSize& size, bool agrees) const;

    std::shared_ptr<const cad::RecognizeOutcome> outcome_;
    CopyTable* table_;
    QWidget* buttons_;
    QPushButton* accept_;
    QPushButton* all_;
};

}  // namespace lathelier::recognise_panel
