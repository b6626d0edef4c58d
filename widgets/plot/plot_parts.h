// What a PlotCanvas is made of. Included by its .cpp files only, because it shows QCustomPlot.
#pragma once

#include <qcustomplot.h>

#include "widgets/plot/plot_canvas.h"
#include "widgets/plot/text_line.h"

namespace lathelier::plot {

struct PlotCanvas::Parts {
    TextLine* title;                  ///< above the plot
    TextLine* readout;                ///< what the pointer reads
    QCPItemStraightLine* vertical;    ///< through the pointer
    QCPItemStraightLine* horizontal;  ///< through the pointer
    QCPItemRect* stretch;             ///< that is being drawn
    QString xTitle, yTitle;           ///< with units
    double x_factor = 1;              ///< numbers at the x axis = values × factor
    QPoint pressedAt;                 ///< in px of the widget
    bool legendWanted = false;        ///< there is more than one curve with a name
    bool pressed = false;             ///< a button of the mouse is held
    bool hasClicked = false;          ///< with the last press
    bool dragsContent = false;        ///< a handle follows the pointer, not the view
    bool drawsStretch = false;        ///< a drag draws a stretch of the x axis
    std::optional<double> drawnFrom;  ///< where it began, on the x axis; none: nothing is being drawn
    bool viewChosen = false;          ///< the user has zoomed or panned
};

}  // namespace lathelier::plot
