#include "engine/cam/clampings.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/job_bodies.h"
#include "engine/core/units.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::cam {
namespace {

}  // namespace

bool isToleranced(const ShaftSegment& row)
{
    return row.tolerance.has_value() || row.tolerance_um.has_value();
}

Clamping wholeClamping(const Shaft& part, const Job& job)
{
    Clamping clamping;
    clamping.part = part;
    clamping.job = job;
    clamping.finished_to_mm = part.length_mm();
    clamping.parts_off = job.part_off;
    clamping.part_off_z_mm = part.length_mm();
    clamping.threads = threadsOf(part);
    return clamping;
}

std::optional<double> splitOf(const Shaft& part)
{
    if (part.segments.size() < 2) return {};
    double largest = 0, split = 0, begin = 0;
    for (const ShaftSegment& row : part.segments) {
        const double radius = std::max(row.start_diameter_mm, row.end_diameter_mm) / 2;
        if (radius > largest + meet_mm) {
            largest = radius;
            split = begin + row.length_mm / 2;
        }
        begin += row.length_mm;
    }
    return split;
}

Shaft cutAt(const Shaft& part, double z_mm)
{
    Shaft result = part;
    result.segments.clear();
    double begin = 0;
    for (const ShaftSegment& row : part.segments) {
        const double end = begin + row.length_mm;
        if (begin >= z_mm - meet_mm) break;
        result.segments.push_back(row);
        if (end > z_mm + meet_mm) {
            const ContourPiece piece{
                {begin, row.start_diameter_mm / 2}, {end, row.end_diameter_mm / 2}, row.arc_radius_mm.value_or(0), 0};
            result.segments.back().length_mm = z_mm - begin;
            result.segments.back().end_diameter_mm = 2 * piece.radiusAt_mm(z_mm);
            break;
        }
        begin = end;
    }
    return result;
}

std::optional<Grip> gripBefore(const Shaft& part, const Job& job, double split_mm, double& missing_mm)
{
    const double needed = job.setup.grip_length_mm.value_or(leastGripLength_mm);
    std::optional<Grip> best;
    double longest = 0, begin = 0;
    for (std::size_t i = 0; i < part.segments.size(); ++i) {
        const ShaftSegment& row = part.segments[i];
        const double end = begin + row.length_mm;
        const bool is_cylinder = row.arc_radius_mm.value_or(0) == 0 && row.start_diameter_mm == row.end_diameter_mm;
        const double to = std::min(end, split_mm) - jawsFromShoulder_mm, length = to - begin;
        if (is_cylinder && length > 0) {
            longest = std::max(longest, length);
            const bool toleranced = isToleranced(row);
            const bool better = !best || (best->has_tolerance && !toleranced) ||
                                (best->has_tolerance == toleranced && length > best->to_mm - best->from_mm);
            if (length >= needed && better) best = Grip{begin, to, toleranced};
        }
        begin = end;
        if (begin >= split_mm) break;
    }
    missing_mm = needed - longest;
    return best;
}

std::vector<Clamping> twoClampings(const Shaft& part, const Job& job, double split_mm, const Grip& grip)
{
    const double length = part.length_mm(), half = splitOverlap_mm / 2;
    Clamping first;
    first.part = cutAt(part, split_mm + half);
    first.job = job;
    first.finished_to_mm = split_mm;
    first.parts_off = job.part_off;
    // Both faces have the same allowance.
    first.part_off_z_mm = length + job.stock.face_allowance_mm;
    Clamping second;
    second.is_mirrored = true;
    second.part = cutAt(mirrored(part), length - split_mm + half);
    second.job = job;
    second.job.setup.chuck_face_z_mm = length - grip.to_mm;
    second.job.setup.tailstock.reset();
    second.job.setup.grip_length_mm.reset();
    const double face = job.stock.face_allowance_mm;
    const bool is_parted = job.part_off && !job.setup.tailstock;
    if (!is_parted) {
        const double beyond = job.stock.length_mm ? *job.stock.length_mm - face - length : HUGE_VAL;
        if (beyond > mostFacedOff_mm)
            second.cut_off_to_mm = length + face;
        else
            second.job.stock.face_allowance_mm = std::max(beyond, 0.0);
    }
    second.work_length_mm = length + second.job.stock.face_allowance_mm;
    second.job.stock.length_mm = face + second.work_length_mm;
    second.job.sections.clear();
    second.finished_to_mm = length - split_mm;
    first.job.part_off = second.job.part_off = false;
    for (const DrawnThread& thread : threadsOf(part))
        if ((thread.z_start_mm + thread.z_end_mm) / 2 < split_mm)
            first.threads.push_back(thread);
        else
            second.threads.push_back(mirrored({thread}, length).front());
    return {std::move(first), std::move(second)};
}

}  // namespace lathelier::cam
