// Parts of a PlotCanvas. Included by its .cpp files only, because it shows QCustomPlot.
#pragma once

#include <qcustomplot.h>

#include "widgets/plot/plot_canvas.h"
#include "widgets/plot/text_line.h"

namespace lathelier::plot {

struct PlotCanvas::Parts {
    TextLine* title;                   ///< title above the plot
    TextLine* readout;                 ///< pointer readout
    QCPItemStraightLine* vertical;     ///< crosshair line
    QCPItemStraightLine* horizontal;   ///< crosshair line
    QCPItemRect* stretch;              ///< interval being drawn
    QString x_title, y_title;          ///< axis titles with units
    double x_factor = 1;               ///< tick label = value × factor
    QPoint pressed_at;                 ///< position of the press, in px of the widget
    bool legend_wanted = false;        ///< true: more than one named curve
    bool pressed = false;              ///< a button of the mouse is held
    bool has_clicked = false;          ///< the last press was a click
    bool drags_content = false;        ///< the drag moves a handle, not the view
    bool draws_stretch = false;        ///< a drag selects an interval of the x axis
    std::optional<double> drawn_from;  ///< x at the start of the selection; none: no selection
    bool view_chosen = false;          ///< the user has zoomed or panned
};

}  // namespace lathelier::plot
