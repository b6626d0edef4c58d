// What a plot shows, as values. The view draws them; the same values go to the CSV export.
#pragma once

#include <QColor>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

namespace lathelier {

/// Title and unit of an axis; shown as "Title [unit]".
struct PlotAxis {
    QString title;
    QString unit;

    QString label() const { return unit.isEmpty() ? title : title + " [" + unit + "]"; }
};

/// One curve. x rises; NaN in y breaks the line.
struct PlotCurve {
    enum class Style { Line, Dashed, Bars, Band, Points };

    QString name;  ///< empty: not in the legend
    std::vector<double> x;
    std::vector<double> y;
    Style style = Style::Line;
    std::vector<double> yLow;      ///< Band only: the other edge
    std::optional<QColor> colour;  ///< none: the next one of a colour-blind-safe row
    std::vector<double> readout;   ///< what the crosshair and the CSV say instead of y (a magnified error's true value)
    QString readoutUnit;           ///< unit of `readout`
    QStringList words;             ///< what the crosshair says besides, by sample: "three lobes: a three-jaw chuck"
    bool spoken = true;            ///< the crosshair says its value
};

/// A straight limit across the plot, such as a tolerance. A movable one can be dragged.
struct PlotLimit {
    Qt::Orientation orientation = Qt::Horizontal;
    double value = 0;
    QString label;
    bool movable = false;
};

/// A shaded stretch of the x axis.
struct PlotRegion {
    double from = 0;
    double to = 0;
    QString label;
    std::optional<QColor> colour;
};

struct PlotData {
    QString title;
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotCurve> curves;
    std::vector<PlotLimit> limits;
    std::vector<PlotRegion> regions;
    QString remark;                                   ///< stands beside the title: "error × 200"
    std::optional<std::pair<double, double>> xRange;  ///< what is shown at first; none: all
    std::optional<std::pair<double, double>> yRange;
    bool yFromZero = false;  ///< counts: the y axis starts at 0
};

/// Comma-separated, decimal point in every locale, full precision; curves that share x share its column.
QString toCsv(const PlotData& data);

/// A map of values on a regular grid: row-major, rows along y, NaN left blank.
struct MapData {
    QString title;
    PlotAxis x;
    PlotAxis y;
    PlotAxis value;
    double xFrom = 0;
    double xTo = 1;
    double yFrom = 0;
    double yTo = 1;
    int columns = 0;
    int rows = 0;
    std::vector<float> values;

    bool empty() const { return columns <= 0 || rows <= 0; }
    /// The value at a place, NaN outside and where there are no data.
    double at(double xPlace, double yPlace) const;
};

/// One line for each cell with data: x, y, value.
QString toCsv(const MapData& data);

}  // namespace lathelier
