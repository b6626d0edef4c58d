// The list of operations with buttons that move one up or down. An invalid order is rejected with its reason below the
// list. Rows can be dragged by their numbers too.
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <optional>
#include <vector>

#include "widgets/turning/operations_table.h"

namespace lathelier::turning_panel {

class OperationsPane : public QWidget {
    Q_OBJECT

public:
    explicit OperationsPane(QWidget* parent = nullptr);

    void setOutcome(const cam::TurningOutcome& outcome, std::size_t setup);
    OperationsTable* table() const { return table_; }
    QToolButton* up() const { return up_; }
    QToolButton* down() const { return down_; }
    QToolButton* reset() const { return reset_; }
    QString refusalText() const
    {
        return refusal_->text();
    }  ///< reason why the last move was rejected; empty:
       ///< accepted

    void moveStep(int row, std::size_t place);  ///< what stands in this row to a place among the steps
    void retranslate();

signals:
    /// All steps of the shown clamping in the new order; `moved`: the step moved by the user.
    void orderRequested(const std::vector<lathelier::cam::OperationStep>& order,
                        const lathelier::cam::OperationStep& moved);
    void orderReset();

private:
    std::optional<std::size_t> placeOf(int row) const;
    void moveBy(int places);
    void enableButtons();
    void dropRow(int row, int on);

    OperationsTable* table_;
    QToolButton* up_;
    QToolButton* down_;
    QToolButton* reset_;
    QLabel* refusal_;
    std::vector<cam::OperationStep> steps_;
    std::vector<cam::OperationStep> rows_;      ///< of the table
    std::vector<cam::OperationStep> rowSteps_;  ///< to which of `steps_` each row belongs
    std::optional<cam::OperationStep> chosen_;  ///< stays the current row
    bool isOwnOrder_ = false;                   ///< the order differs from the default
    bool putsBack_ = false;                     ///< the header's row goes back after a drag
};

}  // namespace lathelier::turning_panel
