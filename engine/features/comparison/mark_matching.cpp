#include "engine/features/comparison/mark_matching.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/features/comparison/comparison_limits.h"
#include "engine/features/features_codes.h"

namespace lathelier::features {
namespace {

double middle_mm(const ShaftMark& mark)
{
    return (*mark.z_start_mm + *mark.z_end_mm) / 2;
}

bool hasPlace(const ShaftMark& mark)
{
    return mark.z_start_mm && mark.z_end_mm;
}

}  // namespace

Notes notesOfMarks(const Shaft& nominal, const Recognition& measured, const Eigen::Isometry3d& nominal_T_part)
{
    Notes notes;
    std::int64_t found = 0;
    std::vector<std::uint8_t> taken(measured.marks.size(), 0);
    for (const ShaftMark& drawn : nominal.marks) {
        if (!hasPlace(drawn) || drawn.kind == MarkKind::Unexplained) continue;
        const double reach = std::max(matchingLimits.mark_mm, (*drawn.z_end_mm - *drawn.z_start_mm) / 2);
        bool is_there = false;
        for (std::size_t i = 0; i < measured.marks.size() && !is_there; ++i) {
            const ShaftMark& mark = measured.marks[i];
            if (taken[i] || mark.kind != drawn.kind || !hasPlace(mark)) continue;
            const double z = (nominal_T_part * Eigen::Vector3d(0, 0, middle_mm(mark))).z();
            is_there = std::abs(z - middle_mm(drawn)) < reach;
            taken[i] = is_there;
        }
        if (is_there)
            ++found;
        else
            notes.push_back({notes::markNotFound,
                             {{"kind", nameOf(drawn)},
                              {"found", key(drawn)},
                              {"from_mm", *drawn.z_start_mm},
                              {"to_mm", *drawn.z_end_mm}}});
    }
    if (found > 0) notes.push_back({notes::marksNotCompared, {{"count", found}}});
    return notes;
}

}  // namespace lathelier::features
