// The table of rows: every value with its uncertainty, the suggested sizes as buttons that accept them.
#pragma once

#include <QPushButton>
#include <QWidget>
#include <optional>

#include "widgets/core/panel/copy_table.h"
#include "widgets/recognise/recognise_picture.h"

namespace lathelier::recognise_panel {

class RowsView : public QWidget {
    Q_OBJECT

public:
    explicit RowsView(QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const RecognisePicture>& picture);
    void markRow(std::optional<std::size_t> row);  ///< index into Recognition::segments
    CopyTable* table() const { return table_; }
    void retranslate();

signals:
    void rowPointedAt(int row);  ///< of the outside, from 0; -1: none, or a row of a bore
    /// Those of one suggestion: a standard's sizes go together.
    void sizesAccepted(const std::vector<lathelier::features::AcceptedSize>& sizes);
    void allAccepted();

private:
    void show();
    void addChips(int row, int column);
    void acceptFirst(int row);
    std::vector<features::AcceptedSize> together(int row, const features::Suggestion& suggestion) const;
    bool isAccepted(const features::AcceptedSize& size) const;

    std::shared_ptr<const RecognisePicture> picture_;
    CopyTable* table_;
    QWidget* buttons_;
    QPushButton* accept_;
    QPushButton* all_;
};

}  // namespace lathelier::recognise_panel
