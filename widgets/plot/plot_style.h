// How every plot looks: colours from the palette (dark and light), line widths that grow with the type.
#pragma once

#include <QColor>
#include <QFont>
#include <QLocale>
#include <QPalette>

#include "engine/report/chart.h"

class QCustomPlot;

namespace lathelier::plot {

struct PlotStyle {
    QColor background;  ///< of the sheet
    QColor text;        ///< of words and axes
    QColor grid;        ///< of grid lines
    QColor limit;       ///< tolerance lines
    QColor marker;      ///< the linked point
    double lineWidth;   ///< logical pixels, from the height of the type

    PlotStyle(const QPalette& palette, const QFont& font);

    bool dark() const { return background.lightness() < 128; }
    /// As in the report, on this background.
    QColor colour(const report::ChartColour& meaning, std::size_t position = 0) const;
};

QColor toQt(const report::Rgb& colour);

/// The words of a chart in the language of the screen.
QString chartText(const report::Caption& caption);
QString chartText(const report::Axis& axis);  ///< with its unit
/// The title as the pointer says it: what explains it behind a comma ("along the axis, from …") is left to the axis.
QString spokenTitle(const report::Axis& axis);

/// A palette for paper: dark on white, whatever the desktop looks like.
QPalette paperPalette();

/// The same with a unit: `value` and `span` in that of the engine, the text in that which is shown.
QString readable(double value, double span, Text unit, const QLocale& locale);

/// "-0.0042": fixed digits that fit `span`, in the user's locale, with a true minus sign.
QString readable(double value, double span, const QLocale& locale);

}  // namespace lathelier::plot
