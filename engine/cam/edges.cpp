#include "engine/cam/edges.h"

#include <cmath>

#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

constexpr double steepestEdgeRow = 0.5774;  // slope of the steepest row whose edge is broken, tan 30°
constexpr double leastRowLegs = 3;          // shortest row, in legs of the chamfer

bool isStraight(const ShaftSegment& row)
{
    return row.arc_radius_mm.value_or(0) == 0 && row.length_mm > meet_mm &&
           std::abs(row.end_diameter_mm - row.start_diameter_mm) / 2 <= steepestEdgeRow * row.length_mm;
}

double diameterAt(const ShaftSegment& row, double along_mm)
{
    return row.start_diameter_mm + (row.end_diameter_mm - row.start_diameter_mm) * along_mm / row.length_mm;
}

}  // namespace

bool breaksEnd(const Job& job, bool is_second)
{
    return is_second || (job.part_off && !job.setup.tailstock);
}

BrokenEdges brokenEdges(const Shaft& part, double leg_mm, bool breaks_end)
{
    BrokenEdges broken;
    broken.part = part;
    if (!(leg_mm > 0)) return broken;
    broken.part.segments.clear();
    const std::size_t count = part.segments.size();
    for (std::size_t i = 0; i < count; ++i) {
        ShaftSegment row = part.segments[i];
        const double before = i == 0 ? 0 : part.segments[i - 1].end_diameter_mm;
        const double after = i + 1 < count ? part.segments[i + 1].start_diameter_mm
                             : breaks_end  ? 0
                                           : row.end_diameter_mm;
        const auto chamfer = [&](double start, double end) {
            ShaftSegment edge;
            edge.length_mm = leg_mm;
            edge.start_diameter_mm = start;
            edge.end_diameter_mm = end;
            edge.role = "chamfer";
            ++broken.count;
            return edge;
        };
        const auto asks = [&](double beside, double edge) { return isStraight(row) && edge - beside > 2 * meet_mm; };
        const auto fits = [&](double beside, double edge) {
            return row.length_mm >= leastRowLegs * leg_mm && edge - beside >= 2 * leg_mm;
        };
        const double start = row.start_diameter_mm, end = row.end_diameter_mm;
        const bool at_start = asks(before, start) && fits(before, start), at_end = asks(after, end) && fits(after, end);
        broken.left += (asks(before, start) && !at_start ? 1 : 0) + (asks(after, end) && !at_end ? 1 : 0);
        const double inner_start = at_start ? diameterAt(row, leg_mm) : start,
                     inner_end = at_end ? diameterAt(row, row.length_mm - leg_mm) : end;
        if (at_start) broken.part.segments.push_back(chamfer(start - 2 * leg_mm, inner_start));
        row.length_mm -= (at_start ? leg_mm : 0) + (at_end ? leg_mm : 0);
        row.start_diameter_mm = inner_start;
        row.end_diameter_mm = inner_end;
        broken.part.segments.push_back(row);
        if (at_end) broken.part.segments.push_back(chamfer(inner_end, end - 2 * leg_mm));
    }
    return broken;
}

}  // namespace lathelier::cam
