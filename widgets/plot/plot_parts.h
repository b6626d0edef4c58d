// What a PlotCanvas is made of. Included by its .cpp files only, because it shows QCustomPlot.
#pragma once

#include <qcustomplot.h>

#include "widgets/plot/plot_canvas.h"
#include "widgets/plot/text_line.h"

namespace lathelier {

struct PlotCanvas::Parts {
    TextLine* title;
    TextLine* readout;
    QCPItemStraightLine* vertical;
    QCPItemStraightLine* horizontal;
    QString xTitle, yTitle;
    QPoint pressedAt;
    bool legendWanted = false;
    bool pressed = false;
    bool hasClicked = false;  ///< with the last press
    bool dragsContent = false;
    bool viewChosen = false;  ///< the user has zoomed or panned
};

}  // namespace lathelier
