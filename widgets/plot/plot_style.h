// Style of all plots: colours from the palette (dark and light), line widths proportional to the font size.
#pragma once

#include <QColor>
#include <QFont>
#include <QLocale>
#include <QPalette>

#include "engine/report/chart.h"

class QCustomPlot;

namespace lathelier::plot {

struct PlotStyle {
    QColor background;  ///< background of the plot
    QColor text;        ///< text and axes
    QColor grid;        ///< grid lines
    QColor limit;       ///< tolerance lines
    QColor marker;      ///< marker of the linked place
    double line_width;  ///< logical pixels, proportional to the font height

    PlotStyle(const QPalette& palette, const QFont& font);

    bool dark() const { return background.lightness() < 128; }
    /// Colour as in the report, for this background.
    QColor colour(const report::ChartColour& meaning, std::size_t position = 0) const;
};

QColor toQt(const report::Rgb& colour);

/// The texts of a chart in the user's language.
QString chartText(const report::Caption& caption);
QString chartText(const report::Axis& axis);  ///< title with unit
/// The title for the readout: an explanation after a comma ("along the axis, from …") is omitted.
QString shortAxisTitle(const report::Axis& axis);

/// A palette for paper: dark on white, independent of the desktop theme.
QPalette paperPalette();

/// The same with a unit: `value` and `span` in that of the engine, the text in the display unit.
QString readable(double value, double span, Text unit, const QLocale& locale);

/// "-0.0042": fixed digits that fit `span`, in the user's locale, with a true minus sign.
QString readable(double value, double span, const QLocale& locale);

}  // namespace lathelier::plot
