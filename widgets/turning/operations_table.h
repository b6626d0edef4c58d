// The operations of a clamping as a table whose boxes switch them off.
#pragma once

#include <memory>

#include "engine/cam/drawn/plan_charts.h"
#include "widgets/core/panel/copy_table.h"

namespace lathelier::turning_panel {

class OperationsTable : public CopyTable {
    Q_OBJECT

public:
    explicit OperationsTable(QWidget* parent = nullptr);

    void setOutcome(const cam::TurningOutcome& outcome, std::size_t setup);

signals:
    void switched(const lathelier::cam::SkippedOperation& operation, bool on);
    void lineChosen(qlonglong line);  ///< the first one of the operation that was chosen

private:
    struct Line {
        cam::SkippedOperation which;
        std::int64_t first_line = 0;  ///< 0: left out, or its line is gone
        bool is_planned = false;      ///< false: switched off
    };
    std::vector<Line> lines_;
};

}  // namespace lathelier::turning_panel
