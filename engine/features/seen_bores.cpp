#include "engine/features/seen_bores.h"

#include <algorithm>
#include <cmath>

#include "engine/features/features_codes.h"
#include "engine/features/outline/bore_rows.h"
#include "engine/features/recognition_limits.h"

namespace lathelier::features {
namespace {

/// Rows of a bore from its mouth inward.
std::vector<RecognizedRow> fromMouth(std::vector<RecognizedRow> rows, ShaftEnd mouth)
{
    if (mouth == ShaftEnd::Free) return rows;
    std::reverse(rows.begin(), rows.end());
    for (RecognizedRow& row : rows) {
        std::swap(row.start_diameter_mm, row.end_diameter_mm);
        std::swap(row.uncertainty.start_diameter_um, row.uncertainty.end_diameter_um);
    }
    return rows;
}

/// A cylinder that continues behind a stretch without points is one row.
void joinCylinders(std::vector<RecognizedRow>& rows)
{
    for (std::size_t i = 0; i + 1 < rows.size();) {
        RecognizedRow &a = rows[i], &b = rows[i + 1];
        const bool same = a.kind == RowKind::Cylinder && b.kind == RowKind::Cylinder &&
                          std::abs(a.end_diameter_mm - b.start_diameter_mm) < recognitionLimits.same_diameter_mm;
        if (!same || b.z_start_mm - a.z_end_mm < recognitionLimits.unseen_mm) {
            ++i;
            continue;
        }
        const double wa = static_cast<double>(a.points + 1), wb = static_cast<double>(b.points + 1);
        a.start_diameter_mm = a.end_diameter_mm = (a.start_diameter_mm * wa + b.start_diameter_mm * wb) / (wa + wb);
        a.z_end_mm = b.z_end_mm;
        a.uncertainty.z_end_um = b.uncertainty.z_end_um;
        a.points += b.points;
        rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
}

}  // namespace

void addSeenBores(const Outline& inner, double zero_mm, double length_mm, const registration::RevolutionFit& fit,
                  const AddedUncertainty& added, Recognition& result)
{
    std::vector<RecognizedRow> rows = rowsWithinPart(rowsOf(inner, zero_mm, fit.coverage_deg, added), length_mm);
    if (rows.empty()) return;
    joinCylinders(rows);
    std::size_t gap = rows.size();  // first row behind the last hidden stretch
    for (std::size_t i = 0; i + 1 < rows.size(); ++i)
        if (rows[i + 1].z_start_mm - rows[i].z_end_mm > recognitionLimits.unseen_mm) {
            result.notes.push_back(
                {notes::boreNotSeen, {{"z_start_mm", rows[i].z_end_mm}, {"z_end_mm", rows[i + 1].z_start_mm}}});
            result.complete = false;
            gap = i + 1;
        }
    const bool free = rows.front().z_start_mm < recognitionLimits.end_reach_mm,
               chuck = length_mm - recognitionLimits.end_reach_mm < rows.back().z_end_mm;
    std::vector<RecognizedRow> from_free, from_chuck;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (free && (i < gap || !chuck))
            from_free.push_back(rows[i]);
        else if (chuck)
            from_chuck.push_back(rows[i]);
    if (!from_free.empty()) from_free.front().z_start_mm = 0;
    if (!from_chuck.empty()) from_chuck.back().z_end_mm = length_mm;
    if (free && chuck && gap == rows.size()) from_free.back().z_end_mm = length_mm;
    for (const auto& [list, mouth] : {std::pair(&from_free, ShaftEnd::Free), std::pair(&from_chuck, ShaftEnd::Chuck)})
        if (!list->empty()) result.bores.push_back(fromMouth(*list, mouth));
    addMeridian(inner, zero_mm, true, 0, result.meridian);
}

}  // namespace lathelier::features
