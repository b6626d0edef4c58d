#include "engine/drawing/marks/mark_geometry.h"

#include <array>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::drawing {

double viewedAngle_deg(const Shaft& shaft)
{
    constexpr std::array leading{MarkKind::Keyway, MarkKind::Flat,      MarkKind::Hexagon,
                                 MarkKind::Square, MarkKind::CrossHole, MarkKind::Spline};
    for (const MarkKind kind : leading)
        for (const ShaftMark& mark : shaft.marks)
            if (mark.kind == kind && mark.angle_deg) return *mark.angle_deg;
    for (const ShaftMark& mark : shaft.marks)
        if (mark.kind == MarkKind::Eccentric && mark.angle_deg) return *mark.angle_deg + 90;
    return 0;
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

bool hasShapeOfItsOwn(const Shaft& shaft, const ContourRow& row)
{
    for (const MarkKind kind : {MarkKind::Hexagon, MarkKind::Square, MarkKind::Spline})
        if (markOver(shaft, kind, row)) return true;
    return false;
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
