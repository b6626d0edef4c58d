#include "engine/features/stretches/rounding.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/units.h"
#include "engine/features/stretches/stretch_ends.h"
#include "engine/features/stretches/stretch_limits.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;

/// Where a point about the axis goes; nullopt: it is left out.
std::optional<Vector3d> roundedPlace(const Vector3d& p, const NotRoundStretch& stretch, double sigma_mm)
{
    const SectionShape& shape = stretch.shape;
    const double r = p.head<2>().norm(), turn = std::atan2(p.y(), p.x()) / turn_rad;
    const double radius = shape.radiusAt_mm(turn, p.z()), off = r - radius;
    const double on_mm = stretchEnds.edge_sigmas * sigma_mm + stretchEnds.edge_off_mm;
    Vector3d moved = p;
    if (p.z() < stretch.from_mm || p.z() > stretch.to_mm) {
        const double round = (p.z() < stretch.from_mm ? stretch.before : stretch.behind).radiusAt_mm(p.z());
        const bool is_low = std::isnan(radius) || isBelowRound(shape, radius, sigma_mm);
        if (!is_low || std::abs(r - round) < on_mm) return p;
        if (!(std::abs(off) < on_mm)) return std::nullopt;
        moved.head<2>() *= (round + off) / r;
        return moved;
    }
    const bool is_beside_end = std::min(p.z() - stretch.from_mm, stretch.to_mm - p.z()) < stretchEnds.edge_mm;
    if (std::isnan(radius)) return shape.kind == MarkKind::Eccentric ? std::optional(p) : std::nullopt;
    const double other_mm = sectionLimits.inner_mm + sectionLimits.wall_gap_sigmas * sigma_mm;
    if (std::abs(off) > (is_beside_end ? on_mm : other_mm)) return p;
    if (shape.kind == MarkKind::Eccentric && shape.centre_mm.norm() > stretchProof.slid_offset_share * shape.level_mm)
        moved.head<2>() -= shape.centre_mm;
    else
        moved.head<2>() *= (shape.level_mm + off) / r;
    return moved;
}

}  // namespace

std::vector<Vector3d> madeRound(const std::vector<Vector3d>& points_mm, const registration::RevolutionFit& fit,
                                const std::vector<NotRoundStretch>& stretches, double sigma_mm,
                                const Progress& progress)
{
    constexpr std::size_t checkEvery = 1U << 14U;
    std::vector<Vector3d> rounded;
    rounded.reserve(points_mm.size());
    const Eigen::Matrix3d to_scan = fit.axis_T_scan.linear().transpose();
    for (std::size_t i = 0; i < points_mm.size(); ++i) {
        if (i % checkEvery == 0) progress.check();
        const Vector3d p = fit.onAxis(points_mm[i]);
        const auto own = std::find_if(stretches.begin(), stretches.end(), [&](const NotRoundStretch& stretch) {
            return p.z() >= *stretch.mark.z_start_mm && p.z() <= *stretch.mark.z_end_mm;
        });
        if (own == stretches.end()) {
            rounded.push_back(points_mm[i]);
            continue;
        }
        if (const std::optional<Vector3d> place = roundedPlace(p, *own, sigma_mm))
            rounded.emplace_back(points_mm[i] + to_scan * (*place - p));
    }
    return rounded;
}

void shareForm(const std::vector<ShaftMark>& marks, Walls& walls)
{
    for (Chain& chain : walls.chains)
        for (Wall& wall : chain.walls)
            if (std::any_of(marks.begin(), marks.end(), [&](const ShaftMark& mark) {
                    return wall.z_mm > *mark.z_start_mm && wall.z_mm < *mark.z_end_mm;
                }))
                wall.shared_mm = std::hypot(wall.shared_mm, stretchEnds.shared_mm);
}

