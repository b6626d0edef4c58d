#include "engine/features/comparison/rows_on_axis.h"

#include <algorithm>

#include "engine/features/comparison/comparison_limits.h"
#include "engine/shaft/shaft_bores.h"

namespace lathelier::features {
namespace {

/// Rows turned end for end.
RowOnAxis turnedRow(RowOnAxis row)
{
    std::swap(row.z_start_mm, row.z_end_mm);
    std::swap(row.start_diameter_mm, row.end_diameter_mm);
    SizeUncertainty& u = row.uncertainty;
    std::swap(u.z_start_um, u.z_end_um);
    std::swap(u.start_diameter_um, u.end_diameter_um);
    std::swap(row.start_seen, row.end_seen);
    return row;
}

bool before(const RowOnAxis& a, const RowOnAxis& b)
{
    return a.z_start_mm + a.z_end_mm < b.z_start_mm + b.z_end_mm;
}

template <class Segment>
RowsOnAxis rowsWithSizes(const std::vector<Segment>& rows, double z_mm, double sense)
{
    RowsOnAxis result;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Segment& row = rows[i];
        const double end = z_mm + sense * row.length_mm;
        const RowOnAxis one{i, z_mm, end, row.start_diameter_mm, row.end_diameter_mm, row.arc_radius_mm, {}};
        z_mm = end;
        if (row.length_mm > 0) result.push_back(sense < 0 ? turnedRow(one) : one);
    }
    std::stable_sort(result.begin(), result.end(), before);
    return result;
}

}  // namespace

RowsOnAxis placed(const std::vector<RecognizedRow>& rows, const Placing& placing, std::array<bool, 2> outer_seen)
{
    RowsOnAxis result;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const RecognizedRow& row = rows[i];
        RowOnAxis one{i,
                      placing.at(row.z_start_mm),
                      placing.at(row.z_end_mm),
                      row.start_diameter_mm,
                      row.end_diameter_mm,
                      row.arc_radius_mm,
                      row.uncertainty};
        one.fully_visible = row.fully_visible;
        if (row.z_end_mm > row.z_start_mm) result.push_back(placing.turned ? turnedRow(one) : one);
    }
    std::stable_sort(result.begin(), result.end(), before);
    if (result.empty()) return result;
    for (std::size_t i = 0; i + 1 < result.size(); ++i)
        if (result[i + 1].z_start_mm - result[i].z_end_mm > matchingLimits.joining_gap_mm)
            result[i].end_seen = result[i + 1].start_seen = false;
    if (placing.turned) std::swap(outer_seen[0], outer_seen[1]);
    result.front().start_seen = outer_seen[0];
    result.back().end_seen = outer_seen[1];
    return result;
}

std::array<bool, 2> endsSeen(const Recognition& measured)
{
    std::array<bool, 2> seen{true, true};
    for (std::size_t i = 0; i < std::min(seen.size(), measured.ends.size()); ++i) seen[i] = isClosed(measured.ends[i]);
    return seen;
}

RowsOnAxis placedBores(const Recognition& measured, const Placing& placing)
{
    std::vector<RecognizedRow> rows;
    for (const auto& bore : measured.bores) rows.insert(rows.end(), bore.begin(), bore.end());
    double length_mm = measured.length_mm.value_or(0), first_mm = length_mm, last_mm = 0;
    for (const RecognizedRow& row : measured.segments) length_mm = std::max(length_mm, row.z_end_mm);
    for (const RecognizedRow& row : rows) {
        first_mm = std::min(first_mm, row.z_start_mm);
        last_mm = std::max(last_mm, row.z_end_mm);
    }
    const std::array<bool, 2> ends = endsSeen(measured);
    constexpr double gap_mm = matchingLimits.joining_gap_mm;
    return placed(rows, placing, {ends[0] && first_mm < gap_mm, ends[1] && last_mm > length_mm - gap_mm});
}

std::vector<ShaftBore> drawnBores(const Shaft& nominal)
{
    std::vector<ShaftBore> bores = boresOf(nominal);
    if (!nominal.bores.empty()) return bores;
    for (ShaftBore& bore : bores) {
        std::vector<BoreSegment> rows;
        for (const BoreSegment& row : bore.segments)
            if (!rows.empty() && rows.back().end_diameter_mm == row.start_diameter_mm)
                rows.back().length_mm += row.length_mm;
            else
                rows.push_back(row);
        bore.segments = std::move(rows);
    }
    return bores;
}

std::vector<Placing> placings(const Shaft& nominal, const Recognition& measured,
                              const std::optional<Eigen::Isometry3d>& nominal_T_part)
{
    const double drawn = nominal.length_mm();
    double length = measured.length_mm.value_or(0);
    for (const RecognizedRow& row : measured.segments) length = std::max(length, row.z_end_mm);
    const std::vector<Placing> straight{{false, 0}, {false, drawn - length}};
    const std::vector<Placing> turned{{true, length}, {true, drawn}};
    std::vector<Placing> all;
    if (nominal_T_part) all.push_back({nominal_T_part->linear()(2, 2) < 0, nominal_T_part->translation().z()});
    if (!nominal_T_part || !all.front().turned) all.insert(all.end(), straight.begin(), straight.end());
    if (!nominal_T_part || all.front().turned) all.insert(all.end(), turned.begin(), turned.end());
    return all;
}

RowsOnAxis drawnRows(const std::vector<ShaftSegment>& rows, double z_mm, double sense)
{
    return rowsWithSizes(rows, z_mm, sense);
}

RowsOnAxis drawnRows(const std::vector<BoreSegment>& rows, double z_mm, double sense)
{
    return rowsWithSizes(rows, z_mm, sense);
}

}  // namespace lathelier::features
