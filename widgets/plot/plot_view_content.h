// What a PlotView has drawn. Included by its .cpp files only, because it shows QCustomPlot.
#pragma once

#include <qcustomplot.h>

#include <optional>
#include <vector>

#include "widgets/plot/plot_view.h"

namespace lathelier {

struct PlotView::Content {
    struct Line {
        QCPItemStraightLine* line;
        QCPItemText* label;
    };
    PlotData data;
    std::vector<QCPAbstractPlottable*> drawn;  ///< one for each curve; Band: the upper edge
    std::vector<QCPGraph*> lowEdges;           ///< one for each curve, null but for bands
    std::vector<Line> limits;
    std::vector<QCPItemRect*> regions;
    std::vector<QCPItemText*> regionLabels;
    QCPItemStraightLine* marker = nullptr;
    std::optional<double> markedX;
    std::optional<int> dragged;
};

}  // namespace lathelier