void widenRows(const std::vector<ShaftMark>& stretches, std::vector<RecognizedRow>& rows)
{
    for (const ShaftMark& mark : stretches)
        for (RecognizedRow& row : rows) {
            const double common = std::min(row.z_end_mm, *mark.z_end_mm) - std::max(row.z_start_mm, *mark.z_start_mm);
            if (row.kind != RowKind::Cylinder || common < stretchEnds.over_share * (row.z_end_mm - row.z_start_mm))
                continue;
            for (std::optional<double>* um : {&row.uncertainty.start_diameter_um, &row.uncertainty.end_diameter_um})
                if (*um) *um = std::max(**um, 1e3 * mark.uncertainty_mm.value_or(0));
        }
}

std::vector<UnsureEnd> unsureEndsIn(const registration::RevolutionFit& other, const registration::RevolutionFit& fit,
                                    const std::vector<NotRoundStretch>& stretches)
{
    const Eigen::Isometry3d other_T_fit = other.axis_T_scan * fit.axis_T_scan.inverse();
    std::vector<UnsureEnd> unsure;
    for (const NotRoundStretch& stretch : stretches) {
        if (stretch.shape.kind == MarkKind::Eccentric) continue;
        const double sigma_mm =
            stretch.shape.kind == MarkKind::Spline ? stretchEnds.spline_end_sigma_mm : stretchEnds.end_sigma_mm;
        for (const bool start : {true, false})
            if (!(start ? stretch.before : stretch.behind).is_explained)
                unsure.push_back(
                    {(other_T_fit * Vector3d(0, 0, start ? *stretch.mark.z_start_mm : *stretch.mark.z_end_mm)).z(),
                     sigma_mm});
    }
    return unsure;
}

void widenEnds(const std::vector<UnsureEnd>& unsure, Outline& outside)
{
    for (const UnsureEnd& end : unsure)
        for (const bool start : {true, false}) {
            Plane& plane = start ? outside.model.planes.front() : outside.model.planes.back();
            if (!outside.face_seen[start ? 0 : 1] && std::abs(plane.z_mm - end.z_mm) < stretchEnds.at_end_mm)
                plane.sigma_mm = std::max(plane.sigma_mm, end.sigma_mm);
        }
}

std::vector<ShaftMark> marksIn(const registration::RevolutionFit& other, const registration::RevolutionFit& fit,
                               const std::vector<NotRoundStretch>& stretches)
{
    const Eigen::Isometry3d other_T_fit = other.axis_T_scan * fit.axis_T_scan.inverse();
    std::vector<ShaftMark> marks;
    for (const NotRoundStretch& stretch : stretches) {
        ShaftMark mark = stretch.mark;
        const double start = (other_T_fit * Vector3d(0, 0, *mark.z_start_mm)).z(),
                     end = (other_T_fit * Vector3d(0, 0, *mark.z_end_mm)).z();
        mark.z_start_mm = std::min(start, end);
        mark.z_end_mm = std::max(start, end);
        const double angle = mark.angle_deg.value_or(0) / deg_per_rad;
        const Vector3d out = other_T_fit.linear() * Vector3d(std::cos(angle), std::sin(angle), 0);
        if (mark.angle_deg) mark.angle_deg = markAngle_deg(std::atan2(out.y(), out.x()) / turn_rad);
        marks.push_back(std::move(mark));
    }
    return marks;
}

std::vector<ShaftMark> withStretches(std::vector<ShaftMark> marks, const std::vector<ShaftMark>& stretches)
{
    std::erase_if(marks, [&](const ShaftMark& mark) {
        return std::any_of(stretches.begin(), stretches.end(), [&](const ShaftMark& stretch) {
            const double common =
                std::min(*mark.z_end_mm, *stretch.z_end_mm) - std::max(*mark.z_start_mm, *stretch.z_start_mm);
            return common > stretchEnds.over_share * (*mark.z_end_mm - *mark.z_start_mm);
        });
    });
    marks.insert(marks.end(), stretches.begin(), stretches.end());
    std::stable_sort(marks.begin(), marks.end(),
                     [](const ShaftMark& a, const ShaftMark& b) { return a.z_start_mm < b.z_start_mm; });
    return marks;
}

}  // namespace lathelier::features
