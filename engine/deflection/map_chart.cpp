#include "engine/deflection/map_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"

namespace lathelier::deflection {
namespace {

constexpr double mostLines = 6;

struct Corner {
    double depth_mm, feed_mm_rev, above_um;
};

/// Zero crossing on a cell side between two corners.
void addCrossing(const Corner& a, const Corner& b, Isoline& line)
{
    const double share = a.above_um / (a.above_um - b.above_um);
    line.depth_mm.push_back(a.depth_mm + share * (b.depth_mm - a.depth_mm));
    line.feed_mm_rev.push_back(a.feed_mm_rev + share * (b.feed_mm_rev - a.feed_mm_rev));
}

/// 1, 2 or 5 times a power of ten, such that at most `most` steps fit into the span.
double roundStep(double span, double most)
{
    const double least = span / most;
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1 - 1e-9)) return factor * power;
    return 10 * power;
}

double largestOf(const DeflectionMap& map)
{
    double largest = 0;
    for (const double value : map.max_um)
        if (std::isfinite(value)) largest = std::max(largest, value);
    return largest;
}

report::ColourMap groundOf(const DeflectionMap& map)
{
    report::ColourMap ground;
    ground.columns = static_cast<int>(map.depth_mm.size());
    ground.rows = static_cast<int>(map.feed_mm_rev.size());
    const auto edges = [](const std::vector<double>& middles, double& from, double& to) {
        const double half = middles.size() > 1
                                ? (middles.back() - middles.front()) / static_cast<double>(2 * (middles.size() - 1))
                                : middles.front() / 2;
        from = middles.front() - half;
        to = middles.back() + half;
    };
    edges(map.depth_mm, ground.x_from, ground.x_to);
    edges(map.feed_mm_rev, ground.y_from, ground.y_to);
    const double from_um = map.parameters.tolerance_um.value_or(0);
    double largest = 1e-3;
    ground.values.reserve(map.max_um.size());
    for (const double value : map.max_um) {
        ground.values.push_back(static_cast<float>(value - from_um));
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value - from_um));
    }
    ground.limit = largest;
    return ground;
}

void addTimes(const DeflectionMap& map, report::Plot& plot, const Language& language)
{
    if (map.time_s.empty()) return;
    const std::size_t rows = map.feed_mm_rev.size(), columns = map.depth_mm.size();
    for (const std::size_t row : {rows / 6, rows / 2, rows - 1 - rows / 6}) {
        report::Limit limit;
        limit.place = map.feed_mm_rev[row];
        limit.name = fill(text(LT_TEXT("Engine", "{time:0} s in cut"), language),
                          {{"time", map.time_s[row * columns + columns / 2]}}, language);
        plot.limits.push_back(std::move(limit));
    }
}

}  // namespace

Isoline isolineOf(const DeflectionMap& map, double error_um)
{
    Isoline line;
    const auto corner = [&](std::size_t row, std::size_t column) {
        // Avoids exact zeros: a line through a corner would be counted by all adjacent cells.
        double above_um = map.at(row, column) - error_um;
        if (above_um == 0) above_um = 1e-12;
        return Corner{map.depth_mm[column], map.feed_mm_rev[row], above_um};
    };
    for (std::size_t row = 0; row + 1 < map.feed_mm_rev.size(); ++row)
        for (std::size_t column = 0; column + 1 < map.depth_mm.size(); ++column) {
            const std::array<Corner, 4> corners{corner(row, column), corner(row, column + 1),
                                                corner(row + 1, column + 1), corner(row + 1, column)};
            if (std::any_of(corners.begin(), corners.end(), [](const Corner& c) { return std::isnan(c.above_um); }))
                continue;
            std::size_t ends = 0;
            for (std::size_t side = 0; side < 4; ++side) {
                const Corner &a = corners[side], &b = corners[(side + 1) % 4];
                if ((a.above_um > 0) == (b.above_um > 0)) continue;
                addCrossing(a, b, line);
                if (++ends % 2 == 0) {
                    line.depth_mm.push_back(notANumber);
                    line.feed_mm_rev.push_back(notANumber);
                }
            }
        }
    return line;
}

report::Plot mapChart(const DeflectionMap& map, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Largest diameter error over depth and feed");
    plot.x = {LT_TEXT("Engine", "Depth of the last pass"), millimetre};
    plot.y = {LT_TEXT("Engine", "Feed"), unit::mm_rev};
    if (map.depth_mm.empty() || map.feed_mm_rev.empty()) return plot;
    plot.ground = groundOf(map);
    plot.x.range = Interval{plot.ground->x_from, plot.ground->x_to};
    plot.y.range = Interval{plot.ground->y_from, plot.ground->y_to};
    const auto add = [&](report::Caption name, double error_um, report::Curve::Style style) {
        Isoline line = isolineOf(map, error_um);
        if (line.depth_mm.empty()) return;
        report::Curve curve{std::move(name), std::move(line.depth_mm), std::move(line.feed_mm_rev), style};
        curve.has_readout = false;
        plot.curves.push_back(std::move(curve));
    };
    const double largest = largestOf(map);
    if (const auto& tolerance_um = map.parameters.tolerance_um) {
        plot.remark = LT_TEXT("Engine", "red: out of tolerance, blue: within");
        add(LT_TEXT("Engine", "tolerance"), *tolerance_um, report::Curve::Style::Line);
        if (!plot.curves.empty()) plot.curves.back().colour = report::ColourRole::Limit;
    }
    if (largest > 0)
        for (double step = roundStep(largest, mostLines), level = step; level < largest; level += step)
            add(fill(text(LT_TEXT("Engine", "{error_um:1} µm"), language), {{"error_um", level}}, language), level,
                report::Curve::Style::Dashed);
    addTimes(map, plot, language);
    if (map.programmed_depth_mm > 0)
        plot.marks.push_back({map.programmed_depth_mm, map.programmed_feed_mm_rev, LT_TEXT("Engine", "as programmed")});
    return plot;
}

}  // namespace lathelier::deflection
