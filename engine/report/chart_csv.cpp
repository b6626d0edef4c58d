#include "engine/report/chart_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lathelier::report {
namespace {

template <class T>
std::string csvNumber(T value)
{
    return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

/// Names come from files: one that a spreadsheet would compute gets an apostrophe in front.
std::string csvQuoted(const std::string& written, bool always = false)
{
    const bool computes = !written.empty() && std::string_view("=+-@").find(written.front()) != std::string_view::npos;
    std::string text = computes ? "'" + written : written;
    if (!always && text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string result(1, '"');
    for (const char letter : text) {
        if (letter == '"') result += '"';
        result += letter;
    }
    result += '"';
    return result;
}

struct Column {
    std::string head;
    const std::vector<double>* values;
};

std::string pathsAsCsv(const Plot& plot, const Language& language)
{
    std::string out = "curve," + csvQuoted(axisLabel(plot.along, language)) + ",x,y\n";
    for (std::size_t c = 0; c < plot.curves.size(); ++c) {
        const Curve& curve = plot.curves[c];
        const std::string name = captionText(curve.name, language);
        const std::string head = csvQuoted(name.empty() ? std::to_string(c + 1) : name, true);
        for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i)
            out += head + ',' + csvNumber(i < curve.along.size() ? curve.along[i] : NAN) + ',' + csvNumber(curve.x[i]) +
                   ',' + csvNumber(curve.y[i]) + '\n';
    }
    return out;
}

}  // namespace

std::string toCsv(const Plot& plot, const Language& of_screen)
{
    const Language language = inEngineUnits(of_screen);
    if (std::any_of(plot.curves.begin(), plot.curves.end(), [](const Curve& c) { return !c.along.empty(); }))
        return pathsAsCsv(plot, language);
    const auto labelled = [&](const std::string& name, const Text& unit) {
        return axisLabel({name, unit, {}, {}}, language);
    };
    std::vector<std::vector<double>> places;
    for (const Curve& curve : plot.curves) places.push_back(placesOf(curve));
    std::vector<Column> columns;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const Curve& curve = plot.curves[i];
        if (i == 0 || places[i] != places[i - 1]) columns.push_back({axisLabel(plot.x, language), &places[i]});
        const std::string name = captionText(curve.name, language);
        const std::string head = name.empty() ? axisLabel(plot.y, language) : labelled(name, plot.y.unit);
        columns.push_back({head, &curve.y});
        if (curve.style == Curve::Style::Band) columns.push_back({head + " (low)", &curve.y_low});
        if (!curve.readout_y.empty()) columns.push_back({labelled(name, curve.readout_unit), &curve.readout_y});
    }
    std::string out;
    std::size_t rows = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (i) out += ',';
        out += csvQuoted(columns[i].head);
        rows = std::max(rows, columns[i].values->size());
    }
    out += '\n';
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (i) out += ',';
            if (row < columns[i].values->size()) out += csvNumber((*columns[i].values)[row]);
        }
        out += '\n';
    }
    return out;
}

std::string toCsv(const ColourMap& map, const Language& of_screen)
{
    const Language language = inEngineUnits(of_screen);
    std::string out = csvQuoted(axisLabel(map.x, language)) + ',' + csvQuoted(axisLabel(map.y, language)) + ',' +
                      csvQuoted(axisLabel(map.value, language)) + '\n';
    const double dx = (map.x_to - map.x_from) / map.columns;
    const double dy = (map.y_to - map.y_from) / map.rows;
    for (int row = 0; row < map.rows; ++row)
        for (int column = 0; column < map.columns; ++column) {
            const float value = map.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
                                           static_cast<std::size_t>(column)];
            if (std::isnan(value)) continue;
            out += csvNumber(map.x_from + (column + 0.5) * dx) + ',' + csvNumber(map.y_from + (row + 0.5) * dy) + ',' +
                   csvNumber(value) + '\n';
        }
    return out;
}

}  // namespace lathelier::report
