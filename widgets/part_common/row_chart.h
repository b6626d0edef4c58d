// A chart along the axis of a part whose context menu says what can be done with the row under the pointer.
#pragma once

#include <QMenu>

#include "widgets/plot/chart_view.h"

namespace lathelier::part_common {

class RowChart : public plot::ChartView {
    Q_OBJECT

public:
    using ChartView::ChartView;

signals:
    /// The menu is about to open at this x; beside the axes where it was opened with a key.
    void menuOpened(QMenu* menu, double x);

protected:
    void addToMenu(QMenu& menu) override;
};

}  // namespace lathelier::part_common
