#include "engine/features/nominal/agreeing_sizes.h"

#include <algorithm>
#include <cmath>

#include "engine/features/nominal/nominal_chain.h"
#include "engine/features/nominal/nominal_limits.h"
#include "engine/features/nominal/snap.h"

namespace lathelier::features {
namespace {

bool isIn(const std::vector<AcceptedSize>& list, std::size_t row, const Suggestion& one)
{
    return std::find(list.begin(), list.end(), AcceptedSize{static_cast<std::int64_t>(row) + 1, one.quantity}) !=
           list.end();
}

/// How far the length of a row may move: U of its ends, and of an arc that of its radius.
double lengthAllowance_mm(const RecognizedRow& row)
{
    const SizeUncertainty& u = row.uncertainty;
    return (u.z_start_um.value_or(0) + u.z_end_um.value_or(0) + u.arc_radius_um.value_or(0)) / 1000 +
           placingLimits.rounding_mm;
}

/// Removes suggestions of a row that are not confirmed: `shape` those of its form, else all. Were there any?
bool drop(RecognizedRow& row, std::size_t number, bool shape, const std::vector<AcceptedSize>& confirmed)
{
    return std::erase_if(row.suggestions, [&](const Suggestion& one) {
               return (!shape || one.quantity != "diameter_mm") && !isIn(confirmed, number, one);
           }) > 0;
}

/// The first row whose length moved beyond its allowance; its number in `segments`; none: -1.
std::ptrdiff_t movedRow(const PlacedShaft& placed, const Recognition& recognition, const std::vector<bool>& settled)
{
    for (std::size_t i = 0; i < placed.shaft.segments.size() && i < placed.source.size(); ++i) {
        if (placed.source[i] == PlacedRow::none) continue;
        const auto row = static_cast<std::size_t>(placed.source[i]);
        const RecognizedRow& from = recognition.segments[row];
        // The rows of an undercut are within the tolerances of its standard.
        if (settled[row] || from.role == "undercut") continue;
        const double moved = placed.shaft.segments[i].length_mm - (from.z_end_mm - from.z_start_mm);
        if (std::abs(moved) > lengthAllowance_mm(from)) return static_cast<std::ptrdiff_t>(row);
    }
    return PlacedRow::none;
}

/// Leaves out what moves row `row`: what shapes it, else the planes at its ends, else its neighbours' sizes.
bool leaveOutAround(Recognition& chosen, std::size_t row, const std::vector<AcceptedSize>& confirmed)
{
    std::vector<RecognizedRow>& rows = chosen.segments;
    if (drop(rows[row], row, true, confirmed)) return true;
    const std::size_t first = row > 0 ? row - 1 : 0, last = std::min(row + 1, rows.size() - 1);
    bool any = false;
    for (const bool shape : {true, false})
        for (std::size_t i = first; i <= last && !any; ++i) any = drop(rows[i], i, shape, confirmed);
    return any;
}

}  // namespace

AgreeingShaft agreeingNominal(const Recognition& recognition, const std::vector<AcceptedSize>& confirmed)
{
    Recognition chosen = recognition;
    for (std::size_t i = 0; i < chosen.segments.size(); ++i)
        std::erase_if(chosen.segments[i].suggestions,
                      [&](const Suggestion& one) { return !one.agrees && !isIn(confirmed, i, one); });
    for (auto& bore : chosen.bores)
        for (RecognizedRow& row : bore)
            std::erase_if(row.suggestions, [](const Suggestion& one) { return !one.agrees; });
    AgreeingShaft result;
    std::vector<bool> settled(chosen.segments.size(), false);  // a person moved them
    while (true) {
        PlacedShaft placed = placedNominal(chosen);
        const std::ptrdiff_t moved = movedRow(placed, chosen, settled);
        result.shaft = std::move(placed.shaft);
        if (moved == PlacedRow::none) break;
        const auto row = static_cast<std::size_t>(moved);
        if (!leaveOutAround(chosen, row, confirmed)) settled[row] = true;
    }
    for (std::size_t i = 0; i < chosen.segments.size(); ++i)
        for (const Suggestion& one : recognition.segments[i].suggestions) {
            const auto& kept = chosen.segments[i].suggestions;
            const bool in_place = std::any_of(kept.begin(), kept.end(),
                                              [&](const Suggestion& other) { return other.quantity == one.quantity; });
            if (!in_place && !isIn(result.left_out, i, one))
                result.left_out.push_back({static_cast<std::int64_t>(i) + 1, one.quantity});
        }
    return result;
}

}  // namespace lathelier::features
