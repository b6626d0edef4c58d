#include "engine/features/comparison/row_matching.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/features/comparison/comparison_limits.h"

namespace lathelier::features {
namespace {

/// Cost of an unassigned row.
double priceOf(const RowOnAxis& row)
{
    return matchingLimits.unassigned_price_mm +
           matchingLimits.unassigned_price_share *
               std::min(row.z_end_mm - row.z_start_mm, matchingLimits.longest_priced_row_mm);
}

/// Diameter of the drawing's row at this z, along its chord.
double diameterAt(const RowOnAxis& row, double z_mm)
{
    const double length = row.z_end_mm - row.z_start_mm;
    const double share = length > 0 ? std::clamp((z_mm - row.z_start_mm) / length, 0.0, 1.0) : 0.5;
    return row.start_diameter_mm + share * (row.end_diameter_mm - row.start_diameter_mm);
}

/// Mean distance of a measured row's diameters from the drawing's, and the larger of both ends.
struct Off {
    double mean_mm, largest_mm;
};
Off offOf(const RowOnAxis& nominal, const RowOnAxis& row, bool alone)
{
    const double z0 = alone ? nominal.z_start_mm : row.z_start_mm, z1 = alone ? nominal.z_end_mm : row.z_end_mm;
    const double start = std::abs(row.start_diameter_mm - diameterAt(nominal, z0));
    const double end = std::abs(row.end_diameter_mm - diameterAt(nominal, z1));
    return {(start + end) / 2, std::max(start, end)};
}

/// Of taking measured [first, first + count) for the row; infinite where that cannot be.
double costOf(const RowOnAxis& nominal, const std::vector<RowOnAxis>& measured, RowRun run)
{
    const RowOnAxis &first = measured[run.first], &last = measured[run.first + run.count - 1];
    double off = 0, length = 0;
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
        const RowOnAxis& row = measured[i];
        const Off one = offOf(nominal, row, run.count == 1);
        const bool has_arc = row.arc_radius_mm || nominal.arc_radius_mm;
        const double allowed = matchingLimits.run_diameter_mm / (has_arc ? matchingLimits.run_arc_part : 1);
        if (run.count > 1 && one.largest_mm > allowed) return std::numeric_limits<double>::infinity();
        const double weight = std::max(row.z_end_mm - row.z_start_mm, matchingLimits.least_row_mm);
        off += weight * one.mean_mm;
        length += weight;
    }
    const double ends =
        (std::abs(first.z_start_mm - nominal.z_start_mm) + std::abs(last.z_end_mm - nominal.z_end_mm)) / 2;
    const bool other = first.arc_radius_mm.has_value() != nominal.arc_radius_mm.has_value();
    return ends + off / length + matchingLimits.extra_row_price_mm * static_cast<double>(run.count - 1) +
           (other ? matchingLimits.other_kind_price_mm : 0);
}

}  // namespace

RowMatch matchRows(const std::vector<RowOnAxis>& nominal, const std::vector<RowOnAxis>& measured)
{
    const std::size_t rows = nominal.size(), found = measured.size();
    struct Step {
        double cost = std::numeric_limits<double>::infinity();
        std::size_t taken_nominal = 0, taken_measured = 0;
    };
    std::vector<std::vector<Step>> best(rows + 1, std::vector<Step>(found + 1));
    best[0][0].cost = 0;
    const auto reach = [&](std::size_t i, std::size_t j, double cost, std::size_t taken_nominal, std::size_t taken) {
        if (cost < best[i][j].cost) best[i][j] = {cost, taken_nominal, taken};
    };
    for (std::size_t i = 0; i <= rows; ++i)
        for (std::size_t j = 0; j <= found; ++j) {
            const double here = best[i][j].cost;
            if (i < rows) reach(i + 1, j, here + priceOf(nominal[i]), 1, 0);
            if (j < found) reach(i, j + 1, here + priceOf(measured[j]), 0, 1);
            if (i == rows) continue;
            for (std::size_t count = 1; count <= std::min(matchingLimits.longest_run, found - j); ++count)
                reach(i + 1, j + count, here + costOf(nominal[i], measured, {j, count}), 1, count);
        }
    RowMatch match{std::vector<RowRun>(rows), best[rows][found].cost};
    for (std::size_t i = rows, j = found; i > 0 || j > 0;) {
        const Step& step = best[i][j];
        i -= step.taken_nominal;
        j -= step.taken_measured;
        if (step.taken_nominal == 1 && step.taken_measured > 0) match.runs[i] = {j, step.taken_measured};
    }
    return match;
}

}  // namespace lathelier::features
