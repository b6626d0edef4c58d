#include "engine/cam/job_rules.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/cam/cam_codes.h"
#include "engine/cam/job_bodies.h"
#include "engine/core/units.h"
#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/turned_marks.h"

namespace lathelier::cam {
namespace {

[[noreturn]] void refuseSegment(std::size_t segment, Text quantity, Value found, Text expected)
{
    throw Error(errors::segmentImpossible, {{"segment", static_cast<std::int64_t>(segment + 1)},
                                            {"quantity", quantity},
                                            {"found", std::move(found)},
                                            {"expected", expected}});
}

void checkArc(std::size_t number, const ShaftSegment& segment)
{
    const double length = segment.length_mm, rise = (segment.end_diameter_mm - segment.start_diameter_mm) / 2;
    const double arc = *segment.arc_radius_mm, half_chord = std::hypot(length, rise) / 2;
    const Text name = LT_TEXT("Engine", "the radius of the arc");
    if (!std::isfinite(arc) || std::abs(arc) < half_chord * (1 - 1e-9))
        refuseSegment(number, name, arc, LT_TEXT("Engine", "at least half the chord"));
    // The tangents at both ends make the same angle with the chord; their z components must not change sign.
    const double lean = std::asin(std::min(1.0, half_chord / std::abs(arc)));
    const double slope = std::abs(std::atan2(rise, length));
    if (lean + slope > std::acos(-1.0) / 2 + 1e-4)
        refuseSegment(number, name, arc, LT_TEXT("Engine", "an arc that does not turn back along the axis"));
}

double radiusOf(const ContourPiece& piece, bool highest)
{
    double radius = std::max(piece.from_mm.y(), piece.to_mm.y());
    if (!highest || piece.arc_radius_mm <= 0) return radius;
    const Eigen::Vector2d centre = piece.centre_mm();
    const double low = std::min(piece.from_mm.x(), piece.to_mm.x()),
                 high = std::max(piece.from_mm.x(), piece.to_mm.x());
    if (centre.x() > low && centre.x() < high) radius = std::max(radius, centre.y() + piece.arc_radius_mm);
    return radius;
}

}  // namespace

void checkPart(const Shaft& part)
{
    if (part.segments.empty()) throw Error(errors::shaftEmpty, {});
    requireTurned(part);
    for (std::size_t i = 0; i < part.segments.size(); ++i) {
        const ShaftSegment& segment = part.segments[i];
        const Text above = LT_TEXT("Engine", "a number above 0");
        if (!(segment.length_mm > meet_mm) || !std::isfinite(segment.length_mm))
            refuseSegment(i, LT_TEXT("Engine", "the length"), segment.length_mm, above);
        const bool may_be_pointed = i == 0 && segment.start_diameter_mm == 0;
        if (!(segment.start_diameter_mm > 0 || may_be_pointed) || !std::isfinite(segment.start_diameter_mm))
            refuseSegment(i, LT_TEXT("Engine", "the diameter at its start"), segment.start_diameter_mm, above);
        if (!(segment.end_diameter_mm > 0) || !std::isfinite(segment.end_diameter_mm))
            refuseSegment(i, LT_TEXT("Engine", "the diameter at its end"), segment.end_diameter_mm, above);
        if (segment.arc_radius_mm && *segment.arc_radius_mm != 0) checkArc(i, segment);
    }
}

void checkStock(const Job& job, const Shaft& part)
{
    const double radius = job.stock.diameter_mm / 2;
    double worst = 0, z = 0;
    for (const ContourPiece& piece : outerContour(part)) {
        const double missing = radiusOf(piece, true) - radius;
        if (missing > worst + meet_mm) {
            worst = missing;
            z = piece.from_mm.y() >= piece.to_mm.y() ? piece.from_mm.x() : piece.to_mm.x();
        }
    }
    if (worst > 0)
        throw Error(errors::stockSmallerThanPart,
                    {{"z_mm", z}, {"missing_mm", worst}, {"quantity", LT_TEXT("Engine", "the radius")}});
    const double end = stockEnd_mm(job);
    if (part.length_mm() > end + meet_mm)
        throw Error(errors::stockSmallerThanPart, {{"z_mm", part.length_mm()},
                                                   {"missing_mm", part.length_mm() - end},
                                                   {"quantity", LT_TEXT("Engine", "the length")}});
}

void checkTools(const Job& job)
{
    std::set<int> numbers;
    for (const JobTool& tool : job.tools) {
        if (!numbers.insert(tool.number).second)
            throw Error(errors::toolNumberTwice, {{"tool", std::int64_t{tool.number}}});
        const auto demand = [&tool](const std::optional<double>& stated, Text quantity) {
            if (!stated)
                throw Error(errors::toolIncomplete,
                            {{"tool", std::int64_t{tool.number}}, {"use", nameOf(tool.use)}, {"quantity", quantity}});
        };
        if (tool.isProfile()) {
            const bool is_blade = tool.use == ToolUse::Groove || tool.use == ToolUse::PartOff;
            if (is_blade && !tool.corner_radius_mm) demand(tool.width_mm, LT_TEXT("Engine", "width"));
            demand(tool.corner_radius_mm, LT_TEXT("Engine", "corner radius"));
            demand(tool.entering_angle_deg, LT_TEXT("Engine", "entering angle"));
            demand(tool.tip_angle_deg, LT_TEXT("Engine", "tip angle"));
        }
        stock::outlineOf(turningTool(tool, job));
    }
}

void checkUses(const Job& job)
{
    const auto demand = [&job](ToolUse use) {
        if (!job.toolFor(use)) throw Error(errors::toolMissing, {{"use", nameOf(use)}});
    };
    demand(ToolUse::Rough);
    demand(ToolUse::Finish);
    if (!job.part_off) return;
    const JobTool* blade = job.partingBlade();
    if (!blade || !blade->isBlade()) throw Error(errors::toolMissing, {{"use", nameOf(ToolUse::PartOff)}});
    const double needed = job.stock.diameter_mm / 2;
    if (blade->reach_mm && *blade->reach_mm < needed)
        throw Error(errors::toolTooShort,
                    {{"tool", std::int64_t{blade->number}}, {"reach_mm", *blade->reach_mm}, {"needed_mm", needed}});
}

}  // namespace lathelier::cam
