// A chart along the axis of a part with a context menu for the row under the pointer.
#pragma once

#include <QMenu>

#include "widgets/plot/chart_view.h"

namespace lathelier::part_common {

class RowChart : public plot::ChartView {
    Q_OBJECT

public:
    using ChartView::ChartView;

signals:
    /// The menu opens at this x; outside the axes when opened with a key.
    void menuOpened(QMenu* menu, double x);

protected:
    void addToMenu(QMenu& menu) override;
};

}  // namespace lathelier::part_common
