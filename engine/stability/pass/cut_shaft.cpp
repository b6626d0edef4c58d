#include "engine/stability/pass/cut_shaft.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/beam/beam_codes.h"
#include "engine/beam/segment_contour.h"
#include "engine/core/error.h"

namespace lathelier::stability {
namespace {

/// The stretch of a segment from `from_mm` to `to_mm` of its length, with the radius reduced by depth_mm.
ShaftSegment stretchOf(const ShaftSegment& segment, double from_mm, double to_mm, double depth_mm)
{
    const beam::SegmentContour contour(segment);
    ShaftSegment result = segment;
    result.length_mm = to_mm - from_mm;
    result.start_diameter_mm =
        (from_mm > 0 ? 2 * contour.radiusAt_mm(from_mm) : segment.start_diameter_mm) - 2 * depth_mm;
    result.end_diameter_mm =
        (to_mm < segment.length_mm ? 2 * contour.radiusAt_mm(to_mm) : segment.end_diameter_mm) - 2 * depth_mm;
    return result;
}

void requireSound(const ShaftSegment& segment, std::size_t number)
{
    const double least = std::min(segment.start_diameter_mm, segment.end_diameter_mm);
    if (!(least > 0) || !(least > segment.bore_diameter_mm))
        throw Error(errors::shaftSegmentUnusable, {{"segment", static_cast<std::int64_t>(number)},
                                                   {"quantity", LT_TEXT("Engine", "the diameter that is left")},
                                                   {"found_mm", least},
                                                   {"expected", LT_TEXT("Engine", "more than the bore")}});
}

}  // namespace

Shaft cutShaft(const Shaft& stock, double from_z_mm, double to_z_mm, double depth_mm)
{
    const double length_mm = stock.length_mm();
    for (const double z : {from_z_mm, to_z_mm})
        if (!(z >= 0 && z <= length_mm))
            throw Error(errors::placeOutsideShaft, {{"z_mm", z}, {"length_mm", length_mm}});
    Shaft result = stock;
    result.segments.clear();
    result.segments.reserve(stock.segments.size() + 2);
    double start_mm = 0;
    for (std::size_t i = 0; i < stock.segments.size(); ++i) {
        const ShaftSegment& segment = stock.segments[i];
        const double a = std::clamp(from_z_mm - start_mm, 0.0, segment.length_mm);
        const double b = std::clamp(to_z_mm - start_mm, a, segment.length_mm);
        const std::array<double, 4> ends{0, a, b, segment.length_mm};
        for (std::size_t part = 0; part < 3; ++part) {
            if (!(ends[part + 1] > ends[part])) continue;
            result.segments.push_back(stretchOf(segment, ends[part], ends[part + 1], part == 1 ? depth_mm : 0));
            if (part == 1) requireSound(result.segments.back(), i + 1);
        }
        start_mm += segment.length_mm;
    }
    return result;
}

double diameterAt_mm(const Shaft& shaft, double z_mm)
{
    double start_mm = 0;
    for (const ShaftSegment& segment : shaft.segments) {
        if (segment.length_mm > 0 && z_mm <= start_mm + segment.length_mm)
            return 2 * beam::SegmentContour(segment).radiusAt_mm(std::max(0.0, z_mm - start_mm));
        start_mm += segment.length_mm;
    }
    return shaft.segments.empty() ? 0 : shaft.segments.back().end_diameter_mm;
}

}  // namespace lathelier::stability
