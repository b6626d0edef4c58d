#include "widgets/plot/plot_data.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <limits>

namespace lathelier {
namespace {

QString number(double value)
{
    return std::isfinite(value) ? QString::number(value, 'g', QLocale::FloatingPointShortest) : QString();
}

QString quoted(QString text)
{
    if (!text.contains(',') && !text.contains('"')) return text;
    return '"' + text.replace('"', "\"\"") + '"';
}

struct Column {
    QString head;
    const std::vector<double>* values;
};

}  // namespace

QString toCsv(const PlotData& data)
{
    std::vector<Column> columns;
    const std::vector<double>* shared = nullptr;
    for (const PlotCurve& curve : data.curves) {
        if (!shared || *shared != curve.x) columns.push_back({data.x.label(), &curve.x});
        shared = &curve.x;
        const QString name = curve.name.isEmpty() ? data.y.label() : curve.name + " [" + data.y.unit + "]";
        columns.push_back({name, &curve.y});
        if (curve.style == PlotCurve::Style::Band) columns.push_back({name + " (low)", &curve.yLow});
        if (!curve.readout.empty()) columns.push_back({curve.name + " [" + curve.readoutUnit + "]", &curve.readout});
    }
    QString text;
    std::size_t rows = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        text += (i ? "," : "") + quoted(columns[i].head);
        rows = std::max(rows, columns[i].values->size());
    }
    text += '\n';
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (i) text += ',';
            if (row < columns[i].values->size()) text += number((*columns[i].values)[row]);
        }
        text += '\n';
    }
    return text;
}

double MapData::at(double xPlace, double yPlace) const
{
    const double u = (xPlace - xFrom) / (xTo - xFrom) * columns;
    const double v = (yPlace - yFrom) / (yTo - yFrom) * rows;
    if (empty() || !(u >= 0 && u < columns && v >= 0 && v < rows)) return std::numeric_limits<double>::quiet_NaN();
    return values[static_cast<std::size_t>(v) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(u)];
}

QString toCsv(const MapData& data)
{
    QString text = quoted(data.x.label()) + ',' + quoted(data.y.label()) + ',' + quoted(data.value.label()) + '\n';
    const double dx = (data.xTo - data.xFrom) / data.columns;
    const double dy = (data.yTo - data.yFrom) / data.rows;
    for (int row = 0; row < data.rows; ++row)
        for (int column = 0; column < data.columns; ++column) {
            const float value = data.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(data.columns) +
                                            static_cast<std::size_t>(column)];
            if (std::isnan(value)) continue;
            text += number(data.xFrom + (column + 0.5) * dx) + ',' + number(data.yFrom + (row + 0.5) * dy) + ',' +
                    QString::number(static_cast<double>(value), 'g', 9) + '\n';
        }
    return text;
}

}  // namespace lathelier
