#include "engine/drawing/marks/mark_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::drawing {
namespace {

constexpr double settled_mm = 0.5;  // measured marks that end no further from an edge of the part end there

constexpr std::array shapedKinds{MarkKind::Hexagon, MarkKind::Square, MarkKind::Spline};

bool isUpward(MarkKind kind)
{
    return kind == MarkKind::Eccentric || kind == MarkKind::BoltCircle;
}

}  // namespace

const ShaftMark* viewedMark(const Shaft& shaft)
{
    constexpr std::array leading{MarkKind::Keyway,    MarkKind::Flat,   MarkKind::Hexagon,   MarkKind::Square,
                                 MarkKind::CrossHole, MarkKind::Spline, MarkKind::Eccentric, MarkKind::BoltCircle};
    for (const MarkKind kind : leading)
        for (const ShaftMark& mark : shaft.marks)
            if (mark.kind == kind && mark.angle_deg) return &mark;
    return nullptr;
}

double viewedAngle_deg(const Shaft& shaft)
{
    const ShaftMark* const mark = viewedMark(shaft);
    if (!mark) return 0;
    return *mark->angle_deg + (isUpward(mark->kind) ? 90 : 0);
}

double turnOf_deg(const ShaftMark& mark, double viewed_deg)
{
    if (!mark.angle_deg) return 0;
    const double turn = std::remainder(*mark.angle_deg - viewed_deg, 360);
    return turn <= -180 ? turn + 360 : turn;
}

const ShaftMark* markOver(const Shaft& shaft, MarkKind kind, const ContourRow& row)
{
    for (const ShaftMark& mark : shaft.marks)
        if (mark.kind == kind && mark.z_start_mm && mark.z_end_mm && row.middleZ_mm() > *mark.z_start_mm &&
            row.middleZ_mm() < *mark.z_end_mm)
            return &mark;
    return nullptr;
}

std::pair<double, double> roundStretch(const Shaft& shaft, const ContourRow& row)
{
    std::vector<std::pair<double, double>> taken;
    for (const ShaftMark& mark : shaft.marks)
        if (mark.z_start_mm && mark.z_end_mm && *mark.z_end_mm > row.start_z_mm && *mark.z_start_mm < row.end_z_mm &&
            std::find(shapedKinds.begin(), shapedKinds.end(), mark.kind) != shapedKinds.end())
            taken.emplace_back(*mark.z_start_mm, *mark.z_end_mm);
    if (taken.empty()) return {row.start_z_mm, row.end_z_mm};
    std::sort(taken.begin(), taken.end());
    taken.emplace_back(row.end_z_mm, row.end_z_mm);
    std::pair<double, double> longest{row.start_z_mm, row.start_z_mm};
    double from = row.start_z_mm;
    for (const auto& [start, end] : taken) {
        if (start - from > std::max(settled_mm, longest.second - longest.first)) longest = {from, start};
        from = std::max(from, end);
    }
    return longest;
}

Shaft withSettledMarks(const Shaft& shaft)
{
    Shaft result = shaft;
    const std::vector<ContourRow> rows = outerRows(shaft);
    const auto settle = [&](std::optional<double>& z_mm) {
        double nearest = *z_mm, least = settled_mm;
        for (const ContourRow& row : rows)
            for (const double edge_mm : {row.start_z_mm, row.end_z_mm})
                if (std::abs(edge_mm - *z_mm) < least) {
                    least = std::abs(edge_mm - *z_mm);
                    nearest = edge_mm;
                }
        z_mm = nearest;
    };
    for (ShaftMark& mark : result.marks) {
        const bool is_cut = mark.kind == MarkKind::Keyway || mark.kind == MarkKind::Flat ||
                            mark.kind == MarkKind::Eccentric ||
                            std::find(shapedKinds.begin(), shapedKinds.end(), mark.kind) != shapedKinds.end();
        const bool is_measured = mark.uncertainty_mm || !shaft.recovered.scan.empty();
        if (!is_cut || !is_measured || !mark.z_start_mm || !mark.z_end_mm ||
            *mark.z_end_mm - *mark.z_start_mm < 3 * settled_mm)
            continue;
        settle(mark.z_start_mm);
        settle(mark.z_end_mm);
    }
    return result;
}

double offsetOf(const Shaft& shaft, const ContourRow& row)
{
    const ShaftMark* const mark = markOver(shaft, MarkKind::Eccentric, row);
    if (!mark || !mark->offset_mm) return 0;
    return -*mark->offset_mm * std::sin(turnOf_deg(*mark, viewedAngle_deg(shaft)) * rad_per_deg);
}

std::optional<double> floorOf(const ShaftMark& keyway, double radius_mm)
{
    if (keyway.floor_mm) return keyway.floor_mm;
    if (keyway.depth_mm) return radius_mm - *keyway.depth_mm;
    return std::nullopt;
}

}  // namespace lathelier::drawing
