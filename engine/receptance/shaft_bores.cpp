#include "engine/receptance/shaft_bores.h"

#include <algorithm>

#include "engine/beam/beam_codes.h"
#include "engine/beam/segment_contour.h"
#include "engine/receptance/receptance_codes.h"

namespace lathelier::receptance {
namespace {

constexpr int stepsOfTaper = 20;
constexpr double tooShort_mm = 1e-9;

/// A length of constant bore, z from the free end.
struct BoreStep {
    double from_mm, to_mm, diameter_mm;
};

void append(const Bore& bore, double length_mm, std::vector<BoreStep>& steps)
{
    double depth_mm = 0;
    for (const ShaftSegment& segment : bore.segments) {
        const beam::SegmentContour contour(segment);
        const int count = contour.isCylinder() ? 1 : stepsOfTaper;
        for (int i = 0; i < count && segment.length_mm > 0; ++i) {
            const double from_mm = depth_mm + segment.length_mm * i / count;
            const double to_mm = depth_mm + segment.length_mm * (i + 1) / count;
            const double diameter_mm = 2 * contour.radiusAt_mm(segment.length_mm * (i + 0.5) / count);
            if (bore.from_free_end)
                steps.push_back({from_mm, to_mm, diameter_mm});
            else
                steps.push_back({length_mm - to_mm, length_mm - from_mm, diameter_mm});
        }
        depth_mm += segment.length_mm;
    }
    if (depth_mm > length_mm + tooShort_mm)
        throw Error(errors::shaftSegmentUnusable, {{"segment", static_cast<std::int64_t>(bore.segments.size())},
                                                   {"quantity", LT_TEXT("Engine", "the depth of the bore")},
                                                   {"found_mm", depth_mm},
                                                   {"expected", LT_TEXT("Engine", "no more than the length")}});
}

double boreAt(const std::vector<BoreStep>& steps, double z_mm)
{
    double largest_mm = 0;
    for (const BoreStep& step : steps)
        if (z_mm > step.from_mm && z_mm < step.to_mm) largest_mm = std::max(largest_mm, step.diameter_mm);
    return largest_mm;
}

}  // namespace

Shaft withBores(Shaft shaft, const std::vector<Bore>& bores)
{
    if (bores.empty()) return shaft;
    const auto isBored = [](const ShaftSegment& segment) { return segment.bore_diameter_mm > 0; };
    if (std::any_of(shaft.segments.begin(), shaft.segments.end(), isBored)) throw Error(errors::boresStatedTwice, {});
    const double length_mm = shaft.length_mm();
    std::vector<BoreStep> steps;
    for (const Bore& bore : bores) append(bore, length_mm, steps);
    std::vector<double> cuts;
    for (const BoreStep& step : steps) cuts.insert(cuts.end(), {step.from_mm, step.to_mm});
    std::sort(cuts.begin(), cuts.end());

    std::vector<ShaftSegment> cut_segments;
    double begin_mm = 0;
    for (const ShaftSegment& segment : shaft.segments) {
        const beam::SegmentContour contour(segment);
        const double end_mm = begin_mm + segment.length_mm;
        double from_mm = begin_mm;
        const auto appendTo = [&](double to_mm) {
            ShaftSegment part = segment;
            part.length_mm = to_mm - from_mm;
            if (from_mm > begin_mm) part.start_diameter_mm = 2 * contour.radiusAt_mm(from_mm - begin_mm);
            if (to_mm < end_mm) part.end_diameter_mm = 2 * contour.radiusAt_mm(to_mm - begin_mm);
            part.bore_diameter_mm = boreAt(steps, (from_mm + to_mm) / 2);
            cut_segments.push_back(part);
            from_mm = to_mm;
        };
        for (const double cut : cuts)
            if (cut > from_mm + tooShort_mm && cut < end_mm - tooShort_mm) appendTo(cut);
        appendTo(end_mm);
        begin_mm = end_mm;
    }
    shaft.segments = std::move(cut_segments);
    return shaft;
}

}  // namespace lathelier::receptance
